//! One aerofoil strip on an aircraft without mass or modes, whose motion a test prescribes: loads are the forces
//! on ν = [v; ω; q̇] without the part that is proportional to accelerations.

use std::sync::Arc;

use flexible_aircraft::air::FrozenGust;
use flexible_aircraft::aircraft::{Bounds, Control, Flap, Limits, Mirroring, Support};
use flexible_aircraft::equations::{Configuration, Controls, EquationsOfMotion, Fidelity, Workspace};
use flexible_aircraft::structure::{ModalIntegrals, ModeShapes, ReducedModel, ReducedStrip, StrainEnergy};
use nalgebra::{Matrix3, Vector3};

/// Semichord, m.
pub const SEMICHORD: f64 = 0.5;

/// ISO 2533 at sea level, kg/m³.
pub const DENSITY: f64 = 1.225;

/// Forward speed, m/s.
pub const SPEED: f64 = 20.0;

/// A strip of 1 m width with 2π lift slope, its elastic axis a distance (in semichords) behind mid-chord.
pub struct PrescribedStrip {
    equations: EquationsOfMotion,
    workspace: Workspace,
    /// Two; the first turns the flap.
    pub controls: Controls,
    /// All states of the equations; the motion is written into them.
    pub state: Vec<f64>,
}

impl PrescribedStrip {
    /// At rest in its own motion, wake at rest. `hinge` is a fraction of the chord.
    pub fn new(inflow_states: usize, axis: f64, suction: f64, hinge: f64) -> Self {
        PrescribedStrip::altered(inflow_states, axis, suction, hinge, |_| {})
    }

    /// The same with other properties.
    pub fn altered(
        inflow_states: usize,
        axis: f64,
        suction: f64,
        hinge: f64,
        alter: impl FnOnce(&mut ReducedStrip),
    ) -> Self {
        let flap = Flap {
            lift_slope: std::f64::consts::TAU,
            hinge,
            moment_slope: None,
            drag: 0.0,
            gains: vec![1.0, 0.0],
        };
        let mut strip = ReducedStrip {
            component: "strip".to_owned(),
            position: Vector3::zeros(),
            section: 0,
            forward: Vector3::x(),
            span: Vector3::y(),
            semichord: SEMICHORD,
            elastic_axis_aft_of_midchord: axis * SEMICHORD,
            width: 1.0,
            lift_slope: std::f64::consts::TAU,
            zero_lift_offset: 0.0,
            zero_lift_moment: 0.0,
            moment_slope: 0.0,
            profile_drag: 0.0,
            leading_edge_suction: suction,
            flap: Some(flap),
            shapes: ModeShapes::default(),
        };
        alter(&mut strip);
        let equations = EquationsOfMotion::new(&model(strip), &configuration(inflow_states)).unwrap();
        let mut state = vec![0.0; equations.layout().len()];
        state[equations.layout().attitude().start] = 1.0;
        state[equations.layout().velocity().start] = SPEED;
        let workspace = Workspace::new(&equations);
        PrescribedStrip { workspace, controls: equations.neutral_controls(), state, equations }
    }

    /// Prescribes w = n·V (m/s) and Ω (rad/s).
    pub fn move_with(&mut self, upwash: f64, pitch_rate: f64) {
        let layout = *self.equations.layout();
        self.state[layout.velocity().end - 1] = upwash;
        self.state[layout.rate().start + 1] = pitch_rate;
    }

    /// Has the strip fly into this.
    pub fn fly_into(&mut self, gust: FrozenGust) {
        self.equations.take_gust(Arc::new(gust));
    }

    /// Puts the strip so far north, m.
    pub fn stand_at(&mut self, north: f64) {
        let place = self.equations.layout().position().start;
        self.state[place] = north;
    }

    /// Where the inflow states stand.
    pub fn inflow(&self) -> std::ops::Range<usize> {
        self.equations.layout().inflow()
    }

    /// Forces along x, z and about y, and the rates of the inflow states.
    pub fn evaluate(&mut self) -> ([f64; 3], Vec<f64>) {
        let mut rates = vec![0.0; self.state.len()];
        self.equations.rates(&self.state, &self.controls, &mut rates, &mut self.workspace);
        let forces = self.workspace.forces();
        ([forces[0], forces[2], forces[4]], rates[self.inflow()].to_vec())
    }
}

fn configuration(inflow_states: usize) -> Configuration {
    Configuration {
        fidelity: Fidelity::Rigid,
        stiffness_scale: 1.0,
        structural_damping: 0.0,
        inflow_states,
        temperature_offset: 0.0,
        tunnel_flow: Vector3::zeros(),
    }
}

/// A control without limits or role.
fn control(name: &str) -> Control {
    Control {
        name: name.to_owned(),
        description: "Flap angle".to_owned(),
        positive: "trailing edge down".to_owned(),
        limits: Bounds::of_usual_control(),
        role: None,
        mirroring: Mirroring::Same,
    }
}

/// Nothing but a strip.
fn model(strip: ReducedStrip) -> ReducedModel {
    ReducedModel {
        name: "Strip".to_owned(),
        gravity: 0.0,
        support: Support::Free,
        fidelity: Fidelity::Exact,
        inflow_states: 0,
        airspeed: 127.0,
        altitude: 7620.0,
        temperature_offset: 0.0,
        limits: Limits::default(),
        tunnel_air: None,
        mount: Vector3::zeros(),
        modes: Vec::new(),
        integrals: ModalIntegrals {
            mass: 0.0,
            first_moment: Vector3::zeros(),
            inertia: Matrix3::zeros(),
            momentum: Vec::new(),
            angular_momentum: Vec::new(),
            gamma: Vec::new(),
            pi: Vec::new(),
            upsilon: Vec::new(),
            mass_matrix: Vec::new(),
        },
        strain_energy: StrainEnergy::zero(0),
        static_loads: Vec::new(),
        sections: Vec::new(),
        strips: vec![strip],
        controls: ["first", "second"].map(control).to_vec(),
        engines: Vec::new(),
        stations: Vec::new(),
        masses: Vec::new(),
        cuts: Vec::new(),
        joints: Vec::new(),
    }
}
