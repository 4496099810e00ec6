//! What only a desktop needs, beside the stack and never under it: the double-precision
//! reference, the comparison of pictures, scene files, and where a ray goes.

pub mod compare;
pub mod file;
pub mod path;
pub mod reference;
