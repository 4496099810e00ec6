//! Tests how a picture is drawn on a display: every pixel once, inside, in order; whole, in part and
//! in pieces; and no row after the display has failed.

use std::collections::BTreeMap;

use embedded_graphics::Pixel;
use embedded_graphics::draw_target::DrawTarget;
use embedded_graphics::geometry::Dimensions;
use embedded_graphics::mock_display::{ColorMapping, MockDisplay};
use embedded_graphics::pixelcolor::{
    BinaryColor, Gray4, Gray8, PixelColor, Rgb565, Rgb888, RgbColor,
};
use embedded_graphics::prelude::{Point, PointsIter, Size};
use embedded_graphics::primitives::Rectangle;
use reflet::host::{compare::compare, painted};
use reflet::quality::{Exact, Fast, Quality};
use reflet::scenes::{BuiltIn, Cylinders, Mirror1, Primitives};
use reflet::shading::Normals;
use reflet::{
    FrameBuilder, Material, Number, PreparedFrame, Report, Rows, RuntimeScene, Scene, room,
};

/// A display that records its calls in order, and fails at the call `fails_at`.
pub struct Recorder<C> {
    bounds: Rectangle,
    /// Area and colours of every call.
    calls: Vec<(Rectangle, Vec<C>)>,
    fails_at: usize,
}

#[derive(Debug, PartialEq, Eq)]
pub struct CableLost(usize);

impl<C: PixelColor> Recorder<C> {
    pub fn new(top_left: Point, size: Size) -> Self {
        Self {
            bounds: Rectangle::new(top_left, size),
            calls: Vec::new(),
            fails_at: usize::MAX,
        }
    }

    /// Returns all drawn pixels in their order.
    fn pixels(&self) -> Vec<(Point, C)> {
        let calls = self.calls.iter();
        let pixels = calls.flat_map(|(area, colors)| area.points().zip(colors.iter().copied()));
        pixels.collect()
    }

    /// Returns the last colour of each pixel, by its row and column.
    pub fn shown(&self) -> BTreeMap<[i32; 2], C> {
        let pixels = self.pixels().into_iter();
        pixels.map(|(at, color)| ([at.y, at.x], color)).collect()
    }
}

impl<C> Dimensions for Recorder<C> {
    fn bounding_box(&self) -> Rectangle {
        self.bounds
    }
}

impl<C: PixelColor> DrawTarget for Recorder<C> {
    type Color = C;
    type Error = CableLost;

    fn draw_iter<I: IntoIterator<Item = Pixel<C>>>(&mut self, _: I) -> Result<(), CableLost> {
        panic!("pixels come in areas");
    }

    fn fill_contiguous<I: IntoIterator<Item = C>>(
        &mut self,
        area: &Rectangle,
        colors: I,
    ) -> Result<(), CableLost> {
        if self.calls.len() == self.fails_at {
            return Err(CableLost(self.fails_at));
        }
        self.calls.push((*area, colors.into_iter().collect()));
        Ok(())
    }

    fn fill_solid(&mut self, area: &Rectangle, color: C) -> Result<(), CableLost> {
        self.fill_contiguous(area, area.points().map(|_| color))
    }
}

type Mirrors<Q> = PreparedFrame<Mirror1, Q>;

fn recorder(width: u32, height: u32) -> Recorder<Rgb888> {
    Recorder::new(Point::zero(), Size::new(width, height))
}

/// Returns a frame of a scene with mirrors and shadows.
pub fn frame() -> FrameBuilder<'static, Mirror1> {
    Mirror1::frame(&Mirror1::CAMERA)
}

fn picture(width: u32, height: u32) -> Mirrors<Fast> {
    frame().prepare(Size::new(width, height))
}

/// Returns a picture with every pixel traced.
fn exact_picture(width: u32, height: u32) -> Mirrors<Exact> {
    let size = Size::new(width, height);
    frame().quality::<Exact>().prepare(size)
}

/// Returns the rows of a frame.
fn on<Q: Quality>(picture: &Mirrors<Q>) -> Rows<'_, Mirror1, Q> {
    picture.on(&Mirror1).unwrap()
}

fn row<C: PixelColor + From<Rgb888>>(picture: &Mirrors<impl Quality>, y: u32) -> Vec<C> {
    let mut pixels = vec![C::from(Rgb888::BLACK); picture.size().width as usize];
    on(picture).row(y, 0, &mut pixels);
    pixels
}

