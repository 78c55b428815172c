//! Reads expressions.

use super::words::{self, Function, UNKNOWN_FUNCTION};
use crate::domain::node::{copy, intern};
use crate::domain::{
    Beam, Dimension, Domain, Extreme, Metric, Node, NodeId, Quantity, SYMMETRIES, Share,
};
use crate::error::Error;
use crate::text::{Failed, Lexer, Place, Token, split_at_last_dot};
use heapless::VecView;

/// Deepest nesting of an expression, and of a formula around it, so that walking one has
/// bounded stack.
pub const MAX_DEPTH: u8 = 12;

const _: () = assert!(MAX_DEPTH == 12, "errors name it");

const A_POINT: &str = "expected the name of a point";
const SECOND_POINT: &str = "expected `,` and a second point";

impl Domain<'_> {
    /// Reads an expression, which is `expr` in the [grammar](crate::domain#the-domain-text).
    ///
    /// # Errors
    /// [`Error::Syntax`] with line and column, also for unknown names and for
    /// quantities of different dimension; [`Error::CapacityExceeded`].
    pub fn parse_expression(
        &self,
        lexer: &mut Lexer<'_>,
        nodes: &mut VecView<Node>,
    ) -> Result<NodeId, Error> {
        let read = self.read_expression(lexer, nodes);
        lexer.outcome(read)
    }

    /// As [`Domain::parse_expression`], but the lexer keeps the error.
    pub(crate) fn read_expression(
        &self,
        lexer: &mut Lexer<'_>,
        nodes: &mut VecView<Node>,
    ) -> Result<NodeId, Failed> {
        self.parser(nodes, None).expression(lexer)
    }

    /// A parser of expressions that may be about a member of the group `own` without an
    /// extreme, because each member gets the point that is being read.
    pub(in crate::domain) fn parser<'p>(
        &'p self,
        nodes: &'p mut VecView<Node>,
        own: Option<u8>,
    ) -> ExpressionParser<'p, 'p, 'p> {
        ExpressionParser {
            domain: self,
            nodes,
            own,
        }
    }
}

pub(in crate::domain) struct ExpressionParser<'d, 't, 'n> {
    pub(super) domain: &'d Domain<'t>,
    pub(super) nodes: &'n mut VecView<Node>,
    /// The group of which an expression may be about a single member.
    pub(super) own: Option<u8>,
}

