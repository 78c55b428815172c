//! A region as C that needs no library: straight-line code, without tables or parsers.
//!
//! | file | content |
//! |---|---|
//! | `code.rs` | constants of C, each computed from those before it |
//! | `begin.c`, `sine.c`, `cut.c`, `sample.c`, `draw.c` | what is the same for every region |
//!
//! What is computed is what a scene and its samples compute, in the same order of
//! operations, so that the answers are the same to the last bit.

mod code;

use crate::domain::{Domain, MAX_PARAMETERS, Node};
use crate::error::Error;
use crate::grammar::{Comparison, Constraint, MAX_FORMULA_STEPS, Step};
use crate::region::Region;
use crate::region::program::{NOT_STRAIGHT, Operand, Places, Program, Term, Value};
use code::Code;
use core::fmt;
use heapless::Vec;

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
        self.check_domain(domain)?;
        if !is_name(name) {
            return Err(Error::InvalidArgument(
                "a name in C has up to 64 letters, digits and _, and begins with no digit",
            ));
        }
        let export = Export {
            region: self,
            domain,
            name,
        };
        // What has no closed form is only found out on the way.
        let is_cut = domain.parameters().len() == 1 && export.cuts(&mut Nowhere).is_ok();
        export.begin(out, is_cut)?;
        export.holds(out)?;
        export.contains(out)?;
        export.margins(out)?;
        if is_cut {
            Code::new(out, name).text(include_str!("cut.c"))?;
            export.cuts(out)?;
            Code::new(out, name).text(include_str!("draw.c"))?;
        }
        Code::new(out, name).raw("\n#endif\n")
    }
}

/// A region to be written.
struct Export<'r> {
    region: &'r Region,
    domain: &'r Domain<'r>,
    name: &'r str,
}

/// The beginning of a function.
const ARGUMENTS: &str = "(const @_real *instance, const @_real *theta";
const UNUSED: &str = "    (void)instance, (void)theta;\n";

