//! Scenes filled while the program runs: from files, or changed between frames.

use super::capacity::{Capacity, Room};
use super::description::{Described, Description};
use super::{Handle, list, prepare};
use crate::camera::Camera;
use crate::error::Error;
use crate::error_kind::ErrorKind;
use crate::light::Light;
use crate::material::Material;
use crate::number::Number;
use crate::shape::MaterialId;
use crate::shape::plane::Plane;
use crate::vector::Position;

/// The description of a scene that is filled while the program runs; `R` is its room,
/// [`room!`](crate::room).
///
/// ```
/// use reflet::{Error, Material, RuntimeScene, Scene, room};
///
/// type Pond = room!(spheres: 1, lights: 1);
///
/// fn pond() -> Result<Scene<Pond>, Error> {
///     let mut scene = RuntimeScene::<Pond>::new();
///     let red = scene.add_material(Material::new([0.9, 0.1, 0.1]))?;
///     scene.add_sphere([0, 0, 1], 1, red)?; // any mix of i32, f32, f64 and fixed-point numbers
///     scene.add_light([3, -4, 6], [1, 1, 1])?;
///     scene.build()
/// }
/// assert!(pond().is_ok());
/// ```
#[derive(Clone, Debug)]
pub struct RuntimeScene<R: Capacity>(Described<R>);

impl<R: Capacity> RuntimeScene<R> {
    /// Adds a material and returns the name that shapes use for it.
    ///
    /// # Errors
    /// [`ErrorKind::TooManyMaterials`].
    pub fn add_material(&mut self, material: Material) -> Result<MaterialId, Error> {
        let materials = &mut self.0.materials;
        let index = materials.len;
        let too_many = ErrorKind::TooManyMaterials;
        materials.add(material, None, "material", too_many)?;
        Ok(list::id(index))
    }

    /// Adds an infinite plane through `point`; the normal may have any length but 0.
    ///
    /// # Errors
    /// What is wrong with the plane, or [`ErrorKind::TooManyPlanes`]; the scene is as it was.
    pub fn add_plane(
        &mut self,
        point: impl Into<Position>,
        normal: impl Into<Position>,
        material: MaterialId,
    ) -> Result<(), Error> {
        let plane = Plane {
            point: point.into(),
            normal: normal.into(),
            material,
        };
        let fault = plane.fault().or(self.unknown(material));
        let planes = &mut self.0.planes;
        planes.add(plane, fault, "plane", ErrorKind::TooManyPlanes)?;
        Ok(())
    }

    /// Adds a point light; colour components are 0 to 16.
    ///
    /// # Errors
    /// What is wrong with the light, or [`ErrorKind::TooManyLights`]; the scene is as it was.
    pub fn add_light(
        &mut self,
        position: impl Into<Position>,
        color: [impl Into<Number>; 3],
    ) -> Result<Handle<Light>, Error> {
        let light = Light {
            position: position.into(),
            color: color.map(Into::into),
        };
        let fault = light.fault();
        let lights = &mut self.0.lights;
        lights
            .add(light, fault, "light", ErrorKind::TooManyLights)
            .map(Handle::new)
    }

    /// Sets what a ray that meets nothing adds, 0 to 16 a component.
    ///
    /// # Errors
    /// [`ErrorKind::Background`]; the scene is as it was.
    pub fn set_background(&mut self, color: [impl Into<Number>; 3]) -> Result<(), Error> {
        let background = color.map(Into::into);
        if let Some(fault) = prepare::background_fault(background) {
            return Err(Error::of("scene", fault));
        }
        self.0.background = background;
        Ok(())
    }

    /// Sets how far above a surface the shadow rays and mirrored rays start that leave it, in scene
    /// units; 0.001 unless it is set. [`SceneBuilder::epsilon`](crate::SceneBuilder::epsilon) says how it
    /// is rounded and what becomes of one that is too small or too large.
    ///
    /// # Errors
    /// [`ErrorKind::Epsilon`] if it is not above 0, or is above 2³⁰; the scene is as it was. That it is smaller
    /// than the scene is checked by [`build`](RuntimeScene::build).
    pub fn set_epsilon(&mut self, epsilon: impl Into<Number>) -> Result<(), Error> {
        let epsilon = epsilon.into();
        if let Some(fault) = prepare::epsilon_fault(epsilon) {
            return Err(Error::of("scene", fault));
        }
        self.0.epsilon = epsilon;
        Ok(())
    }

    /// Sets the camera the scene is meant to be seen with first; see
    /// [`SceneBuilder::camera`](crate::SceneBuilder::camera).
    pub fn set_camera(&mut self, camera: Camera) {
        self.0.camera = Some(camera);
    }

    /// Sets the box in which parts of the scene move, by two opposite corners; see
    /// [`SceneBuilder::motion`](crate::SceneBuilder::motion).
    ///
    /// # Errors
    /// [`ErrorKind::Coordinate`], or [`ErrorKind::Motion`] if a coordinate of `low` is above that of `high`; the
    /// scene is as it was.
    pub fn set_motion(
        &mut self,
        low: impl Into<Position>,
        high: impl Into<Position>,
    ) -> Result<(), Error> {
        let motion = [low.into(), high.into()];
        if let Some(fault) = prepare::motion_fault(motion) {
            return Err(Error::of("motion", fault));
        }
        self.0.motion = Some(motion);
        Ok(())
    }

    fn unknown(&self, material: MaterialId) -> Option<ErrorKind> {
        (material.index() >= self.0.materials.len).then_some(ErrorKind::UnknownMaterial)
    }
}

macro_rules! runtime {
    (
        { $declaration:tt [$($header:tt)*] [$($arguments:tt)*] }
        $({ $list:ident $kind:ident $described:ident $prepared:ident $room:ident $lists:ident $active:tt
            $set:ident $too_many:ident $without:ident
            $(#[$doc:meta])* $add:ident($($field:ident: $type:ident),*) })*
    ) => {
        impl<R: Capacity> RuntimeScene<R> {
            $(
                $(#[$doc])*
                ///
                /// # Errors
                #[doc = concat!(
                    "What is wrong with the ", stringify!($kind), ", or [`ErrorKind::", stringify!($too_many),
                    "`]; the scene is as it was."
                )]
                pub fn $add(
                    &mut self,
                    $($field: impl Into<$type>,)*
                    material: MaterialId,
                ) -> Result<Handle<crate::shape::$described>, Error> {
                    let $kind = crate::shape::$described {
                        $($field: $field.into(),)*
                        material,
                    };
                    let fault = $kind.fault().or(self.unknown(material));
                    let $list = &mut self.0.$list;
                    $list.add($kind, fault, stringify!($kind), ErrorKind::$too_many).map(Handle::new)
                }
            )*
        }

        impl<$($header)*> RuntimeScene<Room<$($arguments)*>> {
            /// An empty scene with a black background and an epsilon of 0.001.
            pub const fn new() -> Self {
                Self(Described::new())
            }

            /// The description so far.
            pub fn description(&self) -> Description<'_> {
                self.0.description()
            }

        }

        impl<$($header)*> Default for RuntimeScene<Room<$($arguments)*>> {
            fn default() -> Self {
                Self::new()
            }
        }
    };
}
kinds!(runtime);
