//! Groups of objects: what is said of their members is what going through the
//! members by hand says, however many an instance has.

use critreg::Error;
use critreg::domain::{Dimension, Domain, Extreme, Node, NodeId, PointSet, Scene};
use critreg::grammar::{Comparison, Features};
use critreg::random::{generator, uniform_in};
use critreg::region::{Intersection, Interval, Part, Region, SavedRegion};
use critreg_tests::by_hand::{
    ABSENT, Constraint, Length, MOVED, SETTLED, Said, TEXT, World, buttons, distance, obstacles,
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

/// A hand on a line, and posts beside it.
const POSTS: &str = "
    object post[6] { x: length, y: length }
    parameter reach in [0, 10]: length
    point hand = world + (reach, 0)
";

/// The numbers of an instance with posts at these places.
fn posts(places: &[f64]) -> Vec<f64> {
    let all = places.iter().flat_map(|x| [*x, 0.0]);
    all.chain(std::iter::repeat(ABSENT)).take(12).collect()
}

#[test]
fn one_region_serves_any_number_of_members() {
    let domain = Domain::parse(POSTS).unwrap();
    assert_eq!(domain.instance_len(), 12);
    let far = Region::parse(&domain, "min(dist(hand, post)) >= 0.5").unwrap();
    let right = Region::parse(&domain, "hand.x > max(post.x)").unwrap();
    type Case<'c> = (&'c [f64], &'c [[f64; 2]], &'c [[f64; 2]]);
    let cases: [Case<'_>; 4] = [
        (&[], &[[0.0, 10.0]], &[[0.0, 10.0]]),
        (&[4.0], &[[0.0, 3.5], [4.5, 10.0]], &[[4.0, 10.0]]),
        (
            &[8.0, 1.0, 1.25],
            &[[0.0, 0.5], [1.75, 7.5], [8.5, 10.0]],
            &[[8.0, 10.0]],
        ),
        (
            &[0.0, 9.0, 7.0, 5.0, 3.0, 10.5],
            &[[0.5, 2.5], [3.5, 4.5], [5.5, 6.5], [7.5, 8.5], [9.5, 10.0]],
            &[],
        ),
    ];
    for (places, when_far, when_right) in cases {
        let instance = posts(places);
        for (region, expected) in [(&far, when_far), (&right, when_right)] {
            let grounded = region.ground::<f64>(&domain, &instance).unwrap();
            let set = grounded.intervals().unwrap();
            let ends: Vec<_> = set.intervals().iter().map(|i| [i.low, i.high]).collect();
            assert!(set.is_exact());
            assert_eq!(ends, expected, "{places:?}");
        }
    }
}

#[test]
fn more_ends_than_there_is_room_for_make_a_larger_set() {
    let domain = Domain::parse(POSTS).unwrap();
    let rings = |count: i32| -> Vec<String> {
        let radius = |i: i32| f64::from(i) / 10.0;
        let ring = |i| format!("min(dist(hand, post)) > {}", radius(i));
        (1..=count).map(ring).collect()
    };
    // Two ends for each of six posts and each ring, and two of the line.
    let region = |count| Region::parse(&domain, &rings(count).join(" or ")).unwrap();
    let instance = posts(&[0.9, 2.5, 4.1, 5.7, 7.3, 8.9]);
    for (count, exact) in [(5, true), (6, false)] {
        let region = region(count);
        let grounded = region.ground::<f64>(&domain, &instance).unwrap();
        let set = grounded.intervals().unwrap();
        assert_eq!(set.is_exact(), exact);
        // The smallest ring decides.
        for step in 0..990 {
            let x = f64::from(step) / 100.0 + 0.003;
            let nearest = [0.9, 2.5, 4.1, 5.7, 7.3, 8.9].map(|post: f64| (post - x).abs());
            let inside = nearest.iter().all(|distance| *distance > 0.1);
            assert_eq!(grounded.contains(&[x]), Ok(inside), "{x}");
            assert!(set.contains(x) || !inside, "{x}");
        }
    }
}

#[test]
fn emptiness_over_no_members_is_proven() {
    let text = POSTS.replace("reach in", "height in [-1, 1]: length parameter reach in");
    let text = text.replace("(reach, 0)", "(reach, height)");
    let domain = Domain::parse(&text).unwrap();
    let near = Region::parse(&domain, "min(dist(hand, post)) <= 20").unwrap();
    let nobody = near.sample::<f64>(&domain, &posts(&[]), &mut generator(1));
    assert_eq!(nobody, Err(Error::EmptyRegion));
    let one = near.sample::<f64>(&domain, &posts(&[3.0]), &mut generator(1));
    assert!(one.is_ok());
}

