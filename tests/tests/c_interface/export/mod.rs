//! Regions as code that needs no library: it compiles, and answers what the library does, to
//! the last bit.

mod c;
mod rust;

use critreg::domain::Domain;
use critreg::random::{generator, uniform_in};
use critreg::real::Real;
use critreg::region::Region;
use std::io::Write as _;
use std::process::{Command, Stdio};

pub(super) const PICK: &str = "
    object stick  { x: length, y: length, theta: angle }
    object holder { x: length, y: length, theta: angle }
    constant zone.top     = 3.0: length
    constant stick.width  = 3.0: length
    constant holder.width = 0.3: length
    constant robot.radius = 0.1: length
    parameter mu in [0, 1]
    shape holder = rectangle(holder.width, holder.width)
    point grasp = stick + (mu * stick.width, 0)";

const SPACE: &str = "
    object stick { x: length, y: length, theta: angle }
    object post[3] { x: length, y: length, z: length, r: length }
    object tray { x: length, y: length, z: length, yaw: angle, pitch: angle, roll: angle }
    constant width = 2: length
    parameter mu in [0, 1]
    parameter lift in [-1, 1]: length
    parameter turn in [-1, 1]: angle
    shape post = circle(post.r)
    point rim = tray turned 0.25 + (1, 0.5*width, 0.1)
    point tip = stick + (mu * width, 0.25, lift)
    point hand = tray turned (turn, 0.5*turn, 0.25) + (mu * width, lift, 0.25)";

/// A domain, a region, how much a region is about arc tangents, and whether all of it has a
/// closed form.
pub(super) const REGIONS: [(&str, &str, f64, bool); 8] = [
    (PICK, "grasp.y <= 2.9 (zone.top - robot.radius)", 0.0, true),
    (
        PICK,
        "grasp.y <= 2.9 and dist(grasp, holder.centre) >= 0.4 and dist_y(grasp, holder) > 0.1",
        0.0,
        true,
    ),
    (
        PICK,
        "not (dist(grasp, holder) < 1.5 or grasp.x > 1.25) or 2*dist(grasp, stick) - holder.x <= 1",
        0.0,
        true,
    ),
    (PICK, "true", 0.0, true),
    (
        PICK,
        "angle(stick, holder) <= 1.5 and angle(stick, grasp, holder) >= 0.5 and grasp.theta < 2",
        1e-15,
        false,
    ),
    (
        SPACE,
        "tip.x <= 2.5 and mu * lift > -0.5 and dist(tip, tray) >= 0.5 and dist(hand, rim) < 4
         and min(dist(tip, post)) < 2 and dist_y(hand, stick) - dist_z(hand, tip) <= 1
         and max(post.r) <= 2",
        0.0,
        false,
    ),
    (
        SPACE,
        "min(dist(hand, post)) >= 1 or lift + tray.z > 0",
        0.0,
        false,
    ),
    (
        SPACE,
        "max(off(post, hand)) <= 2 and angle(hand, rim) < 1",
        1e-14,
        false,
    ),
];

/// How many numbers a program answers with: whether the sample is inside, the margins with
/// their gradients; from 100 on how many intervals there are, a draw, and where the intervals
/// end.
const ANSWER: usize = 256;

/// A region that is written.
struct Case {
    index: usize,
    domain: Domain<'static>,
    region: Region,
    tolerance: f64,
    is_cut: bool,
}

/// What a program is asked about.
struct Sample {
    instance: Vec<f64>,
    theta: Vec<f64>,
    /// A uniform share, of which a draw is made.
    share: f64,
}

impl Sample {
    /// In the order in which programs read it.
    fn numbers(&self) -> impl Iterator<Item = f64> {
        let all = self.instance.iter().chain(&self.theta);
        all.chain([&self.share]).copied()
    }
}

impl Case {
    fn all() -> impl Iterator<Item = Case> {
        let cases = REGIONS.into_iter().enumerate();
        cases.map(|(index, (text, region, tolerance, is_cut))| {
            let domain = Domain::parse(text).unwrap();
            let region = Region::parse(&domain, region).unwrap();
            Case {
                index,
                domain,
                region,
                tolerance,
                is_cut,
            }
        })
    }

