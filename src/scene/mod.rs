//! Floor 4: the bounded scene, checked and prepared once when it is built, and the two questions
//! a ray asks it: what it meets first ([`query`]) and whether it is blocked.
//!
//! A scene is laid on a grid of its own: its shapes fill a ball of 2²⁸ steps, whatever their size
//! in scene units, so the binary point is never the user's concern.

mod builder;
pub(crate) mod cells;
mod error;
pub(crate) mod extent;
pub(crate) mod far;
mod layout;
pub(crate) mod mask;
mod prepare;
pub(crate) mod query;
mod row;
mod runtime;
pub(crate) mod sight;
pub(crate) mod view;

pub use builder::SceneBuilder;
pub use error::SceneError;
pub use runtime::RuntimeScene;

use cells::Cells;
use extent::{Outlook, Outlooks};
use mask::Runs;

use crate::camera::Camera;
use crate::color::Color;
use crate::grid::Grid;
use crate::light::{Light, PreparedLight};
use crate::material::{Material, PreparedMaterial};
use crate::number::{Length, Number};
use crate::shape::MaterialId;
use crate::shape::cylinder::{Cylinder, PreparedCylinder, SeenCylinder};
use crate::shape::plane::{Plane, PreparedPlane};
use crate::shape::sphere::{PreparedSphere, SeenSphere, Sphere};

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
    /// How far a ray is lifted off the surface it leaves.
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
    spheres: [PreparedSphere; S],
    planes: [PreparedPlane; P],
    cylinders: [PreparedCylinder; C],
    lamps: [Spot<S, C>; L],
    materials: [PreparedMaterial; M],
    counts: Counts,
    background: Color,
    epsilon: Length,
    grid: Grid,
    camera: Option<Camera>,
}

/// How much of a scene's room is used.
#[derive(Clone, Copy, Debug)]
struct Counts {
    spheres: usize,
    planes: usize,
    cylinders: usize,
    lights: usize,
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

/// A light, and which shapes lie around it.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Lamp {
    pub(crate) light: PreparedLight,
    pub(crate) cells: Cells,
    /// Whether it stands near and outside of all spheres, so that what is hidden from it can be
    /// told by how it sees the shapes.
    pub(crate) is_plain: bool,
}

impl Lamp {
    /// Fills the room of a light that a scene's type allows but the scene does not use.
    const NONE: Self = Self {
        light: PreparedLight::NONE,
        cells: Cells::ALL,
        is_plain: false,
    };
}

/// A light with the shapes as it sees them.
#[derive(Clone, Copy, Debug)]
pub struct Spot<const S: usize, const C: usize> {
    lamp: Lamp,
    spheres: [SeenSphere; S],
    cylinders: [SeenCylinder; C],
}

impl<const S: usize, const C: usize> Spot<S, C> {
    /// Fills the room of a light that a scene's type allows but the scene does not use.
    const NONE: Self = Self {
        lamp: Lamp::NONE,
        spheres: [SeenSphere::NONE; S],
        cylinders: [SeenCylinder::NONE; C],
    };
}

/// What the kernels read from a [`Spot`], whatever its room.
pub trait LampParts {
    /// The light itself.
    #[allow(private_interfaces)]
    fn lamp(&self) -> &Lamp;

    /// The scene's spheres as the light sees them; what stands for none is never met.
    #[allow(private_interfaces)]
    fn spheres(&self) -> &[SeenSphere];

    /// The scene's cylinders as the light sees them, and maybe more.
    #[allow(private_interfaces)]
    fn cylinders(&self) -> &[SeenCylinder];
}

impl<const S: usize, const C: usize> LampParts for Spot<S, C> {
    #[allow(private_interfaces)]
    #[inline(always)]
    fn lamp(&self) -> &Lamp {
        &self.lamp
    }

    #[allow(private_interfaces)]
    #[inline(always)]
    fn spheres(&self) -> &[SeenSphere] {
        &self.spheres
    }

    #[allow(private_interfaces)]
    #[inline(always)]
    fn cylinders(&self) -> &[SeenCylinder] {
        &self.cylinders
    }
}

/// What the kernels read from a scene.
#[derive(Clone, Copy, Debug)]
pub struct Parts<'a> {
    pub(crate) spheres: &'a [PreparedSphere],
    pub(crate) planes: &'a [PreparedPlane],
    pub(crate) cylinders: &'a [PreparedCylinder],
    pub(crate) materials: &'a [PreparedMaterial],
    pub(crate) background: Color,
    pub(crate) epsilon: Length,
    pub(crate) grid: &'a Grid,
}

