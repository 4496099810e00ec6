//! Tests that whatever is wrong with a scene or a camera is named: by an error while the program
//! runs, by the compiler where the scene is a constant.

mod compiled;
mod filled;
