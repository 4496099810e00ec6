//! Chooses a scene's grid: its middle and the length of a step. Uses integers only; it runs at compile
//! time or run time.

use super::Description;
use crate::error_kind::ErrorKind;
use crate::grid::Grid;
use crate::number::{Number, unsigned, unsigned_128};
use crate::shape::plane::Plane;
use crate::vector::Position;

/// Number of bits that the smallest radius or half height keeps, in steps, when the ball is enlarged
/// for lights, camera and planes: it stays at least 2¹⁴ steps.
const FINE: u32 = 14;
/// Number of bits that epsilon keeps, in steps, when the ball is enlarged for lights, camera and
/// planes: it stays at least 2⁶ steps.
const FINE_EPSILON: u32 = 6;

/// Distance within which a light, camera or plane is near, in radii of the shapes. Rays to near points
/// are short.
///
/// A light or camera further out becomes a far point, so a distant sun costs the shapes no bits. Near
/// ones cost at most 5 bits, and none that small shapes or epsilon need. A scene of planes alone uses
/// the distance of the nearest plane instead of the radius.
const COMPANIONS: u128 = 32;

/// Number of bits that the smallest radius or half height keeps when the ball is enlarged for a camera further out than
/// [`COMPANIONS`]. They are fewer than [`FINE`]: nothing is known between two pixels of a far camera, so it costs more time
/// than these bits are worth.
const FINE_AFAR: u32 = 12;

/// Factor by which the ball of a scene with planes is larger than the shapes need: 8, so 3 bits. Most
/// visible parts of the planes are then near. Small shapes and epsilon keep the bits they need.
const EXPANSE: u128 = 8;

/// Factor by which the ball of a scene of planes alone is larger than needed. There is no shape that
/// would lose exactness.
const EXPANSE_OF_PLANES: u128 = 256;

/// Least radius of a scene of planes alone, in epsilons.
const LEAST_EPSILONS: u128 = 1 << 9;

/// An axis-aligned box around all balls added so far.
struct Bounds {
    low: [i128; 3],
    high: [i128; 3],
    is_empty: bool,
}

impl Bounds {
    /// The box without any ball.
    const EMPTY: Self = Self {
        low: [0; 3],
        high: [0; 3],
        is_empty: true,
    };

    /// Enlarges the box to hold a cube with half side `size` around `center`.
    const fn add(&mut self, center: Position, size: i128) {
        let mut axis = 0;
        while axis < 3 {
            let middle = center.0[axis].to_bits();
            let (low, high) = (middle - size, middle + size);
            if self.is_empty || low < self.low[axis] {
                self.low[axis] = low;
            }
            if self.is_empty || high > self.high[axis] {
                self.high[axis] = high;
            }
            axis += 1;
        }
        self.is_empty = false;
    }

    /// Returns the middle of the box.
    const fn middle(&self) -> Position {
        let mut middle = Position::ORIGIN;
        let mut axis = 0;
        while axis < 3 {
            middle.0[axis] = Number::from_bits((self.low[axis] + self.high[axis]) / 2);
            axis += 1;
        }
        middle
    }
}

/// Returns the distance of two positions, or slightly more, in the bits of a [`Number`].
const fn distance(from: Position, to: Position) -> u128 {
    match to.minus(from).leading() {
        None => 0,
        Some((vector, shift)) => {
            let length = unsigned(vector.direction_and_length().1.to_bits() + 2) as u128;
            if shift >= 0 { length << shift } else { (length >> -shift) + 1 }
        }
    }
}

/// Chooses the grid of a scene: its middle is the middle of the shapes, and its step is the finest that
/// holds the shapes, what stands near them and, in a scene with planes, the enlarged ball.
pub(super) const fn choose_grid(scene: &Description<'_>) -> Result<Grid, ErrorKind> {
    let middle = middle_of(scene);
    let is_bounded = scene.extent(0).is_some();
    let (shapes, expanse) = if is_bounded {
        (radius_around(middle, scene), EXPANSE)
    } else {
        (nearest_plane(middle, scene.planes), EXPANSE_OF_PLANES)
    };
    let room = room_of(scene, FINE);
    let furthest = smaller(COMPANIONS * shapes, larger(shapes, room));
    let mut radius = with_companions(scene, middle, shapes, furthest);
    if radius == 0 {
        radius = 1 << 64;
    }
    if !is_bounded {
        // Only the camera's place tells the size of such a scene. Epsilon is small beside it.
        let epsilon = unsigned_128(scene.epsilon.to_bits());
        radius = larger(radius, epsilon * LEAST_EPSILONS);
    }
    if !scene.planes.is_empty() {
        radius = larger(radius, smaller(radius * expanse, room));
    }
    let away = camera_distance(middle, scene);
    radius = accompanied(radius, larger(shapes, room_of(scene, FINE_AFAR)), away);
    if radius < 1 << 34 {
        Err(ErrorKind::Extent)
    } else {
        Ok(Grid::new(middle, radius))
    }
}

