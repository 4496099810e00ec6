//! The title of the window: what it shows, how long that took, and its keys.

use command_line::{Settings, one_line};

/// Returns the title for a picture that took some seconds to draw on this machine.
pub fn title(scene: &str, settings: Settings, seconds: f64) -> String {
    let (scene, quality) = (one_line(scene), settings.quality.name());
    let (reflections, time) = (settings.reflections, 1e3 * seconds);
    format!(
        "{scene}, {quality}, {reflections} reflections: {time:.1} ms here | arrows orbit, \
         + - reflections, Tab next scene, Escape leaves"
    )
}
