//! From lifted to ground: the atoms and operators over the objects of a problem.
//!
//! | file | what it does |
//! |---|---|
//! | `choices` | which objects an action can have: a join on what holds, bounded by work |
//! | `missing` | why an atom of the goal cannot be reached |
//! | `reach` | which atoms can hold at all, and which negative ones are asked for |
//! | `variants` | conditions with alternatives and conditional effects, split into operators |

mod choices;
mod missing;
mod reach;
mod variants;

use super::formula::Term;
use super::problem::Problem;
use super::schema::Action;
use crate::error::Error;
use crate::task::{
    Arguments, AtomSet, Atoms, GroundAtom, GroundOperator, ObjectId, OperatorId, PredicateId,
};
pub(super) use choices::Binding;
use choices::Work;
use heapless::Vec;
pub use missing::Missing;
use variants::{Variant, Variants};

/// A problem in terms of ground atoms: what a search takes.
///
/// Preconditions that no action changes, equality among them, are decided here:
/// operators for which they fail are left out, and the others no longer have them.
/// So are atoms and operators that cannot be reached from the initial state, not even if
/// nothing were ever deleted. A goal that cannot be reached keeps its atoms, so that a
/// search finds that there is no plan.
///
/// Where a text asks that an atom does not hold, its negation is an atom of its own; see
/// [`PredicateId::negation`]. Alternatives and conditional effects become several operators
/// with one name. Sets of atoms have `N` words.
#[derive(Clone, Debug)]
pub struct Grounding<'a, 't, const N: usize = 2> {
    problem: &'a Problem<'t>,
    atoms: Atoms<N>,
    initial: AtomSet<N>,
    goal: AtomSet<N>,
    /// Atoms of the goal that cannot be reached.
    hopeless: AtomSet<N>,
    /// The sets of which one shall hold in the end, if they are several.
    alternatives: Vec<AtomSet<N>, { variants::MOST }>,
    work: Work,
}

impl<'a, 't, const N: usize> Grounding<'a, 't, N> {
    /// Grounds a problem.
    ///
    /// # Errors
    /// [`Error::CapacityExceeded`] if there are more than 64 `N` atoms that can be reached,
    /// more alternatives in a goal than there is room for, or too much work.
    pub fn new(problem: &'a Problem<'t>) -> Result<Self, Error> {
        let mut grounding = Grounding {
            problem,
            atoms: Atoms::none(),
            initial: AtomSet::EMPTY,
            goal: AtomSet::EMPTY,
            hopeless: AtomSet::EMPTY,
            alternatives: Vec::new(),
            work: Work::default(),
        };
        grounding.reach()?;
        grounding.name_negations()?;
        let reached = grounding.atoms.clone();
        grounding.name_goal()?;
        grounding.set_initial();
        grounding.set_goal()?;
        let places = (0..).zip(grounding.atoms.as_slice());
        let hopeless = places.filter(|(_, atom)| reached.singleton(atom).is_none());
        grounding.hopeless = hopeless.fold(AtomSet::EMPTY, |set, (place, _)| {
            set.union(AtomSet::single(place))
        });
        Ok(grounding)
    }

    /// The atoms that the sets refer to, in the order of their predicates, then of
    /// their objects; negations come last.
    pub fn atoms(&self) -> &Atoms<N> {
        &self.atoms
    }

    /// What holds initially.
    pub fn initial(&self) -> AtomSet<N> {
        self.initial
    }

    /// What shall hold in the end.
    pub fn goal(&self) -> AtomSet<N> {
        self.goal
    }

    /// The atoms of the goal that no action reaches, not even if nothing were ever deleted.
    pub fn hopeless(&self) -> AtomSet<N> {
        self.hopeless
    }

