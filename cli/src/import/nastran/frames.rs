//! Coordinate systems and grids, resolved: each by others, down to the basic one; then in body axes and metres.

use std::collections::BTreeMap;

use nalgebra::{Matrix3, Vector3};

use super::cards::{Cards, FrameBy, FrameCard, FrameShape};
use super::mistakes::{Mistakes, Needed, Origin};

/// Of grids from the zero of the deck, in its lengths.
const FARTHEST: f64 = 1e9;

/// A coordinate system in the basic one.
#[derive(Clone, Debug)]
struct Frame {
    origin: Vector3<f64>,
    /// Columns are its axes.
    axes: Matrix3<f64>,
    shape: FrameShape,
}

impl Frame {
    fn basic() -> Self {
        Frame { origin: Vector3::zeros(), axes: Matrix3::identity(), shape: FrameShape::Rectangular }
    }

    /// With its origin, a point on its z axis, and one in its x–z plane.
    fn through([a, b, c]: [Vector3<f64>; 3], shape: FrameShape) -> Option<Self> {
        let z = (b - a).try_normalize(0.0)?;
        let across = z.cross(&(c - a));
        // Points nearly on one line show no plane.
        let y = (across.norm() > 1e-9 * (c - a).norm()).then(|| across.normalize())?;
        Some(Frame { origin: a, axes: Matrix3::from_columns(&[y.cross(&z), y, z]), shape })
    }

    fn point(&self, numbers: [f64; 3]) -> Vector3<f64> {
        let [r, angle, z] = numbers;
        let local = match self.shape {
            FrameShape::Rectangular => Vector3::from(numbers),
            FrameShape::Cylindrical => {
                let (sin, cos) = libm::sincos(angle.to_radians());
                Vector3::new(r * cos, r * sin, z)
            }
        };
        self.origin + self.axes * local
    }

    /// Its axes at a point: of a cylindrical one out, around, along.
    fn axes_at(&self, point: &Vector3<f64>) -> Matrix3<f64> {
        let local = self.axes.tr_mul(&(point - self.origin));
        match self.shape {
            FrameShape::Cylindrical if libm::hypot(local.x, local.y) > 0.0 => {
                let out = Vector3::new(local.x, local.y, 0.0).normalize();
                let around = Vector3::new(-out.y, out.x, 0.0);
                self.axes * Matrix3::from_columns(&[out, around, Vector3::z()])
            }
            _ => self.axes,
        }
    }
}

/// Where a grid is.
#[derive(Clone, Debug)]
struct GridPlace {
    /// Basic, in the deck's lengths.
    at: Vector3<f64>,
    displacement_frame: i64,
}

/// All frames and grids; what it gives is in body axes and metres, from the point that is the zero of the deck.
#[derive(Clone, Debug)]
pub struct World {
    frames: BTreeMap<i64, Frame>,
    grids: BTreeMap<i64, GridPlace>,
    to_body: Matrix3<f64>,
    /// In the basic system: body coordinates are 0 there.
    zero: Vector3<f64>,
    length: f64,
}

/// What is resolved by others.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
enum Node {
    Frame(i64),
    Grid(i64),
}

impl World {
    /// All frames and grids of a deck; names of frames and grids that are none are mistakes. In the basic system until it is turned.
    pub fn resolve(cards: &Cards, mistakes: &mut Mistakes) -> World {
        let mut world = World {
            frames: BTreeMap::from([(0, Frame::basic())]),
            grids: BTreeMap::new(),
            to_body: Matrix3::identity(),
            zero: Vector3::zeros(),
            length: 1.0,
        };
        let frames = cards.frames.keys().map(|&id| Node::Frame(id));
        let mut failed = std::collections::BTreeSet::new();
        for node in frames.chain(cards.grids.keys().map(|&id| Node::Grid(id))) {
            world.resolve_one(node, cards, (mistakes, &mut failed));
        }
        for grid in cards.grids.values() {
            if !cards.frames.contains_key(&grid.displacement_frame) && grid.displacement_frame != 0 {
                mistakes.missing(&grid.origin, "CD", grid.displacement_frame, Needed::Frame);
            }
        }
        world
    }

    /// With what it rests on first; a stack of its own, for chains may be long.
    fn resolve_one(
        &mut self,
        node: Node,
        cards: &Cards,
        (mistakes, failed): (&mut Mistakes, &mut std::collections::BTreeSet<Node>),
    ) {
        let mut waiting = vec![node];
        let mut under_way = std::collections::BTreeSet::new();
        while let Some(&top) = waiting.last() {
            if self.knows(top) || failed.contains(&top) {
                waiting.pop();
                continue;
            }
            under_way.insert(top);
            let needs = needs(top, cards);
            let missing = needs.iter().find(|need| !self.knows(**need));
            let result = match missing {
                None => self.compute(top, cards),
                Some(need) if failed.contains(need) => Err(None),
                Some(need) if !is_there(*need, cards) => {
                    Err(Some((format!("found {}", number(*need)), needed(*need).text())))
                }
                Some(need) if under_way.contains(need) => {
                    let found = format!("found {}, which rests on this one", number(*need));
                    Err(Some((
                        found,
                        "a coordinate system is allowed that leads to the basic one".to_owned(),
                    )))
                }
                Some(need) => {
                    waiting.push(*need);
                    continue;
                }
            };
            if let Err(why) = result {
                failed.insert(top);
                if let (Some((found, allowed)), Some(origin)) = (why, origin(top, cards)) {
                    mistakes.of_origin(origin, "place", found, allowed);
                }
            }
        }
    }

