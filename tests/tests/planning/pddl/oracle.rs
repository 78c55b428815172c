//! PDDL grounded naively: all choices of objects, then those whose types, static
//! atoms and equalities do not fit are taken out. Reads correct texts only, in
//! lower case, and shares no code with the library.

use std::collections::{BTreeMap, BTreeSet};

/// A ground operator in words: `(pick a b)`, and its atoms.
#[derive(Debug, PartialEq, Eq)]
pub(crate) struct Operator {
    pub(crate) name: String,
    pub(crate) preconditions: BTreeSet<String>,
    pub(crate) adds: BTreeSet<String>,
    pub(crate) deletes: BTreeSet<String>,
}

/// A problem in words.
#[derive(Debug, PartialEq, Eq)]
pub(crate) struct Ground {
    pub(crate) operators: Vec<Operator>,
    pub(crate) initial: BTreeSet<String>,
    pub(crate) goal: BTreeSet<String>,
}

#[derive(Clone, Debug)]
pub(crate) enum Tree {
    Word(String),
    List(Vec<Tree>),
}

impl Tree {
    pub(crate) fn read(text: &str) -> Tree {
        let code = text.lines().map(|line| line.split(';').next().unwrap());
        let spaced = code.collect::<Vec<_>>().join(" ");
        let spaced = spaced
            .replace('(', " ( ")
            .replace(')', " ) ")
            .to_lowercase();
        let mut open = vec![Vec::new()];
        for word in spaced.split_whitespace() {
            match word {
                "(" => open.push(Vec::new()),
                ")" => {
                    let list = Tree::List(open.pop().unwrap());
                    open.last_mut().unwrap().push(list);
                }
                _ => open.last_mut().unwrap().push(Tree::Word(word.into())),
            }
        }
        open.pop().unwrap().remove(0)
    }

    pub(crate) fn list(&self) -> &[Tree] {
        match self {
            Tree::List(list) => list,
            Tree::Word(word) => panic!("{word} is no list"),
        }
    }

    pub(crate) fn word(&self) -> &str {
        match self {
            Tree::Word(word) => word,
            Tree::List(list) => panic!("{list:?} is no word"),
        }
    }

    /// The word it begins with, if it is a list.
    pub(crate) fn head(&self) -> &str {
        match self {
            Tree::List(list) if !list.is_empty() => list[0].word(),
            _ => "",
        }
    }

    /// What stands behind the head of the section with this name.
    pub(crate) fn section(&self, name: &str) -> &[Tree] {
        let found = self.list().iter().find(|t| t.head() == name);
        found.map_or(&[], |t| &t.list()[1..])
    }

    /// The literals of nested conjunctions: whether each is negated, and its words.
    fn literals(&self) -> Vec<Literal> {
        match self.head() {
            "" => vec![],
            "and" => self.list()[1..].iter().flat_map(Tree::literals).collect(),
            "not" => vec![(true, self.list()[1].words())],
            _ => vec![(false, self.words())],
        }
    }

    pub(crate) fn words(&self) -> Vec<String> {
        self.list().iter().map(|t| t.word().to_string()).collect()
    }
}

/// `a b - c d`: each name with its type.
pub(crate) fn typed(list: &[Tree]) -> Vec<(String, String)> {
    let mut entries: Vec<(String, Option<String>)> = Vec::new();
    let mut words = list.iter().map(Tree::word);
    while let Some(word) = words.next() {
        if word == "-" {
            let name = words.next().unwrap();
            for (_, kind) in entries.iter_mut().filter(|(_, kind)| kind.is_none()) {
                *kind = Some(name.to_string());
            }
        } else {
            entries.push((word.to_string(), None));
        }
    }
    let or_object = |kind: Option<String>| kind.unwrap_or("object".into());
    entries
        .into_iter()
        .map(|(name, kind)| (name, or_object(kind)))
        .collect()
}

pub(crate) fn text(words: &[String]) -> String {
    format!("({})", words.join(" "))
}

/// What grounding an action needs to know.
struct Facts {
    parents: BTreeMap<String, String>,
    objects: BTreeMap<String, String>,
    initial: BTreeSet<String>,
    changed: BTreeSet<String>,
}

type Choice = BTreeMap<String, String>;

impl Facts {
    fn is_subtype(&self, own: &str, kind: &str) -> bool {
        own == kind
            || self
                .parents
                .get(own)
                .is_some_and(|p| self.is_subtype(p, kind))
    }

    /// All choices of objects for parameters, the last one changing fastest.
    fn choices(&self, parameters: &[(String, String)]) -> Vec<Choice> {
        let mut choices = vec![Choice::new()];
        for (variable, kind) in parameters {
            let with_each_object = |choice: &Choice| {
                let fitting = self
                    .objects
                    .iter()
                    .filter(|(_, own)| self.is_subtype(own, kind));
                let with = |object: &String| {
                    let mut choice = choice.clone();
                    choice.insert(variable.clone(), object.clone());
                    choice
                };
                fitting.map(|(object, _)| with(object)).collect::<Vec<_>>()
            };
            choices = choices.iter().flat_map(with_each_object).collect();
        }
        choices
    }

