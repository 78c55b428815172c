//! A region as code that needs no library: straight lines of C or Rust, without tables or
//! parsers.
//!
//! | file | content |
//! |---|---|
//! | `phrases.rs`, `c/`, `rust/` | what the languages say differently, and what is the same for every region |
//! | `code.rs` | constants, each computed from those before it |
//!
//! What is computed is what a scene and its samples compute, in the same order of
//! operations, so that the answers are the same to the last bit.

mod code;
mod phrases;

use super::lifted::Region;
use super::program::{NOT_STRAIGHT, Operand, Places, Program, Term, Value};
use crate::domain::{Domain, MAX_PARAMETERS, Node};
use crate::error::Error;
use crate::grammar::{Constraint, Step};
use crate::real::Real;
use crate::text::TextBuffer;
use code::{Code, Part};
use core::fmt;
use phrases::Phrases;

/// Longest name of what is written as C.
const LONGEST_NAME: usize = 64;

impl Region {
    /// Writes the region as C99 (and C++): a header without a library behind it, whose
    /// functions begin with `name`.
    ///
    /// `name_contains` is whether parameters are inside, `name_margins` the
    /// [margins](Region::margins) with gradients. For an action with one parameter whose
    /// constraints have a closed form, `name_intervals` and `name_sample` are there as
    /// well; a comment says so where they are not.
    ///
    /// # Errors
    /// [`Error::InvalidArgument`] for a name that is none in C, and for a region about
    /// relations between bodies or angles with a symmetry, which are too much to be
    /// written out; [`Error::Mismatch`] for another domain; [`Error::CapacityExceeded`] if
    /// `out` fails.
    pub fn write_c(
        &self,
        domain: &Domain<'_>,
        name: &str,
        out: &mut dyn fmt::Write,
    ) -> Result<(), Error> {
        if !is_name(name) {
            return Err(Error::InvalidArgument(
                "a name in C has up to 64 letters, digits and _, and begins with no digit",
            ));
        }
        self.write_code(domain, &phrases::C, name, out)
    }

    /// Writes the region as a module of Rust that needs the crate `libm` only, and neither a
    /// heap nor std: `contains`, `margins`, `intervals` and `sample`, as [`Region::write_c`].
    /// It computes with `f64` or `f32`.
    ///
    /// ```
    /// use critreg::{domain::Domain, region::Region};
    /// let domain = Domain::parse("object wall { x: length } parameter reach in [0, 4]: length")?;
    /// let region = Region::parse(&domain, "reach <= wall.x")?;
    /// let mut module = String::new();
    /// region.write_rust::<f32>(&domain, &mut module)?;
    /// assert!(module.contains("pub type Real = f32;"));
    /// # Ok::<(), critreg::Error>(())
    /// ```
    ///
    /// # Errors
    /// Those of [`Region::write_c`], apart from names.
    pub fn write_rust<R: Real>(
        &self,
        domain: &Domain<'_>,
        out: &mut dyn fmt::Write,
    ) -> Result<(), Error> {
        let phrases = match R::BITS {
            64 => &phrases::RUST_F64,
            _ => &phrases::RUST_F32,
        };
        self.write_code(domain, phrases, "", out)
    }

    fn write_code(
        &self,
        domain: &Domain<'_>,
        phrases: &'static Phrases,
        name: &str,
        out: &mut dyn fmt::Write,
    ) -> Result<(), Error> {
        self.check_domain(domain)?;
        let export = Export {
            region: self,
            domain,
            phrases,
            name,
        };
        // What has no closed form is only found out on the way.
        let mut nowhere = TextBuffer::new(&mut []);
        let is_cut = domain.parameters().len() == 1 && export.cuts(&mut nowhere).is_ok();
        export.begin(out, is_cut)?;
        export.holds(out)?;
        export.contains(out)?;
        export.margins(out)?;
        if is_cut {
            export.cuts(out)?;
            export.code(out).say(phrases.drawing, &[])?;
        }
        export.code(out).say(phrases.end, &[])
    }
}

/// A region to be written.
struct Export<'r> {
    region: &'r Region,
    domain: &'r Domain<'r>,
    phrases: &'static Phrases,
    name: &'r str,
}

