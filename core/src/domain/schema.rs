//! What a planner knows about an action: objects, constants, parameters, points.

use super::dimension::Dimension;
use super::group::{Group, MAX_GROUPS, Member};
use super::node::{Node, NodeId};
use crate::error::Error;
use crate::text::split_at_dot;
use heapless::Vec;

/// Most types in a domain.
pub const MAX_TYPES: usize = 16;
/// Most attributes, counted once per type.
pub const MAX_ATTRIBUTES: usize = 64;
/// Most objects in a domain, every member of a group counted.
pub const MAX_OBJECTS: usize = 32;
/// Most constants in a domain.
pub const MAX_CONSTANTS: usize = 32;
/// Most continuous parameters of an action.
pub const MAX_PARAMETERS: usize = 6;
/// Most points: placed objects, key points and sample points together, those of
/// every member of a group counted.
pub const MAX_POINTS: usize = 64;
/// Most shapes.
pub const MAX_SHAPES: usize = 16;
/// Most terms in the offsets, turns and sizes of all points and shapes together.
pub const MAX_DOMAIN_NODES: usize = 128;

/// A kind of object and the numbers that describe one (thesis 4.1.1: the types
/// and the dimensionality of their feature vectors).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Type<'t> {
    /// Its name.
    pub name: &'t str,
    /// Where its attributes start among those of the domain.
    pub(super) first: u8,
    /// How many attributes it has.
    pub(super) count: u8,
}

/// A dynamic number of an object, such as its position.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Attribute<'t> {
    /// Its name, unique in its type.
    pub name: &'t str,
    /// What it measures.
    pub dimension: Dimension,
}

impl<'t> Attribute<'t> {
    /// The attribute of this name.
    pub const fn new(name: &'t str, dimension: Dimension) -> Self {
        Attribute { name, dimension }
    }
}

/// A thing in the world; its attributes are read from the problem instance.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Object<'t> {
    /// Its name; that of its group if it is a member of one.
    pub name: &'t str,
    /// Index of its type.
    pub type_index: u8,
    /// To which group it belongs.
    pub member: Option<Member>,
    /// Index of its first attribute in an instance.
    pub first_slot: u8,
    pub(super) pose: PoseSlots,
}

/// A static number, the same in every instance.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Constant<'t> {
    /// Its name, usually `object.quantity`.
    pub name: &'t str,
    /// What it measures.
    pub dimension: Dimension,
    /// Its value.
    pub value: f64,
}

/// A continuous parameter of the action.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Parameter<'t> {
    /// Its name.
    pub name: &'t str,
    /// What it measures.
    pub dimension: Dimension,
    /// Smallest value.
    pub low: f64,
    /// Largest value.
    pub high: f64,
}

/// What a point is placed in.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Base {
    /// The fixed frame of the world.
    World,
    /// The pose of an object, by its index.
    Object(u8),
    /// An earlier point, by its index.
    Point(u8),
}

/// A point with a direction: the pose of an object, or a virtual object (thesis
/// 4.2) made from another one by turning and then translating in its frame.
/// A point that moves with a parameter is a *sample point*.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Point<'t> {
    /// Name up to the first dot: `holder` of `holder.centre`.
    pub owner: &'t str,
    /// Name behind the first dot, empty if there is none.
    pub part: &'t str,
    /// The frame it is placed in.
    pub base: Base,
    /// Yaw, pitch and roll in that frame, where not zero.
    pub turn: [Option<NodeId>; 3],
    /// Translation in the turned frame, where not zero.
    pub offset: [Option<NodeId>; 3],
    /// Whether it depends on a parameter.
    pub sampled: bool,
    /// To which group it belongs, with the object it is placed in.
    pub member: Option<Member>,
}

impl Point<'_> {
    /// Whether it is the pose of an object itself.
    pub fn is_object(&self) -> bool {
        matches!(self.base, Base::Object(_)) && self.turn == [None; 3] && self.offset == [None; 3]
    }

    /// Whether it has a direction of its own: an object's, or one that is turned
    /// from its base. Points that share a direction make no new angles.
    pub fn has_heading(&self) -> bool {
        self.is_object() || self.turn != [None; 3]
    }
}

impl Domain<'_> {
    /// Whether anything in the domain has a heading: an object's angle, or a turn.
    pub fn has_headings(&self) -> bool {
        let mut objects = self.objects.iter();
        objects.any(|object| object.pose.angles != [None; 3])
            || self.points.iter().any(|point| point.turn != [None; 3])
    }
}

/// The outline of an object.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Shape {
    /// Around the object's position.
    Circle {
        /// Radius.
        radius: NodeId,
    },
    /// Along the object's axes.
    Rectangle {
        /// Extent along the object's x axis.
        width: NodeId,
        /// Extent along the object's y axis.
        height: NodeId,
    },
}

