//! Everything beyond STRIPS: ground operators do in every state that can be reached what
//! an interpreter of the text does, which shares no code with the library.

use super::oracle::{Tree, text, typed};
use super::{ground, operators};
use critreg::pddl;
use critreg::task::AtomSet;
use std::collections::{BTreeMap, BTreeSet};

/// Atoms that hold.
type World = BTreeSet<String>;
/// The objects of variables.
type Names = BTreeMap<String, String>;

/// A text as it is interpreted.
struct Interpreter {
    /// Each object with its types.
    objects: BTreeMap<String, BTreeSet<String>>,
    actions: Vec<Tree>,
    goal: Tree,
    initial: World,
}

impl Interpreter {
    fn new([domain, problem]: [&str; 2]) -> Interpreter {
        let (domain, problem) = (Tree::read(domain), Tree::read(problem));
        let parents = typed(domain.section(":types"));
        let constants = typed(domain.section(":constants"));
        let objects = constants
            .into_iter()
            .chain(typed(problem.section(":objects")));
        let above = |kind: String| {
            let mut all = BTreeSet::from([kind, "object".to_string()]);
            for _ in 0..parents.len() {
                let more = parents.iter().filter(|(own, _)| all.contains(own));
                let more: Vec<_> = more.map(|(_, parent)| parent.clone()).collect();
                all.extend(more);
            }
            all
        };
        let actions = domain.list().iter().filter(|t| t.head() == ":action");
        let init = problem.section(":init").iter();
        let init = init.filter(|t| !["=", "not"].contains(&t.head()));
        Interpreter {
            objects: objects.map(|(name, kind)| (name, above(kind))).collect(),
            actions: actions.cloned().collect(),
            goal: problem.section(":goal")[0].clone(),
            initial: init.map(|t| text(&t.words())).collect(),
        }
    }

    /// All choices of objects for a typed list, of which types may be `(either ...)`.
    fn choices(&self, list: &[Tree], names: &Names) -> Vec<Names> {
        let mut all = vec![names.clone()];
        let mut list = list.iter().peekable();
        while list.peek().is_some() {
            let mut variables = vec![];
            while let Some(Tree::Word(word)) =
                list.next_if(|t| !matches!(t, Tree::Word(w) if w == "-"))
            {
                variables.push(word.clone());
            }
            let kinds: Vec<String> = match list.next().and_then(|_| list.next()) {
                Some(Tree::Word(kind)) => vec![kind.clone()],
                Some(either) => either.words()[1..].to_vec(),
                None => vec!["object".into()],
            };
            for variable in variables {
                let fits = |own: &BTreeSet<String>| kinds.iter().any(|kind| own.contains(kind));
                let with = |names: &Names| {
                    let fitting = self.objects.iter().filter(|(_, own)| fits(own));
                    let with = |object: &String| {
                        let mut names = names.clone();
                        names.insert(variable.clone(), object.clone());
                        names
                    };
                    fitting.map(|(object, _)| with(object)).collect::<Vec<_>>()
                };
                all = all.iter().flat_map(with).collect();
            }
        }
        all
    }

    fn ground(tree: &Tree, names: &Names) -> Vec<String> {
        let words = tree.words().into_iter();
        words.map(|w| names.get(&w).cloned().unwrap_or(w)).collect()
    }

    fn holds(&self, tree: &Tree, names: &Names, world: &World) -> bool {
        let parts = tree.list();
        let holds = |tree: &Tree| self.holds(tree, names, world);
        match tree.head() {
            "" => true,
            "and" => parts[1..].iter().all(holds),
            "or" => parts[1..].iter().any(holds),
            "not" => !holds(&parts[1]),
            "imply" => !holds(&parts[1]) || holds(&parts[2]),
            "forall" => self
                .choices(parts[1].list(), names)
                .iter()
                .all(|n| self.holds(&parts[2], n, world)),
            "exists" => self
                .choices(parts[1].list(), names)
                .iter()
                .any(|n| self.holds(&parts[2], n, world)),
            "=" => {
                let words = Self::ground(tree, names);
                words[1] == words[2]
            }
            _ => world.contains(&text(&Self::ground(tree, names))),
        }
    }

