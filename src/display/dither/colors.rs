//! Floor 8: how each colour type of embedded-graphics is dithered.

use embedded_graphics::pixelcolor::{
    Bgr555, Bgr565, Bgr666, Bgr888, BinaryColor, Gray2, Gray4, Gray8, GrayColor, Rgb555, Rgb565,
    Rgb666, Rgb888, RgbColor,
};

use super::{Ditherable, Threshold};

/// Red, green and blue, each in the levels of `C`.
#[inline]
fn levels<C: RgbColor>(color: Rgb888, threshold: Threshold) -> [u8; 3] {
    [
        threshold.level(color.r(), C::MAX_R),
        threshold.level(color.g(), C::MAX_G),
        threshold.level(color.b(), C::MAX_B),
    ]
}

/// The luma that embedded-graphics takes for a colour, of `largest` + 1 levels.
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

/// As it is.
impl Ditherable for Rgb888 {
    #[inline]
    fn dithered(color: Rgb888, _: Threshold) -> Self {
        color
    }
}

/// As it is.
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

/// As embedded-graphics converts it: there is a level for every luma.
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
