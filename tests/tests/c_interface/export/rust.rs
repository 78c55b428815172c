//! Regions as Rust.

use super::{ANSWER, Case, answers};
use crate::support::{run, scratch};
use critreg::real::Real;
use std::fmt::Write as _;
use std::fs;
use std::path::PathBuf;
use std::process::Command;

/// Answers about all intervals.
const DRAW: &str = "
    let mut ends = [0.0; 2 * MAX_INTERVALS];
    out[100] = intervals(instance, &mut ends) as f64;
    let drawn = sample(instance, share);
    (out[101], out[102]) = (f64::from(drawn.is_some()), drawn.unwrap_or(0.0) as f64);
    for (to, end) in out[104..].iter_mut().zip(ends) { *to = end as f64; }";

/// The crate that the modules need, as it was built for the library.
fn libm() -> PathBuf {
    let test = std::env::current_exe().unwrap();
    let built = fs::read_dir(test.parent().unwrap()).unwrap();
    let libraries = built.map(|file| file.unwrap().path()).filter(|path| {
        let name = path.file_name().unwrap().to_string_lossy().into_owned();
        name.starts_with("liblibm-") && name.ends_with(".rlib")
    });
    let newest = |path: &PathBuf| fs::metadata(path).unwrap().modified().unwrap();
    libraries.max_by_key(newest).unwrap()
}

/// A program that answers for the region whose number it is given.
fn program<R: Real>() -> PathBuf {
    let name = format!("export_rust_{}", R::NAME);
    let folder = scratch().join(&name);
    fs::create_dir_all(&folder).unwrap();
    let (mut modules, mut cases) = (String::new(), String::new());
    for case in Case::all() {
        let index = case.index;
        let mut text = String::new();
        case.region
            .write_rust::<R>(&case.domain, &mut text)
            .unwrap();
        assert_eq!(text.contains("pub fn sample("), case.is_cut, "{text}");
        fs::write(folder.join(format!("region_{index}.rs")), text).unwrap();
        writeln!(modules, "mod region_{index};").unwrap();
        let numbers = case.domain.instance_len() + case.domain.parameters().len() + 1;
        let draw = if case.is_cut { DRAW } else { "" };
        writeln!(
            cases,
            "{index} => {{
                use region_{index}::*;
                while let Some(numbers) = read::<{numbers}>() {{
                    let numbers = numbers.map(|own| own as Real);
                    let (instance, rest) = numbers.split_first_chunk().unwrap();
                    let (theta, rest) = rest.split_first_chunk().unwrap();
                    let share = rest[0];
                    let mut out = [0.0; {ANSWER}];
                    let mut values = [0.0; CONSTRAINTS];
                    let mut gradients = [[0.0; PARAMETERS]; CONSTRAINTS];
                    out[0] = f64::from(u8::from(contains(instance, theta)));
                    margins(instance, theta, &mut values, &mut gradients);
                    let all = values.iter().chain(gradients.as_flattened());
                    for (to, value) in out[1..].iter_mut().zip(all) {{ *to = *value as f64; }}
                    {draw}
                    write(&out);
                }}
            }}"
        )
        .unwrap();
    }
    let main = folder.join("main.rs");
    let text = format!(
        "#![allow(unused)]
        use std::io::{{Read, Write}};
        {modules}
        fn read<const N: usize>() -> Option<[f64; N]> {{
            let mut numbers = [0.0; N];
            for number in &mut numbers {{
                let mut bytes = [0; 8];
                std::io::stdin().read_exact(&mut bytes).ok()?;
                *number = f64::from_le_bytes(bytes);
            }}
            Some(numbers)
        }}
        fn write(numbers: &[f64]) {{
            let bytes: Vec<_> = numbers.iter().flat_map(|own| own.to_le_bytes()).collect();
            std::io::stdout().write_all(&bytes).unwrap();
        }}
        fn main() {{
            let case: u32 = std::env::args().nth(1).unwrap().parse().unwrap();
            match case {{
                {cases}
                _ => panic!(),
            }}
        }}"
    );
    fs::write(&main, text).unwrap();
    let program = folder.join("program");
    let mut compiler = Command::new("rustc");
    // A crate that may unwind fits into a program that does not, but not the other way.
    compiler.args(["--edition=2024", "-Copt-level=1", "-Cpanic=abort", "-o"]);
    compiler.arg(&program).arg("--extern");
    compiler.arg(format!("libm={}", libm().display())).arg(main);
    run(&mut compiler);
    program
}

fn check<R: Real>() {
    let program = program::<R>();
    for case in Case::all() {
        let samples = case.samples();
        let input: Vec<_> = samples.iter().flat_map(|own| own.numbers()).collect();
        let found = answers(Command::new(&program).arg(case.index.to_string()), &input);
        case.check::<R>(&samples, &found, 0.0);
    }
}

#[test]
fn a_region_as_rust_answers_what_the_library_does_to_the_last_bit() {
    check::<f64>();
}

#[test]
fn a_region_as_rust_in_single_precision_does_so_too() {
    check::<f32>();
}
