//! Several questions at once: answers in any order, late or never.

use crate::shelf::{SHELF, fits, go_on, room, saved, shelves};
use critreg::Error;
use critreg::domain::Domain;
use critreg::learn::version_space::{Capacity, Config};
use critreg::learn::{
    Learner, OBSERVATIONS_FULL, Outcome, Problem, Question, VersionSpace, open_questions, resume,
};
use critreg::random::{below, generator};
use critreg_tests::pick;
use critreg_tests::room::{Algorithm1Room, VersionSpaceRoom};
use proptest::prelude::*;

const INSTANCES: usize = 8;

fn config(seed: u64, noise: bool) -> Config {
    Config {
        seed,
        calls: 60,
        noise: if noise { 0.05 } else { 0.0 },
        ..Config::default()
    }
}

/// As many questions as there are, up to a number.
fn ask(learner: &mut impl Learner, problem: &Problem<'_>, wanted: usize) -> Vec<Question> {
    let more = || learner.ask_more(problem).unwrap();
    std::iter::from_fn(more).take(wanted).collect()
}

fn answer(learner: &mut impl Learner, problem: &Problem<'_>, question: &Question) {
    let outcome = fits(problem, &question.query);
    learner.tell_id(problem, question.id, outcome).unwrap();
}

/// Runs a test of a learner about shelves.
fn with_learner<T>(
    seed: u64,
    capacity: Capacity,
    test: impl FnOnce(&mut VersionSpace<'_, f64>, &Problem<'_>) -> T,
) -> T {
    let domain = Domain::parse(SHELF).unwrap();
    let instances = shelves(seed, INSTANCES);
    let problem = Problem::new(&domain, &instances, INSTANCES).unwrap();
    let mut room = VersionSpaceRoom::new(capacity);
    let mut learner = room.learner(&domain, config(seed, false)).unwrap();
    test(&mut learner, &problem)
}

fn capacity(questions: usize) -> Capacity {
    Capacity {
        questions,
        ..Capacity::new(4096, 256)
    }
}

#[test]
fn open_questions_are_about_different_samples() {
    with_learner(1, capacity(16), |learner, problem| {
        let mut open: Vec<Question> = Vec::new();
        while !learner.is_finished() {
            open.extend(ask(learner, problem, usize::MAX));
            let calls = learner.report().calls;
            assert_eq!(open.len(), 16.min(60 - calls), "as many as it can");
            for (place, own) in open.iter().enumerate() {
                let others = &open[..place];
                assert!(
                    others
                        .iter()
                        .all(|o| o.id != own.id && o.query != own.query)
                );
            }
            assert_eq!(open_questions(learner).collect::<Vec<_>>(), open);
            let question = open.remove(0);
            answer(learner, problem, &question);
        }
        assert_eq!(ask(learner, problem, 1), []);
    });
}

#[test]
fn one_question_at_a_time_is_what_ask_asks() {
    let run = |by_id: bool| {
        with_learner(2, capacity(16), |learner, problem| {
            while !learner.is_finished() {
                match by_id {
                    true => {
                        let question = learner.ask_more(problem).unwrap().unwrap();
                        answer(learner, problem, &question);
                    }
                    false => go_on(learner, problem, 1),
                }
            }
            (learner.observations().to_vec(), learner.report())
        })
    };
    assert_eq!(run(true), run(false));
}

#[test]
fn sixteen_workers_find_the_region_of_one() {
    let region = |seed, workers| {
        with_learner(seed, capacity(workers), |learner, problem| {
            while !learner.is_finished() {
                for question in ask(learner, problem, workers) {
                    answer(learner, problem, &question);
                }
            }
            learner
                .region()
                .unwrap()
                .display(problem.domain())
                .to_string()
        })
    };
    // Both margins, which are named if all ends are found. Of sixteen questions at once some
    // are superfluous.
    let is_right = |text: &String| text.matches("margin").count() == 2;
    for (workers, least) in [(1, 7), (16, 6)] {
        let found: Vec<String> = (0..8).map(|seed| region(seed, workers)).collect();
        let right = found.iter().filter(|text| is_right(text)).count();
        assert!(
            right >= least,
            "{right} of 8 with {workers} workers: {found:#?}"
        );
    }
}

