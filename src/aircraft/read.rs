//! From the TOML document to the [`schema`](super::schema): which fields there are and what they may hold.

use nalgebra::Vector3;
use toml::de::DeTable;

use super::control_tables::read_controls;
use super::cut_tables::read_cuts;
use super::document::{Located, Table, Value};
use super::error::{Place, Problem, Report};
use super::format::allowed::MASS;
use super::format::{FILE, Field, component, file, masses, places, surface};
use super::joint_tables::read_joints;
use super::law::Law;
use super::limit_tables::read_limits;
use super::model::{ModeBasis, Support};
use super::model_tables;
use super::reference::read_reference;
use super::schema::{
    Along, ComponentSpec, DistributedMassSpec, EngineSpec, FileSpec, FlapSpec, Hand, InertiaSpec,
    MassPartSpec, MoveSpec, ParentSpec, PointMassesSpec, StationSpec, SurfaceSpec,
};
use super::section_tables::read_sections;
use super::stretch::Stretch;
use super::tunnel;

/// Reads the whole document; what could not be read is complained about, and left out: the rest may have mistakes too.
pub(super) fn read_file(document: &DeTable, report: &Report) -> Option<FileSpec> {
    let table = Table::new(document, Place { span: 0..0, field: String::new() }, &FILE, report);
    table.required(&file::FORMAT).and_then(|v| v.integer());
    let name = table.required(&file::NAME).and_then(|v| v.text());
    let tunnel_air = tunnel::read_air(&table);
    let supports = [(file::FREE.word, Support::Free), (file::CLAMPED.word, Support::Clamped)];
    let bases = [(file::BENDING_TORSION.word, ModeBasis::BendingTorsion), (file::FULL.word, ModeBasis::Full)];
    let support = table.required(&file::SUPPORT);
    let support = support.and_then(|v| v.located(|v| v.one_of(&supports)));
    let mode_basis = table.required(&file::MODE_BASIS);
    let mode_basis = mode_basis.and_then(|v| v.one_of(&bases));
    let (controls, has_all_controls) = read_controls(&table);
    let (limits, former_limits) = read_limits(&table);
    table.required(&file::COMPONENTS);
    let components = table.tables(&file::COMPONENTS);
    let components: Vec<_> = components.iter().map(read_component).collect();
    let engines: Vec<_> = table.tables(&file::ENGINES).iter().map(read_engine).collect();
    let stations: Vec<_> = table.tables(&file::STATIONS).iter().map(read_station).collect();
    Some(FileSpec {
        gravity: table.number(&file::GRAVITY_FIELD),
        inflow_states: table.integer(&file::INFLOW_STATES),
        airspeed: table
            .optional(&file::AIRSPEED_FIELD)
            .and_then(|v| v.located(Value::number))
            .unwrap_or(Located { value: file::AIRSPEED_FIELD.absent.number(), place: table.place.clone() }),
        altitude: if tunnel_air.is_some() { 0.0 } else { table.number(&file::ALTITUDE_FIELD) },
        temperature_offset: if tunnel_air.is_some() { 0.0 } else { table.number(&file::OFFSET_FIELD) },
        tunnel_air,
        mount: table.optional(&file::MOUNT).and_then(|v| v.located(tunnel::read_mount)),
        load_modes: model_tables::read_load_modes(&table),
        fidelity: model_tables::read_fidelity(&table),
        fidelity_place: table.optional(&file::MODEL).map(|v| v.place),
        symmetric: table.flag(&file::SYMMETRIC),
        reference: read_reference(&table),
        limits,
        former_limits,
        name: name?,
        support: support?,
        mode_basis: mode_basis?,
        controls,
        has_all_controls,
        components: components.into_iter().flatten().collect(),
        joints: read_joints(&table),
        engines: engines.into_iter().flatten().collect(),
        stations: stations.into_iter().flatten().collect(),
        cuts: read_cuts(&table),
    })
}

