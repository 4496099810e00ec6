//! Families that are hard for their light: small highlights and narrow shadows.

use reflet::host::reference::{Light, Vector};

use super::draft::{Draft, UP};

/// Makes planes and round shapes with a shininess from 50 to 100 000 under several lights.
pub fn glossy(draft: &mut Draft) {
    let walls = [
        (Vector::ZERO, UP),
        (Vector([0.0, 3.0, 0.0]), Vector([0.1, -1.0, 0.1])),
    ];
    for (point, normal) in walls.into_iter().take(draft.random.count(1, 2)) {
        let material = gloss(draft);
        draft.plane(point, normal, material);
    }
    for _ in 0..draft.random.count(1, 8) {
        let center = draft.random.point() * 1.5 + UP;
        let radius = draft.random.log_between(0.05, 0.9);
        let material = gloss(draft);
        match draft.random.count(0, 4) {
            0 => draft.any_cylinder(center, (radius * 0.5, 3.0 * radius), material),
            1 => draft.any_disc(center, radius, material),
            _ => draft.sphere(center, radius, material),
        }
    }
    draft.lights((2, 5), 7.0);
    draft.usual_camera(2.0);
}

fn gloss(draft: &mut Draft) -> usize {
    let specular = draft.random.between(0.5, 2.0);
    let shininess = draft.random.log_between(50.0, 1e5);
    let mirror = draft.random.pick(&[0.0, 0.0, 0.3]);
    draft.material((specular, shininess), mirror)
}

/// Makes rows of thin posts on a floor, some with rails and knobs, under one or two low lights.
pub fn fences(draft: &mut Draft) {
    let floor = draft.random.pick(&[0.0, 0.0, 0.0, 0.3]);
    let floor = draft.material((0.0, 1.0), floor);
    draft.plane(Vector::ZERO, UP, floor);
    for _ in 0..draft.random.count(1, 3) {
        add_fence(draft);
    }
    for _ in 0..draft.random.count(1, 2) {
        let angle = draft.random.across(UP);
        let slope = draft.random.log_between(0.04, 0.5);
        let position = (angle + UP * slope) * draft.random.log_between(4.0, 60.0);
        let color = [draft.random.between(0.5, 1.0); 3];
        // A far one is a sun.
        let sun = (position.length() > 20.0).then_some(0.0);
        draft.scene.lights.push(Light {
            position: position.0,
            color,
            sun,
            range: None,
        });
    }
    // As in a scene file.
    draft.scene.lights.sort_by_key(|it| it.sun.is_some());
    let target = draft.random.point().across(UP);
    let offset = draft.random.across(UP) + UP * draft.random.between(0.1, 1.2);
    let distance = draft.random.between(2.5, 6.0);
    let fov = draft.random.between(35.0, 70.0);
    draft.camera(target, offset.unit() * distance, fov);
}

fn add_fence(draft: &mut Draft) {
    let material = draft.material((0.0, 1.0), 0.0);
    let along = draft.random.across(UP);
    let start = draft.random.point().across(UP) * 2.0;
    let (posts, apart) = (draft.random.count(6, 36), draft.random.between(0.08, 0.35));
    let radius = draft.random.log_between(0.004, 0.05);
    let height = draft.random.between(0.3, 1.5);
    let has_knobs = draft.random.chance(0.3);
    for post in 0..posts {
        let foot = start + along * (apart * (post as f64 - posts as f64 / 2.0));
        draft.cylinder(foot + UP * (height / 2.0), UP, (radius, height), material);
        if has_knobs {
            draft.sphere(foot + UP * height, 1.6 * radius, material);
        }
    }
    if draft.random.chance(0.5) {
        let level = height * draft.random.between(0.5, 1.0);
        let length = apart * posts as f64;
        draft.cylinder(start + UP * level, along, (radius, length), material);
    }
}
