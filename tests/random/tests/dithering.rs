//! Tests dithering for displays with few levels: the colour of each dot, that it depends only on
//! colour and position, and that the display gets the same calls as without dithering.

use embedded_graphics::Pixel;
use embedded_graphics::draw_target::{DrawTarget, DrawTargetExt};
use embedded_graphics::geometry::{Dimensions, OriginDimensions};
use embedded_graphics::pixelcolor::{
    Bgr555, Bgr565, Bgr666, Bgr888, BinaryColor, Gray2, Gray4, Gray8, GrayColor, PixelColor,
    Rgb555, Rgb565, Rgb666, Rgb888, RgbColor,
};
use embedded_graphics::prelude::{Point, PointsIter, Size, Transform};
use embedded_graphics::primitives::Rectangle;
use embedded_graphics_simulator::SimulatorDisplay;
use proptest::prelude::*;
use proptest::test_runner::RngSeed;
use reflet::display::{Ditherable, Dithered, Threshold, dither};
use reflet::scenes::{BuiltIn, Empty, Mirror1};
use reflet::{PreparedFrame, Report};

/// Bayer's matrix as it is printed. A dot is lit if the picture is brighter than its number there.
const BAYER: [[u32; 8]; 8] = [
    [0, 32, 8, 40, 2, 34, 10, 42],
    [48, 16, 56, 24, 50, 18, 58, 26],
    [12, 44, 4, 36, 14, 46, 6, 38],
    [60, 28, 52, 20, 62, 30, 54, 22],
    [3, 35, 11, 43, 1, 33, 9, 41],
    [51, 19, 59, 27, 49, 17, 57, 25],
    [15, 47, 7, 39, 13, 45, 5, 37],
    [63, 31, 55, 23, 61, 29, 53, 21],
];

const WIDTH: u32 = 40;
const HEIGHT: u32 = 24;

fn tile() -> Rectangle {
    Rectangle::new(Point::zero(), Size::new(8, 8))
}

fn grey(value: u8) -> Rgb888 {
    Rgb888::new(value, value, value)
}

/// Returns a frame with light, shadows and mirrors.
fn picture() -> PreparedFrame<Mirror1> {
    Mirror1::frame(&Mirror1::CAMERA).prepare(Size::new(WIDTH, HEIGHT))
}

/// Draws the whole frame, with its corner at `top_left`.
fn draw<D: DrawTarget<Color = Rgb888>>(
    top_left: Point,
    target: &mut D,
) -> Result<Report, D::Error> {
    let picture = picture();
    let whole = Rectangle::new(Point::zero(), picture.size());
    let rows = picture.on(&Mirror1).unwrap();
    rows.draw_area(whole, top_left, target)
}

fn display<C: PixelColor + From<BinaryColor>>() -> SimulatorDisplay<C> {
    SimulatorDisplay::new(Size::new(WIDTH, HEIGHT))
}

#[test]
fn dot_is_lit_where_it_is_brighter_than_bayers_number() {
    for value in 0..=255 {
        for at in tile().points() {
            let number = BAYER[at.y as usize][at.x as usize];
            let is_brighter = u32::from(value) * 128 >= (2 * number + 1) * 255;
            let dot: BinaryColor = dither(grey(value), at);
            assert_eq!(dot.is_on(), is_brighter, "{value} at {at}");
        }
    }
}

#[test]
fn every_level_is_beside_its_value_and_never_falls() {
    for largest in 1..=255 {
        for value in 0..=255 {
            for at in tile().points() {
                let level = u32::from(Threshold::at(at).level(value, largest));
                let exact = u32::from(value) * u32::from(largest);
                let beside = [exact / 255, exact.div_ceil(255)];
                assert!(beside.contains(&level), "{value} of {largest} at {at}");
                let brighter = Threshold::at(at).level(value.saturating_add(1), largest);
                assert!(level <= u32::from(brighter), "{value} of {largest} at {at}");
            }
        }
    }
}

