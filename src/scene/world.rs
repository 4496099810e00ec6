//! What the kernels read of a scene, wherever it lives: in a variable, or taken apart into constants
//! of which only those that are read are linked.

use core::marker::PhantomData;

use super::ahead::{Ahead, RoundMirrors, room_for};
use super::capacity::{Capacity, Room};
use super::cells::Cells;
use super::extent::{Outlook, Outlooks};
use super::mask::Runs;
use super::needs::{Bound, Needs};
use super::{Scene, used};
use crate::color::Color;
use crate::grid::Grid;
use crate::light::PreparedLight;
use crate::material::PreparedMaterial;
use crate::number::{Brightness, Length, Unit, unit_product};
use crate::shape::MaterialId;
use crate::shape::cylinder::{LitCylinder, PreparedCylinder};
use crate::shape::plane::PreparedPlane;
use crate::shape::sphere::{PreparedSphere, SphereFromPoint};

/// A light and the shapes of a scene as it sees them.
#[derive(Clone, Copy, Debug)]
pub struct LightOccluders<const S: usize, const C: usize> {
    pub(super) light: PreparedLight,
    pub(super) spheres: [SphereFromPoint; S],
    pub(super) cylinders: [LitCylinder; C],
}

impl<const S: usize, const C: usize> LightOccluders<S, C> {
    /// Fills the room of a light that a scene's type allows but the scene does not use.
    pub(super) const NONE: Self = Self {
        light: PreparedLight::NONE,
        spheres: [SphereFromPoint::NONE; S],
        cylinders: [LitCylinder::NONE; C],
    };
}

/// A [`LightOccluders`], whatever its room.
pub trait Occluders {
    /// The light itself.
    #[allow(private_interfaces)]
    fn light(&self) -> &PreparedLight;

    /// The scene's spheres as the light sees them; what stands for none is never met.
    #[allow(private_interfaces)]
    fn spheres(&self) -> &[SphereFromPoint];

    /// The scene's cylinders as the light sees them, and maybe more.
    #[allow(private_interfaces)]
    fn cylinders(&self) -> &[LitCylinder];
}

impl<const S: usize, const C: usize> Occluders for LightOccluders<S, C> {
    #[allow(private_interfaces)]
    #[inline(always)]
    fn light(&self) -> &PreparedLight {
        &self.light
    }

    #[allow(private_interfaces)]
    #[inline(always)]
    fn spheres(&self) -> &[SphereFromPoint] {
        &self.spheres
    }

    #[allow(private_interfaces)]
    #[inline(always)]
    fn cylinders(&self) -> &[LitCylinder] {
        &self.cylinders
    }
}

/// What the kernels read from a scene.
#[derive(Clone, Copy, Debug)]
pub struct Parts<'a> {
    pub(crate) spheres: &'a [PreparedSphere],
    pub(crate) planes: &'a [PreparedPlane],
    pub(crate) cylinders: &'a [PreparedCylinder],
    pub(crate) lights: &'a [PreparedLight],
    pub(crate) materials: &'a [PreparedMaterial],
    pub(crate) background: Color,
    /// The largest component of any colour that a path can meet, [`Color::in_levels`]; rounded up.
    pub(crate) brightest: Brightness,
    /// One over the brightest, rounded down to 8 leading bits, and at most 1.
    pub(crate) dimness: Unit,
    /// Offset along the normal where rays that leave a surface start: at least 2 steps.
    pub(crate) epsilon: Length,
    /// The same inside of a sphere or cylinder: at least 8 steps, or 16 in a scene with cylinders.
    pub(crate) inner_epsilon: Length,
    pub(crate) grid: &'a Grid,
}

