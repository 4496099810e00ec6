//! Tests frames with a budget: the chosen settings, where drawing stops, and the report. Also tests
//! enlarged pixels, pictures without shadows, and the bound of a report.

use command_line::{Quality, Settings, Shading, Source};
use embedded_graphics::draw_target::DrawTarget;
use embedded_graphics::geometry::{Dimensions, Point, Size};
use embedded_graphics::pixelcolor::{Rgb888, RgbColor};
use embedded_graphics::primitives::PointsIter;
use embedded_graphics_simulator::SimulatorDisplay;
use reflet::budget::{FrontPoint, ParetoFront, QualityLevel};
use reflet::display::Enlarged;
use reflet::host::compare::compare;
use reflet::host::painted;
use reflet::host::reference::{self, pixel};
use reflet::quality::{Exact, Fast};
use reflet::scenes::{Mirror1, NAMES};
use reflet::shading::{Phong, Unshadowed};
use reflet::{Report, Unit};

use super::drawing::{Recorder, frame};

const FRONT: ParetoFront = ParetoFront::new(&[
    point(40, 0, QualityLevel::Fast, 4, 2000),
    point(150, 1, QualityLevel::Fast, 2, 2500),
    point(600, 1, QualityLevel::Fast, 1, 3000),
    point(900, 3, QualityLevel::Exact, 1, 5000),
]);

const fn point(
    cost: u32,
    reflections: u8,
    level: QualityLevel,
    scale: u8,
    psnr: u16,
) -> FrontPoint {
    FrontPoint {
        prepare: PREPARE,
        instructions: cost,
        reflections,
        level,
        scale,
        psnr,
        largest: 255,
    }
}

const SIZE: Size = Size::new(30, 21);

const PREPARE: u32 = 777;

fn display() -> SimulatorDisplay<Rgb888> {
    SimulatorDisplay::new(SIZE)
}

/// Measured Pareto fronts of the built-in scenes.
mod measured {
    use reflet::budget::{FrontPoint, ParetoFront, QualityLevel};

    include!("../../docs/error-time/front.rs");
}

#[test]
fn dearest_point_that_fits_is_chosen() {
    let pixels = u64::from(SIZE.width * SIZE.height);
    let prepare = u64::from(PREPARE);
    let chosen = |instructions| FRONT.choose(SIZE, prepare + instructions * pixels);
    let budgets = [40, 149, 150, 899, 900, 1 << 40];
    for (instructions, index) in budgets.into_iter().zip([0, 0, 1, 2, 3, 3]) {
        let choice = chosen(instructions);
        assert_eq!(choice.point, FRONT.points()[index], "{instructions}");
        assert!(choice.fits);
    }
    let choice = FRONT.choose(SIZE, prepare + 40 * pixels - 1);
    assert_eq!((choice.point, choice.fits), (FRONT.points()[0], false));
    // On a small display, the preparation is a larger part of a frame.
    let choice = FRONT.choose(Size::new(1, 1), prepare + 150);
    assert_eq!(choice.point, FRONT.points()[1]);
    assert_eq!(choice.point.expected(SIZE), prepare + 150 * pixels);
}

#[test]
fn front_is_drawn_with_the_settings_of_its_points() {
    for point in FRONT.points() {
        let (mut found, mut expected) = (display(), display());
        let budget = point.expected(SIZE);
        let Ok(drawn) = frame().draw_within(&FRONT, budget, || false, &mut found);
        assert_eq!((drawn.choice.point, drawn.missing_rows), (*point, 0));
        let frame = frame().reflections(point.reflections);
        let mut target = Enlarged::new(&mut expected, point.scale.into());
        let small = frame.prepare(target.bounding_box().size);
        let small = small.on(&Mirror1).unwrap();
        let Ok(report) = match point.level {
            QualityLevel::Fast => frame.quality::<Fast>().draw(&mut target),
            QualityLevel::Exact => frame.quality::<Exact>().draw(&mut target),
        };
        assert_eq!(found.to_be_bytes(), expected.to_be_bytes(), "{point:?}");
        assert_eq!(drawn.report, report);
        assert_eq!(drawn.cut_off_bound, small.cut_off_bound(&report));
        assert!(drawn.cut_off_bound > Unit::ZERO);
    }
}

#[test]
fn what_is_drawn_when_time_is_up_stays_and_the_rest_is_counted() {
    for (budget, asked, rows_drawn) in [(0, 2, 4 * 2), (u64::MAX, 5, 5), (0, 6, SIZE.height)] {
        let mut display = display();
        let Ok(()) = display.clear(Rgb888::MAGENTA);
        let mut left = asked;
        let is_up = || {
            left -= 1;
            left < 0
        };
        let Ok(drawn) = frame().draw_within(&FRONT, budget, is_up, &mut display);
        assert_eq!(drawn.missing_rows, SIZE.height - rows_drawn);
        let is_untouched = |y: u32| {
            let pixel = |x| display.get_pixel(Point::new(x as i32, y as i32));
            (0..SIZE.width).all(|x| pixel(x) == Rgb888::MAGENTA)
        };
        for y in 0..SIZE.height {
            assert_eq!(is_untouched(y), y >= rows_drawn, "row {y} of {rows_drawn}");
        }
    }
}

