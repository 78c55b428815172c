//! Heuristics, search and regression against brute force on small random tasks.

use critreg::Error;
use critreg::plan::{
    AbstractTask, Advice, Cached, Config, Estimate, Estimator, Guide, Heuristic, HeuristicMemory,
    Metrics, Progress, ReasonId, Search, SearchMemory, SearchNode, Skeleton, Unguided, Waiting,
    links,
};
use critreg::random::generator;
use critreg::task::{Arguments, AtomSet, GroundOperator, OperatorId};
use proptest::collection::vec;
use proptest::prelude::*;
use std::collections::BTreeSet;

/// Atoms of a random task.
const ATOMS: u32 = 6;

/// A small STRIPS problem; sets of atoms as bits.
#[derive(Clone, Debug)]
struct Strips {
    operators: Vec<[u8; 3]>,
    initial: u8,
    goal: u8,
}

fn strips() -> impl Strategy<Value = Strips> {
    // Few preconditions and effects each: two random sets share few atoms.
    let few = || (0..1u8 << ATOMS, 0..1u8 << ATOMS).prop_map(|(a, b)| a & b);
    let operator = (few(), few(), few()).prop_map(|(pre, add, delete)| [pre, add, delete]);
    (vec(operator, 4..13), few(), 0..1u8 << ATOMS).prop_map(|(operators, initial, goal)| Strips {
        operators,
        initial,
        goal,
    })
}

fn set(bits: u8) -> AtomSet {
    let places = (0..8).filter(|place| bits >> place & 1 == 1);
    places.fold(AtomSet::EMPTY, |set, place| {
        set.union(AtomSet::single(place))
    })
}

impl Strips {
    fn ground(&self) -> Vec<GroundOperator> {
        let ground = |[pre, add, delete]: &[u8; 3]| GroundOperator {
            operator: OperatorId(0),
            objects: Arguments::default(),
            cost: 1,
            preconditions: set(*pre),
            add_effects: set(*add),
            delete_effects: set(*delete),
        };
        self.operators.iter().map(ground).collect()
    }

    /// The cost of the goal by breadth-first search over all abstract states.
    fn optimal(&self, delete: bool) -> Option<u32> {
        let mut layer = BTreeSet::from([self.initial]);
        let mut seen = layer.clone();
        for cost in 0.. {
            if layer.iter().any(|state| self.goal & !state == 0) {
                return Some(cost);
            }
            if layer.is_empty() {
                break;
            }
            let successors = layer.iter().flat_map(|&state| {
                let applicable = self
                    .operators
                    .iter()
                    .filter(move |[pre, ..]| pre & !state == 0);
                applicable.map(move |[_, add, del]| {
                    if delete {
                        state & !del | add
                    } else {
                        state | add
                    }
                })
            });
            layer = successors.filter(|state| !seen.contains(state)).collect();
            seen.extend(&layer);
        }
        None
    }

    /// The cost of the goal from the equations of h-max and h-add, iterated until
    /// they hold: an atom costs one more than the cheapest operator that adds it,
    /// which costs what `join` makes of its preconditions.
    fn equations(&self, join: fn(&[u32]) -> u32) -> Option<u32> {
        const NEVER: u32 = 1_000_000;
        let mut cost: Vec<_> = (0..8)
            .map(|atom| {
                if self.initial >> atom & 1 == 1 {
                    0
                } else {
                    NEVER
                }
            })
            .collect();
        let of = |cost: &[u32], atoms: u8| {
            let costs: Vec<_> = (0..8)
                .filter(|a| atoms >> a & 1 == 1)
                .map(|a| cost[a])
                .collect();
            join(&costs)
        };
        for _ in 0..100 {
            for [pre, add, _] in &self.operators {
                let after = of(&cost, *pre) + 1;
                for atom in (0..8).filter(|atom| add >> atom & 1 == 1) {
                    cost[atom] = cost[atom].min(after);
                }
            }
        }
        Some(of(&cost, self.goal)).filter(|cost| *cost < NEVER)
    }

