//! A domain with several parameters, for tests: a two-link arm beside a box.

use critreg::domain::Domain;

/// Two joint angles, a free height, and a placement on a table.
pub const TEXT: &str = "
    # base of the arm, and a box in its way
    object base { x: length, y: length }
    object box  { x: length, y: length, theta: angle }
    constant upper = 1.0: length
    constant fore  = 0.8: length
    constant reach = upper + fore: length
    shape box = rectangle(0.4, 0.2) centred
    parameter px in [-2, 2]: length
    parameter py in [-2, 2]: length
    parameter q  in [-pi, pi]: angle
    point hand  = world + (px, py)
    point elbow = base turned q + (upper, 0)
";

/// The domain of [`TEXT`].
pub fn domain() -> Domain<'static> {
    Domain::parse(TEXT).expect("the text is valid")
}
