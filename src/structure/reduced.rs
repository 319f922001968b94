//! The reduced model: everything that the flight needs of an aircraft, and nothing else.
//!
//! [theory: structure.shapes, structure.integrals, strain-energy.polynomial, air-loads.strip]

use nalgebra::{DMatrix, DVector, Vector3};
use serde::{Deserialize, Serialize};

use crate::aircraft::{Aircraft, Control, Fidelity, Flap, Limits, Support, TrimRole, TunnelAir};

use super::assembly::Structure;
use super::carrier::Carrier;
use super::cuts::{ReducedCut, ReducedMass, reduced_cuts, reduced_masses};
use super::loops;
use super::mode_count::ModeCount;
use super::sections::SectionTree;
use super::{
    BeamSection, ModalBasis, ModalIntegrals, Mode, ModeKind, ModeShapes, ModesInUse, StaticLoad,
    StrainEnergy, StructureError,
};

/// An aircraft reduced to its modes.
///
/// ```
/// use flexible_aircraft::{Aircraft, ReducedModel};
///
/// let wing = ReducedModel::new(&Aircraft::read("aircraft/goland-wing.toml")?, 2)?;
/// let [bending, torsion] = [0, 1].map(|mode| wing.modes[mode].angular_frequency); // rad/s
/// assert!((bending - 48.2).abs() < 0.1 && (torsion - 95.9).abs() < 0.1);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct ReducedModel {
    /// Name for people.
    pub name: String,
    /// m/s², down.
    pub gravity: f64,
    /// Free flight or wind tunnel.
    pub support: Support,
    /// The level of fidelity at which it flies unless someone asks for another.
    pub fidelity: Fidelity,
    /// Default number of inflow states.
    pub inflow_states: usize,
    /// Default airspeed, m/s.
    pub airspeed: f64,
    /// Default altitude, m.
    pub altitude: f64,
    /// By how much the air is warmer than the standard atmosphere, K.
    pub temperature_offset: f64,
    /// What its trims should stay within.
    pub limits: Limits,
    /// The air around a clamped aircraft; `None`: that of the standard atmosphere.
    pub tunnel_air: Option<TunnelAir>,
    /// Roll, pitch and yaw of a clamped aircraft in the tunnel, rad.
    pub mount: Vector3<f64>,
    /// Natural modes, lowest frequency first; then load modes, if there are any.
    pub modes: Vec<Mode>,
    /// Integrals over the mass.
    pub integrals: ModalIntegrals,
    /// Strain energy at nominal stiffness.
    pub strain_energy: StrainEnergy,
    /// The loads whose strains the load modes are; none where the model has no load modes.
    pub static_loads: Vec<StaticLoad>,
    /// Where geometrically exact kinematics evaluates the structure, each after its parent.
    pub sections: Vec<BeamSection>,
    /// Aerodynamic strips.
    pub strips: Vec<ReducedStrip>,
    /// What moves the flaps, in the order of the inputs.
    pub controls: Vec<Control>,
    /// Engines, in the order of the inputs.
    pub engines: Vec<ReducedEngine>,
    /// Named points.
    pub stations: Vec<ReducedStation>,
    /// All mass, bay by bay: what the sections carry, told apart.
    pub masses: Vec<ReducedMass>,
    /// Where section loads are outputs.
    pub cuts: Vec<ReducedCut>,
    /// What each joint joins, for messages. Each closes a loop of beams: geometrically exact kinematics does not fly such a model.
    pub joints: Vec<String>,
}

/// A strip with the mode shapes at its attachment.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct ReducedStrip {
    /// The component it belongs to, for messages.
    pub component: String,
    /// Undeformed attachment, body axes, m.
    pub position: Vector3<f64>,
    /// Which of the sections carries it.
    pub section: usize,
    /// f, unit vector towards the leading edge.
    pub forward: Vector3<f64>,
    /// s, unit vector; positive rotation about it is nose-up.
    pub span: Vector3<f64>,
    /// b, m.
    pub semichord: f64,
    /// d, m.
    pub elastic_axis_aft_of_midchord: f64,
    /// Δy, m.
    pub width: f64,
    /// CLα, 1/rad.
    pub lift_slope: f64,
    /// α0, rad.
    pub zero_lift_offset: f64,
    /// c_m0: the section's moment coefficient about its aerodynamic centre.
    pub zero_lift_moment: f64,
    /// c_mα, 1/rad.
    pub moment_slope: f64,
    /// CD0.
    pub profile_drag: f64,
    /// η.
    pub leading_edge_suction: f64,
    /// The flap, when there is one.
    pub flap: Option<Flap>,
    /// On the elastic axis.
    pub shapes: ModeShapes,
}

