//! How good a region is where the truth is none that the text can say, and what is said of it.

use super::baselines::{Labelled, forest, machine};
use super::beyond;
use super::judge::Score;
use super::runs::{ask_and_tell, draw_theta, for_seeds, with_learner};
use super::scenario::Scenario;
use crate::text;
use critreg::learn::version_space::{Config, Quality};
use critreg::learn::{Learner, Problem, VersionSpace};
use critreg::random::{Generator, below, generator, uniform};
use critreg::region::Region;

/// Precisions that are wanted.
const WANTED: [f64; 3] = [0.90, 0.95, 0.99];
/// With this confidence, each end of an interval holds; both with 95%.
const CONFIDENCE: f64 = 0.975;
/// Fresh instances, and samples in each.
const FRESH: [usize; 2] = [400, 100];
/// One of so many fresh samples is asked of a forest and a machine, too.
const ASKED: usize = 10;
/// Draws from a region that tell its precision.
const DRAWS: usize = 4000;
/// A region that is called exact should have this precision.
const EXACT: f64 = 0.99;

/// What came of a run.
struct Learned {
    quality: Quality,
    /// Of the region, if there is one, in fresh instances.
    score: Option<Score>,
    /// Whether the interval of the precision holds in the instances that were learned in, and
    /// in fresh ones, if there is one; then the same of the recall.
    holds: [Option<bool>; 4],
    /// The region as text.
    text: String,
    /// Of the forest and the machine.
    others: [Option<Score>; 2],
}

impl Learned {
    /// Whether it is called exact and is not good enough for that.
    fn is_overrated(&self) -> bool {
        let bad = self.score.is_some_and(|own| own.precision < EXACT);
        self.quality == Quality::Exact && bad
    }
}

/// Prints for each wanted precision and truth what is learned, and what all truths make together.
pub fn print(seeds: usize, first: u64, wanted: Option<f64>, only: &str) {
    println!("report: approximate\nseeds: {seeds}\n");
    println!(
        "| wanted | truth | none, provisional, approximate, exact | P | R | without a draw | P holds: training, \
         fresh | R holds: training, fresh | exact with P < {EXACT} | forest P | R | SVM P | R |"
    );
    println!("|---|---|---|---|---|---|---|---|---|---|---|---|---|");
    let wanted = wanted.map_or(WANTED.to_vec(), |own| vec![own]);
    for wanted in wanted {
        let mut together = Vec::new();
        let all = beyond::all().into_iter();
        for scenario in all.filter(|own| own.name.contains(only)) {
            let runs = for_seeds(seeds, usize::MAX, |index| {
                learn(&scenario, first + index as u64, wanted)
            });
            eprintln!("{wanted}: {}", scenario.name);
            for (index, run) in runs
                .iter()
                .enumerate()
                .filter(|(_, run)| run.is_overrated())
            {
                let seed = first + index as u64;
                eprintln!("called exact, seed {seed}: {:?} {}", run.score, run.text);
            }
            print_row(wanted, scenario.name, &runs);
            together.extend(runs);
        }
        print_row(wanted, "all", &together);
    }
}

fn print_row(wanted: f64, name: &str, runs: &[Learned]) {
    let count = |quality| runs.iter().filter(|run| run.quality == quality).count();
    let called = [
        count(Quality::None),
        count(Quality::Provisional),
        count(Quality::Approximate),
        count(Quality::Exact),
    ];
    let called = called.map(|own| own.to_string()).join(", ");
    let means = |of: &dyn Fn(&Learned) -> Option<Score>| {
        let scores: Vec<Score> = runs.iter().filter_map(of).collect();
        let mean = |of: fn(&Score) -> f64| match scores.is_empty() {
            true => String::from("-"),
            false => {
                let sum: f64 = scores.iter().map(of).sum();
                format!("{:.3}", sum / scores.len() as f64)
            }
        };
        format!("{} | {}", mean(|own| own.precision), mean(|own| own.recall))
    };
    let holds = |place: usize| {
        let own = runs.iter().filter_map(|run| run.holds[place]);
        let (all, holding) = own.fold((0, 0), |(all, holding), own| {
            (all + 1, holding + usize::from(own))
        });
        format!("{holding}/{all}")
    };
    let unjudged = runs
        .iter()
        .filter(|run| run.quality == Quality::Approximate && run.holds[0].is_none());
    println!(
        "| {wanted:.2} | {name} | {called} | {} | {} | {}, {} | {}, {} | {} | {} | {} |",
        means(&|run| run.score),
        unjudged.count(),
        holds(0),
        holds(1),
        holds(2),
        holds(3),
        runs.iter().filter(|run| run.is_overrated()).count(),
        means(&|run| run.others[0]),
        means(&|run| run.others[1])
    );
}

fn learn(scenario: &Scenario, seed: u64, wanted: f64) -> Learned {
    let config = Config {
        // It is not told that answers are wrong.
        noise: 0.0,
        precision_wanted: wanted,
        ..scenario.config(seed)
    };
    with_learner(scenario, seed, config, |learner, problem| {
        ask_and_tell(learner, scenario, problem, seed, |_, _| ());
        judged(learner, scenario, seed, problem)
    })
}

