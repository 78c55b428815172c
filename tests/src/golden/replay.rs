//! An environment held against its recording.

use super::Recording;
use super::records::{NOT_RECORDED, Start, StepOutcome, Trial, ground_atom, object};
use critreg::task::{
    Atoms, Environment, Failure, GroundAtom, LiftedAtom, ObjectId, Operator, State, Verdict,
    try_operator,
};

/// How much was replayed.
#[derive(Debug, Default, PartialEq, Eq)]
pub struct Counts {
    /// Steps.
    pub transitions: usize,
    /// Steps without an outcome among them.
    pub failures: usize,
    /// States with their atoms.
    pub abstractions: usize,
    /// Atoms of these states.
    pub atoms: usize,
    /// Operators with one vector of parameters each.
    pub feasibility: usize,
    /// The same in chains, first and later steps.
    pub chains: usize,
    /// The feasible among both.
    pub feasible: usize,
    /// Tasks.
    pub tasks: usize,
}

/// Replays every record, to the last bit, and counts them. `action` makes the
/// environment's action of recorded numbers.
///
/// # Panics
/// At the first difference.
pub fn replay<E: Environment>(
    recording: &Recording,
    environment: &E,
    action: impl Fn(&[f32]) -> E::Action,
) -> Counts {
    replay_within(recording, environment, 0.0, action)
}

/// As [`replay`], but numbers after a step may differ by so much, as where sine and cosine
/// are not those of the recording.
///
/// # Panics
/// At the first difference.
pub fn replay_within<E: Environment>(
    recording: &Recording,
    environment: &E,
    tolerance: f64,
    action: impl Fn(&[f32]) -> E::Action,
) -> Counts {
    let states = recording.states::<E>();
    let mut counts = Counts::default();
    replay_transitions(
        recording,
        (environment, tolerance),
        &states,
        action,
        &mut counts,
    );
    replay_atoms(recording, environment, &states, &mut counts);
    let feasibility = recording.feasibility();
    counts.feasibility = replay_trials(&feasibility, environment, &states, &mut counts);
    let chains = recording.chains();
    counts.chains = replay_trials(&chains, environment, &states, &mut counts);
    replay_tasks(recording, environment, &mut counts);
    counts
}

fn replay_transitions<E: Environment>(
    recording: &Recording,
    (environment, tolerance): (&E, f64),
    states: &[State],
    action: impl Fn(&[f32]) -> E::Action,
    counts: &mut Counts,
) {
    for step in recording.transitions() {
        let place = counts.transitions;
        let before = &states[step.before];
        let mut expected = before.clone();
        let result = match step.outcome {
            StepOutcome::Changed(changes) => {
                for (place, value) in changes {
                    expected.values_mut()[place] = value;
                }
                Ok(())
            }
            StepOutcome::Failed(culprit) => {
                counts.failures += 1;
                let culprit = culprit.map(|name| object::<E>(before, name));
                Err(Failure { culprit })
            }
        };
        let mut after = before.clone();
        let ours = environment.simulate(&mut after, action(&step.action));
        assert_eq!(ours, result, "step {place}, {}", step.what);
        let largest = largest_difference(&after, &expected);
        assert!(
            largest <= tolerance,
            "step {place}, {}: {largest}",
            step.what
        );
        counts.transitions += 1;
    }
}

/// By how much numbers of two states differ at most; infinite if some are not the same bit
/// by bit, nor their difference a number.
fn largest_difference(a: &State, b: &State) -> f64 {
    let pairs = a.values().iter().zip(b.values());
    let differences = pairs.map(|(a, b)| match a.to_bits() == b.to_bits() {
        true => 0.0,
        // Zeros of two signs are as far apart as two numbers can be.
        false if a == b || (a - b).is_nan() => f64::INFINITY,
        false => (a - b).abs(),
    });
    differences.fold(0.0, f64::max)
}

