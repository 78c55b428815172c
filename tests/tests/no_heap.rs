//! Nothing is taken from the heap, from the first call to the last: learning, drawing,
//! saving and planning, in Rust and in C.

use critreg::domain::Domain;
use critreg::env::stick_button::StickButton;
use critreg::learn::version_space::{Capacity, Config, VersionSpace};
use critreg::learn::{Problem, learn_region};
use critreg::plan::{Conclusion, Planner};
use critreg::random::generator;
use critreg::skill::{Describe, RegionGuide, RegionSampler, Training};
use critreg::text::TextBuffer;
use critreg_tests::pick::{ENVIRONMENT, instances};
use critreg_tests::plan::skills::{SkillRoom, TrainingRoom, tasks};
use critreg_tests::plan::{Grounding, Room};
use critreg_tests::room::VersionSpaceRoom;
use std::alloc::{GlobalAlloc, Layout, System};
use std::cell::Cell;

/// The allocator of the system, counting.
struct Counting;

thread_local! {
    /// Calls by this thread: the test harness has others, which allocate.
    static CALLS: Cell<u64> = const { Cell::new(0) };
}

fn count() {
    CALLS.with(|calls| calls.set(calls.get() + 1));
}

// SAFETY: everything is passed on to the allocator of the system.
unsafe impl GlobalAlloc for Counting {
    unsafe fn alloc(&self, layout: Layout) -> *mut u8 {
        count();
        // SAFETY: as this function's contract.
        unsafe { System.alloc(layout) }
    }

    unsafe fn dealloc(&self, memory: *mut u8, layout: Layout) {
        count();
        // SAFETY: as this function's contract.
        unsafe { System.dealloc(memory, layout) }
    }
}

#[global_allocator]
static ALLOCATOR: Counting = Counting;

/// How often the allocator is called meanwhile.
fn calls<T>(work: impl FnOnce() -> T) -> (u64, T) {
    let before = CALLS.get();
    let result = work();
    (CALLS.get() - before, result)
}

#[test]
fn the_count_counts() {
    let (calls, text) = calls(|| String::from("on the heap"));
    assert_eq!((calls, text.len()), (1, 11));
}

#[test]
fn learning_and_drawing() {
    let instances = instances(7, 4);
    let capacity = Capacity {
        forms: 4096,
        tracked: 4096,
        sums: usize::MAX,
        questions: 16,
        observations: 128,
        instances: 4,
        steps: 1,
    };
    let mut room = VersionSpaceRoom::<f64>::new(capacity);
    let (mut bytes, mut words) = (vec![0; 8192], vec![0; 2048]);
    let (calls, drawn) = calls(|| -> Result<bool, critreg::Error> {
        let domain = Domain::parse(StickButton::PICK_DOMAIN)?;
        let problem = Problem::new(&domain, &instances, 4)?;
        let mut learner = VersionSpace::new(&domain, Config::default(), capacity, room.lend())?;
        learn_region(&mut learner, &problem, |_, query| {
            ENVIRONMENT.try_pick(problem.instance(query.instance)?, &query.theta)
        })?;
        critreg::learn::save(&learner, &problem, &mut bytes)?;
        let region = critreg::learn::Learner::region(&learner)?;
        let mut text = TextBuffer::new(&mut words);
        region.write(&domain, &mut text).expect("there is room");
        region.save::<f64>(&domain, &mut bytes)?;
        let instance = problem.instance(0)?;
        let theta = region.sample::<f64>(&domain, instance, &mut generator(1))?;
        Ok(ENVIRONMENT.try_pick(instance, &theta)?.is_feasible())
    });
    assert_eq!((calls, drawn), (0, Ok(true)));
}

#[test]
fn learning_skills_and_planning_with_them() {
    let training = Training::default();
    let training_tasks = tasks(1, 1..=2, training.states);
    let (mut room, mut planner_room) = (TrainingRoom::new(training), Room::new(10_000));
    let mut skill_room = SkillRoom::default();
    let task = tasks(2, 2..=2, 1).remove(0);
    let (calls, conclusion) = calls(|| -> Result<Conclusion, critreg::Error> {
        let mut skills = skill_room.lend(&ENVIRONMENT).unwrap();
        let mut trainer = room.trainer(&ENVIRONMENT, 0);
        for index in 0..StickButton::DESCRIPTIONS.len() {
            trainer.learn(&mut skills, index, &training_tasks)?;
        }
        let grounding = Grounding::new(&ENVIRONMENT, &task)?;
        let mut planner = Planner {
            world: &mut grounding.simulated(),
            sampler: &mut RegionSampler::new(&ENVIRONMENT, &skills),
            guide: &mut RegionGuide::new(&ENVIRONMENT, &skills, &task.initial),
            config: critreg::plan::Config::default(),
        };
        let (lots, samples) = (generator(1), || generator(1));
        let memory = planner_room.lend();
        let planned = planner.plan(grounding.task(), &task.initial, lots, samples, memory)?;
        Ok(planned.conclusion)
    });
    assert_eq!((calls, conclusion), (0, Ok(Conclusion::Solved)));
}

