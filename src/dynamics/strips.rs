//! How strips move with the deformed aircraft and where their loads go [4.1; physics.md §4].
//!
//! Symbols: f, s, n the deformed triad, R = r + Ψᵘq, V the velocity relative to the air, m = n + α0 f, and
//! the rows G_w = nᵀ[1, −R×, Ψᵘ], G_Ω = sᵀ[0, 1, Ψᵠ] on ν = [v; ω; q̇].

use nalgebra::Vector3;

use crate::aerodynamics::{FlapEffect, LocalFlow, PetersInflow, Section};
use crate::structure::{ModeShapes, ReducedModel, ReducedStrip};

use super::apparent_mass::{ApparentMass, LANES, Lanes, padded};
use super::controls::Controls;
use super::inertia::{RigidMotion, add};
use super::layout::StateLayout;
use super::rotation::exponential;

/// A strip as the equations of motion see it.
#[derive(Clone, Debug)]
struct PlacedSection {
    position: Vector3<f64>,
    forward: Vector3<f64>,
    span: Vector3<f64>,
    width: f64,
    section: Section,
}

/// All strips of an aircraft, with their mode shapes laid out for the two ways in which they are read.
#[derive(Clone, Debug)]
pub struct Strips {
    placed: Vec<PlacedSection>,
    modes: usize,
    /// Per strip: the rows Ψᵘ_x, Ψᵘ_y, Ψᵘ_z, Ψᵠ_x, Ψᵠ_y, Ψᵠ_z, each padded with zeros to whole lanes.
    by_axis: Vec<Lanes>,
    /// Per strip and mode: the same six numbers.
    by_mode: Vec<[f64; 6]>,
}

/// The state of the aircraft and of the air that all strips share.
pub struct Surroundings<'a> {
    /// v and ω.
    pub motion: RigidMotion,
    /// q.
    pub q: &'a [f64],
    /// q̇.
    pub q_dot: &'a [f64],
    /// Velocity of the air, body axes, m/s.
    pub wind: Vector3<f64>,
    /// C_bI Ẇ, m/s².
    pub wind_rate: Vector3<f64>,
    /// ρ, kg/m³.
    pub density: f64,
    /// Surface positions.
    pub controls: &'a Controls,
    /// The inflow model of every strip.
    pub inflow: &'a PetersInflow,
    /// Whether forces act at the deformed place (all models but RL).
    pub deformed_arms: bool,
}

/// Where the loads of the strips are summed.
pub struct StripSums<'a> {
    /// Generalised forces on ν.
    pub force: &'a mut [f64],
    /// Apparent mass, as the rows that make it up.
    pub apparent: &'a mut ApparentMass,
    /// The first lifting strip in reverse flow, if any.
    pub reversed: &'a mut Option<usize>,
}

/// A deformed section in its flow.
struct MovingSection {
    forward: Vector3<f64>,
    span: Vector3<f64>,
    normal: Vector3<f64>,
    /// R.
    place: Vector3<f64>,
    flow: LocalFlow,
}

impl Strips {
    /// The strips of a model.
    pub fn new(model: &ReducedModel) -> Self {
        let modes = model.modes.len();
        let mut by_axis = Vec::new();
        let mut by_mode = Vec::new();
        for ModeShapes { translation, rotation } in model.strips.iter().map(|strip| &strip.shapes) {
            let rows: [&[f64]; 6] = std::array::from_fn(|i| {
                &(if i < 3 { translation } else { rotation })[i % 3 * modes..][..modes]
            });
            by_axis.extend(rows.iter().flat_map(|row| padded(row)));
            by_mode.extend((0..modes).map(|mode| rows.map(|row| row[mode])));
        }
        Strips { placed: model.strips.iter().map(PlacedSection::new).collect(), modes, by_axis, by_mode }
    }

    /// Number of strips.
    pub fn len(&self) -> usize {
        self.placed.len()
    }

