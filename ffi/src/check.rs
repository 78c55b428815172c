//! What is wrong with a text, in words.

use crate::boundary::limits::CRITREG_DOMAIN_TEXT_MAX;
use crate::boundary::pointer;
use crate::boundary::status::{Failure, Fallible, critreg_status, status_of};
use crate::boundary::structs;
use crate::boundary::text;
use crate::learner;
use crate::learner::config::{
    CRITREG_DEFAULT_FORMS, CRITREG_MAX_OBSERVATIONS, CRITREG_MAX_STEPS, CRITREG_VERSION_SPACE,
    critreg_config,
};
use crate::learner::layout::LearnerLayout;
use crate::planner::config::{self, LINKS_OF_OPERATOR, critreg_planner_config};
use crate::planner::making::read_texts;
use crate::region::making::REGION_TEXT_MAX;
use core::ffi::c_char;
use core::fmt;
use critreg_core::Error;
use critreg_core::domain::{Domain, MAX_SAMPLE_POINTS};
use critreg_core::pddl;
use critreg_core::plan;
use critreg_core::region::Region;

/// Most atoms of `:init` that a check has room for.
const MAX_FACTS: usize = 2048;
/// Most ground operators of a planner, which numbers them so.
const MAX_OPERATORS: usize = u16::MAX as usize;

/// Reads a domain text and says what is wrong with it, such as
/// "line 3, column 7: unknown object".
///
/// @param domain The domain text, ended by NUL.
/// @param text Receives the words, ended by NUL: an empty text if all is well.
/// They are written also if the check fails, which is what they are for, and cut
/// off where the buffer ends. 256 bytes are always enough.
/// @param len Length of text in bytes; 0 if the words are not wanted.
/// @param needed NULL, or receives the length of the words with their NUL.
/// @return CRITREG_OK if the text is a domain; CRITREG_SYNTAX_ERROR; CRITREG_CAPACITY_EXCEEDED if it is
/// longer than CRITREG_DOMAIN_TEXT_MAX or declares too many things;
/// CRITREG_INVALID_ARGUMENT if it is not UTF-8; CRITREG_NULL_POINTER,
/// CRITREG_MISALIGNED.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn critreg_check_domain(
    domain: *const c_char,
    text: *mut c_char,
    len: usize,
    needed: *mut usize,
) -> critreg_status {
    // SAFETY: the header makes it the caller's promise, for both.
    unsafe {
        let checked = check_domain(domain);
        explain(checked, text, len, needed)
    }
}

/// Looks at the configuration of a learner and says what is wrong with it, such as
/// "config.noise is from 0 to 0.2, not 0.5".
///
/// What depends on the domain text is not looked at: the manual samples of
/// CRITREG_ALGORITHM1.
///
/// @param config The configuration, from critreg_config_init() and changed since; NULL for
/// the defaults, with which nothing is wrong.
/// @param text Receives the words, as for critreg_check_domain().
/// @param len Length of text in bytes; 0 if the words are not wanted.
/// @param needed NULL, or receives the length of the words with their NUL.
/// @return CRITREG_OK if critreg_learner_init() would accept it, given memory enough;
/// CRITREG_INVALID_ARGUMENT; CRITREG_NOT_FINITE for a share that is NaN or infinite;
/// CRITREG_TOO_SMALL if no memory can be that large; CRITREG_NULL_POINTER,
/// CRITREG_MISALIGNED.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn critreg_check_config(
    config: *const critreg_config,
    text: *mut c_char,
    len: usize,
    needed: *mut usize,
) -> critreg_status {
    // SAFETY: the header makes it the caller's promise, for both.
    unsafe {
        let checked = learner::config::read(config).and_then(|config| check_learner(&config));
        explain(checked, text, len, needed)
    }
}