/// Half a 64th of a level, in 255ths of a level summed over 64 points.
const HALF: i64 = 255 / 2;

/// Checks that the mean of a dithered tile is close to the colour. `channels` splits a dot into its
/// channels, each with its largest level.
fn assert_mean<C: Ditherable>(channels: impl Fn(C) -> Vec<(u8, u8)>) {
    for value in 0..=255 {
        // A colour with different channels; the other one is grey.
        let turned = Rgb888::new(value, 255 - value, value.rotate_left(4));
        for color in [grey(value), turned] {
            let dots = Vec::from_iter(tile().points().map(|at| channels(dither(color, at))));
            let wanted = match dots[0].len() {
                3 => vec![color.r(), color.g(), color.b()],
                _ => vec![Gray8::from(color).luma()],
            };
            for (channel, wanted) in wanted.into_iter().enumerate() {
                let sum: i64 = dots.iter().map(|dot| i64::from(dot[channel].0)).sum();
                let exact = i64::from(wanted) * i64::from(dots[0][channel].1) * 64;
                let error = sum * 255 - exact;
                let name = std::any::type_name::<C>();
                assert!(error.abs() <= HALF, "{name}: {color:?}: {error}");
            }
        }
    }
}

fn rgb<C: RgbColor>(dot: C) -> Vec<(u8, u8)> {
    vec![
        (dot.r(), C::MAX_R),
        (dot.g(), C::MAX_G),
        (dot.b(), C::MAX_B),
    ]
}

fn luma<C: GrayColor>(dot: C) -> Vec<(u8, u8)> {
    vec![(dot.luma(), C::WHITE.luma())]
}

#[test]
fn mean_of_a_tile_is_within_half_a_64th_of_a_level() {
    assert_mean(rgb::<Rgb555>);
    assert_mean(rgb::<Bgr555>);
    assert_mean(rgb::<Rgb565>);
    assert_mean(rgb::<Bgr565>);
    assert_mean(rgb::<Rgb666>);
    assert_mean(rgb::<Bgr666>);
    assert_mean(rgb::<Rgb888>);
    assert_mean(rgb::<Bgr888>);
    assert_mean(luma::<Gray2>);
    assert_mean(luma::<Gray4>);
    assert_mean(luma::<Gray8>);
    assert_mean(|dot: BinaryColor| vec![(dot.is_on().into(), 1)]);
}

/// Checks that black, white and every other colour with its own level stay the same at every
/// position.
fn assert_levels_stay<C: Ditherable + From<Rgb888> + Into<Rgb888> + std::fmt::Debug>() {
    let colors = (0..=255).map(grey);
    let colors = colors.chain([Rgb888::RED, Rgb888::GREEN, Rgb888::BLUE]);
    let levels = Vec::from_iter(colors.filter(|&color| color == C::from(color).into()));
    assert!(levels.contains(&Rgb888::BLACK) && levels.contains(&Rgb888::WHITE));
    for color in levels {
        for at in tile().points() {
            assert_eq!(dither::<C>(color, at), C::from(color), "{color:?} at {at}");
        }
    }
}

#[test]
fn colour_that_is_a_level_stays_as_it_is() {
    // Levels that are whole numbers in 8 bits. Of 5 and 6 bits only the first and the last level
    // are, tested below.
    for (largest, step) in [(1, 255), (3, 85), (5, 51), (15, 17), (255, 1)] {
        for level in 0..=largest {
            for at in tile().points() {
                assert_eq!(Threshold::at(at).level(level * step, largest), level);
            }
        }
    }
    assert_levels_stay::<Gray2>();
    assert_levels_stay::<Gray4>();
    assert_levels_stay::<Gray8>();
    assert_levels_stay::<Rgb888>();
    assert_levels_stay::<Bgr888>();
    for at in tile().points() {
        for color in [Rgb888::BLACK, Rgb888::WHITE, Rgb888::RED, Rgb888::CYAN] {
            assert_eq!(dither::<Rgb555>(color, at), Rgb555::from(color));
            assert_eq!(dither::<Bgr565>(color, at), Bgr565::from(color));
            assert_eq!(dither::<Rgb666>(color, at), Rgb666::from(color));
        }
    }
}

