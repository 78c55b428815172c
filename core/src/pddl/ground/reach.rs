//! Which atoms can hold at all, and which negations are asked for.

use super::Grounding;
use super::choices::{Binding, Bound, Signed};
use crate::error::Error;
use crate::pddl::formula::{Kind, View};
use crate::task::GroundAtom;

impl<'t, const N: usize> Grounding<'_, 't, N> {
    /// Names the atoms that can be reached if nothing were ever deleted: what holds
    /// initially, and what actions add whose preconditions can be reached, until there are
    /// no more.
    pub(super) fn reach(&mut self) -> Result<(), Error> {
        let (problem, domain) = (self.problem, self.problem.domain());
        for atom in problem.initial() {
            if !domain.declared.is_static(atom.predicate) {
                self.atoms.insert(*atom)?;
            }
        }
        let mut before = None;
        while before != Some(self.atoms.as_slice().len()) {
            before = Some(self.atoms.as_slice().len());
            for action in domain.actions() {
                let count = domain.parameters(action).len() as u8;
                self.choices(action, &mut |own, binding| {
                    own.add_effects(domain.view(), action.effect, (binding, count))
                })?;
            }
        }
        Ok(())
    }

    fn add_effects(
        &mut self,
        view: View<'_, 't>,
        place: u16,
        bound: Bound<'_>,
    ) -> Result<(), Error> {
        let Some(node) = view.node(place) else {
            return Ok(());
        };
        self.work.spend(0)?;
        match node.kind {
            Kind::And => {
                for child in view.children(place) {
                    self.add_effects(view, child, bound)?;
                }
            }
            Kind::Forall => {
                self.quantify(view.variables(node), bound, &mut |own, bound| {
                    own.add_effects(view, place + 1, bound)?;
                    Ok(true)
                })?;
            }
            Kind::When => {
                if let Some((condition, effect)) = view.pair(place)
                    && self.is_possible(view, (condition, false), bound, true)?
                {
                    self.add_effects(view, effect, bound)?;
                }
            }
            Kind::Atom(predicate) => {
                if let Some(atom) = self.atom(predicate, view.terms(node), bound.0) {
                    self.atoms.insert(atom)?;
                }
            }
            _ => {}
        }
        Ok(())
    }

    /// Names the atoms of the goal that cannot be reached, so that it can be said which
    /// they are.
    pub(super) fn name_goal(&mut self) -> Result<(), Error> {
        let (view, binding) = (self.problem.goal(), Binding::default());
        self.literals(
            view,
            (0, false),
            (&binding, 0),
            &mut |own, atom, negated| {
                let holds = own.problem.holds_initially(&atom);
                let is_static = own.problem.domain().declared.is_static(atom.predicate);
                match (is_static && holds, negated) {
                    (false, false) => own.atoms.insert(atom)?,
                    // It holds forever, and shall not.
                    (true, true) => own.atoms.insert(atom.negation())?,
                    _ => false,
                };
                Ok(())
            },
        )
    }

    /// Names the negations of atoms that preconditions, conditions and the goal ask for,
    /// if the atom can hold.
    pub(super) fn name_negations(&mut self) -> Result<(), Error> {
        let domain = self.problem.domain();
        let mut name = |own: &mut Self, atom: GroundAtom, negated: bool| {
            if negated && own.atoms.singleton(&atom).is_some() {
                own.atoms.insert(atom.negation())?;
            }
            Ok(())
        };
        for action in domain.actions() {
            let count = domain.parameters(action).len() as u8;
            self.choices(action, &mut |own, binding| {
                let (view, bound) = (domain.view(), (binding, count));
                own.literals(view, (action.precondition, false), bound, &mut name)?;
                own.conditions(view, action.effect, bound, &mut name)
            })?;
        }
        let (view, binding) = (self.problem.goal(), Binding::default());
        self.literals(view, (0, false), (&binding, 0), &mut name)
    }

    /// Hands on the atoms of the conditions in an effect, as what is wanted and as its
    /// opposite.
    fn conditions(
        &mut self,
        view: View<'_, 't>,
        place: u16,
        bound: Bound<'_>,
        visit: &mut dyn FnMut(&mut Self, GroundAtom, bool) -> Result<(), Error>,
    ) -> Result<(), Error> {
        let Some(node) = view.node(place) else {
            return Ok(());
        };
        self.work.spend(0)?;
        match node.kind {
            Kind::And => {
                for child in view.children(place) {
                    self.conditions(view, child, bound, visit)?;
                }
            }
            Kind::Forall => {
                self.quantify(view.variables(node), bound, &mut |own, bound| {
                    own.conditions(view, place + 1, bound, visit)?;
                    Ok(true)
                })?;
            }
            Kind::When => {
                if let Some((condition, effect)) = view.pair(place) {
                    for negated in [false, true] {
                        self.literals(view, (condition, negated), bound, visit)?;
                    }
                    self.conditions(view, effect, bound, visit)?;
                }
            }
            _ => {}
        }
        Ok(())
    }

    /// Hands on the atoms of a condition, and whether each is negative.
    fn literals(
        &mut self,
        view: View<'_, 't>,
        (place, negated): Signed,
        bound: Bound<'_>,
        visit: &mut dyn FnMut(&mut Self, GroundAtom, bool) -> Result<(), Error>,
    ) -> Result<(), Error> {
        let Some(node) = view.node(place) else {
            return Ok(());
        };
        self.work.spend(0)?;
        match node.kind {
            Kind::And | Kind::Or => {
                for child in view.children(place) {
                    self.literals(view, (child, negated), bound, visit)?;
                }
            }
            Kind::Not => self.literals(view, (place + 1, !negated), bound, visit)?,
            Kind::Imply => {
                if let Some((first, second)) = view.pair(place) {
                    self.literals(view, (first, !negated), bound, visit)?;
                    self.literals(view, (second, negated), bound, visit)?;
                }
            }
            Kind::Forall | Kind::Exists => {
                self.quantify(view.variables(node), bound, &mut |own, bound| {
                    own.literals(view, (place + 1, negated), bound, visit)?;
                    Ok(true)
                })?;
            }
            Kind::Atom(predicate) => {
                if let Some(atom) = self.atom(predicate, view.terms(node), bound.0) {
                    visit(self, atom, negated)?;
                }
            }
            Kind::Equal | Kind::When | Kind::Increase(_) | Kind::IncreaseBy(_) => {}
        }
        Ok(())
    }
}
