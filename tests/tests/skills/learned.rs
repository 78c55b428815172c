//! Learned skills: regions, planning with them, and why something cannot work.

use critreg::env::stick_button::{
    BUTTON_TYPE, FIRST_BUTTON, HOLDER, PICK_STICK, PLACE_STICK, PRESSED, ROBOT, ROBOT_PRESS_BUTTON,
    STICK, STICK_PRESS_BUTTON, StickButton, World,
};
use critreg::plan::{
    Advice, Conclusion, Config, Draw, Drawn, Guide, Metrics, Planned, Planner, Sampler, Search,
    Simulated, Skeleton, Spent, Unguided,
};
use critreg::random::{Generator, generator};
use critreg::region::Region;
use critreg::skill::{Describe, RegionGuide, RegionSampler, Skills, Training};
use critreg::task::{Environment, GroundOperator, ObjectId, State, Task, try_operator};
use critreg_tests::pick::ENVIRONMENT;
use critreg_tests::plan::skills::{SkillRoom, TrainingRoom, learn, tasks};
use critreg_tests::plan::{Grounding, Room, record};
use proptest::prelude::*;

/// The regions that are learned in every detail.
const TRUE_REGIONS: [&str; 4] = [
    "grasp.y <= 2.9 and dist_y(grasp, holder.centre) >= 0.25",
    "button.y <= 2.9",
    "release.y >= 0.1 and release.y <= 2.9",
    "dist_y(grasp, stick.tip) - button.y <= -0.1 and dist_y(grasp, stick.tip) - button.y >= -2.9",
];

/// Skills with these regions; an empty text is no region.
fn know(skills: &mut Skills<'_>, regions: &[&str]) {
    for (index, text) in regions.iter().enumerate() {
        let skill = skills.get_mut(index).unwrap();
        let region = (!text.is_empty()).then(|| Region::parse(skill.domain(), text).unwrap());
        skill.set_region(region);
    }
}

/// Runs every controller once, so that it is seen what they change.
fn observe(skills: &mut Skills<'_>) {
    let training = Training {
        chained: 20,
        budget: 0,
        way: 10_000,
        tasks: 10,
        situations: 4,
        states: 10,
        learner: critreg::learn::version_space::Config {
            calls: 20,
            certifying: 2,
            ..Default::default()
        },
    };
    learn(skills, 1, &mut TrainingRoom::new(training)).unwrap();
}

/// Plans with numbers that begin again with each skeleton.
fn plan<'m, S: Sampler<Simulated<'m, StickButton>>, G: Guide>(
    task: &Task,
    grounding: &'m Grounding<'_, StickButton>,
    (mut sampler, mut guide): (S, G),
    room: &'m mut Room,
) -> Planned<'m, State> {
    let mut planner = Planner {
        world: &mut grounding.simulated(),
        sampler: &mut sampler,
        guide: &mut guide,
        config: Config::default(),
    };
    let (abstracted, initial, numbers) = (grounding.task(), &task.initial, || generator(7));
    let planned = planner.plan(abstracted, initial, numbers(), numbers, room.lend());
    planned.unwrap()
}

/// The region sampler and the region guide of these skills, for a task.
fn guided<'a>(
    skills: &'a Skills<'_>,
    task: &'a Task,
) -> (RegionSampler<'a, StickButton>, RegionGuide<'a, StickButton>) {
    let guide = RegionGuide::new(&ENVIRONMENT, skills, &task.initial);
    (RegionSampler::new(&ENVIRONMENT, skills), guide)
}

/// What the sampler of the environment draws.
fn draw_from(
    sampler: &mut RegionSampler<'_, StickButton>,
    draw: &Draw<'_, State>,
    rng: &mut Generator,
) -> Drawn {
    Sampler::<Simulated<'_, StickButton>>::sample(sampler, draw, rng).unwrap()
}

const NODES: usize = 10_000;

// Learning

