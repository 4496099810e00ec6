//! Floor 7: a frame made ready, its rows, and which of their pixels are traced.
//!
//! Knows no display: colours leave it as sums, and a size is two numbers.

mod builder;
mod interpolate;
mod prepared;
mod quality;
mod report;

pub use builder::FrameBuilder;
pub use prepared::{PreparedFrame, Rows};
pub use quality::{Exact, Fast, Fine, Quality, Small};
pub use report::Report;

use interpolate::Colors;
