//! The settings that are asked for, and the firmware's source made of them.

use std::{
    fmt::Write as _,
    hash::{DefaultHasher, Hash, Hasher},
    path::Path,
};

use serde::Deserialize;

use crate::measure::{cores::Core, float_source, scene::Scene, task::Size};

/// One setting.
#[derive(Clone, Debug, PartialEq, Eq, Hash, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Run {
    contestant: Contestant,
    reflections: u8,
    scale: u8,
    /// Is built in, and not drawn.
    #[serde(default)]
    pub skip: bool,
}

/// What draws.
#[derive(Clone, Debug, PartialEq, Eq, Hash, Deserialize)]
#[serde(rename_all = "snake_case", deny_unknown_fields)]
enum Contestant {
    Float,
    Fixed { quality: Quality, shadows: bool },
}

/// A quality of the library's, or one by its numbers.
#[derive(Clone, Debug, PartialEq, Eq, Hash, Deserialize)]
#[serde(untagged)]
enum Quality {
    Named(Named),
    Own(Own),
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Deserialize)]
#[serde(rename_all = "snake_case")]
enum Named {
    Fast,
    Fine,
    Exact,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Deserialize)]
#[serde(deny_unknown_fields)]
struct Own {
    stride: u8,
    tolerance: u32,
    smallest_weight: u32,
}

/// Reads the settings.
pub fn read(text: &str) -> Result<Vec<Run>, String> {
    let runs: Vec<Run> = serde_json::from_str(text).map_err(|error| error.to_string())?;
    for (index, run) in runs.iter().enumerate() {
        let place = |words: &str| Err(format!("setting {index}: {words}"));
        if run.scale == 0 {
            return place("`scale` is not 1 or more");
        }
        if let Some(own) = run.own() {
            if !matches!(own.stride, 1 | 2 | 4) {
                return place("`stride` is not 1, 2 or 4");
            }
            if own.tolerance > 1 << 30 || own.smallest_weight > 1 << 30 {
                return place("`tolerance` or `smallest_weight` is more than 2^30");
            }
        }
    }
    Ok(runs)
}

/// Comes back with every report.
pub fn ticket(core: &Core, runs: &[Run]) -> u64 {
    let mut hasher = DefaultHasher::new();
    (core.name, runs).hash(&mut hasher);
    hasher.finish()
}

/// The source that the firmware includes; `file` is where the source of a file's scene lies.
pub fn source(scene: &Scene, file: &Path, size: Size, ticket: u64, runs: &[Run]) -> String {
    let Size { width, height } = size;
    let mut source = format!(
        "// Written by `cargo xtask sweep`.\n\n\
         pub const ORDER: firmware::Order =\n    \
         firmware::Order {{ size: ({width}, {height}), ticket: {ticket:#x} }};\n\n\
         pub struct Seen;\n\n"
    );
    if runs
        .iter()
        .any(|run| matches!(run.contestant, Contestant::Fixed { .. }))
    {
        let (module, scene, camera) = scene.names(file);
        source += &format!(
            "{module}type Scene = {scene};\n\n\
             impl firmware::View for Seen {{\n    \
                 const CAMERA: reflet::Camera = {camera};\n\
             }}\n\n"
        );
    }
    if runs.iter().any(|run| run.contestant == Contestant::Float) {
        let (scene, camera) = scene.reference();
        let (scene, camera) = (float_source::scene(&scene), float_source::camera(&camera));
        source += &format!(
            "impl firmware::FloatView for Seen {{\n\
                 const SCENE: float_port::Scene<'static> = {scene};\n\
                 const CAMERA: float_port::Camera = {camera};\n\
                 const REFLECTIONS: u32 = 0;\n\
                 const SHADING: float_port::Shading = float_port::Shading::BlinnPhong;\n\
             }}\n\n"
        );
    }
    let mut qualities: Vec<Own> = runs.iter().filter_map(Run::own).collect();
    qualities.sort_by_key(Own::name);
    qualities.dedup();
    source.extend(qualities.iter().map(Own::source));
    source += "pub const RUNS: &[firmware::Run] = &[\n";
    for run in runs {
        let Run {
            reflections,
            scale,
            skip,
            ..
        } = run;
        let contestant = run.type_name();
        writeln!(
            source,
            "    firmware::Run {{ reflections: {reflections}, scale: {scale}, skip: {skip}, \
             draw: firmware::swept::<{contestant}> }},"
        )
        .expect("a string takes all");
    }
    source + "];\n"
}

