//! How far a formula is from changing its mind.

use super::{Formula, Step};
use heapless::Vec;

/// Statements that wait for what joins them: a formula of 96 steps is at most 48 deep.
const DEPTH: usize = 48;

impl Formula {
    /// How far it is from being false, or below zero from being true, given how far each of
    /// its constraints is: of what `and` joins the least, of what `or` joins the greatest, and
    /// the contrary of what `not` denies.
    pub(crate) fn robustness(&self, constraint: impl Fn(usize) -> f64) -> f64 {
        let mut waiting: Vec<f64, DEPTH> = Vec::new();
        for step in &self.steps {
            let mut last = || waiting.pop().unwrap_or(f64::INFINITY);
            let value = match step {
                Step::Constraint(index) => constraint(usize::from(*index)),
                Step::True => f64::INFINITY,
                Step::Not => -last(),
                Step::And => last().min(last()),
                Step::Or => last().max(last()),
            };
            // There is a place for each.
            let _ = waiting.push(value);
        }
        waiting.pop().unwrap_or(f64::INFINITY)
    }
}

#[cfg(test)]
mod tests {
    use crate::domain::Domain;
    use crate::grammar::Formula;

    #[test]
    fn the_weakest_of_all_and_the_strongest_of_any() {
        let domain = Domain::parse("object cup { x: length, y: length }").unwrap();
        let [x, y] = ["cup.x >= 0", "cup.y >= 0"];
        let cases = [
            ("true".into(), f64::INFINITY),
            (format!("{x} and {y}"), -2.0),
            (format!("{x} or {y}"), 1.0),
            (format!("not ({x} and {y})"), 2.0),
            (format!("{x} and ({y} or not {y})"), 1.0),
            (format!("{x} and {y} or not {x}"), -1.0),
        ];
        for (text, expected) in cases {
            let formula = Formula::parse(&domain, &text).unwrap();
            // Where x is 1 and y is -2; what is denied is another constraint.
            let axes: std::vec::Vec<bool> = text
                .match_indices("cup.")
                .map(|(at, _)| text[at..].starts_with("cup.x"))
                .collect();
            let within = |place: usize| if axes[place] { 1.0 } else { -2.0 };
            assert_eq!(formula.robustness(within), expected, "{text}");
        }
    }
}
