//! What there is and where the action may move it, from above and, in space, from the side.

use super::draws::{Draw, Draws};
use super::outline;
use super::svg::{Pen, Place, Svg};
use super::view::View;
use crate::domain::{Base, MAX_PARAMETERS, Sample, Scene};
use crate::error::Error;
use crate::geometry::Body;
use crate::real::Real;

/// How wide a view is, and how high at least and at most, in pixels.
const WIDTH: f64 = 440.0;
const LOWEST: f64 = 120.0;
const HIGHEST: f64 = 440.0;
/// How high at most where there are two views.
const HIGHEST_OF_TWO: f64 = 300.0;
/// Pixels below a view, for its numbers and the next one's name.
const BELOW: f64 = 52.0;
/// How long the line is that shows a heading, in pixels.
const HEADING: f64 = 16.0;
/// How far below a point its name stands: names of what moves do not cover others.
const ABOVE_IT: f64 = -5.0;
const BELOW_IT: f64 = 13.0;
/// The points that a shape gives an object: they go without saying.
const OF_SHAPES: [&str; 5] = ["left", "right", "bottom", "top", "centre"];

/// A way to look at a scene.
#[derive(Clone, Copy)]
struct Sight {
    /// The axes to the right and up.
    across: usize,
    up: usize,
    names: [&'static str; 2],
}

const PLANE: Sight = Sight {
    across: 0,
    up: 1,
    names: ["x", "y"],
};
const FROM_ABOVE: Sight = Sight {
    across: 0,
    up: 1,
    names: ["x, from above", "y"],
};
const FROM_THE_SIDE: Sight = Sight {
    across: 0,
    up: 2,
    names: ["x, from the side", "z"],
};

impl Sight {
    fn flat(self, position: [f64; 3]) -> [f64; 2] {
        [self.across, self.up].map(|axis| position.get(axis).copied().unwrap_or_default())
    }
}

/// A point of the domain where it is.
struct Standing<'t, R> {
    owner: &'t str,
    part: &'t str,
    /// Whether its shape gives the point to its object.
    is_of_shape: bool,
    position: [f64; 3],
    heading: Option<[f64; 3]>,
    body: Option<Body<R>>,
}

/// A scene that is drawn.
pub(super) struct Stage<'s, 'p, R> {
    scene: &'s Scene<'p, R>,
    draws: &'s Draws<'s, 'p, R>,
    low: [f64; 3],
    high: [f64; 3],
}

