//! Which objects the parameters of an action can have.

use super::Grounding;
use crate::error::Error;
use crate::pddl::formula::{Kind, MAX_BOUND, Node, View};
use crate::pddl::schema::{Action, Variable};
use crate::task::{GroundAtom, MAX_ARGUMENTS, ObjectId, PredicateId};
use core::cmp::Ordering;
use heapless::Vec;

/// How many objects, facts and terms are looked at, at most, until all atoms are known, and
/// again until all operators are: a fraction of a second.
const MOST_WORK: u32 = 1 << 23;

/// What was looked at.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Work(u32);

impl Work {
    pub(super) fn spend(&mut self, count: usize) -> Result<(), Error> {
        let count = u32::try_from(count).unwrap_or(u32::MAX);
        self.0 = self.0.saturating_add(count).saturating_add(1);
        match self.0 > MOST_WORK {
            true => Err(Error::CapacityExceeded(
                "work of grounding: more than 8 million objects, facts and terms to look at; \
                 give actions fewer parameters, or types and preconditions that leave fewer objects",
            )),
            false => Ok(()),
        }
    }
}

/// The objects of variables.
#[derive(Clone, Copy, Debug, Default)]
pub(in crate::pddl) struct Binding([Option<ObjectId>; MAX_BOUND]);

impl Binding {
    pub(in crate::pddl) fn get(&self, place: u8) -> Option<ObjectId> {
        self.0.get(usize::from(place)).copied().flatten()
    }

    /// The objects of the first variables.
    pub(super) fn objects(&self, count: usize) -> impl Iterator<Item = ObjectId> {
        self.0.iter().take(count).filter_map(|object| *object)
    }

    /// The same, with an object for one more variable.
    pub(super) fn with(mut self, place: u8, object: ObjectId) -> Binding {
        if let Some(slot) = self.0.get_mut(usize::from(place)) {
            *slot = Some(object);
        }
        self
    }
}

/// A binding, and the place of the variable that a quantifier would add.
pub(super) type Bound<'b> = (&'b Binding, u8);

/// A formula by its place, and whether its opposite is meant.
pub(super) type Signed = (u16, bool);

/// The objects that are looked for in an atom.
type Pattern = Vec<Option<ObjectId>, MAX_ARGUMENTS>;

