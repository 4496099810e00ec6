//! What is measured: which scene on which core, with which settings; and the job it makes for
//! the firmware.

use std::hash::{DefaultHasher, Hash, Hasher};
use std::path::Path;

use clap::{
    Args, ValueEnum,
    builder::{ArgPredicate, PossibleValue},
    value_parser,
};
pub use command_line::Shading;
use command_line::{Quality as Fixed, size};
use embedded_graphics::geometry::Size;

use super::{build_profile::BuildProfile, cores::Core, float_source, scene::Scene};

/// Returns a size as the command line takes it, such as `64x64`.
pub fn words(size: Size) -> String {
    format!("{}x{}", size.width, size.height)
}

pub fn pixels(size: Size) -> u64 {
    u64::from(size.width) * u64::from(size.height)
}

/// How exactly fixed point computes, or the float port instead.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Quality {
    Fixed(Fixed),
    Float,
}

impl Quality {
    pub const FAST: Self = Self::Fixed(Fixed::Fast);
    pub const SMALL: Self = Self::Fixed(Fixed::Small);
    pub const EXACT: Self = Self::Fixed(Fixed::Exact);

    pub fn name(self) -> &'static str {
        match self {
            Self::Fixed(quality) => quality.name(),
            Self::Float => "float",
        }
    }
}

impl ValueEnum for Quality {
    fn value_variants<'a>() -> &'a [Self] {
        &[
            Self::FAST,
            Self::SMALL,
            Self::EXACT,
            Self::Fixed(Fixed::Smooth2),
            Self::Fixed(Fixed::Smooth4),
            Self::Float,
        ]
    }

    fn to_possible_value(&self) -> Option<PossibleValue> {
        Some(PossibleValue::new(self.name()))
    }
}

#[derive(Args, Clone, Copy, Debug)]
pub struct Settings {
    /// Width and height in pixels
    #[arg(long, value_name = "WxH", default_value = "64x64", value_parser = size)]
    #[arg(default_value_ifs([
        ("clock", ArgPredicate::IsPresent, "240x240"),
        ("board", ArgPredicate::IsPresent, "240x240"),
    ]))]
    pub size: Size,

    /// How often a ray is reflected, from 0 to 255
    #[arg(long, value_name = "N", default_value_t = 4, value_parser = value_parser!(u8))]
    #[arg(allow_negative_numbers = true)]
    pub reflections: u8,

    /// How light shines on a surface
    #[arg(long, value_enum, default_value_t = Shading::BlinnPhong)]
    pub shading: Shading,

    /// How exactly fixed point computes, or the float port instead
    #[arg(long, value_enum, default_value_t = Quality::FAST)]
    pub quality: Quality,

    /// Link everything that any scene needs, whether this one does or not
    #[arg(long = "whole")]
    pub is_whole: bool,
}

#[derive(Clone, Debug)]
pub struct Task {
    pub core: &'static Core,
    pub scene: Scene,
    pub settings: Settings,
    pub profile: &'static BuildProfile,
}

impl Task {
    /// A scene with four reflections and Blinn-Phong shading, and what it needs linked.
    pub fn new(core: &'static Core, scene: Scene, size: Size, quality: Quality) -> Self {
        let settings = Settings {
            size,
            reflections: 4,
            shading: Shading::BlinnPhong,
            quality,
            is_whole: false,
        };
        Self {
            core,
            scene,
            settings,
            profile: BuildProfile::RECOMMENDED,
        }
    }

    /// Returns the source that the firmware includes, and the number that comes back with its report. `scene` is where
    /// the source of a file's scene lies.
    pub fn job(&self, scene: &Path) -> (String, u64) {
        let contestant = self.contestant(scene);
        let mut hasher = DefaultHasher::new();
        (self.core.name, &contestant).hash(&mut hasher);
        let ticket = hasher.finish();
        (self::ticket(ticket) + &contestant, ticket)
    }

    /// Returns the source of the type `Job`: what draws the scene with these settings.
    pub(super) fn contestant(&self, scene: &Path) -> String {
        match self.settings.quality {
            Quality::Fixed(quality) => self.fixed(&quality.type_name(), scene),
            Quality::Float => self.float(),
        }
    }

    fn fixed(&self, quality: &str, scene: &Path) -> String {
        let (reflections, shading) = (self.settings.reflections, self.settings.shading.type_name());
        let (module, scene, view) = self.scene.names(scene);
        let contestant = self.scene.contestant(self.settings.is_whole);
        format!(
            "{module}\
             pub struct Seen;\n\n\
             {view}pub type Job =\n    \
                 firmware::{contestant}<{scene}, Seen, reflet::quality::{quality}, \
                 reflet::shading::{shading}, {reflections}>;\n"
        )
    }

    fn float(&self) -> String {
        let Settings {
            reflections,
            shading,
            ..
        } = self.settings;
        let view = float_source::view(&self.scene, reflections, shading);
        format!("pub struct Seen;\n\n{view}pub type Job = firmware::Float<Seen>;\n")
    }
}

/// Returns the source of the number that comes back with the firmware's report.
pub(crate) fn ticket(ticket: u64) -> String {
    format!("pub const TICKET: u64 = {ticket:#x};\n\n")
}
