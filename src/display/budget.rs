//! Floor 8: frames with a budget of instructions or of time. Chooses among settings that were measured,
//! and stops drawing when time is up.

use embedded_graphics::draw_target::DrawTarget;
use embedded_graphics::geometry::{Point, Size};
use embedded_graphics::pixelcolor::Rgb888;
use embedded_graphics::primitives::Rectangle;

use super::Enlarged;
use crate::accel::any_scene::AnyScene;
use crate::number::{Unit, signed};
use crate::qualities::{Exact, Fast, Quality};
use crate::render::{FrameBuilder, Report};
use crate::shade::Shading;

/// The quality of a [`FrontPoint`], as a value instead of a type.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum QualityLevel {
    /// The quality [`Fast`], as a value.
    Fast,
    /// The quality [`Exact`], as a value.
    Exact,
}

/// Settings for a scene on a processor core, with their measured instructions and error.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct FrontPoint {
    /// Executed instructions for the preparation of a frame of any size.
    pub prepare: u32,
    /// Executed instructions for each pixel of the display, without the preparation.
    pub instructions: u32,
    /// Largest number of reflections of a path.
    pub reflections: u8,
    /// Quality of the frame.
    pub level: QualityLevel,
    /// Enlargement: each computed pixel covers `scale` by `scale` pixels of the display (see
    /// [`Enlarged`]).
    pub scale: u8,
    /// Peak signal-to-noise ratio over all channels, in hundredths of a decibel; [`u16::MAX`] if there
    /// was no difference. It is measured against a picture in double precision with every reflection.
    pub psnr: u16,
    /// Largest difference of a channel from that picture, 0 to 255.
    pub largest: u8,
}

impl FrontPoint {
    /// Returns the number of instructions that a frame of this size is expected to take.
    pub const fn expected(&self, size: Size) -> u64 {
        // `u64::from` is not const.
        let pixels = size.width as u64 * size.height as u64;
        let drawing = pixels.saturating_mul(self.instructions as u64);
        drawing.saturating_add(self.prepare as u64)
    }
}

/// A Pareto front: the best settings for a scene on a processor core, the cheapest first.
///
/// Each point takes more instructions for a pixel than the point before it and has less error. `cargo
/// run --release --package report` in the repository measures them for a scene of yours and writes them
/// as Rust source.
///
/// ```
/// use embedded_graphics::prelude::Size;
/// use reflet::budget::{Choice, FrontPoint, ParetoFront, QualityLevel};
///
/// // Made up; the command above writes measured points.
/// const CHEAP: FrontPoint = FrontPoint {
///     prepare: 10_000, instructions: 80, reflections: 1,
///     level: QualityLevel::Fast, scale: 2, psnr: 2400, largest: 160,
/// };
/// const DEAR: FrontPoint =
///     FrontPoint { instructions: 400, level: QualityLevel::Exact, psnr: 6000, ..CHEAP };
/// const FRONT: ParetoFront = ParetoFront::new(&[CHEAP, DEAR]);
///
/// let size = Size::new(100, 100);
/// assert_eq!((CHEAP.expected(size), DEAR.expected(size)), (810_000, 4_010_000));
/// let choice = FRONT.choose(size, 1_000_000);
/// assert_eq!((choice.point, choice.fits), (CHEAP, true));
/// let choice = FRONT.choose(size, u64::MAX);
/// assert_eq!((choice.point, choice.fits), (DEAR, true));
/// let choice = FRONT.choose(size, 1_000);
/// assert_eq!((choice.point, choice.fits), (FRONT.points()[0], false));
/// ```
#[derive(Clone, Copy, Debug)]
pub struct ParetoFront(&'static [FrontPoint]);

impl ParetoFront {
    /// Creates a front from its points, the cheapest first.
    ///
    /// # Panics
    /// Panics if there is no point, or if a point does not take more instructions for a pixel and reach
    /// a higher PSNR than the point before it. In a constant, this stops the compiler.
    pub const fn new(points: &'static [FrontPoint]) -> Self {
        assert!(!points.is_empty(), "a front has at least one point");
        let mut next = 1;
        while next < points.len() {
            let (before, after) = (&points[next - 1], &points[next]);
            assert!(
                before.instructions < after.instructions && before.psnr < after.psnr,
                "a point of a front takes more than the one before it and has less error"
            );
            next += 1;
        }
        Self(points)
    }

    /// Returns the points of the front, the cheapest first.
    pub const fn points(&self) -> &'static [FrontPoint] {
        self.0
    }

    /// Returns the best settings for a display of `size` with which a frame takes at most
    /// `instructions`.
    ///
    /// If none fit, returns the cheapest settings, and [`Choice::fits`] is `false`.
    pub fn choose(&self, size: Size, instructions: u64) -> Choice {
        let mut dearest_first = self.0.iter().rev();
        let fitting = dearest_first.find(|it| it.expected(size) <= instructions);
        // The constructor has checked that there is a first point.
        let point = fitting.or(self.0.first()).copied().unwrap_or(FrontPoint {
            prepare: 0,
            instructions: 0,
            reflections: 0,
            level: QualityLevel::Fast,
            scale: 1,
            psnr: 0,
            largest: u8::MAX,
        });
        Choice {
            point,
            fits: fitting.is_some(),
        }
    }
}

