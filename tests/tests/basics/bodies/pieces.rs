//! Pieces: along every line of translation the value is that of one of them, and between
//! their roots nothing passes the threshold.

use super::*;
use critreg::geometry::Piece;
use critreg::random::generator;

/// How far a value may be from that of a piece.
const TOLERANCE: f64 = 1e-9;

/// Where a piece has a value along `start + t step`.
fn roots(piece: &Piece<f64>, start: Vector, step: Vector, value: f64) -> Vec<f64> {
    match *piece {
        Piece::Plane { normal, offset } => {
            vec![(value + offset - dot(start, normal)) / dot(step, normal)]
        }
        Piece::Length {
            at,
            across,
            factor,
            offset,
        } => {
            let flat = |v: Vector| across.map_or(v, |w| subtract(v, scale(w, dot(v, w))));
            let (from, step) = (flat(subtract(start, at)), flat(step));
            let length = (value - offset) / factor;
            if length < 0.0 {
                return Vec::new();
            }
            let (a, b) = (dot(step, step), dot(from, step));
            let root = (b * b - a * (dot(from, from) - length * length)).sqrt();
            vec![(-b - root) / a, (-b + root) / a]
        }
    }
}

/// How many samples along lines were looked at, and how often the value passed the threshold
/// between two cuts.
#[derive(Debug, Default)]
struct Seen {
    samples: usize,
    crossings: usize,
}

fn check_line(
    seen: &mut Seen,
    relation: Relation,
    [a, b]: [&Body<f64>; 2],
    step: Vector,
    dimensions: Dimensions,
) {
    let pieces: Vec<_> = relation.pieces(a, b, dimensions).iter().collect();
    let start = subtract(a.centre, b.centre);
    let value = |t: f64| relation.value(&moved(a, scale(step, t)), b, dimensions);
    let threshold = [0.0, 0.05, -0.02][seen.samples % 3];
    let is_root = |t: &f64| (0.0..1.0).contains(t) && (value(*t) - threshold).abs() < 1e-7;
    let all_roots = pieces
        .iter()
        .flat_map(|piece| roots(piece, start, step, threshold));
    let mut cuts: Vec<f64> = all_roots.filter(is_root).collect();
    cuts.extend([0.0, 1.0]);
    cuts.sort_by(f64::total_cmp);
    let mut before = None;
    for cut in cuts.windows(2).filter(|cut| cut[1] - cut[0] > 1e-6) {
        let holds = value(0.5 * (cut[0] + cut[1])) >= threshold;
        seen.crossings += usize::from(before.is_some_and(|before| before != holds));
        before = Some(holds);
    }
    for i in 0..60 {
        let t = f64::from(i) / 59.0;
        let d = add(start, scale(step, t));
        let now = value(t);
        let differences = pieces.iter().map(|piece| (piece.value(d) - now).abs());
        let nearest = differences.fold(f64::INFINITY, f64::min);
        assert!(
            nearest < TOLERANCE,
            "{relation:?} {nearest} at {d:?} of {a:?} {b:?}"
        );
        let after = cuts.iter().find(|cut| **cut > t).copied().unwrap_or(1.0);
        let before = cuts.iter().rfind(|cut| **cut <= t).copied().unwrap_or(0.0);
        if t - before > 1e-6 && after - t > 1e-6 {
            let middle = value(0.5 * (before + after));
            assert_eq!(
                now >= threshold,
                middle >= threshold,
                "{relation:?} {now} {middle} {threshold} at {d:?} of {a:?} {b:?}"
            );
            seen.samples += 1;
        }
    }
}

fn check(dimensions: Dimensions, repeats: usize, seed: u64) -> Seen {
    let mut rng = generator(seed);
    let mut seen = Seen::default();
    for shapes in pairs(dimensions) {
        for relation in RELATIONS {
            for _ in 0..repeats {
                let [a, b] = pair(&mut rng, shapes, dimensions);
                // Some lines run along a side.
                let step = match below(&mut rng, 4) {
                    0 => b.axes[below(&mut rng, 2)],
                    _ => vector(&mut rng, 2.0),
                };
                let a = moved(&a, scale(step, -0.5));
                check_line(&mut seen, relation, [&a, &b], step, dimensions);
            }
        }
    }
    seen
}

