//! Writes a film with at most 256 colours. One palette for all frames: a colour does not flicker.

use std::collections::HashMap;

use color_quant::NeuQuant;
use gif::{Encoder, EncodingError, Frame, Repeat};

/// Most colours of a palette.
const MOST: usize = 256;

/// Pixels from which the colours are learnt, if the frames have that many. Fewer leave visible errors.
const SAMPLE: usize = 200_000;

/// Returns frames in RGB8 as a GIF that repeats without end. Each is shown for `delay` hundredths of a second.
pub fn encoded(
    frames: &[Vec<u8>],
    [width, height]: [u16; 2],
    delay: u16,
) -> Result<Vec<u8>, EncodingError> {
    let palette = Palette::of(frames);
    let mut encoder = Encoder::new(Vec::new(), width, height, &palette.colors)?;
    encoder.set_repeat(Repeat::Infinite)?;
    for frame in frames {
        encoder.write_frame(&Frame {
            width,
            height,
            delay,
            buffer: palette.indices(frame).into(),
            ..Frame::default()
        })?;
    }
    encoder.into_inner()
}

/// A palette, and the index of each colour of the frames.
struct Palette {
    /// Three bytes a colour.
    colors: Vec<u8>,
    indices: HashMap<[u8; 3], u8>,
}

impl Palette {
    /// Returns the palette of frames in RGB8. If they have more than 256 colours, the nearest of 256
    /// colours stands for each.
    fn of(frames: &[Vec<u8>]) -> Self {
        let pixels = || frames.iter().flat_map(|frame| pixels(frame));
        let mut indices: HashMap<_, _> = pixels().map(|pixel| (pixel, 0)).collect();
        if indices.len() <= MOST {
            let mut colors: Vec<_> = indices.keys().copied().collect();
            colors.sort_unstable();
            indices = colors.iter().copied().zip(0..=u8::MAX).collect();
            let colors = colors.concat();
            return Self { colors, indices };
        }
        let opaque: Vec<u8> = pixels().flat_map(with_alpha).collect();
        // The quantiser takes one pixel of `step`, which is from 1 to 30.
        let step = (opaque.len() / 4 / SAMPLE).clamp(1, 30);
        let step = i32::try_from(step).expect("it is at most 30");
        let learnt = NeuQuant::new(step, MOST, &opaque);
        for (&pixel, index) in &mut indices {
            let nearest = learnt.index_of(&with_alpha(pixel));
            *index = u8::try_from(nearest).expect("a palette has at most 256 colours");
        }
        // The mean of the pixels for which a colour stands is nearer to them than what was learnt.
        let mut sums = [(0, 0); 3 * MOST];
        for pixel in pixels() {
            let first = 3 * usize::from(indices[&pixel]);
            for ((sum, count), part) in sums[first..].iter_mut().zip(pixel) {
                (*sum, *count) = (*sum + u64::from(part), *count + 1);
            }
        }
        let means = sums.map(|(sum, count)| sum / count.max(1));
        let colors = means.map(|mean| u8::try_from(mean).expect("it is a mean of bytes"));
        let colors = colors.into();
        Self { colors, indices }
    }

    /// Returns the index of each pixel of one of the frames.
    fn indices(&self, frame: &[u8]) -> Vec<u8> {
        pixels(frame).map(|pixel| self.indices[&pixel]).collect()
    }
}

fn pixels(frame: &[u8]) -> impl Iterator<Item = [u8; 3]> {
    let pixels = frame.chunks_exact(3);
    pixels.map(|pixel| [pixel[0], pixel[1], pixel[2]])
}

fn with_alpha([red, green, blue]: [u8; 3]) -> [u8; 4] {
    [red, green, blue, u8::MAX]
}
