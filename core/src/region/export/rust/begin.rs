#![allow(dead_code, unused_mut, unused_variables, clippy::all)]

