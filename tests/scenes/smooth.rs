//! Tests smooth edges: against many samples a pixel, in parts of rows, in other qualities, and where a thin rod turns.

use command_line::{Quality, Settings, Source, four_samples};
use embedded_graphics::pixelcolor::Rgb888;
use embedded_graphics::prelude::{RgbColor, Size};
use reflet::host::compare::{Difference, compare};
use reflet::host::file::SceneFile;
use reflet::host::reference::{self, Picture, render, sampled};
use reflet::quality::{Exact, Fast, Small, Smooth};
use reflet::shading::BlinnPhong;
use reflet::{Camera, Material};

use super::near::{self, Scenery};

const SIDE: u32 = 96;
const REFLECTIONS: u32 = 4;

/// The scenes that have an edge.
const NAMES: [&str; 9] = [
    "castle",
    "shading_lights",
    "shading_speculars",
    "columns",
    "mirror1",
    "mirror2",
    "primitives",
    "corner1",
    "cylinders",
];

/// The truth about a scene, and what four samples at every pixel show of it.
struct Judge {
    source: Source,
    truth: Picture,
    four: Picture,
}

impl Judge {
    fn new(name: &str) -> Self {
        Self::of(Source::built_in(name).unwrap())
    }

    fn of(source: Source) -> Self {
        let (scene, camera) = source.reference();
        let shading = reference::Shading::BlinnPhong;
        let truth = sampled(&scene, &camera, [SIDE, SIDE, 9], REFLECTIONS, shading);
        let fine = render(&scene, &camera, 8 * SIDE, 8 * SIDE, REFLECTIONS, shading);
        Self {
            four: four_samples(&fine),
            truth,
            source,
        }
    }

    fn decibels(&self, picture: &Picture) -> f64 {
        let Difference { psnr, .. } = compare(picture, &self.truth).unwrap();
        psnr
    }

    fn drawn(&self, quality: Quality) -> f64 {
        let settings = Settings::blinn_phong(quality, REFLECTIONS as u8);
        self.decibels(&self.source.drawn(Size::new(SIDE, SIDE), settings))
    }
}

#[test]
fn two_rows_are_as_good_as_four_samples_and_four_rows_are_better() {
    for name in NAMES {
        let judge = Judge::new(name);
        let four = judge.decibels(&judge.four);
        let [fast, two, more] =
            [Quality::Fast, Quality::Smooth2, Quality::Smooth4].map(|it| judge.drawn(it));
        println!(
            "{name}: jagged {fast:.1}, four samples {four:.1}, two rows {two:.1}, four rows {more:.1} dB"
        );
        // In a small picture more edges lie between the rows.
        assert!(
            two >= four - 2.0,
            "{name}: {two} with two rows, {four} with four samples"
        );
        assert!(
            more >= four + 2.0,
            "{name}: {more} with four rows, {four} with four samples"
        );
        assert!(
            two >= fast + 4.0,
            "{name}: {two} with two rows, {fast} jagged"
        );
    }
}

#[test]
fn part_of_a_row_has_the_colours_of_the_whole_row() {
    let castle = Source::built_in("castle").unwrap();
    let camera = castle.camera();
    let frame = castle.scene().frame(&camera).quality::<Smooth<2>>();
    let frame = frame.prepare(Size::new(100, 60));
    let rows = frame.on(castle.scene()).unwrap();
    for y in [0, 17, 31, 59] {
        let mut whole = [Rgb888::BLACK; 100];
        rows.row(y, 0, &mut whole);
        for x in [1, 31, 32, 33, 64, 96, 99] {
            let mut part = [Rgb888::BLACK; 100];
            rows.row(y, x, &mut part);
            let count = 100 - x as usize;
            assert_eq!(
                part[..count],
                whole[x as usize..],
                "row {y} from column {x} on"
            );
        }
    }
}

#[test]
fn each_quality_has_smooth_edges() {
    fn drawn<Q: reflet::quality::Quality>() -> Picture {
        let source = Source::built_in("mirror1").unwrap();
        source.painted::<Q, BlinnPhong>(Size::new(80, 60), 4)
    }
    let exact = drawn::<Smooth<2, Exact>>();
    for other in [drawn::<Smooth<2>>(), drawn::<Smooth<2, Small>>()] {
        let found = compare(&other, &exact).unwrap();
        assert!(found.within1 >= 0.998, "{found:?}");
    }
    let jagged = compare(&drawn::<Fast>(), &exact).unwrap();
    assert!(jagged.within1 < 0.9, "{jagged:?}");
}

/// Returns a material that shines by itself, and that no light changes.
fn shining(bright: f64) -> Material {
    Material::new([1.0; 3])
        .ambient(bright)
        .diffuse(0.0)
        .specular(0.0, 1.0)
}

