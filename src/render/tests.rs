//! Tests of frames whose rows need no tracing, or seem to need none, and of how few pixels are traced.

use super::FrameBuilder;
use crate::camera::Camera;
use crate::material::Material;
use crate::qualities::{Exact, Fast, Quality};
use crate::scene::{Room, RuntimeScene};
use crate::shade::BlinnPhong;

type Still = RuntimeScene<Room<1, 1, 0, 1, 2>>;

#[test]
fn scene_of_nothing_but_a_sky_shows_it() {
    let mut scene = RuntimeScene::<Room<1, 0, 0, 0, 0>>::new();
    let [below, horizon, above] = [[0.0; 3], [0.5; 3], [1.0; 3]];
    scene.set_sky([0, 0, 1], [below, horizon, above]).unwrap();
    let scene = scene.build().unwrap();
    let camera = Camera::look_at([0.0; 3], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]).fov(90.0);
    let frame = FrameBuilder::<_, Fast, BlinnPhong>::new(&scene, &camera).prepared(9, 9);
    let shown = [0, 4, 8].map(|y| {
        let mut row = [0; 9];
        let report =
            frame
                .unchanged(&scene)
                .fill_row(y, 0, &mut row, (None, |sum| sum.to_rgb8()[0]));
        assert!(report.rays > 0);
        row[4]
    });
    // The middle of the first row is seen at atan(8 / 9) above the horizon.
    assert_eq!(shown, [212, 128, 43]);
}

/// Returns the brightness of the pixels of a picture with 240 columns and 24 rows, and the number of its rays.
fn drawn<Q: Quality>(scene: &Still, camera: &Camera) -> ([[u8; 240]; 24], u64) {
    let scene = scene.build().unwrap();
    let frame = FrameBuilder::<_, Fast, BlinnPhong>::new(&scene, camera);
    let frame = frame.quality::<Q>().prepared(240, 24);
    let (mut rows, mut rays) = ([[0; 240]; 24], 0);
    for (y, row) in (0..).zip(&mut rows) {
        let shown = (None, |sum: crate::color::Sum| sum.to_rgb8()[0]);
        rays += frame.unchanged(&scene).fill_row(y, 0, row, shown).rays;
    }
    (rows, rays)
}

/// Returns the share of the rays of `Exact` that `Fast` takes, and asserts that no pixel is off by more than 1.
fn share_of_rays(scene: &Still, camera: &Camera) -> f64 {
    let ((fast, few), (exact, many)) =
        (drawn::<Fast>(scene, camera), drawn::<Exact>(scene, camera));
    let mut pixels = fast.iter().flatten().zip(exact.iter().flatten());
    assert!(pixels.all(|(one, other)| one.abs_diff(*other) <= 1));
    few as f64 / many as f64
}

/// Returns a scene with a ball of radius 1 at the origin and a lamp.
fn ball() -> Still {
    let mut scene = Still::new();
    let red = Material::new([0.8, 0.3, 0.2])
        .ambient(0.2)
        .diffuse(0.6)
        .specular(0.3, 8.0);
    let red = scene.add_material(red).unwrap();
    scene.add_sphere([0, 0, 0], 1, red).unwrap();
    scene.add_light([-9, -14, 12], [1, 1, 1]).unwrap();
    scene
}

#[test]
fn cells_of_a_checker_on_a_plane_divide_no_stretch() {
    let mut scene = ball();
    let tiles = Material::new([1.0; 3]).checker([0.2; 3], [2.0, 2.0, 0.0]);
    let tiles = scene.add_material(tiles).unwrap();
    scene.add_plane([0, 0, -5], [0, 0, 1], tiles).unwrap();
    let camera = Camera::look_at([0.0, -10.0, -3.0], [0.0, 0.0, -7.0], [0.0, 0.0, 1.0]).fov(40.0);
    let share = share_of_rays(&scene, &camera);
    assert!(share < 0.05, "{share}");
}

#[test]
fn view_through_a_telescope_is_interpolated() {
    let mut scene = ball();
    let camera = Camera::look_at([0.0, -1000.0, 0.0], [0.0; 3], [0.0, 0.0, 1.0]).fov(0.14);
    scene.set_camera(camera);
    let share = share_of_rays(&scene, &camera);
    assert!(share < 0.3, "{share}");
}