/// The settings chosen for a budget.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub struct Choice {
    /// Chosen settings, with their measured instructions and error.
    pub point: FrontPoint,
    /// Whether the settings fit the budget. If `false`, they are the cheapest ones of the front.
    pub fits: bool,
}

/// The result of drawing a frame with a budget; [`FrameBuilder::draw_within`] returns it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub struct Budgeted {
    /// Settings that the frame was drawn with.
    pub choice: Choice,
    /// Report on the rows that were drawn.
    pub report: Report,
    /// Largest error that the reflections left out cause in a traced pixel, as a share of white, 0 to 1;
    /// see [`crate::Rows::cut_off_bound`].
    pub cut_off_bound: Unit,
    /// Number of the display's rows that were not drawn because time was up. They are the lowest rows,
    /// and still show the earlier picture.
    pub missing_rows: u32,
}

/// The part of a frame that was drawn before time was up: its first `rows` rows.
struct Drawn {
    report: Report,
    cut_off_bound: Unit,
    rows: u32,
}

impl<S: AnyScene, Q: Quality, K: Shading> FrameBuilder<'_, S, Q, K> {
    /// Draws the frame over the whole target with the best settings of a front that fit a budget of
    /// instructions. With [`u64::MAX`] the best settings of all are used.
    ///
    /// The settings replace the reflections and the quality of this frame. `time_is_up` is called before
    /// every row. When it returns `true`, drawing ends: rows drawn so far stay, and the result holds the
    /// number of missing rows. `|| false` draws all rows.
    ///
    /// The instructions of a front's points were counted with a row in memory as the target, at the size
    /// of the report. The work of the target is added to them: on a Cortex-M3 a target in memory adds up
    /// to 28 instructions for each pixel, or up to 268 for each enlarged pixel, which is drawn as a
    /// square (`xtask/tests/budget.rs` checks this for the castle). A driver of a display has its own
    /// cost. On a smaller display a pixel takes more instructions, because fewer pixels are
    /// interpolated: the castle at 64 by 48 takes up to 1.8 times what its front of 128 by 128 says,
    /// target included. So measure the front at the size of your display (`--size`).
    ///
    /// A program that calls this function has both [`Fast`] and [`Exact`] in flash.
    ///
    /// ```
    /// use embedded_graphics::{mock_display::MockDisplay, pixelcolor::Rgb888};
    /// use reflet::budget::{Budgeted, FrontPoint, ParetoFront, QualityLevel};
    /// use reflet::scenes::{BuiltIn, Corner1};
    /// use reflet::{Report, Unit};
    ///
    /// // Made up; `cargo run --release --package report -- corner1` writes what is measured.
    /// const FRONT: ParetoFront = ParetoFront::new(&[
    ///     FrontPoint {
    ///         prepare: 10_000, instructions: 80, reflections: 1,
    ///         level: QualityLevel::Fast, scale: 2, psnr: 2400, largest: 160,
    ///     },
    ///     FrontPoint {
    ///         prepare: 10_000, instructions: 230, reflections: 2,
    ///         level: QualityLevel::Fast, scale: 1, psnr: 6000, largest: 9,
    ///     },
    /// ]);
    ///
    /// let mut display = MockDisplay::<Rgb888>::new(); // 64 by 64
    /// let frame = Corner1::frame(&Corner1::CAMERA);
    /// let drawn = frame.draw_within(&FRONT, 1_000_000, || false, &mut display).unwrap();
    /// assert_eq!((drawn.choice.point.reflections, drawn.missing_rows), (2, 0));
    /// assert!(drawn.report.rays > 0);
    ///
    /// let frame = Corner1::frame(&Corner1::CAMERA);
    /// let late: Budgeted = frame.draw_within(&FRONT, 1_000_000, || true, &mut display).unwrap();
    /// assert_eq!((late.missing_rows, late.report, late.cut_off_bound), (64, Report::NONE, Unit::ZERO));
    /// ```
    ///
    /// # Errors
    /// The error of the target, at once: no further row is computed.
    pub fn draw_within<D: DrawTarget<Color: From<Rgb888>>>(
        self,
        front: &ParetoFront,
        instructions: u64,
        time_is_up: impl FnMut() -> bool,
        target: &mut D,
    ) -> Result<Budgeted, D::Error> {
        let size = target.bounding_box().size;
        let choice = front.choose(size, instructions);
        let (level, scale) = (choice.point.level, u32::from(choice.point.scale));
        let frame = self.reflections(choice.point.reflections);
        let drawn = match scale {
            0 | 1 => frame.at_level(level, time_is_up, target),
            _ => frame.at_level(level, time_is_up, &mut Enlarged::new(target, scale)),
        }?;
        let rows = drawn.rows.saturating_mul(scale.max(1));
        Ok(Budgeted {
            choice,
            report: drawn.report,
            cut_off_bound: drawn.cut_off_bound,
            missing_rows: size.height.saturating_sub(rows),
        })
    }

    /// Draws the frame with the quality that `level` stands for, until time is up.
    fn at_level<D: DrawTarget<Color: From<Rgb888>>>(
        self,
        level: QualityLevel,
        time_is_up: impl FnMut() -> bool,
        target: &mut D,
    ) -> Result<Drawn, D::Error> {
        match level {
            QualityLevel::Fast => self.quality::<Fast>().draw_until(time_is_up, target),
            QualityLevel::Exact => self.quality::<Exact>().draw_until(time_is_up, target),
        }
    }

    /// Draws the rows of the frame over the target, from the top, until time is up.
    fn draw_until<D: DrawTarget<Color: From<Rgb888>>>(
        &self,
        mut time_is_up: impl FnMut() -> bool,
        target: &mut D,
    ) -> Result<Drawn, D::Error> {
        let area = target.bounding_box();
        let mut drawn = Drawn {
            report: Report::NONE,
            cut_off_bound: Unit::ZERO,
            rows: 0,
        };
        if area.is_zero_sized() {
            return Ok(drawn);
        }
        let frame = self.prepare(area.size);
        let rows = frame.unchanged(self.scene());
        let Size { width, height } = rows.size();
        for y in 0..height {
            if time_is_up() {
                break;
            }
            let row = Rectangle::new(Point::new(0, signed(y)), Size::new(width, 1));
            let report = rows.draw_area(row, area.top_left, target)?;
            drawn.report = drawn.report.merge(report);
            drawn.rows = y + 1;
        }
        drawn.cut_off_bound = rows.cut_off_bound(&drawn.report);
        Ok(drawn)
    }
}
