//! An action of `ACTIONS.md` as the library draws any action.

use crate::actions::section;
use critreg::Error;
use critreg::domain::Domain;
use critreg::picture::Picture;
use critreg::region::Region;

/// The action, and a scene of it: a cup, and three of four crates.
const NAME: &str = "Reach";
const ABSENT: f64 = f64::NAN;
const SCENE: [f64; 22] = [
    0.1, 0.05, 0.62, 0.12, 0.3, 0.3, 0.2, -0.45, -0.5, 1.0, 0.35, 0.2, -0.3, 0.62, -0.4, 0.25,
    0.25, ABSENT, ABSENT, ABSENT, ABSENT, ABSENT,
];

/// The picture.
pub(super) fn action() -> Result<String, Error> {
    let [domain, region] = section(NAME);
    let domain = Domain::parse(domain)?;
    let region = Region::parse(&domain, region)?;
    let picture = Picture {
        domain: &domain,
        instance: &SCENE,
        region: Some(&region),
        tried: &|_| (),
    };
    let mut text = String::new();
    picture.write_svg::<f64>(&mut text)?;
    Ok(text)
}
