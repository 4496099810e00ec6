//! Families of triangles: meshes, flat and smooth, and needles.

use reflet::host::reference::Vector;

use super::draft::{Draft, UP};

/// Makes pyramids, strips and needles over a floor, among round shapes.
pub fn facets(draft: &mut Draft) {
    draft.floor(0.8, Vector::ZERO);
    for _ in 0..draft.random.count(1, 4) {
        let center = draft.random.point() * 1.5 + UP;
        match draft.random.count(0, 2) {
            0 => needle(draft, center),
            1 => strip(draft, center),
            _ => pyramid(draft, center),
        }
    }
    for _ in 0..draft.random.count(0, 2) {
        let center = draft.random.point() * 1.5 + UP;
        let radius = draft.random.between(0.2, 0.7);
        draft.any_shape(center, radius);
    }
    draft.lights((1, 2), 6.0);
    draft.usual_camera(1.5);
}

/// Adds the closed mesh of a pyramid of 3 to 6 sides, flat or smooth.
fn pyramid(draft: &mut Draft, center: Vector) {
    let (sides, radius) = (draft.random.count(3, 6), draft.random.between(0.3, 1.0));
    let up = draft.random.direction();
    let aside = draft.random.across(up);
    let ahead = up.cross(aside);
    let tip = center + up * draft.random.between(0.3, 1.8);
    let is_smooth = draft.random.chance(0.3);
    let material = draft.any_material();
    let corner = |index: usize| {
        let (sine, cosine) = (std::f64::consts::TAU * index as f64 / sides as f64).sin_cos();
        center + (aside * cosine + ahead * sine) * radius
    };
    for index in 0..sides {
        let corners = [corner(index), corner((index + 1) % sides), tip];
        let normals = corners.map(|it| (it - center + up * 0.2).unit());
        draft.triangle(corners, is_smooth.then_some(normals), material);
        let base = [corners[1], corners[0], center];
        draft.triangle(base, None, material);
    }
}

/// Adds a bent strip of triangles that share edges.
fn strip(draft: &mut Draft, center: Vector) {
    let material = draft.any_material();
    let along = draft.random.direction();
    let aside = draft.random.across(along) * draft.random.log_between(0.02, 0.8);
    let mut corners = [center, center + aside];
    for _ in 0..draft.random.count(2, 8) {
        let next = corners[0] + along * 0.5 + draft.random.point() * 0.3;
        draft.triangle([corners[0], corners[1], next], None, material);
        corners = [corners[1], next];
    }
}

/// Adds a triangle that is up to 1000 times as long as wide.
fn needle(draft: &mut Draft, center: Vector) {
    let along = draft.random.direction();
    let length = draft.random.between(0.5, 3.0);
    let width = length * draft.random.log_between(1e-3, 0.1);
    let end = center + along * length;
    let beside = center + draft.random.across(along) * width;
    let material = draft.any_material();
    draft.triangle([center, end, beside], None, material);
}
