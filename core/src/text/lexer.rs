//! Splits a text into names, numbers and symbols, and knows where each stands.
//!
//! It knows two languages: the library's own and PDDL.

use super::read_number;
use crate::error::{Error, SyntaxError};

/// The sign that reading failed. The lexer keeps the error itself, which takes several
/// words that every function of a parser would have to hand on.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Failed;

/// Where a token stands in a text.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Place(usize);

/// One word of a text.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Token<'t> {
    /// A name, or several joined by dots: `stick.width`. In PDDL without dots but
    /// with dashes, and it may begin with a digit: `pick-up`, `4ops`.
    Name(&'t str),
    /// A variable of PDDL with its question mark: `?from`.
    Variable(&'t str),
    /// A number without sign.
    Number(f64),
    /// One of `( ) [ ] { } , : = + - * / < <= > >=`. In PDDL one of
    /// `( ) = - + * / < <= > >=` or a keyword with its colon: `:action`.
    Symbol(&'t str),
    /// A character or number that the language does not know.
    Unknown,
    /// The end of the text.
    End,
}

/// What the words of a text look like.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Language {
    /// Domains, expressions and regions.
    Own,
    /// The Planning Domain Definition Language, in which case does not matter.
    Pddl,
}

/// Reads tokens from a text; blanks and comments (`#`, in PDDL `;`, to the end of
/// the line) separate them.
#[derive(Clone, Debug)]
pub struct Lexer<'t> {
    language: Language,
    text: &'t str,
    token: Token<'t>,
    /// Where the token begins and ends, in bytes.
    start: usize,
    end: usize,
    failure: Option<Error>,
}

impl<'t> Lexer<'t> {
    /// A lexer that stands on the first token of `text`.
    pub fn new(text: &'t str) -> Self {
        Self::of(Language::Own, text)
    }

    /// A lexer that stands on the first token of a PDDL text.
    pub fn pddl(text: &'t str) -> Self {
        Self::of(Language::Pddl, text)
    }

    fn of(language: Language, text: &'t str) -> Self {
        let mut lexer = Lexer {
            language,
            text,
            token: Token::End,
            start: 0,
            end: 0,
            failure: None,
        };
        lexer.advance();
        lexer
    }

