//! What is learned about: a domain, random instances, and what judges a sample.

use critreg::domain::Domain;
use critreg::env::stick_button::{StickButton, ZONE_HEIGHT};
use critreg::learn::Outcome;
use critreg::learn::version_space::{Capacity, Config};
use critreg::random::{Generator, generator};
use critreg::region::Region;

/// Draws an instance.
pub(super) type Draw = Box<dyn Fn(&mut Generator) -> Vec<f64> + Sync>;
/// Judges parameters in an instance.
pub(super) type Judge = Box<dyn Fn(&[f64], &[f64]) -> Outcome + Sync>;

/// A learning problem of which fresh instances can be drawn.
pub struct Scenario {
    /// Its name.
    pub name: &'static str,
    /// The domain.
    pub domain: Domain<'static>,
    /// Training instances.
    pub instances: usize,
    /// Answers a learner is given.
    pub calls: u32,
    /// Steps of the sequence of actions.
    pub steps: usize,
    /// Share of the answers that is flipped.
    pub noise: f64,
    /// The formula that judges, if it is one and no simulator.
    pub truth: Option<String>,
    pub(super) draw: Draw,
    pub(super) judge: Judge,
}

const UPRIGHT: StickButton = StickButton { angles: false };
const TURNED: StickButton = StickButton { angles: true };

impl Scenario {
    /// A problem of random instances that a region judges.
    pub(super) fn of_region(
        domain: Domain<'static>,
        region: Region,
        truth: String,
        calls: u32,
        draw: impl Fn(&mut Generator) -> Vec<f64> + Sync + 'static,
    ) -> Scenario {
        let own = domain.clone();
        Scenario {
            name: "synthetic",
            domain,
            instances: 8,
            calls,
            steps: 1,
            noise: 0.0,
            truth: Some(truth),
            draw: Box::new(draw),
            judge: Box::new(move |instance, theta| {
                let works = region.contains::<f64>(&own, instance, theta);
                Outcome::from_feasible(works.expect("a valid sample"))
            }),
        }
    }

    /// A problem of random instances that a function judges, which need not be one that the
    /// domain text can say.
    pub(super) fn of_judge(
        name: &'static str,
        text: &'static str,
        (instances, calls): (usize, u32),
        draw: impl Fn(&mut Generator) -> Vec<f64> + Sync + 'static,
        works: impl Fn(&[f64], &[f64]) -> bool + Sync + 'static,
    ) -> Scenario {
        Scenario {
            name,
            domain: Domain::parse(text).expect("the text is valid"),
            instances,
            calls,
            steps: 1,
            noise: 0.0,
            truth: None,
            draw: Box::new(draw),
            judge: Box::new(move |instance, theta| Outcome::from_feasible(works(instance, theta))),
        }
    }

    /// Room for what a version-space learner is told.
    pub fn capacity(&self) -> Capacity {
        Capacity {
            forms: 12_000,
            tracked: usize::MAX,
            sums: usize::MAX,
            questions: 16,
            observations: self.calls as usize,
            instances: self.instances,
            steps: self.steps,
        }
    }

    /// The configuration of a version-space learner with this seed.
    pub fn config(&self, seed: u64) -> Config {
        Config {
            seed,
            calls: self.calls,
            noise: self.noise,
            ..Config::default()
        }
    }

    /// The numbers of `count` random instances.
    pub fn draw(&self, seed: u64, count: usize) -> Vec<f64> {
        let mut rng = generator(seed);
        (0..count).flat_map(|_| (self.draw)(&mut rng)).collect()
    }

    /// What comes of a sample.
    pub fn judge(&self, instance: &[f64], theta: &[f64]) -> Outcome {
        (self.judge)(instance, theta)
    }
}

fn task(environment: &StickButton, rng: &mut Generator) -> Vec<f64> {
    let task = environment.task(1..=1, rng);
    let task = task.expect("one button finds room");
    task.initial.values().to_vec()
}

fn stick_button() -> Domain<'static> {
    Domain::parse(StickButton::PICK_DOMAIN).expect("the built-in domain text is valid")
}

/// Picking the stick, angles off.
pub fn pick() -> Scenario {
    Scenario {
        name: "pick",
        domain: stick_button(),
        instances: 4,
        calls: 100,
        steps: 1,
        noise: 0.0,
        truth: None,
        draw: Box::new(|rng| task(&UPRIGHT, rng)),
        judge: Box::new(|instance, theta| {
            UPRIGHT.try_pick(instance, theta).expect("a valid sample")
        }),
    }
}

/// Picking, when 2% of the answers are wrong.
pub fn noise() -> Scenario {
    Scenario {
        name: "noise",
        calls: 250,
        noise: 0.02,
        ..pick()
    }
}

/// Picking, then pressing one button above the zone.
pub fn chain() -> Scenario {
    Scenario {
        name: "chain",
        instances: 10,
        calls: 200,
        steps: 2,
        draw: Box::new(|rng| {
            loop {
                let instance = task(&UPRIGHT, rng);
                // The last object is the button: x, y, pressed.
                if instance[instance.len() - 2] > ZONE_HEIGHT {
                    return instance;
                }
            }
        }),
        judge: Box::new(|instance, theta| {
            let answer = UPRIGHT.try_pick_and_press(instance, theta);
            answer.expect("a valid sample")
        }),
        ..pick()
    }
}

/// Picking with angles on.
pub fn angles() -> Scenario {
    Scenario {
        name: "angles",
        instances: 64,
        calls: 500,
        draw: Box::new(|rng| task(&TURNED, rng)),
        judge: Box::new(|instance, theta| {
            TURNED.try_pick(instance, theta).expect("a valid sample")
        }),
        ..pick()
    }
}
