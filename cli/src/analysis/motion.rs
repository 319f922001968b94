//! Roots in words: which motions take part.
//!
//! Shares are those of the energy at nominal stiffness: q̇² + ω²q² of a mode, m v² and J ω² of the rigid motion.

use flexible_aircraft::plant::Unknown;
use flexible_aircraft::stability::{Branch, Complex, Root};

use super::Analysis;

/// Modes whose share is less are not named.
const NOTABLE: f64 = 0.05;

/// A root with a greater share of rigid motion is one of flight mechanics. (Elastic modes of a free aircraft move
/// the origin too.)
const FLIGHT: f64 = 0.8;

/// Roots with less are not oscillating, rad/s.
const OSCILLATING: f64 = 1e-5;

/// The energy of a root.
struct Shares {
    /// Of the rigid motion.
    rigid: f64,
    /// Of each mode.
    modes: Vec<f64>,
}

impl Shares {
    fn of(root: &Root, analysis: &Analysis) -> Self {
        let Analysis { model, settings, sweep, .. } = analysis;
        let mut shares = Shares { rigid: 0.0, modes: vec![0.0; model.modes.len()] };
        for (unknown, component) in sweep.unknowns.iter().zip(root.shape.iter()) {
            let square = component.norm_sqr();
            match *unknown {
                Unknown::Velocity(_) => shares.rigid += model.integrals.mass * square,
                Unknown::Rate(axis) => shares.rigid += model.integrals.inertia[(axis, axis)] * square,
                Unknown::CoordinateRate(mode) => shares.modes[mode] += square,
                Unknown::Coordinate(mode) => {
                    let frequency = model.modes[mode].angular_frequency;
                    shares.modes[mode] += settings.stiffness_scale * frequency * frequency * square;
                }
                // Position, attitude and the wake have no energy that is the aircraft's.
                _ => {}
            }
        }
        let total = shares.rigid + shares.modes.iter().sum::<f64>();
        shares.rigid /= total;
        shares.modes.iter_mut().for_each(|share| *share /= total);
        shares
    }

    /// The mode with the largest share, unless the root is one of flight mechanics.
    fn leading_mode(&self) -> Option<usize> {
        let leading = (0..self.modes.len()).max_by(|&a, &b| self.modes[a].total_cmp(&self.modes[b]));
        leading.filter(|_| self.rigid < FLIGHT)
    }
}

/// Whether a root oscillates.
pub fn oscillates(root: &Root) -> bool {
    oscillates_at(root.eigenvalue)
}

/// Whether an eigenvalue, 1/s, is that of an oscillation.
pub fn oscillates_at(eigenvalue: Complex<f64>) -> bool {
    eigenvalue.im.abs() > OSCILLATING
}

/// Frequency of a root, Hz.
pub fn frequency(root: &Root) -> f64 {
    root.eigenvalue.im.abs() / std::f64::consts::TAU
}

/// g = 2 Re λ / |Im λ| of a root that oscillates: the structural damping that it lacks.
///
/// [theory: linearisation.eigenvalues]
pub fn damping(root: &Root) -> f64 {
    2.0 * root.eigenvalue.re / root.eigenvalue.im.abs()
}

/// A mode by its number; load modes, which stand last, have numbers of their own: `load mode 1`.
fn mode_name(mode: usize, analysis: &Analysis) -> String {
    let natural = analysis.model.natural_modes();
    if mode < natural { format!("mode {}", mode + 1) } else { format!("load mode {}", mode - natural + 1) }
}

/// The motion that leads a root: `mode 2`, or `flight`.
pub fn leading_motion(root: &Root, analysis: &Analysis) -> String {
    match Shares::of(root, analysis).leading_mode() {
        Some(mode) => mode_name(mode, analysis),
        None => "flight".to_owned(),
    }
}

/// Whether a root is one of flight mechanics.
pub fn is_of_flight(root: &Root, analysis: &Analysis) -> bool {
    Shares::of(root, analysis).leading_mode().is_none()
}

/// A branch by the motion and the frequency it begins with.
pub fn name(branch: &Branch, analysis: &Analysis) -> String {
    let Some(root) = branch.roots.iter().flatten().next() else { return String::new() };
    let motion = leading_motion(root, analysis);
    if oscillates(root) {
        format!("{motion}, {} Hz", significant(frequency(root)))
    } else {
        format!("{motion}, aperiodic {}/s", significant(root.eigenvalue.re).replace('-', "−"))
    }
}

/// The motions that make up a root, largest share first: `60 % mode 2, 39 % mode 1`.
pub fn composition(root: &Root, analysis: &Analysis) -> String {
    let Shares { rigid, modes } = Shares::of(root, analysis);
    let named = modes.iter().enumerate().map(|(mode, share)| (*share, mode_name(mode, analysis)));
    let mut shares: Vec<(f64, String)> = named.chain([(rigid, "flight".to_owned())]).collect();
    shares.retain(|(share, _)| *share >= NOTABLE);
    shares.sort_by(|a, b| b.0.total_cmp(&a.0));
    let texts: Vec<String> =
        shares.iter().take(3).map(|(share, motion)| format!("{:.0} % {motion}", 100.0 * share)).collect();
    texts.join(", ")
}

/// A number with three digits or so.
fn significant(value: f64) -> String {
    match value.abs() {
        100.0.. => format!("{value:.0}"),
        10.0.. => format!("{value:.1}"),
        1.0.. => format!("{value:.2}"),
        _ => format!("{value:.3}"),
    }
}