    fn operator(&self, action: &Action, choice: &Choice) -> Option<Operator> {
        let ground = |words: &[String]| -> Vec<String> {
            words
                .iter()
                .map(|w| choice.get(w).unwrap_or(w).clone())
                .collect()
        };
        let possible = action.preconditions.iter().all(|(negated, words)| {
            let words = ground(words);
            let holds = match words[0].as_str() {
                "=" => words[1] == words[2],
                name if self.changed.contains(name) => return true,
                _ => self.initial.contains(&text(&words)),
            };
            holds != *negated
        });
        let atoms = |of: &[Literal], negated: bool| {
            of.iter()
                .filter(|(n, words)| *n == negated && self.changed.contains(&words[0]))
                .map(|(_, words)| text(&ground(words)))
                .collect()
        };
        possible.then(|| Operator {
            name: text(&ground(&action.name)),
            preconditions: atoms(&action.preconditions, false),
            adds: atoms(&action.effects, false),
            deletes: atoms(&action.effects, true),
        })
    }
}

/// Whether it is negated, and its words.
type Literal = (bool, Vec<String>);

struct Action {
    /// Its name, then its parameters.
    name: Vec<String>,
    parameters: Vec<(String, String)>,
    preconditions: Vec<Literal>,
    effects: Vec<Literal>,
}

impl Action {
    fn read(tree: &Tree) -> Action {
        let part = |name: &str| {
            let mut parts = tree.list().iter();
            parts.find(|t| matches!(t, Tree::Word(w) if w == name))?;
            parts.next()
        };
        let literals = |name| part(name).map_or(vec![], Tree::literals);
        let parameters = typed(part(":parameters").unwrap().list());
        let mut name = vec![tree.list()[1].word().to_string()];
        name.extend(parameters.iter().map(|(variable, _)| variable.clone()));
        Action {
            name,
            parameters,
            preconditions: literals(":precondition"),
            effects: literals(":effect"),
        }
    }
}

impl Ground {
    /// Without what cannot be reached, even if nothing is ever deleted.
    pub(crate) fn reachable(mut self) -> Ground {
        let mut reached = self.initial.clone();
        loop {
            let possible = self.operators.iter();
            let possible = possible.filter(|o| o.preconditions.is_subset(&reached));
            let more: BTreeSet<String> = possible.flat_map(|o| o.adds.clone()).collect();
            let before = reached.len();
            reached.extend(more);
            if reached.len() == before {
                break;
            }
        }
        self.operators
            .retain(|o| o.preconditions.is_subset(&reached));
        // What shall hold in the end has a name in any case.
        let named: BTreeSet<_> = reached.union(&self.goal).cloned().collect();
        for operator in &mut self.operators {
            operator.deletes.retain(|atom| named.contains(atom));
        }
        self
    }
}

/// Grounds a problem of a domain, without what cannot be reached.
pub(crate) fn ground(domain: &str, problem: &str) -> Ground {
    let (domain, problem) = (Tree::read(domain), Tree::read(problem));
    let actions = domain.list().iter().filter(|t| t.head() == ":action");
    let mut actions: Vec<Action> = actions.map(Action::read).collect();
    actions.sort_by(|a, b| a.name[0].cmp(&b.name[0]));
    let effects = actions.iter().flat_map(|action| &action.effects);
    let objects = typed(domain.section(":constants"));
    let initial = problem.section(":init").iter();
    let facts = Facts {
        parents: typed(domain.section(":types")).into_iter().collect(),
        objects: objects
            .into_iter()
            .chain(typed(problem.section(":objects")))
            .collect(),
        initial: initial.map(|t| text(&t.words())).collect(),
        changed: effects.map(|(_, words)| words[0].clone()).collect(),
    };
    let goal = problem.section(":goal")[0].literals();
    let changes = |atom: &String| {
        let name = atom.trim_matches(['(', ')']).split(' ').next();
        facts.changed.contains(name.unwrap())
    };
    let open = |atom: &String| changes(atom) || !facts.initial.contains(atom);
    let operators = actions.iter().flat_map(|action| {
        let choices = facts.choices(&action.parameters);
        let operators = choices.iter().map(|choice| facts.operator(action, choice));
        operators.flatten().collect::<Vec<_>>()
    });
    Ground {
        operators: operators.collect(),
        goal: goal
            .iter()
            .map(|(_, words)| text(words))
            .filter(open)
            .collect(),
        initial: facts
            .initial
            .iter()
            .filter(|a| changes(a))
            .cloned()
            .collect(),
    }
    .reachable()
}
