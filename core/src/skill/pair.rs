//! The text of two controllers, of what the texts say of each.

use crate::domain::{Attribute, Domain, Object};
use crate::error::Error;
use crate::task::{ObjectType, TypeId};
use crate::text::{Lexer, Token, write_number};
use core::fmt::{self, Write};
use heapless::Vec;

/// What is known of the later one of two controllers.
#[derive(Clone, Copy, Debug)]
pub enum Later<'a> {
    /// Its text.
    Text(&'a Domain<'a>),
    /// Nothing but the types of its objects, which are among these.
    Objects(&'a [ObjectType], &'a [TypeId]),
}

/// Points of the later controller that cannot be told before it runs, at most.
const MAX_DROPPED: usize = 16;

/// Writes the text of two controllers: roles of the same name are the same object, and the
/// parameters are those of the first one. So everything that is said of the first one is
/// said, and of the later one what does not depend on its own parameters.
///
/// ```
/// use critreg::domain::Domain;
/// use critreg::skill::{Later, write_pair};
/// let pick = Domain::parse("object box { x: length } parameter grip in [0, 1]: length
///     point hand = world + (box.x + grip, 0)")?;
/// let place = Domain::parse("object box { height: length } object shelf { z: length }
///     parameter far in [0, 1]: length
///     point spot = world + (far, 0)  point board = world + (0, shelf.z)")?;
/// let mut text = String::new();
/// write_pair(&pick, Later::Text(&place), &mut text)?;
/// assert_eq!(text, "object box { x: length, height: length }
/// object shelf { z: length }
/// parameter grip in [0, 1]: length
/// point hand = world + (box.x + grip, 0)
/// point board = world + (0, shelf.z)
/// ");
/// # Ok::<(), critreg::Error>(())
/// ```
///
/// # Errors
/// [`Error::Mismatch`] if the texts contradict each other about a constant or an attribute;
/// [`Error::CapacityExceeded`] if `out` is full.
pub fn write_pair(first: &Domain<'_>, later: Later<'_>, out: &mut dyn Write) -> Result<(), Error> {
    let mut pair = Pair { first, later, out };
    pair.constants()?;
    pair.objects()?;
    pair.parameters()?;
    pair.places()
}

const FULL: Error = Error::CapacityExceeded("the text of a pair of controllers is too long");

struct Pair<'p, 'o> {
    first: &'p Domain<'p>,
    later: Later<'p>,
    out: &'o mut dyn Write,
}

impl<'p> Pair<'p, '_> {
    fn put(&mut self, text: fmt::Arguments<'_>) -> Result<(), Error> {
        self.out.write_fmt(text).map_err(|_| FULL)
    }

    fn number(&mut self, value: f64) -> Result<(), Error> {
        write_number(self.out, value).map_err(|_| FULL)
    }

    fn second(&self) -> Option<&'p Domain<'p>> {
        match self.later {
            Later::Text(domain) => Some(domain),
            Later::Objects(..) => None,
        }
    }

    fn constants(&mut self) -> Result<(), Error> {
        let known = self.first.constants();
        let more = self.second().map_or(&[][..], Domain::constants);
        for (place, own) in known.iter().chain(more).enumerate() {
            let same = known
                .iter()
                .take(place)
                .find(|other| other.name == own.name);
            match same {
                Some(same) if same == own => continue,
                Some(_) => {
                    return Err(Error::Mismatch(
                        "the texts of the two controllers give a constant two values",
                    ));
                }
                None => {}
            }
            self.put(format_args!("constant {} = ", own.name))?;
            self.number(own.value)?;
            self.put(format_args!(": {}\n", own.dimension.name()))?;
        }
        Ok(())
    }

    fn objects(&mut self) -> Result<(), Error> {
        for object in roles(self.first) {
            self.object(self.first, object, self.second())?;
        }
        let is_new = |name: &str, known: &Domain<'_>| known.find_object(name).is_none();
        match self.later {
            Later::Text(second) => {
                for object in roles(second).filter(|own| is_new(own.name, self.first)) {
                    self.object(second, object, None)?;
                }
            }
            Later::Objects(types, arguments) => {
                for (place, kind) in arguments.iter().enumerate() {
                    let before = arguments.iter().take(place);
                    let number = 1 + before.filter(|other| *other == kind).count();
                    if let Some(named) = types.get(usize::from(kind.0)) {
                        self.argument(named, number)?;
                    }
                }
            }
        }
        Ok(())
    }

    /// A role of one text, with what another text says of it.
    fn object(
        &mut self,
        domain: &Domain<'_>,
        object: &Object<'_>,
        other: Option<&Domain<'_>>,
    ) -> Result<(), Error> {
        let members = |domain: &Domain<'_>| {
            let mut all = domain.objects().iter();
            all.by_ref()
                .filter(|own| own.name == object.name && own.member.is_some())
                .count()
        };
        let count = members(domain).max(other.map_or(0, members));
        self.put(format_args!("object {}", object.name))?;
        if count > 0 {
            self.put(format_args!("[{count}]"))?;
        }
        let own = domain.attributes_of(object.type_index);
        self.put(format_args!(" {{ "))?;
        self.attributes(own, &[])?;
        let same = other.and_then(|other| {
            let mut all = other.objects().iter();
            let same = all.find(|own| own.name == object.name)?;
            Some(other.attributes_of(same.type_index))
        });
        self.attributes(same.unwrap_or_default(), own)?;
        self.put(format_args!(" }}\n"))
    }

    /// An object of the later controller, with all that describes it, unless it has a role.
    fn argument(&mut self, kind: &ObjectType, number: usize) -> Result<(), Error> {
        let is_it = |own: &Object<'_>| match own.name.strip_prefix(kind.name) {
            Some("") => number == 1,
            Some(digits) => digits.parse() == Ok(number),
            None => false,
        };
        if kind.attributes.is_empty() || self.first.objects().iter().any(is_it) {
            return Ok(());
        }
        self.put(format_args!("object {}", kind.name))?;
        if number > 1 {
            self.put(format_args!("{number}"))?;
        }
        self.put(format_args!(" {{ "))?;
        self.attributes(kind.attributes, &[])?;
        self.put(format_args!(" }}\n"))
    }

    /// Attributes that are not among those before.
    fn attributes(&mut self, own: &[Attribute<'_>], before: &[Attribute<'_>]) -> Result<(), Error> {
        let mut is_first = before.is_empty();
        for attribute in own {
            match before.iter().find(|other| other.name == attribute.name) {
                Some(same) if same == attribute => continue,
                Some(_) => {
                    return Err(Error::Mismatch(
                        "the texts of the two controllers give an attribute two dimensions",
                    ));
                }
                None => {}
            }
            let comma = if is_first { "" } else { ", " };
            let dimension = attribute.dimension.name();
            self.put(format_args!("{comma}{}: {dimension}", attribute.name))?;
            is_first = false;
        }
        Ok(())
    }

    fn parameters(&mut self) -> Result<(), Error> {
        for parameter in self.first.parameters() {
            self.put(format_args!("parameter {} in [", parameter.name))?;
            self.number(parameter.low)?;
            self.put(format_args!(", "))?;
            self.number(parameter.high)?;
            self.put(format_args!("]: {}\n", parameter.dimension.name()))?;
        }
        Ok(())
    }

    /// Points and shapes: those of the first text, and those of the second that it has not
    /// and that can be told before.
    fn places(&mut self) -> Result<(), Error> {
        for place in Places::of(self.first.text()) {
            self.put(format_args!("{}\n", place.text))?;
        }
        let Some(second) = self.second() else {
            return Ok(());
        };
        let parameters = second.parameters().iter().map(|own| own.name);
        let mut dropped: Vec<&str, MAX_DROPPED> = crate::table::gather(parameters);
        for place in Places::of(second.text()) {
            if place.mentions(&dropped) {
                dropped.push(place.name).map_err(|_| {
                    Error::CapacityExceeded(
                        "points that move with parameters of a later controller",
                    )
                })?;
                continue;
            }
            let known = Places::of(self.first.text());
            let mut known = known.filter(|other| other.keyword == place.keyword);
            let is_there = known.any(|other| other.name == place.name)
                || place.keyword == "point" && self.first.find_point(place.name).is_some();
            if !is_there {
                self.put(format_args!("{}\n", place.text))?;
            }
        }
        Ok(())
    }
}

