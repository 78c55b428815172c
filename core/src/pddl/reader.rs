//! What the texts of domains and problems have in common.

use crate::error::Error;
use crate::text::{Lexer, Token};

/// Words of PDDL that are refused by name, each with what is said about it.
const UNSUPPORTED: &[(&str, &str)] = &{
    macro_rules! refuse {
        ($($word:literal)*) => { [$(($word, concat!("`", $word, "` is not supported"))),*] };
    }
    refuse! {
        "either" "or" "imply" "exists" "forall" "when" "preference"
        "increase" "decrease" "assign" "scale-up" "scale-down"
        ":functions" ":constraints" ":derived" ":durative-action" ":axiom"
        ":metric" ":length" ":situation"
        ":adl" ":disjunctive-preconditions" ":existential-preconditions"
        ":universal-preconditions" ":quantified-preconditions" ":conditional-effects"
        ":fluents" ":numeric-fluents" ":object-fluents" ":action-costs"
        ":goal-utilities" ":durative-actions" ":duration-inequalities"
        ":continuous-effects" ":derived-predicates" ":timed-initial-literals"
        ":preferences"
    }
};

/// A lexer on a PDDL text that knows what is not supported.
#[derive(Clone)]
pub(super) struct Reader<'t> {
    lexer: Lexer<'t>,
}

/// An entry of a typed list.
pub(super) struct Typed<'t> {
    /// Where it stands.
    pub(super) at: Reader<'t>,
    pub(super) name: &'t str,
    /// Where the name of its type stands, if it has one.
    pub(super) type_at: Option<Reader<'t>>,
}

/// Whether a token is the word that is looked for.
pub(super) type Word = for<'t> fn(Token<'t>) -> Option<&'t str>;

pub(super) fn name(token: Token<'_>) -> Option<&str> {
    match token {
        Token::Name(name) => Some(name),
        _ => None,
    }
}

pub(super) fn variable(token: Token<'_>) -> Option<&str> {
    match token {
        Token::Variable(name) => Some(name),
        _ => None,
    }
}

impl<'t> Reader<'t> {
    /// Begins `(define (<kind> <name>)` and returns the name.
    pub(super) fn begin(
        text: &'t str,
        kind: &str,
        what: &'static str,
    ) -> Result<(Self, &'t str), Error> {
        let lexer = Lexer::pddl(text);
        let mut reader = Reader { lexer };
        for word in ["(", "define", "(", kind] {
            reader.expect(word, what)?;
        }
        let name = reader.expect_word(name, what)?;
        reader.expect(")", "expected `)` behind the name")?;
        Ok((reader, name))
    }

    /// Ends the text: the last bracket, and nothing behind it.
    pub(super) fn end(mut self, what: &'static str) -> Result<(), Error> {
        self.expect(")", what)?;
        match self.lexer.token() {
            Token::End => Ok(()),
            _ => Err(self.error("expected the end of the text")),
        }
    }

    /// Moves on behind the bracket and keyword of a section if it stands there.
    pub(super) fn section(&mut self, keyword: &str) -> bool {
        let mut ahead = self.clone();
        let found = ahead.accept("(") && ahead.accept(keyword);
        if found {
            *self = ahead;
        }
        found
    }

    pub(super) fn accept(&mut self, word: &str) -> bool {
        self.lexer.accept(word)
    }

    pub(super) fn expect(&mut self, word: &str, what: &'static str) -> Result<(), Error> {
        if self.accept(word) {
            Ok(())
        } else {
            Err(self.unexpected(what))
        }
    }

    pub(super) fn accept_word(&mut self, word: Word) -> Option<&'t str> {
        let found = word(self.lexer.token())?;
        self.lexer.advance();
        Some(found)
    }

    pub(super) fn expect_word(&mut self, word: Word, what: &'static str) -> Result<&'t str, Error> {
        let found = self.accept_word(word);
        found.ok_or_else(|| self.unexpected(what))
    }

    /// An error at the token it stands on.
    pub(super) fn error(&self, what: &'static str) -> Error {
        self.lexer.error(what)
    }

    /// An error at the token it stands on, or rather at a word that is not
    /// supported if one stands there or behind the bracket there.
    pub(super) fn unexpected(&self, what: &'static str) -> Error {
        let mut ahead = self.lexer.clone();
        ahead.accept("(");
        let refused = |(word, _): &&(&str, _)| ahead.clone().accept(word);
        match UNSUPPORTED.iter().find(refused) {
            Some((_, refusal)) => ahead.error(refusal),
            None => self.error(what),
        }
    }

    /// The section of requirements, if there is one. They need not be complete:
    /// everything supported may be used anyway.
    pub(super) fn requirements(&mut self) -> Result<(), Error> {
        const SUPPORTED: [&str; 4] = [":strips", ":typing", ":equality", ":negative-preconditions"];
        if !self.section(":requirements") {
            return Ok(());
        }
        while !self.accept(")") {
            if !SUPPORTED.iter().any(|word| self.accept(word)) {
                return Err(self.unexpected(
                    "expected `:strips`, `:typing`, `:equality` or `:negative-preconditions`",
                ));
            }
        }
        Ok(())
    }

    /// The next entry of a typed list such as `a b - c d)`; `None` behind its end.
    pub(super) fn typed(
        &mut self,
        word: Word,
        what: &'static str,
    ) -> Result<Option<Typed<'t>>, Error> {
        if self.accept(")") {
            return Ok(None);
        }
        let at = self.clone();
        let name = self.expect_word(word, what)?;
        let mut ahead = self.clone();
        while ahead.accept_word(word).is_some() {}
        let type_at = ahead.accept("-").then_some(ahead);
        if self.accept("-") {
            self.expect_word(self::name, "expected the name of a type")?;
        }
        Ok(Some(Typed { at, name, type_at }))
    }

    /// `(and ...)`, `()` or a single literal. Calls `literal` behind the opening
    /// bracket of each; it moves on behind the closing one.
    pub(super) fn conjunction(
        &mut self,
        mut literal: impl FnMut(&mut Self) -> Result<(), Error>,
    ) -> Result<(), Error> {
        let mut open = 0_usize;
        loop {
            let what = match open {
                0 => "expected `(`",
                _ => "expected `(` or `)`",
            };
            self.expect("(", what)?;
            if self.accept("and") {
                open = open.saturating_add(1);
            } else if !self.accept(")") {
                literal(self)?;
            }
            while open > 0 && self.accept(")") {
                open -= 1;
            }
            if open == 0 {
                return Ok(());
            }
        }
    }
}
