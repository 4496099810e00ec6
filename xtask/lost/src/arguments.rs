//! Parses the command line of `lost`. Never opens a file.

use std::path::PathBuf;

use clap::builder::PossibleValue;
use clap::{Parser, ValueEnum};
use command_line::{Chosen, Failure, parse, size};
use embedded_graphics::geometry::Size;
use lost::case;
use lost::families::Family;

/// Counts the pixels that interpolation loses: `Exact` is within 1 of the double-precision
/// reference, and the quality is off by more than 8.
///
/// A lost pixel is `apart` if its path is reflected off a curved shape or off several flat ones. Of
/// the others, `seen` are also lost without shadows and highlights, and `light` are not.
///
/// The exit code is 0; 1 if a limit is exceeded; and 2 after an error, which is one line.
#[derive(Parser)]
#[command(name = "lost", max_term_width = 100)]
pub struct Arguments {
    /// Scene files, folders of scene files, or built-in scenes
    #[arg(
        value_name = "SCENE",
        required_unless_present = "families",
        conflicts_with = "families"
    )]
    pub scenes: Vec<PathBuf>,

    #[command(flatten)]
    pub chosen: Chosen,

    /// Size of the pictures, several times for several sizes: by default 96x96 and 160x120, or 96x72
    /// for random scenes
    #[arg(long = "size", value_name = "WxH", value_parser = size)]
    pub sizes: Vec<Size>,

    /// Qualities to test
    #[arg(long, value_enum, value_delimiter = ',', default_value = "fast,fine")]
    pub qualities: Vec<TestedQuality>,

    /// Number of reflections of scene files and built-in scenes
    #[arg(
        long,
        value_name = "N",
        default_value_t = 4,
        conflicts_with = "families"
    )]
    pub reflections: u8,

    /// Draw random scenes of these families
    #[arg(long, value_enum, value_delimiter = ',', num_args = 0..=1, default_missing_value = "all")]
    pub families: Vec<Families>,

    /// Number of random scenes, over all families together
    #[arg(
        long = "scenes",
        value_name = "N",
        default_value_t = 300,
        conflicts_with = "scenes"
    )]
    pub count: usize,

    /// Seed of the random scenes
    #[arg(long, value_name = "N", default_value_t = 1, conflicts_with = "scenes")]
    pub seed: u64,

    /// Write the random scenes as scene files into this folder, and draw nothing
    #[arg(long, value_name = "DIR", conflicts_with = "scenes")]
    pub write: Option<PathBuf>,

    /// Write the pictures into this folder, with lost pixels in magenta; of random scenes only
    /// those that lose anything
    #[arg(long, value_name = "DIR", conflicts_with = "write")]
    pub pictures: Option<PathBuf>,

    /// Most lost pixels of a picture in percent, without those that are apart
    #[arg(long, value_name = "P", conflicts_with = "write")]
    pub limit_scene: Option<f64>,

    /// Most lost pixels of all pictures of a quality in percent, without those that are apart
    #[arg(long, value_name = "P", conflicts_with = "write")]
    pub limit_mean: Option<f64>,
}

/// A tested quality on the command line.
#[derive(Clone, Copy)]
pub struct TestedQuality(case::Quality);

/// A family on the command line, or `all` of them.
#[derive(Clone, Copy)]
pub enum Families {
    All,
    One(Family),
}

impl ValueEnum for TestedQuality {
    fn value_variants<'a>() -> &'a [Self] {
        &const {
            let [fast, fine, draft] = case::Quality::ALL;
            [Self(fast), Self(fine), Self(draft)]
        }
    }

    fn to_possible_value(&self) -> Option<PossibleValue> {
        Some(PossibleValue::new(self.0.name()))
    }
}

impl ValueEnum for Families {
    fn value_variants<'a>() -> &'a [Self] {
        &const {
            let mut all = [Self::All; 1 + Family::ALL.len()];
            let mut index = 0;
            while index < Family::ALL.len() {
                all[1 + index] = Self::One(Family::ALL[index]);
                index += 1;
            }
            all
        }
    }

    fn to_possible_value(&self) -> Option<PossibleValue> {
        Some(PossibleValue::new(match self {
            Self::All => "all",
            Self::One(family) => family.name(),
        }))
    }
}

impl Arguments {
    /// Parses the command line. An error is one line.
    pub fn read() -> Result<Self, Failure> {
        parse()
    }

    /// Returns the sizes of pictures, or `default` if none is named.
    pub fn sizes_or(&self, default: &[Size]) -> Vec<Size> {
        match self.sizes.is_empty() {
            true => default.to_vec(),
            false => self.sizes.clone(),
        }
    }

    /// Returns the tested qualities, each once.
    pub fn qualities(&self) -> Vec<case::Quality> {
        let is_named = |it: &case::Quality| self.qualities.iter().any(|named| named.0 == *it);
        case::Quality::ALL.into_iter().filter(is_named).collect()
    }

    /// Returns the named families, each once, in the order of tables.
    pub fn families(&self) -> Vec<Family> {
        let is_named = |family: &Family| {
            self.families.iter().any(|named| match named {
                Families::All => true,
                Families::One(it) => it == family,
            })
        };
        Family::ALL.into_iter().filter(is_named).collect()
    }
}
