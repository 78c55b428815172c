//! Learned regions, and tasks that show what they say.

use crate::data::to_state;
use crate::report::{Scenario, chain, pick};
use crate::room::VersionSpaceRoom;
use crate::text;
use critreg::Error;
use critreg::learn::{Problem, learn_region};
use critreg::region::Region;
use critreg::task::State;

/// The seed that the regions are learned with.
const SEED: u64 = 1;
/// The seed of the tasks from which those to show are chosen.
const TASKS_SEED: u64 = 1000;
/// How many these are.
const TASKS: usize = 1000;

/// What was learned about a scenario.
pub struct Learned {
    scenario: Scenario,
    region: Region,
}

impl Learned {
    /// Learns with as many instances and calls as the scenario has.
    ///
    /// # Panics
    /// If the answers explain no region.
    pub fn new(scenario: Scenario) -> Learned {
        let instances = scenario.draw(SEED, scenario.instances);
        let domain = &scenario.domain;
        let problem = Problem::new(domain, &instances, scenario.instances).expect("valid");
        let mut room = VersionSpaceRoom::<f64>::new(scenario.capacity());
        let learner = room.learner(domain, scenario.config(SEED));
        let mut learner = learner.expect("enough room");
        let learned = learn_region(&mut learner, &problem, |_, query| {
            let instance = problem.instance(query.instance)?;
            Ok::<_, Error>(scenario.judge(instance, &query.theta))
        });
        let region = learned.expect("the answers explain a region");
        Learned {
            region: region.clone(),
            scenario,
        }
    }

    /// The constraints, each as text.
    pub fn constraints(&self) -> Vec<String> {
        let text = text::of_region(&self.scenario.domain, &self.region);
        text.split(" and ").map(str::to_string).collect()
    }

    /// How many grasps were tried.
    pub fn tries(&self) -> u32 {
        self.scenario.calls
    }

    /// In how many tasks.
    pub fn tasks(&self) -> usize {
        self.scenario.instances
    }

    /// From where to where along the stick the action works, in shares of its width.
    ///
    /// # Panics
    /// If the instance is none of the scenario.
    pub fn intervals(&self, instance: &[f64]) -> Vec<[f64; 2]> {
        let grounded = self.region.ground::<f64>(&self.scenario.domain, instance);
        let grounded = grounded.expect("a valid instance");
        let set = grounded.intervals().expect("picking has one parameter");
        let intervals = set.intervals().iter();
        intervals.map(|i| [i.low, i.high]).collect()
    }

    /// Whether the action does work there.
    pub fn works(&self, instance: &[f64], mu: f64) -> bool {
        self.scenario.judge(instance, &[mu]).is_feasible()
    }
}

/// A task, and where its stick can be picked.
pub struct Panel<'l> {
    /// What there is to see.
    pub title: &'static str,
    /// The initial state.
    pub state: State,
    /// What the intervals are from.
    pub learned: &'l Learned,
    /// Where all that is asked for works.
    pub feasible: Vec<[f64; 2]>,
    /// Where at least the pick works.
    pub pick: Vec<[f64; 2]>,
}

/// The two regions of the picture.
pub struct Regions {
    /// Picking the stick.
    pub pick: Learned,
    /// Picking it, then pressing a button above the zone with it.
    pub chain: Learned,
}

impl Regions {
    /// Learns both.
    pub fn learn() -> Regions {
        Regions {
            pick: Learned::new(pick()),
            chain: Learned::new(chain()),
        }
    }

    /// A task that the holder shows in, one that the zone shows in, and one with a button
    /// that only the stick reaches.
    pub fn panels(&self) -> [Panel<'_>; 3] {
        let wide = |i: &[[f64; 2]]| i.iter().all(|i| length(i) > 0.12);
        [
            self.panel(
                "Pick: the holder cuts a gap into the stick",
                &self.pick,
                |all, _| all.len() == 2 && wide(all),
            ),
            self.panel(
                "Pick: the top is out of the robot's zone",
                &self.pick,
                |all, _| matches!(all, [i] if (0.2..0.5).contains(&length(i))),
            ),
            self.panel(
                "Pick, then press with the stick: less of it is good",
                &self.chain,
                |all, pick| all.len() == 2 && wide(all) && total(all) < 0.8 * total(pick),
            ),
        ]
    }

    /// The first task with such intervals, of all and of the pick alone, and with room
    /// for words beside the stick.
    fn panel<'l>(
        &'l self,
        title: &'static str,
        learned: &'l Learned,
        shows: impl Fn(&[[f64; 2]], &[[f64; 2]]) -> bool,
    ) -> Panel<'l> {
        let instances = learned.scenario.draw(TASKS_SEED, TASKS);
        let mut tasks = instances.chunks_exact(learned.scenario.domain.instance_len());
        let panel = tasks.find_map(|instance| {
            let (feasible, pick) = (learned.intervals(instance), self.pick.intervals(instance));
            let fits = shows(&feasible, &pick) && (2.0..8.0).contains(&instance[STICK_X]);
            fits.then(|| Panel {
                title,
                state: to_state(instance),
                learned,
                feasible,
                pick,
            })
        });
        panel.expect("a task that shows it")
    }
}

/// Where the stick's x is among the numbers of an instance: behind the robot's three.
const STICK_X: usize = 3;

fn length([low, high]: &[f64; 2]) -> f64 {
    high - low
}

fn total(intervals: &[[f64; 2]]) -> f64 {
    intervals.iter().map(length).sum()
}