    /// The token it stands on.
    pub fn token(&self) -> Token<'t> {
        self.token
    }

    /// Where that token stands.
    pub fn place(&self) -> Place {
        Place(self.start)
    }

    /// That place in bytes.
    pub(crate) fn position(&self) -> usize {
        self.start
    }

    /// Where that token ends, in bytes.
    pub(crate) fn end(&self) -> usize {
        self.end
    }

    /// Moves on and returns the token left behind.
    pub fn advance(&mut self) -> Token<'t> {
        let rest = self.text.as_bytes().get(self.end..).unwrap_or_default();
        self.start = self.end + self.language.blanks(rest);
        let word = self.text.get(self.start..).unwrap_or_default();
        let (token, length) = self.language.token(word);
        self.end = self.start + length;
        core::mem::replace(&mut self.token, token)
    }

    /// Moves on if it stands on this symbol or name.
    pub fn accept(&mut self, word: &str) -> bool {
        let found = match (self.token, self.language) {
            (Token::Symbol(s) | Token::Name(s), Language::Own) => s == word,
            (Token::Symbol(s) | Token::Name(s), Language::Pddl) => s.eq_ignore_ascii_case(word),
            _ => false,
        };
        if found {
            self.advance();
        }
        found
    }

    /// Moves on past this symbol or name.
    ///
    /// # Errors
    /// Keeps a syntax error with `what` if something else stands there.
    pub fn expect(&mut self, word: &str, what: &'static str) -> Result<(), Failed> {
        if self.accept(word) {
            Ok(())
        } else {
            Err(self.fail(what))
        }
    }

    /// Moves on past a name and returns it.
    ///
    /// # Errors
    /// Keeps a syntax error with `what` if something else stands there.
    pub fn expect_name(&mut self, what: &'static str) -> Result<&'t str, Failed> {
        match self.token {
            Token::Name(name) => {
                self.advance();
                Ok(name)
            }
            _ => Err(self.fail(what)),
        }
    }

    /// An error at the token it stands on.
    pub fn error(&self, what: &'static str) -> Error {
        self.error_at(self.place(), what)
    }

    fn error_at(&self, place: Place, what: &'static str) -> Error {
        let before = self.text.as_bytes().get(..place.0).unwrap_or_default();
        let breaks = before.iter().filter(|byte| **byte == b'\n').count();
        let line = before.iter().rev().take_while(|byte| **byte != b'\n');
        // In UTF-8 all bytes of a character but the first one begin with the bits 10.
        let chars = line.filter(|byte| **byte >> 6 != 0b10).count();
        let number =
            |before: usize| u32::try_from(before).map_or(u32::MAX, |n| n.saturating_add(1));
        Error::Syntax(SyntaxError {
            line: number(breaks),
            column: number(chars),
            what,
        })
    }

    /// Keeps a syntax error at the token it stands on.
    pub(crate) fn fail(&mut self, what: &'static str) -> Failed {
        self.fail_at(self.place(), what)
    }

    /// Keeps a syntax error at an earlier token.
    #[inline(never)]
    pub(crate) fn fail_at(&mut self, place: Place, what: &'static str) -> Failed {
        let hint = match self.language {
            Language::Own => self.text.get(place.0..).and_then(hint),
            Language::Pddl => None,
        };
        self.note(self.error_at(place, hint.unwrap_or(what)))
    }

    /// Keeps the error that a table is full.
    #[inline(never)]
    pub(crate) fn full(&mut self, what: &'static str) -> Failed {
        self.note(Error::CapacityExceeded(what))
    }

    /// Keeps an error of the parser that reads from it.
    pub(crate) fn note(&mut self, error: Error) -> Failed {
        self.failure = Some(error);
        Failed
    }

    /// Replaces the sign that reading failed by the error itself.
    ///
    /// # Errors
    /// The one that was kept.
    pub(crate) fn outcome<T>(&self, result: Result<T, Failed>) -> Result<T, Error> {
        result.map_err(|Failed| self.failure.unwrap_or(self.error("")))
    }
}

/// What is said in place of an error where a text goes on as other languages do.
fn hint(rest: &str) -> Option<&'static str> {
    const RADIANS: &str = "angles are in radians: write 5*pi/180 for 5 degrees";
    const HINTS: [(&str, &str); 10] = [
        ("//", "a comment begins with #"),
        ("/*", "a comment begins with # and ends with the line"),
        (";", "statements end without `;`"),
        ("^", "there are no powers: write x*x"),
        (
            "==",
            "there is no equality: bound it from both sides, with <= and >=",
        ),
        ("!=", "there is no inequality of this kind: write < or >"),
        ("&&", "write `and`"),
        ("||", "write `or`"),
        ("centered", "the word is `centred`"),
        ("°", RADIANS),
    ];
    let letters = rest.bytes().take_while(u8::is_ascii_alphabetic).count();
    if let Some("deg" | "degree" | "degrees") = rest.get(..letters) {
        return Some(RADIANS);
    }
    let found = HINTS.iter().find(|(sign, _)| rest.starts_with(sign));
    found.map(|(_, hint)| *hint)
}

impl Language {
    /// Length in bytes of the blanks and comments at the start of `text`.
    fn blanks(self, text: &[u8]) -> usize {
        let sign = match self {
            Language::Own => b'#',
            Language::Pddl => b';',
        };
        let mut comment = false;
        run(text, |byte| {
            comment = byte == sign || (comment && byte != b'\n');
            comment || byte.is_ascii_whitespace()
        })
    }