/// Returns all rows of a picture, from `Rows::row`.
fn rows<C: PixelColor + From<Rgb888>>(picture: &Mirrors<impl Quality>) -> Vec<Vec<C>> {
    Vec::from_iter((0..picture.size().height).map(|y| row(picture, y)))
}

#[test]
fn every_pixel_is_drawn_once_and_inside_in_one_call_a_row() {
    for (width, height) in [(1, 1), (1, 9), (9, 1), (13, 7), (31, 17), (64, 64)] {
        let mut display = recorder(width, height);
        frame().draw(&mut display).unwrap();
        let drawn = display.pixels().into_iter().map(|(point, _)| point);
        assert!(drawn.eq(display.bounds.points()), "{width}x{height}");
        assert_eq!(display.calls.len(), height as usize);
        for (y, (area, colors)) in display.calls.iter().enumerate() {
            let row = Rectangle::new(Point::new(0, y as i32), Size::new(width, 1));
            assert_eq!((*area, colors.len()), (row, width as usize));
        }
    }
}

/// Draws on embedded-graphics' own mock display, which fails on a pixel that is outside or drawn twice.
fn assert_mock_display_shows<C>()
where
    C: PixelColor + ColorMapping + From<Rgb888> + std::fmt::Debug,
{
    let mut display = MockDisplay::<C>::new();
    let report = frame().draw(&mut display).unwrap();
    assert!(report.rays > 64 * 64 / 4);
    let colors = rows::<Rgb888>(&picture(64, 64)).into_iter().flatten();
    for (at, color) in display.bounding_box().points().zip(colors) {
        assert_eq!(display.get_pixel(at), Some(C::from(color)), "{at}");
    }
}

#[test]
fn displays_of_every_kind_show_the_same_picture_in_their_colours() {
    assert_mock_display_shows::<Rgb888>();
    assert_mock_display_shows::<Rgb565>();
    assert_mock_display_shows::<Gray8>();
    assert_mock_display_shows::<Gray4>();
    assert_mock_display_shows::<BinaryColor>();
}

#[test]
fn rows_may_be_filled_in_the_displays_colours() {
    let picture = picture(21, 13);
    let converted = rows::<Rgb888>(&picture).concat();
    let converted = converted.into_iter().map(Rgb565::from);
    assert!(converted.eq(rows::<Rgb565>(&picture).concat()));
}

#[test]
fn error_of_the_display_comes_back_at_once() {
    for fails_at in [0, 1, 5, 8] {
        let mut display = recorder(11, 9);
        display.fails_at = fails_at;
        let result = frame().draw(&mut display);
        assert_eq!(result, Err(CableLost(fails_at)));
        assert_eq!(display.calls.len(), fails_at, "rows after the error");
    }
}

/// A display that fails in the middle of its second row.
struct Torn {
    taken: usize,
}

impl Dimensions for Torn {
    fn bounding_box(&self) -> Rectangle {
        Rectangle::new(Point::zero(), Size::new(8, 8))
    }
}

impl DrawTarget for Torn {
    type Color = Rgb888;
    type Error = CableLost;

    fn draw_iter<I: IntoIterator<Item = Pixel<Rgb888>>>(&mut self, it: I) -> Result<(), CableLost> {
        for _ in it {
            self.taken += 1;
            if self.taken == 12 {
                return Err(CableLost(self.taken));
            }
        }
        Ok(())
    }
}

#[test]
fn no_pixel_is_taken_from_a_row_that_the_display_has_given_up() {
    let mut display = Torn { taken: 0 };
    let result = frame().draw(&mut display);
    assert_eq!((result, display.taken), (Err(CableLost(12)), 12));
}

#[test]
fn display_without_area_is_drawn_without_a_call() {
    for size in [Size::zero(), Size::new(0, 9), Size::new(9, 0)] {
        let mut display = Recorder::<Rgb888>::new(Point::new(3, 4), size);
        let report = frame().draw(&mut display);
        assert_eq!(report, Ok(Report::NONE));
        assert!(display.calls.is_empty());
    }
}

#[test]
fn display_that_starts_elsewhere_is_filled_where_it_is() {
    for top_left in [Point::new(-7, 12), Point::new(1000, -1000)] {
        let mut display = Recorder::<Rgb888>::new(top_left, Size::new(16, 12));
        frame().draw(&mut display).unwrap();
        let expected = display.bounds.points().zip(rows(&picture(16, 12)).concat());
        assert_eq!(display.pixels(), Vec::from_iter(expected));
    }
}

