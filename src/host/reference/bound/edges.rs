//! What a path shows that has edges without being a shape: the cells of a checker, and the discs of suns.

use crate::host::reference::Shading;
use crate::host::reference::model::{Met, Scene, Surface, Vector};

/// Returns a number for the cell of a checker in which a surface lies, and whether it may be another cell: the
/// point is off by up to `error` along each axis.
pub(super) fn cell(surface: &Surface, error: f64) -> (u64, bool) {
    let material = surface.material;
    let Some(checker) = material.checker.filter(|_| material.mirror < 1.0) else {
        return (0, false);
    };
    let [low, here, high] =
        [-error, 0.0, error].map(|off| checker.cell(surface.outside + Vector::grey(off)));
    let number = here.iter().fold(0, |number, cell| {
        mixed(number, u64::from(cell.cast_unsigned()))
    });
    (number, low != here || high != here)
}

/// Returns whether a point of a plane lies in a cell of its checker's colour, and its `own` colour minus the one that it would
/// have in a cell of the other kind. Without a checker the two are the same. `None` for a shape that is no plane.
pub(super) fn open_cell(
    scene: &Scene,
    surface: &Surface,
    own: Vector,
    shading: Shading,
) -> Option<(bool, Vector)> {
    if !matches!(surface.shape, Met::Plane(_)) {
        return None;
    }
    let Some(checker) = surface.material.checker else {
        return Some((false, Vector::ZERO));
    };
    let holds = checker.is_odd(surface.outside);
    let mut material = *surface.material;
    material.checker = None;
    if !holds {
        material.color = checker.color;
    }
    let material = &material;
    let other = scene.own_color(
        &Surface {
            material,
            ..*surface
        },
        shading,
    );
    Some((holds, own - other))
}

/// Returns a number for the disc of a sun that a ray shows, and whether it may be another: the cosine of its angle to
/// the sun is off by up to `error`.
pub(super) fn disc(scene: &Scene, direction: Vector, error: f64) -> (u64, bool) {
    let (mut shown, mut is_at_edge) = (0, false);
    for (number, sun) in (1..).zip(scene.lights) {
        let Some(edge) = sun.sun else {
            continue;
        };
        let inside = direction.dot(sun.position) - edge;
        is_at_edge |= inside.abs() <= error;
        if inside >= 0.0 && shown == 0 {
            shown = number;
        }
    }
    (shown, is_at_edge)
}

/// Mixes `word` into the hash `trail`: FNV-1a for whole words, with a rotation.
pub(super) fn mixed(trail: u64, word: u64) -> u64 {
    (trail ^ word.wrapping_add(0x9e37_79b9_7f4a_7c15))
        .wrapping_mul(0x0100_0000_01b3)
        .rotate_left(23)
}