    /// All sequences of up to `length` operators that reach the goal at their end
    /// and not before, without certain operators.
    fn skeletons(&self, length: usize, banned: u16) -> BTreeSet<Vec<u16>> {
        let mut found = BTreeSet::new();
        let mut open = vec![(self.initial, vec![])];
        while let Some((state, sequence)) = open.pop() {
            if self.goal & !state == 0 {
                found.insert(sequence);
                continue;
            }
            for (place, [pre, add, del]) in self.operators.iter().enumerate() {
                if sequence.len() < length && banned >> place & 1 == 0 && pre & !state == 0 {
                    let mut longer = sequence.clone();
                    longer.push(place as u16);
                    open.push((state & !del | add, longer));
                }
            }
        }
        found
    }
}

fn estimate(strips: &Strips, heuristic: Heuristic, cached: usize) -> Option<u32> {
    let operators = strips.ground();
    let task = AbstractTask {
        operators: &operators,
        initial: set(strips.initial),
        goal: set(strips.goal),
    };
    let memory = HeuristicMemory {
        operators: &mut vec![Progress::default(); operators.len()],
        links: &mut vec![0; links(&operators)],
        cache: &mut vec![Cached::default(); cached],
    };
    let mut estimator = Estimator::new(heuristic, task, memory).unwrap();
    let estimates: Vec<_> = (0..1u8 << ATOMS)
        .chain([strips.initial])
        .map(|state| estimator.estimate(set(state)))
        .collect();
    let (last, all) = estimates.split_last().unwrap();
    assert_eq!(
        *last,
        all[usize::from(strips.initial)],
        "the cache changes nothing"
    );
    match last {
        Estimate::Cost(cost) => Some(*cost),
        Estimate::Unreachable => None,
    }
}

/// Bans operators by their place: their sequences are pruned or postponed.
struct Ban {
    operators: u16,
    advice: Advice,
}

impl Guide for Ban {
    fn judge(&mut self, prefix: Skeleton<'_>) -> Advice {
        let last = prefix.places().last().unwrap();
        if self.operators >> last & 1 == 1 {
            self.advice
        } else {
            Advice::Keep
        }
    }
}

/// The skeletons in the order of the search until all up to a length were found, or
/// what ended the search before: those found with advice, then those without.
fn search_twice(
    strips: &Strips,
    config: &Config,
    guide: &mut impl Guide,
    length: usize,
    room: usize,
) -> ([Vec<Vec<u16>>; 2], Result<(), Error>) {
    let operators = strips.ground();
    let task = AbstractTask {
        operators: &operators,
        initial: set(strips.initial),
        goal: set(strips.goal),
    };
    let memory = SearchMemory {
        heuristic: HeuristicMemory {
            operators: &mut vec![Progress::default(); operators.len()],
            links: &mut vec![0; links(&operators)],
            cache: &mut [Cached::default(); 16],
        },
        nodes: &mut vec![SearchNode::default(); room],
        open: &mut vec![Waiting::default(); room],
        visited: &mut vec![0; room],
    };
    let mut metrics = Metrics::new(&mut [], &mut []);
    let lots = generator(1);
    let mut search = Search::new(task, config, lots, memory, &mut metrics).unwrap();
    let mut found: [Vec<Vec<u16>>; 2] = [vec![], vec![]];
    loop {
        match search.next_skeleton(guide, &mut metrics) {
            Ok(Some(skeleton)) => {
                // Where nothing was postponed, what comes later is not shorter.
                let again = metrics.advised.is_some();
                if (again || metrics.postponed == 0) && skeleton.len() > length {
                    return (found, Ok(()));
                }
                found[usize::from(again)].push(skeleton.places().to_vec());
            }
            Ok(None) => return (found, Ok(())),
            Err(full) => {
                let counts = (metrics.nodes_expanded, metrics.nodes_created);
                let again = search.next_skeleton(guide, &mut metrics).map(|_| ());
                assert_eq!(again, Err(full), "the search stays as it was");
                assert_eq!((metrics.nodes_expanded, metrics.nodes_created), counts);
                return (found, Err(full));
            }
        }
    }
}

/// As [`search_twice`], if nothing is postponed.
fn search(
    strips: &Strips,
    config: &Config,
    guide: &mut impl Guide,
    length: usize,
    room: usize,
) -> (Vec<Vec<u16>>, Result<(), Error>) {
    let ([found, again], end) = search_twice(strips, config, guide, length, room);
    assert!(again.is_empty());
    (found, end)
}

