//! Lift, moment, suction and drag of an aerofoil section [4.1; physics.md §4].
//!
//! Symbols: U `chordwise`, w `upwash`, Ω `pitch_rate`, λ₀ `induced`. Loads are per unit width and leave out
//! the apparent-mass part that is proportional to accelerations, which the equations of motion carry on
//! their left-hand side.

use super::FlapEffect;

/// What an aerofoil section is, apart from its place.
#[derive(Clone, Debug, PartialEq)]
pub struct Section {
    /// b, m.
    pub semichord: f64,
    /// d, m.
    pub elastic_axis_aft_of_midchord: f64,
    /// CLα, 1/rad.
    pub lift_slope: f64,
    /// α0, rad.
    pub zero_lift_offset: f64,
    /// CD0.
    pub profile_drag: f64,
    /// η.
    pub leading_edge_suction: f64,
    /// The flap, when there is one.
    pub flap: Option<FlapEffect>,
}

/// The air as the section meets it.
#[derive(Clone, Copy, Debug)]
pub struct LocalFlow {
    /// ρ, kg/m³.
    pub density: f64,
    /// U = f·V, m/s.
    pub chordwise: f64,
    /// n·V, m/s.
    pub normal: f64,
    /// w = n·V + U α0, m/s.
    pub upwash: f64,
    /// Ω, rad/s.
    pub pitch_rate: f64,
    /// The part of ẇ that no acceleration makes, m/s².
    pub upwash_drift: f64,
    /// The part of Ω̇ that no acceleration makes, rad/s².
    pub pitch_drift: f64,
    /// λ₀, m/s.
    pub induced: f64,
    /// δ, rad.
    pub flap_angle: f64,
}

/// Loads at the elastic axis per unit width.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct SectionLoads {
    /// Along f, N/m.
    pub forward: f64,
    /// Along n ("down" for a wing), N/m.
    pub down: f64,
    /// About s, nose-up, N.
    pub pitching: f64,
}

impl Section {
    /// w₃ = w + (b/2 − d) Ω: the upwash at three-quarter chord, m/s.
    pub fn three_quarter_chord_upwash(&self, upwash: f64, pitch_rate: f64) -> f64 {
        upwash + (0.5 * self.semichord - self.elastic_axis_aft_of_midchord) * pitch_rate
    }

    /// πρb², the apparent mass per unit width, kg/m.
    pub fn apparent_mass(&self, density: f64) -> f64 {
        std::f64::consts::PI * density * self.semichord * self.semichord
    }

    /// The loads, without the apparent-mass terms in the accelerations.
    pub fn loads(&self, flow: &LocalFlow) -> SectionLoads {
        let (b, d) = (self.semichord, self.elastic_axis_aft_of_midchord);
        let LocalFlow { density: rho, chordwise, normal, upwash, pitch_rate, induced, .. } = *flow;

        let effective_upwash = self.three_quarter_chord_upwash(upwash, pitch_rate) - induced;
        let (flap_lift, flap_moment) = match &self.flap {
            Some(flap) => {
                let pressure = rho * b * chordwise * chordwise * flow.flap_angle;
                (pressure * flap.lift, pressure * b * flap.moment)
            }
            None => (0.0, 0.0),
        };
        let lift = self.lift_slope * rho * chordwise * b * effective_upwash + flap_lift;

        let apparent = self.apparent_mass(rho);
        let apparent_lift = apparent * (flow.upwash_drift - d * flow.pitch_drift);
        let apparent_moment = apparent
            * (d * flow.upwash_drift
                - 0.5 * b * chordwise * pitch_rate
                - (d * d + 0.125 * b * b) * flow.pitch_drift);

        let suction_velocity = upwash - d * pitch_rate - induced;
        let suction =
            self.leading_edge_suction * self.lift_slope * rho * b * suction_velocity * suction_velocity;
        let drag_per_velocity =
            self.profile_drag * rho * b * libm::sqrt(chordwise * chordwise + normal * normal);

        SectionLoads {
            forward: suction - drag_per_velocity * chordwise,
            down: -(lift + apparent_lift) - drag_per_velocity * normal,
            pitching: (0.5 * b + d) * lift + apparent_moment + flap_moment,
        }
    }
}
