//! How a picture gets into a display: every pixel once, inside, in order; whole, in part, in
//! pieces, and not a row further once the display has failed.

use embedded_graphics::Pixel;
use embedded_graphics::draw_target::DrawTarget;
use embedded_graphics::geometry::Dimensions;
use embedded_graphics::mock_display::{ColorMapping, MockDisplay};
use embedded_graphics::pixelcolor::raw::ToBytes;
use embedded_graphics::pixelcolor::{
    BinaryColor, Gray4, Gray8, PixelColor, Rgb565, Rgb888, RgbColor,
};
use embedded_graphics::prelude::{Point, PointsIter, Size};
use embedded_graphics::primitives::Rectangle;
use reflet::host::painted;
use reflet::scenes::{BuiltIn, Mirror1, Primitives};
use reflet::{
    Exact, Material, Number, Picture, Quality, Report, RuntimeScene, Static, StaticFrame,
};

/// A display that remembers what it is told, in order, and fails at the call it is told to.
struct Recorder<C> {
    bounds: Rectangle,
    /// The area and the colours of every call.
    calls: Vec<(Rectangle, Vec<C>)>,
    fails_at: usize,
}

#[derive(Debug, PartialEq, Eq)]
struct CableLost(usize);

impl<C: PixelColor> Recorder<C> {
    fn new(top_left: Point, size: Size) -> Self {
        Self {
            bounds: Rectangle::new(top_left, size),
            calls: Vec::new(),
            fails_at: usize::MAX,
        }
    }

