//! A scene that is being made: adds parts with random materials, lights and cameras. Never chooses
//! which parts a scene has.

use command_line::Shading;
use reflet::host::reference::{
    Camera, Cylinder, Disc, Light, Material, Plane, Scene, Sphere, Triangle, Vector,
};

use super::random::Random;
use crate::case::Case;

/// Direction of z.
pub const UP: Vector = Vector([0.0, 0.0, 1.0]);

/// Number of reflections of most scenes: the library's default.
const REFLECTIONS: u8 = 4;

/// A scene that is being made, with its random numbers.
pub struct Draft {
    /// Source of all random numbers of the scene.
    pub random: Random,
    /// The scene so far.
    pub scene: Scene,
    /// Number of reflections.
    pub reflections: u8,
    /// How light shines on surfaces.
    pub shading: Shading,
    camera: Camera,
}

impl Draft {
    /// Starts a scene with a random background.
    pub fn new(mut random: Random) -> Self {
        let background = random.color().map(|channel| 0.8 * channel);
        Self {
            random,
            scene: Scene {
                background,
                ..Scene::default()
            },
            reflections: REFLECTIONS,
            shading: Shading::BlinnPhong,
            camera: Camera {
                position: [0.0; 3],
                target: [0.0; 3],
                up: UP.0,
                fov: 50.0,
            },
        }
    }

    /// Returns the finished scene.
    pub fn case(self, name: String) -> Case {
        Case {
            name,
            scene: self.scene,
            camera: self.camera,
            reflections: self.reflections,
            shading: self.shading,
        }
    }

    /// Adds a material with this highlight and mirror share, and returns its number.
    pub fn material(&mut self, (specular, shininess): (f64, f64), mirror: f64) -> usize {
        let material = Material {
            color: self.random.color(),
            ambient: self.random.between(0.1, 0.4),
            diffuse: self.random.between(0.3, 0.8),
            specular,
            shininess,
            mirror,
            checker: None,
        };
        self.scene.materials.push(material);
        self.scene.materials.len() - 1
    }

    /// Adds a material that shines with probability one half, and mirrors with one quarter.
    pub fn any_material(&mut self) -> usize {
        let random = &mut self.random;
        let highlight = if random.chance(0.5) {
            (random.between(0.2, 1.0), random.log_between(2.0, 60.0))
        } else {
            (0.0, 1.0)
        };
        let mirror = if random.chance(0.25) { random.between(0.1, 0.6) } else { 0.0 };
        self.material(highlight, mirror)
    }

    pub fn sphere(&mut self, Vector(center): Vector, radius: f64, material: usize) {
        self.scene.spheres.push(Sphere {
            center,
            radius,
            material,
        });
    }

    /// Adds a cylinder of this radius and height.
    pub fn cylinder(
        &mut self,
        center: Vector,
        axis: Vector,
        (radius, height): (f64, f64),
        material: usize,
    ) {
        self.scene.cylinders.push(Cylinder {
            center: center.0,
            axis: axis.0,
            radius,
            height,
            material,
        });
    }

    pub fn disc(&mut self, center: Vector, normal: Vector, radius: f64, material: usize) {
        self.scene.discs.push(Disc {
            center: center.0,
            normal: normal.0,
            radius,
            material,
        });
    }

    pub fn triangle(
        &mut self,
        corners: [Vector; 3],
        normals: Option<[Vector; 3]>,
        material: usize,
    ) {
        self.scene.triangles.push(Triangle {
            corners: corners.map(|it| it.0),
            normals: normals.map(|it| it.map(|it| it.0)),
            material,
        });
    }

    pub fn plane(&mut self, point: Vector, normal: Vector, material: usize) {
        self.scene.planes.push(Plane {
            point: point.0,
            normal: normal.0,
            material,
        });
    }

    /// Adds a thin cylinder, up to 0.1 thick, with any material.
    pub fn rod(&mut self, center: Vector, axis: Vector, longest: f64) {
        let radius = self.random.log_between(0.003, 0.05);
        let height = self.random.between(0.5, longest);
        let material = self.any_material();
        self.cylinder(center, axis, (radius, height), material);
    }

    /// Adds a disc in any direction.
    pub fn any_disc(&mut self, center: Vector, radius: f64, material: usize) {
        let normal = self.random.direction();
        self.disc(center, normal, radius, material);
    }

    /// Adds a cylinder of this radius and height in any direction.
    pub fn any_cylinder(&mut self, center: Vector, size: (f64, f64), material: usize) {
        let axis = self.random.direction();
        self.cylinder(center, axis, size, material);
    }

    /// Adds a sphere, cylinder or disc of about this radius with any material.
    pub fn any_shape(&mut self, center: Vector, radius: f64) {
        let material = self.any_material();
        let direction = self.random.direction();
        match self.random.count(0, 3) {
            0 => self.disc(center, direction, radius, material),
            1 => {
                let size = (radius * 0.5, radius * self.random.log_between(0.5, 6.0));
                self.cylinder(center, direction, size, material);
            }
            _ => self.sphere(center, radius, material),
        }
    }

    /// Adds a plane of any material across z with this probability.
    pub fn floor(&mut self, probability: f64, point: Vector) {
        if self.random.chance(probability) {
            let material = self.any_material();
            self.plane(point, UP, material);
        }
    }

    /// Adds from `least` to `most` lights above z = 0 at about this distance.
    pub fn lights(&mut self, (least, most): (usize, usize), distance: f64) {
        for _ in 0..self.random.count(least, most) {
            self.light(distance);
        }
    }

    /// Adds a light above z = 0 at about this distance.
    pub fn light(&mut self, distance: f64) {
        let Vector([x, y, z]) = self.random.direction();
        let far = distance * self.random.between(0.7, 1.5);
        let position = (Vector([x, y, z.abs() + 0.15]).unit() * far).0;
        let bright = self.random.between(0.7, 1.2);
        let color = self.random.color().map(|it| (it * bright).max(0.1));
        self.scene.lights.push(Light {
            position,
            color,
            sun: None,
            range: None,
        });
    }

    /// Points a camera at `target` from this offset, with a field of view in degrees. One of five
    /// cameras is tilted to one side.
    pub fn camera(&mut self, target: Vector, offset: Vector, fov: f64) {
        let up = if self.random.chance(0.2) {
            self.random.across(offset.unit())
        } else if offset.unit().across(UP).length() < 1e-3 {
            // Not parallel to the view, even straight from above.
            Vector([0.0, 1.0, 0.0])
        } else {
            UP
        };
        self.look(target + offset, target, up, fov);
    }

    /// Points a camera at `target`, with a field of view in degrees.
    pub fn look(&mut self, position: Vector, target: Vector, up: Vector, fov: f64) {
        self.camera = Camera {
            position: position.0,
            target: target.0,
            up: up.0,
            fov,
        };
    }

    /// Points a camera at the middle of things of this size, from above z = 0.
    pub fn usual_camera(&mut self, size: f64) {
        let target = self.random.point() * (0.3 * size);
        let target = target + UP * (0.3 * size);
        let Vector([x, y, z]) = self.random.direction();
        let distance = size * self.random.between(1.5, 3.5);
        let offset = Vector([x, y, z.abs() + 0.1]).unit() * distance;
        let fov = self.random.between(30.0, 70.0);
        self.camera(target, offset, fov);
    }
}