impl Export<'_> {
    fn begin(&self, out: &mut dyn fmt::Write, is_cut: bool) -> Result<(), Error> {
        let mut code = Code::new(out, self.name);
        code.raw("/* ")?;
        code.written(|out| self.region.write(self.domain, out))?;
        code.text("\n *\n * Made by critreg. @_contains: whether parameters are inside.\n")?;
        code.text(" * @_margins: at most 0 where a constraint holds, and derivatives.\n")?;
        if is_cut {
            code.text(" * @_intervals, @_sample: all that is inside, and a draw from it.\n")?;
        } else {
            code.text(
                " * There is no @_intervals and no @_sample: more than one parameter, or a\n",
            )?;
            code.raw(" * constraint without a closed form that is written as C.\n")?;
        }
        code.raw(" *\n * An instance is, in this order:")?;
        for (object, attribute) in self.domain.slots() {
            code.raw(" ")?;
            code.raw(object.name)?;
            code.raw(".")?;
            code.raw(attribute.name)?;
        }
        code.raw("\n */\n")?;
        code.text(include_str!("begin.c"))?;
        let constraints = self.constraints().len();
        let counts = [
            ("CONSTRAINTS", constraints.max(1)),
            ("MAX_INTERVALS", 2 * constraints + 2),
        ];
        for (what, count) in counts {
            code.text("#define @_")?;
            code.raw(what)?;
            code.raw(" ")?;
            code.whole(count)?;
            code.raw("\n")?;
        }
        code.text(include_str!("sine.c"))
    }

    fn constraints(&self) -> &[Constraint] {
        self.region.formula().constraints()
    }

    fn nodes(&self) -> &[Node] {
        self.region.formula().nodes()
    }

    /// What follows from which constraints hold, a bit each.
    fn holds(&self, out: &mut dyn fmt::Write) -> Result<(), Error> {
        let mut code = Code::new(out, self.name);
        code.raw("\n/* Whether the region has what satisfies these constraints, a bit each. */\n")?;
        code.text("static inline int @_holds(unsigned long constraints)\n{\n")?;
        code.raw("    (void)constraints;\n")?;
        let mut stack: Vec<usize, MAX_FORMULA_STEPS> = Vec::new();
        let missing = Error::InvalidArgument("the steps of a formula do not fit together");
        for (number, step) in self.region.formula().steps().iter().enumerate() {
            let mut pop = || stack.pop().ok_or(missing);
            let (operator, operands) = match step {
                Step::Constraint(_) | Step::True => ("", [None, None]),
                Step::Not => ("!", [None, Some(pop()?)]),
                Step::And => (" & ", [Some(pop()?), Some(pop()?)]),
                Step::Or => (" | ", [Some(pop()?), Some(pop()?)]),
            };
            code.raw("    const int b")?;
            code.whole(number)?;
            code.raw(" = ")?;
            match step {
                Step::Constraint(index) => {
                    code.raw("(int)(constraints >> ")?;
                    code.whole(usize::from(*index))?;
                    code.raw(" & 1)")?;
                }
                Step::True => code.raw("1")?,
                Step::Not | Step::And | Step::Or => {
                    let [right, left] = operands;
                    if let Some(own) = right {
                        code.raw("b")?;
                        code.whole(own)?;
                    }
                    code.raw(operator)?;
                    if let Some(own) = left {
                        code.raw("b")?;
                        code.whole(own)?;
                    }
                }
            }
            code.raw(";\n")?;
            stack.push(number).map_err(|_| missing)?;
        }
        code.raw("    return ")?;
        match stack.pop() {
            Some(last) => {
                code.raw("b")?;
                code.whole(last)?;
            }
            None => code.raw("1")?,
        }
        code.raw(";\n}\n")
    }

    fn contains(&self, out: &mut dyn fmt::Write) -> Result<(), Error> {
        let mut code = Code::new(out, self.name);
        code.raw("\n/* Whether parameters are inside. */\n")?;
        code.text("static inline int @_contains")?;
        code.text(ARGUMENTS)?;
        code.raw(")\n{\n    unsigned long holds = 0;\n    int inside = 1;\n")?;
        code.raw(UNUSED)?;
        for (index, parameter) in (0u8..).zip(self.domain.parameters()) {
            let ends = [code.number(parameter.low)?, code.number(parameter.high)?];
            let [low, high] = ends;
            let theta = Operand::Theta(index);
            code.raw("    inside &= ")?;
            code.operand(low)?;
            code.raw(" <= ")?;
            code.operand(theta)?;
            code.raw(" && ")?;
            code.operand(theta)?;
            code.raw(" <= ")?;
            code.operand(high)?;
            code.raw(";\n")?;
        }
        let mut places = Places::new(self.domain, code, self.moving(false), false);
        for (index, constraint) in self.constraints().iter().enumerate() {
            let left = places.term(self.nodes(), constraint.lhs)?.line.value;
            let right = places.term(self.nodes(), constraint.rhs)?.line.value;
            let code = &mut places.code;
            code.raw("    holds |= (unsigned long)(")?;
            code.operand(left)?;
            code.raw(" ")?;
            code.raw(constraint.comparison.symbol())?;
            code.raw(" ")?;
            code.operand(right)?;
            code.raw(") << ")?;
            code.whole(index)?;
            code.raw(";\n")?;
        }
        places
            .code
            .text("    return inside && @_holds(holds);\n}\n")
    }

    fn margins(&self, out: &mut dyn fmt::Write) -> Result<(), Error> {
        let mut code = Code::new(out, self.name);
        code.raw(
            "\n/* How far each constraint is from its bound, at most 0 where it holds, and its\n",
        )?;
        code.raw(" * derivatives by the parameters, those of the first constraint first. */\n")?;
        code.text("static inline void @_margins")?;
        code.text(ARGUMENTS)?;
        code.text(",\n    @_real *values, @_real *gradients)\n{\n")?;
        code.raw(UNUSED)?;
        code.raw("    (void)values, (void)gradients;\n")?;
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
            code.raw("    values[")?;
            code.whole(index)?;
            code.raw("] = ")?;
            // Two extremes over nothing are equal, though their difference is no number.
            if margin.value == Operand::Zero {
                code.operand(margin.value)?;
            } else {
                for part in [" == ", " ? 0 : "] {
                    let own = if part == " == " { less } else { more };
                    code.operand(own.value)?;
                    code.raw(part)?;
                }
                code.operand(margin.value)?;
            }
            code.raw(";\n")?;
            for (parameter, slope) in margin.slopes.iter().enumerate().take(count) {
                code.raw("    gradients[")?;
                code.whole(index * count + parameter)?;
                code.raw("] = ")?;
                if *slope != Operand::Zero && self.has_extremes() {
                    // What is infinite does not change.
                    code.operand(margin.value)?;
                    code.raw(" - ")?;
                    code.operand(margin.value)?;
                    code.raw(" == 0 ? ")?;
                    code.operand(*slope)?;
                    code.raw(" : 0;\n")?;
                } else {
                    code.operand(*slope)?;
                    code.raw(";\n")?;
                }
            }
        }
        places.code.raw("}\n")
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
        let mut code = Code::new(out, self.name);
        code.text(include_str!("sample.c"))?;
        let mut theta = [Value::ZERO; MAX_PARAMETERS];
        if let [first, ..] = &mut theta
            && let [slope, ..] = &mut first.slopes
        {
            *slope = Operand::One;
        }
        let [parameter] = self.domain.parameters() else {
            return Err(NOT_STRAIGHT);
        };
        let ends = [code.number(parameter.low)?, code.number(parameter.high)?];
        let mut places = Places::new(self.domain, code, theta, true);
        for (index, constraint) in self.constraints().iter().enumerate() {
            let left = places.term(self.nodes(), constraint.lhs)?;
            let right = places.term(self.nodes(), constraint.rhs)?;
            let curve = places.difference(left, right)?;
            write_cut(&mut places.code, index, constraint.comparison, &curve, ends)?;
        }
        let [low, high] = ends;
        let code = &mut places.code;
        code.text("    return @_join(&cut, ")?;
        code.operand(low)?;
        code.raw(", ")?;
        code.operand(high)?;
        code.raw(", ends);\n}\n")
    }
}

/// Cuts the line at the roots of one constraint.
fn write_cut(
    code: &mut Code<'_>,
    index: usize,
    comparison: Comparison,
    curve: &Term,
    ends: [Operand; 2],
) -> Result<(), Error> {
    let slope = |value: &Value| {
        let [slope, ..] = value.slopes;
        slope
    };
    let (factor, vector) = curve.bend.unwrap_or((Operand::Zero, [Value::ZERO; 3]));
    let line = [curve.line.value, slope(&curve.line), factor];
    code.text("    {\n        @_real c[9] = {")?;
    for operand in line {
        code.operand(operand)?;
        code.raw(", ")?;
    }
    for value in vector {
        code.operand(value.value)?;
        code.raw(", ")?;
        code.operand(slope(&value))?;
        code.raw(", ")?;
    }
    code.text("};\n        @_cut_by(&cut, ")?;
    code.whole(index)?;
    code.raw(", ")?;
    code.whole(comparison as usize)?;
    code.raw(", c")?;
    for end in ends {
        code.raw(", ")?;
        code.operand(end)?;
    }
    code.raw(");\n    }\n")
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

/// Takes any text.
struct Nowhere;

impl fmt::Write for Nowhere {
    fn write_str(&mut self, _: &str) -> fmt::Result {
        Ok(())
    }
}
