// Written by `cargo run --release --package report -- --core m3 --size 128x128`:
// what is best for a frame of so many instructions. Include it where `ParetoFront`, `FrontPoint` and
// `QualityLevel` are in scope.
/// castle
pub const CASTLE: ParetoFront = ParetoFront::new(&[
    FrontPoint { prepare: 88792, instructions: 74, reflections: 0, level: QualityLevel::Fast, scale: 4, psnr: 1309, largest: 231 },
    FrontPoint { prepare: 88792, instructions: 113, reflections: 1, level: QualityLevel::Exact, scale: 4, psnr: 2177, largest: 231 },
    FrontPoint { prepare: 87976, instructions: 355, reflections: 1, level: QualityLevel::Fast, scale: 2, psnr: 2550, largest: 211 },
    FrontPoint { prepare: 87809, instructions: 1089, reflections: 1, level: QualityLevel::Fast, scale: 1, psnr: 4252, largest: 76 },
    FrontPoint { prepare: 87809, instructions: 1115, reflections: 2, level: QualityLevel::Fast, scale: 1, psnr: 5906, largest: 16 },
    FrontPoint { prepare: 87809, instructions: 1119, reflections: 3, level: QualityLevel::Fast, scale: 1, psnr: 7629, largest: 3 },
    FrontPoint { prepare: 87809, instructions: 1418, reflections: 3, level: QualityLevel::Exact, scale: 1, psnr: 8425, largest: 3 },
]);
/// shading_lights
pub const SHADING_LIGHTS: ParetoFront = ParetoFront::new(&[
    FrontPoint { prepare: 2280, instructions: 49, reflections: 0, level: QualityLevel::Exact, scale: 4, psnr: 2214, largest: 184 },
    FrontPoint { prepare: 2280, instructions: 65, reflections: 1, level: QualityLevel::Exact, scale: 4, psnr: 2658, largest: 181 },
    FrontPoint { prepare: 2280, instructions: 227, reflections: 1, level: QualityLevel::Fast, scale: 2, psnr: 2889, largest: 180 },
    FrontPoint { prepare: 2280, instructions: 677, reflections: 1, level: QualityLevel::Fast, scale: 1, psnr: 6906, largest: 1 },
    FrontPoint { prepare: 2280, instructions: 962, reflections: 1, level: QualityLevel::Exact, scale: 1, psnr: 65535, largest: 0 },
]);
/// shading_speculars
pub const SHADING_SPECULARS: ParetoFront = ParetoFront::new(&[
    FrontPoint { prepare: 9577, instructions: 48, reflections: 0, level: QualityLevel::Exact, scale: 4, psnr: 1870, largest: 173 },
    FrontPoint { prepare: 9577, instructions: 69, reflections: 1, level: QualityLevel::Exact, scale: 4, psnr: 2228, largest: 147 },
    FrontPoint { prepare: 9577, instructions: 229, reflections: 1, level: QualityLevel::Fast, scale: 2, psnr: 2618, largest: 155 },
    FrontPoint { prepare: 9577, instructions: 713, reflections: 1, level: QualityLevel::Fast, scale: 1, psnr: 4775, largest: 10 },
    FrontPoint { prepare: 9577, instructions: 765, reflections: 2, level: QualityLevel::Fast, scale: 1, psnr: 6384, largest: 2 },
    FrontPoint { prepare: 9577, instructions: 777, reflections: 3, level: QualityLevel::Fast, scale: 1, psnr: 6643, largest: 2 },
    FrontPoint { prepare: 9577, instructions: 1019, reflections: 2, level: QualityLevel::Exact, scale: 1, psnr: 6716, largest: 2 },
    FrontPoint { prepare: 9577, instructions: 1032, reflections: 3, level: QualityLevel::Exact, scale: 1, psnr: 8203, largest: 1 },
    FrontPoint { prepare: 9577, instructions: 1034, reflections: 4, level: QualityLevel::Exact, scale: 1, psnr: 65535, largest: 0 },
]);
/// columns
pub const COLUMNS: ParetoFront = ParetoFront::new(&[
    FrontPoint { prepare: 22602, instructions: 68, reflections: 0, level: QualityLevel::Exact, scale: 4, psnr: 2647, largest: 177 },
    FrontPoint { prepare: 22602, instructions: 91, reflections: 1, level: QualityLevel::Exact, scale: 4, psnr: 2677, largest: 178 },
    FrontPoint { prepare: 22729, instructions: 245, reflections: 0, level: QualityLevel::Exact, scale: 2, psnr: 2936, largest: 163 },
    FrontPoint { prepare: 22729, instructions: 311, reflections: 1, level: QualityLevel::Exact, scale: 2, psnr: 2980, largest: 173 },
    FrontPoint { prepare: 22817, instructions: 750, reflections: 0, level: QualityLevel::Fast, scale: 1, psnr: 3829, largest: 56 },
    FrontPoint { prepare: 22817, instructions: 949, reflections: 1, level: QualityLevel::Fast, scale: 1, psnr: 5795, largest: 16 },
    FrontPoint { prepare: 22817, instructions: 1004, reflections: 2, level: QualityLevel::Fast, scale: 1, psnr: 7337, largest: 2 },
    FrontPoint { prepare: 22817, instructions: 1017, reflections: 3, level: QualityLevel::Fast, scale: 1, psnr: 7371, largest: 1 },
    FrontPoint { prepare: 22817, instructions: 1167, reflections: 2, level: QualityLevel::Exact, scale: 1, psnr: 8425, largest: 2 },
    FrontPoint { prepare: 22817, instructions: 1180, reflections: 3, level: QualityLevel::Exact, scale: 1, psnr: 65535, largest: 0 },
]);
/// mirror1
pub const MIRROR1: ParetoFront = ParetoFront::new(&[
    FrontPoint { prepare: 13831, instructions: 55, reflections: 0, level: QualityLevel::Exact, scale: 4, psnr: 1574, largest: 255 },
    FrontPoint { prepare: 13831, instructions: 81, reflections: 1, level: QualityLevel::Exact, scale: 4, psnr: 2297, largest: 255 },
    FrontPoint { prepare: 13831, instructions: 304, reflections: 1, level: QualityLevel::Exact, scale: 2, psnr: 2508, largest: 234 },
    FrontPoint { prepare: 13831, instructions: 991, reflections: 1, level: QualityLevel::Fast, scale: 1, psnr: 4363, largest: 47 },
    FrontPoint { prepare: 13831, instructions: 1165, reflections: 2, level: QualityLevel::Fast, scale: 1, psnr: 5691, largest: 17 },
    FrontPoint { prepare: 13831, instructions: 1190, reflections: 3, level: QualityLevel::Fast, scale: 1, psnr: 7475, largest: 3 },
    FrontPoint { prepare: 13831, instructions: 1194, reflections: 4, level: QualityLevel::Fast, scale: 1, psnr: 7948, largest: 1 },
    FrontPoint { prepare: 13831, instructions: 1271, reflections: 4, level: QualityLevel::Exact, scale: 1, psnr: 9027, largest: 1 },
    FrontPoint { prepare: 13831, instructions: 1273, reflections: 5, level: QualityLevel::Exact, scale: 1, psnr: 65535, largest: 0 },
]);
/// mirror2
pub const MIRROR2: ParetoFront = ParetoFront::new(&[
    FrontPoint { prepare: 21779, instructions: 65, reflections: 0, level: QualityLevel::Fast, scale: 4, psnr: 1790, largest: 251 },
    FrontPoint { prepare: 21779, instructions: 127, reflections: 1, level: QualityLevel::Exact, scale: 4, psnr: 2046, largest: 224 },
    FrontPoint { prepare: 21779, instructions: 190, reflections: 2, level: QualityLevel::Exact, scale: 4, psnr: 2226, largest: 224 },
    FrontPoint { prepare: 21779, instructions: 231, reflections: 3, level: QualityLevel::Exact, scale: 4, psnr: 2334, largest: 224 },
    FrontPoint { prepare: 21779, instructions: 690, reflections: 2, level: QualityLevel::Fast, scale: 2, psnr: 2403, largest: 224 },
    FrontPoint { prepare: 21779, instructions: 875, reflections: 3, level: QualityLevel::Fast, scale: 2, psnr: 2601, largest: 224 },
    FrontPoint { prepare: 21773, instructions: 2009, reflections: 2, level: QualityLevel::Fast, scale: 1, psnr: 2770, largest: 164 },
    FrontPoint { prepare: 21773, instructions: 2638, reflections: 3, level: QualityLevel::Fast, scale: 1, psnr: 5383, largest: 26 },
    FrontPoint { prepare: 21773, instructions: 2797, reflections: 4, level: QualityLevel::Fast, scale: 1, psnr: 6365, largest: 12 },
    FrontPoint { prepare: 21773, instructions: 2820, reflections: 5, level: QualityLevel::Fast, scale: 1, psnr: 6996, largest: 6 },
    FrontPoint { prepare: 21773, instructions: 2830, reflections: 6, level: QualityLevel::Fast, scale: 1, psnr: 7271, largest: 2 },
    FrontPoint { prepare: 21773, instructions: 3764, reflections: 6, level: QualityLevel::Exact, scale: 1, psnr: 8504, largest: 2 },
    FrontPoint { prepare: 21773, instructions: 3768, reflections: 7, level: QualityLevel::Exact, scale: 1, psnr: 9027, largest: 1 },
    FrontPoint { prepare: 21773, instructions: 3769, reflections: 8, level: QualityLevel::Exact, scale: 1, psnr: 9504, largest: 1 },
]);
/// primitives
pub const PRIMITIVES: ParetoFront = ParetoFront::new(&[
    FrontPoint { prepare: 5312, instructions: 51, reflections: 0, level: QualityLevel::Fast, scale: 4, psnr: 1923, largest: 255 },
    FrontPoint { prepare: 5312, instructions: 72, reflections: 1, level: QualityLevel::Exact, scale: 4, psnr: 2343, largest: 196 },
    FrontPoint { prepare: 5312, instructions: 230, reflections: 1, level: QualityLevel::Fast, scale: 2, psnr: 2659, largest: 212 },
    FrontPoint { prepare: 5312, instructions: 680, reflections: 1, level: QualityLevel::Fast, scale: 1, psnr: 4326, largest: 20 },
    FrontPoint { prepare: 5312, instructions: 717, reflections: 2, level: QualityLevel::Fast, scale: 1, psnr: 5817, largest: 20 },
    FrontPoint { prepare: 5312, instructions: 726, reflections: 3, level: QualityLevel::Fast, scale: 1, psnr: 7440, largest: 3 },
    FrontPoint { prepare: 5312, instructions: 727, reflections: 4, level: QualityLevel::Fast, scale: 1, psnr: 7733, largest: 1 },
    FrontPoint { prepare: 5312, instructions: 1049, reflections: 4, level: QualityLevel::Exact, scale: 1, psnr: 65535, largest: 0 },
]);
/// empty
pub const EMPTY: ParetoFront = ParetoFront::new(&[
    FrontPoint { prepare: 62, instructions: 2, reflections: 0, level: QualityLevel::Fast, scale: 1, psnr: 65535, largest: 0 },
]);
/// floor
pub const FLOOR: ParetoFront = ParetoFront::new(&[
    FrontPoint { prepare: 433, instructions: 10, reflections: 0, level: QualityLevel::Fast, scale: 4, psnr: 2432, largest: 124 },
    FrontPoint { prepare: 433, instructions: 32, reflections: 0, level: QualityLevel::Fast, scale: 2, psnr: 65535, largest: 0 },
]);
/// corner1
pub const CORNER1: ParetoFront = ParetoFront::new(&[
    FrontPoint { prepare: 523, instructions: 29, reflections: 0, level: QualityLevel::Fast, scale: 4, psnr: 3026, largest: 101 },
    FrontPoint { prepare: 523, instructions: 74, reflections: 0, level: QualityLevel::Fast, scale: 2, psnr: 3777, largest: 66 },
    FrontPoint { prepare: 523, instructions: 190, reflections: 0, level: QualityLevel::Fast, scale: 1, psnr: 6003, largest: 43 },
]);
/// cylinders
pub const CYLINDERS: ParetoFront = ParetoFront::new(&[
    FrontPoint { prepare: 4545, instructions: 26, reflections: 0, level: QualityLevel::Fast, scale: 4, psnr: 2041, largest: 255 },
    FrontPoint { prepare: 4545, instructions: 77, reflections: 0, level: QualityLevel::Fast, scale: 2, psnr: 2410, largest: 255 },
    FrontPoint { prepare: 4545, instructions: 212, reflections: 0, level: QualityLevel::Fast, scale: 1, psnr: 3907, largest: 35 },
    FrontPoint { prepare: 4545, instructions: 281, reflections: 1, level: QualityLevel::Fast, scale: 1, psnr: 6310, largest: 3 },
    FrontPoint { prepare: 4545, instructions: 316, reflections: 2, level: QualityLevel::Fast, scale: 1, psnr: 7986, largest: 1 },
    FrontPoint { prepare: 4545, instructions: 427, reflections: 3, level: QualityLevel::Exact, scale: 1, psnr: 65535, largest: 0 },
]);
