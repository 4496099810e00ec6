//! The catalogue of stiff and extreme cases, each with its bar and compared with the reference's own
//! formulas in single precision; the page with the results; and random scenes. Opens no file.

pub mod catalogue;
pub mod page;
pub mod random;
pub mod report;
