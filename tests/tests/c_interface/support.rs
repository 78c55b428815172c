//! Builds the library as C programs get it, compiles programs and runs them.

use std::env;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};
use std::sync::OnceLock;

/// The languages in which a C program must be valid.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Language {
    C99,
    Cpp17,
}

pub(crate) const BOTH: [Language; 2] = [Language::C99, Language::Cpp17];

/// The top of the repository.
pub(crate) fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("..")
}

/// Where the tests put what they write, a folder in the target directory.
pub(crate) fn scratch() -> &'static Path {
    Path::new(env!("CARGO_TARGET_TMPDIR"))
}

/// The directory with the release build of the library, which is also the one that
/// `make -C c_examples` uses: it is built once.
pub(crate) fn library_directory() -> &'static Path {
    static DIRECTORY: OnceLock<PathBuf> = OnceLock::new();
    DIRECTORY.get_or_init(|| {
        let target = scratch().parent().expect("it is in the target directory");
        let mut cargo = Command::new(env::var_os("CARGO").unwrap_or("cargo".into()));
        cargo.args(["build", "--quiet", "--release", "--package", "critreg-ffi"]);
        cargo.arg("--manifest-path").arg(root().join("Cargo.toml"));
        cargo.arg("--target-dir").arg(target);
        // Settings of the test build, such as sanitizers, do not belong here.
        run(cargo
            .env_remove("CARGO_ENCODED_RUSTFLAGS")
            .env_remove("RUSTFLAGS"));
        target.join("release")
    })
}

/// Compiles a program from source files with warnings as errors, links it with
/// the static library and returns its path.
pub(crate) fn compile(name: &str, sources: &[PathBuf], language: Language) -> PathBuf {
    let compiler = |variable, default| env::var(variable).unwrap_or(String::from(default));
    let mut command = match language {
        Language::C99 => Command::new(compiler("CC", "cc")),
        Language::Cpp17 => Command::new(compiler("CXX", "c++")),
    };
    match language {
        Language::C99 => command.arg("-std=c99"),
        Language::Cpp17 => command.args(["-std=c++17", "-x", "c++"]),
    };
    let library = library_directory().join("libcritreg_ffi.a");
    let program = scratch().join(format!("{name}_{language:?}"));
    command
        .args(["-Wall", "-Wextra", "-Wpedantic", "-Werror", "-O1", "-g"])
        .arg("-I")
        .arg(root().join("include"))
        .args(sources)
        // What follows is no source file.
        .args(["-x", "none"])
        .arg(library)
        .args(["-lpthread", "-ldl", "-lm", "-o"])
        .arg(&program);
    run(&mut command);
    program
}

/// Runs a command and fails the test with its output if it fails.
pub(crate) fn run(command: &mut Command) -> Output {
    let output = command
        .output()
        .unwrap_or_else(|error| panic!("{command:?}: {error}"));
    assert!(
        output.status.success(),
        "{command:?}: {}\n{}{}",
        output.status,
        String::from_utf8_lossy(&output.stdout),
        String::from_utf8_lossy(&output.stderr)
    );
    output
}
