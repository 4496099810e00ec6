//! The bounded shapes in each direction from a light, in three short lists: one for each coordinate of a
//! direction. The quality `Small` reads them; they take less flash than a [`LightTable`](super::light_table).
//!
//! A list divides the range of one coordinate into equal parts. Each part has the set of the shapes that
//! some direction with such a coordinate can hit. A ray can hit only the shapes that are in the sets of all
//! three coordinates. Bound: the radius of each ball is widened as in
//! [`screen_bounds`](super::screen_bounds), and the caps as in [`cap`](super::cap).

use super::cap::Cap;
use super::screen_axis::widened;
use crate::light::PreparedLight;
use crate::number::{difference_modulo_2_32, offset_modulo_2_32, to_u32};
use crate::scene::Parts;
use crate::scene::shape_set::{SetLayout, ShapeSet};
use crate::vector::{Direction, Point};

/// Number of parts of the range of one coordinate.
const PARTS: usize = 6;

/// The bounded shapes in each direction from one light.
#[derive(Clone, Copy, Debug)]
pub struct LightLists([Coordinate; 3]);

/// The bounded shapes that lie in directions with each value of one coordinate.
#[derive(Clone, Copy, Debug)]
struct Coordinate {
    /// Smallest coordinate of a direction to a shape, as [`raised`] returns it.
    low: u32,
    /// The set of a coordinate has the index ([`raised`] coordinate - `low`) >> `shift`.
    shift: u32,
    sets: [ShapeSet; PARTS],
}

/// More than the largest coordinate of a direction, Q2.30: it may exceed one by a few last places.
const MOST: i32 = (1 << 30) + SLACK;

/// What a range is widened by, because a cap ends at one.
const SLACK: i32 = 64;

/// Range of a coordinate that holds all directions.
const ALL: (i32, i32) = (-MOST, MOST);

/// Returns a coordinate counted from the smallest one.
#[inline(always)]
const fn raised(value: i32) -> u32 {
    offset_modulo_2_32(value, MOST)
}

impl Coordinate {
    /// Creates empty sets for the values from `low` to `high`.
    const fn new((low, high): (i32, i32)) -> Self {
        let mut shift = 0;
        while difference_modulo_2_32(raised(high), raised(low)) >> shift >= to_u32(PARTS) {
            shift += 1;
        }
        Self {
            low: raised(low),
            shift,
            sets: [ShapeSet::NONE; PARTS],
        }
    }

    /// Returns the index of the set of a value. It is [`PARTS`] or more if no shape has that value.
    #[inline(always)]
    const fn part(&self, value: i32) -> usize {
        (difference_modulo_2_32(raised(value), self.low) >> (self.shift & 31)) as usize
    }

    /// Adds a shape to the sets of the values from `low` to `high`.
    const fn add(&mut self, (low, high): (i32, i32), shape: ShapeSet) {
        let mut part = self.part(low);
        while part <= self.part(high) {
            self.sets[part] = self.sets[part].with(shape);
            part += 1;
        }
    }
}

/// Returns the smallest and the largest value of one coordinate in the directions from a light to all
/// shapes.
const fn range(light: Point, parts: &Parts<'_>, axis: usize) -> (i32, i32) {
    let (mut low, mut high) = (MOST, -MOST);
    let mut number = 0;
    while let Some((ball, _)) = parts.link(number) {
        let own = ball_range(light, ball, axis);
        low = if own.0 < low { own.0 } else { low };
        high = if own.1 > high { own.1 } else { high };
        number += 1;
    }
    if low < high { (low, high) } else { ALL }
}

/// Returns one coordinate of the directions from a light: its range in parts, and the shapes that each part can hit.
const fn coordinate(light: Point, parts: &Parts<'_>, axis: usize) -> Coordinate {
    let layout = SetLayout::new(parts.lengths());
    let mut found = Coordinate::new(range(light, parts, axis));
    let mut number = 0;
    while let Some((ball, shape)) = parts.link(number) {
        let own = ball_range(light, ball, axis);
        found.add(own, layout.set_of(shape));
        number += 1;
    }
    found
}

/// Returns the smallest and the largest value of one coordinate in the directions from a light that hit a ball.
const fn ball_range(light: Point, (center, radius): (Point, i32), axis: usize) -> (i32, i32) {
    let (direction, distance) = light.to(center).direction_and_length();
    let (radius, distance) = (widened(radius), distance.to_bits());
    if distance <= radius {
        return ALL;
    }
    let (low, high) = Cap::new(direction, radius, distance).range(axis);
    (low - SLACK, high + SLACK)
}

impl LightLists {
    /// Lists that hold every shape in every direction.
    const ALL: Self = {
        let mut all = Coordinate::new(ALL);
        all.add(ALL, *ShapeSet::ALL);
        Self([all; 3])
    };

    /// Makes the lists of a light. If the light is far, or if a shape moves, every direction holds every
    /// shape.
    const fn of_light(light: &PreparedLight, parts: &Parts<'_>) -> Self {
        if !light.place.is_near() || parts.moving.meets(*ShapeSet::ALL) {
            return Self::ALL;
        }
        Self([
            coordinate(light.place.point, parts, 0),
            coordinate(light.place.point, parts, 1),
            coordinate(light.place.point, parts, 2),
        ])
    }

    /// Makes the lists of all lights of a scene, in their order.
    pub(crate) const fn of_lights<const L: usize>(parts: &Parts<'_>) -> [Self; L] {
        let mut lists = [Self::ALL; L];
        let mut index = 0;
        while index < parts.lights.len() && index < L {
            lists[index] = Self::of_light(&parts.lights[index], parts);
            index += 1;
        }
        lists
    }

    /// Returns the shapes that a ray from the light in a direction can hit.
    #[inline(never)]
    pub(crate) fn at(&self, direction: Direction) -> ShapeSet {
        let mut set = *ShapeSet::ALL;
        for (coordinate, value) in self.0.iter().zip(direction.components()) {
            let own = coordinate.sets.get(coordinate.part(value.to_bits()));
            set = set.common(own.copied().unwrap_or(ShapeSet::NONE));
        }
        set
    }
}
