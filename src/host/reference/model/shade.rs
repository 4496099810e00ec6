//! The light that a surface itself sends to the viewer; it never asks what the surface mirrors.

use super::{Light, Ray, Real, Scene, Shading, Surface, Vector, power};

/// What the normals view shows where nothing is met.
const BLUE: Vector = Vector([0.0, 0.0, 1.0]);

impl Scene<'_> {
    /// What the normals view shows along a ray.
    pub fn normal_color(&self, ray: &Ray) -> Vector {
        let half = |normal| (normal + Vector::grey(1.0)) * 0.5;
        self.nearest(ray)
            .map_or(BLUE, |surface| half(surface.normal))
    }

    /// Ambient, diffuse and specular light at a surface, in the surface's colour.
    #[inline]
    pub fn own_color(&self, surface: &Surface, shading: Shading) -> Vector {
        let mut light = Vector::grey(surface.material.ambient);
        for lamp in self.lights {
            light += lamp.color * self.strength(surface, lamp, shading);
        }
        surface.material.color.filtered(light)
    }

    /// How much of a light's colour comes to the viewer; nothing where it is behind or blocked.
    #[inline]
    pub fn strength(&self, surface: &Surface, lamp: &Light, shading: Shading) -> Real {
        let to_lamp = lamp.position - surface.outside;
        let distance = to_lamp.length();
        let ray = Ray {
            origin: surface.outside,
            direction: to_lamp * (1.0 / distance),
        };
        let facing = surface.normal.dot(ray.direction);
        // A lamp exactly here has no direction, and what is not a number is not above zero.
        let is_lit = facing > 0.0 && !self.is_blocked(&ray, distance - self.epsilon);
        if !is_lit {
            return 0.0;
        }
        let material = surface.material;
        let diffuse = material.diffuse * facing;
        if material.specular == 0.0 {
            return diffuse;
        }
        let cosine = surface.gleam(ray.direction, shading);
        // Where the mirrored light points away from the viewer there is no highlight, not even one of
        // shininess 0.
        if cosine > 0.0 {
            diffuse + material.specular * power(cosine, material.shininess)
        } else {
            diffuse
        }
    }
}

impl Surface<'_> {
    /// The cosine that a highlight is a power of, by the unit vector to the light.
    #[inline]
    pub fn gleam(&self, to_light: Vector, shading: Shading) -> Real {
        match shading {
            Shading::Phong => to_light.mirrored(self.normal).dot(self.viewer),
            // The normals view has none.
            Shading::BlinnPhong | Shading::Normals => {
                self.normal.dot((to_light + self.viewer).unit())
            }
        }
    }
}
