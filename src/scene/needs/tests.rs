use super::*;
use crate::error::Error;
use crate::error_kind::ErrorKind;
use crate::material::Material;
use crate::scene::{Capacity, Room, RuntimeScene};

type Scenery = RuntimeScene<Room<4, 3, 2, 2, 4, 1, 1>>;

/// Returns the needs of a scene that `fill` has filled.
fn needs<T>(fill: impl FnOnce(&mut Scenery) -> Result<T, Error>) -> Needs {
    let mut scene = Scenery::new();
    fill(&mut scene).unwrap();
    scene.plain().unwrap().parts().needs()
}

const GREY: Material = Material::new([0.5; 3]);

#[test]
fn empty_scene_needs_nothing() {
    let needs = needs(|_| Ok(()));
    assert!(needs.is_nothing());
    assert!(needs.list().iter().all(|need| !need.is_needed));
}

#[test]
fn full_scene_needs_everything() {
    let needs = needs(|scene| {
        let red = scene.add_material(Material::new([0.9, 0.1, 0.1]).specular(0.5, 2.5))?;
        let tiles = GREY.checker([0.5; 3], [1.0; 3]);
        let tiles = scene.add_material(tiles)?;
        let glass = scene.add_material(GREY.mirror(0.5))?;
        scene.add_plane([0, 0, 9], [0, 0, 1], glass)?;
        scene.add_plane([0, 9, 0], [0, 1, 0], glass)?;
        for x in [0, 3] {
            scene.add_sphere([x, 0, 0], 1, red)?;
            scene.add_cylinder([x, 3, 0], [0, 0, 1], 1, 1, glass)?;
        }
        scene.add_disc([0, 3, 1], [0, 0, 1], 1, red)?;
        scene.add_triangle([[0, 3, 2], [1, 3, 2], [0, 4, 2]], None, red)?;
        scene.add_plane([0, 0, -2], [0, 0, 1], tiles)?;
        scene.set_sky([0, 0, 1], [[0.5; 3], [1.0; 3], [0.25; 3]])?;
        // A sun.
        scene.add_light([9000, 9000, 9000], [1, 1, 1])?;
        scene.add_light_with_range([9, 9, 9], [1, 1, 1], 4)
    });
    assert_eq!(needs, Needs::ALL);
    assert!(needs.list().iter().all(|need| need.is_needed));
}

#[test]
fn single_plane_mirrors_nothing_that_is_met_and_is_not_shaded() {
    let mut scene = Scenery::new();
    let glass = scene.add_material(GREY.mirror(0.5)).unwrap();
    scene.add_plane([0, 0, -2], [0, 0, 1], glass).unwrap();
    let dark = scene.plain().unwrap().parts().needs();
    assert_eq!((dark.reflections, dark.mirrored), (1, false));
    scene.add_light([9, 9, 9], [1, 1, 1]).unwrap();
    let lit = scene.plain().unwrap().parts().needs();
    assert_eq!((lit.reflections, lit.shadows), (1, false));
    scene.add_plane([0, 0, 2], [0, 0, 1], glass).unwrap();
    let two = scene.plain().unwrap().parts().needs();
    assert_eq!((two.reflections, two.mirrored), (u8::MAX, true));
    assert!(two.shadows);
}

#[test]
fn highlights_need_a_light_and_a_surface_that_does_not_mirror_all() {
    let shiny = |is_lit: bool, mirror: f64, shininess: f64| {
        needs(|scene| {
            let shiny = GREY.specular(0.5, shininess).mirror(mirror);
            let shiny = scene.add_material(shiny)?;
            scene.add_sphere([0, 0, 0], 1, shiny)?;
            if is_lit { scene.add_light([9, 9, 9], [1, 1, 1]).map(drop) } else { Ok(()) }
        })
    };
    let kind = |needs: Needs| (needs.highlights, needs.shininess);
    assert_eq!(kind(shiny(false, 0.0, 4.0)), (false, Shininess::None));
    assert_eq!(kind(shiny(true, 1.0, 4.0)), (false, Shininess::None));
    assert_eq!(kind(shiny(true, 0.5, 0.0)), (true, Shininess::Even));
    assert_eq!(kind(shiny(true, 0.5, 4.0)), (true, Shininess::Even));
    assert_eq!(kind(shiny(true, 0.5, 5.0)), (true, Shininess::Whole));
    assert_eq!(kind(shiny(true, 0.5, 4.5)), (true, Shininess::Real));
    let mirrors = [0.0, 0.5, 1.0].map(|mirror| shiny(true, mirror, 4.0).mirrors);
    assert_eq!(mirrors, [Mirrors::None, Mirrors::Some, Mirrors::All]);
}

