//! Writes the pictures: `picture -- <folder>`.

use critreg_tests::picture::pictures;
use std::path::PathBuf;
use std::process::ExitCode;

fn main() -> ExitCode {
    let Some(folder) = std::env::args_os().nth(1).map(PathBuf::from) else {
        eprintln!("usage: picture <folder>");
        return ExitCode::FAILURE;
    };
    for (name, text) in pictures() {
        let path = folder.join(name);
        if let Err(error) = std::fs::write(&path, text) {
            eprintln!("{}: {error}", path.display());
            return ExitCode::FAILURE;
        }
        println!("drew {}", path.display());
    }
    ExitCode::SUCCESS
}
