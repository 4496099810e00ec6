//! A scene made ready for the kernels, with the shapes as its lights see them.

use super::light_occluders::LightOccluders;
use super::light_table::LightTable;
use super::mirror_table::MirrorTables;
use super::{ActiveRoom, Tables, World};
use crate::camera::Camera;
use crate::scene::access::SceneAccess;
use crate::scene::{
    Array, Capacity, Description, Needs, Parts, PlainScene, Room, RuntimeSceneIn, SceneBuilder,
    SceneBuilderIn, SceneError, used,
};

/// A [`Scene`] with its room as one type.
#[derive(Clone, Copy, Debug)]
pub struct SceneIn<R: Capacity> {
    pub(super) plain: PlainScene<R>,
    pub(super) light_occluders: R::Lights<LightOccluders<R>>,
}

impl<R: Capacity> SceneIn<R> {
    /// The camera the scene was described with.
    pub const fn camera(&self) -> Option<&Camera> {
        self.plain.camera.as_ref()
    }

    /// What this scene needs.
    pub fn needs(&self) -> Needs {
        self.plain.parts().needs()
    }
}

macro_rules! scene {
    (
        { [$($declaration:tt)*] [$($header:tt)*] [$($arguments:tt)*] }
        $($more:tt)*
    ) => {
        /// A scene made ready for the kernels, with room for `S` spheres, `P` planes, `C` cylinders, `L`
        /// lights and `M` materials.
        ///
        /// Made by [`SceneBuilder::build`] when the program is compiled, or by
        /// [`RuntimeScene::build`](crate::RuntimeScene::build) while it runs. Bytes of RAM on a Cortex-M of
        /// one that is filled at run time, and of the tables that [`Scene::tabled`] adds:
        ///
        /// | capacity | scene | its description | tables |
        /// |---|--:|--:|--:|
        /// | `Scene<1, 0, 0, 1, 1>` | 480 | 624 | not needed |
        /// | `Scene<8, 2, 4, 2, 4>` | 1736 | 2360 | 2056 |
        /// | `Scene<32, 4, 16, 2, 8>` | 5096 | 6440 | 2056 |
        pub type Scene<$($declaration)*> = SceneIn<Room<$($arguments)*>>;

        impl<$($header)*> SceneIn<Room<$($arguments)*>> {
            /// Starts the description of a scene that is built when the program is compiled.
            pub const fn builder() -> SceneBuilder<$($arguments)*> {
                SceneBuilder::new()
            }

            /// Prepares a description whose parts have been checked and fit.
            const fn prepare(description: &Description<'_>) -> Result<Self, SceneError> {
                let plain = match PlainScene::prepare(description) {
                    Ok(plain) => plain,
                    Err(error) => return Err(error),
                };
                let mut scene = Self {
                    plain,
                    light_occluders: [LightOccluders::NONE; L],
                };
                let parts = scene.plain.constant_parts();
                let mut index = 0;
                while index < parts.lights.len() && index < L {
                    scene.light_occluders[index] = LightOccluders::new(parts.lights[index], &parts);
                    index += 1;
                }
                Ok(scene)
            }
        }

        impl<$($header)*> SceneBuilderIn<Room<$($arguments)*>> {
            /// Chooses the binary point and prepares the scene for the kernels.
            pub const fn build(&self) -> Scene<$($arguments)*> {
                match Scene::prepare(&self.description()) {
                    Ok(scene) => scene,
                    Err(error) => panic!("{}", error.fault().words()),
                }
            }
        }

        impl<$($header)*> RuntimeSceneIn<Room<$($arguments)*>> {
            /// Chooses the binary point and prepares the scene for the kernels, with integers only.
            ///
            /// # Errors
            /// What can only be seen in the scene as a whole: [`Fault::Tiny`](crate::Fault::Tiny),
            /// [`Fault::Extent`](crate::Fault::Extent), [`Fault::Epsilon`](crate::Fault::Epsilon) and
            /// [`Fault::Brightness`](crate::Fault::Brightness).
            pub fn build(&self) -> Result<Scene<$($arguments)*>, SceneError> {
                Scene::prepare(&self.description())
            }
        }
    };
}
kinds!(scene);

impl<R: Capacity> SceneIn<R> {
    /// The scene with a table for each light of the shapes around it: 1 KB a light, in memory of the
    /// caller's. Shadows of many shapes then take less time; the picture is the same, to the bit.
    ///
    /// A scene whose type has room for three bounded shapes or fewer asks them all, with tables or without.
    ///
    /// ```
    /// use embedded_graphics::{mock_display::MockDisplay, pixelcolor::Rgb888};
    /// use reflet::{Camera, Material, RuntimeScene};
    ///
    /// const CAMERA: Camera = Camera::look_at([0.0, -5.0, 0.0], [0.0; 3], [0.0, 0.0, 1.0]);
    ///
    /// let mut scene = RuntimeScene::<8, 0, 0, 1, 1>::new();
    /// let chalk = scene.add_material(Material::new([0.9; 3]))?;
    /// for x in -3..=3 {
    ///     scene.add_sphere([x, 0, 0], 0.4, chalk)?;
    /// }
    /// scene.add_light([9, -4, 6], [1, 1, 1])?;
    /// let scene = scene.build()?;
    /// let tabled = scene.tabled();
    /// let mut display = MockDisplay::<Rgb888>::new();
    /// tabled.frame(&CAMERA).draw(&mut display).unwrap();
    /// # Ok::<(), reflet::SceneError>(())
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
    scene: &'a SceneIn<R>,
    light_tables: R::Lights<LightTable>,
}

impl<R: Capacity> SceneAccess for SceneIn<R> {
    const NEEDS: Needs = Needs::of_room(&R::COUNTS).without_sets();
    const CHOOSES_HITS: bool = false;

    #[inline(always)]
    fn parts(&self) -> Parts<'_> {
        self.plain.parts()
    }
}

impl<R: ActiveRoom> World for SceneIn<R> {
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