#[test]
fn what_lies_outside_the_display_is_not_worked_out() {
    let picture = picture(20, 15);
    let whole = rows::<Rgb888>(&picture);
    let exact = exact_picture(20, 15);
    for (x, y) in [
        (0, 0),
        (-5, -3),
        (4, 2),
        (-14, 8),
        (11, 9),
        (12, 0),
        (-20, 0),
        (3, -15),
    ] {
        let mut display = recorder(12, 10);
        let top_left = Point::new(x, y);
        let everything = Rectangle::new(Point::zero(), picture.size());
        let rows = on(&picture);
        let report = rows.draw_area(everything, top_left, &mut display).unwrap();
        let whole_area = Rectangle::new(top_left, picture.size());
        let visible = display.bounds.intersection(&whole_area);
        let color = |at: Point| whole[(at.y - y) as usize][(at.x - x) as usize];
        let expected: Vec<_> = visible.points().map(|at| (at, color(at))).collect();
        assert_eq!(display.pixels(), expected, "at {x}, {y}");
        assert_eq!(display.calls.len(), visible.rows().len(), "at {x}, {y}");
        assert_eq!(report == Report::NONE, expected.is_empty(), "at {x}, {y}");
        let exact = on(&exact);
        let report = exact.draw_area(everything, top_left, &mut display).unwrap();
        let rays = visible.points().map(|at| {
            let Point { x, y } = at - top_left;
            exact.row(y as u32, x as u32, &mut [Rgb888::BLACK]).rays
        });
        assert_eq!(report.rays, rays.sum::<u64>(), "at {x}, {y}");
    }
}

#[test]
fn area_is_a_crop_of_the_whole() {
    let picture = picture(24, 18);
    let whole = rows::<Rgb888>(&picture);
    for (x, y, width, height) in [
        (0, 0, 24, 18),
        (3, 4, 5, 6),
        (23, 17, 1, 1),
        (-3, -3, 9, 9),
        (20, 10, 99, 99),
        (7, 7, 0, 3),
        (24, 0, 5, 5),
    ] {
        let area = Rectangle::new(Point::new(x, y), Size::new(width, height));
        let inside = area.intersection(&Rectangle::new(Point::zero(), picture.size()));
        for top_left in [Point::zero(), Point::new(2, 5)] {
            let mut display = recorder(40, 40);
            let rows = on(&picture);
            rows.draw_area(area, top_left, &mut display).unwrap();
            let color = |at: Point| whole[at.y as usize][at.x as usize];
            let crop = inside.points().map(|at| (at + top_left, color(at)));
            let found = display.pixels().into_iter();
            assert!(found.eq(crop), "{area:?} at {top_left}");
        }
    }
}

#[test]
fn area_of_any_size_at_any_place_is_cut_to_the_picture_and_the_display() {
    let picture = picture(24, 18);
    let whole = rows::<Rgb888>(&picture);
    let (least, most) = (Point::new_equal(i32::MIN), Point::new_equal(i32::MAX));
    let endless = Size::new_equal(u32::MAX);
    for (area, top_left, from) in [
        (
            Rectangle::new(Point::new(5, 6), endless),
            Point::zero(),
            Point::new(5, 6),
        ),
        (Rectangle::new(least, endless), Point::zero(), Point::zero()),
        (Rectangle::new(most, endless), Point::zero(), most),
        (Rectangle::new(Point::zero(), endless), least, most),
        (Rectangle::new(least, endless), most, most),
    ] {
        let mut display = recorder(40, 40);
        on(&picture)
            .draw_area(area, top_left, &mut display)
            .unwrap();
        let seen = Rectangle::new(Point::zero(), picture.size()).points();
        let seen = seen.filter(|at| at.x >= from.x && at.y >= from.y);
        let expected = seen.map(|at| (at, whole[at.y as usize][at.x as usize]));
        assert!(
            display.pixels().into_iter().eq(expected),
            "{area:?} at {top_left}"
        );
    }
}

#[test]
fn rows_make_the_same_picture_as_draw() {
    let mut display = recorder(33, 20);
    let drawn = frame().draw(&mut display).unwrap();
    let colors = display.calls.into_iter().map(|(_, colors)| colors);
    assert!(colors.eq(rows(&picture(33, 20))));
    let mut row = [Rgb888::BLACK; 33];
    let reports = (0..20).map(|y| on(&picture(33, 20)).row(y, 0, &mut row));
    assert_eq!(reports.fold(Report::NONE, Report::merge), drawn);
}

