// Written by `cargo run --release --package report -- --core m3 --size 128x128`:
// what is best for a frame of so many instructions. Include it where `ParetoFront`, `FrontPoint` and
// `QualityLevel` are in scope.
/// castle
pub const CASTLE: ParetoFront = ParetoFront::new(&[
    FrontPoint { prepare: 75670, instructions: 67, reflections: 0, level: QualityLevel::Fast, scale: 4, psnr: 1309, largest: 231 },
    FrontPoint { prepare: 75670, instructions: 104, reflections: 1, level: QualityLevel::Exact, scale: 4, psnr: 2177, largest: 231 },
    FrontPoint { prepare: 74790, instructions: 324, reflections: 1, level: QualityLevel::Fast, scale: 2, psnr: 2550, largest: 211 },
    FrontPoint { prepare: 74569, instructions: 981, reflections: 1, level: QualityLevel::Fast, scale: 1, psnr: 4252, largest: 76 },
    FrontPoint { prepare: 74569, instructions: 1008, reflections: 2, level: QualityLevel::Fast, scale: 1, psnr: 5901, largest: 16 },
    FrontPoint { prepare: 74569, instructions: 1012, reflections: 4, level: QualityLevel::Fast, scale: 1, psnr: 7455, largest: 1 },
    FrontPoint { prepare: 74569, instructions: 1324, reflections: 4, level: QualityLevel::Exact, scale: 1, psnr: 9504, largest: 1 },
]);
/// shading_lights
pub const SHADING_LIGHTS: ParetoFront = ParetoFront::new(&[
    FrontPoint { prepare: 1979, instructions: 48, reflections: 0, level: QualityLevel::Exact, scale: 4, psnr: 2214, largest: 184 },
    FrontPoint { prepare: 1979, instructions: 64, reflections: 1, level: QualityLevel::Exact, scale: 4, psnr: 2658, largest: 181 },
    FrontPoint { prepare: 1979, instructions: 179, reflections: 1, level: QualityLevel::Fast, scale: 2, psnr: 2889, largest: 180 },
    FrontPoint { prepare: 1979, instructions: 500, reflections: 1, level: QualityLevel::Fast, scale: 1, psnr: 6752, largest: 1 },
    FrontPoint { prepare: 1979, instructions: 937, reflections: 1, level: QualityLevel::Exact, scale: 1, psnr: 65535, largest: 0 },
]);
/// shading_speculars
pub const SHADING_SPECULARS: ParetoFront = ParetoFront::new(&[
    FrontPoint { prepare: 7998, instructions: 45, reflections: 0, level: QualityLevel::Exact, scale: 4, psnr: 1870, largest: 173 },
    FrontPoint { prepare: 7998, instructions: 65, reflections: 1, level: QualityLevel::Exact, scale: 4, psnr: 2228, largest: 147 },
    FrontPoint { prepare: 7994, instructions: 209, reflections: 1, level: QualityLevel::Fast, scale: 2, psnr: 2618, largest: 155 },
    FrontPoint { prepare: 7994, instructions: 595, reflections: 1, level: QualityLevel::Fast, scale: 1, psnr: 4771, largest: 10 },
    FrontPoint { prepare: 7994, instructions: 649, reflections: 2, level: QualityLevel::Fast, scale: 1, psnr: 6238, largest: 2 },
    FrontPoint { prepare: 7994, instructions: 661, reflections: 3, level: QualityLevel::Fast, scale: 1, psnr: 6407, largest: 1 },
    FrontPoint { prepare: 7994, instructions: 951, reflections: 2, level: QualityLevel::Exact, scale: 1, psnr: 6716, largest: 2 },
    FrontPoint { prepare: 7994, instructions: 963, reflections: 3, level: QualityLevel::Exact, scale: 1, psnr: 8203, largest: 1 },
    FrontPoint { prepare: 7994, instructions: 965, reflections: 4, level: QualityLevel::Exact, scale: 1, psnr: 65535, largest: 0 },
]);
/// columns
pub const COLUMNS: ParetoFront = ParetoFront::new(&[
    FrontPoint { prepare: 18372, instructions: 60, reflections: 0, level: QualityLevel::Exact, scale: 4, psnr: 2647, largest: 177 },
    FrontPoint { prepare: 18372, instructions: 78, reflections: 1, level: QualityLevel::Exact, scale: 4, psnr: 2677, largest: 178 },
    FrontPoint { prepare: 18388, instructions: 220, reflections: 0, level: QualityLevel::Exact, scale: 2, psnr: 2936, largest: 163 },
    FrontPoint { prepare: 18388, instructions: 276, reflections: 1, level: QualityLevel::Exact, scale: 2, psnr: 2980, largest: 173 },
    FrontPoint { prepare: 18388, instructions: 591, reflections: 0, level: QualityLevel::Fast, scale: 1, psnr: 3829, largest: 56 },
    FrontPoint { prepare: 18388, instructions: 784, reflections: 1, level: QualityLevel::Fast, scale: 1, psnr: 5786, largest: 16 },
    FrontPoint { prepare: 18388, instructions: 838, reflections: 2, level: QualityLevel::Fast, scale: 1, psnr: 7087, largest: 2 },
    FrontPoint { prepare: 18388, instructions: 1046, reflections: 2, level: QualityLevel::Exact, scale: 1, psnr: 8425, largest: 2 },
    FrontPoint { prepare: 18388, instructions: 1058, reflections: 3, level: QualityLevel::Exact, scale: 1, psnr: 65535, largest: 0 },
]);
/// mirror1
pub const MIRROR1: ParetoFront = ParetoFront::new(&[
    FrontPoint { prepare: 11451, instructions: 49, reflections: 0, level: QualityLevel::Exact, scale: 4, psnr: 1574, largest: 255 },
    FrontPoint { prepare: 11451, instructions: 73, reflections: 1, level: QualityLevel::Exact, scale: 4, psnr: 2297, largest: 255 },
    FrontPoint { prepare: 11451, instructions: 279, reflections: 1, level: QualityLevel::Exact, scale: 2, psnr: 2508, largest: 234 },
    FrontPoint { prepare: 11451, instructions: 904, reflections: 1, level: QualityLevel::Fast, scale: 1, psnr: 4363, largest: 47 },
    FrontPoint { prepare: 11451, instructions: 1062, reflections: 2, level: QualityLevel::Fast, scale: 1, psnr: 5690, largest: 17 },
    FrontPoint { prepare: 11451, instructions: 1087, reflections: 3, level: QualityLevel::Fast, scale: 1, psnr: 7432, largest: 3 },
    FrontPoint { prepare: 11451, instructions: 1091, reflections: 4, level: QualityLevel::Fast, scale: 1, psnr: 7832, largest: 1 },
    FrontPoint { prepare: 11451, instructions: 1172, reflections: 4, level: QualityLevel::Exact, scale: 1, psnr: 9027, largest: 1 },
    FrontPoint { prepare: 11451, instructions: 1174, reflections: 5, level: QualityLevel::Exact, scale: 1, psnr: 65535, largest: 0 },
]);
/// mirror2
pub const MIRROR2: ParetoFront = ParetoFront::new(&[
    FrontPoint { prepare: 18029, instructions: 57, reflections: 0, level: QualityLevel::Fast, scale: 4, psnr: 1790, largest: 251 },
    FrontPoint { prepare: 18029, instructions: 115, reflections: 1, level: QualityLevel::Exact, scale: 4, psnr: 2046, largest: 224 },
    FrontPoint { prepare: 18029, instructions: 176, reflections: 2, level: QualityLevel::Exact, scale: 4, psnr: 2226, largest: 224 },
    FrontPoint { prepare: 18029, instructions: 215, reflections: 3, level: QualityLevel::Exact, scale: 4, psnr: 2334, largest: 224 },
    FrontPoint { prepare: 18001, instructions: 638, reflections: 2, level: QualityLevel::Fast, scale: 2, psnr: 2403, largest: 224 },
    FrontPoint { prepare: 18001, instructions: 827, reflections: 3, level: QualityLevel::Fast, scale: 2, psnr: 2601, largest: 224 },
    FrontPoint { prepare: 18001, instructions: 1692, reflections: 2, level: QualityLevel::Fast, scale: 1, psnr: 2770, largest: 164 },
    FrontPoint { prepare: 18001, instructions: 2298, reflections: 3, level: QualityLevel::Fast, scale: 1, psnr: 5379, largest: 26 },
    FrontPoint { prepare: 18001, instructions: 2468, reflections: 4, level: QualityLevel::Fast, scale: 1, psnr: 6329, largest: 12 },
    FrontPoint { prepare: 18001, instructions: 2491, reflections: 5, level: QualityLevel::Fast, scale: 1, psnr: 6862, largest: 6 },
    FrontPoint { prepare: 18001, instructions: 2501, reflections: 6, level: QualityLevel::Fast, scale: 1, psnr: 7045, largest: 2 },
    FrontPoint { prepare: 18001, instructions: 3531, reflections: 5, level: QualityLevel::Exact, scale: 1, psnr: 7295, largest: 6 },
    FrontPoint { prepare: 18001, instructions: 3543, reflections: 6, level: QualityLevel::Exact, scale: 1, psnr: 8504, largest: 2 },
    FrontPoint { prepare: 18001, instructions: 3547, reflections: 7, level: QualityLevel::Exact, scale: 1, psnr: 9027, largest: 1 },
    FrontPoint { prepare: 18001, instructions: 3548, reflections: 8, level: QualityLevel::Exact, scale: 1, psnr: 9504, largest: 1 },
]);
/// primitives
pub const PRIMITIVES: ParetoFront = ParetoFront::new(&[
    FrontPoint { prepare: 4631, instructions: 45, reflections: 0, level: QualityLevel::Exact, scale: 4, psnr: 1923, largest: 255 },
    FrontPoint { prepare: 4631, instructions: 63, reflections: 1, level: QualityLevel::Exact, scale: 4, psnr: 2343, largest: 196 },
    FrontPoint { prepare: 4631, instructions: 182, reflections: 1, level: QualityLevel::Fast, scale: 2, psnr: 2659, largest: 212 },
    FrontPoint { prepare: 4631, instructions: 496, reflections: 1, level: QualityLevel::Fast, scale: 1, psnr: 4325, largest: 20 },
    FrontPoint { prepare: 4631, instructions: 530, reflections: 2, level: QualityLevel::Fast, scale: 1, psnr: 5799, largest: 20 },
    FrontPoint { prepare: 4631, instructions: 540, reflections: 3, level: QualityLevel::Fast, scale: 1, psnr: 6998, largest: 3 },
    FrontPoint { prepare: 4631, instructions: 541, reflections: 4, level: QualityLevel::Fast, scale: 1, psnr: 7083, largest: 1 },
    FrontPoint { prepare: 4631, instructions: 931, reflections: 3, level: QualityLevel::Exact, scale: 1, psnr: 7748, largest: 3 },
    FrontPoint { prepare: 4631, instructions: 932, reflections: 4, level: QualityLevel::Exact, scale: 1, psnr: 65535, largest: 0 },
]);
/// empty
pub const EMPTY: ParetoFront = ParetoFront::new(&[
    FrontPoint { prepare: 62, instructions: 2, reflections: 0, level: QualityLevel::Fast, scale: 1, psnr: 65535, largest: 0 },
]);
/// floor
pub const FLOOR: ParetoFront = ParetoFront::new(&[
    FrontPoint { prepare: 433, instructions: 8, reflections: 0, level: QualityLevel::Fast, scale: 4, psnr: 2432, largest: 124 },
    FrontPoint { prepare: 433, instructions: 25, reflections: 0, level: QualityLevel::Fast, scale: 2, psnr: 65535, largest: 0 },
]);
/// corner1
pub const CORNER1: ParetoFront = ParetoFront::new(&[
    FrontPoint { prepare: 523, instructions: 24, reflections: 0, level: QualityLevel::Fast, scale: 4, psnr: 3026, largest: 101 },
    FrontPoint { prepare: 523, instructions: 67, reflections: 0, level: QualityLevel::Fast, scale: 2, psnr: 3777, largest: 66 },
    FrontPoint { prepare: 523, instructions: 148, reflections: 0, level: QualityLevel::Fast, scale: 1, psnr: 5941, largest: 43 },
    FrontPoint { prepare: 523, instructions: 428, reflections: 0, level: QualityLevel::Exact, scale: 1, psnr: 6024, largest: 43 },
]);
/// cylinders
pub const CYLINDERS: ParetoFront = ParetoFront::new(&[
    FrontPoint { prepare: 3755, instructions: 22, reflections: 0, level: QualityLevel::Fast, scale: 4, psnr: 2041, largest: 255 },
    FrontPoint { prepare: 3755, instructions: 70, reflections: 0, level: QualityLevel::Fast, scale: 2, psnr: 2410, largest: 255 },
    FrontPoint { prepare: 3755, instructions: 199, reflections: 0, level: QualityLevel::Fast, scale: 1, psnr: 3907, largest: 35 },
    FrontPoint { prepare: 3755, instructions: 267, reflections: 1, level: QualityLevel::Fast, scale: 1, psnr: 6310, largest: 3 },
    FrontPoint { prepare: 3755, instructions: 302, reflections: 2, level: QualityLevel::Fast, scale: 1, psnr: 7986, largest: 1 },
    FrontPoint { prepare: 3755, instructions: 386, reflections: 3, level: QualityLevel::Exact, scale: 1, psnr: 65535, largest: 0 },
]);
