//! How strips move with the deformed aircraft and where their loads go [4.1; physics.md §4].
//!
//! Symbols: f, s, n the deformed triad, R = r + Ψᵘq, V the velocity relative to the air, m = n + α0 f, and
//! the rows G_w = nᵀ[1, −R×, Ψᵘ], G_Ω = sᵀ[0, 1, Ψᵠ] on ν = [v; ω; q̇]. Strips are computed four at a time;
//! the last group is filled up with strips of no size.
//!
//! **Caveat.** physics.md §4 turns the triad by the finite rotation exp((Ψᵠq)×) but lets it spin at Ψᵠq̇ in ẇ
//! and Ω̇, which is the true spin only for small rotations. The inflow is forced by that ẇ, so its states,
//! which count from the true w₃, take the difference (`unforced`) off again.

use nalgebra::Vector3;

use crate::aerodynamics::{FlapEffect, LocalFlow, PetersInflow, Section};
use crate::aircraft::ControlGains;
use crate::lanes::{LANES, LaneVector, Lanes};
use crate::structure::{ModeShapes, ReducedModel, ReducedStrip};

use super::controls::Controls;
use super::inertia::RigidMotion;
use super::layout::StateLayout;
use super::rotation::Rotation;
use super::strip_sums::{RowEntry, StripSums};

/// Four strips.
#[derive(Clone, Debug)]
struct Group {
    position: LaneVector,
    forward: LaneVector,
    span: LaneVector,
    width: Lanes,
    zero_lift_offset: Lanes,
    section: Section,
    /// Flap angle per elevator, aileron, ailerons together, rudder.
    gains: [Lanes; 4],
    /// Ψᵘ_x, Ψᵘ_y, Ψᵘ_z, Ψᵠ_x, Ψᵠ_y, Ψᵠ_z of each mode.
    shapes: Vec<[Lanes; 6]>,
}

/// All strips of an aircraft.
#[derive(Clone, Debug)]
pub struct Strips {
    /// Number of strips.
    count: usize,
    groups: Vec<Group>,
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

/// Four deformed sections in their flow.
struct MovingGroup {
    forward: LaneVector,
    span: LaneVector,
    normal: LaneVector,
    /// R.
    place: LaneVector,
    flow: LocalFlow,
    /// The part of dw₃/dt that does not force the inflow, m/s².
    unforced: Lanes,
}

impl Strips {
    /// The strips of a model.
    pub fn new(model: &ReducedModel) -> Self {
        let modes = model.modes.len();
        Strips {
            count: model.strips.len(),
            groups: model.strips.chunks(LANES).map(|strips| Group::new(strips, modes)).collect(),
        }
    }

    /// Number of strips.
    pub fn count(&self) -> usize {
        self.count
    }

    /// The largest displacement or rotation of any strip by a unit coordinate, m or rad.
    pub fn largest_shape(&self) -> f64 {
        let shapes = self.groups.iter().flat_map(|group| group.shapes.iter().flatten());
        shapes.flat_map(|lanes| lanes.to_array()).fold(0.0, |largest, shape| shape.abs().max(largest))
    }

    /// Number of groups of four strips.
    pub fn groups(&self) -> usize {
        self.groups.len()
    }

    /// Whether ẇ and the loads are linear in the same rows, so that apparent mass is symmetric.
    pub fn zero_lift_lines_are_chords(&self) -> bool {
        self.groups.iter().all(|group| group.zero_lift_offset.to_array() == [0.0; LANES])
    }

    /// Sums the loads and the rows of apparent mass of all strips, and writes the rates of the inflow states.
    pub fn sum_loads(
        &self,
        around: &Surroundings,
        layout: &StateLayout,
        state: &[f64],
        rates: &mut [f64],
        sums: &mut StripSums,
    ) {
        sums.clear();
        for (index, group) in self.groups.iter().enumerate() {
            let mut moving = group.deform(around);
            let flow = &mut moving.flow;
            if sums.reversed.is_none() {
                sums.reversed = group.reversed(flow).map(|lane| index * LANES + lane);
            }
            let place = layout.group_inflow(index);
            let states = place.read(state);
            let w3 = group.section.three_quarter_chord_upwash(flow.upwash, flow.pitch_rate);
            flow.induced = around.inflow.induced_velocity(&states, w3);
            let passing = flow.chordwise / group.section.semichord;
            around.inflow.rates(&states, w3, passing, moving.unforced, &mut place.write(rates));
            group.distribute(index, around, &moving, sums);
        }
    }

    /// Writes the inflow's linear part at a constant airspeed (m/s) into a vector of the state's layout, 1/s.
    pub fn inflow_linear_part(
        &self,
        inflow: &PetersInflow,
        airspeed: f64,
        layout: &StateLayout,
        linear: &mut [f64],
    ) {
        for (index, group) in self.groups.iter().enumerate() {
            let passing = Lanes::splat(airspeed) / group.section.semichord;
            inflow.linear_part(passing, &mut layout.group_inflow(index).write(linear));
        }
    }

