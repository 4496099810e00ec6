// Written by `cargo run --release --package report -- --core m3 --size 128x128`:
// what is best for a frame of so many instructions. Include it where `ParetoFront`, `FrontPoint` and
// `QualityLevel` are in scope.
/// castle
pub const CASTLE: ParetoFront = ParetoFront::new(&[
    FrontPoint { prepare: 85461, instructions: 79, reflections: 0, level: QualityLevel::Fast, scale: 4, psnr: 1309, largest: 231 },
    FrontPoint { prepare: 85461, instructions: 123, reflections: 1, level: QualityLevel::Fast, scale: 4, psnr: 2177, largest: 231 },
    FrontPoint { prepare: 84641, instructions: 391, reflections: 1, level: QualityLevel::Fast, scale: 2, psnr: 2550, largest: 211 },
    FrontPoint { prepare: 84476, instructions: 1234, reflections: 1, level: QualityLevel::Fast, scale: 1, psnr: 4252, largest: 76 },
    FrontPoint { prepare: 84476, instructions: 1261, reflections: 2, level: QualityLevel::Fast, scale: 1, psnr: 5909, largest: 16 },
    FrontPoint { prepare: 84476, instructions: 1265, reflections: 3, level: QualityLevel::Fast, scale: 1, psnr: 7788, largest: 3 },
    FrontPoint { prepare: 84476, instructions: 1369, reflections: 3, level: QualityLevel::Fine, scale: 1, psnr: 8274, largest: 3 },
]);
/// shading_lights
pub const SHADING_LIGHTS: ParetoFront = ParetoFront::new(&[
    FrontPoint { prepare: 2455, instructions: 66, reflections: 0, level: QualityLevel::Fast, scale: 4, psnr: 2214, largest: 184 },
    FrontPoint { prepare: 2455, instructions: 87, reflections: 1, level: QualityLevel::Fine, scale: 4, psnr: 2658, largest: 181 },
    FrontPoint { prepare: 2455, instructions: 301, reflections: 1, level: QualityLevel::Fast, scale: 2, psnr: 2889, largest: 180 },
    FrontPoint { prepare: 2455, instructions: 743, reflections: 1, level: QualityLevel::Fast, scale: 1, psnr: 6915, largest: 1 },
    FrontPoint { prepare: 2455, instructions: 1025, reflections: 1, level: QualityLevel::Fine, scale: 1, psnr: 8805, largest: 1 },
]);
/// shading_speculars
pub const SHADING_SPECULARS: ParetoFront = ParetoFront::new(&[
    FrontPoint { prepare: 9430, instructions: 63, reflections: 0, level: QualityLevel::Fast, scale: 4, psnr: 1870, largest: 173 },
    FrontPoint { prepare: 9430, instructions: 83, reflections: 1, level: QualityLevel::Fast, scale: 4, psnr: 2228, largest: 147 },
    FrontPoint { prepare: 9430, instructions: 252, reflections: 1, level: QualityLevel::Fast, scale: 2, psnr: 2618, largest: 155 },
    FrontPoint { prepare: 9430, instructions: 746, reflections: 1, level: QualityLevel::Fast, scale: 1, psnr: 4776, largest: 10 },
    FrontPoint { prepare: 9430, instructions: 804, reflections: 2, level: QualityLevel::Fast, scale: 1, psnr: 6423, largest: 2 },
    FrontPoint { prepare: 9430, instructions: 817, reflections: 3, level: QualityLevel::Fast, scale: 1, psnr: 6717, largest: 1 },
    FrontPoint { prepare: 9430, instructions: 1045, reflections: 3, level: QualityLevel::Fine, scale: 1, psnr: 7948, largest: 1 },
    FrontPoint { prepare: 9430, instructions: 1047, reflections: 4, level: QualityLevel::Fine, scale: 1, psnr: 8300, largest: 1 },
]);
/// columns
pub const COLUMNS: ParetoFront = ParetoFront::new(&[
    FrontPoint { prepare: 22336, instructions: 82, reflections: 0, level: QualityLevel::Fast, scale: 4, psnr: 2647, largest: 177 },
    FrontPoint { prepare: 22336, instructions: 105, reflections: 1, level: QualityLevel::Fast, scale: 4, psnr: 2677, largest: 178 },
    FrontPoint { prepare: 22459, instructions: 259, reflections: 0, level: QualityLevel::Fast, scale: 2, psnr: 2936, largest: 163 },
    FrontPoint { prepare: 22459, instructions: 324, reflections: 1, level: QualityLevel::Fast, scale: 2, psnr: 2980, largest: 173 },
    FrontPoint { prepare: 22543, instructions: 768, reflections: 0, level: QualityLevel::Fast, scale: 1, psnr: 3829, largest: 56 },
    FrontPoint { prepare: 22543, instructions: 979, reflections: 1, level: QualityLevel::Fast, scale: 1, psnr: 5797, largest: 16 },
    FrontPoint { prepare: 22543, instructions: 1032, reflections: 2, level: QualityLevel::Fast, scale: 1, psnr: 7421, largest: 2 },
    FrontPoint { prepare: 22543, instructions: 1044, reflections: 3, level: QualityLevel::Fast, scale: 1, psnr: 7463, largest: 1 },
    FrontPoint { prepare: 22543, instructions: 1151, reflections: 2, level: QualityLevel::Fine, scale: 1, psnr: 8249, largest: 2 },
    FrontPoint { prepare: 22543, instructions: 1162, reflections: 3, level: QualityLevel::Fine, scale: 1, psnr: 8659, largest: 1 },
]);
/// mirror1
pub const MIRROR1: ParetoFront = ParetoFront::new(&[
    FrontPoint { prepare: 13446, instructions: 63, reflections: 0, level: QualityLevel::Fast, scale: 4, psnr: 1574, largest: 255 },
    FrontPoint { prepare: 13446, instructions: 91, reflections: 1, level: QualityLevel::Fast, scale: 4, psnr: 2297, largest: 255 },
    FrontPoint { prepare: 13446, instructions: 329, reflections: 1, level: QualityLevel::Fast, scale: 2, psnr: 2508, largest: 234 },
    FrontPoint { prepare: 13446, instructions: 1120, reflections: 1, level: QualityLevel::Fast, scale: 1, psnr: 4363, largest: 47 },
    FrontPoint { prepare: 13446, instructions: 1240, reflections: 2, level: QualityLevel::Fast, scale: 1, psnr: 5691, largest: 17 },
    FrontPoint { prepare: 13446, instructions: 1268, reflections: 3, level: QualityLevel::Fast, scale: 1, psnr: 7500, largest: 3 },
    FrontPoint { prepare: 13446, instructions: 1273, reflections: 4, level: QualityLevel::Fast, scale: 1, psnr: 8027, largest: 1 },
    FrontPoint { prepare: 13446, instructions: 1310, reflections: 4, level: QualityLevel::Fine, scale: 1, psnr: 8659, largest: 1 },
    FrontPoint { prepare: 13446, instructions: 1312, reflections: 5, level: QualityLevel::Fine, scale: 1, psnr: 8902, largest: 1 },
]);
/// mirror2
pub const MIRROR2: ParetoFront = ParetoFront::new(&[
    FrontPoint { prepare: 21150, instructions: 77, reflections: 0, level: QualityLevel::Fast, scale: 4, psnr: 1790, largest: 251 },
    FrontPoint { prepare: 21150, instructions: 144, reflections: 1, level: QualityLevel::Fast, scale: 4, psnr: 2046, largest: 224 },
    FrontPoint { prepare: 21150, instructions: 209, reflections: 2, level: QualityLevel::Fast, scale: 4, psnr: 2226, largest: 224 },
    FrontPoint { prepare: 21150, instructions: 253, reflections: 3, level: QualityLevel::Fast, scale: 4, psnr: 2334, largest: 224 },
    FrontPoint { prepare: 21150, instructions: 811, reflections: 2, level: QualityLevel::Fast, scale: 2, psnr: 2403, largest: 224 },
    FrontPoint { prepare: 21150, instructions: 1077, reflections: 3, level: QualityLevel::Fast, scale: 2, psnr: 2601, largest: 224 },
    FrontPoint { prepare: 21144, instructions: 2225, reflections: 2, level: QualityLevel::Fast, scale: 1, psnr: 2770, largest: 164 },
    FrontPoint { prepare: 21144, instructions: 3017, reflections: 3, level: QualityLevel::Fast, scale: 1, psnr: 5384, largest: 26 },
    FrontPoint { prepare: 21144, instructions: 3200, reflections: 4, level: QualityLevel::Fast, scale: 1, psnr: 6379, largest: 12 },
    FrontPoint { prepare: 21144, instructions: 3224, reflections: 5, level: QualityLevel::Fast, scale: 1, psnr: 7062, largest: 6 },
    FrontPoint { prepare: 21144, instructions: 3234, reflections: 6, level: QualityLevel::Fast, scale: 1, psnr: 7404, largest: 2 },
    FrontPoint { prepare: 21144, instructions: 3237, reflections: 8, level: QualityLevel::Fast, scale: 1, psnr: 7436, largest: 1 },
    FrontPoint { prepare: 21144, instructions: 3740, reflections: 6, level: QualityLevel::Fine, scale: 1, psnr: 8328, largest: 2 },
    FrontPoint { prepare: 21144, instructions: 3744, reflections: 7, level: QualityLevel::Fine, scale: 1, psnr: 8601, largest: 1 },
    FrontPoint { prepare: 21144, instructions: 3746, reflections: 8, level: QualityLevel::Fine, scale: 1, psnr: 8726, largest: 1 },
]);
/// primitives
pub const PRIMITIVES: ParetoFront = ParetoFront::new(&[
    FrontPoint { prepare: 5754, instructions: 54, reflections: 0, level: QualityLevel::Fast, scale: 4, psnr: 1923, largest: 255 },
    FrontPoint { prepare: 5754, instructions: 76, reflections: 1, level: QualityLevel::Fast, scale: 4, psnr: 2343, largest: 196 },
    FrontPoint { prepare: 5754, instructions: 246, reflections: 1, level: QualityLevel::Fast, scale: 2, psnr: 2659, largest: 212 },
    FrontPoint { prepare: 5754, instructions: 785, reflections: 1, level: QualityLevel::Fast, scale: 1, psnr: 4326, largest: 20 },
    FrontPoint { prepare: 5754, instructions: 814, reflections: 2, level: QualityLevel::Fast, scale: 1, psnr: 5820, largest: 20 },
    FrontPoint { prepare: 5754, instructions: 824, reflections: 3, level: QualityLevel::Fast, scale: 1, psnr: 7550, largest: 3 },
    FrontPoint { prepare: 5754, instructions: 825, reflections: 4, level: QualityLevel::Fast, scale: 1, psnr: 7986, largest: 1 },
    FrontPoint { prepare: 5754, instructions: 899, reflections: 4, level: QualityLevel::Fine, scale: 1, psnr: 8902, largest: 1 },
]);
/// empty
pub const EMPTY: ParetoFront = ParetoFront::new(&[
    FrontPoint { prepare: 181, instructions: 2, reflections: 0, level: QualityLevel::Fast, scale: 1, psnr: 65535, largest: 0 },
]);
/// floor
pub const FLOOR: ParetoFront = ParetoFront::new(&[
    FrontPoint { prepare: 436, instructions: 12, reflections: 0, level: QualityLevel::Fine, scale: 4, psnr: 2432, largest: 124 },
    FrontPoint { prepare: 436, instructions: 39, reflections: 0, level: QualityLevel::Fine, scale: 2, psnr: 65535, largest: 0 },
]);
/// corner1
pub const CORNER1: ParetoFront = ParetoFront::new(&[
    FrontPoint { prepare: 748, instructions: 34, reflections: 0, level: QualityLevel::Fast, scale: 4, psnr: 3026, largest: 101 },
    FrontPoint { prepare: 748, instructions: 85, reflections: 0, level: QualityLevel::Fast, scale: 2, psnr: 3777, largest: 66 },
    FrontPoint { prepare: 748, instructions: 199, reflections: 0, level: QualityLevel::Fast, scale: 1, psnr: 6003, largest: 43 },
]);
/// cylinders
pub const CYLINDERS: ParetoFront = ParetoFront::new(&[
    FrontPoint { prepare: 4462, instructions: 27, reflections: 0, level: QualityLevel::Fine, scale: 4, psnr: 2041, largest: 255 },
    FrontPoint { prepare: 4462, instructions: 80, reflections: 0, level: QualityLevel::Fine, scale: 2, psnr: 2410, largest: 255 },
    FrontPoint { prepare: 4462, instructions: 221, reflections: 0, level: QualityLevel::Fine, scale: 1, psnr: 3907, largest: 35 },
    FrontPoint { prepare: 4462, instructions: 290, reflections: 1, level: QualityLevel::Fine, scale: 1, psnr: 6310, largest: 3 },
    FrontPoint { prepare: 4462, instructions: 325, reflections: 2, level: QualityLevel::Fast, scale: 1, psnr: 7986, largest: 1 },
    FrontPoint { prepare: 4462, instructions: 341, reflections: 3, level: QualityLevel::Fine, scale: 1, psnr: 65535, largest: 0 },
]);
