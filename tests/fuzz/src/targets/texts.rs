//! Domain texts and region texts, and regions in instances of any numbers.

use super::hash;
use critreg::Error;
use critreg::domain::Domain;
use critreg::random::{Generator, generator, uniform, uniform_in};
use critreg::region::{Region, SavedRegion};

const PICK: &str = "
    object stick { x: length, y: length, theta: angle }
    object can[3] { x: length, y: length, radius: length }
    constant zone.top = 3: length
    constant stick.width = 3: length
    parameter mu in [0, 1]
    point grasp = stick + (mu * stick.width, 0)
    shape can = circle(can.radius)";

const PLACE: &str = "
    type thing { x: length, y: length, theta: angle, width: length, depth: length }
    object item, tray: thing
    parameter u in [-1, 1]: length
    parameter v in [-1, 1]: length
    parameter turn in [-pi, pi]: angle
    point place = tray turned turn + (u, v)
    shape item = rectangle(item.width, item.depth) centred
    shape tray = rectangle(tray.width, tray.depth) rounded 0.01 centred
    shape place = rectangle(item.width, item.depth) centred";

pub(crate) fn domains() -> Vec<Vec<u8>> {
    [PICK, PLACE].map(|text| text.as_bytes().to_vec()).into()
}

const POSTS: &str = "
    object post[6] { x: length, y: length }
    parameter reach in [0, 12]: length
    point hand = world + (reach, 0)";

/// Regions of domains; what is fuzzed are the texts of regions, because most changes of a
/// domain text leave none.
pub(crate) const REGIONS: [(&str, &str); 7] = [
    (
        PICK,
        "grasp.y <= 2.9 (zone.top - 0.1) and min(dist(grasp, can)) >= 0.3",
    ),
    (
        PICK,
        "not (mu < 0.25 or mu > 0.75) and min(clear(grasp, can)) > 0",
    ),
    (
        PICK,
        "angle(grasp, stick) <= 0.5*pi and max(can.x) <= 2*grasp.x + 1",
    ),
    (
        PLACE,
        "inside(place, tray) >= 0.01 and u*v <= 0.25 or over(place, tray) > 0",
    ),
    (
        PLACE,
        "angle(place, item, pi) <= 0.1 and dist_x(place, item) >= 0.2",
    ),
    (
        POSTS,
        "min(dist(hand, post)) >= 0.3 or min(dist(hand, post)) <= 0.1",
    ),
    (
        POSTS,
        "reach - max(post.x) < 2 and not min(dist_y(hand, post)) > 0.4",
    ),
];

/// A number of a domain above, and the text of a region.
pub(crate) fn regions() -> Vec<Vec<u8>> {
    let all = (0u8..).zip(REGIONS);
    all.map(|(own, (_, text))| [&[own], text.as_bytes()].concat())
        .collect()
}

/// What was said of an error, without its place.
pub(crate) fn said(error: &Error) -> u64 {
    match error {
        Error::Syntax(at) => hash(at.what),
        other => hash(&format!("{other:?}")),
    }
}

pub(crate) fn domain(input: &[u8]) -> u64 {
    let text = String::from_utf8_lossy(input);
    let domain = match Domain::parse(&text) {
        Ok(domain) => domain,
        Err(error) => return said(&error),
    };
    for parameter in domain.parameters() {
        assert!(parameter.low < parameter.high && (parameter.high - parameter.low) > 0.0);
    }
    assert_eq!(domain.text(), text);
    hash(&(
        domain.parameters().len(),
        domain.points().len(),
        domain.bodies().len(),
        domain.instance_len(),
    ))
}

/// Numbers of an instance, some of members that are absent.
fn instance(domain: &Domain<'_>, rng: &mut Generator) -> Vec<f64> {
    let scale = 10f64.powf(uniform_in(rng, -1.0, 1.0));
    let absent = uniform(rng) < 0.3;
    let numbers = domain.slots().map(|(object, _)| match object.member {
        Some(_) if absent => f64::NAN,
        _ => scale * uniform_in(rng, -3.0, 3.0),
    });
    numbers.collect()
}

pub(crate) fn region(input: &[u8]) -> u64 {
    let Some((own, text)) = input.split_first() else {
        return 0;
    };
    let (text, own) = (
        String::from_utf8_lossy(text),
        usize::from(*own) % REGIONS.len(),
    );
    let domain = Domain::parse(REGIONS[own].0).unwrap();
    let region = match Region::parse(&domain, &text) {
        Ok(region) => region,
        Err(error) => return said(&error),
    };
    let written = region.display(&domain).to_string();
    let again = Region::parse(&domain, &written).expect(&written);
    assert_eq!(again, region, "{written}");
    let mut bytes = vec![0; region.saved_len(&domain)];
    region.save::<f64>(&domain, &mut bytes).unwrap();
    assert_eq!(SavedRegion::read(&bytes).unwrap().region_text, written);
    let mut rng = generator(hash(input));
    let mut outcomes = Vec::new();
    for _ in 0..3 {
        let instance = instance(&domain, &mut rng);
        outcomes.push(hash(&format!(
            "{:?}",
            look(&domain, &region, &instance, &mut rng)
        )));
    }
    let shape: String = written.chars().filter(|c| !c.is_ascii_digit()).collect();
    hash(&(shape, outcomes))
}

/// Looks at a region in an instance; whether that is proven empty, and whether draws work.
fn look(
    domain: &Domain<'_>,
    region: &Region,
    instance: &[f64],
    rng: &mut Generator,
) -> Result<(bool, Option<Error>), Error> {
    let count = domain.parameters().len();
    let grounded = region.ground::<f64>(domain, instance)?;
    let empty = grounded.is_proven_empty()?;
    let drawn = grounded.sample(rng);
    if let Ok(theta) = drawn {
        assert_eq!(
            grounded.contains(&theta[..count]),
            Ok(true),
            "{theta:?} {instance:?}"
        );
        assert!(!empty, "{theta:?} {instance:?}");
    }
    if count == 1 {
        // One parameter: membership is the set where that is exact.
        let parameter = &domain.parameters()[0];
        let set = grounded.intervals()?;
        for step in 0..=20 {
            let share = f64::from(step) / 20.0;
            let theta = parameter.low * (1.0 - share) + parameter.high * share;
            if grounded.contains(&[theta])? {
                assert!(
                    set.contains(theta) || !set.is_exact(),
                    "{theta} {instance:?}"
                );
            }
        }
    }
    Ok((empty, drawn.err()))
}
