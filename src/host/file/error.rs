//! The errors of a scene file, each with a message of one line. This file never reads a scene file.

use alloc::borrow::ToOwned;
use alloc::string::{String, ToString};
use alloc::vec::Vec;
use core::fmt::{self, Display, Formatter};
#[cfg(feature = "host")]
use std::io;
#[cfg(feature = "host")]
use std::path::{Path, PathBuf};

use super::words::words;
use crate::error::Error;
use crate::error_kind::ErrorKind;
use crate::host::line::one_line;
use crate::number::power_of_two;

/// The error of a scene file that cannot be used: the file, the scene in it, and the [`Problem`].
///
/// Its message is one line with these three parts.
///
/// ```
/// use reflet::host::file::SceneFile;
///
/// let error = SceneFile::parse("{\n  \"camera\": 3\n}", None).unwrap_err();
/// assert_eq!(
///     error.to_string(),
///     "line 2, column 13: camera must be an object, in { }, not the number 3"
/// );
/// ```
#[derive(Debug)]
pub struct FileError {
    #[cfg(feature = "host")]
    file: Option<PathBuf>,
    scene: Option<String>,
    problem: Problem,
}

/// The reason why a scene file cannot be used.
///
/// ```
/// use reflet::host::file::{FileError, Problem, SceneFile};
///
/// /// Tests whether another name of a scene may help.
/// fn depends_on_name(error: &FileError) -> bool {
///     match error.problem() {
///         Problem::Undecided { .. } | Problem::NotFound { .. } => true,
///         Problem::Unreadable(_) | Problem::TooLarge | Problem::Json { .. } => false,
///         Problem::Repeated { .. } | Problem::UnknownMaterial { .. } => false,
///         _ => false,
///     }
/// }
///
/// assert!(!depends_on_name(&SceneFile::parse("[", None).unwrap_err()));
/// let camera = r#"{"position": [0, -5, 2], "target": [0, 0, 1], "up": [0, 0, 1], "fov": 50}"#;
/// let text = format!(r#"[{{"name": "pond", "camera": {camera}}}]"#);
/// assert!(depends_on_name(&SceneFile::parse(&text, Some("bond")).unwrap_err()));
/// ```
#[derive(Debug)]
#[non_exhaustive]
pub enum Problem {
    /// The file cannot be read.
    #[cfg(feature = "host")]
    Unreadable(io::Error),
    /// The file is larger than [`MAX_BYTES`](super::MAX_BYTES).
    TooLarge,
    /// The text is not JSON, or is JSON but not a scene.
    Json {
        /// Line of the mistake, counted from 1.
        line: usize,
        /// Column of the mistake, counted from 1; 0 if the mistake is at the start of a line.
        column: usize,
        /// The part, the mistake and the fix, without the position.
        message: String,
    },
    /// The file is an empty array: it holds no scene.
    Empty,
    /// The file holds several scenes, and the caller did not name one.
    Undecided {
        /// Names of all scenes in the file.
        names: Vec<String>,
    },
    /// No scene of the file has the requested name.
    NotFound {
        /// Name of the scene that was asked for and is not in the file.
        wanted: String,
        /// Names of all scenes in the file.
        names: Vec<String>,
    },
    /// Two scenes or two materials have the same name.
    Repeated {
        /// Place of the second scene or material with this name, such as `materials[3]`.
        place: String,
        /// The name that both have.
        name: String,
        /// Place of the first scene or material with this name.
        first: String,
    },
    /// A shape names a material that the scene does not have.
    UnknownMaterial {
        /// Place of the shape, such as `spheres[3]`.
        place: String,
        /// Name of the missing material.
        name: String,
    },
    /// The scene has a background and a sky.
    TwoBackgrounds,
    /// The core refuses a part of the scene, or the scene as a whole.
    Scene(Error),
    /// A radius, or half a height, is below 2⁻²² of the scene's extent.
    TooSmall {
        /// Error of the core: kind and index of the shape.
        error: Error,
        /// Radius of the ball that holds the scene, in scene units, rounded up to a power of two.
        extent: f64,
    },
    /// The core refuses the camera.
    Camera(Error),
}

impl FileError {
    pub(super) fn new(problem: Problem) -> Self {
        Self {
            #[cfg(feature = "host")]
            file: None,
            scene: None,
            problem,
        }
    }

    /// Creates the error for what the parser refuses at a path of keys, such as `spheres[3].radius`.
    pub(super) fn json(path: &str, error: &serde_json::Error) -> Self {
        let (line, column) = (error.line(), error.column());
        let whole = error.to_string();
        let message = whole
            .strip_suffix(&format!(" at line {line} column {column}"))
            .unwrap_or(&whole);
        // A dot stands for the scene itself, and a question mark for a key that was not read.
        let place = path.trim_end_matches(['.', '?']);
        Self::new(Problem::Json {
            line,
            column,
            message: words(place, message),
        })
    }