/// Returns the radius of a ball around `middle` that holds all bounded shapes.
const fn radius_around(middle: Position, scene: &Description<'_>) -> u128 {
    let mut radius = 0;
    let mut index = 0;
    while let Some(extent) = scene.extent(index) {
        let far_side = distance(middle, extent.center) + unsigned_128(extent.radius.to_bits());
        radius = larger(radius, far_side);
        index += 1;
    }
    if let Some(motion) = scene.motion {
        let mut corner = 0;
        while corner < 8 {
            radius = larger(radius, distance(middle, corner_of(&motion, corner)));
            corner += 1;
        }
    }
    radius
}

/// Returns one of the eight corners of a box.
const fn corner_of(motion: &[Position; 2], corner: usize) -> Position {
    let mut position = motion[0];
    let mut axis = 0;
    while axis < 3 {
        position.0[axis] = motion[corner >> axis & 1].0[axis];
        axis += 1;
    }
    position
}

/// Returns `radius` enlarged so that the ball holds the lights, the camera and the planes, as far as
/// [`accompanied`] allows.
const fn with_companions(
    scene: &Description<'_>,
    middle: Position,
    mut radius: u128,
    furthest: u128,
) -> u128 {
    let mut index = 0;
    while index < scene.lights.len() {
        let light = &scene.lights[index];
        if light.sun.is_none() {
            radius = accompanied(radius, furthest, distance(middle, light.position));
        }
        index += 1;
    }
    radius = accompanied(radius, furthest, camera_distance(middle, scene));
    index = 0;
    while index < scene.planes.len() {
        let away = distance_to_plane(middle, &scene.planes[index]);
        radius = accompanied(radius, furthest, away);
        index += 1;
    }
    radius
}

/// Returns the distance of the camera from `middle`, 0 if none is given.
const fn camera_distance(middle: Position, scene: &Description<'_>) -> u128 {
    match scene.camera {
        Some(camera) => distance(middle, camera.description().position),
        None => 0,
    }
}

/// Returns the radius of the largest ball in which the smallest shape and epsilon have at least
/// 2^`fine` and 2^[`FINE_EPSILON`] steps.
const fn room_of(scene: &Description<'_>, fine: u32) -> u128 {
    let mut room = unsigned_128(scene.epsilon.to_bits()) << (28 - FINE_EPSILON);
    let mut index = 0;
    while let Some(extent) = scene.extent(index) {
        let size = unsigned_128(extent.smallest.to_bits());
        room = smaller(room, size << (28 - fine));
        index += 1;
    }
    room
}

/// Returns the distance to the nearest plane that does not go through `middle`; 0 if there is none.
const fn nearest_plane(middle: Position, planes: &[Plane]) -> u128 {
    let mut nearest = 0;
    let mut index = 0;
    while index < planes.len() {
        let away = distance_to_plane(middle, &planes[index]);
        if away > 0 && (nearest == 0 || away < nearest) {
            nearest = away;
        }
        index += 1;
    }
    nearest
}

/// Returns the middle of the bounded shapes. Without shapes it is the camera, and without one the
/// middle of the lights.
const fn middle_of(scene: &Description<'_>) -> Position {
    let mut bounds = Bounds::EMPTY;
    let mut index = 0;
    while let Some(extent) = scene.extent(index) {
        bounds.add(extent.center, extent.radius.to_bits());
        index += 1;
    }
    if let Some([low, high]) = scene.motion {
        bounds.add(low, 0);
        bounds.add(high, 0);
    }
    if !bounds.is_empty {
        return bounds.middle();
    }
    if let Some(camera) = scene.camera {
        return camera.description().position;
    }
    index = 0;
    while index < scene.lights.len() {
        if scene.lights[index].sun.is_none() {
            bounds.add(scene.lights[index].position, 0);
        }
        index += 1;
    }
    bounds.middle()
}

/// Returns `radius` enlarged to reach something at distance `away`, if that is not further than
/// `furthest`.
///
/// `furthest` is 0 if the scene has neither shapes nor a plane beside its middle. Then nothing is too
/// far.
const fn accompanied(radius: u128, furthest: u128, away: u128) -> u128 {
    if furthest == 0 || away <= furthest { larger(radius, away) } else { radius }
}

/// Returns the larger of two numbers.
const fn larger(a: u128, b: u128) -> u128 {
    if a > b { a } else { b }
}

/// Returns the smaller of two numbers.
const fn smaller(a: u128, b: u128) -> u128 {
    if a < b { a } else { b }
}

/// Returns the distance of a position to a plane, in the bits of a [`Number`], up to a relative error
/// of 2⁻³⁰.
const fn distance_to_plane(position: Position, plane: &Plane) -> u128 {
    let Some(normal) = plane.normal.direction() else {
        return 0;
    };
    match plane.point.minus(position).leading() {
        None => 0,
        Some((vector, shift)) => {
            let length = vector.dot(normal).unsigned_abs() as u128;
            if shift >= 0 { length << shift } else { length >> -shift }
        }
    }
}
