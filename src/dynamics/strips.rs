//! How strips move with the deformed aircraft and where their loads go [4.1; physics.md §4].
//!
//! Symbols: f, s, n the deformed triad, R = r + Ψᵘq, V the velocity relative to the air, m = n + α0 f, and
//! the rows G_w = nᵀ[1, −R×, Ψᵘ], G_Ω = sᵀ[0, 1, Ψᵠ] on ν = [v; ω; q̇]. Strips are computed in groups of
//! eight; the last group is filled up with strips of no size.
//!
//! **Caveat.** physics.md §4 turns the triad by the finite rotation exp((Ψᵠq)×) but lets it spin at Ψᵠq̇ in ẇ
//! and Ω̇, which is the true spin only for small rotations. The inflow is forced by that ẇ, so its states,
//! which count from the true w₃, take the difference (`unforced`) off again.

use std::f64::consts::PI;

use nalgebra::Vector3;
use pulp::{Arch, Scalar, Simd};

use crate::aerodynamics::{FlapEffect, LocalFlow, PetersInflow, Section};
use crate::aircraft::Flap;
use crate::lanes::{Eight, EightVectors, LANES, LaneVector, Lanes, Place};
use crate::structure::{ModeShapes, ReducedModel, ReducedStrip};

use super::controls::{SURFACES, gains_of_kinds};
use super::edge_on::EdgeOnStrips;
use super::freedom::RigidFreedom;
use super::layout::StateLayout;
use super::rotation::Rotation;
use super::strip_loads::{Displacement, FlapResultants, StripLoads, StripSizes};
use super::strip_sums::{Row, StripSums};

/// Eight strips.
#[derive(Clone, Debug)]
pub(super) struct Group {
    position: EightVectors,
    forward: EightVectors,
    span: EightVectors,
    width: Eight,
    /// √(πb²Δy) and √(πb⁴Δy/8): roots of apparent mass and inertia in air of unit density.
    root_mass: Eight,
    root_inertia: Eight,
    /// 1/√(πb²Δy).
    per_root_mass: Eight,
    /// 1/b.
    pub(super) per_semichord: Eight,
    zero_lift_offset: Eight,
    pub(super) section: Section,
    /// Flap angle per angle of a kind of surfaces, for those kinds that move any flap here.
    gains: Vec<(usize, Eight)>,
    /// Ψᵘ_x, Ψᵘ_y, Ψᵘ_z, Ψᵠ_x, Ψᵠ_y, Ψᵠ_z of each mode.
    shapes: Vec<[Eight; 6]>,
}

/// All strips of an aircraft.
#[derive(Clone, Debug)]
pub struct Strips {
    /// Number of strips.
    pub(super) count: usize,
    pub(super) groups: Vec<Group>,
    /// Kinds of surfaces that move any flap.
    pub(super) surfaces: Vec<usize>,
    /// Those that only drag.
    pub(super) edge_on: EdgeOnStrips,
    /// How wide this machine's vectors are.
    pub(super) arch: Arch,
}

/// The state of the aircraft and of the air that all strips share.
pub struct Surroundings<'a> {
    /// Velocity of O relative to the air, body axes, m/s.
    pub airspeed: Vector3<f64>,
    /// ω, body axes, rad/s.
    pub rate: Vector3<f64>,
    /// ω × W − C_bI Ẇ of the velocity W of the air, m/s².
    pub air_transport: Vector3<f64>,
    /// q.
    pub q: &'a [f64],
    /// q̇.
    pub q_dot: &'a [f64],
    /// ρ, kg/m³.
    pub density: f64,
    /// The inflow model of every strip.
    pub inflow: &'a PetersInflow,
    /// Whether forces act at the deformed place (all models but RL).
    pub deformed_arms: bool,
    /// Which components of v and ω move.
    pub freedom: RigidFreedom,
}

/// Deformed sections in their flow.
pub(super) struct MovingSections<S: Simd> {
    forward: LaneVector<S>,
    span: LaneVector<S>,
    normal: LaneVector<S>,
    /// m.
    zero_lift_normal: LaneVector<S>,
    /// R.
    position: LaneVector<S>,
    pub(super) flow: LocalFlow<S>,
    /// The part of dw₃/dt that does not force the inflow, m/s².
    pub(super) unforced: Lanes<S>,
}

