//! The thesis's Table 6.1 and what learned regions make of it.

use super::row::{Row, ground};
use crate::data;
use crate::pick::{self, ENVIRONMENT};
use crate::plan::Room;
use crate::plan::lower_half::LowerHalf;
use crate::plan::record;
use crate::plan::skills::{self, SkillRoom, TrainingRoom};
use crate::room::Algorithm1Room;
use critreg::Error;
use critreg::env::stick_button::{PICK_STICK, ROBOT, STICK, StickButton};
use critreg::learn::{Algorithm1, Outcome, Problem, learn_region};
use critreg::plan::Unguided;
use critreg::random::generator;
use critreg::region::Region;
use critreg::skill::{Describe, Skills, Training};
use critreg::task::{ControllerId, Environment, State, Task, try_operator};
use rand_pcg::Pcg64;

/// Test tasks of each seed.
const TASKS: usize = 50;
/// Nodes of the search.
const NODES: usize = 10_000;
/// Seeds of learning with Algorithm 1.
const ALGORITHM1_SEEDS: u64 = 100;
/// Learning begins with this seed; those below were used while the defaults were chosen.
const FIRST_SEED: u64 = 1000;
/// The ranges of numbers of buttons.
const BUTTONS: [(usize, usize); 3] = [(1, 1), (1, 2), (3, 4)];

/// Prints all rows, with tests of so many seeds.
pub fn print(seeds: u64) {
    replayed();
    algorithm1();
    version_space(seeds);
}

/// The recorded test tasks of a seed, or random ones where none are recorded.
fn tests(buttons: (usize, usize), seed: u64) -> Vec<Task> {
    let own = |t: &data::RecordedTask| {
        !t.angles && t.split == "test" && t.buttons == buttons && t.seed == seed
    };
    let recorded = data::tasks().filter(own);
    let recorded: Vec<Task> = recorded.map(|t| record::press_all(t.initial)).collect();
    if recorded.is_empty() {
        return skills::tasks(seed ^ 0x7E57_0000_0000, buttons.0..=buttons.1, TASKS);
    }
    recorded
}

/// The first two rows: the recorded runs of seed 0, with the framework's numbers.
fn replayed() {
    let generators: Vec<Pcg64> = record::streams().map(|s| s.generator).collect();
    let mut room = Room::new(NODES);
    let mut rows = [
        Row::new("seed 0, 1 button (replay)", "original"),
        Row::new("seed 0, 1 button (replay)", "PickStick from U(0, 0.5)"),
    ];
    for run in record::runs_of_the_thesis() {
        let numbers = || generators[run.planner_seed as usize].clone();
        let [original, lower] = &mut rows;
        original.plan_originally((&ENVIRONMENT, &run.task), numbers, &mut room);
        let grounding = ground(&ENVIRONMENT, &run.task);
        let advice = (LowerHalf(grounding.simulated()), Unguided);
        lower.plan((&grounding, &run.task), advice, numbers, &mut room);
    }
    rows.iter().for_each(Row::print);
}

/// Plans with skills; lots and samples are those of the task's place.
fn plan(row: &mut Row, tests: &[Task], skills: &Skills<'_>, room: &mut Room) {
    for (index, task) in (1..).zip(tests) {
        row.plan_with_skills((&ENVIRONMENT, task), skills, || generator(index), room);
    }
}

/// The next rows: what the thesis's learner makes of PickStick, beside nothing, with the
/// library's numbers.
fn algorithm1() {
    let tests = tests((1, 1), 0);
    let mut room = Room::new(NODES);
    let mut row = Row::new("seed 0, 1 button", "learned by algorithm1");
    for seed in FIRST_SEED..FIRST_SEED + ALGORITHM1_SEEDS {
        let mut skill_room = SkillRoom::default();
        let mut skills = skill_room.lend(&ENVIRONMENT).expect("valid descriptions");
        match grasps(&skills, seed) {
            Ok(region) => {
                row.regions += 1;
                skills
                    .get_mut(0)
                    .expect("the first is PickStick")
                    .set_region(Some(region));
            }
            Err(Error::NoRegion) => {}
            Err(error) => panic!("{error}"),
        }
        plan(&mut row, &tests, &skills, &mut room);
    }
    let mut original = Row::new("seed 0, 1 button", "original");
    for (index, task) in (1..).zip(&tests) {
        original.plan_originally((&ENVIRONMENT, task), || generator(index), &mut room);
    }
    original.print();
    row.learners = ALGORITHM1_SEEDS as u32;
    row.learning_calls = ALGORITHM1_SEEDS * 100;
    row.print();
}