/// The calls of a C program.
mod c {
    use super::{calls, instances};
    use critreg_ffi::{
        boundary::rng::*,
        learner::{learning::*, making::*, saving::*},
        planner::{callbacks::*, config::*, making::*, planning::*},
        region::{sampling::*, writing::*},
        stick_button::{environment::*, world::*},
    };
    use std::ffi::{CStr, c_char};
    use std::mem::zeroed;
    use std::ptr::{null, null_mut};

    /// Whether a status is that of a call that did what it promises.
    fn ok(status: i32) {
        assert_eq!(status, 0);
    }

    #[test]
    fn learning_and_drawing() {
        let instances = instances(7, 4);
        let (first, count) = (instances.as_ptr(), 4);
        // SAFETY: NULL is the default configuration.
        let size = unsafe { critreg_learner_size(null()) };
        let mut memory = vec![0u64; size / 8 + 1];
        let (mut bytes, mut text) = (vec![0u8; 8192], vec![0 as c_char; 2048]);
        let (calls, mu) = calls(|| {
            let (mut learner, mut region) = (null_mut(), null());
            let (mut rng, mut mu, mut used) = (critreg_rng_seed(1), f64::NAN, 0);
            let (start, len) = (memory.as_mut_ptr().cast(), size);
            // SAFETY: all pointers are to variables and arrays of the lengths told.
            unsafe {
                let domain = critreg_stick_button_domain();
                ok(critreg_learner_init(
                    start,
                    len,
                    domain,
                    null(),
                    &mut learner,
                ));
                let pick = Some(critreg_stick_button_pick as _);
                ok(critreg_learn_region(
                    learner,
                    first,
                    count,
                    pick,
                    null_mut(),
                    &mut region,
                ));
                let (to, room) = (bytes.as_mut_ptr(), bytes.len());
                ok(critreg_learner_save(
                    learner, first, count, to, room, &mut used,
                ));
                ok(critreg_region_format(
                    region,
                    text.as_mut_ptr(),
                    text.len(),
                    &mut used,
                ));
                ok(critreg_sample_region(region, first, &mut rng, &mut mu));
            }
            mu
        });
        assert_eq!(calls, 0);
        assert!((0.0..=1.0).contains(&mu));
    }

    const DOMAIN: &str = concat!(include_str!("../data/pddl/stick_button.pddl"), "\0");
    const PROBLEM: &str = concat!(include_str!("../data/pddl/stick_button_problem.pddl"), "\0");

    #[test]
    fn planning() {
        let text =
            |text: &'static str| CStr::from_bytes_with_nul(text.as_bytes()).unwrap().as_ptr();
        let numbers = critreg_stick_button_state_len(2);
        // SAFETY: a configuration of zeros is overwritten before it is read.
        let mut config: critreg_planner_config = unsafe { zeroed() };
        // SAFETY: the configuration is as long as it says.
        let size = unsafe {
            ok(critreg_planner_config_init(
                &mut config,
                size_of_val(&config),
            ));
            config.state_len = numbers as u32;
            critreg_planner_size(&config)
        };
        let (mut memory, mut initial) = (vec![0u64; size / 8 + 1], vec![0.0; numbers]);
        let (calls, length) = calls(|| {
            let (mut planner, mut length) = (null_mut(), 0);
            let start = memory.as_mut_ptr().cast();
            // SAFETY: all pointers are to variables and arrays of the lengths told.
            unsafe {
                ok(critreg_stick_button_task(
                    3,
                    0,
                    2,
                    initial.as_mut_ptr(),
                    numbers,
                ));
                let (domain, problem) = (text(DOMAIN), text(PROBLEM));
                ok(critreg_planner_init(
                    start,
                    size,
                    domain,
                    problem,
                    &config,
                    &mut planner,
                ));
                for name in [c"PickStickFromNothing", c"PickStickFromButton"] {
                    let along = [0.0, 1.0];
                    ok(critreg_planner_set_ranges(
                        planner,
                        name.as_ptr(),
                        along.as_ptr(),
                        1,
                    ));
                }
                for name in [c"PlaceStickFromNothing", c"PlaceStickFromButton"] {
                    let across = [-1.0, 1.0];
                    ok(critreg_planner_set_ranges(
                        planner,
                        name.as_ptr(),
                        across.as_ptr(),
                        1,
                    ));
                }
                let mut callbacks: critreg_callbacks = zeroed();
                ok(critreg_callbacks_init(
                    &mut callbacks,
                    size_of_val(&callbacks),
                ));
                callbacks.execute = Some(critreg_stick_button_execute);
                callbacks.holds = Some(critreg_stick_button_holds);
                let (from, no_options) = (initial.as_ptr(), null_mut());
                ok(critreg_plan(
                    planner,
                    &callbacks,
                    from,
                    3,
                    no_options,
                    &mut length,
                ));
            }
            length
        });
        assert_eq!(calls, 0);
        assert!(length >= 2);
    }
}
