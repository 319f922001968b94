//! From the TOML document to the [`schema`](super::schema): which fields there are and what they may hold.

use nalgebra::Vector3;
use toml::de::DeTable;

use super::allowed::{
    AIRSPEED, ALTITUDE, ANGLE_DEG, ANY, Allowed, BEAM_STIFFNESS, CHORDS, DRAG, FLAP_LIFT_SLOPE, FRACTION,
    GAIN, GRAVITY, GYRATION, INERTIA, INERTIA_PRODUCT, INSIDE_THE_CHORD, LENGTH, LIFT_SLOPE, MASS, MOMENT,
    NEAR_THE_CHORD, POSITIVE_LENGTH, SHARE,
};
use super::control_tables::read_controls;
use super::cut_tables::read_cuts;
use super::document::{Located, Table, Value};
use super::error::{Place, Problem, Report};
use super::law::Law;
use super::limit_tables::read_limits;
use super::model::{ModeBasis, Support};
use super::model_tables;
use super::reference::read_reference;
use super::schema::{
    Along, ComponentSpec, DistributedMassSpec, EngineSpec, FileSpec, FlapSpec, Hand, InertiaSpec,
    MassPartSpec, MoveSpec, ParentSpec, PointMassesSpec, STIFFNESS, StationSpec, SurfaceSpec,
};
use super::stretch::Stretch;
use super::tunnel;

const FILE: &[&str] = &[
    "format",
    "name",
    "gravity_m_s2",
    "support",
    "mode_basis",
    "model",
    "inflow_states",
    "airspeed_m_s",
    "altitude_m",
    "density_kg_m3",
    "temperature_K",
    "mount_attitude_deg",
    "symmetric",
    "basis",
    "reference",
    "limits",
    "control",
    "component",
    "engine",
    "station",
    "cut",
];
const COMPONENT: &[&str] = &[
    "name",
    "mirror",
    "attached_to",
    "axis_m",
    "elements",
    "y_axis",
    "EA_N",
    "GJ_N_m2",
    "EI_y_N_m2",
    "EI_z_N_m2",
    "chord_m",
    "distributed_mass",
    "point_masses",
    "surface",
];
const DISTRIBUTED_MASS: &[&str] =
    &["parts", "offset_chords", "offset_m", "gyration_chords", "gyration_lengths", "added_inertia_kg_m2"];
const POINT_MASSES: &[&str] = &[
    "at_m",
    "at",
    "mass_kg",
    "total_kg",
    "shares",
    "shares_of",
    "offset_m",
    "gyration_m",
    "inertia_kg_m2",
    "products_kg_m2",
];
const SURFACE: &[&str] = &[
    "position_in_element",
    "from",
    "to",
    "elastic_axis",
    "chord_m",
    "span_axis",
    "incidence_deg",
    "width_m",
    "lift_slope_per_rad",
    "zero_lift_offset_deg",
    "zero_lift_moment",
    "profile_drag",
    "leading_edge_suction",
    "flap",
    "control",
];
const MOVE: &[&str] = &["input", "gain", "from", "to", "side"];
const ENGINE: &[&str] = &["name", "component", "at_m", "at", "offset_m", "direction"];
const STATION: &[&str] = &["name", "component", "at_m", "at"];

/// Reads the whole document; what could not be read is complained about, and left out: the rest may have mistakes too.
pub(super) fn read_file(document: &DeTable, report: &Report) -> Option<FileSpec> {
    let table = Table::new(document, Place { span: 0..0, field: String::new() }, FILE, report);
    let supports = [("free", Support::Free), ("clamped", Support::Clamped)];
    let bases = [("bending_torsion", ModeBasis::BendingTorsion), ("full", ModeBasis::Full)];
    table.required("format").and_then(|v| v.integer(1..2));
    let name = table.required("name").and_then(|v| v.text());
    let tunnel_air = tunnel::read_air(&table);
    let support = table.required("support").and_then(|v| v.located(|v| v.one_of(&supports)));
    let mode_basis = table.required("mode_basis").and_then(|v| v.one_of(&bases));
    let (controls, has_all_controls) = read_controls(&table);
    let (limits, former_limits) = read_limits(&table);
    table.required("component");
    let components = table.tables("component", COMPONENT);
    let components: Vec<_> = components.iter().map(read_component).collect();
    let engines: Vec<_> = table.tables("engine", ENGINE).iter().map(read_engine).collect();
    let stations: Vec<_> = table.tables("station", STATION).iter().map(read_station).collect();
    Some(FileSpec {
        gravity: table.number_or("gravity_m_s2", &GRAVITY, 9.80665),
        inflow_states: model_tables::read_inflow_states(&table),
        airspeed: table
            .optional("airspeed_m_s")
            .and_then(|v| v.located(|v| v.number(&AIRSPEED)))
            .unwrap_or(Located { value: 127.0, place: table.place.clone() }),
        altitude: if tunnel_air.is_some() { 0.0 } else { table.number_or("altitude_m", &ALTITUDE, 7620.0) },
        tunnel_air,
        mount: table.optional("mount_attitude_deg").and_then(|v| v.located(tunnel::read_mount)),
        load_modes: model_tables::read_load_modes(&table),
        fidelity: model_tables::read_fidelity(&table),
        symmetric: table.optional("symmetric").and_then(|v| v.flag()).unwrap_or(false),
        reference: read_reference(&table),
        limits,
        former_limits,
        name: name?,
        support: support?,
        mode_basis: mode_basis?,
        controls,
        has_all_controls,
        components: components.into_iter().flatten().collect(),
        engines: engines.into_iter().flatten().collect(),
        stations: stations.into_iter().flatten().collect(),
        cuts: read_cuts(&table),
    })
}