/// The objects of a text, each group once.
fn roles<'d>(domain: &'d Domain<'_>) -> impl Iterator<Item = &'d Object<'d>> {
    let is_role = |own: &&Object<'_>| own.member.is_none_or(|member| member.index == 0);
    domain.objects().iter().filter(is_role)
}

/// A statement that declares a point or a shape.
#[derive(Clone, Copy)]
struct Place<'t> {
    keyword: &'t str,
    name: &'t str,
    text: &'t str,
}

impl Place<'_> {
    /// Whether its expressions depend on one of these names, or its body is of one.
    fn mentions(&self, names: &[&str]) -> bool {
        let mut lexer = Lexer::new(self.text);
        loop {
            match lexer.advance() {
                Token::End => return false,
                Token::Name(word) => {
                    let is_it = |name: &&str| match word.strip_prefix(*name) {
                        Some(rest) => rest.is_empty() || rest.as_bytes().first() == Some(&b'.'),
                        None => false,
                    };
                    if names.iter().any(is_it) {
                        return true;
                    }
                }
                _ => {}
            }
        }
    }
}

/// The points and shapes of a text, in order.
struct Places<'t> {
    text: &'t str,
    lexer: Lexer<'t>,
}

impl<'t> Places<'t> {
    fn of(text: &'t str) -> Places<'t> {
        let lexer = Lexer::new(text);
        Places { text, lexer }
    }

    /// The statement that begins at the token, and moves on behind it.
    fn statement(&mut self) -> Option<Place<'t>> {
        let start = self.lexer.position();
        let Token::Name(keyword) = self.lexer.advance() else {
            return None;
        };
        let name = match self.lexer.token() {
            Token::Name(name) => name,
            _ => "",
        };
        let (mut end, mut depth) = (start, 0usize);
        loop {
            match self.lexer.token() {
                Token::End => break,
                Token::Name(word) if depth == 0 && STATEMENTS.contains(&word) => break,
                Token::Symbol("(" | "[" | "{") => depth += 1,
                Token::Symbol(")" | "]" | "}") => depth = depth.saturating_sub(1),
                _ => {}
            }
            end = self.lexer.end();
            self.lexer.advance();
        }
        let text = self.text.get(start..end).unwrap_or_default();
        Some(Place {
            keyword,
            name,
            text,
        })
    }
}

/// The words that statements begin with.
const STATEMENTS: [&str; 6] = ["type", "object", "constant", "parameter", "shape", "point"];

impl<'t> Iterator for Places<'t> {
    type Item = Place<'t>;

    fn next(&mut self) -> Option<Place<'t>> {
        loop {
            let statement = self.statement()?;
            if matches!(statement.keyword, "point" | "shape") {
                return Some(statement);
            }
        }
    }
}
