//! How far a formula is from changing its mind.

use super::{Formula, Step};
use crate::error::Error;

impl Formula {
    /// How far it is from being false, or below zero from being true, given how far each of
    /// its constraints is: of what `and` joins the least, of what `or` joins the greatest, and
    /// the contrary of what `not` denies.
    ///
    /// # Errors
    /// Those of [`Formula::fold`].
    pub(crate) fn robustness(&self, constraint: impl Fn(usize) -> f64) -> Result<f64, Error> {
        let robustness = self.fold(|_, step, [left, right]: [Option<f64>; 2]| {
            let [left, right] = [left, right].map(|own| own.unwrap_or(f64::INFINITY));
            Ok(match step {
                Step::Constraint(index) => constraint(usize::from(index)),
                Step::True => f64::INFINITY,
                Step::Not => -right,
                Step::And => left.min(right),
                Step::Or => left.max(right),
            })
        })?;
        Ok(robustness.unwrap_or(f64::INFINITY))
    }
}

#[cfg(test)]
mod tests {
    use crate::domain::Domain;
    use crate::grammar::Formula;

    #[test]
    fn the_weakest_of_all_and_the_strongest_of_any() {
        let domain = Domain::parse("object cup { x: length, y: length }").unwrap();
        // What each constraint is worth, in their order.
        let cases: [(&str, &[f64], f64); 6] = [
            ("true", &[], f64::INFINITY),
            ("cup.x >= 0 and cup.y >= 0", &[1.0, -2.0], -2.0),
            ("cup.x >= 0 or cup.y >= 0", &[1.0, -2.0], 1.0),
            ("not (cup.x >= 0 and cup.y >= 0)", &[1.0, -2.0], 2.0),
            (
                "cup.x >= 0 and (cup.y >= 0 or cup.y <= 3)",
                &[4.0, -2.0, 3.0],
                3.0,
            ),
            (
                "cup.x >= 0 and cup.y >= 0 or not cup.x >= 5",
                &[1.0, -2.0, 5.0],
                -2.0,
            ),
        ];
        for (text, worth, expected) in cases {
            let formula = Formula::parse(&domain, text).unwrap();
            assert_eq!(formula.constraints().len(), worth.len(), "{text}");
            assert_eq!(
                formula.robustness(|place| worth[place]),
                Ok(expected),
                "{text}"
            );
        }
    }
}
