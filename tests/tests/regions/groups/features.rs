//! What the grammar says of groups.

use super::{POSTS, posts};
use critreg::domain::{Dimension, Domain, Node, NodeId, PointSet, Scene};
use critreg::grammar::Features;
use critreg::region::Region;

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
