//! The C interface keeps its promises when it is used wrongly, exports what the
//! header declares and nothing else, and can be used from several files.

use crate::support::{
    BOTH, Language, compile, compile_with, compiler, library_directory, root, run, scratch,
};
use critreg::env::stick_button::StickButton;
use critreg::plan::{Conclusion, Config, Planner, Unguided};
use critreg::random::generator;
use critreg::task::Environment;
use critreg_tests::pick::ENVIRONMENT;
use critreg_tests::plan::{Grounding, Room};
use std::collections::BTreeSet;
use std::env;
use std::fmt::Write as _;
use std::fs;
use std::path::Path;
use std::process::Command;

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
fn wrong_handles_and_instances() {
    passes("misuse_learner", &["misuse_learner.c"]);
}

#[test]
fn wrong_outcomes() {
    passes("misuse_outcomes", &["misuse_outcomes.c"]);
}

#[test]
fn a_bool_says_what_works() {
    passes("bool", &["bool.c"]);
    let source = root().join("tests/c/bool.cpp");
    run(&mut Command::new(compile(
        "bool_cpp",
        &[source],
        Language::Cpp17,
    )));
}

/// Warnings that a program may have on, which a header must not trip over.
const STRICT: [&str; 4] = [
    "-Wshadow",
    "-Wconversion",
    "-Wsign-conversion",
    "-Wnon-virtual-dtor",
];

#[test]
fn the_wrapper_for_cpp_keeps_its_promises() {
    let source = root().join("tests/c/wrapper.cpp");
    for standard in ["-std=c++17", "-std=c++20"] {
        let flags = [&STRICT[..], &[standard]].concat();
        run(&mut Command::new(compile_with(
            "wrapper",
            std::slice::from_ref(&source),
            Language::Cpp17,
            &flags,
        )));
    }
}

#[test]
fn the_wrapper_for_cpp_compiles_without_exceptions() {
    let source = root().join("tests/c/nothrow.cpp");
    let flags = [&STRICT[..], &["-fno-exceptions"]].concat();
    run(&mut Command::new(compile_with(
        "nothrow",
        &[source],
        Language::Cpp17,
        &flags,
    )));
}

/// A function of C is one of C++, too, but for what only those need who lend memory, or leave
/// callbacks by longjmp().
#[test]
fn the_wrapper_for_cpp_leaves_nothing_out() {
    let headers = fs::read_dir(root().join("include")).unwrap();
    let wrappers = headers.map(|file| file.unwrap().path()).filter(|path| {
        path.extension().is_some_and(|own| own == "hpp") && !path.ends_with("critreg_ompl.hpp")
    });
    let text: String = wrappers
        .map(|path| fs::read_to_string(path).unwrap())
        .collect();
    let of_c = |name: &String| name.ends_with("_align") || name.ends_with("_recover");
    let missing = declared()
        .into_iter()
        .filter(|name| !of_c(name) && !text.contains(&format!("{name}(")));
    assert_eq!(missing.collect::<Vec<_>>(), Vec::<String>::new());
}

#[test]
fn wrong_callbacks() {
    passes("misuse_callbacks", &["misuse_callbacks.c"]);
}

#[test]
fn callbacks_that_are_left() {
    passes("left_callbacks", &["left_callbacks.c"]);
}

#[test]
fn pictures() {
    passes("picture", &["picture.c"]);
}

#[test]
fn wrong_regions() {
    passes("misuse_region", &["misuse_region.c"]);
}

#[test]
fn wrong_uses_of_the_environment() {
    passes("misuse_environment", &["misuse_environment.c"]);
}

#[test]
fn wrong_planners() {
    passes("misuse_planner", &["misuse_planner.c"]);
}

#[test]
fn wrong_planning() {
    passes("misuse_planning", &["misuse_planning.c"]);
}

#[test]
fn wrong_skills() {
    passes("misuse_skills", &["misuse_skills.c"]);
}

#[test]
fn parameters_as_they_were_drawn() {
    passes("parameters", &["parameters.c"]);
}

#[test]
fn groups_of_any_number() {
    passes("groups", &["groups.c"]);
}

#[test]
fn proofs() {
    passes("proof", &["proof.c"]);
}

#[test]
fn regions_without_the_library_and_many_samples() {
    passes("export", &["export.c"]);
}

#[test]
fn words_about_configurations_and_texts() {
    passes("words", &["words.c"]);
}

#[test]
fn chains_noise_and_certificates() {
    passes("learning", &["learning.c"]);
}

#[test]
fn versions_and_capabilities() {
    passes("version", &["version.c"]);
}

#[test]
fn several_questions_at_once() {
    passes("questions", &["questions.c"]);
}

#[test]
fn learning_with_float() {
    passes("precision", &["precision.c"]);
}

#[test]
fn the_stack_that_functions_take() {
    let sources = [root().join("tests/c/stack.c")];
    run(&mut Command::new(compile("stack", &sources, Language::C99)));
}

#[test]
fn two_threads_read_the_same_handles() {
    passes("threads", &["threads.c"]);
}

#[test]
fn two_translation_units_include_the_header() {
    passes("two_units", &["two_units_main.c", "two_units_other.c"]);
}

