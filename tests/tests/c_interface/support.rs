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

/// The directory with the library that `make` at the top builds and installs.
pub(crate) fn library_directory() -> &'static Path {
    static DIRECTORY: OnceLock<PathBuf> = OnceLock::new();
    DIRECTORY.get_or_init(|| {
        let target = scratch().parent().expect("it is in the target directory");
        run(Command::new("make")
            .args(["--silent", "-C"])
            .arg(root())
            .arg("library")
            .env("CARGO_TARGET_DIR", target)
            // Settings of the test build, such as sanitizers, do not belong here.
            .env_remove("CARGO_ENCODED_RUSTFLAGS")
            .env_remove("RUSTFLAGS"));
        target.join("c")
    })
}

/// The compiler that an environment variable names, or this one.
pub(crate) fn compiler(variable: &str, default: &str) -> String {
    env::var(variable).unwrap_or(String::from(default))
}

/// Compiles a program from source files with warnings as errors, links it with
/// the static library and returns its path.
pub(crate) fn compile(name: &str, sources: &[PathBuf], language: Language) -> PathBuf {
    compile_with(name, sources, language, &[])
}

/// The same with more flags of the compiler.
pub(crate) fn compile_with(
    name: &str,
    sources: &[PathBuf],
    language: Language,
    flags: &[&str],
) -> PathBuf {
    let mut command = match language {
        Language::C99 => Command::new(compiler("CC", "cc")),
        Language::Cpp17 => Command::new(compiler("CXX", "c++")),
    };
    match language {
        Language::C99 => command.arg("-std=c99"),
        Language::Cpp17 => command.args(["-std=c++17", "-x", "c++"]),
    };
    let library = library_directory().join("libcritreg.a");
    let program = scratch().join(format!("{name}_{language:?}"));
    command
        .args(["-Wall", "-Wextra", "-Wpedantic", "-Werror", "-O1", "-g"])
        .args(flags)
        .arg("-I")
        .arg(root().join("include"))
        .args(sources)
        // What follows is no source file.
        .args(["-x", "none"])
        .arg(library)
        .args(["-lm", "-lpthread", "-o"])
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
