//! What a domain can declare: types, objects, groups, constants, parameters, points
//! and shapes.

use super::dimension::Dimension;
use super::node::NodeId;
use super::schema::MAX_PARTS;
use heapless::Vec;

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
    /// The group that it belongs to.
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
    /// The group that it and the object it is placed in belong to.
    pub member: Option<Member>,
}

impl Point<'_> {
    /// Whether it is the pose of an object itself.
    pub fn is_object(&self) -> bool {
        matches!(self.base, Base::Object(_)) && self.turn == [None; 3] && self.offset == [None; 3]
    }

    /// Whether it lies on an object and moves with no parameter, as a corner does.
    pub fn is_key_point(&self) -> bool {
        !self.sampled && !self.part.is_empty()
    }

    /// Whether it has a direction of its own: an object's, or one that is turned
    /// from its base. Points that share a direction make no new angles.
    pub fn has_heading(&self) -> bool {
        self.is_object() || self.turn != [None; 3]
    }
}

/// Objects of one type under one name. The members follow one another among the objects,
/// and their numbers and points follow one another in the same order.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Group {
    /// Index of the first member among the objects.
    pub first_object: u8,
    /// How many members there can be.
    pub count: u8,
}

/// The group of an object or point, and its place there.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Member {
    /// Index of the group.
    pub group: u8,
    /// Which of its members, from 0.
    pub index: u8,
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

/// The form of a body in the frame of its point: sizes along the axes of the frame, and a
/// radius around that. A ball, a segment, a capsule, a rectangle, a rounded rectangle, a box.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Solid {
    /// The size along each axis, where it has one.
    pub sizes: [Option<NodeId>; 3],
    /// The radius, if it is round.
    pub radius: Option<NodeId>,
    /// Whether the point is its centre, and not the corner where it begins.
    pub centred: bool,
}

/// What has an extent: a solid that stands and turns as a point does.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Body {
    /// The point, which may be an object.
    pub point: u8,
    /// What is there.
    pub solid: Solid,
}

/// An expression that hypotheses are about because the text says so.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Feature<'t> {
    /// Its name; empty for one that has none.
    pub name: &'t str,
    /// The expression, among the terms of the domain.
    pub term: NodeId,
    /// What it measures, if the text says so.
    pub dimension: Option<Dimension>,
}

/// Several bodies under one name.
#[derive(Clone, Debug, PartialEq)]
pub struct Compound<'t> {
    /// Its name.
    pub name: &'t str,
    /// The points whose bodies are its parts.
    pub parts: Vec<u8, MAX_PARTS>,
}

impl Body {
    /// The terms of its sizes.
    pub fn terms(&self) -> impl Iterator<Item = NodeId> {
        let Solid { sizes, radius, .. } = self.solid;
        sizes.into_iter().flatten().chain(radius)
    }
}

/// The slots of an object's attributes that place it in the world: `x y z`, and of what has
/// `x` and `y` the angles `theta` (or `yaw`), `pitch`, `roll`. The pitch of a thread is a
/// length, and turns nothing.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) struct PoseSlots {
    pub(crate) position: [Option<u8>; 3],
    pub(crate) angles: [Option<u8>; 3],
}

impl PoseSlots {
    /// Finds the slots by name among attributes that start at `first_slot`.
    pub(super) fn find(attributes: &[Attribute<'_>], first_slot: u8) -> PoseSlots {
        let mut pose = PoseSlots::default();
        for (attribute, slot) in attributes.iter().zip(first_slot..) {
            let [x, y, z] = &mut pose.position;
            let [yaw, pitch, roll] = &mut pose.angles;
            let place = match (attribute.name, attribute.dimension) {
                ("x", _) => x,
                ("y", _) => y,
                ("z", _) => z,
                ("theta" | "yaw", Dimension::Angle) => yaw,
                ("pitch", Dimension::Angle) => pitch,
                ("roll", Dimension::Angle) => roll,
                _ => continue,
            };
            *place = Some(slot);
        }
        if !pose.has_place() {
            pose.angles = [None; 3];
        }
        pose
    }

    /// Whether it makes a point.
    pub(super) fn has_place(&self) -> bool {
        matches!(self.position, [Some(_), Some(_), _])
    }
}
