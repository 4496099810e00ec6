//! Families that are hard because of their planes or cameras: sunk shapes, wide views, mirrors, and what is far away.

use reflet::host::reference::Vector;

use super::draft::{Draft, UP};

/// Makes caps, strips and rivets that barely stick out of one to three planes.
pub fn sunk(draft: &mut Draft) {
    let mut planes = vec![(Vector::ZERO, UP)];
    for _ in 0..draft.random.count(0, 2) {
        let normal = (draft.random.direction() + UP * 0.3).unit();
        planes.push((normal * -2.5, normal));
    }
    for &(point, normal) in &planes {
        let material = draft.any_material();
        draft.plane(point, normal, material);
    }
    for _ in 0..draft.random.count(8, 25) {
        let (point, normal) = draft.random.pick(&planes);
        let across = draft.random.across(normal);
        let place = point + across * draft.random.between(0.0, 2.0);
        let radius = draft.random.log_between(0.1, 4.0);
        let depth = radius * (1.0 - draft.random.log_between(2e-4, 0.2));
        let center = place - normal * depth;
        let material = draft.any_material();
        let axis = draft.random.across(normal);
        match draft.random.count(0, 3) {
            0 => {
                let tilt = draft.random.log_between(1e-3, 0.3);
                let axis = axis + normal * draft.random.pick(&[0.0, 0.0, tilt]);
                let length = draft.random.between(0.5, 4.0);
                draft.cylinder(center, axis, (radius, length), material);
            }
            1 => {
                let tilt = draft.random.pick(&[0.0, 0.02, 0.3]);
                draft.disc(center, axis + normal * tilt, radius, material);
            }
            _ => draft.sphere(center, radius, material),
        }
    }
    if draft.random.chance(0.4) {
        add_rivets(draft);
    }
    draft.lights((1, 2), 8.0);
    draft.usual_camera(1.3);
}

/// Adds rows of equal caps to the plane z = 0.
fn add_rivets(draft: &mut Draft) {
    let (columns, rows) = (draft.random.count(3, 8), draft.random.count(2, 6));
    let radius = draft.random.log_between(0.05, 0.5);
    let depth = radius * (1.0 - draft.random.log_between(1e-3, 0.1));
    let apart = draft.random.between(0.2, 0.5);
    let material = draft.any_material();
    for index in 0..columns * rows {
        let x = (index % columns) as f64 - columns as f64 / 2.0;
        let y = (index / columns) as f64 - rows as f64 / 2.0;
        draft.sphere(Vector([x * apart, y * apart, -depth]), radius, material);
    }
}

/// Makes a room around a camera with a field of view from 90 to 150 degrees.
pub fn wide(draft: &mut Draft) {
    let walls = [
        (UP * -1.0, UP),
        (Vector([0.0, 4.0, 0.0]), Vector([0.1, -1.0, 0.0])),
        (Vector([-4.0, 0.0, 0.0]), Vector([1.0, 0.0, 0.1])),
    ];
    for (point, normal) in walls.into_iter().take(draft.random.count(0, 3)) {
        let material = draft.any_material();
        draft.plane(point, normal, material);
    }
    let (position, view) = (draft.random.point() * 0.4, draft.random.direction());
    for _ in 0..draft.random.count(8, 30) {
        // Most shapes are in front of the camera, many of them near the edges of the picture.
        let toward = (view + draft.random.direction() * 1.2).unit();
        let center = toward * draft.random.between(1.2, 3.5);
        let radius = draft.random.log_between(0.02, 0.6);
        draft.any_shape(center, radius);
    }
    draft.lights((1, 3), 6.0);
    let fov = draft.random.between(90.0, 150.0);
    draft.camera(position + view, view * -1.0, fov);
}

/// Makes one to three flat mirrors and some round ones, among small things, with 1 to 5 reflections.
pub fn mirrors(draft: &mut Draft) {
    draft.reflections = draft.random.count(1, 5) as u8;
    let walls = [
        (Vector::ZERO, UP),
        (Vector([0.0, 3.0, 0.0]), Vector([0.2, -1.0, 0.1])),
        (Vector([-3.0, 0.0, 0.0]), Vector([1.0, 0.1, 0.0])),
    ];
    let count = draft.random.count(1, 3);
    for (point, normal) in walls.into_iter().take(count) {
        let normal = normal + draft.random.point() * 0.1;
        let mirror = draft.random.between(0.3, 1.0);
        let material = draft.material((0.0, 1.0), mirror);
        draft.plane(point, normal, material);
    }
    for _ in 0..draft.random.count(0, 3) {
        let center = draft.random.point() * 1.5 + UP * 1.2;
        let radius = draft.random.between(0.2, 0.8);
        let mirror = draft.random.between(0.3, 1.0);
        let material = draft.material((0.5, 30.0), mirror);
        match draft.random.count(0, 4) {
            0 => draft.any_disc(center, radius, material),
            1 => draft.any_cylinder(center, (radius * 0.5, 2.0 * radius), material),
            _ => draft.sphere(center, radius, material),
        }
    }
    for _ in 0..draft.random.count(2, 12) {
        let center = draft.random.point() * 1.8 + UP * 1.5;
        let radius = draft.random.log_between(0.01, 0.5);
        draft.any_shape(center, radius);
    }
    draft.lights((1, 3), 8.0);
    let (target, distance) = (draft.random.point() + UP, draft.random.between(3.0, 8.0));
    let [x, y, z] = draft.random.direction().0;
    let offset = Vector([x.abs(), -y.abs() - 0.2, z.abs()]).unit() * distance;
    let fov = draft.random.between(30.0, 80.0);
    draft.camera(target, offset, fov);
}

/// Makes a few shapes that are looked at from up to 100 000 units away, with planes and lights that may be as far.
pub fn far(draft: &mut Draft) {
    draft.floor(0.6, Vector::ZERO);
    // Not always so far that nothing is interpolated.
    let furthest = draft.random.pick(&[200.0, 1e5]);
    let distance = draft.random.log_between(8.0, furthest);
    let Vector([x, y, z]) = draft.random.direction();
    let eye = Vector([x, y, z.abs() + 0.05]).unit();
    if draft.random.chance(0.6) {
        let back = draft.any_material();
        let tilt = draft.random.point() * 0.2;
        let behind = draft.random.log_between(10.0, 1e5);
        draft.plane(eye * -behind, eye + tilt, back);
    }
    for _ in 0..draft.random.count(3, 15) {
        let center = draft.random.point() * 1.5 + UP;
        let radius = draft.random.log_between(0.01, 0.8);
        draft.any_shape(center, radius);
    }
    for _ in 0..draft.random.count(0, 5) {
        let (center, axis) = (draft.random.point() * 1.5 + UP, draft.random.direction());
        draft.rod(center, axis, 4.0);
    }
    let lights = draft.random.count(1, 2);
    let away = draft.random.log_between(8.0, 1e5);
    (0..lights).for_each(|_| draft.light(away));
    // From a third of the shapes to twice as much; not below the smallest field of view.
    let width = draft.random.log_between(1.0, 6.0);
    let fov = (2.0 * (width / 2.0 / distance).atan().to_degrees()).max(0.002);
    draft.camera(UP, eye * distance, fov);
}
