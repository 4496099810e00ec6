//! The needs that follow from the materials and the lights of a scene.

use super::Parts;
use crate::background::PreparedBackground;
use crate::light::PreparedLight;
use crate::number::{Brightness, Exponent, Unit};
use crate::shape::MaterialId;

/// The powers that the highlights of a scene take. Each variant includes those before it.
///
/// ```
/// use reflet::needs::{Needs, Shininess};
///
/// const WHOLE: Needs = Needs::ALL.with_shininess(Shininess::Whole);
/// assert!(WHOLE.highlights && Shininess::Even < WHOLE.shininess && WHOLE.shininess < Shininess::Real);
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Shininess {
    /// No power: the scene has no highlight.
    None,
    /// Even whole numbers: Blinn-Phong shading takes no root.
    Even,
    /// Whole numbers: no logarithm is computed.
    Whole,
    /// Highlights take any real power.
    Real,
}

/// The surfaces of a scene that mirror: none, some or all.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Mirrors {
    /// No surface mirrors: every path ends at the first surface.
    None,
    /// Some surfaces mirror, or surfaces mirror a part of the light.
    Some,
    /// Every surface mirrors all light (α = 1): no surface has a colour of its own.
    All,
}

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
    /// Whether a light falls off with distance.
    pub(super) has_ranges: bool,
    pub(super) has_sky: bool,
    pub(super) has_checkers: bool,
}

impl Finish {
    pub(super) const fn new(background: &PreparedBackground, lights: &[PreparedLight]) -> Self {
        let [below, horizon, above] = background.colors();
        let mut finish = Self {
            shininess: Shininess::None,
            mirrors: [false; 2],
            is_grey: below.is_grey() && horizon.is_grey() && above.is_grey(),
            is_lit_grey: true,
            is_far: false,
            has_ranges: false,
            has_sky: background.is_sky(),
            has_checkers: false,
        };
        let mut index = 0;
        while index < lights.len() {
            finish.is_lit_grey &= lights[index].color.is_grey();
            finish.is_far |= !lights[index].place.is_near();
            finish.has_ranges |= lights[index].is_ranged();
            if lights[index].disc().is_some() {
                finish.has_sky = true;
                finish.is_grey &= lights[index].color.is_grey();
            }
            index += 1;
        }
        finish
    }

    /// Includes the material of a shape.
    pub(super) const fn add(&mut self, parts: &Parts<'_>, id: MaterialId) {
        if id.index() >= parts.materials.len() || id.index() >= parts.checkers.len() {
            return;
        }
        let material = &parts.materials[id.index()];
        let checker = &parts.checkers[id.index()];
        self.mirrors[0] |= material.mirror.to_bits() > 0;
        let is_seen = material.mirror.to_bits() < Unit::ONE.to_bits();
        self.mirrors[1] |= is_seen;
        if !is_seen {
            return;
        }
        self.is_grey &= material.color.is_grey() && checker.color.is_grey();
        self.has_checkers |= checker.has_cells();
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
