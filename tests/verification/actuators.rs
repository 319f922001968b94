//! Actuators and engines against numbers of another program.

use flexible_aircraft::devices::{Actuator, Command, EngineLag, Surface};

use super::record::Record;

const SERVO: Actuator =
    Actuator { frequency: 40.0, damping: 0.7, rate_limit: 0.7, minimum: -0.35, maximum: 0.35 };

/// What a command asks for, from a time (s) on.
type Asked = (f64, Command);

/// The angle at a time (s) under commands that follow each other, from rest at 0, in cells of 10 ms.
fn angle(commands: &[Asked], end: f64) -> f64 {
    let cells = libm::round(end / 0.01) as usize;
    let fly = |surface: Surface, cell: usize| {
        let time = 0.01 * cell as f64;
        let (since, command) = commands.iter().rfind(|(since, _)| *since <= time + 1e-9).unwrap();
        let now = Command { value: command.after(time - since), rate: command.rate };
        SERVO.after(surface, now, 0.01)
    };
    (0..cells).fold(Surface::default(), fly).angle
}

fn step(value: f64) -> Command {
    Command { value, rate: 0.0 }
}

/// A name, what is asked for, and where the surface is at some times.
type Case<'a> = (&'static str, &'a [Asked], &'a [(f64, f64)]);

#[test]
fn actuators_and_engines_move_as_in_another_program() {
    let mut record = Record::new(
        "actuators",
        "Actuators and engines at their limits",
        "a program of its own in numpy; ω = 40 rad/s, ζ = 0.7, rate 0.7 rad/s, stops ±0.35 rad, from rest; τ = 0.5 s, from \
         20 kN, at most 30 kN [theory: actuators.events, actuators.engines]",
    );
    let (up, down) = (Command { value: 0.0, rate: 2.0 }, Command { value: 0.8, rate: -2.0 });
    let cases: [Case; 3] = [
        (
            "step of 0.3 rad",
            &[(0.0, step(0.3))],
            &[(0.1, 0.069474926), (0.4, 0.279443379), (0.5, 0.301264380), (0.6, 0.299928445)],
        ),
        (
            "step of 0.5 rad, then −0.1 rad at 1 s",
            &[(0.0, step(0.5)), (1.0, step(-0.1))],
            &[(0.5, 0.349688588), (0.8, 0.35), (1.1, 0.280346674)],
        ),
        (
            "ramp to 0.8 rad at 0.4 s and back",
            &[(0.0, up), (0.4, down), (0.8, step(0.0))],
            &[(0.4, 0.268205655), (0.6, 0.35), (0.8, 0.239294345), (1.2, -0.001616978)],
        ),
    ];
    for (case, commands, points) in cases {
        for &(time, expected) in points {
            record.absolute(&format!("{case}: at {time} s, rad"), expected, 6e-10, angle(commands, time));
        }
    }
    let engine = EngineLag { time_constant: 0.5, maximum: 30_000.0, ..EngineLag::default() };
    let ramp = Command { value: 20_000.0, rate: 40_000.0 };
    for (case, command, time, expected) in [
        ("thrust asked for 40 kN", step(40_000.0), 0.5, 26_321.206),
        ("thrust asked for 40 kN more each second", ramp, 0.25, 22_130.613),
        ("thrust asked for 40 kN more each second", ramp, 1.0, 28_244.102),
    ] {
        let found = engine.after(20_000.0, command, time);
        record.absolute(&format!("{case}: at {time} s, N"), expected, 6e-4, found);
    }
    record.finish();
}
