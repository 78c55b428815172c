//! Which constraints a formula leaves no choice about.

use super::{Formula, MAX_CONSTRAINTS, Step, before};
use crate::error::Error;
use heapless::Vec;

impl Formula {
    /// Visits which constraints must hold, or fail, if the formula does: the index of each
    /// and whether it holds.
    ///
    /// # Errors
    /// [`Error::CapacityExceeded`], for a formula whose brackets leave no room.
    pub(crate) fn each_literal(
        &self,
        holds: bool,
        visit: &mut dyn FnMut(u8, bool),
    ) -> Result<(), Error> {
        const FULL: Error = Error::CapacityExceeded("statements that a formula joins");
        let mut ends: Vec<(usize, bool), { 2 * MAX_CONSTRAINTS }> = Vec::new();
        if let Some(last) = self.steps.len().checked_sub(1) {
            ends.push((last, holds)).map_err(|_| FULL)?;
        }
        while let Some((end, holds)) = ends.pop() {
            match (self.steps.get(end), holds) {
                (Some(Step::Constraint(index)), _) => visit(*index, holds),
                (Some(Step::Not), _) => {
                    let inner = before(end).map_err(|_| FULL)?;
                    ends.push((inner, !holds)).map_err(|_| FULL)?;
                }
                (Some(Step::And), true) | (Some(Step::Or), false) => {
                    let right = before(end).map_err(|_| FULL)?;
                    let start = self.start_of(right).map_err(|_| FULL)?;
                    let left = before(start).map_err(|_| FULL)?;
                    ends.push((right, holds)).map_err(|_| FULL)?;
                    ends.push((left, holds)).map_err(|_| FULL)?;
                }
                // One of several, or none at all.
                (Some(Step::And | Step::Or | Step::True) | None, _) => {}
            }
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::domain::Domain;
    use std::vec::Vec;

    #[test]
    fn what_must_hold_or_fail_is_visited() {
        let domain = Domain::parse("parameter a in [0, 1] parameter b in [0, 1]").unwrap();
        type Case = (&'static str, bool, &'static [(u8, bool)]);
        let cases: [Case; 6] = [
            ("a < 0.5 and not b < 0.5", true, &[(0, true), (1, false)]),
            ("a < 0.5 and not b < 0.5", false, &[]),
            ("a < 0.5 or not b < 0.5", false, &[(0, false), (1, true)]),
            ("not (a < 0.5 or b < 0.5)", true, &[(0, false), (1, false)]),
            ("a < 0.5 and (b < 0.5 or a < 0.1)", true, &[(0, true)]),
            ("true", true, &[]),
        ];
        for (text, holds, wanted) in cases {
            let mut found = Vec::new();
            let formula = Formula::parse(&domain, text).unwrap();
            formula
                .each_literal(holds, &mut |index, holds| found.push((index, holds)))
                .unwrap();
            assert_eq!(found, wanted, "{text}");
        }
    }
}