/// A display that records its calls, and fails at the call `fails_at`.
#[derive(Default)]
struct Recorder<C: PixelColor> {
    calls: Vec<Call<C>>,
    fails_at: Option<usize>,
}

#[derive(Clone, Debug, PartialEq)]
enum Call<C: PixelColor> {
    Pixels(Vec<Pixel<C>>),
    Colors(Rectangle, Vec<C>),
    Solid(Rectangle, C),
}

#[derive(Debug, PartialEq, Eq)]
struct CableLost(usize);

impl<C: PixelColor> Recorder<C> {
    fn failing(call: usize) -> Self {
        let (calls, fails_at) = (Vec::new(), Some(call));
        Self { calls, fails_at }
    }

    fn take(&mut self, call: Call<C>) -> Result<(), CableLost> {
        if self.fails_at == Some(self.calls.len()) {
            return Err(CableLost(self.calls.len()));
        }
        self.calls.push(call);
        Ok(())
    }
}

impl<C: PixelColor> OriginDimensions for Recorder<C> {
    fn size(&self) -> Size {
        Size::new(WIDTH, HEIGHT)
    }
}

impl<C: PixelColor> DrawTarget for Recorder<C> {
    type Color = C;
    type Error = CableLost;

    fn draw_iter<I: IntoIterator<Item = Pixel<C>>>(&mut self, pixels: I) -> Result<(), CableLost> {
        self.take(Call::Pixels(pixels.into_iter().collect()))
    }

    fn fill_contiguous<I>(&mut self, area: &Rectangle, colors: I) -> Result<(), CableLost>
    where
        I: IntoIterator<Item = C>,
    {
        self.take(Call::Colors(*area, colors.into_iter().collect()))
    }

    fn fill_solid(&mut self, area: &Rectangle, color: C) -> Result<(), CableLost> {
        self.take(Call::Solid(*area, color))
    }
}

#[test]
fn display_is_asked_as_without_dithering() {
    let mut plain = Recorder::<Rgb888>::default();
    let mut dithered = Recorder::<Gray4>::default();
    let report = draw(Point::new(-3, 5), &mut plain).unwrap();
    let of_dithered = draw(Point::new(-3, 5), &mut Dithered::new(&mut dithered));
    assert_eq!(of_dithered, Ok(report));
    let calls = plain.calls.into_iter().map(|call| match call {
        Call::Colors(area, colors) => {
            let dots = area.points().zip(colors);
            Call::Colors(area, dots.map(|(at, color)| dither(color, at)).collect())
        }
        call => panic!("{call:?}"),
    });
    assert_eq!(calls.len(), HEIGHT as usize - 5);
    assert_eq!(dithered.calls, calls.collect::<Vec<_>>());
}

#[test]
fn size_and_place_are_the_displays() {
    let mut display = display::<Gray2>();
    let area = Rectangle::new(Point::new(3, -2), Size::new(20, 10));
    let mut part = display.cropped(&area);
    let bounds = part.bounding_box();
    assert_eq!(bounds, Rectangle::new(Point::zero(), Size::new(20, 8)));
    assert_eq!(Dithered::new(&mut part).bounding_box(), bounds);
}

