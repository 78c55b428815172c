//! The planner, its heuristics and search, and PDDL.

mod graph;
mod parameters;
mod pddl;
mod planner;
mod strips;
