//! Statements that declare objects, single ones and groups.

use super::{DomainParser, small};
use crate::domain::schema::{MAX_OBJECTS, PoseSlots};
use crate::domain::{Base, Group, Member, Object};
use crate::error::Error;
use crate::text::Token;
use heapless::Vec;

const FULL: Error = Error::CapacityExceeded("objects of a domain");

/// A name that is declared, and how many members a group of that name has.
type Named<'t> = (&'t str, Option<u8>);

impl<'t> DomainParser<'_, 't> {
    #[inline(never)]
    pub(super) fn object_statement(&mut self) -> Result<(), Error> {
        let mut all: Vec<Named<'t>, MAX_OBJECTS> = Vec::new();
        loop {
            let name = self.new_name("expected the name of the object", false)?;
            if all.iter().any(|(other, _)| *other == name) {
                return Err(self.lexer.error("this object was just declared"));
            }
            all.push((name, self.member_count()?)).map_err(|_| FULL)?;
            if !self.lexer.accept(",") {
                break;
            }
        }
        let at = self.lexer.clone();
        let type_index = if self.lexer.accept(":") {
            let at = self.lexer.clone();
            let kind = self.lexer.expect_name("expected the name of a type")?;
            let found = self.domain.types.iter().position(|t| t.name == kind);
            small(found.ok_or_else(|| at.error("unknown type"))?)?
        } else {
            match all.as_slice() {
                [(name, _)] => self.attributes(name)?,
                _ => return Err(at.error("expected `:` and the type of these objects")),
            }
        };
        let absent = self.domain.attributes_of(type_index).is_empty();
        if absent && all.iter().any(|(_, count)| count.is_some()) {
            return Err(at.error("members need attributes, which tell those that are absent"));
        }
        all.iter()
            .try_for_each(|named| self.objects(*named, type_index))
    }

    /// `[ number ]` behind the name of a group.
    fn member_count(&mut self) -> Result<Option<u8>, Error> {
        const WHAT: &str = "expected how many members the group has, a whole number from 1";
        if !self.lexer.accept("[") {
            return Ok(None);
        }
        let at = self.lexer.clone();
        let count = match self.lexer.advance() {
            Token::Number(number) if number >= 1.0 => number as u64,
            _ => return Err(at.error(WHAT)),
        };
        if at.token() != Token::Number(count as f64) {
            return Err(at.error(WHAT));
        }
        self.lexer.expect("]", "expected `]`")?;
        u8::try_from(count).map(Some).map_err(|_| FULL)
    }

    /// Declares an object, or all members of a group, and their poses as points.
    fn objects(&mut self, (name, count): Named<'t>, type_index: u8) -> Result<(), Error> {
        let first_object = small(self.domain.objects.len())?;
        let group = match count {
            None => None,
            Some(count) => {
                let group = Group {
                    first_object,
                    count,
                };
                let index = small(self.domain.groups.len())?;
                let pushed = self.domain.groups.push(group);
                pushed.map_err(|_| Error::CapacityExceeded("groups of a domain"))?;
                Some(index)
            }
        };
        for index in 0..count.unwrap_or(1) {
            self.object(name, type_index, group.map(|group| Member { group, index }))?;
        }
        if let [Some(_), Some(_), _] = self.domain.pose_slots(first_object).position {
            let base = Base::Object(first_object);
            self.point(name, "", base, [None; 3], [None; 3])?;
        }
        Ok(())
    }

    fn object(
        &mut self,
        name: &'t str,
        type_index: u8,
        member: Option<Member>,
    ) -> Result<(), Error> {
        let attributes = self.domain.attributes_of(type_index);
        let object = Object {
            name,
            type_index,
            member,
            first_slot: self.domain.slots,
            pose: PoseSlots::find(attributes, self.domain.slots),
        };
        self.domain.slots = small(usize::from(self.domain.slots) + attributes.len())?;
        self.domain.objects.push(object).map_err(|_| FULL)
    }
}
