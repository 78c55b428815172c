//! The parameters that the region admits: of one as intervals, of two as an area, of more as
//! draws.

use super::draws::{Draws, Expected};
use super::svg::{Place, Svg};
use super::view::{View, write_tick};
use crate::domain::{MAX_PARAMETERS, Parameter};
use crate::error::Error;
use crate::real::Real;
use crate::region::{Grounded, Theta};
use core::fmt;

/// How wide a plot is, in pixels.
const WIDTH: f64 = 300.0;
/// How high the plot of two parameters is; of more, that of each two.
const HEIGHT_OF_TWO: f64 = 300.0;
const HEIGHT_OF_MORE: f64 = 190.0;
/// How high a band of values is, and the lanes beside it of what was tried.
const BAND: f64 = 24.0;
const LANE: f64 = 14.0;
/// Pixels below a plot, for its numbers and names.
const BELOW: f64 = 52.0;
/// How many rows the area of two parameters is made of; in a row it is exact.
const ROWS: u32 = 150;
/// In how many cells a row is cut where it is not.
const CELLS: u32 = 100;
/// How many intervals are written out.
const WRITTEN: usize = 4;

impl<R: Real> Draws<'_, '_, R> {
    /// How high what the region admits is drawn.
    pub(super) fn height(&self) -> f64 {
        match self.picture.domain.parameters().len() {
            0 => BELOW,
            1 => BAND + 2.0 * LANE + 1.4 * BELOW,
            2 => HEIGHT_OF_TWO + BELOW,
            count => count.div_ceil(2) as f64 * (HEIGHT_OF_MORE + BELOW),
        }
    }

    /// Draws what the region admits, from the upper left corner on.
    pub(super) fn draw(&self, svg: &mut Svg<'_>, corner: Place) -> Result<(), Error> {
        match self.picture.domain.parameters() {
            [] => self.draw_answer(svg, corner),
            [only] => self.draw_values(svg, corner, only),
            [first, second] => self.draw_area(svg, corner, [first, second]),
            all => self.draw_pairs(svg, corner, all),
        }
    }

    fn draw_answer(&self, svg: &mut Svg<'_>, [x, y]: Place) -> Result<(), Error> {
        let words = match self.expected(&[0.0; MAX_PARAMETERS])? {
            Expected::Unknown => "The action has no parameters.",
            Expected::Works => "The action has no parameters, and is expected to work.",
            Expected::Fails => "The action has no parameters, and is expected to fail.",
        };
        svg.words([x, y + 14.0], words, "")
    }

    fn draw_values(
        &self,
        svg: &mut Svg<'_>,
        [left, top]: Place,
        parameter: &Parameter<'_>,
    ) -> Result<(), Error> {
        let view = View {
            corner: [left, top],
            size: [WIDTH, BAND + 2.0 * LANE],
            low: [parameter.low, 0.0],
            high: [parameter.high, 1.0],
        };
        let y = top + LANE;
        let class = match self.grounded {
            Some(_) => Expected::Fails.class(),
            None => Expected::Unknown.class(),
        };
        svg.rectangle([left, y], [WIDTH, BAND], class)?;
        if let Some(grounded) = self.grounded {
            each_interval(grounded, 0, &[0.0; MAX_PARAMETERS], |low, high| {
                let ([from, _], [to, _]) = (view.place([low, 0.0]), view.place([high, 0.0]));
                // A single value is seen, too.
                let size = [Real::max(to - from, 1.0), BAND];
                svg.rectangle([from, y], size, Expected::Works.class())
            })?;
        }
        view.axis_x(svg, parameter.name)?;
        super::each_tried(svg, self.picture, |pen, theta, worked| {
            let value = theta.first().copied().unwrap_or_default();
            let [x, _] = view.place([value, 0.0]);
            match worked {
                true => pen.dot([x, y - 0.5 * LANE]),
                false => pen.cross([x, y + BAND + 0.5 * LANE]),
            }
        })?;
        let Some(grounded) = self.grounded else {
            return Ok(());
        };
        let below = top + BAND + 2.0 * LANE + BELOW;
        svg.written([left, below], "small", |out| {
            write_intervals(out, grounded, parameter)
        })
    }