impl ReducedStrip {
    /// Whether the strip lies in the mirror plane with its span across it, and every mode leaves it so.
    pub fn stays_in_plane(&self) -> bool {
        let ReducedStrip { position, forward, span, shapes, .. } = self;
        let across = ModeShapes::ACROSS.into_iter().flat_map(|row| shapes.row(row));
        let mut all = [&position.y, &forward.y, &span.x, &span.z].into_iter().chain(across);
        all.all(|number| *number == 0.0)
    }

    /// Takes off what symmetry up to rounding has left across the mirror plane [theory: symmetry.in-plane].
    pub fn lay_in_plane(&mut self) {
        let ReducedStrip { position, forward, span, shapes, .. } = self;
        (position.y, forward.y) = (0.0, 0.0);
        *span = Vector3::new(0.0, span.y.signum(), 0.0);
        ModeShapes::ACROSS.into_iter().for_each(|row| shapes.row_mut(row).fill(0.0));
    }
}

/// An engine with the mode shapes at the point where its thrust acts.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct ReducedEngine {
    /// Its input is `thrust_<name>`.
    pub name: String,
    /// Undeformed point of action, body axes, m.
    pub position: Vector3<f64>,
    /// The section that carries it.
    pub carrier: Carrier,
    /// Unit vector of positive thrust.
    pub direction: Vector3<f64>,
    /// About it, N·m per N.
    pub torque: f64,
    /// Of what turns in it, along the direction, kg·m²/s.
    pub angular_momentum: f64,
    /// In what proportion it has the thrust of trims.
    pub trim_share: f64,
    /// At the point of action.
    pub shapes: ModeShapes,
}

/// A named point with the mode shapes there.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct ReducedStation {
    /// Its outputs are `deflection.<name>.*`.
    pub name: String,
    /// Undeformed position, body axes, m.
    pub position: Vector3<f64>,
    /// The section that carries it.
    pub carrier: Carrier,
    /// Axis about which the twist counts.
    pub twist_axis: Vector3<f64>,
    /// On the elastic axis.
    pub shapes: ModeShapes,
}

impl Aircraft {
    /// Reduces the aircraft to as many modes as are usual: see [`ReducedModel::new`] for other numbers.
    ///
    /// ```
    /// let model = flexible_aircraft::Aircraft::read("aircraft/generic-business-jet.toml")?.reduce()?;
    /// assert_eq!((model.modes.len(), model.engines.len()), (26, 2));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// When the structure has no modes or its numbers overflow.
    pub fn reduce(&self) -> Result<ReducedModel, StructureError> {
        ReducedModel::new(self, ModeCount::Usual(ReducedModel::USUAL_MODES))
    }
}

impl ReducedModel {
    /// How many modes a model has unless someone asks for another number: of the generic business jet's 26
    /// lowest modes twelve are symmetric, so that the FMU's `mode_count` of 12 serves either `mode_family`.
    pub const USUAL_MODES: usize = 26;

    /// The most modes that a model can have: the quartic strain energy then has 9 million coefficients, which are 73 MB of
    /// an FMU, and a flight with all of them needs ten times as much memory.
    pub const MOST_MODES: usize = 120;

    /// Reduces an aircraft to its lowest modes of all families together, and to those that they make pairs with; a plain
    /// number is one that is asked for.
    ///
    /// # Errors
    /// When there are no such modes, too many are asked for, or the numbers overflow.
    pub fn new(aircraft: &Aircraft, count: impl Into<ModeCount>) -> Result<Self, StructureError> {
        Self::with(aircraft, count.into(), ModeKind::All)
    }

    /// Reduces an aircraft to its lowest modes, as many as it takes to have `count` of a kind among them.
    ///
    /// # Errors
    /// As [`new`](Self::new), or for symmetric modes of a structure without mirror plane.
    pub fn with(aircraft: &Aircraft, count: ModeCount, kind: ModeKind) -> Result<Self, StructureError> {
        let structure = Structure::new(aircraft)?;
        let basis = ModalBasis::with(&structure, count, kind)?;
        Self::of_basis(&structure, basis)
    }

