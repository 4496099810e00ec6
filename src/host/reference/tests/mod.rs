//! Tests of the reference.

mod shade;
mod shape;
mod trace;
mod vector;
mod view;
mod world;