/// What is wrong with the configuration of a learner.
fn check_learner(config: &critreg_config) -> Fallible {
    if !(1..=CRITREG_MAX_STEPS).contains(&config.steps) {
        return Err(out_of_range("config.steps is from 1 to 4", config.steps));
    }
    if config.observations > CRITREG_MAX_OBSERVATIONS {
        let what = "config.observations is up to 2048";
        return Err(out_of_range(what, config.observations));
    }
    if config.learner == CRITREG_VERSION_SPACE {
        for (expected, share, [low, high]) in config.shares().shares() {
            if !(low..=high).contains(&share) {
                return Err(Failure::Share(expected, share.to_ne_bytes()));
            }
        }
    }
    let mut capacity = config.capacity()?;
    if capacity.forms() == 0 {
        capacity = capacity.with_forms(CRITREG_DEFAULT_FORMS as usize);
    }
    let layout = LearnerLayout::new(capacity, config.precision()?);
    layout
        .map(|_| ())
        .ok_or(Failure::TooSmall("any memory, for these capacities"))
}

fn out_of_range(expected: &'static str, number: u32) -> Failure {
    Failure::Number(expected, i32::try_from(number).unwrap_or(i32::MAX))
}

const _: () = assert!(MAX_SAMPLE_POINTS == 8, "an error names it");

/// Whether a learner has room for the points that move with a parameter.
fn check_points(domain: &Domain<'_>) -> Fallible {
    let moving = domain.points().iter().filter(|point| point.sampled).count();
    if moving > MAX_SAMPLE_POINTS {
        let count = u32::try_from(moving).unwrap_or(u32::MAX);
        return Err(Failure::TooMany(
            count,
            "points move with a parameter, 8 fit",
        ));
    }
    Ok(())
}

/// Reads a region text and says what is wrong with it.
///
/// @param domain The domain text that the region speaks about, ended by NUL.
/// @param region_text The region text, ended by NUL.
/// @param text Receives the words, as for critreg_check_domain(). If the domain
/// text is wrong, they are about that.
/// @param len Length of text in bytes; 0 if the words are not wanted.
/// @param needed NULL, or receives the length of the words with their NUL.
/// @return CRITREG_OK if critreg_region_parse() would accept both texts, else as
/// critreg_check_domain().
#[unsafe(no_mangle)]
pub unsafe extern "C" fn critreg_check_region(
    domain: *const c_char,
    region_text: *const c_char,
    text: *mut c_char,
    len: usize,
    needed: *mut usize,
) -> critreg_status {
    // SAFETY: the header makes it the caller's promise, for both.
    unsafe {
        let checked = check_region(domain, region_text);
        explain(checked, text, len, needed)
    }
}

/// Reads a PDDL domain and a problem of it and says what is wrong with them, such as
/// "problem, line 3, column 7: unknown object".
///
/// @param domain The PDDL domain, ended by NUL.
/// @param problem A PDDL problem of that domain, ended by NUL.
/// @param text Receives the words, as for critreg_check_domain().
/// @param len Length of text in bytes; 0 if the words are not wanted.
/// @param needed NULL, or receives the length of the words with their NUL.
/// @return CRITREG_OK if critreg_planner_init() would accept both texts, given
/// memory enough, else as critreg_check_domain(); CRITREG_CAPACITY_EXCEEDED for a
/// text longer than CRITREG_PDDL_TEXT_MAX or too many ground atoms.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn critreg_check_pddl(
    domain: *const c_char,
    problem: *const c_char,
    text: *mut c_char,
    len: usize,
    needed: *mut usize,
) -> critreg_status {
    // SAFETY: the header makes it the caller's promise, for both.
    unsafe {
        let (which, checked) = match read_texts(domain, problem) {
            Ok(texts) => check_pddl(texts),
            Err(failure) => ("", Err(failure)),
        };
        explain_part(which, checked, text, len, needed)
    }
}

/// What is wrong with a domain and a problem, and which of them is.
fn check_pddl(texts: [&str; 2]) -> (&'static str, Fallible) {
    let (which, measured) = measure(texts);
    (which, measured.map(|_| ()))
}

/// What a planner has to have room for.
struct Measured {
    operators: usize,
    atoms: usize,
    facts: usize,
}

/// What two texts take room for; or what is wrong with them, and with which.
fn measure([domain, problem]: [&str; 2]) -> (&'static str, Fallible<Measured>) {
    let domain = match pddl::Domain::parse(domain) {
        Ok(domain) => domain,
        Err(error) => return ("domain, ", Err(error.into())),
    };
    let mut facts = [pddl::Fact::default(); MAX_FACTS];
    let grounded = pddl::Problem::parse(&domain, problem, &mut facts)
        .and_then(|problem| measure_problem(&problem));
    ("problem, ", grounded.map_err(Failure::from))
}

