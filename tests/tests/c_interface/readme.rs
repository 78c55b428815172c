//! The README's program compiles, runs, and prints what the README says.

use crate::support::{BOTH, compile, root, run, scratch};
use std::process::Command;

/// The first block of this language in the README.
fn block<'t>(readme: &'t str, opening: &str) -> &'t str {
    let (_, behind) = readme.split_once(opening).expect("the block starts");
    let (block, _) = behind.split_once("\n```").expect("the block ends");
    block
}

#[test]
fn the_readme_tells_the_truth_about_its_program() {
    let readme = std::fs::read_to_string(root().join("README.md")).unwrap();
    let source = scratch().join("readme.c");
    std::fs::write(&source, block(&readme, "```c\n")).unwrap();
    let printed = block(&readme, "It prints\n\n```\n");
    for language in BOTH {
        let program = compile("readme", std::slice::from_ref(&source), language);
        let output = run(&mut Command::new(program));
        assert_eq!(
            String::from_utf8(output.stdout).unwrap().trim_end(),
            printed
        );
    }
}