#[test]
fn a_forgotten_question_may_be_answered_late() {
    with_learner(4, capacity(2), |learner, problem| {
        let [first, second] = ask(learner, problem, 2)[..] else {
            panic!("two questions")
        };
        assert_eq!(ask(learner, problem, 1), [], "there is no room for more");
        learner.forget(first.id).unwrap();
        answer(learner, problem, &first);
        answer(learner, problem, &second);
        assert_eq!(learner.report().calls, 2);

        let [first, second] = ask(learner, problem, 2)[..] else {
            panic!("two questions")
        };
        learner.forget(first.id).unwrap();
        // Its place is needed.
        assert_eq!(ask(learner, problem, 2).len(), 1);
        let late = learner.tell_id(problem, first.id, Outcome::Feasible);
        assert!(matches!(late, Err(Error::OutOfSequence(_))));
        learner
            .observe(problem, &first.query, fits(problem, &first.query))
            .unwrap();
        answer(learner, problem, &second);
        let again = learner.tell_id(problem, second.id, Outcome::Feasible);
        assert!(matches!(again, Err(Error::OutOfSequence(_))));
        assert!(matches!(learner.forget(0), Err(Error::OutOfSequence(_))));
    });
}

#[test]
fn what_is_unknown_is_not_asked_again_at_once() {
    with_learner(5, capacity(16), |learner, problem| {
        let mut before: Option<Question> = None;
        while !learner.is_finished() {
            let question = learner.ask_more(problem).unwrap().unwrap();
            assert!(before.is_none_or(|own| own.query != question.query));
            learner
                .tell_id(problem, question.id, Outcome::Unknown)
                .unwrap();
            before = Some(question);
        }
        assert_eq!(learner.report().unknown, 60);
    });
}

#[test]
fn no_answer_is_lost_for_want_of_room() {
    let capacity = Capacity {
        questions: 16,
        ..Capacity::new(4096, 10)
    };
    with_learner(6, capacity, |learner, problem| {
        let questions = ask(learner, problem, 16);
        // The last ones wait for the first.
        for question in questions[1..11].iter().rev() {
            answer(learner, problem, question);
        }
        let full = Err(OBSERVATIONS_FULL);
        let first = questions[0];
        assert_eq!(learner.tell_id(problem, first.id, Outcome::Feasible), full);
        assert_eq!(
            learner.observe(problem, &first.query, Outcome::Feasible),
            full
        );
        learner.conclude(problem).unwrap();
        assert_eq!(learner.report().calls, 10);
    });
}

#[test]
fn the_baseline_has_one_question() {
    let domain = Domain::parse(SHELF).unwrap();
    let instances = shelves(7, INSTANCES);
    let problem = Problem::new(&domain, &instances, INSTANCES).unwrap();
    let mut room = Algorithm1Room::new(4096, 64);
    let (capacity, mut config) = (room.capacity, pick::config(7));
    (config.negative, config.positive, config.iterations) = (None, None, 8);
    let mut learner =
        critreg::learn::Algorithm1::<f64>::new(&domain, config, capacity, room.lend()).unwrap();
    let question = learner.ask_more(&problem).unwrap().unwrap();
    assert_eq!(learner.ask_more(&problem).unwrap(), None);
    learner.forget(question.id).unwrap();
    assert_eq!(learner.ask_more(&problem).unwrap(), Some(question));
    assert!(
        learner
            .tell_id(&problem, question.id + 1, Outcome::Feasible)
            .is_err()
    );
    answer(&mut learner, &problem, &question);
    assert_eq!(learner.observations().len(), 1);
}

/// What a program does with a learner and its workers.
#[derive(Clone, Copy, Debug)]
enum Deed {
    Ask(usize),
    /// One that is open, by its place.
    Answer(usize),
    Lose(usize),
    Observe,
    Conclude,
}

fn deeds(most: usize) -> impl Strategy<Value = Vec<Deed>> {
    let deed = prop_oneof![
        3 => (1usize..6).prop_map(Deed::Ask),
        8 => (0usize..16).prop_map(Deed::Answer),
        1 => (0usize..16).prop_map(Deed::Lose),
        1 => Just(Deed::Observe),
        1 => Just(Deed::Conclude),
    ];
    prop::collection::vec(deed, 0..most)
}

