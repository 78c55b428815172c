//! What is fuzzed.

mod learning;
mod pddl;
mod saved;
mod texts;

use std::collections::hash_map::DefaultHasher;
use std::hash::{Hash, Hasher};
use std::time::Duration;

/// A function of bytes that panics if something does not hold. It returns a number that is
/// another one if it did something else.
pub(crate) struct Target {
    pub(crate) name: &'static str,
    pub(crate) run: fn(&[u8]) -> u64,
    pub(crate) corpus: fn() -> Vec<Vec<u8>>,
    /// How long it may take, in a release build with much to spare.
    pub(crate) bound: Duration,
}

const fn target(
    name: &'static str,
    run: fn(&[u8]) -> u64,
    corpus: fn() -> Vec<Vec<u8>>,
    seconds: u64,
) -> Target {
    Target {
        name,
        run,
        corpus,
        bound: Duration::from_secs(seconds),
    }
}

pub(crate) const TARGETS: &[Target] = &[
    target("domain", texts::domain, texts::domains, 1),
    target("region", texts::region, texts::regions, 3),
    target("region_bytes", saved::region, saved::regions, 1),
    target("learner_bytes", saved::learner, saved::learners, 3),
    target("pddl", pddl::ground, pddl::texts, 3),
    target("learning", learning::answers, learning::corpus, 20),
];

/// A number that is another one for other values.
pub(crate) fn hash(value: &(impl Hash + ?Sized)) -> u64 {
    let mut hasher = DefaultHasher::new();
    value.hash(&mut hasher);
    hasher.finish()
}

/// The two texts that an input is made of, which a line with dashes parts.
pub(crate) fn halves(input: &[u8]) -> (String, String) {
    let text = String::from_utf8_lossy(input);
    match text.split_once("\n---\n") {
        Some((first, second)) => (first.into(), second.into()),
        None => (text.into(), String::new()),
    }
}
