//! The examples in C and C++ compile without warnings and do what they say.

use crate::support::{BOTH, Language, compile, root, run, scratch};
use std::process::Command;

fn output_of(file: &str, language: Language, arguments: &[&str]) -> String {
    let name = file.split('.').next().unwrap();
    let program = compile(name, &[root().join("c_examples").join(file)], language);
    let output = run(Command::new(program).args(arguments));
    String::from_utf8(output.stdout).unwrap()
}

/// The number behind a key in `key: value` lines, the first one.
fn number(output: &str, key: &str) -> f64 {
    let values = output.lines().find_map(|line| line.split_once(key));
    let (_, rest) = values.unwrap_or_else(|| panic!("no {key} in {output}"));
    let rest = rest.trim_start_matches([':', ' ']);
    let word = rest.split([' ', ',']).next().unwrap();
    word.parse().unwrap_or_else(|_| panic!("{key}: {word}"))
}

#[test]
fn pick_stick_reports_both_learners() {
    let outputs = BOTH.map(|language| output_of("pick_stick.c", language, &["8"]));
    let [output, as_cpp] = &outputs;
    assert_eq!(output, as_cpp);
    let original = number(output, "feasibility rate of the original sampler");
    assert!((0.4..0.55).contains(&original), "{original}");
    let parts: Vec<_> = output.split("\nlearner: ").skip(1).collect();
    let [sound, thesis, manual] = parts[..] else {
        panic!("three learners in {output}");
    };
    // Every seed is accounted for.
    for part in [sound, thesis, manual] {
        let nothing = number(part, "seeds that learned nothing");
        let empty = number(part, "seeds whose region is empty in all tasks");
        let useful = number(part, "seeds whose region gives draws");
        assert_eq!(nothing + empty + useful, 8.0);
    }
    assert_eq!(number(thesis, "kept"), 20_000.0);
    let all = number(thesis, "enumerated");
    assert_eq!(all, 20_000.0 + number(thesis, "left out"));
    assert!(number(thesis, "after z-") >= number(thesis, "after z+"));
    assert!(number(thesis, "after z+") >= number(thesis, "at the end"));
    // The sound learner finds the region, and says why.
    assert_eq!(number(sound, "simulator calls"), 100.0);
    assert!(number(sound, "feasibility rate") > 0.99, "{sound}");
    assert!(number(sound, "coverage") > 0.95, "{sound}");
    for part in [
        "grasp.y <= 2.9 (zone.top - robot.radius)",
        "constraint 2: ",
        "feasible to S = ",
        "certificate: 10 of 10 draws",
    ] {
        assert!(sound.contains(part), "no {part} in {sound}");
    }
}

#[test]
fn own_domain_beats_uniform_draws() {
    for language in BOTH {
        let output = output_of("own_domain.c", language, &[]);
        let rates = |line: &str| {
            let lines = output.lines().filter(|l| l.starts_with(line));
            let rates: Vec<_> = lines.map(|l| number(l, "feasibility rate")).collect();
            assert!(!rates.is_empty(), "no {line} in {output}");
            rates.into_iter().fold(1.0, f64::min)
        };
        assert!(rates("uniform: ") < 0.7, "{output}");
        assert!(rates("region by hand: 10000 draws") > 0.98, "{output}");
        assert!(rates("learned region: ") > 0.9, "{output}");
        assert!(number(&output, "seeds that learned a region") >= 5.0);
    }
}

#[test]
fn ask_tell_resumes_to_the_same_region() {
    for language in BOTH {
        let output = output_of("ask_tell.c", language, &[]);
        assert_eq!(number(&output, "samples before saving"), 10.0);
        assert_eq!(number(&output, "samples in all"), 40.0);
        assert!(
            output.contains("region of the second learner: reach - wall.x <= "),
            "{output}"
        );
        assert!(output.ends_with("the regions are identical\n"), "{output}");
    }
}

