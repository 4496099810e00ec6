//! Scenes filled while the program runs: from files, or changed between frames.

use heapless::Vec;

use super::{Description, EPSILON, Scene, SceneError, prepare};
use crate::camera::Camera;
use crate::fault::Fault;
use crate::light::Light;
use crate::material::Material;
use crate::number::{Number, to_u16, to_u32};
use crate::shape::MaterialId;
use crate::shape::cylinder::Cylinder;
use crate::shape::plane::Plane;
use crate::shape::sphere::Sphere;
use crate::vector::Position;

/// The description of a scene with room for `S` spheres, `P` planes, `C` cylinders, `L` lights and
/// `M` materials, filled at run time.
///
/// ```
/// use reflet::{Material, RuntimeScene, SceneError};
///
/// fn scene() -> Result<reflet::Scene<1, 0, 0, 1, 1>, SceneError> {
///     let mut scene = RuntimeScene::<1, 0, 0, 1, 1>::new();
///     let red = scene.add_material(Material::new([0.9, 0.1, 0.1]))?;
///     scene.add_sphere([0, 0, 1], 1, red)?; // any mix of i32, f32, f64 and fixed-point numbers
///     scene.add_light([3, -4, 6], [1, 1, 1])?;
///     scene.build()
/// }
/// assert!(scene().is_ok());
/// ```
#[derive(Clone, Debug)]
pub struct RuntimeScene<
    const S: usize,
    const P: usize,
    const C: usize,
    const L: usize,
    const M: usize = 8,
> {
    spheres: Vec<Sphere, S>,
    planes: Vec<Plane, P>,
    cylinders: Vec<Cylinder, C>,
    lights: Vec<Light, L>,
    materials: Vec<Material, M>,
    background: [Number; 3],
    epsilon: Number,
    camera: Option<Camera>,
}

