//! PickStick and then StickPressButton, as one thing to learn about: where to
//! grasp the stick so that its tip reaches the button.

use super::pick::{pick, read_instance};
use super::{FIRST_BUTTON, ROBOT, STICK, StickButton};
use crate::error::Error;
use crate::learn::Outcome;
use crate::task::{Environment, OperatorId, State, Verdict, try_operator_from};

/// The operator StickPressButtonFromNothing.
pub const STICK_PRESS_BUTTON_FROM_NOTHING: OperatorId = OperatorId(7);

impl StickButton {
    /// Rolls PickStick out and then StickPressButton, in an instance of
    /// [`StickButton::PICK_DOMAIN`] and with the first parameter as mu. The answer
    /// tells which of the two failed.
    ///
    /// # Errors
    /// Those of [`StickButton::try_pick`].
    pub fn try_pick_and_press(&self, instance: &[f64], theta: &[f64]) -> Result<Outcome, Error> {
        let mut state = State::new();
        read_instance(instance, &mut state)?;
        if pick(self, &mut state, theta)? != Verdict::Feasible {
            return Ok(Outcome::FailedStep(1));
        }
        let operators = Self::OPERATORS;
        let press = operators
            .get(usize::from(STICK_PRESS_BUTTON_FROM_NOTHING.0))
            .ok_or(Error::InvalidArgument("there is no such operator"))?;
        let objects = [ROBOT, STICK, FIRST_BUTTON];
        let (_, verdict) = try_operator_from(self, press, &objects, &[], &mut state);
        Ok(if verdict == Verdict::Feasible {
            Outcome::Feasible
        } else {
            Outcome::FailedStep(2)
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::random::generator;

    #[test]
    fn the_operator_is_where_it_is_expected() {
        let index = usize::from(STICK_PRESS_BUTTON_FROM_NOTHING.0);
        let press = &StickButton::OPERATORS[index];
        assert_eq!(press.name, "StickPressButtonFromNothing");
    }

    #[test]
    fn the_step_that_fails_is_told() {
        let environment = StickButton::default();
        let mut seen = [0; 3];
        for seed in 0..40 {
            let task = environment.task(1..=1, &mut generator(seed)).unwrap();
            let instance = task.initial.values();
            for step in 0..20 {
                let theta = [f64::from(step) / 20.0];
                let picked = environment.try_pick(instance, &theta).unwrap();
                let both = environment.try_pick_and_press(instance, &theta).unwrap();
                assert_eq!(picked == Outcome::Feasible, both != Outcome::FailedStep(1));
                let place = match both {
                    Outcome::Feasible => 0,
                    Outcome::FailedStep(step) => usize::from(step),
                    Outcome::Unknown => panic!("the simulator knows"),
                };
                seen[place] += 1;
            }
        }
        assert!(seen.iter().all(|count| *count > 0), "{seen:?}");
    }
}
