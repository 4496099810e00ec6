//! What a scene needs of the kernels, derived from the scene: what is not needed is not linked.

mod bound;
mod words;

pub use bound::{Bound, Excess, MostReflections};
pub use words::Need;

use super::Scene;
use crate::color::Color;
use crate::material::PreparedMaterial;
use crate::number::{Brightness, Exponent, Unit};
use crate::shape::MaterialId;

/// What a scene, or any scene of a type, can need of the library.
///
/// For a [`crate::StaticScene`] it is derived from the scene itself when the program is compiled
/// ([`Needs::of`]); for a scene filled at run time from the room in its type, or from a [`Bound`].
/// The code and the tables for what is not needed are not in the program.
///
/// ```
/// use reflet::{Material, Mirrors, Needs, Scene, StaticScene};
///
/// struct Marble;
/// impl StaticScene for Marble {
///     type Scene = Scene<1, 0, 0, 1>;
///     const SCENE: &'static Self::Scene = &Scene::builder()
///         .sphere([0.0, 0.0, 1.0], 1.0, Material::new([0.9, 0.1, 0.1]))
///         .light([3.0, -4.0, 6.0], [1.0, 1.0, 1.0])
///         .build();
/// }
/// const NEEDS: Needs = Needs::of::<Marble>();
/// assert!(NEEDS.spheres && !NEEDS.planes && NEEDS.mirrors == Mirrors::None);
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub struct Needs {
    /// Whether there are spheres.
    pub spheres: bool,
    /// Whether there are planes.
    pub planes: bool,
    /// Whether there are cylinders.
    pub cylinders: bool,
    /// Whether there are lights, and anything to be lit.
    pub lights: bool,
    /// Whether a shape may throw a shadow, on another or on itself.
    pub shadows: bool,
    /// Whether a light may be seen as a highlight.
    pub highlights: bool,
    /// Which powers the highlights take.
    pub shininess: Shininess,
    /// Which surfaces mirror.
    pub mirrors: Mirrors,
    /// The last reflection that can add light: none without a mirror, one where a single plane is all
    /// there is, else as many as a frame allows.
    pub reflections: u8,
    /// Whether a mirror can show more than the background.
    pub mirrored: bool,
    /// Whether it matters where a ray meets a shape, and not only whether it does.
    pub places: bool,
    /// Whether it takes less time to choose among the shapes that may throw a shadow than to ask all.
    pub sets: bool,
    /// Whether there is more than one material.
    pub materials: bool,
    /// Whether anything is not grey.
    pub colors: bool,
}

/// Which powers the highlights of a scene take, each kind with those before it.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Shininess {
    /// None: there is no highlight.
    None,
    /// Even whole numbers: with Blinn-Phong no root is taken.
    Even,
    /// Whole numbers: no logarithm is needed.
    Whole,
    /// Any.
    Real,
}

/// Which surfaces of a scene mirror.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Mirrors {
    /// None: a path ends at the first surface.
    None,
    /// Some, or some of the light.
    Some,
    /// All, and all of the light: no surface has a colour of its own.
    All,
}

/// As many spheres and cylinders as are asked in less time than it takes to choose among them.
pub(crate) const FEW: usize = 3;

impl Needs {
    /// Everything.
    pub const ALL: Self = Self {
        spheres: true,
        planes: true,
        cylinders: true,
        lights: true,
        shadows: true,
        highlights: true,
        shininess: Shininess::Real,
        mirrors: Mirrors::Some,
        reflections: u8::MAX,
        mirrored: true,
        places: true,
        sets: true,
        materials: true,
        colors: true,
    };

