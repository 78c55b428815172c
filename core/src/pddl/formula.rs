//! Conditions and effects as trees, and how they are read.

use super::reader::{Reader, name, variable};
use super::schema::{Declarations, Span, Variable, function_id, index_of};
use super::types::Types;
use crate::error::Error;
use crate::task::{MAX_ARGUMENTS, ObjectId, PredicateId, TypeId};
use crate::text::read_number;
use heapless::{Vec, VecView};

/// Most parameters of an action and variables of the quantifiers around a place in it.
pub const MAX_BOUND: usize = 16;

/// Most brackets of a condition or an effect inside of each other.
const MAX_DEPTH: u32 = 24;

/// What stands for an object.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Term {
    /// The variable with this index: first the parameters of the action, then those of
    /// the quantifiers around.
    Variable(u8),
    /// The constant with this index.
    Constant(u8),
    /// An object of the problem.
    Object(ObjectId),
}

/// What a node of a formula says.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Kind {
    And,
    Or,
    Not,
    /// The first child implies the second.
    Imply,
    /// For all objects of the types of variables; their span is that of the node.
    Forall,
    /// For some.
    Exists,
    /// The second child, an effect, if the first holds.
    When,
    /// The predicate holds for the terms.
    Atom(PredicateId),
    /// The two terms are one object.
    Equal,
    /// The cost grows by so much.
    Increase(u32),
    /// The cost grows by the number that the problem says for the terms.
    IncreaseBy(PredicateId),
}

/// A node of a formula. Its children stand behind it, each followed by its own.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Node {
    pub(super) kind: Kind,
    /// Its terms, or the variables of a quantifier.
    pub(super) span: Span,
    /// How many nodes it is, with all below.
    pub(super) size: u16,
}

/// Formulas in tables.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub(super) struct Formulas<'t, const NODES: usize, const TERMS: usize, const VARIABLES: usize> {
    pub(super) nodes: Vec<Node, NODES>,
    pub(super) terms: Vec<Term, TERMS>,
    pub(super) variables: Vec<Variable<'t>, VARIABLES>,
}

impl<'t, const NODES: usize, const TERMS: usize, const VARIABLES: usize>
    Formulas<'t, NODES, TERMS, VARIABLES>
{
    pub(super) fn view(&self) -> View<'_, 't> {
        View {
            nodes: &self.nodes,
            terms: &self.terms,
            variables: &self.variables,
        }
    }

    pub(super) fn sheet(&mut self) -> Sheet<'_, 't> {
        Sheet {
            nodes: &mut self.nodes,
            terms: &mut self.terms,
            variables: &mut self.variables,
        }
    }
}

/// Formulas to look at.
#[derive(Clone, Copy)]
pub(super) struct View<'a, 't> {
    nodes: &'a [Node],
    terms: &'a [Term],
    variables: &'a [Variable<'t>],
}

impl<'a, 't> View<'a, 't> {
    pub(super) fn node(self, place: u16) -> Option<Node> {
        self.nodes.get(usize::from(place)).copied()
    }

    pub(super) fn terms(self, node: Node) -> &'a [Term] {
        node.span.of(self.terms)
    }

    pub(super) fn variables(self, node: Node) -> &'a [Variable<'t>] {
        node.span.of(self.variables)
    }

    /// The places of the children of a node.
    pub(super) fn children(self, place: u16) -> impl Iterator<Item = u16> + use<'a, 't> {
        let end = self.node(place).map_or(0, |node| place + node.size);
        let first = (place + 1 < end).then_some(place + 1);
        core::iter::successors(first, move |child| {
            let next = *child + self.node(*child)?.size.max(1);
            (next < end).then_some(next)
        })
    }

    /// The two children of an implication or a conditional effect.
    pub(super) fn pair(self, place: u16) -> Option<(u16, u16)> {
        let mut children = self.children(place);
        Some((children.next()?, children.next()?))
    }
}

/// Where a formula stands.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Part {
    /// In a precondition or a goal.
    Condition,
    /// In an effect.
    Effect,
    /// In an effect that is conditional or for all objects.
    InnerEffect,
}

/// Formulas to be written.
pub(super) struct Sheet<'a, 't> {
    pub(super) nodes: &'a mut VecView<Node>,
    pub(super) terms: &'a mut VecView<Term>,
    pub(super) variables: &'a mut VecView<Variable<'t>>,
}

/// Who knows the names that stand for objects: constants, in a problem all objects.
pub(super) type Names<'a> = &'a dyn Fn(&str) -> Option<(Term, TypeId)>;

/// Reads formulas.
pub(super) struct FormulaReader<'a, 't> {
    pub(super) types: &'a mut Types<'t>,
    pub(super) declared: &'a Declarations<'t>,
    pub(super) sheet: Sheet<'a, 't>,
    pub(super) names: Names<'a>,
    /// The parameters, and the variables of the quantifiers around.
    pub(super) scope: Vec<Variable<'t>, MAX_BOUND>,
    /// A bit for each predicate that an effect changes.
    pub(super) changed: u64,
}

