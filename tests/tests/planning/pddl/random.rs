//! Properties over random problems and damaged texts.

use super::{ALL, BLOCKS, DELIVERY, GRIPPER, ground, oracle};
use critreg::pddl;
use proptest::collection::vec;
use proptest::prelude::*;
use proptest::sample::{Index, subsequence};

/// A problem with these objects, of which some of `facts` hold initially and some
/// shall hold in the end.
fn problem(
    domain: &str,
    objects: &str,
    facts: Vec<String>,
) -> impl Strategy<Value = String> + use<> {
    let header = format!("(define (problem p) (:domain {domain}) (:objects {objects})");
    let count = facts.len();
    let some = |most: usize| subsequence(facts.clone(), 0..=count.min(most));
    (some(count), some(5)).prop_map(move |(initial, goal)| {
        let (initial, goal) = (initial.concat(), goal.concat());
        format!("{header} (:init {initial}) (:goal (and {goal})))")
    })
}

/// `b0 B1 b2 ...`: case must not matter for their order.
fn names(word: &str, count: usize) -> Vec<String> {
    let upper = word.to_uppercase();
    let word = |i: usize| if i.is_multiple_of(2) { word } else { &upper };
    (0..count).map(|i| format!("{}{i}", word(i))).collect()
}

/// All atoms of a predicate with two arguments.
fn pairs(predicate: &str, firsts: &[String], seconds: &[String]) -> Vec<String> {
    let with = |a| move |b| format!("({predicate} {a} {b})");
    firsts
        .iter()
        .flat_map(|a| seconds.iter().map(with(a)))
        .collect()
}

/// All atoms of a predicate with one argument.
fn singles(predicate: &str, objects: &[String]) -> Vec<String> {
    objects
        .iter()
        .map(|a| format!("({predicate} {a})"))
        .collect()
}

fn blocks() -> impl Strategy<Value = String> {
    (1..7_usize).prop_flat_map(|count| {
        let blocks = names("b", count);
        let facts = [pairs("on", &blocks, &blocks), singles("clear", &blocks)].concat();
        problem("blocks", &format!("{} - block", blocks.join(" ")), facts)
    })
}

fn gripper() -> impl Strategy<Value = String> {
    (0..7_usize).prop_flat_map(|count| {
        let things = names("x", count);
        let kinds = ["room", "ball", "hand", "free"].map(|kind| singles(kind, &things));
        let facts = [kinds.concat(), pairs("in", &things, &things)].concat();
        problem("gripper", &things.join(" "), facts)
    })
}

fn delivery() -> impl Strategy<Value = String> {
    (0..4_usize, 0..3_usize, 0..3_usize, 0..3_usize).prop_flat_map(|(p, t, d, x)| {
        let lists = [names("p", p), names("t", t), names("d", d), names("x", x)];
        let [mut places, trucks, drones, parcels] = lists;
        let objects = [
            format!("{} - drone", drones.join(" ")),
            format!("{} - place", places.join(" ")),
            format!("{} - truck", trucks.join(" ")),
            format!("{} - parcel", parcels.join(" ")),
        ];
        let given = [&places, &trucks, &drones, &parcels].map(Vec::len);
        let objects = objects.iter().zip([given[2], given[0], given[1], given[3]]);
        let objects: Vec<_> = objects
            .filter(|(_, n)| *n > 0)
            .map(|(o, _)| o.clone())
            .collect();
        places.push("depot".into());
        let facts = [
            pairs("road", &places, &places),
            pairs("docked", &drones, &trucks),
            pairs("at", &trucks, &places),
            singles("carried-out", &parcels),
        ];
        problem("delivery", &objects.join(" "), facts.concat())
    })
}

/// Words and brackets of a text.
fn words(text: &str) -> Vec<String> {
    let code: Vec<_> = text
        .lines()
        .filter_map(|line| line.split(';').next())
        .collect();
    let spaced = code.join(" ").replace('(', " ( ").replace(')', " ) ");
    spaced.split_whitespace().map(String::from).collect()
}

