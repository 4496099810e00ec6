//! The JSON structure of a scene file: owns the names of the keys. It accepts any value of the right
//! type and never checks ranges.

use std::string::String;
use std::vec::Vec;

use serde::Deserialize;
use serde::de::DeserializeOwned;

use crate::host::reference::{Camera, Light};

/// A position or a direction: x, y and z.
type Position = [f64; 3];

/// A size, such as a radius or a height.
type Number = f64;

macro_rules! document {
    ($parameters:tt $({
        $list:ident $kind:ident $described:ident $add:ident $fields:tt $room:ident $too_many:ident { $($key:tt)* }
    })*) => {
        /// One scene as it is written in the file: materials are named, and nothing is checked yet.
        #[derive(Deserialize)]
        #[serde(deny_unknown_fields)]
        pub(super) struct Scene {
            pub name: Option<String>,
            pub camera: Camera,
            #[serde(default)]
            pub materials: Vec<Material>,
            #[serde(default)]
            pub lights: Vec<Light>,
            $(
                #[serde(default)]
                pub $list: Vec<$described>,
            )*
            #[serde(default)]
            pub background: [f64; 3],
            pub epsilon: Option<f64>,
        }

        $(
            #[derive(Deserialize)]
            #[serde(deny_unknown_fields)]
            pub(super) struct $described {
                $($key)*
                pub material: String,
            }
        )*
    };
}
kinds!(shapes, document);

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct Material {
    pub name: String,
    pub color: [f64; 3],
    pub ambient: f64,
    pub diffuse: f64,
    pub specular: f64,
    pub shininess: f64,
    pub mirror: f64,
}

/// Reads one scene or an array of scenes from JSON text.
///
/// The first character decides which of the two is read. So the error for a mistake deep inside names
/// its own line and column.
pub(super) fn read(text: &str) -> serde_json::Result<Vec<Scene>> {
    // Some editors put a byte-order mark at the start of a file.
    let text = text.strip_prefix('\u{feff}').unwrap_or(text);
    match text.trim_start().starts_with('[') {
        true => read_as(text),
        false => read_as(text).map(|scene| vec![scene]),
    }
}

fn read_as<T: DeserializeOwned>(text: &str) -> serde_json::Result<T> {
    serde_json::from_str(text)
}
