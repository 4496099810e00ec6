//! Stiff and extreme cases, each with its bar, beside the reference's own formulas in single
//! precision; and the page that says what came of them. It opens no file.

pub mod catalogue;
pub mod page;
pub mod report;
