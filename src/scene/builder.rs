//! Scenes written in plain numbers and built by the compiler.

use super::{Counts, Description, EPSILON, Scene, prepare};
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
/// `M` different materials, for constants.
///
/// Every method checks what it is given and panics with words that name the field and the fix;
/// in a constant that stops the compiler. For scenes that are filled while the program runs there
/// is [`crate::RuntimeScene`], which returns errors.
///
/// ```compile_fail
/// use reflet::{Material, Scene};
/// const SCENE: Scene<1, 0, 0, 0> =
///     Scene::builder().sphere([0.0; 3], -1.0, Material::new([1.0; 3])).build();
/// ```
#[derive(Clone, Copy, Debug)]
pub struct SceneBuilder<
    const S: usize,
    const P: usize,
    const C: usize,
    const L: usize,
    const M: usize = 8,
> {
    spheres: [Sphere; S],
    planes: [Plane; P],
    cylinders: [Cylinder; C],
    lights: [Light; L],
    materials: [Material; M],
    counts: Counts,
    background: [Number; 3],
    epsilon: Number,
    camera: Option<Camera>,
}

impl<const S: usize, const P: usize, const C: usize, const L: usize, const M: usize>
    SceneBuilder<S, P, C, L, M>
{
    /// An empty scene with a black background and an epsilon of 0.001.
    pub const fn new() -> Self {
        const { assert!(M <= 1 << 16, "a scene has 65536 materials at most") };
        Self {
            spheres: [Sphere::NONE; S],
            planes: [Plane::NONE; P],
            cylinders: [Cylinder::NONE; C],
            lights: [Light::NONE; L],
            materials: [Material::new([0.0; 3]); M],
            counts: Counts {
                spheres: 0,
                planes: 0,
                cylinders: 0,
                lights: 0,
                materials: 0,
            },
            background: [Number::ZERO; 3],
            epsilon: Number::new(EPSILON),
            camera: None,
        }
    }

    /// Adds a sphere with a radius greater than 0.
    pub const fn sphere(mut self, center: [f64; 3], radius: f64, material: Material) -> Self {
        refuse_when(self.counts.spheres == S, Fault::TooManySpheres);
        let material = self.id_of(material);
        let sphere = Sphere {
            center: Position::new(center),
            radius: Number::new(radius),
            material,
        };
        Fault::refuse(sphere.fault());
        self.spheres[self.counts.spheres] = sphere;
        self.counts.spheres += 1;
        self
    }

    /// Adds an infinite plane through `point`; the normal may have any length but 0.
    pub const fn plane(mut self, point: [f64; 3], normal: [f64; 3], material: Material) -> Self {
        refuse_when(self.counts.planes == P, Fault::TooManyPlanes);
        let material = self.id_of(material);
        let plane = Plane {
            point: Position::new(point),
            normal: Position::new(normal),
            material,
        };
        Fault::refuse(plane.fault());
        self.planes[self.counts.planes] = plane;
        self.counts.planes += 1;
        self
    }

    /// Adds an open cylinder around its `center`; the axis may have any length but 0, radius and
    /// height are greater than 0.
    pub const fn cylinder(
        mut self,
        center: [f64; 3],
        axis: [f64; 3],
        radius: f64,
        height: f64,
        material: Material,
    ) -> Self {
        refuse_when(self.counts.cylinders == C, Fault::TooManyCylinders);
        let cylinder = Cylinder {
            center: Position::new(center),
            axis: Position::new(axis),
            radius: Number::new(radius),
            height: Number::new(height),
            material: self.id_of(material),
        };
        Fault::refuse(cylinder.fault());
        self.cylinders[self.counts.cylinders] = cylinder;
        self.counts.cylinders += 1;
        self
    }

    /// Adds a point light; colour components are 0 to 16.
    pub const fn light(mut self, position: [f64; 3], color: [f64; 3]) -> Self {
        refuse_when(self.counts.lights == L, Fault::TooManyLights);
        let light = Light {
            position: Position::new(position),
            color: numbers(color),
        };
        Fault::refuse(prepare::light_fault(&light));
        self.lights[self.counts.lights] = light;
        self.counts.lights += 1;
        self
    }

    /// What a ray that meets nothing adds, 0 to 16 a component; black unless it is named.
    pub const fn background(mut self, color: [f64; 3]) -> Self {
        self.background = numbers(color);
        Fault::refuse(prepare::background_fault(self.background));
        self
    }

    /// How far above a surface the shadow rays and mirrored rays start that leave it, in scene units;
    /// 0.001 unless it is named.
    ///
    /// It must be above 0. The built scene has it in whole steps of its grid, rounded to the nearest, and
    /// refuses 2²⁸ steps and more: the radius of the ball that holds the shapes. A scene of planes alone
    /// takes any epsilon up to 2³⁰ scene units, because its ball grows with it.
    ///
    /// Less than 2 steps become 2. A ray that leaves the inside of a sphere or cylinder can meet the same
    /// shape again; for it less than 8 steps become 8, or 16 in a scene with cylinders. So no surface
    /// shadows itself, however small epsilon is. But lights, planes and the scene's camera that stand
    /// outside of the shapes' ball and further from its middle than 2²² times epsilon may be kept as
    /// far places, which take more instructions.
    ///
    /// If epsilon is too large, rays start beyond what lies nearer to the surface than epsilon: shadows and
    /// reflections do not reach the place where two shapes touch. It should be small beside the smallest
    /// shape and the smallest gap.
    pub const fn epsilon(mut self, epsilon: f64) -> Self {
        self.epsilon = Number::new(epsilon);
        Fault::refuse(prepare::epsilon_fault(self.epsilon));
        self
    }

    /// The camera the scene is meant to be seen with first. The binary point is chosen so that it
    /// has its place beside the shapes; any other camera can be used as well.
    pub const fn camera(mut self, camera: Camera) -> Self {
        self.camera = Some(camera);
        self
    }

    /// The description so far.
    pub const fn description(&self) -> Description<'_> {
        Description {
            spheres: self.spheres.split_at(self.counts.spheres).0,
            planes: self.planes.split_at(self.counts.planes).0,
            cylinders: self.cylinders.split_at(self.counts.cylinders).0,
            lights: self.lights.split_at(self.counts.lights).0,
            materials: self.materials.split_at(self.counts.materials).0,
            background: self.background,
            epsilon: self.epsilon,
            camera: self.camera,
        }
    }

    /// Chooses the binary point and prepares the scene for the kernels.
    pub const fn build(&self) -> Scene<S, P, C, L, M> {
        match Scene::prepare(&self.description()) {
            Ok(scene) => scene,
            Err(error) => panic!("{}", error.fault().words()),
        }
    }

    /// The number of a material, which is kept once however often it is used.
    const fn id_of(&mut self, material: Material) -> MaterialId {
        let mut index = 0;
        while index < self.counts.materials {
            if self.materials[index].same(&material) {
                return MaterialId(to_u16(to_u32(index)));
            }
            index += 1;
        }
        refuse_when(index == M, Fault::TooManyMaterials);
        self.materials[index] = material;
        self.counts.materials += 1;
        MaterialId(to_u16(to_u32(index)))
    }
}

impl<const S: usize, const P: usize, const C: usize, const L: usize, const M: usize> Default
    for SceneBuilder<S, P, C, L, M>
{
    fn default() -> Self {
        Self::new()
    }
}

const fn numbers([red, green, blue]: [f64; 3]) -> [Number; 3] {
    [Number::new(red), Number::new(green), Number::new(blue)]
}

const fn refuse_when(wrong: bool, fault: Fault) {
    if wrong {
        Fault::refuse(Some(fault));
    }
}

#[cfg(test)]
mod tests;