    /// Notes what an effect adds and deletes, and returns what it costs.
    fn effect(&self, tree: &Tree, names: &Names, world: &World, changes: &mut [World; 2]) -> u32 {
        let parts = tree.list();
        match tree.head() {
            "" => 0,
            "and" => parts[1..]
                .iter()
                .map(|t| self.effect(t, names, world, changes))
                .sum(),
            "forall" => {
                for names in self.choices(parts[1].list(), names) {
                    self.effect(&parts[2], &names, world, changes);
                }
                0
            }
            "when" => {
                if self.holds(&parts[1], names, world) {
                    self.effect(&parts[2], names, world, changes);
                }
                0
            }
            "increase" => parts[2].word().parse().unwrap(),
            "not" => {
                changes[1].insert(text(&Self::ground(&parts[1], names)));
                0
            }
            _ => {
                changes[0].insert(text(&Self::ground(tree, names)));
                0
            }
        }
    }

    /// What each operator does in a state, and what it costs.
    fn successors(&self, world: &World) -> BTreeSet<(String, World, u32)> {
        let mut all = BTreeSet::new();
        for action in &self.actions {
            let part = |name: &str| {
                let mut parts = action.list().iter();
                parts.find(|t| matches!(t, Tree::Word(w) if w == name))?;
                parts.next()
            };
            let parameters = part(":parameters").map_or(&[][..], Tree::list);
            for names in self.choices(parameters, &Names::new()) {
                if part(":precondition").is_some_and(|p| !self.holds(p, &names, world)) {
                    continue;
                }
                let mut changes = [World::new(), World::new()];
                let cost =
                    part(":effect").map_or(0, |e| self.effect(e, &names, world, &mut changes));
                let [adds, deletes] = changes;
                let after = world.difference(&deletes).cloned().chain(adds).collect();
                let mut words = vec![action.list()[1].word().to_string()];
                let variables = parameters.iter().filter_map(|t| match t {
                    Tree::Word(w) if w.starts_with('?') => Some(names[w].clone()),
                    _ => None,
                });
                words.extend(variables);
                all.insert((text(&words), after, cost));
            }
        }
        all
    }
}

/// Goes through all states that can be reached, and compares. Returns how many there are,
/// and in how many the goal holds.
fn compare(texts: [&str; 2]) -> [usize; 2] {
    let interpreter = Interpreter::new(texts);
    let domain = pddl::Domain::parse(texts[0]).unwrap();
    let mut memory = [pddl::Fact::default(); 64];
    let problem = pddl::Problem::parse(&domain, texts[1], &mut memory).unwrap();
    let mut grounding = pddl::Grounding::<3>::new(&problem).unwrap();
    let operators = operators(&mut grounding).unwrap();
    let fixed: World = problem
        .initial()
        .filter(|a| grounding.atoms().singleton(a).is_none())
        .map(|a| problem.atom_text(a).to_string())
        .collect();
    let world = |set: AtomSet<3>| -> World {
        let atoms = grounding.atoms().members(set);
        let held = atoms.filter(|a| !a.predicate.is_negation());
        held.map(|a| problem.atom_text(a).to_string())
            .chain(fixed.clone())
            .collect()
    };
    let goals: Vec<_> = operators.iter().filter(|o| o.is_goal()).collect();
    assert_eq!(world(grounding.initial()), interpreter.initial);
    let mut open = vec![grounding.initial()];
    let mut seen = BTreeSet::from([grounding.initial()]);
    let mut reached = 0;
    while let Some(state) = open.pop() {
        let here = world(state);
        let mut own = BTreeSet::new();
        for operator in operators
            .iter()
            .filter(|o| !o.is_goal() && o.is_applicable(state))
        {
            let after = operator.apply(state);
            let name = problem.operator_text(operator).to_string();
            let cost = if problem.minimizes_cost() {
                operator.cost
            } else {
                0
            };
            own.insert((name, world(after), cost));
            if seen.insert(after) {
                open.push(after);
            }
        }
        let mut expected = interpreter.successors(&here);
        if !problem.minimizes_cost() {
            expected = expected
                .into_iter()
                .map(|(name, after, _)| (name, after, 0))
                .collect();
        }
        assert_eq!(own, expected, "in {here:?}");
        let is_goal =
            grounding.goal().is_subset(state) || goals.iter().any(|g| g.is_applicable(state));
        assert_eq!(
            is_goal,
            interpreter.holds(&interpreter.goal, &Names::new(), &here),
            "{here:?}"
        );
        reached += usize::from(is_goal);
    }
    [seen.len(), reached]
}

