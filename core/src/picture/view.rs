//! A part of a plane, and where it is in the picture.

use super::svg::{Place, Svg, write_fixed};
use crate::error::Error;
use crate::real::Real;
use crate::text::write_number;
use core::fmt;

/// Pixels between two numbers of an axis, at least.
const APART: f64 = 42.0;
/// Most numbers of an axis, whatever the range is.
const MOST_TICKS: u32 = 40;

/// A rectangle of a plane, drawn in a rectangle of the picture; upwards is upwards.
#[derive(Clone, Copy)]
pub(super) struct View {
    /// The upper left corner in the picture, and the size there.
    pub(super) corner: Place,
    pub(super) size: Place,
    /// The lowest and highest numbers along each axis.
    pub(super) low: [f64; 2],
    pub(super) high: [f64; 2],
}

impl View {
    /// Where a point of the plane is in the picture.
    pub(super) fn place(&self, [x, y]: [f64; 2]) -> Place {
        let ([left, top], [width, height]) = (self.corner, self.size);
        let ([low_x, low_y], [high_x, high_y]) = (self.low, self.high);
        [
            left + width * share(x, low_x, high_x),
            top + height * (1.0 - share(y, low_y, high_y)),
        ]
    }

    /// Pixels per unit along the first axis.
    pub(super) fn scale(&self) -> f64 {
        let ([width, _], [low, _], [high, _]) = (self.size, self.low, self.high);
        width / (high - low)
    }

    /// Draws the frame, a grid, the numbers along both axes and the names of these.
    pub(super) fn axes(&self, svg: &mut Svg<'_>, names: [&str; 2]) -> Result<(), Error> {
        let [name_x, name_y] = names;
        self.axis_x(svg, name_x)?;
        let ([left, top], [width, height]) = (self.corner, self.size);
        let ([_, low], [_, high]) = (self.low, self.high);
        Ticks::new(low, high, height).each(|tick, decimals| {
            let [_, y] = self.place([0.0, tick]);
            svg.line(&[[left, y], [left + width, y]], "grid")?;
            let write = |out: &mut dyn fmt::Write| write_tick(out, tick, decimals);
            svg.written([left - 5.0, y + 4.0], "small end", write)
        })?;
        svg.words([left - 30.0, top - 10.0], name_y, "small")?;
        svg.rectangle(self.corner, self.size, "frame")
    }

    /// The same for the first axis only.
    pub(super) fn axis_x(&self, svg: &mut Svg<'_>, name: &str) -> Result<(), Error> {
        let ([left, top], [width, height]) = (self.corner, self.size);
        let ([low, _], [high, _]) = (self.low, self.high);
        let bottom = top + height;
        Ticks::new(low, high, width).each(|tick, decimals| {
            let [x, _] = self.place([tick, 0.0]);
            svg.line(&[[x, top], [x, bottom]], "grid")?;
            let write = |out: &mut dyn fmt::Write| write_tick(out, tick, decimals);
            svg.written([x, bottom + 14.0], "small middle", write)
        })?;
        let middle = left + 0.5 * width;
        svg.words([middle, bottom + 29.0], name, "small middle")
    }
}

/// Where a number is between two others, in single steps that cannot overflow.
fn share(value: f64, low: f64, high: f64) -> f64 {
    let share = (0.5 * value - 0.5 * low) / (0.5 * high - 0.5 * low);
    // Far outside is far enough.
    Real::clamp(share, -100.0, 100.0)
}

/// The round numbers of an axis.
struct Ticks {
    step: f64,
    decimals: u32,
    low: f64,
    high: f64,
}

impl Ticks {
    fn new(low: f64, high: f64, pixels: f64) -> Ticks {
        let wanted = (high - low) * APART / pixels;
        let (mut power, mut decimals) = (1.0, 0_u32);
        for _ in 0..300 {
            if power >= wanted {
                power /= 10.0;
                decimals += 1;
            } else if power * 10.0 < wanted {
                power *= 10.0;
            } else {
                break;
            }
        }
        let factor = [1.0, 2.0, 5.0, 10.0];
        let factor = factor.into_iter().find(|factor| factor * power >= wanted);
        let factor = factor.unwrap_or(10.0);
        if factor == 10.0 {
            decimals = decimals.saturating_sub(1);
        }
        Ticks {
            step: factor * power,
            decimals,
            low,
            high,
        }
    }

    /// Visits the numbers, each with how many decimals it has.
    fn each(&self, mut visit: impl FnMut(f64, u32) -> Result<(), Error>) -> Result<(), Error> {
        let first = -Real::floor(1e-9 - self.low / self.step);
        for number in 0..MOST_TICKS {
            let tick = (first + f64::from(number)) * self.step;
            let beyond = self.high + 1e-9 * self.step;
            if tick.partial_cmp(&beyond).is_none_or(|order| order.is_gt()) {
                break;
            }
            visit(tick, self.decimals)?;
        }
        Ok(())
    }
}

/// Writes a number with so many decimals, or shortly if it is large or needs many.
pub(super) fn write_tick(out: &mut dyn fmt::Write, value: f64, decimals: u32) -> fmt::Result {
    if decimals <= 6 && Real::abs(value) < 1e6 {
        write_fixed(out, value, decimals)
    } else {
        write_number(out, value)
    }
}
