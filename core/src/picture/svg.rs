//! Shapes and words as the text of an SVG picture.

use crate::error::Error;
use crate::real::Real;
use crate::text::TextBuffer;
use core::fmt;

/// A place in a picture: to the right and down, in pixels.
pub type Place = [f64; 2];

/// A picture that is being written. All numbers have two decimals, so that it is the same
/// text everywhere; what something looks like is said by the class it has.
pub struct Svg<'o> {
    out: &'o mut dyn fmt::Write,
}

impl<'o> Svg<'o> {
    /// Begins a picture of this size, on white: for readers in the dark, too.
    ///
    /// `title` writes what it is, for those who cannot see it. `style` is CSS, whose
    /// selectors should begin with `.critreg`: in a page, they hold for all of it.
    ///
    /// # Errors
    /// As for all that is written here, [`Error::CapacityExceeded`] if `out` fails.
    pub fn begin(
        out: &'o mut dyn fmt::Write,
        size: Place,
        title: impl FnOnce(&mut dyn fmt::Write) -> fmt::Result,
        style: &str,
    ) -> Result<Svg<'o>, Error> {
        let mut svg = Svg { out };
        let [width, height] = size;
        svg.raw("<svg xmlns=\"http://www.w3.org/2000/svg\" class=\"critreg\" role=\"img\"")?;
        svg.attributes(&[("width", width), ("height", height)])?;
        svg.raw(" viewBox=\"0 0 ")?;
        svg.pair(size, " ")?;
        svg.raw("\">\n<title>")?;
        svg.escaped(title)?;
        svg.raw("</title>\n<style>\n")?;
        svg.raw(style)?;
        svg.raw("</style>\n<rect width=\"100%\" height=\"100%\" fill=\"#fff\"/>\n")?;
        Ok(svg)
    }

    /// Ends the picture.
    ///
    /// # Errors
    /// See [`Svg::begin`].
    pub fn end(mut self) -> Result<(), Error> {
        self.raw("</svg>\n")
    }

    /// A rectangle from its upper left corner.
    ///
    /// # Errors
    /// See [`Svg::begin`].
    pub fn rectangle(
        &mut self,
        [x, y]: Place,
        [width, height]: Place,
        class: &str,
    ) -> Result<(), Error> {
        self.element("rect", class)?;
        self.attributes(&[("x", x), ("y", y), ("width", width), ("height", height)])?;
        self.raw("/>\n")
    }

    /// A circle.
    ///
    /// # Errors
    /// See [`Svg::begin`].
    pub fn circle(&mut self, [x, y]: Place, radius: f64, class: &str) -> Result<(), Error> {
        self.element("circle", class)?;
        self.attributes(&[("cx", x), ("cy", y), ("r", radius)])?;
        self.raw("/>\n")
    }

    /// A closed line through these points.
    ///
    /// # Errors
    /// See [`Svg::begin`].
    pub fn polygon(&mut self, points: &[Place], class: &str) -> Result<(), Error> {
        self.through("polygon", points, class)
    }

    /// An open line through these points.
    ///
    /// # Errors
    /// See [`Svg::begin`].
    pub fn line(&mut self, points: &[Place], class: &str) -> Result<(), Error> {
        self.through("polyline", points, class)
    }

    fn through(&mut self, element: &str, points: &[Place], class: &str) -> Result<(), Error> {
        self.element(element, class)?;
        self.raw(" points=\"")?;
        for (number, point) in points.iter().enumerate() {
            self.raw(if number > 0 { " " } else { "" })?;
            self.pair(*point, ",")?;
        }
        self.raw("\"/>\n")
    }

    /// What a pen draws.
    ///
    /// # Errors
    /// See [`Svg::begin`]; those of `draw`.
    pub fn path(
        &mut self,
        class: &str,
        draw: impl FnOnce(&mut Pen<'_, 'o>) -> Result<(), Error>,
    ) -> Result<(), Error> {
        self.element("path", class)?;
        self.raw(" d=\"")?;
        draw(&mut Pen { svg: self })?;
        self.raw("\"/>\n")
    }

    /// Words, of which the class says whether they start, end or have their middle at this
    /// point of the base line.
    ///
    /// # Errors
    /// See [`Svg::begin`].
    pub fn words(&mut self, at: Place, words: &str, class: &str) -> Result<(), Error> {
        self.written(at, class, |out| out.write_str(words))
    }

    /// Words that are written by something else.
    ///
    /// # Errors
    /// See [`Svg::begin`].
    pub fn written(
        &mut self,
        [x, y]: Place,
        class: &str,
        write: impl FnOnce(&mut dyn fmt::Write) -> fmt::Result,
    ) -> Result<(), Error> {
        self.element("text", class)?;
        self.attributes(&[("x", x), ("y", y)])?;
        self.raw(">")?;
        self.escaped(write)?;
        self.raw("</text>\n")
    }

    /// Words that go on in another line, at a blank, after so many letters; lines are so many
    /// pixels high.
    ///
    /// # Errors
    /// See [`Svg::begin`].
    pub fn paragraph(
        &mut self,
        [x, y]: Place,
        class: &str,
        line: f64,
        letters: usize,
        write: impl FnOnce(&mut dyn fmt::Write) -> fmt::Result,
    ) -> Result<(), Error> {
        self.element("text", class)?;
        self.attributes(&[("x", x), ("y", y)])?;
        self.raw("><tspan>")?;
        let mut lines = Lines {
            out: self.out,
            start: [x, line],
            letters,
            column: 0,
            count: 1,
        };
        write(&mut lines).map_err(full)?;
        self.raw("</tspan></text>\n")
    }

    fn element(&mut self, name: &str, class: &str) -> Result<(), Error> {
        for text in ["<", name, " class=\"", class, "\""] {
            self.raw(text)?;
        }
        Ok(())
    }

    fn attributes(&mut self, attributes: &[(&str, f64)]) -> Result<(), Error> {
        for (name, value) in attributes {
            for text in [" ", name, "=\""] {
                self.raw(text)?;
            }
            self.number(*value)?;
            self.raw("\"")?;
        }
        Ok(())
    }

    fn pair(&mut self, [x, y]: Place, between: &str) -> Result<(), Error> {
        self.number(x)?;
        self.raw(between)?;
        self.number(y)
    }

    fn number(&mut self, value: f64) -> Result<(), Error> {
        write_fixed(self.out, value, 2).map_err(full)
    }

    fn escaped(
        &mut self,
        write: impl FnOnce(&mut dyn fmt::Write) -> fmt::Result,
    ) -> Result<(), Error> {
        write(&mut Escaped(self.out)).map_err(full)
    }

    fn raw(&mut self, text: &str) -> Result<(), Error> {
        self.out.write_str(text).map_err(full)
    }
}

