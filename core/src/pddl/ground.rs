//! From lifted to ground: the atoms and operators over the objects of a problem.

use super::problem::Problem;
use super::schema::{Action, Literal, Part, Relation, Term, Variable};
use crate::error::Error;
use crate::task::{Arguments, AtomSet, Atoms, GroundAtom, GroundOperator, OperatorId};

/// A problem in terms of ground atoms: what a search takes.
///
/// Preconditions that no action changes, equality among them, are decided here:
/// operators for which they fail are left out, and the others no longer have them.
/// What holds forever is in no set. A goal that never holds keeps its atom, so that
/// a search finds that there is no plan.
#[derive(Clone, Debug)]
pub struct Grounding<'a, 't> {
    problem: &'a Problem<'t>,
    atoms: Atoms,
    initial: AtomSet,
    goal: AtomSet,
}

impl<'a, 't> Grounding<'a, 't> {
    /// Grounds a problem. Its atoms are those that an operator, the initial state
    /// or the goal names.
    ///
    /// # Errors
    /// [`Error::CapacityExceeded`] if they are more than
    /// [`MAX_ATOMS`](crate::task::MAX_ATOMS).
    pub fn new(problem: &'a Problem<'t>) -> Result<Self, Error> {
        let is_static = |atom: &GroundAtom| problem.domain().is_static(atom.predicate);
        let initial = problem.initial().iter().filter(|a| !is_static(a));
        let goal = problem.goal().iter();
        let goal = goal.filter(|a| !(is_static(a) && problem.holds_initially(a)));

        let mut atoms = Atoms::none();
        for atom in initial.clone().chain(goal.clone()) {
            atoms.insert(*atom)?;
        }
        for action in problem.domain().actions() {
            for objects in Choices::new(problem, action) {
                for literal in problem.domain().literals(action) {
                    if let Some(atom) = changing_atom(problem, literal, &objects) {
                        atoms.insert(atom)?;
                    }
                }
            }
        }
        let bit = |atom| atoms.singleton(atom);
        Ok(Grounding {
            initial: initial.filter_map(bit).fold(AtomSet::EMPTY, AtomSet::union),
            goal: goal.filter_map(bit).fold(AtomSet::EMPTY, AtomSet::union),
            problem,
            atoms,
        })
    }

    /// The atoms that the sets refer to, in the order of their predicates, then of
    /// their objects.
    pub fn atoms(&self) -> &Atoms {
        &self.atoms
    }

    /// What holds initially.
    pub fn initial(&self) -> AtomSet {
        self.initial
    }

    /// What shall hold in the end.
    pub fn goal(&self) -> AtomSet {
        self.goal
    }

    /// The ground operators in the order of the names of their actions, then of
    /// their objects, the last parameter changing fastest. An object may fill
    /// several parameters unless a precondition forbids it.
    pub fn operators(&self) -> impl Iterator<Item = GroundOperator> {
        let actions = self.problem.domain().actions_by_name();
        actions.flat_map(move |(id, action)| {
            Choices::new(self.problem, action)
                .map(move |objects| self.operator(id, action, objects))
        })
    }

    fn operator(&self, id: OperatorId, action: &Action<'t>, objects: Arguments) -> GroundOperator {
        let literals = self.problem.domain().literals(action);
        let set = |part, negated| {
            literals
                .iter()
                .filter(|literal| literal.part == part && literal.negated == negated)
                .filter_map(|literal| changing_atom(self.problem, literal, &objects))
                .filter_map(|atom| self.atoms.singleton(&atom))
                .fold(AtomSet::EMPTY, AtomSet::union)
        };
        GroundOperator {
            operator: id,
            objects,
            preconditions: set(Part::Precondition, false),
            add_effects: set(Part::Effect, false),
            delete_effects: set(Part::Effect, true),
        }
    }
}

/// The atom of a literal for these objects, if an action changes its predicate.
fn changing_atom(
    problem: &Problem<'_>,
    literal: &Literal,
    objects: &Arguments,
) -> Option<GroundAtom> {
    match literal.relation {
        Relation::Predicate(predicate) if !problem.domain().is_static(predicate) => {
            let objects = substitute(problem, &literal.terms, objects)?;
            Some(GroundAtom { predicate, objects })
        }
        Relation::Predicate(_) | Relation::Equality => None,
    }
}

/// The objects that terms stand for; a domain's terms all stand for one.
fn substitute(problem: &Problem<'_>, terms: &[Term], objects: &Arguments) -> Option<Arguments> {
    let object = |term: &Term| match term {
        Term::Parameter(place) => objects.as_slice().get(usize::from(*place)).copied(),
        Term::Constant(place) => {
            let constant = problem.domain().constants().get(usize::from(*place))?;
            problem.find_object(constant.name)
        }
    };
    Arguments::new(terms.iter().filter_map(object)).ok()
}

/// All choices of objects for the parameters of an action that its static
/// preconditions admit, the last parameter changing fastest.
struct Choices<'a, 't> {
    problem: &'a Problem<'t>,
    parameters: &'a [Variable<'t>],
    literals: &'a [Literal],
    next: Option<Arguments>,
}

impl<'a, 't> Choices<'a, 't> {
    fn new(problem: &'a Problem<'t>, action: &Action<'t>) -> Self {
        let parameters = problem.domain().parameters(action);
        let firsts = || {
            parameters
                .iter()
                .map_while(|p| problem.of_type(p.type_id).next())
        };
        let complete = firsts().count() == parameters.len();
        Choices {
            problem,
            parameters,
            literals: problem.domain().literals(action),
            next: Arguments::new(firsts()).ok().filter(|_| complete),
        }
    }

    /// The next choice that differs in this place or an earlier one.
    fn after(&self, mut choice: Arguments, place: usize) -> Option<Arguments> {
        let places = choice.as_mut_slice().iter_mut().zip(self.parameters);
        for (i, (object, parameter)) in places.enumerate().rev() {
            let mut candidates = self.problem.of_type(parameter.type_id);
            let current = *object;
            match candidates.find(|o| i <= place && *o > current) {
                Some(next) => {
                    *object = next;
                    return Some(choice);
                }
                None => *object = self.problem.of_type(parameter.type_id).next()?,
            }
        }
        None
    }

    /// If a static precondition fails: the last place that it depends on. Whatever
    /// stands behind that place, it fails again.
    fn failing_place(&self, literal: &Literal, choice: &Arguments) -> Option<usize> {
        let objects = || substitute(self.problem, &literal.terms, choice);
        let holds = match literal.relation {
            _ if literal.part == Part::Effect => return None,
            Relation::Equality => !objects()?.are_distinct(),
            Relation::Predicate(predicate) if self.problem.domain().is_static(predicate) => {
                let objects = objects()?;
                self.problem
                    .holds_initially(&GroundAtom { predicate, objects })
            }
            Relation::Predicate(_) => return None,
        };
        let place = |term: &Term| match term {
            Term::Parameter(place) => Some(usize::from(*place)),
            Term::Constant(_) => None,
        };
        let last = literal.terms.iter().filter_map(place).max();
        (holds == literal.negated).then_some(last.unwrap_or(0))
    }
}

impl Iterator for Choices<'_, '_> {
    type Item = Arguments;

    fn next(&mut self) -> Option<Arguments> {
        loop {
            let choice = self.next?;
            let failing = self
                .literals
                .iter()
                .filter_map(|l| self.failing_place(l, &choice));
            let skipped_from = failing.min();
            self.next = self.after(choice, skipped_from.unwrap_or(usize::MAX));
            if skipped_from.is_none() {
                return Some(choice);
            }
        }
    }
}