fn vector_or_zero(table: &Table, field: &str, allowed: &Allowed) -> Vector3<f64> {
    table.optional(field).and_then(|v| v.vector(allowed)).unwrap_or_default()
}

/// `from` and `to`, fractions of the component's length, by default all of it.
fn read_stretch(table: &Table) -> Stretch {
    let (from, to) = (table.number_or("from", &FRACTION, 0.0), table.number_or("to", &FRACTION, 1.0));
    if to <= from {
        let found = format!("found from = {from} and to = {to}");
        table.report.add(Problem::OutOfRange, &table.place.within("to"), found, "to > from is allowed");
    }
    Stretch { from, to }
}

fn read_along(table: &Table) -> Option<Along> {
    let (field, value) = table.either(&["at_m", "at"])?;
    let places = value.one_or_more_numbers(&ANY)?;
    Some(if field == "at_m" { Along::Metres(places) } else { Along::Fractions(places) })
}

fn read_name(table: &Table, field: &str) -> Option<Located<String>> {
    table.required(field)?.located(Value::name)
}

fn read_component(table: &Table) -> Option<ComponentSpec> {
    let name = read_name(table, "name");
    let parent = table.required("attached_to").and_then(|v| read_parent(&v));
    let axis = table.required("axis_m").and_then(|v| v.located(read_corners));
    let segments = axis.as_ref().map(|axis| axis.value.len() - 1);
    let elements = table.required("elements").and_then(|v| read_elements(&v, segments?));
    let y_axis = table.required("y_axis").and_then(|v| v.located(Value::direction));
    let stiffness =
        STIFFNESS.map(|f| Some((f, table.required(f).and_then(|v| Law::read(&v, &BEAM_STIFFNESS))?)));
    let chord = table.optional("chord_m").and_then(|v| Law::read(&v, &POSITIVE_LENGTH));
    let distributed: Vec<_> =
        table.tables("distributed_mass", DISTRIBUTED_MASS).iter().map(read_distributed_mass).collect();
    let points: Vec<_> = table.tables("point_masses", POINT_MASSES).iter().map(read_point_masses).collect();
    let surfaces: Vec<_> = table.tables("surface", SURFACE).iter().map(read_surface).collect();
    Some(ComponentSpec {
        mirror: table.optional("mirror").and_then(|v| v.located(Value::name)),
        name: name?,
        parent: parent?,
        axis: axis?,
        elements: elements?,
        y_axis: y_axis?,
        stiffness: stiffness.into_iter().collect::<Option<_>>()?,
        chord,
        distributed_masses: distributed.into_iter().collect::<Option<_>>()?,
        point_masses: points.into_iter().collect::<Option<_>>()?,
        surfaces: surfaces.into_iter().flatten().collect(),
    })
}

fn read_parent(value: &Value) -> Option<ParentSpec> {
    if !value.has_field("component") {
        return value.one_of(&[("origin", ())]).map(|()| ParentSpec::Origin);
    }
    let table = value.table(&["component", "at"])?;
    let name = read_name(&table, "component");
    let at = table.required("at").and_then(|v| v.located(|v| v.number(&FRACTION)));
    Some(ParentSpec::Component { name: name?, at: at? })
}