#[test]
fn nothing_is_drawn_on_a_display_without_pixels() {
    let mut display = SimulatorDisplay::<Rgb888>::new(Size::zero());
    let Ok(drawn) = frame().draw_within(&FRONT, 0, || false, &mut display);
    assert_eq!((drawn.report, drawn.missing_rows), (Report::NONE, 0));
}

#[test]
fn every_pixel_of_a_display_with_larger_ones_is_a_square_inside_of_it() {
    for scale in [0, 1, 2, 3, 4, 50, u32::MAX] {
        let small = Enlarged::<SimulatorDisplay<Rgb888>>::size_of(SIZE, scale);
        let small = painted(&frame().prepare(small).on(&Mirror1).unwrap());
        // It does not begin at the corner.
        let mut display = Recorder::new(Point::new(3, 5), SIZE);
        let drawn = frame().draw(&mut Enlarged::new(&mut display, scale));
        drawn.unwrap();
        let expected = display.bounding_box().points().map(|at| {
            let Point { x, y } = (at - Point::new(3, 5)) / scale.clamp(1, 1 << 30) as i32;
            let [red, green, blue] = small.pixels[(y * small.width as i32 + x) as usize];
            ([at.y, at.x], Rgb888::new(red, green, blue))
        });
        assert_eq!(display.shown(), expected.collect(), "{scale}");
    }
}

/// Returns the scene with only one shape. Shapes are numbered: first spheres, then planes, then
/// cylinders.
fn lone(scene: &reference::Scene, shape: usize) -> reference::Scene {
    let (mut lone, mut numbers) = (scene.clone(), 0..);
    let mut is_it = || numbers.next() == Some(shape);
    lone.spheres.retain(|_| is_it());
    lone.planes.retain(|_| is_it());
    lone.cylinders.retain(|_| is_it());
    lone
}

/// Returns the scene with glowing shapes: the red channel is the shape's number plus one. The
/// background is black.
fn numbered(scene: &reference::Scene) -> reference::Scene {
    let mut numbered = reference::Scene {
        lights: Vec::new(),
        background: [0.0; 3],
        ..scene.clone()
    };
    let spheres = numbered.spheres.iter_mut().map(|it| &mut it.material);
    let planes = numbered.planes.iter_mut().map(|it| &mut it.material);
    let cylinders = numbered.cylinders.iter_mut().map(|it| &mut it.material);
    let materials = spheres.chain(planes).chain(cylinders).enumerate();
    let materials = materials.map(|(index, material)| {
        *material = index;
        reference::Material {
            color: [(index + 1) as f64 / 255.0, 0.0, 0.0],
            ambient: 1.0,
            diffuse: 0.0,
            specular: 0.0,
            shininess: 1.0,
            mirror: 0.0,
            checker: None,
        }
    });
    numbered.materials = materials.collect();
    assert!(numbered.materials.len() < 255);
    numbered
}

#[test]
fn picture_without_shadows_is_one_of_each_shape_in_its_own_light() {
    /// Returns the number of pixels that are brighter without shadows.
    fn brighter(name: &str) -> usize {
        let source = Source::built_in(name).unwrap();
        let size = Size::new(48, 48);
        // Without reflections a pixel shows one surface only.
        let blinn_phong = source.painted::<Exact, Unshadowed>(size, 0);
        let phong = source.painted::<Exact, Unshadowed<Phong>>(size, 0);
        let pictures = [(Shading::BlinnPhong, blinn_phong), (Shading::Phong, phong)];
        let (scene, camera) = source.reference();
        let render = |scene: &_, shading| {
            reference::render(scene, &camera, size.width, size.height, 0, shading).pixels
        };
        let met = render(&numbered(&scene), reference::Shading::BlinnPhong);
        let shapes = scene.spheres.len() + scene.planes.len() + scene.cylinders.len();
        let compared = pictures.iter().map(|&(shading, ref lit)| {
            let settings = Settings {
                reflections: 0,
                shading,
                quality: Quality::Exact,
            };
            let shadowed = source.drawn(size, settings);
            // One more than there are shapes: the last scene has only the background.
            let alone = (0..=shapes).map(|shape| render(&lone(&scene, shape), shading.into()));
            let alone: Vec<_> = alone.collect();
            let apart = |at: usize| {
                let shape = usize::from(met[at][0]).checked_sub(1).unwrap_or(shapes);
                let (found, expected) = (lit.pixels[at], alone[shape][at]);
                // An open tube casts a shadow on its own inside, even alone.
                let is_tube = shape < shapes && shape >= shapes - scene.cylinders.len();
                (0..3).any(|i| {
                    if is_tube {
                        found[i].saturating_add(1) < expected[i]
                    } else {
                        found[i].abs_diff(expected[i]) > 1
                    }
                })
            };
            // At most one pixel in 200 differs, at rims.
            let different = (0..met.len()).filter(|at| apart(*at)).count();
            assert!(200 * different <= met.len(), "{name}: {different}");
            let pixels = shadowed.pixels.iter().zip(&lit.pixels);
            pixels
                .filter(|(a, b)| (0..3).any(|i| b[i] > a[i].saturating_add(8)))
                .count()
        });
        compared.sum()
    }

    let brighter = NAMES.map(|name| (name, brighter(name)));
    let has_shadows = brighter.iter().filter(|(_, pixels)| *pixels > 20).count();
    assert!(has_shadows >= 6, "{brighter:?}");
}

