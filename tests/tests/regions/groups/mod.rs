//! Groups of objects: what is said of their members is what going through the
//! members by hand says, however many an instance has.

mod extremes;
mod features;
mod members;
mod texts;

use critreg_tests::by_hand::ABSENT;

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
