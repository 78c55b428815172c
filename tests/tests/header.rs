//! `include/critreg.h` is generated, committed, and what the interface is now.

use std::fs;
use std::path::{Path, PathBuf};

/// The files with the interface, in the order in which the manual tells it.
const SOURCES: [&str; 10] = [
    "status.rs",
    "memory.rs",
    "config.rs",
    "learner.rs",
    "learning.rs",
    "region.rs",
    "sampling.rs",
    "rng.rs",
    "check.rs",
    "stick_button.rs",
];

fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("..")
}

fn generated() -> String {
    let ffi = root().join("ffi");
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
    let path = root().join("include/critreg.h");
    let expected = generated();
    if std::env::var_os("CRITREG_UPDATE_HEADER").is_some() {
        fs::write(&path, &expected).unwrap();
    }
    let committed = fs::read_to_string(&path).unwrap_or_default();
    assert!(
        committed == expected,
        "include/critreg.h does not describe the interface as it is; update it with\n    \
         CRITREG_UPDATE_HEADER=1 cargo test -p critreg-tests --test header"
    );
}

#[test]
fn no_file_of_the_interface_is_left_out() {
    for entry in fs::read_dir(root().join("ffi/src")).unwrap() {
        let path = entry.unwrap().path();
        let exports = fs::read_to_string(&path).unwrap().contains("no_mangle");
        let name = path.file_name().unwrap().to_str().unwrap();
        assert!(!exports || SOURCES.contains(&name), "{name} is left out");
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
