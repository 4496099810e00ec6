//! Compares two pictures of the same size, pixel by pixel. This file knows nothing of scenes.

use std::error::Error;
use std::fmt::{self, Display, Formatter};

use super::reference::Picture;

/// The difference between two pictures: shares of similar pixels, signal-to-noise ratio, and maximum.
///
/// Each share is a part of all pixels, 0 to 1. A pixel counts only if all three of its channels are
/// within the limit. For pictures without pixels every share is 1.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Difference {
    /// Share of pixels that are equal in both pictures.
    pub same: f64,
    /// Share of pixels that differ by at most 1 (of 255) in every channel.
    pub within1: f64,
    /// Share of pixels that differ by at most 8 (of 255) in every channel.
    pub within8: f64,
    /// Peak signal-to-noise ratio in decibels over all channels, 10 log₁₀(255² / mean squared
    /// difference); infinite if the pictures are equal.
    pub psnr: f64,
    /// Largest difference of any channel of any pixel, 0 to 255.
    pub max: u8,
}

/// Compares two pictures; the order of the two does not matter.
///
/// # Errors
///
/// The pictures do not have the same size.
///
/// ```
/// use reflet::host::compare::compare;
/// use reflet::host::reference::Picture;
///
/// let left = Picture { width: 2, height: 1, pixels: vec![[10, 20, 30], [40, 50, 60]] };
/// let right = Picture { width: 2, height: 1, pixels: vec![[10, 20, 30], [40, 50, 57]] };
/// let difference = compare(&left, &right).unwrap();
/// assert_eq!((difference.same, difference.within1, difference.within8), (0.5, 0.5, 1.0));
/// assert_eq!(difference.max, 3);
/// assert_eq!(difference.psnr, 10.0 * (255.0_f64.powi(2) * 6.0 / 9.0).log10());
/// ```
pub fn compare(a: &Picture, b: &Picture) -> Result<Difference, SizeMismatch> {
    SizeMismatch::refuse(a, b)?;
    let pairs = || a.pixels.iter().zip(&b.pixels).map(|(a, b)| apart(a, b));
    // Entry i counts the pixels whose worst channel differs by i.
    let mut counts = [0_usize; 256];
    pairs().for_each(|[red, green, blue]| counts[usize::from(red.max(green).max(blue))] += 1);
    let square = |channel: u8| u64::from(channel).pow(2);
    let squares: u64 = pairs().flatten().map(square).sum();
    let channels = 3 * a.pixels.len();
    let max = counts.iter().rposition(|count| *count > 0).unwrap_or(0);
    Ok(Difference {
        same: share(&counts[..1], a.pixels.len()),
        within1: share(&counts[..=1], a.pixels.len()),
        within8: share(&counts[..=8], a.pixels.len()),
        psnr: decibels(squares, channels),
        max: max as u8,
    })
}

/// The error of comparing two pictures of different sizes.
///
/// ```
/// use reflet::host::compare::{SizeMismatch, compare};
/// use reflet::host::reference::Picture;
///
/// let dot = Picture { width: 1, height: 1, pixels: vec![[0; 3]] };
/// let line = Picture { width: 2, height: 1, pixels: vec![[0; 3]; 2] };
/// let error: SizeMismatch = compare(&dot, &line).unwrap_err();
/// assert_eq!(error.to_string(), "a picture of 1x1 and one of 2x1 cannot be compared");
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct SizeMismatch {
    /// For each of the two pictures: its width, its height, and the number of its pixels.
    sizes: [[u64; 3]; 2],
}

impl SizeMismatch {
    fn refuse(a: &Picture, b: &Picture) -> Result<(), Self> {
        let size = |it: &Picture| [it.width.into(), it.height.into(), it.pixels.len() as u64];
        let sizes = [size(a), size(b)];
        if sizes[0] == sizes[1] { Ok(()) } else { Err(Self { sizes }) }
    }
}

impl Error for SizeMismatch {}

impl Display for SizeMismatch {
    fn fmt(&self, formatter: &mut Formatter<'_>) -> fmt::Result {
        let [a, b] = self.sizes.map(|[width, height, pixels]| {
            if width * height == pixels {
                format!("{width}x{height}")
            } else {
                format!("{width}x{height} with {pixels} pixels")
            }
        });
        write!(
            formatter,
            "a picture of {a} and one of {b} cannot be compared"
        )
    }
}

fn apart(a: &[u8; 3], b: &[u8; 3]) -> [u8; 3] {
    [0, 1, 2].map(|channel| a[channel].abs_diff(b[channel]))
}

fn share(counts: &[usize], of: usize) -> f64 {
    match of {
        0 => 1.0,
        of => counts.iter().sum::<usize>() as f64 / of as f64,
    }
}

fn decibels(squares: u64, channels: usize) -> f64 {
    match squares {
        0 => f64::INFINITY,
        squares => 10.0 * (255.0_f64.powi(2) * channels as f64 / squares as f64).log10(),
    }
}

#[cfg(test)]
mod tests;
