//! Chooses a scene's grid: where its middle is and how fine its steps are. Integers only, by the
//! compiler or at run time.

use super::Description;
use crate::fault::Fault;
use crate::grid::Grid;
use crate::number::{Number, unsigned, unsigned_128};
use crate::shape::plane::Plane;
use crate::vector::Position;

/// The room that is left for companions and planes where it can be had, in steps: this much at least
/// for the smallest radius or half height, and for epsilon.
const FINE: u32 = 14;
const FINE_EPSILON: u32 = 6;

/// A light, camera or plane within this many radii of the shapes is given its place in the ball:
/// rays to what is near are short. What is further out is kept as a far place, so that a distant sun
/// costs the shapes no bits; these at most 5, and none that small shapes or epsilon need. A scene of
/// planes alone goes by the nearest plane.
const COMPANIONS: u128 = 32;

/// How many times larger than it need be the ball of a scene with planes is, so that most of what is
/// seen of them is near: 3 bits, where small shapes or epsilon do not need them.
const EXPANSE: u128 = 8;

/// The same for a scene of planes alone, which has no shape to see less exactly.
const EXPANSE_OF_PLANES: u128 = 256;

/// How many times as large as epsilon a scene of planes alone is at least.
const LEAST_EPSILONS: u128 = 1 << 9;

/// The box around what has been added so far.
struct Bounds {
    low: [i128; 3],
    high: [i128; 3],
    is_empty: bool,
}

impl Bounds {
    const EMPTY: Self = Self {
        low: [0; 3],
        high: [0; 3],
        is_empty: true,
    };

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

/// At least the distance of two positions, in the bits of a [`Number`].
const fn distance(from: Position, to: Position) -> u128 {
    match to.minus(from).leading() {
        None => 0,
        Some((vector, shift)) => {
            let length = unsigned(vector.direction_and_length().1.to_bits() + 2) as u128;
            if shift >= 0 {
                length << shift
            } else {
                (length >> -shift) + 1
            }
        }
    }
}

/// Puts the middle of the scene in the middle of its shapes, and chooses the finest step that
/// holds them and what stands near them.
pub(super) const fn choose_grid(scene: &Description<'_>) -> Result<Grid, Fault> {
    let middle = middle_of(scene);
    let is_bounded = scene.extent(0).is_some();
    let shapes = match is_bounded {
        true => radius_around(middle, scene),
        false => nearest_plane(middle, scene.planes),
    };
    let room = room_of(scene);
    let furthest = smaller(COMPANIONS * shapes, larger(shapes, room));
    let mut radius = with_companions(scene, middle, shapes, furthest);
    if radius == 0 {
        radius = 1 << 64;
    }
    if !is_bounded {
        // Nothing but the camera's place tells its size: epsilon is small beside it.
        let epsilon = unsigned_128(scene.epsilon.to_bits());
        radius = larger(radius, epsilon * LEAST_EPSILONS);
    }
    if !scene.planes.is_empty() {
        let expanse = match is_bounded {
            true => EXPANSE,
            false => EXPANSE_OF_PLANES,
        };
        radius = larger(radius, smaller(radius * expanse, room));
    }
    if radius < 1 << 34 {
        Err(Fault::Extent)
    } else {
        Ok(Grid::new(middle, radius))
    }
}

/// The radius of a ball around `middle` that holds the bounded shapes.
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

/// `radius` enlarged for the lights, the camera and the planes, as far as [`accompanied`] allows.
const fn with_companions(
    scene: &Description<'_>,
    middle: Position,
    mut radius: u128,
    furthest: u128,
) -> u128 {
    let mut index = 0;
    while index < scene.lights.len() {
        let away = distance(middle, scene.lights[index].position);
        radius = accompanied(radius, furthest, away);
        index += 1;
    }
    if let Some(camera) = scene.camera {
        let away = distance(middle, camera.description().position);
        radius = accompanied(radius, furthest, away);
    }
    index = 0;
    while index < scene.planes.len() {
        let away = distance_to_plane(middle, &scene.planes[index]);
        radius = accompanied(radius, furthest, away);
        index += 1;
    }
    radius
}

/// The radius of the largest ball in which the smallest shape and epsilon have the steps that are
/// wanted.
const fn room_of(scene: &Description<'_>) -> u128 {
    let mut room = unsigned_128(scene.epsilon.to_bits()) << (28 - FINE_EPSILON);
    let mut index = 0;
    while let Some(extent) = scene.extent(index) {
        let size = unsigned_128(extent.smallest.to_bits());
        room = smaller(room, size << (28 - FINE));
        index += 1;
    }
    room
}

/// The distance to the nearest plane that does not go through `middle`; 0 where there is none.
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

/// The middle of the shapes; where there are none, the camera, and without one the middle of the
/// lights.
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
        bounds.add(scene.lights[index].position, 0);
        index += 1;
    }
    bounds.middle()
}

/// `radius` enlarged for something `away`, unless that is further away than what is `furthest`;
/// where there are no shapes, that is 0, and nothing is too far.
const fn accompanied(radius: u128, furthest: u128, away: u128) -> u128 {
    if furthest == 0 || away <= furthest {
        larger(radius, away)
    } else {
        radius
    }
}

const fn larger(a: u128, b: u128) -> u128 {
    if a > b { a } else { b }
}

const fn smaller(a: u128, b: u128) -> u128 {
    if a < b { a } else { b }
}

/// The distance of a position to a plane, in the bits of a [`Number`], but for 2⁻³⁰ of it.
const fn distance_to_plane(position: Position, plane: &Plane) -> u128 {
    let Some(normal) = plane.normal.direction() else {
        return 0;
    };
    match plane.point.minus(position).leading() {
        None => 0,
        Some((vector, shift)) => {
            let length = vector.dot(normal).unsigned_abs() as u128;
            if shift >= 0 {
                length << shift
            } else {
                length >> -shift
            }
        }
    }
}
