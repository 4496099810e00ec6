//! Constant scenes, taken apart into constants of which only those that are read are linked.

use core::marker::PhantomData;

use super::World;
use super::light_occluders::LightOccluders;
use super::light_table::LightTable;
use super::mirror_table::{MirrorTable, MirrorTables};
use crate::grid::Grid;
use crate::light::PreparedLight;
use crate::material::PreparedMaterial;
use crate::scene::access::SceneAccess;
use crate::scene::{Needs, Parts, Scene, used};
use crate::shape::cylinder::PreparedCylinder;
use crate::shape::plane::PreparedPlane;
use crate::shape::sphere::PreparedSphere;

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
    const LIGHT_OCCLUDERS: &'static [<Self::Scene as World>::LightOccluders];
    /// Which of them lie in which direction from each light.
    const LIGHT_TABLES: &'static [LightTable];
    /// Which of them lie ahead of rays that leave each round mirror; none where no ray is going to.
    const MIRROR_TABLES: &'static MirrorTables;
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

    const LIGHT_OCCLUDERS: &'static [LightOccluders<S, C>] =
        used(&Copied::<T>::LIGHT_OCCLUDERS, T::SCENE.counts.lights);

    const LIGHT_TABLES: &'static [LightTable] =
        used(&Copied::<T>::LIGHT_TABLES, T::SCENE.counts.lights);

    const MIRROR_TABLES: &'static MirrorTables = &MirrorTables {
        numbers: MirrorTables::numbered(&Self::PARTS).0,
        tables: match MirrorTables::numbered(&Self::PARTS).1 {
            0 => &[],
            1 => &Copied::<T>::MIRROR_TABLES_1,
            2 => &Copied::<T>::MIRROR_TABLES_2,
            3 => &Copied::<T>::MIRROR_TABLES_3,
            4 => &Copied::<T>::MIRROR_TABLES_4,
            6 => &Copied::<T>::MIRROR_TABLES_6,
            8 => &Copied::<T>::MIRROR_TABLES_8,
            12 => &Copied::<T>::MIRROR_TABLES_12,
            _ => &Copied::<T>::MIRROR_TABLES_16,
        },
    };
}

impl Needs {
    /// Of a scene known when the program is compiled.
    pub const fn of<T: Apart>() -> Self {
        T::NEEDS
    }
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
    const LIGHT_TABLES: [LightTable; L] = T::SCENE.light_tables;
    const LIGHT_OCCLUDERS: [LightOccluders<S, C>; L] = T::SCENE.light_occluders;
    // An array's length cannot come from the scene, so there is one of each size.
    const MIRROR_TABLES_1: [MirrorTable; 1] = MirrorTables::tables(&T::PARTS);
    const MIRROR_TABLES_2: [MirrorTable; 2] = MirrorTables::tables(&T::PARTS);
    const MIRROR_TABLES_3: [MirrorTable; 3] = MirrorTables::tables(&T::PARTS);
    const MIRROR_TABLES_4: [MirrorTable; 4] = MirrorTables::tables(&T::PARTS);
    const MIRROR_TABLES_6: [MirrorTable; 6] = MirrorTables::tables(&T::PARTS);
    const MIRROR_TABLES_8: [MirrorTable; 8] = MirrorTables::tables(&T::PARTS);
    const MIRROR_TABLES_12: [MirrorTable; 12] = MirrorTables::tables(&T::PARTS);
    const MIRROR_TABLES_16: [MirrorTable; 16] = MirrorTables::tables(&T::PARTS);
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

impl<T: Apart> SceneAccess for Static<T> {
    const NEEDS: Needs = <T as Apart>::NEEDS;
    const CHOOSES_HITS: bool = !T::MIRROR_TABLES.tables.is_empty();

    #[inline(always)]
    fn parts(&self) -> Parts<'_> {
        T::PARTS
    }
}

#[allow(private_interfaces)]
impl<T: Apart> World for Static<T> {
    type LightOccluders = <T::Scene as World>::LightOccluders;
    type ScreenBounds = <T::Scene as World>::ScreenBounds;

    #[inline(always)]
    fn light_occluders(&self) -> &[Self::LightOccluders] {
        T::LIGHT_OCCLUDERS
    }

    #[inline(always)]
    fn light_tables(&self) -> &[LightTable] {
        T::LIGHT_TABLES
    }

    #[inline(always)]
    fn mirror_tables(&self) -> &MirrorTables {
        T::MIRROR_TABLES
    }
}
