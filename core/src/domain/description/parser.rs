//! What the statements of a domain text are made of: names, dimensions and terms.

use crate::domain::expression::is_reserved;
use crate::domain::node::{copy, intern};
use crate::domain::{Dimension, Domain, Node, NodeId};
use crate::text::{Failed, Lexer, Place, split_at_dot};
use heapless::Vec;

/// The words of statements and formulas.
const KEYWORDS: [&str; 18] = [
    "type",
    "object",
    "constant",
    "parameter",
    "shape",
    "point",
    "feature",
    "compare",
    "relate",
    "in",
    "turned",
    "rounded",
    "centred",
    "world",
    "and",
    "or",
    "not",
    "true",
];

/// Whether a name is a word of the language.
pub(super) fn is_word(name: &str) -> bool {
    KEYWORDS.contains(&name) || is_reserved(name)
}

/// Most terms of one expression for an offset, turn, size or value.
pub(super) const MAX_TERMS: usize = 32;

pub(super) struct DomainParser<'d, 't> {
    pub(super) domain: &'d mut Domain<'t>,
    pub(super) lexer: Lexer<'t>,
    /// The group of which each member gets the point that is being read.
    pub(super) own: Option<u8>,
}

impl<'t> DomainParser<'_, 't> {
    pub(super) fn dimension(&mut self) -> Result<Dimension, Failed> {
        const WHAT: &str = "expected a dimension: length, angle, area, flag or none";
        let at = self.lexer.place();
        let word = self.lexer.expect_name(WHAT)?;
        Dimension::from_name(word).ok_or_else(|| self.lexer.fail_at(at, WHAT))
    }

    /// Reads an expression over what is declared so far, without points.
    pub(super) fn expression(&mut self) -> Result<NodeId, Failed> {
        self.terms(false)
    }

    /// Reads an expression, or only one factor.
    pub(super) fn terms(&mut self, factor: bool) -> Result<NodeId, Failed> {
        let at = self.lexer.place();
        let mut nodes: Vec<Node, MAX_TERMS> = Vec::new();
        let mut parser = self.domain.parser(&mut nodes, self.own);
        let id = if factor {
            parser.single(&mut self.lexer)?
        } else {
            parser.expression(&mut self.lexer)?
        };
        let simple = |node: &Node| match node {
            Node::Number(_)
            | Node::Constant(_)
            | Node::Parameter(_)
            | Node::Sum(..)
            | Node::Difference(..)
            | Node::Product(..)
            | Node::Quotient(..) => true,
            Node::Quantity(quantity) => quantity.slot().is_some(),
            Node::Area(_) | Node::Extreme(..) => false,
        };
        if !nodes.iter().all(simple) {
            return Err(self.lexer.fail_at(
                at,
                "offsets, sizes and values cannot refer to points, areas, min or max",
            ));
        }
        copy(&nodes, id, &mut self.domain.nodes).map_err(|full| self.lexer.note(full.into()))
    }

    /// Adds a term to those of the domain.
    pub(super) fn intern(&mut self, node: Node) -> Result<NodeId, Failed> {
        intern(&mut self.domain.nodes, node).map_err(|full| self.lexer.note(full.into()))
    }

    /// Reads a name that means nothing yet in an expression.
    pub(super) fn new_name(&mut self, what: &'static str, dotted: bool) -> Result<&'t str, Failed> {
        let at = self.lexer.place();
        let name = self.lexer.expect_name(what)?;
        self.check_new(name, at, dotted)?;
        Ok(name)
    }

    /// Checks that a name means nothing yet in an expression.
    pub(super) fn check_new(&mut self, name: &str, at: Place, dotted: bool) -> Result<(), Failed> {
        if is_word(name) {
            return Err(self.lexer.fail_at(at, "this is a word of the language"));
        }
        // The lexer lets no name begin with a dot.
        let next = name.bytes().skip(1).chain([b'.']);
        let empty_part = name.bytes().zip(next).any(|pair| pair == (b'.', b'.'));
        if empty_part || (!dotted && split_at_dot(name).is_some()) {
            return Err(self
                .lexer
                .fail_at(at, "a dot is not allowed here in a name"));
        }
        let domain = &self.domain;
        let taken = domain.find_object(name).is_some()
            || domain.find_point(name).is_some()
            || domain.find_compound(name).is_some()
            || domain.find_constant(name).is_some()
            || domain.find_parameter(name).is_some()
            || domain.find_feature(name).is_some()
            || domain.find_slot(name).is_some();
        if taken {
            return Err(self.lexer.fail_at(at, "this name is declared already"));
        }
        Ok(())
    }

    pub(super) fn small(&mut self, index: usize) -> Result<u8, Failed> {
        u8::try_from(index).map_err(|_| self.lexer.full("numbers of an instance"))
    }
}
