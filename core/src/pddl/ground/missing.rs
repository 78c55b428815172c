//! Why an atom of the goal cannot be reached.

use super::Grounding;
use super::choices::Binding;
use crate::error::Error;
use crate::pddl::formula::{Kind, Term, View};
use crate::pddl::schema::Action;
use crate::task::{GroundAtom, OperatorId};

/// An atom that the goal needs and that cannot be reached, and what is missing for it.
#[derive(Clone, Copy, Debug)]
pub struct Missing {
    /// The atom.
    pub atom: GroundAtom,
    /// The first action that would add it, if one would.
    pub action: Option<OperatorId>,
    /// The part of its precondition that fails, whatever the other objects are.
    pub(in crate::pddl) condition: Option<(u16, Binding)>,
}

/// Atoms that are asked why in a row.
const DEPTH: u32 = 8;

impl<'t, const N: usize> Grounding<'_, 't, N> {
    /// Says what is missing for the first atom of the goal that cannot be reached; `None`
    /// if all can be, each for itself.
    ///
    /// # Errors
    /// [`Error::CapacityExceeded`] if it is too much work.
    pub fn missing(&mut self) -> Result<Option<Missing>, Error> {
        let first = self.atoms.members(self.hopeless).next().copied();
        let Some(mut atom) = first.filter(|atom| !atom.predicate.is_negation() && !atom.is_goal())
        else {
            return Ok(None);
        };
        let mut missing = self.explain(atom)?;
        for _ in 0..DEPTH {
            // What is missing may be an atom that something else is missing for.
            let deeper = missing.condition.and_then(|(place, binding)| {
                let view = self.problem.domain().view();
                let node = view.node(place)?;
                match node.kind {
                    Kind::Atom(predicate) => self.atom(predicate, view.terms(node), &binding),
                    _ => None,
                }
            });
            let is_static =
                |atom: &GroundAtom| self.problem.domain().declared.is_static(atom.predicate);
            match deeper.filter(|deeper| *deeper != atom && !is_static(deeper)) {
                Some(deeper) => atom = deeper,
                None => break,
            }
            missing = self.explain(atom)?;
        }
        Ok(Some(missing))
    }

    fn explain(&mut self, atom: GroundAtom) -> Result<Missing, Error> {
        let domain = self.problem.domain();
        let mut missing = Missing {
            atom,
            action: None,
            condition: None,
        };
        for (id, action) in (0..).map(OperatorId).zip(domain.actions()) {
            if let Some(binding) = self.adding(action.effect, &atom) {
                missing.action.get_or_insert(id);
                missing.condition = self.failing(action, &binding)?;
                if missing.condition.is_some() {
                    missing.action = Some(id);
                    break;
                }
            }
        }
        Ok(missing)
    }

    /// The objects with which an effect without condition adds an atom.
    fn adding(&self, place: u16, atom: &GroundAtom) -> Option<Binding> {
        let view = self.problem.domain().view();
        let node = view.node(place)?;
        match node.kind {
            Kind::And => {
                let mut children = view.children(place);
                children.find_map(|child| self.adding(child, atom))
            }
            Kind::Atom(predicate) if predicate == atom.predicate => {
                let mut binding = Binding::default();
                for (term, object) in view.terms(node).iter().zip(atom.objects.as_slice()) {
                    let own = self.object(*term, &binding);
                    match (own, term) {
                        (Some(own), _) if own != *object => return None,
                        (None, Term::Variable(variable)) => {
                            binding = binding.with(*variable, *object);
                        }
                        _ => {}
                    }
                }
                Some(binding)
            }
            _ => None,
        }
    }

    /// A part of a precondition that cannot hold with these objects and some for the other
    /// parameters: if possible one that actions change, as the others say only that those
    /// objects do not fit.
    fn failing(
        &mut self,
        action: &Action<'t>,
        binding: &Binding,
    ) -> Result<Option<(u16, Binding)>, Error> {
        let problem = self.problem;
        let view = problem.domain().view();
        let variables = problem.domain().parameters(action);
        let bound = (binding, variables.len() as u8);
        if let Some(place) = self.failing_part(view, action.precondition, bound)? {
            return Ok(Some((place, *binding)));
        }
        let mut open = (0..).zip(variables);
        let Some((place, variable)) = open.find(|(place, _)| binding.get(*place).is_none()) else {
            return Ok(None);
        };
        let changes = |place: u16| match view.node(place).map(|node| node.kind) {
            Some(Kind::Atom(predicate)) => !problem.domain().declared.is_static(predicate),
            _ => false,
        };
        let mut first = None;
        for object in problem.of_type(variable.type_id) {
            let failing = self.failing(action, &binding.with(place, object))?;
            if failing.is_some_and(|(place, _)| changes(place)) {
                return Ok(failing);
            }
            first = first.or(failing);
        }
        Ok(first)
    }

    fn failing_part(
        &mut self,
        view: View<'_, 't>,
        place: u16,
        bound: (&Binding, u8),
    ) -> Result<Option<u16>, Error> {
        if self.is_possible(view, (place, false), bound, false)? {
            return Ok(None);
        }
        if view.node(place).is_some_and(|node| node.kind == Kind::And) {
            for child in view.children(place) {
                if let Some(failing) = self.failing_part(view, child, bound)? {
                    return Ok(Some(failing));
                }
            }
        }
        Ok(Some(place))
    }
}