#[test]
fn negative_preconditions_and_goals() {
    let domain = "(define (domain lamps) (:predicates (lit ?x) (hot ?x) (wired ?x ?y))
        (:action light :parameters (?x) :precondition (and (not (lit ?x)) (not (hot ?x)))
          :effect (and (lit ?x) (hot ?x)))
        (:action cool :parameters (?x) :precondition (not (lit ?x)) :effect (not (hot ?x)))
        (:action off :parameters (?x ?y)
          :precondition (and (wired ?x ?y) (not (wired ?y ?x)) (not (= ?x ?y)))
          :effect (and (not (lit ?x)) (not (lit ?y)) (lit ?y))))";
    let problem = "(define (problem p) (:domain lamps) (:objects a b c)
        (:init (lit c) (wired a b) (wired b c) (wired c b) (wired c c) (not (hot a)))
        (:goal (and (not (lit a)) (lit b) (hot a) (not (wired b a)))))";
    let [states, goals] = compare([domain, problem]);
    assert!(
        states > 7 && goals > 0 && goals < states,
        "{states} {goals}"
    );
}

#[test]
fn alternatives_and_quantifiers() {
    let domain = "(define (domain crates) (:requirements :adl)
        (:predicates (on ?x ?y) (clean ?x) (open) (likes ?x ?y))
        (:constants floor - place)
        (:types crate - thing thing place box - object)
        (:action lift :parameters (?x - crate ?y - (either crate place))
          :precondition (and (on ?x ?y) (not (= ?x ?y))
            (forall (?z - crate) (not (on ?z ?x)))
            (or (open) (exists (?z - crate) (and (likes ?x ?z) (clean ?z)))))
          :effect (and (not (on ?x ?y)) (on ?x floor)))
        (:action wash
          :parameters (?x - crate)
          :precondition (imply (on ?x floor) (or (clean ?x) (not (open))))
          :effect (and (clean ?x)))
        (:action door :effect (and) :precondition (or))
        (:action toggle :precondition (not (open)) :effect (open)))";
    let problem = "(define (problem p) (:init (on a b) (on b c) (on c floor) (likes b a))
        (:domain crates) (:objects a b c - crate floor - place)
        (:goal (or (and (clean c) (on b floor)) (exists (?x - crate) (and (clean ?x) (open))))))";
    let [states, goals] = compare([domain, problem]);
    assert!(
        states > 7 && goals > 0 && goals < states,
        "{states} {goals}"
    );
}

#[test]
fn conditional_effects_and_costs() {
    let domain = "(define (domain briefcase) (:predicates (at ?x ?y) (in ?x) (here ?y) (warm ?y))
        (:functions (total-cost))
        (:types item place)
        (:action move :parameters (?from ?to - place)
          :precondition (and (here ?from) (not (= ?from ?to)))
          :effect (and (here ?to) (not (here ?from)) (increase (total-cost) 2)
            (when (or (warm ?to) (in a)) (not (warm ?from)))
            (forall (?x - item) (when (in ?x) (and (at ?x ?to) (not (at ?x ?from)))))))
        (:action pack :parameters (?x - item ?y - place)
          :precondition (and (at ?x ?y) (here ?y))
          :effect (and (increase (total-cost) 1) (when (not (in ?x)) (in ?x))
            (when (in ?x) (not (in ?x)))))
        (:constants a b - item))";
    let problem = "(define (problem p) (:domain briefcase) (:objects home work - place)
        (:init (at a home) (at b home) (here home) (warm work) (= (total-cost) 0))
        (:metric minimize (total-cost)) (:goal (and (at a work) (not (in a)) (here home))))";
    let [states, goals] = compare([domain, problem]);
    assert!(
        states > 7 && goals > 0 && goals < states,
        "{states} {goals}"
    );
}

