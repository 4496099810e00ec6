//! What the commands of the repository have in common: how a scene, a size, a quality and a shading
//! are named, and how a mistake is told in one line. Only [`parse`] prints, where help is asked for.

mod mistake;
mod setting;
mod source;

pub use mistake::{in_one_line, one_line, parse};
pub use setting::{Quality, Shading, size};
pub use source::{Kind, Source};

/// What goes wrong in a command, in words for the person who typed it.
pub type Failure = Box<dyn std::error::Error + Send + Sync>;