#[test]
fn material_that_no_shape_is_made_of_is_not_counted() {
    let needs = needs(|scene| {
        let grey = scene.add_material(GREY)?;
        scene.add_material(Material::new([0.9, 0.1, 0.1]).mirror(0.5))?;
        scene.add_sphere([0, 0, 0], 1, grey)
    });
    assert_eq!((needs.mirrors, needs.colors), (Mirrors::None, false));
}

#[test]
fn color_of_a_light_or_the_background_is_no_grey() {
    let with = |light: [f64; 3], background: [f64; 3]| {
        needs(|scene| {
            let grey = scene.add_material(GREY)?;
            scene.add_sphere([0, 0, 0], 1, grey)?;
            scene.set_background(background)?;
            scene.add_light([9, 9, 9], light)
        })
    };
    assert!(!with([0.5; 3], [0.25; 3]).colors);
    assert!(with([0.5, 0.5, 0.6], [0.25; 3]).colors);
    assert!(with([0.5; 3], [0.25, 0.3, 0.25]).colors);
}

#[test]
fn suns_and_lamps_are_told_apart() {
    let kinds = |places: &[i32]| {
        let needs = needs(|scene| {
            let grey = scene.add_material(GREY)?;
            for &place in places {
                scene.add_light([place; 3], [1, 1, 1])?;
            }
            scene.add_sphere([0, 0, 0], 1, grey)
        });
        (needs.near_lights, needs.far_lights)
    };
    assert_eq!(kinds(&[]), (false, false));
    assert_eq!(kinds(&[9]), (true, false));
    assert_eq!(kinds(&[9000]), (false, true));
    assert_eq!(kinds(&[9000, 9]), (true, true));
}

#[test]
fn mirroring_planes_are_counted() {
    let planes = |mirrors: &[f64]| {
        let needs = needs(|scene| {
            let glass = scene.add_material(GREY.mirror(0.5))?;
            scene.add_sphere([0, 0, 0], 1, glass)?;
            for (place, mirror) in (2..).zip(mirrors) {
                let wall = scene.add_material(GREY.mirror(*mirror))?;
                scene.add_plane([0, 0, -place], [0, 0, 1], wall)?;
            }
            Ok(())
        });
        (needs.plane_mirrors, needs.facing_mirrors)
    };
    assert_eq!(planes(&[]), (false, false));
    assert_eq!(planes(&[0.0, 0.0]), (false, false));
    assert_eq!(planes(&[0.0, 0.5]), (true, false));
    assert_eq!(planes(&[0.5, 1.0]), (true, true));
}

#[test]
fn bound_names_the_first_need_beyond_it() {
    let all = Needs::ALL;
    assert_eq!(all.within(&all), Ok(()));
    for (bound, need) in [
        (all.without_spheres(), "spheres"),
        (all.without_planes(), "planes"),
        (all.without_cylinders(), "cylinders"),
        (all.without_discs(), "discs"),
        (all.without_triangles(), "triangles"),
        (all.without_lights(), "lights"),
        (all.without_ranges(), "ranges"),
        (all.without_highlights(), "highlights"),
        (all.with_shininess(Shininess::Whole), "shininess"),
        (all.without_mirrors(), "mirrors"),
        (all.without_checkers(), "checkers"),
        (all.without_sky(), "sky"),
        (all.without_colors(), "colors"),
    ] {
        let excess = all.within(&bound).unwrap_err();
        assert_eq!((excess.part(), excess.kind()), (need, ErrorKind::Limit));
        assert!(format!("{excess}").starts_with(&format!("{need}: ")));
        assert_eq!(bound.within(&all), Ok(()));
        assert_eq!(all.both(&bound), bound);
        assert_eq!(bound.both(&all), bound);
    }
}

#[test]
fn room_bounds_every_scene_in_it() {
    let roomy = Needs::of_room(&Room::<4, 3, 2, 2, 4, 1>::COUNTS);
    let scene = needs(|scene| {
        let red = scene.add_material(Material::new([0.9, 0.1, 0.1]).mirror(0.3))?;
        scene.add_plane([0, 0, -2], [0, 0, 1], red)
    });
    assert_eq!(scene.within(&roomy), Ok(()));
}
