//! From components to the whole airframe: every component is built once, then placed as written and, when
//! it has a mirror image, once more on the other side.

use nalgebra::Vector3;

use super::components::{BESIDE_A_HINGE, component_named, nodes_allowed};
use super::control::Mirroring;
use super::cuts;
use super::document::Located;
use super::error::{Place, Problem, Report};
use super::geometry::{Line, Side};
use super::joints;
use super::law::Laws;
use super::masses::{self, LocatedBay};
use super::model::{
    Aircraft, Attachment, Beam, Component, Engine, Flap, MassBay, MassGroup, Station, Strip, WrittenComponent,
};
use super::schema::{
    Along, ComponentSpec, ControlSpec, EngineSpec, FileSpec, Hand, MoveSpec, ParentSpec, StationSpec,
};
use super::sections;
use super::stations_along::twist_axis;
use super::surfaces::{self, PartStrip};

/// The aircraft with the places of the file that its parts come from.
pub(super) struct Assembly {
    pub(super) aircraft: Aircraft,
    /// One for each beam.
    pub(super) beam_places: Vec<Place>,
    /// One for each bay.
    pub(super) bay_places: Vec<Place>,
    /// One for each joint.
    pub(super) joint_places: Vec<Place>,
}

/// A component by itself; nodes and elements count from its root, vectors from its attachment point.
struct Part<'s> {
    spec: &'s ComponentSpec,
    line: Line,
    beams: Vec<Beam>,
    bays: Vec<LocatedBay>,
    /// Name of each group of bays, and how many it has, in their order.
    groups: Vec<(String, usize)>,
    strips: Vec<PartStrip<'s>>,
}

/// Where a component came to lie.
struct Placed<'p> {
    name: &'p str,
    /// The name of its mirror image.
    partner: Option<&'p str>,
    line: &'p Line,
    /// From the attachment point on.
    nodes: Vec<usize>,
    first_beam: usize,
    /// Whether it turns against the first of its nodes.
    is_hinged: bool,
}

/// Builds the aircraft; what is wrong with it is reported and `None`.
pub(super) fn expand(file: &FileSpec, report: &Report) -> Option<Assembly> {
    let parts: Vec<_> = file.components.iter().map(|spec| build(spec, report)).collect();
    let parts: Vec<Part> = parts.into_iter().collect::<Option<_>>()?;
    let mut assembly = Assembly {
        aircraft: Aircraft {
            name: file.name.clone(),
            gravity: file.gravity,
            support: file.support.value,
            mode_basis: file.mode_basis,
            load_modes: file.load_modes,
            fidelity: file.fidelity,
            inflow_states: file.inflow_states,
            airspeed: file.airspeed.value,
            altitude: file.altitude,
            temperature_offset: file.temperature_offset,
            reference: file.reference,
            limits: file.limits,
            tunnel_air: file.tunnel_air.as_ref().map(|air| air.value),
            mount: file.mount.as_ref().map_or(Vector3::zeros(), |mount| mount.value),
            controls: file.controls.iter().map(|spec| spec.control.clone()).collect(),
            nodes: vec![Vector3::zeros()],
            beams: Vec::new(),
            joints: Vec::new(),
            bays: Vec::new(),
            strips: Vec::new(),
            engines: Vec::new(),
            stations: Vec::new(),
            components: Vec::new(),
            written: Vec::new(),
            cuts: Vec::new(),
        },
        beam_places: Vec::new(),
        bay_places: Vec::new(),
        joint_places: Vec::new(),
    };
    let mut placed = Vec::new();
    for part in &parts {
        let first_bay = assembly.aircraft.bays.len();
        let (name, mirror) = (&part.spec.name, part.spec.mirror.as_ref());
        let root = root(part.spec, Side::AsWritten, &placed, &assembly, report);
        let partner = mirror.map(|mirror| mirror.value.as_str());
        let as_written = (Side::AsWritten, root.unwrap_or(Root::ORIGIN));
        let as_written = assembly.place(part, as_written, &name.value, partner, &file.controls);
        let image = mirror.map(|mirror| {
            let image = root.and_then(|_| self::root(part.spec, Side::Mirrored, &placed, &assembly, report));
            let image = (Side::Mirrored, image.unwrap_or(Root::ORIGIN));
            assembly.place(part, image, &mirror.value, Some(&name.value), &file.controls)
        });
        if image.is_some() {
            assembly.join_images(placed.len());
        }
        placed.push(as_written);
        placed.extend(image);
        let groups = part.groups(first_bay, 1 + usize::from(partner.is_some()));
        let image = partner.map(str::to_owned);
        assembly.aircraft.written.push(WrittenComponent { name: name.value.clone(), image, groups });
    }
    let engines = file.engines.iter().filter_map(|spec| engine(spec, &placed, report)).collect();
    assembly.aircraft.engines = engines;
    let stations = file.stations.iter().filter_map(|s| station(s, &placed, &assembly.aircraft, report));
    let stations = stations.collect();
    assembly.aircraft.stations = stations;
    let joints = joints::joints(&file.joints, &assembly.aircraft, report);
    (assembly.aircraft.joints, assembly.joint_places) = joints.into_iter().unzip();
    joints::level(file, &assembly.aircraft, &assembly.joint_places, report);
    assembly.aircraft.cuts = cuts::cuts(&file.cuts, &assembly.aircraft, report);
    Some(assembly)
}

