//! Floor 4: the bounded scene, checked and prepared once when it is built, and the two questions
//! a ray asks it: what it meets first ([`query`]) and whether it is blocked.
//!
//! A scene is laid on a grid of its own: its shapes fill a ball of 2²⁸ steps, whatever their size
//! in scene units, so the binary point is never the user's concern.

pub(crate) mod ahead;
mod brightness;
mod builder;
mod capacity;
pub(crate) mod cells;
pub(crate) mod culling;
mod description;
mod directions;
mod error;
pub(crate) mod extent;
pub(crate) mod far;
mod layout;
mod list;
pub(crate) mod mask;
pub(crate) mod nearest;
mod needs;
mod prepare;
pub(crate) mod query;
mod row;
mod runtime;
pub(crate) mod view;
mod world;

pub use builder::{SceneBuilder, SceneBuilderIn};
use capacity::Counts;
pub use capacity::{Capacity, Room};
pub use description::Description;
pub use error::SceneError;
pub use needs::{Bound, Excess, Mirrors, MostReflections, Need, Needs, Shininess};
pub use runtime::{RuntimeScene, RuntimeSceneIn};
pub use world::{Apart, Static, StaticScene, Whole, Within, World};
pub(crate) use world::{Occluders, Parts};

use cells::Cells;
use world::LightOccluders;

use crate::camera::Camera;
use crate::color::Color;
use crate::grid::Grid;
use crate::light::PreparedLight;
use crate::material::PreparedMaterial;
use crate::number::{Brightness, Length, Unit};
use crate::shape::plane::PreparedPlane;
use crate::shape::{PreparedCylinder, PreparedSphere};

/// A scene made ready for the kernels, with room for `S` spheres, `P` planes, `C` cylinders, `L`
/// lights and `M` materials.
///
/// Made by [`SceneBuilder::build`] when the program is compiled, or by [`RuntimeScene::build`]
/// while it runs.
#[derive(Clone, Copy, Debug)]
pub struct Scene<const S: usize, const P: usize, const C: usize, const L: usize, const M: usize = 8>
{
    spheres: [PreparedSphere; S],
    planes: [PreparedPlane; P],
    cylinders: [PreparedCylinder; C],
    lights: [PreparedLight; L],
    cells: [Cells; L],
    lamps: [LightOccluders<S, C>; L],
    materials: [PreparedMaterial; M],
    counts: Counts,
    background: Color,
    brightest: Brightness,
    dimness: Unit,
    epsilon: Length,
    inner_epsilon: Length,
    grid: Grid,
    camera: Option<Camera>,
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
}

/// The first `count` items; all of them, rather than a panic, should there be fewer.
#[inline(always)]
const fn used<T>(items: &[T], count: usize) -> &[T] {
    match items.split_at_checked(count) {
        Some((used, _)) => used,
        None => items,
    }
}