#[test]
fn a_member_is_absent_as_a_whole() {
    let domain = Domain::parse(TEXT).unwrap();
    let region = Region::parse(&domain, "min(dist(grasp, obstacle)) >= 0.1").unwrap();
    let present = World {
        stick: [0.0; 3],
        obstacles: [Some([5.0; 4]); 6],
        buttons: [None; 3],
    };
    let instance = present.instance();
    assert_eq!(domain.check_instance(&instance), Ok(()));
    for slot in 0..instance.len() {
        for wrong in [f64::NAN, f64::INFINITY] {
            let mut damaged = instance.clone();
            damaged[slot] = wrong;
            let drawn = region.sample::<f64>(&domain, &damaged, &mut generator(1));
            // The only NaN that may stay are those of absent buttons.
            if slot >= 27 && wrong.is_nan() {
                assert!(drawn.is_ok());
            } else {
                assert!(matches!(drawn, Err(Error::NotFinite(_))), "{slot}");
            }
        }
    }
}

#[test]
fn errors_of_groups_say_where() {
    let domains = [
        ("object a[0] { x: length }", 1, 10),
        ("object a[1.5] { x: length }", 1, 10),
        ("object a[b] { x: length }", 1, 10),
        ("object a[2 { x: length }", 1, 12),
        ("object a[2] {}", 1, 13),
        ("object a[2] { x: length } object a { x: length }", 1, 34),
        (
            "object a[2] { x: length, y: length } parameter m in [0, 1]: length\npoint p = a + (m, 0)",
            2,
            11,
        ),
        (
            "object a[2] { x: length, y: length } object b[2] { x: length }\npoint p = a + (b.x, 0)",
            2,
            16,
        ),
        (
            "object a[2] { x: length, y: length }\npoint p = world + (a.x, 0)",
            2,
            20,
        ),
        (
            "object a[2] { x: length, y: length }\npoint p = world + (min(a.x), 0)",
            2,
            20,
        ),
        ("object min { x: length }", 1, 8),
    ];
    for (text, line, column) in domains {
        let Err(Error::Syntax(at)) = Domain::parse(text) else {
            panic!("accepted: {text}")
        };
        assert_eq!((at.line, at.column), (line, column), "{text}: {}", at.what);
    }
    let domain = Domain::parse(TEXT).unwrap();
    let regions = [
        ("mu < 1 and\n dist(grasp, obstacle) > 1", 2, 2),
        ("obstacle.x > 1", 1, 1),
        ("grasp.y < obstacle.tip.y", 1, 11),
        ("min(grasp.y) > 1", 1, 5),
        ("min(dist(obstacle, button)) > 1", 1, 5),
        ("min(1) > 1", 1, 5),
        ("min(min(obstacle.x)) > 1", 1, 5),
        ("min(obstacle.x + 1) > 1", 1, 16),
        ("min obstacle.x > 1", 1, 5),
        ("max(area(button)) > 1", 1, 5),
    ];
    for (text, line, column) in regions {
        let Err(Error::Syntax(at)) = Region::parse(&domain, text) else {
            panic!("accepted: {text}")
        };
        assert_eq!((at.line, at.column), (line, column), "{text}: {}", at.what);
    }
    // A shape is the same for every member, so its area needs no extreme.
    assert!(Region::parse(&domain, "area(button) < 1").is_ok());
}

#[test]
fn more_members_than_there_is_room_for() {
    let full = [
        String::from("object a[1000000000000] { x: length }"),
        String::from("object a[33] { x: length }"),
        String::from("object a[22], b[11]: t").replacen("object", "type t { x: length } object", 1),
        (0..9)
            .map(|i| format!("object a{i}[2] {{ x: length }}\n"))
            .collect(),
        String::from("object a[20] { x: length, y: length } shape a = circle(1)"),
    ];
    for text in full {
        let parsed = Domain::parse(&text);
        assert!(matches!(parsed, Err(Error::CapacityExceeded(_))), "{text}");
    }
    let most = Domain::parse("object a[32] { x: length, y: length }").unwrap();
    assert_eq!(most.members(0).len(), 32);
}

/// The features of a range, as text.
fn texts(domain: &Domain<'_>, nodes: &[Node], range: std::ops::Range<usize>) -> Vec<String> {
    let text = |index: usize| {
        let mut text = String::new();
        let id = NodeId(index.try_into().unwrap());
        domain.write_expression(&mut text, nodes, id).unwrap();
        text
    };
    range.map(text).collect()
}

