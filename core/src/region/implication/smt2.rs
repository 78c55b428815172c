//! The same questions as SMT-LIB 2 (Barrett, Fontaine and Tinelli 2017), for other provers.
//!
//! Numbers are reals, a sine and a cosine are a point of the unit circle, roots have squares.
//! What a region says that polynomials cannot is left open: "unsat" is a proof all the same.

use super::proof::{Margins, Proof};
use super::tape::{Corners, Node, Place, Ranges, range_of};
use super::{Obligation, ProofConfig, Region, check};
use crate::domain::{Domain, Range};
use crate::error::Error;
use crate::grammar::{Formula, Step};
use crate::real::Real;
use crate::region::program::Operand;
use crate::text::write_number;
use core::fmt;
use heapless::String;

/// Room for a number in decimal digits.
const DIGITS: usize = 40;

/// Sines are written in steps of one by this.
const DIGIT: f64 = 1e9;

const AN_ANGLE: Error = Error::InvalidArgument(
    "SMT-LIB has no angles between what moves; say it by coordinates, or prove it without",
);

impl Region {
    /// How many questions a specification is: one for each statement that it joins by `and`,
    /// and for each member of a group that this is about.
    ///
    /// # Errors
    /// [`Error::Mismatch`] for another domain; [`Error::CapacityExceeded`].
    pub fn question_count(&self, domain: &Domain<'_>) -> Result<usize, Error> {
        self.check_domain(domain)?;
        let mut count = 0;
        while Obligation::find(&self.formula, domain, count)?.is_some() {
            count += 1;
        }
        Ok(count)
    }

    /// Writes one of the questions of [`Region::implies`] as SMT-LIB 2: a prover such as z3
    /// answers `unsat` if the region satisfies this part of the specification in all instances
    /// in the ranges, up to the tolerance. Otherwise its model is a counterexample, if the
    /// angles that it stands for are in their ranges.
    ///
    /// `number` is below [`Region::question_count`] of the specification. Numbers are written
    /// as the shortest decimals, as one means them.
    ///
    /// # Errors
    /// Those of [`Region::implies`]; [`Error::InvalidArgument`] for a number that no question
    /// has, and for angles between what moves in the specification;
    /// [`Error::CapacityExceeded`] if `out` fails.
    pub fn write_smt2(
        &self,
        specification: &Region,
        domain: &Domain<'_>,
        ranges: &[[f64; 2]],
        (config, number): (ProofConfig, usize),
        out: &mut dyn fmt::Write,
    ) -> Result<(), Error> {
        check([self, specification], domain, ranges, config)?;
        let obligation = Obligation::find(&specification.formula, domain, number)?;
        let obligation = obligation.ok_or(Error::InvalidArgument(
            "the specification has no question of this number",
        ))?;
        let regions = [self, specification];
        let given = (ranges, config.tolerance);
        let mut proof = Proof::new(regions, domain, given, &obligation, &mut []);
        proof.write()?;
        let mut script = Script { out, proof: &proof };
        script.write(number)
    }
}

/// What is written.
struct Script<'s, 'p> {
    out: &'s mut dyn fmt::Write,
    proof: &'s Proof<'p>,
}

impl Script<'_, '_> {
    fn write(&mut self, number: usize) -> Result<(), Error> {
        self.comments(number).map_err(full)?;
        let Some(corners) = self.proof.corners() else {
            let nobody = "; The member that this is about is never there.\n(assert false)\n";
            return self.raw(nobody).and_then(|()| self.raw("(check-sat)\n"));
        };
        let mut ranges = Ranges::new();
        // Where a term cannot be in its range there is no sample, which the prover finds.
        let _ = self.proof.tape.evaluate(&corners, &mut ranges);
        if !self.proof.tape.has_sizes(&ranges) {
            return Err(super::proof::NO_SIZE);
        }
        let needed = self.proof.tape.needed(self.proof.margins());
        for (place, node) in (0..).zip(&self.proof.tape.nodes) {
            if needed.get(usize::from(place)) == Some(&true) {
                self.node(place, *node, &corners, &ranges)?;
            }
        }
        let region = self.proof.region.formula();
        let statement = &self.proof.obligation.formula;
        self.formula("r", region, &self.proof.of_region, 0.0)?;
        self.formula(
            "s",
            statement,
            &self.proof.of_statement,
            self.proof.tolerance,
        )?;
        self.raw("(assert r)\n(assert (not s))\n(check-sat)\n")
    }

    fn comments(&mut self, number: usize) -> fmt::Result {
        let domain = self.proof.domain;
        write!(self.out, "; Question {number}: does\n;   ")?;
        self.proof.region.formula().write(domain, self.out)?;
        self.out.write_str("\n; imply\n;   ")?;
        self.proof.obligation.formula.write(domain, self.out)?;
        if let Some(member) = self.proof.obligation.member {
            write!(self.out, "\n; of member {} of its group", member.index)?;
        }
        self.out.write_str("? unsat: yes.\n(set-logic QF_NRA)\n")
    }

    fn raw(&mut self, text: &str) -> Result<(), Error> {
        self.out.write_str(text).map_err(full)
    }

