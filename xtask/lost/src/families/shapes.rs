//! Families that are hard for their shapes: thin ones, ones that touch, many.

use reflet::host::reference::Vector;

use super::draft::{Draft, UP};

/// Axes of the scene's own coordinates.
const AXES: [Vector; 3] = [Vector([1.0, 0.0, 0.0]), Vector([0.0, 1.0, 0.0]), UP];

/// Makes long thin rods, tiny spheres and small discs, half of the time over a floor.
pub fn thin(draft: &mut Draft) {
    draft.floor(0.5, UP * -0.6);
    let eye = draft.random.direction();
    let eye = Vector([eye.0[0], eye.0[1], eye.0[2].abs()]).unit();
    for _ in 0..draft.random.count(4, 14) {
        let center = draft.random.point() * 1.5 + UP;
        let axis = match draft.random.count(0, 4) {
            0 => draft.random.pick(&AXES),
            1 => {
                let aside = draft.random.across(eye);
                eye + aside * draft.random.log_between(1e-3, 0.3)
            }
            _ => draft.random.direction(),
        };
        draft.rod(center, axis, 6.0);
    }
    for _ in 0..draft.random.count(0, 10) {
        let center = draft.random.point() * 1.5 + UP;
        let radius = draft.random.log_between(0.003, 0.05);
        let material = draft.any_material();
        if draft.random.chance(0.75) {
            draft.sphere(center, radius, material)
        } else {
            draft.any_disc(center, 4.0 * radius, material)
        }
    }
    draft.lights((1, 2), 12.0);
    let distance = draft.random.between(3.0, 7.0);
    let fov = draft.random.between(25.0, 60.0);
    draft.camera(UP, eye * distance, fov);
}

/// Makes a chain of shapes in which each touches or cuts one before it, most of the time on a floor.
pub fn touching(draft: &mut Draft) {
    draft.floor(0.7, Vector::ZERO);
    let radius = draft.random.between(0.3, 1.0);
    let mut chain = vec![(UP * radius, radius)];
    let material = draft.any_material();
    draft.sphere(UP * radius, radius, material);
    for _ in 0..draft.random.count(2, 9) {
        let (center, radius) = draft.random.pick(&chain);
        let direction = draft.random.direction();
        let material = draft.any_material();
        let other = radius * draft.random.log_between(0.1, 1.2);
        // Exactly touching, barely cutting, barely apart, or overlapping.
        let overlap = draft.random.between(0.2, 1.0);
        let share = draft.random.pick(&[1.0, 0.999, 1.001, overlap]);
        let beside = center + direction * ((radius + other) * share);
        match draft.random.count(0, 5) {
            0 => touch_by_rod(draft, (center, radius), material),
            1 => {
                let size = (other, other * draft.random.log_between(0.5, 8.0));
                let axis = draft.random.across(direction);
                draft.cylinder(beside, axis, size, material);
            }
            2 => {
                let reach = radius * draft.random.pick(&[1.0, 0.99, 0.5, 0.0]);
                draft.disc(center + direction * reach, direction, other * 2.0, material);
            }
            _ => {
                draft.sphere(beside, other, material);
                chain.push((beside, other));
            }
        }
    }
    draft.lights((1, 3), 9.0);
    draft.usual_camera(1.3);
}

/// Adds a rod through the middle of a ball, as thick as the ball or thinner, with a lid or without.
fn touch_by_rod(draft: &mut Draft, (center, radius): (Vector, f64), material: usize) {
    let axis = draft.random.direction();
    let thick = radius * draft.random.pick(&[1.0, 0.98, 0.5, 0.1, 0.03]);
    let height = radius * draft.random.between(1.5, 5.0);
    draft.cylinder(center, axis, (thick, height), material);
    if draft.random.chance(0.5) {
        let lid = draft.any_material();
        draft.disc(center + axis * (height / 2.0), axis, thick, lid);
    }
}

/// Makes 20 to 60 shapes of all kinds, half of the time on a floor.
pub fn crowds(draft: &mut Draft) {
    draft.floor(0.5, Vector::ZERO);
    for _ in 0..draft.random.count(20, 60) {
        let center = draft.random.point() * 2.0 + UP * 1.5;
        let radius = draft.random.log_between(0.04, 0.5);
        draft.any_shape(center, radius);
    }
    draft.lights((1, 4), 10.0);
    draft.usual_camera(2.5);
}
