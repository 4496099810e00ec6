//! Sizes, qualities and shadings as the command line names them.

use clap::ValueEnum;
use embedded_graphics::geometry::Size;
use reflet::host::reference;

/// Parses the width and height of a picture, such as `320x240`.
///
/// # Errors
/// Fails if the text is not two numbers from 1 to 65535 with an `x` between them.
pub fn size(text: &str) -> Result<Size, &'static str> {
    let side = |digits: &str| {
        if digits.bytes().all(|digit| digit.is_ascii_digit()) {
            digits.parse::<u16>().ok().filter(|&side| side > 0)
        } else {
            None
        }
    };
    let sides = text
        .split_once('x')
        .map(|(width, height)| (side(width), side(height)));
    match sides {
        Some((Some(width), Some(height))) => Ok(Size::new(width.into(), height.into())),
        _ => Err("not a width and a height from 1 to 65535, such as 320x240"),
    }
}

/// A shading of the library as a value.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, ValueEnum)]
pub enum Shading {
    BlinnPhong,
    Phong,
    Normals,
}

impl Shading {
    /// Returns the name of the shading on the command line.
    pub fn name(self) -> &'static str {
        match self {
            Self::BlinnPhong => "blinn-phong",
            Self::Phong => "phong",
            Self::Normals => "normals",
        }
    }

    /// Returns the name of the library's type, which is also the variant's name.
    pub fn type_name(self) -> String {
        format!("{self:?}")
    }
}

impl From<Shading> for reference::Shading {
    fn from(shading: Shading) -> Self {
        match shading {
            Shading::BlinnPhong => Self::BlinnPhong,
            Shading::Phong => Self::Phong,
            Shading::Normals => Self::Normals,
        }
    }
}

/// A quality of the library as a value.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, ValueEnum)]
pub enum Quality {
    Fast,
    Small,
    Exact,
    /// As `Fast`, with the smooth edges of `Smooth<2>`.
    Smooth2,
    /// As `Fast`, with the smooth edges of `Smooth<4>`.
    Smooth4,
}

impl Quality {
    /// Returns the name of the quality on the command line.
    pub fn name(self) -> &'static str {
        match self {
            Self::Fast => "fast",
            Self::Small => "small",
            Self::Exact => "exact",
            Self::Smooth2 => "smooth2",
            Self::Smooth4 => "smooth4",
        }
    }

    /// Returns the library's type.
    pub fn type_name(self) -> String {
        match self {
            Self::Smooth2 => "Smooth<2>".to_owned(),
            Self::Smooth4 => "Smooth<4>".to_owned(),
            _ => format!("{self:?}"),
        }
    }
}