/// One of the texts with up to three words replaced, repeated, swapped or left out.
fn damaged() -> impl Strategy<Value = [String; 2]> {
    let changes = vec((0..4_u8, any::<Index>(), any::<Index>()), 0..4);
    (0..ALL.len(), 0..2_usize, changes).prop_map(|(which, part, changes)| {
        let mut texts = ALL[which].map(words);
        let vocabulary = [texts[0].clone(), texts[1].clone()].concat();
        let text = &mut texts[part];
        for (kind, at, other) in changes {
            let (place, second) = (at.index(text.len()), other.index(text.len()));
            match kind {
                0 => text[place] = other.get(&vocabulary).clone(),
                1 => text.insert(place, other.get(&vocabulary).clone()),
                2 => text.swap(place, second),
                _ => drop(text.remove(place)),
            }
        }
        texts.map(|words| words.join(" "))
    })
}

/// Whatever is read is written such that it is read again as the same. Whether the
/// domain, and whether the problem was read.
fn read_and_write(texts: [&str; 2]) -> [bool; 2] {
    let Ok(domain) = pddl::Domain::parse(texts[0]) else {
        return [false; 2];
    };
    let domain_text = domain.to_string();
    assert_eq!(
        pddl::Domain::parse(&domain_text).as_ref(),
        Ok(&domain),
        "{domain_text}"
    );
    let mut memory = [pddl::Fact::default(); 64];
    let Ok(problem) = pddl::Problem::parse(&domain, texts[1], &mut memory) else {
        return [true, false];
    };
    let problem_text = problem.to_string();
    let mut again = [pddl::Fact::default(); 64];
    let again = pddl::Problem::parse(&domain, &problem_text, &mut again);
    assert_eq!(again.as_ref(), Ok(&problem), "{problem_text}");
    assert_eq!(ground([&domain_text, &problem_text]), ground(texts));
    [true; 2]
}

#[test]
fn writing_and_reading() {
    for texts in ALL {
        assert_eq!(read_and_write(texts), [true; 2]);
    }
}

proptest! {
    #[test]
    fn random_blocks(problem in blocks()) {
        prop_assert_eq!(lower([BLOCKS[0], &problem]), oracle::ground(BLOCKS[0], &problem));
    }

    #[test]
    fn random_grippers(problem in gripper()) {
        prop_assert_eq!(lower([GRIPPER[0], &problem]), oracle::ground(GRIPPER[0], &problem));
    }

    #[test]
    fn random_deliveries(problem in delivery()) {
        prop_assert_eq!(lower([DELIVERY[0], &problem]), oracle::ground(DELIVERY[0], &problem));
    }

    #[test]
    fn damaged_texts(texts in damaged()) {
        read_and_write([&texts[0], &texts[1]]);
    }

    #[test]
    fn any_text(text in any::<String>(), part in "[-()=?:;a-z0-9 \n]{0,60}") {
        let beginnings = ["", "(define (domain d) ", "(define (domain d) (:predicates (p)) (:action a :parameters "];
        for begin in beginnings {
            for end in [&text, &part] {
                read_and_write([&format!("{begin}{end}"), ""]);
                read_and_write([DELIVERY[0], &format!("(define (problem p) (:domain delivery) {end}")]);
            }
        }
    }
}

/// Grounds a problem as if it were written in lower case. The order must be the
/// same, so only the words of the answer are changed.
fn lower(texts: [&str; 2]) -> oracle::Ground {
    let (mut found, _) = ground(texts).unwrap();
    let lower = |words: &mut std::collections::BTreeSet<String>| {
        *words = words.iter().map(|word| word.to_lowercase()).collect();
    };
    for operator in &mut found.operators {
        operator.name = operator.name.to_lowercase();
        lower(&mut operator.preconditions);
        lower(&mut operator.adds);
        lower(&mut operator.deletes);
    }
    lower(&mut found.initial);
    lower(&mut found.goal);
    found
}