fn replay_atoms<E: Environment>(
    recording: &Recording,
    environment: &E,
    states: &[State],
    counts: &mut Counts,
) {
    for record in recording.abstractions() {
        let state = &states[record.state];
        let all = Atoms::new::<E>(state).unwrap();
        let abstract_state = all.abstract_state(environment, state);
        let mut distinct = 0;
        for (name, truth) in &record.atoms {
            let atom = ground_atom::<E>(state, name);
            let what = || format!("{name} in state {}", record.state);
            assert_eq!(atom.holds(environment, state), *truth, "{}", what());
            if let Some(bit) = all.singleton(&atom) {
                assert_eq!(bit.is_subset(abstract_state), *truth, "{}", what());
                distinct += 1;
            }
        }
        // The framework also has atoms that name an object twice.
        assert_eq!(distinct, all.as_slice().len(), "state {}", record.state);
        counts.abstractions += 1;
        counts.atoms += record.atoms.len();
    }
}

/// Replays trials, and the chains among them; how many cases there were.
fn replay_trials<E: Environment>(
    trials: &[Trial],
    environment: &E,
    states: &[State],
    counts: &mut Counts,
) -> usize {
    let mut cases = 0;
    // Where the steps of the present chain ended.
    let mut chain: Vec<State> = Vec::new();
    for (line, trial) in (1..).zip(trials) {
        let start = match trial.start {
            Start::State(place) => {
                chain.clear();
                &states[place]
            }
            Start::After(steps) => {
                chain.truncate(steps);
                &chain[steps - 1]
            }
        };
        let operator = find::<E>(trial.operator);
        let names = trial.objects.iter();
        let objects: Vec<_> = names.map(|n| object::<E>(start, n)).collect();
        assert_applicable(environment, operator, &objects, start, line);
        let mut end = None;
        for (parameters, code) in &trial.cases {
            let outcome = try_operator(environment, operator, &objects, parameters, start);
            let ours = code_of(outcome.verdict);
            let what = || format!("{} {parameters:?}, line {line}", operator.name);
            assert!(
                *code == ours || *code == NOT_RECORDED,
                "{ours} for {code}: {}",
                what()
            );
            counts.feasible += usize::from(*code == '1');
            cases += usize::from(*code != NOT_RECORDED);
            end = Some(outcome.state);
        }
        if trial.cases.len() == 1 {
            chain.extend(end);
        }
    }
    cases
}

fn find<E: Environment>(name: &str) -> &'static Operator<'static> {
    let mut operators = E::OPERATORS.iter();
    let operator = operators.find(|operator| operator.name == name);
    operator.unwrap_or_else(|| panic!("no operator {name}"))
}

fn code_of(verdict: Verdict) -> char {
    match verdict {
        Verdict::Feasible => '1',
        Verdict::DeleteEffectRemains => '2',
        Verdict::AddEffectMissing => '0',
        Verdict::NoAction => 's',
        Verdict::Failed(Failure { culprit: Some(_) }) => 'x',
        Verdict::Failed(Failure { culprit: None }) => 'a',
    }
}

/// Only operators whose preconditions hold were tried.
fn assert_applicable<E: Environment>(
    environment: &E,
    operator: &Operator<'_>,
    objects: &[ObjectId],
    start: &State,
    line: usize,
) {
    let ground = |atom: &LiftedAtom<'_>| atom.ground(objects).unwrap();
    let holds = |atom: GroundAtom| atom.holds(environment, start);
    let mut preconditions = operator.preconditions.iter().map(ground);
    assert!(preconditions.all(holds), "{}, line {line}", operator.name);
}

/// Goals hold only at the end.
fn replay_tasks<E: Environment>(recording: &Recording, environment: &E, counts: &mut Counts) {
    for recorded in recording.tasks::<E>() {
        let task = recorded.task;
        assert!(!task.goal.is_empty() && !task.is_solved(environment, &task.initial));
        counts.tasks += 1;
    }
}
