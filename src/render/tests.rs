//! Tests of frames whose rows need no tracing, or seem to need none.

use super::FrameBuilder;
use crate::camera::Camera;
use crate::scene::{Room, RuntimeScene};
use crate::shade::BlinnPhong;

#[test]
fn scene_of_nothing_but_a_sky_shows_it() {
    let mut scene = RuntimeScene::<Room<1, 0, 0, 0, 0>>::new();
    let [below, horizon, above] = [[0.0; 3], [0.5; 3], [1.0; 3]];
    scene.set_sky([0, 0, 1], [below, horizon, above]).unwrap();
    let scene = scene.build().unwrap();
    let camera = Camera::look_at([0.0; 3], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]).fov(90.0);
    let frame = FrameBuilder::<_, super::Fast, BlinnPhong>::new(&scene, &camera).prepared(9, 9);
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
