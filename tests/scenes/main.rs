//! Tests pictures of scenes. They are one program, so that the renderer is compiled once for all.

mod accuracy;
mod areas;
mod bound;
mod budget;
mod course;
mod discs;
mod drawing;
mod far;
mod held;
mod motion;
mod near;
mod ranges;
mod smooth;
mod suns;
mod triangles;