    /// Declares or defines what a node is.
    fn node(
        &mut self,
        place: Place,
        node: Node,
        corners: &Corners,
        ranges: &Ranges,
    ) -> Result<(), Error> {
        let own = range_of(ranges, place);
        match node {
            Node::Number(number) => {
                self.begin(place)?;
                self.number(number)?;
                self.raw(")\n")
            }
            Node::Variable(index) => {
                self.variable(usize::from(index))?;
                let known = corners.get(usize::from(index)).copied().unwrap_or(own);
                self.begin(place)?;
                self.name(usize::from(index))?;
                self.raw(")\n")?;
                self.between(place, known)
            }
            Node::Sum(a, b) => self.define(place, "(+", &[a, b]),
            Node::Difference(a, b) => self.define(place, "(-", &[a, b]),
            Node::Product(a, b) => self.define(place, "(*", &[a, b]),
            Node::Square(a) => self.define(place, "(*", &[a, a]),
            Node::Magnitude(a) => {
                self.begin(place)?;
                writeln!(self.out, "(ite (>= t{a} 0.0) t{a} (- t{a})))").map_err(full)
            }
            Node::Least(a, b) => self.choose(place, "<=", [a, b]),
            Node::Greatest(a, b) => self.choose(place, ">=", [a, b]),
            Node::Root(a) => {
                self.declare(place)?;
                self.between(
                    place,
                    Range {
                        low: 0.0,
                        high: f64::INFINITY,
                    },
                )?;
                self.raw("(assert (= ")?;
                self.define_inline("(*", &[place, place])?;
                writeln!(self.out, " t{a}))").map_err(full)
            }
            Node::Sine(a) | Node::Cosine(a) if is_fixed(range_of(ranges, a)) => {
                self.begin(place)?;
                self.number(snapped(own.low + 0.5 * (own.high - own.low)))?;
                self.raw(")\n")
            }
            // The cosine follows its sine.
            Node::Sine(_) => self
                .declare(place)
                .and_then(|()| self.between(place, loose(own))),
            Node::Cosine(_) => {
                self.declare(place)?;
                self.between(place, loose(own))?;
                let sine = place.saturating_sub(1);
                self.raw("(assert (= (+")?;
                for term in [sine, place] {
                    self.raw(" ")?;
                    self.define_inline("(*", &[term, term])?;
                }
                self.raw(") 1.0))\n")
            }
            Node::ArcTangent(..) if place < self.proof.statement_end => Err(AN_ANGLE),
            // Any number that it can be.
            Node::ArcTangent(..) | Node::Extreme(..) | Node::Slack(_) => {
                self.declare(place)?;
                self.between(place, own)
            }
            Node::Cut(_, a) => self.define(place, "(+ 0.0", &[a]),
        }
    }

    fn begin(&mut self, place: Place) -> Result<(), Error> {
        write!(self.out, "(define-fun t{place} () Real ").map_err(full)
    }

    fn define(&mut self, place: Place, operation: &str, of: &[Place]) -> Result<(), Error> {
        self.begin(place)?;
        self.define_inline(operation, of)?;
        self.raw(")\n")
    }

    fn define_inline(&mut self, operation: &str, of: &[Place]) -> Result<(), Error> {
        self.raw(operation)?;
        for operand in of {
            write!(self.out, " t{operand}").map_err(full)?;
        }
        self.raw(")")
    }

    /// Defines a node as one of two terms.
    fn choose(&mut self, place: Place, comparison: &str, [a, b]: [Place; 2]) -> Result<(), Error> {
        self.begin(place)?;
        writeln!(self.out, "(ite ({comparison} t{a} t{b}) t{a} t{b}))").map_err(full)
    }

    fn declare(&mut self, place: Place) -> Result<(), Error> {
        writeln!(self.out, "(declare-const t{place} Real)").map_err(full)
    }

    /// Asserts that a node is in a range.
    fn between(&mut self, place: Place, own: Range<f64>) -> Result<(), Error> {
        for (end, comparison) in [(own.low, ">="), (own.high, "<=")] {
            if end.is_finite() {
                write!(self.out, "(assert ({comparison} t{place} ").map_err(full)?;
                self.number(end)?;
                self.raw("))\n")?;
            }
        }
        Ok(())
    }

    fn variable(&mut self, index: usize) -> Result<(), Error> {
        self.raw("(declare-const ")?;
        self.name(index)?;
        self.raw(" Real)\n")
    }

    /// The name of a number of the instance or of a parameter, as the domain has it.
    fn name(&mut self, index: usize) -> Result<(), Error> {
        let domain = self.proof.domain;
        match self.proof.tape.variables.get(index) {
            Some(Operand::Slot(slot)) => {
                let missing = Error::InvalidArgument("a number of the instance is not there");
                let (object, attribute) = domain.slot(*slot).ok_or(missing)?;
                let written = match object.member {
                    Some(member) => write!(self.out, "|{}[{}].", object.name, member.index),
                    None => write!(self.out, "|{}.", object.name),
                };
                written.map_err(full)?;
                self.raw(attribute.name)?;
                self.raw("|")
            }
            Some(Operand::Theta(parameter)) => {
                let parameter = domain.parameters().get(usize::from(*parameter));
                let name = parameter.map_or("", |parameter| parameter.name);
                self.raw("|")?;
                self.raw(name)?;
                self.raw("|")
            }
            _ => self.raw("0.0"),
        }
    }

