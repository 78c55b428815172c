//! What can be said and learned of it.

use super::{drawn, pick, place, tasks};
use critreg::env::shelf::{BOX, ROBOT, SHELF, SHELF_DEPTH, Shelf};
use critreg::learn::version_space::Config as LearnerConfig;
use critreg::plan::{Conclusion, Metrics};
use critreg::random::generator;
use critreg::region::Region;
use critreg::skill::{Context, RegionGuide, RegionSampler, Skill, Skills, Training};
use critreg::task::{ObjectId, State, Task};
use critreg_tests::plan::skills::{SkillRoom, TrainingRoom, learn_from};
use critreg_tests::plan::{Grounding, Room, plan};

/// The feasible sets in the words of the descriptions: of Pick, Place, and Place later.
const TRUE_REGIONS: [&str; 3] = [
    "yaw - box.yaw <= hand.swivel and yaw - box.yaw >= -hand.swivel and hand.heel.z >= 0",
    "x >= 0.5 * box.depth and x <= shelf.depth - 0.5 * box.depth
     and hand.y - shelf.left.y <= -0.5 * hand.width
     and hand.y - shelf.right.y >= 0.5 * hand.width and hand.end.z <= shelf.top",
    "hand.end.z <= shelf.top",
];

/// Whether a skill says that parameters work in a state.
fn says(skill: &Skill, state: &State, own: &[ObjectId], theta: [f64; 2]) -> bool {
    let context = Context {
        environment: &Shelf,
        state,
        objects: own,
        later_objects: &[ROBOT, BOX, SHELF],
        members: &[],
    };
    let mut instance = vec![0.0; skill.binding().len()];
    skill.binding().instance(&context, &mut instance).unwrap();
    let region = skill.region().expect("there is a region");
    region
        .contains::<f64>(skill.domain(), &instance, &theta)
        .unwrap()
}

/// Whether Place can work after a Pick that does: at the middle of the shelf, where its
/// parameters are in nobody's way.
fn can_be_placed(picked: &State) -> bool {
    place(picked, [0.5 * SHELF_DEPTH, 0.0]).is_feasible()
}

/// In new tasks, the share of drawn parameters that each skill is right about.
fn agreement(skills: &Skills<'_>, seed: u64) -> [f64; 3] {
    let skills: Vec<_> = skills.iter().collect();
    let mut rng = generator(seed);
    let (mut right, mut all) = ([0; 3], [0; 3]);
    for task in tasks(seed, 300) {
        for _ in 0..40 {
            let state = &task.initial;
            let theta = drawn(0, state, &mut rng);
            let picked = pick(state, theta);
            let mut count = |index: usize, state, own: &[ObjectId], theta, works| {
                let said = says(skills[index], state, own, theta);
                right[index] += u32::from(said == works);
                all[index] += 1;
            };
            count(0, state, &[ROBOT, BOX], theta, picked.is_feasible());
            if !picked.is_feasible() {
                continue;
            }
            let can = can_be_placed(&picked.state);
            count(2, state, &[ROBOT, BOX], theta, can);
            let theta = drawn(1, &picked.state, &mut rng);
            let placed = place(&picked.state, theta);
            let own = [ROBOT, BOX, SHELF];
            count(1, &picked.state, &own, theta, placed.is_feasible());
        }
    }
    assert!(all.iter().all(|count| *count > 1000), "{all:?}");
    [0, 1, 2].map(|i| f64::from(right[i]) / f64::from(all[i]))
}

/// Plans with these skills; whether it succeeded, and how.
fn planned<'m>(
    task: &Task,
    skills: &Skills<'_>,
    grounding: &'m Grounding<'m, Shelf>,
    room: &'m mut Room,
) -> (Conclusion, Metrics<'m>) {
    let advice = (
        RegionSampler::new(&Shelf, skills),
        RegionGuide::new(&Shelf, skills, &task.initial),
    );
    let planned = plan(grounding, &task.initial, advice, || generator(7), room).unwrap();
    (planned.conclusion, planned.metrics)
}

#[test]
fn the_descriptions_can_say_the_feasible_sets_and_then_every_sample_works() {
    let mut skill_room = SkillRoom::default();
    let mut skills = skill_room.lend(&Shelf).unwrap();
    for (index, text) in TRUE_REGIONS.iter().enumerate() {
        let skill = skills.get_mut(index).unwrap();
        let region = Region::parse(skill.domain(), text).unwrap();
        skill.set_region(Some(region));
    }
    assert_eq!(agreement(&skills, 9), [1.0; 3]);
    let mut room = Room::new(1000);
    for task in tasks(9, 100) {
        let grounding = Grounding::new(&Shelf, &task).unwrap();
        let (conclusion, metrics) = planned(&task, &skills, &grounding, &mut room);
        assert_eq!((conclusion, metrics.samples), (Conclusion::Solved, 2));
    }
}

/// Learns all skills from so many tasks. Tells whether each has a region.
fn learned<'m>(room: &'m mut SkillRoom, seed: u64, count: usize) -> (Skills<'m>, bool) {
    let training = Training {
        tasks: count,
        situations: count,
        states: count,
        chained: 100,
        budget: 0,
        way: 10_000,
        learner: LearnerConfig {
            calls: 200,
            slack: 0.0,
            ..LearnerConfig::default()
        },
    };
    let mut skills = room.lend(&Shelf).unwrap();
    let (tasks, mut room) = (tasks(seed + 1000, 60), TrainingRoom::new(training));
    let learned = learn_from(&Shelf, &mut skills, &tasks, seed, &mut room);
    let mut all = true;
    for learned in learned.unwrap() {
        let within = learned.situations <= count && learned.runs <= 250;
        assert!(within, "{learned:?}");
        all &= learned.region;
    }
    (skills, all)
}

#[test]
fn the_skills_are_learned_from_a_dozen_tasks() {
    // Whether the hand is below the board does not depend on where it places the box: of
    // a dozen held boxes each is one observation of that, and now and then the pitch or
    // the height alone explains all of them.
    let seeds = 0..15;
    let all_right = seeds.filter(|seed| {
        let mut room = SkillRoom::default();
        let (skills, true) = learned(&mut room, *seed, 12) else {
            return false;
        };
        let [pick, place, later] = agreement(&skills, 10);
        assert!(pick > 0.99, "seed {seed}: {pick}");
        place > 0.98 && later > 0.99
    });
    assert!(all_right.count() >= 10);
}

#[test]
fn with_twice_as_many_tasks_nearly_every_sample_works() {
    for seed in 0..3 {
        let mut skill_room = SkillRoom::default();
        let (skills, all) = learned(&mut skill_room, seed, 24);
        assert!(all);
        let shares = agreement(&skills, 10);
        assert!(shares.iter().all(|share| *share > 0.98), "{shares:?}");
        let (mut room, mut samples) = (Room::new(1000), 0);
        for task in tasks(seed + 10, 50) {
            let grounding = Grounding::new(&Shelf, &task).unwrap();
            let (conclusion, metrics) = planned(&task, &skills, &grounding, &mut room);
            assert_eq!(conclusion, Conclusion::Solved);
            samples += metrics.samples;
        }
        assert!(
            samples <= 105,
            "{samples} samples for 50 plans of two steps"
        );
    }
}
