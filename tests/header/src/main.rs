//! Writes `include/critreg.h` from the C interface: `cargo run -p critreg-header`. The
//! header is committed; the tests here hold it against the interface as it is.

use std::fs;
use std::path::{Path, PathBuf};

/// The files with the interface, in the order in which the manual tells it.
const SOURCES: [&str; 52] = [
    "boundary/version.rs",
    "boundary/status.rs",
    "boundary/limits.rs",
    "boundary/precision.rs",
    "region/quality.rs",
    "learner/quality.rs",
    "learner/report.rs",
    "learner/config.rs",
    "learner/check.rs",
    "learner/handle.rs",
    "learner/making.rs",
    "learner/choosing.rs",
    "learner/outcome.rs",
    "learner/learning.rs",
    "learner/questions.rs",
    "learner/inspection.rs",
    "learner/picture.rs",
    "learner/saving.rs",
    "region/handle.rs",
    "region/making.rs",
    "region/check.rs",
    "region/writing.rs",
    "region/constraint.rs",
    "region/sampling.rs",
    "region/many.rs",
    "region/margins.rs",
    "region/implies.rs",
    "learner/challenge.rs",
    "region/export.rs",
    "region/picture.rs",
    "boundary/rng.rs",
    "planner/config.rs",
    "planner/check.rs",
    "planner/handle.rs",
    "planner/making.rs",
    "planner/callbacks.rs",
    "planner/planning.rs",
    "planner/step.rs",
    "planner/metrics.rs",
    "planner/why.rs",
    "planner/inspection.rs",
    "skill/config.rs",
    "skill/handle.rs",
    "skill/making.rs",
    "skill/controllers.rs",
    "skill/descriptions.rs",
    "skill/training_tasks.rs",
    "skill/learning.rs",
    "skill/report.rs",
    "skill/saving.rs",
    "stick_button/environment.rs",
    "stick_button/world.rs",
];

fn main() {
    fs::write(committed(), generated()).expect("the header can be written");
}

/// A file of the repository.
fn file(path: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR"))
        .join("../..")
        .join(path)
}

fn committed() -> PathBuf {
    file("include/critreg.h")
}

fn generated() -> String {
    let ffi = file("ffi");
    let config = cbindgen::Config::from_file(ffi.join("cbindgen.toml")).unwrap();
    let mut builder = cbindgen::Builder::new().with_config(config);
    for source in SOURCES {
        builder = builder.with_src(ffi.join("src").join(source));
    }
    let mut bytes = Vec::new();
    builder.generate().unwrap().write(&mut bytes);
    String::from_utf8(bytes).unwrap()
}

#[test]
fn the_header_is_up_to_date() {
    let committed = fs::read_to_string(committed()).unwrap_or_default();
    assert!(
        committed == generated(),
        "include/critreg.h does not describe the interface as it is; update it with\n    \
         cargo run -p critreg-header"
    );
}

/// All files below a directory.
#[cfg(test)]
fn files_below(directory: &Path, found: &mut Vec<PathBuf>) {
    for entry in fs::read_dir(directory).unwrap() {
        let path = entry.unwrap().path();
        if path.is_dir() {
            files_below(&path, found);
        } else {
            found.push(path);
        }
    }
}

#[test]
fn no_file_of_the_interface_is_left_out() {
    let (top, mut files) = (file("ffi/src"), Vec::new());
    files_below(&top, &mut files);
    assert!(files.len() > SOURCES.len());
    for path in files {
        let exports = fs::read_to_string(&path).unwrap().contains("no_mangle");
        let name = path.strip_prefix(&top).unwrap();
        let listed = SOURCES.iter().any(|source| Path::new(source) == name);
        assert!(!exports || listed, "{} is left out", name.display());
    }
}

