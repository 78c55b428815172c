//! What can be said of the controllers, for learning when they work.

use super::{PICK_STICK, PLACE_STICK, ROBOT_PRESS_BUTTON, STICK_PRESS_BUTTON, StickButton};
use crate::skill::{Describe, Description};

static DESCRIPTIONS: [Description; 4] = [
    Description::alone(PICK_STICK, text!("skills/pick.txt")),
    Description::alone(ROBOT_PRESS_BUTTON, text!("skills/press.txt")),
    Description::alone(PLACE_STICK, text!("skills/place.txt")),
    Description::chained(PICK_STICK, STICK_PRESS_BUTTON, text!("skills/reach.txt")),
];

impl Describe for StickButton {
    const DESCRIPTIONS: &'static [Description] = &DESCRIPTIONS;
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::domain::Domain;
    use crate::skill::{Changes, Skills};
    use crate::task::Environment;

    #[test]
    fn the_texts_agree_with_the_environment() {
        let environment = StickButton::default();
        let pick = Domain::parse(StickButton::PICK_DOMAIN).unwrap();
        let mut skills = [const { None }; DESCRIPTIONS.len()];
        let mut changes = [Changes::default(); 4];
        let skills = Skills::new(&environment, &mut skills, &mut changes).unwrap();
        for skill in skills.iter() {
            assert_eq!(skill.domain().constants(), pick.constants());
            let controller = usize::from(skill.description().controller.0);
            let controller = &StickButton::CONTROLLERS[controller];
            let parameters = skill.domain().parameters().iter();
            let ranges: std::vec::Vec<_> = parameters.map(|p| [p.low, p.high]).collect();
            assert_eq!(ranges, controller.parameters, "{}", controller.name);
        }
    }
}
