//! Tests: the tables of lights and mirrors change no bit of a built-in scene's paths.

use super::*;
use crate::accel::{Culling, CullingQuality};
use crate::color::Sum;
use crate::shade::LightQuality;
use crate::trace::PathQuality;

/// As [`Fine`], with or without tables.
struct With<const LIGHT_TABLES: bool, const MIRROR_TABLES: bool>;

impl<const L: bool, const M: bool> LightQuality for With<L, M> {
    const IS_PRECISE: bool = <Fine as LightQuality>::IS_PRECISE;
}

impl<const L: bool, const M: bool> CullingQuality for With<L, M> {
    const CULLING: Culling = Culling {
        light_tables: L,
        mirror_tables: M,
        ..Culling::ALL
    };
}

impl<const L: bool, const M: bool> PathQuality for With<L, M> {
    const SMALLEST_WEIGHT: Unit = <Fine as PathQuality>::SMALLEST_WEIGHT;
}

/// What the paths through all pixels come to, with every shape asked for in every column.
fn traced<W: World, Q: PathQuality>(
    world: &W,
    camera: &Camera,
) -> std::vec::Vec<(Sum, PathSignature)> {
    let generator = camera.generator(SIZE.0, SIZE.1);
    let from = world.parts().grid.place(camera.description().position);
    let view = LightVisibility::new(world, from);
    let rows = (0..SIZE.1).flat_map(|y| {
        let culling = ScreenCulling::new::<true>(None, from, y, true);
        let mut tracer = Tracer::<W, BlinnPhong, Q>::new(world, &view, culling, 5);
        let directions = generator.row(y);
        let pixels = (0..SIZE.0).map(|x| {
            let window = tracer.advance(x, x);
            let traced = tracer.trace((&window, x), directions.of(x));
            (traced.sum, traced.signature)
        });
        pixels.collect::<std::vec::Vec<_>>()
    });
    rows.collect()
}

#[test]
fn paths_in_built_in_scenes_come_to_the_same_without_tables() {
    struct Paths;
    impl Visitor for Paths {
        /// Whether it has tables of lights, and of mirrors.
        type Output = [bool; 2];
        fn visit<S: BuiltIn>(self) -> [bool; 2] {
            let world = &Static::<S>::new();
            let all = traced::<_, With<true, true>>(world, &S::CAMERA);
            let others = [
                traced::<_, With<false, true>>(world, &S::CAMERA),
                traced::<_, With<true, false>>(world, &S::CAMERA),
            ];
            assert!(others.iter().all(|it| *it == all), "{}", S::NAME);
            let needs = <Static<S> as SceneAccess>::NEEDS;
            [needs.sets, <Static<S> as SceneAccess>::CHOOSES_HITS]
        }
    }
    let found = NAMES.map(|name| visit(name, Paths).expect("a built-in scene"));
    for table in [0, 1] {
        assert!(found.iter().any(|tables| tables[table]), "{found:?}");
    }
}
