// Written by `cargo run --release --package report -- --core m3 --size 128x128`:
// what is best for a frame of so many instructions. Include it where `ParetoFront`, `FrontPoint` and
// `QualityLevel` are in scope.
/// castle
pub const CASTLE: ParetoFront = ParetoFront::new(&[
    FrontPoint { prepare: 75908, instructions: 70, reflections: 0, level: QualityLevel::Fast, scale: 4, psnr: 1309, largest: 231 },
    FrontPoint { prepare: 75908, instructions: 109, reflections: 1, level: QualityLevel::Exact, scale: 4, psnr: 2177, largest: 231 },
    FrontPoint { prepare: 75028, instructions: 337, reflections: 1, level: QualityLevel::Fast, scale: 2, psnr: 2550, largest: 211 },
    FrontPoint { prepare: 74807, instructions: 1025, reflections: 1, level: QualityLevel::Fast, scale: 1, psnr: 4252, largest: 76 },
    FrontPoint { prepare: 74807, instructions: 1051, reflections: 2, level: QualityLevel::Fast, scale: 1, psnr: 5901, largest: 16 },
    FrontPoint { prepare: 74807, instructions: 1055, reflections: 4, level: QualityLevel::Fast, scale: 1, psnr: 7455, largest: 1 },
    FrontPoint { prepare: 74807, instructions: 1407, reflections: 4, level: QualityLevel::Exact, scale: 1, psnr: 9504, largest: 1 },
]);
/// shading_lights
pub const SHADING_LIGHTS: ParetoFront = ParetoFront::new(&[
    FrontPoint { prepare: 1985, instructions: 51, reflections: 0, level: QualityLevel::Exact, scale: 4, psnr: 2214, largest: 184 },
    FrontPoint { prepare: 1985, instructions: 68, reflections: 1, level: QualityLevel::Exact, scale: 4, psnr: 2658, largest: 181 },
    FrontPoint { prepare: 1985, instructions: 182, reflections: 1, level: QualityLevel::Fast, scale: 2, psnr: 2889, largest: 180 },
    FrontPoint { prepare: 1985, instructions: 511, reflections: 1, level: QualityLevel::Fast, scale: 1, psnr: 6752, largest: 1 },
    FrontPoint { prepare: 1985, instructions: 995, reflections: 1, level: QualityLevel::Exact, scale: 1, psnr: 65535, largest: 0 },
]);
/// shading_speculars
pub const SHADING_SPECULARS: ParetoFront = ParetoFront::new(&[
    FrontPoint { prepare: 8025, instructions: 48, reflections: 0, level: QualityLevel::Exact, scale: 4, psnr: 1870, largest: 173 },
    FrontPoint { prepare: 8025, instructions: 69, reflections: 1, level: QualityLevel::Exact, scale: 4, psnr: 2228, largest: 147 },
    FrontPoint { prepare: 8021, instructions: 215, reflections: 1, level: QualityLevel::Fast, scale: 2, psnr: 2618, largest: 155 },
    FrontPoint { prepare: 8021, instructions: 619, reflections: 1, level: QualityLevel::Fast, scale: 1, psnr: 4771, largest: 10 },
    FrontPoint { prepare: 8021, instructions: 673, reflections: 2, level: QualityLevel::Fast, scale: 1, psnr: 6235, largest: 2 },
    FrontPoint { prepare: 8021, instructions: 686, reflections: 3, level: QualityLevel::Fast, scale: 1, psnr: 6403, largest: 1 },
    FrontPoint { prepare: 8021, instructions: 1019, reflections: 2, level: QualityLevel::Exact, scale: 1, psnr: 6716, largest: 2 },
    FrontPoint { prepare: 8021, instructions: 1031, reflections: 3, level: QualityLevel::Exact, scale: 1, psnr: 8203, largest: 1 },
    FrontPoint { prepare: 8021, instructions: 1033, reflections: 4, level: QualityLevel::Exact, scale: 1, psnr: 65535, largest: 0 },
]);
/// columns
pub const COLUMNS: ParetoFront = ParetoFront::new(&[
    FrontPoint { prepare: 18437, instructions: 66, reflections: 0, level: QualityLevel::Exact, scale: 4, psnr: 2647, largest: 177 },
    FrontPoint { prepare: 18437, instructions: 85, reflections: 1, level: QualityLevel::Exact, scale: 4, psnr: 2677, largest: 178 },
    FrontPoint { prepare: 18453, instructions: 238, reflections: 0, level: QualityLevel::Fast, scale: 2, psnr: 2935, largest: 163 },
    FrontPoint { prepare: 18453, instructions: 299, reflections: 1, level: QualityLevel::Fast, scale: 2, psnr: 2980, largest: 173 },
    FrontPoint { prepare: 18453, instructions: 621, reflections: 0, level: QualityLevel::Fast, scale: 1, psnr: 3829, largest: 56 },
    FrontPoint { prepare: 18453, instructions: 818, reflections: 1, level: QualityLevel::Fast, scale: 1, psnr: 5786, largest: 16 },
    FrontPoint { prepare: 18453, instructions: 874, reflections: 2, level: QualityLevel::Fast, scale: 1, psnr: 7087, largest: 2 },
    FrontPoint { prepare: 18453, instructions: 1158, reflections: 2, level: QualityLevel::Exact, scale: 1, psnr: 8425, largest: 2 },
    FrontPoint { prepare: 18453, instructions: 1170, reflections: 3, level: QualityLevel::Exact, scale: 1, psnr: 65535, largest: 0 },
]);
/// mirror1
pub const MIRROR1: ParetoFront = ParetoFront::new(&[
    FrontPoint { prepare: 11491, instructions: 53, reflections: 0, level: QualityLevel::Exact, scale: 4, psnr: 1574, largest: 255 },
    FrontPoint { prepare: 11491, instructions: 78, reflections: 1, level: QualityLevel::Exact, scale: 4, psnr: 2297, largest: 255 },
    FrontPoint { prepare: 11491, instructions: 296, reflections: 1, level: QualityLevel::Exact, scale: 2, psnr: 2508, largest: 234 },
    FrontPoint { prepare: 11491, instructions: 939, reflections: 1, level: QualityLevel::Fast, scale: 1, psnr: 4363, largest: 47 },
    FrontPoint { prepare: 11491, instructions: 1104, reflections: 2, level: QualityLevel::Fast, scale: 1, psnr: 5690, largest: 17 },
    FrontPoint { prepare: 11491, instructions: 1129, reflections: 3, level: QualityLevel::Fast, scale: 1, psnr: 7432, largest: 3 },
    FrontPoint { prepare: 11491, instructions: 1133, reflections: 4, level: QualityLevel::Fast, scale: 1, psnr: 7832, largest: 1 },
    FrontPoint { prepare: 11491, instructions: 1246, reflections: 4, level: QualityLevel::Exact, scale: 1, psnr: 9027, largest: 1 },
    FrontPoint { prepare: 11491, instructions: 1248, reflections: 5, level: QualityLevel::Exact, scale: 1, psnr: 65535, largest: 0 },
]);
/// mirror2
pub const MIRROR2: ParetoFront = ParetoFront::new(&[
    FrontPoint { prepare: 18089, instructions: 60, reflections: 0, level: QualityLevel::Fast, scale: 4, psnr: 1790, largest: 251 },
    FrontPoint { prepare: 18089, instructions: 124, reflections: 1, level: QualityLevel::Fast, scale: 4, psnr: 2046, largest: 224 },
    FrontPoint { prepare: 18089, instructions: 188, reflections: 2, level: QualityLevel::Exact, scale: 4, psnr: 2226, largest: 224 },
    FrontPoint { prepare: 18089, instructions: 229, reflections: 3, level: QualityLevel::Exact, scale: 4, psnr: 2334, largest: 224 },
    FrontPoint { prepare: 18061, instructions: 661, reflections: 2, level: QualityLevel::Fast, scale: 2, psnr: 2403, largest: 224 },
    FrontPoint { prepare: 18061, instructions: 855, reflections: 3, level: QualityLevel::Fast, scale: 2, psnr: 2601, largest: 224 },
    FrontPoint { prepare: 18061, instructions: 1752, reflections: 2, level: QualityLevel::Fast, scale: 1, psnr: 2770, largest: 164 },
    FrontPoint { prepare: 18061, instructions: 2372, reflections: 3, level: QualityLevel::Fast, scale: 1, psnr: 5379, largest: 26 },
    FrontPoint { prepare: 18061, instructions: 2545, reflections: 4, level: QualityLevel::Fast, scale: 1, psnr: 6329, largest: 12 },
    FrontPoint { prepare: 18061, instructions: 2568, reflections: 5, level: QualityLevel::Fast, scale: 1, psnr: 6862, largest: 6 },
    FrontPoint { prepare: 18061, instructions: 2578, reflections: 6, level: QualityLevel::Fast, scale: 1, psnr: 7045, largest: 2 },
    FrontPoint { prepare: 18061, instructions: 3762, reflections: 5, level: QualityLevel::Exact, scale: 1, psnr: 7295, largest: 6 },
    FrontPoint { prepare: 18061, instructions: 3775, reflections: 6, level: QualityLevel::Exact, scale: 1, psnr: 8504, largest: 2 },
    FrontPoint { prepare: 18061, instructions: 3779, reflections: 7, level: QualityLevel::Exact, scale: 1, psnr: 9027, largest: 1 },
    FrontPoint { prepare: 18061, instructions: 3780, reflections: 8, level: QualityLevel::Exact, scale: 1, psnr: 9504, largest: 1 },
]);
/// primitives
pub const PRIMITIVES: ParetoFront = ParetoFront::new(&[
    FrontPoint { prepare: 4645, instructions: 48, reflections: 0, level: QualityLevel::Fast, scale: 4, psnr: 1923, largest: 255 },
    FrontPoint { prepare: 4645, instructions: 68, reflections: 1, level: QualityLevel::Exact, scale: 4, psnr: 2343, largest: 196 },
    FrontPoint { prepare: 4645, instructions: 190, reflections: 1, level: QualityLevel::Fast, scale: 2, psnr: 2659, largest: 212 },
    FrontPoint { prepare: 4645, instructions: 525, reflections: 1, level: QualityLevel::Fast, scale: 1, psnr: 4325, largest: 20 },
    FrontPoint { prepare: 4645, instructions: 561, reflections: 2, level: QualityLevel::Fast, scale: 1, psnr: 5799, largest: 20 },
    FrontPoint { prepare: 4645, instructions: 570, reflections: 3, level: QualityLevel::Fast, scale: 1, psnr: 6998, largest: 3 },
    FrontPoint { prepare: 4645, instructions: 571, reflections: 4, level: QualityLevel::Fast, scale: 1, psnr: 7083, largest: 1 },
    FrontPoint { prepare: 4645, instructions: 1008, reflections: 3, level: QualityLevel::Exact, scale: 1, psnr: 7748, largest: 3 },
    FrontPoint { prepare: 4645, instructions: 1009, reflections: 4, level: QualityLevel::Exact, scale: 1, psnr: 65535, largest: 0 },
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
    FrontPoint { prepare: 523, instructions: 68, reflections: 0, level: QualityLevel::Fast, scale: 2, psnr: 3777, largest: 66 },
    FrontPoint { prepare: 523, instructions: 150, reflections: 0, level: QualityLevel::Fast, scale: 1, psnr: 5941, largest: 43 },
    FrontPoint { prepare: 523, instructions: 437, reflections: 0, level: QualityLevel::Exact, scale: 1, psnr: 6024, largest: 43 },
]);
/// cylinders
pub const CYLINDERS: ParetoFront = ParetoFront::new(&[
    FrontPoint { prepare: 3768, instructions: 23, reflections: 0, level: QualityLevel::Fast, scale: 4, psnr: 2041, largest: 255 },
    FrontPoint { prepare: 3768, instructions: 73, reflections: 0, level: QualityLevel::Fast, scale: 2, psnr: 2410, largest: 255 },
    FrontPoint { prepare: 3768, instructions: 209, reflections: 0, level: QualityLevel::Fast, scale: 1, psnr: 3907, largest: 35 },
    FrontPoint { prepare: 3768, instructions: 279, reflections: 1, level: QualityLevel::Fast, scale: 1, psnr: 6310, largest: 3 },
    FrontPoint { prepare: 3768, instructions: 314, reflections: 2, level: QualityLevel::Fast, scale: 1, psnr: 7986, largest: 1 },
    FrontPoint { prepare: 3768, instructions: 425, reflections: 3, level: QualityLevel::Exact, scale: 1, psnr: 65535, largest: 0 },
]);
