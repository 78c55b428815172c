//! Conditions with alternatives and conditional effects, split into what a search takes:
//! sets of atoms that shall hold, are added and are deleted.

use super::Grounding;
use super::choices::{Binding, Bound, Signed};
use crate::error::Error;
use crate::pddl::formula::{Kind, View};
use crate::pddl::schema::Variable;
use crate::task::{AtomSet, GroundAtom};
use heapless::Vec;

/// Most operators that an action with its objects, or a goal, is split into.
pub(super) const MOST: usize = 64;

/// Room for them, and for those that they are made of.
const ROOM: usize = 2 * MOST;

const TOO_MANY: Error = Error::CapacityExceeded(
    "alternatives: more than 64 of one action with its objects, or of the goal",
);

/// One of the operators that an action with its objects is split into.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) struct Variant<const N: usize> {
    pub(super) needs: AtomSet<N>,
    adds: AtomSet<N>,
    deletes: AtomSet<N>,
}

/// All of them. What is done to those from a place on leaves those before untouched.
pub(super) type Variants<const N: usize> = Vec<Variant<N>, ROOM>;

/// What is done with a formula in a branch.
type Step<'s, 'a, 't, const N: usize> =
    &'s mut dyn FnMut(&mut Grounding<'a, 't, N>, &mut Variants<N>, usize) -> Result<(), Error>;

impl<'a, 't, const N: usize> Grounding<'a, 't, N> {
    /// Makes the variants from a place on need a condition, or its opposite. Those for
    /// which it cannot hold are left out; alternatives make more of them.
    pub(super) fn require(
        &mut self,
        view: View<'_, 't>,
        (place, negated): Signed,
        bound: Bound<'_>,
        list: &mut Variants<N>,
        start: usize,
    ) -> Result<(), Error> {
        let Some(node) = view.node(place) else {
            return Ok(());
        };
        match node.kind {
            Kind::And | Kind::Or => {
                let mut branches = Branches::new((node.kind == Kind::And) != negated, list, start);
                for child in view.children(place) {
                    branches.take(self, list, &mut |own, list, start| {
                        own.require(view, (child, negated), bound, list, start)
                    })?;
                }
                branches.end(list)?;
            }
            Kind::Not => self.require(view, (place + 1, !negated), bound, list, start)?,
            Kind::Imply => {
                let mut branches = Branches::new(negated, list, start);
                if let Some((first, second)) = view.pair(place) {
                    for signed in [(first, !negated), (second, negated)] {
                        branches.take(self, list, &mut |own, list, start| {
                            own.require(view, signed, bound, list, start)
                        })?;
                    }
                }
                branches.end(list)?;
            }
            Kind::Forall | Kind::Exists => {
                let all = (node.kind == Kind::Forall) != negated;
                let variables = view.variables(node);
                self.for_each(
                    variables,
                    bound,
                    all,
                    (list, start),
                    &mut |own, bound, list, start| {
                        own.require(view, (place + 1, negated), bound, list, start)
                    },
                )?;
            }
            Kind::Atom(predicate) => {
                if let Some(atom) = self.atom(predicate, view.terms(node), bound.0) {
                    self.require_atom(atom, negated, list, start);
                }
            }
            Kind::Equal => {
                if self.are_equal(view, node, bound.0) == Some(negated) {
                    list.truncate(start);
                }
            }
            Kind::When | Kind::Increase(_) | Kind::IncreaseBy(_) => {}
        }
        Ok(())
    }

