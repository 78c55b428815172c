//! Saving what was learned so far, and going on from there.
//!
//! | bytes | content |
//! |---|---|
//! | 4 | `CRSK` |
//! | 2 | version, little endian, as all numbers |
//! | 4 | fingerprint of what is learned from |
//! | 2 | skills that were learned |
//! | | for each: what it took, its region as text, and its effects |
//! | 2 | controllers, and for each what it changes |
//! | | the journal of the skill that is being learned |
//! | 4 | CRC-32 of all before |

use super::config::Learned;
use super::journal::Journal;
use crate::error::Error;
use crate::learn::version_space::{Certificate, Quality, Report, Why};
use crate::region::Region;
use crate::skill::changes::Changes;
use crate::skill::effects::Effects;
use crate::skill::skills::{Skill, Skills};
use crate::wire::{Reader, Writer};

const MAGIC: &[u8; 4] = b"CRSK";
const VERSION: u16 = 3;
const WHAT: &str = "bytes for saved skills";

/// What was learned so far, to be saved or to go on from.
#[derive(Debug)]
pub struct Course<'c, 'm, 'j> {
    /// The skills, of which the first ones were learned.
    pub skills: &'c mut Skills<'m>,
    /// What it took to learn each of these first ones.
    pub learned: &'c mut [Learned],
    /// The runs of the skill that is being learned.
    pub journal: &'c mut Journal<'j>,
    /// A number that tells apart what is learned from: texts, tasks, configuration.
    pub fingerprint: u32,
}

impl Course<'_, '_, '_> {
    /// How many bytes [`Course::save`] needs, if so many skills were learned.
    pub fn saved_len(&self, count: usize) -> usize {
        let mut writer = Writer::new(&mut [], MAGIC, VERSION);
        self.write(count, &mut writer);
        writer.length().saturating_add(size_of::<u32>())
    }

    /// Saves the first `count` skills, which were learned, and the journal of the next one.
    /// Tells how many bytes that takes.
    ///
    /// # Errors
    /// [`Error::CapacityExceeded`] if the bytes are too few.
    pub fn save(&self, count: usize, bytes: &mut [u8]) -> Result<usize, Error> {
        let mut writer = Writer::new(bytes, MAGIC, VERSION);
        self.write(count, &mut writer);
        writer.finish(WHAT)
    }

    fn write(&self, count: usize, writer: &mut Writer<'_>) {
        writer.u32(self.fingerprint);
        writer.u16(count as u16);
        for (skill, learned) in self.skills.iter().zip(&*self.learned).take(count) {
            write_learned(learned, writer);
            let region = skill.region();
            writer.u16(region.map_or(0, |own| own.text_len(skill.domain())) as u16);
            if let Some(region) = region {
                // The writer takes everything, and counts what finds no room.
                let _ = region.write(skill.domain(), writer);
            }
            skill.effects().write(writer);
        }
        let changes = self.skills.all_changes();
        writer.u16(changes.len() as u16);
        changes.iter().for_each(|own| own.write(writer));
        self.journal.write(writer);
    }

    /// Goes on from saved bytes. Tells how many skills were learned; of the others nothing
    /// is known.
    ///
    /// # Errors
    /// [`Error::Corrupt`] for bytes that are no saved skills; [`Error::Mismatch`] if they
    /// were learned from something else; [`Error::CapacityExceeded`] if the journal finds no
    /// room. Then nothing is known of any skill.
    pub fn resume(&mut self, bytes: &[u8]) -> Result<usize, Error> {
        self.forget();
        let read = self.read(bytes);
        if read.is_err() {
            self.forget();
        }
        read
    }

    /// Knows nothing.
    fn forget(&mut self) {
        for index in 0..self.learned.len() {
            if let Some(skill) = self.skills.get_mut(index) {
                skill.set_region(None);
                skill.set_effects(Effects::default());
            }
        }
        self.skills.all_changes_mut().fill(Changes::default());
        self.journal.clear();
    }

    fn read(&mut self, bytes: &[u8]) -> Result<usize, Error> {
        let mut reader = Reader::new(bytes, MAGIC, VERSION)?;
        if reader.u32()? != self.fingerprint {
            return Err(Error::Mismatch(
                "the saved skills were learned from other texts, tasks or settings",
            ));
        }
        let count = usize::from(reader.u16()?);
        for index in 0..count {
            let learned = read_learned(&mut reader)?;
            let length = usize::from(reader.u16()?);
            let text = reader.text(length)?;
            let skill = self.skills.get_mut(index);
            let place = self.learned.get_mut(index);
            let (Some(skill), Some(place)) = (skill, place) else {
                return Err(Error::Corrupt("there are more saved skills than skills"));
            };
            *place = learned;
            if length > 0 {
                restore(skill, text)?;
            }
            skill.set_effects(Effects::read(&mut reader)?);
        }
        let changes = self.skills.all_changes_mut();
        if usize::from(reader.u16()?) != changes.len() {
            return Err(Error::Corrupt("there are other controllers"));
        }
        for own in changes {
            *own = Changes::read(&mut reader)?;
        }
        self.journal.read(&mut reader)?;
        reader.finish()?;
        Ok(count)
    }
}

