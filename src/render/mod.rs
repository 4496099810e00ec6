//! Floor 7: prepared frames, their rows, and the choice of the pixels that are traced.
//!
//! This floor knows no display: it returns colours as sums, and a size is two numbers.

mod builder;
mod interpolate;
mod prepared;
mod report;
mod smooth;
#[cfg(feature = "files")]
mod walk;

pub use builder::FrameBuilder;
pub use prepared::{PreparedFrame, Rows};
pub use report::Report;
pub(crate) use report::light_cut_off;
pub use smooth::Seam;

pub(crate) use interpolate::Buffer;
use interpolate::Colors;
#[cfg(feature = "host")]
pub(crate) use interpolate::block_of;

#[cfg(test)]
mod tests;
