//! Which name was meant, where a text has one that is not there.

use super::schema::Domain;
use crate::error::SyntaxError;
use core::fmt;

/// Longest name that is looked for, in bytes.
const LONGEST: usize = 48;
/// What a point has coordinates for.
const COORDINATES: [&str; 4] = ["x", "y", "z", "theta"];

/// A name of a domain: its parts, with dots between.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Name<'t> {
    parts: [&'t str; 3],
}

impl Name<'_> {
    fn bytes(&self) -> impl Iterator<Item = u8> + '_ {
        let parts = self.parts.iter().filter(|part| !part.is_empty());
        let dots = (0..).map(|place: u8| if place > 0 { "." } else { "" });
        dots.zip(parts)
            .flat_map(|(dot, part)| dot.bytes().chain(part.bytes()))
    }
}

impl fmt::Display for Name<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let [first, rest @ ..] = self.parts;
        f.write_str(first)?;
        for part in rest.iter().filter(|part| !part.is_empty()) {
            f.write_str(".")?;
            f.write_str(part)?;
        }
        Ok(())
    }
}

impl<'t> Domain<'t> {
    /// The name of this domain that is most like the one at which a text could not be read;
    /// `None` if none is like it, or something else is wrong there.
    ///
    /// ```
    /// use critreg::{Error, domain::Domain, region::Region};
    /// let domain = Domain::parse("constant table.width = 1: length parameter mu in [0, 1]")?;
    /// let text = "mu * table.widht <= 1";
    /// let Err(Error::Syntax(error)) = Region::parse(&domain, text) else { panic!() };
    /// assert_eq!(domain.similar(text, &error).unwrap().to_string(), "table.width");
    /// # Ok::<(), Error>(())
    /// ```
    pub fn similar(&self, text: &str, error: &SyntaxError) -> Option<Name<'t>> {
        if !error.what.starts_with("unknown") {
            return None;
        }
        let word = word_at(text, error)?;
        let mut best = None;
        // A third of the letters may be wrong, but not all of a short name.
        let mut least = (word.len() / 3).clamp(1, 3) + 1;
        self.each_name(&mut |name| {
            if let Some(distance) = distance(word, &name).filter(|own| *own < least) {
                (least, best) = (distance, Some(name));
            }
        });
        best
    }

    fn each_name(&self, visit: &mut dyn FnMut(Name<'t>)) {
        let mut say = |a, b, c| visit(Name { parts: [a, b, c] });
        for (object, attribute) in self.slots() {
            say(object.name, attribute.name, "");
        }
        for object in self.objects() {
            say(object.name, "", "");
        }
        for constant in self.constants() {
            say(constant.name, "", "");
        }
        for parameter in self.parameters() {
            say(parameter.name, "", "");
        }
        for point in self.points() {
            say(point.owner, point.part, "");
            for coordinate in COORDINATES {
                say(point.owner, point.part, coordinate);
            }
        }
        for kind in self.types() {
            say(kind.name, "", "");
        }
    }
}

/// The name that begins at the place of an error.
fn word_at<'x>(text: &'x str, error: &SyntaxError) -> Option<&'x str> {
    let mut line = 1;
    let mut rest = text;
    while line < error.line {
        let end = rest.bytes().position(|byte| byte == b'\n')?;
        rest = rest.get(end.checked_add(1)?..)?;
        line += 1;
    }
    let before = usize::try_from(error.column.checked_sub(1)?).ok()?;
    let (begin, _) = rest.char_indices().nth(before)?;
    let rest = rest.get(begin..)?;
    let belongs = |byte: u8| byte.is_ascii_alphanumeric() || byte == b'_' || byte == b'.';
    let end = rest.bytes().position(|byte| !belongs(byte));
    rest.get(..end.unwrap_or(rest.len()))
        .filter(|word| !word.is_empty() && word.len() < LONGEST)
}

/// How many letters have to be added, left out, exchanged with a neighbour or replaced
/// (Damerau 1964, in the restricted form).
fn distance(word: &str, name: &Name<'_>) -> Option<usize> {
    let mut rows = [[0_usize; LONGEST]; 3];
    let [_, _, first] = &mut rows;
    for (place, own) in first.iter_mut().enumerate() {
        *own = place;
    }
    let mut before = None;
    for (row, letter) in name.bytes().enumerate() {
        let [oldest, old, new] = &mut rows;
        core::mem::swap(oldest, old);
        core::mem::swap(old, new);
        let mut left = row.checked_add(1)?;
        *new.first_mut()? = left;
        let mut last = None;
        for (place, own) in word.bytes().enumerate() {
            let above = *old.get(place.checked_add(1)?)?;
            let across = *old.get(place)?;
            let mut best = (left.min(above) + 1).min(across + usize::from(own != letter));
            if last == Some(letter) && before == Some(own) {
                let twice = *oldest.get(place.checked_sub(1)?)?;
                best = best.min(twice + 1);
            }
            *new.get_mut(place.checked_add(1)?)? = best;
            (left, last) = (best, Some(own));
        }
        before = Some(letter);
    }
    let [_, _, result] = &rows;
    result.get(word.len()).copied()
}
