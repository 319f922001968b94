//! Tables of trims: for people, as comma-separated values, as JSON.

use flexible_aircraft::aircraft::{Support, TrimRole};
use flexible_aircraft::flight::Settings;
use flexible_aircraft::plant::{PlantSettings, TrimPoint};
use flexible_aircraft::structure::ReducedModel;
use serde_json::json;

use super::points::{Point, Status};
use crate::answer::Answer;
use crate::flown::level;
use crate::numbers::{Plain, aligned, fixed};

/// Of a trim at a point, if it has one.
type Value = Box<dyn Fn(&Point, &TrimPoint) -> Option<f64>>;

/// A column: its name, its unit, and its value in a trim.
struct Column {
    name: String,
    unit: &'static str,
    /// Places for people.
    places: usize,
    value: Value,
}

impl Column {
    /// None where there is no trim, or nothing of the kind in it.
    fn of(&self, point: &Point) -> Option<f64> {
        (self.value)(point, point.trim.as_ref()?)
    }
}

/// Of what a trim of an aircraft consists.
fn columns(model: &ReducedModel) -> Vec<Column> {
    let column = |name: &str, unit, places, value: fn(&TrimPoint) -> f64| Column {
        name: name.to_owned(),
        unit,
        places,
        value: Box::new(move |_, trim| Some(value(trim))),
    };
    let mut columns = vec![
        column("pitch", "rad", 5, |trim| trim.pitch),
        column("alpha", "rad", 5, TrimPoint::angle_of_attack),
        column("roll", "rad", 5, |trim| trim.roll),
        column("beta", "rad", 5, |trim| trim.sideslip),
        column("climb_angle", "rad", 5, |trim| trim.climb_angle),
    ];
    for role in [TrimRole::Pitch, TrimRole::Roll, TrimRole::Yaw] {
        let control = model.control_for(role).map(|control| &model.controls[control]);
        columns.extend(control.map(|control| Column {
            name: control.name.clone(),
            unit: "rad",
            places: 5,
            value: Box::new(move |_, trim| Some(trim.control(role))),
        }));
    }
    if !model.engines.is_empty() {
        columns.push(column("thrust_per_engine", "N", 1, |trim| trim.thrust));
        columns.push(Column {
            name: "thrust".to_owned(),
            unit: "N",
            places: 1,
            value: Box::new(|point, _| Some(point.total_thrust)),
        });
    }
    columns.extend([
        column("turn_rate", "rad/s", 5, |trim| trim.turn_rate),
        column("pitch_rate", "rad/s", 5, |trim| trim.pitch_rate),
        column("load_factor", "1", 4, |trim| trim.load_factor),
    ]);
    columns.push(Column {
        name: "static_margin".to_owned(),
        unit: "1",
        places: 4,
        value: Box::new(|point, _| point.static_margin),
    });
    columns
}

/// Speed, altitude and the load factor that is asked for: the axes of a table.
fn axes(point: &Point) -> [(&'static str, &'static str, f64); 3] {
    let PlantSettings { airspeed, altitude, condition, .. } = point.settings;
    [
        ("airspeed", "m/s", airspeed),
        ("altitude", "m", altitude),
        ("condition.load_factor", "1", condition.load_factor),
    ]
}

/// What varies or is not 0, a line a point; then what stands though it is beyond a limit, and what could not be trimmed.
pub fn text(model: &ReducedModel, settings: &Settings, points: &[Point]) -> String {
    let flown = points.first().map_or(settings.plant.condition, |point| point.settings.condition);
    let manoeuvre = match model.support {
        Support::Free => flown.manoeuvre().name(!model.engines.is_empty()),
        Support::Clamped => "rest in the tunnel",
    };
    let day = match settings.plant.temperature_offset {
        0.0 => String::new(),
        offset => format!(", ISA {offset:+} K"),
    };
    let mut text = format!("{}: {manoeuvre}{day}, {}\n\n", model.name, level(settings));
    let columns = columns(model);
    let is_shown = |column: &&Column| {
        let values = points.iter().filter_map(|point| column.of(point));
        values.into_iter().any(|value| value.abs() >= 5e-6)
    };
    let shown: Vec<&Column> = columns.iter().filter(is_shown).collect();
    let factor = |point: &Point| point.settings.condition.load_factor;
    let has_factors = points.iter().any(|point| factor(point) != factor(&points[0]));
    let asked = has_factors.then(|| "load factor asked".to_owned());
    let heads = ["airspeed (m/s)", "altitude (m)"].map(str::to_owned).into_iter().chain(asked);
    let heads = heads.chain(shown.iter().map(|column| match column.unit {
        "1" => column.name.clone(),
        unit => format!("{} ({unit})", column.name),
    }));
    let mut lines: Vec<Vec<String>> = vec![heads.collect()];
    for point in points {
        let [airspeed, altitude, _] = axes(point).map(|(_, _, value)| Plain(value).to_string());
        let numbers = shown.iter().map(|column| match column.of(point) {
            Some(value) => fixed(value, column.places),
            None => "–".to_owned(),
        });
        let asked = has_factors.then(|| Plain(factor(point)).to_string());
        lines.push([airspeed, altitude].into_iter().chain(asked).chain(numbers).collect());
    }
    text += &aligned(&lines);
    for point in points {
        let [airspeed, altitude, _] = axes(point).map(|(_, _, value)| Plain(value));
        let place = match has_factors {
            true => format!("{airspeed} m/s, {altitude} m and a load factor of {}", Plain(factor(point))),
            false => format!("{airspeed} m/s and {altitude} m"),
        };
        for warning in &point.warnings {
            text += &format!("\nwarning: the trim at {place} stands, but {warning}");
        }
        if point.status != Status::Found {
            text += &format!("\n{}: {}", place, point.message);
        }
    }
    text.trim_end().to_owned() + "\n"
}