#[test]
fn clear_rows_are_the_same_pixel_by_pixel() {
    for width in [64, 100, 240] {
        let (mut display, frame) = (recorder(width, 64), Cylinders::frame(&Cylinders::CAMERA));
        frame.draw(&mut display).unwrap();
        let frame = frame.prepare(Size::new(width, 64));
        let rows: Rows<'_, Cylinders, Fast> = frame.on(&Cylinders).unwrap();
        for (y, (_, drawn)) in (0..).zip(&display.calls) {
            let mut row = vec![Rgb888::BLACK; width as usize];
            rows.row(y, 0, &mut row);
            assert_eq!((y, &row), (y, drawn), "{width}");
        }
    }
}

#[test]
fn rows_may_be_filled_in_any_order_and_in_pieces() {
    assert_pieces_make_rows(&picture(30, 11));
    // If every pixel is traced, pieces trace no ray twice.
    let picture = exact_picture(30, 11);
    for (y, report) in assert_pieces_make_rows(&picture) {
        let mut pixels = [Rgb888::BLACK; 30];
        assert_eq!(report, on(&picture).row(y, 0, &mut pixels), "row {y}");
    }
}

/// Draws the rows in mixed order, and each row in pieces of another length, from the last piece to
/// the first. Returns the merged report of each row's pieces.
fn assert_pieces_make_rows(picture: &Mirrors<impl Quality>) -> Vec<(u32, Report)> {
    let whole = rows::<Rgb888>(picture);
    let row = |step: usize| {
        let y = step * 7 % 11;
        let mut pixels = [Rgb888::BLACK; 30];
        let mut report = Report::NONE;
        for (piece, part) in pixels.chunks_mut(step + 1).enumerate().rev() {
            let x = piece * (step + 1);
            report = report.merge(on(picture).row(y as u32, x as u32, part));
        }
        assert_eq!(pixels[..], whole[y], "row {y}");
        (y as u32, report)
    };
    (0..11).map(row).collect()
}

#[test]
fn two_threads_may_share_a_picture() {
    let picture = picture(40, 30);
    let row = |y| row::<Rgb888>(&picture, y);
    let halves = std::thread::scope(|scope| {
        let half = |first| scope.spawn(move || Vec::from_iter((first..30).step_by(2).map(row)));
        [half(0), half(1)].map(|half| half.join().unwrap())
    });
    for (y, row) in rows::<Rgb888>(&picture).into_iter().enumerate() {
        assert_eq!(row, halves[y % 2][y / 2], "row {y}");
    }
}

#[test]
fn empty_slice_is_filled_without_a_ray() {
    let report = on(&picture(5, 5)).row::<Rgb888>(2, 2, &mut []);
    assert_eq!(report, Report::NONE);
}

#[test]
fn picture_has_at_least_one_pixel_and_at_most_65535_a_side() {
    let given = [1, 1, 65_535, 65_535, 65_535];
    for (asked, given) in [0, 1, 65_535, 65_536, u32::MAX].into_iter().zip(given) {
        let wide = frame().prepare(Size::new(asked, 3));
        assert_eq!(wide.size(), Size::new(given, 3));
        assert_eq!(on(&wide).size(), Size::new(given, 3));
        let high = frame().prepare(Size::new(3, asked));
        assert_eq!(high.size(), Size::new(3, given));
        assert_eq!(on(&high).size(), Size::new(3, given));
    }
}

#[test]
fn widest_row_is_drawn_to_its_end() {
    let frame = Primitives::frame(&Primitives::CAMERA).prepare(Size::new(65_535, 3));
    let wide = frame.on(&Primitives).unwrap();
    let mut row = vec![Rgb888::BLACK; 65_535];
    let report = wide.row(1, 0, &mut row);
    assert!(report.rays > 65_535 / 64, "fewer than blocks: {report:?}");
    let exact = Primitives::frame(&Primitives::CAMERA).quality::<Exact>();
    let exact = painted(&exact.prepare(wide.size()).on(&Primitives).unwrap());
    assert!(compare(&painted(&wide), &exact).unwrap().max <= 1);
    let mut last = [Rgb888::BLACK];
    for x in [0, 1, 32_767, 65_533, 65_534] {
        wide.row(1, x, &mut last);
        assert_eq!(last[0], row[x as usize], "column {x}");
    }
    let mut display = recorder(65_535, 1);
    let whole = Rectangle::new(Point::zero(), wide.size());
    let above = Point::new(0, -1);
    wide.draw_area(whole, above, &mut display).unwrap();
    assert_eq!(display.calls[0].1, row);
}

