//! What is said about many runs.

use super::judge::Score;
use critreg::learn::version_space::Quality;
use std::collections::BTreeMap;

/// One run of a learner.
#[derive(Clone, Debug, Default)]
pub struct Run {
    /// The region as text, if there is one.
    pub region: Option<String>,
    /// Its score; zero without a region.
    pub score: Score,
    /// What it is called by a learner that has a word for it.
    pub quality: Quality,
    /// After how many answers the region was exact and stayed so.
    pub calls_to_exact: Option<u32>,
}

/// A summary of runs.
pub struct Statistics<'r> {
    /// Name of the learner.
    pub learner: &'static str,
    /// Training instances.
    pub instances: usize,
    /// Answers per run.
    pub calls: u32,
    /// The runs.
    pub runs: &'r [Run],
}

impl Statistics<'_> {
    /// Prints a `key: value` line each, and the most frequent region last.
    pub fn print(&self) {
        let runs = self.runs;
        let exact = runs.iter().filter(|r| r.score.is_exact()).count();
        println!("learner: {}", self.learner);
        println!("instances: {}", self.instances);
        println!("calls: {}", self.calls);
        println!("seeds: {}", runs.len());
        println!("exact: {exact}");
        println!(
            "exact_share: {:.4}",
            exact as f64 / runs.len().max(1) as f64
        );
        let found = || runs.iter().filter(|r| r.region.is_some());
        type Pick = fn(&Run) -> f64;
        let measures: [(&str, Pick); 2] = [
            ("precision", |r| r.score.precision),
            ("recall", |r| r.score.recall),
        ];
        for (name, pick) in measures {
            let values: Vec<f64> = found().map(pick).collect();
            if values.is_empty() {
                println!("{name}_min: none\n{name}_mean: none");
                continue;
            }
            let least = values.iter().copied().fold(1.0, f64::min);
            let mean = values.iter().sum::<f64>() / values.len() as f64;
            println!("{name}_min: {least:.4}");
            println!("{name}_mean: {mean:.4}");
        }
        let mut calls: Vec<u32> = runs.iter().filter_map(|r| r.calls_to_exact).collect();
        calls.sort_unstable();
        for (name, share) in [("median", 0.5), ("p95", 0.95)] {
            let place = (share * runs.len() as f64) as usize;
            match calls.get(place) {
                Some(calls) => println!("calls_to_exact_{name}: {calls}"),
                None => println!("calls_to_exact_{name}: never"),
            }
        }
        println!(
            "no_region: {}",
            runs.iter().filter(|r| r.region.is_none()).count()
        );
        let mut texts: BTreeMap<&str, usize> = BTreeMap::new();
        for text in found().filter_map(|r| r.region.as_deref()) {
            *texts.entry(text).or_default() += 1;
        }
        let most = texts.iter().max_by_key(|(_, count)| **count);
        let (text, count) = most.map_or(("none", 0), |(text, count)| (text, *count));
        println!("most_frequent_count: {count}");
        println!("most_frequent_region: {text}");
    }
}
