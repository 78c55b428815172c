//! The tables of a domain.

use super::formula::{Formulas, View};
use super::types::{Type, Types};
use crate::task::{OperatorId, PredicateId, TypeId};
use core::cmp::Ordering;
use heapless::Vec;

/// Most types of a domain, `object` among them, and every `(either ...)` that a problem or
/// a domain mentions.
pub const MAX_TYPES: usize = 64;
/// Most constants of a domain.
pub const MAX_CONSTANTS: usize = 64;
/// Most predicates of a domain.
pub const MAX_PREDICATES: usize = 64;
/// Most functions of a domain.
pub const MAX_FUNCTIONS: usize = 16;
/// Most actions of a domain.
pub const MAX_ACTIONS: usize = 64;
/// Most arguments of all predicates and functions together.
pub const MAX_VARIABLES: usize = 192;
/// Most parameters of all actions and variables of quantifiers together.
pub const MAX_PARAMETERS: usize = 192;
/// Most preconditions and effects of all actions together, words such as `and` among
/// them.
pub const MAX_LITERALS: usize = 768;
/// Most arguments of all preconditions and effects together.
pub const MAX_TERMS: usize = 1024;

/// The id that the function with an index has among the facts of a problem.
pub(super) fn function_id(index: u8) -> PredicateId {
    PredicateId(index.saturating_add(MAX_PREDICATES as u8))
}

/// An object of a problem or a constant of a domain.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Object<'t> {
    /// Its name.
    pub name: &'t str,
    /// Its type; it has all supertypes as well.
    pub type_id: TypeId,
}

/// An argument of a predicate or a parameter of an action.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Variable<'t> {
    /// Its name with the question mark: `?from`.
    pub name: &'t str,
    /// The type of the objects it stands for.
    pub type_id: TypeId,
}

/// A predicate, or a function of which a problem says numbers.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Predicate<'t> {
    /// Its name.
    pub name: &'t str,
    /// Whether no action changes it: what holds initially holds forever.
    pub is_static: bool,
    pub(super) arguments: Span,
}

/// An action: an operator without its controller.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Action<'t> {
    /// Its name.
    pub name: &'t str,
    pub(super) parameters: Span,
    /// The places of its formulas.
    pub(super) precondition: u16,
    pub(super) effect: u16,
}

/// Some neighbours in a table.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(super) struct Span {
    first: u16,
    count: u16,
}

impl Span {
    /// From an index up to the end of a table. No table here has more entries than
    /// its indices can say.
    pub(super) fn since<T>(first: usize, table: &[T]) -> Span {
        Span {
            first: first as u16,
            count: table.len().saturating_sub(first) as u16,
        }
    }

    pub(super) fn of<T>(self, table: &[T]) -> &[T] {
        let first = usize::from(self.first);
        let end = first + usize::from(self.count);
        table.get(first..end).unwrap_or_default()
    }
}

/// What a domain declares, besides types.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub(super) struct Declarations<'t> {
    pub(super) constants: Vec<Object<'t>, MAX_CONSTANTS>,
    pub(super) predicates: Vec<Predicate<'t>, MAX_PREDICATES>,
    pub(super) functions: Vec<Predicate<'t>, MAX_FUNCTIONS>,
    pub(super) variables: Vec<Variable<'t>, MAX_VARIABLES>,
}

/// A domain: types, constants, predicates and actions. Its names are slices of its
/// text; `Display` writes it as PDDL.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Domain<'t> {
    pub(super) name: &'t str,
    pub(super) types: Types<'t>,
    pub(super) declared: Declarations<'t>,
    pub(super) actions: Vec<Action<'t>, MAX_ACTIONS>,
    pub(super) formulas: Formulas<'t, MAX_LITERALS, MAX_TERMS, MAX_PARAMETERS>,
}

impl<'t> Declarations<'t> {
    /// The constant with this name and its index.
    pub(super) fn find_constant(&self, name: &str) -> Option<(u8, &Object<'t>)> {
        let place = index_of(self.constants.iter().map(|c| c.name), name)?;
        Some((place, self.constants.get(usize::from(place))?))
    }

    pub(super) fn is_static(&self, predicate: PredicateId) -> bool {
        let predicate = self.predicates.get(usize::from(predicate.0));
        predicate.is_some_and(|p| p.is_static)
    }
}

impl<'t> Domain<'t> {
    /// Its name.
    pub fn name(&self) -> &'t str {
        self.name
    }

    /// The types: `object`, then in order of declaration, then each `(either ...)`.
    pub fn types(&self) -> &[Type<'t>] {
        self.types.as_slice()
    }

    /// The constants in order of declaration.
    pub fn constants(&self) -> &[Object<'t>] {
        &self.declared.constants
    }

    /// The predicates in order of declaration; a [`PredicateId`] is an index.
    pub fn predicates(&self) -> &[Predicate<'t>] {
        &self.declared.predicates
    }

    /// The actions in order of declaration; an [`OperatorId`] is an index.
    pub fn actions(&self) -> &[Action<'t>] {
        &self.actions
    }

    /// The arguments of a predicate of this domain.
    pub fn arguments(&self, predicate: &Predicate<'t>) -> &[Variable<'t>] {
        predicate.arguments.of(&self.declared.variables)
    }

    /// The parameters of an action of this domain.
    pub fn parameters(&self, action: &Action<'t>) -> &[Variable<'t>] {
        action.parameters.of(&self.formulas.variables)
    }

    /// The type with this name.
    pub fn find_type(&self, name: &str) -> Option<TypeId> {
        self.types.find(name)
    }

    /// The predicate with this name.
    pub fn find_predicate(&self, name: &str) -> Option<PredicateId> {
        index_of(self.predicates().iter().map(|p| p.name), name).map(PredicateId)
    }

    /// The action with this name.
    pub fn find_action(&self, name: &str) -> Option<OperatorId> {
        index_of(self.actions.iter().map(|a| a.name), name).map(OperatorId)
    }

    /// Whether what is of the first type is of the second as well.
    pub fn is_subtype(&self, type_id: TypeId, of: TypeId) -> bool {
        self.types.is_subtype(type_id, of)
    }

    /// The actions in the order of their names.
    pub(super) fn actions_by_name(&self) -> impl Iterator<Item = (OperatorId, &Action<'t>)> {
        let next = |last: Option<&str>| {
            let rest = (0..).map(OperatorId).zip(&self.actions);
            rest.filter(|(_, a)| last.is_none_or(|last| compare(last, a.name).is_lt()))
                .min_by(|(_, a), (_, b)| compare(a.name, b.name))
        };
        core::iter::successors(next(None), move |(_, last)| next(Some(last.name)))
    }

    /// The formulas of its actions.
    pub(super) fn view(&self) -> View<'_, 't> {
        self.formulas.view()
    }
}

/// The place of a name among others.
pub(super) fn index_of<'n>(mut names: impl Iterator<Item = &'n str>, name: &str) -> Option<u8> {
    let place = names.position(|n| n.eq_ignore_ascii_case(name))?;
    u8::try_from(place).ok()
}

/// What is said about a second declaration of a name.
pub(super) const DECLARED_TWICE: &str = "this name is declared already";

/// The order of names, in which case does not matter.
pub(super) fn compare(a: &str, b: &str) -> Ordering {
    let lower = |byte: u8| byte.to_ascii_lowercase();
    a.bytes().map(lower).cmp(b.bytes().map(lower))
}
