//! The flight itself: stepped from one communication point to the next, a row of outputs at each.

use std::io::{self, Write};
use std::sync::Arc;

use flexible_aircraft::flight::{Settings, Simulation, SimulationError};
use flexible_aircraft::structure::ReducedModel;
use flexible_aircraft::variables::{OutputSlot, Slot, VariableTable};

use crate::flown::trimmed;
use crate::numbers::NumberTable;
use crate::progress::Progress;

use super::plot::Recorded;
use super::schedule::Schedule;

/// Why a flight did not reach the end of its schedule.
#[derive(Debug, thiserror::Error)]
pub enum Interruption {
    #[error(transparent)]
    Flight(#[from] SimulationError),
    #[error(transparent)]
    Sink(#[from] io::Error),
}

/// A flight that has not begun.
pub struct Flight<'s> {
    simulation: Simulation,
    model: Arc<ReducedModel>,
    schedule: &'s Schedule,
    names: Vec<&'s str>,
    slots: Vec<OutputSlot>,
}

impl<'s> Flight<'s> {
    /// Trims the aircraft at the start of the schedule.
    ///
    /// # Errors
    /// When it cannot be trimmed.
    pub fn new(
        model: Arc<ReducedModel>,
        settings: &Settings,
        schedule: &'s Schedule,
        variables: &'s VariableTable,
    ) -> Result<Self, SimulationError> {
        let (names, slots) = variables
            .iter()
            .filter_map(|(_, variable)| match variable.slot {
                Slot::Output(slot) => Some((variable.name.as_str(), slot)),
                _ => None,
            })
            .unzip();
        let simulation = trimmed(&model, settings, schedule.start())?;
        Ok(Flight { simulation, model, schedule, names, slots })
    }

    /// Flies, and writes the outputs at each communication point, as a master reads them at the end of the step that
    /// leads there; and records those that are to be drawn.
    ///
    /// # Errors
    /// When the flight has to end, or the table takes no rows.
    pub fn fly<W: Write>(
        &mut self,
        step: Option<f64>,
        table: &mut NumberTable<W>,
        mut recorded: Option<&mut Recorded>,
        progress: &Progress,
    ) -> Result<(), Interruption> {
        let Flight { simulation, model, schedule, slots, .. } = self;
        schedule.fly(simulation, model, step, |time, simulation| {
            // All outputs are written, section loads among them.
            let instant = simulation.instant_with_loads();
            if let Some(recorded) = &mut recorded {
                recorded.look(time, instant);
            }
            let values = slots.iter().map(|slot| slot.number(instant));
            table.row(std::iter::once(time).chain(values))?;
            progress.advance();
            Ok(())
        })
    }

    /// Flies, and keeps the outputs at each communication point, row after row.
    ///
    /// # Errors
    /// When the flight has to end.
    pub fn record(&mut self, step: Option<f64>, progress: &Progress) -> Result<Vec<f64>, SimulationError> {
        let Flight { simulation, model, schedule, slots, .. } = self;
        let mut values = Vec::new();
        schedule.fly(simulation, model, step, |time, simulation| {
            let instant = simulation.instant_with_loads();
            values.push(time);
            values.extend(slots.iter().map(|slot| slot.number(instant)));
            progress.advance();
            Ok::<(), SimulationError>(())
        })?;
        Ok(values)
    }

    /// The names of the columns.
    pub fn names(&self) -> impl Iterator<Item = &'s str> {
        std::iter::once("time").chain(self.names.clone())
    }
}

#[cfg(test)]
mod tests {
    use std::path::Path;

    use flexible_aircraft::aircraft::Aircraft;
    use flexible_aircraft::plant::PlantSettings;

    use super::*;

