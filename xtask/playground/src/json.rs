//! Writes JSON. What reads it is linked for scene files; what writes it with serde has tables of numbers of its own,
//! which would be a twentieth of the page.

use std::fmt::Write;

/// A value that can be written as JSON.
pub(crate) trait Json {
    /// Adds the value to a text.
    fn write(&self, text: &mut String);
}

/// Implements [`Json`] for a struct: an object with the fields as keys.
macro_rules! object {
    ($name:ident { $($field:ident),* $(,)? }) => {
        impl $crate::json::Json for $name {
            fn write(&self, text: &mut String) {
                $crate::json::members(text, &[$((stringify!($field), &self.$field)),*]);
            }
        }
    };
}
pub(crate) use object;

/// Implements [`Json`] for whole numbers and truth values, which print as JSON.
macro_rules! printed {
    ($($name:ty),*) => {
        $(
            impl Json for $name {
                fn write(&self, text: &mut String) {
                    *text += &self.to_string();
                }
            }
        )*
    };
}
printed!(bool, u8, u32, u64, usize);

/// The shortest digits that are read as the same number; `null` if it is infinite or no number.
impl Json for f64 {
    fn write(&self, text: &mut String) {
        match self.is_finite() {
            true => *text += &format!("{self:?}"),
            false => *text += "null",
        }
    }
}

impl Json for str {
    fn write(&self, text: &mut String) {
        text.push('"');
        for letter in self.chars() {
            match letter {
                '"' | '\\' => text.extend(['\\', letter]),
                _ if letter.is_control() => {
                    // Control characters have four digits at most.
                    let _ = write!(text, "\\u{:04x}", u32::from(letter));
                }
                _ => text.push(letter),
            }
        }
        text.push('"');
    }
}

impl Json for String {
    fn write(&self, text: &mut String) {
        self.as_str().write(text);
    }
}

impl Json for &str {
    fn write(&self, text: &mut String) {
        (**self).write(text);
    }
}

impl<T: Json> Json for Option<T> {
    fn write(&self, text: &mut String) {
        match self {
            Some(value) => value.write(text),
            None => *text += "null",
        }
    }
}

impl<T: Json> Json for [T] {
    fn write(&self, text: &mut String) {
        text.push('[');
        for (index, value) in self.iter().enumerate() {
            *text += if index > 0 { "," } else { "" };
            value.write(text);
        }
        text.push(']');
    }
}

impl<T: Json, const N: usize> Json for [T; N] {
    fn write(&self, text: &mut String) {
        self.as_slice().write(text);
    }
}

impl<T: Json> Json for Vec<T> {
    fn write(&self, text: &mut String) {
        self.as_slice().write(text);
    }
}

/// Writes an object. Keys need no escapes.
pub(crate) fn members(text: &mut String, members: &[(&str, &dyn Json)]) {
    for (index, (key, value)) in members.iter().enumerate() {
        *text += if index > 0 { ",\"" } else { "{\"" };
        *text += key;
        *text += "\":";
        value.write(text);
    }
    text.push('}');
}

#[cfg(test)]
mod tests {
    use super::*;

    struct Thing {
        name: &'static str,
        places: Vec<[f64; 2]>,
        size: Option<u32>,
    }
    object!(Thing { name, places, size });

    #[test]
    fn what_is_written_is_read_as_the_same() {
        let name = "a \"b\" \\ \n\u{7f}\u{85} é";
        let thing = Thing {
            name,
            places: vec![[0.1, -1e-300], [1e300, f64::NAN]],
            size: None,
        };
        let mut text = String::new();
        thing.write(&mut text);
        let read: serde_json::Value = serde_json::from_str(&text).unwrap();
        let places = serde_json::json!([[0.1, -1e-300], [1e300, null]]);
        let whole = serde_json::json!({ "name": name, "places": places, "size": null });
        assert_eq!(read, whole);
    }
}
