//! Expressions that divide, features with a name, and what a text says is compared.

use critreg::domain::{Dimension, Domain, Node, NodeId};
use critreg::grammar::Features;
use critreg::random::{generator, uniform_in};
use critreg::region::Region;
use critreg_tests::text;

const TEXT: &str = "
    object ground { friction: none }
    object pad { x: length, y: length, width: length }
    constant g = 9.81: none
    parameter v in [0.1, 3]
    parameter px in [-1, 1]: length
    point foot = world + (px, 0.5)
    feature slide = v*v / (2*g*ground.friction)
    feature share = dist_x(foot, pad) / pad.width
";

fn region(domain: &Domain<'_>, text: &str) -> Region {
    Region::parse(domain, text).unwrap()
}

/// Whether the draws, intervals and memberships of a region are those of a rule.
fn check(formula: &str, rule: impl Fn(&[f64], [f64; 2]) -> bool) {
    let domain = Domain::parse(TEXT).unwrap();
    let region = region(&domain, formula);
    assert_eq!(text::of_region(&domain, &region), formula);
    let mut rng = generator(3);
    let mut inside = 0;
    for _ in 0..40 {
        let instance = [(0.2, 0.6), (-0.5, 0.5), (-0.5, 0.5), (0.2, 1.0)];
        let instance = instance.map(|(low, high)| uniform_in(&mut rng, low, high));
        let grounded = region.ground::<f64>(&domain, &instance).unwrap();
        for _ in 0..100 {
            let theta = [
                uniform_in(&mut rng, 0.1, 3.0),
                uniform_in(&mut rng, -1.0, 1.0),
            ];
            let expected = rule(&instance, theta);
            assert_eq!(grounded.contains(&theta).unwrap(), expected, "{theta:?}");
            inside += usize::from(expected);
        }
        for _ in 0..20 {
            let Ok(theta) = grounded.sample(&mut rng) else {
                break;
            };
            assert!(rule(&instance, [theta[0], theta[1]]));
        }
    }
    assert!((200..3800).contains(&inside), "{inside} of 4000");
}

fn slide(instance: &[f64], theta: [f64; 2]) -> f64 {
    theta[0] * theta[0] / (2.0 * 9.81 * instance[0])
}

#[test]
fn a_square_over_a_number_of_the_scene() {
    check("slide <= 0.5", |instance, theta| {
        slide(instance, theta) <= 0.5
    });
}

#[test]
fn a_distance_over_a_size() {
    check("share >= 0.5 and slide >= 0.1", |instance, theta| {
        (theta[1] - instance[1]).abs() / instance[3] >= 0.5 && slide(instance, theta) >= 0.1
    });
}

#[test]
fn a_quotient_of_two_numbers_of_the_sample() {
    check(
        "px/v - 2*dist_x(foot, pad)/v >= -0.25",
        |instance, theta| {
            theta[1] / theta[0] - 2.0 * (theta[1] - instance[1]).abs() / theta[0] >= -0.25
        },
    );
}

#[test]
fn nothing_is_proven_by_a_division_by_zero() {
    let domain = Domain::parse(
        "object a { size: length } parameter x in [-1, 1]: length parameter y in [-1, 1]: length",
    )
    .unwrap();
    // Somewhere it is as large as one likes, and nowhere a number where x is zero.
    let region = region(&domain, "y/x >= 100");
    let grounded = region.ground::<f64>(&domain, &[1.0]).unwrap();
    assert!(!grounded.is_proven_empty().unwrap());
    assert!(grounded.contains(&[0.001, 0.5]).unwrap());
    assert!(!grounded.contains(&[0.0, 0.0]).unwrap());
    // A size of zero makes no number, and no number is in the region.
    let region = Region::parse(&domain, "x/a.size - x/a.size <= 1").unwrap();
    let grounded = region.ground::<f64>(&domain, &[0.0]).unwrap();
    assert!(!grounded.contains(&[0.5, 0.5]).unwrap());
}

