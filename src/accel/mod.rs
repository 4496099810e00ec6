//! Floor 5: culling: techniques that make the plain path faster by testing fewer shapes for each ray.
//! This floor knows no shading.
//!
//! Each file holds one technique and its bound. A technique that only chooses candidates changes no bit
//! of a picture.

mod active_list;
mod active_lists;
pub(crate) mod any_scene;
mod beside;
mod cap;
mod far_stretch;
mod fingerprint;
pub(crate) mod hierarchy;
pub(crate) mod light_lists;
pub(crate) mod light_occluders;
mod light_stretch;
pub(crate) mod light_table;
pub(crate) mod light_visibility;
mod motion;
pub(crate) mod row_list;
mod scene;
pub(crate) mod screen_axis;
pub(crate) mod screen_bounds;
pub(crate) mod screen_culling;
mod screen_rect;
mod static_scene;
pub(crate) mod stretch;
pub(crate) mod thin;
mod touched;
mod within;

pub(crate) use active_list::Window;
pub(crate) use beside::Beside;
pub(crate) use far_stretch::far_lights_all;
pub(crate) use light_stretch::{LitStretch, is_clear_way, lights_all};
pub use motion::MovingScene;
pub use scene::{Scene, Tabled};
pub use static_scene::{Apart, Static, StaticScene};
pub use touched::BoundedShape;
pub(crate) use touched::Touched;
pub use within::{Everything, Limited};

pub use active_lists::ActiveRoom;
use hierarchy::Hierarchy;
pub use hierarchy::HierarchyNode;
use light_lists::LightLists;
use light_occluders::LightOccluders;
use light_table::LightTable;

use crate::color::LONGEST;
use crate::number::to_u32;
use crate::qualities::Quality;
use crate::ray::Ray;
use crate::scene::access::{SceneAccess, ShapeId};
use crate::scene::nearest::{Hit, NOWHERE, nearest_of};

/// Largest number of columns of a block: how many lie at most from one traced pixel of a row to the next.
///
/// A parabola reaches over all of them.
pub(crate) const LONGEST_BLOCK: u32 = to_u32(LONGEST);

/// Returns the nearest bounded shape hit by a ray that leaves `mirror`: tests the shapes near the ray if the scene has
/// a hierarchy, else all. `skip` is the shape that the ray leaves from outside.
#[inline(always)]
pub(crate) fn nearest_ahead<W: World, Q: Quality>(
    world: &W,
    ray: &Ray,
    (mirror, skip): (ShapeId, ShapeId),
) -> Hit {
    if hierarchy::is_used::<W, Q>(world) {
        hierarchy::nearest(world, ray, (mirror, skip))
    } else {
        nearest_of(world, (ray, NOWHERE), skip)
    }
}

/// A scene that the kernels can read, together with the tables that make it fast.
///
/// The crate implements it for scenes in RAM, for constant scenes and for limited ones. Users do not
/// implement it.
pub trait World: SceneAccess {
    /// Room of the scene: the capacities of its lists.
    type Room: ActiveRoom;

    /// Whether the scene may have a hierarchy of balls. If not, the code that reads it is not linked.
    const IS_CROWD: bool;

    /// Returns the tables of the scene.
    fn tables(&self) -> Tables<'_, Self::Room>;
}

/// The culling tables of a scene. Tables that a scene does not have are empty.
#[derive(Debug)]
pub struct Tables<'a, R: ActiveRoom> {
    /// For each light, the shapes that may occlude it, prepared from the light's position.
    pub(crate) light_occluders: &'a [LightOccluders<R>],
    /// For each light, the shapes that lie in each direction from it.
    pub(crate) light_tables: &'a [LightTable],
    /// For each light, short lists of the shapes that lie in each direction from it.
    pub(crate) light_lists: &'a [LightLists],
    /// The balls around the shapes of a crowd.
    pub(crate) hierarchy: Hierarchy<'a>,
}

impl<W: World> World for &W {
    type Room = W::Room;
    const IS_CROWD: bool = W::IS_CROWD;

    #[inline(always)]
    fn tables(&self) -> Tables<'_, W::Room> {
        (**self).tables()
    }
}
