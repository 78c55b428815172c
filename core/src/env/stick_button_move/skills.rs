//! What can be said of the controllers, for learning when they work.

use super::{
    PICK_STICK, PLACE_STICK, ROBOT_MOVE_TO_BUTTON, ROBOT_PRESS_BUTTON, STICK_PRESS_BUTTON,
    StickButtonMove,
};
use crate::skill::{Describe, Description};

/// A text about objects, behind the constants.
macro_rules! text {
    ($objects:literal) => {
        concat!(include_str!("skills/constants.txt"), include_str!($objects))
    };
}

static DESCRIPTIONS: [Description; 5] = [
    Description {
        controller: PICK_STICK,
        later: None,
        members: &[],
        text: text!("skills/pick.txt"),
    },
    Description {
        controller: ROBOT_MOVE_TO_BUTTON,
        later: None,
        members: &[],
        text: text!("skills/robot_move.txt"),
    },
    Description {
        controller: ROBOT_PRESS_BUTTON,
        later: None,
        members: &[],
        text: text!("skills/press.txt"),
    },
    Description {
        controller: PLACE_STICK,
        later: None,
        members: &[],
        text: text!("skills/place.txt"),
    },
    Description {
        controller: PICK_STICK,
        later: Some(STICK_PRESS_BUTTON),
        members: &[],
        text: text!("skills/reach.txt"),
    },
];

impl Describe for StickButtonMove {
    const DESCRIPTIONS: &'static [Description] = &DESCRIPTIONS;
}
