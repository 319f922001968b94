//! Eight strips side by side [theory: air-loads.strip; thesis §4.1].
//!
//! A strip is an aerofoil (`aerofoil`: what its chord, camber and flap make of a flow) of some width, with axes that are fixed
//! to a section of the structure (`kinematics`: where it is, how it moves). A group has aerofoils, widths and axes; its sections
//! are those of the same number at an instant. The last group is filled up with strips of no size.

use std::f64::consts::PI;

use nalgebra::Vector3;

use crate::aircraft::FlapEffect;
use crate::kinematics::RigidFreedom;
use crate::math::{Arithmetic, Arrow, Eight, EightVectors, Lanes, Window};
use crate::structure::ReducedStrip;

use super::aerofoil::{Aerofoil, LocalFlow, SectionFlapLoads, SectionLoads};
use super::flap_factor::FlapFactor;
use super::strip_loads::{Displacement, StripFlapLoads, StripLoads, StripSizes};
use super::sums::{Row, add_to};

/// Eight strips.
#[derive(Clone, Debug)]
pub(crate) struct Group {
    pub(crate) forward: EightVectors,
    pub(crate) span: EightVectors,
    pub(super) width: Eight,
    /// √(πb²Δy) and √(πb⁴Δy/8): roots of apparent mass and inertia in air of unit density.
    root_mass: Eight,
    root_inertia: Eight,
    /// 1/√(πb²Δy).
    per_root_mass: Eight,
    /// 1/b.
    pub(crate) per_semichord: Eight,
    pub(crate) zero_lift_offset: Eight,
    pub(crate) aerofoil: Aerofoil,
    /// 2 c_mα, 1/rad, where any of them has one.
    moment_slope: Option<Eight>,
    /// k, 1/rad², where a flap of any has one.
    flap_profile_drag: Option<Eight>,
    /// Coefficients of δ by the factors, by their places, that move any flap here.
    pub(super) gains: Vec<(usize, Eight)>,
    /// Coefficients of δ², where it drags.
    pub(super) squared_gains: Vec<(usize, Eight)>,
    /// Whether motion and all strips stay in the mirror plane.
    pub(crate) in_plane: bool,
}

/// Sections in their flow, with what is known of their motion.
pub(crate) struct MovingSections<S: Arithmetic, Motion> {
    pub(crate) motion: Motion,
    pub(crate) flow: LocalFlow<S>,
}

/// Loads on strips, vectors of kind `V`: those with the flaps neutral, and those of the flaps if there are any.
pub(crate) type StripLoadsWithFlaps<S, V, const EQUAL_ROWS: bool> =
    (StripLoads<S, V, EQUAL_ROWS>, Option<StripFlapLoads<S>>);

