//! The built-in scene `castle`.

use crate::{Camera, Material, scene};

const WALL: Material = Material::new([0.6, 0.6, 0.6])
    .ambient(0.2)
    .diffuse(0.9)
    .specular(0.05, 2.0);
const GRASS: Material = Material::new([0.1, 0.3, 0.1])
    .ambient(0.2)
    .diffuse(0.5)
    .specular(0.1, 2.0);
const GOLD: Material = Material::new([0.7, 0.6, 0.0])
    .ambient(0.2)
    .diffuse(0.4)
    .specular(0.8, 4.0)
    .mirror(0.4);
const WATER: Material = Material::new([0.6, 0.8, 1.0])
    .ambient(0.2)
    .diffuse(0.1)
    .specular(1.0, 4.0)
    .mirror(0.7);
const SKY: Material = Material::new([0.4, 0.4, 0.9])
    .ambient(0.2)
    .diffuse(0.9)
    .specular(0.0, 8.0);
const CLOUD: Material = Material::new([1.0, 1.0, 1.0])
    .ambient(0.4)
    .diffuse(0.7)
    .specular(0.0, 2.0);

pub(super) const CAMERA: Camera = Camera::look_at(
    [24.186, -55.742, 26.689],
    [20.357, -47.128, 23.352],
    [-0.136, 0.305, 0.943],
)
.fov(50.0);

scene! {
    /// The scene `castle`: three towers with golden domes around a keep, on an island in a reflecting lake.
    pub struct Castle {
        // The island.
        sphere([0.0, 0.0, -21.682], 23.973, GRASS);
        // Golden domes.
        sphere([-1.002, 1.805, 11.07], 2.039, GOLD);
        sphere([-1.002, 1.805, 13.068], 1.349, GOLD);
        sphere([-1.002, 1.805, 14.636], 0.836, GOLD);
        sphere([3.601, -2.688, 14.475], 0.836, GOLD);
        sphere([3.601, -2.688, 12.907], 1.349, GOLD);
        sphere([3.601, -2.688, 10.908], 2.039, GOLD);
        sphere([5.703, 3.276, 6.737], 2.63, GOLD);
        // Hills around the lake.
        sphere([17.552, 30.95, -21.236], 21.337, GRASS);
        sphere([-30.014, -18.202, -21.937], 21.337, GRASS);
        sphere([24.793, -17.593, -21.636], 21.337, GRASS);
        // The last dome.
        sphere([5.641, 3.409, 9.028], 1.349, GOLD);
        // Clouds.
        sphere([-11.228, -2.638, 25.215], 1.922, CLOUD);
        sphere([-12.143, -3.811, 23.235], 2.309, CLOUD);
        sphere([-13.484, -2.399, 26.174], 2.086, CLOUD);
        sphere([-13.333, -7.328, 22.772], 4.715, CLOUD);
        sphere([-18.142, -7.591, 23.955], 2.309, CLOUD);
        sphere([-14.456, -5.548, 19.708], 2.309, CLOUD);
        sphere([-9.43, -4.96, 23.767], 2.309, CLOUD);
        sphere([-17.206, -9.675, 20.389], 3.484, CLOUD);
        sphere([-20.278, -11.128, 19.47], 1.387, CLOUD);
        sphere([-7.209, 15.244, 32.023], 1.7, CLOUD);
        sphere([-4.279, 16.884, 29.314], 4.27, CLOUD);
        sphere([4.687, 21.667, 23.143], 2.83, CLOUD);
        sphere([0.993, 15.483, 26.507], 2.83, CLOUD);
        sphere([-0.934, 19.277, 32.479], 2.83, CLOUD);
        sphere([0.438, 20.004, 26.602], 5.779, CLOUD);
        sphere([-2.997, 14.757, 24.082], 2.556, CLOUD);
        sphere([4.947, 19.405, 26.02], 2.83, CLOUD);
        sphere([7.271, 21.35, 26.198], 2.355, CLOUD);
        // A far hill.
        sphere([-36.502, 109.578, -75.372], 99.621, GRASS);
        // Far clouds.
        sphere([-34.709, 42.001, 43.469], 3.682, CLOUD);
        sphere([-38.342, 38.96, 43.191], 4.424, CLOUD);
        sphere([-50.761, 31.694, 40.16], 3.996, CLOUD);
        sphere([-45.391, 39.897, 44.099], 9.034, CLOUD);
        sphere([-47.535, 38.76, 53.288], 4.424, CLOUD);
        sphere([-44.523, 32.829, 43.951], 4.424, CLOUD);
        sphere([-38.748, 42.497, 38.692], 4.424, CLOUD);
        sphere([-52.766, 35.019, 48.34], 6.676, CLOUD);
        sphere([-57.347, 32.455, 52.575], 2.658, CLOUD);
        // The lake and the sky.
        plane([0.0, 0.0, -1.033], [0.0, 0.0, 1.0], WATER);
        plane([-33.708, 150.082, 43.878], [0.299, -0.79, -0.535], SKY);
        // The towers.
        cylinder([-1.002, 1.805, 6.025], [0.0, 0.0, 1.0], 1.556, 9.192, WALL);
        cylinder([2.889, 1.183, 1.254], [0.0, 0.0, 1.0], 5.08, 6.552, WALL);
        cylinder([3.517, -2.667, 4.98], [0.0, 0.0, 1.0], 1.556, 9.192, WALL);
        cylinder([5.673, 3.25, -1.256], [0.0, 0.0, 1.0], 2.456, 14.513, WALL);
        light([10.539, -61.862, 55.018], [1.0, 0.719, 0.413]);
        camera(CAMERA);
    }
}