#[test]
fn plan_tasks_is_better_with_learned_regions() {
    let outputs = BOTH.map(|language| output_of("plan_tasks.c", language, &[]));
    let [rows, as_cpp] = outputs.each_ref().map(|output| {
        let rows = output.lines().filter(|line| line.starts_with("tests: "));
        let rows = rows.map(|row| row.split_once(", time_us_mean: ").unwrap().0);
        rows.collect::<Vec<_>>()
    });
    assert_eq!(rows, as_cpp);
    for tests in ["1 button", "3 or 4 buttons"] {
        let row = |sampler: &str| {
            let start = format!("tests: {tests}, sampler: {sampler}, ");
            rows.iter().find(|row| row.starts_with(&start)).unwrap()
        };
        let [original, learned] = ["original", "learned"].map(row);
        assert!(learned.contains("solved: 50/50"), "{learned}");
        let samples = number(learned, "samples_mean");
        assert!(samples < 1.1 * number(learned, "plan_length_mean"));
        assert!(number(original, "samples_mean") > 5.0 * samples);
    }
    assert!(outputs[0].contains("region of pressing by hand: button.y <= 2.9 ("));
}

#[test]
fn own_world_plans_without_a_try_in_vain() {
    let outputs = BOTH.map(|language| output_of("own_world.c", language, &[]));
    let [output, as_cpp] = &outputs;
    assert_eq!(output, as_cpp);
    for region in [
        "Pick, after 100 calls: grip - box.height >= -0.06 (-finger.length) and grip - box.height <= 0\n",
        "PutDown, after 100 calls: min(clear(spot, other_box)) >= 0.02 (gap) and inside(spot, surface) >= 0\n",
        "Pick, then PushIn, after 200 calls: dist(tips, box) - shelf.room <= -0.11 (-hand.height)",
    ] {
        assert!(output.contains(region), "no {region} in {output}");
    }
    let row = |sampler: &str| {
        let start = format!("sampler: {sampler}, solved: 50/50, ");
        let mut rows = output.lines().filter(|line| line.starts_with(&start));
        rows.next()
            .unwrap_or_else(|| panic!("no {start} in {output}"))
    };
    let [original, learned] = ["original", "learned"].map(row);
    let samples = number(learned, "samples_mean");
    assert!(
        samples <= 1.05 * number(learned, "plan_length_mean"),
        "{learned}"
    );
    assert!(
        number(original, "samples_mean") > 4.0 * samples,
        "{original}"
    );
}

/// The program in the chapter on planning of the manual.
#[test]
fn the_manual_tells_the_truth_about_its_program() {
    let header = std::fs::read_to_string(root().join("include/critreg.h")).unwrap();
    let (_, chapter) = header.split_once(" * PLANNING\n").unwrap();
    let (_, behind) = chapter.split_once(" A complete program:\n *\n").unwrap();
    let (program, told) = behind.split_once(" * It prints ").unwrap();
    let lines = program.lines().map(|line| line.get(7..).unwrap_or(""));
    let source = scratch().join("manual.c");
    std::fs::write(&source, lines.collect::<Vec<_>>().join("\n")).unwrap();
    for language in BOTH {
        let program = compile("manual", std::slice::from_ref(&source), language);
        let output = run(&mut Command::new(program));
        let printed = String::from_utf8(output.stdout).unwrap();
        let quoted: Vec<_> = printed.lines().map(|line| format!("\"{line}\"")).collect();
        assert!(told.starts_with(&quoted.join(" and ")), "{printed}");
    }
}

#[test]
fn from_cpp_tells_errors_as_exceptions() {
    let output = output_of("from_cpp.cpp", Language::Cpp17, &[]);
    for part in [
        "stopped after 5 calls: the gripper is stuck",
        "feasible from 0.01",
        "name: finger.gap",
        "learned: opening - peg.width >= 0.01 (finger.gap)",
        "written: opening >= peg.width + finger.gap",
        "[0.0700, 0.1000] 1000 draws, 1000 of them feasible",
        "peg of 0.095: 0 draws",
        "an opening for two pegs: 0.0",
        "plan with it: (Open peg) (Close peg) after 2 samples",
        "stopped: cannot run (Open peg)",
        "learned of Open, then Close: opening - peg.width >= 0.01 (finger.gap) after 200 calls",
        "plan with skills after 2 samples",
        "no plan: no sequence of up to max_length operators is left; Open failed most",
        "CRITREG_SYNTAX_ERROR: line 1, column 12: unknown name",
    ] {
        assert!(output.contains(part), "no {part} in {output}");
    }
}