fn read_corners(value: &Value) -> Option<Vec<Vector3<f64>>> {
    let what = "a list of at least two points [x, y, z]";
    let points = value.list(what)?;
    if points.len() < 2 {
        return value.wrong(what);
    }
    let points: Vec<_> = points.iter().map(|point| point.vector(&LENGTH)).collect();
    points.into_iter().collect()
}

/// More elements than this are a slip of the pen, and would only run out of memory.
const MOST_ELEMENTS: usize = 1000;

fn read_elements(value: &Value, segments: usize) -> Option<Vec<usize>> {
    let read = |value: &Value| value.integer(1..MOST_ELEMENTS + 1);
    if value.is_number() {
        let all = read(value)?;
        return if segments == 1 { Some(vec![all]) } else { value.wrong(&one_per_segment(segments)) };
    }
    let list = value.list("a whole number, or a list with one for each segment of axis_m,")?;
    if list.len() != segments {
        return value.wrong(&one_per_segment(segments));
    }
    let numbers: Vec<_> = list.iter().map(read).collect();
    numbers.into_iter().collect()
}

fn one_per_segment(segments: usize) -> String {
    format!("a list of {segments} whole numbers, one for each segment of axis_m,")
}

fn read_distributed_mass(table: &Table) -> Option<DistributedMassSpec> {
    table
        .required("parts")
        .filter(Value::is_empty_list)
        .and_then(|v| v.wrong::<()>("a list of at least one table"));
    let parts = table.tables("parts", &["total_kg", "chord_power", "from", "to"]);
    let parts: Vec<_> = parts.iter().map(read_mass_part).collect();
    let laws = |field, allowed| table.optional(field).and_then(|v| v.located(|v| read_laws(v, allowed)));
    Some(DistributedMassSpec {
        place: table.place.clone(),
        parts: parts.into_iter().collect::<Option<_>>()?,
        offset_chords: laws("offset_chords", &CHORDS),
        offset: vector_or_zero(table, "offset_m", &LENGTH),
        gyration_chords: laws("gyration_chords", &GYRATION),
        gyration_lengths: vector_or_zero(table, "gyration_lengths", &GYRATION),
        added_inertia: vector_or_zero(table, "added_inertia_kg_m2", &INERTIA),
    })
}

/// Three laws, one for each axis.
fn read_laws(value: &Value, allowed: &'static Allowed) -> Option<[Law; 3]> {
    let laws = value.list("a list of three numbers or laws")?;
    let [x, y, z] = laws.as_slice() else { return value.wrong("a list of three numbers or laws") };
    let (x, y, z) = (Law::read(x, allowed), Law::read(y, allowed), Law::read(z, allowed));
    Some([x?, y?, z?])
}

fn read_mass_part(table: &Table) -> Option<MassPartSpec> {
    let stretch = read_stretch(table);
    let total = table.required("total_kg")?.number(&MASS)?;
    let chord_power = table.number_or("chord_power", &ANY, 0.0);
    Some(MassPartSpec { place: table.place.clone(), total, chord_power, stretch })
}

fn read_point_masses(table: &Table) -> Option<PointMassesSpec> {
    let along = read_along(table);
    let (inertia, inertia_place) = read_inertia(table);
    Some(PointMassesSpec {
        masses: read_masses(table)?,
        along: along?,
        offset: vector_or_zero(table, "offset_m", &LENGTH),
        inertia,
        products: vector_or_zero(table, "products_kg_m2", &INERTIA_PRODUCT),
        inertia_place,
    })
}

/// `mass_kg`, or `total_kg` divided by `shares`.
fn read_masses(table: &Table) -> Option<Located<Vec<f64>>> {
    let (field, value) = table.either(&["mass_kg", "total_kg"])?;
    let place = value.place.clone();
    if field == "mass_kg" {
        for excluded in ["shares", "shares_of"].into_iter().filter_map(|field| table.optional(field)) {
            let allowed = "shares are allowed together with total_kg";
            table.report.add(Problem::Contradiction, &excluded.place, "found shares of mass_kg", allowed);
        }
        let masses = value.one_or_more_numbers(&MASS)?;
        return Some(Located { value: masses.into_iter().map(|mass| mass.value).collect(), place });
    }
    let total = value.number(&MASS);
    let shares = table.required("shares")?;
    let place = shares.place.clone();
    let shares = shares.numbers(&SHARE)?;
    let whole = table.number_or("shares_of", &SHARE, shares.iter().sum());
    let total = total?;
    let masses: Vec<f64> = shares.iter().map(|share| total * (share / whole)).collect();
    let allowed = masses.iter().all(|mass| MASS.check(*mass, &place, table.report));
    allowed.then_some(Located { value: masses, place })
}

