//! draft
mod abstraction;
mod algebra;
mod atom;
mod controller;
mod description;
mod dimension;
mod environment;
mod expression;
mod operator;
mod scene;
mod schema;
mod state;
mod task;
mod trial;
pub use abstraction::{AtomSet, Atoms, MAX_ATOMS};
pub use algebra::{Algebra, Arithmetic, Curve, Line, Range};
pub use atom::{
    Arguments, GroundAtom, Groundings, LiftedAtom, MAX_ARGUMENTS, Predicate, PredicateId,
};
pub use controller::{
    Controller, ControllerId, Ending, OfAction, Parameters, Rollout, always, rollout,
};
pub(crate) use description::CHECKSUM;
pub use dimension::Dimension;
pub use environment::{Environment, Failure};
pub use expression::*;
pub use operator::{GroundOperator, Operator, OperatorId, ground_operators};
pub use scene::{MAX_SAMPLE_POINTS, PointSet, Sample, Scene};
pub use schema::*;
pub use state::{MAX_STATE_VALUES, Naming, ObjectId, ObjectName, ObjectType, State, TypeId};
pub use task::{MAX_GOAL_ATOMS, Task};
pub use trial::{Outcome, Verdict, try_operator};