#[test]
fn steps_are_followed_to_where_controllers_leave_things() {
    let mut skill_room = SkillRoom::default();
    let mut skills = skill_room.lend(&ENVIRONMENT).unwrap();
    learn(&mut skills, 3, &mut TrainingRoom::new(Training::default())).unwrap();
    let press = skills.about(ROBOT_PRESS_BUTTON, None).next().unwrap();
    assert!(!press.effects().is_empty(), "the robot is at the button");
    let mut room = Room::new(NODES);
    let (mut samples, mut length) = (0, 0);
    for task in tasks(77, 3..=4, 20) {
        let grounding = Grounding::new(&ENVIRONMENT, &task).unwrap();
        let (mut sampler, mut guide) = guided(&skills, &task);
        (sampler.lookahead, guide.lookahead) = (8, 8);
        let planned = plan(&task, &grounding, (sampler, guide), &mut room);
        assert_eq!(planned.conclusion, Conclusion::Solved);
        samples += planned.metrics.samples;
        length += planned.metrics.plan_length;
    }
    assert!(
        f64::from(samples) <= 1.05 * f64::from(length),
        "{samples} for {length}"
    );
}

#[test]
fn learned_skills_need_about_a_sample_per_step() {
    let mut training_room = TrainingRoom::new(Training::default());
    let mut room = Room::new(NODES);
    let mut skill_rooms = [SkillRoom::default(), SkillRoom::default()];
    let mut texts = vec![];
    for skill_room in &mut skill_rooms {
        let mut skills = skill_room.lend(&ENVIRONMENT).unwrap();
        let learned = learn(&mut skills, 3, &mut training_room).unwrap();
        let (mut samples, mut length) = (0, 0);
        for task in tasks(77, 3..=4, 50) {
            let grounding = Grounding::new(&ENVIRONMENT, &task).unwrap();
            let planned = plan(&task, &grounding, guided(&skills, &task), &mut room);
            assert_eq!(planned.conclusion, Conclusion::Solved);
            samples += planned.metrics.samples;
            length += planned.metrics.plan_length;
        }
        assert!(
            f64::from(samples) <= 1.05 * f64::from(length),
            "{samples} for {length}"
        );
        let text = skills.iter().map(|skill| {
            let mut text = String::new();
            let region = skill
                .region()
                .map(|region| region.write(skill.domain(), &mut text));
            region.map(|written| written.map(|()| text).unwrap())
        });
        texts.push((learned, text.collect::<Vec<_>>()));
    }
    assert_eq!(
        texts[0], texts[1],
        "learning depends on the seed and the tasks only"
    );
    let (learned, regions) = &texts[0];
    assert!(
        learned
            .iter()
            .zip(regions)
            .all(|(l, region)| l.region == region.is_some())
    );
    assert!(regions[0].is_some() && regions[1].is_some() && regions[3].is_some());
}

#[test]
fn what_controllers_change_is_seen_while_learning() {
    let mut skill_room = SkillRoom::default();
    let mut skills = skill_room.lend(&ENVIRONMENT).unwrap();
    observe(&mut skills);
    let task = &tasks(1, 2..=2, 1)[0];
    let (button, other) = (FIRST_BUTTON, ObjectId(FIRST_BUTTON.0 + 1));
    let robot = [(ROBOT, 0), (ROBOT, 1)];
    let stick = [(STICK, 0), (STICK, 1)];
    type Attributes = Vec<(ObjectId, usize)>;
    let cases: [(_, &[ObjectId], Attributes); 4] = [
        (
            PICK_STICK,
            &[ROBOT, STICK],
            [&robot[..], &[(STICK, 3)]].concat(),
        ),
        (
            PLACE_STICK,
            &[ROBOT, STICK],
            [&robot[..], &stick, &[(STICK, 3)]].concat(),
        ),
        (
            ROBOT_PRESS_BUTTON,
            &[ROBOT, button, STICK],
            [&robot[..], &[(button, 2)]].concat(),
        ),
        (
            STICK_PRESS_BUTTON,
            &[ROBOT, STICK, button],
            [&robot[..], &stick, &[(button, 2)]].concat(),
        ),
    ];
    for (controller, objects, expected) in cases {
        let changes = skills.changes(controller);
        let all = [ROBOT, STICK, HOLDER, button, other].into_iter();
        let all =
            all.flat_map(|o| (0..task.initial.attributes(o).unwrap().len()).map(move |a| (o, a)));
        let affected = all.filter(|(o, a)| changes.affect(objects, &task.initial, *o, *a));
        assert_eq!(affected.collect::<Vec<_>>(), expected, "{controller:?}");
    }
}

