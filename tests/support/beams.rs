//! A uniform cantilever in any direction, as an [`Aircraft`] without air.

use flexible_aircraft::aircraft::{
    Aircraft, Attachment, Beam, Coupling, Fidelity, GivenReference, Limits, MassBay, ModeBasis, Support,
};
use nalgebra::{Matrix3, Vector3};

/// A uniform beam clamped at O.
#[derive(Clone, Debug)]
pub struct Cantilever {
    /// Unit vector along the beam, body axes.
    pub axis: Vector3<f64>,
    /// Unit vector of the section's local y, body axes.
    pub y_axis: Vector3<f64>,
    /// m.
    pub length: f64,
    /// EA, N.
    pub axial: f64,
    /// GJ, N·m².
    pub torsional: f64,
    /// EI_y, N·m²: resists w″.
    pub bending_y: f64,
    /// EI_z, N·m²: resists v″.
    pub bending_z: f64,
    /// kg/m.
    pub mass_per_length: f64,
    /// Radius of gyration about the axis, m; half of its square each about y and z.
    pub gyration: f64,
    /// Where each element's mass sits: fractions of its length and shares of its mass.
    pub lumps: &'static [(f64, f64)],
}

/// One lump at the middle of each element, as aircraft files make them.
pub const MIDDLE: &[(f64, f64)] = &[(0.5, 1.0)];

/// Half of each element's mass at either end.
pub const ENDS: &[(f64, f64)] = &[(0.0, 0.5), (1.0, 0.5)];

/// A cantilever askew in all axes, of 6 m.
pub fn askew() -> Cantilever {
    Cantilever {
        axis: Vector3::new(1.0, 2.0, -2.0) / 3.0,
        y_axis: Vector3::new(2.0, 1.0, 2.0) / 3.0,
        length: 6.0,
        axial: 1e6,
        torsional: 5e3,
        bending_y: 1e4,
        bending_z: 4e4,
        mass_per_length: 10.0,
        gyration: 0.2,
        lumps: MIDDLE,
    }
}

impl Cantilever {
    /// The beam in equal elements whose sections couple, with axial modes in its basis.
    pub fn coupled(&self, elements: usize, coupling: Coupling) -> Aircraft {
        let mut aircraft = self.aircraft(elements);
        aircraft.beams.iter_mut().for_each(|beam| beam.coupling = coupling);
        aircraft
    }

    /// The columns are the local x, y, z axes in body axes.
    pub fn axes(&self) -> Matrix3<f64> {
        Matrix3::from_columns(&[self.axis, self.y_axis, self.axis.cross(&self.y_axis)])
    }

    /// The beam in equal elements, with axial modes in its basis.
    pub fn aircraft(&self, elements: usize) -> Aircraft {
        let step = self.length / elements as f64;
        let beam = |index: usize| Beam {
            component: "beam".to_owned(),
            nodes: [index, index + 1],
            y_axis: self.y_axis,
            axial_stiffness: self.axial,
            torsional_stiffness: self.torsional,
            bending_stiffness_y: self.bending_y,
            bending_stiffness_z: self.bending_z,
            coupling: Coupling::NONE,
            hinge: None,
        };
        let bay = |(beam, &(fraction, share)): (usize, &(f64, f64))| {
            let mass = share * step * self.mass_per_length;
            let polar = mass * self.gyration * self.gyration;
            let local = Matrix3::from_diagonal(&Vector3::new(polar, 0.5 * polar, 0.5 * polar));
            MassBay {
                attachment: Attachment { beam, fraction },
                mass,
                offset: Vector3::zeros(),
                inertia: self.axes() * local * self.axes().transpose(),
            }
        };
        Aircraft {
            name: "Cantilever".to_owned(),
            gravity: 0.0,
            support: Support::Clamped,
            mode_basis: ModeBasis::Full,
            load_modes: false,
            fidelity: Fidelity::Exact,
            inflow_states: 0,
            airspeed: 127.0,
            altitude: 7620.0,
            temperature_offset: 0.0,
            reference: GivenReference::default(),
            limits: Limits::default(),
            controls: Vec::new(),
            tunnel_air: None,
            mount: Vector3::zeros(),
            nodes: (0..=elements).map(|i| self.axis * (i as f64 * step)).collect(),
            beams: (0..elements).map(beam).collect(),
            bays: (0..elements).flat_map(|i| self.lumps.iter().map(move |lump| (i, lump))).map(bay).collect(),
            strips: Vec::new(),
            engines: Vec::new(),
            stations: Vec::new(),
            components: Vec::new(),
            written: Vec::new(),
            cuts: Vec::new(),
            joints: Vec::new(),
        }
    }
}
