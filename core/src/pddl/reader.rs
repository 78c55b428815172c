//! What the texts of domains and problems have in common.

use crate::error::Error;
use crate::text::{Lexer, Token};

/// Words of PDDL that are refused by name, each with what is said about it.
const UNSUPPORTED: &[(&str, &str)] = &{
    macro_rules! refuse {
        ($($word:literal => $hint:literal,)*) => {
            [$(($word, concat!("`", $word, "` is not supported", $hint))),*]
        };
    }
    refuse! {
        "preference" => ": make it a goal or leave it out",
        "decrease" => ": a number belongs to the state of the program; write a predicate for what it decides",
        "assign" => ": a number belongs to the state of the program; write a predicate for what it decides",
        "scale-up" => ": a number belongs to the state of the program; write a predicate for what it decides",
        "scale-down" => ": a number belongs to the state of the program; write a predicate for what it decides",
        "<" => ": a number belongs to the state of the program; write a predicate for what it decides",
        ">" => ": a number belongs to the state of the program; write a predicate for what it decides",
        "<=" => ": a number belongs to the state of the program; write a predicate for what it decides",
        ">=" => ": a number belongs to the state of the program; write a predicate for what it decides",
        "oneof" => ": an effect is certain, or left out",
        "probabilistic" => ": an effect is certain, or left out",
        "increase" => " here: only `(increase (total-cost) ...)` in an effect without condition",
        "or" => " here",
        "imply" => " here",
        "exists" => " here",
        "forall" => " here",
        "when" => " here",
        ":constraints" => ": write them as preconditions",
        ":derived" => ": write the effects of the actions that change it, or a predicate that the program decides",
        ":axiom" => ": write the effects of the actions that change it, or a predicate that the program decides",
        ":durative-action" => ": write an `:action`; how long it takes is the controller's",
    }
};

/// A lexer on a PDDL text that knows what is not supported.
#[derive(Clone)]
pub(super) struct Reader<'t> {
    lexer: Lexer<'t>,
    text: &'t str,
}

/// What to do with a section.
pub(super) enum Section {
    /// It was read.
    Read,
    /// Its turn is another time, or never.
    Skip,
    /// There is no such section.
    Unknown,
}

/// An entry of a typed list.
pub(super) struct Typed<'t> {
    /// Where it stands.
    pub(super) at: Reader<'t>,
    pub(super) name: &'t str,
    /// Where its type stands, if it has one.
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
        // Some editors begin a text with a byte-order mark.
        let text = text.strip_prefix('\u{feff}').unwrap_or(text);
        let lexer = Lexer::pddl(text);
        let mut reader = Reader { lexer, text };
        for word in ["(", "define", "(", kind] {
            reader.expect(word, what)?;
        }
        let name = reader.expect_word(name, what)?;
        reader.expect(")", "expected `)` behind the name")?;
        Ok((reader, name))
    }

    /// Goes through the sections up to the end of the text. `read` gets each behind its
    /// keyword, and reads it with the closing bracket or says what to do with it.
    pub(super) fn sections(
        &self,
        what: &'static str,
        mut read: impl FnMut(&str, &mut Self) -> Result<Section, Error>,
    ) -> Result<(), Error> {
        let mut reader = self.clone();
        while !reader.accept(")") {
            reader.expect("(", what)?;
            let at = reader.clone();
            let keyword = reader.accept_keyword();
            let keyword = keyword.ok_or_else(|| at.unexpected(what))?;
            match read(keyword, &mut reader)? {
                Section::Read => {}
                Section::Skip => reader.skip_to_close(1)?,
                Section::Unknown => return Err(at.refuse(keyword, what)),
            }
        }
        match reader.lexer.token() {
            Token::End => Ok(()),
            _ => Err(reader.error("expected the end of the text")),
        }
    }

    /// Moves on behind a word, or a bracket with all that is in it.
    pub(super) fn skip(&mut self) -> Result<(), Error> {
        if self.accept("(") {
            return self.skip_to_close(1);
        }
        match self.lexer.token() {
            Token::End | Token::Symbol(")") => Err(self.error("expected something here")),
            _ => {
                self.lexer.advance();
                Ok(())
            }
        }
    }

    /// Moves on behind so many closing brackets.
    pub(super) fn skip_to_close(&mut self, mut open: u32) -> Result<(), Error> {
        while open > 0 {
            match self.lexer.token() {
                Token::Symbol("(") => open = open.saturating_add(1),
                Token::Symbol(")") => open -= 1,
                Token::End => return Err(self.error("expected `)`")),
                _ => {}
            }
            self.lexer.advance();
        }
        Ok(())
    }

    /// The text from here up to the first closing bracket.
    pub(super) fn text_to_close(&self) -> &'t str {
        let rest = self.text.get(self.lexer.position()..).unwrap_or_default();
        let length = rest.bytes().take_while(|byte| *byte != b')').count();
        rest.get(..=length).unwrap_or(rest)
    }

    /// The keyword it stands on, and moves on.
    pub(super) fn accept_keyword(&mut self) -> Option<&'t str> {
        match self.lexer.token() {
            Token::Symbol(keyword) if keyword.len() > 1 => {
                self.lexer.advance();
                Some(keyword)
            }
            _ => None,
        }
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

    /// Refuses a keyword that is not supported, at the token it stands on.
    pub(super) fn refuse(&self, keyword: &str, what: &'static str) -> Error {
        let refused = |(word, _): &&(&str, _)| word.eq_ignore_ascii_case(keyword);
        let found = UNSUPPORTED.iter().find(refused);
        self.error(found.map_or(what, |(_, refusal)| refusal))
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
            self.skip_type()?;
        }
        Ok(Some(Typed { at, name, type_at }))
    }

    /// Moves on behind a type: a name or `(either ...)`.
    pub(super) fn skip_type(&mut self) -> Result<(), Error> {
        const WHAT: &str = "expected the name of a type";
        if !self.accept("(") {
            return self.expect_word(self::name, WHAT).map(|_| ());
        }
        self.expect("either", "expected `either`")?;
        while !self.accept(")") {
            self.expect_word(self::name, WHAT)?;
        }
        Ok(())
    }
}
