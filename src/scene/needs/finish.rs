//! The needs that follow from the materials and the lights of a scene.

use super::Shininess;
use crate::color::Color;
use crate::light::PreparedLight;
use crate::material::PreparedMaterial;
use crate::number::{Brightness, Exponent, Unit};
use crate::shape::MaterialId;

/// The properties of a scene's lights and used materials that its needs depend on.
pub(super) struct Finish {
    pub(super) shininess: Shininess,
    /// Whether a surface mirrors some light, and whether a surface has a colour of its own (α below 1).
    pub(super) mirrors: [bool; 2],
    pub(super) is_grey: bool,
    /// Whether the colours of all lights are grey.
    pub(super) is_lit_grey: bool,
    /// Whether a light is far away.
    pub(super) is_far: bool,
}

impl Finish {
    pub(super) const fn new(background: Color, lights: &[PreparedLight]) -> Self {
        let mut finish = Self {
            shininess: Shininess::None,
            mirrors: [false; 2],
            is_grey: is_grey(background),
            is_lit_grey: true,
            is_far: false,
        };
        let mut index = 0;
        while index < lights.len() {
            finish.is_lit_grey &= is_grey(lights[index].color);
            finish.is_far |= !lights[index].place.is_near();
            index += 1;
        }
        finish
    }

    /// Includes the material of a shape.
    pub(super) const fn add(&mut self, materials: &[PreparedMaterial], id: MaterialId) {
        if id.index() >= materials.len() {
            return;
        }
        let material = &materials[id.index()];
        self.mirrors[0] |= material.mirror.to_bits() > 0;
        let is_seen = material.mirror.to_bits() < Unit::ONE.to_bits();
        self.mirrors[1] |= is_seen;
        if !is_seen {
            return;
        }
        self.is_grey &= is_grey(material.color);
        if material.specular.to_bits() > Brightness::ZERO.to_bits() {
            let shininess = shininess(material.shininess);
            if shininess as u8 > self.shininess as u8 {
                self.shininess = shininess;
            }
        }
    }
}

const fn shininess(exponent: Exponent) -> Shininess {
    if exponent.is_even() {
        Shininess::Even
    } else if exponent.is_whole() {
        Shininess::Whole
    } else {
        Shininess::Real
    }
}

const fn is_grey(color: Color) -> bool {
    let [red, green, blue] = color.components();
    red.to_bits() == green.to_bits() && green.to_bits() == blue.to_bits()
}