    /// All pixels in the order they came.
    fn pixels(&self) -> Vec<(Point, C)> {
        let calls = self.calls.iter();
        let pixels = calls.flat_map(|(area, colors)| area.points().zip(colors.iter().copied()));
        pixels.collect()
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
}

/// A picture of a scene with mirrors and shadows.
fn picture(width: u32, height: u32) -> Picture<Static<Mirror1>> {
    Mirror1::frame(&Mirror1::CAMERA).sized(Size::new(width, height))
}

/// The same, with every pixel traced.
fn exact_picture(width: u32, height: u32) -> Picture<Static<Mirror1>, Exact> {
    let frame = Mirror1::frame(&Mirror1::CAMERA).quality::<Exact>();
    frame.sized(Size::new(width, height))
}

/// Every pixel of a picture by the row API.
fn rows<C: PixelColor + From<Rgb888>>(
    picture: &Picture<Static<Mirror1>, impl Quality>,
) -> Vec<Vec<C>> {
    let Size { width, height } = picture.size();
    let black = C::from(Rgb888::BLACK);
    let row = |y| {
        let mut pixels = vec![black; width as usize];
        picture.row(y, 0, &mut pixels);
        pixels
    };
    (0..height).map(row).collect()
}

#[test]
fn every_pixel_is_drawn_once_and_inside_and_in_row_order() {
    for (width, height) in [(1, 1), (1, 9), (9, 1), (31, 17), (64, 64)] {
        let mut display = Recorder::<Rgb888>::new(Point::zero(), Size::new(width, height));
        Mirror1::frame(&Mirror1::CAMERA).draw(&mut display).unwrap();
        let drawn = display.pixels().into_iter().map(|(point, _)| point);
        let expected: Vec<Point> = display.bounds.points().collect();
        assert_eq!(drawn.collect::<Vec<_>>(), expected, "{width}x{height}");
    }
}

#[test]
fn every_row_is_one_call() {
    let mut display = Recorder::<Rgb888>::new(Point::zero(), Size::new(13, 7));
    Mirror1::frame(&Mirror1::CAMERA).draw(&mut display).unwrap();
    assert_eq!(display.calls.len(), 7);
    for (y, (area, colors)) in display.calls.iter().enumerate() {
        assert_eq!(
            *area,
            Rectangle::new(Point::new(0, y as i32), Size::new(13, 1))
        );
        assert_eq!(colors.len(), 13);
    }
}

/// Draws on embedded-graphics' own mock, which fails on a pixel outside or drawn twice.
fn assert_mock_display_shows<C>()
where
    C: PixelColor + ColorMapping + From<Rgb888> + std::fmt::Debug,
{
    let mut display = MockDisplay::<C>::new();
    let report = Mirror1::frame(&Mirror1::CAMERA).draw(&mut display).unwrap();
    assert!(report.rays > 64 * 64 / 4);
    for (y, row) in rows::<Rgb888>(&picture(64, 64)).into_iter().enumerate() {
        for (x, color) in row.into_iter().enumerate() {
            let shown = display.get_pixel(Point::new(x as i32, y as i32));
            assert_eq!(shown, Some(C::from(color)), "{x}, {y}");
        }
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
    let converted = rows::<Rgb888>(&picture).into_iter().map(|row| {
        let row = row.into_iter();
        row.map(|color| Rgb565::from(color).to_be_bytes())
            .collect::<Vec<_>>()
    });
    let direct = rows::<Rgb565>(&picture).into_iter().map(|row| {
        let row = row.into_iter();
        row.map(|color| color.to_be_bytes()).collect::<Vec<_>>()
    });
    assert!(converted.eq(direct));
}

#[test]
fn error_of_the_display_comes_back_at_once() {
    for fails_at in [0, 1, 5, 8] {
        let mut display = Recorder::<Rgb888>::new(Point::zero(), Size::new(11, 9));
        display.fails_at = fails_at;
        let result = Mirror1::frame(&Mirror1::CAMERA).draw(&mut display);
        assert_eq!(result, Err(CableLost(fails_at)));
        assert_eq!(display.calls.len(), fails_at, "rows after the error");
    }
}

/// A display that gives up in the middle of its second row.
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
    let result = Mirror1::frame(&Mirror1::CAMERA).draw(&mut display);
    assert_eq!((result, display.taken), (Err(CableLost(12)), 12));
}

#[test]
fn display_without_area_is_drawn_without_a_call() {
    for size in [Size::zero(), Size::new(0, 9), Size::new(9, 0)] {
        let mut display = Recorder::<Rgb888>::new(Point::new(3, 4), size);
        let report = Mirror1::frame(&Mirror1::CAMERA).draw(&mut display);
        assert_eq!(report, Ok(Report::NONE));
        assert!(display.calls.is_empty());
    }
}

#[test]
fn display_that_starts_elsewhere_is_filled_where_it_is() {
    for top_left in [Point::new(-7, 12), Point::new(1000, -1000)] {
        let mut display = Recorder::<Rgb888>::new(top_left, Size::new(16, 12));
        Mirror1::frame(&Mirror1::CAMERA).draw(&mut display).unwrap();
        let points: Vec<Point> = display.bounds.points().collect();
        let expected = rows(&picture(16, 12)).into_iter().flatten();
        let expected: Vec<_> = points.into_iter().zip(expected).collect();
        assert_eq!(display.pixels(), expected);
    }
}

#[test]
fn what_lies_outside_the_display_is_not_worked_out() {
    let picture = picture(20, 15);
    let whole = rows::<Rgb888>(&picture);
    let exact = exact_picture(20, 15);
    let display_size = Size::new(12, 10);
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
        let mut display = Recorder::<Rgb888>::new(Point::zero(), display_size);
        let report = picture.draw_at(Point::new(x, y), &mut display).unwrap();
        let visible = display
            .bounds
            .intersection(&Rectangle::new(Point::new(x, y), Size::new(20, 15)));
        let expected: Vec<_> = visible
            .points()
            .map(|at| (at, whole[(at.y - y) as usize][(at.x - x) as usize]))
            .collect();
        assert_eq!(display.pixels(), expected, "at {x}, {y}");
        assert_eq!(display.calls.len(), visible.rows().len(), "at {x}, {y}");
        assert_eq!(report == Report::NONE, expected.is_empty(), "at {x}, {y}");
        let report = exact.draw_at(Point::new(x, y), &mut display).unwrap();
        let rays: u64 = expected
            .iter()
            .map(|(at, _)| rays_of(&exact, *at - Point::new(x, y)))
            .sum();
        assert_eq!(report.rays, rays, "at {x}, {y}");
    }
}