    /// A number as an exact decimal.
    fn number(&mut self, number: f64) -> Result<(), Error> {
        let mut digits: String<DIGITS> = String::new();
        write_number(&mut digits, number.abs()).map_err(full)?;
        if number < 0.0 {
            self.raw("(- ")?;
        }
        let place = digits.bytes().position(|byte| byte == b'e');
        let mantissa = digits
            .get(..place.unwrap_or(digits.len()))
            .unwrap_or_default();
        let power = place
            .and_then(|place| digits.get(place + 1..))
            .unwrap_or("0");
        let power: i32 = decimal(power);
        match power {
            0 => {}
            ..0 => self.raw("(/ ")?,
            _ => self.raw("(* ")?,
        }
        self.raw(mantissa)?;
        if !mantissa.contains('.') {
            self.raw(".0")?;
        }
        if power != 0 {
            self.raw(" 1")?;
            for _ in 0..power.unsigned_abs() {
                self.raw("0")?;
            }
            self.raw(".0)")?;
        }
        self.raw(if number < 0.0 { ")" } else { "" })
    }

    /// Defines a formula, step by step, up to a tolerance.
    fn formula(
        &mut self,
        name: &str,
        formula: &Formula,
        margins: &Margins,
        tolerance: f64,
    ) -> Result<(), Error> {
        let last = formula.fold(|index, step, operands| {
            let operator = match step {
                Step::Constraint(own) => {
                    self.constraint((name, index), formula, (own, margins), tolerance)?;
                    return Ok(index);
                }
                Step::Not => "(not",
                Step::And => "(and",
                Step::Or => "(or",
                Step::True => "(and true",
            };
            write!(self.out, "(define-fun {name}{index} () Bool ").map_err(full)?;
            self.raw(operator)?;
            for operand in operands.into_iter().flatten() {
                write!(self.out, " {name}{operand}").map_err(full)?;
            }
            self.raw("))\n")?;
            Ok(index)
        })?;
        match last {
            Some(last) => writeln!(self.out, "(define-fun {name} () Bool {name}{last})"),
            None => writeln!(self.out, "(define-fun {name} () Bool true)"),
        }
        .map_err(full)
    }

    /// Says what follows from a constraint, or, of a statement, what it is.
    fn constraint(
        &mut self,
        (name, index): (&str, usize),
        formula: &Formula,
        (own, margins): (u8, &Margins),
        tolerance: f64,
    ) -> Result<(), Error> {
        let constraint = formula.constraints().get(usize::from(own));
        let comparison = match constraint {
            Some(own) if own.comparison.admits_equal() || tolerance > 0.0 => "<=",
            _ => "<",
        };
        let is_statement = tolerance > 0.0;
        let margin = margins.get(usize::from(own)).copied().flatten();
        let in_part = !is_statement && self.proof.in_part >> own & 1 == 1;
        let Some(margin) = margin else {
            return writeln!(self.out, "(declare-const {name}{index} Bool)").map_err(full);
        };
        if in_part {
            writeln!(self.out, "(declare-const {name}{index} Bool)").map_err(full)?;
            write!(self.out, "(assert (=> {name}{index} ").map_err(full)?;
        } else {
            write!(self.out, "(define-fun {name}{index} () Bool ").map_err(full)?;
        }
        write!(self.out, "({comparison} t{margin} ").map_err(full)?;
        self.number(tolerance)?;
        self.raw(if in_part { ")))\n" } else { "))\n" })
    }
}

/// Whether there is one number in a range.
fn is_fixed(own: Range<f64>) -> bool {
    own.low == own.high
}

/// A sine or cosine as one means it: that of half of pi is one.
fn snapped(number: f64) -> f64 {
    Real::floor(number * DIGIT + 0.5) / DIGIT
}

/// A range of sines in few digits, that is no narrower but for what [`snapped`] leaves out.
fn loose(own: Range<f64>) -> Range<f64> {
    let end = |end: f64, outward: f64| match (end - snapped(end)).abs() * DIGIT < 0.01 {
        true => snapped(end),
        false => snapped(end + outward),
    };
    let (low, high) = (end(own.low, -1.0 / DIGIT), end(own.high, 1.0 / DIGIT));
    Range {
        low: if low <= -1.0 { -f64::INFINITY } else { low },
        high: if high >= 1.0 { f64::INFINITY } else { high },
    }
}

/// A whole number, as the writer of numbers writes it.
fn decimal(text: &str) -> i32 {
    let digits = text.trim_start_matches('-');
    let whole = digits.bytes().fold(0i32, |whole, byte| {
        whole
            .saturating_mul(10)
            .saturating_add(i32::from(byte.saturating_sub(b'0')))
    });
    if text.starts_with('-') { -whole } else { whole }
}

fn full(_: fmt::Error) -> Error {
    Error::CapacityExceeded("the text of a question for a prover")
}
