//! Lift, moment, suction and drag of aerofoil sections, four side by side [4.1; physics.md §4].
//!
//! Symbols: U `chordwise`, w `upwash`, Ω `pitch_rate`, λ₀ `induced`. Loads are per unit width and leave out
//! the apparent-mass part that is proportional to accelerations, which the equations of motion carry on
//! their left-hand side.

use crate::lanes::Lanes;

/// What four aerofoil sections are, apart from their places.
#[derive(Clone, Debug)]
pub struct Section {
    /// b, m.
    pub semichord: Lanes,
    /// d, m.
    pub elastic_axis_aft_of_midchord: Lanes,
    /// CLα, 1/rad.
    pub lift_slope: Lanes,
    /// CD0.
    pub profile_drag: Lanes,
    /// η.
    pub leading_edge_suction: Lanes,
    /// CLδ c1, 1/rad, see [`FlapEffect`](super::FlapEffect); zero without a flap.
    pub flap_lift: Lanes,
    /// CLδ c4, 1/rad.
    pub flap_moment: Lanes,
}

/// The air as the sections meet it.
#[derive(Clone, Copy, Debug)]
pub struct LocalFlow {
    /// ρ, kg/m³.
    pub density: Lanes,
    /// U = f·V, m/s.
    pub chordwise: Lanes,
    /// n·V, m/s.
    pub normal: Lanes,
    /// w = n·V + U α0, m/s.
    pub upwash: Lanes,
    /// Ω, rad/s.
    pub pitch_rate: Lanes,
    /// The part of ẇ that no acceleration makes, m/s².
    pub upwash_drift: Lanes,
    /// The part of Ω̇ that no acceleration makes, rad/s².
    pub pitch_drift: Lanes,
    /// λ₀, m/s.
    pub induced: Lanes,
    /// δ, rad.
    pub flap_angle: Lanes,
}

/// Loads at the elastic axis per unit width.
#[derive(Clone, Copy, Debug)]
pub struct SectionLoads {
    /// Along f, N/m.
    pub forward: Lanes,
    /// Along n ("down" for a wing), N/m.
    pub down: Lanes,
    /// About s, nose-up, N.
    pub pitching: Lanes,
}

impl Section {
    /// w₃ = w + (b/2 − d) Ω: the upwash at three-quarter chord, m/s.
    pub fn three_quarter_chord_upwash(&self, upwash: Lanes, pitch_rate: Lanes) -> Lanes {
        upwash + (half(self.semichord) - self.elastic_axis_aft_of_midchord) * pitch_rate
    }

    /// The loads, without the apparent-mass terms in the accelerations.
    pub fn loads(&self, flow: &LocalFlow) -> SectionLoads {
        let (b, d) = (self.semichord, self.elastic_axis_aft_of_midchord);
        let LocalFlow { density: rho, chordwise, normal, upwash, pitch_rate, induced, .. } = *flow;

        let effective_upwash = self.three_quarter_chord_upwash(upwash, pitch_rate) - induced;
        let flap_pressure = rho * b * chordwise * chordwise * flow.flap_angle;
        let lift = self.lift_slope * rho * chordwise * b * effective_upwash + flap_pressure * self.flap_lift;

        let apparent = Lanes::splat(std::f64::consts::PI) * rho * b * b;
        let apparent_lift = apparent * (flow.upwash_drift - d * flow.pitch_drift);
        let apparent_moment = apparent
            * (d * flow.upwash_drift
                - half(b) * chordwise * pitch_rate
                - (d * d + Lanes::splat(0.125) * b * b) * flow.pitch_drift);

        let suction_velocity = upwash - d * pitch_rate - induced;
        let suction =
            self.leading_edge_suction * self.lift_slope * rho * b * suction_velocity * suction_velocity;
        let drag_per_velocity =
            self.profile_drag * rho * b * (chordwise * chordwise + normal * normal).sqrt();

        SectionLoads {
            forward: suction - drag_per_velocity * chordwise,
            down: -(lift + apparent_lift) - drag_per_velocity * normal,
            pitching: (half(b) + d) * lift + apparent_moment + flap_pressure * b * self.flap_moment,
        }
    }
}

fn half(value: Lanes) -> Lanes {
    value * Lanes::splat(0.5)
}
