//! Floor 8: a frame for so many instructions, or so much time: which settings fit, by what was
//! measured, and an end in time.

use embedded_graphics::draw_target::DrawTarget;
use embedded_graphics::geometry::{Point, Size};
use embedded_graphics::pixelcolor::Rgb888;
use embedded_graphics::primitives::Rectangle;

use super::Enlarged;
use crate::accel::drawable::Drawable;
use crate::number::{Unit, signed};
use crate::render::{Fast, Fine, Quality};
use crate::render::{FrameBuilder, Report};
use crate::shade::Shading;

/// The quality of a [`FrontPoint`], as a value.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum QualityLevel {
    /// [`Fast`]
    Fast,
    /// [`Fine`]
    Fine,
}

/// Settings for a scene on a core, what they take and what they lose: measured, not worked out.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct FrontPoint {
    /// Executed instructions of a frame's preparation, whatever its size.
    pub prepare: u32,
    /// Executed instructions for a pixel of the display beyond that.
    pub instructions: u32,
    /// At most this many reflections a path.
    pub reflections: u8,
    /// The quality.
    pub level: QualityLevel,
    /// A pixel that is drawn covers `scale` by `scale` pixels of the display (see [`Enlarged`]).
    pub scale: u8,
    /// The peak signal-to-noise ratio against double precision that follows every reflection, over
    /// all channels, in hundredths of a decibel; [`u16::MAX`] if there was no difference.
    pub psnr: u16,
    /// The largest difference of a channel, of 255.
    pub largest: u8,
}

impl FrontPoint {
    /// The instructions that a frame of this size is expected to take.
    pub const fn expected(&self, size: Size) -> u64 {
        // `u64::from` is not const.
        let pixels = size.width as u64 * size.height as u64;
        let drawing = pixels.saturating_mul(self.instructions as u64);
        drawing.saturating_add(self.prepare as u64)
    }
}

/// The best settings for a scene on a core: each takes more instructions a pixel than the one before
/// it and has less error.
///
/// `cargo run --release --package report` measures them for a scene of yours and writes them as
/// Rust source.
#[derive(Clone, Copy, Debug)]
pub struct ParetoFront(&'static [FrontPoint]);

impl ParetoFront {
    /// The front of these points.
    ///
    /// Panics, which stops the compiler for a constant, if there are none, or if one does not take
    /// more instructions a pixel than the one before it and reach a higher PSNR.
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

    /// Its points, the cheapest first.
    pub const fn points(&self) -> &'static [FrontPoint] {
        self.0
    }

    /// What to draw a display of `size` with for so many instructions a frame.
    pub fn choose(&self, size: Size, instructions: u64) -> Choice {
        let mut dearest_first = self.0.iter().rev();
        let fitting = dearest_first.find(|it| it.expected(size) <= instructions);
        // There is a first one, by how a front is made.
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

/// What was chosen for a budget, and so the error to expect.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub struct Choice {
    /// The settings, with what they take and lose.
    pub point: FrontPoint,
    /// Whether they fit the budget; if nothing does they are the cheapest there are.
    pub fits: bool,
}

/// What became of a frame that had a budget.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub struct Budgeted {
    /// What was chosen.
    pub choice: Choice,
    /// Of what was drawn.
    pub report: Report,
    /// How far a pixel that was traced can be off on account of the reflections that were left out,
    /// as a share of white: [`crate::Rows::cut_off_bound`].
    pub cut_off_bound: Unit,
    /// How many of the display's rows were still to be drawn when time was up: the lowest ones, which
    /// show what they showed before.
    pub missing_rows: u32,
}

/// What was drawn of a frame: its lowest rows may be missing.
struct Drawn {
    report: Report,
    cut_off_bound: Unit,
    rows: u32,
}

impl<S: Drawable, Q: Quality, K: Shading> FrameBuilder<'_, S, Q, K> {
    /// Draws the frame over the whole target with the settings of a front that fit a budget of so
    /// many instructions, instead of its own; [`u64::MAX`] for the best there is.
    ///
    /// `time_is_up` is asked before every row. From when it says so nothing more is drawn: what was
    /// drawn stays, and the result says how many rows are missing. `|| false` draws all.
    ///
    /// What the points of a front take is counted into a row in memory, at the size of the report. The
    /// target comes on top: on a Cortex-M3 one in memory adds up to 16 instructions a pixel, or up to
    /// 256 for each of the larger pixels, which are squares of their own (`xtask/tests/budget.rs` holds
    /// this for the castle); a driver of a display has its own. On a smaller display a pixel takes more,
    /// as fewer lie between traced ones: the castle at 64 by 48 up to 1.8 times what its front of 128
    /// by 128 says, target included. So the report should be of your display's size (`--size`).
    ///
    /// Only what calls this has both [`Fast`] and [`Fine`] in flash.
    ///
    /// ```
    /// use embedded_graphics::{mock_display::MockDisplay, pixelcolor::Rgb888};
    /// use reflet::budget::{FrontPoint, ParetoFront, QualityLevel};
    /// use reflet::scenes::{BuiltIn, Corner1};
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
    /// ```
    ///
    /// # Errors
    /// The target's own, at once: no further row is worked out.
    pub fn draw_within<D>(
        self,
        front: &ParetoFront,
        instructions: u64,
        time_is_up: impl FnMut() -> bool,
        target: &mut D,
    ) -> Result<Budgeted, D::Error>
    where
        D: DrawTarget,
        D::Color: From<Rgb888>,
    {
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

    fn at_level<D>(
        self,
        level: QualityLevel,
        time_is_up: impl FnMut() -> bool,
        target: &mut D,
    ) -> Result<Drawn, D::Error>
    where
        D: DrawTarget,
        D::Color: From<Rgb888>,
    {
        match level {
            QualityLevel::Fast => self.quality::<Fast>().draw_until(time_is_up, target),
            QualityLevel::Fine => self.quality::<Fine>().draw_until(time_is_up, target),
        }
    }

    /// Draws rows over the target until time is up.
    fn draw_until<D>(
        &self,
        mut time_is_up: impl FnMut() -> bool,
        target: &mut D,
    ) -> Result<Drawn, D::Error>
    where
        D: DrawTarget,
        D::Color: From<Rgb888>,
    {
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
