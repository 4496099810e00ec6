//! Decides which pixels are lost, and why. Knows only colours, never a scene.

/// A pixel's levels of red, green and blue.
pub type Pixel = [u8; 3];

/// Most that a right pixel differs from the reference, in 255ths of the largest channel.
pub const RIGHT: u8 = 1;

/// Most that a pixel differs from the reference if nobody sees it, in 255ths of the largest channel.
pub const VISIBLE: u8 = 8;

/// Why a pixel is lost.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Cause {
    /// The pixel is also lost without shadows and highlights: a shape or its reflection is missing.
    Seen,
    /// Only a shadow or a highlight is missing.
    Light,
    /// The path was reflected off a curved shape, or off more than one flat shape.
    Apart,
}

/// Returns the largest difference of a channel.
pub fn difference(one: Pixel, other: Pixel) -> u8 {
    let channels = one.iter().zip(other).map(|(a, b)| a.abs_diff(b));
    channels.max().unwrap_or(0)
}

/// Tests for each pixel whether one quality has it right and the tested one visibly wrong.
pub fn lost(truth: &[Pixel], right: &[Pixel], tested: &[Pixel]) -> Vec<bool> {
    let pixels = truth.iter().zip(right).zip(tested);
    let is_lost = pixels.map(|((truth, right), tested)| {
        difference(*right, *truth) <= RIGHT && difference(*tested, *truth) > VISIBLE
    });
    is_lost.collect()
}

/// Returns for each pixel why it is lost, or `None` if it is not. `plain` finds the pixels that are
/// lost without shadows and highlights; it is called only if a lost pixel is not apart.
pub fn causes(
    is_lost: &[bool],
    is_apart: &[bool],
    plain: impl FnOnce() -> Vec<bool>,
) -> Vec<Option<Cause>> {
    let indices = 0..is_lost.len();
    let is_in_question = |it: usize| is_lost[it] && !is_apart[it];
    let plain = indices.clone().any(is_in_question).then(plain);
    let cause = |index: usize| match (is_apart[index], &plain) {
        (true, _) => Cause::Apart,
        (false, Some(plain)) if plain[index] => Cause::Seen,
        _ => Cause::Light,
    };
    indices
        .map(|index| is_lost[index].then(|| cause(index)))
        .collect()
}

/// Numbers of lost pixels of a picture.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Counts {
    /// All pixels of the picture.
    pub pixels: usize,
    /// Pixels with [`Cause::Seen`].
    pub seen: usize,
    /// Pixels with [`Cause::Light`].
    pub light: usize,
    /// Pixels with [`Cause::Apart`].
    pub apart: usize,
}

impl Counts {
    /// Counts the causes of a picture's pixels.
    pub fn of(causes: &[Option<Cause>]) -> Self {
        let count = |cause| causes.iter().filter(|it| **it == Some(cause)).count();
        Self {
            pixels: causes.len(),
            seen: count(Cause::Seen),
            light: count(Cause::Light),
            apart: count(Cause::Apart),
        }
    }

    /// Returns a number of pixels as percent of the picture.
    pub fn percent(&self, count: usize) -> f64 {
        100.0 * count as f64 / self.pixels.max(1) as f64
    }

    /// Returns the percentage of lost pixels that are not apart: seen and light.
    pub fn lost(&self) -> f64 {
        self.percent(self.seen + self.light)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const GREY: Pixel = [100; 3];

    /// One pixel for each way to be right or wrong. `truth` is grey everywhere.
    const EXACT: [Pixel; 7] = [
        [100, 101, 99],
        [101, 99, 100],
        [100, 100, 102],
        GREY,
        GREY,
        GREY,
        GREY,
    ];
    const TESTED: [Pixel; 7] = [
        [100, 100, 108],
        [109, 100, 100],
        [0; 3],
        [91, 100, 100],
        [0; 3],
        GREY,
        [92, 108, 100],
    ];
    const APART: [bool; 7] = [false, false, false, false, true, true, false];

    #[test]
    fn pixel_is_lost_only_if_exact_is_within_1_and_the_quality_off_by_more_than_8() {
        let mut plain = [GREY; 7];
        plain[3] = [0; 3];
        let lit = lost(&[GREY; 7], &EXACT, &TESTED);
        let causes = causes(&lit, &APART, || lost(&[GREY; 7], &[GREY; 7], &plain));
        let (seen, light, apart) = (Some(Cause::Seen), Some(Cause::Light), Some(Cause::Apart));
        assert_eq!(causes, [None, light, None, seen, apart, None, None]);
        let expected = Counts {
            pixels: 7,
            seen: 1,
            light: 1,
            apart: 1,
        };
        let counts = Counts::of(&causes);
        assert_eq!(counts, expected);
        assert!((counts.lost() - 200.0 / 7.0).abs() < 1e-12);
    }

    #[test]
    fn plain_pictures_are_not_drawn_for_pixels_that_are_apart() {
        let tested = [GREY, GREY, GREY, GREY, [0; 3], GREY, GREY];
        let lit = lost(&[GREY; 7], &[GREY; 7], &tested);
        let found = causes(&lit, &APART, || panic!("nothing is in question"));
        assert_eq!(Counts::of(&found).apart, 1);
    }
}
