//! Code that the commands of the repository share: names of scenes, sizes, qualities and shadings on
//! the command line, scene files, where output goes, and error messages of one line. Only [`print()`] prints, and
//! [`parse`] if the command line asks for help.

mod draw;
mod file;
mod mistake;
mod samples;
pub mod scene_file;
mod setting;
mod source;

pub use draw::Settings;
pub use file::{OutputFile, are_same_file, is_standard_output, print, shown};
pub use mistake::{exit_code, in_one_line, json_line, parse};
pub use reflet::host::line::one_line;
pub use samples::four_samples;
pub use setting::{Quality, Shading, size};
pub use source::{Chosen, Named, Source, exact, with_advice};

/// An error of a command, in words for the person who typed it.
pub type Failure = Box<dyn std::error::Error + Send + Sync>;