#[test]
fn numbers_that_a_problem_gives_are_costs() {
    let domain = "(define (domain roads) (:predicates (at ?x) (road ?x ?y))
        (:functions (length ?x ?y) - number (total-cost) - number)
        (:action drive :parameters (?x ?y) :precondition (and (at ?x) (road ?x ?y))
          :effect (and (not (at ?x)) (at ?y) (increase (total-cost) (length ?x ?y)))))";
    let problem = |number: &str, metric: &str| {
        format!(
            "(define (problem p) (:domain roads) (:objects a b) (:init (at a) (road a b)
             (= (total-cost) 0) (= (length a b) {number})) (:goal (at b)) {metric})"
        )
    };
    let domain = pddl::Domain::parse(domain).unwrap();
    let minimize = "(:metric minimize (total-cost))";
    let cases = [
        ("7", minimize, Some(7)),
        ("7.5", minimize, None),
        ("-7", minimize, None),
        ("7.5", "", Some(1)),
        ("7", "(:metric minimize (total-time))", Some(1)),
    ];
    for (number, metric, expected) in cases {
        let text = problem(number, metric);
        let mut memory = [pddl::Fact::default(); 8];
        let problem = pddl::Problem::parse(&domain, &text, &mut memory).unwrap();
        let mut grounding = pddl::Grounding::<2>::new(&problem).unwrap();
        let costs = operators(&mut grounding).map(|all| all.iter().map(|o| o.cost).collect());
        assert_eq!(costs.ok(), expected.map(|cost| vec![cost]), "{number}");
    }
}

/// Sections in any order, a byte-order mark, names that begin with digits.
#[test]
fn peculiarities() {
    let domain = "\u{feff}(define (domain 4ops-blocks@1)
        (:action 1 :effect (and (p ?x.1 8) (q)) :parameters (?x.1 - a_b))
        (:predicates (p ?obj ?obj) (q)) (:constants 8 _x - a_b)
        (:types object a_b - object a_b - c c) (:requirements :whatever))";
    let problem = "\u{feff}(define (problem 8) (:goal (and (p _x 8) (p a#1 8) (q)))
        (:init) (:objects a#1 8 - a_b) (:domain 4OPS-BLOCKS@1))";
    let (found, _) = ground([domain, problem]).unwrap();
    let names: Vec<_> = found.operators.iter().map(|o| o.name.as_str()).collect();
    assert_eq!(names, ["(1 8)", "(1 _x)", "(1 a#1)"]);
}

/// Four parameters over 64 objects in a chain are 16 million choices, of which 61 fit; with
/// nothing that ties them together, grounding ends at its bound.
#[test]
fn grounding_is_a_join_and_bounded() {
    let domain = |precondition: &str| {
        format!(
            "(define (domain chain) (:predicates (next ?x ?y) (done ?x))
             (:action go :parameters (?a ?b ?c ?d) :precondition {precondition}
               :effect (done ?a)))"
        )
    };
    let objects: String = (10..74).map(|i| format!(" o{i}")).collect();
    let facts: String = (10..73)
        .map(|i| format!("(next o{i} o{})", i + 1))
        .collect();
    let problem = format!(
        "(define (problem p) (:domain chain) (:objects{objects}) (:init {facts}) (:goal ()))"
    );
    let tied = domain("(and (next ?a ?b) (next ?b ?c) (next ?c ?d))");
    let (found, atoms) = ground([&tied, &problem]).unwrap();
    assert_eq!((found.operators.len(), atoms), (61, 61));
    let free = domain("(and (next ?a ?b) (next ?c ?d) (not (next ?a ?d)) (not (next ?b ?d)))");
    assert!(ground([&free, &problem]).is_ok());
    let wild = free.replace("?d) :pre", "?d ?e ?f) :pre");
    assert_ne!(wild, free);
    let error = ground([&wild, &problem]).unwrap_err();
    assert!(error.to_string().contains("work of grounding"), "{error}");
}

#[test]
fn alternatives_have_a_bound() {
    let pairs: String = (0..7).map(|i| format!("(or (p{i}) (q{i}))")).collect();
    let names: String = (0..7).map(|i| format!("(p{i}) (q{i})")).collect();
    let flips: String = (0..7)
        .map(|i| format!("(:action f{i} :effect (p{i})) (:action g{i} :effect (q{i}))"))
        .collect();
    let problem = "(define (problem p) (:domain d) (:init) (:goal (done)))";
    for (count, fits) in [(6, true), (7, false)] {
        let pairs: String = pairs.split_inclusive("))").take(count).collect();
        let domain = format!(
            "(define (domain d) (:predicates {names} (done)) {flips}
             (:action go :precondition (and {pairs}) :effect (done)))"
        );
        let grounded = ground([&domain, problem]);
        assert_eq!(grounded.is_ok(), fits);
        let error = grounded.err().map(|e| e.to_string()).unwrap_or_default();
        assert_eq!(error.contains("alternatives"), !fits, "{error}");
    }
}
