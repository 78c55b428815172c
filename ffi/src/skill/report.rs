//! What was learned, and what it took.

use crate::boundary::status::{Failure, Fallible, critreg_status, status_of};
use crate::boundary::structs::{self, Versioned};
use crate::boundary::text;
use crate::learner::quality::{self, CRITREG_WHY_NOTHING_TOLD};
use crate::region::quality::CRITREG_NO_QUALITY;
use crate::skill::handle::{Inner, critreg_skills, with_skills};
use core::ffi::c_char;
use core::fmt;
use critreg_core::learn::version_space::Quality;
use critreg_core::skill::{Learned, Skill};

/// What was learned of a skill, and what it took.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct critreg_skill_report {
    /// Size of this struct in bytes, from critreg_skill_report_init().
    pub struct_size: u32,
    /// 1 if it was learned; 0 if its turn has not come.
    pub finished: u32,
    /// 1 if there is a region, which planning uses; else 0.
    pub has_region: u32,
    /// CRITREG_EXACT, CRITREG_APPROXIMATE, CRITREG_PROVISIONAL or CRITREG_NO_QUALITY.
    pub quality: u32,
    /// Why there is no region, or none that is exact: CRITREG_WHY_EXPLAINED and so on, as for
    /// critreg_learner_why().
    pub why: u32,
    /// Training tasks that situations were taken from.
    pub tasks: u32,
    /// Situations that it was tried in.
    pub situations: u32,
    /// Runs of controllers, those on the way to a situation included.
    pub runs: u32,
    /// Questions that were answered.
    pub calls: u32,
    /// How often it worked.
    pub feasible: u32,
    /// How often it did not.
    pub infeasible: u32,
    /// Draws from the region that were tried to certify it.
    pub certificate_draws: u32,
    /// Those of them that worked.
    pub certificate_feasible: u32,
    /// Always 0.
    pub reserved: u32,
    /// At least this share of the region works, with the confidence of the learner.
    pub certificate_lower_bound: f64,
}

// SAFETY: it is repr(C) and starts with struct_size.
unsafe impl Versioned for critreg_skill_report {
    const FIRST: usize = size_of::<critreg_skill_report>();
}

const NOTHING: critreg_skill_report = critreg_skill_report {
    struct_size: size_of::<critreg_skill_report>() as u32,
    finished: 0,
    has_region: 0,
    quality: CRITREG_NO_QUALITY,
    why: CRITREG_WHY_NOTHING_TOLD,
    tasks: 0,
    situations: 0,
    runs: 0,
    calls: 0,
    feasible: 0,
    infeasible: 0,
    certificate_draws: 0,
    certificate_feasible: 0,
    reserved: 0,
    certificate_lower_bound: 0.0,
};

/// Prepares a report for critreg_skills_report().
///
/// @param report The report.
/// @param size sizeof *report; see critreg_config_init().
/// @return As critreg_config_init().
#[unsafe(no_mangle)]
pub unsafe extern "C" fn critreg_skill_report_init(
    report: *mut critreg_skill_report,
    size: usize,
) -> critreg_status {
    // SAFETY: the header makes it the caller's promise.
    status_of(unsafe { structs::init(report, size, NOTHING) })
}

/// What was learned of a skill, and what it took.
///
/// @param skills The skills.
/// @param index Which skill, from 0, in the order in which they were added.
/// @param report A report from critreg_skill_report_init(), to be filled.
/// @return CRITREG_INVALID_ARGUMENT if there is no such skill or the report was not
/// initialised; CRITREG_BUSY, CRITREG_NULL_POINTER, CRITREG_MISALIGNED,
/// CRITREG_NOT_A_HANDLE.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn critreg_skills_report(
    skills: *mut critreg_skills,
    index: usize,
    report: *mut critreg_skill_report,
) -> critreg_status {
    // SAFETY: the header makes it the caller's promise, for both.
    unsafe {
        with_skills(skills, |inner| {
            let (_, learned) = inner.skill(index)?;
            structs::write(learned.map_or(NOTHING, report_of), report, "report")
        })
    }
}

