//! Constraints about extremes over members, drawn at random, hold where they do by hand.

use critreg::Error;
use critreg::domain::{Domain, Extreme};
use critreg::grammar::Comparison;
use critreg::random::generator;
use critreg::region::{Interval, Region, SavedRegion};
use critreg_tests::by_hand::{
    Constraint, Length, MOVED, SETTLED, Said, TEXT, World, buttons, distance, obstacles,
};
use critreg_tests::text;
use proptest::prelude::*;

fn world() -> impl Strategy<Value = World> {
    let place = || (-3.0..3.0f64, -3.0..3.0f64, -4.0..4.0f64, -1.0..1.0f64);
    let obstacle = proptest::option::of(place().prop_map(|(x, y, t, w)| [x, y, t, w]));
    let button = proptest::option::of(place().prop_map(|(x, y, ..)| [x, y]));
    let stick = place().prop_map(|(x, y, t, _)| [x, y, t]);
    let obstacles = prop_oneof![
        6 => proptest::array::uniform6(obstacle),
        1 => Just([None; 6]),
    ];
    (stick, obstacles, proptest::array::uniform3(button)).prop_map(|(stick, obstacles, buttons)| {
        World {
            stick,
            obstacles,
            buttons,
        }
    })
}

fn extreme() -> impl Strategy<Value = Extreme> {
    prop_oneof![Just(Extreme::Least), Just(Extreme::Greatest)]
}

/// A length with a sum and a scale at most, of these leaves.
fn length(leaf: impl Strategy<Value = Length> + Clone + 'static) -> BoxedStrategy<Length> {
    let boxed = || leaf.clone().prop_map(Box::new);
    prop_oneof![
        4 => leaf.clone(),
        1 => (0.25..1.5f64, boxed()).prop_map(|(k, of)| Length::Scaled(k, of)),
        1 => (boxed(), boxed()).prop_map(|(a, b)| Length::Sum(a, b)),
        1 => (boxed(), boxed()).prop_map(|(a, b)| Length::Difference(a, b)),
    ]
    .boxed()
}

fn over(said: &'static [Said]) -> impl Strategy<Value = Length> + Clone {
    let index = 0..said.len();
    (
        prop_oneof![Just(Extreme::Least), Just(Extreme::Greatest)],
        index,
    )
        .prop_map(|(extreme, index)| Length::Over(extreme, said[index]))
}

fn settled() -> BoxedStrategy<Length> {
    length(prop_oneof![
        2 => over(&SETTLED),
        1 => (-1.0..3.0f64).prop_map(Length::Number),
        1 => Just(Length::StickY),
    ])
}

fn comparison() -> impl Strategy<Value = Comparison> {
    (0..4usize).prop_map(|i| Comparison::ALL[i])
}

/// The constraints of the grammar: one moving extreme, compared with what the
/// instance settles.
fn learnable() -> impl Strategy<Value = Constraint> {
    let left = prop_oneof![3 => over(&MOVED), 1 => Just(Length::GraspY)];
    (left, comparison(), settled()).prop_map(|(a, c, b)| Constraint(a, c, b))
}

/// Any constraint, also those without closed form.
fn constraint() -> impl Strategy<Value = Constraint> {
    let moved = || length(prop_oneof![3 => over(&MOVED), 1 => Just(Length::GraspY)]);
    let any = || prop_oneof![moved(), settled()];
    (any(), comparison(), any()).prop_map(|(a, c, b)| Constraint(a, c, b))
}

/// Values of mu close together, and those at which rounding decides left out.
fn grid(intervals: &[Interval<f64>]) -> impl Iterator<Item = f64> {
    let near_end = |mu: f64| {
        let mut ends = intervals.iter().flat_map(|i| [i.low, i.high]);
        ends.any(|end| (mu - end).abs() < 1e-6)
    };
    let all = (0..=1000).map(|i| f64::from(i) / 1000.0);
    all.filter(move |mu| !near_end(*mu))
}

