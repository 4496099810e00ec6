use super::*;
use crate::number::Length;
use crate::vector::Vector;

/// Opposite directions along an axis, each a few last places longer than one.
fn opposite() -> [Direction; 2] {
    [1, -1].map(|sign| Direction::from_raw(Vector::new(sign * ((1 << 30) + 3), 0, 0)))
}

#[test]
fn opposite_normals_turn_too_much() {
    let across = Direction::from_raw(Vector::new(0, 0, 1 << 30));
    assert!(turn_in_plane(opposite(), across).is_none());
}

#[test]
fn light_between_two_places_turns_too_much() {
    let places = [ScaledPoint::ORIGIN; 2];
    let rays = Rays {
        apex: ScaledPoint::ORIGIN,
        places,
        ends: opposite(),
        reaches: [Length::from_bits(1 << 20); 2],
    };
    assert_eq!(rays.turn(), Unit::ONE);
}
