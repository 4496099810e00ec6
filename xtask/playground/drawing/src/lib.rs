//! Draws pictures for the playground, row by row. It never knows what a page asks for.

mod display;
mod frame;
mod lines;
mod settings;

pub use frame::Frame;
pub use lines::{Lines, prepared};
pub use settings::Settings;
