//! Lift, moment, suction and drag of aerofoil sections, several side by side.
//!
//! [theory: air-loads.lift, air-loads.moment, air-loads.moment-slope, air-loads.suction, air-loads.drag, gusts.strip; thesis §4.1]
//!
//! Symbols: U `chordwise`, w `upwash`, Ω `pitch_rate`, λ₀ `induced`. Loads are per unit width and leave out
//! the apparent-mass part that is proportional to accelerations, which the equations of motion carry on
//! their left-hand side.

use std::f64::consts::PI;

use crate::math::{Arithmetic, Eight, Lanes, Window};

/// What aerofoil sections are, apart from their places: in memory one number per strip of a group, in use those of
/// the strips at hand.
#[derive(Clone, Debug)]
pub struct Aerofoil<T = Eight> {
    /// b, m.
    pub semichord: T,
    /// d, m.
    pub elastic_axis_aft_of_midchord: T,
    /// CLα, 1/rad.
    pub lift_slope: T,
    /// CD0.
    pub profile_drag: T,
    /// 2 c_m0.
    pub zero_lift_moment: T,
    /// 1 − η: the share of the leading-edge suction that is lost; zero where CLα = 0.
    pub suction_loss: T,
    /// CLδ c1, 1/rad, see [`FlapEffect`](crate::aircraft::FlapEffect); zero without a flap.
    pub flap_lift: T,
    /// (1 − η)(CLδ c1)²/CLα, 1/rad; zero where CLα = 0.
    pub flap_drag: T,
    /// CLδ c4, 1/rad.
    pub flap_moment: T,
}

/// The air as the sections meet it [theory: air-loads.flow].
#[derive(Clone, Copy, Debug)]
pub struct LocalFlow<S: Arithmetic> {
    /// ρ, kg/m³.
    pub density: Lanes<S>,
    /// U = f·V, m/s.
    pub chordwise: Lanes<S>,
    /// n·V, m/s.
    pub normal: Lanes<S>,
    /// w = n·V + U α0, m/s.
    pub upwash: Lanes<S>,
    /// Ω, rad/s.
    pub pitch_rate: Lanes<S>,
    /// w₃: the upwash at three-quarter chord, and half of g₁, m/s.
    pub w3: Lanes<S>,
    /// The part of ẇ that no acceleration makes, m/s².
    pub upwash_drift: Lanes<S>,
    /// The part of Ω̇ that no acceleration makes, rad/s².
    pub pitch_drift: Lanes<S>,
    /// λ₀, m/s.
    pub induced: Lanes<S>,
    /// g₁ in a gust: how its upwash changes along the chord, m/s.
    pub gust_gradient: Option<Lanes<S>>,
}

/// Loads of flaps at the elastic axis per unit width: per radian of δ, and a drag per radian squared.
#[derive(Clone, Copy, Debug)]
pub struct SectionFlapLoads<S: Arithmetic> {
    /// Along f, N/m.
    pub forward: Lanes<S>,
    /// Along −f per δ², N/m.
    pub drag: Lanes<S>,
    /// Along −n per δ², N/m, where it has any.
    pub drag_across: Option<Lanes<S>>,
    /// Along n, N/m.
    pub down: Lanes<S>,
    /// About s, nose-up, N.
    pub pitching: Lanes<S>,
}

/// Loads at the elastic axis per unit width, flaps neutral.
#[derive(Clone, Copy, Debug)]
pub struct SectionLoads<S: Arithmetic> {
    /// Along f, N/m.
    pub forward: Lanes<S>,
    /// Along n ("down" for a wing), N/m.
    pub down: Lanes<S>,
    /// About s, nose-up, N.
    pub pitching: Lanes<S>,
}

impl Aerofoil {
    /// The sections in a window on the group.
    #[inline(always)]
    pub fn at<S: Arithmetic>(&self, window: Window<S>) -> Aerofoil<Lanes<S>> {
        Aerofoil {
            semichord: window.load(&self.semichord),
            elastic_axis_aft_of_midchord: window.load(&self.elastic_axis_aft_of_midchord),
            lift_slope: window.load(&self.lift_slope),
            profile_drag: window.load(&self.profile_drag),
            zero_lift_moment: window.load(&self.zero_lift_moment),
            suction_loss: window.load(&self.suction_loss),
            flap_lift: window.load(&self.flap_lift),
            flap_drag: window.load(&self.flap_drag),
            flap_moment: window.load(&self.flap_moment),
        }
    }

    /// w₃ = w + (b/2 − d) Ω: the upwash at three-quarter chord, m/s.
    #[inline(always)]
    pub fn three_quarter_chord_upwash<S: Arithmetic>(
        &self,
        window: Window<S>,
        upwash: Lanes<S>,
        pitch_rate: Lanes<S>,
    ) -> Lanes<S> {
        let (b, d) = (window.load(&self.semichord), window.load(&self.elastic_axis_aft_of_midchord));
        upwash + (half(b) - d) * pitch_rate
    }
}

