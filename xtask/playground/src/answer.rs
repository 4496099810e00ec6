//! Answers to the page: a text, mostly JSON, or why the call is refused.

use serde::Serialize;

/// The text of the answer to a call: JSON or Rust source, and nothing if there is nothing to say. Of a
/// call that is refused, it is a [`Refusal`] in JSON.
pub type Answer = Result<String, String>;

/// Why a call was refused, and where in the text of the scene, counted from 1.
#[derive(Serialize)]
struct Refusal {
    error: String,
    line: Option<usize>,
    column: Option<usize>,
}

/// Refuses a call. `place` is line and column.
pub(crate) fn refused(reason: impl ToString, place: Option<(usize, usize)>) -> String {
    let (line, column) = place.unzip();
    let error = reason.to_string();
    json(&Refusal {
        error,
        line,
        column,
    })
}

/// Refuses a call for a reason that is not in the text of the scene.
pub(crate) fn error(reason: impl ToString) -> String {
    refused(reason, None)
}

pub(crate) fn json(value: &impl Serialize) -> String {
    serde_json::to_string(value).expect("no map, and no number that JSON lacks")
}