#[test]
fn a_skill_that_nothing_is_known_of_is_the_original_sampler() {
    let mut skill_room = SkillRoom::default();
    let skills = skill_room.lend(&ENVIRONMENT).unwrap();
    let mut room = Room::new(NODES);
    for task in tasks(5, 1..=2, 30) {
        let grounding = Grounding::new(&ENVIRONMENT, &task).unwrap();
        let outcome = |planned: Planned<'_, State>| {
            let (metrics, steps) = (planned.metrics, planned.steps.iter());
            let steps: Vec<_> = steps.map(|s| (s.operator, s.parameters.clone())).collect();
            (
                planned.conclusion,
                metrics.samples,
                metrics.nodes_created,
                steps,
            )
        };
        let ours = outcome(plan(&task, &grounding, guided(&skills, &task), &mut room));
        let original = (grounding.simulated(), Unguided);
        assert_eq!(ours, outcome(plan(&task, &grounding, original, &mut room)));
    }
}

// Judging

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

// Completeness

/// What there was to spend without advice, and the plan.
fn end(planned: &Planned<'_, State>) -> (Conclusion, Spent, Vec<u16>) {
    let metrics = &planned.metrics;
    let before = metrics.advised.unwrap_or_default();
    let spent = Spent {
        samples: metrics.samples - before.samples,
        skeletons: metrics.skeletons - before.skeletons,
    };
    let plan = planned.steps.iter().map(|step| step.operator).collect();
    (planned.conclusion, spent, plan)
}

#[test]
fn wrong_regions_cost_no_plan() {
    let mut room = Room::new(NODES);
    let mut skill_room = SkillRoom::default();
    let wrong: [[&str; 4]; 4] = [
        ["mu >= 0.9", "", "", ""],
        ["grasp.y >= 2.9", "button.y >= 3", "o >= 0.9", ""],
        ["", "button.y <= 0", "", "mu > 2"],
        ["not true", "not true", "not true", "not true"],
    ];
    let (mut anew, mut solved) = (0, 0);
    for regions in wrong {
        let mut skills = skill_room.lend(&ENVIRONMENT).unwrap();
        observe(&mut skills);
        know(&mut skills, &regions);
        for run in record::runs().step_by(7) {
            let grounding = Grounding::new(&ENVIRONMENT, &run.task).unwrap();
            let original = (grounding.simulated(), Unguided);
            let original = end(&plan(&run.task, &grounding, original, &mut room));
            let planned = plan(&run.task, &grounding, guided(&skills, &run.task), &mut room);
            if planned.metrics.advised.is_some() {
                anew += 1;
                assert_eq!(end(&planned), original, "{}", run.name);
            }
            let kept = planned.conclusion == Conclusion::Solved;
            assert!(kept || original.0 != Conclusion::Solved, "{}", run.name);
            solved += u32::from(kept);
        }
    }
    assert!(anew > 50 && solved > 50, "{anew} {solved}");
}

#[test]
fn draws_from_everything_reach_what_a_region_leaves_out() {
    let mut skill_room = SkillRoom::default();
    let mut skills = skill_room.lend(&ENVIRONMENT).unwrap();
    know(&mut skills, &["mu <= 0.25", "", "", ""]);
    let task = &tasks(2, 1..=1, 1)[0];
    let grounding = Grounding::new(&ENVIRONMENT, task).unwrap();
    let is_pick = |o: &GroundOperator| o.objects.as_slice() == [ROBOT, STICK];
    let place = grounding.operators.iter().position(is_pick).unwrap() as u16;
    let outside = |everywhere: f64| {
        let mut sampler = RegionSampler::new(&ENVIRONMENT, &skills);
        sampler.everywhere = everywhere;
        let places = [place];
        let skeleton = Skeleton::new(&grounding.operators, &places);
        let mut rng: Generator = generator(1);
        let beyond = (0..2000).filter(|_| {
            let draw = Draw {
                skeleton,
                step: 0,
                operator: skeleton.get(0).unwrap(),
                state: &task.initial,
                attempt: 1,
                advised: true,
            };
            match draw_from(&mut sampler, &draw, &mut rng) {
                Drawn::Parameters(p) | Drawn::Informed(p) => p[0] > 0.25,
                Drawn::Empty(_) | Drawn::Nothing => panic!("the region is not empty"),
            }
        });
        beyond.count()
    };
    assert_eq!(outside(0.0), 0);
    assert!(
        outside(0.2).abs_diff(300) < 60,
        "a fifth of the draws, three quarters of them"
    );
}

// Why

/// A task of which the first button is at a place along y, and all are to be pressed.
fn with_button_at(y: f64) -> Task {
    let mut task = tasks(1, 1..=1, 1).remove(0);
    task.initial.attributes_mut(FIRST_BUTTON).unwrap()[1] = y;
    task
}