/// The slots of an object's attributes that place it in the world: `x y z` and
/// `theta` (or `yaw`), `pitch`, `roll`.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(super) struct PoseSlots {
    pub(super) position: [Option<u8>; 3],
    pub(super) angles: [Option<u8>; 3],
}

impl PoseSlots {
    /// Finds them by name among attributes that start at `first_slot`.
    pub(super) fn find(attributes: &[Attribute<'_>], first_slot: u8) -> PoseSlots {
        let mut pose = PoseSlots::default();
        for (attribute, slot) in attributes.iter().zip(first_slot..) {
            let [x, y, z] = &mut pose.position;
            let [yaw, pitch, roll] = &mut pose.angles;
            let place = match attribute.name {
                "x" => x,
                "y" => y,
                "z" => z,
                "theta" | "yaw" => yaw,
                "pitch" => pitch,
                "roll" => roll,
                _ => continue,
            };
            *place = Some(slot);
        }
        pose
    }
}

/// Everything the learner may speak about. Made from text by
/// [`Domain::parse`]; it borrows the names from that text.
#[derive(Clone, Debug)]
pub struct Domain<'t> {
    pub(super) types: Vec<Type<'t>, MAX_TYPES>,
    pub(super) attributes: Vec<Attribute<'t>, MAX_ATTRIBUTES>,
    pub(super) objects: Vec<Object<'t>, MAX_OBJECTS>,
    pub(super) groups: Vec<Group, MAX_GROUPS>,
    pub(super) constants: Vec<Constant<'t>, MAX_CONSTANTS>,
    pub(super) parameters: Vec<Parameter<'t>, MAX_PARAMETERS>,
    pub(super) points: Vec<Point<'t>, MAX_POINTS>,
    pub(super) shapes: Vec<(u8, Shape), MAX_SHAPES>,
    pub(super) nodes: Vec<Node, MAX_DOMAIN_NODES>,
    pub(super) slots: u8,
    pub(super) text: &'t str,
    pub(super) fingerprint: u32,
}

