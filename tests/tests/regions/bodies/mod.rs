//! Bodies in domain texts, and relations between them in region texts: they read back, they
//! mean what a few lines of geometry say, and draws and proofs of emptiness follow.

mod angles;
mod check;
mod compound;
mod plane;
mod relations;
mod shapes;
mod sight;
mod table;
mod turning;
