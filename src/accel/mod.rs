//! Floor 5: everything that only makes the plain path faster: which shapes a ray need ask. Knows no
//! shading.
//!
//! Each file has one technique and its bound. What chooses candidates changes no bit of a picture.

mod active_list;
mod active_lists;
mod cap;
mod direction_table;
pub(crate) mod drawable;
mod fingerprint;
pub(crate) mod light_occluders;
pub(crate) mod light_table;
pub(crate) mod light_visibility;
pub(crate) mod mirror_table;
mod motion;
mod scene;
mod screen_axis;
pub(crate) mod screen_bounds;
pub(crate) mod screen_culling;
mod screen_rect;
mod static_scene;
mod within;

pub(crate) use active_list::Window;
pub use motion::MovingScene;
pub use scene::{Scene, Tabled};
pub use static_scene::{Apart, Static, StaticScene};
pub use within::Limited;

pub use active_lists::ActiveRoom;
use light_occluders::LightOccluders;
use light_table::LightTable;
use mirror_table::MirrorTables;

use crate::ray::{PathSignature, Ray};
use crate::scene::access::{SceneAccess, ShapeId};
use crate::scene::nearest::{Hit, NOWHERE, nearest_of};
use crate::scene::shape_set::ShapeSet;

/// The longest way from one pixel that is always traced to the next.
pub(crate) const LONGEST_STRIDE: u32 = 4;

/// Which techniques are used.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Culling {
    /// Rows ask what [`screen_bounds`] name.
    pub(crate) screen_bounds: bool,
    /// Shadows are told from the light ([`light_occluders`], [`light_visibility`]).
    pub(crate) light_occluders: bool,
    /// Shadows ask what [`light_table`] names.
    pub(crate) light_tables: bool,
    /// Rays off round mirrors ask what [`mirror_table`] names.
    pub(crate) mirror_tables: bool,
}

impl Culling {
    /// Every technique.
    pub(crate) const ALL: Self = Self {
        screen_bounds: true,
        light_occluders: true,
        light_tables: true,
        mirror_tables: true,
    };

    /// The plain path.
    pub(crate) const NONE: Self = Self {
        screen_bounds: false,
        light_occluders: false,
        light_tables: false,
        mirror_tables: false,
    };

    /// Whether a technique is used.
    pub(crate) const fn is_any(self) -> bool {
        self.screen_bounds || self.light_occluders || self.light_tables || self.mirror_tables
    }
}

/// Which techniques a quality uses.
pub trait CullingQuality {
    /// Its techniques.
    const CULLING: Culling;
}

/// The nearest bounded shape on a ray that a mirror reflects; asks what lies ahead of it, if that is
/// known.
#[inline(always)]
pub(crate) fn nearest_ahead<W: World, Q: CullingQuality>(
    world: &W,
    ray: &Ray,
    (mirror, skip): (ShapeId, ShapeId),
    signature: &mut PathSignature,
) -> Hit {
    let candidates = match W::CHOOSES_HITS && Q::CULLING.mirror_tables {
        true => world.tables().mirror_tables.ahead(mirror, ray.direction),
        false => ShapeSet::ALL,
    };
    nearest_of(world, candidates, (ray, NOWHERE), skip, signature)
}

/// A scene the kernels can read, wherever it lives, with what makes it fast.
///
/// Implemented by the crate for [`Scene`], for references to one, for [`Static`] and for [`Within`];
/// there is no need to implement it elsewhere.
pub trait World: SceneAccess {
    /// The room of its lists.
    type Room: ActiveRoom;

    /// What makes it fast.
    fn tables(&self) -> Tables<'_, Self::Room>;
}

/// What is kept of a scene beside its parts.
#[derive(Debug)]
pub struct Tables<'a, R: ActiveRoom> {
    /// The lights, and the shapes as they see them.
    pub(crate) light_occluders: &'a [LightOccluders<R>],
    /// Which shapes lie in which direction from each light.
    pub(crate) light_tables: &'a [LightTable],
    /// Which shapes lie ahead of rays that leave each round mirror.
    pub(crate) mirror_tables: &'a MirrorTables,
}

impl<W: World> World for &W {
    type Room = W::Room;

    #[inline(always)]
    fn tables(&self) -> Tables<'_, W::Room> {
        (**self).tables()
    }
}
