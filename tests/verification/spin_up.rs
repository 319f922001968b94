//! Geometric stiffening: the spin-up of a beam on a rotating base (T. R. Kane, R. R. Ryan, A. K. Banerjee, Dynamics
//! of a cantilever beam attached to a moving base, J. Guidance 10 (1987) 139–151; J. C. Simo, L. Vu-Quoc, J. Appl.
//! Mech. 53 (1986) 849–854).
//!
//! Without the axial–bending coupling of the strain energy (model I) centrifugal force softens the beam until it
//! breaks away; with it (CL, E) the beam lags behind, swings back and ends straight, stretched by ρω²L³/3E.
//! The lag is compared with Kane's theory in its continuous form,
//!
//! ```text
//! ρA (ẅ − ω²w + ω̇x) + EI w⁗ − (½ρAω²(L² − x²) w′)′ = 0,
//! ```
//!
//! solved here by Galerkin's method in the beam's own bending modes, and with the published value of the geometrically
//! exact rod of J. C. Simo, L. Vu-Quoc, Comput. Methods Appl. Mech. Eng. 66 (1988) 125–161, figure 6, as the ANSYS
//! Mechanical APDL Verification Manual 2023 R2 states it for the same beam and base (VM258, "peak transverse
//! displacement" 0.575 m at 6.85 s; in the package `ansys-mapdl-core` 0.74.1 as `examples/verif/vm258.dat`).

use std::f64::consts::TAU;

use flexible_aircraft::aircraft::{Limits, Support};
use flexible_aircraft::equations::{Configuration, EquationsOfMotion, Fidelity, Workspace};
use flexible_aircraft::structure::{
    ModalIntegrals, ModeShapes, ReducedModel, ReducedStation, StrainEnergy, Structure,
};
use nalgebra::{Complex, DMatrix, DVector, Schur, Vector3};

use crate::support::beams::{Cantilever, ENDS};
use crate::support::ritz::{bending_and_shortening, ritz_modes};

use super::record::Record;

const LENGTH: f64 = 10.0;
const AREA: f64 = 4e-4;
const SECOND_MOMENT: f64 = 2e-7;
const YOUNG: f64 = 7e10;
const DENSITY: f64 = 3000.0;

/// The base turns ever faster until then, s.
const SPIN_UP: f64 = 15.0;

/// Rates of the base before and after, rad/s.
#[derive(Clone, Copy)]
struct Base {
    from: f64,
    to: f64,
}

/// Kane's.
const FROM_REST: Base = Base { from: 0.0, to: 6.0 };

/// A gentle one, in which the beam is taut all the time.
const TAUT: Base = Base { from: 5.97, to: 6.0 };

impl Base {
    /// ω and ω̇ at a time.
    fn turns(self, time: f64) -> (f64, f64) {
        if time >= SPIN_UP {
            return (self.to, 0.0);
        }
        let (sin, cos) = libm::sincos(TAU * time / SPIN_UP);
        let mean = (self.to - self.from) / SPIN_UP;
        (self.from + mean * (time - SPIN_UP / TAU * sin), mean * (1.0 - cos))
    }
}

/// The beam along x, turning about z, in Ritz modes of a `full` basis. Natural axial modes span the same space, but
/// slowly: they have no strain at the tip.
fn model(elements: usize) -> ReducedModel {
    let beam = Cantilever {
        axis: Vector3::x(),
        y_axis: Vector3::y(),
        length: LENGTH,
        axial: YOUNG * AREA,
        torsional: 1e4,
        bending_y: YOUNG * SECOND_MOMENT,
        bending_z: YOUNG * SECOND_MOMENT,
        mass_per_length: DENSITY * AREA,
        gyration: libm::sqrt(2.0 * SECOND_MOMENT / AREA),
        lumps: ENDS,
    };
    let aircraft = beam.aircraft(elements);
    let structure = Structure::new(&aircraft).unwrap();
    let (modes, shapes) = ritz_modes(&structure, &bending_and_shortening(&structure));
    let tip = structure.unknowns() - 6;
    let at_tip = |first: usize| shapes.rows(first, 3).transpose().as_slice().to_vec();
    ReducedModel {
        name: aircraft.name.clone(),
        gravity: 0.0,
        support: Support::Clamped,
        inflow_states: 0,
        airspeed: 127.0,
        altitude: 7620.0,
        limits: Limits::default(),
        tunnel_air: None,
        mount: Vector3::zeros(),
        modes,
        integrals: ModalIntegrals::new(&structure, &shapes),
        strain_energy: StrainEnergy::new(&structure, &shapes),
        strips: Vec::new(),
        controls: Vec::new(),
        engines: Vec::new(),
        stations: vec![ReducedStation {
            name: "tip".to_owned(),
            position: Vector3::x() * LENGTH,
            twist_axis: Vector3::x(),
            shapes: ModeShapes { translation: at_tip(tip), rotation: at_tip(tip + 3) },
        }],
    }
}

