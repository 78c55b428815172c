//! Regions as C that needs no library: it compiles, and answers what the library does, to
//! the last bit.

use crate::support::{BOTH, Language, compiler, run, scratch};
use critreg::Error;
use critreg::domain::Domain;
use critreg::random::{generator, uniform_in};
use critreg::real::Real;
use critreg::region::Region;
use std::fmt::Write as _;
use std::fs;
use std::io::Write as _;
use std::path::PathBuf;
use std::process::{Command, Stdio};

const PICK: &str = "
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
const REGIONS: [(&str, &str, f64, bool); 8] = [
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

/// Reads samples, looks up their sines, and writes what the C says about each.
const MAIN: &str = r"
#include <stdio.h>
#include <stdlib.h>
static double sines[3 * 64];
static inline double find(double angle, int which)
{
    int i;
    for (i = 0; i < 64; i++)
        if (sines[3 * i] == angle)
            return sines[3 * i + which];
    if (angle != angle)
        return angle;
    abort();
}
#define pick_sin(angle) find(angle, 1)
#define pick_cos(angle) find(angle, 2)
#include FILE_NAME
int main(void)
{
    double in[NUMBERS + THETA + 1], out[256];
    while (fread(sines, sizeof sines, 1, stdin) == 1 && fread(in, sizeof in, 1, stdin) == 1) {
        int i;
        for (i = 0; i < 256; i++)
            out[i] = 0;
        out[0] = pick_contains(in, in + NUMBERS);
        pick_margins(in, in + NUMBERS, out + 1, out + 1 + CONSTRAINTS);
#ifdef CUT
        out[100] = pick_intervals(in, out + 104);
        out[101] = pick_sample(in, in[NUMBERS + THETA], out + 102);
#endif
        fwrite(out, sizeof out, 1, stdout);
    }
    return 0;
}
";

fn written(domain: &Domain<'_>, region: &Region) -> String {
    let mut text = String::new();
    region.write_c(domain, "pick", &mut text).unwrap();
    text
}

fn built(name: &str, text: &str, defines: &[String], language: Language) -> PathBuf {
    let header = scratch().join(format!("{name}.h"));
    let source = scratch().join(format!("{name}_main.c"));
    let program = scratch().join(format!("{name}_{language:?}"));
    fs::write(&header, text).unwrap();
    fs::write(&source, MAIN).unwrap();
    let mut command = match language {
        Language::C99 => Command::new(compiler("CC", "cc")),
        Language::Cpp17 => Command::new(compiler("CXX", "c++")),
    };
    match language {
        Language::C99 => command.arg("-std=c99"),
        Language::Cpp17 => command.args(["-std=c++17", "-x", "c++"]),
    };
    command
        .args(["-Wall", "-Wextra", "-Wpedantic", "-Werror", "-O1"])
        .arg("-ffp-contract=off")
        .arg(format!("-DFILE_NAME=\"{}\"", header.display()))
        .args(defines)
        .arg(source)
        .args(["-lm", "-o"])
        .arg(&program);
    run(&mut command);
    program
}

/// What a program writes about what it is given.
fn answers(program: &PathBuf, input: &[f64]) -> Vec<f64> {
    let mut command = Command::new(program);
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

/// The sines of all angles that there can be.
fn sines(numbers: &[f64]) -> Vec<f64> {
    let mut angles = vec![0.25, 0.0];
    angles.extend(numbers.iter().flat_map(|own| [*own, 0.5 * own]));
    let mut table = Vec::new();
    for angle in angles.into_iter().filter(|own| own.is_finite()) {
        let (sin, cos) = Real::sin_cos(angle);
        table.extend([angle, sin, cos]);
    }
    assert!(table.len() <= 3 * 64);
    table.resize(3 * 64, 0.0);
    table
}

/// Equal to the last bit; or nearly, where arc tangents are taken.
fn is_same(a: f64, b: f64, tolerance: f64) -> bool {
    a == b || (a - b).abs() <= tolerance * (1.0 + a.abs())
}

#[test]
fn a_region_as_c_answers_what_the_library_does() {
    for (index, (text, region, tolerance, is_cut)) in REGIONS.iter().enumerate() {
        let domain = Domain::parse(text).unwrap();
        let region = Region::parse(&domain, region).unwrap();
        let c = written(&domain, &region);
        assert_eq!(c.contains("pick_sample("), *is_cut, "{c}");
        let (numbers, theta_len) = (domain.instance_len(), domain.parameters().len());
        let constraints = region.formula().constraints().len();
        let mut defines = vec![
            format!("-DNUMBERS={numbers}"),
            format!("-DTHETA={theta_len}"),
            format!("-DCONSTRAINTS={constraints}"),
        ];
        if *is_cut {
            defines.push(String::from("-DCUT"));
        }
        let mut rng = generator(11 + index as u64);
        let (mut input, mut samples) = (Vec::new(), Vec::new());
        for trial in 0..2000 {
            let mut draw = |size: f64| uniform_in(&mut rng, -size, size);
            let mut instance: Vec<_> = (0..numbers).map(|_| draw(2.0)).collect();
            if !domain.groups().is_empty() && trial % 3 > 0 {
                let members = [3..7, 3..15];
                instance[members[trial % 3 - 1].clone()].fill(f64::NAN);
            }
            // Sticks that lie along an axis, as they often do.
            if trial % 10 == 0 {
                instance[2] = 0.0;
            }
            let theta: Vec<_> = domain
                .parameters()
                .iter()
                .map(|p| p.low + (p.high - p.low) * (0.5 + 0.55 * draw(1.0)))
                .collect();
            let share = 0.5 + 0.5 * draw(1.0);
            input.extend(sines(&[&instance[..], &theta[..]].concat()));
            input.extend(instance.iter().chain(&theta).chain([&share]));
            samples.push((instance, theta, share));
        }
        let name = format!("export_{index}");
        let [found, as_cpp] =
            BOTH.map(|language| answers(&built(&name, &c, &defines, language), &input));
        assert!(
            found
                .iter()
                .zip(&as_cpp)
                .all(|(a, b)| a.to_bits() == b.to_bits())
        );
        assert_eq!(found.len(), 256 * samples.len());
        let mut inside = 0;
        for (found, (instance, theta, share)) in found.chunks(256).zip(&samples) {
            let admitted = region.contains::<f64>(&domain, instance, theta).unwrap();
            assert_eq!(found[0], f64::from(admitted), "{instance:?} {theta:?}");
            inside += usize::from(admitted);
            let mut values = vec![0.0; constraints];
            let mut gradients = vec![0.0; constraints * theta_len];
            let done = region.margins::<f64>(&domain, instance, theta, &mut values, &mut gradients);
            done.unwrap();
            let found_margins = &found[1..1 + constraints * (1 + theta_len)];
            for (own, found) in values.iter().chain(&gradients).zip(found_margins) {
                assert!(is_same(*own, *found, *tolerance), "{own} {found}\n{c}");
            }
            if *is_cut {
                let grounded = region.ground::<f64>(&domain, instance).unwrap();
                let set = grounded.intervals().unwrap();
                let ends = set.intervals().iter().flat_map(|own| [own.low, own.high]);
                let ends: Vec<_> = ends.collect();
                assert_eq!(found[100] as usize * 2, ends.len(), "{instance:?}");
                assert_eq!(found[104..104 + ends.len()], ends, "{instance:?}");
                let drawn = set.quantile(*share);
                assert_eq!(found[101], f64::from(drawn.is_some()));
                assert!(drawn.is_none_or(|own| own == found[102]));
            }
        }
        let share = inside as f64 / samples.len() as f64;
        assert!(
            (0.02..=0.98).contains(&share) || constraints == 0,
            "{share} of {index}"
        );
    }
}

/// In float, sines are the file's own, and still the library's.
#[test]
fn in_float_not_even_sines_come_from_elsewhere() {
    let domain = Domain::parse(PICK).unwrap();
    let region = Region::parse(&domain, REGIONS[1].1).unwrap();
    let header = scratch().join("export_float.h");
    let source = scratch().join("export_float.c");
    let program = scratch().join("export_float");
    fs::write(&header, written(&domain, &region)).unwrap();
    let main = r#"
        #define pick_FLOAT
        #include "export_float.h"
        #include <stdio.h>
        int main(void)
        {
            float in[7], values[3], gradients[3];
            while (scanf("%f %f %f %f %f %f %f", in, in + 1, in + 2, in + 3, in + 4, in + 5,
                         in + 6) == 7) {
                pick_margins(in, in + 6, values, gradients);
                printf("%.9g %.9g %.9g %.9g %.9g %.9g\n", (double)values[0], (double)values[1],
                       (double)values[2], (double)gradients[0], (double)gradients[1],
                       (double)gradients[2]);
            }
            return 0;
        }"#;
    fs::write(&source, main).unwrap();
    let options = "-std=c99 -Wall -Wextra -Wpedantic -Werror -O1 -ffp-contract=off";
    let mut command = Command::new(compiler("CC", "cc"));
    command.args(options.split(' ')).arg(&source);
    run(command.args(["-lm", "-o"]).arg(&program));
    let (mut rng, mut input, mut expected) = (generator(5), String::new(), String::new());
    for _ in 0..1000 {
        let mut draw = |size: f64| uniform_in(&mut rng, -size, size) as f32;
        let numbers: Vec<_> = (0..6).map(|_| draw(7.0)).collect();
        let theta = 0.5 + 0.5 * draw(1.0);
        for number in numbers.iter().chain([&theta]) {
            write!(input, "{number:?} ").unwrap();
        }
        let instance: Vec<_> = numbers.into_iter().map(f64::from).collect();
        let (mut values, mut gradients) = ([0.0; 3], [0.0; 3]);
        let theta = [f64::from(theta)];
        let done = region.margins::<f32>(&domain, &instance, &theta, &mut values, &mut gradients);
        done.unwrap();
        for number in values.iter().chain(&gradients) {
            writeln!(expected, "{:?}", *number as f32).unwrap();
        }
    }
    let path = scratch().join("export_float.txt");
    fs::write(&path, input).unwrap();
    let output = run(Command::new(program).stdin(fs::File::open(path).unwrap()));
    let found = String::from_utf8(output.stdout).unwrap();
    let found: Vec<f32> = found
        .split_whitespace()
        .map(|own| own.parse().unwrap())
        .collect();
    let expected: Vec<f32> = expected.lines().map(|own| own.parse().unwrap()).collect();
    assert_eq!(found, expected);
}

#[test]
fn what_cannot_be_written_is_named() {
    let bodies = "object can { x: length, y: length }
                  parameter x in [0, 1]: length
                  point hand = world + (x, 0)
                  shape can = circle(0.5)
                  shape hand = circle(0.5)";
    let domain = Domain::parse(bodies).unwrap();
    let region = Region::parse(&domain, "clear(hand, can) >= 0").unwrap();
    let refused =
        |region: &Region, name: &str| match region.write_c(&domain, name, &mut String::new()) {
            Err(Error::InvalidArgument(what)) => what,
            other => panic!("{other:?}"),
        };
    assert!(refused(&region, "pick").contains("bodies"));
    let region = Region::parse(&domain, "x < 0.5").unwrap();
    for name in ["", "2pick", "pick it", "pick*/", &"p".repeat(65)] {
        assert!(refused(&region, name).contains("a name in C"), "{name}");
    }
}