/// The region of PickStick by Algorithm 1, with the thesis's set-up and four instances.
fn grasps(skills: &Skills<'_>, seed: u64) -> Result<Region, Error> {
    let skill = skills
        .about(PICK_STICK, None)
        .next()
        .expect("it is described");
    let states: Vec<State> = skills::tasks(seed, 1..=1, 4)
        .into_iter()
        .map(|t| t.initial)
        .collect();
    let length = skill.binding().len();
    let mut instances = vec![0.0; states.len() * length];
    for (state, numbers) in states.iter().zip(instances.chunks_exact_mut(length)) {
        skill.binding().instance(&pick::context(state), numbers)?;
    }
    let problem = Problem::new(skill.domain(), &instances, states.len())?;
    let mut room = Algorithm1Room::new(20_000, 102);
    let capacity = room.capacity;
    let config = pick::config(seed);
    let mut learner = Algorithm1::new(skill.domain(), config, capacity, room.lend())?;
    let region = learn_region(&mut learner, &problem, |_, query| {
        let state = &states[query.instance];
        let operator = &StickButton::OPERATORS[1];
        let mu = query.theta[0];
        let tried = try_operator(&ENVIRONMENT, operator, &[ROBOT, STICK], &[mu], state);
        Ok::<_, Error>(Outcome::from_feasible(tried.is_feasible()))
    });
    region.cloned()
}

/// The other rows: for each seed all skills are learned from training tasks of its own.
fn version_space(seeds: u64) {
    let name = |(least, most): (usize, usize), sampler| {
        let buttons = match least == most {
            true => format!("{least} button"),
            false => format!("{least} or {most} buttons"),
        };
        Row::new(&format!("{seeds} seeds, {buttons}"), sampler)
    };
    let mut originals = BUTTONS.map(|buttons| name(buttons, "original"));
    let mut rows = BUTTONS.map(|buttons| name(buttons, "learned, version_space"));
    let descriptions = StickButton::DESCRIPTIONS;
    let mut calls = vec![(0, 0); descriptions.len()];
    let mut room = Room::new(NODES);
    let mut training_room = TrainingRoom::new(Training::default());
    for seed in 0..seeds {
        let mut skill_room = SkillRoom::default();
        let mut skills = skill_room.lend(&ENVIRONMENT).expect("valid descriptions");
        let learned = skills::learn(&mut skills, FIRST_SEED + seed, &mut training_room);
        let learned = learned.expect("learning does not fail");
        for ((sum, regions), learned) in calls.iter_mut().zip(&learned) {
            *sum += learned.runs;
            *regions += u32::from(learned.region);
        }
        for (buttons, (original, row)) in
            BUTTONS.into_iter().zip(originals.iter_mut().zip(&mut rows))
        {
            let tests = tests(buttons, seed);
            for (index, task) in (1..).zip(&tests) {
                let numbers = || generator(index);
                original.plan_originally((&ENVIRONMENT, task), numbers, &mut room);
            }
            plan(row, &tests, &skills, &mut room);
            row.learners += 1;
            row.regions += learned.iter().map(|l| u32::from(l.region)).sum::<u32>();
            row.learning_calls += learned.iter().map(|l| u64::from(l.runs)).sum::<u64>();
        }
    }
    for (original, row) in originals.iter().zip(&rows) {
        original.print();
        row.print();
        row.print_payback(original);
    }
    for (description, (calls, regions)) in descriptions.iter().zip(calls) {
        let name = |id: ControllerId| StickButton::CONTROLLERS[usize::from(id.0)].name;
        let later = description
            .later
            .map_or(String::new(), |id| format!(" then {}", name(id)));
        println!("learning: {}{later}", name(description.controller));
        println!(
            "learning_calls_mean: {:.1}",
            f64::from(calls) / seeds as f64
        );
        println!("regions: {regions}/{seeds}");
    }
}