    /// Does something for all objects of a quantifier, all at once or as alternatives.
    #[expect(clippy::type_complexity, reason = "one closure, used once")]
    fn for_each(
        &mut self,
        variables: &[Variable<'t>],
        bound: Bound<'_>,
        all: bool,
        (list, start): (&mut Variants<N>, usize),
        step: &mut dyn FnMut(&mut Self, Bound<'_>, &mut Variants<N>, usize) -> Result<(), Error>,
    ) -> Result<(), Error> {
        let mut branches = Branches::new(all, list, start);
        self.quantify(variables, bound, &mut |own, bound| {
            branches.take(own, list, &mut |own, list, start| {
                step(own, bound, list, start)
            })?;
            Ok(!branches.is_decided(list))
        })?;
        branches.end(list)
    }

    fn require_atom(
        &mut self,
        atom: GroundAtom,
        negated: bool,
        list: &mut Variants<N>,
        start: usize,
    ) {
        let wanted = if negated { atom.negation() } else { atom };
        let (bit, opposite) = (
            self.atoms.singleton(&wanted),
            self.atoms.singleton(&wanted.negation()),
        );
        let Some(bit) = bit else {
            // It has no place, as it never changes, or never holds.
            let is_static = self.problem.domain().declared.is_static(atom.predicate);
            let holds = is_static && self.problem.holds_initially(&atom);
            if holds == negated {
                list.truncate(start);
            }
            return;
        };
        let opposite = opposite.unwrap_or_default();
        let mut kept = start;
        for place in start..list.len() {
            let Some(mut variant) = list.get(place).copied() else {
                break;
            };
            variant.needs = variant.needs.union(bit);
            if variant.needs.intersection(opposite).is_empty() {
                if let Some(slot) = list.get_mut(kept) {
                    *slot = variant;
                }
                kept += 1;
            }
        }
        list.truncate(kept);
    }

    /// Makes the variants from a place on have an effect.
    pub(super) fn apply(
        &mut self,
        view: View<'_, 't>,
        place: u16,
        bound: Bound<'_>,
        list: &mut Variants<N>,
        start: usize,
    ) -> Result<(), Error> {
        let Some(node) = view.node(place) else {
            return Ok(());
        };
        match node.kind {
            Kind::And => {
                for child in view.children(place) {
                    self.apply(view, child, bound, list, start)?;
                }
            }
            Kind::Forall => {
                let variables = view.variables(node);
                self.for_each(
                    variables,
                    bound,
                    true,
                    (list, start),
                    &mut |own, bound, list, start| own.apply(view, place + 1, bound, list, start),
                )?;
            }
            Kind::When => {
                if let Some((condition, effect)) = view.pair(place) {
                    if deletes_itself(view, condition, effect) {
                        // Where the atom does not hold, it may be deleted all the same.
                        return self.apply(view, effect, bound, list, start);
                    }
                    let mut branches = Branches::new(false, list, start);
                    branches.take(self, list, &mut |own, list, start| {
                        own.require(view, (condition, false), bound, list, start)?;
                        own.apply(view, effect, bound, list, start)
                    })?;
                    branches.take(self, list, &mut |own, list, start| {
                        own.require(view, (condition, true), bound, list, start)
                    })?;
                    branches.end(list)?;
                }
            }
            Kind::Not => self.change(view, place + 1, bound.0, (list, start), false),
            Kind::Atom(_) => self.change(view, place, bound.0, (list, start), true),
            _ => {}
        }
        Ok(())
    }

    /// Adds or deletes an atom.
    fn change(
        &self,
        view: View<'_, 't>,
        place: u16,
        binding: &Binding,
        (list, start): (&mut Variants<N>, usize),
        added: bool,
    ) {
        let Some((node, Kind::Atom(predicate))) = view.node(place).map(|node| (node, node.kind))
        else {
            return;
        };
        let atom = self.atom(predicate, view.terms(node), binding);
        let bit = atom.and_then(|atom| self.atoms.singleton(&atom));
        let bit = bit.unwrap_or_default();
        for variant in list.iter_mut().skip(start) {
            let set = if added {
                &mut variant.adds
            } else {
                &mut variant.deletes
            };
            *set = set.union(bit);
        }
    }

    /// What a variant adds and deletes, negations among it. An atom in both is added.
    pub(super) fn complete(&self, variant: &Variant<N>) -> (AtomSet<N>, AtomSet<N>) {
        let (adds, deletes) = (variant.adds, variant.deletes.difference(variant.adds));
        let (mut all_adds, mut all_deletes) = (adds, variant.deletes);
        let atoms = self.atoms.as_slice();
        let first = atoms.partition_point(|atom| !atom.predicate.is_negation());
        for (place, atom) in (0..).zip(atoms).skip(first) {
            let own = AtomSet::single(place);
            let opposite = self.atoms.singleton(&atom.negation()).unwrap_or_default();
            if !opposite.intersection(adds).is_empty() {
                all_deletes = all_deletes.union(own);
            } else if !opposite.intersection(deletes).is_empty() {
                all_adds = all_adds.union(own);
            }
        }
        (all_adds, all_deletes)
    }

    /// What an effect costs.
    pub(super) fn cost(
        &self,
        view: View<'_, 't>,
        place: u16,
        binding: &Binding,
    ) -> Result<u32, Error> {
        let Some(node) = view.node(place) else {
            return Ok(0);
        };
        match node.kind {
            Kind::And => view.children(place).try_fold(0u32, |sum, child| {
                Ok(sum.saturating_add(self.cost(view, child, binding)?))
            }),
            Kind::Increase(amount) => Ok(amount),
            Kind::IncreaseBy(function) => self
                .atom(function, view.terms(node), binding)
                .and_then(|atom| self.problem.number(&atom))
                .ok_or(Error::InvalidArgument(
                    "a cost is missing in :init, or is no whole number below 1000000000",
                )),
            _ => Ok(0),
        }
    }
}

/// Whether an effect deletes just the atom that is its condition.
fn deletes_itself(view: View<'_, '_>, condition: u16, effect: u16) -> bool {
    let (Some(condition), Some(not)) = (view.node(condition), view.node(effect)) else {
        return false;
    };
    let (Kind::Atom(_), Kind::Not, Some(deleted)) =
        (condition.kind, not.kind, view.node(effect + 1))
    else {
        return false;
    };
    condition.kind == deleted.kind && view.terms(condition) == view.terms(deleted)
}

/// Several formulas about the same variants: all of them shall hold, or one.
struct Branches {
    all: bool,
    /// The variants that they are about, if one shall hold.
    start: usize,
    middle: usize,
    /// Whether one holds anyway, or there are no variants left.
    decided: bool,
}

impl Branches {
    fn new<const N: usize>(all: bool, list: &Variants<N>, start: usize) -> Self {
        Branches {
            all,
            start,
            middle: list.len(),
            decided: false,
        }
    }

    /// Whether the formulas that follow change nothing.
    fn is_decided<const N: usize>(&self, list: &Variants<N>) -> bool {
        self.decided || (self.all && list.len() == self.start)
    }

    fn take<'a, 't, const N: usize>(
        &mut self,
        grounding: &mut Grounding<'a, 't, N>,
        list: &mut Variants<N>,
        step: Step<'_, 'a, 't, N>,
    ) -> Result<(), Error> {
        if self.is_decided(list) {
            return Ok(());
        }
        if self.all {
            return step(grounding, list, self.start);
        }
        let from = list.len();
        for place in self.start..self.middle {
            let copy = list.get(place).copied().unwrap_or_default();
            list.push(copy).map_err(|_| TOO_MANY)?;
        }
        step(grounding, list, from)?;
        // Nothing is asked for: the others do not matter.
        let same = list.get(self.start..self.middle) == list.get(from..);
        if same {
            list.truncate(self.middle);
            self.decided = true;
        }
        Ok(())
    }

    fn end<const N: usize>(self, list: &mut Variants<N>) -> Result<(), Error> {
        if self.all || self.decided {
            return Ok(());
        }
        let left = list.len().saturating_sub(self.middle);
        for place in 0..left {
            let moved = list.get(self.middle + place).copied();
            if let (Some(moved), Some(slot)) = (moved, list.get_mut(self.start + place)) {
                *slot = moved;
            }
        }
        list.truncate(self.start + left);
        match list.len() > MOST {
            true => Err(TOO_MANY),
            false => Ok(()),
        }
    }
}