/// What the tip does.
struct History {
    /// Largest lag, m; infinite when the beam breaks away.
    peak_lag: f64,
    /// When, s.
    peak_time: f64,
    /// Largest lateral motion in the last two seconds, m.
    residual: f64,
    /// Mean stretch in the last two seconds, m.
    stretch: f64,
}

/// The beam's equations with the motion of the base prescribed.
struct Spinning<'a> {
    model: &'a ReducedModel,
    base: Base,
    equations: EquationsOfMotion,
    workspace: Workspace,
    /// Whether the mass matrix is that of the deformed beam.
    deformed: bool,
}

impl<'a> Spinning<'a> {
    fn new(model: &'a ReducedModel, fidelity: Fidelity, base: Base) -> Self {
        let configuration = Configuration {
            fidelity,
            stiffness_scale: 1.0,
            structural_damping: 0.0,
            inflow_states: 0,
            tunnel_flow: Vector3::zeros(),
        };
        let equations = EquationsOfMotion::new(model, &configuration);
        let workspace = Workspace::new(&equations);
        Spinning { model, base, equations, workspace, deformed: fidelity.terms().deformed_mass }
    }

    /// q̈: what the equations of the clamped beam say at ω held, less what ω̇ does to the generalised rows.
    /// Modes are mass-normalised: M = 1.
    fn acceleration(&mut self, time: f64, q: &DVector<f64>, q_dot: &DVector<f64>) -> DVector<f64> {
        let layout = *self.equations.layout();
        let (rate, rate_change) = self.base.turns(time);
        let mut state = vec![0.0; layout.len()];
        state[layout.attitude().start] = 1.0;
        state[layout.rate().end - 1] = rate;
        state[layout.coordinates()].copy_from_slice(q.as_slice());
        state[layout.coordinate_rates()].copy_from_slice(q_dot.as_slice());
        let mut rates = vec![0.0; layout.len()];
        self.equations.rates(&state, &self.equations.neutral_controls(), &mut rates, &mut self.workspace);
        let (n, integrals) = (q.len(), &self.model.integrals);
        DVector::from_fn(n, |a, _| {
            let mut h = integrals.angular_momentum[a].z;
            if self.deformed {
                h += (0..n).map(|b| integrals.upsilon[a * n + b].z * q[b]).sum::<f64>();
            }
            self.workspace.accelerations()[6 + a] - h * rate_change
        })
    }
}

/// Flies 20 s of the manoeuvre, from rest in the frame of the base.
fn spin_up(model: &ReducedModel, fidelity: Fidelity, base: Base) -> History {
    let n = model.modes.len();
    let mut beam = Spinning::new(model, fidelity, base);
    let q = beam.equilibrium(0.0);
    let tip = |q: &DVector<f64>, axis: usize| {
        DVector::from_row_slice(&model.stations[0].shapes.translation[axis * n..(axis + 1) * n]).dot(q)
    };
    // The highest Ritz mode has 19 000 rad/s.
    integrate(q, 1.25e-4, |time, q, q_dot| beam.acceleration(time, q, q_dot), |q| [-tip(q, 1), tip(q, 0)])
}

