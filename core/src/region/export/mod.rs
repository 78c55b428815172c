//! A region for programs that do not have the library.

mod c;