/// Every point, failed ones with empty cells, status and message.
pub fn csv(model: &ReducedModel, points: &[Point]) -> String {
    let columns = columns(model);
    let names = ["airspeed", "altitude", "condition.load_factor"].into_iter();
    let names = names.chain(columns.iter().map(|column| column.name.as_str()));
    let mut writer = csv::Writer::from_writer(Vec::new());
    let mut record: Vec<String> = names.map(str::to_owned).collect();
    record.extend(["status", "message", "warnings"].map(str::to_owned));
    // PROOF: a vector takes every record.
    let _ = writer.write_record(&record);
    for point in points {
        let mut record: Vec<String> =
            axes(point).into_iter().map(|(_, _, value)| Plain(value).to_string()).collect();
        let numbers = columns.iter().map(|column| column.of(point).map(|value| Plain(value).to_string()));
        record.extend(numbers.map(Option::unwrap_or_default));
        record.extend([point.status.name().to_owned(), point.message.clone(), point.warnings.join("; ")]);
        let _ = writer.write_record(&record);
    }
    String::from_utf8_lossy(&writer.into_inner().unwrap_or_default()).into_owned()
}

/// The same as arrays, with NaN where nothing is trimmed.
pub fn answer(model: &ReducedModel, points: &[Point]) -> Answer {
    let columns = columns(model);
    let axes_of = |axis: usize| points.iter().map(move |point| axes(point)[axis].2).collect();
    let of_axes = points.iter().take(1).flat_map(axes).enumerate();
    let of_axes = of_axes.map(|(axis, (name, unit, _))| (name.to_owned(), unit, axes_of(axis)));
    let of_trims = columns.iter().map(|Column { name, unit, value, .. }| {
        let number =
            |point: &Point| point.trim.as_ref().and_then(|trim| value(point, trim)).unwrap_or(f64::NAN);
        (name.clone(), *unit, points.iter().map(number).collect())
    });
    let (mut values, mut units) = (Vec::new(), Vec::new());
    for (name, unit, numbers) in of_axes.chain(of_trims) {
        values.push((name.clone(), Answer::Numbers(numbers)));
        units.push((name, Answer::Text(unit.to_owned())));
    }
    let texts = |text: fn(&Point) -> String| Answer::Texts(points.iter().map(text).collect());
    Answer::named([
        ("columns", Answer::Members(values)),
        ("units", Answer::Members(units)),
        ("status", texts(|point| point.status.name().to_owned())),
        ("messages", texts(|point| point.message.clone())),
        ("warnings", texts(|point| point.warnings.join("; "))),
    ])
}

/// The same with units.
pub fn json(model: &ReducedModel, points: &[Point]) -> String {
    let columns = columns(model);
    let units: serde_json::Map<String, serde_json::Value> = points
        .iter()
        .take(1)
        .flat_map(|point| axes(point).map(|(name, unit, _)| (name.to_owned(), json!(unit))))
        .chain(columns.iter().map(|column| (column.name.clone(), json!(column.unit))))
        .collect();
    let row = |point: &Point| {
        let mut row = serde_json::Map::new();
        for (name, _, value) in axes(point) {
            row.insert(name.to_owned(), json!(value));
        }
        for column in &columns {
            row.insert(column.name.clone(), json!(column.of(point)));
        }
        row.insert("status".to_owned(), json!(point.status.name()));
        row.insert("message".to_owned(), json!(point.message));
        row.insert("warnings".to_owned(), json!(point.warnings));
        serde_json::Value::Object(row)
    };
    let rows: Vec<serde_json::Value> = points.iter().map(row).collect();
    format!("{:#}\n", json!({ "aircraft": model.name, "units": units, "trims": rows }))
}