impl Spinning<'_> {
    /// ∂q̈/∂q and ∂q̈/∂q̇ at rest at q.
    fn jacobians(&mut self, time: f64, q: &DVector<f64>) -> [DMatrix<f64>; 2] {
        const STEP: f64 = 1e-6;
        let n = q.len();
        let rest = DVector::zeros(n);
        [true, false].map(|moves_q| {
            let column = |mode: usize| {
                let mut sides = [1.0, -1.0].map(|sign| {
                    let step = DVector::from_fn(n, |i, _| if i == mode { sign * STEP } else { 0.0 });
                    if moves_q {
                        self.acceleration(time, &(q + step), &rest)
                    } else {
                        self.acceleration(time, q, &step)
                    }
                });
                sides[0] -= sides[1].clone();
                sides[0].clone() / (2.0 * STEP)
            };
            DMatrix::from_columns(&(0..n).map(column).collect::<Vec<_>>())
        })
    }

    /// Where the beam rests while the base turns as it does at a time.
    fn equilibrium(&mut self, time: f64) -> DVector<f64> {
        let rest = DVector::zeros(self.model.modes.len());
        let mut q = rest.clone();
        for _ in 0..10 {
            let residual = self.acceleration(time, &q, &rest);
            q -= self.jacobians(time, &q)[0].clone().lu().solve(&residual).unwrap();
        }
        q
    }
}

/// The slowest eigenvalue (1/s) of small motion about the beam turning steadily at 6 rad/s.
fn slowest_eigenvalue(model: &ReducedModel, fidelity: Fidelity) -> Complex<f64> {
    let n = model.modes.len();
    let mut beam = Spinning::new(model, fidelity, FROM_REST);
    let q = beam.equilibrium(SPIN_UP);
    let [stiffness, gyroscopic] = beam.jacobians(SPIN_UP, &q);
    let mut matrix = DMatrix::zeros(2 * n, 2 * n);
    matrix.view_mut((0, n), (n, n)).fill_with_identity();
    matrix.view_mut((n, 0), (n, n)).copy_from(&stiffness);
    matrix.view_mut((n, n), (n, n)).copy_from(&gyroscopic);
    let eigenvalues = Schur::new(matrix).complex_eigenvalues();
    let upper = eigenvalues.iter().filter(|x| x.im >= 0.0 && x.re > -1e-3);
    *upper.min_by(|a, b| a.norm().total_cmp(&b.norm())).unwrap()
}

/// Runge–Kutta steps of q̈ = f(t, q, q̇) from rest at q over 20 s; `tip` is its lag and stretch at q.
fn integrate(
    mut q: DVector<f64>,
    step: f64,
    mut accelerate: impl FnMut(f64, &DVector<f64>, &DVector<f64>) -> DVector<f64>,
    tip: impl Fn(&DVector<f64>) -> [f64; 2],
) -> History {
    let mut p = DVector::zeros(q.len());
    let mut history = History { peak_lag: 0.0, peak_time: 0.0, residual: 0.0, stretch: 0.0 };
    let steps = (20.0 / step).round() as usize;
    let last = (18.0 / step).round() as usize;
    for index in 0..steps {
        let t = index as f64 * step;
        let a1 = accelerate(t, &q, &p);
        let (q2, p2) = (&q + &p * (0.5 * step), &p + &a1 * (0.5 * step));
        let a2 = accelerate(t + 0.5 * step, &q2, &p2);
        let (q3, p3) = (&q + &p2 * (0.5 * step), &p + &a2 * (0.5 * step));
        let a3 = accelerate(t + 0.5 * step, &q3, &p3);
        let (q4, p4) = (&q + &p3 * step, &p + &a3 * step);
        let a4 = accelerate(t + step, &q4, &p4);
        q += (&p + p2 * 2.0 + p3 * 2.0 + p4) * (step / 6.0);
        p += (a1 + a2 * 2.0 + a3 * 2.0 + a4) * (step / 6.0);
        let [lag, stretch] = tip(&q);
        if lag.is_nan() || lag.abs() >= LENGTH {
            history.peak_lag = f64::INFINITY;
            history.peak_time = t;
            return history;
        }
        if lag > history.peak_lag {
            (history.peak_lag, history.peak_time) = (lag, t);
        }
        if index >= last {
            history.residual = history.residual.max(lag.abs());
            history.stretch += stretch / (steps - last) as f64;
        }
    }
    history
}

