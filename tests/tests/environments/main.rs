//! The built-in environments, against recordings and closed forms. `--nocapture` prints
//! how much is compared.

mod blocks;
mod cluttered_table;
mod coffee;
mod cover;
mod shelf;
mod single_precision;
mod stick_button;
mod stick_button_move;