/// What came of a learner, on samples from its own instances and from fresh ones.
fn judged(
    learner: &VersionSpace<'_, f64>,
    scenario: &Scenario,
    seed: u64,
    problem: &Problem<'_>,
) -> Learned {
    let instances = scenario.draw(seed, scenario.instances);
    let training = Samples::new(scenario, &instances, seed ^ 0x7124);
    let fresh = scenario.draw(seed ^ 0x7E57_0000_0000, FRESH[0]);
    let fresh = Samples::new(scenario, &fresh, seed ^ 0xF4E5);
    let region = learner.region().ok();
    let report = learner.report();
    let stated = [report.precision(CONFIDENCE), report.recall(CONFIDENCE)];
    let holds = |place: usize, is: &dyn Fn(&Region) -> f64| {
        let (low, high) = stated[place]?;
        region.map(|region| (low..=high).contains(&is(region)))
    };
    Learned {
        quality: learner.quality(),
        score: region.map(|region| fresh.score(region)),
        holds: [
            holds(0, &|region| training.precision(region, seed)),
            holds(0, &|region| fresh.precision(region, seed)),
            holds(1, &|region| training.recall(region)),
            holds(1, &|region| fresh.recall(region)),
        ],
        text: region.map_or(String::new(), |region| {
            text::of_region(&scenario.domain, region)
        }),
        others: others(learner, problem, &fresh, seed),
    }
}

/// How good a forest and a machine are that learn from the same answers.
fn others(
    learner: &VersionSpace<'_, f64>,
    problem: &Problem<'_>,
    fresh: &Samples<'_>,
    seed: u64,
) -> [Option<Score>; 2] {
    let used = problem.domain().parameters().len();
    let mut known = Labelled::default();
    for own in learner.observations() {
        let query = own.query();
        let instance = problem.instance(query.instance).expect("an instance");
        known.inputs.push([instance, &query.theta[..used]].concat());
        known.works.push(own.outcome.is_feasible());
    }
    let mut asked = Labelled::default();
    for sample in fresh.all.iter().step_by(ASKED) {
        let instance = fresh.instance(sample.instance);
        asked.inputs.push([instance, &sample.theta].concat());
        asked.works.push(sample.works);
    }
    [forest(&known, &asked, seed), machine(&known, &asked, seed)].map(|said| {
        let said = said?;
        Some(score(said.into_iter().zip(asked.works.iter().copied())))
    })
}

/// How well what is claimed agrees with what works.
fn score(all: impl Iterator<Item = (bool, bool)>) -> Score {
    let (mut both, mut claimed, mut working) = (0, 0, 0);
    for (claim, works) in all {
        both += usize::from(claim && works);
        claimed += usize::from(claim);
        working += usize::from(works);
    }
    let share = |whole: usize| both as f64 / whole.max(1) as f64;
    Score {
        precision: share(claimed),
        recall: share(working),
    }
}

/// A uniform sample in an instance.
struct Sample {
    instance: usize,
    theta: Vec<f64>,
    works: bool,
    /// What would have been told: a share of the answers is wrong.
    answer: bool,
}

/// Uniform samples in instances.
struct Samples<'s> {
    scenario: &'s Scenario,
    instances: Vec<f64>,
    all: Vec<Sample>,
}

impl Samples<'_> {
    fn new<'s>(scenario: &'s Scenario, instances: &[f64], seed: u64) -> Samples<'s> {
        let mut own = Samples {
            scenario,
            instances: instances.to_vec(),
            all: Vec::new(),
        };
        let mut rng = generator(seed);
        let used = scenario.domain.parameters().len();
        for _ in 0..FRESH[0] * FRESH[1] {
            let instance = below(&mut rng, own.count());
            let theta = draw_theta(&scenario.domain, &mut rng)[..used].to_vec();
            let (works, answer) = own.judged(instance, &theta, &mut rng);
            own.all.push(Sample {
                instance,
                theta,
                works,
                answer,
            });
        }
        own
    }

    fn count(&self) -> usize {
        self.instances.len() / self.scenario.domain.instance_len()
    }

    fn instance(&self, place: usize) -> &[f64] {
        let length = self.scenario.domain.instance_len();
        &self.instances[place * length..][..length]
    }

    /// Whether a sample works, and whether an answer says so.
    fn judged(&self, instance: usize, theta: &[f64], rng: &mut Generator) -> (bool, bool) {
        let outcome = self.scenario.judge(self.instance(instance), theta);
        let works = outcome.is_feasible();
        (works, works != (uniform(rng) < self.scenario.noise))
    }

    fn inside(&self, region: &Region, sample: &Sample) -> bool {
        let instance = self.instance(sample.instance);
        let inside = region.contains::<f64>(&self.scenario.domain, instance, &sample.theta);
        inside.expect("a valid sample")
    }

    fn score(&self, region: &Region) -> Score {
        let all = self.all.iter();
        score(all.map(|sample| (self.inside(region, sample), sample.works)))
    }

    /// The share of what is said to work that is in the region.
    fn recall(&self, region: &Region) -> f64 {
        let all = self.all.iter();
        score(all.map(|sample| (self.inside(region, sample), sample.answer))).recall
    }

    /// The share of draws from the region, each in a random instance, that are said to work.
    fn precision(&self, region: &Region, seed: u64) -> f64 {
        let mut rng = generator(seed ^ 0xD4A3);
        let domain = &self.scenario.domain;
        let (mut draws, mut worked) = (0, 0);
        for _ in 0..DRAWS {
            let instance = below(&mut rng, self.count());
            let drawn = region.sample::<f64>(domain, self.instance(instance), &mut rng);
            // The region may be empty in this instance.
            let Ok(theta) = drawn else { continue };
            let used = domain.parameters().len();
            let (_, answer) = self.judged(instance, &theta[..used], &mut rng);
            draws += 1;
            worked += usize::from(answer);
        }
        worked as f64 / f64::from(draws.max(1))
    }
}
