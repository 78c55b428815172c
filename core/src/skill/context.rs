//! What roles are filled from: a state, and the objects of one or two controllers.

use super::setting::Setting;
use crate::task::{ObjectId, PredicateId, State, TypeId};

/// What the roles of a domain text are filled from; see
/// [`RoleBinding`](super::RoleBinding).
#[derive(Debug)]
pub struct Context<'a, S> {
    /// The environment, or whatever else the state is of.
    pub environment: &'a S,
    /// The state before the controller.
    pub state: &'a State,
    /// The objects of the controller.
    pub objects: &'a [ObjectId],
    /// Those of the later one, if there is one.
    pub later_objects: &'a [ObjectId],
    /// Who is a member of a group: see [`Description::members`](super::Description::members).
    pub members: &'a [PredicateId],
}

impl<S: Setting> Context<'_, S> {
    /// Whether an object is none of the controllers'.
    pub(super) fn is_other(&self, object: ObjectId) -> bool {
        !self.objects.contains(&object) && !self.later_objects.contains(&object)
    }

    /// The objects of a type that are members of groups.
    pub(super) fn members(&self, kind: TypeId) -> impl Iterator<Item = ObjectId> {
        self.state.of_type(kind).filter(move |object| {
            let holds = |p: &PredicateId| self.environment.holds_of(*p, self.state, *object);
            self.narrowing(kind).all(holds)
        })
    }

    /// Whether predicates decide which objects of a type are members of groups.
    pub(super) fn is_narrowed(&self, kind: TypeId) -> bool {
        self.narrowing(kind).next().is_some()
    }

    /// The predicates that are about objects of a type.
    fn narrowing(&self, kind: TypeId) -> impl Iterator<Item = &PredicateId> {
        let named = self.members.iter();
        named.filter(move |predicate| self.environment.narrows(**predicate, kind))
    }
}
