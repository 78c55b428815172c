//! The pictures tell the truth.

use critreg_tests::picture::pictures;
use critreg_tests::picture::regions::Regions;
use critreg_tests::picture::samples::{Measured, measure};
use critreg_tests::plan::record;
use std::path::Path;

#[test]
fn the_pictures_in_the_repository_are_those_that_are_written() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../c_examples/out");
    for (name, text) in pictures() {
        let committed = std::fs::read_to_string(folder.join(name)).unwrap();
        // Not assert_eq: nobody wants to read two pictures.
        assert!(
            committed == text,
            "{name} is out of date: make -C c_examples pictures"
        );
    }
}

#[test]
fn what_is_green_works_and_nothing_else_does() {
    // How far a pick may end from its target, as a share of the stick, and contact that
    // reaches a little further than it is planned for.
    const SLACK: f64 = 0.05;
    for panel in Regions::learn().panels() {
        let instance = panel.state.values();
        let ends: Vec<f64> = panel.feasible.iter().flatten().copied().collect();
        let mut seen = [0; 2];
        for mu in (0..=200).map(|i| f64::from(i) / 200.0) {
            if ends.iter().any(|end| (end - mu).abs() < SLACK) {
                continue;
            }
            let green = panel.feasible.iter().any(|[a, b]| (*a..=*b).contains(&mu));
            assert_eq!(
                panel.learned.works(instance, mu),
                green,
                "{} {mu}",
                panel.title
            );
            seen[usize::from(green)] += 1;
        }
        assert!(seen.iter().all(|count| *count > 10), "{seen:?}");
    }
}

#[test]
fn the_original_series_is_the_thesis_s_table() {
    let Measured {
        original, learned, ..
    } = measure();
    assert_eq!(original.samples.iter().sum::<u32>(), 388);
    assert_eq!(original.samples.last(), Some(&230));
    let recorded: usize = record::runs_of_the_thesis().map(|run| run.plan.len()).sum();
    assert_eq!(original.steps as usize, recorded);
    assert_eq!([original.solved, learned.solved], [50, 50]);
    // No plan has fewer samples than steps; regions that are right need few more.
    let samples: u32 = learned.samples.iter().sum();
    assert!(samples >= learned.steps);
    assert!(samples <= learned.steps + 3, "{samples}");
}
