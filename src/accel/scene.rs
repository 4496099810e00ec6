//! Scenes in RAM: prepared parts, and the shapes prepared from the position of each light.

use super::fingerprint::Fingerprint;
use super::hierarchy::{Hierarchy, HierarchyNode};
use super::light_occluders::LightOccluders;
use super::light_table::LightTable;
use super::{ActiveRoom, Tables, World};
use crate::camera::Camera;
use crate::error::Error;
use crate::error_kind::ErrorKind;
use crate::scene::access::SceneAccess;
use crate::scene::{
    Array, Capacity, Description, Needs, Parts, PlainScene, Room, RuntimeScene, SceneBuilder, used,
};

/// A prepared scene, ready to be drawn. `R` is its room, written with [`room!`](crate::room).
///
/// [`RuntimeScene::build`](crate::RuntimeScene::build) prepares a scene while the program runs,
/// [`SceneBuilder::build`] when the program is compiled. Shapes and lights can then be moved in place.
///
/// ```
/// use reflet::description::{Cylinder, Light};
/// use reflet::{Camera, Handle, Material, RuntimeScene, room};
///
/// let mut scene = RuntimeScene::<room!(cylinders: 1, discs: 1, lights: 1)>::new();
/// scene.set_motion([-4, -4, -4], [4, 4, 4])?;
/// scene.set_camera(Camera::new([0, -9, 3], [0, 0, 1], [0, 0, 1], 50)?);
/// let tin = scene.add_material(Material::new([0.8; 3]).mirror(0.3))?;
/// let can: Handle<Cylinder> = scene.add_cylinder([0, 0, 1], [0, 0, 1], 1, 2, tin)?;
/// let lid = scene.add_disc([0, 0, 2], [0, 0, 1], 1, tin)?;
/// let lamp: Handle<Light> = scene.add_light([3, -4, 6], [1, 1, 1])?;
///
/// let mut scene = scene.build()?;
/// scene.set_cylinder(can, [1, 0, 1], [0, 0, 1], 1, 2)?;
/// scene.set_disc(lid, [1, 0, 2], [0, 0, 1], 1)?;
/// scene.set_light(lamp, [-3, -4, 6])?;
/// assert!(scene.camera().is_some());
/// assert!(scene.needs().cylinders);
/// # Ok::<(), reflet::Error>(())
/// ```
///
/// Bytes of RAM on a Cortex-M of a scene that was filled at run time, of its description, and of the
/// tables that [`Scene::tabled`] adds:
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
    /// Number that changes with the scene. A frame stores it and refuses a scene with another number.
    pub(super) stamp: u32,
}

impl<R: Capacity> Scene<R> {
    /// Returns the camera of the scene's description, or `None` if it has none.
    pub const fn camera(&self) -> Option<&Camera> {
        self.plain.camera.as_ref()
    }

    /// Returns the features of the library that the scene needs.
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
            /// Prepares a scene from a description whose parts were checked and fit the room.
            pub(super) const fn of_description(description: &Description<'_>) -> Result<Self, Error> {
                let plain = match PlainScene::prepare(description) {
                    Ok(plain) => plain,
                    Err(error) => return Err(error),
                };
                Ok(Self::of(plain, Fingerprint::of(description)))
            }

            /// Adds the occluders of each light to a prepared scene.
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

        #[doc(hidden)]
        impl<$($header)*> SceneBuilder<Room<$($arguments)*>> {
            /// Chooses the scene's grid and prepares the scene, for constants.
            ///
            /// # Panics
            /// Panics with the text of an [`Error`] where [`RuntimeScene::build`] returns one; if the
            /// room is larger than the scene ([`ErrorKind::UnusedRoom`], materials excepted); and if
            /// nothing lights the scene ([`ErrorKind::NoLight`]). In a constant, this stops the
            /// compiler.
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

            /// Panics if a list has room for more parts than it holds, because unused room takes flash.
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
    };
}
kinds!(scene);

impl<R: ActiveRoom> RuntimeScene<R> {
    /// Chooses the scene's grid and prepares the scene. No float instruction is executed.
    ///
    /// # Errors
    /// Mistakes that show only in the whole scene: [`ErrorKind::Tiny`], [`ErrorKind::BelowEpsilon`],
    /// [`ErrorKind::Extent`], [`ErrorKind::Epsilon`], [`ErrorKind::Brightness`].
    pub fn build(&self) -> Result<Scene<R>, Error> {
        R::prepare(&self.description())
    }
}