fn restore(skill: &mut Skill, text: &str) -> Result<(), Error> {
    let region = Region::parse(skill.domain(), text)?;
    skill.set_region(Some(region));
    Ok(())
}

fn write_learned(learned: &Learned, writer: &mut Writer<'_>) {
    let report = &learned.report;
    let counts = [
        learned.tasks,
        learned.situations,
        report.forms,
        report.forms_left_out,
        report.calls,
        report.observed,
        report.feasible,
        report.infeasible,
        report.unknown,
        report.constraints_left_out,
        report.strays,
    ];
    counts.iter().for_each(|count| writer.u32(*count as u32));
    let certificate = &report.certificate;
    let counts = [
        learned.runs,
        certificate.draws,
        certificate.feasible,
        report.found,
        report.inside,
    ];
    counts.iter().for_each(|count| writer.u32(*count));
    writer.f64(certificate.lower_bound);
    writer.u16(u16::from(learned.region));
    writer.u16(learned.quality as u16);
    let (code, numbers) = match learned.why {
        Why::Explained => (0, [0, 0]),
        Why::NothingTold => (1, [0, 0]),
        Why::NoneWorked => (2, [0, 0]),
        Why::AllWorked => (3, [0, 0]),
        Why::NoInfluence => (4, [0, 0]),
        Why::TooFew { more } => (5, [more, 0]),
        Why::Contradiction { asked, differing } => (6, [asked, differing]),
        // Which samples they are means nothing without the learner.
        Why::Unexplained { samples, .. } => (7, [samples, 0]),
    };
    writer.u16(code);
    numbers.iter().for_each(|number| writer.u32(*number));
}

fn read_learned(reader: &mut Reader<'_>) -> Result<Learned, Error> {
    let mut count = || reader.u32().map(|count| count as usize);
    let mut learned = Learned {
        tasks: count()?,
        situations: count()?,
        ..Learned::default()
    };
    learned.report = Report {
        forms: count()?,
        forms_left_out: count()?,
        calls: count()?,
        observed: count()?,
        feasible: count()?,
        infeasible: count()?,
        unknown: count()?,
        constraints_left_out: count()?,
        strays: count()?,
        ..Report::default()
    };
    learned.runs = reader.u32()?;
    let (draws, feasible) = (reader.u32()?, reader.u32()?);
    (learned.report.found, learned.report.inside) = (reader.u32()?, reader.u32()?);
    learned.report.certificate = Certificate {
        draws,
        feasible,
        lower_bound: reader.f64()?,
    };
    learned.region = reader.u16()? != 0;
    const UNKNOWN: Error = Error::Corrupt("a saved skill has a quality that is none");
    let qualities = [
        Quality::None,
        Quality::Provisional,
        Quality::Approximate,
        Quality::Exact,
    ];
    let quality = usize::from(reader.u16()?);
    learned.quality = *qualities.get(quality).ok_or(UNKNOWN)?;
    let (code, first, second) = (reader.u16()?, reader.u32()?, reader.u32()?);
    learned.why = match code {
        0 => Why::Explained,
        1 => Why::NothingTold,
        2 => Why::NoneWorked,
        3 => Why::AllWorked,
        4 => Why::NoInfluence,
        5 => Why::TooFew { more: first },
        6 => Why::Contradiction {
            asked: first,
            differing: second,
        },
        7 => Why::Unexplained {
            samples: first,
            examples: [None; 3],
        },
        _ => return Err(UNKNOWN),
    };
    Ok(learned)
}
