//! Counts *lost* pixels: those that `Exact` has right and an interpolating quality has wrong. Draws
//! scenes of any origin, and makes random scenes that lose many. This library prints nothing.
#![deny(missing_docs)]

#[macro_use]
#[path = "../../../src/kinds.rs"]
mod kinds;
#[macro_use]
#[path = "../../../src/host/shapes.rs"]
mod shapes;

pub mod case;
pub mod count;
pub mod families;
pub mod file;
pub mod parallel;
pub mod table;
pub mod truth;
