//! PickStick as something to learn about: its domain text and its simulator.

use super::{ROBOT, STICK, StickButton, World};
use crate::error::Error;
use crate::learn::Outcome;
use crate::task::{Environment, OperatorId, State, Verdict, try_operator_from};

/// The operator PickStickFromNothing.
pub const PICK_STICK_FROM_NOTHING: OperatorId = OperatorId(1);

impl StickButton {
    /// The domain text of picking the stick with one button on the table. An
    /// instance has the numbers of a state with one button, in their order.
    pub const PICK_DOMAIN: &'static str = include_str!("pick.txt");

    /// How many numbers an instance of [`StickButton::PICK_DOMAIN`] has.
    pub const PICK_INSTANCE_LEN: usize = 13;

    /// Rolls PickStick out in an instance, with the first parameter as mu.
    ///
    /// # Errors
    /// [`Error::InvalidArgument`] if the instance has another length or there is
    /// no parameter.
    pub fn try_pick(&self, instance: &[f64], theta: &[f64]) -> Result<Outcome, Error> {
        let mut state = State::new();
        read_instance(instance, &mut state)?;
        let verdict = pick(self, &mut state, theta)?;
        Ok(Outcome::from_feasible(verdict == Verdict::Feasible))
    }
}

/// Rolls PickStick out in a state.
pub(super) fn pick(
    environment: &StickButton,
    state: &mut State,
    theta: &[f64],
) -> Result<Verdict, Error> {
    let mu = theta
        .first()
        .ok_or(Error::InvalidArgument("picking needs the parameter mu"))?;
    let operators = StickButton::OPERATORS;
    let pick = operators
        .get(usize::from(PICK_STICK_FROM_NOTHING.0))
        .ok_or(Error::InvalidArgument("there is no such operator"))?;
    let objects = [ROBOT, STICK];
    let (_, verdict) = try_operator_from(environment, pick, &objects, &[*mu], state);
    Ok(verdict)
}

/// Adds what an instance describes to a state without objects.
pub(super) fn read_instance(instance: &[f64], state: &mut State) -> Result<(), Error> {
    World::read(instance)
        .filter(|world| world.buttons.len() == 1)
        .ok_or(Error::InvalidArgument(
            "an instance has 13 numbers: robot, stick, holder and one button",
        ))?
        .add_to(state)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::domain::Domain;

    #[test]
    fn the_domain_text_agrees_with_the_environment() {
        let domain = Domain::parse(StickButton::PICK_DOMAIN).unwrap();
        assert_eq!(domain.instance_len(), StickButton::PICK_INSTANCE_LEN);
        let types = StickButton::TYPES;
        for (object, kind) in domain.objects().iter().zip(types) {
            assert_eq!(object.name, kind.name);
            assert_eq!(domain.attributes_of(object.type_index), kind.attributes);
        }
        let constants = [
            ("robot.radius", super::super::ROBOT_RADIUS),
            ("button.radius", super::super::BUTTON_RADIUS),
            ("stick.width", super::super::STICK_WIDTH),
            ("stick.height", super::super::STICK_HEIGHT),
            ("tip.width", super::super::TIP_WIDTH),
            ("holder.width", super::super::HOLDER_WIDTH),
            ("holder.height", super::super::HOLDER_HEIGHT),
            ("table.right", super::super::TABLE_WIDTH),
            ("table.top", super::super::TABLE_HEIGHT),
            ("zone.top", super::super::ZONE_HEIGHT),
        ];
        assert_eq!(domain.constants().len(), constants.len());
        for (name, value) in constants {
            let constant = domain.constants().iter().find(|c| c.name == name).unwrap();
            assert_eq!(constant.value, value, "{name}");
        }
        let pick = &StickButton::OPERATORS[usize::from(PICK_STICK_FROM_NOTHING.0)];
        assert_eq!(pick.name, "PickStickFromNothing");
    }
}
