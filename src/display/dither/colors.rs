//! Floor 8: dithering to each colour type of embedded-graphics.

use embedded_graphics::pixelcolor::{
    Bgr555, Bgr565, Bgr666, Bgr888, BinaryColor, Gray2, Gray4, Gray8, GrayColor, Rgb555, Rgb565,
    Rgb666, Rgb888, RgbColor,
};

use super::{Ditherable, Threshold};

/// Returns the luma that embedded-graphics computes for a colour, dithered to the levels 0 to `largest`.
#[inline]
fn grey(color: Rgb888, largest: u8, threshold: Threshold) -> u8 {
    threshold.level(Gray8::from(color).luma(), largest)
}

/// Implements [`Ditherable`] with the same expression for several colour types.
macro_rules! ditherable {
    ($($(#[$doc:meta])* $color_type:ty),+: |$color:ident, $threshold:pat_param| $dithered:expr) => {
        $(
            $(#[$doc])*
            impl Ditherable for $color_type {
                #[inline]
                fn dithered($color: Rgb888, $threshold: Threshold) -> Self {
                    $dithered
                }
            }
        )+
    };
}

ditherable!(Rgb555, Bgr555, Rgb565, Bgr565, Rgb666, Bgr666: |color, threshold| Self::new(
    threshold.level(color.r(), Self::MAX_R),
    threshold.level(color.g(), Self::MAX_G),
    threshold.level(color.b(), Self::MAX_B),
));

ditherable!(Gray2, Gray4: |color, threshold| Self::new(grey(color, Self::WHITE.luma(), threshold)));

ditherable!(BinaryColor: |color, threshold| Self::from(grey(color, 1, threshold) == 1));

ditherable!(
    /// Returns colours unchanged: the type has all 256 levels per channel.
    Rgb888: |color, _| color
);

ditherable!(
    /// Converts colours without dithering: the type has all 256 levels per channel.
    Bgr888,
    /// Converts colours as embedded-graphics does, without dithering: the type has a level for every luma.
    Gray8: |color, _| color.into()
);
