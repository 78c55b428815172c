//! What can be said of the controllers, for learning when they work.

use super::Cover;
use crate::plan::skill::{Describe, Description};

static COVER: [Description; 4] = [
    Description {
        own: Cover::PICK,
        later: None,
        among: &[],
        text: include_str!("skills/pick.txt"),
    },
    Description {
        own: Cover::PLACE,
        later: None,
        among: &[],
        text: include_str!("skills/place.txt"),
    },
    Description {
        own: Cover::PICK,
        later: Some(Cover::PLACE),
        among: &[],
        text: include_str!("skills/pick_place.txt"),
    },
    Description {
        own: Cover::PLACE,
        later: Some(Cover::PLACE),
        among: &[],
        text: include_str!("skills/place_place.txt"),
    },
];

impl Describe for Cover {
    fn descriptions(&self) -> &'static [Description] {
        &COVER
    }
}