#[test]
fn the_grammar_speaks_of_extremes_only() {
    let text = POSTS.replace(
        "parameter",
        "object base { x: length, y: length } point post.tip = post + (0.5, 0) parameter",
    );
    let domain = Domain::parse(&text).unwrap();
    let (mut nodes, mut values) = ([Node::Number(0.0); 400], [0.0; 400]);
    let mut features: Features<'_, f64> =
        Features::enumerate(&domain, &mut nodes, &mut values).unwrap();
    let both = |said: &[&str]| -> Vec<String> {
        let extremes = said
            .iter()
            .flat_map(|s| [format!("min({s})"), format!("max({s})")]);
        extremes.collect()
    };
    let pairs = |a: &str, b: &str| ["dist_x", "dist_y", "dist"].map(|d| format!("{d}({a}, {b})"));
    let of_pairs = |all: &[[String; 3]]| -> Vec<String> {
        both(&all.iter().flatten().map(String::as_str).collect::<Vec<_>>())
    };
    let found = |range| texts(&domain, features.nodes(), range);

    let mut leaves = both(&["post.x", "post.y"]);
    leaves.extend(["base.x", "base.y"].map(String::from));
    leaves.extend(both(&["post.tip.x", "post.tip.y"]));
    assert_eq!(found(features.rhs(1, Dimension::Length)), leaves);
    let relations = found(features.rhs(2, Dimension::Length));
    let expected = of_pairs(&[pairs("base", "post"), pairs("post.tip", "base")]);
    assert_eq!(relations[..12], expected);
    assert_eq!(relations[12..14], ["0.25*min(post.x)", "0.5*min(post.x)"]);
    let moved = found(features.lhs(2, Dimension::Length));
    let mut expected = of_pairs(&[pairs("hand", "post")]);
    expected.extend(pairs("hand", "base"));
    expected.extend(of_pairs(&[pairs("hand", "post.tip")]));
    assert_eq!(moved, expected);

    // A reader of the texts finds the same features, and the values are those of
    // the members that are there.
    for (index, text) in found(0..features.len()).iter().enumerate() {
        let region = Region::parse(&domain, &format!("{text} > 0")).unwrap();
        let left = region.formula().constraints()[0].lhs;
        let nodes = region.formula().nodes();
        assert_eq!(
            texts(&domain, nodes, 0..nodes.len())[usize::from(left.0)],
            *text,
            "{index}"
        );
    }
    let mut instance = posts(&[4.0, 1.0]);
    instance.extend([0.0, 2.0]);
    let scene = Scene::new(&domain, &instance, PointSet::all(&domain)).unwrap();
    let [first, second] = [
        features.rhs(1, Dimension::Length),
        features.lhs(2, Dimension::Length),
    ];
    features.evaluate(&scene, &[3.0]);
    assert_eq!(
        features.values()[first],
        [1.0, 4.0, 0.0, 0.0, 0.0, 2.0, 1.5, 4.5, 0.0, 0.0]
    );
    assert_eq!(
        features.values()[second][..6],
        [1.0, 2.0, 0.0, 0.0, 1.0, 2.0]
    );
    let instance: Vec<f64> = posts(&[]).into_iter().chain([0.0, 2.0]).collect();
    let scene = Scene::new(&domain, &instance, PointSet::all(&domain)).unwrap();
    features.evaluate(&scene, &[3.0]);
    let nothing = [f64::INFINITY, f64::NEG_INFINITY];
    assert_eq!(
        features.values()[features.rhs(1, Dimension::Length)][..2],
        nothing
    );
}

const ROW: &str = "
    object post[6] { x: length, y: length }
    parameter reach in [0, 12]: length
    point hand = world + (reach, 0)
";

/// A region of so many constraints about the distance of every post has up to twelve roots
/// for each: more than there is room for. It can be used all the same.
#[test]
fn a_region_with_many_roots_can_be_used() {
    let domain = Domain::parse(ROW).unwrap();
    let mut rng = generator(7);
    for constraints in 1..=12 {
        let bound = |index: usize| match index % 2 {
            0 => format!("min(dist(hand, post)) >= {}", 0.3 + 0.02 * index as f64),
            // Around each post a ring is left out.
            _ => format!(
                "(min(dist(hand, post)) >= {} or min(dist(hand, post)) <= {})",
                0.2 + 0.001 * index as f64,
                0.1 + 0.002 * index as f64
            ),
        };
        let text: Vec<String> = (0..constraints).map(bound).collect();
        let text = text.join(if constraints % 3 == 0 {
            " or "
        } else {
            " and "
        });
        let region = Region::parse(&domain, &text).unwrap();
        for _ in 0..10 {
            let x = |post: usize| 0.5 + 2.0 * post as f64;
            let posts = (0..6).flat_map(|post| [x(post), uniform_in(&mut rng, -0.2, 0.2)]);
            let instance: Vec<f64> = posts.collect();
            let grounded = region.ground::<f64>(&domain, &instance).unwrap();
            let set = grounded.intervals().unwrap();
            let mut some = false;
            for step in 0..=600 {
                let theta = [0.02 * f64::from(step)];
                let inside = grounded.contains(&theta).unwrap();
                assert_eq!(
                    region.contains::<f64>(&domain, &instance, &theta),
                    Ok(inside)
                );
                some |= inside;
                assert!(!inside || set.contains(theta[0]), "{text}: {theta:?}");
            }
            assert!(!(some && grounded.is_proven_empty().unwrap()), "{text}");
            match grounded.sample(&mut rng) {
                Ok(drawn) => assert_eq!(grounded.contains(&drawn[..1]), Ok(true)),
                Err(error) => assert!(!some && error == Error::EmptyRegion, "{text}: {error}"),
            }
            let part = Part {
                region: &region,
                domain: &domain,
                instance: &instance,
            };
            let both = Intersection::<f64>::new(&[part, part])
                .unwrap()
                .sample(&mut rng);
            assert_eq!(both.is_ok(), some, "{text}");
        }
    }
}
