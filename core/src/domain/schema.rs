//! A domain: the lists of what it declares, and look-ups in them.

use super::compound::FIRST_COMPOUND;
use super::declarations::{
    Attribute, Base, Body, Compound, Constant, Feature, Group, Object, Parameter, Point, PoseSlots,
    Shape, Type,
};
use super::node::{Node, NodeId, is_same};
use super::point_set::Bits;
use crate::text::split_at_dot;
use heapless::Vec;

/// Most types in a domain.
pub const MAX_TYPES: usize = 16;
/// Most attributes, counted once per type.
pub const MAX_ATTRIBUTES: usize = 64;
/// Most objects in a domain, every member of a group counted.
pub const MAX_OBJECTS: usize = 32;
/// Most groups in a domain.
pub const MAX_GROUPS: usize = 8;
/// Most constants in a domain.
pub const MAX_CONSTANTS: usize = 32;
/// Most continuous parameters of an action.
pub const MAX_PARAMETERS: usize = 6;
/// Most points: placed objects, key points and sample points together, those of
/// every member of a group counted.
pub const MAX_POINTS: usize = 64;
/// Most shapes.
pub const MAX_SHAPES: usize = 16;
/// Most bodies, those of every member of a group counted; none without the feature `bodies`.
pub const MAX_BODIES: usize = if cfg!(feature = "bodies") { 24 } else { 0 };
/// Most compounds; none without the feature `bodies`.
pub const MAX_COMPOUNDS: usize = if cfg!(feature = "bodies") { 4 } else { 0 };
/// Most parts of a compound.
pub const MAX_PARTS: usize = 6;
/// Most features that the text declares.
pub const MAX_FEATURES: usize = 8;
/// Most terms in the offsets, turns and sizes of all points and shapes, and in the features,
/// together.
pub const MAX_DOMAIN_NODES: usize = 128;

/// What relations are enumerated of: points, and compounds by their numbers from zero.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(super) struct Related {
    pub(super) points: Bits,
    pub(super) compounds: Bits,
}

/// Everything that features and regions can speak of. [`Domain::parse`] makes it from a
/// text, from which it borrows the names.
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
    pub(super) bodies: Vec<Body, MAX_BODIES>,
    pub(super) compounds: Vec<Compound<'t>, MAX_COMPOUNDS>,
    pub(super) features: Vec<Feature<'t>, MAX_FEATURES>,
    /// Whether nothing is compared but the features.
    pub(super) compares: bool,
    /// The points that no relation is enumerated of.
    pub(super) hidden: Bits,
    /// The points whose places others say.
    pub(super) repeating: Bits,
    /// The points whose places move with a parameter.
    pub(super) displaced: Bits,
    /// What alone relations are enumerated of, if the text says so.
    pub(super) related: Option<Related>,
    pub(super) nodes: Vec<Node, MAX_DOMAIN_NODES>,
    pub(super) slots: u8,
    pub(super) text: &'t str,
    pub(super) fingerprint: u32,
}

impl<'t> Domain<'t> {
    /// A domain that declares nothing.
    pub const fn empty() -> Domain<'t> {
        Domain {
            types: Vec::new(),
            attributes: Vec::new(),
            objects: Vec::new(),
            groups: Vec::new(),
            constants: Vec::new(),
            parameters: Vec::new(),
            points: Vec::new(),
            shapes: Vec::new(),
            bodies: Vec::new(),
            compounds: Vec::new(),
            features: Vec::new(),
            compares: false,
            hidden: Bits::NONE,
            repeating: Bits::NONE,
            displaced: Bits::NONE,
            related: None,
            nodes: Vec::new(),
            slots: 0,
            text: "",
            fingerprint: 0,
        }
    }

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

    /// The groups in order of declaration.
    pub fn groups(&self) -> &[Group] {
        &self.groups
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

    /// The bodies in order of declaration; those of the members of a group follow one
    /// another.
    pub fn bodies(&self) -> &[Body] {
        &self.bodies
    }

    /// The body of a point, if it has one.
    pub fn body_of(&self, point: u8) -> Option<&Body> {
        self.bodies.iter().find(|body| body.point == point)
    }

    /// Whether a point or compound is none that relations are enumerated of: its shape is
    /// `none`, or the text relates others.
    pub fn is_hidden(&self, number: u8) -> bool {
        let is_related = |related: Related| match number.checked_sub(FIRST_COMPOUND) {
            Some(compound) => related.compounds.has(compound),
            None => related.points.has(number),
        };
        self.hidden.has(number) || !self.related.is_none_or(is_related)
    }

    /// The features that the text declares.
    pub fn features(&self) -> &[Feature<'t>] {
        &self.features
    }

    /// Whether nothing is compared but the features.
    pub fn compares(&self) -> bool {
        self.compares
    }

    /// The feature with this name.
    pub fn find_feature(&self, name: &str) -> Option<&Feature<'t>> {
        let mut named = self.features.iter().filter(|f| !f.name.is_empty());
        named.find(|feature| feature.name == name)
    }

    /// The feature with a name that an expression of a list is.
    pub(super) fn feature_of(&self, nodes: &[Node], id: NodeId) -> Option<&Feature<'t>> {
        let mut named = self.features.iter().filter(|f| !f.name.is_empty());
        named.find(|feature| is_same(&self.nodes, feature.term, nodes, id))
    }

    /// Whether the body of a point is a circle, or a ball.
    pub fn is_round(&self, point: u8) -> bool {
        let solid = self.body_of(point).map(|body| body.solid);
        solid.is_some_and(|solid| solid.radius.is_some() && solid.sizes == [None; 3])
    }

    /// The terms that the points and shapes refer to.
    pub fn nodes(&self) -> &[Node] {
        &self.nodes
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

    /// Whether anything in the domain has a heading: an object's angle, or a turn.
    pub fn has_headings(&self) -> bool {
        let mut objects = self.objects.iter();
        objects.any(|object| object.pose.angles != [None; 3])
            || self.points.iter().any(|point| point.turn != [None; 3])
    }

    /// Whether a parameter turns a point.
    pub(crate) fn turns_points(&self, parameter: u8) -> bool {
        let bit = 1u32.checked_shl(parameter.into()).unwrap_or(0);
        let mut turns = self.points.iter().flat_map(|point| point.turn).flatten();
        turns.any(|id| self.parameters_of(&self.nodes, id) & bit != 0)
    }

    /// Whether the direction of a point is given: by an angle of its object, or a turn.
    pub(crate) fn is_oriented(&self, point: u8) -> bool {
        let mut next = Some(point);
        while let Some(point) = next.and_then(|index| self.points.get(usize::from(index))) {
            let of_object = match point.base {
                Base::Object(object) => self.pose_slots(object).angles != [None; 3],
                Base::World | Base::Point(_) => false,
            };
            if of_object || point.turn != [None; 3] {
                return true;
            }
            next = match point.base {
                Base::Point(earlier) => Some(earlier),
                Base::World | Base::Object(_) => None,
            };
        }
        false
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
    pub(crate) fn pose_slots(&self, object: u8) -> &PoseSlots {
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
