//! Measures how far every quality and single precision are from the double-precision reference.

use command_line::{Quality, Settings, Shading, Source};
use embedded_graphics::prelude::Size;
use reflet::host::compare::{Difference, compare};
use reflet::host::reference;

/// Names of the measured qualities and of single precision, in the order of [`Row::differences`].
pub const NAMES: [&str; 4] = ["fast", "small", "exact", "f32"];

/// Accuracy of one scene in one shading.
#[derive(Clone, Debug)]
pub struct Row {
    /// Name of the scene.
    pub scene: &'static str,
    /// Differences from the reference: those of each quality, then that of the float port in `f32`.
    pub differences: [Difference; NAMES.len()],
}

/// Share of pixels equal to the reference's that counts as all of them: one in ten thousand may
/// differ.
const ALL: f64 = 0.9999;

impl Row {
    /// Tests whether a quality equals the reference in at least as many pixels as single precision
    /// does, or in all but one of ten thousand. `quality` is an index into [`NAMES`].
    pub fn is_as_near_as_single_precision(&self, quality: usize) -> bool {
        let [.., single] = self.differences.map(|it| it.same);
        self.differences[quality].same >= single.min(ALL)
    }
}

/// Draws a built-in scene `side` by `side` pixels large and measures its accuracy. `None` if there
/// is no scene of that name, or for [`reference::Shading::Normals`].
pub fn measure(
    scene: &'static str,
    side: u32,
    reflections: u8,
    shading: reference::Shading,
) -> Option<Row> {
    let source = Source::built_in(scene)?;
    let named = match shading {
        reference::Shading::BlinnPhong => Shading::BlinnPhong,
        reference::Shading::Phong => Shading::Phong,
        reference::Shading::Normals => return None,
    };
    let qualities = [Quality::Fast, Quality::Small, Quality::Exact];
    let fixed = qualities.map(|quality| {
        let settings = Settings {
            reflections,
            shading: named,
            quality,
        };
        source.drawn(Size::new_equal(side), settings)
    });
    let (exact, camera) = source.reference();
    let n = u32::from(reflections);
    let truth = reference::render(&exact, &camera, side, side, n, shading);
    let [fast, small, precise] = fixed;
    let single = crate::render(&exact, &camera, (side, side), n, shading);
    Some(Row {
        scene,
        differences: [fast, small, precise, single].map(|picture| {
            compare(&picture, &truth).expect("all have the size that was asked for")
        }),
    })
}
