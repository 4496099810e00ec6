//! What shading asks about the lights of a scene.

use crate::light::PreparedLight;
use crate::number::Length;
use crate::ray::{ScaledPoint, ScaledRay};
use crate::scene::Surface;
use crate::vector::Direction;

/// Tells which lights are visible from a surface.
pub trait Visibility {
    /// A light with the tables that belong to it.
    type Light;

    /// Whether anything is known of a light before a ray to it is tested. If not, only [`Visibility::is_occluded`] is
    /// asked. A branch on this constant compiles one side only.
    const IS_KNOWN: bool;

    /// Returns all lights of the scene.
    fn lights(&self) -> &[Self::Light];

    /// Returns the light without its tables.
    fn light(light: &Self::Light) -> &PreparedLight;

    /// Tests whether a light is hidden from all surfaces of the frame. `index` is the light's index.
    fn is_hidden(&self, _index: usize) -> bool {
        false
    }

    /// Tests whether [`Visibility::is_occluded_from`] may be used for a light. `index` is the light's
    /// index.
    fn is_clear(&self, _index: usize) -> bool {
        false
    }

    /// Tests whether a bounded shape occludes a near surface from a clear light. No plane does.
    ///
    /// The ray is the direction and the distance from the light to the surface. The light comes with its
    /// index.
    fn is_occluded_from<const PRECISE: bool>(
        &self,
        _surface: &Surface<'_>,
        _light: (&Self::Light, usize),
        _ray: (Direction, Length),
    ) -> bool {
        false
    }

    /// Tests whether no plane hides a far light from any surface of the frame. `index` is the light's index.
    fn is_open(&self, _index: usize) -> bool {
        false
    }

    /// Tests whether a bounded shape lies ahead of a ray that leaves a near surface: whether it hides an
    /// open far light in this direction.
    fn is_occluded_ahead(&self, _surface: &Surface<'_>, _direction: Direction) -> bool {
        false
    }

    /// Tests whether any shape lies between a surface and a light. `index` is the light's index.
    ///
    /// `ray` leads from the surface to the light. `light` is the light's position, its distance in
    /// steps of 2ˢᶜᵃˡᵉ, and the scale.
    fn is_occluded(
        &self,
        surface: &Surface<'_>,
        ray: &ScaledRay,
        index: usize,
        light: (ScaledPoint, Length, u32),
    ) -> bool;
}
