//! Model problems with known answers.

mod explicit;
mod periodic;
mod stiff;
