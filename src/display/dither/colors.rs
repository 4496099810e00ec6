//! Floor 8: dithering to each colour type of embedded-graphics.

use embedded_graphics::pixelcolor::{
    Bgr555, Bgr565, Bgr666, Bgr888, BinaryColor, Gray2, Gray4, Gray8, GrayColor, Rgb555, Rgb565,
    Rgb666, Rgb888, RgbColor,
};

use super::{Ditherable, Threshold};

/// Returns red, green and blue, each dithered to the levels of `C`.
#[inline]
fn levels<C: RgbColor>(color: Rgb888, threshold: Threshold) -> [u8; 3] {
    [
        threshold.level(color.r(), C::MAX_R),
        threshold.level(color.g(), C::MAX_G),
        threshold.level(color.b(), C::MAX_B),
    ]
}

/// Returns the luma that embedded-graphics computes for a colour, dithered to the levels 0 to `largest`.
#[inline]
fn grey(color: Rgb888, largest: u8, threshold: Threshold) -> u8 {
    threshold.level(Gray8::from(color).luma(), largest)
}

impl Ditherable for Rgb555 {
    #[inline]
    fn dithered(color: Rgb888, threshold: Threshold) -> Self {
        let [red, green, blue] = levels::<Self>(color, threshold);
        Self::new(red, green, blue)
    }
}

impl Ditherable for Bgr555 {
    #[inline]
    fn dithered(color: Rgb888, threshold: Threshold) -> Self {
        let [red, green, blue] = levels::<Self>(color, threshold);
        Self::new(red, green, blue)
    }
}

impl Ditherable for Rgb565 {
    #[inline]
    fn dithered(color: Rgb888, threshold: Threshold) -> Self {
        let [red, green, blue] = levels::<Self>(color, threshold);
        Self::new(red, green, blue)
    }
}

impl Ditherable for Bgr565 {
    #[inline]
    fn dithered(color: Rgb888, threshold: Threshold) -> Self {
        let [red, green, blue] = levels::<Self>(color, threshold);
        Self::new(red, green, blue)
    }
}

impl Ditherable for Rgb666 {
    #[inline]
    fn dithered(color: Rgb888, threshold: Threshold) -> Self {
        let [red, green, blue] = levels::<Self>(color, threshold);
        Self::new(red, green, blue)
    }
}

impl Ditherable for Bgr666 {
    #[inline]
    fn dithered(color: Rgb888, threshold: Threshold) -> Self {
        let [red, green, blue] = levels::<Self>(color, threshold);
        Self::new(red, green, blue)
    }
}

/// Returns colours unchanged: the type has all 256 levels per channel.
impl Ditherable for Rgb888 {
    #[inline]
    fn dithered(color: Rgb888, _: Threshold) -> Self {
        color
    }
}

/// Converts colours without dithering: the type has all 256 levels per channel.
impl Ditherable for Bgr888 {
    #[inline]
    fn dithered(color: Rgb888, _: Threshold) -> Self {
        color.into()
    }
}

impl Ditherable for Gray2 {
    #[inline]
    fn dithered(color: Rgb888, threshold: Threshold) -> Self {
        Self::new(grey(color, Self::WHITE.luma(), threshold))
    }
}

impl Ditherable for Gray4 {
    #[inline]
    fn dithered(color: Rgb888, threshold: Threshold) -> Self {
        Self::new(grey(color, Self::WHITE.luma(), threshold))
    }
}

/// Converts colours as embedded-graphics does, without dithering: the type has a level for every luma.
impl Ditherable for Gray8 {
    #[inline]
    fn dithered(color: Rgb888, _: Threshold) -> Self {
        color.into()
    }
}

impl Ditherable for BinaryColor {
    #[inline]
    fn dithered(color: Rgb888, threshold: Threshold) -> Self {
        Self::from(grey(color, 1, threshold) == 1)
    }
}