    /// The lines that a flight of the generic business jet writes, and how it ended.
    fn lines(inputs: &str, step: Option<f64>) -> (Vec<String>, Result<(), Interruption>) {
        let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../aircraft/generic-business-jet.toml");
        let model = Arc::new(ReducedModel::new(&Aircraft::read(&path).unwrap(), 4).unwrap());
        let variables = VariableTable::new(&model);
        let settings = Settings::from(PlantSettings { mode_count: 4, ..PlantSettings::of(&model) });
        let schedule = Schedule::parse(inputs.as_bytes(), &variables).unwrap();
        let mut flight = Flight::new(model, &settings, &schedule, &variables).unwrap();
        let mut table = NumberTable::new(Vec::new(), flight.names()).unwrap();
        let flown = flight.fly(step, &mut table, None, &Progress::hidden());
        let text = String::from_utf8(table.into_sink().unwrap()).unwrap();
        (text.lines().map(String::from).collect(), flown)
    }

    fn value(lines: &[String], name: &str, row: usize) -> f64 {
        let column = lines[0].split(',').position(|found| found == name).unwrap();
        lines[row + 1].split(',').nth(column).unwrap().parse().unwrap()
    }

    #[test]
    fn a_row_holds_the_outputs_at_the_end_of_the_step_that_leads_there() {
        let (lines, flown) = lines("time,elevator,der(elevator)\n0,0.01,0.2\n0.1,0.05,0\n0.2,0,0\n", None);
        flown.unwrap();
        assert_eq!(lines.len(), 4);
        let acting = |row| value(&lines, "surface.elevator", row) - value(&lines, "trim.elevator", 0);
        for (row, expected) in [(0, 0.01), (1, 0.03), (2, 0.05)] {
            assert!((acting(row) - expected).abs() < 1e-12, "{}", acting(row));
        }
        assert!(value(&lines, "rate.y", 2) < -1e-3);
    }

    /// The ramp goes on over the rows in between, and the rows of the table have the bits that they have without these.
    #[test]
    fn rows_between_those_of_the_table_change_no_bit_of_them() {
        let inputs = "time,elevator,der(elevator)\n0,0.01,0.2\n0.105,0.05,0\n0.2,0,0\n";
        let (few, flown) = lines(inputs, None);
        flown.unwrap();
        let (many, flown) = lines(inputs, Some(0.01));
        flown.unwrap();
        assert_eq!(many.len(), 1 + 20 + 2);
        assert_eq!((&few[1], &few[2], &few[3]), (&many[1], &many[12], &many[22]));
        let acting = value(&many, "surface.elevator", 5) - value(&many, "trim.elevator", 0);
        assert!((acting - 0.02).abs() < 1e-12, "{acting}");
    }

    #[test]
    fn a_flight_that_must_end_leaves_the_rows_up_to_there() {
        let (lines, flown) = lines("time,wind_north\n0,0\n0.01,400\n0.02,0\n", None);
        assert!(matches!(flown, Err(Interruption::Flight(SimulationError::ReverseFlow { .. }))), "{flown:?}");
        assert_eq!(lines.len(), 3);
    }

    #[test]
    fn a_gust_by_wind_rate_is_one_by_its_derivative_and_goes_on_where_only_its_rate_is_given() {
        let [by_rate, by_derivative] = ["wind_rate_down", "der(wind_down)"].map(|rate| {
            let (lines, flown) =
                lines(&format!("time,wind_down,{rate}\n0,0,-5\n0.1,-0.5,2\n0.2,-0.3,0\n"), None);
            flown.unwrap();
            lines
        });
        assert!(by_rate == by_derivative);
        let (rate_alone, flown) = lines("time,wind_rate_down\n0,-5\n0.1,2\n0.2,0\n", None);
        flown.unwrap();
        for row in 0..3 {
            let [alone, with] =
                [&rate_alone, &by_rate].map(|lines| value(lines, "deflection.wing_tip_right.up", row));
            assert!((alone - with).abs() < 1e-12 * with, "{row}: {alone} {with}");
        }
        let rise = |lines: &[String]| value(lines, "air.alpha", 1) - value(lines, "air.alpha", 0);
        assert!(rise(&rate_alone) > 0.5 / 127.0 / 2.0, "{}", rise(&rate_alone));
    }
}