fn rays_of(picture: &Picture<Static<Mirror1>, Exact>, at: Point) -> u64 {
    picture
        .row(at.y as u32, at.x as u32, &mut [Rgb888::BLACK])
        .rays
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
            let mut display = Recorder::<Rgb888>::new(Point::zero(), Size::new(40, 40));
            picture.draw_area(area, top_left, &mut display).unwrap();
            let crop = inside
                .points()
                .map(|at| (at + top_left, whole[at.y as usize][at.x as usize]));
            assert_eq!(
                display.pixels(),
                crop.collect::<Vec<_>>(),
                "{area:?} at {top_left}"
            );
        }
    }
}

#[test]
fn rows_make_the_same_picture_as_draw() {
    let mut display = Recorder::<Rgb888>::new(Point::zero(), Size::new(33, 20));
    let drawn = Mirror1::frame(&Mirror1::CAMERA).draw(&mut display).unwrap();
    let colors = display.calls.into_iter().map(|(_, colors)| colors);
    assert!(colors.eq(rows::<Rgb888>(&picture(33, 20))));
    let mut row = [Rgb888::BLACK; 33];
    let reports = (0..20).map(|y| picture(33, 20).row(y, 0, &mut row));
    assert_eq!(reports.fold(Report::NONE, Report::merge), drawn);
}

#[test]
fn rows_may_be_filled_in_any_order_and_in_pieces() {
    assert_pieces_make_rows(&picture(30, 11));
    // No ray is followed twice where every pixel is traced.
    let picture = exact_picture(30, 11);
    for (y, report) in assert_pieces_make_rows(&picture) {
        let mut pixels = [Rgb888::BLACK; 30];
        assert_eq!(report, picture.row(y, 0, &mut pixels), "row {y}");
    }
}

/// Every row but one comes after one below it; every row in pieces of another length, from the last
/// one to the first. Returns the pieces' reports together.
fn assert_pieces_make_rows(picture: &Picture<Static<Mirror1>, impl Quality>) -> Vec<(u32, Report)> {
    let whole = rows::<Rgb888>(picture);
    let row = |step: usize| {
        let y = step * 7 % 11;
        let mut pixels = [Rgb888::BLACK; 30];
        let mut report = Report::NONE;
        for (piece, part) in pixels.chunks_mut(step + 1).enumerate().rev() {
            let x = piece * (step + 1);
            report = report.merge(picture.row(y as u32, x as u32, part));
        }
        assert_eq!(pixels[..], whole[y], "row {y}");
        (y as u32, report)
    };
    (0..11).map(row).collect()
}

#[test]
fn two_threads_may_share_a_picture() {
    let picture = picture(40, 30);
    let halves = std::thread::scope(|scope| {
        let half = |rest: u32| {
            let picture = &picture;
            scope.spawn(move || {
                let row = |y| {
                    let mut pixels = [Rgb888::BLACK; 40];
                    picture.row(y, 0, &mut pixels);
                    pixels.to_vec()
                };
                (0..30)
                    .filter(|y| y % 2 == rest)
                    .map(row)
                    .collect::<Vec<_>>()
            })
        };
        [half(0), half(1)].map(|half| half.join().unwrap())
    });
    let whole = rows::<Rgb888>(&picture);
    let [even, odd] = halves;
    for (y, row) in whole.into_iter().enumerate() {
        assert_eq!(row, [&even, &odd][y % 2][y / 2], "row {y}");
    }
}

#[test]
fn empty_slice_is_filled_without_a_ray() {
    assert_eq!(picture(5, 5).row::<Rgb888>(2, 2, &mut []), Report::NONE);
}

#[test]
fn picture_has_at_least_one_pixel_and_at_most_65535_a_side() {
    let frame = Mirror1::frame(&Mirror1::CAMERA);
    for (asked, given) in [
        (0, 1),
        (1, 1),
        (65_535, 65_535),
        (65_536, 65_535),
        (u32::MAX, 65_535),
    ] {
        let size = frame.sized(Size::new(asked, 3)).size();
        assert_eq!(size, Size::new(given, 3));
        let size = frame.sized(Size::new(3, asked)).size();
        assert_eq!(size, Size::new(3, given));
    }
}

