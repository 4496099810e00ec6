//! Measures how far every quality and single precision are from the double-precision reference.

use std::marker::PhantomData;

use embedded_graphics::prelude::Size;
use reflet::host::compare::{Difference, compare};
use reflet::host::painted;
use reflet::host::reference::{self, Picture};
use reflet::quality::{Exact, Fast, Fine, Quality, Small};
use reflet::scenes::{BuiltIn, Visitor, visit};
use reflet::shading::{BlinnPhong, Phong, Shading};

/// Names of the measured qualities and of single precision, in the order of [`Row::differences`].
pub const NAMES: [&str; 5] = ["fast", "fine", "small", "exact", "f32"];

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
    scene: &str,
    side: u32,
    reflections: u8,
    shading: reference::Shading,
) -> Option<Row> {
    let size = Size::new_equal(side);
    match shading {
        reference::Shading::BlinnPhong => visit(
            scene,
            Measure::<BlinnPhong>::new(size, reflections, shading),
        ),
        reference::Shading::Phong => {
            visit(scene, Measure::<Phong>::new(size, reflections, shading))
        }
        reference::Shading::Normals => None,
    }
}

struct Measure<K> {
    size: Size,
    reflections: u8,
    shading: reference::Shading,
    kind: PhantomData<K>,
}

impl<K: Shading> Measure<K> {
    fn new(size: Size, reflections: u8, shading: reference::Shading) -> Self {
        let kind = PhantomData;
        Self {
            size,
            reflections,
            shading,
            kind,
        }
    }

    fn painted<S: BuiltIn, Q: Quality>(&self) -> Picture {
        let frame = S::frame(&S::CAMERA).reflections(self.reflections);
        let frame = frame.quality::<Q>().shading::<K>().prepare(self.size);
        painted(
            &frame
                .on(S::INSTANCE)
                .expect("a constant scene never changes"),
        )
    }
}

impl<K: Shading> Visitor for Measure<K> {
    type Output = Row;

    fn visit<S: BuiltIn>(self) -> Row {
        let scene = S::with_description(|scene| reference::Scene::from(&scene));
        let camera = reference::Camera::from(&S::CAMERA);
        let Size { width, height } = self.size;
        let n = u32::from(self.reflections);
        let truth = reference::render(&scene, &camera, width, height, n, self.shading);
        let pictures = [
            self.painted::<S, Fast>(),
            self.painted::<S, Fine>(),
            self.painted::<S, Small>(),
            self.painted::<S, Exact>(),
            crate::render(&scene, &camera, (width, height), n, self.shading),
        ];
        Row {
            scene: S::NAME,
            differences: pictures.map(|picture| {
                compare(&picture, &truth).expect("all have the size that was asked for")
            }),
        }
    }
}
