//! Pictures of a scene and of the parameters that a region admits there, as SVG.
//!
//! ```
//! use critreg::{domain::Domain, picture::Picture, region::Region};
//! let domain = Domain::parse(
//!     "object stick { x: length, y: length, theta: angle }
//!      parameter mu in [0, 3]: length
//!      point grasp = stick + (mu, 0)",
//! )?;
//! let region = Region::parse(&domain, "grasp.y <= 2.9")?;
//! let picture = Picture {
//!     domain: &domain,
//!     instance: &[2.0, 0.7, 1.57],
//!     region: Some(&region),
//!     tried: &|mark| {
//!         mark(&[0.5], true);
//!         mark(&[2.8], false);
//!     },
//! };
//! let mut svg = String::new();
//! picture.write_svg::<f64>(&mut svg)?;
//! assert!(svg.starts_with("<svg") && svg.contains("mu in 0.00 .. 2.20"));
//! # Ok::<(), critreg::Error>(())
//! ```
//!
//! | file | content |
//! |---|---|
//! | `svg.rs` | shapes and words as text |
//! | `view.rs` | from a plane to the picture; axes with round numbers |
//! | `draws.rs` | which parameters are shown |
//! | `scene.rs`, `outline.rs` | what there is, and where the action moves it |
//! | `parameters.rs` | what the region admits |

mod draws;
mod outline;
mod parameters;
mod scene;
mod svg;
mod view;

pub use svg::{Pen, Place, Svg, write_fixed};

use crate::domain::{Domain, PointSet, Scene};
use crate::error::Error;
use crate::real::Real;
use crate::region::Region;
use core::fmt;
use draws::{Draws, Expected};
use scene::Stage;

/// Visits what was tried in an instance: parameters, and whether the action worked.
pub type Tried<'p> = dyn Fn(&mut dyn FnMut(&[f64], bool)) + 'p;

/// What is drawn.
#[derive(Clone, Copy)]
pub struct Picture<'p> {
    /// What there is.
    pub domain: &'p Domain<'p>,
    /// Where that is: one number per attribute of every object.
    pub instance: &'p [f64],
    /// With which parameters the action is expected to work; `None` if that is not known.
    pub region: Option<&'p Region>,
    /// What was tried in this instance.
    pub tried: &'p Tried<'p>,
}

/// The width of a picture, and the space around it, in pixels.
const WIDTH: f64 = 880.0;
const SPACE: f64 = 20.0;
/// Space for the numbers of an axis.
const NUMBERS: f64 = 34.0;
/// Where plots of parameters begin, beside a scene.
const BESIDE: f64 = 560.0;
/// The height of a line of the region's text, and how many letters have room there.
const LINE: f64 = 17.0;
const LETTERS: usize = 112;