    fn knows(&self, node: Node) -> bool {
        match node {
            Node::Frame(id) => self.frames.contains_key(&id),
            Node::Grid(id) => self.grids.contains_key(&id),
        }
    }

    /// Of what all it rests on is known.
    fn compute(&mut self, node: Node, cards: &Cards) -> Result<(), Option<(String, String)>> {
        match node {
            Node::Grid(id) => {
                let grid = cards.grids.get(&id).ok_or(None)?;
                let at = self.frames.get(&grid.place_frame).ok_or(None)?.point(grid.place);
                // Also what is no number is no less.
                let is_near = at.norm() <= FARTHEST;
                if !is_near {
                    let found = format!("found a place {:e} from the zero of the deck", at.norm());
                    return Err(Some((found, "up to 1e9 is allowed, in the deck's lengths".to_owned())));
                }
                self.grids.insert(id, GridPlace { at, displacement_frame: grid.displacement_frame });
            }
            Node::Frame(id) => {
                let card = cards.frames.get(&id).ok_or(None)?;
                let points = self.points(card).ok_or(None)?;
                let line = "found three points on one line";
                let allowed = "an origin, a point on the z axis and one beside it are allowed";
                let frame = Frame::through(points, card.shape)
                    .ok_or_else(|| Some((line.to_owned(), allowed.to_owned())))?;
                self.frames.insert(id, frame);
            }
        }
        Ok(())
    }

    fn points(&self, card: &FrameCard) -> Option<[Vector3<f64>; 3]> {
        match &card.by {
            FrameBy::Grids(grids) => {
                let [a, b, c] = grids.map(|grid| self.grids.get(&grid).map(|grid| grid.at));
                Some([a?, b?, c?])
            }
            FrameBy::Points { frame, points } => {
                let frame = self.frames.get(frame)?;
                Some(points.map(|point| frame.point(point)))
            }
        }
    }

    /// The same in body axes: those of a frame, or of the basic one, turned; from the frame's origin.
    pub fn turned(mut self, frame: i64, axes: Matrix3<f64>, length: f64) -> Option<World> {
        let frame = self.frames.get(&frame)?;
        self.to_body = axes * frame.axes.transpose();
        self.zero = frame.origin;
        self.length = length;
        Some(self)
    }

    fn to_body(&self, basic: &Vector3<f64>) -> Vector3<f64> {
        self.to_body * (basic - self.zero) * self.length
    }

    /// The place of a grid, m.
    pub fn grid(&self, id: i64) -> Option<Vector3<f64>> {
        Some(self.to_body(&self.grids.get(&id)?.at))
    }

    /// A place by its numbers in a frame, m.
    pub fn point(&self, frame: i64, numbers: [f64; 3]) -> Option<Vector3<f64>> {
        Some(self.to_body(&self.frames.get(&frame)?.point(numbers)))
    }

    /// The displacement axes of a grid, as columns.
    pub fn displacement_axes(&self, grid: i64) -> Option<Matrix3<f64>> {
        let grid = self.grids.get(&grid)?;
        Some(self.to_body * self.frames.get(&grid.displacement_frame)?.axes_at(&grid.at))
    }

    /// The axes of a frame at a grid, as columns.
    pub fn axes_at(&self, frame: i64, grid: i64) -> Option<Matrix3<f64>> {
        let at = self.grids.get(&grid).map_or(self.zero, |grid| grid.at);
        Some(self.to_body * self.frames.get(&frame)?.axes_at(&at))
    }

    /// The basic axes, as columns.
    pub fn basic_axes(&self) -> Matrix3<f64> {
        self.to_body
    }

    /// m of a length of the deck.
    pub fn length(&self) -> f64 {
        self.length
    }
}

fn needed(node: Node) -> Needed {
    match node {
        Node::Frame(_) => Needed::Frame,
        Node::Grid(_) => Needed::Grid,
    }
}

fn number(node: Node) -> i64 {
    match node {
        Node::Frame(id) | Node::Grid(id) => id,
    }
}

fn needs(node: Node, cards: &Cards) -> Vec<Node> {
    match node {
        Node::Grid(id) => {
            cards.grids.get(&id).map(|grid| Node::Frame(grid.place_frame)).into_iter().collect()
        }
        Node::Frame(id) => match cards.frames.get(&id).map(|frame| &frame.by) {
            Some(FrameBy::Grids(grids)) => grids.iter().map(|&grid| Node::Grid(grid)).collect(),
            Some(FrameBy::Points { frame, .. }) => vec![Node::Frame(*frame)],
            None => Vec::new(),
        },
    }
}

fn is_there(node: Node, cards: &Cards) -> bool {
    match node {
        Node::Frame(id) => id == 0 || cards.frames.contains_key(&id),
        Node::Grid(id) => cards.grids.contains_key(&id),
    }
}

fn origin(node: Node, cards: &Cards) -> Option<&Origin> {
    match node {
        Node::Frame(id) => cards.frames.get(&id).map(|frame| &frame.origin),
        Node::Grid(id) => cards.grids.get(&id).map(|grid| &grid.origin),
    }
}
