//! Answers to the page: whether a call did its work, and a text, mostly JSON.

use serde::Serialize;

#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Answer {
    /// Whether the call was refused. The text then has the reason.
    pub is_refused: bool,
    /// JSON, or Rust source.
    pub text: String,
}

/// Why a call was refused, and where in the text of the scene, counted from 1.
#[derive(Serialize)]
pub(crate) struct Refusal {
    pub(crate) error: String,
    pub(crate) line: Option<usize>,
    pub(crate) column: Option<usize>,
}

impl Refusal {
    /// `place` is line and column.
    pub(crate) fn new(reason: impl ToString, place: Option<(usize, usize)>) -> Self {
        let (line, column) = place.unzip();
        Self {
            error: reason.to_string(),
            line,
            column,
        }
    }
}

impl Answer {
    /// The work is done, and there is nothing to say.
    pub(crate) fn nothing() -> Self {
        Self::default()
    }

    pub(crate) fn done(answer: &impl Serialize) -> Self {
        Self::text(json(answer))
    }

    pub(crate) fn text(text: String) -> Self {
        Self {
            is_refused: false,
            text,
        }
    }

    pub(crate) fn refused(refusal: &Refusal) -> Self {
        Self {
            is_refused: true,
            text: json(refusal),
        }
    }

    pub(crate) fn error(reason: impl ToString) -> Self {
        Self::refused(&Refusal::new(reason, None))
    }

    pub(crate) fn no_scene() -> Self {
        Self::error("no scene is open: open one first")
    }

    pub(crate) fn no_frame() -> Self {
        Self::error("there is no frame: prepare one first")
    }
}

fn json(value: &impl Serialize) -> String {
    serde_json::to_string(value).expect("no map, and no number that JSON lacks")
}