impl<'a> Parts<'a> {
    /// A material; black if there is none of that number.
    #[inline(always)]
    pub(crate) fn material(&self, material: MaterialId) -> &'a PreparedMaterial {
        const NONE: &PreparedMaterial = &PreparedMaterial::NONE;
        match self.materials {
            // So that the compiler knows which.
            [only] => only,
            several => several.get(material.index()).unwrap_or(NONE),
        }
    }

    /// The smallest weight with which a path can still change a channel by `change`, 0 to 1.
    pub(crate) const fn smallest_weight(&self, change: Unit) -> Unit {
        unit_product(change, self.dimness)
    }

    /// Whether there is nothing to be met.
    #[inline(always)]
    pub(crate) fn is_empty(&self) -> bool {
        !self.has_bounded() && self.planes.is_empty()
    }

    /// Whether there are spheres or cylinders.
    #[inline(always)]
    pub(crate) fn has_bounded(&self) -> bool {
        !(self.spheres.is_empty() && self.cylinders.is_empty())
    }

    /// How the shapes are spread over the bits of a mask.
    #[inline(always)]
    pub(crate) fn runs(&self) -> Runs {
        Runs::new(self.spheres.len(), self.cylinders.len())
    }
}

/// A scene the kernels can read, wherever it lives.
///
/// Implemented by the crate for [`Scene`], for references to one, for [`Static`] and for [`Within`];
/// there is no need to implement it elsewhere.
pub trait World {
    /// A light, and the shapes as it sees them.
    type LightOccluders: Occluders;

    /// Which pixels of a frame the shapes cover.
    type Outlook: Outlooks;

    /// What it can need: what it does not is not linked.
    const NEEDS: Needs;

    /// How many planes there are at most.
    const PLANES: usize;

    /// Whether it is known what lies ahead of rays that leave spheres and cylinders.
    const AHEAD: bool;

    /// The scene's parts.
    fn parts(&self) -> Parts<'_>;

    /// The lights, and the shapes as they see them.
    fn lamps(&self) -> &[Self::LightOccluders];

    /// Which shapes lie in which direction from each light.
    #[allow(private_interfaces)]
    fn cells(&self) -> &[Cells];

    /// Which shapes lie ahead of rays that leave each sphere and each cylinder, if that is known.
    #[allow(private_interfaces)]
    fn round_mirrors(&self) -> &RoundMirrors;
}

impl<const S: usize, const P: usize, const C: usize, const L: usize, const M: usize> World
    for Scene<S, P, C, L, M>
{
    type LightOccluders = LightOccluders<S, C>;
    type Outlook = Outlook<S, P, C>;

    const NEEDS: Needs = Needs::of_room(&Room::<S, P, C, L, M>::COUNTS);
    const PLANES: usize = P;
    const AHEAD: bool = false;

    #[inline(always)]
    fn parts(&self) -> Parts<'_> {
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

    #[inline(always)]
    fn lamps(&self) -> &[Self::LightOccluders] {
        used(&self.lamps, self.counts.lights)
    }

    #[allow(private_interfaces)]
    #[inline(always)]
    fn cells(&self) -> &[Cells] {
        used(&self.cells, self.counts.lights)
    }

    #[allow(private_interfaces)]
    #[inline(always)]
    fn round_mirrors(&self) -> &RoundMirrors {
        RoundMirrors::NONE
    }
}

impl<W: World> World for &W {
    type LightOccluders = W::LightOccluders;
    type Outlook = W::Outlook;

    const NEEDS: Needs = W::NEEDS;
    const PLANES: usize = W::PLANES;
    const AHEAD: bool = W::AHEAD;

    #[inline(always)]
    fn parts(&self) -> Parts<'_> {
        (**self).parts()
    }

    #[inline(always)]
    fn lamps(&self) -> &[Self::LightOccluders] {
        (**self).lamps()
    }

    #[allow(private_interfaces)]
    #[inline(always)]
    fn cells(&self) -> &[Cells] {
        (**self).cells()
    }

    #[allow(private_interfaces)]
    #[inline(always)]
    fn round_mirrors(&self) -> &RoundMirrors {
        (**self).round_mirrors()
    }
}

/// A scene that is a constant of a type: it lives in flash, and the compiler keeps only the code and
/// the tables that this scene can use.
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

/// A [`StaticScene`] taken apart: what it needs, and each of its parts as a constant of its own, so
/// that a part that nothing reads is not linked.
///
/// Implemented by the crate for every [`StaticScene`].
#[allow(private_interfaces)]
pub trait Apart: StaticScene {
    /// What the scene needs.
    const NEEDS: Needs;
    /// Its parts.
    const PARTS: Parts<'static>;
    /// Its lights, and its shapes as they see them.
    const LAMPS: &'static [<Self::Scene as World>::LightOccluders];
    /// Which of them lie in which direction from each light.
    const CELLS: &'static [Cells];
    /// Which of them lie ahead of rays that leave each sphere and each cylinder; nothing where no
    /// ray is going to.
    const ROUND_MIRRORS: &'static RoundMirrors;
}