#[test]
fn everything_is_documented() {
    // A declaration follows the end of a comment; a field or macro, too.
    let header = generated();
    let mut previous = "";
    for line in header.lines() {
        let declares = line.starts_with("critreg_status critreg_")
            || line.starts_with("typedef ")
            || (line.starts_with("#define CRITREG_") && line != "#define CRITREG_H");
        assert!(
            !declares || previous.ends_with("*/"),
            "no comment above: {line}"
        );
        previous = line;
    }
}

/// The rules of a grammar from one to another, without comments and blanks.
#[cfg(test)]
fn rules(text: &str, first: &str, last: &str) -> String {
    let lines = text
        .lines()
        .map(|line| line.trim_start_matches([' ', '*', '/', '!']));
    let from_first = lines.skip_while(|line| !line.starts_with(first));
    let mut rules = String::new();
    for line in from_first {
        rules.extend(line.split("(* ").next().unwrap().split_whitespace());
        if line.starts_with(last) {
            return rules;
        }
    }
    panic!("no rules from {first} to {last}");
}

#[test]
fn the_header_has_the_grammar_of_the_library() {
    let header = fs::read_to_string(committed()).unwrap();
    let library = fs::read_to_string(file("core/src/domain/mod.rs")).unwrap();
    let of = |text| rules(text, "domain    =", "name      =");
    assert_eq!(of(&header), of(&library));
}

/// What the manual says about the memory of a planner is true on machines with
/// pointers of 64 bits.
#[test]
#[cfg(target_pointer_width = "64")]
fn the_memory_of_a_planner_is_true() {
    use critreg_ffi::planner::config::critreg_planner_config_init;
    use critreg_ffi::planner::making::critreg_planner_size;
    let size = |state_len: u32| {
        let mut config = std::mem::MaybeUninit::uninit();
        // SAFETY: the pointer is to a variable of the size told, which is
        // initialised when it succeeds.
        let mut config = unsafe {
            let len = size_of_val(&config);
            assert_eq!(critreg_planner_config_init(config.as_mut_ptr(), len), 0);
            config.assume_init()
        };
        config.state_len = state_len;
        // SAFETY: it is a configuration.
        unsafe { critreg_planner_size(&config) }
    };
    let each = size(2) - size(1);
    let told = format!(
        "A planner with the default capacities takes {} bytes, and {each} more for every",
        size(1) - each
    );
    assert!(generated().contains(&told), "{told}");
}

/// The manual's table of how much memory a learner takes is true on machines with
/// pointers of 64 bits.
#[test]
#[cfg(target_pointer_width = "64")]
fn the_table_of_memory_is_true() {
    use critreg_ffi::learner::config::{
        CRITREG_ALGORITHM1, CRITREG_VERSION_SPACE, critreg_config_init,
    };
    use critreg_ffi::learner::making::critreg_learner_size;
    let size = |learner: u32, forms: usize, observations: usize| {
        let mut config = std::mem::MaybeUninit::uninit();
        // SAFETY: the pointer is to a variable of the size told, which is
        // initialised when it succeeds.
        let mut config = unsafe {
            let len = size_of_val(&config);
            assert_eq!(critreg_config_init(config.as_mut_ptr(), len), 0);
            config.assume_init()
        };
        config.learner = learner;
        config.forms = forms as u32;
        config.observations = observations as u32;
        // SAFETY: it is a configuration.
        unsafe { critreg_learner_size(&config) }
    };
    let header = generated();
    let (_, table) = header.split_once("forms       observations").unwrap();
    let rows = table.lines().skip(1).map_while(|line| {
        let words = line.split_whitespace();
        let numbers: Vec<usize> = words.filter_map(|word| word.parse().ok()).collect();
        <[usize; 4]>::try_from(numbers).ok()
    });
    let rows: Vec<_> = rows.collect();
    assert_eq!(rows.len(), 4);
    for [forms, observations, sound, thesis] in rows {
        let is = [CRITREG_VERSION_SPACE, CRITREG_ALGORITHM1]
            .map(|learner| size(learner, forms, observations));
        assert_eq!([sound, thesis], is, "{forms}, {observations}");
    }
}