impl<'t, const N: usize> Grounding<'_, 't, N> {
    /// Hands on all objects that the precondition of an action admits as far as is known,
    /// the last parameter changing fastest.
    ///
    /// A choice is dropped as soon as a part of the precondition fails for it, whatever the
    /// rest will be: so it is a join on what holds, and no enumeration of everything.
    pub(super) fn choices(
        &mut self,
        action: &Action<'t>,
        visit: &mut dyn FnMut(&mut Self, &Binding) -> Result<(), Error>,
    ) -> Result<(), Error> {
        let variables = self.problem.domain().parameters(action);
        self.choose(
            (action.precondition, variables),
            0,
            &Binding::default(),
            visit,
        )
    }

    fn choose(
        &mut self,
        (precondition, variables): (u16, &[Variable<'t>]),
        place: u8,
        binding: &Binding,
        visit: &mut dyn FnMut(&mut Self, &Binding) -> Result<(), Error>,
    ) -> Result<(), Error> {
        let view = self.problem.domain().view();
        let next = variables.get(usize::from(place));
        let complete = next.is_none();
        let end = variables.len() as u8;
        if !self.is_possible(view, (precondition, false), (binding, end), complete)? {
            return Ok(());
        }
        let Some(variable) = next else {
            return visit(self, binding);
        };
        let problem = self.problem;
        for object in problem.of_type(variable.type_id) {
            self.work.spend(0)?;
            let longer = binding.with(place, object);
            self.choose((precondition, variables), place + 1, &longer, visit)?;
        }
        Ok(())
    }

    /// Calls `visit` with all objects of the variables of a quantifier, until it says that
    /// it is enough.
    pub(super) fn quantify(
        &mut self,
        variables: &[Variable<'t>],
        (binding, place): Bound<'_>,
        visit: &mut dyn FnMut(&mut Self, Bound<'_>) -> Result<bool, Error>,
    ) -> Result<bool, Error> {
        let Some((variable, rest)) = variables.split_first() else {
            return visit(self, (binding, place));
        };
        let problem = self.problem;
        for object in problem.of_type(variable.type_id) {
            self.work.spend(0)?;
            let longer = binding.with(place, object);
            if !self.quantify(rest, (&longer, place + 1), visit)? {
                return Ok(false);
            }
        }
        Ok(true)
    }

    /// Whether a condition, or its opposite, may hold sometime, as far as is known: what
    /// has variables without objects, and what is negative, may.
    pub(super) fn is_possible(
        &mut self,
        view: View<'_, 't>,
        (place, negated): Signed,
        bound: Bound<'_>,
        complete: bool,
    ) -> Result<bool, Error> {
        let Some(node) = view.node(place) else {
            return Ok(true);
        };
        self.work.spend(0)?;
        match node.kind {
            Kind::And | Kind::Or => {
                let all = (node.kind == Kind::And) != negated;
                for child in view.children(place) {
                    if self.is_possible(view, (child, negated), bound, complete)? != all {
                        return Ok(!all);
                    }
                }
                Ok(all)
            }
            Kind::Not => self.is_possible(view, (place + 1, !negated), bound, complete),
            Kind::Imply => {
                let Some((first, second)) = view.pair(place) else {
                    return Ok(true);
                };
                let first = self.is_possible(view, (first, !negated), bound, complete)?;
                let second = self.is_possible(view, (second, negated), bound, complete)?;
                Ok(if negated {
                    first && second
                } else {
                    first || second
                })
            }
            // Not before it is clear what the parameters are.
            Kind::Forall | Kind::Exists if !complete => Ok(true),
            Kind::Forall | Kind::Exists => {
                let all = (node.kind == Kind::Forall) != negated;
                let mut outcome = all;
                self.quantify(view.variables(node), bound, &mut |own, bound| {
                    outcome = own.is_possible(view, (place + 1, negated), bound, true)?;
                    Ok(outcome == all)
                })?;
                Ok(outcome)
            }
            Kind::Atom(predicate) => self.may_hold(view, node, predicate, negated, bound.0),
            Kind::Equal => Ok(self
                .are_equal(view, node, bound.0)
                .is_none_or(|equal| equal != negated)),
            Kind::When | Kind::Increase(_) | Kind::IncreaseBy(_) => Ok(true),
        }
    }

    /// Whether two terms are one object, if it is clear.
    pub(super) fn are_equal(
        &self,
        view: View<'_, 't>,
        node: Node,
        binding: &Binding,
    ) -> Option<bool> {
        let mut objects = view.terms(node).iter();
        let mut next = || self.object(*objects.next()?, binding);
        Some(next()? == next()?)
    }

    fn may_hold(
        &mut self,
        view: View<'_, 't>,
        node: Node,
        predicate: PredicateId,
        negated: bool,
        binding: &Binding,
    ) -> Result<bool, Error> {
        let is_static = self.problem.domain().declared.is_static(predicate);
        let terms = view.terms(node).iter();
        let pattern: Pattern = terms.map(|term| self.object(*term, binding)).fold(
            Pattern::new(),
            |mut pattern, object| {
                // A predicate has no more arguments than there is room for.
                let _ = pattern.push(object);
                pattern
            },
        );
        if negated && (!is_static || pattern.contains(&None)) {
            return Ok(true);
        }
        let (found, looked_at) = match is_static {
            true => {
                let facts = self.problem.facts();
                find(facts, |fact| &fact.atom, predicate, &pattern, |_| true)
            }
            false => {
                let atoms = self.atoms.as_slice();
                let can_hold = |place| !self.hopeless.contains(place);
                find(atoms, |atom| atom, predicate, &pattern, can_hold)
            }
        };
        self.work.spend(looked_at)?;
        Ok(found != negated)
    }
}

/// Whether an atom of a sorted table at a place that counts has these objects where some
/// are given, and how many were looked at.
fn find<T>(
    table: &[T],
    atom: fn(&T) -> &GroundAtom,
    predicate: PredicateId,
    pattern: &[Option<ObjectId>],
    counts: impl Fn(u32) -> bool,
) -> (bool, usize) {
    let order = |item: &T| -> Ordering {
        let atom = atom(item);
        let given = pattern.iter().map_while(|object| *object);
        let objects = atom.objects.as_slice().iter().zip(given);
        let differing = objects.map(|(own, given)| own.cmp(&given));
        let mut differing = differing.filter(|order| order.is_ne());
        let predicates = atom.predicate.cmp(&predicate);
        predicates.then(differing.next().unwrap_or(Ordering::Equal))
    };
    let first = table.partition_point(|item| order(item).is_lt());
    let rest = (0..).zip(table).skip(first);
    let mut looked_at = 0;
    for (place, item) in rest.take_while(|(_, item)| order(item).is_eq()) {
        looked_at += 1;
        let objects = atom(item).objects;
        let mut pairs = objects.as_slice().iter().zip(pattern);
        let fits = pairs.all(|(own, given)| given.is_none_or(|given| given == *own));
        if fits && counts(place) {
            return (true, looked_at);
        }
    }
    (false, looked_at)
}
