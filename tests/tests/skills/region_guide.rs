//! What the guide judges of operators that come after others: in the state that is
//! expected there, and until parameters are chosen again.

use critreg::env::cluttered_table::{ClutteredTable, ClutteredTablePlace, GRASP, cans};
use critreg::env::cover::{BLOCKS, Block, Cover, TARGETS, Target};
use critreg::env::stick_button_move::StickButtonMove;
use critreg::learn::version_space::Config as LearnerConfig;
use critreg::plan::{Advice, Guide, Skeleton};
use critreg::random::generator;
use critreg::region::Region;
use critreg::skill::{Describe, RegionGuide, Skills, Training};
use critreg::task::{AtomSet, Environment, GroundOperator, ObjectId, State, Task, try_operator};
use critreg_tests::golden::{CLUTTERED_TABLE, CLUTTERED_TABLE_PLACE, COVER, Recording};
use critreg_tests::plan::Grounding;
use critreg_tests::plan::skills::{SkillRoom, TrainingRoom, learn_from};
use std::f64::consts::{FRAC_PI_2, PI};

/// Runs controllers, so that it is seen what they change; those of texts without
/// parameters `states` times.
fn observe<E: Describe>(environment: &E, skills: &mut Skills<'_>, tasks: &[Task], states: usize) {
    let training = Training {
        chained: 20,
        budget: 0,
        way: 10_000,
        tasks: 10,
        situations: 4,
        states,
        learner: LearnerConfig {
            calls: 20,
            certifying: 2,
            ..LearnerConfig::default()
        },
    };
    let mut room = TrainingRoom::new(training);
    learn_from(environment, skills, tasks, 1, &mut room).unwrap();
}

/// That the skill at an index has this region is all that is known.
fn know(skills: &mut Skills<'_>, index: usize, text: &str) {
    for other in 0..skills.iter().count() {
        skills.get_mut(other).unwrap().set_region(None);
    }
    let skill = skills.get_mut(index).unwrap();
    let region = Region::parse(skill.domain(), text).unwrap();
    skill.set_region(Some(region));
}

/// Skills of an environment that were seen at work, and one of which has this region.
fn knowing<'m, E: Describe>(
    room: &'m mut SkillRoom,
    environment: &E,
    tasks: &[Task],
    (index, text): (usize, &str),
) -> Skills<'m> {
    let mut skills = room.lend(environment).unwrap();
    observe(environment, &mut skills, tasks, 10);
    know(&mut skills, index, text);
    skills
}

/// Tasks of a recording.
fn recorded<E: Environment>(recording: &Recording, split: &str) -> Vec<Task> {
    let all = recording.tasks::<E>().into_iter();
    let all = all.filter(|recorded| recorded.split == split);
    all.map(|recorded| recorded.task).collect()
}

/// All sequences of so many operators at most that can be applied one after the other,
/// by their places; shorter ones before those that they begin.
fn sequences<E: Environment>(grounding: &Grounding<'_, E>, most: usize) -> Vec<Vec<u16>> {
    let mut all: Vec<(Vec<u16>, AtomSet)> = vec![(vec![], grounding.task().initial)];
    let mut index = 0;
    while let Some((places, state)) = all.get(index).cloned() {
        index += 1;
        if places.len() == most {
            continue;
        }
        for (place, ground) in (0..).zip(&grounding.operators) {
            if ground.is_applicable(state) {
                let longer = [&places[..], &[place]].concat();
                all.push((longer, ground.apply(state)));
            }
        }
    }
    all.into_iter().skip(1).map(|(places, _)| places).collect()
}

fn is_kept<E: Describe>(
    guide: &mut RegionGuide<'_, E>,
    operators: &[GroundOperator],
    places: &[u16],
) -> bool {
    guide.judge(Skeleton::new(operators, places)) == Advice::Keep
}

// What is expected of the state

/// An approach has some length, and ends in a can beside which no other one stands in
/// its direction.
const FREE: &str =
    "min(angle(start, can, other_can)) >= 0.25 * half.turn and dist(start, can) > 0.1";
/// No other can is close.
const ALONE: &str = "min(dist(can, other_can)) >= 0.15";

