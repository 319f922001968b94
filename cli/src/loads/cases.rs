//! What is flown: one flight, or one for each gust of a set.

use std::sync::Arc;

use clap::Args;
use flexible_aircraft::air::{GustSettings, GustShape};
use flexible_aircraft::equations::SectionLoads;
use flexible_aircraft::flight::{Inputs, Settings, Simulation, SimulationError};
use flexible_aircraft::structure::ReducedModel;

use crate::numbers::Plain;
use crate::progress::Progress;
use crate::simulate::schedule::Schedule;

/// Options that say into which gusts the aircraft flies.
#[derive(Args)]
pub struct GustOptions {
    /// Fly into a 1-cosine gust with this gradient (half its length), m. May be repeated or a list, as in 15,30,60,107: then
    /// each is flown, and the envelope is that of all
    #[arg(long, value_name = "M", value_delimiter = ',', value_parser = positive)]
    gradient: Vec<f64>,

    /// Its peak, m/s of true airspeed
    #[arg(long, value_name = "M/S", default_value_t = GustSettings::default().peak, requires = "gradient")]
    gust_peak: f64,

    /// Its direction: 0 is upwards, 90 to the right, 180 downwards, degrees. May be repeated or a list: each is flown
    #[arg(long, value_name = "DEG", value_delimiter = ',', default_value = "0", requires = "gradient")]
    gust_direction: Vec<f64>,

    /// When the nose meets it, s after the beginning
    #[arg(long, value_name = "SECONDS", default_value_t = 0.5, requires = "gradient")]
    gust_start: f64,
}

fn positive(text: &str) -> Result<f64, String> {
    let number = text.trim().parse().ok().filter(|number: &f64| number.is_finite() && *number > 0.0);
    number.ok_or_else(|| "allowed is a number of metres, greater than 0".to_owned())
}

/// A flight.
pub struct Case {
    /// For people.
    pub name: String,
    pub settings: Settings,
}

impl GustOptions {
    /// All flights.
    pub fn cases(&self, settings: &Settings) -> Vec<Case> {
        if self.gradient.is_empty() {
            return vec![Case { name: "flight".to_owned(), settings: settings.clone() }];
        }
        let directions = self.gust_direction.iter();
        let gusts =
            directions.flat_map(|direction| self.gradient.iter().map(|gradient| (*gradient, *direction)));
        gusts.map(|(gradient, direction)| self.case(settings, gradient, direction)).collect()
    }

    fn case(&self, settings: &Settings, gradient: f64, direction: f64) -> Case {
        let way = match direction {
            0.0 => "up".to_owned(),
            90.0 => "right".to_owned(),
            180.0 => "down".to_owned(),
            -90.0 | 270.0 => "left".to_owned(),
            other => format!("{} deg", Plain(other)),
        };
        let gust = GustSettings {
            shape: GustShape::OneMinusCosine,
            gradient,
            peak: self.gust_peak,
            direction: direction.to_radians(),
            start: self.gust_start,
            ..settings.gust
        };
        let name = format!("gust {} m {way}", Plain(gradient));
        Case { name, settings: Settings { gust, ..settings.clone() } }
    }
}

/// Has somebody look at the loads at the points of a flight.
pub fn fly(
    model: &Arc<ReducedModel>,
    settings: &Settings,
    (schedule, step): (&Schedule, f64),
    progress: &Progress,
    mut look: impl FnMut(f64, &[SectionLoads]),
) -> Result<(), SimulationError> {
    let mut simulation = Simulation::new(Arc::clone(model), settings, schedule.start())?;
    let [mut inputs, mut rates] = [Inputs::zero(model), Inputs::zero(model)];
    schedule.write(0, &mut inputs, &mut rates);
    simulation.set_inputs(&inputs, &rates);
    for point in schedule.points(Some(step)) {
        simulation.advance_to(point.time)?;
        if let Some(loads) = simulation.instant_with_loads().outputs.loads.known() {
            look(point.time, loads);
        }
        if let Some(row) = point.row {
            simulation.write_inputs(&mut inputs);
            schedule.write(row, &mut inputs, &mut rates);
            simulation.set_inputs(&inputs, &rates);
        }
        progress.advance();
    }
    Ok(())
}