/// `from` and `to`, fractions of the component's length, by default all of it.
fn read_stretch(table: &Table) -> Stretch {
    let (from, to) = (table.number(&places::FROM), table.number(&places::TO));
    if to <= from {
        let found = format!("found from = {from} and to = {to}");
        table.report.add(
            Problem::OutOfRange,
            &table.place.within(places::TO.name),
            found,
            "to > from is allowed",
        );
    }
    Stretch { from, to }
}

fn read_along(table: &Table) -> Option<Along> {
    let (field, value) = table.either(&places::ALONG)?;
    Some(along(field, value.one_or_more_numbers()?))
}

/// Where one thing is.
fn read_place(table: &Table) -> Option<Along> {
    let (field, value) = table.either(&places::PLACE)?;
    Some(along(field, vec![value.located(Value::number)?]))
}

fn along(field: &Field, places: Vec<Located<f64>>) -> Along {
    if field.name == places::AT_METRES.name { Along::Metres(places) } else { Along::Fractions(places) }
}

fn read_name(table: &Table, field: &Field) -> Option<Located<String>> {
    table.required(field)?.located(Value::name)
}

fn read_component(table: &Table) -> Option<ComponentSpec> {
    let name = read_name(table, &component::NAME);
    let parent = table.required(&component::ATTACHED_TO).and_then(|v| read_parent(&v));
    let axis = table.required(&component::AXIS).and_then(|v| v.located(read_corners));
    let segments = axis.as_ref().map(|axis| axis.value.len() - 1);
    let elements = table.required(&component::ELEMENTS).and_then(|v| read_elements(&v, segments?));
    let y_axis = table.required(&component::Y_AXIS).and_then(|v| v.located(Value::direction));
    let sections = read_sections(table);
    let chord = table.optional(&component::CHORD).and_then(|v| Law::read(&v));
    let distributed = table.tables(&component::DISTRIBUTED_MASSES);
    let distributed: Vec<_> = distributed.iter().map(read_distributed_mass).collect();
    let points = table.tables(&component::POINT_MASSES_FIELD);
    let points: Vec<_> = points.iter().map(read_point_masses).collect();
    let surfaces = table.tables(&component::SURFACES);
    let surfaces: Vec<_> = surfaces.iter().map(read_surface).collect();
    let (stiffness, section) = sections?;
    Some(ComponentSpec {
        mirror: table.optional(&component::MIRROR).and_then(|v| v.located(Value::name)),
        name: name?,
        parent: parent?,
        axis: axis?,
        elements: elements?,
        y_axis: y_axis?,
        stiffness,
        section,
        chord,
        distributed_masses: distributed.into_iter().collect::<Option<_>>()?,
        point_masses: points.into_iter().collect::<Option<_>>()?,
        surfaces: surfaces.into_iter().flatten().collect(),
    })
}

fn read_parent(value: &Value) -> Option<ParentSpec> {
    if !value.has_field(&component::PARENT_NAME) {
        return value.one_of(&[(component::ORIGIN.word, ())]).map(|()| ParentSpec::Origin);
    }
    let table = value.table()?;
    let name = read_name(&table, &component::PARENT_NAME);
    let at = table.required(&component::PARENT_AT).and_then(|v| v.located(Value::number));
    Some(ParentSpec::Component { name: name?, at: at? })
}

fn read_corners(value: &Value) -> Option<Vec<Vector3<f64>>> {
    let what = "a list of at least two points [x, y, z]";
    let points = value.list(what)?;
    if points.len() < 2 {
        return value.wrong(what);
    }
    let points: Vec<_> = points.iter().map(Value::vector).collect();
    points.into_iter().collect()
}

fn read_elements(value: &Value, segments: usize) -> Option<Vec<usize>> {
    if value.is_number() {
        let all = value.integer()?;
        return if segments == 1 { Some(vec![all]) } else { value.wrong(&one_per_segment(segments)) };
    }
    let list = value.list("a whole number, or a list with one for each segment of axis_m,")?;
    if list.len() != segments {
        return value.wrong(&one_per_segment(segments));
    }
    let numbers: Vec<_> = list.iter().map(Value::integer).collect();
    numbers.into_iter().collect()
}

fn one_per_segment(segments: usize) -> String {
    format!("a list of {segments} whole numbers, one for each segment of axis_m,")
}