    /// Hands on the ground operators in the order of the names of their actions, then of
    /// their objects, the last parameter changing fastest. An object may fill
    /// several parameters unless a precondition forbids it. A goal with alternatives ends
    /// with an operator for each, which [`GroundOperator::is_goal`] tells apart.
    ///
    /// # Errors
    /// Those of `visit`; [`Error::CapacityExceeded`] if one operator is split into too
    /// many; [`Error::InvalidArgument`] if the problem does not say what one costs.
    pub fn operators(
        &mut self,
        visit: &mut dyn FnMut(GroundOperator<N>) -> Result<(), Error>,
    ) -> Result<(), Error> {
        let domain = self.problem.domain();
        self.work = Work::default();
        for (id, action) in domain.actions_by_name() {
            self.choices(action, &mut |own, binding| {
                own.split(id, action, binding, visit)
            })?;
        }
        for alternative in self.alternatives.clone().iter() {
            visit(GroundOperator {
                operator: OperatorId::GOAL,
                objects: Arguments::default(),
                cost: 0,
                preconditions: *alternative,
                add_effects: self.goal,
                delete_effects: AtomSet::EMPTY,
            })?;
        }
        Ok(())
    }

    /// Hands on the operators of an action with these objects.
    fn split(
        &mut self,
        id: OperatorId,
        action: &Action<'t>,
        binding: &Binding,
        visit: &mut dyn FnMut(GroundOperator<N>) -> Result<(), Error>,
    ) -> Result<(), Error> {
        let domain = self.problem.domain();
        let count = domain.parameters(action).len();
        let view = domain.view();
        let mut variants = Variants::<N>::new();
        // There is room for one.
        let _ = variants.push(Variant::default());
        let whole = (binding, count as u8);
        self.require(view, (action.precondition, false), whole, &mut variants, 0)?;
        self.apply(view, action.effect, whole, &mut variants, 0)?;
        let cost = match self.problem.minimizes_cost() {
            true => self.cost(view, action.effect, binding)?,
            false => 1,
        };
        for variant in &variants {
            let (add_effects, delete_effects) = self.complete(variant);
            visit(GroundOperator {
                operator: id,
                objects: Arguments::new(binding.objects(count))?,
                cost,
                preconditions: variant.needs,
                add_effects,
                delete_effects,
            })?;
        }
        Ok(())
    }

    /// What holds of the atoms that can change.
    fn set_initial(&mut self) {
        let holds = |atom: &GroundAtom| match atom.predicate.is_negation() {
            true => !self.problem.holds_initially(&atom.negation()),
            false => self.problem.holds_initially(atom),
        };
        let places = (0..).zip(self.atoms.as_slice());
        let held = places.filter(|(_, atom)| holds(atom));
        self.initial = held.fold(AtomSet::EMPTY, |set, (place, _)| {
            set.union(AtomSet::single(place))
        });
    }

    /// What shall hold; if there are alternatives, an atom that stands for them.
    fn set_goal(&mut self) -> Result<(), Error> {
        let mut variants = Variants::<N>::new();
        let _ = variants.push(Variant::default());
        let binding = Binding::default();
        self.require_goal(&binding, &mut variants)?;
        if let [only] = variants.as_slice() {
            self.goal = only.needs;
            return Ok(());
        }
        // It comes behind all that was named but negations, whose places change.
        let predicate = PredicateId::GOAL;
        let objects = Arguments::default();
        let atom = GroundAtom { predicate, objects };
        self.atoms.insert(atom)?;
        self.set_initial();
        let mut variants = Variants::<N>::new();
        let _ = variants.push(Variant::default());
        self.require_goal(&binding, &mut variants)?;
        self.goal = self.atoms.singleton(&atom).unwrap_or_default();
        for variant in &variants {
            // There are as many places as there can be variants.
            let _ = self.alternatives.push(variant.needs);
        }
        Ok(())
    }

    fn require_goal(&mut self, binding: &Binding, list: &mut Variants<N>) -> Result<(), Error> {
        self.require(self.problem.goal(), (0, false), (binding, 0), list, 0)
    }

    /// The object of a term; `None` if it is a variable that has none yet.
    fn object(&self, term: Term, binding: &Binding) -> Option<ObjectId> {
        match term {
            Term::Variable(place) => binding.get(place),
            Term::Constant(place) => self.problem.constant(place),
            Term::Object(object) => Some(object),
        }
    }

    /// The atom of a predicate for these terms; `None` if a variable has no object.
    fn atom(
        &self,
        predicate: PredicateId,
        terms: &[Term],
        binding: &Binding,
    ) -> Option<GroundAtom> {
        let objects = terms.iter().map_while(|term| self.object(*term, binding));
        let objects = Arguments::new(objects).ok()?;
        let complete = objects.as_slice().len() == terms.len();
        complete.then_some(GroundAtom { predicate, objects })
    }
}
