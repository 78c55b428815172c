//! Which numbers of a state belong to which object.

use crate::skill::facts::{Facts, NO_TYPE};
use core::cmp::Ordering;
use critreg_core::Error;
use critreg_core::domain::{MAX_OBJECTS, Object};
use critreg_core::pddl::Problem;
use critreg_core::task::{ObjectId, State, TypeId};
use heapless::Vec;

const TOO_MANY: Error = Error::CapacityExceeded(
    "objects of a task for skills: at most 32, those of the layout among them",
);

/// The objects of a problem, in its order, and behind them those of the layout that it does
/// not have: of each its type, where its numbers begin, and how many they are.
type Entries = Vec<(TypeId, usize, usize), MAX_OBJECTS>;

/// The state of a problem that these numbers are, marked to be known again.
pub(crate) fn arranged(
    facts: &Facts,
    problem: &Problem<'_>,
    mark: u16,
    numbers: &[f64],
) -> Result<State, Error> {
    let mut entries = Entries::new();
    for _ in problem.objects() {
        entries.push((NO_TYPE, 0, 0)).map_err(|_| TOO_MANY)?;
    }
    let (layout, mut first) = (facts.layout, 0);
    for object in layout.objects() {
        let count = layout.attributes_of(object.type_index).len();
        let kind = TypeId(object.type_index);
        match object.member {
            None => {
                let entry = (kind, first, count);
                match problem.find_object(object.name) {
                    Some(id) => set(&mut entries, id, entry),
                    None => entries.push(entry).map_err(|_| TOO_MANY)?,
                }
                first += count;
            }
            Some(member) if member.index == 0 => {
                for id in members(facts, problem, object)?.iter() {
                    set(&mut entries, *id, (kind, first, count));
                    first += count;
                }
            }
            Some(_) => {}
        }
    }
    if first > numbers.len() {
        return Err(Error::Mismatch(
            "a state has fewer numbers than the layout has for the objects of its problem",
        ));
    }
    State::arranged(mark, entries.iter().copied(), numbers)
}

fn set(entries: &mut Entries, ObjectId(id): ObjectId, entry: (TypeId, usize, usize)) {
    if let Some(slot) = entries.get_mut(usize::from(id)) {
        *slot = entry;
    }
}

/// The objects of a problem that are members of a group of the layout: all of its type that
/// the layout does not name, in the order of their names.
fn members(
    facts: &Facts,
    problem: &Problem<'_>,
    group: &Object<'_>,
) -> Result<Vec<ObjectId, MAX_OBJECTS>, Error> {
    let (layout, domain) = (facts.layout, problem.domain());
    let name = |id: &ObjectId| {
        let object = problem.objects().get(usize::from(id.0));
        object.map_or("", |own| own.name)
    };
    let is_single = |id: &ObjectId| {
        let mut singles = layout.objects().iter().filter(|own| own.member.is_none());
        singles.any(|own| own.name.eq_ignore_ascii_case(name(id)))
    };
    let kind = facts.types.get(usize::from(group.type_index));
    let kind = kind.and_then(|kind| domain.find_type(kind.name));
    let Some(kind) = kind else {
        return Err(Error::Mismatch(
            "a group of the layout is of a type that the PDDL domain does not have",
        ));
    };
    let most = layout.objects().iter();
    let most = most.filter(|own| own.name == group.name).count();
    let mut found = Vec::<ObjectId, MAX_OBJECTS>::new();
    for id in problem.of_type(kind).filter(|id| !is_single(id)) {
        if found.len() >= most || found.push(id).is_err() {
            return Err(Error::CapacityExceeded(
                "members of a group of the layout: the problem has more objects of its type",
            ));
        }
        // Insertion: names are mostly in order already.
        let mut place = found.len() - 1;
        while place > 0 {
            let Some((before, [own, ..])) = found.split_at_mut_checked(place) else {
                break;
            };
            let Some(last) = before.last_mut() else { break };
            if compare(name(last), name(own)) != Ordering::Greater {
                break;
            }
            core::mem::swap(last, own);
            place -= 1;
        }
    }
    Ok(found)
}

/// The order of names: as texts, but a number at the end counts as a number.
fn compare(left: &str, right: &str) -> Ordering {
    let split = |name: &'_ str| {
        let digits = name.bytes().rev().take_while(u8::is_ascii_digit).count();
        let stem = name.len() - digits;
        let number = name
            .get(stem..)
            .and_then(|digits| digits.parse::<u64>().ok());
        (stem, number)
    };
    let (left_split, right_split) = (split(left), split(right));
    let lower = |byte: u8| byte.to_ascii_lowercase();
    let stem = left.bytes().take(left_split.0).map(lower);
    let stems = stem.cmp(right.bytes().take(right_split.0).map(lower));
    stems.then(left_split.1.cmp(&right_split.1))
}