fn config(heuristic: Heuristic, patience: u32) -> Config {
    Config {
        heuristic,
        patience,
        ..Config::default()
    }
}

/// Sequences this long are searched.
const LENGTH: usize = 3;
/// Nodes of the search.
const ROOM: usize = 8192;

proptest! {
    #![proptest_config(ProptestConfig::with_cases(400))]

    #[test]
    fn heuristics_keep_their_promises(strips in strips()) {
        let [cut, max, additive, blind] = [
            Heuristic::LandmarkCut,
            Heuristic::Max,
            Heuristic::Additive,
            Heuristic::Blind,
        ]
        .map(|heuristic| estimate(&strips, heuristic, 16));
        let relaxed = strips.optimal(false);
        prop_assert_eq!(max, strips.equations(|costs| costs.iter().copied().max().unwrap_or(0)));
        prop_assert_eq!(additive, strips.equations(|costs| costs.iter().sum()));
        prop_assert_eq!(blind, Some(0));
        // Never is nothing for all of them, and exactly if the goal cannot be
        // reached without deletes.
        prop_assert_eq!([cut, max, additive].map(|h| h.is_none()), [relaxed.is_none(); 3]);
        prop_assert!(max <= cut && cut <= relaxed && relaxed <= additive);
        if let Some(optimal) = strips.optimal(true) {
            prop_assert!(relaxed <= Some(optimal));
        }
        prop_assert_eq!(estimate(&strips, Heuristic::LandmarkCut, 0), cut, "without a cache");
    }

    #[test]
    fn search_finds_every_skeleton_once_and_shorter_ones_first(strips in strips()) {
        for heuristic in [Heuristic::LandmarkCut, Heuristic::Max, Heuristic::Blind] {
            let config = config(heuristic, 0);
            let (found, end) = search(&strips, &config, &mut Unguided, LENGTH, ROOM);
            prop_assert!(found.is_sorted_by_key(|skeleton| skeleton.len()));
            let expected = strips.skeletons(LENGTH, 0);
            let set: BTreeSet<_> = found.iter().filter(|s| s.len() <= LENGTH).cloned().collect();
            prop_assert!(set.is_subset(&expected));
            if end.is_ok() {
                prop_assert_eq!(found.len(), set.len());
                prop_assert_eq!(set, expected);
            }
        }
    }

    /// As in a graph: the first skeleton is a shortest one, and that there is none is
    /// found out.
    #[test]
    fn states_that_are_recognised_end_the_search(strips in strips()) {
        let config = Config {
            skeletons_per_state: 1,
            ..config(Heuristic::LandmarkCut, 0)
        };
        let (operators, room) = (strips.ground(), ROOM);
        let task = AbstractTask {
            operators: &operators,
            initial: set(strips.initial),
            goal: set(strips.goal),
        };
        let memory = SearchMemory {
            heuristic: HeuristicMemory {
                operators: &mut vec![Progress::default(); operators.len()],
                links: &mut vec![0; links(&operators)],
                cache: &mut [],
            },
            nodes: &mut vec![SearchNode::default(); room],
            open: &mut vec![Waiting::default(); room],
            visited: &mut vec![0; 256],
        };
        let mut metrics = Metrics::new(&mut [], &mut []);
        let mut search = Search::new(task, &config, generator(1), memory, &mut metrics).unwrap();
        let found = search.next_skeleton(&mut Unguided, &mut metrics).unwrap();
        let length = found.map(|skeleton| skeleton.len() as u32);
        prop_assert_eq!(length, strips.optimal(true));
        // Each of the 64 states is extended once, or anew from a shorter way.
        prop_assert!(metrics.nodes_expanded <= 64 + metrics.repeated);
    }

    #[test]
    fn pruning_drops_what_was_pruned_and_nothing_else(strips in strips(), operators: u16) {
        let mut ban = Ban { operators, advice: Advice::Prune(ReasonId(0)) };
        let config = config(Heuristic::LandmarkCut, 0);
        let (found, end) = search(&strips, &config, &mut ban, LENGTH, ROOM);
        let expected = strips.skeletons(LENGTH, operators);
        prop_assert!(found.iter().flatten().all(|place| operators >> place & 1 == 0));
        if end.is_ok() {
            prop_assert_eq!(found.into_iter().collect::<BTreeSet<_>>(), expected);
        }
    }

    #[test]
    fn what_is_postponed_waits_and_then_nothing_was_ever_postponed(
        strips in strips(), operators: u16, patience in 0..40u32, room in 1..200usize,
    ) {
        let mut ban = Ban { operators, advice: Advice::Postpone(ReasonId(0)) };
        let config = config(Heuristic::LandmarkCut, patience);
        let (found, end) = search_twice(&strips, &config, &mut ban, LENGTH, room);
        let [advised, again] = found;
        prop_assert!(advised.iter().flatten().all(|place| operators >> place & 1 == 0));
        let unguided = search(&strips, &config, &mut Unguided, LENGTH, room);
        if again.is_empty() {
            // Nothing was postponed, unless the task has no skeleton at all.
            prop_assert!(unguided == (advised, end) || unguided.0.is_empty());
        } else {
            prop_assert_eq!(unguided, (again, end));
        }
    }

    #[test]
    fn full_memory_finds_the_same_up_to_then(strips in strips(), room in 1..40usize) {
        let config = config(Heuristic::LandmarkCut, 0);
        let (found, end) = search(&strips, &config, &mut Unguided, LENGTH, room);
        let (all, _) = search(&strips, &config, &mut Unguided, LENGTH, ROOM);
        prop_assert!(all.starts_with(&found));
        prop_assert!(end.is_err() || all == found);
    }

    #[test]
    fn necessary_atoms_by_brute_force(strips in strips(), sequence in vec(0..8usize, 0..6)) {
        // An atom is necessary if it is needed later, or in the end, and nothing
        // adds it until then.
        let sequence: Vec<_> = sequence.iter().filter_map(|o| strips.operators.get(*o)).collect();
        let mut necessary = set(strips.goal);
        let ground = strips.ground();
        for (at, operator) in sequence.iter().enumerate().rev() {
            let place = strips.operators.iter().position(|o| o == *operator).unwrap();
            necessary = ground[place].regress(necessary);
            let mut expected = 0;
            let mut added = 0;
            for [pre, add, _] in &sequence[at..] {
                expected |= pre & !added;
                added |= add;
            }
            prop_assert_eq!(necessary, set(expected | strips.goal & !added));
        }
    }
}

