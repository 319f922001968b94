//! All numbers of modes side by side: the quantities that they are compared by, and what is said of them.
//!
//! Changes are shares of a scale, for an angle near zero has no share of its own: angles of the greatest trim angle, deflections of
//! the greatest one, both with the most modes; thrust, airspeeds and roots of themselves.

use flexible_aircraft::aircraft::{Support, TrimRole};
use flexible_aircraft::plant::{Deflection, TrimPoint};
use flexible_aircraft::stability::Complex;
use flexible_aircraft::structure::{ReducedModel, ReducedStation};

use super::quantity::{Kind, Quantity, Value};
use super::row::{Row, Trimmed};
use super::verdict::{Verdict, moved};

/// Angles are measured by this at least, rad.
const LEAST_ANGLE: f64 = 0.01;

/// Deflections are measured by this share of the aircraft's size at least.
const LEAST_DEFLECTION: f64 = 1e-4;

/// Angles that are nowhere greater are left out: they hold nothing. In rad.
const HOLDS: f64 = 5e-6;

/// Stations nearer to the plane of symmetry have no inboard, as a share of the aircraft's size.
const IN_PLANE: f64 = 1e-9;

/// Deflections that differ by this share of their scale are equal.
const ROUNDING: f64 = 1e-9;

/// Roots that are listed.
const ROOTS: usize = 4;

/// All numbers of modes side by side.
pub struct Study {
    /// By ascending number of modes; one at least.
    pub rows: Vec<Row>,
    /// Airspeed of the trims, m/s.
    pub airspeed: f64,
    pub quantities: Vec<Quantity>,
    pub verdict: Verdict,
}

impl Study {
    /// Of what came out with ascending numbers of modes; `has_no_more` tells whether the last has all modes there are.
    pub fn new(rows: Vec<Row>, airspeed: f64, has_no_more: impl FnOnce() -> bool) -> Self {
        let quantities = quantities(&rows);
        let verdict = Verdict::of(&quantities, rows.len(), has_no_more);
        Study { rows, airspeed, quantities, verdict }
    }

    /// Each number of modes for people.
    pub fn labels(&self) -> Vec<String> {
        self.rows.iter().map(Row::label).collect()
    }

    /// The row with the most modes.
    pub fn last(&self) -> Option<&Row> {
        self.rows.last()
    }

    /// Whether load modes stand beside the natural ones.
    pub fn has_load_modes(&self) -> bool {
        self.last().is_some_and(|row| row.loads > 0)
    }

    /// The quantities without those that are the mirror image of another one.
    pub fn distinct(&self) -> Vec<Quantity> {
        distinct(&self.quantities)
    }

    /// A line for each quantity that the last step moved, and for a last trim that nobody could fly.
    pub fn warnings(&self) -> Vec<String> {
        let trim = self.last().and_then(|row| row.trim.as_ref().ok());
        let odd = trim.and_then(|trim| trim.warning.clone());
        odd.into_iter().chain(moved(&self.distinct(), &self.labels())).collect()
    }
}

/// The quantities without those that are the mirror image of another one: they have its name beside their own.
fn distinct(quantities: &[Quantity]) -> Vec<Quantity> {
    let mut distinct: Vec<Quantity> = Vec::new();
    for quantity in quantities {
        let is_image = |other: &&mut Quantity| is_image(quantity, other);
        match distinct.iter_mut().find(is_image) {
            Some(other) => other.name = format!("{}, {}", first_word(&quantity.name), other.name),
            None => distinct.push(quantity.clone()),
        }
    }
    distinct
}

fn first_word(name: &str) -> &str {
    name.split(' ').next().unwrap_or_default()
}

