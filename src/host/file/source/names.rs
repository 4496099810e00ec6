//! Makes Rust identifiers from names, which may be any text.

use alloc::borrow::ToOwned;
use alloc::string::String;
use alloc::vec::Vec;

/// Names that the source imports or defines: a scene's type must have another one.
const TAKEN: &str = "CAMERA Camera Material Self";

/// Returns the name of a scene's type: `shading_lights` becomes `ShadingLights`.
pub(super) fn type_name(name: &str) -> String {
    let capitalised = |word: &str| {
        let (first, rest) = word.split_at(1);
        first.to_ascii_uppercase() + rest
    };
    let name: String = words(name).iter().map(|word| capitalised(word)).collect();
    match name.chars().next() {
        Some(first) if first.is_ascii_digit() => format!("Scene{name}"),
        Some(_) if TAKEN.split(' ').all(|taken| taken != name) => name,
        Some(_) => format!("{name}Scene"),
        None => "TheScene".to_owned(),
    }
}

/// Returns the names of the materials' constants: `old gold` becomes `OLD_GOLD`. All names are
/// different, and differ from the scene's type and its camera.
pub(super) fn constants(names: &[String], type_name: &str) -> Vec<String> {
    let mut constants: Vec<String> = Vec::new();
    for name in names.iter().map(|name| constant(name)) {
        let numbered = (2..).map(|number| format!("{name}_{number}"));
        let mut candidates = core::iter::once(name.clone()).chain(numbered);
        let is_free =
            |name: &String| name != "CAMERA" && name != type_name && !constants.contains(name);
        let free = candidates.find(is_free);
        constants.push(free.expect("numbers do not end"));
    }
    constants
}

fn constant(name: &str) -> String {
    let name = words(name).join("_").to_ascii_uppercase();
    match name.chars().next() {
        Some(first) if !first.is_ascii_digit() => name,
        Some(_) => format!("MATERIAL_{name}"),
        None => "MATERIAL".to_owned(),
    }
}

/// Splits a name into its runs of ASCII letters and digits, which an identifier may contain.
fn words(name: &str) -> Vec<&str> {
    let words = name.split(|letter: char| !letter.is_ascii_alphanumeric());
    words.filter(|word| !word.is_empty()).collect()
}
