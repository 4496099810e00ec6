//! Tests that any valid scene is drawn like the double-precision reference draws it, and that no pixel
//! is further off than its bound.

use std::collections::BTreeSet;

use command_line::{Quality, Settings, Shading, Source};
use embedded_graphics::geometry::Size;
use lost::case::Case;
use lost::families::Family;
use lost::on_all_cores;
use reflet::host::compare::{Difference, compare};
use reflet::host::precision;
use reflet::host::reference::bound::Paths;
use reflet::quality::{Exact, Fast};

#[path = "../../../tests/scenes/held.rs"]
mod held;

use held::{ending, held};

/// Smallest share of the pixels within 8 of the reference in every scene; `WITHIN_1` is that within
/// 1. They are below 1 because a ray at a rim may miss the shape. In most scenes no pixel differs.
const WITHIN_8: f64 = 0.99;
const WITHIN_1: f64 = 0.98;

/// Returns the results of `check` for scenes of a family. Scenes that the library refuses are left out.
fn for_scenes<T: Send>(
    family: Family,
    count: usize,
    check: impl Fn(&Case, &Source) -> T + Sync,
) -> Vec<T> {
    let checked = on_all_cores(count, |number| {
        let case = family.case(1, number as u64);
        let source = case.source().ok()?;
        Some(check(&case, &source))
    });
    let checked: Vec<_> = checked.into_iter().flatten().collect();
    assert!(
        10 * checked.len() > 9 * count,
        "{} of {count}",
        checked.len()
    );
    checked
}

fn are_painted_as_double_precision_paints_them(family: Family, count: usize) {
    const SIZE: Size = Size::new_equal(48);
    let found = for_scenes(family, count, |case, source| {
        let picture = source.drawn(SIZE, case.settings(Quality::Exact));
        let found = compare(&picture, &case.truth(SIZE)).unwrap();
        let is_near = found.within8 >= WITHIN_8 && found.within1 >= WITHIN_1;
        assert!(is_near, "{}: {found:?}", case.name);
        (found, BTreeSet::from_iter(picture.pixels).len())
    });
    let worst =
        |share: fn(&Difference) -> f64| found.iter().map(|it| share(&it.0)).fold(1.0, f64::min);
    let (within8, within1) = (worst(|found| found.within8), worst(|found| found.within1));
    let close = found.iter().filter(|it| it.0.max <= 1).count();
    let seen = found.len();
    println!("{close} of {seen} pictures are within 1 everywhere");
    println!("the worst is within 8 on {within8:.4}, within 1 on {within1:.4} of its pixels");
    // The pictures must show enough for the comparison to be useful.
    let colorful = found.iter().filter(|it| it.1 > 50).count();
    assert!(
        2 * colorful > seen,
        "only {colorful} of {seen} pictures show much"
    );
}

#[test]
fn any_valid_scene_is_painted_as_double_precision_paints_it() {
    are_painted_as_double_precision_paints_them(Family::Any, 800);
    are_painted_as_double_precision_paints_them(Family::Fading, 240);
}

#[test]
#[ignore = "long: more scenes"]
fn many_more_scenes_are_painted_as_double_precision_paints_them() {
    are_painted_as_double_precision_paints_them(Family::Any, 2000);
    are_painted_as_double_precision_paints_them(Family::Fading, 600);
}

/// Only one in this many pixels may exceed its bound, because rounding changed what its path hits.
const MOST_DECIDED: usize = 10_000;

fn no_pixel_is_further_off_than_its_bound(family: Family, count: usize) {
    /// Width and height of a picture in pixels.
    const SIDE: u32 = 32;
    /// Number of reflections after which nothing is left of a path, unless its mirrors reflect all
    /// light.
    const ALL: usize = 200;
    let found = for_scenes(family, count, |case, source| {
        // Normals are not light, so they have no bound.
        let shading = match case.shading {
            Shading::Phong => Shading::Phong,
            _ => Shading::BlinnPhong,
        };
        let (precision, size) = (precision(source.scene()), (SIDE, SIDE));
        let (scene, camera) = (&case.scene, &case.camera);
        let paths = Paths::follow(scene, camera, size, ALL, shading.into(), &precision);
        let held = |quality, ending| {
            let settings = Settings {
                shading,
                ..case.settings(quality)
            };
            let picture = source.drawn(Size::new_equal(SIDE), settings);
            let held = held(&paths, &ending, &picture, ALL);
            assert!(held.broken == 0, "{}: {held:?}", case.name);
            held
        };
        let n = case.reflections;
        [
            held(Quality::Fast, ending::<Fast>(n, SIDE)),
            held(Quality::Exact, ending::<Exact>(n, SIDE)),
        ]
    });
    for quality in [0, 1] {
        let held = found.iter().map(|it| &it[quality]);
        let [all, sure, decided] = held.fold([0; 3], |[all, sure, decided], it| {
            [all + it.pixels, sure + it.sure, decided + it.decided]
        });
        let words = format!("of {all} pixels {sure} are sure, {decided} were decided otherwise");
        println!("{words}");
        assert!(2 * sure > all && MOST_DECIDED * decided < all, "{words}");
    }
}

#[test]
fn no_pixel_of_any_scene_is_further_off_than_its_bound() {
    no_pixel_is_further_off_than_its_bound(Family::Any, 160);
    no_pixel_is_further_off_than_its_bound(Family::Fading, 120);
}

#[test]
#[ignore = "long: more scenes"]
fn no_pixel_of_many_more_scenes_is_further_off_than_its_bound() {
    no_pixel_is_further_off_than_its_bound(Family::Any, 400);
    no_pixel_is_further_off_than_its_bound(Family::Fading, 200);
}
