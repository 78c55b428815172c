//! What a planner knows of an action (thesis 4.1.1), for learning: a [`Domain`] has
//! types, objects with attributes, constants, the parameters of the action, and points.
//! [`Node`]s are terms over it; a [`Scene`] puts an instance into them, a [`Sample`]
//! parameters.
//!
//! # The domain text
//!
//! ```text
//! domain    = { statement } ;                                (* "#" starts a comment *)
//! statement = type | object | constant | parameter | shape | point
//!           | feature | compare | relate ;
//! type      = "type" name attributes ;
//! object    = "object" named ( attributes | { "," named } ":" name ) ;
//! named     = name [ "[" number "]" ] ;                      (* a group of this many members *)
//! attributes= "{" [ name ":" dimension { "," name ":" dimension } ] "}" ;
//! dimension = "length" | "angle" | "area" | "flag" | "none" ;
//! constant  = "constant" path "=" expr ":" dimension ;
//! parameter = "parameter" name "in" "[" expr "," expr "]" [ ":" dimension ] ;
//! shape     = "shape" path "=" ( solid [ "rounded" factor ] [ "centred" ] | "none" )
//!           | "shape" name "=" path { "+" path } ;           (* of earlier bodies *)
//! solid     = "circle" "(" expr ")"                          (* a ball in space *)
//!           | "rectangle" "(" expr "," expr ")"              (* a plate in space *)
//!           | "box" "(" expr "," expr "," expr ")"
//!           | "capsule" "(" expr "," expr ")"                (* length along x, radius *)
//!           | "segment" "(" expr ")" ;                       (* along x *)
//! point     = "point" path "=" frame [ "turned" turn ] [ "+" offset ] ;
//! frame     = "world" | path ;                               (* an object or an earlier point *)
//! turn      = factor | "(" expr "," expr "," expr ")" ;      (* yaw, or yaw, pitch, roll *)
//! offset    = "(" expr "," expr [ "," expr ] ")" ;
//! feature   = "feature" path "=" expr [ ":" dimension ] ;    (* a name for an expression *)
//! compare   = "compare" expr { "," expr } ;                  (* these and no others *)
//! relate    = "relate" path { "," path } ;                   (* these and no others *)
//! expr      = term { ( "+" | "-" ) term } ;
//! term      = factor { ( "*" | "/" ) factor } ;
//! factor    = number | "pi" | path | "-" factor | "(" expr ")" | call | extreme ;
//! extreme   = ( "min" | "max" ) "(" ( path | call ) ")" ;    (* over the members of a group *)
//! call      = ( "dist" | "dist_x" | "dist_y" | "dist_z" | "angle" | "off" ) "(" path "," path ")"
//!           | "angle" "(" path "," path "," path ")"         (* at the second point *)
//!           | "angle" "(" path "," path "," symmetry ")"     (* of headings *)
//!           | relation "(" path "," path ")"                 (* between their bodies *)
//!           | "clear" "(" line "," path ")"
//!           | "area" "(" name ")" ;
//! relation  = "clear" | "inside" | "inside_x" | "inside_y" | "inside_z" | "over" | "corner"
//!           | "x_in" | "y_in" | "z_in" | "abs_x_in" | "abs_y_in" | "abs_z_in" ;
//! symmetry  = plain { "*" plain } | "symmetry" number ;      (* 2 pi / n, or n *)
//! plain     = number | "pi" | path ;
//! line      = ( "line" | "sweep" ) "(" path "," path ")" ;   (* from point to point *)
//! path      = name { "." name } ;
//! name      = ( letter | "_" ) { letter | digit | "_" } ;
//! ```
//!
//! No name is a word of the language: one of a statement, a function or a line, `in`, `turned`,
//! `world`, `rounded`, `centred`, `symmetry`, `pi`, `and`, `or`, `not` or `true`. Those of
//! solids and dimensions may be names, and an attribute may have any name.
//!
//! An object whose type has the attributes `x` and `y` (and `z`, and the angles `theta` or
//! `yaw`, `pitch`, `roll`) is a point as well. The corner of a `rectangle` is the
//! object's position unless it is `centred`; a circle or a rectangle of constant sizes on an
//! object adds the key points `left`, `right`, `bottom`, `top` and, for rectangles, `centre`
//! (thesis 4.2).
//! Offsets, turns and sizes are made of numbers, constants, attributes and
//! parameters; a point that depends on a parameter is a sample point.
//!
//! The angle of two headings is in `[0, pi]`. Where one of them belongs to a thing that looks
//! the same after a turn by `2 pi / n`, `angle(a, b, pi)`, `angle(a, b, 0.5*pi)` or in general
//! `angle(a, b, symmetry n)` is how far it is from the nearest such turn, in `[0, pi / n]`.
//!
//! # Bodies
//!
//! A shape makes a body of an object or of a point, also of one that moves with parameters,
//! and one of each member of a group, with sizes of its own. Relations between two bodies
//! ([`Relation`](crate::geometry::Relation)) are lengths that are the same in every frame:
//!
//! ```
//! use critreg::{domain::Domain, region::Region};
//! let domain = Domain::parse(
//!     "object tray { x: length, y: length, theta: angle, width: length, depth: length }
//!      object item { width: length, depth: length }
//!      parameter px in [-0.5, 0.5]: length
//!      parameter py in [-0.5, 0.5]: length
//!      parameter yaw in [-0.5*pi, 0.5*pi]: angle
//!      point spot = world + (px, py)
//!      point place = spot turned yaw
//!      shape tray  = rectangle(tray.width, tray.depth) centred
//!      shape place = rectangle(item.width, item.depth) centred",
//! )?;
//! let region = Region::parse(&domain, "inside(place, tray) >= 0")?;
//! // A tray that is turned by a quarter, and an item that fits with 5 cm on each side.
//! let instance = [0.0, 0.0, core::f64::consts::FRAC_PI_2, 0.4, 0.25, 0.3, 0.15];
//! let fits = |theta: [f64; 3]| region.contains::<f64>(&domain, &instance, &theta);
//! assert!(fits([0.04, 0.0, 1.57])? && !fits([0.06, 0.0, 1.57])? && !fits([0.0, 0.0, 0.0])?);
//! # Ok::<(), critreg::Error>(())
//! ```
//!
//! The straight line between two points is a body, too: `clear(line(eye, sign), post) >= 0`
//! says that the sign is seen past the post. A `sweep` is as wide as the circle of its first
//! point, which drives along it. And `off(sign, eye) <= 0.5` says that the sign is in a cone
//! about the x axis of the eye: it is the angle between that axis and the direction there.
//!
//! Several bodies may have one name: of `shape gripper = left + right` the least value over
//! the parts counts, so `clear(gripper, can) >= 0` holds of both. Only rooms and clearances
//! are said of it, and it may be the second body of `clear` only. A name whose shape is `none`
//! is only there for others to be placed in: learners say nothing of how it lies to things.
//!
//! `rounded r` grows a solid by `r` on all sides.
//!
//! A point without a shape is a body without extent. A size below zero is that of an absent
//! body, of which no constraint holds.
//!
//! # Features
//!
//! Whoever knows a law writes it down once: `feature slide = v*v / (2*9.81*ground.mu): length`
//! is compared as any other feature of the grammar, before all others, and regions call it by
//! its name. What a product or a quotient measures is what the text says; without, it follows
//! from the factors: a length times a length is an area, an angle times a length a length, as
//! angles are in radians, and flags and plain numbers scale. Where there is no word for it, as
//! for a volume or a mass divided by a length, it fits every number. `compare hand.x, slide` says that these, and the features with a name, are all
//! that is compared, and `relate gripper, can` that relations between points and bodies are
//! enumerated of these only.
//!
//! # Groups
//!
//! `object obstacle[6]: block` is a group: any number of blocks up to six. An
//! instance has the numbers of all six; a member that is absent has NaN for each of
//! its numbers. A shape or point of a group is one of each member, and its offset may
//! name the attributes of that member. What is said of a group is the least or the
//! greatest value over the members that are there, which is how one says "for all":
//!
//! ```
//! use critreg::{domain::Domain, region::Region};
//! let domain = Domain::parse(
//!     "object obstacle[3] { x: length, y: length }
//!      parameter reach in [0, 4]: length
//!      point hand = world + (reach, 0)",
//! )?;
//! let region = Region::parse(&domain, "min(dist(hand, obstacle)) >= 0.5")?;
//! const NO: f64 = f64::NAN;
//! let ends = |instance: &[f64]| -> Result<Vec<[f64; 2]>, critreg::Error> {
//!     let grounded = region.ground::<f64>(&domain, instance)?;
//!     let intervals = grounded.intervals()?.intervals();
//!     Ok(intervals.iter().map(|i| [i.low, i.high]).collect())
//! };
//! assert_eq!(ends(&[1.0, 0.0, 3.0, 0.0, NO, NO])?, [[0.0, 0.5], [1.5, 2.5], [3.5, 4.0]]);
//! assert_eq!(ends(&[NO, NO, 3.0, 0.0, NO, NO])?, [[0.0, 2.5], [3.5, 4.0]]);
//! assert_eq!(ends(&[NO; 6])?, [[0.0, 4.0]]);
//! # Ok::<(), critreg::Error>(())
//! ```
//!
//! Over no members the least value is infinite and the greatest minus infinite. So where
//! no member is there, a least value is above every bound, and a greatest one below.

