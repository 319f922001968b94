//! States of a linear model on which nothing depends: horizontal position, heading, how far the air has gone
//! [theory: linearisation.all-states].

use crate::plant::{Course, Manoeuvre, SettingError, SteadyFlight};
use crate::variables::{Axis, InputSlot, OutputSlot, VariableTable};

use super::lags::add_state;
use super::linear_model::LinearModel;
use super::linear_names::{Name, input_named, output_named};

/// That they stay at rest, or go on evenly.
///
/// # Errors
/// In a turn, which takes the heading along.
pub(super) fn check(manoeuvre: &Manoeuvre) -> Result<(), SettingError> {
    match manoeuvre.flight {
        SteadyFlight::Turn { .. } | SteadyFlight::TurnAtLoadFactor { .. } => {
            let [setting, found] = ["condition.manoeuvre", "turn"].map(str::to_owned);
            let allowed = "straight or pull_up for a linear model with all states: in a turn position north and east and \
                           heading do not rest";
            Err(SettingError { setting, found, allowed: allowed.to_owned() })
        }
        SteadyFlight::Straight { .. } | SteadyFlight::Banked { .. } | SteadyFlight::PullUp { .. } => Ok(()),
    }
}

/// Turns horizontal position, where a model has it along a course, to north and east, and adds how far the air has gone.
pub(super) fn complete(linear: &mut LinearModel, course: Course, table: &VariableTable) {
    let names = [Axis::X, Axis::Y].map(|axis| output_named(OutputSlot::Position(axis), table));
    if linear.states.first() == Some(&names[0]) {
        turn_positions(linear, course);
    }
    for axis in Axis::ALL {
        let wind = input_named(InputSlot::Wind(axis), table);
        let state = Name { name: format!("drift.{}", wind.name.trim_start_matches("wind_")), unit: "m" };
        let place = add_state(linear, state, 0.0);
        if let Some(column) = linear.inputs.iter().position(|name| *name == wind) {
            linear.b[(place, column)] = 1.0;
        }
    }
}