    /// Whether ẇ and the loads are linear in the same rows, so that apparent mass is symmetric.
    pub fn zero_lift_lines_are_chords(&self) -> bool {
        self.placed.iter().all(|strip| strip.section.zero_lift_offset == 0.0)
    }

    /// Adds the loads and the apparent mass of all strips, and writes the rates of the inflow states.
    pub fn add_loads(
        &self,
        around: &Surroundings,
        layout: &StateLayout,
        state: &[f64],
        rates: &mut [f64],
        sums: &mut StripSums,
    ) {
        for (index, strip) in self.placed.iter().enumerate() {
            let mut moving = self.moving_section(index, around);
            let states = &state[layout.strip_inflow(index)];
            let flow = &mut moving.flow;
            if flow.chordwise <= 0.0 && strip.section.lift_slope > 0.0 && sums.reversed.is_none() {
                *sums.reversed = Some(index);
            }
            let w3 = strip.section.three_quarter_chord_upwash(flow.upwash, flow.pitch_rate);
            flow.induced = around.inflow.induced_velocity(states, w3);
            let passing = flow.chordwise / strip.section.semichord;
            around.inflow.rates(states, w3, passing, &mut rates[layout.strip_inflow(index)]);
            self.distribute(index, around, &moving, sums);
        }
    }

    /// Sets the inflow states of every strip to a wake long at rest.
    pub fn settle_inflow(&self, around: &Surroundings, layout: &StateLayout, state: &mut [f64]) {
        for (index, strip) in self.placed.iter().enumerate() {
            let flow = self.moving_section(index, around).flow;
            let w3 = strip.section.three_quarter_chord_upwash(flow.upwash, flow.pitch_rate);
            around.inflow.settle(w3, &mut state[layout.strip_inflow(index)]);
        }
    }

    /// Deforms a section and finds its flow; the induced velocity is left at zero.
    fn moving_section(&self, index: usize, around: &Surroundings) -> MovingSection {
        let strip = &self.placed[index];
        let RigidMotion { velocity, rate } = &around.motion;
        let [displacement, rotation, elastic_velocity, elastic_rate] =
            self.elastic_motion(index, around.q, around.q_dot);

        let turn = exponential(&rotation);
        let (forward, span) = (turn * strip.forward, turn * strip.span);
        let normal = forward.cross(&span);
        let place = strip.position + displacement;
        let air_velocity = velocity + rate.cross(&place) + elastic_velocity - around.wind;
        let spin = rate + elastic_rate;
        let zero_lift = strip.section.zero_lift_offset;
        let zero_lift_normal = normal + forward * zero_lift;

        let (chordwise, across) = (forward.dot(&air_velocity), normal.dot(&air_velocity));
        let transport = rate.cross(&(elastic_velocity + around.wind)) - around.wind_rate;
        let flow = LocalFlow {
            density: around.density,
            chordwise,
            normal: across,
            upwash: across + chordwise * zero_lift,
            pitch_rate: span.dot(&spin),
            upwash_drift: zero_lift_normal.dot(&transport)
                + elastic_rate.cross(&zero_lift_normal).dot(&air_velocity),
            pitch_drift: elastic_rate.cross(&span).dot(&spin),
            induced: 0.0,
            flap_angle: strip.section.flap.map_or(0.0, |flap| around.controls.flap_angle(&flap.gains)),
        };
        MovingSection { forward, span, normal, place, flow }
    }

    /// Ψᵘq, Ψᵠq, Ψᵘq̇, Ψᵠq̇.
    fn elastic_motion(&self, index: usize, q: &[f64], q_dot: &[f64]) -> [Vector3<f64>; 4] {
        let shapes = &self.by_mode[self.modes * index..self.modes * (index + 1)];
        let (mut place, mut motion) = ([0.0; 6], [0.0; 6]);
        for ((shape, q), q_dot) in shapes.iter().zip(q).zip(q_dot) {
            for axis in 0..6 {
                place[axis] += shape[axis] * q;
                motion[axis] += shape[axis] * q_dot;
            }
        }
        let vector = |values: &[f64]| Vector3::new(values[0], values[1], values[2]);
        [vector(&place[..3]), vector(&place[3..]), vector(&motion[..3]), vector(&motion[3..])]
    }