#[test]
fn widest_row_is_drawn_to_its_end() {
    let wide = Primitives::frame(&Primitives::CAMERA).sized(Size::new(65_535, 3));
    let mut row = vec![Rgb888::BLACK; 65_535];
    let report = wide.row(1, 0, &mut row);
    assert!(report.rays > 65_535 / 4);
    let mut last = [Rgb888::BLACK];
    for x in [0, 1, 32_767, 65_533, 65_534] {
        wide.row(1, x, &mut last);
        assert_eq!(last[0], row[x as usize], "column {x}");
    }
    let mut display = Recorder::<Rgb888>::new(Point::zero(), Size::new(65_535, 1));
    wide.draw_at(Point::new(0, -1), &mut display).unwrap();
    assert_eq!(display.calls[0].1, row);
}

#[test]
fn highest_column_is_drawn_to_its_end() {
    let mut display = Recorder::<Gray4>::new(Point::zero(), Size::new(1, 65_535));
    Primitives::frame(&Primitives::CAMERA)
        .draw(&mut display)
        .unwrap();
    assert_eq!(display.calls.len(), 65_535);
}

#[test]
fn picture_without_mirrors_takes_one_ray_a_pixel() {
    let mut display = Recorder::<Rgb888>::new(Point::zero(), Size::new(17, 11));
    let frame = Mirror1::frame(&Mirror1::CAMERA).quality::<Exact>();
    let report = frame.draw(&mut display).unwrap();
    assert!(report.rays > 17 * 11);
    let frame = frame.reflections(0);
    let report = frame.draw(&mut display).unwrap();
    assert_eq!(report.rays, 17 * 11);
    let normals = frame.reflections(4).shading::<reflet::Normals>();
    let report = normals.draw(&mut display).unwrap();
    assert_eq!((report.rays, report.cut_off.to_bits()), (17 * 11, 0));
}

#[test]
fn fast_picture_takes_fewer_rays_than_it_has_pixels() {
    let mut display = Recorder::<Rgb888>::new(Point::zero(), Size::new(64, 48));
    let frame = Mirror1::frame(&Mirror1::CAMERA).reflections(0);
    let report = frame.draw(&mut display).unwrap();
    assert!(
        (64 * 48 / 4..64 * 48 * 3 / 4).contains(&report.rays),
        "{report:?}"
    );
}

#[test]
fn scene_may_change_between_frames() {
    let mut scene = RuntimeScene::<1, 0, 0, 1, 1>::new();
    let white = scene.add_material(Material::new([1.0; 3])).unwrap();
    scene.add_light([0, -9, 9], [1, 1, 1]).unwrap();
    let camera = reflet::Camera::look_at([0.0, -5.0, 0.0], [0.0; 3], [0.0, 0.0, 1.0]);
    let size = Size::new(16, 16);
    let empty = painted(&scene.build().unwrap().frame(&camera).sized(size));
    assert_eq!(empty.pixels, [[0; 3]; 256]);
    scene.add_sphere([Number::ZERO; 3], 1, white).unwrap();
    let full = painted(&scene.build().unwrap().frame(&camera).sized(size));
    assert!(full.pixels[8 * 16 + 8][0] > 50);
    assert_eq!(full.pixels[0], [0; 3]);
}

#[test]
fn row_beyond_the_picture_stays_as_it_is() {
    const MARK: Rgb888 = Rgb888::new(1, 2, 3);
    let picture = picture(33, 20);
    let mut row = [MARK; 40];
    for (y, x) in [(20, 0), (0, 33), (u32::MAX, 0), (0, u32::MAX)] {
        assert_eq!(picture.row(y, x, &mut row), Report::NONE, "{y}, {x}");
    }
    assert_eq!(row, [MARK; 40]);
    assert!(picture.row(19, 30, &mut row).rays >= 3);
    assert_eq!(row[3..], [MARK; 37]);
}