    /// Of any scene with no more spheres, planes, cylinders, lights and materials than this.
    pub(crate) const fn of_room(
        [spheres, planes, cylinders, lights, materials]: [usize; 5],
    ) -> Self {
        let bounded = spheres + cylinders;
        let is_lit = lights > 0 && bounded + planes > 0;
        Self {
            spheres: spheres > 0,
            planes: planes > 0,
            cylinders: cylinders > 0,
            lights: is_lit,
            // No ray crosses a plane, so one by itself hides nothing that could be seen lit.
            shadows: is_lit && (bounded > 0 || planes > 1),
            highlights: is_lit,
            shininess: match is_lit {
                true => Shininess::Real,
                false => Shininess::None,
            },
            mirrors: match bounded + planes {
                0 => Mirrors::None,
                _ => Mirrors::Some,
            },
            reflections: match (bounded, planes) {
                (0, 0) => 0,
                (0, 1) => 1,
                _ => u8::MAX,
            },
            mirrored: bounded > 0 || planes > 1,
            places: is_lit || bounded > 0 || planes > 1,
            sets: is_lit && bounded > FEW,
            materials: materials > 1,
            colors: true,
        }
    }

    /// What both need.
    #[must_use]
    pub const fn both(&self, other: &Self) -> Self {
        Self {
            spheres: self.spheres && other.spheres,
            planes: self.planes && other.planes,
            cylinders: self.cylinders && other.cylinders,
            lights: self.lights && other.lights,
            shadows: self.shadows && other.shadows,
            highlights: self.highlights && other.highlights,
            shininess: match (self.shininess as u8) < other.shininess as u8 {
                true => self.shininess,
                false => other.shininess,
            },
            mirrors: match (self.mirrors, other.mirrors) {
                (Mirrors::Some, mirrors) | (mirrors, Mirrors::Some) => mirrors,
                (Mirrors::All, Mirrors::All) => Mirrors::All,
                _ => Mirrors::None,
            },
            reflections: match self.reflections < other.reflections {
                true => self.reflections,
                false => other.reflections,
            },
            mirrored: self.mirrored
                && other.mirrored
                && self.reflections > 0
                && other.reflections > 0,
            places: self.places && other.places,
            sets: self.sets && other.sets,
            materials: self.materials && other.materials,
            colors: self.colors && other.colors,
        }
    }

    /// Whether there is no shape.
    pub const fn is_nothing(&self) -> bool {
        !(self.spheres || self.planes || self.cylinders)
    }
}

/// What the materials that shapes are made of come to.
struct Finish {
    shininess: Shininess,
    /// Whether there is a surface that mirrors something, and one that does not mirror all.
    mirrors: [bool; 2],
    is_grey: bool,
}

impl Finish {
    const fn add(&mut self, material: &PreparedMaterial) {
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

impl<const S: usize, const P: usize, const C: usize, const L: usize, const M: usize>
    Scene<S, P, C, L, M>
{
    /// What this scene needs.
    pub const fn needs(&self) -> Needs {
        let counts = &self.counts;
        let room = Needs::of_room([
            counts.spheres,
            counts.planes,
            counts.cylinders,
            counts.lights,
            counts.materials,
        ]);
        let mut finish = Finish {
            shininess: Shininess::None,
            mirrors: [false; 2],
            is_grey: is_grey(self.background),
        };
        let mut index = 0;
        while index < counts.spheres && index < S {
            self.add_finish(&mut finish, self.spheres[index].material);
            index += 1;
        }
        index = 0;
        while index < counts.planes && index < P {
            self.add_finish(&mut finish, self.planes[index].material);
            index += 1;
        }
        index = 0;
        while index < counts.cylinders && index < C {
            self.add_finish(&mut finish, self.cylinders[index].material);
            index += 1;
        }
        index = 0;
        while room.lights && index < counts.lights && index < L {
            finish.is_grey &= is_grey(self.lights[index].color);
            index += 1;
        }
        let mirrors = match finish.mirrors {
            [false, _] => Mirrors::None,
            [true, true] => Mirrors::Some,
            [true, false] => Mirrors::All,
        };
        let shininess = match room.lights {
            true => finish.shininess,
            false => Shininess::None,
        };
        Needs {
            highlights: !matches!(shininess, Shininess::None),
            shininess,
            mirrors,
            reflections: match mirrors {
                Mirrors::None => 0,
                _ => room.reflections,
            },
            mirrored: room.mirrored && !matches!(mirrors, Mirrors::None),
            colors: !finish.is_grey,
            ..room
        }
    }

    const fn add_finish(&self, finish: &mut Finish, material: MaterialId) {
        if material.index() < M {
            finish.add(&self.materials[material.index()]);
        }
    }
}

#[cfg(test)]
mod tests;