/// The first two states are positions ahead and to the right; makes them those north and east.
fn turn_positions(linear: &mut LinearModel, course: Course) {
    let LinearModel { a, b, c, bd, x0, .. } = linear;
    let along = course.matrix().fixed_view::<2, 2>(0, 0).into_owned();
    for rates in [&mut *a, b, bd] {
        let turned = along.transpose() * rates.fixed_rows::<2>(0);
        rates.fixed_rows_mut::<2>(0).copy_from(&turned);
    }
    for effects in [a, c] {
        let turned = effects.fixed_columns::<2>(0) * along;
        effects.fixed_columns_mut::<2>(0).copy_from(&turned);
    }
    let turned = along.transpose() * nalgebra::Vector2::new(x0[0], x0[1]);
    x0[..2].copy_from_slice(turned.as_slice());
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::aircraft::{Aircraft, Support};
    use crate::by_name::{Flight, Inflow, LinearContents};
    use crate::flight::Settings;
    use crate::plant::{ConditionSettings, ManoeuvreChoice, PlantSettings};
    use crate::structure::{ReducedModel, test_jet::jet};
    use nalgebra::DVector;

    const ALL: LinearContents = LinearContents { inflow: Inflow::Kept, all_states: true, gust_planes: 0 };

    /// North-east, at a climb angle, with two modes.
    fn climbing(climb_angle: f64) -> Settings {
        let condition = ConditionSettings { climb_angle, ..ConditionSettings::default() };
        let settings = PlantSettings { mode_count: 2, heading: 0.7, condition, ..PlantSettings::of(jet()) };
        PlantSettings { inflow_states: 0, ..settings }.into()
    }

    fn whole(settings: &Settings) -> LinearModel {
        LinearModel::with(jet().clone(), settings, ALL).unwrap()
    }

    fn place(names: &[Name], name: &str) -> usize {
        names.iter().position(|other| other.name == name).unwrap()
    }

    #[test]
    fn position_follows_path_and_heading_and_drift_the_wind() {
        let model = whole(&climbing(0.05));
        let states: Vec<&str> = model.states.iter().map(|name| name.name.as_str()).collect();
        let rigid = ["position.north", "position.east", "position.down", "attitude.roll", "attitude.pitch"];
        assert_eq!((&states[..5], states[5]), (&rigid[..], "attitude.yaw"));
        assert_eq!(states[states.len() - 3..], ["drift.north", "drift.east", "drift.down"]);
        let entry = |row, column| model.a[(place(&model.states, row), place(&model.states, column))];
        let near = |found: f64, expected: f64| (found - expected).abs() < 1e-8 * (1.0 + expected.abs());
        // By closed forms: ρ̇ = C_Ib v, of which nothing is across; ψ̇ = (ω_y sin φ + ω_z cos φ)/cos θ.
        let (sin, cos) = libm::sincos(0.7);
        let (sin_pitch, cos_pitch) = libm::sincos(model.x0[4]);
        let ahead = 127.0 * libm::cos(0.05);
        assert!(near(entry("position.north", "attitude.yaw"), -ahead * sin));
        assert!(near(entry("position.east", "attitude.yaw"), ahead * cos));
        assert!(near(entry("position.north", "attitude.pitch"), -127.0 * libm::sin(0.05) * cos));
        for (body, north, east) in [
            ("velocity.x", cos_pitch * cos, cos_pitch * sin),
            ("velocity.y", -sin, cos),
            ("velocity.z", sin_pitch * cos, sin_pitch * sin),
        ] {
            assert!(near(entry("position.north", body), north) && near(entry("position.east", body), east));
        }
        assert!(near(entry("attitude.yaw", "rate.z"), 1.0 / cos_pitch));
        for column in ["position.north", "position.east", "attitude.yaw", "drift.east"] {
            let moved: Vec<usize> = (0..states.len())
                .filter(|&row| model.a[(row, place(&model.states, column))].abs() > 1e-7)
                .collect();
            let expected: &[usize] = if column == "attitude.yaw" { &[0, 1] } else { &[] };
            assert_eq!(moved, expected, "{column}");
        }
        for (drift, wind) in
            [("drift.north", "wind_north"), ("drift.east", "wind_east"), ("drift.down", "wind_down")]
        {
            let row = model.b.row(place(&model.states, drift));
            assert_eq!((row[place(&model.inputs, wind)], row.sum()), (1.0, 1.0));
        }
    }

    #[test]
    fn the_other_states_and_what_outputs_show_of_them_are_those_without() {
        let settings = climbing(0.05);
        let (all, felt) =
            (whole(&settings), LinearModel::new(jet().clone(), &settings, Inflow::Kept).unwrap());
        let columns: Vec<usize> = felt.states.iter().map(|name| place(&all.states, &name.name)).collect();
        assert_eq!(all.states.len(), felt.states.len() + 6);
        assert_eq!(all.a.select_rows(&columns).select_columns(&columns), felt.a);
        assert_eq!([all.b.select_rows(&columns), all.bd.select_rows(&columns)], [felt.b, felt.bd]);
        assert_eq!([all.c.select_columns(&columns), all.d.clone()], [felt.c, felt.d]);
        for name in ["position.north", "position.east", "attitude.yaw"] {
            let row = all.c.row(place(&all.outputs, name));
            let own = row[place(&all.states, name)];
            assert!((own - 1.0).abs() < 1e-9 && (row.norm() - 1.0).abs() < 1e-7, "{name}: {row}");
        }
    }

    /// Half the difference of a step up and a step down, in which nothing quadratic is left; level, as the air that thins changes
    /// a climb.
    #[test]
    fn a_flight_goes_where_the_linear_model_has_it() {
        const JUMP: f64 = 1e-3;
        const STEPS: u32 = 200;
        let model = whole(&climbing(0.0));
        let flown = |jump: f64| {
            let mut flight = Flight::new(jet().clone());
            for (name, value) in [("heading", 0.7), ("tolerance", 1e-9)] {
                flight.set(name, value).unwrap();
            }
            for (name, count) in [("mode_count", 2), ("inflow_states", 0)] {
                flight.set(name, count).unwrap();
            }
            for control in ["rudder", "elevator"] {
                flight.set(control, jump).unwrap();
            }
            flight.advance(0.01 * f64::from(STEPS)).unwrap();
            ["position.north", "position.east", "attitude.yaw"].map(|name| flight.get(name).unwrap())
        };
        let (up, down) = (flown(JUMP), flown(-JUMP));
        // Of the fourth order, in a tenth of the flight's steps.
        let forcing = (model.b.column(place(&model.inputs, "rudder"))
            + model.b.column(place(&model.inputs, "elevator")))
            * JUMP;
        let rate = |x: &DVector<f64>| &model.a * x + &forcing;
        let (mut x, step) = (DVector::zeros(model.states.len()), 1e-3);
        for _ in 0..10 * STEPS {
            let one = rate(&x);
            let two = rate(&(&x + &one * (0.5 * step)));
            let three = rate(&(&x + &two * (0.5 * step)));
            let four = rate(&(&x + &three * step));
            x += (one + (two + three) * 2.0 + four) * (step / 6.0);
        }
        for (found, name) in ["position.north", "position.east", "attitude.yaw"].iter().enumerate() {
            let flown = 0.5 * (up[found] - down[found]);
            let linear = x[place(&model.states, name)];
            assert!((flown - linear).abs() < 1e-5 * flown.abs(), "{name}: {flown}, {linear}");
            assert!(flown.abs() > 1e-4, "{name}: {flown}");
        }
    }

    #[test]
    fn a_turn_is_refused_and_a_wing_in_a_tunnel_has_drift_alone() {
        let condition = ConditionSettings {
            manoeuvre: ManoeuvreChoice::Turn,
            bank_angle: 0.3,
            ..ConditionSettings::default()
        };
        let turning = PlantSettings { condition, ..climbing(0.0).plant };
        let refused = LinearModel::with(jet().clone(), &turning.into(), ALL).unwrap_err().to_string();
        assert!(
            refused.starts_with("condition.manoeuvre: found turn, allowed is straight or pull_up"),
            "{refused}"
        );
        let wing = ReducedModel::new(&Aircraft::read("aircraft/goland-wing.toml").unwrap(), 2).unwrap();
        assert_eq!(wing.support, Support::Clamped);
        let settings = Settings::of(&wing);
        let felt = LinearModel::new(wing.clone(), &settings, Inflow::Steady).unwrap();
        let all =
            LinearModel::with(wing, &settings, LinearContents { inflow: Inflow::Steady, ..ALL }).unwrap();
        assert_eq!(all.states[..4], felt.states[..4]);
        let added: Vec<&str> = all.states[4..].iter().map(|name| name.name.as_str()).collect();
        assert_eq!(added, ["drift.north", "drift.east", "drift.down"]);
    }
}
