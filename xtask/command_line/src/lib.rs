//! What the commands of the repository have in common: how a scene, a size, a quality and a shading
//! are named, where their output goes, and how a mistake is told in one line. Only [`print()`] prints,
//! and [`parse`] where help is asked for.

mod file;
mod mistake;
mod setting;
mod source;

pub use file::{NewFile, are_same_file, is_standard_output, print, shown};
pub use mistake::{in_one_line, json_line, parse};
pub use reflet::host::line::one_line;
pub use setting::{Quality, Shading, size};
pub use source::{Chosen, Kind, Named, Source, with_advice};

/// What goes wrong in a command, in words for the person who typed it.
pub type Failure = Box<dyn std::error::Error + Send + Sync>;
