//! What is wrong with PDDL texts, in words, and what they need.

use crate::boundary::status::{Failure, Fallible, critreg_status, status_of};
use crate::boundary::structs;
use crate::boundary::text::explain;
use crate::planner::config::{self, LINKS_OF_OPERATOR, critreg_planner_config};
use crate::planner::making::read_texts;
use core::ffi::c_char;
use core::fmt;
use critreg_core::Error;
use critreg_core::pddl;
use critreg_core::plan;

/// Most atoms of `:init` that a check has room for.
const MAX_FACTS: usize = 2048;
/// Most ground operators of a planner, which numbers them so.
const MAX_OPERATORS: usize = u16::MAX as usize;

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
        explain(&Words(which, checked), checked, text, len, needed)
    }
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