/// How everything looks, by class.
const STYLE: &str = "\
.critreg text{font:13px sans-serif;fill:#222}
.critreg .small{font-size:11px}
.critreg .code{font:12px monospace}
.critreg .middle{text-anchor:middle}
.critreg .end{text-anchor:end}
.critreg .name{paint-order:stroke;stroke:#fff;stroke-width:3px;stroke-opacity:.8}
.critreg .frame{fill:none;stroke:#888}
.critreg .grid{fill:none;stroke:#000;stroke-opacity:.07}
.critreg .body{fill:#dbe4f0;stroke:#5b6b82}
.critreg .point{fill:#222}
.critreg .heading{fill:none;stroke:#222;stroke-width:1.5}
.critreg .works{fill:#8fd19e}
.critreg .fails{fill:#e2e2e2}
.critreg .unknown{fill:#c9d7ea}
.critreg .works-body{fill:#1a9641;fill-opacity:.18;stroke:#1a9641}
.critreg .fails-body{fill:none;stroke:#b0b0b0;stroke-dasharray:3 2}
.critreg .unknown-body{fill:none;stroke:#7593bd;stroke-dasharray:3 2}
.critreg .works-dots{fill:none;stroke:#1a9641;stroke-width:3.5;stroke-linecap:round}
.critreg .fails-dots{fill:none;stroke:#b4b4b4;stroke-width:2.5;stroke-linecap:round}
.critreg .unknown-dots{fill:none;stroke:#7593bd;stroke-width:2.5;stroke-linecap:round}
.critreg .worked{fill:none;stroke:#0058a6;stroke-width:7;stroke-linecap:round}
.critreg .failed{fill:none;stroke:#d55e00;stroke-width:2}
";

impl Expected {
    /// The class of a body that stands there.
    fn body_class(self) -> &'static str {
        match self {
            Expected::Unknown => "unknown-body",
            Expected::Works => "works-body",
            Expected::Fails => "fails-body",
        }
    }

    /// The class of points.
    fn dots_class(self) -> &'static str {
        match self {
            Expected::Unknown => "unknown-dots",
            Expected::Works => "works-dots",
            Expected::Fails => "fails-dots",
        }
    }
}

impl Picture<'_> {
    /// Writes the picture: the text of the region; the scene with its bodies, and where the
    /// action moves points, in green where it is expected to work; the parameters that the
    /// region admits; and what was tried. In space the scene is seen from above and from the
    /// side. The same picture is the same text everywhere.
    ///
    /// `R` is what the region computes with.
    ///
    /// # Errors
    /// Those of [`Region::ground`] and of [`Scene::new`] with all points of the domain;
    /// [`Error::CapacityExceeded`] if `out` fails.
    pub fn write_svg<R: Real>(&self, out: &mut dyn fmt::Write) -> Result<(), Error> {
        let scene = Scene::<R>::new(self.domain, self.instance, PointSet::all(self.domain))?;
        let grounded = match self.region {
            Some(region) => Some(region.ground::<R>(self.domain, self.instance)?),
            None => None,
        };
        let draws = Draws {
            picture: self,
            grounded: grounded.as_ref(),
        };
        let stage = Stage::new(&scene, &draws)?;
        // How high it gets is known when it was drawn once.
        let words = |out: &mut dyn fmt::Write| self.write_words(out);
        let lines = svg::lines_of(LETTERS, words)?;
        let top = SPACE + f64::from(lines) * LINE + 1.3 * SPACE;
        let (left, scene) = match &stage {
            Some(stage) => (BESIDE, stage.height()),
            None => (SPACE + NUMBERS, 0.0),
        };
        let bottom = top + Real::max(scene, draws.height());
        let mut svg = Svg::begin(out, [WIDTH, bottom + SPACE], words, STYLE)?;
        svg.paragraph([SPACE, SPACE + 12.0], "code", LINE, LETTERS, words)?;
        if let Some(stage) = stage {
            stage.draw(&mut svg, [SPACE + NUMBERS, top])?;
        }
        draws.draw(&mut svg, [left, top])?;
        self.draw_legend(&mut svg, [SPACE + NUMBERS, bottom])?;
        svg.end()
    }

    fn draw_legend(&self, svg: &mut Svg<'_>, [mut x, y]: Place) -> Result<(), Error> {
        let expected: &[(Expected, &str)] = match self.region {
            Some(_) => &[
                (Expected::Works, "expected to work"),
                (Expected::Fails, "expected to fail"),
            ],
            None => &[(Expected::Unknown, "what can be chosen")],
        };
        for (expected, words) in expected {
            svg.rectangle([x, y - 9.0], [18.0, 10.0], expected.class())?;
            svg.path(expected.dots_class(), |pen| pen.dot([x + 9.0, y - 4.0]))?;
            svg.words([x + 24.0, y], words, "small")?;
            x += 150.0;
        }
        let mut any = [false; 2];
        (self.tried)(&mut |_, worked| {
            let [of_failed, of_worked] = &mut any;
            *(if worked { of_worked } else { of_failed }) = true;
        });
        let [any_failed, any_worked] = any;
        if any_worked {
            svg.path("worked", |pen| pen.dot([x + 9.0, y - 4.0]))?;
            svg.words([x + 24.0, y], "tried, and worked", "small")?;
            x += 150.0;
        }
        if any_failed {
            svg.path("failed", |pen| pen.cross([x + 9.0, y - 4.0]))?;
            svg.words([x + 24.0, y], "tried, and failed", "small")?;
        }
        Ok(())
    }

    fn write_words(&self, out: &mut dyn fmt::Write) -> fmt::Result {
        match self.region {
            Some(region) => region.write(self.domain, out),
            None => out.write_str("no region"),
        }
    }
}

/// Draws a mark for everything that was tried: what failed first.
fn each_tried(
    svg: &mut Svg<'_>,
    picture: &Picture<'_>,
    mark: impl Fn(&mut Pen<'_, '_>, &[f64], bool) -> Result<(), Error>,
) -> Result<(), Error> {
    for (class, wanted) in [("failed", false), ("worked", true)] {
        svg.path(class, |pen| {
            let mut marked = Ok(());
            (picture.tried)(&mut |theta, worked| {
                if worked == wanted && marked.is_ok() {
                    marked = mark(pen, theta, worked);
                }
            });
            marked
        })?;
    }
    Ok(())
}
