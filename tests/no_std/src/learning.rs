//! Learning with the core, in `f64`, and drawing in both precisions.

use critreg::Error;
use critreg::domain::Domain;
use critreg::env::stick_button::StickButton;
use critreg::learn::{Capacity, Config, Problem, VersionSpace, learn_region, resume, save};
use critreg::random::generator;
use critreg::region::{Region, SavedRegion};
use critreg::text::TextBuffer;

critreg::room!(struct Room: f64, Capacity::new(1024, 128));

/// The texts come from outside, so that nothing is decided at compile time.
///
/// # Safety
/// `text` must point to `length` bytes.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn no_std_learn(text: *const u8, length: usize, seed: u64) -> i32 {
    // SAFETY: as the caller promised.
    let bytes = unsafe { core::slice::from_raw_parts(text, length) };
    let Ok(text) = core::str::from_utf8(bytes) else {
        return 2;
    };
    match run(text, seed) {
        Ok(feasible) => i32::from(!feasible),
        Err(_) => 3,
    }
}

fn run(text: &str, seed: u64) -> Result<bool, Error> {
    let domain = Domain::parse(text)?;
    let environment = StickButton {
        angles: seed % 2 == 1,
    };
    let mut rng = generator(seed);
    let task = environment.task(1..=1, &mut rng)?;
    let problem = Problem::new(&domain, task.initial.values(), 1)?;
    let config = Config {
        seed,
        ..Config::default()
    };
    let mut bytes = [0; 8192];
    let mut learned = learn(&domain, &problem, config, &environment, &mut bytes)?;
    let mut out = [0; 4096];
    let mut buffer = TextBuffer::new(&mut out);
    learned
        .write(&domain, &mut buffer)
        .map_err(|_| Error::NoRegion)?;
    if let Some(text) = buffer.as_str() {
        learned = Region::parse(&domain, text)?;
    }
    let used = learned.save::<f64>(&domain, &mut bytes)?;
    let saved = SavedRegion::read(bytes.get(..used).unwrap_or(&[]))?;
    let region = Region::parse(&domain, saved.region_text)?;
    let theta = region.sample::<f64>(&domain, task.initial.values(), &mut rng)?;
    let other = region.sample::<f32>(&domain, task.initial.values(), &mut rng)?;
    let grounded = region.ground::<f64>(&domain, task.initial.values())?;
    let empty = grounded.is_proven_empty()?;
    let used = theta.get(..domain.parameters().len()).unwrap_or(&[]);
    Ok(grounded.contains(used)? && !empty && other.first() != theta.get(1))
}

fn learn(
    domain: &Domain<'_>,
    problem: &Problem<'_>,
    config: Config,
    environment: &StickButton,
    bytes: &mut [u8],
) -> Result<Region, Error> {
    let mut room = Room::new();
    let mut learner = VersionSpace::new(domain, config, Room::CAPACITY, room.lend())?;
    let _ = resume(&mut learner, problem, bytes);
    let learned = learn_region(&mut learner, problem, |_, query| {
        environment.try_pick(problem.instance(query.instance)?, &query.theta)
    });
    let region = learned.cloned();
    save(&learner, problem, bytes)?;
    region
}
