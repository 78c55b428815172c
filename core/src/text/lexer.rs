//! Splits a text into names, numbers and symbols, and knows where each stands.

use super::read_number;
use crate::error::{Error, SyntaxError};

/// One word of a text.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Token<'t> {
    /// A name, or several joined by dots: `stick.width`.
    Name(&'t str),
    /// A number without sign.
    Number(f64),
    /// One of `( ) [ ] { } , : = + - * < <= > >=`.
    Symbol(&'t str),
    /// A character or number that the language does not know.
    Unknown,
    /// The end of the text.
    End,
}

/// Reads tokens from a text; blanks and comments (`#` to the end of the line)
/// separate them.
#[derive(Clone, Debug)]
pub struct Lexer<'t> {
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
        let mut lexer = Lexer {
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
        let length = token_length(self.rest);
        let word = self.take(length);
        self.token = match word.bytes().next() {
            None => Token::End,
            Some(b) if b.is_ascii_alphabetic() || b == b'_' => Token::Name(word),
            Some(b) if b.is_ascii_digit() => {
                read_number(word).map_or(Token::Unknown, Token::Number)
            }
            Some(b) if b"()[]{},:=+-*<>".contains(&b) => Token::Symbol(word),
            Some(_) => Token::Unknown,
        };
        left
    }

    /// Moves on if it stands on this symbol or name.
    pub fn accept(&mut self, word: &str) -> bool {
        let found = matches!(self.token, Token::Symbol(s) | Token::Name(s) if s == word);
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
        let blank = |c: char| {
            comment = c == '#' || (comment && c != '\n');
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

/// Length in bytes of the token at the start of `text`.
fn token_length(text: &str) -> usize {
    let run = |belongs: fn(char) -> bool| text.find(|c| !belongs(c)).unwrap_or(text.len());
    match text.chars().next() {
        None => 0,
        Some(c) if c.is_ascii_alphabetic() || c == '_' => {
            run(|c| c.is_ascii_alphanumeric() || c == '_' || c == '.')
        }
        Some(c) if c.is_ascii_digit() => number_length(text),
        Some('<' | '>') if matches!(text.as_bytes().get(1), Some(b'=')) => 2,
        Some(c) => c.len_utf8(),
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
    fn no_number_runs_into_a_name() {
        for text in ["3x", "1e999", "1.2.3"] {
            assert_eq!(Lexer::new(text).token(), Token::Unknown, "{text}");
        }
    }
}