impl Group {
    /// Up to eight strips of a model in the freedom that its motion has.
    pub(crate) fn new(strips: &[ReducedStrip], factors: &[FlapFactor], free: RigidFreedom) -> Self {
        let lanes = |value: &dyn Fn(&ReducedStrip) -> f64, empty: f64| Eight::of(strips, value, empty);
        let flap = |value: &dyn Fn(&FlapEffect) -> f64| {
            lanes(&|strip| strip.flap.as_ref().map_or(0.0, |flap| value(&FlapEffect::new(flap))), 0.0)
        };
        let coefficients = |places: &dyn Fn(&FlapFactor) -> bool| {
            let factors = factors.iter().enumerate().filter(|(_, factor)| places(factor));
            let coefficients = factors.map(|(place, &factor)| {
                let coefficients = lanes(&|strip| coefficient(strip, factor), 0.0);
                (place, coefficients)
            });
            coefficients.filter(|(_, coefficients)| *coefficients != Eight::ZERO).collect()
        };
        let root_mass = |strip: &ReducedStrip| strip.semichord * libm::sqrt(PI * strip.width);
        Group {
            // Forward, so that strips of no size do not meet the air from behind.
            forward: EightVectors::of(strips, |strip| strip.forward, Vector3::x()),
            span: EightVectors::of(strips, |strip| strip.span, Vector3::zeros()),
            width: lanes(&|strip| strip.width, 0.0),
            root_mass: lanes(&root_mass, 0.0),
            root_inertia: lanes(&|strip| strip.semichord * root_mass(strip) / libm::sqrt(8.0), 0.0),
            per_root_mass: lanes(&|strip| 1.0 / root_mass(strip), 0.0),
            per_semichord: lanes(&|strip| 1.0 / strip.semichord, 1.0),
            zero_lift_offset: lanes(&|strip| strip.zero_lift_offset, 0.0),
            aerofoil: Aerofoil {
                semichord: lanes(&|strip| strip.semichord, 1.0),
                elastic_axis_aft_of_midchord: lanes(&|strip| strip.elastic_axis_aft_of_midchord, 0.0),
                lift_slope: lanes(&|strip| strip.lift_slope, 0.0),
                profile_drag: lanes(&|strip| strip.profile_drag, 0.0),
                zero_lift_moment: lanes(&|strip| 2.0 * strip.zero_lift_moment, 0.0),
                suction_loss: lanes(&suction_loss, 0.0),
                flap_lift: flap(&|effect| effect.lift),
                flap_drag: lanes(&flap_drag, 0.0),
                flap_moment: flap(&|effect| effect.moment),
            },
            moment_slope: if_any(lanes(&|strip| 2.0 * strip.moment_slope, 0.0)),
            flap_profile_drag: if_any(lanes(&flap_profile_drag, 0.0)),
            gains: coefficients(&|factor| matches!(factor, FlapFactor::Angle(_))),
            squared_gains: coefficients(&|factor| matches!(factor, FlapFactor::Product(_))),
            in_plane: free == RigidFreedom::InPlane && strips.iter().all(ReducedStrip::stays_in_plane),
        }
    }

    /// m = n + α0 f [theory: air-loads.triad].
    #[inline(always)]
    pub(crate) fn zero_lift_normal<S: Arithmetic, V: Arrow<S>, const EQUAL_ROWS: bool>(
        &self,
        window: Window<S>,
        [normal, forward]: [V; 2],
    ) -> V {
        if EQUAL_ROWS { normal } else { normal + forward * window.load(&self.zero_lift_offset) }
    }

    /// The flow by f·V, n·V and Ω, by those parts of ẇ and Ω̇ that no acceleration makes, and by g₁ in a gust; the induced
    /// velocity is left at zero [theory: air-loads.flow, air-loads.rates, gusts.strip].
    #[inline(always)]
    pub(crate) fn flow<S: Arithmetic, const EQUAL_ROWS: bool>(
        &self,
        window: Window<S>,
        density: f64,
        [chordwise, normal, pitch_rate]: [Lanes<S>; 3],
        [upwash_drift, pitch_drift]: [Lanes<S>; 2],
        gust_gradient: Option<Lanes<S>>,
    ) -> LocalFlow<S> {
        let upwash =
            if EQUAL_ROWS { normal } else { normal + chordwise * window.load(&self.zero_lift_offset) };
        let mut w3 = self.aerofoil.three_quarter_chord_upwash(window, upwash, pitch_rate);
        if let Some(gradient) = gust_gradient {
            w3 += gradient * 0.5;
        }
        LocalFlow {
            density: window.splat(density),
            chordwise,
            normal,
            upwash,
            pitch_rate,
            w3,
            upwash_drift,
            pitch_drift,
            induced: window.splat(0.0),
            gust_gradient,
        }
    }

    /// The loads on the strips in a flow, by their axes n, f and m.
    #[inline(always)]
    pub(crate) fn loads<S: Arithmetic, V: Arrow<S>, const EQUAL_ROWS: bool>(
        &self,
        window: Window<S>,
        flow: &LocalFlow<S>,
        axes: [&V; 3],
    ) -> StripLoadsWithFlaps<S, V, EQUAL_ROWS> {
        let aerofoil = self.aerofoil.at(window);
        let sizes = StripSizes {
            width: window.load(&self.width),
            elastic_axis_aft_of_midchord: aerofoil.elastic_axis_aft_of_midchord,
            root_mass: window.load(&self.root_mass),
            root_inertia: window.load(&self.root_inertia),
        };
        let loads = StripLoads::new(&self.section_loads(window, &aerofoil, flow), &sizes, axes);
        let flaps = if self.gains.is_empty() {
            None
        } else {
            let loads = self.section_flap_loads(window, &aerofoil, flow);
            Some(StripFlapLoads::new(&loads, &sizes, window.load(&self.per_root_mass)))
        };
        (loads, flaps)
    }