fn build<'s>(spec: &'s ComponentSpec, report: &Report) -> Option<Part<'s>> {
    let line = Line::of(spec, report)?;
    let laws = Laws { chord: spec.chord.as_ref(), named: &spec.stiffness, elements: line.elements(), report };
    let chords = spec.chord.as_ref().map(|chord| laws.chords(&line.points_at(0.5), &chord.place));
    if let Some(None) = chords {
        return None;
    }
    let beams = beams(spec, &line, &laws);
    let mut bays = Some(Vec::new());
    let mut strips = Some(Vec::new());
    let mut groups = Vec::new();
    let named = |field: &'static str| (1..).map(move |number| format!("{field}[{number}]"));
    let distributed = spec.distributed_masses.iter().map(|mass| masses::distributed(mass, &line, &laws));
    let at_points = spec.point_masses.iter().map(|mass| masses::at_points(mass, &line, report));
    let of_sections =
        sections::bays(spec, &line, &laws).into_iter().map(|(name, bays)| (name.to_owned(), bays));
    let of_groups = named("distributed_mass").zip(distributed).chain(named("point_masses").zip(at_points));
    let of_groups = of_groups.chain(of_sections);
    for (name, more) in of_groups {
        groups.push((name, more.as_ref().map_or(0, Vec::len)));
        bays = extended(bays, more);
    }
    if !surfaces::do_not_overlap(&spec.surfaces, &line, report) {
        strips = None;
    }
    for surface in &spec.surfaces {
        strips = extended(strips, surfaces::strips(surface, &line, &laws));
    }
    Some(Part { spec, beams: beams?, bays: bays?, groups, strips: strips?, line })
}

impl Part<'_> {
    /// The groups of the part's bays, which it has so many times among those of the aircraft, from a first on.
    fn groups(&self, first_bay: usize, times: usize) -> Vec<MassGroup> {
        let mut begin = first_bay;
        let group = |(name, count): &(String, usize)| {
            let of_time =
                |time: usize| begin + time * self.bays.len()..begin + time * self.bays.len() + count;
            let bays = (0..times).flat_map(of_time).collect();
            begin += count;
            MassGroup { name: name.clone(), bays }
        };
        self.groups.iter().map(group).collect()
    }
}

/// Both lists after one another, when both could be made.
fn extended<T>(list: Option<Vec<T>>, more: Option<Vec<T>>) -> Option<Vec<T>> {
    let (mut list, more) = (list?, more?);
    list.extend(more);
    Some(list)
}

fn beams(spec: &ComponentSpec, line: &Line, laws: &Laws) -> Option<Vec<Beam>> {
    let sections = sections::of_elements(spec, line, laws)?;
    let beam = |element: usize| {
        let section = &sections[element];
        Some(Beam {
            component: spec.name.value.clone(),
            nodes: [element, element + 1],
            y_axis: y_axis(spec, line, element, laws.report)?,
            axial_stiffness: section.axial,
            torsional_stiffness: section.torsional,
            bending_stiffness_y: section.bending_y,
            bending_stiffness_z: section.bending_z,
            coupling: section.coupling,
            hinge: if element == 0 { sections::hinge(spec, line) } else { None },
        })
    };
    (0..line.elements()).map(beam).collect()
}

