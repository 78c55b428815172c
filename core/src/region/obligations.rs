//! What has to be proven of a specification, piece by piece: each of the statements that it
//! joins by `and`, of one member of a group at a time.
//!
//! A member of a group may be there or not. So what is said of all members holds of all of
//! them if it holds of each, whatever others there are; and what a region says of all members
//! of another group says nothing, since none may be there.

use crate::domain::{Domain, Extreme, Member, Node, NodeId, Quantity};
use crate::error::Error;
use crate::grammar::{Constraint, Formula, Step};

/// One statement of a specification, about one member if it is about all of them.
#[derive(Clone, Debug)]
pub(super) struct Obligation {
    /// The place of the statement in the specification.
    pub(super) clause: usize,
    /// The statement.
    pub(super) formula: Formula,
    pub(super) member: Option<Member>,
}

impl Obligation {
    /// What has to be proven, by its number; `None` beyond the last one.
    pub(super) fn find(
        specification: &Formula,
        domain: &Domain<'_>,
        mut number: usize,
    ) -> Result<Option<Obligation>, Error> {
        for clause in 0..specification.conjunct_count() {
            let formula = specification.select(|own| own.index == clause)?;
            let group = group_of(&formula, domain);
            let members = group.map_or(1, |group| domain.members(group).len());
            if number < members {
                let index = u8::try_from(number).unwrap_or(u8::MAX);
                let member = group.map(|group| Member { group, index });
                return Ok(Some(Obligation {
                    clause,
                    formula,
                    member,
                }));
            }
            number -= members;
        }
        Ok(None)
    }

    /// How a constraint is to be read where this is proven.
    pub(super) fn reading(
        &self,
        domain: &Domain<'_>,
        nodes: &[Node],
        constraint: &Constraint,
    ) -> Members {
        let group = Scope::of(domain, nodes, constraint).group;
        match self.member {
            Some(member) if group == Some(member.group) => Members::One(member.index),
            _ => Members::Unknown,
        }
    }
}

/// Which members of groups are meant.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Members {
    /// Those that an instance has.
    Present,
    /// One of them, by its index.
    One(u8),
    /// Nothing is known of them.
    Unknown,
}

/// The group of whose members a statement says the same of each.
fn group_of(formula: &Formula, domain: &Domain<'_>) -> Option<u8> {
    if formula.steps().contains(&Step::Not) {
        return None;
    }
    let mut group = None;
    let mut extremes = 0;
    for constraint in formula.constraints() {
        let own = Scope::of(domain, formula.nodes(), constraint);
        extremes += own.extremes;
        group = group.or(own.group);
    }
    group.filter(|_| extremes == 1)
}

/// What a constraint says of groups.
#[derive(Default)]
struct Scope {
    /// How many extremes it has.
    extremes: u32,
    /// The group, if it says the same of each member.
    group: Option<u8>,
}

impl Scope {
    fn of(domain: &Domain<'_>, nodes: &[Node], constraint: &Constraint) -> Scope {
        let mut scope = Scope::default();
        let sign = match constraint.comparison.is_upper() {
            true => 1,
            false => -1,
        };
        scope.visit(domain, nodes, constraint.lhs, sign);
        scope.visit(domain, nodes, constraint.rhs, -sign);
        if scope.extremes > 1 {
            scope.group = None;
        }
        scope
    }

    /// Looks for extremes in a term that has to be small (of sign 1), large (-1) or neither.
    fn visit(&mut self, domain: &Domain<'_>, nodes: &[Node], id: NodeId, sign: i8) {
        let Some(node) = nodes.get(usize::from(id.0)) else {
            return;
        };
        match *node {
            Node::Sum(a, b) => {
                self.visit(domain, nodes, a, sign);
                self.visit(domain, nodes, b, sign);
            }
            Node::Difference(a, b) => {
                self.visit(domain, nodes, a, sign);
                self.visit(domain, nodes, b, -sign);
            }
            Node::Product(a, b) => {
                let sign_of = |id: NodeId| match nodes.get(usize::from(id.0)) {
                    Some(Node::Number(number)) if *number > 0.0 => 1,
                    Some(Node::Number(number)) if *number < 0.0 => -1,
                    _ => 0,
                };
                self.visit(domain, nodes, a, sign * sign_of(b));
                self.visit(domain, nodes, b, sign * sign_of(a));
            }
            // What is divided may be anything.
            Node::Quotient(a, b) => {
                self.visit(domain, nodes, a, 0);
                self.visit(domain, nodes, b, 0);
            }
            Node::Extreme(extreme, quantity) => {
                self.extremes += 1;
                if matches!(
                    (extreme, sign),
                    (Extreme::Least, -1) | (Extreme::Greatest, 1)
                ) {
                    self.group = group(domain, quantity);
                }
            }
            Node::Number(_)
            | Node::Constant(_)
            | Node::Parameter(_)
            | Node::Area(_)
            | Node::Quantity(_) => {}
        }
    }
}

fn group(domain: &Domain<'_>, quantity: Quantity) -> Option<u8> {
    let mut members = domain.members_in(quantity).into_iter().flatten();
    members.next().map(|member| member.group)
}
