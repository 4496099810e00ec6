//! Random scenes in families, most of which are hard to interpolate. The same seed makes the same scenes.

mod any;
mod draft;
mod facets;
mod flat;
mod light;
mod random;
mod shapes;

use clap::ValueEnum;

use self::draft::Draft;
use self::random::Random;
use crate::case::Case;

/// A family of random scenes.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum Family {
    /// Thin rods and tiny spheres in all directions, also along the view.
    Thin,
    /// Spheres, cylinders and discs that barely stick out of planes.
    Sunk,
    /// Shapes that touch, overlap and cut each other.
    Touching,
    /// 20 to 60 shapes.
    Crowds,
    /// Fields of view from 90 to 150 degrees.
    Wide,
    /// Flat and round mirrors, with 1 to 5 reflections.
    Mirrors,
    /// Cameras, planes and lights up to 100 000 units away.
    Far,
    /// Small highlights of several lights.
    Glossy,
    /// Rows of thin posts on a floor, under low lights.
    Fences,
    /// Meshes and needles of triangles, flat and smooth.
    Facets,
    /// Anything at any scale, in any shading.
    Any,
    /// The same under lights that fall off.
    Fading,
}

impl Family {
    /// Those that are hard to interpolate.
    pub const ALL: [Self; 10] = [
        Self::Thin,
        Self::Sunk,
        Self::Touching,
        Self::Crowds,
        Self::Wide,
        Self::Mirrors,
        Self::Far,
        Self::Glossy,
        Self::Fences,
        Self::Facets,
    ];

    /// Returns the family's name in tables and on the command line.
    pub fn name(self) -> String {
        format!("{self:?}").to_lowercase()
    }

    /// Makes the scene of this number. It depends on nothing but family, seed and number. The name
    /// says all three, and the number of reflections if it is not 4: `mirrors-1-7-r2`.
    pub fn case(self, seed: u64, number: u64) -> Case {
        let mut draft = Draft::new(Random::new(&[self as u64, seed, number]));
        match self {
            Self::Thin => shapes::thin(&mut draft),
            Self::Sunk => flat::sunk(&mut draft),
            Self::Touching => shapes::touching(&mut draft),
            Self::Crowds => shapes::crowds(&mut draft),
            Self::Wide => flat::wide(&mut draft),
            Self::Mirrors => flat::mirrors(&mut draft),
            Self::Far => flat::far(&mut draft),
            Self::Glossy => light::glossy(&mut draft),
            Self::Fences => light::fences(&mut draft),
            Self::Facets => facets::facets(&mut draft),
            Self::Any => any::any(&mut draft, false),
            Self::Fading => any::any(&mut draft, true),
        }
        let name = format!("{}-{seed}-{number}", self.name());
        let name = match draft.reflections {
            4 => name,
            other => format!("{name}-r{other}"),
        };
        draft.case(name)
    }
}

/// Returns scene `index` of a run over several families, which take turns.
pub fn scene_of_run(families: &[Family], seed: u64, index: usize) -> (Family, Case) {
    let family = families[index % families.len()];
    (family, family.case(seed, (index / families.len()) as u64))
}