/// Draws a path of an [`Svg`]. It fails as that does.
pub struct Pen<'s, 'o> {
    svg: &'s mut Svg<'o>,
}

#[expect(clippy::missing_errors_doc, reason = "all fail as a picture does")]
impl Pen<'_, '_> {
    /// Begins a line.
    pub fn move_to(&mut self, to: Place) -> Result<(), Error> {
        self.step("M", to)
    }

    /// Goes on straight.
    pub fn line_to(&mut self, to: Place) -> Result<(), Error> {
        self.step("L", to)
    }

    /// Goes on along a circle of this radius, the shorter way and counter-clockwise.
    pub fn arc_to(&mut self, to: Place, radius: f64) -> Result<(), Error> {
        self.svg.raw("A")?;
        self.svg.pair([radius, radius], " ")?;
        self.svg.raw(" 0 0 0 ")?;
        self.svg.pair(to, " ")
    }

    /// Goes back to where the line began.
    pub fn close(&mut self) -> Result<(), Error> {
        self.svg.raw("Z")
    }

    /// A dot as large as the line is wide, if its ends are round.
    pub fn dot(&mut self, at: Place) -> Result<(), Error> {
        self.step("M", at)?;
        self.svg.raw("h0")
    }

    /// A small cross.
    pub fn cross(&mut self, [x, y]: Place) -> Result<(), Error> {
        self.step("M", [x - 3.5, y - 3.5])?;
        self.svg.raw("l7 7m0-7l-7 7")
    }

    fn step(&mut self, letter: &str, to: Place) -> Result<(), Error> {
        self.svg.raw(letter)?;
        self.svg.pair(to, " ")
    }
}

/// Writes a number with so many decimals, rounded; what is no number as zero.
///
/// # Errors
/// Those of `out`.
pub fn write_fixed(out: &mut dyn fmt::Write, value: f64, decimals: u32) -> fmt::Result {
    let unit = 10_u64.pow(decimals.min(15));
    let magnitude = Real::floor(Real::abs(value) * unit as f64 + 0.5) as u64;
    if value < 0.0 && magnitude > 0 {
        out.write_char('-')?;
    }
    // The unit is a power of ten, never zero.
    let whole = magnitude.checked_div(unit).unwrap_or_default();
    write!(out, "{whole}")?;
    let mut rest = magnitude.saturating_sub(whole.saturating_mul(unit));
    let mut next = unit;
    for place in 0..decimals.min(15) {
        if place == 0 {
            out.write_char('.')?;
        }
        next /= 10;
        let digit = rest.checked_div(next).unwrap_or_default();
        rest = rest.saturating_sub(digit.saturating_mul(next));
        out.write_char(char::from(b'0'.saturating_add(digit.min(9) as u8)))?;
    }
    Ok(())
}

/// Takes text and hands on what stands for it in SVG.
struct Escaped<'o>(&'o mut dyn fmt::Write);

impl fmt::Write for Escaped<'_> {
    fn write_str(&mut self, text: &str) -> fmt::Result {
        text.chars().try_for_each(|letter| match letter {
            '&' => self.0.write_str("&amp;"),
            '<' => self.0.write_str("&lt;"),
            '>' => self.0.write_str("&gt;"),
            other => self.0.write_char(other),
        })
    }
}

/// Breaks text into lines.
struct Lines<'o> {
    out: &'o mut dyn fmt::Write,
    /// Where a line starts to the right, and how far below the one before.
    start: Place,
    letters: usize,
    column: usize,
    count: u32,
}

/// How many lines a paragraph has.
pub(super) fn lines_of(
    letters: usize,
    write: impl FnOnce(&mut dyn fmt::Write) -> fmt::Result,
) -> Result<u32, Error> {
    let mut lines = Lines {
        out: &mut TextBuffer::new(&mut []),
        start: [0.0; 2],
        letters,
        column: 0,
        count: 1,
    };
    write(&mut lines).map_err(full)?;
    Ok(lines.count)
}

impl fmt::Write for Lines<'_> {
    fn write_str(&mut self, text: &str) -> fmt::Result {
        text.chars().try_for_each(|letter| {
            self.column = self.column.saturating_add(1);
            if letter == ' ' && self.column > self.letters {
                self.column = 0;
                let [x, line] = self.start;
                self.count = self.count.saturating_add(1);
                self.out.write_str("</tspan><tspan x=\"")?;
                write_fixed(self.out, x, 2)?;
                self.out.write_str("\" dy=\"")?;
                write_fixed(self.out, line, 2)?;
                return self.out.write_str("\">");
            }
            Escaped(self.out).write_char(letter)
        })
    }
}

fn full(_: fmt::Error) -> Error {
    Error::CapacityExceeded("the text of a picture")
}