impl Run {
    fn own(&self) -> Option<Own> {
        match &self.contestant {
            Contestant::Fixed {
                quality: Quality::Own(own),
                ..
            } => Some(*own),
            _ => None,
        }
    }

    fn type_name(&self) -> String {
        let Contestant::Fixed { quality, shadows } = &self.contestant else {
            return "firmware::Float<Seen>".to_owned();
        };
        let quality = match quality {
            Quality::Named(Named::Fast) => "reflet::Fast".to_owned(),
            Quality::Named(Named::Fine) => "reflet::Fine".to_owned(),
            Quality::Named(Named::Exact) => "reflet::Exact".to_owned(),
            Quality::Own(own) => own.name(),
        };
        let shading = match shadows {
            true => "reflet::BlinnPhong",
            false => "reflet::Unshadowed<reflet::BlinnPhong>",
        };
        format!("firmware::Varied<Scene, Seen, {quality}, {shading}>")
    }
}

impl Own {
    fn name(&self) -> String {
        let Self {
            stride,
            tolerance,
            smallest_weight,
        } = self;
        format!("Own{stride}T{tolerance}W{smallest_weight}")
    }

    fn source(&self) -> String {
        let Self {
            stride,
            tolerance,
            smallest_weight,
        } = self;
        format!(
            "pub struct {};\n\n\
             impl reflet::Quality for {0} {{\n    \
                 const SMALLEST_WEIGHT: reflet::Unit = reflet::Unit::from_bits({smallest_weight});\n    \
                 const STRIDE: u32 = {stride};\n    \
                 const TOLERANCE: reflet::Unit = reflet::Unit::from_bits({tolerance});\n\
             }}\n\n",
            self.name()
        )
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn settings_are_read_and_named() {
        let text = r#"[
            {"contestant": "float", "reflections": 3, "scale": 1},
            {"contestant": {"fixed": {"quality": "fine", "shadows": true}}, "reflections": 0, "scale": 2},
            {"contestant": {"fixed": {"quality": {"stride": 1, "tolerance": 0, "smallest_weight": 1},
             "shadows": false}}, "reflections": 9, "scale": 1}
        ]"#;
        let names: Vec<_> = read(text).unwrap().iter().map(Run::type_name).collect();
        let expected = [
            "firmware::Float<Seen>",
            "firmware::Varied<Scene, Seen, reflet::Fine, reflet::BlinnPhong>",
            "firmware::Varied<Scene, Seen, Own1T0W1, reflet::Unshadowed<reflet::BlinnPhong>>",
        ];
        assert_eq!(names, expected);
    }

    #[test]
    fn settings_that_no_firmware_has_are_refused() {
        let run = |contestant: &str, scale: u8| {
            read(&format!(
                r#"[{{"contestant": {contestant}, "reflections": 1, "scale": {scale}}}]"#
            ))
        };
        let own = r#"{"fixed": {"shadows": true, "quality": {"stride": 3, "tolerance": 0, "smallest_weight": 1}}}"#;
        assert!(run(r#""float""#, 1).is_ok());
        assert_eq!(
            run(r#""float""#, 0).unwrap_err(),
            "setting 0: `scale` is not 1 or more"
        );
        assert_eq!(
            run(own, 1).unwrap_err(),
            "setting 0: `stride` is not 1, 2 or 4"
        );
        assert!(run(r#""double""#, 1).is_err());
    }
}
