//! Describes in words what a scene needs of the library.

use reflet::needs::{Need, Needs};
use serde_json::json;

use command_line::{Quality, Settings, Shading, json_line, one_line};

/// Returns one line of text for each need: its name, whether the firmware has it, and why.
pub fn text(scene: &str, needs: Needs, settings: Settings) -> String {
    let lines = lines(needs, settings).into_iter().map(|(need, why)| {
        let place = if need.is_needed { "in" } else { "left out" };
        format!("\n  {:<14} {place:<9} {why}", need.name)
    });
    let (scene, quality) = (one_line(scene), settings.quality.name());
    format!("{scene}, quality {quality}:{}", lines.collect::<String>())
}

/// Returns the needs as one line of JSON.
pub fn json(scene: &str, needs: Needs, settings: Settings) -> String {
    let needs = lines(needs, settings)
        .into_iter()
        .map(|(need, why)| json!({ "name": need.name, "is_needed": need.is_needed, "why": why }));
    let quality = settings.quality.name();
    let needs = needs.collect::<Vec<_>>();
    json_line(&json!({ "scene": scene, "quality": quality, "needs": needs }).to_string())
}

/// Needs of light and reflections, which a view of normals does not have.
const LIT: [&str; 13] = [
    "lights",
    "near_lights",
    "far_lights",
    "ranges",
    "shadows",
    "highlights",
    "shininess",
    "mirrors",
    "reflections",
    "mirrored",
    "plane_mirrors",
    "facing_mirrors",
    "checkers",
];

/// Returns each need of a scene that is drawn with these settings, and why the scene has it.
fn lines(needs: Needs, settings: Settings) -> Vec<(Need, String)> {
    let allowed = Needs::ALL.with_reflections(settings.reflections);
    let is_small = matches!(settings.quality, Quality::Small);
    let explained = |mut need: Need| {
        let mut why = need.why.to_owned();
        if need.name == "reflections" && settings.reflections == 0 {
            need.is_needed = false;
            why = "the frame allows none (`MostReflections<0>`)".to_owned();
        }
        if settings.shading == Shading::Normals && need.is_needed && LIT.contains(&need.name) {
            need.is_needed = false;
            why = "the shading is normals: there is no light and no reflection".to_owned();
        }
        if need.name == "sets" && is_small && need.is_needed {
            need.is_needed = false;
            why = "the quality is small: every shape is asked".to_owned();
        }
        (need, why)
    };
    needs.both(&allowed).list().map(explained).to_vec()
}