impl<'t> FormulaReader<'_, 't> {
    /// An empty conjunction.
    pub(super) fn nothing(&mut self, at: &Reader<'t>) -> Result<u16, Error> {
        let place = self.open(at, Kind::And, Span::default())?;
        self.close(place);
        Ok(place)
    }

    /// Reads a formula; returns its place.
    pub(super) fn read(
        &mut self,
        reader: &mut Reader<'t>,
        part: Part,
        depth: u32,
    ) -> Result<u16, Error> {
        if depth > MAX_DEPTH {
            return Err(reader.error("no room left: more than 24 brackets inside of each other"));
        }
        let at = reader.clone();
        reader.expect(
            "(",
            if depth == 0 {
                "expected `(`"
            } else {
                "expected `(` or `)`"
            },
        )?;
        let condition = part == Part::Condition;
        if reader.accept(")") {
            self.nothing(&at)
        } else if reader.accept("and") {
            self.group(reader, &at, Kind::And, part, depth)
        } else if condition && reader.accept("or") {
            self.group(reader, &at, Kind::Or, part, depth)
        } else if reader.accept("not") {
            self.negation(reader, &at, part, depth)
        } else if condition && reader.accept("imply") {
            let parts = [Part::Condition; 2];
            self.two(reader, &at, Kind::Imply, parts, depth)
        } else if reader.accept("forall") {
            self.quantifier(reader, &at, Kind::Forall, part, depth)
        } else if condition && reader.accept("exists") {
            self.quantifier(reader, &at, Kind::Exists, part, depth)
        } else if !condition && reader.accept("when") {
            let parts = [Part::Condition, Part::InnerEffect];
            self.two(reader, &at, Kind::When, parts, depth)
        } else if condition && reader.accept("=") {
            self.equality(reader, &at)
        } else if part == Part::Effect && reader.accept("increase") {
            self.increase(reader, &at)
        } else {
            self.atom(reader, part)
        }
    }

    fn open(&mut self, at: &Reader<'t>, kind: Kind, span: Span) -> Result<u16, Error> {
        let place = self.sheet.nodes.len() as u16;
        let node = Node {
            kind,
            span,
            size: 1,
        };
        let full = |_| at.error("no room left: too many preconditions and effects");
        self.sheet.nodes.push(node).map_err(full)?;
        Ok(place)
    }

    fn close(&mut self, place: u16) {
        let size = (self.sheet.nodes.len() as u16).saturating_sub(place);
        if let Some(node) = self.sheet.nodes.get_mut(usize::from(place)) {
            node.size = size;
        }
    }

    fn group(
        &mut self,
        reader: &mut Reader<'t>,
        at: &Reader<'t>,
        kind: Kind,
        part: Part,
        depth: u32,
    ) -> Result<u16, Error> {
        let place = self.open(at, kind, Span::default())?;
        while !reader.accept(")") {
            self.read(reader, part, depth + 1)?;
        }
        self.close(place);
        Ok(place)
    }

    /// What stands behind `not`: in an effect an atom.
    fn negation(
        &mut self,
        reader: &mut Reader<'t>,
        at: &Reader<'t>,
        part: Part,
        depth: u32,
    ) -> Result<u16, Error> {
        let place = self.open(at, Kind::Not, Span::default())?;
        if part == Part::Condition {
            self.read(reader, part, depth + 1)?;
        } else {
            reader.expect("(", "expected `(` behind `not`")?;
            self.atom(reader, part)?;
        }
        reader.expect(")", "expected `)` behind what is negated")?;
        self.close(place);
        Ok(place)
    }

    fn two(
        &mut self,
        reader: &mut Reader<'t>,
        at: &Reader<'t>,
        kind: Kind,
        parts: [Part; 2],
        depth: u32,
    ) -> Result<u16, Error> {
        let place = self.open(at, kind, Span::default())?;
        for part in parts {
            self.read(reader, part, depth + 1)?;
        }
        reader.expect(")", "expected `)` behind two parts")?;
        self.close(place);
        Ok(place)
    }

    fn quantifier(
        &mut self,
        reader: &mut Reader<'t>,
        at: &Reader<'t>,
        kind: Kind,
        part: Part,
        depth: u32,
    ) -> Result<u16, Error> {
        reader.expect("(", "expected `(` and variables behind a quantifier")?;
        let outside = self.scope.len();
        let span = self.types.read_variables(reader, self.sheet.variables)?;
        for variable in span.of(self.sheet.variables) {
            self.scope.push(*variable).map_err(|_| {
                at.error("no room left: more than 16 parameters and variables of quantifiers")
            })?;
        }
        let place = self.open(at, kind, span)?;
        let inner = match part {
            Part::Condition => part,
            _ => Part::InnerEffect,
        };
        self.read(reader, inner, depth + 1)?;
        reader.expect(")", "expected `)` behind what is quantified")?;
        self.scope.truncate(outside);
        self.close(place);
        Ok(place)
    }

    fn equality(&mut self, reader: &mut Reader<'t>, at: &Reader<'t>) -> Result<u16, Error> {
        let first = self.sheet.terms.len();
        for _ in 0..2 {
            let (term, _) = self.term(reader)?;
            self.push_term(at, term)?;
        }
        reader.expect(")", "expected `)` behind two terms")?;
        let span = Span::since(first, self.sheet.terms);
        self.open(at, Kind::Equal, span)
    }

    /// `(total-cost)` and a number, or what stands for one.
    fn increase(&mut self, reader: &mut Reader<'t>, at: &Reader<'t>) -> Result<u16, Error> {
        const COST: &str = "only `(total-cost)` can be increased: other numbers belong to \
            the state of the program";
        for word in ["(", "total-cost", ")"] {
            reader.expect(word, COST)?;
        }
        let place = if reader.accept("(") {
            let (id, span) = self.application(reader, true)?;
            self.open(at, Kind::IncreaseBy(id), span)?
        } else {
            let word = reader.accept_word(name);
            let amount = word.and_then(whole_number);
            let what = "expected a whole number from 0 to 999999999, or a function";
            let amount = amount.ok_or_else(|| reader.error(what))?;
            self.open(at, Kind::Increase(amount), Span::default())?
        };
        reader.expect(")", "expected `)` behind what the cost grows by")?;
        Ok(place)
    }

    /// A predicate, its arguments and the closing bracket.
    fn atom(&mut self, reader: &mut Reader<'t>, part: Part) -> Result<u16, Error> {
        let at = reader.clone();
        let (id, span) = self.application(reader, false)?;
        if part != Part::Condition {
            self.changed |= 1u64.wrapping_shl(id.0.into());
        }
        self.open(&at, Kind::Atom(id), span)
    }

    fn application(
        &mut self,
        reader: &mut Reader<'t>,
        function: bool,
    ) -> Result<(PredicateId, Span), Error> {
        let at = reader.clone();
        let mut terms = Vec::<Term, MAX_ARGUMENTS>::new();
        let mut term = |reader: &mut Reader<'t>, declared: TypeId| {
            let at = reader.clone();
            let (term, own) = self.term(reader)?;
            if !self.types.is_subtype(own, declared) {
                return Err(at.error("this is not of the type that the predicate declares"));
            }
            let full = |_| at.error("no room left: too many arguments of one predicate");
            terms.push(term).map_err(full)
        };
        let id = self
            .declared
            .read_application(reader, function, &mut term)?;
        let first = self.sheet.terms.len();
        for term in &terms {
            self.push_term(&at, *term)?;
        }
        Ok((id, Span::since(first, self.sheet.terms)))
    }

    fn push_term(&mut self, at: &Reader<'t>, term: Term) -> Result<(), Error> {
        let full = |_| at.error("no room left: too many arguments of preconditions and effects");
        self.sheet.terms.push(term).map_err(full)
    }

    /// A variable or a name, with its type.
    fn term(&self, reader: &mut Reader<'t>) -> Result<(Term, TypeId), Error> {
        let at = reader.clone();
        if let Some(name) = reader.accept_word(variable) {
            // The innermost of a name.
            let named = (0..).zip(&self.scope);
            let named = named.filter(|(_, v)| v.name.eq_ignore_ascii_case(name));
            let (place, variable) = named.last().ok_or_else(|| at.error("unknown variable"))?;
            return Ok((Term::Variable(place), variable.type_id));
        }
        let name = reader.expect_word(name, "expected a variable or a constant")?;
        (self.names)(name).ok_or_else(|| at.error("unknown object or constant"))
    }
}