    /// Reduces a structure to the modes of a basis.
    ///
    /// # Errors
    /// When there are too many, the numbers overflow, or there are loops that its level or its cuts cannot have.
    pub fn of_basis(structure: &Structure, basis: ModalBasis) -> Result<Self, StructureError> {
        let aircraft = structure.aircraft;
        let (wanted, most) = (basis.modes.len(), Self::MOST_MODES);
        if wanted > most {
            return Err(StructureError::TooManyModes { wanted, most });
        }
        loops::refuse(aircraft)?;
        let tree = SectionTree::new(structure, &basis.shapes, basis.mirror.as_ref());
        let model = ReducedModel {
            name: aircraft.name.clone(),
            gravity: aircraft.gravity,
            support: aircraft.support,
            fidelity: aircraft.fidelity,
            inflow_states: aircraft.inflow_states,
            airspeed: aircraft.airspeed,
            altitude: aircraft.altitude,
            temperature_offset: aircraft.temperature_offset,
            limits: aircraft.limits,
            tunnel_air: aircraft.tunnel_air,
            mount: aircraft.mount,
            integrals: ModalIntegrals::new(structure, &basis.shapes),
            strain_energy: StrainEnergy::new(structure, &basis.shapes),
            static_loads: basis.static_loads,
            controls: aircraft.controls.clone(),
            strips: reduced_strips(structure, &tree, &basis.shapes),
            engines: reduced_engines(structure, &tree, &basis.shapes),
            stations: reduced_stations(structure, &tree, &basis.shapes),
            masses: reduced_masses(structure, &tree),
            cuts: reduced_cuts(structure, &tree, &basis.shapes),
            sections: tree.sections,
            joints: aircraft.joints.iter().map(ToString::to_string).collect(),
            modes: basis.modes,
        };
        if model.is_finite() { Ok(model) } else { Err(StructureError::NotFinite) }
    }

    /// The place among the inputs of the control with a name.
    pub fn control(&self, name: &str) -> Option<usize> {
        self.controls.iter().position(|control| control.name == name)
    }

    /// The place among the inputs of the control with a role in trims.
    pub fn control_for(&self, role: TrimRole) -> Option<usize> {
        self.controls.iter().position(|control| control.role == Some(role))
    }

    /// Whether every computed number is finite.
    pub(super) fn is_finite(&self) -> bool {
        let finite =
            |shapes: &ModeShapes| shapes.translation.iter().chain(&shapes.rotation).all(|x| x.is_finite());
        self.modes.iter().all(|mode| mode.angular_frequency.is_finite())
            && self.integrals.is_finite()
            && self.strain_energy.is_finite()
            && self.static_loads.iter().flat_map(|load| &load.forces).all(|force| force.is_finite())
            && self.sections.iter().all(|section| finite(&section.steps) && section.body.is_finite())
            && self.strips.iter().all(|strip| finite(&strip.shapes))
            && self.engines.iter().all(|engine| finite(&engine.shapes))
            && self.stations.iter().all(|station| finite(&station.shapes))
            && self.cuts.iter().all(|cut| finite(&cut.steps))
    }

    /// The model with a choice of modes (ascending indices), all others held at rest. Load modes among them keep the loads that
    /// they are the strains of.
    ///
    /// # Panics
    /// When the model has no mode with one of the indices.
    pub fn select(&self, chosen: &[usize]) -> Self {
        let mut model = self.clone();
        model.modes = chosen.iter().map(|&mode| self.modes[mode]).collect();
        model.integrals = self.integrals.select(chosen);
        model.strain_energy = self.strain_energy.select(chosen);
        model.take_loads(|forces| chosen.iter().map(|&mode| forces[mode]).collect());
        model.all_shapes_mut().for_each(|shapes| *shapes = shapes.select(chosen));
        model
    }

    /// The model with these coordinates, everything else held at rest.
    ///
    /// # Panics
    /// When they are those of a model with other modes.
    pub fn in_use(&self, modes: &ModesInUse) -> Self {
        if let Some(chosen) = modes.plain() {
            return self.select(&chosen);
        }
        let (own, shares) = modes.columns(&self.modes);
        let mut model = ReducedModel { modes: own, ..self.clone() };
        model.integrals = self.integrals.combine(&shares);
        model.strain_energy = self.strain_energy.combine(&shares);
        model.take_loads(|forces| shares.tr_mul(&DVector::from_column_slice(forces)).as_slice().to_vec());
        model.all_shapes_mut().for_each(|shapes| *shapes = shapes.combine(&shares));
        model
    }

