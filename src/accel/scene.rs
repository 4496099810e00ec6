//! A scene made ready for the kernels, with the shapes as its lights see them.

use super::World;
use super::light_occluders::LightOccluders;
use super::light_table::LightTable;
use super::mirror_table::MirrorTables;
use crate::camera::Camera;
use crate::scene::access::SceneAccess;
use crate::scene::{
    Capacity, Description, Needs, Parts, PlainScene, Room, RuntimeSceneIn, SceneBuilder,
    SceneBuilderIn, SceneError, used,
};

/// A [`Scene`] with its room as one type.
#[derive(Clone, Copy, Debug)]
pub struct SceneIn<R: Capacity> {
    pub(super) plain: PlainScene<R>,
    pub(super) light_occluders: R::Lights<LightOccluders<R>>,
    pub(super) light_tables: R::Lights<LightTable>,
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
        /// [`RuntimeScene::build`](crate::RuntimeScene::build) while it runs.
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
                    light_tables: [LightTable::ALL; L],
                };
                let parts = scene.plain.constant_parts();
                let mut index = 0;
                while index < parts.lights.len() && index < L {
                    let light = parts.lights[index];
                    scene.light_occluders[index] = LightOccluders::new(light, &parts);
                    if light.place.is_near() {
                        scene.light_tables[index] = LightTable::around(light.place.point, &parts);
                    }
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

impl<R: Capacity> SceneAccess for SceneIn<R> {
    const NEEDS: Needs = Needs::of_room(&R::COUNTS);
    const CHOOSES_HITS: bool = false;

    #[inline(always)]
    fn parts(&self) -> Parts<'_> {
        self.plain.parts()
    }
}

#[allow(private_interfaces)]
impl<R: Capacity> World for SceneIn<R> {
    type Room = R;

    #[inline(always)]
    fn light_occluders(&self) -> &[LightOccluders<R>] {
        used(self.light_occluders.as_ref(), self.plain.counts.lights)
    }

    #[inline(always)]
    fn light_tables(&self) -> &[LightTable] {
        used(self.light_tables.as_ref(), self.plain.counts.lights)
    }

    #[inline(always)]
    fn mirror_tables(&self) -> &MirrorTables {
        MirrorTables::NONE
    }
}

#[cfg(test)]
mod tests;
