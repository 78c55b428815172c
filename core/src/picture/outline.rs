//! The outline of a body, seen along an axis of the world.

use super::svg::{Place, Svg};
use super::view::View;
use crate::error::Error;
use crate::geometry::Body;
use crate::real::Real;
use heapless::Vec;

/// Half the sides of what is seen of a body's core, each as a vector to the right.
struct Sides {
    halves: Vec<[f64; 2], 3>,
}

impl Sides {
    /// The shadow of a box is a polygon whose sides are its edges, each twice.
    fn of<R: Real>(body: &Body<R>, flat: impl Fn([f64; 3]) -> [f64; 2]) -> Sides {
        let mut halves: Vec<[f64; 2], 3> = Vec::new();
        for half in body.half_axes() {
            let [x, y] = flat(half.map(R::to_f64));
            // There is room: a body has three.
            let _ = match x < 0.0 || (x == 0.0 && y < 0.0) {
                _ if x == 0.0 && y == 0.0 => Ok(()),
                true => halves.push([-x, -y]),
                false => halves.push([x, y]),
            };
        }
        // From steeply downwards to steeply upwards: the lower half of the outline.
        for _ in 0..2 {
            let (first, rest) = match halves.as_mut_slice() {
                [first, rest @ ..] => (first, rest),
                [] => break,
            };
            let mut last = first;
            for next in rest {
                if turns_left(*next, *last) {
                    core::mem::swap(last, next);
                }
                last = next;
            }
        }
        Sides { halves }
    }

    /// Visits the sides counter-clockwise, each with where it begins and how it goes on.
    fn each(
        &self,
        centre: [f64; 2],
        mut visit: impl FnMut([f64; 2], [f64; 2]) -> Result<(), Error>,
    ) -> Result<(), Error> {
        let halves = self.halves.iter();
        let mut at = halves.fold(centre, |[x, y], [own_x, own_y]| [x - own_x, y - own_y]);
        for sign in [2.0, -2.0] {
            for [x, y] in &self.halves {
                let side = [sign * x, sign * y];
                visit(at, side)?;
                let ([from_x, from_y], [x, y]) = (at, side);
                at = [from_x + x, from_y + y];
            }
        }
        Ok(())
    }
}

fn turns_left([ax, ay]: [f64; 2], [bx, by]: [f64; 2]) -> bool {
    ax * by - ay * bx > 0.0
}

/// Draws the outline of a body; `flat` leaves out the axis that is looked along.
pub(super) fn draw<R: Real>(
    svg: &mut Svg<'_>,
    view: &View,
    body: &Body<R>,
    flat: impl Fn([f64; 3]) -> [f64; 2],
    class: &str,
) -> Result<(), Error> {
    let centre = flat(body.centre.map(R::to_f64));
    let radius = body.radius.to_f64();
    let sides = Sides::of(body, flat);
    let pixels = radius * view.scale();
    if sides.halves.is_empty() {
        return svg.circle(view.place(centre), pixels, class);
    }
    svg.path(class, |pen| {
        let mut first: Option<Place> = None;
        sides.each(centre, |from, side| {
            let [begin, end] = outside(from, side, radius).map(|place| view.place(place));
            match first {
                None => {
                    first = Some(begin);
                    pen.move_to(begin)?;
                }
                // A rounded corner.
                Some(_) if radius > 0.0 => pen.arc_to(begin, pixels)?,
                Some(_) => {}
            }
            pen.line_to(end)
        })?;
        match first {
            Some(first) if radius > 0.0 => pen.arc_to(first, pixels)?,
            _ => {}
        }
        pen.close()
    })
}

/// The ends of a side that was moved outwards, which is to its right.
fn outside([x, y]: [f64; 2], [along_x, along_y]: [f64; 2], by: f64) -> [[f64; 2]; 2] {
    let length = Real::sqrt(along_x * along_x + along_y * along_y);
    let [right_x, right_y] = [along_y * by / length, -along_x * by / length];
    let (x, y) = (x + right_x, y + right_y);
    [[x, y], [x + along_x, y + along_y]]
}