/// The centres of the can that a sequence grasps last, and of the cans that stand on
/// the table then; `None` if it does something else.
fn last_grasp(
    task: &Task,
    operators: &[GroundOperator],
    places: &[u16],
) -> Option<([f64; 2], Vec<[f64; 2]>)> {
    let all = cans(&task.initial).unwrap();
    let (mut left, mut last) = (vec![true; all.len()], None);
    for place in places {
        let ground = &operators[usize::from(*place)];
        let can = usize::from(ground.objects.as_slice()[0].0);
        let operator = ClutteredTable.operator(ground).unwrap();
        last = (operator.controller == GRASP).then_some(can);
        left[can] = last.is_some();
    }
    let own = last?;
    let centre = |index: usize| [all[index][0], all[index][1]];
    let others = (0..all.len()).filter(|index| *index != own && left[*index]);
    Some((centre(own), others.map(centre).collect()))
}

/// The widest angle between directions next to each other, from a can to the others.
fn widest_gap(can: [f64; 2], others: &[[f64; 2]]) -> f64 {
    let bearing = |other: &[f64; 2]| (other[1] - can[1]).atan2(other[0] - can[0]);
    let mut bearings: Vec<f64> = others.iter().map(bearing).collect();
    bearings.sort_by(f64::total_cmp);
    let next = bearings.iter().cycle().skip(1);
    let gaps = bearings.iter().zip(next);
    let gaps = gaps.map(|(a, b)| (b - a).rem_euclid(2.0 * PI));
    gaps.fold(0.0, f64::max)
}

fn nearest(can: [f64; 2], others: &[[f64; 2]]) -> f64 {
    let distance = |other: &[f64; 2]| (other[0] - can[0]).hypot(other[1] - can[1]);
    others.iter().map(distance).fold(f64::INFINITY, f64::min)
}

/// How often the guide is right about grasps that come first, and about those after
/// others: of grasps that cannot work and that can. `gap` tells how far a grasp is from
/// being possible, negative if it is not; within `blur` of that nothing is asked. What
/// `expected` says of it is what the guide has to say.
fn judge_grasps(
    skills: &Skills<'_>,
    (gap, blur): (impl Fn([f64; 2], &[[f64; 2]]) -> f64, f64),
    expected: impl Fn(usize, bool) -> bool,
) -> [[u32; 2]; 2] {
    let mut counts = [[0; 2]; 2];
    for task in recorded::<ClutteredTable>(&CLUTTERED_TABLE, "test")
        .iter()
        .take(40)
    {
        let grounding = Grounding::new(&ClutteredTable, task).unwrap();
        let mut guide = RegionGuide::new(&ClutteredTable, skills, &task.initial);
        for places in sequences(&grounding, 3) {
            let kept = is_kept(&mut guide, &grounding.operators, &places);
            let Some((can, others)) = last_grasp(task, &grounding.operators, &places) else {
                assert!(kept, "nothing is known of dumping");
                continue;
            };
            let gap = gap(can, &others);
            if !(-blur..0.0).contains(&gap) {
                assert_eq!(
                    kept,
                    expected(places.len(), gap >= 0.0),
                    "{gap}, {places:?}"
                );
                counts[usize::from(places.len() > 1)][usize::from(gap >= 0.0)] += 1;
            }
        }
    }
    counts
}

fn training_tasks() -> Vec<Task> {
    recorded::<ClutteredTable>(&CLUTTERED_TABLE, "train")
}

#[test]
fn a_can_that_is_dumped_is_in_nobodys_way() {
    let mut skill_room = SkillRoom::default();
    let tasks = training_tasks();
    let mut skills = knowing(&mut skill_room, &ClutteredTable, &tasks, (0, FREE));
    // That a grasp cannot work is proven in boxes of some size.
    let free = (
        |can, others: &[_]| widest_gap(can, others) - FRAC_PI_2,
        0.15,
    );
    let counts = judge_grasps(&skills, free, |_, works| works);
    assert!(
        counts.as_flattened().iter().all(|count| *count >= 5),
        "{counts:?}"
    );

    know(&mut skills, 0, ALONE);
    let alone = (|can, others: &[_]| nearest(can, others) - 0.15, 0.0);
    let counts = judge_grasps(&skills, alone, |_, works| works);
    assert!(
        counts.as_flattened().iter().all(|count| *count > 50),
        "{counts:?}"
    );
}

#[test]
fn what_was_hardly_seen_may_change_anything() {
    let mut skill_room = SkillRoom::default();
    for dumped in [0, 2, 3] {
        let mut skills = skill_room.lend(&ClutteredTable).unwrap();
        observe(&ClutteredTable, &mut skills, &training_tasks(), dumped);
        know(&mut skills, 0, ALONE);
        let alone = (|can, others: &[_]| nearest(can, others) - 0.15, 0.0);
        let cannot_tell = |length| length > 1 && dumped < 3;
        let counts = judge_grasps(&skills, alone, |length, works| works || cannot_tell(length));
        assert!(
            counts.as_flattened().iter().all(|count| *count > 50),
            "{counts:?}"
        );
    }
}