/// The admitted ranges of mu, and whether they are exact.
fn intervals(domain: &Domain<'_>, region: &Region, world: &World) -> (Vec<Interval<f64>>, bool) {
    let instance = world.instance();
    let grounded = region.ground::<f64>(domain, &instance).unwrap();
    let set = grounded.intervals().unwrap();
    (set.intervals().to_vec(), set.is_exact())
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(600))]

    #[test]
    fn what_the_grammar_says_of_groups_is_exact(
        first in learnable(), second in learnable(), world in world(), both in any::<bool>(),
    ) {
        let domain = Domain::parse(TEXT).unwrap();
        let word = if both { "and" } else { "or" };
        let text = format!("{} {word} not {}", first.text(), second.text());
        let region = Region::parse(&domain, &text).unwrap();
        let (intervals, exact) = intervals(&domain, &region, &world);
        prop_assert!(exact, "{}", text);
        let instance = world.instance();
        for mu in grid(&intervals) {
            let [first, second] = [&first, &second].map(|c| c.holds(&world, mu));
            let inside = if both { first && !second } else { first || !second };
            let found = intervals.iter().any(|i| i.contains(mu));
            prop_assert_eq!(found, inside, "{} at {}: {:?}", text, mu, intervals);
            let contained = region.contains::<f64>(&domain, &instance, &[mu]).unwrap();
            prop_assert_eq!(contained, inside, "{} at {}", text, mu);
        }
    }

    #[test]
    fn anything_said_of_groups_is_true_or_too_large(constraint in constraint(), world in world()) {
        let domain = Domain::parse(TEXT).unwrap();
        let text = constraint.text();
        let region = Region::parse(&domain, &text).unwrap();
        let instance = world.instance();
        let (intervals, exact) = intervals(&domain, &region, &world);
        for mu in grid(&intervals).filter(|mu| !constraint.is_close(&world, *mu)) {
            let inside = constraint.holds(&world, mu);
            let found = intervals.iter().any(|i| i.contains(mu));
            prop_assert!(found || !inside, "{} at {}: {:?}", text, mu, intervals);
            prop_assert!(!(exact && found) || inside, "{} at {}: {:?}", text, mu, intervals);
            let contained = region.contains::<f64>(&domain, &instance, &[mu]).unwrap();
            prop_assert_eq!(contained, inside, "{} at {}", text, mu);
        }
        if let Ok(theta) = region.sample::<f64>(&domain, &instance, &mut generator(1)) {
            prop_assert!(region.contains::<f64>(&domain, &instance, &theta[..1]).unwrap());
        }
    }

    #[test]
    fn the_order_of_members_means_nothing(
        constraint in constraint(), world in world(),
        order in Just([0, 1, 2, 3, 4, 5]).prop_shuffle(),
    ) {
        let domain = Domain::parse(TEXT).unwrap();
        let region = Region::parse(&domain, &constraint.text()).unwrap();
        let mut other = world.clone();
        other.obstacles = order.map(|i: usize| world.obstacles[i]);
        other.buttons.reverse();
        let [a, b] = [&world, &other].map(|world| intervals(&domain, &region, world));
        prop_assert_eq!(a, b, "{}", constraint.text());
    }

    #[test]
    fn what_is_written_and_saved_reads_back_the_same(a in constraint(), b in constraint()) {
        let domain = Domain::parse(TEXT).unwrap();
        let text = format!("{} and not ({})", a.text(), b.text());
        let region = Region::parse(&domain, &text).unwrap();
        let written = text::of_region(&domain, &region);
        prop_assert_eq!(&Region::parse(&domain, &written).expect(&written), &region);
        let mut bytes = vec![0; region.saved_len(&domain)];
        region.save::<f64>(&domain, &mut bytes).unwrap();
        let saved = SavedRegion::read(&bytes).unwrap();
        let again = Domain::parse(saved.domain_text).unwrap();
        prop_assert_eq!(&Region::parse(&again, saved.region_text).unwrap(), &region);
    }

    #[test]
    fn no_box_with_something_in_it_is_excluded(
        world in world(), comparison in comparison(), extreme in extreme(),
        bound in 0.0..4.0f64, seed in any::<u64>(),
    ) {
        // The same world, but the hand is anywhere.
        let text = TEXT.replace("mu in [0, 1]", "px in [-2, 2]: length parameter py in [-2, 2]: length");
        let text = text.replace("stick + (mu * reach, 0.1)", "world + (px, py)");
        let domain = Domain::parse(&text).unwrap();
        let (name, symbol) = (extreme.name(), comparison.symbol());
        let said = format!(
            "{name}(dist(grasp, obstacle)) {symbol} {bound} and min(dist_y(grasp, button)) > 0.5"
        );
        let region = Region::parse(&domain, &said).unwrap();
        let instance = world.instance();
        let inside = |hand: [f64; 2]| {
            let far = obstacles(&world, |[x, y, ..]| distance([x, y], hand)).into_iter();
            let extreme = match extreme {
                Extreme::Least => far.fold(f64::INFINITY, f64::min),
                Extreme::Greatest => far.fold(f64::NEG_INFINITY, f64::max),
            };
            let beside = buttons(&world, |[_, y]| (y - hand[1]).abs()).into_iter();
            comparison.holds(&extreme, &bound) && beside.fold(f64::INFINITY, f64::min) > 0.5
        };
        match region.sample::<f64>(&domain, &instance, &mut generator(seed)) {
            Ok([x, y, ..]) => prop_assert!(inside([x, y]), "{said} at {x}, {y}"),
            Err(Error::EmptyRegion) => {
                let steps = || (-100..=100).map(|i| f64::from(i) / 50.0);
                let hands = steps().flat_map(|x| steps().map(move |y| [x, y]));
                prop_assert_eq!(hands.into_iter().find(|hand| inside(*hand)), None, "{}", said);
            }
            Err(error) => prop_assert_eq!(error, Error::NoSample),
        }
    }
}
