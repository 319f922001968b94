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

use flexible_aircraft::aircraft::{Limits, Support};
use flexible_aircraft::equations::{Configuration, EquationsOfMotion, Fidelity, Workspace};
use flexible_aircraft::structure::{
    Carrier, ModalIntegrals, ModeShapes, ReducedModel, ReducedStation, StrainEnergy, Structure,
};
use nalgebra::{Complex, DMatrix, DVector, Schur, Vector3};

use crate::support::kane::{
    Base, DENSITY, FROM_REST, History, LENGTH, SPIN_UP, TAUT, YOUNG, beam, integrate, kane,
};
use crate::support::ritz::{bending_and_shortening, ritz_modes};

use super::record::Record;

/// The beam along x, turning about z, in Ritz modes of a `full` basis. Natural axial modes span the same space, but
/// slowly: they have no strain at the tip.
fn model(elements: usize) -> ReducedModel {
    let aircraft = beam(1.0).aircraft(elements);
    let structure = Structure::new(&aircraft).unwrap();
    let (modes, shapes) = ritz_modes(&structure, &bending_and_shortening(&structure));
    let tip = structure.unknowns() - 6;
    let at_tip = |first: usize| shapes.rows(first, 3).transpose().as_slice().to_vec();
    ReducedModel {
        name: aircraft.name.clone(),
        gravity: 0.0,
        support: Support::Clamped,
        fidelity: Fidelity::Exact,
        inflow_states: 0,
        airspeed: 127.0,
        altitude: 7620.0,
        temperature_offset: 0.0,
        limits: Limits::default(),
        tunnel_air: None,
        mount: Vector3::zeros(),
        modes,
        integrals: ModalIntegrals::new(&structure, &shapes),
        strain_energy: StrainEnergy::new(&structure, &shapes),
        static_loads: Vec::new(),
        sections: Vec::new(),
        strips: Vec::new(),
        controls: Vec::new(),
        engines: Vec::new(),
        stations: vec![ReducedStation {
            name: "tip".to_owned(),
            position: Vector3::x() * LENGTH,
            carrier: Carrier { section: 0, mirrored: false },
            twist_axis: Vector3::x(),
            shapes: ModeShapes { translation: at_tip(tip), rotation: at_tip(tip + 3) },
        }],
        masses: Vec::new(),
        cuts: Vec::new(),
        joints: Vec::new(),
    }
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
            temperature_offset: 0.0,
            tunnel_flow: Vector3::zeros(),
        };
        let equations = EquationsOfMotion::new(model, &configuration).unwrap();
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
