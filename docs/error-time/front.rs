// Written by `cargo run --release --package report -- --core m3 --size 128x128`:
// what is best for a frame of so many instructions. Include it where `ParetoFront`, `FrontPoint` and
// `QualityLevel` are in scope.
/// castle
pub const CASTLE: ParetoFront = ParetoFront::new(&[
    FrontPoint { prepare: 86386, instructions: 75, reflections: 0, level: QualityLevel::Exact, scale: 4, psnr: 1309, largest: 231 },
    FrontPoint { prepare: 86386, instructions: 113, reflections: 1, level: QualityLevel::Exact, scale: 4, psnr: 2177, largest: 231 },
    FrontPoint { prepare: 85568, instructions: 383, reflections: 1, level: QualityLevel::Fast, scale: 2, psnr: 2550, largest: 211 },
    FrontPoint { prepare: 85404, instructions: 1201, reflections: 1, level: QualityLevel::Fast, scale: 1, psnr: 4252, largest: 76 },
    FrontPoint { prepare: 85404, instructions: 1227, reflections: 2, level: QualityLevel::Fast, scale: 1, psnr: 5908, largest: 16 },
    FrontPoint { prepare: 85404, instructions: 1231, reflections: 3, level: QualityLevel::Fast, scale: 1, psnr: 7726, largest: 3 },
    FrontPoint { prepare: 85404, instructions: 1444, reflections: 3, level: QualityLevel::Exact, scale: 1, psnr: 8425, largest: 3 },
]);
/// shading_lights
pub const SHADING_LIGHTS: ParetoFront = ParetoFront::new(&[
    FrontPoint { prepare: 2233, instructions: 49, reflections: 0, level: QualityLevel::Exact, scale: 4, psnr: 2214, largest: 184 },
    FrontPoint { prepare: 2233, instructions: 65, reflections: 1, level: QualityLevel::Exact, scale: 4, psnr: 2658, largest: 181 },
    FrontPoint { prepare: 2233, instructions: 252, reflections: 1, level: QualityLevel::Exact, scale: 2, psnr: 2889, largest: 180 },
    FrontPoint { prepare: 2233, instructions: 731, reflections: 1, level: QualityLevel::Fast, scale: 1, psnr: 6909, largest: 1 },
    FrontPoint { prepare: 2233, instructions: 954, reflections: 1, level: QualityLevel::Exact, scale: 1, psnr: 65535, largest: 0 },
]);
/// shading_speculars
pub const SHADING_SPECULARS: ParetoFront = ParetoFront::new(&[
    FrontPoint { prepare: 9369, instructions: 49, reflections: 0, level: QualityLevel::Exact, scale: 4, psnr: 1870, largest: 173 },
    FrontPoint { prepare: 9369, instructions: 70, reflections: 1, level: QualityLevel::Exact, scale: 4, psnr: 2228, largest: 147 },
    FrontPoint { prepare: 9369, instructions: 249, reflections: 1, level: QualityLevel::Fast, scale: 2, psnr: 2618, largest: 155 },
    FrontPoint { prepare: 9369, instructions: 719, reflections: 1, level: QualityLevel::Fast, scale: 1, psnr: 4776, largest: 10 },
    FrontPoint { prepare: 9369, instructions: 771, reflections: 2, level: QualityLevel::Fast, scale: 1, psnr: 6407, largest: 2 },
    FrontPoint { prepare: 9369, instructions: 784, reflections: 3, level: QualityLevel::Fast, scale: 1, psnr: 6687, largest: 1 },
    FrontPoint { prepare: 9369, instructions: 1035, reflections: 2, level: QualityLevel::Exact, scale: 1, psnr: 6716, largest: 2 },
    FrontPoint { prepare: 9369, instructions: 1047, reflections: 3, level: QualityLevel::Exact, scale: 1, psnr: 8203, largest: 1 },
    FrontPoint { prepare: 9369, instructions: 1049, reflections: 4, level: QualityLevel::Exact, scale: 1, psnr: 65535, largest: 0 },
]);
/// columns
pub const COLUMNS: ParetoFront = ParetoFront::new(&[
    FrontPoint { prepare: 22597, instructions: 68, reflections: 0, level: QualityLevel::Exact, scale: 4, psnr: 2647, largest: 177 },
    FrontPoint { prepare: 22597, instructions: 90, reflections: 1, level: QualityLevel::Exact, scale: 4, psnr: 2677, largest: 178 },
    FrontPoint { prepare: 22724, instructions: 244, reflections: 0, level: QualityLevel::Exact, scale: 2, psnr: 2936, largest: 163 },
    FrontPoint { prepare: 22724, instructions: 309, reflections: 1, level: QualityLevel::Exact, scale: 2, psnr: 2980, largest: 173 },
    FrontPoint { prepare: 22812, instructions: 760, reflections: 0, level: QualityLevel::Fast, scale: 1, psnr: 3829, largest: 56 },
    FrontPoint { prepare: 22812, instructions: 967, reflections: 1, level: QualityLevel::Fast, scale: 1, psnr: 5796, largest: 16 },
    FrontPoint { prepare: 22812, instructions: 1023, reflections: 2, level: QualityLevel::Fast, scale: 1, psnr: 7361, largest: 2 },
    FrontPoint { prepare: 22812, instructions: 1035, reflections: 3, level: QualityLevel::Fast, scale: 1, psnr: 7397, largest: 1 },
    FrontPoint { prepare: 22812, instructions: 1161, reflections: 2, level: QualityLevel::Exact, scale: 1, psnr: 8425, largest: 2 },
    FrontPoint { prepare: 22812, instructions: 1173, reflections: 3, level: QualityLevel::Exact, scale: 1, psnr: 65535, largest: 0 },
]);
/// mirror1
pub const MIRROR1: ParetoFront = ParetoFront::new(&[
    FrontPoint { prepare: 13510, instructions: 55, reflections: 0, level: QualityLevel::Exact, scale: 4, psnr: 1574, largest: 255 },
    FrontPoint { prepare: 13510, instructions: 81, reflections: 1, level: QualityLevel::Exact, scale: 4, psnr: 2297, largest: 255 },
    FrontPoint { prepare: 13510, instructions: 304, reflections: 1, level: QualityLevel::Exact, scale: 2, psnr: 2508, largest: 234 },
    FrontPoint { prepare: 13510, instructions: 1075, reflections: 1, level: QualityLevel::Fast, scale: 1, psnr: 4363, largest: 47 },
    FrontPoint { prepare: 13510, instructions: 1184, reflections: 2, level: QualityLevel::Fast, scale: 1, psnr: 5691, largest: 17 },
    FrontPoint { prepare: 13510, instructions: 1209, reflections: 3, level: QualityLevel::Fast, scale: 1, psnr: 7491, largest: 3 },
    FrontPoint { prepare: 13510, instructions: 1213, reflections: 4, level: QualityLevel::Fast, scale: 1, psnr: 7999, largest: 1 },
    FrontPoint { prepare: 13510, instructions: 1271, reflections: 4, level: QualityLevel::Exact, scale: 1, psnr: 9027, largest: 1 },
    FrontPoint { prepare: 13510, instructions: 1273, reflections: 5, level: QualityLevel::Exact, scale: 1, psnr: 65535, largest: 0 },
]);
/// mirror2
pub const MIRROR2: ParetoFront = ParetoFront::new(&[
    FrontPoint { prepare: 21071, instructions: 66, reflections: 0, level: QualityLevel::Exact, scale: 4, psnr: 1790, largest: 251 },
    FrontPoint { prepare: 21071, instructions: 126, reflections: 1, level: QualityLevel::Exact, scale: 4, psnr: 2046, largest: 224 },
    FrontPoint { prepare: 21071, instructions: 189, reflections: 2, level: QualityLevel::Exact, scale: 4, psnr: 2226, largest: 224 },
    FrontPoint { prepare: 21071, instructions: 230, reflections: 3, level: QualityLevel::Exact, scale: 4, psnr: 2334, largest: 224 },
    FrontPoint { prepare: 21071, instructions: 732, reflections: 2, level: QualityLevel::Exact, scale: 2, psnr: 2403, largest: 224 },
    FrontPoint { prepare: 21071, instructions: 903, reflections: 3, level: QualityLevel::Exact, scale: 2, psnr: 2601, largest: 224 },
    FrontPoint { prepare: 21065, instructions: 2204, reflections: 2, level: QualityLevel::Fast, scale: 1, psnr: 2770, largest: 164 },
    FrontPoint { prepare: 21065, instructions: 3002, reflections: 3, level: QualityLevel::Fast, scale: 1, psnr: 5385, largest: 26 },
    FrontPoint { prepare: 21065, instructions: 3176, reflections: 4, level: QualityLevel::Fast, scale: 1, psnr: 6383, largest: 12 },
    FrontPoint { prepare: 21065, instructions: 3200, reflections: 5, level: QualityLevel::Fast, scale: 1, psnr: 7078, largest: 6 },
    FrontPoint { prepare: 21065, instructions: 3209, reflections: 6, level: QualityLevel::Fast, scale: 1, psnr: 7440, largest: 2 },
    FrontPoint { prepare: 21065, instructions: 3212, reflections: 7, level: QualityLevel::Fast, scale: 1, psnr: 7467, largest: 1 },
    FrontPoint { prepare: 21065, instructions: 3748, reflections: 6, level: QualityLevel::Exact, scale: 1, psnr: 8504, largest: 2 },
    FrontPoint { prepare: 21065, instructions: 3752, reflections: 7, level: QualityLevel::Exact, scale: 1, psnr: 9027, largest: 1 },
    FrontPoint { prepare: 21065, instructions: 3753, reflections: 8, level: QualityLevel::Exact, scale: 1, psnr: 9504, largest: 1 },
]);
/// primitives
pub const PRIMITIVES: ParetoFront = ParetoFront::new(&[
    FrontPoint { prepare: 5231, instructions: 51, reflections: 0, level: QualityLevel::Exact, scale: 4, psnr: 1923, largest: 255 },
    FrontPoint { prepare: 5231, instructions: 71, reflections: 1, level: QualityLevel::Exact, scale: 4, psnr: 2343, largest: 196 },
    FrontPoint { prepare: 5231, instructions: 239, reflections: 1, level: QualityLevel::Fast, scale: 2, psnr: 2659, largest: 212 },
    FrontPoint { prepare: 5231, instructions: 749, reflections: 1, level: QualityLevel::Fast, scale: 1, psnr: 4326, largest: 20 },
    FrontPoint { prepare: 5231, instructions: 786, reflections: 2, level: QualityLevel::Fast, scale: 1, psnr: 5819, largest: 20 },
    FrontPoint { prepare: 5231, instructions: 795, reflections: 3, level: QualityLevel::Fast, scale: 1, psnr: 7536, largest: 3 },
    FrontPoint { prepare: 5231, instructions: 796, reflections: 4, level: QualityLevel::Fast, scale: 1, psnr: 7948, largest: 1 },
    FrontPoint { prepare: 5231, instructions: 1027, reflections: 4, level: QualityLevel::Exact, scale: 1, psnr: 65535, largest: 0 },
]);
/// empty
pub const EMPTY: ParetoFront = ParetoFront::new(&[
    FrontPoint { prepare: 181, instructions: 2, reflections: 0, level: QualityLevel::Fast, scale: 1, psnr: 65535, largest: 0 },
]);
/// floor
pub const FLOOR: ParetoFront = ParetoFront::new(&[
    FrontPoint { prepare: 434, instructions: 11, reflections: 0, level: QualityLevel::Fast, scale: 4, psnr: 2432, largest: 124 },
    FrontPoint { prepare: 434, instructions: 38, reflections: 0, level: QualityLevel::Fast, scale: 2, psnr: 65535, largest: 0 },
]);
/// corner1
pub const CORNER1: ParetoFront = ParetoFront::new(&[
    FrontPoint { prepare: 522, instructions: 31, reflections: 0, level: QualityLevel::Exact, scale: 4, psnr: 3026, largest: 101 },
    FrontPoint { prepare: 522, instructions: 86, reflections: 0, level: QualityLevel::Fast, scale: 2, psnr: 3777, largest: 66 },
    FrontPoint { prepare: 522, instructions: 200, reflections: 0, level: QualityLevel::Fast, scale: 1, psnr: 6003, largest: 43 },
]);
/// cylinders
pub const CYLINDERS: ParetoFront = ParetoFront::new(&[
    FrontPoint { prepare: 4546, instructions: 26, reflections: 0, level: QualityLevel::Fast, scale: 4, psnr: 2041, largest: 255 },
    FrontPoint { prepare: 4546, instructions: 77, reflections: 0, level: QualityLevel::Fast, scale: 2, psnr: 2410, largest: 255 },
    FrontPoint { prepare: 4546, instructions: 215, reflections: 0, level: QualityLevel::Fast, scale: 1, psnr: 3907, largest: 35 },
    FrontPoint { prepare: 4546, instructions: 285, reflections: 1, level: QualityLevel::Fast, scale: 1, psnr: 6310, largest: 3 },
    FrontPoint { prepare: 4546, instructions: 320, reflections: 2, level: QualityLevel::Fast, scale: 1, psnr: 7986, largest: 1 },
    FrontPoint { prepare: 4546, instructions: 429, reflections: 3, level: QualityLevel::Exact, scale: 1, psnr: 65535, largest: 0 },
]);