#[test]
fn why_there_is_no_plan() {
    let mut skill_room = SkillRoom::default();
    let mut skills = skill_room.lend(&ENVIRONMENT).unwrap();
    observe(&mut skills);
    know(&mut skills, &TRUE_REGIONS);
    let task = with_button_at(5.97);
    let grounding = Grounding::new(&ENVIRONMENT, &task).unwrap();
    let (mut sampler, mut guide) = guided(&skills, &task);
    guide.prune = true;
    let mut room = Room::new(NODES);
    let mut planner = Planner {
        world: &mut grounding.simulated(),
        sampler: &mut sampler,
        guide: &mut guide,
        config: Config {
            max_length: 2,
            ..Config::default()
        },
    };
    let numbers = || generator(1);
    let planned = planner.plan(
        grounding.task(),
        &task.initial,
        numbers(),
        numbers,
        room.lend(),
    );
    let planned = planned.unwrap();
    assert_ne!(planned.conclusion, Conclusion::Solved);
    let explain = |reason| {
        let mut text = String::new();
        guide
            .explain(&grounding.operators, reason, &mut text)
            .unwrap();
        text
    };
    let reasons = planned.metrics.reasons().iter();
    let given = (0..).zip(reasons).filter(|(_, count)| **count > 0);
    let texts: Vec<String> = given
        .map(|(place, _)| explain(critreg::plan::ReasonId(place)))
        .collect();
    assert_eq!(
        texts,
        [
            "RobotPressButton(robby, button0, stick) needs button0.y <= 2.9, and it is 5.97",
            "StickPressButton(robby, stick, button0) after PickStick(robby, stick) \
             needs dist_y(grasp, stick.tip) - button0.y >= -2.9, \
             here dist_y(grasp, stick.tip) >= 3.07, and it is 0 to 2.95",
        ]
    );
    assert!(texts.contains(&explain(planned.metrics.main_reason().unwrap())));
}

#[test]
fn no_parameters_work_means_none_does() {
    // The explanation is about the world, too.
    let task = with_button_at(5.97);
    assert!(task.goal.iter().all(|atom| atom.predicate == PRESSED));
    assert_eq!(task.initial.of_type(BUTTON_TYPE).count(), 1);
    let operators = StickButton::OPERATORS;
    let (pick, press) = (&operators[1], &operators[7]);
    for i in 0..=200 {
        let mu = f64::from(i) / 200.0;
        let picked = try_operator(&ENVIRONMENT, pick, &[ROBOT, STICK], &[mu], &task.initial);
        let objects = [ROBOT, STICK, FIRST_BUTTON];
        let pressed = try_operator(&ENVIRONMENT, press, &objects, &[], &picked.state);
        assert!(!(picked.is_feasible() && pressed.is_feasible()), "{mu}");
    }
    assert_eq!(StickButton::DESCRIPTIONS.len(), TRUE_REGIONS.len());
}

/// A grasp that is low enough for the hand, and far enough from the tip for a button.
#[test]
fn constraints_that_cannot_both_hold_are_told_with_their_numbers() {
    let mut skill_room = SkillRoom::default();
    let mut skills = skill_room.lend(&ENVIRONMENT).unwrap();
    observe(&mut skills);
    know(
        &mut skills,
        &[
            "grasp.y <= 2.9",
            "",
            "",
            "dist_y(grasp, stick.tip) - button.y <= -3.5",
        ],
    );
    let mut task = with_button_at(4.0);
    let stick = task.initial.attributes_mut(STICK).unwrap();
    // Upright, from 1 to 4.
    stick[1] = 1.0;
    let grounding = Grounding::new(&ENVIRONMENT, &task).unwrap();
    let guide = RegionGuide::new(&ENVIRONMENT, &skills, &task.initial);
    let press = grounding.operators.iter().position(|ground| {
        let operator = ENVIRONMENT.operator(ground).unwrap();
        operator.name == "StickPressButtonFromNothing"
    });
    let mut text = String::new();
    let reason = critreg::plan::ReasonId(press.unwrap() as u16);
    guide
        .explain(&grounding.operators, reason, &mut text)
        .unwrap();
    assert_eq!(
        text,
        "StickPressButton(robby, stick, button0) after PickStick(robby, stick) needs \
         grasp.y <= 2.9, and it is 1 to 4, and dist_y(grasp, stick.tip) - button0.y <= -3.5, \
         here dist_y(grasp, stick.tip) <= 0.5, and it is 0 to 2.95; they cannot both hold"
    );
}
