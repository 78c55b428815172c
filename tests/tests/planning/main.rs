//! The planner, its heuristics and search, and PDDL.

mod pddl;
mod planner;
mod strips;