#[test]
fn cut_off_bound_holds_and_shrinks_with_each_reflection() {
    for name in NAMES {
        let source = Source::built_in(name).unwrap();
        let (world, view) = (source.scene(), source.camera());
        let ((scene, camera), side) = (source.reference(), 24);
        let at = |x, y, reflections| {
            let shading = reference::Shading::BlinnPhong;
            pixel(&scene, &camera, (side, side), (x, y), reflections, shading)
        };
        let mut last = Unit::ONE;
        for reflections in 0..6 {
            let frame = world.frame(&view).reflections(reflections);
            let picture = frame.quality::<Exact>().prepare(Size::new(side, side));
            let picture = picture.on(world).unwrap();
            let mut row = vec![Rgb888::BLACK; side as usize];
            let reports = (0..side).map(|y| picture.row(y, 0, &mut row));
            let report = reports.fold(Report::NONE, Report::merge);
            let bound = picture.cut_off_bound(&report);
            assert!(bound <= last, "{name} {reflections}: {bound} after {last}");
            last = bound;
            for (x, y) in (0..side).flat_map(|y| (0..side).map(move |x| (x, y))) {
                let found = at(x, y, reflections.into());
                let truth = at(x, y, 300);
                for (found, truth) in found.into_iter().zip(truth) {
                    let lost = truth.clamp(0.0, 1.0) - found.clamp(0.0, 1.0);
                    let bound = bound.to_num::<f64>();
                    assert!((-1e-9..=bound + 1e-6).contains(&lost), "{lost} {bound}");
                }
            }
        }
    }
}

/// Measured fronts of the scenes, in the order of [`NAMES`].
const MEASURED: [ParetoFront; 11] = [
    measured::CASTLE,
    measured::SHADING_LIGHTS,
    measured::SHADING_SPECULARS,
    measured::COLUMNS,
    measured::MIRROR1,
    measured::MIRROR2,
    measured::PRIMITIVES,
    measured::EMPTY,
    measured::FLOOR,
    measured::CORNER1,
    measured::CYLINDERS,
];

#[test]
fn error_is_the_one_that_was_promised() {
    for (name, front) in NAMES.into_iter().zip(MEASURED) {
        let source = Source::built_in(name).unwrap();
        let (view, size) = (source.camera(), Size::new(128, 128));
        let (scene, camera) = source.reference();
        let shading = reference::Shading::BlinnPhong;
        let truth = reference::render(&scene, &camera, size.width, size.height, 300, shading);
        for point in front.points() {
            let budget = point.expected(size);
            let mut display = SimulatorDisplay::<Rgb888>::new(size);
            // With tables, as a constant scene of a board.
            let scene = source.scene().tabled();
            let Ok(drawn) = scene
                .frame(&view)
                .draw_within(&front, budget, || false, &mut display);
            assert_eq!((drawn.choice.point, drawn.choice.fits), (*point, true));
            let bytes = display.to_be_bytes();
            let pixels = bytes.chunks_exact(3).map(|it| [it[0], it[1], it[2]]);
            let picture = reference::Picture {
                pixels: pixels.collect(),
                ..truth
            };
            let found = compare(&picture, &truth).unwrap();
            assert_eq!(found.max, point.largest, "{name}: {point:?}");
            // The promised PSNR is rounded down to a hundredth.
            let more = found.psnr - f64::from(point.psnr) / 100.0;
            let is_promised = match point.psnr {
                u16::MAX => found.psnr == f64::INFINITY,
                _ => (-1e-9..0.01).contains(&more),
            };
            assert!(is_promised, "{name}: {point:?} {found:?}");
        }
    }
}
