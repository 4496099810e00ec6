//! Decides which pixels are lost, and why. Knows only colours, never a scene.

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

/// The same picture three times.
#[derive(Clone, Copy, Debug)]
pub struct Views<'a> {
    /// Picture of the reference.
    pub truth: &'a [[u8; 3]],
    /// Picture of `Exact`.
    pub exact: &'a [[u8; 3]],
    /// Picture of the tested quality.
    pub tested: &'a [[u8; 3]],
}

impl Views<'_> {
    /// Tests whether `Exact` has a pixel right.
    pub fn is_exact_right(&self, index: usize) -> bool {
        difference(self.exact[index], self.truth[index]) <= RIGHT
    }

    /// Tests whether `Exact` has a pixel right that the tested quality has visibly wrong.
    pub fn is_lost(&self, index: usize) -> bool {
        self.is_exact_right(index) && difference(self.tested[index], self.truth[index]) > VISIBLE
    }
}

fn difference(one: [u8; 3], other: [u8; 3]) -> u8 {
    let channels = one.iter().zip(other).map(|(a, b)| a.abs_diff(b));
    channels.max().unwrap_or(0)
}

/// Returns for each pixel why it is lost, or `None` if it is not. `plain` draws the views without
/// shadows and highlights; it is called only if a lost pixel is not apart.
pub fn causes<'a>(
    lit: Views<'_>,
    is_apart: &[bool],
    plain: impl FnOnce() -> Views<'a>,
) -> Vec<Option<Cause>> {
    let indices = 0..lit.truth.len();
    let is_in_question = |it: usize| lit.is_lost(it) && !is_apart[it];
    let plain = indices.clone().any(is_in_question).then(plain);
    let cause = |index| match is_apart[index] {
        true => Cause::Apart,
        false if plain.is_some_and(|it| it.is_lost(index)) => Cause::Seen,
        false => Cause::Light,
    };
    indices
        .map(|index| lit.is_lost(index).then(|| cause(index)))
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

    /// Tests whether any pixel is lost, apart or not.
    pub fn is_any(&self) -> bool {
        self.seen + self.light + self.apart > 0
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const GREY: [u8; 3] = [100; 3];

    /// One pixel for each way to be right or wrong. `truth` is grey everywhere.
    const EXACT: [[u8; 3]; 7] = [
        [100, 101, 99],
        [101, 99, 100],
        [100, 100, 102],
        GREY,
        GREY,
        GREY,
        GREY,
    ];
    const TESTED: [[u8; 3]; 7] = [
        [100, 100, 108],
        [109, 100, 100],
        [0; 3],
        [91, 100, 100],
        [0; 3],
        GREY,
        [92, 108, 100],
    ];
    const APART: [bool; 7] = [false, false, false, false, true, true, false];

    fn views<'a>(exact: &'a [[u8; 3]], tested: &'a [[u8; 3]]) -> Views<'a> {
        Views {
            truth: &[GREY; 7],
            exact,
            tested,
        }
    }

    #[test]
    fn pixel_is_lost_only_if_exact_is_within_1_and_the_quality_off_by_more_than_8() {
        let mut plain = [GREY; 7];
        plain[3] = [0; 3];
        let causes = causes(views(&EXACT, &TESTED), &APART, || views(&[GREY; 7], &plain));
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
        assert!(counts.is_any() && (counts.lost() - 200.0 / 7.0).abs() < 1e-12);
    }

    #[test]
    fn plain_pictures_are_not_drawn_for_pixels_that_are_apart() {
        let tested = [GREY, GREY, GREY, GREY, [0; 3], GREY, GREY];
        let never = || -> Views<'static> { panic!("nothing is in question") };
        let found = causes(views(&[GREY; 7], &tested), &APART, never);
        assert_eq!(Counts::of(&found).apart, 1);
    }
}
