//! Statements that declare types and objects, single ones and groups.

use super::parser::{DomainParser, is_word};
use crate::domain::declarations::PoseSlots;
use crate::domain::{Attribute, Base, Group, Member, Object, Type};
use crate::text::{Failed, Token, split_at_dot};

impl<'t> DomainParser<'_, 't> {
    #[inline(never)]
    pub(super) fn type_statement(&mut self) -> Result<(), Failed> {
        let at = self.lexer.place();
        let name = self.lexer.expect_name("expected the name of the type")?;
        if split_at_dot(name).is_some() || is_word(name) {
            return Err(self.lexer.fail_at(
                at,
                "a type has a plain name that is no word of the language",
            ));
        }
        if self.domain.types.iter().any(|t| t.name == name) {
            return Err(self.lexer.fail_at(at, "this type is declared already"));
        }
        self.attributes(name).map(|_| ())
    }

    /// Reads `{ x: length, ... }` and declares a type with these attributes.
    fn attributes(&mut self, name: &'t str) -> Result<u8, Failed> {
        self.lexer.expect("{", "expected `{` and the attributes")?;
        let first = self.domain.attributes.len();
        while !self.lexer.accept("}") {
            let at = self.lexer.place();
            let attribute = self
                .lexer
                .expect_name("expected the name of an attribute or `}`")?;
            let own = self.domain.attributes.iter().skip(first);
            if split_at_dot(attribute).is_some() || own.clone().any(|a| a.name == attribute) {
                return Err(self
                    .lexer
                    .fail_at(at, "attributes have plain names, each once"));
            }
            self.lexer.expect(":", "expected `:` and a dimension")?;
            let dimension = self.dimension()?;
            let attribute = Attribute {
                name: attribute,
                dimension,
            };
            self.domain
                .attributes
                .push(attribute)
                .map_err(|_| self.lexer.full("attributes of a domain"))?;
            if !self.lexer.accept(",") {
                self.lexer.expect("}", "expected `,` or `}`")?;
                break;
            }
        }
        let kind = Type {
            name,
            first: self.small(first)?,
            count: self.small(self.domain.attributes.len() - first)?,
        };
        let index = self.small(self.domain.types.len())?;
        self.domain
            .types
            .push(kind)
            .map_err(|_| self.lexer.full("types of a domain"))?;
        Ok(index)
    }

    #[inline(never)]
    pub(super) fn object_statement(&mut self) -> Result<(), Failed> {
        let first = self.domain.objects.len();
        loop {
            let name = self.new_name("expected the name of the object", false)?;
            match self.member_count()? {
                None => self.object(name, None)?,
                Some(count) => self.group(name, count)?,
            }
            if !self.lexer.accept(",") {
                break;
            }
        }
        let at = self.lexer.place();
        let type_index = self.type_of_objects(first)?;
        let mut own = self.domain.objects.iter().skip(first);
        let absent = self.domain.attributes_of(type_index).is_empty();
        if absent && own.any(|object| object.member.is_some()) {
            let what = "members need attributes, which tell those that are absent";
            return Err(self.lexer.fail_at(at, what));
        }
        (first..self.domain.objects.len()).try_for_each(|index| self.describe(index, type_index))
    }

    /// Reads `: type`, or the attributes of the one object that was declared.
    fn type_of_objects(&mut self, first: usize) -> Result<u8, Failed> {
        if self.lexer.accept(":") {
            let at = self.lexer.place();
            let name = self.lexer.expect_name("expected the name of a type")?;
            let found = self.domain.types.iter().position(|t| t.name == name);
            let found = found.ok_or_else(|| self.lexer.fail_at(at, "unknown type"))?;
            return self.small(found);
        }
        let own = self.domain.objects.get(first..).unwrap_or_default();
        match own {
            [first, others @ ..] if others.iter().all(|o| o.name == first.name) => {
                self.attributes(first.name)
            }
            _ => Err(self
                .lexer
                .fail("expected `:` and the type of these objects")),
        }
    }

    /// Reads `[ number ]` behind the name of a group.
    fn member_count(&mut self) -> Result<Option<u8>, Failed> {
        if !self.lexer.accept("[") {
            return Ok(None);
        }
        let count = match self.lexer.token() {
            Token::Number(number) if number >= 1.0 && number as u64 as f64 == number => number,
            _ => {
                let what = "expected how many members the group has, a whole number from 1";
                return Err(self.lexer.fail(what));
            }
        };
        self.lexer.advance();
        self.lexer.expect("]", "expected `]`")?;
        u8::try_from(count as u64)
            .map(Some)
            .map_err(|_| self.full())
    }

    /// Declares all members of a group, still without attributes.
    fn group(&mut self, name: &'t str, count: u8) -> Result<(), Failed> {
        let first_object = self.small(self.domain.objects.len())?;
        let group = self.small(self.domain.groups.len())?;
        let declared = Group {
            first_object,
            count,
        };
        let pushed = self.domain.groups.push(declared);
        pushed.map_err(|_| self.lexer.full("groups of a domain"))?;
        (0..count).try_for_each(|index| self.object(name, Some(Member { group, index })))
    }

    /// Declares an object, still without attributes.
    fn object(&mut self, name: &'t str, member: Option<Member>) -> Result<(), Failed> {
        let object = Object {
            name,
            type_index: 0,
            member,
            first_slot: 0,
            pose: PoseSlots::default(),
        };
        let pushed = self.domain.objects.push(object);
        pushed.map_err(|_| self.full())
    }

    fn full(&mut self) -> Failed {
        self.lexer.full("objects of a domain")
    }

    /// Gives an object its attributes, and declares its pose as a point; for the first
    /// member of a group, the poses of all members.
    fn describe(&mut self, index: usize, type_index: u8) -> Result<(), Failed> {
        let first_slot = self.domain.slots;
        let attributes = self.domain.attributes_of(type_index);
        let pose = PoseSlots::find(attributes, first_slot);
        self.domain.slots = self.small(usize::from(first_slot) + attributes.len())?;
        let Some(object) = self.domain.objects.get_mut(index) else {
            return Ok(());
        };
        (object.type_index, object.first_slot, object.pose) = (type_index, first_slot, pose);
        if pose.has_place() && object.member.is_none_or(|member| member.index == 0) {
            let name = object.name;
            let base = Base::Object(self.small(index)?);
            self.point(name, "", base, [None; 3], [None; 3])?;
        }
        Ok(())
    }
}