/// The written direction made perpendicular to the element.
fn y_axis(spec: &ComponentSpec, line: &Line, element: usize, report: &Report) -> Option<Vector3<f64>> {
    let axes = sections::local_axes(spec, line, element);
    axes.map(|axes| axes.column(1).into_owned()).or_else(|| {
        let found = format!("found a direction along element {} itself", element + 1);
        report.add(Problem::NoDirection, &spec.y_axis.place, found, "a direction across the beam is allowed");
        None
    })
}

/// What a component hangs on.
#[derive(Clone, Copy)]
struct Root {
    /// Of the airframe.
    node: usize,
    /// The component that has it, and its number there; `None`: O is no part of any.
    parent: Option<(usize, usize)>,
}

impl Root {
    const ORIGIN: Root = Root { node: 0, parent: None };

    /// A node of a component.
    fn of(placed: &[Placed], parent: usize, node: usize) -> Self {
        match placed[parent].nodes[node] {
            0 => Root::ORIGIN,
            on_airframe => Root { node: on_airframe, parent: Some((parent, node)) },
        }
    }
}

/// The node that a component hangs on.
fn root(
    spec: &ComponentSpec,
    side: Side,
    placed: &[Placed],
    assembly: &Assembly,
    report: &Report,
) -> Option<Root> {
    let ParentSpec::Component { name, at } = &spec.parent else { return Some(Root::ORIGIN) };
    let names: Vec<&str> = placed.iter().map(|other| other.name).collect();
    let Some(index) = names.iter().position(|other| *other == name.value) else {
        let found = format!("found \"{}\", which is not a component above this one", name.value);
        let allowed = format!("allowed: \"origin\" or one of the components above: {}", names.join(", "));
        report.add(Problem::Disconnected, &name.place, found, allowed);
        return None;
    };
    let parent = &placed[index];
    let Some(node) = parent.line.node_at(at.value) else {
        let found = format!("found {}, where \"{}\" has no node", at.value, name.value);
        let allowed = nodes_allowed(parent.line.fractions(), at.value);
        report.add(Problem::Disconnected, &at.place, found, allowed);
        return None;
    };
    if node == 0 && parent.is_hinged {
        let found = format!("found the root of \"{}\", where a hinge is", name.value);
        report.add(Problem::Disconnected, &at.place, found, BESIDE_A_HINGE);
        return None;
    }
    if side == Side::AsWritten {
        return Some(Root::of(placed, index, node));
    }
    let image = parent.partner.and_then(|partner| names.iter().position(|other| *other == partner));
    let root = Root::of(placed, image.unwrap_or(index), node);
    if image.is_none() && assembly.aircraft.nodes[root.node].y.abs() > 1e-9 {
        let found = format!("found \"{}\", which is off the plane y = 0 and has no mirror image", name.value);
        let allowed = "a mirrored component is allowed on a parent in the plane or one that is mirrored too";
        report.add(Problem::Disconnected, &name.place, found, allowed);
        return None;
    }
    Some(root)
}

impl Assembly {
    /// Makes a component and the next one mirror images of each other.
    fn join_images(&mut self, component: usize) {
        let components = &mut self.aircraft.components;
        (components[component].image, components[component + 1].image) =
            (Some(component + 1), Some(component));
    }

