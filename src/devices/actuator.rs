//! Actuators: of second order, with a limit of the rate and two stops, followed from event to event in closed form.
//!
//! [theory: actuators.motion, actuators.limits, actuators.events]

use super::command::{Command, LIMITLESS, acting_limits};
use super::swing::Swing;

/// What moves the surface of a control.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Actuator {
    /// ω, rad/s; 0 where the surface is the command.
    pub frequency: f64,
    /// ζ.
    pub damping: f64,
    /// rad/s; from [`LIMITLESS`] on there is none.
    pub rate_limit: f64,
    /// rad; from −[`LIMITLESS`] down there is none.
    pub minimum: f64,
    /// rad; from [`LIMITLESS`] on there is none.
    pub maximum: f64,
}

/// Where a surface is and how it moves.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Surface {
    /// rad.
    pub angle: f64,
    /// rad/s.
    pub rate: f64,
}

/// What holds a surface back.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Holding {
    /// Nothing.
    None,
    /// It moves as fast as it can.
    Rate,
    /// It is at a stop and pushed against it, or jammed between two that are one.
    Stop,
}

impl Default for Actuator {
    /// None: the surface is the command.
    fn default() -> Self {
        Actuator {
            frequency: 0.0,
            damping: 0.7,
            rate_limit: LIMITLESS,
            minimum: -LIMITLESS,
            maximum: LIMITLESS,
        }
    }
}

/// Sub-intervals in which limits are looked for, per radian of the undamped swing.
const LOOKS_PER_RADIAN: f64 = 16.0;

/// By this share a rate is beyond its limit, so that rounding at the limit is not.
const BEYOND: f64 = 1.0 + 1e-12;

const BISECTIONS: usize = 60;

/// Phases that are followed at once. A swing has at most four in a turn; only rounding could make more of them than this in
/// the 10 ms for which commands are followed, and the surface then stands until the next.
const MOST_PHASES: usize = 256;

/// A surface on its way: where a phase begins.
#[derive(Clone, Copy, Debug)]
struct Phase {
    surface: Surface,
    command: Command,
    holding: Holding,
}

impl Actuator {
    /// Whether the surface lags behind the command.
    pub fn lags(&self) -> bool {
        self.frequency > 0.0
    }

    /// Whether the surface is the command, whatever that is.
    pub fn is_direct(&self) -> bool {
        // As it starts: whoever moves a limit from there is asked whether it acts alike on both sides.
        !self.lags() && [self.minimum, self.maximum] == [-LIMITLESS, LIMITLESS]
    }

    /// Minimum and maximum, rad, infinite where there is none.
    pub fn stops(&self) -> [f64; 2] {
        acting_limits(self.minimum, self.maximum)
    }

    /// Whether it has neither stops nor a limit of its rate.
    pub fn is_unlimited(&self) -> bool {
        self.rate_limit() == f64::INFINITY && self.stops() == [f64::NEG_INFINITY, f64::INFINITY]
    }

    /// Whether its stops leave one place.
    fn is_jammed(&self) -> bool {
        let [minimum, maximum] = self.stops();
        minimum == maximum
    }

    fn rate_limit(&self) -> f64 {
        if self.rate_limit >= LIMITLESS { f64::INFINITY } else { self.rate_limit }
    }

    /// The surface where it does not lag: the command within the stops.
    pub fn at_once(&self, command: Command) -> Surface {
        let Command { value, rate } = command.clamped(self.stops());
        Surface { angle: value, rate }
    }

    /// The surface after a time (s) under a command, both counted from where it was.
    pub fn after(&self, surface: Surface, command: Command, time: f64) -> Surface {
        if time == 0.0 {
            return surface;
        }
        let (mut phase, mut left) = (self.phase(surface, command), time);
        for _ in 0..MOST_PHASES {
            match self.end(&phase, left) {
                Some((end, next)) if end < left => {
                    left -= end;
                    phase = next;
                }
                _ => return self.within(&phase, left),
            }
        }
        Surface { rate: 0.0, ..phase.surface }
    }

    /// What holds a surface back under a command.
    pub fn holding(&self, surface: Surface, command: Command) -> Holding {
        if self.lags() {
            return self.phase(surface, command).holding;
        }
        let is_held = command.clamped(self.stops()) != command;
        if is_held { Holding::Stop } else { Holding::None }
    }

