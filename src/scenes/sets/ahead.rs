//! Tests that paths have the same sum and signature with and without mirror tables.

use crate::Camera;
use crate::accel::light_visibility::LightVisibility;
use crate::accel::mirror_table::MirrorTables;
use crate::accel::mirror_table::tests::{Built, crowd, leaked};
use crate::accel::screen_culling::ScreenCulling;
use crate::accel::{Tables, World};
use crate::color::Sum;
use crate::number::sweep::Sweep;
use crate::ray::PathSignature;
use crate::render::Exact;
use crate::scene::access::SceneAccess;
use crate::scene::shape_set::ShapeSet;
use crate::scene::{Needs, Parts};
use crate::shade::BlinnPhong;
use crate::trace::{Stops, Traced, Tracer};

/// A scene filled at run time with the mirror tables that a constant scene would have.
struct Tabled<'a> {
    scene: &'a Built,
    mirrors: MirrorTables,
}

impl SceneAccess for Tabled<'_> {
    const NEEDS: Needs = <Built as SceneAccess>::NEEDS;
    const CHOOSES_HITS: bool = true;

    fn parts(&self) -> Parts<'_> {
        self.scene.parts()
    }
}

impl World for Tabled<'_> {
    type Room = <Built as World>::Room;
    const IS_CROWD: bool = false;

    fn tables(&self) -> Tables<'_, Self::Room> {
        Tables {
            mirror_tables: &self.mirrors,
            ..self.scene.tables()
        }
    }
}

/// Returns the sum and the signature of the path through each pixel of a 32x32 picture.
fn traced<W: World>(world: &W, camera: &Camera) -> std::vec::Vec<(Sum, PathSignature)> {
    const SIDE: u32 = 32;
    let generator = camera.generator(SIDE, SIDE);
    let from = world.parts().grid.place(camera.description().position);
    let view = LightVisibility::new(world, from);
    let rows = (0..SIDE).flat_map(|y| {
        let row = (from, generator.row_plane(y, from.point));
        let culling = ScreenCulling::new::<true>(None, row, y, true);
        let mut tracer =
            Tracer::<W, BlinnPhong, Exact>::new(world, &view, (culling, *ShapeSet::ALL), 5);
        let directions = generator.row(y);
        let mut pixels = std::vec::Vec::new();
        for x in 0..SIDE {
            let window = tracer.advance(x, x);
            let mut stops = Stops::NONE;
            let Traced { sum, signature } =
                tracer.trace((&window, x), directions.of(x), &mut stops);
            pixels.push((sum, signature));
        }
        pixels
    });
    rows.collect()
}

#[test]
fn paths_come_to_the_same_with_tables_and_without() {
    let mut sweep = Sweep::new(2);
    let mut lit = 0;
    for number in 0..60 {
        let scene = crowd(&mut sweep, number);
        let tabled = Tabled {
            scene: &scene,
            mirrors: leaked(&scene),
        };
        // Every third camera is among the shapes, the others are outside.
        let distance = if number % 3 == 0 { 2.0 } else { 24.0 };
        let camera = Camera::look_at([0.5, -distance, 3.0], [0.0; 3], [0.0, 0.0, 1.0]);
        let [with, without] = [traced(&tabled, &camera), traced(&scene, &camera)];
        assert!(with == without, "{scene:?}");
        lit += with.iter().filter(|(sum, _)| *sum != Sum::ZERO).count();
    }
    assert!(lit > 20_000, "{lit}");
}
