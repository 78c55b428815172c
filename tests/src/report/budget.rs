//! What few calls teach: how good the best region is, and what it is called.

use super::judge::{Score, Truth};
use super::runs::{ask_and_tell, for_seeds, with_learner, with_seed};
use super::scenario::Scenario;
use critreg::learn::VersionSpace;
use critreg::learn::version_space::{Config, Quality};

/// Answers after which it is looked at.
const CALLS: [u32; 6] = [10, 20, 30, 40, 60, 100];
/// What a region may be called.
const QUALITIES: [Quality; 4] = [
    Quality::None,
    Quality::Provisional,
    Quality::Approximate,
    Quality::Exact,
];

/// What there is after some answers.
type Offer = (Quality, Option<Score>);

/// Prints for each number of calls how good the best region is of a learner that is configured
/// with as many, and of one that may ask more than that.
pub fn print(scenario: &Scenario, seeds: usize, first: u64) {
    let all = for_seeds(seeds, 10, |index| {
        let seed = first + index as u64;
        with_seed(scenario, seed, |scenario| offers(scenario, seed))
    });
    println!(
        "report: budget\nscenario: {}\nseeds: {seeds}\n",
        scenario.name
    );
    println!("| calls | of | mean P | mean R | none | provisional | approximate | exact |");
    println!("|---|---|---|---|---|---|---|---|");
    for (place, calls) in CALLS.into_iter().enumerate() {
        let most = CALLS[CALLS.len() - 1];
        for (kind, of) in [calls, most].into_iter().enumerate() {
            let own: Vec<Offer> = all.iter().map(|offers| offers[place][kind]).collect();
            print_row(calls, of, &own);
        }
    }
}

fn print_row(calls: u32, of: u32, offers: &[Offer]) {
    let scores: Vec<Score> = offers.iter().filter_map(|(_, score)| *score).collect();
    let mean = |of: fn(&Score) -> f64| match scores.is_empty() {
        true => String::from("-"),
        false => {
            let sum: f64 = scores.iter().map(of).sum();
            format!("{:.3}", sum / scores.len() as f64)
        }
    };
    let (p, r) = (mean(|own| own.precision), mean(|own| own.recall));
    let called = QUALITIES.map(|quality| {
        let own = offers.iter().filter(|(own, _)| *own == quality);
        own.count().to_string()
    });
    println!("| {calls} | {of} | {p} | {r} | {} |", called.join(" | "));
}

/// For each number of calls, what there is in the end, and what there is on the way.
fn offers(scenario: &Scenario, seed: u64) -> [[Offer; 2]; CALLS.len()] {
    let truth = Truth::new(scenario, seed);
    let most = CALLS[CALLS.len() - 1];
    let all = course(scenario, &truth, seed, most);
    let mut offers = [[(Quality::None, None); 2]; CALLS.len()];
    for ((own, calls), on_the_way) in offers.iter_mut().zip(CALLS).zip(all) {
        let configured = course(scenario, &truth, seed, calls);
        let last = CALLS.iter().position(|own| *own == calls);
        *own = [configured[last.unwrap_or_default()], on_the_way];
    }
    offers
}

/// What a learner that is configured with so many calls offers after each number of them.
fn course(scenario: &Scenario, truth: &Truth, seed: u64, calls: u32) -> [Offer; CALLS.len()] {
    let config = Config {
        calls,
        ..scenario.config(seed)
    };
    let mut offers = [(Quality::None, None); CALLS.len()];
    let seen = |told: u32, learner: &VersionSpace<'_, f64>| {
        if let Some(place) = CALLS.iter().position(|own| *own == told) {
            let region = learner.best_region().ok();
            let score = region.map(|region| truth.full_score(&scenario.domain, region));
            offers[place] = (learner.quality(), score);
        }
    };
    with_learner(scenario, seed, config, |learner, problem| {
        ask_and_tell(learner, scenario, problem, seed, seen);
    });
    offers
}