impl<S: Arithmetic> LocalFlow<S> {
    /// An upwash at the elastic axis as mid-chord meets it, d ahead, less the induced velocity, m/s.
    #[inline(always)]
    fn at_midchord(&self, d: Lanes<S>, upwash: Lanes<S>) -> Lanes<S> {
        upwash - d * self.pitch_rate - self.induced
    }
}

impl<S: Arithmetic> Aerofoil<Lanes<S>> {
    /// The loads with the flaps neutral, without the apparent-mass terms in the accelerations.
    ///
    /// [theory: air-loads.lift, air-loads.moment, air-loads.suction, air-loads.drag]; departures from the printed thesis
    /// [theory: corrections.moment-arm, corrections.drag].
    #[inline(always)]
    pub fn loads(&self, flow: &LocalFlow<S>) -> SectionLoads<S> {
        let (b, d) = (self.semichord, self.elastic_axis_aft_of_midchord);
        let LocalFlow { density, chordwise, normal, upwash, w3, pitch_rate, induced, .. } = *flow;
        let rho_b = density * b;

        let effective_upwash = w3 - induced;
        let lift_by_upwash = self.lift_slope * rho_b;
        let mut lift = lift_by_upwash * chordwise * effective_upwash;
        if let Some(gradient) = flow.gust_gradient {
            // The gust's apparent mass acts at the quarter chord too [theory: gusts.strip].
            lift += -(rho_b * PI * chordwise * gradient);
        }

        let apparent = rho_b * b * PI;
        let apparent_lift = apparent * (flow.upwash_drift - d * flow.pitch_drift);
        let apparent_moment = apparent
            * (d * flow.upwash_drift
                - half(b) * chordwise * pitch_rate
                - (d * d + b * b * 0.125) * flow.pitch_drift);

        let zero_lift_moment = self.zero_lift_moment * rho_b * b * chordwise * chordwise;

        let suction_velocity = flow.at_midchord(d, normal);
        let incidence_velocity = flow.at_midchord(d, upwash);
        let suction =
            lift_by_upwash * incidence_velocity * (suction_velocity - self.suction_loss * incidence_velocity);
        let drag_per_velocity = self.profile_drag * rho_b * (chordwise * chordwise + normal * normal).sqrt();

        SectionLoads {
            forward: suction - drag_per_velocity * chordwise,
            down: -(lift + apparent_lift) - drag_per_velocity * normal,
            pitching: (half(b) + d) * lift + apparent_moment + zero_lift_moment,
        }
    }

    /// The moment of sections whose 2 c_mα is a slope, N [theory: air-loads.moment-slope].
    #[inline(always)]
    pub fn moment_by_slope(&self, slope: Lanes<S>, flow: &LocalFlow<S>) -> Lanes<S> {
        let effective_upwash = flow.w3 - flow.induced;
        slope * (flow.density * self.semichord) * self.semichord * flow.chordwise * effective_upwash
    }

    /// Adds the profile drag of flaps by their k [theory: air-loads.drag].
    #[inline(always)]
    pub fn add_flap_drag(&self, k: Lanes<S>, flow: &LocalFlow<S>, loads: &mut SectionFlapLoads<S>) {
        let speed = (flow.chordwise * flow.chordwise + flow.normal * flow.normal).sqrt();
        let per_velocity = k * (flow.density * self.semichord) * speed;
        loads.drag += per_velocity * flow.chordwise;
        loads.drag_across = Some(per_velocity * flow.normal);
    }

    /// What the flaps add: the loads are linear in δ but for a drag, which is proportional to δ².
    ///
    /// [theory: air-loads.flap-products]
    #[inline(always)]
    pub fn flap_loads(&self, flow: &LocalFlow<S>) -> SectionFlapLoads<S> {
        let (b, d) = (self.semichord, self.elastic_axis_aft_of_midchord);
        let momentum = flow.density * b * flow.chordwise;
        let (pressure, lift_by_velocity) = (momentum * flow.chordwise, momentum * self.flap_lift);
        let lift = pressure * self.flap_lift;
        let suction_velocity = flow.at_midchord(d, flow.normal);
        let incidence_velocity = flow.at_midchord(d, flow.upwash);
        SectionFlapLoads {
            forward: lift_by_velocity * (suction_velocity - self.suction_loss * incidence_velocity * 2.0),
            drag: pressure * self.flap_drag,
            drag_across: None,
            down: -lift,
            pitching: (half(b) + d) * lift + pressure * b * self.flap_moment,
        }
    }
}

/// The first lane whose lifting strip meets the air from behind.
#[cold]
pub fn first_reversed<S: Arithmetic>(chordwise: Lanes<S>, lift_slope: Lanes<S>) -> Option<usize> {
    let mut strips = chordwise.numbers().iter().zip(lift_slope.numbers());
    strips.position(|(chordwise, slope)| *chordwise <= 0.0 && *slope > 0.0)
}

#[inline(always)]
fn half<S: Arithmetic>(value: Lanes<S>) -> Lanes<S> {
    value * 0.5
}