/// The rod is thinner than a pixel, on a black ground, and shines by itself.
#[test]
fn thin_rod_that_turns_covers_the_same_area() {
    let camera = Camera::new([0, -10, 0], [0, 0, 0], [0, 0, 1], 30).unwrap();
    let areas: Vec<f64> = (0..12)
        .map(|step| {
            let angle = f64::from(step) * 7.0_f64.to_radians();
            let mut scene = Scenery::new();
            let white = scene.add_material(shining(1.0)).unwrap();
            let axis = [angle.cos(), 0.0, angle.sin()];
            scene
                .add_cylinder([0, 0, 0], axis, 0.06, 4.0, white)
                .unwrap();
            let scene = scene.build().unwrap();
            let size = Size::new(120, 120);
            let picture = near::drawn::<Smooth<4>, BlinnPhong>(&scene, &camera, size);
            let bytes = picture.pixels.iter().map(|[red, ..]| f64::from(*red));
            bytes.sum::<f64>() / 255.0
        })
        .collect();
    let (least, most) = areas
        .iter()
        .fold((f64::MAX, 0.0_f64), |(least, most), area| {
            (least.min(*area), most.max(*area))
        });
    println!("{least:.1} to {most:.1} pixels");
    // A quarter of a pixel for each of the 89 columns that the rod crosses, at most.
    assert!(most - least <= 0.25 * 89.0, "{areas:?}");
    assert!(most / least < 1.1, "{areas:?}");
}

/// A camera that moves by a sixteenth of a pixel moves an edge by as much: that of a bright disc, and those of a dark rod
/// before it. Samples stand for the area of a pixel, and an upright edge crosses those of its rows at once: two of four
/// with two rows, four of twelve with four.
#[test]
fn camera_that_moves_slowly_changes_no_pixel_by_more_than_the_area_that_moved() {
    let mut scene = Scenery::new();
    let [white, black] = [1.0, 0.0].map(|bright| scene.add_material(shining(bright)).unwrap());
    scene.add_disc([0, 0, 0], [0, 1, 0], 2, white).unwrap();
    scene
        .add_cylinder([0.0, -0.1, 0.0], [0.3, 0.0, 1.0], 0.03, 5.0, black)
        .unwrap();
    let scene = scene.build().unwrap();
    // At this distance 96 pixels are 6 wide.
    let fov = 2.0 * 0.3_f64.atan().to_degrees();
    let camera = |step: u32| {
        let x = f64::from(step) / 256.0;
        Camera::look_at([x, -10.0, 0.0], [x, 0.0, 0.0], [0.0, 0.0, 1.0]).fov(fov)
    };
    let largest_change = |drawn: &dyn Fn(&Camera) -> Picture| {
        let pictures: Vec<Picture> = (0..24).map(|step| drawn(&camera(step))).collect();
        let pairs = pictures.windows(2).flat_map(|pair| {
            let pixels = pair[0].pixels.iter().zip(&pair[1].pixels);
            pixels.map(|(one, other)| one[0].abs_diff(other[0]))
        });
        f64::from(pairs.max().unwrap())
    };
    let size = Size::new(SIDE, SIDE);
    let jagged = largest_change(&|it| near::drawn::<Fast, BlinnPhong>(&scene, it, size));
    let two = largest_change(&|it| near::drawn::<Smooth<2>, BlinnPhong>(&scene, it, size));
    let four = largest_change(&|it| near::drawn::<Smooth<4>, BlinnPhong>(&scene, it, size));
    println!("of 255: {jagged} jagged, {two} with two rows, {four} with four");
    assert_eq!(jagged, 255.0);
    assert!(two <= 255.0 * (1.0 / 16.0 + 2.0 / 4.0), "{two}");
    assert!(four <= 255.0 * (1.0 / 16.0 + 4.0 / 12.0), "{four}");
}

/// A wire and a fence are what jagged edges tear.
#[test]
fn wire_and_fence_are_whole() {
    for name in ["wire", "fence"] {
        let path = format!("{}/examples/scenes/{name}.json", env!("CARGO_MANIFEST_DIR"));
        let (scene, camera) = SceneFile::read(&path, None).unwrap().reference();
        let judge = Judge::of(Source::described(name.to_owned(), scene, camera).unwrap());
        let drawn = [Quality::Fast, Quality::Smooth2, Quality::Smooth4].map(|it| judge.drawn(it));
        println!("{name}: {drawn:.1?} dB");
        assert!(drawn[1] >= drawn[0] + 7.0, "{name}: {drawn:?}");
        assert!(drawn[2] >= drawn[1] + 4.0, "{name}: {drawn:?}");
    }
}
