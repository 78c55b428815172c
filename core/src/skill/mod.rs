//! Skills: the bridge between learning and planning.
//!
//! An environment says in a domain text what can be said of a controller, or of two
//! that run one after the other ([`Describe`]). From training tasks a [`Trainer`] learns
//! a region of each text (the thesis's RegionLearningApproach, 5.2, and its sequential
//! feasibility, 7.2):
//!
//! | text | of a controller alone | with a later one |
//! |---|---|---|
//! | with parameters | with which parameters it works | with which the later one works, too |
//! | without | in which states it works | in which states the two can work |
//!
//! The later controller may have parameters of its own and need others in between (pick,
//! put, pick): what is learned is whether there are any with which it works.
//!
//! | word | what it is |
//! |---|---|
//! | [`Skills`] | the store: a [`Skill`] for each text, with its region, and what controllers change ([`Changes`]) and where they leave things ([`Effects`]) |
//! | [`RoleBinding`] | how the objects of a text, its *roles*, are filled from a [`Context`]: a state and the objects of ground operators |
//! | [`write_pair`] | the text of two controllers, of what is said of each |
//! | [`Setting`], [`Practice`] | what is asked of an environment, or of a program behind callbacks: to use skills, and to learn them |
//! | [`Situation`] | a state and the operators to try from it: an instance that can be run |
//! | [`Oracle`] | tries situations and answers the learner's questions |
//! | [`Journal`], [`Course`] | the runs of a skill that is being learned, and what was learned so far, to be saved |
//! | joint region | of a step in a plan skeleton: what its region and those of later steps have in common |
//! | [`RegionSampler`] | draws the parameters of a step from its joint region |
//! | [`RegionGuide`] | postpones, or prunes, a sequence of operators with an empty joint region |
//!
//! The last two are what a bilevel planner of the kind "search, then sample" (SeSamE, see
//! [`plan`](crate::plan)) asks for: its samplers, and advice to its search.
//!
//! # Learning to use a stick, and planning with it
//!
//! ```
//! use critreg::env::stick_button::{PICK_STICK, StickButton};
//! use critreg::learn::{Capacity, Config};
//! use critreg::plan::{self, Conclusion, GroundTask, Planner};
//! use critreg::random::generator;
//! use critreg::skill::*;
//! use critreg::task::Task;
//!
//! // Memory: of skills, of learning them in 8 situations, of a planner, of a learner.
//! let mut skill_room = SkillRoom::<4, 4>::default();
//! let mut training_room = TrainingRoom::<8, 32>::default();
//! let mut planner_room = plan::Room::<_, 32, 256, 8>::default();
//! critreg::room!(struct LearnerRoom: f64, Capacity { steps: 2, ..Capacity::new(2048, 64) });
//! let mut learner_room = LearnerRoom::new();
//! let learner = (learner_room.lend(), LearnerRoom::CAPACITY);
//! let memory = training_room.lend(planner_room.lend(), learner);
//!
//! // Training tasks, and 50 questions about each skill.
//! let environment = StickButton { angles: false };
//! let mut rng = generator(1);
//! let tasks = (0..8).map(|_| environment.task(1..=2, &mut rng));
//! let tasks = tasks.collect::<Result<Vec<Task>, _>>()?;
//! let training = Training {
//!     learner: Config { calls: 50, ..Config::default() },
//!     chained: 50,
//!     situations: 8,
//!     ..Training::default()
//! };
//! let mut trainer = Trainer::new(&environment, training, memory);
//! let mut skills = skill_room.lend(&environment)?;
//! for index in 0..StickButton::DESCRIPTIONS.len() {
//!     trainer.learn(&mut skills, index, &tasks)?;
//! }
//! let pick = skills.about(PICK_STICK, None).next().unwrap();
//! let mut text = String::new();
//! pick.region().unwrap().write(pick.domain(), &mut text).unwrap();
//! assert_eq!(
//!     text,
//!     "grasp.y <= 2.9 (zone.top - robot.radius) and \
//!      dist_y(grasp, holder.centre) >= 0.25 (robot.radius + 0.5*holder.width)"
//! );
//!
//! // In a new task, with a button that only the stick reaches. With the original sampler
//! // and no guide, the planner finds nothing in this memory.
//! let task = environment.task(1..=1, &mut generator(0))?;
//! let ground = GroundTask::<_, 32>::new(&environment, &task)?;
//! let mut planner = Planner {
//!     world: &mut ground.simulated(),
//!     sampler: &mut RegionSampler::new(&environment, &skills),
//!     guide: &mut RegionGuide::new(&environment, &skills, &task.initial),
//!     config: plan::Config::default(),
//! };
//! let (lots, samples) = (generator(1), || generator(1));
//! let planned = planner.plan(ground.task(), &task.initial, lots, samples, planner_room.lend())?;
//! assert_eq!(planned.conclusion, Conclusion::Solved);
//! assert_eq!(planned.metrics.plan_length, 2);
//! assert!(planned.metrics.samples <= 4);
//! # Ok::<(), critreg::Error>(())
//! ```

mod changes;
mod context;
mod description;
mod effects;
mod pair;
mod planning;
mod role_binding;
mod room;
mod setting;
mod skills;
mod training;
mod tuning;

pub use changes::Changes;
pub use context::Context;
pub use description::{Describe, Description};
pub use effects::Effects;
pub use pair::{Later, write_pair};
pub use planning::{RegionGuide, RegionSampler};
pub use role_binding::RoleBinding;
pub use room::{SkillRoom, TrainingRoom};
pub use setting::{Practice, Said, Setting, Signature};
pub use skills::{Skill, Skills};
pub use training::{
    Candidate, Course, Journal, Learned, MAX_CHAIN, Oracle, Situation, Trainer, Training,
    TrainingMemory,
};