impl<const S: usize, const P: usize, const C: usize, const L: usize, const M: usize>
    RuntimeScene<S, P, C, L, M>
{
    /// An empty scene with a black background and an epsilon of 0.001.
    pub const fn new() -> Self {
        Self {
            spheres: Vec::new(),
            planes: Vec::new(),
            cylinders: Vec::new(),
            lights: Vec::new(),
            materials: Vec::new(),
            background: [Number::ZERO; 3],
            epsilon: Number::new(EPSILON),
            camera: None,
        }
    }

    /// Adds a material and returns the name that shapes use for it.
    ///
    /// # Errors
    /// [`Fault::TooManyMaterials`].
    pub fn add_material(&mut self, material: Material) -> Result<MaterialId, SceneError> {
        const { assert!(M <= 1 << 16, "a scene has 65536 materials at most") };
        let index = self.materials.len();
        match self.materials.push(material) {
            Ok(()) => Ok(MaterialId(to_u16(to_u32(index)))),
            Err(_) => Err(SceneError::Material(index, Fault::TooManyMaterials)),
        }
    }

    /// Adds a sphere with a radius greater than 0.
    ///
    /// # Errors
    /// What is wrong with the sphere, or [`Fault::TooManySpheres`]; the scene is as it was.
    pub fn add_sphere(
        &mut self,
        center: impl Into<Position>,
        radius: impl Into<Number>,
        material: MaterialId,
    ) -> Result<(), SceneError> {
        let sphere = Sphere {
            center: center.into(),
            radius: radius.into(),
            material,
        };
        let fault = sphere.fault().or(self.unknown(material));
        pushed(
            &mut self.spheres,
            sphere,
            fault,
            SceneError::Sphere,
            Fault::TooManySpheres,
        )
    }

    /// Adds an infinite plane through `point`; the normal may have any length but 0.
    ///
    /// # Errors
    /// What is wrong with the plane, or [`Fault::TooManyPlanes`]; the scene is as it was.
    pub fn add_plane(
        &mut self,
        point: impl Into<Position>,
        normal: impl Into<Position>,
        material: MaterialId,
    ) -> Result<(), SceneError> {
        let plane = Plane {
            point: point.into(),
            normal: normal.into(),
            material,
        };
        let fault = plane.fault().or(self.unknown(material));
        pushed(
            &mut self.planes,
            plane,
            fault,
            SceneError::Plane,
            Fault::TooManyPlanes,
        )
    }

    /// Adds an open cylinder around its `center`; the axis may have any length but 0, radius and
    /// height are greater than 0.
    ///
    /// # Errors
    /// What is wrong with the cylinder, or [`Fault::TooManyCylinders`]; the scene is as it was.
    pub fn add_cylinder(
        &mut self,
        center: impl Into<Position>,
        axis: impl Into<Position>,
        radius: impl Into<Number>,
        height: impl Into<Number>,
        material: MaterialId,
    ) -> Result<(), SceneError> {
        let cylinder = Cylinder {
            center: center.into(),
            axis: axis.into(),
            radius: radius.into(),
            height: height.into(),
            material,
        };
        let fault = cylinder.fault().or(self.unknown(material));
        let full = Fault::TooManyCylinders;
        pushed(
            &mut self.cylinders,
            cylinder,
            fault,
            SceneError::Cylinder,
            full,
        )
    }

    /// Adds a point light; colour components are 0 to 16.
    ///
    /// # Errors
    /// What is wrong with the light, or [`Fault::TooManyLights`]; the scene is as it was.
    pub fn add_light(
        &mut self,
        position: impl Into<Position>,
        color: [impl Into<Number>; 3],
    ) -> Result<(), SceneError> {
        let light = Light {
            position: position.into(),
            color: color.map(Into::into),
        };
        let fault = prepare::light_fault(&light);
        pushed(
            &mut self.lights,
            light,
            fault,
            SceneError::Light,
            Fault::TooManyLights,
        )
    }

    /// Sets what a ray that meets nothing adds, 0 to 16 a component.
    ///
    /// # Errors
    /// [`Fault::Background`]; the scene is as it was.
    pub fn set_background(&mut self, color: [impl Into<Number>; 3]) -> Result<(), SceneError> {
        let background = color.map(Into::into);
        if let Some(fault) = prepare::background_fault(background) {
            return Err(SceneError::Scene(fault));
        }
        self.background = background;
        Ok(())
    }

    /// Sets how far above a surface the shadow rays and mirrored rays start that leave it, in scene
    /// units; 0.001 unless it is set. [`SceneBuilder::epsilon`](super::SceneBuilder::epsilon) says how it
    /// is rounded and what becomes of one that is too small or too large.
    ///
    /// # Errors
    /// [`Fault::Epsilon`] if it is not above 0, or is above 2³⁰; the scene is as it was. That it is smaller
    /// than the scene is checked by [`build`](Self::build).
    pub fn set_epsilon(&mut self, epsilon: impl Into<Number>) -> Result<(), SceneError> {
        let epsilon = epsilon.into();
        if let Some(fault) = prepare::epsilon_fault(epsilon) {
            return Err(SceneError::Scene(fault));
        }
        self.epsilon = epsilon;
        Ok(())
    }

    /// Sets the camera the scene is meant to be seen with first; see [`super::SceneBuilder::camera`].
    pub fn set_camera(&mut self, camera: Camera) {
        self.camera = Some(camera);
    }

    /// The description so far.
    pub fn description(&self) -> Description<'_> {
        Description {
            spheres: &self.spheres,
            planes: &self.planes,
            cylinders: &self.cylinders,
            lights: &self.lights,
            materials: &self.materials,
            background: self.background,
            epsilon: self.epsilon,
            camera: self.camera,
        }
    }

    /// Chooses the binary point and prepares the scene for the kernels, with integers only.
    ///
    /// # Errors
    /// What can only be seen in the scene as a whole: [`Fault::Tiny`], [`Fault::Extent`],
    /// [`Fault::Epsilon`] and [`Fault::Brightness`].
    pub fn build(&self) -> Result<Scene<S, P, C, L, M>, SceneError> {
        Scene::prepare(&self.description())
    }

    fn unknown(&self, material: MaterialId) -> Option<Fault> {
        (material.index() >= self.materials.len()).then_some(Fault::UnknownMaterial)
    }
}

impl<const S: usize, const P: usize, const C: usize, const L: usize, const M: usize> Default
    for RuntimeScene<S, P, C, L, M>
{
    fn default() -> Self {
        Self::new()
    }
}

/// Pushes a part that has no fault and for which there is room.
fn pushed<T, const N: usize>(
    parts: &mut Vec<T, N>,
    part: T,
    fault: Option<Fault>,
    place: fn(usize, Fault) -> SceneError,
    full: Fault,
) -> Result<(), SceneError> {
    let index = parts.len();
    if let Some(fault) = fault {
        return Err(place(index, fault));
    }
    parts.push(part).map_err(|_| place(index, full))
}