impl<'a> Parts<'a> {
    /// A material; black if there is none of that number.
    #[inline(always)]
    pub(crate) fn material(&self, material: MaterialId) -> &'a PreparedMaterial {
        const NONE: &PreparedMaterial = &PreparedMaterial::NONE;
        self.materials.get(material.index()).unwrap_or(NONE)
    }

    /// Whether there is nothing to be met.
    #[inline(always)]
    pub(crate) fn is_empty(&self) -> bool {
        self.spheres.is_empty() && self.cylinders.is_empty() && self.planes.is_empty()
    }

    /// How the shapes are spread over the bits of a mask.
    #[inline(always)]
    pub(crate) fn runs(&self) -> Runs {
        Runs::new(self.spheres.len(), self.cylinders.len())
    }
}

/// A scene the kernels can read, wherever it lives.
///
/// Implemented by the crate for [`Scene`], for references to one, and for [`Static`]; there is no
/// need to implement it elsewhere.
pub trait World {
    /// A light with the shapes as it sees them.
    type Lamp: LampParts;

    /// Which pixels of a frame the shapes cover.
    type Outlook: Outlooks;

    /// The scene's parts.
    fn parts(&self) -> Parts<'_>;

    /// The scene's lights.
    fn lamps(&self) -> &[Self::Lamp];
}

impl<const S: usize, const P: usize, const C: usize, const L: usize, const M: usize> World
    for Scene<S, P, C, L, M>
{
    type Lamp = Spot<S, C>;
    type Outlook = Outlook<S, P, C>;

    #[inline(always)]
    fn parts(&self) -> Parts<'_> {
        Parts {
            spheres: used(&self.spheres, self.counts.spheres),
            planes: used(&self.planes, self.counts.planes),
            cylinders: used(&self.cylinders, self.counts.cylinders),
            materials: &self.materials,
            background: self.background,
            epsilon: self.epsilon,
            grid: &self.grid,
        }
    }

    #[inline(always)]
    fn lamps(&self) -> &[Self::Lamp] {
        used(&self.lamps, self.counts.lights)
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

impl<W: World> World for &W {
    type Lamp = W::Lamp;
    type Outlook = W::Outlook;

    #[inline(always)]
    fn parts(&self) -> Parts<'_> {
        (**self).parts()
    }

    #[inline(always)]
    fn lamps(&self) -> &[Self::Lamp] {
        (**self).lamps()
    }
}

/// A scene that is a constant of a type: it lives in flash, and the compiler keeps only the code
/// this scene can use.
///
/// ```
/// use reflet::{Material, Scene, StaticScene};
///
/// const RED: Material = Material::new([0.9, 0.1, 0.1]);
///
/// struct Marble;
/// impl StaticScene for Marble {
///     type Scene = Scene<1, 0, 0, 1>; // spheres, planes, cylinders, lights
///     const SCENE: &'static Self::Scene = &Scene::builder()
///         .sphere([0.0, 0.0, 1.0], 1.0, RED)
///         .light([3.0, -4.0, 6.0], [1.0, 1.0, 1.0])
///         .build();
/// }
/// ```
pub trait StaticScene {
    /// The scene's type, which carries its bounds.
    type Scene: World + 'static;
    /// The scene.
    const SCENE: &'static Self::Scene;
}

/// The scene of a [`StaticScene`] as the kernels read it; takes no room.
pub struct Static<T>(core::marker::PhantomData<T>);

impl<T: StaticScene> Static<T> {
    pub(crate) const fn new() -> Self {
        Self(core::marker::PhantomData)
    }
}

impl<T: StaticScene> Clone for Static<T> {
    fn clone(&self) -> Self {
        *self
    }
}

impl<T: StaticScene> Copy for Static<T> {}

impl<T: StaticScene> World for Static<T> {
    type Lamp = <T::Scene as World>::Lamp;
    type Outlook = <T::Scene as World>::Outlook;

    #[inline(always)]
    fn parts(&self) -> Parts<'_> {
        T::SCENE.parts()
    }

    #[inline(always)]
    fn lamps(&self) -> &[Self::Lamp] {
        T::SCENE.lamps()
    }
}
