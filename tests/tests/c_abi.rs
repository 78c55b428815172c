//! The C interface keeps its promises when it is used wrongly, exports what the
//! header declares and nothing else, and can be used from several files.

#[path = "../c/support.rs"]
mod support;

use std::collections::BTreeSet;
use std::fs;
use std::process::Command;
use support::{BOTH, compile, library_directory, root, run};

/// Compiles and runs a program of `tests/c` in both languages.
fn passes(name: &str, files: &[&str]) {
    let directory = root().join("tests/c");
    let sources: Vec<_> = files.iter().map(|file| directory.join(file)).collect();
    for language in BOTH {
        run(&mut Command::new(compile(name, &sources, language)));
    }
}

#[test]
fn wrong_memory_texts_and_configurations() {
    passes("misuse_init", &["misuse_init.c"]);
}

#[test]
fn wrong_handles_instances_and_answers() {
    passes("misuse_learner", &["misuse_learner.c"]);
}

#[test]
fn wrong_callbacks() {
    passes("misuse_callbacks", &["misuse_callbacks.c"]);
}

#[test]
fn wrong_regions() {
    passes("misuse_region", &["misuse_region.c"]);
}

#[test]
fn groups_of_any_number() {
    passes("groups", &["groups.c"]);
}

#[test]
fn chains_noise_and_certificates() {
    passes("learning", &["learning.c"]);
}

#[test]
fn two_translation_units_include_the_header() {
    passes("two_units", &["two_units_main.c", "two_units_other.c"]);
}

/// The functions that the header declares.
fn declared() -> BTreeSet<String> {
    let header = fs::read_to_string(root().join("include/critreg.h")).unwrap();
    let code = header.lines().filter(|line| {
        let start = line.trim_start();
        !start.starts_with(['*', '/', '#']) && !start.starts_with("typedef")
    });
    let names = code.flat_map(|line| {
        line.split([' ', '*'])
            .filter(|word| word.starts_with("critreg_"))
            .filter_map(|word| word.split_once('('))
            .map(|(name, _)| String::from(name))
    });
    names.collect()
}

#[test]
fn the_library_exports_what_the_header_declares() {
    let declared = declared();
    assert!(declared.len() > 30, "{declared:?}");
    let library = library_directory().join("libcritreg_ffi.so");
    if !library.exists() {
        // Another system than Linux, which names and inspects libraries its own way.
        return;
    }
    let output = run(Command::new("nm")
        .args(["-D", "--defined-only"])
        .arg(library));
    let listing = String::from_utf8(output.stdout).unwrap();
    let names = listing
        .lines()
        .filter_map(|line| line.split_whitespace().last());
    let exported: BTreeSet<_> = names.map(String::from).collect();
    assert_eq!(exported, declared);
}

/// Every function is called by the programs above.
#[test]
fn no_function_is_left_out() {
    let files = fs::read_dir(root().join("tests/c")).unwrap();
    let texts = files.map(|file| fs::read_to_string(file.unwrap().path()).unwrap());
    let text: String = texts.collect();
    for name in declared() {
        assert!(text.contains(&format!("{name}(")), "{name} is never called");
    }
}

/// The generator that C copies about is the generator of the library.
#[test]
fn the_stream_of_random_numbers_is_that_of_the_core() {
    use critreg_ffi::rng::{critreg_rng_seed, critreg_rng_uniform};
    let mut expected = critreg::random::generator(7);
    let mut rng = critreg_rng_seed(7);
    for _ in 0..100 {
        let mut number = 0.0;
        // SAFETY: both pointers are to variables.
        let status = unsafe { critreg_rng_uniform(&mut rng, &mut number) };
        assert_eq!(status, 0);
        assert_eq!(number, critreg::random::uniform(&mut expected));
    }
}

/// What C is told about the environment is the environment of the library.
#[test]
fn the_built_in_domain_is_that_of_the_core() {
    use critreg_ffi::stick_button::critreg_stick_button_domain;
    // SAFETY: it is a static text that ends with NUL.
    let text = unsafe { std::ffi::CStr::from_ptr(critreg_stick_button_domain()) };
    let expected = critreg::env::stick_button::StickButton::PICK_DOMAIN;
    assert_eq!(text.to_str(), Ok(expected));
}
