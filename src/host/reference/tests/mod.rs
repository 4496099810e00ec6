//! Tests of the reference.

mod scene;
mod shade;
mod shape;
mod trace;
mod vector;
mod view;
