//! Computes a surface's own colour: ambient, diffuse and specular light. This file ignores reflections.

use super::{Light, Ray, Real, Scene, Shading, Surface, Vector, power};

/// Colour that [`Shading::Normals`] shows for a ray that hits nothing.
const BLUE: Vector = Vector([0.0, 0.0, 1.0]);

impl Scene<'_> {
    /// Returns the colour along a ray for [`Shading::Normals`]: (n + 1) / 2 at the nearest hit, else
    /// blue.
    pub fn normal_color(&self, ray: &Ray) -> Vector {
        let half = |normal| (normal + Vector::grey(1.0)) * 0.5;
        self.nearest(ray)
            .map_or(BLUE, |surface| half(surface.normal))
    }

    /// Returns the ambient, diffuse and specular light at a surface, multiplied by the material's
    /// colour.
    #[inline]
    pub fn own_color(&self, surface: &Surface, shading: Shading) -> Vector {
        let mut light = Vector::grey(surface.material.ambient);
        for lamp in self.lights {
            light += lamp.color * self.strength(surface, lamp, shading);
        }
        surface.material.color_at(surface.outside).filtered(light)
    }

    /// Returns the factor of a light's colour in the light that the surface sends to the viewer: diffuse
    /// and specular light, before the material's colour. It is 0 if the light is behind the surface or
    /// blocked.
    #[inline]
    pub fn strength(&self, surface: &Surface, lamp: &Light, shading: Shading) -> Real {
        match self.arrival(surface, lamp) {
            Some(arrival) => {
                let sent = Self::sent_on(surface, arrival, shading);
                match lamp.range {
                    Some(range) => sent * Light::share_at(range, lamp.seen_from(surface.outside).1),
                    None => sent,
                }
            }
            None => 0.0,
        }
    }

    /// Returns the direction to a light and the cosine of its angle to the normal. Returns `None` if the
    /// light is behind the surface or blocked.
    #[inline]
    pub fn arrival(&self, surface: &Surface, lamp: &Light) -> Option<(Vector, Real)> {
        let (direction, distance) = lamp.seen_from(surface.outside);
        let ray = Ray {
            origin: surface.outside,
            direction,
        };
        let facing = surface.normal.dot(ray.direction);
        // For a light exactly at this point `facing` is not a number, and so not above zero.
        let is_lit = facing > 0.0 && !self.is_blocked(&ray, distance - self.epsilon);
        is_lit.then_some((ray.direction, facing))
    }

    /// Returns the share of the light that a surface sends on, from the direction and the cosine of
    /// [`Scene::arrival`].
    #[inline]
    pub fn sent_on(
        surface: &Surface,
        (to_light, facing): (Vector, Real),
        shading: Shading,
    ) -> Real {
        let material = surface.material;
        let diffuse = material.diffuse * facing;
        if material.specular == 0.0 {
            return diffuse;
        }
        let cosine = surface.gleam(to_light, shading);
        // There is no highlight if the mirrored light points away from the viewer, not even with
        // shininess 0.
        if cosine > 0.0 {
            diffuse + material.specular * power(cosine, material.shininess)
        } else {
            diffuse
        }
    }
}

impl Surface<'_> {
    /// Returns the cosine whose power is the highlight, for the unit vector `to_light`. It may be
    /// negative.
    #[inline]
    pub fn gleam(&self, to_light: Vector, shading: Shading) -> Real {
        match shading {
            Shading::Phong => to_light.mirrored(self.normal).dot(self.viewer),
            // `Normals` shows no highlight, so any value does.
            Shading::BlinnPhong | Shading::Normals => {
                self.normal.dot((to_light + self.viewer).unit())
            }
        }
    }
}
