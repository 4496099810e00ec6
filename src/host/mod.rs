//! What only a desktop needs, beside the stack and never under it: the double-precision
//! reference, the comparison of pictures, and scene files.

pub mod compare;
pub mod file;
pub mod reference;