impl ExpressionParser<'_, '_, '_> {
    /// Reads a whole expression.
    pub(in crate::domain) fn expression(
        &mut self,
        lexer: &mut Lexer<'_>,
    ) -> Result<NodeId, Failed> {
        self.sum(lexer, 0)
    }

    /// Reads one factor of an expression: a number, a name, a call or a bracket.
    pub(in crate::domain) fn single(&mut self, lexer: &mut Lexer<'_>) -> Result<NodeId, Failed> {
        self.factor(lexer, 0)
    }

    fn sum(&mut self, lexer: &mut Lexer<'_>, depth: u8) -> Result<NodeId, Failed> {
        let mut left = self.product(lexer, depth)?;
        let mut links = depth;
        loop {
            let at = lexer.place();
            let make = if lexer.accept("+") {
                Node::Sum
            } else if lexer.accept("-") {
                Node::Difference
            } else {
                return Ok(left);
            };
            links = deeper(lexer, links)?;
            let right = self.product(lexer, depth)?;
            let dimensions = (self.dimension(left), self.dimension(right));
            if let (Some(a), Some(b)) = dimensions
                && a != b
            {
                return Err(lexer.fail_at(at, "the two sides of + or - have different dimensions"));
            }
            left = self.join(lexer, make(left, right))?;
        }
    }

    fn product(&mut self, lexer: &mut Lexer<'_>, depth: u8) -> Result<NodeId, Failed> {
        let mut left = self.factor(lexer, depth)?;
        let mut links = depth;
        loop {
            let make = if lexer.accept("*") {
                Node::Product
            } else if lexer.accept("/") {
                Node::Quotient
            } else {
                return Ok(left);
            };
            links = deeper(lexer, links)?;
            let right = self.factor(lexer, depth)?;
            left = self.join(lexer, make(left, right))?;
        }
    }

    fn factor(&mut self, lexer: &mut Lexer<'_>, depth: u8) -> Result<NodeId, Failed> {
        let depth = deeper(lexer, depth)?;
        if lexer.accept("(") {
            let inside = self.sum(lexer, depth)?;
            lexer.expect(")", "expected `)`")?;
            return Ok(inside);
        }
        if lexer.accept("-") {
            if let Token::Number(value) = lexer.token() {
                lexer.advance();
                return self.intern(lexer, Node::Number(-value));
            }
            let zero = self.intern(lexer, Node::Number(0.0))?;
            let inside = self.factor(lexer, depth)?;
            return self.join(lexer, Node::Difference(zero, inside));
        }
        if let Token::Name(name) = lexer.token()
            && let Some(feature) = self.domain.find_feature(name)
        {
            lexer.advance();
            let copied = copy(self.domain.nodes(), feature.term, self.nodes);
            return copied.map_err(|full| lexer.note(full.into()));
        }
        let node = self.leaf(lexer)?;
        self.intern(lexer, node)
    }

    /// Interns a term made of two others. It is no deeper than what can be written: where
    /// the left one was in brackets, it is written without.
    fn join(&mut self, lexer: &mut Lexer<'_>, node: Node) -> Result<NodeId, Failed> {
        let joined = self.intern(lexer, node)?;
        match height(self.nodes, joined) <= MAX_DEPTH {
            true => Ok(joined),
            false => Err(lexer.fail(TOO_DEEP)),
        }
    }

    /// Reads a number, a name, a call, or the extreme of one of these.
    fn leaf(&self, lexer: &mut Lexer<'_>) -> Result<Node, Failed> {
        let at = lexer.place();
        if let Token::Name(name) = lexer.token()
            && let Some(extreme) = words::extreme(name)
        {
            lexer.advance();
            return self.extreme(extreme, lexer);
        }
        let term = self.term(lexer)?;
        let mut groups = self.groups_of(term.quantity());
        if groups.any(|group| self.own != Some(group)) {
            return Err(lexer.fail_at(at, "only min(...) or max(...) can be about a group"));
        }
        Ok(term)
    }

    fn extreme(&self, extreme: Extreme, lexer: &mut Lexer<'_>) -> Result<Node, Failed> {
        lexer.expect("(", "expected `(` and what the extreme is taken of")?;
        let at = lexer.place();
        let term = self.gap(self.term(lexer)?, lexer)?;
        lexer.expect(")", "expected `)`")?;
        let quantity = term.quantity().ok_or_else(|| {
            lexer.fail_at(
                at,
                "min and max are of an attribute, a coordinate, a distance or an angle",
            )
        })?;
        let mut groups = self.groups_of(Some(quantity));
        let first = groups.next();
        if first.is_none() {
            return Err(lexer.fail_at(at, "min and max are over a group, and here is none"));
        }
        if groups.any(|group| Some(group) != first) {
            return Err(lexer.fail_at(at, "min and max are over one group, and here are two"));
        }
        Ok(Node::Extreme(extreme, quantity))
    }

    /// Reads what is taken off a distance: a share of a size.
    fn gap(&self, term: Node, lexer: &mut Lexer<'_>) -> Result<Node, Failed> {
        const WHAT: &str = "from a distance in min or max, 0.5, 1, 1.5 or 2 times \
                            an attribute of length can be taken off";
        let Node::Quantity(Quantity::Distance(Metric::Straight, a, b)) = term else {
            return Ok(term);
        };
        if !lexer.accept("-") {
            return Ok(term);
        }
        let at = lexer.place();
        let (mut factor, mut size) = (1.0, self.term(lexer)?);
        if let Node::Number(value) = size {
            lexer.expect("*", WHAT)?;
            (factor, size) = (value, self.term(lexer)?);
        }
        let share = Share::ALL
            .into_iter()
            .find(|share| share.factor() == factor);
        match (share, size) {
            (Some(share), Node::Quantity(own @ Quantity::Attribute(slot)))
                if self.domain.measured_by(own) == Some(Dimension::Length) =>
            {
                Ok(Node::Quantity(Quantity::Gap(share, a, b, slot)))
            }
            _ => Err(lexer.fail_at(at, WHAT)),
        }
    }

    /// The groups whose members a quantity is about.
    fn groups_of(&self, quantity: Option<Quantity>) -> impl Iterator<Item = u8> {
        let members = quantity.map_or([None; 3], |own| self.domain.members_in(own));
        members.into_iter().flatten().map(|member| member.group)
    }

    fn term(&self, lexer: &mut Lexer<'_>) -> Result<Node, Failed> {
        let at = lexer.place();
        match lexer.advance() {
            Token::Number(value) => Ok(Node::Number(value)),
            Token::Name(name) if lexer.accept("(") => {
                let node = self.call(name, at, lexer)?;
                lexer.expect(")", "expected `)`")?;
                Ok(node)
            }
            Token::Name(name) => self.name(name).ok_or_else(|| {
                lexer.fail_at(
                    at,
                    "unknown name: not an attribute, constant, parameter or coordinate of a point",
                )
            }),
            _ => Err(lexer.fail_at(at, "expected a number, a name or `(`")),
        }
    }

    fn call(&self, name: &str, at: Place, lexer: &mut Lexer<'_>) -> Result<Node, Failed> {
        match words::function(name) {
            None => Err(lexer.fail_at(at, UNKNOWN_FUNCTION)),
            Some(Function::OfPoints(two, three)) => self.of_points(two, three, lexer),
            Some(Function::Area) => self.area(lexer),
            Some(Function::Extreme(_)) => {
                Err(lexer.fail_at(at, "min and max cannot be of each other"))
            }
        }
    }

    /// Reads two points or three, and makes the quantity that the function is of as many.
    fn of_points(
        &self,
        two: Option<Quantity>,
        three: Option<Quantity>,
        lexer: &mut Lexer<'_>,
    ) -> Result<Node, Failed> {
        let at = lexer.place();
        let first = lexer.expect_name(A_POINT)?;
        if lexer.accept("(") {
            return match words::beam(first) {
                Some(beam) if two == Some(words::CLEAR) => self.sight(beam, lexer),
                _ => Err(lexer.fail_at(at, "only clear(...) is about line(...) or sweep(...)")),
            };
        }
        let takes_compounds = match two {
            Some(Quantity::Relation(relation, ..)) => relation.takes_compounds(),
            _ => [false; 2],
        };
        let [of_first, of_second] = takes_compounds;
        let a = self.body_of_name(first, at, of_first, lexer)?;
        lexer.expect(",", SECOND_POINT)?;
        let b = self.body(of_second, lexer)?;
        let (example, c) = match (two, three) {
            (_, Some(three)) if lexer.accept(",") => match self.symmetry(lexer)? {
                Some(symmetry) => (Quantity::FoldedAngle(symmetry, a, b), b),
                None => (three, self.point(lexer)?),
            },
            (Some(two), _) => (two, b),
            (None, _) => return Err(lexer.fail("expected `,` and a third point")),
        };
        Ok(Node::Quantity(example.with_points([a, b, c])))
    }

    /// Reads a symmetry: the angle of a turn, as a product of numbers, or how many of them
    /// make a full turn. `None` where the name of a point stands, or of nothing.
    fn symmetry(&self, lexer: &mut Lexer<'_>) -> Result<Option<u8>, Failed> {
        const WHAT: &str =
            "a symmetry is 2*pi/n for a whole n from 2 to 12: pi, 0.5*pi, or symmetry 3";
        const _: () = assert!(*SYMMETRIES.start() == 2 && *SYMMETRIES.end() == 12);
        let at = lexer.place();
        if let Token::Name(name) = lexer.token() {
            let is_word = name == words::SYMMETRY || self.name(name).is_some();
            if !is_word || self.domain.find_point(name).is_some() {
                return Ok(None);
            }
        }
        let turns = if lexer.accept(words::SYMMETRY) {
            self.number(lexer)
        } else {
            let mut angle = self.number(lexer);
            while lexer.accept("*") {
                angle = angle.zip(self.number(lexer)).map(|(a, b)| a * b);
            }
            angle.map(|angle| core::f64::consts::TAU / angle)
        };
        let is_near = |n: &u8| turns.is_some_and(|turns| (turns - f64::from(*n)).abs() <= 1e-6);
        let symmetry = SYMMETRIES.into_iter().find(is_near);
        symmetry.map(Some).ok_or_else(|| lexer.fail_at(at, WHAT))
    }

    /// Reads a plain number, pi or a constant.
    fn number(&self, lexer: &mut Lexer<'_>) -> Option<f64> {
        let node = match lexer.advance() {
            Token::Number(value) => Node::Number(value),
            Token::Name(name) => self.name(name)?,
            _ => return None,
        };
        self.domain.constant_value(&[node], NodeId(0))
    }

    /// Reads the ends of a line and the body that it is to be clear of.
    fn sight(&self, beam: Beam, lexer: &mut Lexer<'_>) -> Result<Node, Failed> {
        let at = lexer.place();
        let a = self.point(lexer)?;
        if beam == Beam::Sweep && !self.domain.is_round(a) {
            return Err(lexer.fail_at(at, "only what has the shape of a circle can be swept"));
        }
        lexer.expect(",", SECOND_POINT)?;
        let b = self.point(lexer)?;
        lexer.expect(")", "expected `)` behind the ends of the line")?;
        lexer.expect(",", "expected `,` and what the line is clear of")?;
        let body = self.body(true, lexer)?;
        Ok(Node::Quantity(Quantity::Sight(beam, a, b, body)))
    }

    fn area(&self, lexer: &mut Lexer<'_>) -> Result<Node, Failed> {
        let at = lexer.place();
        let object = lexer.expect_name("expected the name of an object")?;
        let shape = self.domain.find_shape(object);
        shape
            .map(Node::Area)
            .ok_or_else(|| lexer.fail_at(at, "no `shape` is declared for this object"))
    }

    fn point(&self, lexer: &mut Lexer<'_>) -> Result<u8, Failed> {
        self.body(false, lexer)
    }

    /// Reads the name of a point, or of a compound where one may stand.
    fn body(&self, may_be_compound: bool, lexer: &mut Lexer<'_>) -> Result<u8, Failed> {
        let at = lexer.place();
        let name = lexer.expect_name(A_POINT)?;
        self.body_of_name(name, at, may_be_compound, lexer)
    }

    fn body_of_name(
        &self,
        name: &str,
        at: Place,
        may_be_compound: bool,
        lexer: &mut Lexer<'_>,
    ) -> Result<u8, Failed> {
        let domain = self.domain;
        let what = match (domain.find_point(name), domain.find_compound(name)) {
            (Some(point), _) => return Ok(point),
            (None, Some(compound)) if may_be_compound => return Ok(compound),
            (None, Some(_)) => "this is said of a single body, and here are several",
            (None, None) => "unknown point",
        };
        Err(lexer.fail_at(at, what))
    }

    fn name(&self, name: &str) -> Option<Node> {
        let domain = self.domain;
        let leaf = domain
            .find_parameter(name)
            .map(Node::Parameter)
            .or_else(|| domain.find_constant(name).map(Node::Constant))
            .or_else(|| {
                let slot = domain.find_slot(name)?;
                Some(Node::Quantity(Quantity::Attribute(slot)))
            });
        if name == words::PI {
            return leaf.or(Some(Node::Number(core::f64::consts::PI)));
        }
        leaf.or_else(|| {
            let (point, coordinate) = split_at_last_dot(name)?;
            let coordinate = words::coordinate(coordinate)?;
            let point = domain.find_point(point)?;
            Some(Node::Quantity(Quantity::Coordinate(coordinate, point)))
        })
    }

    fn intern(&mut self, lexer: &mut Lexer<'_>, node: Node) -> Result<NodeId, Failed> {
        intern(self.nodes, node).map_err(|full| lexer.note(full.into()))
    }

    fn dimension(&self, id: NodeId) -> Option<Dimension> {
        self.domain.dimension(self.nodes, id)
    }
}

const TOO_DEEP: &str =
    "the expression is nested deeper than 12; brackets and operators in a row count";

fn deeper(lexer: &mut Lexer<'_>, depth: u8) -> Result<u8, Failed> {
    if depth < MAX_DEPTH {
        Ok(depth + 1)
    } else {
        Err(lexer.fail(TOO_DEEP))
    }
}

/// How many operations stand one in the other. No term is much deeper than is allowed,
/// because such a one is refused when it is made.
fn height(nodes: &[Node], id: NodeId) -> u8 {
    let node = nodes.get(usize::from(id.0));
    match node.and_then(|node| node.operands()) {
        Some((a, b, _)) => {
            let [a, b] = [a, b].map(|own| height(nodes, own));
            a.max(b).saturating_add(1)
        }
        None => 0,
    }
}
