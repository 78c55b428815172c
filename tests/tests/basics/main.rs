//! What everything else computes with: numbers as text, precisions, frames and shapes.

mod bodies;
mod cuboid;
mod geometry;
mod micromath;
mod numbers;
mod sine;
