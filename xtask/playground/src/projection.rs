//! Where a picture shows a point of the scene. In doubles: it only places marks over the picture.

use reflet::host::reference::Camera;

pub(crate) struct Projection {
    position: [f64; 3],
    forward: [f64; 3],
    right: [f64; 3],
    up: [f64; 3],
    /// Distance of the picture from the camera, in pixels.
    distance: f64,
    size: [f64; 2],
}

impl Projection {
    pub(crate) fn new(camera: &Camera, size: [u32; 2]) -> Self {
        let size = size.map(f64::from);
        let forward = unit(minus(camera.target, camera.position));
        let right = unit(cross(forward, camera.up));
        Self {
            position: camera.position,
            forward,
            right,
            up: cross(right, forward),
            distance: size[0] / 2.0 / tangent(camera.fov.to_radians() / 2.0),
            size,
        }
    }

    /// Returns where the picture shows a point, in pixels from its left top corner; `None` behind the camera.
    pub(crate) fn seen(&self, point: [f64; 3]) -> Option<[f64; 2]> {
        let way = minus(point, self.position);
        let ahead = dot(way, self.forward);
        let place = |axis, half| half + dot(way, axis) / ahead * self.distance;
        let [width, height] = self.size;
        let down = self.up.map(|it| -it);
        (ahead > 0.0).then(|| [place(self.right, width / 2.0), place(down, height / 2.0)])
    }
}

/// Returns the tangent of an angle between 0 and a right angle, by Lambert's continued fraction
/// x / (1 - x² / (3 - x² / (5 - ...))). The tangent of `std` would take 3 KB more: it reduces large angles.
fn tangent(angle: f64) -> f64 {
    let odd_numbers = (1..12).rev().map(|it| f64::from(2 * it + 1));
    let below = odd_numbers.fold(0.0, |below, odd| angle * angle / (odd - below));
    angle / (1.0 - below)
}

fn minus(one: [f64; 3], other: [f64; 3]) -> [f64; 3] {
    [0, 1, 2].map(|axis| one[axis] - other[axis])
}

fn dot(one: [f64; 3], other: [f64; 3]) -> f64 {
    one[0] * other[0] + one[1] * other[1] + one[2] * other[2]
}

fn cross([a, b, c]: [f64; 3], [x, y, z]: [f64; 3]) -> [f64; 3] {
    [b * z - c * y, c * x - a * z, a * y - b * x]
}

fn unit(way: [f64; 3]) -> [f64; 3] {
    let length = dot(way, way).sqrt();
    way.map(|it| it / length)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn tangent_is_that_of_the_standard_library() {
        for degrees in 1..=89 {
            let angle = f64::from(degrees).to_radians();
            let error = tangent(angle) / angle.tan() - 1.0;
            assert!(error.abs() < 1e-12, "{degrees} degrees: {error}");
        }
    }

    #[test]
    fn picture_shows_the_target_in_its_middle_and_nothing_behind_the_camera() {
        let camera = Camera {
            position: [0.0, -5.0, 0.0],
            target: [0.0; 3],
            up: [0.0, 0.0, 1.0],
            fov: 90.0,
        };
        let projection = Projection::new(&camera, [64, 48]);
        assert_eq!(projection.seen([0.0; 3]), Some([32.0, 24.0]));
        let [x, y] = projection.seen([5.0, 0.0, 2.5]).unwrap();
        assert!((x - 64.0).abs() < 1e-9 && (y - 8.0).abs() < 1e-9);
        assert_eq!(projection.seen([0.0, -6.0, 0.0]), None);
    }
}
