//! What an environment says of its controllers.

use crate::task::{ControllerId, Environment, PredicateId};

/// What can be said of a controller, or of two that run one after the other.
#[derive(Clone, Copy, Debug)]
pub struct Description {
    /// The controller. The parameters of the text are its first ones, the same in all
    /// texts that have any; the others are left to the original sampler.
    pub controller: ControllerId,
    /// A controller that runs later.
    pub later: Option<ControllerId>,
    /// Predicates of one object. An object is a member of a group only if all of them that
    /// are about its type hold of it.
    pub members: &'static [PredicateId],
    /// The domain text; its objects are roles, see [`RoleBinding`](super::RoleBinding).
    pub text: &'static str,
}

impl Description {
    /// What can be said of a controller.
    pub const fn alone(controller: ControllerId, text: &'static str) -> Self {
        Description {
            controller,
            later: None,
            members: &[],
            text,
        }
    }

    /// What can be said of a controller and of one that runs later.
    pub const fn chained(
        controller: ControllerId,
        later: ControllerId,
        text: &'static str,
    ) -> Self {
        Description {
            later: Some(later),
            ..Description::alone(controller, text)
        }
    }

    /// The same with predicates that narrow groups.
    pub const fn with_members(self, members: &'static [PredicateId]) -> Self {
        Description { members, ..self }
    }
}

/// An environment that says what can be said of its controllers.
pub trait Describe: Environment {
    /// The descriptions; those of single controllers first, in the order in which they
    /// are learned.
    const DESCRIPTIONS: &'static [Description];
}