mod algebra;
mod coincidence;
mod compound;
mod declarations;
mod description;
mod dimension;
mod expression;
mod group;
mod instance;
pub(crate) use instance::{TOO_LARGE, held};
mod node;
mod point_set;
mod sample;
mod scene;
mod schema;
mod similar;
mod turns;

pub(crate) use node::{TermError, copy, intern, is_same};

pub use algebra::{Algebra, Arithmetic, Bend, Curve, Line, Measure, Range};
pub use declarations::{
    Attribute, Base, Body, Compound, Constant, Feature, Group, Member, Object, Parameter, Point,
    Shape, Solid, Type,
};
pub use dimension::Dimension;
pub use expression::{Dependence, MAX_DEPTH};
pub use node::{Beam, Coordinate, Extreme, Metric, Node, NodeId, Quantity, SYMMETRIES, Share};
pub use point_set::PointSet;
pub use sample::Sample;
pub use scene::{MAX_SAMPLE_POINTS, Scene};
pub use schema::{
    Domain, MAX_ATTRIBUTES, MAX_BODIES, MAX_COMPOUNDS, MAX_CONSTANTS, MAX_DOMAIN_NODES,
    MAX_FEATURES, MAX_GROUPS, MAX_OBJECTS, MAX_PARAMETERS, MAX_PARTS, MAX_POINTS, MAX_SHAPES,
    MAX_TYPES,
};
pub use similar::Name;