/// A C program that plans from PDDL and callbacks finds the plans of the core, in as
/// many steps of the search.
#[test]
fn a_c_program_plans_as_the_core_does() {
    let source = root().join("tests/c/planning.c");
    let expected: String = (0..40).map(planned_by_the_core).collect();
    for language in BOTH {
        let program = compile("planning", std::slice::from_ref(&source), language);
        let output = run(&mut Command::new(program));
        assert_eq!(String::from_utf8(output.stdout).unwrap(), expected);
    }
}

/// What the program prints of a task.
fn planned_by_the_core(seed: u64) -> String {
    let buttons = 1 + seed as usize % 4;
    let task = ENVIRONMENT.task(buttons..=buttons, &mut generator(seed));
    let task = task.unwrap();
    let grounding = Grounding::new(&ENVIRONMENT, &task).unwrap();
    let mut room = Room::new(10_000);
    let mut planner = Planner {
        world: &mut grounding.simulated(),
        sampler: &mut grounding.simulated(),
        guide: &mut Unguided,
        config: Config::default(),
    };
    let (lots, samples) = (generator(seed), || generator(seed));
    let planned = planner.plan(grounding.task(), &task.initial, lots, samples, room.lend());
    let planned = planned.unwrap();
    let m = &planned.metrics;
    let mut line = format!(
        "{seed}: {} {} {} {} {} {}",
        i32::from(planned.conclusion == Conclusion::Solved),
        m.samples,
        m.skeletons,
        m.nodes_expanded,
        m.nodes_created,
        m.actions
    );
    for step in planned.steps {
        let ground = &grounding.operators[usize::from(step.operator)];
        let name = ENVIRONMENT.operator(ground).unwrap().name;
        write!(line, " ({name}").unwrap();
        for object in ground.objects.as_slice() {
            let name = task.initial.name(StickButton::TYPES, *object).unwrap();
            write!(line, " {name}").unwrap();
        }
        line.push(')');
        for parameter in &step.parameters {
            write!(line, " {}", (*parameter as f32).to_bits()).unwrap();
        }
    }
    line + "\n"
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

/// What a shared object exports.
fn exported(library: &Path) -> BTreeSet<String> {
    let output = run(Command::new("nm")
        .args(["-D", "--defined-only"])
        .arg(library));
    let listing = String::from_utf8(output.stdout).unwrap();
    let names = listing
        .lines()
        .filter_map(|line| line.split_whitespace().last());
    names.map(String::from).collect()
}

/// Another system than Linux names, makes and inspects libraries its own way.
#[test]
#[cfg(target_os = "linux")]
fn the_library_exports_what_the_header_declares() {
    let declared = declared();
    assert!(declared.len() > 50, "{declared:?}");
    let library = library_directory().join("libcritreg.so");
    assert_eq!(exported(&library), declared);
}

/// A shared object that has the static library inside exports the functions of the header
/// and its own, and nothing of Rust.
#[test]
#[cfg(target_os = "linux")]
fn a_plug_in_exports_what_the_header_declares() {
    let plug_in = scratch().join("plug_in.so");
    let (include, source) = (root().join("include"), root().join("tests/c/plug_in.c"));
    run(Command::new(compiler("CC", "cc"))
        .args(["-shared", "-fPIC", "-I"])
        .args([&include, &source])
        .arg(library_directory().join("libcritreg.a"))
        .args(["-lm", "-Wl,--no-undefined", "-o"])
        .arg(&plug_in));
    let mut expected = declared();
    expected.insert("plug_in_learn".into());
    assert_eq!(exported(&plug_in), expected);
}

/// There may be another library in Rust in the same program, in front or behind.
#[test]
#[cfg(target_os = "linux")]
fn another_rust_library_does_not_clash() {
    const OTHER: &str = r#"
        #[unsafe(no_mangle)]
        pub extern "C" fn other_sum(count: u32) -> u32 {
            let numbers: Vec<u32> = (0..count).collect();
            println!("sum of {numbers:?}");
            numbers.iter().sum()
        }
    "#;
    let (source, other) = (scratch().join("other.rs"), scratch().join("libother.a"));
    fs::write(&source, OTHER).unwrap();
    let rustc = env::var("RUSTC").unwrap_or("rustc".into());
    run(Command::new(rustc)
        .args(["--edition=2024", "-O", "-Clto=fat", "-Cpanic=abort"])
        .args(["--crate-type=staticlib", "-o"])
        .args([&other, &source]));
    let program = scratch().join("beside_rust");
    let own = library_directory().join("libcritreg.a");
    for libraries in [[&own, &other], [&other, &own]] {
        run(Command::new(compiler("CC", "cc"))
            .arg("-I")
            .args([root().join("include"), root().join("tests/c/beside_rust.c")])
            .args(libraries)
            // What std needs, which is in the other one.
            .args(["-lpthread", "-ldl", "-lm", "-lgcc_s", "-o"])
            .arg(&program));
        run(&mut Command::new(&program));
    }
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
    use critreg_ffi::boundary::rng::{critreg_rng_seed, critreg_rng_uniform};
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
    use critreg_ffi::stick_button::environment::critreg_stick_button_domain;
    // SAFETY: it is a static text that ends with NUL.
    let text = unsafe { std::ffi::CStr::from_ptr(critreg_stick_button_domain()) };
    let expected = critreg::env::stick_button::StickButton::PICK_DOMAIN;
    assert_eq!(text.to_str(), Ok(expected));
}