fn measure_problem(problem: &pddl::Problem<'_>) -> Result<Measured, Error> {
    let mut grounding = pddl::Grounding::<16>::new(problem)?;
    let (mut operators, mut links) = (0, 0);
    grounding.operators(&mut |operator| {
        if operators == MAX_OPERATORS {
            return Err(Error::CapacityExceeded(
                "ground operators: more than a planner has places for",
            ));
        }
        operators += 1;
        links += plan::links(core::slice::from_ref(&operator));
        Ok(())
    })?;
    Ok(Measured {
        operators: operators.max(links.div_ceil(LINKS_OF_OPERATOR)),
        atoms: grounding.atoms().as_slice().len(),
        facts: problem.fact_count(),
    })
}

/// Sets pddl_bytes, operators, atoms and facts of a configuration to what a PDDL domain and
/// a problem of it need; the rest stays. Ask critreg_planner_size() then how much memory
/// that is.
///
/// It takes much stack, see above.
///
/// @param domain The PDDL domain, ended by NUL.
/// @param problem A PDDL problem of that domain, ended by NUL.
/// @param config A configuration from critreg_planner_config_init(), to be changed.
/// @return CRITREG_OK; else as critreg_check_pddl(), which has words for it, and nothing
/// is changed.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn critreg_planner_measure(
    domain: *const c_char,
    problem: *const c_char,
    config: *mut critreg_planner_config,
) -> critreg_status {
    let measured = || {
        // SAFETY: the header makes it the caller's promise, for both.
        let (texts, mut read) = unsafe { (read_texts(domain, problem)?, config::read(config)?) };
        let measured = measure(texts).1?;
        let number = |count: usize| u32::try_from(count).unwrap_or(u32::MAX);
        let bytes = texts.iter().map(|text| text.len() + 1).sum();
        read.pddl_bytes = number(bytes);
        read.operators = number(measured.operators);
        read.atoms = number(measured.atoms);
        read.facts = number(measured.facts);
        // SAFETY: as above.
        unsafe { structs::write(read, config, "config") }
    };
    status_of(measured())
}

/// What is large is on the stack while this runs, and no more when words are written.
///
/// # Safety
/// If not NULL, the text can be read up to its NUL.
#[inline(never)]
unsafe fn check_domain(domain: *const c_char) -> Fallible {
    // SAFETY: by this function's contract.
    let text = unsafe { pointer::text(domain, CRITREG_DOMAIN_TEXT_MAX, "domain")? };
    let mut domain = Domain::empty();
    domain.read(text)?;
    check_points(&domain)
}

/// # Safety
/// If not NULL, the texts can be read up to their NUL.
#[inline(never)]
unsafe fn check_region(domain: *const c_char, region_text: *const c_char) -> Fallible {
    // SAFETY: by this function's contract.
    let domain_text = unsafe { pointer::text(domain, CRITREG_DOMAIN_TEXT_MAX, "domain")? };
    let mut domain = Domain::empty();
    domain.read(domain_text)?;
    // SAFETY: as above.
    let text = unsafe { pointer::text(region_text, REGION_TEXT_MAX, "region_text")? };
    let mut region = Region::default();
    Ok(region.read(&domain, text)?)
}

/// What is wrong, and with what.
struct Words(&'static str, Fallible);

impl fmt::Display for Words {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Words(which, checked) = self;
        match checked {
            Ok(()) => Ok(()),
            Err(failure) => write!(f, "{which}{failure}"),
        }
    }
}

/// # Safety
/// As for [`text::write`].
unsafe fn explain(
    checked: Fallible,
    text: *mut c_char,
    len: usize,
    needed: *mut usize,
) -> critreg_status {
    // SAFETY: by this function's contract.
    unsafe { explain_part("", checked, text, len, needed) }
}

/// # Safety
/// As for [`text::write`].
unsafe fn explain_part(
    which: &'static str,
    checked: Fallible,
    text: *mut c_char,
    len: usize,
    needed: *mut usize,
) -> critreg_status {
    // SAFETY: by this function's contract.
    let written: Result<(), Failure> =
        unsafe { text::write_cut_off(&Words(which, checked), text, len, needed) };
    // A wrong buffer is the first thing to put right.
    status_of(written.and(checked))
}
