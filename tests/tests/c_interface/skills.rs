//! A C program that learns skills and plans with them learns and plans what the core does.

use crate::support::{BOTH, compile, root, run};
use critreg::env::stick_button::StickButton;
use critreg::learn::version_space::{Capacity, Config, Quality};
use critreg::plan::{self, Conclusion, Planner};
use critreg::random::generator;
use critreg::skill::{
    Describe, Learned, RegionGuide, RegionSampler, Skills, Trainer, Training, TrainingRoom,
};
use critreg::task::Task;
use critreg_tests::pick::ENVIRONMENT;
use critreg_tests::plan::skills::SkillRoom;
use critreg_tests::plan::{Grounding, MAX_OPERATORS, Room};
use critreg_tests::room::VersionSpaceRoom;
use std::fmt::Write as _;
use std::process::Command;

const TRAINING: usize = 40;

#[test]
fn a_c_program_learns_and_plans_as_the_core_does() {
    let source = root().join("tests/c/skills.c");
    let expected = of_the_core();
    let texts = StickButton::DESCRIPTIONS.iter().map(|own| own.text);
    for language in BOTH {
        let program = compile("skills", std::slice::from_ref(&source), language);
        let output = run(Command::new(program).args(texts.clone()));
        let printed = String::from_utf8(output.stdout).unwrap();
        assert_eq!(rounded(&printed), rounded(&expected));
    }
}

/// A text with its numbers rounded: the program's simulator takes sines of another library, so a
/// threshold without a name differs in the last digits.
fn rounded(text: &str) -> String {
    let words = text.split_inclusive([' ', '\n']);
    let round = |word: &str| {
        let number = word.trim_end();
        match number.parse::<f64>() {
            Ok(value) if number.contains('.') => word.replace(number, &format!("{value:.9}")),
            _ => word.into(),
        }
    };
    words.map(round).collect()
}

/// What the program prints.
fn of_the_core() -> String {
    let mut skill_room = SkillRoom::default();
    let mut skills = skill_room.lend(&ENVIRONMENT).unwrap();
    let tasks: Vec<Task> = (0..TRAINING as u64)
        .map(|index| {
            let buttons = 1 + index as usize % 2;
            let task = ENVIRONMENT.task(buttons..=buttons, &mut generator(1000 + index));
            task.unwrap()
        })
        .collect();
    let mut room = Room::new(1000);
    let mut learner = VersionSpaceRoom::new(Capacity {
        forms: 4096,
        tracked: usize::MAX,
        sums: usize::MAX,
        observations: 256,
        instances: TRAINING,
        questions: 16,
        steps: 2,
    });
    let mut tables = Box::<TrainingRoom<TRAINING, MAX_OPERATORS>>::default();
    let training = Training {
        learner: Config {
            seed: 3,
            calls: 100,
            ..Config::default()
        },
        chained: 120,
        situations: 12,
        states: TRAINING,
        ..Training::default()
    };
    let capacity = learner.capacity;
    let memory = tables.lend(room.lend(), (learner.lend(), capacity));
    let mut trainer = Trainer::new(&ENVIRONMENT, training, memory);
    let mut text = String::new();
    for index in 0..StickButton::DESCRIPTIONS.len() {
        let learned = trainer.learn(&mut skills, index, &tasks).unwrap();
        text += &described(&skills, index, &learned);
    }
    let regions = skills.iter().filter(|skill| skill.region().is_some());
    assert_eq!(regions.count(), 4, "{text}");
    (0..20).for_each(|task| text += &planned(&skills, task));
    assert!(text.contains(" needs "), "{text}");
    text
}

fn described(skills: &Skills<'_>, index: usize, learned: &Learned) -> String {
    let skill = skills.get(index).unwrap();
    let report = &learned.report;
    let quality = match learned.quality {
        Quality::None => 0,
        Quality::Provisional => 1,
        Quality::Approximate => 2,
        Quality::Exact => 3,
    };
    let mut line = format!(
        "{} {quality} {} {} {} {} {} {} {} {} ",
        u32::from(learned.region),
        learned.tasks,
        learned.situations,
        learned.runs,
        report.calls,
        report.feasible,
        report.infeasible,
        report.certificate.draws,
        report.certificate.feasible
    );
    match skill.region() {
        Some(region) => region.write(skill.domain(), &mut line).unwrap(),
        None => write!(line, "{}", learned.why).unwrap(),
    }
    line + "\n"
}

fn planned(skills: &Skills<'_>, seed: u64) -> String {
    let buttons = 1 + seed as usize % 4;
    let task = ENVIRONMENT.task(buttons..=buttons, &mut generator(seed));
    let task = task.unwrap();
    let grounding = Grounding::new(&ENVIRONMENT, &task).unwrap();
    let mut room = Room::new(10_000);
    let mut guide = RegionGuide::new(&ENVIRONMENT, skills, &task.initial);
    let mut planner = Planner {
        world: &mut grounding.simulated(),
        sampler: &mut RegionSampler::new(&ENVIRONMENT, skills),
        guide: &mut guide,
        config: plan::Config::default(),
    };
    let (lots, samples) = (generator(seed), || generator(seed));
    let planned = planner.plan(grounding.task(), &task.initial, lots, samples, room.lend());
    let planned = planned.unwrap();
    assert_eq!(planned.conclusion, Conclusion::Solved);
    let metrics = &planned.metrics;
    let mut line = format!(
        "{} {} {} {} {} {} {} ",
        metrics.samples,
        metrics.plan_length,
        metrics.nodes_expanded,
        metrics.nodes_created,
        metrics.postponed,
        metrics.informed_draws,
        metrics.empty_draws
    );
    if let Some(reason) = metrics.main_reason() {
        guide
            .explain(&grounding.operators, reason, &mut line)
            .unwrap();
    }
    writeln!(line).unwrap();
    line
}