/// Kane's theory by Galerkin's method in four cantilever modes, integrals by the midpoint rule.
struct Kane {
    mass: DMatrix<f64>,
    bending: DMatrix<f64>,
    /// Of the centrifugal force at 1 rad/s.
    tension: DMatrix<f64>,
    lever: DVector<f64>,
    tips: Vec<f64>,
}

fn kane() -> Kane {
    let modes = 4;
    const ROOTS: [f64; 4] =
        [1.875_104_068_711_961, 4.694_091_132_974_175, 7.854_757_438_237_613, 10.995_540_734_875_467];
    const PANELS: usize = 2000;
    let line_density = DENSITY * AREA;
    let (mut mass, mut bending, mut tension) =
        (DMatrix::zeros(modes, modes), DMatrix::zeros(modes, modes), DMatrix::zeros(modes, modes));
    let mut lever = DVector::zeros(modes);
    let shape = |k: usize, x: f64| {
        let z = ROOTS[k] * x / LENGTH;
        let (ch, sh, c, s) = (libm::cosh(z), libm::sinh(z), libm::cos(z), libm::sin(z));
        let r = ROOTS[k];
        let sigma = (libm::sinh(r) - libm::sin(r)) / (libm::cosh(r) + libm::cos(r));
        let wave = r / LENGTH;
        [
            ch - c - sigma * (sh - s),
            wave * (sh + s - sigma * (ch - c)),
            wave * wave * (ch + c - sigma * (sh + s)),
        ]
    };
    for panel in 0..PANELS {
        let dx = LENGTH / PANELS as f64;
        let x = (panel as f64 + 0.5) * dx;
        let values: Vec<_> = (0..modes).map(|k| shape(k, x)).collect();
        for (a, [w_a, slope_a, curvature_a]) in values.iter().enumerate() {
            lever[a] += line_density * x * w_a * dx;
            for (b, [w_b, slope_b, curvature_b]) in values.iter().enumerate() {
                mass[(a, b)] += line_density * w_a * w_b * dx;
                bending[(a, b)] += YOUNG * SECOND_MOMENT * curvature_a * curvature_b * dx;
                tension[(a, b)] += 0.5 * line_density * (LENGTH * LENGTH - x * x) * slope_a * slope_b * dx;
            }
        }
    }
    let tips = (0..modes).map(|k| shape(k, LENGTH)[0]).collect();
    Kane { mass, bending, tension, lever, tips }
}

impl Kane {
    /// Lateral stiffness at a steady rate of the base.
    fn stiffness(&self, rate: f64) -> DMatrix<f64> {
        &self.bending + (&self.tension - &self.mass) * (rate * rate)
    }

    fn spin_up(&self, base: Base) -> History {
        let inverse = self.mass.clone().try_inverse().unwrap();
        let accelerate = |time: f64, q: &DVector<f64>, _: &DVector<f64>| {
            let (rate, rate_change) = base.turns(time);
            &inverse * (&self.lever * -rate_change - self.stiffness(rate) * q)
        };
        let lag = |q: &DVector<f64>| -q.iter().zip(&self.tips).map(|(q, tip)| q * tip).sum::<f64>();
        integrate(DVector::zeros(self.tips.len()), 1e-3, accelerate, |q| [lag(q), 0.0])
    }

    /// The lowest frequency of lateral motion in the rotating frame, rad/s.
    fn frequency(&self, rate: f64) -> f64 {
        let inverse = self.mass.clone().try_inverse().unwrap();
        let squares = (inverse * self.stiffness(rate)).complex_eigenvalues();
        libm::sqrt(squares.iter().map(|square| square.re).fold(f64::INFINITY, f64::min))
    }
}