    /// The token at the start of a text, and its length in bytes.
    fn token<'t>(self, text: &'t str) -> (Token<'t>, usize) {
        let (first, behind) = match text.as_bytes() {
            [] => return (Token::End, 0),
            [first, behind @ ..] => (*first, behind),
        };
        let second = behind.first().copied().unwrap_or_default();
        let (make, length): (fn(&'t str) -> Token<'t>, usize) = match (self, first) {
            _ if self.begins_name(first) => (Token::Name, self.name_length(text.as_bytes())),
            (_, b'0'..=b'9') => (number, number_length(text.as_bytes())),
            (_, b'<' | b'>') if second == b'=' => (Token::Symbol, 2),
            (_, b'(' | b')' | b'=' | b'-' | b'+' | b'*' | b'<' | b'>') => (Token::Symbol, 1),
            // Other languages begin comments with two signs.
            (Language::Own, b'/') if matches!(second, b'/' | b'*') => (|_| Token::Unknown, 2),
            (_, b'/') => (Token::Symbol, 1),
            (Language::Own, b'[' | b']' | b'{' | b'}' | b',' | b':') => (Token::Symbol, 1),
            (Language::Pddl, b':') if self.begins_name(second) => {
                (Token::Symbol, 1 + self.name_length(behind))
            }
            (Language::Pddl, b'?') if self.begins_name(second) => {
                (Token::Variable, 1 + self.name_length(behind))
            }
            // Whole characters.
            _ => {
                let others = run(behind, |byte| !first.is_ascii() && !byte.is_ascii());
                (|_| Token::Unknown, 1 + others)
            }
        };
        (make(text.get(..length).unwrap_or_default()), length)
    }

    fn begins_name(self, byte: u8) -> bool {
        byte.is_ascii_alphabetic()
            || byte == b'_'
            || (self == Language::Pddl && (byte.is_ascii_digit() || byte == b'@'))
    }

    fn name_length(self, text: &[u8]) -> usize {
        let joints: &[u8] = match self {
            Language::Own => b"_.",
            Language::Pddl => b"_.-@#",
        };
        run(text, |byte| {
            byte.is_ascii_alphanumeric() || joints.contains(&byte)
        })
    }
}

fn number(word: &str) -> Token<'_> {
    read_number(word).map_or(Token::Unknown, Token::Number)
}

/// Length of digits, fraction and exponent; letters that follow belong to it, so
/// that `3x` is one unknown word and not a number beside a name.
fn number_length(text: &[u8]) -> usize {
    let mut previous = b' ';
    run(text, |byte| {
        let signed_exponent = matches!(byte, b'+' | b'-') && matches!(previous, b'e' | b'E');
        previous = byte;
        byte.is_ascii_alphanumeric() || byte == b'.' || byte == b'_' || signed_exponent
    })
}

/// How many bytes at the start satisfy a condition.
fn run(text: &[u8], mut condition: impl FnMut(u8) -> bool) -> usize {
    text.iter().take_while(|byte| condition(**byte)).count()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn words_and_places() {
        let mut lexer = Lexer::new("a.b <= 1e-3 # note\n  >x");
        let expected = [
            Token::Name("a.b"),
            Token::Symbol("<="),
            Token::Number(1e-3),
            Token::Symbol(">"),
            Token::Name("x"),
            Token::End,
        ];
        for token in expected {
            assert_eq!(lexer.advance(), token);
        }
        let mut lexer = Lexer::new("a\n  ?");
        lexer.advance();
        let Error::Syntax(at) = lexer.error("") else {
            panic!()
        };
        assert_eq!((at.line, at.column, lexer.token()), (2, 3, Token::Unknown));
    }

    #[test]
    fn words_of_pddl() {
        let mut lexer =
            Lexer::pddl("(:Action pick-up ; note # note\n ?x-1 - t = ? :) _a.1 8 4ops@x#1 >=");
        let expected = [
            Token::Symbol("("),
            Token::Symbol(":Action"),
            Token::Name("pick-up"),
            Token::Variable("?x-1"),
            Token::Symbol("-"),
            Token::Name("t"),
            Token::Symbol("="),
            Token::Unknown,
            Token::Unknown,
            Token::Symbol(")"),
            Token::Name("_a.1"),
            Token::Name("8"),
            Token::Name("4ops@x#1"),
            Token::Symbol(">="),
            Token::End,
        ];
        for token in expected {
            assert_eq!(lexer.advance(), token);
        }
        assert!(Lexer::pddl(":ACTION").accept(":action"));
        assert!(!Lexer::new("Type").accept("type"));
    }

    #[test]
    fn no_number_runs_into_a_name() {
        for text in ["3x", "1e999", "1.2.3"] {
            assert_eq!(Lexer::new(text).token(), Token::Unknown, "{text}");
        }
    }
}