#[test]
fn what_is_placed_anywhere_is_not_expected_anywhere() {
    let mut skill_room = SkillRoom::default();
    let tasks = recorded::<ClutteredTablePlace>(&CLUTTERED_TABLE_PLACE, "train");
    // The cans of all tasks stand closer, but where they are placed nobody knows.
    let far = (0, "min(dist(can, other_can)) >= 2");
    let skills = knowing(&mut skill_room, &ClutteredTablePlace, &tasks, far);
    let mut counts = [0; 4];
    for task in &tasks[..10] {
        let grounding = Grounding::new(&ClutteredTablePlace, task).unwrap();
        let mut guide = RegionGuide::new(&ClutteredTablePlace, &skills, &task.initial);
        for places in sequences(&grounding, 3) {
            let kept = is_kept(&mut guide, &grounding.operators, &places);
            assert_eq!(kept, places.len() > 1, "{places:?}");
            counts[places.len()] += 1;
        }
    }
    assert_eq!(counts, [0, 20, 20, 40]);
}

#[test]
fn what_is_always_the_same_afterwards_is_told_again() {
    let mut skill_room = SkillRoom::default();
    let tasks = recorded::<Cover>(&COVER, "train");
    // Only what is held is placed. Where it is held varies, where it is not is one number.
    let held = (1, "block.grasp >= -0.5");
    let skills = knowing(&mut skill_room, &Cover, &tasks, held);
    let [block, other] = BLOCKS;
    let (place, pick) = (&[block, TARGETS[0]][..], &[block][..]);
    let (mut held, mut lying) = (0, 0);
    for task in &tasks {
        let judged = |steps: &[&[ObjectId]]| judged(task, &skills, steps);
        assert!(judged(&[pick, place]), "it is not known where it is held");
        assert!(!judged(&[pick, place, place]));
        assert!(judged(&[pick, place, pick, place]));
        assert!(judged(&[pick, place, &[other], pick, place]));
        let holds = Block::read(&task.initial, block).unwrap().is_held();
        assert_eq!(judged(&[place]), holds);
        assert_eq!(judged(&[&[other], place]), holds, "another block is picked");
        (held, lying) = (held + u32::from(holds), lying + u32::from(!holds));
    }
    assert!(held > 10 && lying > 10, "{held} {lying}");
}

// How long parameters count

/// Two blocks do not go to one place.
const ELSEWHERE: (usize, &str) = (3, "dist(target.centre, later_target.centre) >= 0.04");

/// What the guide says of operators of Cover, each by its objects.
fn judged(task: &Task, skills: &Skills<'_>, steps: &[&[ObjectId]]) -> bool {
    let grounding = Grounding::new(&Cover, task).unwrap();
    let place = |objects: &&[ObjectId]| {
        let mut all = grounding.operators.iter();
        all.position(|ground| ground.objects.as_slice() == *objects)
            .unwrap() as u16
    };
    let places: Vec<u16> = steps.iter().map(place).collect();
    let mut guide = RegionGuide::new(&Cover, skills, &task.initial);
    is_kept(&mut guide, &grounding.operators, &places)
}

/// Whether operators work one after the other, with parameters that `choose` makes.
fn works(
    task: &Task,
    operators: &[GroundOperator],
    places: &[u16],
    mut choose: impl FnMut(&GroundOperator, &State) -> f64,
) -> bool {
    let mut state = task.initial.clone();
    places.iter().all(|place| {
        let ground = &operators[usize::from(*place)];
        let operator = Cover.operator(ground).unwrap();
        let click = [choose(ground, &state)];
        let outcome = try_operator(&Cover, operator, ground.objects.as_slice(), &click, &state);
        let worked = outcome.is_feasible();
        state = outcome.state;
        worked
    })
}

/// Picks a block at its centre, and places it with its centre over that of the target:
/// whatever can work works so, for targets lie far from each other and from blocks.
fn centred(ground: &GroundOperator, state: &State) -> f64 {
    let objects = ground.objects.as_slice();
    let block = Block::read(state, objects[0]).unwrap();
    match objects.get(1) {
        Some(target) => Target::read(state, *target).unwrap().pose + block.grasp,
        None => block.pose,
    }
}

