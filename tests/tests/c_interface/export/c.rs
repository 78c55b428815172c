//! Regions as C.

use super::{Case, PICK, REGIONS, answers};
use crate::support::{BOTH, Language, compiler, run, scratch};
use critreg::Error;
use critreg::domain::Domain;
use critreg::random::{generator, uniform_in};
use critreg::real::Real;
use critreg::region::Region;
use std::fmt::Write as _;
use std::fs;
use std::path::PathBuf;
use std::process::Command;

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

#[test]
fn a_region_as_c_answers_what_the_library_does() {
    for case in Case::all() {
        let c = written(&case.domain, &case.region);
        assert_eq!(c.contains("pick_sample("), case.is_cut, "{c}");
        let mut defines = vec![
            format!("-DNUMBERS={}", case.domain.instance_len()),
            format!("-DTHETA={}", case.domain.parameters().len()),
            format!("-DCONSTRAINTS={}", case.constraints()),
        ];
        if case.is_cut {
            defines.push(String::from("-DCUT"));
        }
        let samples = case.samples();
        let mut input = Vec::new();
        for sample in &samples {
            input.extend(sines(&[&sample.instance[..], &sample.theta[..]].concat()));
            input.extend(sample.numbers());
        }
        let name = format!("export_{}", case.index);
        let [found, as_cpp] = BOTH.map(|language| {
            let program = built(&name, &c, &defines, language);
            answers(&mut Command::new(program), &input)
        });
        assert!(
            found
                .iter()
                .zip(&as_cpp)
                .all(|(a, b)| a.to_bits() == b.to_bits())
        );
        case.check::<f64>(&samples, &found, case.tolerance);
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