#[test]
fn a_task_that_is_too_large_is_refused() {
    let strips = Strips {
        operators: vec![[1, 2, 0], [0, 1, 0]],
        initial: 0,
        goal: 2,
    };
    let operators = strips.ground();
    assert_eq!(
        links(&operators),
        4,
        "two preconditions, counting none as one, two effects"
    );
    let task = AbstractTask {
        operators: &operators,
        initial: AtomSet::EMPTY,
        goal: set(2),
    };
    for (count, links, fits) in [(2, 4, true), (1, 4, false), (2, 3, false)] {
        let memory = HeuristicMemory {
            operators: &mut vec![Progress::default(); count],
            links: &mut vec![0; links],
            cache: &mut [],
        };
        let estimator = Estimator::new(Heuristic::Max, task, memory);
        let estimate = estimator.map(|mut e| e.estimate(task.initial));
        assert_eq!(estimate == Ok(Estimate::Cost(2)), fits);
        assert_eq!(matches!(estimate, Err(Error::CapacityExceeded(_))), !fits);
    }
}

#[test]
fn what_is_postponed_waits_as_long_as_patience() {
    // One operator reaches the goal; two others do it together.
    let strips = Strips {
        operators: vec![[0, 1, 0], [0, 2, 0], [2, 1, 0]],
        initial: 0,
        goal: 1,
    };
    let mut ban = Ban {
        operators: 1,
        advice: Advice::Postpone(ReasonId(0)),
    };
    for patience in [0, 1, 2, 5, 20] {
        let config = config(Heuristic::LandmarkCut, patience);
        let (found, end) = search_twice(&strips, &config, &mut ban, 1, ROOM);
        assert_eq!(end, Ok(()));
        let [advised, again] = found;
        // The root is expanded before there is an objection, and then the sequences of
        // the second operator alone, each of which makes one longer and one that reaches
        // the goal.
        assert_eq!(
            advised.len(),
            (patience as usize).saturating_sub(1),
            "{patience}"
        );
        assert!(!advised.iter().flatten().any(|place| *place == 0));
        assert_eq!(again, [[0]]);
    }
}