    /// The phase that a surface is in.
    fn phase(&self, surface: Surface, command: Command) -> Phase {
        let [minimum, maximum] = self.stops();
        let angle = surface.angle.max(minimum).min(maximum);
        if self.is_jammed() {
            return Phase { surface: Surface { angle, rate: 0.0 }, command, holding: Holding::Stop };
        }
        let outward = match angle {
            _ if angle == maximum => 1.0,
            _ if angle == minimum => -1.0,
            _ => 0.0,
        };
        // Whoever runs into a stop stands there.
        let rate = if surface.rate * outward > 0.0 { 0.0 } else { surface.rate };
        let surface = Surface { angle, rate };
        let push = (command.value - angle) * outward;
        let presses = push > 0.0 || (push == 0.0 && command.rate * outward >= 0.0);
        if outward != 0.0 && rate == 0.0 && presses {
            return Phase { surface, command, holding: Holding::Stop };
        }
        let limit = self.rate_limit();
        if rate.abs() >= limit && self.acceleration(surface, command) * rate > 0.0 {
            let surface = Surface { angle, rate: libm::copysign(limit, rate) };
            return Phase { surface, command, holding: Holding::Rate };
        }
        Phase { surface, command, holding: Holding::None }
    }

    /// ω²(u − δ) − 2ζω δ̇, rad/s².
    fn acceleration(&self, surface: Surface, command: Command) -> f64 {
        let Actuator { frequency, damping, .. } = *self;
        frequency * (frequency * (command.value - surface.angle) - 2.0 * damping * surface.rate)
    }

    /// The surface a time (s) after the beginning of a phase that has not ended.
    fn within(&self, phase: &Phase, time: f64) -> Surface {
        let Phase { surface, command, holding } = *phase;
        match holding {
            Holding::Stop => surface,
            Holding::Rate => Surface { angle: surface.angle + surface.rate * time, ..surface },
            Holding::None => self.swung(surface, command, time),
        }
    }

    /// The linear motion [theory: actuators.motion].
    fn swung(&self, surface: Surface, command: Command, time: f64) -> Surface {
        let Actuator { frequency, damping, .. } = *self;
        let behind = 2.0 * damping * command.rate / frequency;
        let z = [surface.angle - command.value + behind, surface.rate - command.rate];
        let [z, speed] = Swing { frequency, damping }.after(time, z);
        Surface { angle: command.after(time) - behind + z, rate: command.rate + speed }
    }

    /// When a phase ends (s from its beginning), and the next one; looks no further than a sub-interval beyond a horizon (s).
    fn end(&self, phase: &Phase, horizon: f64) -> Option<(f64, Phase)> {
        match phase.holding {
            Holding::Stop => self.end_at_the_stop(phase),
            Holding::Rate => self.end_of_the_full_rate(phase),
            Holding::None => self.end_of_the_swing(phase, horizon),
        }
    }

    /// When the command comes back from beyond the stop; never between stops that are one.
    fn end_at_the_stop(&self, phase: &Phase) -> Option<(f64, Phase)> {
        let Phase { surface, command, .. } = *phase;
        let end = (surface.angle - command.value) / command.rate;
        let free = Phase { surface, command: command.from(end), holding: Holding::None };
        (end > 0.0 && end.is_finite() && !self.is_jammed()).then_some((end, free))
    }

    /// When the acceleration, linear in time, is zero, or at a stop.
    fn end_of_the_full_rate(&self, phase: &Phase) -> Option<(f64, Phase)> {
        let Phase { surface: Surface { angle, rate }, command, .. } = *phase;
        let [minimum, maximum] = self.stops();
        let limit = if rate > 0.0 { maximum } else { minimum };
        let to_the_stop = (limit - angle) / rate;
        let slope = self.frequency * self.frequency * (rate - command.rate);
        let to_zero = Some(self.acceleration(phase.surface, command) / slope).filter(|time| *time > 0.0);
        match to_zero {
            Some(end) if end < to_the_stop => {
                let surface = Surface { angle: angle + rate * end, rate };
                Some((end, Phase { surface, command: command.from(end), holding: Holding::None }))
            }
            _ => {
                let stopped = Surface { angle: limit, rate: 0.0 };
                to_the_stop.is_finite().then(|| (to_the_stop, self.phase(stopped, command.from(to_the_stop))))
            }
        }
    }