#[test]
fn a_place_counts_until_its_block_is_picked_again() {
    let mut skill_room = SkillRoom::default();
    let tasks = recorded::<Cover>(&COVER, "train");
    let skills = knowing(&mut skill_room, &Cover, &tasks, ELSEWHERE);
    let (mut counts, mut rng) = ([0; 2], generator(1));
    for task in &tasks[..20] {
        let grounding = Grounding::new(&Cover, task).unwrap();
        let operators = &grounding.operators[..];
        let mut guide = RegionGuide::new(&Cover, &skills, &task.initial);
        for places in sequences(&grounding, 6) {
            let mut prefixes = (1..=places.len()).map(|length| &places[..length]);
            let kept = prefixes.all(|prefix| is_kept(&mut guide, operators, prefix));
            assert_eq!(kept, works(task, operators, &places, centred), "{places:?}");
            counts[usize::from(kept)] += 1;
            for _ in 0..20 {
                let chance = |ground: &GroundOperator, state: &State| {
                    let objects = ground.objects.as_slice();
                    Cover.sample(ground.operator, state, objects, &mut rng)[0]
                };
                assert!(
                    kept || !works(task, operators, &places, chance),
                    "{places:?}"
                );
            }
        }
    }
    assert!(counts.iter().all(|count| *count > 500), "{counts:?}");
}

#[test]
fn the_same_target_again_with_and_without_the_block_in_between() {
    let mut skill_room = SkillRoom::default();
    let tasks = recorded::<Cover>(&COVER, "train");
    let skills = knowing(&mut skill_room, &Cover, &tasks, ELSEWHERE);
    let judged = |steps: &[&[ObjectId]]| judged(&tasks[0], &skills, steps);
    let ([b0, b1], [t0, t1]) = (BLOCKS, TARGETS);
    assert!(!judged(&[&[b0, t1], &[b1], &[b1, t1]]));
    assert!(judged(&[&[b0, t1], &[b1], &[b1, t0]]));
    assert!(judged(&[&[b0, t1], &[b0], &[b0, t0], &[b1], &[b1, t1]]));
    assert!(
        judged(&[&[b0, t1], &[b0], &[b1], &[b1, t1]]),
        "it is in the hand, for all that is known"
    );
    assert!(!judged(&[&[b0, t1], &[b0], &[b0, t1], &[b1], &[b1, t1]]));
    assert!(!judged(&[&[b0, t0], &[b0], &[b0, t1], &[b1], &[b1, t1]]));
}

/// An operator may end what it does not say to: no stick is above nothing once it was moved
/// above a button. That is seen while skills are learned, and nothing is built on it.
#[test]
fn what_ends_without_being_said_to_is_seen() {
    let environment = StickButtonMove;
    let mut rng = generator(5);
    let tasks: Vec<Task> = (0..20)
        .map(|_| environment.task(1..=2, &mut rng).unwrap())
        .collect();
    let task = environment.task(2..=2, &mut rng).unwrap();
    let grounding = Grounding::new(&environment, &task).unwrap();
    let place = |name: &str, objects: &[ObjectId]| {
        let mut all = grounding.operators.iter();
        let found = all.position(|ground| {
            let operator = environment.operator(ground).unwrap();
            let objects = |ground: &GroundOperator| ground.objects.as_slice() == objects;
            operator.name == name && objects(ground)
        });
        found.unwrap() as u16
    };
    let [first, second, holder, robot, stick] = [0, 1, 2, 3, 4].map(ObjectId);
    let pick = place("PickStickFromNothing", &[robot, stick]);
    let to_first = place("StickMoveToButtonFromNothing", &[robot, stick, first]);
    let to_second = place("StickMoveToButtonFromNothing", &[robot, stick, second]);
    let from_first = place(
        "StickMoveToButtonFromButton",
        &[robot, stick, second, first],
    );
    let put = place("PlaceStickFromNothing", &[robot, stick, holder]);
    let put_from_first = place("PlaceStickFromButton", &[robot, stick, holder, first]);
    let cases = [
        (&[pick, to_first][..], true),
        (&[pick, to_first, from_first], true),
        (&[pick, to_first, put_from_first], true),
        (&[pick, put], true),
        (&[pick, to_first, to_second], false),
        (&[pick, to_first, put], false),
    ];
    let mut skill_room = SkillRoom::default();
    let mut skills = skill_room.lend(&environment).unwrap();
    for observed in [false, true] {
        if observed {
            observe(&environment, &mut skills, &tasks, 10);
            for index in 0..skills.iter().count() {
                skills.get_mut(index).unwrap().set_region(None);
            }
        }
        let mut guide = RegionGuide::new(&environment, &skills, &task.initial);
        for (places, works) in cases {
            let kept = is_kept(&mut guide, &grounding.operators, places);
            assert_eq!(kept, works || !observed, "{places:?}, {observed}");
        }
    }
}