/// Radii of gyration or moments; a mass without either is a point.
fn read_inertia(table: &Table) -> (InertiaSpec, Place) {
    let point = || (InertiaSpec::Gyration(Vector3::zeros()), table.place.clone());
    if table.optional("gyration_m").is_none() && table.optional("inertia_kg_m2").is_none() {
        return point();
    }
    let Some((field, value)) = table.either(&["gyration_m", "inertia_kg_m2"]) else { return point() };
    let allowed = if field == "gyration_m" { &GYRATION } else { &INERTIA };
    let Some(vector) = value.vector(allowed) else { return point() };
    let inertia =
        if field == "gyration_m" { InertiaSpec::Gyration(vector) } else { InertiaSpec::Moments(vector) };
    (inertia, value.place)
}

fn read_surface(table: &Table) -> Option<SurfaceSpec> {
    let stretch = read_stretch(table);
    let law = |field, allowed| table.optional(field).and_then(|v| Law::read(&v, allowed));
    let needed = |field, allowed| table.required(field).and_then(|v| Law::read(&v, allowed));
    let (lift_slope, drag) = (needed("lift_slope_per_rad", &LIFT_SLOPE), needed("profile_drag", &DRAG));
    let elastic_axis = needed("elastic_axis", &NEAR_THE_CHORD);
    let moves: Vec<_> = table.tables("control", MOVE).iter().map(read_move).collect();
    let flap = table.optional("flap");
    if flap.is_none() && !moves.is_empty() {
        let (found, allowed) =
            ("found a control and no flap", "it is needed; allowed: { lift_slope_per_rad, hinge }");
        table.report.add(Problem::MissingField, &table.place.within("flap"), found, allowed);
    }
    Some(SurfaceSpec {
        place: table.place.clone(),
        position: table.number_or("position_in_element", &FRACTION, 0.5),
        stretch,
        chord: law("chord_m", &POSITIVE_LENGTH),
        span_axis: table.optional("span_axis").and_then(|v| v.direction()),
        incidence: law("incidence_deg", &ANGLE_DEG),
        width: law("width_m", &POSITIVE_LENGTH),
        zero_lift_offset: law("zero_lift_offset_deg", &ANGLE_DEG),
        zero_lift_moment: law("zero_lift_moment", &MOMENT),
        leading_edge_suction: law("leading_edge_suction", &FRACTION),
        flap: flap.and_then(|v| read_flap(&v)),
        moves: moves.into_iter().flatten().collect(),
        elastic_axis: elastic_axis?,
        lift_slope: lift_slope?,
        profile_drag: drag?,
    })
}

fn read_flap(value: &Value) -> Option<FlapSpec> {
    let table = value.table(&["lift_slope_per_rad", "hinge"])?;
    let lift_slope = table.required("lift_slope_per_rad").and_then(|v| v.number(&FLAP_LIFT_SLOPE));
    let hinge = table.required("hinge").and_then(|v| v.number(&INSIDE_THE_CHORD));
    Some(FlapSpec { lift_slope: lift_slope?, hinge: hinge? })
}

fn read_move(table: &Table) -> Option<MoveSpec> {
    let control = read_name(table, "input");
    let gain = table.required("gain").and_then(|v| v.number(&GAIN));
    let stretch = read_stretch(table);
    let hands = [("right", Hand::Right), ("left", Hand::Left)];
    let side = table.optional("side");
    let hand = side.as_ref().and_then(|v| v.located(|v| v.one_of(&hands)));
    // Nothing more is said of a side that could not be read.
    let is_readable = hand.is_some() == side.is_some();
    let control = control.filter(|_| is_readable)?;
    Some(MoveSpec { place: table.place.clone(), control, gain: gain?, stretch, hand })
}

fn read_engine(table: &Table) -> Option<EngineSpec> {
    let (name, component) = (read_name(table, "name"), read_name(table, "component"));
    let along = read_along(table);
    let direction = table.required("direction").and_then(|v| v.direction());
    Some(EngineSpec {
        name: name?,
        component: component?,
        along: along?,
        offset: vector_or_zero(table, "offset_m", &LENGTH),
        direction: direction?,
    })
}

fn read_station(table: &Table) -> Option<StationSpec> {
    let (name, component) = (read_name(table, "name"), read_name(table, "component"));
    let along = read_along(table);
    Some(StationSpec { name: name?, component: component?, along: along? })
}
