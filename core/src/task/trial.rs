//! Trying an operator with given parameters: the question that is learned.

use super::atom::LiftedAtom;
use super::environment::{Environment, Failure};
use super::operator::Operator;
use super::rollout::{Ending, rollout_from};
use super::state::{ObjectId, State};

/// Whether an action did what its operator promises.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Verdict {
    /// All effects hold: the parameters are feasible.
    Feasible,
    /// An add effect does not hold afterwards.
    AddEffectMissing,
    /// All add effects hold, but also a delete effect that is not added again.
    DeleteEffectRemains,
    /// No action was taken: the controller was stuck, done at once, could not
    /// start, or does not exist.
    NoAction,
    /// A step had no outcome.
    Failed(Failure),
}

/// An operator that was tried, and what came of it.
#[derive(Clone, Debug)]
pub struct Trial {
    /// The last state; the start state if no action was taken.
    pub state: State,
    /// How many actions were taken.
    pub actions: u32,
    /// Whether the effects hold.
    pub verdict: Verdict,
}

impl Trial {
    /// Whether the parameters are feasible.
    pub fn is_feasible(&self) -> bool {
        self.verdict == Verdict::Feasible
    }
}

/// Runs an operator's controller from `start` and looks at the effects: the
/// parameters are feasible if an action was taken and all of them hold. `objects`
/// stand for the operator's parameters. Preconditions are the caller's business.
pub fn try_operator<E: Environment>(
    environment: &E,
    operator: &Operator<'_>,
    objects: &[ObjectId],
    parameters: &[f64],
    start: &State,
) -> Trial {
    let mut trial = Trial {
        state: start.clone(),
        actions: 0,
        verdict: Verdict::NoAction,
    };
    (trial.actions, trial.verdict) =
        try_operator_from(environment, operator, objects, parameters, &mut trial.state);
    if trial.actions == 0 {
        trial.state.clone_from(start);
    }
    trial
}

/// As [`try_operator`], in a state that the caller lends, see [`rollout_from`]. Tells how
/// many actions were taken, and whether the effects hold.
pub fn try_operator_from<E: Environment>(
    environment: &E,
    operator: &Operator<'_>,
    objects: &[ObjectId],
    parameters: &[f64],
    state: &mut State,
) -> (u32, Verdict) {
    let controller = environment.controller(operator.controller);
    let arguments = operator.controller_objects(objects);
    let (Ok(controller), Ok(arguments)) = (controller, arguments) else {
        return (0, Verdict::NoAction);
    };
    let arguments = arguments.as_slice();
    let (actions, ending) = rollout_from(environment, controller, arguments, parameters, state);
    let verdict = match ending {
        Ending::Failed(failure) => Verdict::Failed(failure),
        _ if actions == 0 => Verdict::NoAction,
        _ => judge(environment, operator, objects, state),
    };
    (actions, verdict)
}