    /// Adds the generalised forces −G_wᵀL + G_ΩᵀM + G_fᵀF and the apparent mass of one strip.
    fn distribute(&self, index: usize, around: &Surroundings, moving: &MovingSection, sums: &mut StripSums) {
        let strip = &self.placed[index];
        let arm = if around.deformed_arms { moving.place } else { strip.position };
        let loads = strip.section.loads(&moving.flow);
        let force = (moving.forward * loads.forward + moving.normal * loads.down) * strip.width;
        let moment = moving.span * (loads.pitching * strip.width);
        add(&mut sums.force[0..3], &force);
        add(&mut sums.force[3..6], &(arm.cross(&force) + moment));
        let elastic = sums.force[6..].chunks_mut(LANES);
        for (sums, work) in elastic.zip(self.work(index, &force, &moment)) {
            for (sum, work) in sums.iter_mut().zip(work) {
                *sum += work;
            }
        }

        let d = strip.section.elastic_axis_aft_of_midchord;
        let torque = moving.span * -d;
        let row = |row: &mut [Lanes], axis: &Vector3<f64>, place: &Vector3<f64>, torque: &Vector3<f64>| {
            ApparentMass::write_row(row, axis, &(place.cross(axis) + torque), self.work(index, axis, torque));
        };
        let mass = strip.section.apparent_mass(around.density) * strip.width;
        let inertia = 0.125 * strip.section.semichord * strip.section.semichord * mass;
        sums.apparent.add(index, mass, inertia, |heave, pitch, acceleration| {
            row(heave, &moving.normal, &arm, &torque);
            row(pitch, &Vector3::zeros(), &arm, &moving.span);
            if let Some(acceleration) = acceleration {
                let axis = moving.normal + moving.forward * strip.section.zero_lift_offset;
                row(acceleration, &axis, &moving.place, &torque);
            }
        });
    }

    /// Work per unit of each generalised coordinate of a force and a moment at the strip.
    fn work(&self, index: usize, force: &Vector3<f64>, moment: &Vector3<f64>) -> impl Iterator<Item = Lanes> {
        let lanes = self.modes.div_ceil(LANES);
        let rows = &self.by_axis[6 * lanes * index..6 * lanes * (index + 1)];
        let (ux, rest) = rows.split_at(lanes);
        let (uy, rest) = rest.split_at(lanes);
        let (uz, rest) = rest.split_at(lanes);
        let (rx, rest) = rest.split_at(lanes);
        let (ry, rz) = rest.split_at(lanes);
        let (force, moment) = (*force, *moment);
        let translations = ux.iter().zip(uy).zip(uz);
        let rotations = rx.iter().zip(ry).zip(rz);
        translations.zip(rotations).map(move |(((ux, uy), uz), ((rx, ry), rz))| {
            std::array::from_fn(|i| {
                (ux[i] * force.x + uy[i] * force.y + uz[i] * force.z)
                    + (rx[i] * moment.x + ry[i] * moment.y + rz[i] * moment.z)
            })
        })
    }
}

impl PlacedSection {
    fn new(strip: &ReducedStrip) -> Self {
        PlacedSection {
            position: strip.position,
            forward: strip.forward,
            span: strip.span,
            width: strip.width,
            section: Section {
                semichord: strip.semichord,
                elastic_axis_aft_of_midchord: strip.elastic_axis_aft_of_midchord,
                lift_slope: strip.lift_slope,
                zero_lift_offset: strip.zero_lift_offset,
                profile_drag: strip.profile_drag,
                leading_edge_suction: strip.leading_edge_suction,
                flap: strip.flap.as_ref().map(FlapEffect::new),
            },
        }
    }
}
