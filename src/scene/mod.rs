//! Floor 3: the bounded scene, checked and prepared once when it is built, and the two questions
//! a ray asks it: what it meets first ([`query`]) and whether it is blocked.
//!
//! A scene is laid on a grid of its own: its shapes fill a ball of 2²⁸ steps, whatever their size
//! in scene units, so the binary point is never the user's concern.

pub(crate) mod access;
mod brightness;
mod builder;
mod error;
pub(crate) mod far;
mod layout;
pub(crate) mod nearest;
mod needs;
pub(crate) mod planes;
mod prepare;
pub(crate) mod query;
mod runtime;
pub(crate) mod shape_set;
pub(crate) mod surface;

pub(crate) use access::Parts;
pub use builder::SceneBuilder;
pub use error::SceneError;
pub(crate) use needs::FEW;
pub use needs::{Bound, Excess, Mirrors, MostReflections, Need, Needs, Shininess};
pub use runtime::RuntimeScene;
pub(crate) use surface::Surface;

use crate::accel::light_occluders::LightOccluders;
use crate::accel::light_table::LightTable;
use crate::camera::Camera;
use crate::color::Color;
use crate::grid::Grid;
use crate::light::{Light, PreparedLight};
use crate::material::{Material, PreparedMaterial};
use crate::number::{Brightness, Length, Number, Unit};
use crate::shape::cylinder::{Cylinder, PreparedCylinder};
use crate::shape::plane::{Plane, PreparedPlane};
use crate::shape::sphere::{PreparedSphere, Sphere};

/// A scene as it was described: plain numbers, before they are laid on the grid.
#[derive(Clone, Copy, Debug)]
pub struct Description<'a> {
    /// The spheres.
    pub spheres: &'a [Sphere],
    /// The planes.
    pub planes: &'a [Plane],
    /// The cylinders.
    pub cylinders: &'a [Cylinder],
    /// The lights.
    pub lights: &'a [Light],
    /// The materials the shapes name.
    pub materials: &'a [Material],
    /// What a ray that meets nothing adds.
    pub background: [Number; 3],
    /// How far above a surface rays start that leave it; see [`SceneBuilder::epsilon`].
    pub epsilon: Number,
    /// The camera the scene is meant to be seen with first.
    pub camera: Option<Camera>,
}

/// How far a ray is lifted off the surface it leaves unless the scene says otherwise.
pub(crate) const EPSILON: f64 = 1e-3;

/// A scene made ready for the kernels, with room for `S` spheres, `P` planes, `C` cylinders, `L`
/// lights and `M` materials.
///
/// Made by [`SceneBuilder::build`] when the program is compiled, or by [`RuntimeScene::build`]
/// while it runs.
#[derive(Clone, Copy, Debug)]
pub struct Scene<const S: usize, const P: usize, const C: usize, const L: usize, const M: usize = 8>
{
    pub(crate) spheres: [PreparedSphere; S],
    pub(crate) planes: [PreparedPlane; P],
    pub(crate) cylinders: [PreparedCylinder; C],
    pub(crate) lights: [PreparedLight; L],
    pub(crate) light_tables: [LightTable; L],
    pub(crate) light_occluders: [LightOccluders<S, C>; L],
    pub(crate) materials: [PreparedMaterial; M],
    pub(crate) counts: Counts,
    pub(crate) background: Color,
    pub(crate) brightest: Brightness,
    pub(crate) dimness: Unit,
    pub(crate) epsilon: Length,
    pub(crate) inner_epsilon: Length,
    pub(crate) grid: Grid,
    pub(crate) camera: Option<Camera>,
}

/// How much of a scene's room is used.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Counts {
    pub(crate) spheres: usize,
    pub(crate) planes: usize,
    pub(crate) cylinders: usize,
    pub(crate) lights: usize,
    pub(crate) materials: usize,
}

impl<const S: usize, const P: usize, const C: usize, const L: usize, const M: usize>
    Scene<S, P, C, L, M>
{
    /// Starts the description of a scene that is built when the program is compiled.
    pub const fn builder() -> SceneBuilder<S, P, C, L, M> {
        SceneBuilder::new()
    }

    /// The camera the scene was described with.
    pub const fn camera(&self) -> Option<&Camera> {
        self.camera.as_ref()
    }

    /// What the plain kernels read.
    #[inline(always)]
    pub(crate) const fn plain_parts(&self) -> Parts<'_> {
        Parts {
            spheres: used(&self.spheres, self.counts.spheres),
            planes: used(&self.planes, self.counts.planes),
            cylinders: used(&self.cylinders, self.counts.cylinders),
            lights: used(&self.lights, self.counts.lights),
            materials: used(&self.materials, self.counts.materials),
            background: self.background,
            brightest: self.brightest,
            dimness: self.dimness,
            epsilon: self.epsilon,
            inner_epsilon: self.inner_epsilon,
            grid: &self.grid,
        }
    }
}

/// The first `count` items; all of them, rather than a panic, should there be fewer.
#[inline(always)]
pub(crate) const fn used<T>(items: &[T], count: usize) -> &[T] {
    match items.split_at_checked(count) {
        Some((used, _)) => used,
        None => items,
    }
}