    fn draw_area(
        &self,
        svg: &mut Svg<'_>,
        corner: Place,
        [first, second]: [&Parameter<'_>; 2],
    ) -> Result<(), Error> {
        let view = View {
            corner,
            size: [WIDTH, HEIGHT_OF_TWO],
            low: [first.low, second.low],
            high: [first.high, second.high],
        };
        if let Some(grounded) = self.grounded {
            svg.rectangle(view.corner, view.size, Expected::Fails.class())?;
            svg.path(Expected::Works.class(), |pen| {
                for row in 0..ROWS {
                    let [bottom, middle, top] = [0.0, 0.5, 1.0].map(|part| {
                        let share = (f64::from(row) + part) / f64::from(ROWS);
                        second.low.towards(second.high, share)
                    });
                    let theta = [0.0, middle, 0.0, 0.0, 0.0, 0.0];
                    each_interval(grounded, 0, &theta, |low, high| {
                        let corners = [[low, bottom], [high, bottom], [high, top], [low, top]];
                        let [from, rest @ ..] = corners.map(|corner| view.place(corner));
                        pen.move_to(from)?;
                        rest.iter().try_for_each(|corner| pen.line_to(*corner))?;
                        pen.close()
                    })?;
                }
                Ok(())
            })?;
        }
        view.axes(svg, [first.name, second.name])?;
        self.tried_in(svg, &view, [0, 1])
    }

    /// Draws of which two parameters each are shown beside one another.
    fn draw_pairs(
        &self,
        svg: &mut Svg<'_>,
        [left, top]: Place,
        all: &[Parameter<'_>],
    ) -> Result<(), Error> {
        let mut below = top;
        for first in (0..all.len()).step_by(2) {
            // The last one of an odd number stands beside the first.
            let second = if first + 1 < all.len() { first + 1 } else { 0 };
            let (Some(across), Some(up)) = (all.get(first), all.get(second)) else {
                break;
            };
            let view = View {
                corner: [left, below],
                size: [WIDTH, HEIGHT_OF_MORE],
                low: [across.low, up.low],
                high: [across.high, up.high],
            };
            view.axes(svg, [across.name, up.name])?;
            for expected in self.expectations() {
                svg.path(expected.dots_class(), |pen| {
                    self.each_of(*expected, &mut |draw| {
                        pen.dot(view.place(two_of(&draw.theta, [first, second])))
                    })
                })?;
            }
            self.tried_in(svg, &view, [first, second])?;
            below += HEIGHT_OF_MORE + BELOW;
        }
        Ok(())
    }

    fn tried_in(&self, svg: &mut Svg<'_>, view: &View, axes: [usize; 2]) -> Result<(), Error> {
        super::each_tried(svg, self.picture, |pen, theta, worked| {
            let place = view.place(two_of(theta, axes));
            match worked {
                true => pen.dot(place),
                false => pen.cross(place),
            }
        })
    }
}

fn two_of(theta: &[f64], axes: [usize; 2]) -> [f64; 2] {
    axes.map(|axis| theta.get(axis).copied().unwrap_or_default())
}

/// Visits the intervals that a region admits of one parameter while the others stay.
fn each_interval<R: Real>(
    grounded: &Grounded<'_, R>,
    axis: usize,
    theta: &Theta,
    mut visit: impl FnMut(f64, f64) -> Result<(), Error>,
) -> Result<(), Error> {
    let set = grounded.intervals_along(axis, theta)?;
    for interval in set.intervals() {
        let [low, high] = [interval.low, interval.high].map(R::to_f64);
        if set.is_exact() {
            visit(low, high)?;
        } else {
            each_run(grounded, axis, theta, [low, high], &mut visit)?;
        }
    }
    Ok(())
}

/// Visits what is admitted between two ends, where only looking at each cell can tell.
fn each_run<R: Real>(
    grounded: &Grounded<'_, R>,
    axis: usize,
    theta: &Theta,
    [low, high]: [f64; 2],
    visit: &mut impl FnMut(f64, f64) -> Result<(), Error>,
) -> Result<(), Error> {
    let count = grounded.domain().parameters().len();
    let mut theta = *theta;
    let mut begun = None;
    for cell in 0..CELLS {
        let at = |part: f64| low.towards(high, (f64::from(cell) + part) / f64::from(CELLS));
        if let Some(value) = theta.get_mut(axis) {
            *value = at(0.5);
        }
        match (
            begun,
            grounded.contains(theta.get(..count).unwrap_or_default())?,
        ) {
            (None, true) => begun = Some(at(0.0)),
            (Some(begin), false) => {
                visit(begin, at(0.0))?;
                begun = None;
            }
            _ => {}
        }
    }
    match begun {
        Some(begin) => visit(begin, high),
        None => Ok(()),
    }
}

/// Writes the values that are admitted, with as many digits as one can see.
fn write_intervals<R: Real>(
    out: &mut dyn fmt::Write,
    grounded: &Grounded<'_, R>,
    parameter: &Parameter<'_>,
) -> fmt::Result {
    let mut decimals = 0;
    let mut unit = (parameter.high - parameter.low) / 200.0;
    while unit < 1.0 && decimals < 15 {
        unit *= 10.0;
        decimals += 1;
    }
    out.write_str(parameter.name)?;
    let mut count = 0;
    let written = each_interval(grounded, 0, &[0.0; MAX_PARAMETERS], |low, high| {
        let mut write = || {
            match count {
                0 => out.write_str(" in ")?,
                1..WRITTEN => out.write_str(", ")?,
                WRITTEN => return out.write_str(" and more"),
                _ => return Ok(()),
            }
            write_tick(out, low, decimals)?;
            out.write_str(" .. ")?;
            write_tick(out, high, decimals)
        };
        let written = write().map_err(|_| Error::CapacityExceeded("the text of a picture"));
        count += 1;
        written
    });
    written.map_err(|_| fmt::Error)?;
    match count {
        0 => out.write_str(": none works here"),
        _ => Ok(()),
    }
}