    #[cfg(feature = "host")]
    pub(super) fn in_file(mut self, file: Option<&Path>) -> Self {
        self.file = file.map(Path::to_owned);
        self
    }

    pub(super) fn in_scene(mut self, scene: Option<&str>) -> Self {
        self.scene = scene.map(str::to_owned);
        self
    }

    /// Returns the path of the file, or `None` if the scene was parsed from text.
    #[cfg(feature = "host")]
    pub fn file(&self) -> Option<&Path> {
        self.file.as_deref()
    }

    /// Returns the name of the scene that has the problem. It is `None` if the scene has no name or the
    /// problem is not in one scene.
    pub fn scene(&self) -> Option<&str> {
        self.scene.as_deref()
    }

    /// Returns the reason why the file cannot be used.
    pub fn problem(&self) -> &Problem {
        &self.problem
    }
}

impl core::error::Error for FileError {}

impl Display for FileError {
    fn fmt(&self, formatter: &mut Formatter<'_>) -> fmt::Result {
        #[cfg(feature = "host")]
        if let Some(file) = &self.file {
            write!(formatter, "{}: ", one_line(&file.display().to_string()))?;
        }
        if let Some(scene) = &self.scene {
            write!(formatter, "scene {}: ", one_line(scene))?;
        }
        write!(formatter, "{}", self.problem)
    }
}

impl Display for Problem {
    fn fmt(&self, formatter: &mut Formatter<'_>) -> fmt::Result {
        formatter.write_str(&one_line(&self.words()))
    }
}

impl Problem {
    fn words(&self) -> String {
        match self {
            #[cfg(feature = "host")]
            Self::Unreadable(error) => error.to_string(),
            Self::TooLarge => {
                let megabytes = super::MAX_BYTES / 1_000_000;
                format!("a scene file may have {megabytes} MB at most")
            }
            Self::Json {
                line,
                column,
                message,
            } => format!("line {line}, column {column}: {message}"),
            Self::Empty => "there is no scene in the file".to_owned(),
            Self::Undecided { names } => format!("choose one of the scenes {}", names.join(", ")),
            Self::NotFound { wanted, names } => {
                format!("there is no scene {wanted}, only {}", names.join(", "))
            }
            Self::Repeated { place, name, first } => {
                format!("{place} has the name {name} of {first}")
            }
            Self::UnknownMaterial { place, name } => {
                format!("{place}.material: there is no material {name}: add it to materials")
            }
            Self::TwoBackgrounds => "a scene has a background or a sky: leave one out".to_owned(),
            Self::Scene(error) => refused(*error),
            Self::TooSmall { error, extent } => {
                let most = rounded(*extent);
                let least = rounded(extent * power_of_two(-22));
                format!(
                    "{}; here the extent is {most} and the least {least}",
                    refused(*error)
                )
            }
            Self::Camera(error) => error.to_string(),
        }
    }
}

/// Rounds a positive, finite number to four significant digits.
fn rounded(number: f64) -> f64 {
    // Formatting with a precision would link tables of `core` that nothing else reads.
    let (mut unit, mut parts) = (1.0, 1.0);
    while number >= 1e4 * unit {
        unit *= 10.0;
    }
    while number * parts < 1e3 {
        parts *= 10.0;
    }
    // From 2^52 on, a number of 64 bits has no fraction: adding it rounds.
    let digits = number * parts / unit + power_of_two(52) - power_of_two(52);
    digits * unit / parts
}

macro_rules! refused {
    ($parameters:tt $({
        $list:ident $kind:ident $described:ident $add:ident $fields:tt $room:ident $too_many:ident $keys:tt
    })*) => {
        /// Returns the message for a part that the core refuses, such as `spheres[3]: ...`.
        ///
        /// If there are too many parts, it states how many fit. The core's own message does not fit: it advises a larger
        /// type, and a file has no type.
        fn refused(error: Error) -> String {
            let names = [
                $((stringify!($kind), stringify!($list)),)*
                ("light", "lights"),
                ("sun", "suns"),
                ("material", "materials"),
            ];
            let list = names.iter().find(|(part, _)| *part == error.part());
            let Some(((_, list), index)) = list.zip(error.index()) else {
                let is_whole = error.part() == "scene";
                return if is_whole { error.kind().to_string() } else { error.to_string() };
            };
            // Counted from 0, the first part that does not fit has as its number how many do.
            match error.kind() {
                $(ErrorKind::$too_many |)* ErrorKind::TooManyLights | ErrorKind::TooManyMaterials => {
                    format!("{list}[{index}]: there is room for {index} {list} at most")
                }
                fault => format!("{list}[{index}]: {fault}"),
            }
        }
    };
}
kinds!(shapes, refused);

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn four_digits_are_left_of_a_number() {
        let numbers = [12_345.6, 9_999.6, 1e3, 999.96, 1.0, power_of_two(-22)];
        let rounded = numbers.map(|number| format!("{}", rounded(number)));
        assert_eq!(
            rounded,
            ["12350", "10000", "1000", "1000", "1", "0.0000002384"]
        );
    }
}
