//! The guide keeps what may work, whatever objects are called.

use super::{NODES, TRUE_REGIONS, draw_from, guided, know, observe};
use critreg::env::stick_button::{
    FIRST_BUTTON, PICK_STICK, PLACE_STICK, ROBOT_PRESS_BUTTON, STICK_PRESS_BUTTON, StickButton,
    World,
};
use critreg::plan::{Advice, Config, Draw, Drawn, Guide, Metrics, Search, Skeleton};
use critreg::random::generator;
use critreg::skill::RegionGuide;
use critreg::task::{Environment, GroundOperator, ObjectId, State, Task};
use critreg_tests::pick::ENVIRONMENT;
use critreg_tests::plan::skills::{SkillRoom, tasks};
use critreg_tests::plan::{Grounding, Room};
use proptest::prelude::*;

/// Whether the last operator of a sequence works with some parameters, in the closed form
/// of the true regions, as far as they are about the initial state.
fn may_work(state: &State, operators: &[&GroundOperator]) -> bool {
    let world = World::of(state).unwrap();
    let ([_, stick, ..], [_, holder, _]) = (*world.stick, *world.holder);
    let controller = |ground: &GroundOperator| ENVIRONMENT.operator(ground).unwrap().controller;
    let button = |ground: &GroundOperator, place: usize| {
        let object = ground.objects.as_slice()[place];
        world.buttons[usize::from(object.0 - FIRST_BUTTON.0)][1]
    };
    let last = operators.last().unwrap();
    if controller(last) == ROBOT_PRESS_BUTTON {
        return button(last, 1) <= 2.9;
    }
    let decides =
        |ground: &&GroundOperator| [PICK_STICK, PLACE_STICK].contains(&controller(ground));
    let Some(own) = operators.iter().rposition(decides) else {
        return true;
    };
    if controller(operators[own]) != PICK_STICK {
        return true;
    }
    // A stick that was placed lies elsewhere.
    if operators[..own]
        .iter()
        .any(|ground| [PLACE_STICK, STICK_PRESS_BUTTON].contains(&controller(ground)))
    {
        return true;
    }
    (0..=30_000).any(|i| {
        let q = 3.0 * f64::from(i) / 30_000.0;
        let picks = stick + q <= 2.9 && (stick + q - holder - 0.15).abs() >= 0.25;
        picks
            && operators[own + 1..].iter().all(|ground| {
                let reach = (2.95 - q).abs() - button(ground, 2);
                (-2.9..=-0.1).contains(&reach)
            })
    })
}

/// Compares each advice with the closed form.
struct Checked<'a> {
    guide: RegionGuide<'a, StickButton>,
    initial: &'a State,
    counts: [u32; 2],
}

impl Guide for Checked<'_> {
    fn judge(&mut self, prefix: Skeleton<'_>) -> Advice {
        let advice = self.guide.judge(prefix);
        let operators: Vec<_> = prefix.iter().collect();
        let expected = may_work(self.initial, &operators);
        assert_eq!(advice == Advice::Keep, expected, "{prefix:?}");
        self.counts[usize::from(expected)] += 1;
        advice
    }
}

#[test]
fn the_guide_keeps_what_may_work_and_nothing_else() {
    let mut skill_room = SkillRoom::default();
    let mut skills = skill_room.lend(&ENVIRONMENT).unwrap();
    observe(&mut skills);
    // Nothing is known of placing, which depends on where the stick was grasped.
    let regions = [TRUE_REGIONS[0], TRUE_REGIONS[1], "", TRUE_REGIONS[3]];
    know(&mut skills, &regions);
    let mut room = Room::new(NODES);
    let mut counts = [0; 2];
    for task in tasks(11, 1..=4, 40) {
        let grounding = Grounding::new(&ENVIRONMENT, &task).unwrap();
        let memory = room.lend();
        let mut metrics = Metrics::new(memory.failures, memory.reasons);
        let config = Config {
            patience: 200,
            ..Config::default()
        };
        let mut guide = Checked {
            guide: RegionGuide::new(&ENVIRONMENT, &skills, &task.initial),
            initial: &task.initial,
            counts: [0; 2],
        };
        let abstracted = grounding.task();
        let mut search = Search::new(
            abstracted,
            &config,
            generator(1),
            memory.search,
            &mut metrics,
        )
        .unwrap();
        for _ in 0..20 {
            search.next_skeleton(&mut guide, &mut metrics).unwrap();
        }
        counts = [counts[0] + guide.counts[0], counts[1] + guide.counts[1]];
    }
    assert!(counts.iter().all(|count| *count > 100), "{counts:?}");
}

/// Another order of the buttons, by the places of the old ones.
fn permuted(state: &State, order: &[usize]) -> State {
    let world = World::of(state).unwrap();
    let buttons: Vec<_> = order.iter().map(|old| world.buttons[*old]).collect();
    World {
        buttons: &buttons,
        ..world
    }
    .to_state()
    .unwrap()
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(60))]

    #[test]
    fn other_names_of_objects_change_nothing_but_names(
        seed in 0u64..1000, order in Just(vec![0, 1, 2]).prop_shuffle(),
        places in prop::collection::vec(0usize..1000, 1..5),
    ) {
        let mut skill_room = SkillRoom::default();
        let mut skills = skill_room.lend(&ENVIRONMENT).unwrap();
        know(&mut skills, &TRUE_REGIONS);
        let task = &tasks(seed, 3..=3, 1)[0];
        let other = Task { initial: permuted(&task.initial, &order), goal: task.goal.clone() };
        let renamed = |object: &ObjectId| match object.0.checked_sub(FIRST_BUTTON.0) {
            None => *object,
            Some(old) => {
                let new = order.iter().position(|o| *o == usize::from(old)).unwrap();
                ObjectId(FIRST_BUTTON.0 + new as u8)
            }
        };
        let groundings = [task, &other].map(|task| Grounding::new(&ENVIRONMENT, task).unwrap());
        let [first, second] = &groundings;
        let places: Vec<u16> = places.iter().map(|p| (p % first.operators.len()) as u16).collect();
        let others: Vec<u16> = places.iter().map(|place| {
            let ground = &first.operators[usize::from(*place)];
            let objects: Vec<_> = ground.objects.as_slice().iter().map(renamed).collect();
            let found = second.operators.iter().position(|o| {
                o.operator == ground.operator && o.objects.as_slice() == objects
            });
            found.unwrap() as u16
        }).collect();
        let judge = |task: &Task, grounding: &Grounding<'_, StickButton>, places: &[u16]| {
            let (mut sampler, mut guide) = guided(&skills, task);
            let skeleton = Skeleton::new(&grounding.operators, places);
            let kept = guide.judge(skeleton) == Advice::Keep;
            let draw = Draw {
                skeleton,
                step: 0,
                operator: skeleton.get(0).unwrap(),
                state: &task.initial,
                attempt: 1,
                advised: true,
            };
            let drawn = draw_from(&mut sampler, &draw, &mut generator(seed));
            let parameters = match drawn {
                Drawn::Parameters(p) | Drawn::Informed(p) => Some(p),
                Drawn::Empty(_) | Drawn::Nothing => None,
            };
            (kept, parameters)
        };
        prop_assert_eq!(judge(task, first, &places), judge(&other, second, &others));
    }
}
