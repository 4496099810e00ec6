//! A scene made ready for the kernels, with the shapes as its lights see them.

use super::fingerprint::Fingerprint;
use super::light_occluders::LightOccluders;
use super::light_table::LightTable;
use super::mirror_table::MirrorTables;
use super::{ActiveRoom, Tables, World};
use crate::camera::Camera;
use crate::error::Error;
use crate::error_kind::ErrorKind;
use crate::scene::access::SceneAccess;
use crate::scene::{
    Array, Capacity, Description, Needs, Parts, PlainScene, Room, RuntimeScene, SceneBuilder, used,
};

/// A scene made ready for the kernels; `R` is its room, [`room!`](crate::room).
///
/// [`RuntimeScene::build`](crate::RuntimeScene::build) makes it while the program runs,
/// [`SceneBuilder::build`] when the program is compiled. Bytes of RAM on a Cortex-M of one that is filled
/// at run time, and of the tables that [`Scene::tabled`] adds:
///
/// | room | scene | its description | tables |
/// |---|--:|--:|--:|
/// | `room!(spheres: 1, lights: 1, materials: 1)` | 528 | 728 | not needed |
/// | `room!(spheres: 8, planes: 2, cylinders: 4, lights: 2, materials: 4)` | 1776 | 2464 | 2056 |
/// | `room!(spheres: 32, planes: 4, cylinders: 16, lights: 2, materials: 8)` | 5136 | 6544 | 2056 |
#[derive(Clone, Copy, Debug)]
pub struct Scene<R: Capacity> {
    pub(super) plain: PlainScene<R>,
    pub(super) light_occluders: R::Lights<LightOccluders<R>>,
    /// Changes with the scene: a frame that was prepared for another one is refused.
    pub(super) stamp: u32,
}

impl<R: Capacity> Scene<R> {
    /// Returns the camera that the scene was described with.
    pub const fn camera(&self) -> Option<&Camera> {
        self.plain.camera.as_ref()
    }

    /// Returns what the scene needs.
    pub fn needs(&self) -> Needs {
        self.plain.parts().needs()
    }
}

macro_rules! scene {
    (
        { $declaration:tt [$($header:tt)*] [$($arguments:tt)*] }
        $({ $list:ident $($more:tt)* })*
    ) => {
        impl<$($header)*> Scene<Room<$($arguments)*>> {
            /// Prepares a description whose parts have been checked and fit.
            const fn prepare(description: &Description<'_>) -> Result<Self, Error> {
                let plain = match PlainScene::prepare(description) {
                    Ok(plain) => plain,
                    Err(error) => return Err(error),
                };
                Ok(Self::of(plain, Fingerprint::of(description)))
            }

            /// Adds the shapes as the lights see them.
            const fn of(plain: PlainScene<Room<$($arguments)*>>, stamp: Fingerprint) -> Self {
                let mut scene = Self {
                    plain,
                    light_occluders: [LightOccluders::NONE; L],
                    stamp: stamp.0,
                };
                let parts = scene.plain.constant_parts();
                let mut index = 0;
                while index < parts.lights.len() && index < L {
                    scene.light_occluders[index] = LightOccluders::new(parts.lights[index], &parts);
                    index += 1;
                }
                scene
            }
        }

        impl<$($header)*> SceneBuilder<Room<$($arguments)*>> {
            /// Chooses the binary point and prepares the scene for the kernels.
            pub const fn build(&self) -> Scene<Room<$($arguments)*>> {
                self.refuse_unused_room();
                let plain = match PlainScene::prepare(&self.description()) {
                    Ok(plain) => plain.marked(self.moving(), &self.description()),
                    Err(error) => error.stop(),
                };
                if plain.constant_parts().lacks_light() {
                    Error::of("scene", ErrorKind::NoLight).stop();
                }
                Scene::of(plain, Fingerprint::of(&self.description()))
            }

            /// Stops the compiler if a list has room for more than its parts; each takes flash.
            const fn refuse_unused_room(&self) {
                let (counts, room) = (self.counts(), Room::<$($arguments)*>::COUNTS);
                $(
                    if counts.$list < room.$list {
                        Error::of(stringify!($list), ErrorKind::UnusedRoom).stop();
                    }
                )*
                if counts.planes < room.planes {
                    Error::of("planes", ErrorKind::UnusedRoom).stop();
                }
                if counts.lights < room.lights {
                    Error::of("lights", ErrorKind::UnusedRoom).stop();
                }
            }
        }

        impl<$($header)*> RuntimeScene<Room<$($arguments)*>> {
            /// Chooses the binary point and prepares the scene for the kernels, with integers only.
            ///
            /// # Errors
            /// What can only be seen in the scene as a whole: [`ErrorKind::Tiny`], [`ErrorKind::Extent`],
            /// [`ErrorKind::Epsilon`], [`ErrorKind::Brightness`].
            pub fn build(&self) -> Result<Scene<Room<$($arguments)*>>, Error> {
                Scene::prepare(&self.description())
            }
        }
    };
}
kinds!(scene);

