//! Tests that a ball that rays are known to hit first is the one that they hit if all shapes are tested.

use super::*;
use crate::color::Sum;
use crate::ray::PathSignature;

/// Width and height of the pictures.
const SIDES: (u32, u32) = (160, 120);

/// Number of columns from one traced pixel to the next: the fewest between which a ball is looked for.
const LENGTH: u32 = 8;

/// Asserts for every pixel between two on one ball that its path is the same whether the ball is known or not. Returns
/// between how many pairs a ball was known.
fn known_balls<W: World>(world: &W, camera: &Camera, name: &str) -> usize {
    let generator = camera.generator(SIDES.0, SIDES.1);
    let from = world.parts().grid.place(camera.description().position);
    let view = LightVisibility::new(world, from);
    let mut bounds = ScreenBounds::<W::Room>::empty();
    bounds.look(world, &camera.screen_axes(&generator, from.point));
    let mut known = 0;
    for y in 0..SIDES.1 {
        let row = generator.row_plane(y, from.point);
        let culling = ScreenCulling::new::<true>(Some(&bounds), (from, row), y, false);
        let mut tracer =
            Tracer::<W, BlinnPhong, Fast>::new(world, &view, (culling, *ShapeSet::ALL), 3);
        assert!(tracer.finds_balls(), "{name} has too many shapes");
        let directions = generator.row(y);
        for first in (0..SIDES.0 - LENGTH).step_by(LENGTH as usize) {
            let last = first + LENGTH;
            let window = tracer.advance(first, last);
            let traced = |tracer: &mut Tracer<'_, W, _, _>, x, stops: &mut Stops| {
                let pixel = Pixel::Center(&window, x);
                let traced = tracer.trace(pixel, (directions.of(x), None), (stops, true));
                (traced.sum, traced.signature)
            };
            let between =
                |tracer: &mut Tracer<'_, W, _, _>| -> std::vec::Vec<(Sum, PathSignature)> {
                    let mut stops = Stops::NONE;
                    (first + 1..last)
                        .map(|x| traced(tracer, x, &mut stops))
                        .collect()
                };
            let [mut start, mut end] = [Stops::NONE; 2];
            traced(&mut tracer, first, &mut start);
            traced(&mut tracer, last, &mut end);
            let is_known = tracer.find_ball((&window, [first, last]), [&start, &end]);
            known += usize::from(is_known);
            let found = between(&mut tracer);
            tracer.forget_ball();
            let exact = between(&mut tracer);
            assert_eq!(
                found, exact,
                "{name}: after pixel {first}, {y} of {camera:?}"
            );
        }
    }
    known
}

#[test]
fn known_ball_is_the_one_that_rays_hit() {
    let mut random = Sweep::new(0x510e_527f_ade6_82d1);
    let mut known = 0;
    for name in ["mirror1", "mirror2", "primitives", "shading_speculars"] {
        let (scene, camera) = at_run_time(name);
        for azimuth in [0, 40, 100, 200] {
            let camera = camera.orbited(azimuth, 0).unwrap();
            known += known_balls(&scene.tabled(), &camera, name);
        }
    }
    assert!(known > 1000, "{known}");
    for round in 0..40 {
        // A large ball, with small shapes and thin ones around it.
        let (mut scene, glass) = described::<10, 6>(&mut random, (9, 6));
        scene.add_sphere([0.0; 3], 0.5, glass).unwrap();
        let position = random.place().map(|x| 3.0 * x);
        let camera = camera(&mut random, position);
        let name = format!("ball among shapes {round}");
        known += known_balls(&scene.build().unwrap().tabled(), &camera, &name);
    }
    assert!(known > 1500, "{known}");
}
