//! Domains, terms and regions: their text, membership, intervals and draws.

mod bodies;
mod division;
mod groups;
mod implication;
mod intersection;
mod large_numbers;
mod margins;
mod picture;
mod region;
mod vertex_angle;