impl<'t> Domain<'t> {
    /// The text it was made from.
    pub fn text(&self) -> &'t str {
        self.text
    }

    /// A checksum of the text, to tell domains apart in saved bytes.
    pub fn fingerprint(&self) -> u32 {
        self.fingerprint
    }

    /// The types in order of declaration.
    pub fn types(&self) -> &[Type<'t>] {
        &self.types
    }

    /// The attributes of a type, in order; empty for an index that is none.
    pub fn attributes_of(&self, type_index: u8) -> &[Attribute<'t>] {
        let range = self.types.get(usize::from(type_index)).map(|t| {
            let first = usize::from(t.first);
            first..first + usize::from(t.count)
        });
        range.and_then(|r| self.attributes.get(r)).unwrap_or(&[])
    }

    /// The objects in order of declaration.
    pub fn objects(&self) -> &[Object<'t>] {
        &self.objects
    }

    /// The constants in order of declaration.
    pub fn constants(&self) -> &[Constant<'t>] {
        &self.constants
    }

    /// The parameters of the action in order of declaration.
    pub fn parameters(&self) -> &[Parameter<'t>] {
        &self.parameters
    }

    /// All points, bases before what is placed in them.
    pub fn points(&self) -> &[Point<'t>] {
        &self.points
    }

    /// The shapes, each with the index of its object.
    pub fn shapes(&self) -> &[(u8, Shape)] {
        &self.shapes
    }

    /// The terms that the points and shapes refer to.
    pub fn nodes(&self) -> &[Node] {
        &self.nodes
    }

    /// How many numbers a problem instance has: every attribute of every object,
    /// in order of declaration.
    pub fn instance_len(&self) -> usize {
        usize::from(self.slots)
    }

    /// Every attribute of every object in the order of an instance.
    pub fn slots(&self) -> impl Iterator<Item = (&Object<'t>, &Attribute<'t>)> {
        (0..self.slots).filter_map(|slot| self.slot(slot))
    }

    /// The attribute at a place in an instance, with its object.
    pub(crate) fn slot(&self, slot: u8) -> Option<(&Object<'t>, &Attribute<'t>)> {
        let object = self.owner(slot)?;
        let own = self.attributes_of(object.type_index);
        let attribute = own.get(usize::from(slot - object.first_slot))?;
        Some((object, attribute))
    }

    /// Checks that `instance` has one finite number per attribute; or NaN for all
    /// attributes of a member of a group, which then is absent.
    ///
    /// # Errors
    /// [`Error::InvalidArgument`] for a wrong length, [`Error::NotFinite`].
    pub fn check_instance(&self, instance: &[f64]) -> Result<(), Error> {
        if instance.len() != self.instance_len() {
            return Err(Error::InvalidArgument(
                "an instance needs one number per attribute of every object",
            ));
        }
        let finite = all_finite(instance, "a number of an instance");
        if finite.is_ok() || self.groups.is_empty() {
            return finite;
        }
        self.objects
            .iter()
            .try_for_each(|object| self.check_object(object, instance))
    }

    fn check_object(&self, object: &Object<'_>, instance: &[f64]) -> Result<(), Error> {
        let first = usize::from(object.first_slot);
        let count = self.attributes_of(object.type_index).len();
        let own = instance.get(first..first + count).unwrap_or(&[]);
        if object.member.is_some() && own.iter().all(|number| number.is_nan()) {
            return Ok(());
        }
        all_finite(
            own,
            "a number of an instance that belongs to no absent member of a group",
        )
    }

    /// Checks that `theta` has one finite number per parameter.
    ///
    /// # Errors
    /// [`Error::InvalidArgument`] for a wrong length, [`Error::NotFinite`].
    pub fn check_parameters(&self, theta: &[f64]) -> Result<(), Error> {
        if theta.len() != self.parameters.len() {
            return Err(Error::InvalidArgument(
                "the action needs one number per parameter",
            ));
        }
        all_finite(theta, "a parameter")
    }

    /// Index of the object with this name; of the first member if it is a group.
    pub fn find_object(&self, name: &str) -> Option<u8> {
        index_of(self.objects.iter().position(|o| o.name == name))
    }

    /// Index of the point with this name, `owner` or `owner.part`; that of the
    /// first member if each member of a group has one.
    pub fn find_point(&self, name: &str) -> Option<u8> {
        let (owner, part) = split_at_dot(name).unwrap_or((name, ""));
        let found = |p: &Point<'_>| p.owner == owner && p.part == part;
        index_of(self.points.iter().position(found))
    }

    /// Index of the constant with this name.
    pub fn find_constant(&self, name: &str) -> Option<u8> {
        index_of(self.constants.iter().position(|c| c.name == name))
    }

    /// Index of the parameter with this name.
    pub fn find_parameter(&self, name: &str) -> Option<u8> {
        index_of(self.parameters.iter().position(|p| p.name == name))
    }

    /// Index in an instance of the attribute `object.attribute`; that of the first
    /// member if it is a group.
    pub fn find_slot(&self, name: &str) -> Option<u8> {
        let (owner, attribute) = split_at_dot(name)?;
        let object = self.objects.iter().find(|o| o.name == owner)?;
        let mut own = self.attributes_of(object.type_index).iter();
        let place = index_of(own.position(|a| a.name == attribute))?;
        object.first_slot.checked_add(place)
    }

    /// Index of the shape of the object with this name.
    pub fn find_shape(&self, object: &str) -> Option<u8> {
        let object = self.find_object(object)?;
        index_of(self.shapes.iter().position(|(o, _)| *o == object))
    }

    /// Along how many axes positions in this domain lie: one, two or three.
    pub fn axes(&self) -> usize {
        let depth = |used: [bool; 3]| {
            used.iter()
                .rposition(|used| *used)
                .map_or(0, |axis| axis + 1)
        };
        let axes = self.points.iter().map(|point| {
            let pose = match point.base {
                Base::Object(object) => self.pose_slots(object).position,
                _ => [None; 3],
            };
            let turned = if self.has_headings() { 2 } else { 1 };
            let moved = depth(point.offset.map(|term| term.is_some()));
            moved
                .max(depth(pose.map(|slot| slot.is_some())))
                .max(turned)
        });
        axes.max().unwrap_or(1)
    }

    /// The name of the object that a point is placed in, directly or not.
    pub(crate) fn object_of(&self, point: u8) -> Option<&'t str> {
        let mut base = self.points.get(usize::from(point))?.base;
        loop {
            match base {
                Base::World => return None,
                Base::Object(object) => {
                    return self.objects.get(usize::from(object)).map(|o| o.name);
                }
                // Bases stand before what is placed in them.
                Base::Point(earlier) => base = self.points.get(usize::from(earlier))?.base,
            }
        }
    }

    /// Which attributes of an object place it.
    pub(super) fn pose_slots(&self, object: u8) -> &PoseSlots {
        const NONE: PoseSlots = PoseSlots {
            position: [None; 3],
            angles: [None; 3],
        };
        let object = self.objects.get(usize::from(object));
        object.map_or(&NONE, |o| &o.pose)
    }
}

fn index_of(position: Option<usize>) -> Option<u8> {
    position.and_then(|i| u8::try_from(i).ok())
}

fn all_finite(numbers: &[f64], what: &'static str) -> Result<(), Error> {
    if numbers.iter().all(|x| x.is_finite()) {
        Ok(())
    } else {
        Err(Error::NotFinite(what))
    }
}