impl<'s, 'p, R: Real> Stage<'s, 'p, R> {
    /// Looks at how large it is; `None` if the domain has no places.
    pub(super) fn new(
        scene: &'s Scene<'p, R>,
        draws: &'s Draws<'s, 'p, R>,
    ) -> Result<Option<Self>, Error> {
        let mut stage = Stage {
            scene,
            draws,
            low: [f64::INFINITY; 3],
            high: [f64::NEG_INFINITY; 3],
        };
        let (mut low, mut high) = (stage.low, stage.high);
        let mut reach = |standing: &Standing<'_, R>, with_body: bool| {
            let body = standing.body.as_ref().filter(|_| with_body);
            for axis in 0..3 {
                let Some((centre, extent)) = extent(standing, body, axis) else {
                    continue;
                };
                let ends = low.get_mut(axis).zip(high.get_mut(axis));
                if let Some((low, high)) = ends {
                    *low = Real::min(*low, centre - extent);
                    *high = Real::max(*high, centre + extent);
                }
            }
            Ok(())
        };
        stage.each_fixed(|standing| reach(standing, true))?;
        for expected in draws.expectations() {
            draws.each_of(*expected, &mut |draw| {
                stage.each_moved(&draw.theta, |standing| reach(standing, draw.with_bodies))
            })?;
        }
        (stage.low, stage.high) = (low, high);
        let [x, y, _] = stage.low;
        Ok((x.is_finite() && y.is_finite()).then_some(stage))
    }

    /// How high it is drawn.
    pub(super) fn height(&self) -> f64 {
        let (sights, highest) = self.sights();
        let views = sights
            .iter()
            .map(|sight| self.view(*sight, [0.0; 2], highest));
        views.fold(0.0, |sum, view| {
            let [_, height] = view.size;
            sum + height + BELOW
        })
    }

    /// Draws all views below one another, from the upper left corner on.
    pub(super) fn draw(&self, svg: &mut Svg<'_>, [left, top]: Place) -> Result<(), Error> {
        let (sights, highest) = self.sights();
        let mut below = top;
        for sight in sights {
            let view = self.view(*sight, [left, below], highest);
            self.draw_view(svg, &view, *sight)?;
            let [_, height] = view.size;
            below += height + BELOW;
        }
        Ok(())
    }

    /// From where it is seen, and how high a view is at most.
    fn sights(&self) -> (&'static [Sight], f64) {
        match self.draws.picture.domain.axes() > 2 {
            true => (&[FROM_ABOVE, FROM_THE_SIDE], HIGHEST_OF_TWO),
            false => (&[PLANE], HIGHEST),
        }
    }

    /// All of the scene with some space around, as large as there is room for.
    fn view(&self, sight: Sight, corner: Place, highest: f64) -> View {
        let (low, high) = (sight.flat(self.low), sight.flat(self.high));
        let ([low_x, low_y], [high_x, high_y]) = (low, high);
        let larger = Real::max(high_x - low_x, high_y - low_y);
        let space = if larger > 0.0 { 0.06 * larger } else { 0.5 };
        let (width, height) = (high_x - low_x + 2.0 * space, high_y - low_y + 2.0 * space);
        let pixels = Real::clamp(WIDTH * height / width, LOWEST, highest);
        // What is left over on one axis is given to both sides.
        let unit = Real::max(width / WIDTH, height / pixels);
        let middle = [0.5 * (low_x + high_x), 0.5 * (low_y + high_y)];
        let half = [0.5 * WIDTH * unit, 0.5 * pixels * unit];
        let ([x, y], [half_x, half_y]) = (middle, half);
        View {
            corner,
            size: [WIDTH, pixels],
            low: [x - half_x, y - half_y],
            high: [x + half_x, y + half_y],
        }
    }

    fn draw_view(&self, svg: &mut Svg<'_>, view: &View, sight: Sight) -> Result<(), Error> {
        view.axes(svg, sight.names)?;
        let outline = |svg: &mut Svg<'_>, standing: &Standing<'_, R>, class: &str| {
            let Some(body) = &standing.body else {
                return Ok(());
            };
            outline::draw(svg, view, body, |place| sight.flat(place), class)
        };
        self.each_fixed(|standing| outline(svg, standing, "body"))?;
        for expected in self.draws.expectations() {
            self.draws
                .each_of(*expected, &mut |draw| match draw.with_bodies {
                    true => self.each_moved(&draw.theta, |standing| {
                        outline(svg, standing, expected.body_class())
                    }),
                    false => Ok(()),
                })?;
        }
        for expected in self.draws.expectations() {
            svg.path(expected.dots_class(), |pen| {
                self.draws.each_of(*expected, &mut |draw| {
                    self.each_moved(&draw.theta, |own| {
                        pen.dot(view.place(sight.flat(own.position)))
                    })
                })
            })?;
        }
        self.tried(svg, view, sight)?;
        self.each_fixed(|standing| name(svg, view, sight, standing, ABOVE_IT))?;
        self.names_of_moved(svg, view, sight)
    }

    /// Marks what was tried where the points that the action moves came to be.
    fn tried(&self, svg: &mut Svg<'_>, view: &View, sight: Sight) -> Result<(), Error> {
        let mark = |pen: &mut Pen<'_, '_>, theta: &[f64], worked: bool| {
            self.each_moved(theta, |standing| {
                let place = view.place(sight.flat(standing.position));
                match worked {
                    true => pen.dot(place),
                    false => pen.cross(place),
                }
            })
        };
        super::each_tried(svg, self.draws.picture, mark)
    }

    /// Names the points that the action moves where the first of what works moves them.
    fn names_of_moved(&self, svg: &mut Svg<'_>, view: &View, sight: Sight) -> Result<(), Error> {
        let mut shown: Option<Draw> = None;
        for expected in self.draws.expectations().iter().rev() {
            self.draws.each_of(*expected, &mut |draw| {
                shown.get_or_insert(*draw);
                Ok(())
            })?;
        }
        match shown {
            Some(draw) => self.each_moved(&draw.theta, |own| name(svg, view, sight, own, BELOW_IT)),
            None => Ok(()),
        }
    }

    /// Visits the points that no parameter moves.
    fn each_fixed(
        &self,
        visit: impl FnMut(&Standing<'_, R>) -> Result<(), Error>,
    ) -> Result<(), Error> {
        self.each_point(&[], false, visit)
    }

    /// Visits the points that the parameters move.
    fn each_moved(
        &self,
        theta: &[f64],
        visit: impl FnMut(&Standing<'_, R>) -> Result<(), Error>,
    ) -> Result<(), Error> {
        self.each_point(theta, true, visit)
    }

    fn each_point(
        &self,
        theta: &[f64],
        moved: bool,
        mut visit: impl FnMut(&Standing<'_, R>) -> Result<(), Error>,
    ) -> Result<(), Error> {
        let domain = self.draws.picture.domain;
        let mut values = [R::ZERO; MAX_PARAMETERS];
        for (value, own) in values.iter_mut().zip(theta) {
            *value = R::from_f64(*own);
        }
        let sample: Sample<'_, '_, R, R> = self.scene.sample(&values);
        for (index, point) in (0u8..).zip(domain.points()) {
            if point.sampled != moved || domain.is_hidden(index) {
                continue;
            }
            let position = sample.position(index).map(R::to_f64);
            if !position.iter().all(|number| number.is_finite()) {
                continue;
            }
            let of_object = matches!(point.base, Base::Object(_));
            visit(&Standing {
                owner: point.owner,
                part: point.part,
                is_of_shape: of_object && OF_SHAPES.contains(&point.part),
                position,
                heading: sample
                    .direction(index)
                    .filter(|_| domain.is_oriented(index))
                    .map(|own| own.map(R::to_f64)),
                body: sample.body_of(index).filter(|body| !body.is_absent()),
            })?;
        }
        Ok(())
    }
}

/// Where something is along an axis: the middle of it, and how far it reaches from there.
fn extent<R: Real>(
    standing: &Standing<'_, R>,
    body: Option<&Body<R>>,
    axis: usize,
) -> Option<(f64, f64)> {
    let Some(body) = body else {
        return Some((*standing.position.get(axis)?, 0.0));
    };
    let halves = body.half_axes();
    let reach = halves.iter().filter_map(|half| half.get(axis));
    let reach = reach.fold(body.radius, |sum, own| sum + own.abs());
    Some((body.centre.get(axis)?.to_f64(), reach.to_f64()))
}

/// Draws a point with its heading and its name.
fn name<R: Real>(
    svg: &mut Svg<'_>,
    view: &View,
    sight: Sight,
    standing: &Standing<'_, R>,
    beside: f64,
) -> Result<(), Error> {
    let at = view.place(sight.flat(standing.position));
    if standing.is_of_shape {
        return svg.circle(at, 1.5, "point");
    }
    let [x, y] = at;
    if let Some(heading) = standing.heading.filter(|_| standing.part.is_empty()) {
        let [along_x, along_y] = sight.flat(heading);
        svg.line(
            &[at, [x + HEADING * along_x, y - HEADING * along_y]],
            "heading",
        )?;
    }
    svg.circle(at, 2.5, "point")?;
    svg.written([x + 5.0, y + beside], "small name", |out| {
        out.write_str(standing.owner)?;
        if !standing.part.is_empty() {
            out.write_str(".")?;
            out.write_str(standing.part)?;
        }
        Ok(())
    })
}
