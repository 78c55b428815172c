//! The scenario runner in Python, `tests/field/run.py`, on the library as C programs get it.

use crate::support::{library_directory, root, run, scratch};
use std::path::Path;
use std::process::Command;

/// The blocks of what the runner prints, as pairs of key and value.
fn blocks(file: &Path, arguments: &[&str]) -> Vec<Vec<(String, String)>> {
    let output = run(Command::new("python3")
        .arg(root().join("tests/field/run.py"))
        .arg(file)
        .args(arguments)
        .env("CRITREG_LIBRARY", library_directory().join("libcritreg.so"))
        .env("PYTHONDONTWRITEBYTECODE", "1"));
    let printed = String::from_utf8(output.stdout).unwrap();
    let pair = |line: &str| {
        let (key, value) = line.split_once(": ").unwrap_or_else(|| panic!("{line}"));
        (key.to_string(), value.to_string())
    };
    let parts = printed.trim_end().split("\n\n");
    parts.map(|part| part.lines().map(pair).collect()).collect()
}

fn value<'b>(block: &'b [(String, String)], key: &str) -> &'b str {
    let found = block.iter().find(|(name, _)| name == key);
    let (_, value) = found.unwrap_or_else(|| panic!("no {key} in {block:?}"));
    value
}

#[test]
fn a_plain_scenario_of_ours_is_learned_and_judged() {
    let file = root().join("tests/field/scenarios.py");
    let [block, summary] = &blocks(&file, &["--only", "reach", "--seeds", "1"])[..] else {
        panic!("one scenario and a summary");
    };
    let keys: Vec<_> = block.iter().map(|(key, _)| key.as_str()).collect();
    let expected = [
        "scenario",
        "exact",
        "useful",
        "precision_mean",
        "precision_least",
        "recall_mean",
        "recall_least",
        "calls_until_exact_median",
        "no_region",
        "ask_tell_ms_p99",
        "most_frequent_region",
        "most_frequent_region_seeds",
    ];
    assert_eq!(keys, expected);
    for (key, expected) in [
        ("scenario", "reach"),
        ("exact", "1/1"),
        ("no_region", "0/1"),
    ] {
        assert_eq!(value(block, key), expected, "{key}");
    }
    let calls: f64 = value(block, "calls_until_exact_median").parse().unwrap();
    assert!((2.0..=100.0).contains(&calls), "{calls}");
    let region = value(block, "most_frequent_region");
    assert!(
        region.contains("dist(base, cup) <= 0.8 (farthest)"),
        "{region}"
    );
    assert_eq!(value(summary, "reached"), "1 of 1 scenarios");
}

/// Scenarios of somebody else: a text that is refused, a chain whose texts say too little,
/// and one with aligned instances of which it is enough to be useful.
const FOREIGN: &str = r#"
class Refused:
    name, text = "refused", "object a { x: length }\nshape a = potato(1)\n"
    lo, hi, calls, instances = [0.0], [1.0], 20, 2
    def instance(self, rng): return [0.0]
    def works(self, i, t): return True

class Coin(Refused):
    name, text, steps = "coin", "object a { x: length }\nparameter p in [0, 1]\n", 2
    calls = 60
    def instance(self, rng): return [rng.random()]
    def fails(self, i, t): return int(t[0] * 1e4) % 3

class Below(Coin):
    name, goal, steps, calls = "below", "useful", 1, 20
    def aligned(self, rng): return [0.5]
    def works(self, i, t): return t[0] <= 0.5

SCENARIOS = [Refused, Coin, Below()]
"#;

#[test]
fn what_is_refused_or_not_learned_is_told_and_the_rest_goes_on() {
    let file = scratch().join("foreign_scenarios.py");
    std::fs::write(&file, FOREIGN).unwrap();
    let [refused, coin, below, summary] = &blocks(&file, &["--seeds", "2", "--first", "7"])[..]
    else {
        panic!("three scenarios and a summary");
    };
    assert_eq!(value(refused, "scenario"), "refused");
    let message = value(refused, "refused");
    assert!(message.contains("line 2, column"), "{message}");
    assert_eq!(refused.len(), 2);
    assert_eq!(value(coin, "no_region"), "2/2");
    assert_eq!(value(coin, "exact"), "0/2");
    assert_eq!(value(coin, "calls_until_exact_median"), "never");
    assert_eq!(value(below, "useful"), "2/2");
    let precision: f64 = value(below, "aligned_precision_least").parse().unwrap();
    assert!(precision > 0.95, "{precision}");
    assert_eq!(value(summary, "reached"), "1 of 3 scenarios");
}
