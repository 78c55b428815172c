//! What holds of draws, and of ranges over boxes, whatever the relation is.

use critreg::domain::{Domain, Node, PointSet, Range, Scene};
use critreg::random::{Generator, below, uniform_in};
use critreg::region::Grounded;
use critreg::text::Lexer;

/// Draws succeed and are inside, or there is next to nothing to draw.
pub(super) fn check_draws(grounded: &Grounded<'_, f64>, text: &str, rng: &mut Generator) {
    let length = grounded.intervals().unwrap().length();
    for _ in 0..5 {
        match grounded.sample(rng) {
            Ok(theta) => assert!(grounded.contains(&theta[..1]).unwrap(), "{text}"),
            Err(error) => assert!(length < 1e-6, "{text}: {error}, but {length} is admitted"),
        }
    }
}

/// The intervals of a region are those positions at which it is `expected` to hold, of so many on
/// either side of zero; ends, and positions of which nothing is expected, do not count. Tells how
/// many are admitted.
pub(super) fn check_intervals(
    grounded: &Grounded<'_, f64>,
    positions: i32,
    what: &dyn Fn() -> String,
    expected: &dyn Fn(f64) -> Option<bool>,
) -> usize {
    let set = grounded.intervals().unwrap();
    assert!(set.is_exact(), "{}", what());
    let ends = || set.intervals().iter().flat_map(|i| [i.low, i.high]);
    let mut admitted = 0;
    for step in -positions..=positions {
        let p = f64::from(step) / f64::from(positions);
        if ends().any(|end| (p - end).abs() <= 1e-6) {
            continue;
        }
        let Some(expected) = expected(p) else {
            continue;
        };
        let what = || format!("{} at {p}: {:?}", what(), set.intervals());
        assert_eq!(set.contains(p), expected, "{}", what());
        assert_eq!(grounded.contains(&[p]).unwrap(), expected, "{}", what());
        admitted += usize::from(expected);
    }
    admitted
}

/// The bounds of an expression over boxes of parameters are beyond its values in them, and no
/// farther apart than it is said for the size of a box.
pub(super) fn check_ranges(
    domain: &Domain,
    numbers: &[f64],
    text: &str,
    widest: fn(f64) -> f64,
    rng: &mut Generator,
) {
    let mut nodes: heapless::Vec<Node, 16> = heapless::Vec::new();
    let id = domain
        .parse_expression(&mut Lexer::new(text), &mut nodes)
        .expect(text);
    let scene = Scene::<f64>::new(domain, numbers, PointSet::of(domain, &nodes)).unwrap();
    for size in [0.01, 0.1, 0.5] {
        let boxed: Vec<_> = domain
            .parameters()
            .iter()
            .map(|parameter| {
                let low = uniform_in(rng, parameter.low, parameter.high - size);
                let high = low + uniform_in(rng, 0.0, size);
                Range { low, high }
            })
            .collect();
        let bounds = scene.sample(&boxed).measure(&nodes, id);
        assert!(bounds.low <= bounds.high, "{text}: {bounds:?}");
        for _ in 0..40 {
            let theta: Vec<_> = boxed
                .iter()
                .map(|range| match below(rng, 4) {
                    0 => range.low,
                    1 => range.high,
                    _ => uniform_in(rng, range.low, range.high),
                })
                .collect();
            let value = scene.sample(&theta).measure(&nodes, id);
            let bounded = bounds.low - 1e-9 <= value && value <= bounds.high + 1e-9;
            assert!(
                bounded,
                "{text}: {value} at {theta:?}, {bounds:?} over {boxed:?}"
            );
        }
        assert!(
            bounds.high - bounds.low <= widest(size) || bounds.low == f64::INFINITY,
            "{text}: {bounds:?} over {boxed:?}"
        );
    }
}
