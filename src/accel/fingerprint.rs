//! The fingerprint of a scene: a number that lets a frame recognise the scene it was prepared for.

use core::hash::{Hash, Hasher};

use crate::ray::spread;

/// A 32-bit hash of a scene's description, computed byte by byte.
pub(super) struct Fingerprint(u32);

impl Fingerprint {
    /// Returns the hash of all numbers of a description, or of a part of one.
    pub(super) fn of(described: &impl Hash) -> u32 {
        let mut hash = Self(0);
        described.hash(&mut hash);
        hash.0
    }
}

impl Hasher for Fingerprint {
    fn write(&mut self, bytes: &[u8]) {
        for byte in bytes {
            self.0 = spread(self.0.rotate_left(5) ^ u32::from(*byte));
        }
    }

    fn finish(&self) -> u64 {
        self.0.into()
    }
}

#[cfg(test)]
mod tests {
    use crate::material::Material;
    use crate::scene::{Room, RuntimeScene};

    #[test]
    fn stamp_tells_scenes_apart() {
        let stamp = |x: f64, shade: f64| {
            let mut scene = RuntimeScene::<Room<1, 0, 0, 0>>::new();
            let chalk = scene.add_material(Material::new([shade; 3])).unwrap();
            scene.add_sphere([x, 0.0, 0.0], 1, chalk).unwrap();
            scene.build().unwrap().stamp
        };
        assert_eq!(stamp(0.5, 0.5), stamp(0.5, 0.5));
        assert_ne!(stamp(0.5, 0.5), stamp(0.25, 0.5));
        assert_ne!(stamp(0.5, 0.5), stamp(0.5, 0.25));
    }
}
