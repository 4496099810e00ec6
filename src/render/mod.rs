//! Floor 7: a frame made ready, its rows, and which of their pixels are traced.
//!
//! Knows no display: colours leave it as sums, and a size is two numbers.

mod frame;
mod interpolate;
mod picture;
mod quality;
mod report;

pub use frame::{Frame, StaticFrame};
pub use picture::Picture;
pub use quality::{Exact, Fast, Fine, Quality, Small};
pub use report::Report;

use interpolate::Colors;
