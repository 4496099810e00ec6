//! Writes the firmware's source for a sweep.

use std::{collections::BTreeMap, path::Path};

use super::{Contestant, Level, Setting, Sweep};
use crate::measure::{Shading, float_source};

/// Returns the source that the firmware includes. `file` is the path of the source of a scene file's
/// scene.
pub fn source(sweep: &Sweep, file: &Path, ticket: u64) -> String {
    let (width, height) = sweep.size;
    let mut source = format!(
        "pub const ORDER: firmware::Order =\n    \
         firmware::Order {{ size: ({width}, {height}), ticket: {ticket:#x} }};\n\n\
         pub struct Seen;\n\n"
    );
    if sweep.settings.iter().any(|it| !it.is_float()) {
        let (module, scene, view) = sweep.scene.names(file);
        source += &format!("{module}type Scene = {scene};\n\n{view}");
    }
    if sweep.settings.iter().any(Setting::is_float) {
        source += &float_source::view(sweep.scene, 0, Shading::BlinnPhong);
    }
    let levels = sweep.settings.iter().filter_map(own_level);
    let qualities: BTreeMap<String, String> = levels.map(quality).collect();
    source.extend(qualities.into_values());
    source += "pub const RUNS: &[firmware::Run] = &[\n";
    for setting in sweep.settings {
        let contestant = type_name(setting);
        source += &format!(
            "    firmware::Run {{ reflections: {}, scale: {}, \
             draw: firmware::swept::<{contestant}> }},\n",
            setting.reflections, setting.scale
        );
    }
    source + "];\n"
}

/// Returns the level of a setting if it is none of the library's qualities.
fn own_level(setting: &Setting) -> Option<Level> {
    match setting.contestant {
        Contestant::Fixed(level) => Some(level).filter(|it| it.library_type().is_none()),
        Contestant::Unshadowed | Contestant::Float => None,
    }
}

fn type_name(setting: &Setting) -> String {
    const PLAIN: &str = "reflet::shading::BlinnPhong";
    let (level, shading) = match setting.contestant {
        Contestant::Fixed(level) => (level, PLAIN.to_owned()),
        Contestant::Unshadowed => (Level::Fast, format!("reflet::shading::Unshadowed<{PLAIN}>")),
        Contestant::Float => return "firmware::Float<Seen>".to_owned(),
    };
    let quality = match level.library_type() {
        Some(name) => format!("reflet::quality::{name}"),
        None => quality(level).0,
    };
    format!("firmware::Varied<Scene, Seen, {quality}, {shading}>")
}

/// Returns the type name and the source of a level that the library does not have.
fn quality(level: Level) -> (String, String) {
    let numbers = level.numbers();
    let tolerance = numbers.tolerance.to_bits();
    let weight = numbers.smallest_weight.to_bits();
    let name = format!("OwnT{tolerance}W{weight}");
    let source = format!(
        "pub struct {name};\n\n\
         impl reflet::quality::Quality for {name} {{\n    \
             const SMALLEST_WEIGHT: reflet::Unit = reflet::Unit::from_bits({weight});\n    \
             const TOLERANCE: reflet::Unit = reflet::Unit::from_bits({tolerance});\n\
         }}\n\n"
    );
    (name, source)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn contestant_is_named_by_its_type() {
        let names = [
            Setting::float(3, 1),
            Setting::fixed(Level::Exact, 0),
            Setting::fixed(Level::Cut16, 9),
            Setting::unshadowed(9, 1),
        ]
        .map(|it| type_name(&it));
        let expected = [
            "firmware::Float<Seen>",
            "firmware::Varied<Scene, Seen, reflet::quality::Exact, reflet::shading::BlinnPhong>",
            "firmware::Varied<Scene, Seen, OwnT4194304W67108864, reflet::shading::BlinnPhong>",
            "firmware::Varied<Scene, Seen, reflet::quality::Fast, \
             reflet::shading::Unshadowed<reflet::shading::BlinnPhong>>",
        ];
        assert_eq!(names, expected);
    }
}