/// Writes the region of a skill as text, such as "grasp.y <= 2.9 (zone.top - robot.radius)";
/// or, if it has none, why.
///
/// @param skills The skills.
/// @param index Which skill, from 0.
/// @param text Receives the text, ended by NUL.
/// @param len Length of text in bytes; 0 to ask for the length only.
/// @param needed NULL, or receives the length of the text with its NUL, also if the buffer
/// is too small.
/// @return CRITREG_NO_REGION if there is none: the text then tells why; CRITREG_TOO_SMALL;
/// CRITREG_INVALID_ARGUMENT if there is no such skill; CRITREG_BUSY, CRITREG_NULL_POINTER,
/// CRITREG_MISALIGNED, CRITREG_NOT_A_HANDLE.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn critreg_skills_format(
    skills: *mut critreg_skills,
    index: usize,
    text: *mut c_char,
    len: usize,
    needed: *mut usize,
) -> critreg_status {
    // SAFETY: the header makes it the caller's promise, for all.
    unsafe {
        with_skills(skills, |inner| {
            let (skill, learned) = inner.skill(index)?;
            text::write(&Words { skill, learned }, text, len, needed)?;
            match skill.region() {
                Some(_) => Ok(()),
                None => Err(critreg_core::Error::NoRegion.into()),
            }
        })
    }
}

/// Writes the domain text of a skill: as it was added, or as it was made of the texts of its
/// members. With it, critreg_region_parse() makes a region of what critreg_skills_format()
/// wrote.
///
/// @param skills The skills.
/// @param index Which skill, from 0.
/// @param text Receives the text, ended by NUL.
/// @param len Length of text in bytes; 0 to ask for the length only.
/// @param needed NULL, or receives the length of the text with its NUL, also if the buffer
/// is too small.
/// @return CRITREG_TOO_SMALL; CRITREG_INVALID_ARGUMENT if there is no such skill;
/// CRITREG_BUSY, CRITREG_NULL_POINTER, CRITREG_MISALIGNED, CRITREG_NOT_A_HANDLE.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn critreg_skills_domain(
    skills: *mut critreg_skills,
    index: usize,
    text: *mut c_char,
    len: usize,
    needed: *mut usize,
) -> critreg_status {
    // SAFETY: the header makes it the caller's promise, for all.
    unsafe {
        with_skills(skills, |inner| {
            let (skill, _) = inner.skill(index)?;
            text::write(&skill.domain().text(), text, len, needed)
        })
    }
}

impl Inner {
    /// A skill, and what it took if it was learned.
    fn skill(&self, index: usize) -> Fallible<(&Skill, Option<&Learned>)> {
        let skill = self.skills.get(index).and_then(Option::as_ref);
        let skill = skill.ok_or(Failure::invalid("there is no such skill"))?;
        let learned = self.learned.get(index);
        Ok((skill, learned.filter(|_| index < self.learned_count)))
    }
}

fn report_of(learned: &Learned) -> critreg_skill_report {
    let report = &learned.report;
    critreg_skill_report {
        finished: 1,
        has_region: u32::from(learned.region),
        quality: quality::number(learned.quality),
        why: quality::code(&learned.why),
        tasks: learned.tasks as u32,
        situations: learned.situations as u32,
        runs: learned.runs,
        calls: report.calls as u32,
        feasible: report.feasible as u32,
        infeasible: report.infeasible as u32,
        certificate_draws: report.certificate.draws,
        certificate_feasible: report.certificate.feasible,
        certificate_lower_bound: report.certificate.lower_bound,
        ..NOTHING
    }
}

/// The region of a skill, or why there is none.
struct Words<'a> {
    skill: &'a Skill,
    learned: Option<&'a Learned>,
}

impl fmt::Display for Words<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if let Some(region) = self.skill.region() {
            return region.write(self.skill.domain(), f);
        }
        match self.learned {
            None => f.write_str("it was not learned yet"),
            Some(learned) if learned.situations == 0 => {
                f.write_str("no training task leads to a situation in which it could be tried")
            }
            Some(learned) if learned.quality < Quality::Approximate => learned.why.fmt(f),
            Some(_) => f.write_str(
                "the later controller worked wherever the first one did: nothing is to be said",
            ),
        }
    }
}