impl Strips {
    /// The strips of a model, and others with the same modes that flow in the mirror plane meets edge-on.
    pub fn new(model: &ReducedModel, edge_on: &[ReducedStrip]) -> Self {
        let modes = model.modes.len();
        let moves = |surface: usize| {
            let mut flaps = model.strips.iter().filter_map(|strip| strip.flap.as_ref());
            flaps.any(|flap| gains_of_kinds(&flap.gains)[surface] != 0.0)
        };
        let surfaces: Vec<usize> = (0..SURFACES).filter(|&surface| moves(surface)).collect();
        let groups = model.strips.chunks(LANES).map(|strips| Group::new(strips, &surfaces, modes));
        Strips {
            count: model.strips.len(),
            groups: groups.collect(),
            surfaces,
            edge_on: EdgeOnStrips::new(edge_on, modes),
            arch: Arch::new(),
        }
    }

    /// Number of strips, without those edge-on.
    pub fn count(&self) -> usize {
        self.count
    }

    /// The largest displacement or rotation of any strip by a unit coordinate, m or rad.
    pub fn largest_shape(&self) -> f64 {
        let shapes = self.groups.iter().flat_map(|group| group.shapes.iter().flatten());
        shapes.flat_map(|lanes| lanes.0).fold(0.0, |largest, shape| shape.abs().max(largest))
    }

    /// Number of groups of strips.
    pub fn groups(&self) -> usize {
        self.groups.len()
    }

    /// Whether ẇ and the loads are linear in the same rows, so that apparent mass is symmetric.
    pub fn zero_lift_lines_are_chords(&self) -> bool {
        self.groups.iter().all(|group| group.zero_lift_offset == Eight::ZERO)
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
            let passing = Eight(group.section.semichord.0.map(|semichord| airspeed / semichord));
            inflow.linear_part(&passing, &mut layout.group_inflow(index).write(linear));
        }
    }

    /// Sets the inflow states of every strip to a wake long at rest.
    pub fn settle_inflow(&self, around: &Surroundings, layout: &StateLayout, state: &mut [f64]) {
        for (index, group) in self.groups.iter().enumerate() {
            for place in Place::all(Scalar::new()) {
                let w3 = group.deform::<Scalar, false>(place, around).flow.w3;
                around.inflow.settle(place, w3, &mut layout.group_inflow(index).write(state));
            }
        }
    }
}

impl Group {
    /// Up to eight strips of a model with `modes` modes.
    fn new(strips: &[ReducedStrip], surfaces: &[usize], modes: usize) -> Self {
        let lanes = |value: &dyn Fn(&ReducedStrip) -> f64, empty: f64| {
            Eight(std::array::from_fn(|lane| strips.get(lane).map_or(empty, value)))
        };
        let vectors = |value: &dyn Fn(&ReducedStrip) -> Vector3<f64>, empty: Vector3<f64>| {
            EightVectors::new(std::array::from_fn(|lane| strips.get(lane).map_or(empty, value)))
        };
        let flap = |value: &dyn Fn(&FlapEffect) -> f64| {
            lanes(&|strip| strip.flap.as_ref().map_or(0.0, |flap| value(&FlapEffect::new(flap))), 0.0)
        };
        let gain = |surface: usize| {
            let gain = |flap: &Flap| gains_of_kinds(&flap.gains)[surface];
            lanes(&|strip| strip.flap.as_ref().map_or(0.0, gain), 0.0)
        };
        let gains = surfaces.iter().map(|&surface| (surface, gain(surface)));
        let shape = |mode: usize, row: usize| {
            lanes(
                &|ReducedStrip { shapes: ModeShapes { translation, rotation }, .. }| {
                    (if row < 3 { translation } else { rotation })[row % 3 * modes + mode]
                },
                0.0,
            )
        };
        let root_mass = |strip: &ReducedStrip| strip.semichord * libm::sqrt(PI * strip.width);
        Group {
            position: vectors(&|strip| strip.position, Vector3::zeros()),
            // Forward, so that strips of no size do not meet the air from behind.
            forward: vectors(&|strip| strip.forward, Vector3::x()),
            span: vectors(&|strip| strip.span, Vector3::zeros()),
            width: lanes(&|strip| strip.width, 0.0),
            root_mass: lanes(&root_mass, 0.0),
            root_inertia: lanes(&|strip| strip.semichord * root_mass(strip) / libm::sqrt(8.0), 0.0),
            per_root_mass: lanes(&|strip| 1.0 / root_mass(strip), 0.0),
            per_semichord: lanes(&|strip| 1.0 / strip.semichord, 1.0),
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
            gains: gains.filter(|(_, gain)| *gain != Eight::ZERO).collect(),
            shapes: (0..modes).map(|mode| std::array::from_fn(|row| shape(mode, row))).collect(),
        }
    }