#[test]
fn along_one_parameter_the_intervals_of_a_quotient_are_right() {
    let domain =
        Domain::parse("object a { size: length } parameter x in [0.1, 4]: length").unwrap();
    let ends = |formula: &str| {
        let region = region(&domain, formula);
        let grounded = region.ground::<f64>(&domain, &[2.0]).unwrap();
        let set = grounded.intervals().unwrap();
        let ends: Vec<_> = set.intervals().iter().map(|i| [i.low, i.high]).collect();
        ends
    };
    // In closed form, and where there is none.
    assert_eq!(ends("x/a.size <= 0.5"), [[0.1, 1.0]]);
    for (formula, expected) in [
        ("a.size/x >= 1", [0.1, 2.0]),
        ("x*x/a.size >= 0.5", [1.0, 4.0]),
    ] {
        let found = ends(formula);
        let [[low, high]] = found[..] else {
            panic!("{formula}: {found:?}")
        };
        let off = (low - expected[0]).abs().max((high - expected[1]).abs());
        assert!(off < 1e-6, "{formula}: {found:?}");
    }
}

#[test]
fn constants_and_places_divide() {
    let domain = Domain::parse(
        "object a { width: length, count: none } constant third = 1/3: none
         parameter p in [0, 1] point mark = world + (p*a.width/a.count, 0)",
    )
    .unwrap();
    let region = region(&domain, "mark.x <= third*a.width");
    let inside = |p: f64| region.contains::<f64>(&domain, &[6.0, 2.0], &[p]).unwrap();
    assert!(inside(0.66) && !inside(0.67));
}

/// The left sides of a dimension, as text.
fn lefts(domain: &Domain<'_>) -> Vec<String> {
    let (mut nodes, mut values) = ([Node::Number(0.0); 400], [0.0; 400]);
    let features = Features::enumerate(domain, &mut nodes, &mut values).unwrap();
    let both = [1, 2].map(|complexity| {
        let of = |dimension| features.lhs(complexity, dimension);
        Dimension::ALL.into_iter().flat_map(of).collect::<Vec<_>>()
    });
    let write = |index: usize| {
        let mut text = String::new();
        let id = NodeId(u16::try_from(index).unwrap());
        let written = domain.write_expression(&mut text, features.nodes(), id);
        written.map(|()| text).unwrap()
    };
    both.concat().into_iter().map(write).collect()
}

#[test]
fn features_of_the_text_come_first() {
    let domain = Domain::parse(TEXT).unwrap();
    let expected = ["slide", "share", "v", "px", "foot.x", "foot.y"];
    assert_eq!(lefts(&domain)[..6], expected);
}

#[test]
fn only_what_is_listed_is_compared() {
    let listed = format!("{TEXT} compare foot.x, 2*px - pad.x");
    let domain = Domain::parse(&listed).unwrap();
    let expected = ["slide", "share", "foot.x", "2*px - pad.x"];
    assert_eq!(lefts(&domain), expected);
}

#[test]
fn only_what_is_related_has_relations() {
    let text = "object can[2] { x: length, y: length } shape can = circle(0.1)
        object bin { x: length, y: length } shape bin = rectangle(2, 2) centred
        parameter p in [0, 1]: length
        point grip = world + (p, 0)
        point left = grip + (0, 1) shape left = circle(0.1)
        point right = grip + (0, -1) shape right = circle(0.1)
        shape gripper = left + right ";
    let lefts = |more: &str| lefts(&Domain::parse(&[text, more].concat()).unwrap());
    assert!(lefts("").iter().any(|own| own == "clear(left, bin)"));
    let related = lefts("relate gripper, can");
    assert!(
        related.contains(&"min(clear(gripper, can))".into()),
        "{related:?}"
    );
    let about = |name: &str| related.iter().filter(|own| own.contains(name)).count();
    assert_eq!(about("bin"), 0, "{related:?}");
    assert_eq!(about("(left"), 0, "{related:?}");
    // Where it is, it says still.
    assert_eq!(about("left.x"), 1, "{related:?}");
}

#[test]
fn statements_about_features_say_what_is_wrong() {
    let cases = [
        ("feature", "expected the name of the feature"),
        ("feature px = v", "this name is declared already"),
        ("feature slide = v", "this name is declared already"),
        ("feature three = 1 + 2", "this is the same in every scene"),
        ("compare", "expected a number, a name or `(`"),
        ("relate banana", "no object with a place"),
        ("constant c = 1 / 0: none", "the value is too large"),
        (
            "feature far = dist(foot, pad): angle",
            "another dimension than the feature",
        ),
    ];
    for (statement, what) in cases {
        let error = Domain::parse(&[TEXT, statement].concat()).unwrap_err();
        assert!(error.to_string().contains(what), "{statement}: {error}");
    }
}
