//! The catalogue of stiff and extreme cases, each with its bar and compared with the reference's own
//! formulas in single precision; and the page with the results. Opens no file.

pub mod catalogue;
pub mod page;
pub mod report;