    /// Deforms the sections and finds their flow; the induced velocity is left at zero.
    #[inline(always)]
    pub(super) fn deform<S: Simd, const SYMMETRIC: bool>(
        &self,
        place: Place<S>,
        around: &Surroundings,
    ) -> MovingSections<S> {
        let [displacement, rotation, elastic_velocity, elastic_rate] =
            self.combine(place, around.q, around.q_dot);

        let turn = Rotation::new(rotation);
        let forward = turn.apply(&place.load_vector(&self.forward));
        let span = turn.apply(&place.load_vector(&self.span));
        let normal = forward.cross(&span);
        let position = place.load_vector(&self.position) + displacement;
        let rate = place.splat_vector(&around.rate);
        let air_velocity = place.splat_vector(&around.airspeed) + rate.cross(&position) + elastic_velocity;
        let transport = place.splat_vector(&around.air_transport) + rate.cross(&elastic_velocity);
        let spin = rate + elastic_rate;
        let zero_lift_offset = place.load(&self.zero_lift_offset);
        let zero_lift_normal = if SYMMETRIC { normal } else { normal + forward * zero_lift_offset };

        let (chordwise, across) = (forward.dot(&air_velocity), normal.dot(&air_velocity));
        // (ω × m)·V = ω·(m × V): how w and Ω change with the spin of the triad.
        let (by_spin, pitch_by_spin) = (zero_lift_normal.cross(&air_velocity), span.cross(&spin));
        let upwash = if SYMMETRIC { across } else { across + chordwise * zero_lift_offset };
        let pitch_rate = span.dot(&spin);
        let flow = LocalFlow {
            density: place.splat(around.density),
            chordwise,
            normal: across,
            upwash,
            pitch_rate,
            w3: self.section.three_quarter_chord_upwash(place, upwash, pitch_rate),
            upwash_drift: zero_lift_normal.dot(&transport) + elastic_rate.dot(&by_spin),
            pitch_drift: elastic_rate.dot(&pitch_by_spin),
            induced: place.splat(0.0),
        };
        let excess = turn.excess_spin(&elastic_rate);
        let unforced =
            self.section.three_quarter_chord_upwash(place, excess.dot(&by_spin), excess.dot(&pitch_by_spin));
        MovingSections { forward, span, normal, zero_lift_normal, position, flow, unforced }
    }

    /// Ψᵘq, Ψᵠq, Ψᵘq̇ and Ψᵠq̇.
    #[inline(always)]
    fn combine<S: Simd>(&self, place: Place<S>, q: &[f64], q_dot: &[f64]) -> [LaneVector<S>; 4] {
        let (mut sums, mut rates) = ([place.splat(0.0); 6], [place.splat(0.0); 6]);
        for (shape, (&q, &q_dot)) in self.shapes.iter().zip(q.iter().zip(q_dot)) {
            for row in 0..6 {
                let shape = place.load(&shape[row]);
                sums[row] += shape * q;
                rates[row] += shape * q_dot;
            }
        }
        let [ux, uy, uz, rx, ry, rz] = sums;
        let [vx, vy, vz, wx, wy, wz] = rates;
        [
            LaneVector { x: ux, y: uy, z: uz },
            LaneVector { x: rx, y: ry, z: rz },
            LaneVector { x: vx, y: vy, z: vz },
            LaneVector { x: wx, y: wy, z: wz },
        ]
    }