    /// Whether there are load modes beside the natural ones.
    pub fn has_load_modes(&self) -> bool {
        self.modes.iter().any(|mode| mode.of_loads)
    }

    /// How many of the modes are natural ones.
    pub fn natural_modes(&self) -> usize {
        self.modes.iter().filter(|mode| !mode.of_loads).count()
    }

    /// Has the static loads act on other coordinates, as far as load modes of their families are among these.
    fn take_loads(&mut self, on_coordinates: impl Fn(&[f64]) -> Vec<f64>) {
        let ReducedModel { static_loads, modes, .. } = self;
        static_loads.retain(|load| modes.iter().any(|mode| mode.of_loads && mode.family == load.family));
        static_loads.iter_mut().for_each(|load| load.forces = on_coordinates(&load.forces));
    }

    fn all_shapes_mut(&mut self) -> impl Iterator<Item = &mut ModeShapes> {
        let engines = self.engines.iter_mut().map(|engine| &mut engine.shapes);
        let stations = self.stations.iter_mut().map(|station| &mut station.shapes);
        let sections = self.sections.iter_mut().map(|section| &mut section.steps);
        let cuts = self.cuts.iter_mut().map(|cut| &mut cut.steps);
        let strips = self.strips.iter_mut().map(|strip| &mut strip.shapes);
        strips.chain(engines).chain(stations).chain(sections).chain(cuts)
    }
}

fn reduced_strips(structure: &Structure, tree: &SectionTree, shapes: &DMatrix<f64>) -> Vec<ReducedStrip> {
    let reduce = |strip: &crate::aircraft::Strip| ReducedStrip {
        component: structure.aircraft.beams[strip.attachment.beam].component.clone(),
        position: structure.geometry[strip.attachment.beam].position(strip.attachment.fraction),
        section: tree.at(strip.attachment),
        forward: strip.forward,
        span: strip.span,
        semichord: strip.semichord,
        elastic_axis_aft_of_midchord: strip.elastic_axis_aft_of_midchord,
        width: strip.width,
        lift_slope: strip.lift_slope,
        zero_lift_offset: strip.zero_lift_offset,
        zero_lift_moment: strip.zero_lift_moment,
        moment_slope: strip.moment_slope,
        profile_drag: strip.profile_drag,
        leading_edge_suction: strip.leading_edge_suction,
        flap: strip.flap.clone(),
        shapes: structure.shapes_at(strip.attachment, shapes),
    };
    structure.aircraft.strips.iter().map(reduce).collect()
}

fn reduced_engines(structure: &Structure, tree: &SectionTree, shapes: &DMatrix<f64>) -> Vec<ReducedEngine> {
    let reduce = |engine: &crate::aircraft::Engine| {
        let beam = engine.attachment.beam;
        let geometry = &structure.geometry[beam];
        let (translation, rotation) = geometry.section(engine.attachment.fraction);
        let displacement = translation - engine.offset.cross_matrix() * rotation;
        ReducedEngine {
            name: engine.name.clone(),
            position: geometry.position(engine.attachment.fraction) + engine.offset,
            carrier: Carrier::own(tree.at(engine.attachment)),
            direction: engine.direction,
            torque: engine.torque,
            angular_momentum: engine.angular_momentum,
            trim_share: engine.trim_share,
            shapes: ModeShapes {
                translation: structure.apply_map(beam, &displacement, shapes),
                rotation: structure.apply_map(beam, &rotation, shapes),
            },
        }
    };
    structure.aircraft.engines.iter().map(reduce).collect()
}

fn reduced_stations(structure: &Structure, tree: &SectionTree, shapes: &DMatrix<f64>) -> Vec<ReducedStation> {
    let reduce = |station: &crate::aircraft::Station| ReducedStation {
        name: station.name.clone(),
        position: structure.geometry[station.attachment.beam].position(station.attachment.fraction),
        carrier: Carrier::own(tree.at(station.attachment)),
        twist_axis: station.twist_axis,
        shapes: structure.shapes_at(station.attachment, shapes),
    };
    structure.aircraft.stations.iter().map(reduce).collect()
}
