//! Frames of reference, shapes and bodies.
//!
//! [`Frame2`] and [`Frame3`] are the homogeneous transforms of thesis section
//! 2.1; [`Circle`], [`Rectangle`] and [`Segment`] in the plane and [`Cuboid`] in
//! space are the shapes of the built-in environments, and [`Intersects`] tells
//! whether two of them meet. A [`Body`] is any convex thing with a size, and a [`Relation`]
//! says how two of them lie to each other, as a number. All are generic over [`Real`](crate::real::Real); sine
//! and cosine are computed once, when a frame or a shape is made from an angle.

mod body;
mod cuboid;
mod frame2;
mod frame3;
mod intersect;
mod pieces;
mod relation;
mod rotation;
mod shape;
mod sight;
mod vector;
mod zonogon;
mod zonotope;

pub use body::{Body, Dimensions};
pub use cuboid::Cuboid;
pub use frame2::Frame2;
pub use frame3::Frame3;
pub use intersect::Intersects;
pub use pieces::{Piece, Pieces};
pub use relation::{Axis, Relation, lipschitz, off};
pub(crate) use rotation::Rotation;
pub use shape::{Circle, Rectangle, Segment};
pub use sight::{Swing, SwingPiece, sight};
pub use vector::{Vector2, Vector3, distance, distance_squared};
