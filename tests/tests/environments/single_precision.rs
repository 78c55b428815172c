//! The environments that were recorded draw and read parameters in single precision, as
//! their originals do; nobody else does.

use critreg::env::blocks::Blocks;
use critreg::env::cluttered_table::{ClutteredTable, ClutteredTablePlace};
use critreg::env::coffee::Coffee;
use critreg::env::cover::{Cover, CoverRegrasp, RegionalBumpyCover};
use critreg::env::shelf::Shelf;
use critreg::env::stick_button::StickButton;
use critreg::env::stick_button_move::StickButtonMove;
use critreg::random::{Generator, generator};
use critreg::task::{Environment, State, Task, try_operator};
use critreg_tests::plan::Grounding;

/// How many operators were tried with drawn parameters and with some that round to them,
/// and of how many the drawn ones are single and both do the same.
#[derive(Debug, Default)]
struct Counts {
    all: u32,
    single: u32,
    same: u32,
}

/// Tries each operator that is applicable in a state, and what is applicable after it.
fn try_all<E: Environment>(
    (environment, task): (&E, &Task),
    state: &State,
    steps: u32,
    rng: &mut Generator,
    counts: &mut Counts,
) {
    let grounding = Grounding::new(environment, task).unwrap();
    let holds = grounding.atoms.abstract_state(environment, state);
    let applicable = grounding
        .operators
        .iter()
        .filter(|o| o.is_applicable(holds));
    for ground in applicable {
        let (operator, objects) = (
            &E::OPERATORS[usize::from(ground.operator.0)],
            ground.objects.as_slice(),
        );
        let drawn = environment.sample(ground.operator, state, objects, rng);
        let near: Vec<f64> = drawn.iter().map(|x| x * (1.0 + 1e-10)).collect();
        let [first, second] = [&drawn[..], &near]
            .map(|theta| try_operator(environment, operator, objects, theta, state));
        if !drawn.is_empty() {
            counts.all += 1;
            counts.single += u32::from(drawn.iter().all(|x| f64::from(*x as f32) == *x));
            counts.same += u32::from(first.state == second.state);
        }
        if steps > 1 && first.is_feasible() {
            try_all((environment, task), &first.state, steps - 1, rng, counts);
        }
    }
}

fn counts<E: Environment>(
    environment: &E,
    task: impl Fn(usize, &mut Generator) -> Result<Task, critreg::Error>,
) -> Counts {
    let (mut rng, mut counts) = (generator(1), Counts::default());
    for index in 0..40 {
        let task = task(index, &mut rng).unwrap();
        try_all(
            (environment, &task),
            &task.initial,
            2,
            &mut rng,
            &mut counts,
        );
    }
    counts
}

#[test]
fn recorded_environments_round_what_they_draw_and_what_they_read() {
    let upright = StickButton { angles: false };
    for counts in [
        counts(&upright, |_, rng| upright.task(1..=2, rng)),
        counts(&Blocks, |_, rng| Blocks.task(3..=4, rng)),
        counts(&ClutteredTable, |_, rng| ClutteredTable.task(5, rng)),
        counts(&ClutteredTablePlace, |_, rng| ClutteredTablePlace.task(rng)),
        counts(&Coffee, |_, rng| Coffee.task(1..=2, rng)),
        counts(&StickButtonMove, |_, rng| StickButtonMove.task(1..=2, rng)),
        counts(&Cover, |index, rng| Cover.task(index, rng)),
        counts(&CoverRegrasp, |index, rng| CoverRegrasp.task(index, rng)),
        counts(&RegionalBumpyCover, |index, rng| {
            RegionalBumpyCover.task(index, rng)
        }),
    ] {
        let Counts { all, single, same } = counts;
        assert!(all >= 40 && single == all && same == all, "{counts:?}");
    }
}

#[test]
fn an_environment_of_our_own_does_not() {
    let Counts { all, single, same } = counts(&Shelf, |_, rng| Shelf.task(rng));
    assert!(
        all >= 40 && single == 0 && same < all,
        "{all} {single} {same}"
    );
}