/// Whether two deflections in one direction are equal with every number of modes, up to rounding.
fn is_image(one: &Quantity, other: &Quantity) -> bool {
    let direction = |quantity: &Quantity| quantity.name.rsplit(' ').next().map(str::to_owned);
    let rounding = ROUNDING * one.scale;
    let is_near = |(one, other): (&Value, &Value)| match (one.number(), other.number()) {
        (Some(one), Some(other)) => (one - other).abs() <= rounding,
        _ => one == other,
    };
    one.kind == Some(Kind::Deflection)
        && other.kind == one.kind
        && direction(one) == direction(other)
        && one.values.iter().zip(&other.values).all(is_near)
}

fn quantities(rows: &[Row]) -> Vec<Quantity> {
    let Some(model) = rows.last().map(|row| &row.analysis.model) else { return Vec::new() };
    let mut quantities = trims(rows, model);
    quantities.extend(deflections(rows, model));
    quantities.extend(critical_speeds(rows));
    quantities.extend(roots(rows));
    quantities
}

/// A number of every trim.
fn of_trims(rows: &[Row], number: impl Fn(&Trimmed) -> f64) -> Vec<Value> {
    let value = |row: &Row| match &row.trim {
        Ok(trim) => Value::Number(number(trim)),
        Err(_) => Value::Unknown("no trim"),
    };
    rows.iter().map(value).collect()
}

/// The greatest modulus of some values, `least` if there is none.
fn greatest(values: &[Value], least: f64) -> f64 {
    values.iter().filter_map(Value::number).fold(least, |greatest, number| greatest.max(number.abs()))
}

/// Gives some quantities one scale, the greatest of their values with the most modes.
fn measure(quantities: &mut [Quantity], least: f64) {
    let lasts: Vec<Value> =
        quantities.iter().filter_map(|quantity| quantity.values.last().cloned()).collect();
    let scale = greatest(&lasts, least);
    quantities.iter_mut().for_each(|quantity| quantity.scale = scale);
}

fn trims(rows: &[Row], model: &ReducedModel) -> Vec<Quantity> {
    if model.support == Support::Clamped {
        return Vec::new();
    }
    let quantity = |(name, angle): (String, Angle)| Quantity {
        kind: Some(Kind::Trim),
        name,
        unit: "rad",
        places: 5,
        scale: 1.0,
        values: of_trims(rows, |trim| angle(&trim.point)),
    };
    let mut quantities: Vec<Quantity> = angles(model).into_iter().map(quantity).collect();
    measure(&mut quantities, LEAST_ANGLE);
    quantities.retain(|quantity| quantity.name == "pitch" || greatest(&quantity.values, 0.0) >= HOLDS);
    if !model.engines.is_empty() {
        let values = of_trims(rows, |trim| trim.point.thrust);
        let scale = greatest(&values[values.len() - 1..], f64::MIN_POSITIVE);
        let name = "thrust per engine".to_owned();
        quantities.push(Quantity { kind: Some(Kind::Trim), name, unit: "N", places: 0, scale, values });
    }
    quantities
}

/// An angle of a trim, rad.
type Angle = Box<dyn Fn(&TrimPoint) -> f64>;

/// The angles that a trim of a free aircraft has, by their names.
fn angles(model: &ReducedModel) -> Vec<(String, Angle)> {
    let mut angles: Vec<(String, Angle)> = vec![("pitch".to_owned(), Box::new(|point| point.pitch))];
    for role in [TrimRole::Pitch, TrimRole::Roll, TrimRole::Yaw] {
        if let Some(control) = model.control_for(role) {
            let name = model.controls[control].name.clone();
            angles.push((name, Box::new(move |point| point.control(role))));
        }
    }
    angles.push(("bank angle".to_owned(), Box::new(|point| point.roll)));
    angles.push(("sideslip".to_owned(), Box::new(|point| point.sideslip)));
    if model.engines.is_empty() {
        angles.push(("climb angle".to_owned(), Box::new(|point| point.climb_angle)));
    }
    angles
}

