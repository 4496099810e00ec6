//! The functions that a browser calls. Texts are UTF-8 and go through two buffers of this module: the
//! page writes its text to [`text_room`], and reads the answer at [`answer_ptr`].
//!
//! A function that returns 0 has done its work; 1 means that the answer says why it is refused.

use std::cell::RefCell;

use crate::{Answer, Playground, Settings};

#[derive(Default)]
struct State {
    playground: Playground,
    input: Vec<u8>,
    answer: String,
}

thread_local! {
    static STATE: RefCell<State> = RefCell::default();
}

/// Runs a request, stores the text of its answer, and returns 1 if it is refused, else 0.
fn answer(ask: impl FnOnce(&mut Playground) -> Answer) -> u32 {
    STATE.with_borrow_mut(|state| {
        let answer = ask(&mut state.playground);
        let is_refused = answer.is_err();
        state.answer = answer.unwrap_or_else(|refusal| refusal);
        is_refused.into()
    })
}

/// Returns room for an input text of `len` bytes.
#[unsafe(no_mangle)]
pub extern "C" fn text_room(len: u32) -> *mut u8 {
    STATE.with_borrow_mut(|state| {
        state.input = vec![0; len as usize];
        state.input.as_mut_ptr()
    })
}

/// Returns where the answer of the last call begins.
#[unsafe(no_mangle)]
pub extern "C" fn answer_ptr() -> *const u8 {
    STATE.with_borrow(|state| state.answer.as_ptr())
}

/// Returns the number of bytes of the answer of the last call.
#[unsafe(no_mangle)]
pub extern "C" fn answer_len() -> u32 {
    STATE.with_borrow(|state| state.answer.len() as u32)
}

/// Reads the scene at `index` of the file in the first `len` bytes of the input text.
#[unsafe(no_mangle)]
pub extern "C" fn open(len: u32, index: i32) -> u32 {
    let input = STATE.with_borrow_mut(|state| std::mem::take(&mut state.input));
    let text = String::from_utf8_lossy(&input[..input.len().min(len as usize)]);
    answer(|playground| playground.open(&text, index))
}

/// Sets the view; see [`Playground::set_view`].
#[unsafe(no_mangle)]
pub extern "C" fn set_view(turn: i32, rise: i32, zoom: u32) -> u32 {
    answer(|playground| playground.set_view(turn, rise, zoom))
}

#[unsafe(no_mangle)]
pub extern "C" fn camera() -> u32 {
    answer(|playground| playground.camera())
}

/// Prepares a frame; see [`Settings`].
#[unsafe(no_mangle)]
pub extern "C" fn frame(
    width: u32,
    height: u32,
    reflections: u32,
    quality: u32,
    shading: u32,
    smooth: u32,
    display: u32,
) -> u32 {
    let settings = Settings {
        width,
        height,
        reflections,
        quality,
        shading,
        smooth,
        display,
    };
    answer(|playground| playground.frame(settings))
}

/// Draws row `y` and returns where its pixels begin: red, green, blue and 255 each.
#[unsafe(no_mangle)]
pub extern "C" fn row(y: u32) -> *const u8 {
    STATE.with_borrow_mut(|state| state.playground.row(y).as_ptr())
}

/// Answers with what the rows have told.
#[unsafe(no_mangle)]
pub extern "C" fn finish() -> u32 {
    answer(|playground| playground.finish())
}

/// Answers with the path of pixel (`x`, `y`) of the frame.
#[unsafe(no_mangle)]
pub extern "C" fn path(x: u32, y: u32) -> u32 {
    answer(|playground| playground.path(x, y))
}

/// Answers with the error of a picture with so many reflections.
#[unsafe(no_mangle)]
pub extern "C" fn error_at(width: u32, height: u32, reflections: u32) -> u32 {
    answer(|playground| playground.error_at(width, height, reflections))
}

/// Answers with the runs of row `y` of the frame.
#[unsafe(no_mangle)]
pub extern "C" fn row_paths(y: u32) -> u32 {
    answer(|playground| playground.row_paths(y))
}

#[unsafe(no_mangle)]
pub extern "C" fn rust() -> u32 {
    answer(|playground| playground.rust())
}