#[allow(private_interfaces)]
impl<T, const S: usize, const P: usize, const C: usize, const L: usize, const M: usize> Apart for T
where
    T: StaticScene<Scene = Scene<S, P, C, L, M>>,
{
    const NEEDS: Needs = T::SCENE.needs();

    const PARTS: Parts<'static> = Parts {
        spheres: used(&Copied::<T>::SPHERES, T::SCENE.counts.spheres),
        planes: used(&Copied::<T>::PLANES, T::SCENE.counts.planes),
        cylinders: used(&Copied::<T>::CYLINDERS, T::SCENE.counts.cylinders),
        lights: used(&Copied::<T>::LIGHTS, T::SCENE.counts.lights),
        materials: used(&Copied::<T>::MATERIALS, T::SCENE.counts.materials),
        background: T::SCENE.background,
        brightest: T::SCENE.brightest,
        dimness: T::SCENE.dimness,
        epsilon: T::SCENE.epsilon,
        inner_epsilon: T::SCENE.inner_epsilon,
        grid: &Copied::<T>::GRID,
    };

    const LAMPS: &'static [LightOccluders<S, C>] =
        used(&Copied::<T>::LAMPS, T::SCENE.counts.lights);

    const CELLS: &'static [Cells] = used(&Copied::<T>::CELLS, T::SCENE.counts.lights);

    const ROUND_MIRRORS: &'static RoundMirrors = &RoundMirrors {
        numbers: T::SCENE.numbers_ahead(),
        tables: match room_for(T::SCENE.count_round_mirrors()) {
            0 => &[],
            1 => &Copied::<T>::AHEAD_OF_1,
            2 => &Copied::<T>::AHEAD_OF_2,
            3 => &Copied::<T>::AHEAD_OF_3,
            4 => &Copied::<T>::AHEAD_OF_4,
            6 => &Copied::<T>::AHEAD_OF_6,
            8 => &Copied::<T>::AHEAD_OF_8,
            12 => &Copied::<T>::AHEAD_OF_12,
            _ => &Copied::<T>::AHEAD_OF_16,
        },
    };
}

/// Copies of the parts of a scene.
struct Copied<T>(PhantomData<T>);

impl<T, const S: usize, const P: usize, const C: usize, const L: usize, const M: usize> Copied<T>
where
    T: StaticScene<Scene = Scene<S, P, C, L, M>>,
{
    const SPHERES: [PreparedSphere; S] = T::SCENE.spheres;
    const PLANES: [PreparedPlane; P] = T::SCENE.planes;
    const CYLINDERS: [PreparedCylinder; C] = T::SCENE.cylinders;
    const LIGHTS: [PreparedLight; L] = T::SCENE.lights;
    const CELLS: [Cells; L] = T::SCENE.cells;
    const LAMPS: [LightOccluders<S, C>; L] = T::SCENE.lamps;
    // An array's length cannot come from the scene, so there is one of each size.
    const AHEAD_OF_1: [Ahead; 1] = T::SCENE.tables_ahead();
    const AHEAD_OF_2: [Ahead; 2] = T::SCENE.tables_ahead();
    const AHEAD_OF_3: [Ahead; 3] = T::SCENE.tables_ahead();
    const AHEAD_OF_4: [Ahead; 4] = T::SCENE.tables_ahead();
    const AHEAD_OF_6: [Ahead; 6] = T::SCENE.tables_ahead();
    const AHEAD_OF_8: [Ahead; 8] = T::SCENE.tables_ahead();
    const AHEAD_OF_12: [Ahead; 12] = T::SCENE.tables_ahead();
    const AHEAD_OF_16: [Ahead; 16] = T::SCENE.tables_ahead();
    const MATERIALS: [PreparedMaterial; M] = T::SCENE.materials;
    const GRID: Grid = T::SCENE.grid;
}

/// The scene of a [`StaticScene`] as the kernels read it; takes no room.
pub struct Static<T>(PhantomData<T>);

