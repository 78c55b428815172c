//! Where whether an action works is a matter of chance, nothing is learned.

use critreg::random::{generator, uniform};
use critreg::skill::Training;
use critreg::task::{Environment, State, try_operator};
use critreg_tests::lottery::Lottery;
use critreg_tests::plan::skills::{SkillRoom, TrainingRoom};
use critreg_tests::report;

fn wins(lottery: &Lottery, state: &State, seed: f64) -> bool {
    let operator = &Lottery::OPERATORS[0];
    let objects: Vec<_> = state.objects().map(|(object, _)| object).collect();
    try_operator(lottery, operator, &objects, &[seed], state).is_feasible()
}

#[test]
fn a_seed_wins_always_or_never_and_its_neighbour_as_often_as_any_other() {
    for winning in [0.5, 0.25] {
        let lottery = Lottery { winning };
        let mut rng = generator(1);
        let (mut all, mut both) = (0, 0);
        for _ in 0..100 {
            let state = lottery.task(&mut rng).unwrap().initial;
            for _ in 0..100 {
                let seed = uniform(&mut rng);
                let [own, again, next] =
                    [seed, seed, seed.next_up()].map(|seed| wins(&lottery, &state, seed));
                assert_eq!(own, again);
                all += u32::from(own);
                both += u32::from(own && next);
            }
        }
        let close = |count: u32, share: f64| (f64::from(count) / 10_000.0 - share).abs() < 0.02;
        assert!(
            close(all, winning) && close(both, winning * winning),
            "{all} {both}"
        );
    }
}

#[test]
fn there_is_no_region_where_only_chance_decides() {
    let all: Training = report::training();
    let short = Training { budget: 0, ..all };
    // Long in vain takes long.
    for (winning, training, seeds) in [(0.5, short, 20), (0.25, short, 20), (0.5, all, 1)] {
        let lottery = Lottery { winning };
        let mut skill_room = SkillRoom::default();
        let mut room = TrainingRoom::new(training);
        for seed in 0..seeds {
            let mut skills = skill_room.lend(&lottery).unwrap();
            let task = |_, rng: &mut _| lottery.task(rng);
            let learned = report::train(&lottery, task, seed, &mut skills, &mut room);
            let learned = learned.unwrap()[0];
            // It was asked as often as where there is something to learn.
            assert_eq!(
                (learned.tasks, learned.runs),
                (training.tasks, training.learner.calls.max(training.budget))
            );
            let region = skills.get(0).unwrap().region();
            assert!(
                !learned.region && region.is_none(),
                "{winning}, {seed}: {region:?}"
            );
        }
    }
}