impl<R: Capacity> Scene<R> {
    /// The scene with a table for each light of the shapes around it: 1 KB a light, in memory of the
    /// caller's. Shadows of many shapes then take less time; the picture is the same, to the bit.
    ///
    /// A scene whose type has room for three bounded shapes or fewer asks them all, with tables or without.
    ///
    /// ```
    /// use embedded_graphics::{mock_display::MockDisplay, pixelcolor::Rgb888};
    /// use reflet::{Camera, Material, RuntimeScene, room};
    ///
    /// const CAMERA: Camera = Camera::look_at([0.0, -5.0, 0.0], [0.0; 3], [0.0, 0.0, 1.0]);
    ///
    /// let mut scene = RuntimeScene::<room!(spheres: 8, lights: 1, materials: 1)>::new();
    /// let chalk = scene.add_material(Material::new([0.9; 3]))?;
    /// for x in -3..=3 {
    ///     scene.add_sphere([x, 0, 0], 0.4, chalk)?;
    /// }
    /// scene.add_light([9, -4, 6], [1, 1, 1])?;
    /// let scene = scene.build()?;
    /// let tabled = scene.tabled();
    /// let mut display = MockDisplay::<Rgb888>::new();
    /// tabled.frame(&CAMERA).draw(&mut display).unwrap();
    /// # Ok::<(), reflet::Error>(())
    /// ```
    pub fn tabled(&self) -> Tabled<'_, R> {
        let mut light_tables: R::Lights<LightTable> = Array::filled(LightTable::ALL);
        let parts = self.plain.parts();
        for (light, table) in parts.lights.iter().zip(light_tables.as_mut()) {
            *table = LightTable::of_light(light, &parts);
        }
        Tabled {
            scene: self,
            light_tables,
        }
    }
}

/// A [`Scene`] with a table for each of its lights; see [`Scene::tabled`].
#[derive(Clone, Copy, Debug)]
pub struct Tabled<'a, R: Capacity> {
    pub(super) scene: &'a Scene<R>,
    light_tables: R::Lights<LightTable>,
}

impl<R: Capacity> SceneAccess for Scene<R> {
    const NEEDS: Needs = Needs::of_room(&R::COUNTS).without_sets();
    const CHOOSES_HITS: bool = false;

    #[inline(always)]
    fn parts(&self) -> Parts<'_> {
        self.plain.parts()
    }
}

impl<R: ActiveRoom> World for Scene<R> {
    type Room = R;

    #[inline(always)]
    fn tables(&self) -> Tables<'_, R> {
        Tables {
            light_occluders: used(self.light_occluders.as_ref(), self.plain.counts.lights),
            light_tables: &[],
            mirror_tables: MirrorTables::NONE,
        }
    }
}

impl<R: Capacity> SceneAccess for Tabled<'_, R> {
    const NEEDS: Needs = Needs::of_room(&R::COUNTS);
    const CHOOSES_HITS: bool = false;

    #[inline(always)]
    fn parts(&self) -> Parts<'_> {
        self.scene.plain.parts()
    }
}

impl<R: ActiveRoom> World for Tabled<'_, R> {
    type Room = R;

    #[inline(always)]
    fn tables(&self) -> Tables<'_, R> {
        Tables {
            light_tables: used(self.light_tables.as_ref(), self.scene.plain.counts.lights),
            ..self.scene.tables()
        }
    }
}

#[cfg(test)]
mod tests;
