//! Tests smooth edges: against many samples a pixel, in parts of rows, in other qualities, and where a thin rod turns.

use command_line::{Chosen, Quality, Settings, Source, four_samples};
use embedded_graphics::pixelcolor::Rgb888;
use embedded_graphics::prelude::{Dimensions, Point, PointsIter, RgbColor, Size};
use embedded_graphics::primitives::Rectangle;
use embedded_graphics_simulator::SimulatorDisplay;
use reflet::host::compare::{Difference, compare};
use reflet::host::reference::{self, Picture, render, sampled};
use reflet::quality::{self, Exact, Fast, Seam, Small, Smooth};
use reflet::scenes::NAMES;
use reflet::shading::BlinnPhong;
use reflet::{Camera, Material, MaterialId};

use super::near::{self, Scenery};

const SIDE: u32 = 96;
const REFLECTIONS: u32 = 4;

/// The truth about a scene, and what four samples at every pixel show of it.
struct Judge {
    source: Source,
    truth: Picture,
    four: Picture,
}

impl Judge {
    fn new(source: Source) -> Self {
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
fn smooth_edges_are_as_good_as_four_samples_and_smoother_ones_are_better() {
    // All other scenes have edges.
    let has_edges = |name: &&str| !["empty", "floor"].contains(name);
    for name in NAMES.into_iter().filter(has_edges) {
        let judge = Judge::new(Source::built_in(name).unwrap());
        let four = judge.decibels(&judge.four);
        let [fast, two, more] =
            [Quality::Fast, Quality::Smooth2, Quality::Smooth4].map(|it| judge.drawn(it));
        println!(
            "{name}: jagged {fast:.1}, four samples {four:.1}, Smooth<2> {two:.1}, Smooth<4> {more:.1} dB"
        );
        // Small pictures are full of edges. In corner1 all are faint, and those of low contrast are found less finely.
        assert!(two >= (four - 2.0).min(48.0), "{name}: Smooth<2>");
        assert!(more >= (four + 2.0).min(54.5), "{name}: Smooth<4>");
        assert!(two >= fast + 4.0, "{name}: Smooth<2> and jagged");
    }
}

/// Tests that rows alone, rows one after the other and parts of rows have the same colours: `Q` is the quality.
fn assert_same_however_drawn<Q: quality::Quality>(source: &Source, [width, height]: [u32; 2]) {
    let (scene, camera, size) = (source.scene(), source.camera(), Size::new(width, height));
    let frame = scene.frame(&camera).quality::<Q>().prepare(size);
    let rows = frame.on(scene).unwrap();
    let mut display = SimulatorDisplay::<Rgb888>::new(size);
    let area = display.bounding_box();
    rows.draw_area(area, Point::zero(), &mut display).unwrap();
    let (mut short, mut long) = (Seam::<1>::new(), Seam::<12>::new());
    for y in 0..height {
        let mut found = [(); 3].map(|()| vec![Rgb888::BLACK; width as usize]);
        let [alone, narrow, wide] = &mut found;
        rows.row(y, 0, alone);
        rows.next_row(&mut short, y, 0, narrow);
        rows.next_row(&mut long, y, 0, wide);
        let line = Rectangle::new(Point::new(0, y as i32), Size::new(width, 1));
        let drawn: Vec<_> = line.points().map(|it| display.get_pixel(it)).collect();
        let are_same = alone == narrow && alone == wide && *alone == drawn;
        assert!(are_same, "row {y} of {width} columns");
        for x in [1, 31, 32, 33, 64, 96] {
            let mut part = vec![Rgb888::BLACK; width.saturating_sub(x) as usize];
            rows.row(y, x, &mut part);
            let whole = alone.get(x as usize..).unwrap_or_default();
            assert!(part == whole, "row {y} of {width} columns, from {x} on");
        }
    }
}

/// The last width is beyond what a picture drawn at once keeps. `cylinders` has no plane, so parts of its rows are clear.
#[test]
fn rows_have_the_same_colours_however_they_are_drawn() {
    for name in ["castle", "cylinders", "mirror2"] {
        let source = Source::built_in(name).unwrap();
        for size in [[1, 3], [33, 20], [100, 60], [176, 30], [340, 9]] {
            assert_same_however_drawn::<Smooth<2>>(&source, size);
            assert_same_however_drawn::<Smooth<4>>(&source, size);
        }
        assert_same_however_drawn::<Smooth<4, Exact>>(&source, [70, 12]);
        assert_same_however_drawn::<Smooth<2, Small>>(&source, [70, 12]);
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
        assert!(found.within1 >= 0.996, "{found:?}");
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
            let rod = scene.add_cylinder([0, 0, 0], axis, 0.06, 4.0, white);
            rod.unwrap();
            let scene = scene.build().unwrap();
            let size = Size::new(120, 120);
            let picture = near::drawn::<Smooth<4>, BlinnPhong>(&scene, &camera, size);
            let bytes = picture.pixels.iter().map(|[red, ..]| f64::from(*red));
            bytes.sum::<f64>() / 255.0
        })
        .collect();
    let least = areas.iter().copied().fold(f64::MAX, f64::min);
    let most = areas.iter().copied().fold(0.0, f64::max);
    println!("{least:.1} to {most:.1} pixels");
    // The rod crosses at most 89 columns or rows. Each may be off by at most a quarter of a pixel.
    assert!(most - least <= 0.25 * 89.0, "{areas:?}");
    assert!(most / least < 1.02, "{areas:?}");
}

/// A camera that moves by a sixteenth of a pixel moves an edge by as much: that of a bright disc, and those of a dark rod
/// before it. An edge is found to an eighth of a pixel with `Smooth<2>`, and to a sixteenth with `Smooth<4>`; two edges
/// cross a pixel of the rod.
#[test]
fn camera_that_moves_slowly_changes_no_pixel_by_more_than_the_area_that_moved() {
    let mut scene = Scenery::new();
    let [white, black] = [1.0, 0.0].map(|bright| scene.add_material(shining(bright)).unwrap());
    scene.add_disc([0, 0, 0], [0, 1, 0], 2, white).unwrap();
    let rod = scene.add_cylinder([0.0, -0.1, 0.0], [0.3, 0.0, 1.0], 0.03, 5.0, black);
    rod.unwrap();
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
    println!("of 255: {jagged} jagged, {two} with Smooth<2>, {four} with Smooth<4>");
    assert_eq!(jagged, 255.0);
    assert!(two <= 255.0 * (1.0 / 16.0 + 2.0 / 8.0), "{two}");
    assert!(four <= 255.0 * (1.0 / 16.0 + 2.0 / 16.0) + 1.0, "{four}");
}

/// A wire and a fence are what jagged edges tear.
#[test]
fn wire_and_fence_are_whole() {
    for name in ["wire", "fence"] {
        let path = format!("{}/examples/scenes/{name}.json", env!("CARGO_MANIFEST_DIR"));
        let source = Source::open(path.as_ref(), &Chosen::default());
        let judge = Judge::new(source.unwrap());
        let drawn = [Quality::Fast, Quality::Smooth2, Quality::Smooth4].map(|it| judge.drawn(it));
        println!("{name}: {drawn:.1?} dB");
        // Both take a second line there, and find edges nearly as finely.
        assert!(drawn[1] >= drawn[0] + 10.0, "{name}: {drawn:?}");
        assert!(drawn[2] >= drawn[1], "{name}: {drawn:?}");
    }
}

/// Draws tiles that shine by themselves, and returns how near the picture is to 32 x 32 samples a pixel: jagged, and
/// with `Smooth<2>` and `Smooth<4>`, in decibels.
fn tiled(camera: &Camera, fill: impl FnOnce(&mut Scenery, [MaterialId; 2])) -> [f64; 3] {
    let mut scene = Scenery::new();
    let tiles = shining(0.9).checker([0.1; 3], [1.0, 1.0, 0.0]);
    let materials = [tiles, Material::new([0.0; 3]).mirror(1.0)];
    let materials = materials.map(|it| scene.add_material(it).unwrap());
    fill(&mut scene, materials);
    let shading = reference::Shading::BlinnPhong;
    let exact = reference::Scene::from(&scene.description());
    let truth = sampled(
        &exact,
        &camera.into(),
        [SIDE, SIDE, 32],
        REFLECTIONS,
        shading,
    );
    let (built, size) = (scene.build().unwrap(), Size::new(SIDE, SIDE));
    let pictures = [
        near::drawn::<Fast, BlinnPhong>(&built, camera, size),
        near::drawn::<Smooth<2>, BlinnPhong>(&built, camera, size),
        near::drawn::<Smooth<4>, BlinnPhong>(&built, camera, size),
    ];
    pictures.map(|picture| compare(&picture, &truth).unwrap().psnr)
}

/// Cells that are smaller than a pixel are mixed. Samples at points make noise of them: the floor had 18.5 dB with `Smooth<4>`,
/// the wall 31.9.
#[test]
fn small_cells_of_checkers_are_mixed() {
    let low = Camera::new([1, -6, 2], [0, 0, 1], [0, 0, 1], 50).unwrap();
    let rolled = Camera::new([4, -5, 2], [0, 0, 1], [1, 0, 2], 60).unwrap();
    let floor = |scene: &mut Scenery, [tiles, _]: [MaterialId; 2]| {
        scene.add_plane([0, 0, 0], [0, 0, 1], tiles).unwrap();
    };
    let with_wall = |scene: &mut Scenery, [tiles, mirror]: [MaterialId; 2]| {
        scene.add_plane([0, 0, 0], [0, 0, 1], tiles).unwrap();
        scene.add_disc([0, 2, 3], [1, -4, 1], 4, mirror).unwrap();
    };
    let with_ball = |scene: &mut Scenery, [tiles, mirror]: [MaterialId; 2]| {
        scene.add_plane([0, 0, 0], [0, 0, 1], tiles).unwrap();
        scene.add_sphere([0, 0, 1], 1, mirror).unwrap();
    };
    let with_can = |scene: &mut Scenery, [tiles, mirror]: [MaterialId; 2]| {
        scene.add_plane([0, 0, 0], [0, 0, 1], tiles).unwrap();
        scene
            .add_cylinder([0, 0, 1], [0, 0, 1], 1, 2, mirror)
            .unwrap();
    };
    let globe = |scene: &mut Scenery, [_, mirror]: [MaterialId; 2]| {
        let tiles = shining(0.9).checker([0.1; 3], [0.1; 3]);
        let tiles = scene.add_material(tiles).unwrap();
        scene.add_sphere([0, 0, 1], 2, tiles).unwrap();
        scene.add_sphere([1, -3, 2], 0.4, mirror).unwrap();
    };
    for (name, found, bars) in [
        ("floor", tiled(&low, floor), [33.0, 37.0]),
        ("rolled", tiled(&rolled, floor), [29.5, 30.0]),
        ("wall", tiled(&low, with_wall), [41.5, 45.0]),
        ("ball", tiled(&low, with_ball), [32.0, 35.0]),
        ("can", tiled(&low, with_can), [30.0, 32.5]),
        ("globe", tiled(&low, globe), [30.0, 31.5]),
    ] {
        println!("{name}: {found:.1?} dB");
        let [_, two, four] = found;
        assert!(two >= bars[0] && four >= bars[1], "{name}: {found:?}");
    }
}
