//! How far every quality, and single precision, is from the double-precision reference.

use std::marker::PhantomData;

use embedded_graphics::prelude::Size;
use reflet::host::compare::{Difference, compare};
use reflet::host::painted;
use reflet::host::reference::{self, Picture};
use reflet::scenes::{BuiltIn, Visitor, visit};
use reflet::{BlinnPhong, Exact, Fast, Fine, Phong, Quality, Shading, Small};

/// The names of what is measured, in the order of [`Row::differences`].
pub const NAMES: [&str; 5] = ["fast", "fine", "small", "exact", "f32"];

/// One scene in one shading.
#[derive(Clone, Debug)]
pub struct Row {
    /// The scene's name.
    pub scene: &'static str,
    /// From the reference: of each quality, then of the float port in `f32`.
    pub differences: [Difference; NAMES.len()],
}

/// Renders a built-in scene `side` by `side` pixels large. `None` without a scene of that name, and
/// for [`reference::Shading::Normals`].
pub fn measure(
    scene: &str,
    side: u32,
    reflections: u8,
    shading: reference::Shading,
) -> Option<Row> {
    let size = Size::new_equal(side);
    match shading {
        reference::Shading::BlinnPhong => {
            let kind = PhantomData::<BlinnPhong>;
            visit(
                scene,
                Measure {
                    size,
                    reflections,
                    shading,
                    kind,
                },
            )
        }
        reference::Shading::Phong => {
            let kind = PhantomData::<Phong>;
            visit(
                scene,
                Measure {
                    size,
                    reflections,
                    shading,
                    kind,
                },
            )
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
    fn painted<S: BuiltIn, Q: Quality>(&self) -> Picture {
        let frame = S::frame(&S::CAMERA).reflections(self.reflections);
        painted(&frame.quality::<Q>().shading::<K>().sized(self.size))
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