#[test]
fn in_the_plane_a_value_is_made_of_its_pieces() {
    let seen = check(Dimensions::Plane, 8, 11);
    assert!(seen.samples > 100_000 && seen.crossings > 1000, "{seen:?}");
}

#[test]
fn in_space_a_value_is_made_of_its_pieces() {
    let seen = check(Dimensions::Space, 4, 12);
    assert!(seen.samples > 100_000 && seen.crossings > 1000, "{seen:?}");
}

#[test]
fn boxes_turned_alike_have_all_their_edges() {
    // All axes of one are those of the other but for rounding, so that four half axes lie in
    // a plane, and three of them are seen along one line.
    let mut rng = generator(13);
    for _ in 0..1000 {
        let frame = Frame3::new([0.0; 3], vector(&mut rng, PI));
        let quarters = [0; 3].map(|_| FRAC_PI_2 * below(&mut rng, 4) as f64);
        let alike = frame.compose(&Frame3::new([0.0; 3], quarters));
        let a = body(&mut rng, SPACE[9], frame.axes());
        let b = body(&mut rng, SPACE[10], alike.axes());
        let pieces = Relation::Clear.pieces(&a, &b, Dimensions::Space);
        for _ in 0..20 {
            let a = moved(&a, vector(&mut rng, 2.0));
            let value = Relation::Clear.value(&a, &b, Dimensions::Space);
            let d = subtract(a.centre, b.centre);
            let differences = pieces.iter().map(|piece| (piece.value(d) - value).abs());
            let nearest = differences.fold(f64::INFINITY, f64::min);
            assert!(nearest < TOLERANCE, "{nearest} at {d:?} of {a:?} {b:?}");
        }
    }
}

#[test]
fn there_are_no_more_pieces_than_sides_and_corners() {
    let turned = axes([0.3, 0.0, 0.0]);
    let rectangle = Body::new([0.0; 3], Body::UPRIGHT, [2.0, 1.0, 0.0], 0.0);
    let other = Body::new([0.0; 3], turned, [1.0, 0.5, 0.0], 0.0);
    let box_in_space = Body::new([0.0; 3], Body::UPRIGHT, [2.0, 1.0, 0.5], 0.0);
    let ball = Body::ball([0.0; 3], 0.5);
    let count = |relation: Relation, a: &Body<f64>, b: &Body<f64>, dimensions| {
        let pieces = relation.pieces(a, b, dimensions);
        assert!(pieces.iter().count() <= pieces.len());
        assert_eq!(pieces.get(pieces.len()), None);
        pieces.len()
    };
    // An octagon: eight sides, eight corners.
    assert_eq!(
        count(Relation::Clear, &rectangle, &other, Dimensions::Plane),
        16
    );
    assert_eq!(count(Relation::Clear, &ball, &other, Dimensions::Plane), 8);
    assert_eq!(count(Relation::Clear, &ball, &ball, Dimensions::Plane), 1);
    assert_eq!(
        count(Relation::Inside, &rectangle, &other, Dimensions::Plane),
        4
    );
    assert_eq!(
        count(Relation::Inside, &rectangle, &ball, Dimensions::Plane),
        4
    );
    assert_eq!(
        count(Relation::Corner, &rectangle, &other, Dimensions::Plane),
        32
    );
    // Six faces, twelve edges, eight corners.
    assert_eq!(
        count(Relation::Clear, &ball, &box_in_space, Dimensions::Space),
        26
    );
    assert_eq!(
        count(Relation::Over, &ball, &box_in_space, Dimensions::Space),
        4
    );
    assert_eq!(
        count(
            Relation::Coordinate(Axis::X),
            &ball,
            &ball,
            Dimensions::Space
        ),
        1
    );
}
