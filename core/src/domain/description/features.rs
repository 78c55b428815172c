//! Statements about what is compared: `feature name = expr`, `compare expr, ...` and
//! `relate name, ...`.

use super::parser::{DomainParser, MAX_TERMS};
use crate::domain::compound::FIRST_COMPOUND;
use crate::domain::node::copy;
use crate::domain::{Dependence, Dimension, Feature, Node};
use crate::text::{Failed, Place};
use heapless::Vec;

impl<'t> DomainParser<'_, 't> {
    #[inline(never)]
    pub(super) fn feature_statement(&mut self) -> Result<(), Failed> {
        let name = self.new_name("expected the name of the feature", true)?;
        self.lexer.expect("=", "expected `=` and an expression")?;
        let at = self.lexer.place();
        self.feature(name)?;
        if self.lexer.accept(":") {
            let dimension = self.dimension()?;
            return self.measure_last(dimension, at);
        }
        Ok(())
    }

    /// Reads what alone is compared, beside the features with a name.
    #[inline(never)]
    pub(super) fn compare_statement(&mut self) -> Result<(), Failed> {
        self.domain.compares = true;
        loop {
            self.feature("")?;
            if !self.lexer.accept(",") {
                return Ok(());
            }
        }
    }

    /// Reads the names of what alone relations are enumerated of.
    #[inline(never)]
    pub(super) fn relate_statement(&mut self) -> Result<(), Failed> {
        let mut related = self.domain.related.unwrap_or_default();
        loop {
            let at = self.lexer.place();
            let name = self
                .lexer
                .expect_name("expected the name of an object, a point or a compound")?;
            if let Some(point) = self.domain.find_point(name) {
                for index in (0u8..).take(self.count_of(point)) {
                    related.points.insert(point.saturating_add(index));
                }
            } else if let Some(compound) = self.domain.find_compound(name) {
                related
                    .compounds
                    .insert(compound.saturating_sub(FIRST_COMPOUND));
            } else {
                return Err(self.lexer.fail_at(
                    at,
                    "no object with a place, no earlier point and no compound has this name",
                ));
            }
            if !self.lexer.accept(",") {
                self.domain.related = Some(related);
                return Ok(());
            }
        }
    }

    /// Reads the expression of a feature.
    fn feature(&mut self, name: &'t str) -> Result<(), Failed> {
        let at = self.lexer.place();
        let mut nodes: Vec<Node, MAX_TERMS> = Vec::new();
        let read = self
            .domain
            .parser(&mut nodes, None)
            .expression(&mut self.lexer)?;
        if self.domain.dependence(&nodes, read) == Dependence::Constant {
            return Err(self
                .lexer
                .fail_at(at, "this is the same in every scene, as a constant is"));
        }
        let term = copy(&nodes, read, &mut self.domain.nodes)
            .map_err(|full| self.lexer.note(full.into()))?;
        let feature = Feature {
            name,
            term,
            dimension: None,
        };
        let pushed = self.domain.features.push(feature);
        pushed.map_err(|_| self.lexer.full("features of a domain"))
    }

    /// Says what the last feature measures. Laws of physics have units that no word is for,
    /// so it may be anything where the expression is a product or a quotient.
    fn measure_last(&mut self, dimension: Dimension, at: Place) -> Result<(), Failed> {
        let Some(last) = self.domain.features.last().copied() else {
            return Ok(());
        };
        let nodes = &self.domain.nodes;
        let node = nodes.get(usize::from(last.term.0));
        let is_law = matches!(node, Some(Node::Product(..) | Node::Quotient(..)));
        let measured = self.domain.dimension(nodes, last.term);
        if !is_law && measured.is_some_and(|own| own != dimension) {
            return Err(self
                .lexer
                .fail_at(at, "the expression has another dimension than the feature"));
        }
        if let Some(last) = self.domain.features.last_mut() {
            last.dimension = Some(dimension);
        }
        Ok(())
    }
}
