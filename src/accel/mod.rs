//! Floor 5: everything that only makes the plain path faster: which shapes a ray need ask. Knows no
//! shading.
//!
//! Each file has one technique and its bound. What chooses candidates changes no bit of a picture.

mod active_list;
mod active_lists;
mod cap;
mod direction_table;
pub(crate) mod light_occluders;
pub(crate) mod light_table;
pub(crate) mod light_visibility;
pub(crate) mod mirror_table;
mod screen_axis;
pub(crate) mod screen_bounds;
pub(crate) mod screen_culling;
mod screen_rect;
mod static_scene;
mod within;

pub(crate) use active_list::Window;
pub use static_scene::{Apart, Static, StaticScene};
pub use within::{Whole, Within};

use light_occluders::{LightOccluders, Occluders};
use light_table::LightTable;
use mirror_table::MirrorTables;
use screen_bounds::{Bounds, ScreenBounds};

use crate::ray::{PathSignature, Ray};
use crate::scene::access::{SceneAccess, ShapeId};
use crate::scene::nearest::{Hit, NOWHERE, nearest_of};
use crate::scene::shape_set::ShapeSet;
use crate::scene::{Needs, Parts, Scene, used};

/// The longest way from one pixel that is always traced to the next.
pub(crate) const LONGEST_STRIDE: u32 = 4;

/// Which techniques a quality uses.
pub trait CullingQuality {
    /// Whether it uses any.
    const CULLING: bool;
}

/// The nearest bounded shape on a ray that a mirror reflects; asks what lies ahead of it, if that is
/// known.
#[inline(always)]
pub(crate) fn nearest_ahead<W: World>(
    world: &W,
    ray: &Ray,
    (mirror, skip): (ShapeId, ShapeId),
    signature: &mut PathSignature,
) -> Hit {
    let candidates = match W::CHOOSES_HITS {
        true => world.mirror_tables().ahead(mirror, ray.direction),
        false => ShapeSet::ALL,
    };
    nearest_of(world, candidates, (ray, NOWHERE), skip, signature)
}

/// A scene the kernels can read, wherever it lives, with what makes it fast.
///
/// Implemented by the crate for [`Scene`], for references to one, for [`Static`] and for [`Within`];
/// there is no need to implement it elsewhere.
pub trait World: SceneAccess {
    /// A light, and the shapes as it sees them.
    type LightOccluders: Occluders;

    /// Which pixels of a frame the shapes cover.
    type ScreenBounds: Bounds;

    /// The lights, and the shapes as they see them.
    fn light_occluders(&self) -> &[Self::LightOccluders];

    /// Which shapes lie in which direction from each light.
    #[allow(private_interfaces)]
    fn light_tables(&self) -> &[LightTable];

    /// Which shapes lie ahead of rays that leave each round mirror.
    #[allow(private_interfaces)]
    fn mirror_tables(&self) -> &MirrorTables;
}

impl<const S: usize, const P: usize, const C: usize, const L: usize, const M: usize> SceneAccess
    for Scene<S, P, C, L, M>
{
    const NEEDS: Needs = Needs::of_room([S, P, C, L, M]);
    const CHOOSES_HITS: bool = false;

    #[inline(always)]
    fn parts(&self) -> Parts<'_> {
        self.plain_parts()
    }
}

#[allow(private_interfaces)]
impl<const S: usize, const P: usize, const C: usize, const L: usize, const M: usize> World
    for Scene<S, P, C, L, M>
{
    type LightOccluders = LightOccluders<S, C>;
    type ScreenBounds = ScreenBounds<S, P, C>;

    #[inline(always)]
    fn light_occluders(&self) -> &[Self::LightOccluders] {
        used(&self.light_occluders, self.counts.lights)
    }

    #[inline(always)]
    fn light_tables(&self) -> &[LightTable] {
        used(&self.light_tables, self.counts.lights)
    }

    #[inline(always)]
    fn mirror_tables(&self) -> &MirrorTables {
        MirrorTables::NONE
    }
}

#[allow(private_interfaces)]
impl<W: World> World for &W {
    type LightOccluders = W::LightOccluders;
    type ScreenBounds = W::ScreenBounds;

    #[inline(always)]
    fn light_occluders(&self) -> &[Self::LightOccluders] {
        (**self).light_occluders()
    }

    #[inline(always)]
    fn light_tables(&self) -> &[LightTable] {
        (**self).light_tables()
    }

    #[inline(always)]
    fn mirror_tables(&self) -> &MirrorTables {
        (**self).mirror_tables()
    }
}