    fn place<'p>(
        &mut self,
        part: &'p Part,
        (side, Root { node: root, parent }): (Side, Root),
        name: &'p str,
        partner: Option<&'p str>,
        controls: &[ControlSpec],
    ) -> Placed<'p> {
        let aircraft = &mut self.aircraft;
        let (origin, first_node, first_beam) =
            (aircraft.nodes[root], aircraft.nodes.len(), aircraft.beams.len());
        let nodes: Vec<usize> =
            std::iter::once(root).chain(first_node..first_node + part.beams.len()).collect();
        let points = part.line.points.iter().skip(1);
        aircraft.nodes.extend(points.map(|point| origin + side.vector(*point)));
        let on_airframe = |local: Attachment| Attachment { beam: first_beam + local.beam, ..local };
        for beam in &part.beams {
            aircraft.beams.push(Beam {
                component: name.to_owned(),
                nodes: beam.nodes.map(|local| nodes[local]),
                y_axis: side.vector(beam.y_axis),
                coupling: side.coupling(beam.coupling),
                hinge: beam.hinge.as_ref().map(|hinge| hinge.turned(|axis| side.vector(axis))),
                ..beam.clone()
            });
            self.beam_places.push(part.spec.name.place.clone());
        }
        for (bay, place) in &part.bays {
            aircraft.bays.push(MassBay {
                attachment: on_airframe(bay.attachment),
                mass: bay.mass,
                offset: side.vector(bay.offset),
                inertia: side.inertia(bay.inertia),
            });
            self.bay_places.push(place.clone());
        }
        let hand = hand(side, nodes.iter().map(|&node| aircraft.nodes[node].y).sum());
        for PartStrip { strip, moves } in &part.strips {
            let gains = || gains_on((side, hand), moves, controls);
            aircraft.strips.push(Strip {
                attachment: on_airframe(strip.attachment),
                forward: side.vector(strip.forward),
                span: side.axis(strip.span),
                flap: strip.flap.clone().map(|flap| Flap { gains: gains(), ..flap }),
                ..strip.clone()
            });
        }
        aircraft.components.push(Component {
            name: name.to_owned(),
            nodes: nodes.clone(),
            first_beam,
            image: None,
            parent,
        });
        let is_hinged = part.spec.section.hinge.is_some();
        Placed { name, partner, line: &part.line, nodes, first_beam, is_hinged }
    }
}

/// On which side of the aircraft a component is whose nodes have this sum of y; in the plane the right one is as written.
fn hand(side: Side, sum_of_y: f64) -> Hand {
    let in_plane = sum_of_y.abs() <= 1e-9;
    let is_right = if in_plane { side == Side::AsWritten } else { sum_of_y > 0.0 };
    if is_right { Hand::Right } else { Hand::Left }
}

/// The gain of each control on a flap that some of them move.
fn gains_on((side, hand): (Side, Hand), moves: &[&MoveSpec], controls: &[ControlSpec]) -> Vec<f64> {
    let gain = |spec: &ControlSpec| {
        let moves = moves.iter().filter(|used| used.control.value == spec.name.value);
        let here = moves.filter(|used| used.hand.as_ref().is_none_or(|other| other.value == hand));
        let gain = here.fold(0.0, |sum, used| sum + used.gain);
        // Positive is towards +n on both sides.
        if (side, spec.control.mirroring) == (Side::Mirrored, Mirroring::Opposite) {
            0.0 - gain
        } else {
            gain
        }
    };
    controls.iter().map(gain).collect()
}

/// One place on a component, mirror images included.
fn attach(name: &Located<String>, along: &Along, placed: &[Placed], report: &Report) -> Option<Attachment> {
    let component = &placed[component_named(name, placed.iter().map(|other| other.name), report)?];
    // The format has one place there.
    let local = *component.line.locate(along, report)?.first()?;
    Some(Attachment { beam: component.first_beam + local.beam, ..local })
}

fn engine(spec: &EngineSpec, placed: &[Placed], report: &Report) -> Option<Engine> {
    let attachment = attach(&spec.component, &spec.along, placed, report)?;
    let name = spec.name.value.clone();
    let EngineSpec { offset, direction, ref torque, ref angular_momentum, ref trim_share, .. } = *spec;
    let [torque, angular_momentum, trim_share] =
        [torque, angular_momentum, trim_share].map(|field| field.value);
    Some(Engine { name, attachment, offset, direction, torque, angular_momentum, trim_share })
}

fn station(spec: &StationSpec, placed: &[Placed], aircraft: &Aircraft, report: &Report) -> Option<Station> {
    let attachment = attach(&spec.component, &spec.along, placed, report)?;
    let twist_axis = twist_axis(attachment, aircraft);
    Some(Station { name: spec.name.value.clone(), attachment, twist_axis })
}