    /// The loads per unit width, flaps neutral.
    #[inline(always)]
    pub(super) fn section_loads<S: Arithmetic>(
        &self,
        window: Window<S>,
        aerofoil: &Aerofoil<Lanes<S>>,
        flow: &LocalFlow<S>,
    ) -> SectionLoads<S> {
        let mut loads = aerofoil.loads(flow);
        if let Some(slope) = &self.moment_slope {
            loads.pitching += aerofoil.moment_by_slope(window.load(slope), flow);
        }
        loads
    }

    /// What the flaps add per unit width.
    #[inline(always)]
    pub(super) fn section_flap_loads<S: Arithmetic>(
        &self,
        window: Window<S>,
        aerofoil: &Aerofoil<Lanes<S>>,
        flow: &LocalFlow<S>,
    ) -> SectionFlapLoads<S> {
        let mut loads = aerofoil.flap_loads(flow);
        if let Some(k) = &self.flap_profile_drag {
            aerofoil.add_flap_drag(window.load(k), flow, &mut loads);
        }
        loads
    }

    /// Adds what the loads and the flaps contribute to one component of ν.
    #[inline(always)]
    pub(crate) fn add_row<S: Arithmetic, V: Arrow<S>, const EQUAL_ROWS: bool>(
        &self,
        window: Window<S>,
        index: usize,
        displacement: &Displacement<S>,
        (loads, flaps): &StripLoadsWithFlaps<S, V, EQUAL_ROWS>,
        row: &mut Row,
    ) {
        row.add::<S, EQUAL_ROWS>(window, index, &loads.on(displacement));
        if let Some(flaps) = flaps {
            let (effects, effect) = (row.effects(), flaps.on(displacement));
            for (factor, gain) in &self.gains {
                add_to(window, &mut effects[*factor], effect * window.load(gain));
            }
            if !self.squared_gains.is_empty() {
                let drag = flaps.drag_on(displacement);
                for (factor, gain) in &self.squared_gains {
                    add_to(window, &mut effects[*factor], drag * window.load(gain));
                }
            }
        }
    }
}

/// 1 − η, where there is lift to lose suction from [theory: air-loads.suction].
fn suction_loss(strip: &ReducedStrip) -> f64 {
    if strip.lift_slope == 0.0 { 0.0 } else { 1.0 - strip.leading_edge_suction }
}

/// (1 − η)(CLδ c1)²/CLα, 1/rad.
fn flap_drag(strip: &ReducedStrip) -> f64 {
    match &strip.flap {
        Some(flap) if strip.lift_slope != 0.0 => {
            let lift = FlapEffect::new(flap).lift;
            suction_loss(strip) * lift * lift / strip.lift_slope
        }
        _ => 0.0,
    }
}

/// k, 1/rad².
fn flap_profile_drag(strip: &ReducedStrip) -> f64 {
    strip.flap.as_ref().map_or(0.0, |flap| flap.drag)
}

/// Whether a strip's flap makes a drag that is proportional to δ².
pub(crate) fn drags_by_flap(strip: &ReducedStrip) -> bool {
    flap_drag(strip) != 0.0 || flap_profile_drag(strip) != 0.0
}

/// Numbers of which one at least is not zero.
fn if_any(numbers: Eight) -> Option<Eight> {
    (numbers != Eight::ZERO).then_some(numbers)
}

/// The coefficient of a factor in a strip's δ; in its δ² where that drags.
fn coefficient(strip: &ReducedStrip, factor: FlapFactor) -> f64 {
    match factor {
        FlapFactor::Product(_) if !drags_by_flap(strip) => 0.0,
        _ => strip.flap.as_ref().map_or(0.0, |flap| factor.coefficient(&flap.gains)),
    }
}
