//! What can be said of the controllers, for learning when they work.

use super::{PICK, PLACE, Shelf};
use crate::skill::{Describe, Description};

static DESCRIPTIONS: [Description; 3] = [
    Description::alone(PICK, text!("skills/pick.txt")),
    Description::alone(PLACE, text!("skills/place.txt")),
    Description::chained(PICK, PLACE, text!("skills/pick_place.txt")),
];

impl Describe for Shelf {
    const DESCRIPTIONS: &'static [Description] = &DESCRIPTIONS;
}

#[cfg(test)]
mod tests {
    use super::super::{
        BOX_DEPTH, FINGER_LENGTH, HAND_LENGTH, HAND_THICKNESS, HAND_WIDTH, SHELF_DEPTH, SHELF_TOP,
        SWIVEL,
    };
    use super::*;
    use crate::skill::{Changes, Skills};
    use crate::task::Environment;

    #[test]
    fn the_texts_agree_with_the_environment() {
        let mut skills = [const { None }; DESCRIPTIONS.len()];
        let mut changes = [Changes::default(); 2];
        let skills = Skills::new(&Shelf, &mut skills, &mut changes).unwrap();
        let expected = [
            ("finger.length", FINGER_LENGTH),
            ("hand.length", HAND_LENGTH),
            ("hand.width", HAND_WIDTH),
            ("hand.thickness", HAND_THICKNESS),
            ("hand.swivel", SWIVEL),
            ("box.depth", BOX_DEPTH),
            ("shelf.depth", SHELF_DEPTH),
            ("shelf.top", SHELF_TOP),
        ];
        for skill in skills.iter() {
            let constants = skill.domain().constants().iter();
            let constants: std::vec::Vec<_> = constants.map(|c| (c.name, c.value)).collect();
            assert_eq!(constants, expected);
            let controller = usize::from(skill.description().controller.0);
            let controller = &Shelf::CONTROLLERS[controller];
            let parameters = skill.domain().parameters().iter();
            let ranges: std::vec::Vec<_> = parameters.map(|p| [p.low, p.high]).collect();
            assert_eq!(ranges, controller.parameters, "{}", controller.name);
        }
    }
}