#[test]
fn the_exact_beam_lags_as_published_and_as_in_kanes_theory_and_ends_stretched() {
    let mut record = Record::new(
        "spin-up",
        "Spin-up of Kane's beam to 6 rad/s in 15 s, 80 elements",
        "published: ANSYS Verification Manual VM258 after figure 6 of Simo, Vu-Quoc 1988 (0.575 m at 6.85 s, read from a figure); \
         theory: Kane's, in its continuous form, integrated here; stretch: ρω²L³/3E (Simo, Vu-Quoc 1986; VM258: 5.14e-4 m)",
    );
    let theory = kane().spin_up(FROM_REST);
    let model = model(80);
    let exact = spin_up(&model, Fidelity::Exact, FROM_REST);
    record.relative("E: largest lag of the tip, published, m", 0.575, 5e-3, exact.peak_lag);
    record.absolute("E: time of the largest lag, published, s", 6.85, 0.1, exact.peak_time);
    record.relative("E: largest lag of the tip, theory, m", theory.peak_lag, 5e-3, exact.peak_lag);
    record.absolute("E: time of the largest lag, theory, s", theory.peak_time, 0.01, exact.peak_time);
    let stretch = DENSITY * 36.0 * LENGTH.powi(3) / (3.0 * YOUNG);
    record.relative("E: stretch in the last two seconds, m", stretch, 2e-3, exact.stretch);
    record.absolute("E: lateral motion in the last two seconds, m", theory.residual, 5e-4, exact.residual);
    for (name, fidelity) in [("I", Fidelity::Inconsistent), ("CL", Fidelity::ConsistentlyLinearised)] {
        let history = spin_up(&model, fidelity, FROM_REST);
        let breaks_away = if history.peak_lag.is_infinite() { history.peak_time } else { f64::INFINITY };
        record.at_most(&format!("{name} breaks away: lag as long as the beam at, s"), SPIN_UP, breaks_away);
    }
    record.remark(
        "CL keeps the cubic energy ½EA u′w′² and drops the quartic ⅛EA w′⁴ that bounds it. Once axial modes can follow, \
         u′ → −½w′² takes away −⅛EA w′⁴, and a lag of a few centimetres suffices to break the beam away. So CL loses \
         static stability with axial modes [theory: structure.axially-rigid]: CL is for bending–torsion bases, or for motion \
         as small as in the next two cases.",
    );
    record.finish();
}

#[test]
fn a_taut_beam_stays_bounded_with_geometric_stiffening_alone() {
    let mut record = Record::new(
        "spin-up-taut",
        "Spin-up of the same beam from 5.97 to 6 rad/s in 15 s, 80 elements",
        "theory: Kane's; stretch: ρω²L³/3E",
    );
    let theory = kane().spin_up(TAUT);
    let model = model(80);
    let stretch = DENSITY * 36.0 * LENGTH.powi(3) / (3.0 * YOUNG);
    for (name, fidelity) in [("E", Fidelity::Exact), ("CL", Fidelity::ConsistentlyLinearised)] {
        let history = spin_up(&model, fidelity, TAUT);
        record.relative(
            &format!("{name}: largest lag of the tip, m"),
            theory.peak_lag,
            5e-3,
            history.peak_lag,
        );
        record.relative(
            &format!("{name}: stretch in the last two seconds, m"),
            stretch,
            2e-3,
            history.stretch,
        );
        record.absolute(
            &format!("{name}: lateral motion in the last two seconds, m"),
            theory.residual,
            1e-4,
            history.residual,
        );
    }
    let history = spin_up(&model, Fidelity::Inconsistent, TAUT);
    let breaks_away = if history.peak_lag.is_infinite() { history.peak_time } else { f64::INFINITY };
    record.at_most("I breaks away: lag as long as the beam at, s", SPIN_UP, breaks_away);
    record.finish();
}

#[test]
fn the_spinning_beam_has_the_frequency_of_kanes_theory_in_small_motion() {
    let mut record = Record::new(
        "spinning",
        "Small lateral motion of the same beam turning steadily at 6 rad/s, 80 elements",
        "Kane's theory: frequency in the plane of rotation; without tension √(ω² − ω₁²) is a growth rate",
    );
    let (theory, model) = (kane(), model(80));
    for fidelity in [Fidelity::Exact, Fidelity::ConsistentlyLinearised] {
        let found = slowest_eigenvalue(&model, fidelity);
        record.relative(&format!("{fidelity:?}: frequency, rad/s"), theory.frequency(6.0), 1e-3, found.im);
        record.rounding(&format!("{fidelity:?}: growth, 1/s"), 1e-5, found.re);
    }
    let growth = libm::sqrt(36.0 - theory.frequency(0.0).powi(2));
    let found = slowest_eigenvalue(&model, Fidelity::Inconsistent);
    record.relative("Inconsistent: growth, 1/s", growth, 1e-3, found.re);
    record.finish();
}
