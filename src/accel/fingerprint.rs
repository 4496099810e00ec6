//! The fingerprint of a scene: a number that lets a frame recognise the scene it was prepared for.

use crate::material::Material;
use crate::number::{Number, to_u32};
use crate::ray::spread;
use crate::scene::Description;
use crate::vector::Position;

/// A 32-bit hash of a scene's description, computed byte by byte.
#[derive(Clone, Copy, Debug)]
pub(super) struct Fingerprint(pub(super) u32);

/// Returns the hash of all numbers of a description, or of a part of one.
macro_rules! add {
    ($hash:ident, Position, $value:expr) => {
        $hash.position(&$value)
    };
    ($hash:ident, Number, $value:expr) => {
        $hash.number($value)
    };
    ($hash:ident, Corners, $value:expr) => {
        $hash.positions(&$value.positions())
    };
    ($hash:ident, Normals, $value:expr) => {
        match &$value.0 {
            Some(normals) => $hash.positions(normals),
            None => $hash,
        }
    };
}

macro_rules! fingerprint {
    (
        $header:tt
        $({ $list:ident $kind:ident $described:ident $prepared:ident $room:ident $lists:ident $active:tt
            $set:ident $too_many:ident $without:ident
            $(#[$doc:meta])* $add:ident($($field:ident: $type:ident),*) })*
    ) => {
        impl Fingerprint {
            /// Hashes every number of a description.
            pub(super) const fn of(scene: &Description<'_>) -> Self {
                let mut hash = Self(0);
                $(
                    let mut index = 0;
                    while index < scene.$list.len() {
                        let $kind = &scene.$list[index];
                        hash = hash.$kind(index, $kind).index($kind.material.index());
                        index += 1;
                    }
                )*
                hash.planes_and_lights(scene).rest(scene)
            }

            $(
                #[doc = concat!("Adds the place of a ", stringify!($kind), ".")]
                pub(super) const fn $kind(
                    self,
                    index: usize,
                    $kind: &crate::shape::$described,
                ) -> Self {
                    let hash = self.index(index);
                    $(let hash = add!(hash, $type, $kind.$field);)*
                    hash
                }
            )*
        }
    };
}
kinds!(fingerprint);

impl Fingerprint {
    const fn positions(self, [one, two, three]: &[Position; 3]) -> Self {
        self.position(one).position(two).position(three)
    }

    const fn planes_and_lights(self, scene: &Description<'_>) -> Self {
        let mut hash = self;
        let mut index = 0;
        while index < scene.planes.len() {
            let plane = &scene.planes[index];
            hash = hash.position(&plane.point).position(&plane.normal);
            hash = hash.index(plane.material.index());
            index += 1;
        }
        index = 0;
        while index < scene.lights.len() {
            let light = &scene.lights[index];
            hash = hash.light(index, &light.position).color(&light.color);
            if let Some(disc) = light.sun {
                hash = hash.number(disc).index(1);
            }
            if let Some(range) = light.range {
                hash = hash.number(range).index(2);
            }
            index += 1;
        }
        hash
    }

    const fn rest(self, scene: &Description<'_>) -> Self {
        let mut hash = self.color(&scene.background).number(scene.epsilon);
        if let Some(sky) = &scene.sky {
            hash = hash.position(&sky.up).color(&sky.below);
            hash = hash.color(&sky.horizon).color(&sky.above);
        }
        let mut index = 0;
        while index < scene.materials.len() {
            hash = hash.material(&scene.materials[index]);
            index += 1;
        }
        if let Some(camera) = &scene.camera {
            let it = camera.description();
            hash = hash.positions(&[it.position, it.target, it.up]);
            hash = hash.number(it.fov);
        }
        if let Some([low, high]) = &scene.motion {
            hash = hash.position(low).position(high);
        }
        hash
    }

    const fn material(self, material: &Material) -> Self {
        let [ambient, diffuse, specular, shininess, mirror] = material.described_coefficients();
        let hash = self.color(&material.described_color());
        let hash = hash.number(ambient).number(diffuse).number(specular);
        let hash = hash.number(shininess).number(mirror);
        match &material.described_checker() {
            Some(checker) => hash.color(&checker.color).color(&checker.size).index(1),
            None => hash,
        }
    }

    /// Adds the place of a light.
    pub(super) const fn light(self, index: usize, position: &Position) -> Self {
        self.index(index).position(position)
    }

    const fn color(self, [red, green, blue]: &[Number; 3]) -> Self {
        self.number(*red).number(*green).number(*blue)
    }

    const fn position(self, position: &Position) -> Self {
        self.color(&position.0)
    }

    #[inline(never)]
    const fn number(self, number: Number) -> Self {
        let [a, b, c, d, e, f, g, h, i, j, k, l, m, n, o, p] = number.to_bits().to_le_bytes();
        let low = self.word([a, b, c, d]).word([e, f, g, h]);
        low.word([i, j, k, l]).word([m, n, o, p])
    }

    const fn index(self, index: usize) -> Self {
        self.word(to_u32(index).to_le_bytes())
    }

    const fn word(self, bytes: [u8; 4]) -> Self {
        Self(spread(self.0.rotate_left(5) ^ u32::from_le_bytes(bytes)))
    }
}

#[cfg(test)]
mod tests;