fn judge<E: Environment>(
    environment: &E,
    operator: &Operator<'_>,
    objects: &[ObjectId],
    after: &State,
) -> Verdict {
    let atom = |lifted: &LiftedAtom<'_>| lifted.ground(objects).ok();
    let holds = |lifted| atom(lifted).is_some_and(|a| a.holds(environment, after));
    // Deletes come before adds: an atom in both is added.
    let added = |lifted| operator.add_effects.iter().any(|a| atom(a) == atom(lifted));
    let mut deleted = operator.delete_effects.iter().filter(|a| !added(a));
    if !operator.add_effects.iter().all(holds) {
        Verdict::AddEffectMissing
    } else if deleted.any(holds) {
        Verdict::DeleteEffectRemains
    } else {
        Verdict::Feasible
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::domain::{Attribute, Dimension};
    use crate::task::{
        Controller, ControllerId, Naming, ObjectType, OperatorId, Predicate, PredicateId, Terminal,
        TypeId, rollout,
    };
    use rand_pcg::Pcg32;

    /// A cart on a line that rolls by its action, hits a wall at -3 and stands
    /// still at 3.
    struct Cart;

    const CART: TypeId = TypeId(0);
    const PAST_ONE: LiftedAtom<'static> = LiftedAtom {
        predicate: PredicateId(0),
        variables: &[0],
    };
    const POSITIVE: LiftedAtom<'static> = LiftedAtom {
        predicate: PredicateId(1),
        variables: &[0],
    };

    fn position(state: &State) -> f64 {
        state.values().first().copied().unwrap()
    }

    impl Environment for Cart {
        type Action = f64;

        const TYPES: &'static [ObjectType] = &[ObjectType {
            name: "cart",
            attributes: &[Attribute {
                name: "x",
                dimension: Dimension::Length,
            }],
            naming: Naming::Single("cart"),
        }];
        const PREDICATES: &'static [Predicate<Self>] = &[
            Predicate {
                name: "PastOne",
                arguments: &[CART],
                classifier: |_, state, _| position(state) > 1.0,
            },
            Predicate {
                name: "Positive",
                arguments: &[CART],
                classifier: |_, state, _| position(state) > 0.0,
            },
        ];
        const CONTROLLERS: &'static [Controller<Self>] = &[Controller {
            name: "Roll",
            arguments: &[CART],
            parameters: &[[-1.0, 1.0], [0.0, 10.0]],
            initiable: |_, _, _, theta| theta.len() == 2,
            policy: |_, _, _, theta| theta.first().copied().unwrap_or(0.0),
            terminal: Terminal::When(|_, state, _, theta| {
                let end = theta.get(1);
                end.is_some_and(|end| position(state) >= *end)
            }),
        }];
        const OPERATORS: &'static [Operator<'static>] = &[
            Operator {
                name: "Advance",
                parameters: &[CART],
                preconditions: &[],
                add_effects: &[PAST_ONE],
                delete_effects: &[PAST_ONE],
                controller: ControllerId(0),
                controller_arguments: &[0],
            },
            Operator {
                name: "Vanish",
                parameters: &[CART],
                preconditions: &[],
                add_effects: &[PAST_ONE],
                delete_effects: &[POSITIVE],
                controller: ControllerId(0),
                controller_arguments: &[0],
            },
        ];

        fn simulate(&self, state: &mut State, action: f64) -> Result<(), Failure> {
            let moved = position(state) + action;
            if moved < -3.0 {
                let culprit = Some(ObjectId(0));
                return Err(Failure { culprit });
            }
            for x in state.values_mut() {
                *x = moved.min(3.0);
            }
            Ok(())
        }
    }

    fn start() -> State {
        let mut state = State::new();
        state.add(Cart::TYPES, CART, &[0.0]).unwrap();
        state
    }

    #[test]
    fn every_ending() {
        let failure = Failure {
            culprit: Some(ObjectId(0)),
        };
        let cases: [(&[f64], Ending, u32, f64); 6] = [
            (&[0.5, 2.0], Ending::Terminal, 4, 2.0),
            (&[0.5, 0.0], Ending::Terminal, 0, 0.0),
            (&[0.5, 9.0], Ending::Stuck, 0, 0.0),
            (&[0.03125, 9.0], Ending::StepLimit, 50, 1.5625),
            (&[-1.0, 9.0], Ending::Failed(failure), 0, 0.0),
            (&[1.0], Ending::NotInitiable, 0, 0.0),
        ];
        let [controller] = Cart::CONTROLLERS else {
            panic!()
        };
        for (theta, ending, actions, end) in cases {
            let run = rollout(&Cart, controller, &[ObjectId(0)], theta, &start());
            assert_eq!((run.ending, run.actions), (ending, actions), "{theta:?}");
            assert_eq!(position(&run.state), end, "{theta:?}");
        }
    }

    #[test]
    fn every_verdict() {
        let [advance, vanish] = Cart::OPERATORS else {
            panic!()
        };
        let failure = Failure {
            culprit: Some(ObjectId(0)),
        };
        let cases: [(&Operator<'_>, [f64; 2], Verdict); 5] = [
            (advance, [1.0, 2.0], Verdict::Feasible),
            (advance, [1.0, 1.0], Verdict::AddEffectMissing),
            (advance, [1.0, 9.0], Verdict::NoAction),
            (advance, [-1.0, 2.0], Verdict::Failed(failure)),
            (vanish, [1.0, 2.0], Verdict::DeleteEffectRemains),
        ];
        for (operator, theta, verdict) in cases {
            let trial = try_operator(&Cart, operator, &[ObjectId(0)], &theta, &start());
            assert_eq!(trial.verdict, verdict, "{theta:?}");
        }
        let trial = try_operator(&Cart, advance, &[], &[1.0, 2.0], &start());
        assert_eq!(trial.verdict, Verdict::NoAction, "an object is missing");
    }

    #[test]
    fn samples_fill_the_parameter_space() {
        let mut rng = Pcg32::new(0, 0);
        let mut largest = [f64::MIN; 2];
        for _ in 0..1000 {
            let theta = Cart.sample(OperatorId(0), &start(), &[ObjectId(0)], &mut rng);
            let &[a, b] = &*theta else { panic!() };
            assert!((-1.0..=1.0).contains(&a) && (0.0..=10.0).contains(&b));
            largest = [largest[0].max(a), largest[1].max(b)];
        }
        assert!(largest[0] > 0.95 && largest[1] > 9.5);
        assert!(
            Cart.sample(OperatorId(9), &start(), &[], &mut rng)
                .is_empty()
        );
    }
}
