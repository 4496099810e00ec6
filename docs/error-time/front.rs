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
    FrontPoint { prepare: 1979, instructions: 177, reflections: 1, level: QualityLevel::Fast, scale: 2, psnr: 2889, largest: 180 },
    FrontPoint { prepare: 1979, instructions: 494, reflections: 1, level: QualityLevel::Fast, scale: 1, psnr: 6752, largest: 1 },
    FrontPoint { prepare: 1979, instructions: 935, reflections: 1, level: QualityLevel::Exact, scale: 1, psnr: 65535, largest: 0 },
]);
/// shading_speculars
pub const SHADING_SPECULARS: ParetoFront = ParetoFront::new(&[
    FrontPoint { prepare: 7998, instructions: 45, reflections: 0, level: QualityLevel::Exact, scale: 4, psnr: 1870, largest: 173 },
    FrontPoint { prepare: 7998, instructions: 65, reflections: 1, level: QualityLevel::Exact, scale: 4, psnr: 2228, largest: 147 },
    FrontPoint { prepare: 7994, instructions: 207, reflections: 1, level: QualityLevel::Fast, scale: 2, psnr: 2618, largest: 155 },
    FrontPoint { prepare: 7994, instructions: 590, reflections: 1, level: QualityLevel::Fast, scale: 1, psnr: 4771, largest: 10 },
    FrontPoint { prepare: 7994, instructions: 642, reflections: 2, level: QualityLevel::Fast, scale: 1, psnr: 6238, largest: 2 },
    FrontPoint { prepare: 7994, instructions: 655, reflections: 3, level: QualityLevel::Fast, scale: 1, psnr: 6407, largest: 1 },
    FrontPoint { prepare: 7994, instructions: 950, reflections: 2, level: QualityLevel::Exact, scale: 1, psnr: 6716, largest: 2 },
    FrontPoint { prepare: 7994, instructions: 962, reflections: 3, level: QualityLevel::Exact, scale: 1, psnr: 8203, largest: 1 },
    FrontPoint { prepare: 7994, instructions: 964, reflections: 4, level: QualityLevel::Exact, scale: 1, psnr: 65535, largest: 0 },
]);
/// columns
pub const COLUMNS: ParetoFront = ParetoFront::new(&[
    FrontPoint { prepare: 18372, instructions: 60, reflections: 0, level: QualityLevel::Exact, scale: 4, psnr: 2647, largest: 177 },
    FrontPoint { prepare: 18372, instructions: 77, reflections: 1, level: QualityLevel::Exact, scale: 4, psnr: 2677, largest: 178 },
    FrontPoint { prepare: 18388, instructions: 220, reflections: 0, level: QualityLevel::Exact, scale: 2, psnr: 2936, largest: 163 },
    FrontPoint { prepare: 18388, instructions: 272, reflections: 1, level: QualityLevel::Exact, scale: 2, psnr: 2980, largest: 173 },
    FrontPoint { prepare: 18388, instructions: 591, reflections: 0, level: QualityLevel::Fast, scale: 1, psnr: 3829, largest: 56 },
    FrontPoint { prepare: 18388, instructions: 779, reflections: 1, level: QualityLevel::Fast, scale: 1, psnr: 5786, largest: 16 },
    FrontPoint { prepare: 18388, instructions: 831, reflections: 2, level: QualityLevel::Fast, scale: 1, psnr: 7087, largest: 2 },
    FrontPoint { prepare: 18388, instructions: 1031, reflections: 2, level: QualityLevel::Exact, scale: 1, psnr: 8425, largest: 2 },
    FrontPoint { prepare: 18388, instructions: 1042, reflections: 3, level: QualityLevel::Exact, scale: 1, psnr: 65535, largest: 0 },
]);
/// mirror1
pub const MIRROR1: ParetoFront = ParetoFront::new(&[
    FrontPoint { prepare: 11451, instructions: 49, reflections: 0, level: QualityLevel::Exact, scale: 4, psnr: 1574, largest: 255 },
    FrontPoint { prepare: 11451, instructions: 73, reflections: 1, level: QualityLevel::Exact, scale: 4, psnr: 2297, largest: 255 },
    FrontPoint { prepare: 11451, instructions: 277, reflections: 1, level: QualityLevel::Exact, scale: 2, psnr: 2508, largest: 234 },
    FrontPoint { prepare: 11451, instructions: 898, reflections: 1, level: QualityLevel::Fast, scale: 1, psnr: 4363, largest: 47 },
    FrontPoint { prepare: 11451, instructions: 1053, reflections: 2, level: QualityLevel::Fast, scale: 1, psnr: 5690, largest: 17 },
    FrontPoint { prepare: 11451, instructions: 1077, reflections: 3, level: QualityLevel::Fast, scale: 1, psnr: 7432, largest: 3 },
    FrontPoint { prepare: 11451, instructions: 1081, reflections: 4, level: QualityLevel::Fast, scale: 1, psnr: 7832, largest: 1 },
    FrontPoint { prepare: 11451, instructions: 1164, reflections: 4, level: QualityLevel::Exact, scale: 1, psnr: 9027, largest: 1 },
    FrontPoint { prepare: 11451, instructions: 1165, reflections: 5, level: QualityLevel::Exact, scale: 1, psnr: 65535, largest: 0 },
]);
/// mirror2
pub const MIRROR2: ParetoFront = ParetoFront::new(&[
    FrontPoint { prepare: 18029, instructions: 57, reflections: 0, level: QualityLevel::Fast, scale: 4, psnr: 1790, largest: 251 },
    FrontPoint { prepare: 18029, instructions: 115, reflections: 1, level: QualityLevel::Exact, scale: 4, psnr: 2046, largest: 224 },
    FrontPoint { prepare: 18029, instructions: 175, reflections: 2, level: QualityLevel::Exact, scale: 4, psnr: 2226, largest: 224 },
    FrontPoint { prepare: 18029, instructions: 214, reflections: 3, level: QualityLevel::Exact, scale: 4, psnr: 2334, largest: 224 },
    FrontPoint { prepare: 18001, instructions: 630, reflections: 2, level: QualityLevel::Fast, scale: 2, psnr: 2403, largest: 224 },
    FrontPoint { prepare: 18001, instructions: 815, reflections: 3, level: QualityLevel::Fast, scale: 2, psnr: 2601, largest: 224 },
    FrontPoint { prepare: 18001, instructions: 1672, reflections: 2, level: QualityLevel::Fast, scale: 1, psnr: 2770, largest: 164 },
    FrontPoint { prepare: 18001, instructions: 2265, reflections: 3, level: QualityLevel::Fast, scale: 1, psnr: 5379, largest: 26 },
    FrontPoint { prepare: 18001, instructions: 2430, reflections: 4, level: QualityLevel::Fast, scale: 1, psnr: 6329, largest: 12 },
    FrontPoint { prepare: 18001, instructions: 2452, reflections: 5, level: QualityLevel::Fast, scale: 1, psnr: 6862, largest: 6 },
    FrontPoint { prepare: 18001, instructions: 2461, reflections: 6, level: QualityLevel::Fast, scale: 1, psnr: 7045, largest: 2 },
    FrontPoint { prepare: 18001, instructions: 3498, reflections: 5, level: QualityLevel::Exact, scale: 1, psnr: 7295, largest: 6 },
    FrontPoint { prepare: 18001, instructions: 3510, reflections: 6, level: QualityLevel::Exact, scale: 1, psnr: 8504, largest: 2 },
    FrontPoint { prepare: 18001, instructions: 3513, reflections: 7, level: QualityLevel::Exact, scale: 1, psnr: 9027, largest: 1 },
    FrontPoint { prepare: 18001, instructions: 3515, reflections: 8, level: QualityLevel::Exact, scale: 1, psnr: 9504, largest: 1 },
]);
/// primitives
pub const PRIMITIVES: ParetoFront = ParetoFront::new(&[
    FrontPoint { prepare: 4631, instructions: 45, reflections: 0, level: QualityLevel::Exact, scale: 4, psnr: 1923, largest: 255 },
    FrontPoint { prepare: 4631, instructions: 63, reflections: 1, level: QualityLevel::Exact, scale: 4, psnr: 2343, largest: 196 },
    FrontPoint { prepare: 4631, instructions: 181, reflections: 1, level: QualityLevel::Fast, scale: 2, psnr: 2659, largest: 212 },
    FrontPoint { prepare: 4631, instructions: 492, reflections: 1, level: QualityLevel::Fast, scale: 1, psnr: 4325, largest: 20 },
    FrontPoint { prepare: 4631, instructions: 526, reflections: 2, level: QualityLevel::Fast, scale: 1, psnr: 5799, largest: 20 },
    FrontPoint { prepare: 4631, instructions: 536, reflections: 3, level: QualityLevel::Fast, scale: 1, psnr: 6998, largest: 3 },
    FrontPoint { prepare: 4631, instructions: 537, reflections: 4, level: QualityLevel::Fast, scale: 1, psnr: 7083, largest: 1 },
    FrontPoint { prepare: 4631, instructions: 930, reflections: 3, level: QualityLevel::Exact, scale: 1, psnr: 7748, largest: 3 },
    FrontPoint { prepare: 4631, instructions: 931, reflections: 4, level: QualityLevel::Exact, scale: 1, psnr: 65535, largest: 0 },
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
    FrontPoint { prepare: 3755, instructions: 265, reflections: 1, level: QualityLevel::Fast, scale: 1, psnr: 6310, largest: 3 },
    FrontPoint { prepare: 3755, instructions: 299, reflections: 2, level: QualityLevel::Fast, scale: 1, psnr: 7986, largest: 1 },
    FrontPoint { prepare: 3755, instructions: 383, reflections: 3, level: QualityLevel::Exact, scale: 1, psnr: 65535, largest: 0 },
]);
