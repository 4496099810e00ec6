//! Scenes that are filled while the program runs, for example from a file.

use super::capacity::Capacity;
use super::description::{Described, Description};
use super::{Handle, list, prepare};
use crate::background::Background;
use crate::camera::Camera;
use crate::error::Error;
use crate::error_kind::ErrorKind;
use crate::material::Material;
use crate::number::Number;
use crate::shape::plane::Plane;
use crate::shape::{Corners, MaterialId, Normals};
use crate::vector::Position;

/// A scene that is filled while the program runs, before it is prepared. `R` is its room, written with
/// [`room!`](crate::room).
///
/// Every method checks its arguments and returns an [`Error`] that names the part and the fix.
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
///
/// A can on a floor, and a mistake:
///
/// ```
/// use reflet::{Camera, ErrorKind, Material, MaterialId, RuntimeScene, room};
///
/// let mut scene = RuntimeScene::<room!(planes: 1, cylinders: 1, discs: 1, lights: 1)>::new();
/// scene.set_background([0.3, 0.4, 0.6])?;
/// scene.set_epsilon(0.01)?;
/// scene.set_camera(Camera::new([0, -9, 3], [0, 0, 1], [0, 0, 1], 50)?);
/// let tin: MaterialId = scene.add_material(Material::new([0.8; 3]).mirror(0.3))?;
/// scene.add_cylinder([0, 0, 1], [0, 0, 1], 1, 2, tin)?;
/// scene.add_disc([0, 0, 2], [0, 0, 1], 1, tin)?;
/// scene.add_plane([0, 0, 0], [0, 0, 1], tin)?;
/// scene.add_light([3, -4, 6], [1, 1, 1])?;
/// assert_eq!(scene.description().cylinders.len(), 1);
///
/// let error = scene.add_plane([0, 0, -5], [0, 0, 1], tin).unwrap_err();
/// assert_eq!(error.kind(), ErrorKind::TooManyPlanes);
/// # Ok::<(), reflet::Error>(())
/// ```
#[derive(Clone, Debug)]
pub struct RuntimeScene<R: Capacity>(pub(super) Described<R>);

impl<R: Capacity> RuntimeScene<R> {
    /// Creates an empty scene with a black background and an epsilon of 0.001.
    pub fn new() -> Self {
        Self(R::empty())
    }

    /// Returns the description of the parts added so far.
    pub fn description(&self) -> Description<'_> {
        R::description(&self.0)
    }

    /// Adds a material and returns the identifier that shapes of this scene use for it.
    ///
    /// # Errors
    /// [`ErrorKind::TooManyMaterials`] if the room is full.
    pub fn add_material(&mut self, material: Material) -> Result<MaterialId, Error> {
        let materials = &mut self.0.materials;
        let index = materials.add(material, None, "material", ErrorKind::TooManyMaterials)?;
        Ok(list::id(index))
    }

    /// Adds an infinite plane through `point`. The normal may have any length but 0.
    ///
    /// # Errors
    /// The mistake in the plane, or [`ErrorKind::TooManyPlanes`]. After an error the scene is unchanged.
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

    /// Sets the colour of rays that hit nothing; each component is 0 to 16. Defaults to black.
    ///
    /// # Errors
    /// [`ErrorKind::Background`] if a component is out of range. The scene is then unchanged.
    pub fn set_background(&mut self, color: [impl Into<Number>; 3]) -> Result<(), Error> {
        self.replace(Background::of_color(color.map(Into::into)))
    }

    /// Sets a sky as the background: the direction straight up, and the colours straight down, at the
    /// horizon and straight up; each component is 0 to 16. [`Sky`](crate::description::Sky) has the formula.
    ///
    /// # Errors
    /// [`ErrorKind::Sky`] if `up` is zero, [`ErrorKind::Coordinate`] or [`ErrorKind::Color`] if a number is
    /// out of range. The scene is then unchanged.
    pub fn set_sky(
        &mut self,
        up: impl Into<Position>,
        colors: [[impl Into<Number>; 3]; 3],
    ) -> Result<(), Error> {
        let colors = colors.map(|color| color.map(Into::into));
        self.replace(Background::of_sky(up.into(), colors))
    }

    /// Replaces the background, unless it is faulty.
    fn replace(&mut self, background: Background) -> Result<(), Error> {
        if let Some((part, fault)) = background.fault() {
            return Err(Error::of(part, fault));
        }
        self.0.background = background;
        Ok(())
    }

    /// Sets epsilon: how far above a surface its shadow rays and reflected rays start, in scene units.
    /// Defaults to 0.001.
    ///
    /// [`SceneBuilder::epsilon`](crate::SceneBuilder::epsilon) says how it is rounded and which values
    /// suit a scene.
    ///
    /// # Errors
    /// [`ErrorKind::Epsilon`] if `epsilon` is not above 0, or is above 2³⁰. The scene is then unchanged.
    /// [`build`](RuntimeScene::build) checks that epsilon is smaller than the scene.
    pub fn set_epsilon(&mut self, epsilon: impl Into<Number>) -> Result<(), Error> {
        let epsilon = epsilon.into();
        if let Some(fault) = prepare::epsilon_fault(epsilon) {
            return Err(Error::of("scene", fault));
        }
        self.0.epsilon = epsilon;
        Ok(())
    }

    /// Sets the camera that the scene is usually viewed with; see
    /// [`SceneBuilder::camera`](crate::SceneBuilder::camera).
    pub fn set_camera(&mut self, camera: Camera) {
        self.0.camera = Some(camera);
    }

    /// Sets the box in which shapes of the scene may move, by its lowest and its highest corner; see
    /// [`SceneBuilder::motion`](crate::SceneBuilder::motion).
    ///
    /// # Errors
    /// [`ErrorKind::Coordinate`] if a coordinate is not within ±2³⁰, [`ErrorKind::Motion`] if a
    /// coordinate of `low` is above that of `high`. The scene is then unchanged.
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
        $header:tt
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
                    "The mistake in the ", stringify!($kind), ", or [`ErrorKind::", stringify!($too_many),
                    "`]. After an error the scene is unchanged."
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
    };
}
kinds!(runtime);

impl<R: Capacity> Default for RuntimeScene<R> {
    fn default() -> Self {
        Self::new()
    }
}