impl Export<'_> {
    fn code<'o>(&'o self, out: &'o mut dyn fmt::Write) -> Code<'o> {
        Code::new(out, self.phrases, self.name)
    }

    fn begin(&self, out: &mut dyn fmt::Write, is_cut: bool) -> Result<(), Error> {
        let mut code = self.code(out);
        let [first, line, end] = self.phrases.comment;
        code.raw(first)?;
        code.written(|out| self.region.write(self.domain, out))?;
        let always = [
            "",
            " Made by critreg. @_contains: whether parameters are inside.",
            " @_margins: at most 0 where a constraint holds, and derivatives.",
        ];
        let drawn = [" @_intervals, @_sample: all that is inside, and a draw from it."];
        let not_drawn = [
            " There is no @_intervals and no @_sample: more than one parameter, or a",
            " constraint without a closed form that is written as code.",
        ];
        let more: &[&str] = if is_cut { &drawn } else { &not_drawn };
        let order = ["", " An instance is, in this order:"];
        for words in always.iter().chain(more).chain(&order) {
            code.raw("\n")?;
            code.raw(line)?;
            code.say(words, &[])?;
        }
        for (object, attribute) in self.domain.slots() {
            code.say(" $a.$b", &[object.name.into(), attribute.name.into()])?;
        }
        code.raw("\n")?;
        code.raw(end)?;
        code.say(self.phrases.begin, &[])?;
        let constraints = self.constraints().len();
        let counts = [
            ("INSTANCE_LEN", self.domain.instance_len()),
            ("PARAMETERS", self.domain.parameters().len()),
            ("CONSTRAINTS", constraints),
            ("MAX_INTERVALS", 2 * constraints + 2),
        ];
        for (name, count) in counts {
            code.say(self.phrases.count, &[name.into(), count.into()])?;
        }
        code.say(self.phrases.sines, &[])
    }

    fn constraints(&self) -> &[Constraint] {
        self.region.formula().constraints()
    }

    fn nodes(&self) -> &[Node] {
        self.region.formula().nodes()
    }

    /// What follows from which constraints hold, a bit each.
    fn holds(&self, out: &mut dyn fmt::Write) -> Result<(), Error> {
        let (mut code, phrases) = (self.code(out), self.phrases);
        code.say(phrases.holds_begin, &[])?;
        let last = self.region.formula().fold(|number, step, operands| {
            let parts = operands.map(|own: Option<usize>| Part::Whole(own.unwrap_or_default()));
            let [left, right] = parts;
            code.say(phrases.step, &[number.into()])?;
            match step {
                Step::Constraint(index) => {
                    code.say(phrases.bit, &[usize::from(index).into()])?;
                }
                Step::True => code.raw(phrases.truth)?,
                Step::Not => code.say("!b$a", &[right])?,
                Step::And => code.say("b$a & b$b", &[right, left])?,
                Step::Or => code.say("b$a | b$b", &[right, left])?,
            }
            code.raw(";\n")?;
            Ok(number)
        })?;
        let [begin, end] = phrases.holds_end;
        code.raw(begin)?;
        match last {
            Some(last) => code.say("b$a", &[last.into()])?,
            None => code.raw(phrases.truth)?,
        }
        code.raw(end)
    }

    fn contains(&self, out: &mut dyn fmt::Write) -> Result<(), Error> {
        let (mut code, phrases) = (self.code(out), self.phrases);
        code.say(phrases.contains_begin, &[])?;
        for (index, parameter) in (0u8..).zip(self.domain.parameters()) {
            let [low, high] = [code.number(parameter.low)?, code.number(parameter.high)?];
            let parts = [low, Operand::Theta(index), high].map(Part::Operand);
            code.say("    inside &= $a <= $b && $b <= $c;\n", &parts)?;
        }
        let mut places = Places::new(self.domain, code, self.moving(false), false);
        for (index, constraint) in self.constraints().iter().enumerate() {
            let left = places.term(self.nodes(), constraint.lhs)?.line.value;
            let right = places.term(self.nodes(), constraint.rhs)?.line.value;
            let symbol = constraint.comparison.symbol();
            let parts = [left.into(), symbol.into(), right.into(), index.into()];
            places.code.say(phrases.met, &parts)?;
        }
        places.code.say(phrases.contains_end, &[])
    }

    fn margins(&self, out: &mut dyn fmt::Write) -> Result<(), Error> {
        let (mut code, phrases) = (self.code(out), self.phrases);
        code.say(phrases.margins_begin, &[])?;
        let count = self.domain.parameters().len();
        let mut places = Places::new(self.domain, code, self.moving(true), false);
        for (index, constraint) in self.constraints().iter().enumerate() {
            let left = places.term(self.nodes(), constraint.lhs)?;
            let right = places.term(self.nodes(), constraint.rhs)?;
            let [less, more] = match constraint.comparison.is_upper() {
                true => [left.line, right.line],
                false => [right.line, left.line],
            };
            let margin = places.code.minus(less, more)?;
            let code = &mut places.code;
            code.say("    values[$a] = ", &[index.into()])?;
            // Two extremes over nothing are equal, though their difference is no number.
            let template = match margin.value {
                Operand::Zero => "$c",
                _ => phrases.margin,
            };
            let parts = [less.value, more.value, margin.value].map(Part::Operand);
            code.say(template, &parts)?;
            code.raw(";\n")?;
            for (parameter, slope) in margin.slopes.iter().enumerate().take(count) {
                let place = [index, parameter, index * count + parameter];
                code.say(phrases.gradient, &place.map(Part::Whole))?;
                // What is infinite does not change.
                let template = match *slope != Operand::Zero && self.has_extremes() {
                    true => phrases.slope,
                    false => "$b",
                };
                code.say(template, &[margin.value, *slope].map(Part::Operand))?;
                code.raw(";\n")?;
            }
        }
        places.code.say(phrases.margins_end, &[])
    }

    fn has_extremes(&self) -> bool {
        let mut nodes = self.nodes().iter();
        nodes.any(|node| matches!(node, Node::Extreme(..)))
    }

    /// The parameters; with derivatives by themselves, if wanted.
    fn moving(&self, differentiated: bool) -> [Value; MAX_PARAMETERS] {
        let mut theta = [Value::ZERO; MAX_PARAMETERS];
        for (index, own) in (0u8..).zip(theta.iter_mut()) {
            own.value = Operand::Theta(index);
            if differentiated && let Some(slope) = own.slopes.get_mut(usize::from(index)) {
                *slope = Operand::One;
            }
        }
        theta
    }

    /// Cuts the line of the only parameter at the roots of all constraints.
    fn cuts(&self, out: &mut dyn fmt::Write) -> Result<(), Error> {
        let (mut code, phrases) = (self.code(out), self.phrases);
        code.say(phrases.cutting, &[])?;
        let mut theta = [Value::ZERO; MAX_PARAMETERS];
        if let [first, ..] = &mut theta
            && let [slope, ..] = &mut first.slopes
        {
            *slope = Operand::One;
        }
        let [parameter] = self.domain.parameters() else {
            return Err(NOT_STRAIGHT);
        };
        let [low, high] = [code.number(parameter.low)?, code.number(parameter.high)?];
        let mut places = Places::new(self.domain, code, theta, true);
        for (index, constraint) in self.constraints().iter().enumerate() {
            let left = places.term(self.nodes(), constraint.lhs)?;
            let right = places.term(self.nodes(), constraint.rhs)?;
            let [a, b, c, d, e, f, g, h, i] = numbers(&places.difference(left, right)?);
            let (owner, sign) = (index.into(), (constraint.comparison as usize).into());
            let parts = [
                a,
                b,
                c,
                d,
                e,
                f,
                g,
                h,
                i,
                owner,
                sign,
                low.into(),
                high.into(),
            ];
            places.code.say(phrases.cut, &parts)?;
        }
        let parts = [low, high].map(Part::Operand);
        places.code.say(phrases.cutting_end, &parts)
    }
}

/// What a curve is made of: a line, a factor, and a vector whose parts are lines.
fn numbers(curve: &Term) -> [Part<'static>; 9] {
    let of = |value: &Value| {
        let [slope, ..] = value.slopes;
        [value.value, slope]
    };
    let (factor, vector) = curve.bend.unwrap_or((Operand::Zero, [Value::ZERO; 3]));
    let [[c, d], [e, f], [g, h]] = vector.map(|own| of(&own));
    let [a, b] = of(&curve.line);
    [a, b, factor, c, d, e, f, g, h].map(Part::Operand)
}

fn is_name(name: &str) -> bool {
    let letter = |byte: u8| byte.is_ascii_alphabetic() || byte == b'_';
    let first = name.bytes().next();
    name.len() <= LONGEST_NAME
        && first.is_some_and(letter)
        && name
            .bytes()
            .all(|byte| letter(byte) || byte.is_ascii_digit())
}
