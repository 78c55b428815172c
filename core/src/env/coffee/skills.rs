//! What can be said of the controllers, for learning when they work.

use super::{Coffee, PICK_JUG, TWIST_JUG};
use crate::skill::{Describe, Description};

static DESCRIPTIONS: [Description; 2] = [
    Description {
        controller: PICK_JUG,
        later: None,
        members: &[],
        text: include_str!("skills/pick.txt"),
    },
    Description {
        controller: TWIST_JUG,
        later: Some(PICK_JUG),
        members: &[],
        text: include_str!("skills/twist_to_pick.txt"),
    },
];

impl Describe for Coffee {
    const DESCRIPTIONS: &'static [Description] = &DESCRIPTIONS;
}
