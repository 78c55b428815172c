//! Constraints joined by `and`, `or` and `not` (thesis 4.2), and their text.

mod comparison;
mod conjuncts;
mod literals;
mod parser;
mod robustness;
mod writer;

pub use comparison::Comparison;
pub use conjuncts::Conjunct;

use crate::domain::{Node, NodeId, copy, intern};
use crate::error::Error;
use core::fmt;
use heapless::Vec;

/// Most constraints in a formula.
pub const MAX_CONSTRAINTS: usize = 32;
/// Most terms in the expressions of a formula together.
pub const MAX_FORMULA_NODES: usize = 160;
/// Most constraints and connectives in a formula together.
pub const MAX_FORMULA_STEPS: usize = 96;

/// `left comparison right`, with an optional name for the right side.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Constraint {
    /// Left side, in the formula's nodes.
    pub lhs: NodeId,
    /// How the sides are compared.
    pub comparison: Comparison,
    /// Right side, in the formula's nodes.
    pub rhs: NodeId,
    /// What the right side is in terms of the domain's constants.
    pub name: Option<NodeId>,
}

/// A constraint to be: its terms are not yet in a formula.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Inequality {
    /// Left side.
    pub lhs: NodeId,
    /// How the sides are compared.
    pub comparison: Comparison,
    /// Right side.
    pub bound: f64,
    /// What the right side is in terms of the domain's constants.
    pub name: Option<NodeId>,
}

/// A step of a formula in postfix order.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Step {
    /// Pushes the truth of a constraint, by its index.
    Constraint(u8),
    /// Pushes true.
    True,
    /// Replaces the top by its opposite.
    Not,
    /// Replaces the two topmost by whether both hold.
    And,
    /// Replaces the two topmost by whether one holds.
    Or,
}

/// What is known of the truth of a statement about many samples at once.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Truth {
    /// It may hold somewhere.
    pub may_hold: bool,
    /// It may fail somewhere.
    pub may_fail: bool,
}

impl Truth {
    /// It may hold and it may fail.
    pub(crate) const UNKNOWN: Truth = Truth {
        may_hold: true,
        may_fail: true,
    };
}

impl From<bool> for Truth {
    fn from(holds: bool) -> Truth {
        Truth {
            may_hold: holds,
            may_fail: !holds,
        }
    }
}

/// A statement about a sample in an instance: constraints and connectives. Its text is
///
/// ```text
/// formula    = conjunction { "or" conjunction } ;
/// conjunction= literal { "and" literal } ;
/// literal    = "not" literal | "true" | "(" formula ")" | constraint ;
/// constraint = expr ( "<" | "<=" | ">=" | ">" ) expr [ "(" expr ")" ] ;
/// ```
///
/// with the `expr` of the [domain text](crate::domain#the-domain-text). The expression in
/// brackets behind a constraint names its right side, as in
/// `grasp.y <= 2.9 (zone.top - robot.radius)`. It is kept, printed and otherwise ignored.
/// Formulas and expressions are nested at most [`MAX_DEPTH`](crate::domain::MAX_DEPTH)
/// deep.
#[derive(Clone, Debug, PartialEq)]
pub struct Formula {
    pub(super) nodes: Vec<Node, MAX_FORMULA_NODES>,
    pub(super) constraints: Vec<Constraint, MAX_CONSTRAINTS>,
    pub(super) steps: Vec<Step, MAX_FORMULA_STEPS>,
}

impl Default for Formula {
    fn default() -> Self {
        Formula::everything()
    }
}

impl Formula {
    /// The formula `true`, which holds for every sample.
    pub const fn everything() -> Formula {
        Formula {
            nodes: Vec::new(),
            constraints: Vec::new(),
            steps: Vec::new(),
        }
    }

    /// The terms its constraints refer to.
    pub fn nodes(&self) -> &[Node] {
        &self.nodes
    }

    /// Its constraints in order of the text.
    pub fn constraints(&self) -> &[Constraint] {
        &self.constraints
    }

    /// Constraints and connectives in postfix order; empty means `true`.
    pub fn steps(&self) -> &[Step] {
        &self.steps
    }

    /// Adds `and`, and one of these inequalities or another; their terms are copied
    /// from `nodes`.
    ///
    /// # Errors
    /// [`Error::CapacityExceeded`]; the formula is as it was.
    pub fn and(&mut self, nodes: &[Node], any_of: &[Inequality]) -> Result<(), Error> {
        let kept = (self.nodes.len(), self.constraints.len(), self.steps.len());
        let added = self.add(nodes, any_of);
        if added.is_err() {
            self.truncate(kept);
        }
        added
    }

    /// Copies another formula into this one, in place.
    pub(crate) fn copy_from(&mut self, other: &Formula) {
        self.clear();
        // There is room: both have the same.
        let _ = self.nodes.extend_from_slice(&other.nodes);
        let _ = self.constraints.extend_from_slice(&other.constraints);
        let _ = self.steps.extend_from_slice(&other.steps);
    }

    /// Makes it hold for every sample.
    pub(crate) fn clear(&mut self) {
        self.truncate((0, 0, 0));
    }