fn read_distributed_mass(table: &Table) -> Option<DistributedMassSpec> {
    table
        .required(&masses::PARTS)
        .filter(Value::is_empty_list)
        .and_then(|v| v.wrong::<()>("a list of at least one table"));
    let parts: Vec<_> = table.tables(&masses::PARTS).iter().map(read_mass_part).collect();
    let laws = |field: &Field| table.optional(field).and_then(|v| v.located(read_laws));
    Some(DistributedMassSpec {
        place: table.place.clone(),
        parts: parts.into_iter().collect::<Option<_>>()?,
        offset_chords: laws(&masses::OFFSET_CHORDS),
        offset: table.vector(&places::OFFSET),
        gyration_chords: laws(&masses::GYRATION_CHORDS),
        gyration_lengths: table.vector(&masses::GYRATION_LENGTHS),
        added_inertia: table.vector(&masses::ADDED_INERTIA),
    })
}

/// Three laws, one for each axis.
fn read_laws(value: &Value) -> Option<[Law; 3]> {
    let laws = value.list("a list of three numbers or laws")?;
    let [x, y, z] = laws.as_slice() else { return value.wrong("a list of three numbers or laws") };
    let (x, y, z) = (Law::read(x), Law::read(y), Law::read(z));
    Some([x?, y?, z?])
}

fn read_mass_part(table: &Table) -> Option<MassPartSpec> {
    let stretch = read_stretch(table);
    let total = table.required(&masses::PART_TOTAL)?.number()?;
    let chord_power = table.number(&masses::CHORD_POWER);
    Some(MassPartSpec { place: table.place.clone(), total, chord_power, stretch })
}

fn read_point_masses(table: &Table) -> Option<PointMassesSpec> {
    let along = read_along(table);
    let (inertia, inertia_place) = read_inertia(table);
    Some(PointMassesSpec {
        masses: read_masses(table)?,
        along: along?,
        offset: table.vector(&places::OFFSET),
        inertia,
        products: table.vector(&masses::PRODUCTS),
        inertia_place,
    })
}

/// `mass_kg`, or `total_kg` divided by `shares`.
fn read_masses(table: &Table) -> Option<Located<Vec<f64>>> {
    let (field, value) = table.either(&masses::MASSES)?;
    let place = value.place.clone();
    if std::ptr::eq(field, &masses::EACH_MASS) {
        for excluded in [&masses::SHARES, &masses::SHARES_OF].into_iter().filter_map(|f| table.optional(f)) {
            let allowed = "shares are allowed together with total_kg";
            table.report.add(Problem::Contradiction, &excluded.place, "found shares of mass_kg", allowed);
        }
        let masses = value.one_or_more_numbers()?;
        return Some(Located { value: masses.into_iter().map(|mass| mass.value).collect(), place });
    }
    let total = value.number();
    let shares = table.required(&masses::SHARES)?;
    let place = shares.place.clone();
    let shares = shares.numbers()?;
    let whole = table.optional(&masses::SHARES_OF).and_then(|v| v.number());
    let whole = whole.unwrap_or(shares.iter().sum());
    let total = total?;
    let masses: Vec<f64> = shares.iter().map(|share| total * (share / whole)).collect();
    let allowed = masses.iter().all(|mass| MASS.check(*mass, &place, table.report));
    allowed.then_some(Located { value: masses, place })
}

/// Radii of gyration or moments; a mass without either is a point.
fn read_inertia(table: &Table) -> (InertiaSpec, Place) {
    let point = || (InertiaSpec::Gyration(Vector3::zeros()), table.place.clone());
    if masses::INERTIAS.iter().all(|field| table.optional(field).is_none()) {
        return point();
    }
    let Some((field, value)) = table.either(&masses::INERTIAS) else { return point() };
    let Some(vector) = value.vector() else { return point() };
    let is_gyration = std::ptr::eq(field, &masses::GYRATION_RADII);
    let inertia = if is_gyration { InertiaSpec::Gyration(vector) } else { InertiaSpec::Moments(vector) };
    (inertia, value.place)
}