    fn constraints(&self) -> usize {
        self.region.formula().constraints().len()
    }

    fn samples(&self) -> Vec<Sample> {
        let mut rng = generator(11 + self.index as u64);
        let sample = |trial: usize| {
            let mut draw = |size: f64| uniform_in(&mut rng, -size, size);
            let numbers = 0..self.domain.instance_len();
            let mut instance: Vec<_> = numbers.map(|_| draw(2.0)).collect();
            if !self.domain.groups().is_empty() {
                let absent = [3..3, 3..7, 3..15];
                instance[absent[trial % 3].clone()].fill(f64::NAN);
            }
            // Sticks that lie along an axis, as they often do.
            if trial.is_multiple_of(10) {
                instance[2] = 0.0;
            }
            let parameters = self.domain.parameters().iter();
            let theta = parameters
                .map(|p| p.low + (p.high - p.low) * (0.5 + 0.55 * draw(1.0)))
                .collect();
            let share = 0.5 + 0.5 * draw(1.0);
            Sample {
                instance,
                theta,
                share,
            }
        };
        (0..2000).map(sample).collect()
    }

    /// Holds the answers of a program against those of the library.
    fn check<R: Real>(&self, samples: &[Sample], found: &[f64], tolerance: f64) {
        let Case { domain, region, .. } = self;
        assert_eq!(found.len(), ANSWER * samples.len());
        let (constraints, parameters) = (self.constraints(), domain.parameters().len());
        let mut inside = 0;
        for (found, sample) in found.chunks(ANSWER).zip(samples) {
            let Sample {
                instance,
                theta,
                share,
            } = sample;
            let admitted = region.contains::<R>(domain, instance, theta).unwrap();
            assert_eq!(found[0], f64::from(admitted), "{instance:?} {theta:?}");
            inside += usize::from(admitted);
            let mut values = vec![0.0; constraints];
            let mut gradients = vec![0.0; constraints * parameters];
            let done = region.margins::<R>(domain, instance, theta, &mut values, &mut gradients);
            done.unwrap();
            let found_margins = &found[1..1 + constraints * (1 + parameters)];
            for (own, found) in values.iter().chain(&gradients).zip(found_margins) {
                assert!(is_same(*own, *found, tolerance), "{own} {found}");
            }
            if self.is_cut {
                let grounded = region.ground::<R>(domain, instance).unwrap();
                let set = grounded.intervals().unwrap();
                let ends = set.intervals().iter().flat_map(|own| [own.low, own.high]);
                let ends: Vec<_> = ends.map(R::to_f64).collect();
                assert_eq!(found[100] as usize * 2, ends.len(), "{instance:?}");
                assert_eq!(found[104..104 + ends.len()], ends, "{instance:?}");
                let drawn = set.quantile(R::from_f64(*share)).map(R::to_f64);
                assert_eq!(found[101], f64::from(drawn.is_some()));
                assert!(drawn.is_none_or(|own| own == found[102]));
            }
        }
        let share = inside as f64 / samples.len() as f64;
        assert!(
            (0.02..=0.98).contains(&share) || constraints == 0,
            "{share} of {}",
            self.index
        );
    }
}

/// Equal to the last bit; or nearly, where arc tangents are taken.
fn is_same(a: f64, b: f64, tolerance: f64) -> bool {
    a == b || (a - b).abs() <= tolerance * (1.0 + a.abs())
}

/// What a program writes about what it is given.
fn answers(command: &mut Command, input: &[f64]) -> Vec<f64> {
    let mut child = command
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .spawn()
        .unwrap();
    let bytes: Vec<_> = input.iter().flat_map(|own| own.to_le_bytes()).collect();
    let mut stdin = child.stdin.take().unwrap();
    let writer = std::thread::spawn(move || stdin.write_all(&bytes).unwrap());
    let output = child.wait_with_output().unwrap();
    writer.join().unwrap();
    assert!(output.status.success());
    let numbers = output.stdout.chunks(8);
    numbers
        .map(|own| f64::from_le_bytes(own.try_into().unwrap()))
        .collect()
}
