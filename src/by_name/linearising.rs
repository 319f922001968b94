//! How a linear model comes to be: an aircraft at a trim, linearised there, and what is asked for beside that.
//!
//! [theory: linearisation.inputs, linearisation.gust-planes]

use std::sync::Arc;

use crate::flight::{Settings, SimulationError};
use crate::plant::{SettingError, UnknownsKept};
use crate::structure::ReducedModel;
use crate::symmetry::Plants;

use super::at_trim::AtTrim;
use super::linear_model::{Inflow, LinearContents, LinearModel};
use super::{gust_planes, lags};

impl LinearModel {
    /// Linearises an aircraft about the trim of some settings, whatever the manoeuvre. Allocates.
    ///
    /// # Errors
    /// When a setting is out of range or no flight could begin with them.
    pub fn new(
        model: impl Into<Arc<ReducedModel>>,
        settings: &Settings,
        inflow: Inflow,
    ) -> Result<Self, SimulationError> {
        LinearModel::with(model, settings, LinearContents { inflow, ..LinearContents::default() })
    }

    /// The same with these states and inputs.
    ///
    /// ```
    /// use flexible_aircraft::{Aircraft, Inflow, LinearContents, LinearModel, flight::Settings};
    ///
    /// let jet = Aircraft::read("aircraft/generic-business-jet.toml")?.reduce()?;
    /// let mut settings = Settings::of(&jet);
    /// settings.plant.mode_count = 2;
    /// let contents = LinearContents { inflow: Inflow::Steady, all_states: true, gust_planes: 3 };
    /// let model = LinearModel::with(jet, &settings, contents)?;
    /// assert_eq!(model.inputs[model.inputs.len() - 2].name, "gust_plane[3].up");
    /// // From the nose, 10.4 m before O, the last plane is met after this time, s.
    /// let delay = (model.gust_planes[0] - model.gust_planes[2]) / settings.plant.airspeed;
    /// assert!((0.1..0.3).contains(&delay));
    /// assert_eq!(model.states[0].name, "position.north");
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// As those of [`new`](Self::new); with all states in a turn, where they do not rest; when there is a single plane.
    pub fn with(
        model: impl Into<Arc<ReducedModel>>,
        settings: &Settings,
        contents: LinearContents,
    ) -> Result<Self, SimulationError> {
        let at_trim = AtTrim::new(model.into(), settings, contents)?;
        let mut linear = at_trim.linear_model();
        gust_planes::append(&mut linear, &at_trim, contents.gust_planes)?;
        Ok(linear)
    }

