//! Who fills roles: a state, and the objects of one or two controllers.

use crate::task::{Environment, ObjectId, PredicateId, State, TypeId};

/// What the roles of a domain text are filled from; see [`Binding`](super::Binding).
#[derive(Debug)]
pub struct Scope<'a, E> {
    /// The environment.
    pub environment: &'a E,
    /// The state before the controller.
    pub state: &'a State,
    /// The objects of the controller.
    pub own: &'a [ObjectId],
    /// Those of the later one, if there is one.
    pub later: &'a [ObjectId],
    /// Predicates of one object that hold of every member of a group.
    pub among: &'a [PredicateId],
}

impl<E: Environment> Scope<'_, E> {
    /// The objects of a type that count as members of groups.
    pub(super) fn members(&self, kind: TypeId) -> impl Iterator<Item = ObjectId> {
        self.state.of_type(kind).filter(move |object| {
            let mut narrowing = self.narrowing(kind);
            narrowing
                .all(|predicate| (predicate.classifier)(self.environment, self.state, &[*object]))
        })
    }

    /// Whether predicates decide which objects of a type are members of groups.
    pub(super) fn is_narrowed(&self, kind: TypeId) -> bool {
        self.narrowing(kind).next().is_some()
    }

    /// The predicates that are about objects of a type.
    fn narrowing(&self, kind: TypeId) -> impl Iterator<Item = &'static crate::task::Predicate<E>> {
        let all = E::PREDICATES;
        let named = self
            .among
            .iter()
            .filter_map(|id| all.get(usize::from(id.0)));
        named.filter(move |predicate| predicate.arguments == [kind])
    }
}