/// Does it, as far as it is possible.
fn perform(learner: &mut VersionSpace<'_, f64>, problem: &Problem<'_>, deed: Deed) {
    let open: Vec<Question> = open_questions(learner).collect();
    let at = |place: usize| open.get(place % open.len().max(1));
    match deed {
        Deed::Ask(wanted) => {
            ask(learner, problem, wanted);
        }
        Deed::Answer(place) => {
            if let Some(question) = at(place) {
                answer(learner, problem, question);
            }
        }
        Deed::Lose(place) => {
            if let Some(question) = at(place) {
                learner.forget(question.id).unwrap();
            }
        }
        Deed::Observe => {
            let mut rng = generator(learner.observations().len() as u64);
            let instance = below(&mut rng, problem.count());
            let mut query = critreg::learn::Query {
                instance,
                theta: Default::default(),
            };
            query.theta[..2].fill(0.25 * below(&mut rng, 16) as f64);
            let outcome = fits(problem, &query);
            learner.observe(problem, &query, outcome).unwrap();
        }
        Deed::Conclude => learner.conclude(problem).unwrap(),
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(24))]

    #[test]
    fn the_order_of_answers_does_not_matter(
        seed in any::<u64>(), noise in any::<bool>(), rounds in 1usize..6,
        wanted in 2usize..16, lost in 0usize..3,
    ) {
        let domain = Domain::parse(SHELF).unwrap();
        let instances = shelves(seed, INSTANCES);
        let problem = Problem::new(&domain, &instances, INSTANCES).unwrap();
        let mut rng = generator(seed);
        let (mut first, mut second) = (room(256), room(256));
        let mut sorted = first.learner(&domain, config(seed, noise)).unwrap();
        let mut shuffled = second.learner(&domain, config(seed, noise)).unwrap();
        for _ in 0..rounds {
            let questions = ask(&mut sorted, &problem, wanted);
            prop_assert_eq!(&ask(&mut shuffled, &problem, wanted), &questions);
            // Some stay open.
            let mut told = open_questions(&sorted).collect::<Vec<_>>();
            for _ in 0..lost.min(told.len()) {
                told.remove(below(&mut rng, told.len()));
            }
            for question in &told {
                answer(&mut sorted, &problem, question);
            }
            while !told.is_empty() {
                let question = told.swap_remove(below(&mut rng, told.len()));
                answer(&mut shuffled, &problem, &question);
            }
        }
        sorted.conclude(&problem).unwrap();
        shuffled.conclude(&problem).unwrap();
        prop_assert_eq!(shuffled.observations(), sorted.observations());
        prop_assert_eq!(shuffled.region(), sorted.region());
        prop_assert_eq!(shuffled.report(), sorted.report());
    }

    #[test]
    fn a_run_is_resumed_with_its_open_questions(
        seed in any::<u64>(), noise in any::<bool>(), before in deeds(120), after in deeds(60),
    ) {
        let domain = Domain::parse(SHELF).unwrap();
        let instances = shelves(seed, INSTANCES);
        let problem = Problem::new(&domain, &instances, INSTANCES).unwrap();
        let (mut first, mut second) = (room(256), room(256));
        let mut whole = first.learner(&domain, config(seed, noise)).unwrap();
        for deed in before {
            perform(&mut whole, &problem, deed);
        }
        let mut part = second.learner(&domain, config(seed, noise)).unwrap();
        resume(&mut part, &problem, &saved(&whole, &problem)).unwrap();
        prop_assert!(open_questions(&part).eq(open_questions(&whole)));
        prop_assert_eq!(saved(&part, &problem), saved(&whole, &problem));
        for deed in after {
            perform(&mut whole, &problem, deed);
            perform(&mut part, &problem, deed);
        }
        prop_assert_eq!(part.observations(), whole.observations());
        prop_assert_eq!(part.region(), whole.region());
        prop_assert_eq!(part.report(), whole.report());
    }
}
