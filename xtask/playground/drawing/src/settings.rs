//! The settings of a frame, as a page sends them, and their limits.

/// The settings of a frame, as the page sends them: choices are numbers.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Settings {
    /// Number of columns, 1 to [`Settings::LONGEST`].
    pub width: u32,
    /// Number of rows, 1 to [`Settings::LONGEST`].
    pub height: u32,
    /// Largest number of reflections, 0 to 255.
    pub reflections: u32,
    /// 0 for `Fast`, 1 for `Exact`.
    pub quality: u32,
    /// 0 for Blinn-Phong, 1 for Phong.
    pub shading: u32,
    /// Samples along each side of a pixel, 1 to 4.
    pub smooth: u32,
    /// Number of the display's colours; see `display.rs`.
    pub display: u32,
}

impl Settings {
    /// Most pixels along a side.
    pub const LONGEST: u32 = 4096;

    /// Tests whether the frame can be drawn.
    ///
    /// # Errors
    /// The setting that is out of range, and its range.
    pub fn check(&self) -> Result<(), String> {
        let limits = [
            ("width", self.width, 1..=Self::LONGEST),
            ("height", self.height, 1..=Self::LONGEST),
            ("reflections", self.reflections, 0..=255),
            ("quality", self.quality, 0..=1),
            ("shading", self.shading, 0..=1),
            ("smooth", self.smooth, 1..=4),
            ("display", self.display, 0..=5),
        ];
        for (name, value, range) in limits {
            if !range.contains(&value) {
                let (least, most) = range.into_inner();
                return Err(format!("{name} must be {least} to {most}, not {value}"));
            }
        }
        Ok(())
    }

    pub fn reflections(&self) -> u8 {
        u8::try_from(self.reflections).unwrap_or(u8::MAX)
    }

    /// Tests whether the picture is shown as it is drawn.
    pub(crate) fn is_plain(&self) -> bool {
        self.smooth == 1 && self.display == 0
    }
}
