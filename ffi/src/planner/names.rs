//! The names of PDDL texts as C wants them.

use crate::planner::callbacks::critreg_ground;
use core::ffi::c_char;
use critreg_core::Error;
use critreg_core::pddl::{MAX_ACTIONS, MAX_OBJECTS, MAX_PREDICATES, Problem};
use critreg_core::task::{GroundAtom, GroundOperator, ObjectId};

/// The names of predicates, actions and objects, ended by NUL, in memory of the
/// planner.
pub(crate) struct Names {
    predicates: [*const c_char; MAX_PREDICATES],
    actions: [*const c_char; MAX_ACTIONS],
    objects: [*const c_char; MAX_OBJECTS],
}

impl Names {
    /// Copies the names of a problem into `room`, which is as long as the texts it
    /// was read from: behind each name there stands something else.
    pub(crate) fn new(problem: &Problem<'_>, room: &'static mut [u8]) -> Result<Names, Error> {
        let domain = problem.domain();
        let (predicates, actions) = (domain.predicates().iter(), domain.actions().iter());
        let mut writer = Writer { room };
        Ok(Names {
            predicates: writer.write_all(predicates.map(|p| p.name))?,
            actions: writer.write_all(actions.map(|a| a.name))?,
            objects: writer.write_all(problem.objects().iter().map(|o| o.name))?,
        })
    }

    pub(crate) fn atom(&self, atom: &GroundAtom) -> critreg_ground {
        self.ground(&self.predicates, atom.predicate.0, atom.objects.as_slice())
    }

    pub(crate) fn operator<const N: usize>(&self, ground: &GroundOperator<N>) -> critreg_ground {
        self.ground(&self.actions, ground.operator.0, ground.objects.as_slice())
    }

    /// An action with these objects.
    pub(crate) fn call(&self, action: u8, objects: &[ObjectId]) -> critreg_ground {
        self.ground(&self.actions, action, objects)
    }

    /// The name of an action.
    pub(crate) fn action(&self, index: u8) -> *const c_char {
        name(&self.actions, index)
    }

    fn ground(&self, names: &[*const c_char], index: u8, objects: &[ObjectId]) -> critreg_ground {
        let mut ground = critreg_ground {
            name: name(names, index),
            index: index.into(),
            object_count: objects.len() as u32,
            ..critreg_ground::NONE
        };
        let places = ground.objects.iter_mut().zip(&mut ground.object_names);
        for ((place, slot), ObjectId(object)) in places.zip(objects) {
            *place = u32::from(*object);
            *slot = name(&self.objects, *object);
        }
        ground
    }
}

fn name(names: &[*const c_char], index: u8) -> *const c_char {
    let known = names.get(usize::from(index)).copied();
    known.unwrap_or(core::ptr::null())
}

struct Writer {
    room: &'static mut [u8],
}

impl Writer {
    fn write_all<'n, const N: usize>(
        &mut self,
        names: impl Iterator<Item = &'n str>,
    ) -> Result<[*const c_char; N], Error> {
        let mut written = [core::ptr::null(); N];
        for (slot, name) in written.iter_mut().zip(names) {
            *slot = self.write(name)?;
        }
        Ok(written)
    }

    fn write(&mut self, name: &str) -> Result<*const c_char, Error> {
        let room = core::mem::take(&mut self.room);
        let split = room.split_at_mut_checked(name.len() + 1);
        let (own, rest) = split.ok_or(Error::CapacityExceeded("names of the PDDL texts"))?;
        self.room = rest;
        let ended = name.bytes().chain(core::iter::once(0));
        for (slot, byte) in own.iter_mut().zip(ended) {
            *slot = byte;
        }
        Ok(own.as_ptr().cast())
    }
}
