//! The JSON structure of a scene file: owns the names of the keys. It accepts any value of the right
//! type and never checks ranges.

use alloc::string::{String, ToString};
use alloc::vec::Vec;

use core::fmt;

use serde::de::value::SeqAccessDeserializer;
use serde::de::{DeserializeOwned, Error, SeqAccess, Visitor};
use serde::{Deserialize, Deserializer};

use super::error::FileError;
use crate::host::reference::{Camera, Checker, Corners, Light, Normals, Number, Position, Sky};

macro_rules! document {
    ($parameters:tt $({
        $list:ident $kind:ident $described:ident $add:ident $fields:tt $room:ident $too_many:ident { $($key:tt)* }
    })*) => {
        /// One scene as it is written in the file: materials are named, and nothing is checked yet.
        #[derive(Deserialize)]
        #[serde(deny_unknown_fields)]
        pub(super) struct Scene {
            /// Address of the schema, for editors. Nothing reads it.
            #[serde(rename = "$schema")]
            pub _schema: Option<String>,
            pub name: Option<String>,
            pub camera: Camera,
            #[serde(default)]
            pub materials: Vec<Material>,
            #[serde(default)]
            pub lights: Vec<Light>,
            #[serde(default)]
            pub suns: Vec<Sun>,
            $(
                #[serde(default)]
                pub $list: Vec<$described>,
            )*
            pub background: Option<[f64; 3]>,
            pub sky: Option<Sky>,
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

/// A sun: the direction points towards it, the disc is an angle in degrees.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct Sun {
    pub direction: [f64; 3],
    pub color: [f64; 3],
    pub disc: Option<f64>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct Material {
    pub name: String,
    pub color: [f64; 3],
    pub ambient: Option<f64>,
    pub diffuse: Option<f64>,
    pub specular: Option<f64>,
    pub shininess: Option<f64>,
    pub mirror: Option<f64>,
    pub checker: Option<Checker>,
}

/// Reads the size of a cell: one number along all axes, or one along each.
pub(in crate::host) fn size<'de, D: Deserializer<'de>>(source: D) -> Result<[f64; 3], D::Error> {
    struct Numbers;

    impl<'de> Visitor<'de> for Numbers {
        type Value = [f64; 3];

        fn expecting(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
            formatter.write_str("a number, or three numbers in [ ]")
        }

        fn visit_f64<E: Error>(self, size: f64) -> Result<[f64; 3], E> {
            Ok([size; 3])
        }

        fn visit_u64<E: Error>(self, size: u64) -> Result<[f64; 3], E> {
            self.visit_f64(size as f64)
        }

        fn visit_i64<E: Error>(self, size: i64) -> Result<[f64; 3], E> {
            self.visit_f64(size as f64)
        }

        fn visit_seq<A: SeqAccess<'de>>(self, sizes: A) -> Result<[f64; 3], A::Error> {
            Deserialize::deserialize(SeqAccessDeserializer::new(sizes))
        }
    }

    source.deserialize_any(Numbers)
}

/// Reads one scene or an array of scenes from JSON text.
///
/// The first character decides which of the two is read. So the error for a mistake deep inside names
/// its own line and column.
#[inline]
pub(super) fn read(text: &str) -> Result<Vec<Scene>, FileError> {
    // Some editors put a byte-order mark at the start of a file.
    let text = text.strip_prefix('\u{feff}').unwrap_or(text);
    if text.trim_start().starts_with('[') {
        read_as(text)
    } else {
        read_as(text).map(|scene| vec![scene])
    }
}

fn read_as<T: DeserializeOwned>(text: &str) -> Result<T, FileError> {
    let mut parser = serde_json::Deserializer::from_str(text);
    let read = serde_path_to_error::deserialize(&mut parser)
        .map_err(|error| FileError::json(&error.path().to_string(), error.inner()))?;
    parser.end().map_err(|error| FileError::json("", &error))?;
    Ok(read)
}