    /// Adds the generalised forces −G_wᵀL + G_ΩᵀM + G_fᵀF and writes the rows of apparent mass.
    #[inline(always)]
    pub(super) fn distribute<S: Simd, const SYMMETRIC: bool>(
        &self,
        place: Place<S>,
        index: usize,
        around: &Surroundings,
        moving: &MovingSections<S>,
        sums: &mut StripSums,
    ) {
        let MovingSections { forward, span, normal, zero_lift_normal, position, flow, .. } = moving;
        let section = self.section.at(place);
        let sizes = StripSizes {
            width: place.load(&self.width),
            elastic_axis_aft_of_midchord: section.elastic_axis_aft_of_midchord,
            root_mass: place.load(&self.root_mass),
            root_inertia: place.load(&self.root_inertia),
        };
        let loads: StripLoads<S, SYMMETRIC> =
            StripLoads::new(&section.loads(flow), &sizes, normal, forward, zero_lift_normal);
        let flaps = if self.gains.is_empty() {
            None
        } else {
            Some(FlapResultants::new(&section.flap_loads(flow), &sizes, place.load(&self.per_root_mass)))
        };
        let loads = (&loads, &flaps);
        let arm = if around.deformed_arms { *position } else { place.load_vector(&self.position) };
        let rigid = RigidRows { index, arms: [&arm, position], span };
        let mut rows = sums.rows();
        // Axes written out, so that nothing is computed about or along others.
        match around.freedom {
            RigidFreedom::All => self.add_rigid_rows(place, &rigid, [&[0, 1, 2]; 2], loads, &mut rows),
            RigidFreedom::InPlane => self.add_rigid_rows(place, &rigid, [&[0, 2], &[1]], loads, &mut rows),
            RigidFreedom::Held => {}
        }
        for (shape, row) in self.shapes.iter().zip(rows) {
            let [ux, uy, uz, rx, ry, rz] = [0, 1, 2, 3, 4, 5].map(|row| place.load(&shape[row]));
            let turn = LaneVector { x: rx, y: ry, z: rz }.dot(span);
            let displacement = loads.0.resultants.displaced(&LaneVector { x: ux, y: uy, z: uz }, turn);
            self.add_row(place, index, &displacement, loads, row);
        }
    }

    /// Adds the rows of translations along axes and of rotations about axes.
    #[inline(always)]
    fn add_rigid_rows<'a, S: Simd, const SYMMETRIC: bool>(
        &self,
        place: Place<S>,
        RigidRows { index, arms: [arm, position], span }: &RigidRows<S>,
        [along, about]: [&[usize]; 2],
        loads: (&StripLoads<S, SYMMETRIC>, &Option<FlapResultants<S>>),
        rows: &mut impl Iterator<Item = &'a mut Row>,
    ) {
        let resultants = &loads.0.resultants;
        for (&axis, row) in along.iter().zip(&mut *rows) {
            let displacement = resultants.component(axis, place.splat(0.0));
            self.add_row(place, *index, &displacement, loads, row);
        }
        let moments = resultants.about(arm, position);
        for (&axis, row) in about.iter().zip(rows) {
            let displacement = moments.component(axis, span.component(axis));
            self.add_row(place, *index, &displacement, loads, row);
        }
    }

    /// Adds what the loads and the flaps contribute to one component of ν.
    #[inline(always)]
    fn add_row<S: Simd, const SYMMETRIC: bool>(
        &self,
        place: Place<S>,
        index: usize,
        displacement: &Displacement<S>,
        (loads, flaps): (&StripLoads<S, SYMMETRIC>, &Option<FlapResultants<S>>),
        row: &mut Row,
    ) {
        row.add::<S, SYMMETRIC>(place, index, &loads.on(displacement));
        if let Some(flaps) = flaps {
            let effect = flaps.on(displacement);
            for (surface, gain) in &self.gains {
                row.add_effect(place, *surface, effect * place.load(gain));
            }
        }
    }
}

/// What the rows of the rigid motion of a group of strips need.
struct RigidRows<'a, S: Simd> {
    /// The group.
    index: usize,
    /// At which loads act, and at which accelerations.
    arms: [&'a LaneVector<S>; 2],
    /// s.
    span: &'a LaneVector<S>,
}
