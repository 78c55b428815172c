//! A line of which one end moves: along every line of places of that end, the clearance is
//! that of a piece, or does not vary.

use super::*;
use critreg::geometry::{Swing, SwingPiece, sight};
use critreg::random::generator;

/// How far a value may be from that of a piece.
const TOLERANCE: f64 = 1e-9;

fn nearest(pieces: &[SwingPiece<f64>], [pivot, end]: [Vector; 2], value: f64) -> f64 {
    let values = pieces.iter().map(|piece| piece.value(pivot, end));
    values
        .map(|own| (own - value).abs())
        .fold(f64::INFINITY, f64::min)
}

fn check(dimensions: Dimensions, seed: u64) -> [usize; 3] {
    let mut rng = generator(seed);
    // Where the end is nearest, an edge or a corner, or the end that stands.
    let mut seen = [0; 3];
    for shapes in pairs(dimensions) {
        for _ in 0..20 {
            let [_, body] = pair(&mut rng, shapes, dimensions);
            let body = Body {
                centre: [0.0; 3],
                ..body
            };
            let radius = [0.0, 0.05][below(&mut rng, 2)];
            // Some ends are straight above a corner, or in line with a side.
            let pivot = match below(&mut rng, 3) {
                0 => add(body.half_axes()[0], scale(body.axes[1], 0.7)),
                _ => vector(&mut rng, 1.0),
            };
            let pivot = match dimensions {
                Dimensions::Plane => [pivot[0], pivot[1], 0.0],
                Dimensions::Space => pivot,
            };
            let swing = Swing::new(pivot, radius, &body, dimensions);
            let pieces: Vec<_> = swing.iter().collect();
            assert!(!swing.is_empty() && pieces.len() <= swing.len());
            assert_eq!(swing.get(swing.len()), None);
            let of_end = |piece: &&SwingPiece<f64>| matches!(piece, SwingPiece::End(_));
            let ends: Vec<_> = pieces.iter().filter(of_end).copied().collect();
            for _ in 0..30 {
                let mut end = vector(&mut rng, 1.5);
                if dimensions == Dimensions::Plane {
                    end[2] = 0.0;
                }
                let value = sight(pivot, end, radius, &body, dimensions);
                if nearest(&ends, [pivot, pivot], value) < TOLERANCE {
                    seen[2] += 1;
                    continue;
                }
                let off = nearest(&pieces, [pivot, end], value);
                assert!(
                    off < TOLERANCE,
                    "{off}: {value} from {pivot:?} to {end:?}, {radius}, {body:?}"
                );
                let is_end = nearest(&ends, [pivot, end], value) < TOLERANCE;
                seen[usize::from(!is_end)] += 1;
            }
        }
    }
    seen
}

#[test]
fn a_line_about_one_end_is_made_of_its_pieces() {
    for (dimensions, seed) in [(Dimensions::Plane, 31), (Dimensions::Space, 32)] {
        let seen = check(dimensions, seed);
        assert!(
            seen.iter().all(|count| *count > 1000),
            "{dimensions:?}: {seen:?}"
        );
    }
}

#[test]
fn there_are_no_more_pieces_than_ends_and_corners() {
    let rectangle = Body::new([0.0; 3], Body::UPRIGHT, [2.0, 1.0, 0.0], 0.0);
    let cuboid = Body::new([0.0; 3], Body::UPRIGHT, [2.0, 1.0, 0.5], 0.0);
    let ball = Body::ball([0.0; 3], 0.5);
    let count = |body: &Body<f64>, dimensions| Swing::new([3.0; 3], 0.1, body, dimensions).len();
    // Eight of the end, and each corner from two sides.
    assert_eq!(count(&rectangle, Dimensions::Plane), 8 + 8);
    assert_eq!(count(&ball, Dimensions::Plane), 1 + 2);
    // Twelve edges from two sides, and eight corners.
    assert_eq!(count(&cuboid, Dimensions::Space), 26 + 24 + 8);
    assert_eq!(count(&ball, Dimensions::Space), 1 + 1);
}
