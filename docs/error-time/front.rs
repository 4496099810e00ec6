// Written by `cargo run --release --package report -- --core m3 --size 128x128`:
// what is best for a frame of so many instructions. Include it where `ParetoFront`, `FrontPoint` and
// `QualityLevel` are in scope.
/// castle
pub const CASTLE: ParetoFront = ParetoFront::new(&[
    FrontPoint { prepare: 85461, instructions: 75, reflections: 0, level: QualityLevel::Exact, scale: 4, psnr: 1309, largest: 231 },
    FrontPoint { prepare: 85461, instructions: 113, reflections: 1, level: QualityLevel::Exact, scale: 4, psnr: 2177, largest: 231 },
    FrontPoint { prepare: 84641, instructions: 390, reflections: 1, level: QualityLevel::Exact, scale: 2, psnr: 2550, largest: 211 },
    FrontPoint { prepare: 84476, instructions: 1236, reflections: 1, level: QualityLevel::Fast, scale: 1, psnr: 4252, largest: 76 },
    FrontPoint { prepare: 84476, instructions: 1263, reflections: 2, level: QualityLevel::Fast, scale: 1, psnr: 5909, largest: 16 },
    FrontPoint { prepare: 84476, instructions: 1267, reflections: 3, level: QualityLevel::Fast, scale: 1, psnr: 7788, largest: 3 },
    FrontPoint { prepare: 84476, instructions: 1441, reflections: 3, level: QualityLevel::Exact, scale: 1, psnr: 8425, largest: 3 },
    FrontPoint { prepare: 84476, instructions: 1442, reflections: 4, level: QualityLevel::Exact, scale: 1, psnr: 9504, largest: 1 },
]);
/// shading_lights
pub const SHADING_LIGHTS: ParetoFront = ParetoFront::new(&[
    FrontPoint { prepare: 2455, instructions: 48, reflections: 0, level: QualityLevel::Exact, scale: 4, psnr: 2214, largest: 184 },
    FrontPoint { prepare: 2455, instructions: 64, reflections: 1, level: QualityLevel::Exact, scale: 4, psnr: 2658, largest: 181 },
    FrontPoint { prepare: 2455, instructions: 249, reflections: 1, level: QualityLevel::Exact, scale: 2, psnr: 2889, largest: 180 },
    FrontPoint { prepare: 2455, instructions: 738, reflections: 1, level: QualityLevel::Fast, scale: 1, psnr: 6915, largest: 1 },
    FrontPoint { prepare: 2455, instructions: 944, reflections: 1, level: QualityLevel::Exact, scale: 1, psnr: 65535, largest: 0 },
]);
/// shading_speculars
pub const SHADING_SPECULARS: ParetoFront = ParetoFront::new(&[
    FrontPoint { prepare: 9430, instructions: 48, reflections: 0, level: QualityLevel::Exact, scale: 4, psnr: 1870, largest: 173 },
    FrontPoint { prepare: 9430, instructions: 69, reflections: 1, level: QualityLevel::Exact, scale: 4, psnr: 2228, largest: 147 },
    FrontPoint { prepare: 9430, instructions: 252, reflections: 1, level: QualityLevel::Fast, scale: 2, psnr: 2618, largest: 155 },
    FrontPoint { prepare: 9430, instructions: 746, reflections: 1, level: QualityLevel::Fast, scale: 1, psnr: 4776, largest: 10 },
    FrontPoint { prepare: 9430, instructions: 804, reflections: 2, level: QualityLevel::Fast, scale: 1, psnr: 6423, largest: 2 },
    FrontPoint { prepare: 9430, instructions: 818, reflections: 3, level: QualityLevel::Fast, scale: 1, psnr: 6717, largest: 1 },
    FrontPoint { prepare: 9430, instructions: 1047, reflections: 3, level: QualityLevel::Exact, scale: 1, psnr: 8203, largest: 1 },
    FrontPoint { prepare: 9430, instructions: 1049, reflections: 4, level: QualityLevel::Exact, scale: 1, psnr: 65535, largest: 0 },
]);
/// columns
pub const COLUMNS: ParetoFront = ParetoFront::new(&[
    FrontPoint { prepare: 22336, instructions: 68, reflections: 0, level: QualityLevel::Exact, scale: 4, psnr: 2647, largest: 177 },
    FrontPoint { prepare: 22336, instructions: 90, reflections: 1, level: QualityLevel::Exact, scale: 4, psnr: 2677, largest: 178 },
    FrontPoint { prepare: 22459, instructions: 242, reflections: 0, level: QualityLevel::Exact, scale: 2, psnr: 2936, largest: 163 },
    FrontPoint { prepare: 22459, instructions: 306, reflections: 1, level: QualityLevel::Exact, scale: 2, psnr: 2980, largest: 173 },
    FrontPoint { prepare: 22543, instructions: 764, reflections: 0, level: QualityLevel::Fast, scale: 1, psnr: 3829, largest: 56 },
    FrontPoint { prepare: 22543, instructions: 975, reflections: 1, level: QualityLevel::Fast, scale: 1, psnr: 5797, largest: 16 },
    FrontPoint { prepare: 22543, instructions: 1028, reflections: 2, level: QualityLevel::Fast, scale: 1, psnr: 7421, largest: 2 },
    FrontPoint { prepare: 22543, instructions: 1039, reflections: 3, level: QualityLevel::Fast, scale: 1, psnr: 7463, largest: 1 },
    FrontPoint { prepare: 22543, instructions: 1148, reflections: 2, level: QualityLevel::Exact, scale: 1, psnr: 8425, largest: 2 },
    FrontPoint { prepare: 22543, instructions: 1159, reflections: 3, level: QualityLevel::Exact, scale: 1, psnr: 65535, largest: 0 },
]);
/// mirror1
pub const MIRROR1: ParetoFront = ParetoFront::new(&[
    FrontPoint { prepare: 13446, instructions: 55, reflections: 0, level: QualityLevel::Exact, scale: 4, psnr: 1574, largest: 255 },
    FrontPoint { prepare: 13446, instructions: 80, reflections: 1, level: QualityLevel::Exact, scale: 4, psnr: 2297, largest: 255 },
    FrontPoint { prepare: 13446, instructions: 304, reflections: 1, level: QualityLevel::Exact, scale: 2, psnr: 2508, largest: 234 },
    FrontPoint { prepare: 13446, instructions: 1116, reflections: 1, level: QualityLevel::Exact, scale: 1, psnr: 4363, largest: 47 },
    FrontPoint { prepare: 13446, instructions: 1240, reflections: 2, level: QualityLevel::Fast, scale: 1, psnr: 5691, largest: 17 },
    FrontPoint { prepare: 13446, instructions: 1268, reflections: 3, level: QualityLevel::Fast, scale: 1, psnr: 7500, largest: 3 },
    FrontPoint { prepare: 13446, instructions: 1273, reflections: 3, level: QualityLevel::Exact, scale: 1, psnr: 7580, largest: 3 },
    FrontPoint { prepare: 13446, instructions: 1280, reflections: 4, level: QualityLevel::Exact, scale: 1, psnr: 9027, largest: 1 },
    FrontPoint { prepare: 13446, instructions: 1282, reflections: 5, level: QualityLevel::Exact, scale: 1, psnr: 65535, largest: 0 },
]);
/// mirror2
pub const MIRROR2: ParetoFront = ParetoFront::new(&[
    FrontPoint { prepare: 21150, instructions: 65, reflections: 0, level: QualityLevel::Exact, scale: 4, psnr: 1790, largest: 251 },
    FrontPoint { prepare: 21150, instructions: 125, reflections: 1, level: QualityLevel::Exact, scale: 4, psnr: 2046, largest: 224 },
    FrontPoint { prepare: 21150, instructions: 187, reflections: 2, level: QualityLevel::Exact, scale: 4, psnr: 2226, largest: 224 },
    FrontPoint { prepare: 21150, instructions: 228, reflections: 3, level: QualityLevel::Exact, scale: 4, psnr: 2334, largest: 224 },
    FrontPoint { prepare: 21150, instructions: 726, reflections: 2, level: QualityLevel::Exact, scale: 2, psnr: 2403, largest: 224 },
    FrontPoint { prepare: 21150, instructions: 901, reflections: 3, level: QualityLevel::Exact, scale: 2, psnr: 2601, largest: 224 },
    FrontPoint { prepare: 21144, instructions: 2230, reflections: 2, level: QualityLevel::Fast, scale: 1, psnr: 2770, largest: 164 },
    FrontPoint { prepare: 21144, instructions: 3023, reflections: 3, level: QualityLevel::Fast, scale: 1, psnr: 5384, largest: 26 },
    FrontPoint { prepare: 21144, instructions: 3206, reflections: 4, level: QualityLevel::Fast, scale: 1, psnr: 6379, largest: 12 },
    FrontPoint { prepare: 21144, instructions: 3231, reflections: 5, level: QualityLevel::Fast, scale: 1, psnr: 7062, largest: 6 },
    FrontPoint { prepare: 21144, instructions: 3240, reflections: 6, level: QualityLevel::Fast, scale: 1, psnr: 7404, largest: 2 },
    FrontPoint { prepare: 21144, instructions: 3244, reflections: 8, level: QualityLevel::Fast, scale: 1, psnr: 7436, largest: 1 },
    FrontPoint { prepare: 21144, instructions: 3740, reflections: 6, level: QualityLevel::Exact, scale: 1, psnr: 8504, largest: 2 },
    FrontPoint { prepare: 21144, instructions: 3744, reflections: 7, level: QualityLevel::Exact, scale: 1, psnr: 9027, largest: 1 },
    FrontPoint { prepare: 21144, instructions: 3746, reflections: 8, level: QualityLevel::Exact, scale: 1, psnr: 9504, largest: 1 },
]);
/// primitives
pub const PRIMITIVES: ParetoFront = ParetoFront::new(&[
    FrontPoint { prepare: 5754, instructions: 51, reflections: 0, level: QualityLevel::Exact, scale: 4, psnr: 1923, largest: 255 },
    FrontPoint { prepare: 5754, instructions: 71, reflections: 1, level: QualityLevel::Exact, scale: 4, psnr: 2343, largest: 196 },
    FrontPoint { prepare: 5754, instructions: 247, reflections: 1, level: QualityLevel::Fast, scale: 2, psnr: 2659, largest: 212 },
    FrontPoint { prepare: 5754, instructions: 787, reflections: 1, level: QualityLevel::Fast, scale: 1, psnr: 4326, largest: 20 },
    FrontPoint { prepare: 5754, instructions: 816, reflections: 2, level: QualityLevel::Fast, scale: 1, psnr: 5820, largest: 20 },
    FrontPoint { prepare: 5754, instructions: 825, reflections: 3, level: QualityLevel::Fast, scale: 1, psnr: 7550, largest: 3 },
    FrontPoint { prepare: 5754, instructions: 827, reflections: 4, level: QualityLevel::Fast, scale: 1, psnr: 7986, largest: 1 },
    FrontPoint { prepare: 5754, instructions: 1029, reflections: 4, level: QualityLevel::Exact, scale: 1, psnr: 65535, largest: 0 },
]);
/// empty
pub const EMPTY: ParetoFront = ParetoFront::new(&[
    FrontPoint { prepare: 181, instructions: 2, reflections: 0, level: QualityLevel::Fast, scale: 1, psnr: 65535, largest: 0 },
]);
/// floor
pub const FLOOR: ParetoFront = ParetoFront::new(&[
    FrontPoint { prepare: 436, instructions: 12, reflections: 0, level: QualityLevel::Fast, scale: 4, psnr: 2432, largest: 124 },
    FrontPoint { prepare: 436, instructions: 39, reflections: 0, level: QualityLevel::Fast, scale: 2, psnr: 65535, largest: 0 },
]);
/// corner1
pub const CORNER1: ParetoFront = ParetoFront::new(&[
    FrontPoint { prepare: 748, instructions: 31, reflections: 0, level: QualityLevel::Exact, scale: 4, psnr: 3026, largest: 101 },
    FrontPoint { prepare: 748, instructions: 85, reflections: 0, level: QualityLevel::Fast, scale: 2, psnr: 3777, largest: 66 },
    FrontPoint { prepare: 748, instructions: 200, reflections: 0, level: QualityLevel::Fast, scale: 1, psnr: 6003, largest: 43 },
]);
/// cylinders
pub const CYLINDERS: ParetoFront = ParetoFront::new(&[
    FrontPoint { prepare: 4462, instructions: 27, reflections: 0, level: QualityLevel::Fast, scale: 4, psnr: 2041, largest: 255 },
    FrontPoint { prepare: 4462, instructions: 80, reflections: 0, level: QualityLevel::Fast, scale: 2, psnr: 2410, largest: 255 },
    FrontPoint { prepare: 4462, instructions: 221, reflections: 0, level: QualityLevel::Fast, scale: 1, psnr: 3907, largest: 35 },
    FrontPoint { prepare: 4462, instructions: 290, reflections: 1, level: QualityLevel::Fast, scale: 1, psnr: 6310, largest: 3 },
    FrontPoint { prepare: 4462, instructions: 325, reflections: 2, level: QualityLevel::Fast, scale: 1, psnr: 7986, largest: 1 },
    FrontPoint { prepare: 4462, instructions: 422, reflections: 3, level: QualityLevel::Exact, scale: 1, psnr: 65535, largest: 0 },
]);
