//! The planner, its heuristics and search, and PDDL.

mod conclusions;
mod graph;
mod parameters;
mod pddl;
mod planner;
mod strips;