    fn add(&mut self, nodes: &[Node], any_of: &[Inequality]) -> Result<(), Error> {
        let joined = !self.steps.is_empty();
        for (index, own) in any_of.iter().enumerate() {
            let constraint = Constraint {
                lhs: copy(nodes, own.lhs, &mut self.nodes)?,
                comparison: own.comparison,
                rhs: intern(&mut self.nodes, Node::Number(own.bound))?,
                name: match own.name {
                    Some(name) => Some(copy(nodes, name, &mut self.nodes)?),
                    None => None,
                },
            };
            self.push_constraint(constraint)?;
            if index > 0 {
                self.push_step(Step::Or)?;
            }
        }
        if joined && !any_of.is_empty() {
            self.push_step(Step::And)?;
        }
        Ok(())
    }

    pub(super) fn push_constraint(&mut self, constraint: Constraint) -> Result<(), Error> {
        const FULL: Error = Error::CapacityExceeded("constraints of a region");
        let index = u8::try_from(self.constraints.len()).map_err(|_| FULL)?;
        self.constraints.push(constraint).map_err(|_| FULL)?;
        self.push_step(Step::Constraint(index))
    }

    pub(super) fn push_step(&mut self, step: Step) -> Result<(), Error> {
        self.steps
            .push(step)
            .map_err(|_| Error::CapacityExceeded("connectives of a region"))
    }

    fn truncate(&mut self, (nodes, constraints, steps): (usize, usize, usize)) {
        self.nodes.truncate(nodes);
        self.constraints.truncate(constraints);
        self.steps.truncate(steps);
    }

    /// Whether it holds, given which constraints hold.
    pub fn holds(&self, mut constraint: impl FnMut(&Constraint) -> bool) -> bool {
        self.truth(|c| constraint(c).into()).may_hold
    }

    /// If it joins all its constraints by `and` only: a bit for each.
    pub fn conjunction(&self) -> Option<u32> {
        let joins = |step: &Step| matches!(step, Step::Constraint(_) | Step::And);
        let bits = u32::try_from((1u64 << self.constraints.len()) - 1).ok();
        bits.filter(|_| self.steps.iter().all(joins))
    }

    /// What is known of it, given what is known of each constraint.
    pub fn truth(&self, mut constraint: impl FnMut(&Constraint) -> Truth) -> Truth {
        let (mut hold, mut fail) = (0, 0);
        for (index, own) in self.constraints.iter().enumerate() {
            let known = constraint(own);
            hold |= u32::from(known.may_hold) << index;
            fail |= u32::from(known.may_fail) << index;
        }
        self.truth_of_masks(hold, fail)
    }

    /// Follows its steps: `of` makes something of each, with its place, of what it makes of those
    /// that the step joins, left and right; `not` has a right one alone. Returns what it makes of
    /// the last, which is none for `true`.
    ///
    /// # Errors
    /// Those of `of`; [`Error::InvalidArgument`] if the steps do not fit together.
    pub(crate) fn fold<T: Copy>(
        &self,
        mut of: impl FnMut(usize, Step, [Option<T>; 2]) -> Result<T, Error>,
    ) -> Result<Option<T>, Error> {
        let missing = Error::InvalidArgument("the steps of a formula do not fit together");
        let mut waiting: Vec<T, { MAX_FORMULA_STEPS / 2 }> = Vec::new();
        for (place, step) in self.steps.iter().enumerate() {
            let mut pop = || waiting.pop().ok_or(missing).map(Some);
            let operands = match step {
                Step::Constraint(_) | Step::True => [None, None],
                Step::Not => [None, pop()?],
                Step::And | Step::Or => {
                    let right = pop()?;
                    [pop()?, right]
                }
            };
            let made = of(place, *step, operands)?;
            waiting.push(made).map_err(|_| missing)?;
        }
        Ok(waiting.pop())
    }

    /// What is known of it, given a bit for each constraint that may hold and one
    /// for each that may fail.
    pub fn truth_of_masks(&self, may_hold: u32, may_fail: u32) -> Truth {
        let bit = |mask: u32, index: u8| u64::from(mask.checked_shr(index.into()).unwrap_or(0) & 1);
        // One bit per stack entry: a formula of 96 steps is at most 48 deep.
        let (mut hold, mut fail) = (0u64, 0u64);
        for step in &self.steps {
            match step {
                Step::Constraint(index) => {
                    hold = hold << 1 | bit(may_hold, *index);
                    fail = fail << 1 | bit(may_fail, *index);
                }
                Step::True => {
                    hold = hold << 1 | 1;
                    fail <<= 1;
                }
                Step::Not => {
                    let swapped = (hold ^ fail) & 1;
                    hold ^= swapped;
                    fail ^= swapped;
                }
                Step::And => {
                    hold = hold >> 1 & (hold | !1);
                    fail = fail >> 1 | (fail & 1);
                }
                Step::Or => {
                    hold = hold >> 1 | (hold & 1);
                    fail = fail >> 1 & (fail | !1);
                }
            }
        }
        if self.steps.is_empty() {
            return true.into();
        }
        Truth {
            may_hold: hold & 1 == 1,
            may_fail: fail & 1 == 1,
        }
    }

    /// Index of the first step of the statement that ends at `at`.
    pub(super) fn start_of(&self, mut at: usize) -> Result<usize, fmt::Error> {
        let mut missing = 1usize;
        loop {
            missing = match self.steps.get(at).ok_or(fmt::Error)? {
                Step::Constraint(_) | Step::True => missing.saturating_sub(1),
                Step::Not => missing,
                Step::And | Step::Or => missing + 1,
            };
            if missing == 0 {
                return Ok(at);
            }
            at = before(at)?;
        }
    }
}

fn before(at: usize) -> Result<usize, fmt::Error> {
    at.checked_sub(1).ok_or(fmt::Error)
}