/// Up and inboard of every station; where there is none, of the strip that moves most.
fn deflections(rows: &[Row], model: &ReducedModel) -> Vec<Quantity> {
    let places = model.stations.iter().map(|station| station.position.norm());
    let strips = model.strips.iter().map(|strip| strip.position.norm());
    let size = places.chain(strips).fold(0.0, f64::max);
    let quantity = |name: String, values: Vec<Value>| Quantity {
        kind: Some(Kind::Deflection),
        name,
        unit: "m",
        places: 4,
        scale: 1.0,
        values,
    };
    let mut quantities = Vec::new();
    for (place, station) in model.stations.iter().enumerate() {
        for (direction, number) in directions(station, size) {
            let values = of_trims(rows, |trim| number(&trim.outputs.deflections[place]));
            quantities.push(quantity(format!("{} {direction}", station.name), values));
        }
    }
    if quantities.is_empty() {
        quantities.push(quantity("farthest strip".to_owned(), of_trims(rows, |trim| trim.farthest)));
    }
    measure(&mut quantities, LEAST_DEFLECTION * size);
    quantities
}

type Direction = (&'static str, Box<dyn Fn(&Deflection) -> f64>);

/// What is read of the displacement of a station of an aircraft of a size, m.
fn directions(station: &ReducedStation, size: f64) -> Vec<Direction> {
    let side = station.position.y;
    let mut directions: Vec<Direction> = vec![("up", Box::new(|deflection| -deflection.displacement.z))];
    if side.abs() > IN_PLANE * size {
        directions.push(("inboard", Box::new(move |deflection| -side.signum() * deflection.displacement.y)));
    }
    directions
}

fn critical_speeds(rows: &[Row]) -> Vec<Quantity> {
    let quantity = |kind, name: &str, unit, values: Vec<Value>| {
        let scale = greatest(&values[values.len() - 1..], f64::MIN_POSITIVE);
        Quantity { kind, name: name.to_owned(), unit, places: 2, scale, values }
    };
    let speed = Some(Kind::Critical);
    let flutter = rows.iter().map(|row| row.flutter.airspeed.clone()).collect();
    let frequency = |row: &Row| row.flutter.frequency.map_or(Value::Outside(String::new()), Value::Number);
    let divergence = rows.iter().map(|row| row.divergence.airspeed.clone()).collect();
    vec![
        quantity(speed, "flutter", "m/s", flutter),
        quantity(None, "flutter frequency", "rad/s", rows.iter().map(frequency).collect()),
        quantity(speed, "divergence", "m/s", divergence),
    ]
}

/// The slowest oscillations with the most modes, and those of the other rows that are nearest to them.
fn roots(rows: &[Row]) -> Vec<Quantity> {
    let listed = rows.last().map_or(0, |row| row.roots.len().min(ROOTS));
    let mut values: Vec<Vec<Value>> = vec![Vec::new(); listed];
    for row in rows {
        let mut left = row.roots.clone();
        let wanted =
            rows.last().iter().flat_map(|last| last.roots.iter().take(listed).copied()).collect::<Vec<_>>();
        for (values, wanted) in values.iter_mut().zip(wanted) {
            values.push(nearest(&mut left, wanted).map_or(Value::Unknown("none"), Value::Root));
        }
    }
    let quantity = |(place, values): (usize, Vec<Value>)| Quantity {
        kind: Some(Kind::Root),
        name: format!("root {}", place + 1),
        unit: "1/s",
        places: 4,
        scale: 1.0,
        values,
    };
    values.into_iter().enumerate().map(quantity).collect()
}

/// Takes out the root that is nearest to one.
fn nearest(roots: &mut Vec<Complex<f64>>, to: Complex<f64>) -> Option<Complex<f64>> {
    let distances = roots.iter().map(|root| (root - to).norm()).enumerate();
    let (place, _) = distances.min_by(|a, b| a.1.total_cmp(&b.1))?;
    Some(roots.remove(place))
}
