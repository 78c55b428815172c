//! What can be said of the controllers, for learning when they work.

use super::{
    PICK_STICK, PLACE_STICK, ROBOT_MOVE_TO_BUTTON, ROBOT_PRESS_BUTTON, STICK_PRESS_BUTTON,
    StickButtonMove,
};
use crate::skill::{Describe, Description};

static DESCRIPTIONS: [Description; 5] = [
    Description::alone(PICK_STICK, text!("skills/pick.txt")),
    Description::alone(ROBOT_MOVE_TO_BUTTON, text!("skills/robot_move.txt")),
    Description::alone(ROBOT_PRESS_BUTTON, text!("skills/press.txt")),
    Description::alone(PLACE_STICK, text!("skills/place.txt")),
    Description::chained(PICK_STICK, STICK_PRESS_BUTTON, text!("skills/reach.txt")),
];

impl Describe for StickButtonMove {
    const DESCRIPTIONS: &'static [Description] = &DESCRIPTIONS;
}