#[test]
fn only_a_level_is_filled_as_one() {
    let mut recorder = Recorder::<Gray2>::default();
    let area = Rectangle::new(Point::new(-5, 20), Size::new(8, 8));
    let mut dithered = Dithered::new(&mut recorder);
    dithered.fill_solid(&area, grey(85)).unwrap();
    dithered.fill_solid(&area, grey(86)).unwrap();
    dithered.clear(Rgb888::WHITE).unwrap();
    let visible = Rectangle::new(Point::new(0, 20), Size::new(3, 4));
    let dots = visible.points().map(|at| dither(grey(86), at));
    let expected = [
        Call::Solid(area, Gray2::new(1)),
        Call::Colors(visible, dots.collect()),
        Call::Solid(recorder.bounding_box(), Gray2::WHITE),
    ];
    assert_eq!(recorder.calls, expected);
}

#[test]
fn area_is_filled_as_one_where_all_its_dots_are_the_same() {
    for value in 0..=255_u8 {
        let mut recorder = Recorder::<BinaryColor>::default();
        let area = tile();
        let mut dithered = Dithered::new(&mut recorder);
        dithered.fill_solid(&area, grey(value)).unwrap();
        let dots: Vec<BinaryColor> = area.points().map(|at| dither(grey(value), at)).collect();
        let expected = if dots.iter().all(|&dot| dot == dots[0]) {
            Call::Solid(area, dots[0])
        } else {
            Call::Colors(area, dots)
        };
        assert_eq!(recorder.calls, [expected], "{value}");
    }
}

#[test]
fn error_of_the_display_comes_back() {
    let area = tile();
    for fails_at in 0..4 {
        let mut recorder = Recorder::<Rgb565>::failing(fails_at);
        let mut dithered = Dithered::new(&mut recorder);
        let results = [
            dithered.draw_iter([Pixel(Point::zero(), grey(1))]),
            dithered.fill_contiguous(&area, [grey(2); 64]),
            dithered.fill_solid(&area, Rgb888::WHITE),
            dithered.fill_solid(&area, grey(3)),
        ];
        let (before, from) = results.split_at(fails_at);
        assert!(before.iter().all(Result::is_ok));
        // It keeps failing, because failed calls are not recorded.
        assert!(from.iter().all(|it| *it == Err(CableLost(fails_at))));
    }
}

#[test]
fn no_row_follows_an_error() {
    let mut recorder = Recorder::<BinaryColor>::failing(3);
    let result = draw(Point::zero(), &mut Dithered::new(&mut recorder));
    assert_eq!(result, Err(CableLost(3)));
    assert_eq!(recorder.calls.len(), 3);
}

#[test]
fn scene_of_nothing_is_filled_in_its_colour() {
    let mut recorder = Recorder::<Gray4>::default();
    let result = Empty::frame(&Empty::CAMERA).draw(&mut Dithered::new(&mut recorder));
    assert!(result.is_ok());
    let expected = Call::Solid(recorder.bounding_box(), Gray4::BLACK);
    assert_eq!(recorder.calls, [expected]);
}

#[test]
fn rows_have_the_dots_of_the_whole() {
    let mut whole = display::<Rgb565>();
    let mut dithered = Dithered::new(&mut whole);
    draw(Point::zero(), &mut dithered).unwrap();
    let mut row = [Rgb888::BLACK; WIDTH as usize];
    for y in (0..HEIGHT as i32).rev() {
        picture().on(&Mirror1).unwrap().row(y as u32, 0, &mut row);
        for (x, color) in row.into_iter().enumerate() {
            let at = Point::new(x as i32, y);
            assert_eq!(whole.get_pixel(at), dither(color, at), "{at}");
        }
    }
}

