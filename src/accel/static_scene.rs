//! Constant scenes. Each list of a scene is a constant of its own, and only constants that are read are
//! linked.

use core::marker::PhantomData;

use super::hierarchy::{Hierarchy, HierarchyNode, fill, is_useful};
use super::light_lists::LightLists;
use super::light_occluders::LightOccluders;
use super::light_table::LightTable;
use super::{ActiveRoom, Scene, Tables, World};
use crate::checker::PreparedChecker;
use crate::grid::Grid;
use crate::light::PreparedLight;
use crate::material::PreparedMaterial;
use crate::scene::access::SceneAccess;
use crate::scene::{Description, Needs, Parts, Room, used};
use crate::shape::plane::PreparedPlane;

/// A type whose scene is a constant. [`scene!`](crate::scene) implements it.
///
/// The scene lives in flash. The program contains only the code and the tables that the scene can use.
pub trait StaticScene: Sized + 'static {
    /// Room of the scene: the capacities of its lists.
    type Room: ActiveRoom;
    /// Prepared scene, as one constant.
    const SCENE: &'static Scene<Self::Room>;
    /// Reference to the only value of the type, which has no fields.
    const INSTANCE: &'static Self;

    /// Calls `read` with the description of the scene, which holds the numbers it was written with, and
    /// returns the result.
    ///
    /// Frames do not read the description. Checks against a reference do.
    fn with_description<R>(read: impl FnOnce(Description<'_>) -> R) -> R;
}

/// A [`StaticScene`] with its needs and with each list as a constant of its own.
///
/// A list that nothing reads is then not linked.
pub trait Apart: StaticScene {
    /// Features of the library that the scene needs.
    const NEEDS: Needs;
    /// Prepared shapes, lights, materials and settings of the scene.
    const PARTS: Parts<'static>;
    /// For each light, the shapes that may occlude it, prepared from the light's position.
    const LIGHT_OCCLUDERS: &'static [LightOccluders<Self::Room>];
    /// For each light, the shapes that lie in each direction from it.
    const LIGHT_TABLES: &'static [LightTable];
    /// For each light, short lists of the shapes that lie in each direction from it.
    const LIGHT_LISTS: &'static [LightLists];
    /// The balls around the shapes of a crowd; empty if no ray would read them.
    const HIERARCHY: Hierarchy<'static>;
}

impl Needs {
    /// Returns the needs of the constant scene `T`; the example of [`Needs`] shows it.
    pub const fn of<T: Apart>() -> Self {
        T::NEEDS
    }
}

/// Holder of constants that are copies of the lists of the scene `T`.
struct Copied<T>(PhantomData<T>);

macro_rules! apart {
    (
        { $declaration:tt [$($header:tt)*] [$($arguments:tt)*] }
        $({ $list:ident $kind:ident $described:ident $prepared:ident $room:ident $lists:ident $($more:tt)* })*
    ) => {
        impl<T, $($header)*> Apart for T
        where
            T: StaticScene<Room = Room<$($arguments)*>>,
        {
            const NEEDS: Needs = T::SCENE.plain.constant_parts().needs();

            const PARTS: Parts<'static> = Parts {
                $($list: used(&Copied::<T>::$lists, T::SCENE.plain.counts.$list),)*
                planes: used(&Copied::<T>::PLANES, T::SCENE.plain.counts.planes),
                lights: used(&Copied::<T>::LIGHTS, T::SCENE.plain.counts.lights),
                materials: used(&Copied::<T>::MATERIALS, T::SCENE.plain.counts.materials),
                checkers: used(&Copied::<T>::CHECKERS, T::SCENE.plain.counts.materials),
                grid: &Copied::<T>::GRID,
                ..T::SCENE.plain.constant_parts()
            };

            const LIGHT_OCCLUDERS: &'static [LightOccluders<Room<$($arguments)*>>] =
                used(&Copied::<T>::LIGHT_OCCLUDERS, T::SCENE.plain.counts.lights);

            const LIGHT_TABLES: &'static [LightTable] =
                used(&Copied::<T>::LIGHT_TABLES, T::SCENE.plain.counts.lights);

            const LIGHT_LISTS: &'static [LightLists] =
                used(&Copied::<T>::LIGHT_LISTS, T::SCENE.plain.counts.lights);

            const HIERARCHY: Hierarchy<'static> = hierarchy::<T>();
        }

        #[allow(non_upper_case_globals, reason = "a constant has the name of its list")]
        impl<T, $($header)*> Copied<T>
        where
            T: StaticScene<Room = Room<$($arguments)*>>,
        {
            $(const $lists: [crate::shape::$prepared; $room] = T::SCENE.plain.$list;)*
            const PLANES: [PreparedPlane; P] = T::SCENE.plain.planes;
            const LIGHTS: [PreparedLight; L] = T::SCENE.plain.lights;
            const MATERIALS: [PreparedMaterial; M] = T::SCENE.plain.materials;
            const CHECKERS: [PreparedChecker; M] = T::SCENE.plain.checkers;
            const GRID: Grid = T::SCENE.plain.grid;
            const LIGHT_TABLES: [LightTable; L] = LightTable::of_lights(&T::PARTS);
            const LIGHT_LISTS: [LightLists; L] = LightLists::of_lights(&T::PARTS);
            const LIGHT_OCCLUDERS: [LightOccluders<Room<$($arguments)*>>; L] =
                T::SCENE.light_occluders;
        }
    };
}
kinds!(apart);

/// Holder of the `N` nodes of the hierarchy of the scene `T`. The length of an array cannot be computed from
/// `T`, so [`hierarchy`] chooses among fixed lengths.
struct NodeList<T, const N: usize>(PhantomData<T>);

impl<T: Apart, const N: usize> NodeList<T, N> {
    const OF_SCENE: [HierarchyNode; N] = {
        let mut nodes = [HierarchyNode::NONE; N];
        fill(&T::PARTS, &mut nodes);
        nodes
    };
}

/// Returns the hierarchy of a constant scene. It has none if few rays would read it, or if it would have
/// more nodes than 1024.
const fn hierarchy<T: Apart>() -> Hierarchy<'static> {
    let room = if is_useful(&T::PARTS) { Hierarchy::room(T::PARTS.bounded()) } else { 0 };
    let nodes: &[HierarchyNode] = match room {
        16 => &NodeList::<T, 16>::OF_SCENE,
        32 => &NodeList::<T, 32>::OF_SCENE,
        64 => &NodeList::<T, 64>::OF_SCENE,
        128 => &NodeList::<T, 128>::OF_SCENE,
        256 => &NodeList::<T, 256>::OF_SCENE,
        512 => &NodeList::<T, 512>::OF_SCENE,
        1024 => &NodeList::<T, 1024>::OF_SCENE,
        _ => &[],
    };
    Hierarchy::filled(nodes)
}

/// Access of the kernels to the constant scene `T`. The value takes no memory.
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
    const HAS_BLANK: bool = T::PARTS.has_blank();

    #[inline(always)]
    fn parts(&self) -> Parts<'_> {
        T::PARTS
    }
}

impl<T: Apart> World for Static<T> {
    type Room = T::Room;
    const IS_CROWD: bool = !T::HIERARCHY.is_empty();

    #[inline(always)]
    fn tables(&self) -> Tables<'_, Self::Room> {
        Tables {
            light_occluders: T::LIGHT_OCCLUDERS,
            light_tables: T::LIGHT_TABLES,
            light_lists: T::LIGHT_LISTS,
            hierarchy: T::HIERARCHY,
        }
    }
}
