//! What is learned of controllers, and what planning takes with it.

use super::{NODES, guided, observe, plan};
use critreg::env::stick_button::{
    FIRST_BUTTON, HOLDER, PICK_STICK, PLACE_STICK, ROBOT, ROBOT_PRESS_BUTTON, STICK,
    STICK_PRESS_BUTTON,
};
use critreg::plan::{Conclusion, Planned, Unguided};
use critreg::skill::Training;
use critreg::task::{ObjectId, State};
use critreg_tests::pick::ENVIRONMENT;
use critreg_tests::plan::skills::{SkillRoom, TrainingRoom, learn, tasks};
use critreg_tests::plan::{Grounding, Room};

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