fn read_surface(table: &Table) -> Option<SurfaceSpec> {
    let stretch = read_stretch(table);
    let law = |field: &Field| table.optional(field).and_then(|v| Law::read(&v));
    let needed = |field: &Field| table.required(field).and_then(|v| Law::read(&v));
    let (lift_slope, drag) = (needed(&surface::LIFT), needed(&surface::PROFILE_DRAG));
    let elastic_axis = needed(&surface::ELASTIC_AXIS);
    let moves: Vec<_> = table.tables(&surface::MOVES).iter().map(read_move).collect();
    let flap = table.optional(&surface::FLAP);
    if flap.is_none() && !moves.is_empty() {
        let (found, allowed) =
            ("found a control and no flap", "it is needed; allowed: { lift_slope_per_rad, hinge }");
        table.report.add(Problem::MissingField, &table.place.within(surface::FLAP.name), found, allowed);
    }
    Some(SurfaceSpec {
        place: table.place.clone(),
        position: table.number(&surface::POSITION),
        stretch,
        chord: law(&surface::CHORD),
        span_axis: table.optional(&surface::SPAN_AXIS).and_then(|v| v.direction()),
        incidence: law(&surface::INCIDENCE),
        width: law(&surface::WIDTH),
        zero_lift_offset: law(&surface::ZERO_LIFT_OFFSET),
        zero_lift_moment: law(&surface::ZERO_LIFT_MOMENT),
        moment_slope: law(&surface::MOMENT_SLOPE),
        leading_edge_suction: law(&surface::SUCTION),
        flap: flap.and_then(|v| read_flap(&v)),
        moves: moves.into_iter().flatten().collect(),
        elastic_axis: elastic_axis?,
        lift_slope: lift_slope?,
        profile_drag: drag?,
    })
}

fn read_flap(value: &Value) -> Option<FlapSpec> {
    let table = value.table()?;
    let law = |field: &Field| table.optional(field).and_then(|v| Law::read(&v));
    let needed = |field: &Field| table.required(field).and_then(|v| Law::read(&v));
    let (lift_slope, hinge) = (needed(&surface::FLAP_LIFT), needed(&surface::HINGE));
    let (moment_slope, drag) = (law(&surface::FLAP_MOMENT), law(&surface::FLAP_DRAG));
    Some(FlapSpec { lift_slope: lift_slope?, hinge: hinge?, moment_slope, drag })
}

fn read_move(table: &Table) -> Option<MoveSpec> {
    let control = read_name(table, &surface::INPUT);
    let gain = table.required(&surface::GAIN_FIELD).and_then(|v| v.number());
    let stretch = read_stretch(table);
    let hands = [(surface::RIGHT.word, Hand::Right), (surface::LEFT.word, Hand::Left)];
    let side = table.optional(&surface::SIDE);
    let hand = side.as_ref().and_then(|v| v.located(|v| v.one_of(&hands)));
    // Nothing more is said of a side that could not be read.
    let is_readable = hand.is_some() == side.is_some();
    let control = control.filter(|_| is_readable)?;
    Some(MoveSpec { place: table.place.clone(), control, gain: gain?, stretch, hand })
}

fn read_engine(table: &Table) -> Option<EngineSpec> {
    let (name, component) = (read_name(table, &places::ENGINE_NAME), read_name(table, &places::COMPONENT));
    let along = read_place(table);
    let direction = table.required(&places::DIRECTION).and_then(|v| v.direction());
    Some(EngineSpec {
        name: name?,
        component: component?,
        along: along?,
        offset: table.vector(&places::THRUST_OFFSET),
        direction: direction?,
        torque: table.located_number(&places::TORQUE),
        angular_momentum: table.located_number(&places::ANGULAR_MOMENTUM),
        trim_share: table.located_number(&places::TRIM_SHARE),
    })
}

fn read_station(table: &Table) -> Option<StationSpec> {
    let (name, component) = (read_name(table, &places::STATION_NAME), read_name(table, &places::COMPONENT));
    let along = read_place(table);
    Some(StationSpec { name: name?, component: component?, along: along? })
}