impl<R: Capacity> Scene<R> {
    /// Returns the scene with a table for each light: the shapes that lie in each direction from it.
    ///
    /// A table takes 1 KB for each light that the room allows, in the memory of the returned value.
    /// Shadows of many shapes then take less time. Pixels that are traced stay the same, to the bit.
    /// [`Fast`](crate::quality::Fast) may interpolate more pixels, a few of which then differ by one level.
    /// A scene of three bounded shapes or fewer does not use its tables: each shadow ray tests all shapes.
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
            *table = LightTable::around(light.place, &parts);
        }
        Tabled {
            scene: self,
            light_tables,
            hierarchy: Hierarchy::NONE,
        }
    }
}

/// A borrowed [`Scene`] with a table of shapes for each of its lights. [`Scene::tabled`] creates it.
#[derive(Clone, Copy, Debug)]
pub struct Tabled<'a, R: Capacity> {
    pub(super) scene: &'a Scene<R>,
    light_tables: R::Lights<LightTable>,
    hierarchy: Hierarchy<'a>,
}

impl<'a, R: Capacity> Tabled<'a, R> {
    /// Returns the scene with a hierarchy of balls around its shapes, made in `memory`.
    ///
    /// Rays off mirrors and to distant lights then test few shapes of many; in a scene of more than 128
    /// bounded shapes, all shadow rays do. The picture stays the same, to
    /// the bit. The hierarchy takes as many nodes as there are bounded shapes, rounded up to a power of
    /// two: 64 shapes take 64 nodes, 1792 bytes. If the scene has 12 bounded shapes or fewer, or if the
    /// memory is too small, there is no hierarchy, and rays test more shapes.
    ///
    /// To make it for 64 spheres takes 677 thousand instructions on an emulated Cortex-M0. A frame of 64
    /// mirroring beads (those of `xtask/tests/scale.rs`) takes 10.7 thousand instructions a pixel
    /// at 64x64 without it, and 6.4 thousand with it.
    ///
    /// ```
    /// use embedded_graphics::{mock_display::MockDisplay, pixelcolor::Rgb888};
    /// use reflet::needs::HierarchyNode;
    /// use reflet::{Camera, Material, RuntimeScene, room};
    ///
    /// const CAMERA: Camera = Camera::look_at([0.0, -9.0, 0.0], [0.0; 3], [0.0, 0.0, 1.0]);
    ///
    /// let mut scene = RuntimeScene::<room!(spheres: 25, lights: 1, materials: 1)>::new();
    /// let mirror = scene.add_material(Material::new([0.9; 3]).mirror(0.7))?;
    /// for bead in 0..25 {
    ///     scene.add_sphere([bead % 5 - 2, 0, bead / 5 - 2], 0.4, mirror)?;
    /// }
    /// scene.add_light([9, -4, 6], [1, 1, 1])?;
    /// let scene = scene.build()?;
    /// let mut memory = [HierarchyNode::NONE; 32];
    /// let tabled = scene.tabled().with_hierarchy(&mut memory);
    /// let mut display = MockDisplay::<Rgb888>::new();
    /// tabled.frame(&CAMERA).draw(&mut display).unwrap();
    /// # Ok::<(), reflet::Error>(())
    /// ```
    pub fn with_hierarchy(mut self, memory: &'a mut [HierarchyNode]) -> Self {
        self.hierarchy = Hierarchy::of(&self.scene.plain.parts(), memory);
        self
    }
}

impl<R: Capacity> SceneAccess for Scene<R> {
    const NEEDS: Needs = Needs::of_room(&R::COUNTS).without_sets();

    #[inline(always)]
    fn parts(&self) -> Parts<'_> {
        self.plain.parts()
    }
}

impl<R: ActiveRoom> World for Scene<R> {
    type Room = R;
    const IS_CROWD: bool = false;

    #[inline(always)]
    fn tables(&self) -> Tables<'_, R> {
        Tables {
            light_occluders: used(self.light_occluders.as_ref(), self.plain.counts.lights),
            light_tables: &[],
            light_lists: &[],
            hierarchy: Hierarchy::NONE,
        }
    }
}

impl<R: Capacity> SceneAccess for Tabled<'_, R> {
    const NEEDS: Needs = Needs::of_room(&R::COUNTS);

    #[inline(always)]
    fn parts(&self) -> Parts<'_> {
        self.scene.plain.parts()
    }
}

impl<R: ActiveRoom> World for Tabled<'_, R> {
    type Room = R;
    const IS_CROWD: bool = Hierarchy::room(R::COUNTS.bounded()) > 0;

    #[inline(always)]
    fn tables(&self) -> Tables<'_, R> {
        Tables {
            light_tables: used(self.light_tables.as_ref(), self.scene.plain.counts.lights),
            hierarchy: self.hierarchy,
            ..self.scene.tables()
        }
    }
}

#[cfg(test)]
mod tests;