    /// Sets the inflow states of every strip to a wake long at rest.
    pub fn settle_inflow(&self, around: &Surroundings, layout: &StateLayout, state: &mut [f64]) {
        for (index, group) in self.groups.iter().enumerate() {
            let flow = group.deform(around).flow;
            let w3 = group.section.three_quarter_chord_upwash(flow.upwash, flow.pitch_rate);
            around.inflow.settle(w3, &mut layout.group_inflow(index).write(state));
        }
    }
}

impl Group {
    /// Up to four strips of a model with `modes` modes.
    fn new(strips: &[ReducedStrip], modes: usize) -> Self {
        let lanes = |value: &dyn Fn(&ReducedStrip) -> f64, empty: f64| {
            Lanes::new(std::array::from_fn(|lane| strips.get(lane).map_or(empty, value)))
        };
        let vectors = |value: &dyn Fn(&ReducedStrip) -> Vector3<f64>| {
            LaneVector::new(std::array::from_fn(|lane| strips.get(lane).map_or(Vector3::zeros(), value)))
        };
        let flap = |value: &dyn Fn(&FlapEffect) -> f64| {
            lanes(&|strip| strip.flap.as_ref().map_or(0.0, |flap| value(&FlapEffect::new(flap))), 0.0)
        };
        let gain = |value: &dyn Fn(&ControlGains) -> f64| flap(&|effect| value(&effect.gains));
        let shape = |mode: usize, row: usize| {
            lanes(
                &|ReducedStrip { shapes: ModeShapes { translation, rotation }, .. }| {
                    (if row < 3 { translation } else { rotation })[row % 3 * modes + mode]
                },
                0.0,
            )
        };
        Group {
            position: vectors(&|strip| strip.position),
            forward: vectors(&|strip| strip.forward),
            span: vectors(&|strip| strip.span),
            width: lanes(&|strip| strip.width, 0.0),
            zero_lift_offset: lanes(&|strip| strip.zero_lift_offset, 0.0),
            section: Section {
                semichord: lanes(&|strip| strip.semichord, 1.0),
                elastic_axis_aft_of_midchord: lanes(&|strip| strip.elastic_axis_aft_of_midchord, 0.0),
                lift_slope: lanes(&|strip| strip.lift_slope, 0.0),
                profile_drag: lanes(&|strip| strip.profile_drag, 0.0),
                leading_edge_suction: lanes(&|strip| strip.leading_edge_suction, 0.0),
                flap_lift: flap(&|effect| effect.lift),
                flap_moment: flap(&|effect| effect.moment),
            },
            gains: [
                gain(&|g| g.elevator),
                gain(&|g| g.aileron),
                gain(&|g| g.aileron_symmetric),
                gain(&|g| g.rudder),
            ],
            shapes: (0..modes).map(|mode| std::array::from_fn(|row| shape(mode, row))).collect(),
        }
    }

    /// Deforms the sections and finds their flow; the induced velocity is left at zero.
    fn deform(&self, around: &Surroundings) -> MovingGroup {
        let velocity = LaneVector::splat(&around.motion.velocity);
        let rate = LaneVector::splat(&around.motion.rate);
        let wind = LaneVector::splat(&around.wind);
        let [displacement, rotation] = self.combine(around.q);
        let [elastic_velocity, elastic_rate] = self.combine(around.q_dot);

        let turn = Rotation::new(rotation);
        let (forward, span) = (turn.apply(&self.forward), turn.apply(&self.span));
        let normal = forward.cross(&span);
        let place = self.position + displacement;
        let air_velocity = velocity + rate.cross(&place) + elastic_velocity - wind;
        let spin = rate + elastic_rate;
        let zero_lift_normal = normal + forward * self.zero_lift_offset;

        let (chordwise, across) = (forward.dot(&air_velocity), normal.dot(&air_velocity));
        let transport = rate.cross(&(elastic_velocity + wind)) - LaneVector::splat(&around.wind_rate);
        let Controls { elevator, aileron, aileron_symmetric, rudder, .. } = *around.controls;
        let flow = LocalFlow {
            density: Lanes::splat(around.density),
            chordwise,
            normal: across,
            upwash: across + chordwise * self.zero_lift_offset,
            pitch_rate: span.dot(&spin),
            upwash_drift: zero_lift_normal.dot(&transport)
                + elastic_rate.cross(&zero_lift_normal).dot(&air_velocity),
            pitch_drift: elastic_rate.cross(&span).dot(&spin),
            induced: Lanes::splat(0.0),
            flap_angle: self.gains[0] * Lanes::splat(elevator)
                + self.gains[1] * Lanes::splat(aileron)
                + self.gains[2] * Lanes::splat(aileron_symmetric)
                + self.gains[3] * Lanes::splat(rudder),
        };
        let excess = turn.excess_spin(&elastic_rate);
        let unforced = self.section.three_quarter_chord_upwash(
            excess.cross(&zero_lift_normal).dot(&air_velocity),
            excess.cross(&span).dot(&spin),
        );
        MovingGroup { forward, span, normal, place, flow, unforced }
    }

