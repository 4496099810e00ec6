//! Words for what the JSON parser refuses: names the part and the fix. This file never reads a scene
//! file.

use alloc::borrow::ToOwned;
use alloc::string::String;

/// Returns what is wrong at `place`, such as `spheres[3].radius`, from a message of the parser without
/// its position. `place` is empty if the scene itself is meant.
pub(super) fn words(place: &str, message: &str) -> String {
    wrong_value(place, message)
        .or_else(|| wrong_key(place, message))
        .unwrap_or_else(|| {
            let message = syntax(message);
            match place {
                "" => message,
                _ => format!("{place}: {message}"),
            }
        })
}

/// Returns the words for a value of the wrong type or length.
fn wrong_value(place: &str, message: &str) -> Option<String> {
    let is_inside = !place.is_empty();
    let place = if is_inside { place } else { "a scene" };
    if message == "trailing characters" && is_inside {
        let items = if is_of_lists(place) { "lists" } else { "numbers" };
        return Some(format!("{place} has more than 3 {items}: remove the rest"));
    }
    if let Some(rest) = message.strip_prefix("invalid length ") {
        let (length, expected) = rest.split_once(", expected ")?;
        let wanted = wanted(place, expected);
        return Some(format!("{place} must be {wanted}, not {length}"));
    }
    let rest = message.strip_prefix("invalid type: ")?;
    let (found, expected) = rest.split_once(", expected ")?;
    let (wanted, given) = (wanted(place, expected), given(found));
    Some(format!("{place} must be {wanted}, not {given}"))
}

/// Returns the words for a key that is missing, unknown or given twice.
fn wrong_key(place: &str, message: &str) -> Option<String> {
    let place = if place.is_empty() { "the scene" } else { place };
    let quoted = |text: &str| text.strip_suffix('`').map(str::to_owned);
    if let Some(key) = message.strip_prefix("missing field `") {
        return Some(format!("{place} has no {}: add it", quoted(key)?));
    }
    if let Some(key) = message.strip_prefix("duplicate field `") {
        return Some(format!("{place} has {} twice: remove one", quoted(key)?));
    }
    let rest = message.strip_prefix("unknown field `")?;
    let (key, expected) = rest.split_once("`, expected ")?;
    let keys = expected.trim_start_matches("one of ").replace('`', "");
    let keys = keys.replace(" or ", ", ");
    // The place is that of the key.
    let place = match place.strip_suffix(key).map(|it| it.trim_end_matches('.')) {
        Some("") => "the scene",
        Some(owner) => owner,
        None => place,
    };
    Some(format!("{place} cannot have the key {key}, only {keys}"))
}

/// Returns the words for a type that the parser expects.
fn wanted(place: &str, expected: &str) -> String {
    match expected {
        "f64" => "a number",
        "a string" => "a text",
        "a sequence" => "a list, in [ ]",
        "an array of length 3" if is_of_lists(place) => "3 lists of 3 numbers, one for each corner",
        "an array of length 3" => "a list of 3 numbers",
        _ if expected.starts_with("struct ") => "an object, in { }",
        _ => expected,
    }
    .to_owned()
}

/// Tests whether the value at a place is a list of lists: one for each corner of a triangle.
fn is_of_lists(place: &str) -> bool {
    place.ends_with(".corners") || place.ends_with(".normals")
}

/// Returns the words for a value that the parser found.
fn given(found: &str) -> String {
    let number = found
        .strip_prefix("integer ")
        .or_else(|| found.strip_prefix("floating point "));
    if let Some(number) = number {
        return format!("the number {}", number.replace('`', ""));
    }
    if let Some(text) = found.strip_prefix("string ") {
        return format!("the text {text}");
    }
    match found {
        "map" => "an object",
        "sequence" => "a list",
        _ => return found.trim_start_matches("boolean ").replace('`', ""),
    }
    .to_owned()
}

/// Returns the words for a text that is not JSON.
fn syntax(message: &str) -> String {
    if message.starts_with("EOF while parsing") {
        return "the file ends too early: a bracket or a quote is not closed".to_owned();
    }
    match message {
        "expected value" => "a value is missing here, or is not JSON",
        "key must be a string" => "a key must be a text in double quotes; JSON has no comments",
        "expected `:`" => "a colon is missing after the key",
        "expected `,` or `}`" => "a comma or a closing } is missing before this",
        "expected `,` or `]`" => "a comma or a closing ] is missing before this",
        "trailing comma" => "the comma after the last value must go",
        "trailing characters" => "the file must end after the scene",
        "number out of range" => "the number is too large",
        "invalid number" => "this is not a number of JSON, such as 0.5 or -1e-3",
        _ => message,
    }
    .to_owned()
}