    /// When the linear motion first passes a limit [theory: actuators.events].
    fn end_of_the_swing(&self, phase: &Phase, horizon: f64) -> Option<(f64, Phase)> {
        if self.is_unlimited() {
            return None;
        }
        let Phase { surface, command, .. } = *phase;
        let is_beyond = |time: f64| self.is_beyond(self.swung(surface, command, time));
        let width = 1.0 / (LOOKS_PER_RADIAN * self.frequency);
        let (mut before, mut looks) = (0.0, 1.0);
        while before < horizon {
            let mut later = looks * width;
            if is_beyond(later) {
                for _ in 0..BISECTIONS {
                    let middle = 0.5 * (before + later);
                    *(if is_beyond(middle) { &mut later } else { &mut before }) = middle;
                }
                let held = self.held(self.swung(surface, command, later));
                return Some((later, self.phase(held, command.from(later))));
            }
            (before, looks) = (later, looks + 1.0);
        }
        None
    }

    fn is_beyond(&self, Surface { angle, rate }: Surface) -> bool {
        let [minimum, maximum] = self.stops();
        angle > maximum || angle < minimum || rate.abs() > self.rate_limit() * BEYOND
    }

    /// A surface beyond a limit on it.
    fn held(&self, Surface { angle, rate }: Surface) -> Surface {
        let [minimum, maximum] = self.stops();
        if angle > maximum || angle < minimum {
            Surface { angle: angle.max(minimum).min(maximum), rate: 0.0 }
        } else {
            Surface { angle, rate: libm::copysign(self.rate_limit(), rate) }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// That of the reference numbers in `tests/verification/actuators.rs`.
    const LIMITED: Actuator =
        Actuator { frequency: 40.0, damping: 0.7, rate_limit: 0.7, minimum: -0.35, maximum: 0.35 };

    /// Follows commands, each from a time (s) on, from rest in cells of 10 ms; the angle at the end.
    fn follow(actuator: &Actuator, commands: &[(f64, Command)], end: f64) -> Surface {
        let (mut surface, cells) = (Surface::default(), libm::round(end / 0.01) as usize);
        for cell in 0..cells {
            let time = 0.01 * cell as f64;
            let (since, command) = commands.iter().rfind(|(since, _)| *since <= time + 1e-9).unwrap();
            surface = actuator.after(surface, command.from(time - since), 0.01);
        }
        surface
    }

    const fn step(value: f64) -> Command {
        Command { value, rate: 0.0 }
    }

    #[test]
    fn whether_it_is_followed_in_one_piece_or_in_many_changes_only_rounding() {
        let (start, command) = (Surface { angle: 0.1, rate: -0.5 }, Command { value: 0.6, rate: -1.2 });
        let whole = LIMITED.after(start, command, 0.9);
        let mut parts = start;
        for part in 0..90 {
            parts = LIMITED.after(parts, command.from(0.01 * f64::from(part)), 0.01);
        }
        assert!((whole.angle - parts.angle).abs() < 1e-12 && (whole.rate - parts.rate).abs() < 1e-11);
    }

    #[test]
    fn the_linear_motion_fulfils_its_equation_whatever_the_damping() {
        for damping in [0.0, 0.3, 1.0, 2.5] {
            let actuator = Actuator { frequency: 25.0, damping, ..Actuator::default() };
            let (start, command) = (Surface { angle: 0.2, rate: 1.0 }, Command { value: -0.1, rate: 0.4 });
            let at = |time: f64| actuator.after(start, command, time);
            for time in [0.01, 0.1, 0.5] {
                let h = 1e-4;
                let rates =
                    [at(time - 2.0 * h), at(time - h), at(time + h), at(time + 2.0 * h)].map(|s| s.rate);
                let found = (8.0 * (rates[2] - rates[1]) - (rates[3] - rates[0])) / (12.0 * h);
                let expected = actuator.acceleration(at(time), command.from(time));
                assert!((found - expected).abs() < 7e-7, "{damping} {time}: {found} {expected}");
            }
        }
    }

    #[test]
    fn what_holds_a_surface_back_is_told() {
        let holding = |end| LIMITED.holding(follow(&LIMITED, &[(0.0, step(0.5))], end), step(0.5));
        assert_eq!([0.0, 0.3, 0.8].map(holding), [Holding::None, Holding::Rate, Holding::Stop]);
        // Pushed inward it is free, though it is still there.
        let at_stop = Surface { angle: 0.35, rate: 0.0 };
        assert_eq!(LIMITED.holding(at_stop, step(0.3)), Holding::None);
        assert_eq!(LIMITED.holding(at_stop, Command { value: 0.35, rate: -1.0 }), Holding::None);
    }

    #[test]
    fn without_a_frequency_the_stops_clamp_the_command_and_no_rate_is_limited() {
        let direct = Actuator { frequency: 0.0, ..LIMITED };
        let surface = |value, rate| {
            let command = Command { value, rate };
            (direct.at_once(command), direct.holding(Surface::default(), command))
        };
        let free = |angle, rate| (Surface { angle, rate }, Holding::None);
        let held = |angle| (Surface { angle, rate: 0.0 }, Holding::Stop);
        assert_eq!(surface(0.2, 5.0), free(0.2, 5.0));
        assert_eq!([surface(0.4, -5.0), surface(-0.4, 1.0)], [held(0.35), held(-0.35)]);
        assert_eq!([surface(0.35, 1.0), surface(0.35, -1.0)], [held(0.35), free(0.35, -1.0)]);
    }

    #[test]
    fn commands_beyond_all_numbers_end_the_search_for_events() {
        for value in [f64::MAX, f64::INFINITY, f64::NAN] {
            let surface = LIMITED.after(Surface::default(), Command { value, rate: 0.0 }, 0.01);
            assert!(surface.angle.abs() <= 0.35 || surface.angle.is_nan(), "{value}: {surface:?}");
        }
    }

    /// Asked for more, for less, for just this, and by ramps from there and past it.
    #[test]
    fn a_jammed_actuator_stays_at_its_stop_whatever_it_is_asked_for() {
        let jammed = Actuator { minimum: 0.1, maximum: 0.1, ..LIMITED };
        let start = Surface { angle: 0.1, rate: 0.0 };
        for (value, rate) in [(0.3, 0.0), (-0.3, 0.0), (0.1, 0.0), (0.1, 1.0), (0.1, -1.0), (0.2, -20.0)] {
            let command = Command { value, rate };
            assert_eq!(jammed.after(start, command, 0.01), start, "{command:?}");
            assert_eq!(jammed.holding(start, command), Holding::Stop, "{command:?}");
            assert!(jammed.end(&jammed.phase(start, command), 0.01).is_none(), "{command:?}");
        }
    }

    #[test]
    fn a_stop_that_the_command_leaves_outwards_holds_and_one_that_it_comes_back_to_lets_go() {
        let at_stop = Surface { angle: 0.35, rate: 0.0 };
        let end = |value: f64, rate: f64| {
            let phase = LIMITED.phase(at_stop, Command { value, rate });
            assert_eq!(phase.holding, Holding::Stop);
            LIMITED.end(&phase, 0.01).map(|(end, next)| (end, next.holding))
        };
        // Standing there, leaving from there, and from beyond.
        assert_eq!([end(0.35, 0.0), end(0.35, 1.0), end(0.6, 1.0), end(0.6, 0.0)], [None; 4]);
        let (back, next) = end(0.6, -100.0).unwrap();
        assert!((back - 2.5e-3).abs() < 1e-15 && next == Holding::None, "{back}");
    }

    /// Undamped, fast, and with hardly any room: the search still ends, and no limit is passed by more than looking so often
    /// lets pass.
    #[test]
    fn limits_hold_while_an_undamped_actuator_bounces_between_them() {
        let nervous =
            Actuator { frequency: 1000.0, damping: 0.0, rate_limit: 1.0, minimum: -1e-4, maximum: 2e-4 };
        let mut surface = Surface::default();
        for cell in 0..100 {
            let command = Command { value: if cell % 3 == 0 { 1e-4 } else { -5e-4 }, rate: 0.02 };
            surface = nervous.after(surface, command, 0.01);
            assert!((-1e-4..=2e-4).contains(&surface.angle), "{surface:?}");
            assert!(surface.rate.abs() <= 1.0 + 1e-3, "{surface:?}");
        }
    }
}