    /// Ψᵘ and Ψᵠ times generalised coordinates or their rates.
    fn combine(&self, coordinates: &[f64]) -> [LaneVector; 2] {
        let mut sums = [Lanes::splat(0.0); 6];
        for (shape, &coordinate) in self.shapes.iter().zip(coordinates) {
            let coordinate = Lanes::splat(coordinate);
            for (sum, shape) in sums.iter_mut().zip(shape) {
                *sum += *shape * coordinate;
            }
        }
        let [ux, uy, uz, rx, ry, rz] = sums;
        [LaneVector { x: ux, y: uy, z: uz }, LaneVector { x: rx, y: ry, z: rz }]
    }

    /// The first lane whose lifting strip meets the air from behind.
    fn reversed(&self, flow: &LocalFlow) -> Option<usize> {
        let (chordwise, slope) = (flow.chordwise.to_array(), self.section.lift_slope.to_array());
        (0..LANES).find(|&lane| chordwise[lane] <= 0.0 && slope[lane] > 0.0)
    }

    /// Adds the generalised forces −G_wᵀL + G_ΩᵀM + G_fᵀF and writes the rows of apparent mass.
    fn distribute(&self, index: usize, around: &Surroundings, moving: &MovingGroup, sums: &mut StripSums) {
        let MovingGroup { forward, span, normal, place, flow, .. } = moving;
        let arm = if around.deformed_arms { place } else { &self.position };
        let loads = self.section.loads(flow);
        let (along, across) = (loads.forward * self.width, loads.down * self.width);
        let pitching = loads.pitching * self.width;

        let (b, d) = (self.section.semichord, self.section.elastic_axis_aft_of_midchord);
        let alpha0 = self.zero_lift_offset;
        let root_mass = b * (Lanes::splat(std::f64::consts::PI * around.density) * self.width).sqrt();
        let root_inertia = b * root_mass * Lanes::splat(0.5 * std::f64::consts::FRAC_1_SQRT_2);
        let mut write = |component: usize, work: &Work| {
            let Work { down, ahead, nose_up, moving_down } = *work;
            sums.force[component] += down * across + ahead * along + nose_up * pitching;
            let entry = RowEntry {
                heave: (down - nose_up * d) * root_mass,
                pitch: nose_up * root_inertia,
                acceleration: (moving_down - nose_up * d) * root_mass,
            };
            sums.write(index, component, &entry);
        };
        let axis = *normal + *forward * alpha0;
        let zero = LaneVector::splat(&Vector3::zeros());
        let translation = Work::on_axes(normal, forward, &zero, &axis);
        let rotation = Work::on_axes(&arm.cross(normal), &arm.cross(forward), span, &place.cross(&axis));
        for (component, work) in translation.iter().chain(&rotation).enumerate() {
            write(component, work);
        }
        for (mode, [ux, uy, uz, rx, ry, rz]) in self.shapes.iter().enumerate() {
            let down = *ux * normal.x + *uy * normal.y + *uz * normal.z;
            let ahead = *ux * forward.x + *uy * forward.y + *uz * forward.z;
            let nose_up = *rx * span.x + *ry * span.y + *rz * span.z;
            write(6 + mode, &Work { down, ahead, nose_up, moving_down: down + ahead * alpha0 });
        }
    }
}

/// Work of unit loads of a strip per unit of one component of ν.
struct Work {
    /// G_w: of a force along n.
    down: Lanes,
    /// G_f: of a force along f.
    ahead: Lanes,
    /// G_Ω: of a moment about s.
    nose_up: Lanes,
    /// G_m: velocity along m, where the strip is.
    moving_down: Lanes,
}

impl Work {
    /// On the three axes of v or of ω.
    fn on_axes(
        down: &LaneVector,
        ahead: &LaneVector,
        nose_up: &LaneVector,
        moving_down: &LaneVector,
    ) -> [Work; 3] {
        let axis = |pick: fn(&LaneVector) -> Lanes| Work {
            down: pick(down),
            ahead: pick(ahead),
            nose_up: pick(nose_up),
            moving_down: pick(moving_down),
        };
        [axis(|vector| vector.x), axis(|vector| vector.y), axis(|vector| vector.z)]
    }
}
