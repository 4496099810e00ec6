//! The text of a scene file exactly as it is written; it owns the names of the keys and never
//! judges a value.

use std::string::String;
use std::vec::Vec;

use serde::Deserialize;
use serde::de::DeserializeOwned;

/// One scene as it is written.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct Scene {
    pub name: Option<String>,
    pub camera: Camera,
    #[serde(default)]
    pub materials: Vec<Material>,
    #[serde(default)]
    pub lights: Vec<Light>,
    #[serde(default)]
    pub spheres: Vec<Sphere>,
    #[serde(default)]
    pub planes: Vec<Plane>,
    #[serde(default)]
    pub cylinders: Vec<Cylinder>,
    #[serde(default)]
    pub background: [f64; 3],
    pub epsilon: Option<f64>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct Camera {
    pub position: [f64; 3],
    pub target: [f64; 3],
    pub up: [f64; 3],
    pub fov: f64,
}

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

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct Light {
    pub position: [f64; 3],
    pub color: [f64; 3],
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct Sphere {
    pub center: [f64; 3],
    pub radius: f64,
    pub material: String,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct Plane {
    pub center: [f64; 3],
    pub normal: [f64; 3],
    pub material: String,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct Cylinder {
    pub center: [f64; 3],
    pub axis: [f64; 3],
    pub radius: f64,
    pub height: f64,
    pub material: String,
}

/// Reads one scene or an array of scenes.
///
/// The first character decides which of the two is read, so that a mistake deep inside is
/// reported where it stands.
pub(super) fn read(text: &str) -> serde_json::Result<Vec<Scene>> {
    // Some editors put a byte-order mark in front.
    let text = text.strip_prefix('\u{feff}').unwrap_or(text);
    match text.trim_start().starts_with('[') {
        true => read_as(text),
        false => read_as(text).map(|scene| vec![scene]),
    }
}

fn read_as<T: DeserializeOwned>(text: &str) -> serde_json::Result<T> {
    serde_json::from_str(text)
}
