//! Splits a text into names, numbers and symbols, and knows where each stands.
//!
//! It knows two languages: the library's own and PDDL.

use super::read_number;
use crate::error::{Error, SyntaxError};

/// One word of a text.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Token<'t> {
    /// A name, or several joined by dots: `stick.width`. In PDDL without dots but
    /// with dashes: `pick-up`.
    Name(&'t str),
    /// A variable of PDDL with its question mark: `?from`.
    Variable(&'t str),
    /// A number without sign.
    Number(f64),
    /// One of `( ) [ ] { } , : = + - * < <= > >=`. In PDDL one of `( ) = -` or a
    /// keyword with its colon: `:action`.
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
    rest: &'t str,
    token: Token<'t>,
    line: u32,
    column: u32,
    next_line: u32,
    next_column: u32,
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
            rest: text,
            token: Token::End,
            line: 1,
            column: 1,
            next_line: 1,
            next_column: 1,
        };
        lexer.advance();
        lexer
    }

    /// The token it stands on.
    pub fn token(&self) -> Token<'t> {
        self.token
    }

    /// Moves on and returns the token left behind.
    pub fn advance(&mut self) -> Token<'t> {
        let left = self.token;
        self.skip_blanks();
        self.line = self.next_line;
        self.column = self.next_column;
        let length = self.language.token_length(self.rest);
        let word = self.take(length);
        self.token = self.language.token(word);
        left
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
    /// [`Error::Syntax`] with `what` if something else stands there.
    pub fn expect(&mut self, word: &str, what: &'static str) -> Result<(), Error> {
        if self.accept(word) {
            Ok(())
        } else {
            Err(self.error(what))
        }
    }

    /// Moves on past a name and returns it.
    ///
    /// # Errors
    /// [`Error::Syntax`] with `what` if something else stands there.
    pub fn expect_name(&mut self, what: &'static str) -> Result<&'t str, Error> {
        match self.token {
            Token::Name(name) => {
                self.advance();
                Ok(name)
            }
            _ => Err(self.error(what)),
        }
    }

    /// An error at the token it stands on.
    pub fn error(&self, what: &'static str) -> Error {
        Error::Syntax(SyntaxError {
            line: self.line,
            column: self.column,
            what,
        })
    }

    fn skip_blanks(&mut self) {
        let mut comment = false;
        let sign = self.language.comment_sign();
        let blank = |c: char| {
            comment = c == sign || (comment && c != '\n');
            comment || c.is_whitespace()
        };
        let length = self.rest.len() - self.rest.trim_start_matches(blank).len();
        self.take(length);
    }

    /// Cuts `length` bytes off the rest and counts lines and columns.
    fn take(&mut self, length: usize) -> &'t str {
        let (taken, rest) = self
            .rest
            .split_at_checked(length)
            .unwrap_or((self.rest, ""));
        for c in taken.chars() {
            if c == '\n' {
                self.next_line = self.next_line.saturating_add(1);
                self.next_column = 1;
            } else {
                self.next_column = self.next_column.saturating_add(1);
            }
        }
        self.rest = rest;
        taken
    }
}

impl Language {
    fn comment_sign(self) -> char {
        match self {
            Language::Own => '#',
            Language::Pddl => ';',
        }
    }

    /// The token that this word is; of an empty word the end of the text.
    fn token(self, word: &str) -> Token<'_> {
        let mut bytes = word.bytes();
        let (Some(first), second) = (bytes.next(), bytes.next()) else {
            return Token::End;
        };
        match self {
            _ if self.begins_name(char::from(first)) => Token::Name(word),
            _ if first.is_ascii_digit() => read_number(word).map_or(Token::Unknown, Token::Number),
            Language::Own if b"()[]{},:=+-*<>".contains(&first) => Token::Symbol(word),
            Language::Pddl if b"()=-".contains(&first) => Token::Symbol(word),
            Language::Pddl if first == b':' && second.is_some() => Token::Symbol(word),
            Language::Pddl if first == b'?' && second.is_some() => Token::Variable(word),
            _ => Token::Unknown,
        }
    }

    /// Length in bytes of the token at the start of `text`.
    fn token_length(self, text: &str) -> usize {
        let mut chars = text.chars();
        let (first, second) = (chars.next(), chars.next());
        match (self, first) {
            (_, None) => 0,
            (_, Some(c)) if self.begins_name(c) => self.name_length(text),
            (_, Some(c)) if c.is_ascii_digit() => number_length(text),
            (Language::Own, Some('<' | '>')) if second == Some('=') => 2,
            (Language::Pddl, Some(':' | '?')) if second.is_some_and(|c| self.begins_name(c)) => {
                1 + self.name_length(text.trim_start_matches([':', '?']))
            }
            (_, Some(c)) => c.len_utf8(),
        }
    }

    fn begins_name(self, c: char) -> bool {
        c.is_ascii_alphabetic() || (self == Language::Own && c == '_')
    }

    fn name_length(self, text: &str) -> usize {
        let joint = match self {
            Language::Own => '.',
            Language::Pddl => '-',
        };
        let belongs = |c: char| c.is_ascii_alphanumeric() || c == '_' || c == joint;
        text.find(|c| !belongs(c)).unwrap_or(text.len())
    }
}

/// Length of digits, fraction and exponent; letters that follow belong to it, so
/// that `3x` is one unknown word and not a number beside a name.
fn number_length(text: &str) -> usize {
    let mut previous = ' ';
    let end = text.find(|c: char| {
        let signed_exponent = matches!(c, '+' | '-') && matches!(previous, 'e' | 'E');
        previous = c;
        !(c.is_ascii_alphanumeric() || c == '.' || c == '_' || signed_exponent)
    });
    end.unwrap_or(text.len())
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
        let mut lexer = Lexer::pddl("(:Action pick-up ; note # note\n ?x-1 - t = ? :) _a.1");
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
            Token::Unknown,
            Token::Name("a"),
            Token::Unknown,
            Token::Number(1.0),
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