#[test]
fn picture_in_black_and_white_is_as_bright_as_the_picture() {
    let size = Size::new(320, 320);
    let frame = Mirror1::frame(&Mirror1::CAMERA);
    let mut grey = SimulatorDisplay::<Gray8>::new(size);
    frame.draw(&mut grey).unwrap();
    let mut dots = SimulatorDisplay::<BinaryColor>::new(size);
    frame.draw(&mut Dithered::new(&mut dots)).unwrap();
    let points = || Rectangle::new(Point::zero(), size).points();
    let pixels = f64::from(size.width * size.height);
    let luma = points().map(|at| u32::from(grey.get_pixel(at).luma()));
    let luma: u32 = luma.sum();
    let lit = points().filter(|&at| dots.get_pixel(at).is_on()).count();
    let (wanted, shown) = (f64::from(luma) / 255.0 / pixels, lit as f64 / pixels);
    // One tile of one luma can be off by half a 64th in either direction; the mean of many tiles by
    // less.
    assert!((shown - wanted).abs() < 1.0 / 256.0, "{shown} of {wanted}");
}

/// Returns any rectangle: on the display, partly on it, or beside it.
fn area() -> impl Strategy<Value = Rectangle> {
    let corner = (-20..50_i32, -20..50_i32).prop_map(|(x, y)| Point::new(x, y));
    let size = (0..40_u32, 0..40_u32).prop_map(|(width, height)| Size::new(width, height));
    (corner, size).prop_map(|(corner, size)| Rectangle::new(corner, size))
}

fn color() -> impl Strategy<Value = Rgb888> {
    any::<[u8; 3]>().prop_map(|[red, green, blue]| Rgb888::new(red, green, blue))
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, rng_seed: RngSeed::Fixed(1), ..ProptestConfig::default() })]

    #[test]
    fn any_part_has_the_dots_of_the_whole(part in area(), x in -50..50_i32, y in -50..50_i32) {
        let top_left = Point::new(x, y);
        let (mut whole, mut of_part) = (display::<Gray2>(), display::<Gray2>());
        draw(top_left, &mut Dithered::new(&mut whole)).unwrap();
        picture().on(&Mirror1).unwrap().draw_area(part, top_left, &mut Dithered::new(&mut of_part)).unwrap();
        let inside = Rectangle::new(Point::zero(), picture().size()).intersection(&part);
        for at in whole.bounding_box().points() {
            let is_inside = inside.translate(top_left).contains(at);
            let expected = if is_inside { whole.get_pixel(at) } else { Gray2::BLACK };
            prop_assert_eq!(of_part.get_pixel(at), expected);
        }
    }

    #[test]
    fn every_way_to_draw_shows_the_same_dots(
        area in area(),
        color in color(),
        missing in 0..100_usize,
    ) {
        let pixels = || area.points().map(|at| Pixel(at, color));
        let mut by_hand = display::<Rgb555>();
        by_hand.draw_iter(pixels().map(|Pixel(at, color)| Pixel(at, dither(color, at)))).unwrap();
        let mut shown = [display(), display(), display()];
        let [one, two, three] = &mut shown;
        Dithered::new(one).draw_iter(pixels()).unwrap();
        Dithered::new(two).fill_solid(&area, color).unwrap();
        let colors = std::iter::repeat(color);
        Dithered::new(three).fill_contiguous(&area, colors).unwrap();
        for display in shown {
            prop_assert!(display == by_hand);
        }
        // With fewer colours than the area has points, the last points stay as they are.
        let count = pixels().count().saturating_sub(missing);
        let mut fewer = [display::<Rgb555>(), display()];
        let [one, two] = &mut fewer;
        Dithered::new(one).draw_iter(pixels().take(count)).unwrap();
        Dithered::new(two).fill_contiguous(&area, (0..count).map(|_| color)).unwrap();
        prop_assert!(fewer[0] == fewer[1]);
    }

    #[test]
    fn pattern_repeats_every_eight_points(
        color in color(),
        x in any::<i32>(),
        y in any::<i32>(),
        tiles in any::<[i32; 2]>(),
    ) {
        let [right, down] = tiles.map(|tiles| tiles.wrapping_mul(8));
        let moved = Point::new(x.wrapping_add(right), y.wrapping_add(down));
        prop_assert_eq!(dither::<Rgb565>(color, Point::new(x, y)), dither(color, moved));
    }
}
