//! What everything else computes with: numbers as text, precisions, frames and shapes.

mod cuboid;
mod geometry;
mod micromath;
mod numbers;
mod sine;