/// A whole number of up to nine digits.
pub(super) fn whole_number(word: &str) -> Option<u32> {
    let number = read_number(word)?;
    let whole = number as u32;
    (f64::from(whole) == number && whole < 1_000_000_000).then_some(whole)
}

/// What reads an argument of this type.
type Argument<'a, 't> = &'a mut dyn FnMut(&mut Reader<'t>, TypeId) -> Result<(), Error>;

impl<'t> Declarations<'t> {
    /// The name of a predicate, or of a function, its arguments as `argument` reads each,
    /// and the closing bracket.
    pub(super) fn read_application(
        &self,
        reader: &mut Reader<'t>,
        function: bool,
        argument: Argument<'_, 't>,
    ) -> Result<PredicateId, Error> {
        let at = reader.clone();
        let (what, unknown) = match function {
            false => ("expected the name of a predicate", "unknown predicate"),
            true => ("expected the name of a function", "unknown function"),
        };
        let name = reader.expect_word(name, what)?;
        let table = if function {
            &self.functions[..]
        } else {
            &self.predicates
        };
        let place = index_of(table.iter().map(|p| p.name), name);
        let found = place.and_then(|p| Some((p, table.get(usize::from(p))?)));
        let (place, declared) = found.ok_or_else(|| at.unexpected(unknown))?;
        for declared in declared.arguments.of(&self.variables) {
            argument(reader, declared.type_id)?;
        }
        reader.expect(")", "expected `)`: the predicate has no more arguments")?;
        Ok(if function {
            function_id(place)
        } else {
            PredicateId(place)
        })
    }
}
