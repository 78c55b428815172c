//! Why there is no plan, in words.

use super::{NODES, TRUE_REGIONS, guided, know, observe};
use critreg::env::stick_button::{BUTTON_TYPE, FIRST_BUTTON, PRESSED, ROBOT, STICK, StickButton};
use critreg::plan::{Conclusion, Config};
use critreg::random::generator;
use critreg::skill::{Describe, RegionGuide};
use critreg::task::{Environment, Task, try_operator};
use critreg_tests::pick::ENVIRONMENT;
use critreg_tests::plan::skills::{SkillRoom, tasks};
use critreg_tests::plan::{Grounding, Room, plan_as};

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
    let (sampler, mut guide) = guided(&skills, &task);
    guide.prune = true;
    let mut room = Room::new(NODES);
    let (initial, advice) = (&task.initial, (sampler, guide));
    let config = Config {
        max_length: 2,
        ..Config::default()
    };
    let numbers = || generator(1);
    let planned = plan_as(config, &grounding, initial, advice, numbers, &mut room);
    let planned = planned.unwrap();
    assert_ne!(planned.conclusion, Conclusion::Solved);
    let (_, guide) = guided(&skills, &task);
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