#[test]
fn highest_column_is_drawn_to_its_end() {
    let mut display = Recorder::<Gray4>::new(Point::zero(), Size::new(1, 65_535));
    let frame = Primitives::frame(&Primitives::CAMERA);
    frame.draw(&mut display).unwrap();
    assert_eq!(display.calls.len(), 65_535);
}

#[test]
fn picture_without_mirrors_takes_one_ray_a_pixel() {
    let mut display = recorder(17, 11);
    let frame = frame().quality::<Exact>();
    assert!(frame.draw(&mut display).unwrap().rays > 17 * 11);
    let frame = frame.reflections(0);
    assert_eq!(frame.draw(&mut display).unwrap().rays, 17 * 11);
    let normals = frame.reflections(4).shading::<Normals>();
    let report = normals.draw(&mut display).unwrap();
    assert_eq!((report.rays, report.cut_off.to_bits()), (17 * 11, 0));
}

#[test]
fn fast_picture_takes_fewer_rays_than_it_has_pixels() {
    let Report { rays, .. } = frame().reflections(0).draw(&mut recorder(64, 48)).unwrap();
    assert!((64 * 48 / 4..64 * 48 * 3 / 4).contains(&rays), "{rays}");
}

type One = room!(spheres: 1, lights: 1, materials: 1);

#[test]
fn scene_may_change_between_frames() {
    let mut scene = RuntimeScene::<One>::new();
    let white = scene.add_material(Material::new([1.0; 3])).unwrap();
    scene.add_light([0, -9, 9], [1, 1, 1]).unwrap();
    let camera = reflet::Camera::look_at([0.0, -5.0, 0.0], [0.0; 3], [0.0, 0.0, 1.0]);
    let size = Size::new(16, 16);
    let drawn =
        |scene: Scene<One>| painted(&scene.frame(&camera).prepare(size).on(&scene).unwrap());
    let empty = drawn(scene.build().unwrap());
    assert_eq!(empty.pixels, [[0; 3]; 256]);
    scene.add_sphere([Number::ZERO; 3], 1, white).unwrap();
    let full = drawn(scene.build().unwrap());
    assert!(full.pixels[8 * 16 + 8][0] > 50);
    assert_eq!(full.pixels[0], [0; 3]);
}

#[test]
fn row_beyond_the_picture_stays_as_it_is() {
    const MARK: Rgb888 = Rgb888::new(1, 2, 3);
    let picture = picture(33, 20);
    let mut row = [MARK; 40];
    for (y, x) in [(20, 0), (0, 33), (u32::MAX, 0), (0, u32::MAX)] {
        assert_eq!(on(&picture).row(y, x, &mut row), Report::NONE, "{y}, {x}");
    }
    assert_eq!(row, [MARK; 40]);
    assert!(on(&picture).row(19, 30, &mut row).rays >= 3);
    assert_eq!(row[3..], [MARK; 37]);
}

/// Returns a display after a frame that was coarse at first, and the report.
fn coarse_first(height: u32, fails_at: usize) -> (Recorder<Rgb888>, Result<Report, CableLost>) {
    let mut display = Recorder::new(Point::new(-3, 5), Size::new(40, height));
    display.fails_at = fails_at;
    let mut row = [Rgb888::BLACK; 40];
    let drawn = frame().draw_coarse_first(&mut row, &mut display);
    (display, drawn)
}

#[test]
fn picture_that_is_coarse_at_first_traces_each_row_once_and_ends_as_the_plain_one() {
    for height in [1, 6, 32, 35] {
        let mut plain = Recorder::new(Point::new(-3, 5), Size::new(40, height));
        let report = frame().draw(&mut plain);
        let (coarse, drawn) = coarse_first(height, usize::MAX);
        assert_eq!(drawn, report);
        assert_eq!(coarse.calls.len(), height as usize);
        assert_eq!(coarse.shown(), plain.shown());
        let quarter = coarse.calls.iter().take(height.div_ceil(4) as usize);
        let rows: u32 = quarter.map(|(area, _)| area.size.height).sum();
        assert_eq!(rows, height, "the first pass covers the display");
    }
}

#[test]
fn picture_that_is_coarse_at_first_ends_with_the_error_of_the_display() {
    for fails_at in [0, 7, 8, 31] {
        let (display, drawn) = coarse_first(32, fails_at);
        assert_eq!(drawn, Err(CableLost(fails_at)));
        assert_eq!(display.calls.len(), fails_at);
    }
}