    /// How many states a [`new`](Self::new) one of these settings has, whether or not there is a trim. Allocates.
    ///
    /// # Errors
    /// When a setting is out of range.
    pub fn state_count(
        model: &ReducedModel,
        settings: &Settings,
        inflow: Inflow,
    ) -> Result<usize, SettingError> {
        let settings = inflow.of(settings);
        let plants = Plants::under(model, &settings.plant.along_course())?;
        Ok(plants.whole().unknowns(UnknownsKept::Felt).len() + lags::count(model, &settings))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::by_name::LinearName;
    use crate::devices::{Actuator, EngineLag};
    use crate::equations::Fidelity;
    use crate::flight::{Inputs, Simulation};
    use crate::plant::PlantSettings;
    use crate::structure::test_jet::jet;
    use crate::variables::{Slot, VariableTable};

    /// Two modes and one inflow state.
    fn small() -> Settings {
        PlantSettings { mode_count: 2, inflow_states: 1, ..PlantSettings::of(jet()) }.into()
    }

    fn linearised(settings: &Settings, inflow: Inflow) -> LinearModel {
        LinearModel::new(jet().clone(), settings, inflow).unwrap()
    }

    fn place(names: &[LinearName], name: &str) -> usize {
        names.iter().position(|other| other.name == name).unwrap()
    }

    #[test]
    fn states_inputs_and_outputs_are_named_as_in_the_fmu() {
        let model = linearised(&small(), Inflow::Kept);
        let names = |names: &[LinearName]| names.iter().map(|name| name.name.clone()).collect::<Vec<_>>();
        let states = names(&model.states);
        let rigid = [
            "position.down",
            "attitude.roll",
            "attitude.pitch",
            "velocity.x",
            "velocity.y",
            "velocity.z",
            "rate.x",
            "rate.y",
            "rate.z",
        ];
        assert_eq!(states[..9], rigid);
        assert_eq!(states[9..13], ["modal.q[1]", "modal.q[2]", "modal.q_dot[1]", "modal.q_dot[2]"]);
        assert_eq!(states[13], "inflow[1,1]");
        assert_eq!(states.len(), 13 + jet().strips.len());
        assert_eq!(model.states[11].unit, "kg^(1/2).m/s");
        let inputs = names(&model.inputs);
        let expected = ["elevator", "aileron", "aileron_symmetric", "rudder", "thrust_left", "thrust_right"];
        assert_eq!(inputs[..6], expected);
        assert_eq!(inputs[6..], ["wind_north", "wind_east", "wind_down"]);
        let outputs = names(&model.outputs);
        for there in
            ["load_factor.z", "air.beta", "loads.wing_root_right.bending", "surface.elevator", "wind.down"]
        {
            assert!(outputs.iter().any(|name| name == there), "{there}");
        }
        for left_out in ["sensor.rate.y", "trim.pitch", "actuator.elevator.rate", "gust.peak_velocity"] {
            assert!(outputs.iter().all(|name| name != left_out), "{left_out}");
        }
        let steady = linearised(&small(), Inflow::Steady);
        assert_eq!(steady.states, model.states[..13]);
    }

    #[test]
    fn shapes_agree_and_trim_values_are_those_of_the_flight() {
        let model = linearised(&small(), Inflow::Kept);
        let [n, m, p] = [&model.states, &model.inputs, &model.outputs].map(Vec::len);
        assert_eq!([model.a.shape(), model.b.shape(), model.bd.shape()], [(n, n), (n, m), (n, m)]);
        assert_eq!([model.c.shape(), model.d.shape(), model.dd.shape()], [(p, n), (p, m), (p, m)]);
        assert_eq!([model.x0.len(), model.u0.len(), model.y0.len()], [n, m, p]);
        let mut flight = Simulation::new(Arc::new(jet().clone()), &small(), 0.0).unwrap();
        let (table, instant) = (VariableTable::new(jet()), flight.instant_with_loads());
        for (name, value) in model.outputs.iter().zip(&model.y0) {
            let Some(Slot::Output(slot)) = table.named(&name.name).map(|row| row.slot) else {
                panic!("{name:?} is no output");
            };
            let expected = slot.number(instant);
            assert!(
                (value - expected).abs() <= 1e-8 * (1.0 + expected.abs()),
                "{name:?}: {value}, {expected}"
            );
        }
        assert!((model.u0[0] - flight.trim().pitch_control).abs() < 1e-12 && model.u0[4] > 1e4);
        // A state that is an output is its own.
        let [row, column] = [place(&model.outputs, "attitude.pitch"), place(&model.states, "attitude.pitch")];
        assert!(
            (model.c[(row, column)] - 1.0).abs() < 1e-9 && (model.y0[row] - model.x0[column]).abs() < 1e-12
        );
    }

    #[test]
    fn only_the_air_acts_by_its_rate() {
        let mut rigid = small();
        rigid.plant.fidelity = Fidelity::Rigid;
        let model = linearised(&rigid, Inflow::Kept);
        let down = place(&model.inputs, "wind_down");
        for column in 0..down {
            let acts = model.bd.column(column).amax().max(model.dd.column(column).amax()) > 0.0;
            assert_eq!(acts, column >= place(&model.inputs, "wind_north"), "{}", model.inputs[column].name);
        }
        // The apparent mass that air drags along is a few thousandths of the jet's.
        let falls = model.bd[(place(&model.states, "velocity.z"), down)];
        assert!((1e-4..0.1).contains(&falls), "{falls}");
    }

    #[test]
    fn a_model_on_another_heading_is_the_same_turned_by_it_without_jumps_of_its_angles() {
        let north = linearised(&small(), Inflow::Steady);
        let mut settings = small();
        settings.plant.heading = std::f64::consts::PI;
        let south = linearised(&settings, Inflow::Steady);
        assert!((&north.a - &south.a).amax() < 1e-9 * north.a.amax());
        for name in ["load_factor.z", "air.alpha", "air.speed"] {
            let row = place(&north.outputs, name);
            for (wind, sense) in [("wind_north", -1.0), ("wind_east", -1.0), ("wind_down", 1.0)] {
                let column = place(&north.inputs, wind);
                let [one, other] = [&north, &south].map(|model| model.d[(row, column)]);
                assert!((one - sense * other).abs() < 1e-9, "{name}, {wind}: {one}, {other}");
            }
        }
        for name in ["attitude.yaw", "path.track"] {
            let row = place(&north.outputs, name);
            let difference = (north.c.row(row) - south.c.row(row)).amax();
            assert!(difference < 1e-8, "{name}: {difference:e}");
        }
    }

    /// On a heading between the quarters, so that north and east are neither ahead nor aside.
    #[test]
    fn inputs_act_at_once_as_they_do_in_flight() {
        let mut settings = small();
        settings.plant.heading = 0.7;
        let model = linearised(&settings, Inflow::Kept);
        let (table, still) = (VariableTable::new(jet()), Inputs::zero(jet()));
        let slot_of = |name: &str| table.named(name).unwrap().slot;
        let flight = Simulation::new(Arc::new(jet().clone()), &settings, 0.0).unwrap();
        let cases = [
            ("elevator", "elevator", &model.d, 1e-3),
            ("thrust_right", "thrust_right", &model.d, 100.0),
            ("wind_north", "wind_north", &model.d, 0.1),
            ("wind_east", "wind_east", &model.d, 0.1),
            ("wind_rate_east", "wind_east", &model.dd, 0.1),
            ("wind_rate_down", "wind_down", &model.dd, 0.1),
        ];
        for (variable, input, matrix, change) in cases {
            let Slot::Input(slot) = slot_of(variable) else { panic!("{variable} is no input") };
            let [less, more] = [-change, change].map(|change| {
                let mut inputs = still.clone();
                *slot.of(&mut inputs) = change;
                flight.instant_with_loads_under(&inputs, &still)
            });
            for (row, name) in model.outputs.iter().enumerate() {
                let Slot::Output(slot) = slot_of(&name.name) else { panic!("{name:?} is no output") };
                let expected = (slot.number(&more) - slot.number(&less)) / (2.0 * change);
                let found = matrix[(row, place(&model.inputs, input))];
                // A newton does little: what 10 kN do is compared.
                let usual = if input.starts_with("thrust") { 1e4 } else { 1.0 };
                let close = usual * (found - expected).abs() <= 1e-5 * (1.0 + usual * expected.abs());
                assert!(close, "{variable}, {name:?}: {found}, {expected}");
            }
        }
    }

    #[test]
    fn what_lags_stands_between_the_input_and_what_acts() {
        let mut settings = small();
        settings.actuators.set(0, Actuator { frequency: 40.0, damping: 0.7, ..settings.actuators.get(0) });
        settings.engines.set(1, EngineLag { time_constant: 0.5, ..settings.engines.get(1) });
        let direct = linearised(&small(), Inflow::Steady);
        let lagging = linearised(&settings, Inflow::Steady);
        let added: Vec<_> = lagging.states[13..].iter().map(|name| name.name.as_str()).collect();
        assert_eq!(
            added,
            ["actuator.elevator.position", "actuator.elevator.rate", "engine.right.lagged_thrust"]
        );
        let [elevator, right] = [0, 5];
        assert_eq!(lagging.a.view((0, 13), (13, 1)), direct.b.column(elevator));
        assert_eq!(lagging.a.view((0, 15), (13, 1)), direct.b.column(right));
        assert_eq!((lagging.b[(14, elevator)], lagging.b[(15, right)]), (1600.0, 2.0));
        assert_eq!((lagging.a[(14, 13)], lagging.a[(14, 14)], lagging.a[(15, 15)]), (-1600.0, -56.0, -2.0));
        let row = place(&lagging.outputs, "actuator.elevator.rate");
        assert_eq!((lagging.c[(row, 14)], lagging.c.row(row).amax()), (1.0, 1.0));
        let row = place(&lagging.outputs, "surface.elevator");
        assert!((lagging.c[(row, 13)] - 1.0).abs() < 1e-12 && lagging.d.row(row).amax() == 0.0);
        assert_eq!([lagging.x0[13], lagging.x0[15]], [lagging.u0[elevator], lagging.u0[right]]);
        for (inflow, extra) in [(Inflow::Steady, 0), (Inflow::Kept, jet().strips.len())] {
            let count = LinearModel::state_count(jet(), &settings, inflow).unwrap();
            assert_eq!(count, lagging.states.len() + extra);
        }
    }

    #[test]
    fn what_no_flight_could_begin_with_is_refused() {
        let mut settings = small();
        settings.plant.airspeed = -1.0;
        let refused = LinearModel::new(jet().clone(), &settings, Inflow::Kept).unwrap_err().to_string();
        assert!(refused.starts_with("airspeed: found -1"), "{refused}");
        let mut settings = small();
        settings.actuators.set(0, Actuator { minimum: -0.1, ..settings.actuators.get(0) });
        let refused = LinearModel::new(jet().clone(), &settings, Inflow::Kept).unwrap_err();
        assert!(matches!(refused, SimulationError::BeyondLimit { .. }), "{refused}");
    }
}