impl<T> Static<T> {
    pub(crate) const fn new() -> Self {
        Self(PhantomData)
    }
}

impl<T> Clone for Static<T> {
    fn clone(&self) -> Self {
        *self
    }
}

impl<T> Copy for Static<T> {}

impl<T: Apart> World for Static<T> {
    type LightOccluders = <T::Scene as World>::LightOccluders;
    type Outlook = <T::Scene as World>::Outlook;

    const NEEDS: Needs = T::NEEDS;
    const PLANES: usize = T::PARTS.planes.len();
    const AHEAD: bool = !T::ROUND_MIRRORS.tables.is_empty();

    #[inline(always)]
    fn parts(&self) -> Parts<'_> {
        T::PARTS
    }

    #[inline(always)]
    fn lamps(&self) -> &[Self::LightOccluders] {
        T::LAMPS
    }

    #[allow(private_interfaces)]
    #[inline(always)]
    fn cells(&self) -> &[Cells] {
        T::CELLS
    }

    #[allow(private_interfaces)]
    #[inline(always)]
    fn round_mirrors(&self) -> &RoundMirrors {
        T::ROUND_MIRRORS
    }
}

/// A scene of which no more is needed than `B` says; see [`Scene::frame_within`].
pub struct Within<W, B> {
    world: W,
    bound: PhantomData<B>,
}

impl<W, B> Within<W, B> {
    /// The caller knows it.
    pub(crate) const fn new(world: W) -> Self {
        Self {
            world,
            bound: PhantomData,
        }
    }
}

impl<W: Clone, B> Clone for Within<W, B> {
    fn clone(&self) -> Self {
        Self::new(self.world.clone())
    }
}

impl<W: Copy, B> Copy for Within<W, B> {}

impl<W: World, B: Bound> World for Within<W, B> {
    type LightOccluders = W::LightOccluders;
    type Outlook = W::Outlook;

    const NEEDS: Needs = W::NEEDS.both(&B::NEEDS);
    const PLANES: usize = W::PLANES;
    const AHEAD: bool = W::AHEAD;

    #[inline(always)]
    fn parts(&self) -> Parts<'_> {
        let parts = self.world.parts();
        // What is not needed is not there, and the compiler sees it.
        Parts {
            spheres: if_needed(B::NEEDS.spheres, parts.spheres),
            planes: if_needed(B::NEEDS.planes, parts.planes),
            cylinders: if_needed(B::NEEDS.cylinders, parts.cylinders),
            lights: if_needed(B::NEEDS.lights, parts.lights),
            ..parts
        }
    }

    #[inline(always)]
    fn lamps(&self) -> &[Self::LightOccluders] {
        if_needed(B::NEEDS.lights, self.world.lamps())
    }

    #[allow(private_interfaces)]
    #[inline(always)]
    fn cells(&self) -> &[Cells] {
        self.world.cells()
    }

    #[allow(private_interfaces)]
    #[inline(always)]
    fn round_mirrors(&self) -> &RoundMirrors {
        self.world.round_mirrors()
    }
}

/// A scene with everything linked that any scene needs; see [`crate::Frame::whole`].
#[derive(Clone, Copy, Debug)]
pub struct Whole<W>(pub(crate) W);

impl<W: World> World for Whole<W> {
    type LightOccluders = W::LightOccluders;
    type Outlook = W::Outlook;

    const NEEDS: Needs = Needs::ALL;
    const PLANES: usize = W::PLANES;
    const AHEAD: bool = W::AHEAD;

    #[inline(always)]
    fn parts(&self) -> Parts<'_> {
        self.0.parts()
    }

    #[inline(always)]
    fn lamps(&self) -> &[Self::LightOccluders] {
        self.0.lamps()
    }

    #[allow(private_interfaces)]
    #[inline(always)]
    fn cells(&self) -> &[Cells] {
        self.0.cells()
    }

    #[allow(private_interfaces)]
    #[inline(always)]
    fn round_mirrors(&self) -> &RoundMirrors {
        self.0.round_mirrors()
    }
}

#[inline(always)]
const fn if_needed<T>(is_needed: bool, items: &[T]) -> &[T] {
    if is_needed { items } else { &[] }
}
