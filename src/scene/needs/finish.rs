//! The needs that follow from the materials and the lights of a scene.

use super::{Needs, Parts};
use crate::light::PreparedLight;
use crate::number::{Exponent, Unit};
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

impl Shininess {
    pub(super) const fn less(self, other: Self) -> Self {
        if (self as u8) < other as u8 { self } else { other }
    }
}

impl Mirrors {
    pub(super) const fn common(self, other: Self) -> Self {
        match (self, other) {
            (Self::Some, mirrors) | (mirrors, Self::Some) => mirrors,
            (Self::All, Self::All) => Self::All,
            _ => Self::None,
        }
    }
}

impl Parts<'_> {
    /// Returns the needs of a scene with these parts.
    pub(crate) const fn needs(&self) -> Needs {
        let [below, horizon, above] = self.background.colors();
        let mut needs = Needs {
            near_lights: false,
            far_lights: false,
            ranges: false,
            highlights: false,
            shininess: Shininess::None,
            checkers: false,
            sky: self.has_sky(),
            colors: !(below.is_grey() && horizon.is_grey() && above.is_grey()),
            ..Needs::of_room(&self.counts())
        };
        let mut index = 0;
        while index < self.lights.len() {
            needs.add_light(&self.lights[index]);
            index += 1;
        }
        let mut mirrors = [false; 2];
        index = 0;
        while let Some((_, material)) = self.ball(index) {
            needs.add_material(self, material, &mut mirrors);
            index += 1;
        }
        let mut mirroring = 0;
        index = 0;
        while index < self.planes.len() {
            let material = self.planes[index].material;
            needs.add_material(self, material, &mut mirrors);
            mirroring += self.mirrors(material) as usize;
            index += 1;
        }
        (needs.plane_mirrors, needs.facing_mirrors) = (mirroring > 0, mirroring > 1);
        needs.of_mirrors(mirrors)
    }
}

impl Needs {
    const fn add_light(&mut self, light: &PreparedLight) {
        let is_near = light.place.is_near();
        self.near_lights |= self.lights && is_near;
        self.far_lights |= self.lights && !is_near;
        self.ranges |= self.lights && light.is_ranged();
        self.colors |= !light.color.is_grey() && (self.lights || light.disc().is_some());
    }

    /// Includes the material of a shape. Notes whether a surface mirrors some light, and whether a surface has a
    /// colour of its own (α below 1).
    const fn add_material(&mut self, parts: &Parts<'_>, id: MaterialId, mirrors: &mut [bool; 2]) {
        if id.index() >= parts.materials.len() || id.index() >= parts.checkers.len() {
            return;
        }
        let material = &parts.materials[id.index()];
        let checker = &parts.checkers[id.index()];
        let is_seen = material.mirror.to_bits() < Unit::ONE.to_bits();
        mirrors[0] |= material.mirrors();
        mirrors[1] |= is_seen;
        if !is_seen {
            return;
        }
        self.colors |= !(material.color.is_grey() && checker.color.is_grey());
        self.checkers |= checker.has_cells();
        if self.lights && material.specular.to_bits() > 0 {
            self.highlights = true;
            let shininess = shininess(material.shininess);
            if shininess as u8 > self.shininess as u8 {
                self.shininess = shininess;
            }
        }
    }

    /// Returns these needs, lowered to the mirrors that [`Needs::add_material`] noted.
    const fn of_mirrors(self, mirrors: [bool; 2]) -> Self {
        let mirrors = match mirrors {
            [false, _] => return self.without_mirrors(),
            [true, true] => Mirrors::Some,
            [true, false] => Mirrors::All,
        };
        Self {
            mirrors,
            // A single plane shows only the background. A sky depends on the ray, a colour does not.
            mirrored: self.mirrored && (self.reflections > 1 || self.sky),
            ..self
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
