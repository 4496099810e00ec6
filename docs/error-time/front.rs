// Written by `cargo run --release --package report -- --core m3 --size 128x128`:
// what is best for a frame of so many instructions. Include it where `ParetoFront`, `FrontPoint` and
// `QualityLevel` are in scope.
/// castle
pub const CASTLE: ParetoFront = ParetoFront::new(&[
    FrontPoint { prepare: 88792, instructions: 74, reflections: 0, level: QualityLevel::Fast, scale: 4, psnr: 1309, largest: 231 },
    FrontPoint { prepare: 88792, instructions: 112, reflections: 1, level: QualityLevel::Exact, scale: 4, psnr: 2177, largest: 231 },
    FrontPoint { prepare: 87976, instructions: 352, reflections: 1, level: QualityLevel::Fast, scale: 2, psnr: 2550, largest: 211 },
    FrontPoint { prepare: 87809, instructions: 1076, reflections: 1, level: QualityLevel::Fast, scale: 1, psnr: 4252, largest: 76 },
    FrontPoint { prepare: 87809, instructions: 1102, reflections: 2, level: QualityLevel::Fast, scale: 1, psnr: 5906, largest: 16 },
    FrontPoint { prepare: 87809, instructions: 1106, reflections: 3, level: QualityLevel::Fast, scale: 1, psnr: 7629, largest: 3 },
    FrontPoint { prepare: 87809, instructions: 1413, reflections: 3, level: QualityLevel::Exact, scale: 1, psnr: 8425, largest: 3 },
    FrontPoint { prepare: 87809, instructions: 1414, reflections: 4, level: QualityLevel::Exact, scale: 1, psnr: 9504, largest: 1 },
]);
/// shading_lights
pub const SHADING_LIGHTS: ParetoFront = ParetoFront::new(&[
    FrontPoint { prepare: 2280, instructions: 50, reflections: 0, level: QualityLevel::Exact, scale: 4, psnr: 2214, largest: 184 },
    FrontPoint { prepare: 2280, instructions: 66, reflections: 1, level: QualityLevel::Exact, scale: 4, psnr: 2658, largest: 181 },
    FrontPoint { prepare: 2280, instructions: 193, reflections: 1, level: QualityLevel::Fast, scale: 2, psnr: 2889, largest: 180 },
    FrontPoint { prepare: 2280, instructions: 523, reflections: 1, level: QualityLevel::Fast, scale: 1, psnr: 6725, largest: 1 },
    FrontPoint { prepare: 2280, instructions: 976, reflections: 1, level: QualityLevel::Exact, scale: 1, psnr: 65535, largest: 0 },
]);
/// shading_speculars
pub const SHADING_SPECULARS: ParetoFront = ParetoFront::new(&[
    FrontPoint { prepare: 9577, instructions: 48, reflections: 0, level: QualityLevel::Exact, scale: 4, psnr: 1870, largest: 173 },
    FrontPoint { prepare: 9577, instructions: 69, reflections: 1, level: QualityLevel::Exact, scale: 4, psnr: 2228, largest: 147 },
    FrontPoint { prepare: 9577, instructions: 220, reflections: 1, level: QualityLevel::Fast, scale: 2, psnr: 2618, largest: 155 },
    FrontPoint { prepare: 9577, instructions: 653, reflections: 1, level: QualityLevel::Fast, scale: 1, psnr: 4771, largest: 10 },
    FrontPoint { prepare: 9577, instructions: 707, reflections: 2, level: QualityLevel::Fast, scale: 1, psnr: 6242, largest: 2 },
    FrontPoint { prepare: 9577, instructions: 720, reflections: 3, level: QualityLevel::Fast, scale: 1, psnr: 6412, largest: 1 },
    FrontPoint { prepare: 9577, instructions: 1018, reflections: 2, level: QualityLevel::Exact, scale: 1, psnr: 6716, largest: 2 },
    FrontPoint { prepare: 9577, instructions: 1031, reflections: 3, level: QualityLevel::Exact, scale: 1, psnr: 8203, largest: 1 },
    FrontPoint { prepare: 9577, instructions: 1033, reflections: 4, level: QualityLevel::Exact, scale: 1, psnr: 65535, largest: 0 },
]);
/// columns
pub const COLUMNS: ParetoFront = ParetoFront::new(&[
    FrontPoint { prepare: 22602, instructions: 69, reflections: 0, level: QualityLevel::Exact, scale: 4, psnr: 2647, largest: 177 },
    FrontPoint { prepare: 22602, instructions: 92, reflections: 1, level: QualityLevel::Exact, scale: 4, psnr: 2677, largest: 178 },
    FrontPoint { prepare: 22729, instructions: 248, reflections: 0, level: QualityLevel::Exact, scale: 2, psnr: 2936, largest: 163 },
    FrontPoint { prepare: 22729, instructions: 314, reflections: 1, level: QualityLevel::Exact, scale: 2, psnr: 2980, largest: 173 },
    FrontPoint { prepare: 22817, instructions: 699, reflections: 0, level: QualityLevel::Fast, scale: 1, psnr: 3829, largest: 56 },
    FrontPoint { prepare: 22817, instructions: 900, reflections: 1, level: QualityLevel::Fast, scale: 1, psnr: 5791, largest: 16 },
    FrontPoint { prepare: 22817, instructions: 955, reflections: 2, level: QualityLevel::Fast, scale: 1, psnr: 7207, largest: 2 },
    FrontPoint { prepare: 22817, instructions: 1180, reflections: 2, level: QualityLevel::Exact, scale: 1, psnr: 8425, largest: 2 },
    FrontPoint { prepare: 22817, instructions: 1193, reflections: 3, level: QualityLevel::Exact, scale: 1, psnr: 65535, largest: 0 },
]);
/// mirror1
pub const MIRROR1: ParetoFront = ParetoFront::new(&[
    FrontPoint { prepare: 13831, instructions: 55, reflections: 0, level: QualityLevel::Exact, scale: 4, psnr: 1574, largest: 255 },
    FrontPoint { prepare: 13831, instructions: 81, reflections: 1, level: QualityLevel::Exact, scale: 4, psnr: 2297, largest: 255 },
    FrontPoint { prepare: 13831, instructions: 304, reflections: 1, level: QualityLevel::Exact, scale: 2, psnr: 2508, largest: 234 },
    FrontPoint { prepare: 13831, instructions: 967, reflections: 1, level: QualityLevel::Fast, scale: 1, psnr: 4363, largest: 47 },
    FrontPoint { prepare: 13831, instructions: 1128, reflections: 2, level: QualityLevel::Fast, scale: 1, psnr: 5690, largest: 17 },
    FrontPoint { prepare: 13831, instructions: 1153, reflections: 3, level: QualityLevel::Fast, scale: 1, psnr: 7432, largest: 3 },
    FrontPoint { prepare: 13831, instructions: 1157, reflections: 4, level: QualityLevel::Fast, scale: 1, psnr: 7832, largest: 1 },
    FrontPoint { prepare: 13831, instructions: 1272, reflections: 4, level: QualityLevel::Exact, scale: 1, psnr: 9027, largest: 1 },
    FrontPoint { prepare: 13831, instructions: 1274, reflections: 5, level: QualityLevel::Exact, scale: 1, psnr: 65535, largest: 0 },
]);
/// mirror2
pub const MIRROR2: ParetoFront = ParetoFront::new(&[
    FrontPoint { prepare: 21779, instructions: 64, reflections: 0, level: QualityLevel::Fast, scale: 4, psnr: 1790, largest: 251 },
    FrontPoint { prepare: 21779, instructions: 126, reflections: 1, level: QualityLevel::Exact, scale: 4, psnr: 2046, largest: 224 },
    FrontPoint { prepare: 21779, instructions: 189, reflections: 2, level: QualityLevel::Exact, scale: 4, psnr: 2226, largest: 224 },
    FrontPoint { prepare: 21779, instructions: 230, reflections: 3, level: QualityLevel::Exact, scale: 4, psnr: 2334, largest: 224 },
    FrontPoint { prepare: 21779, instructions: 654, reflections: 2, level: QualityLevel::Fast, scale: 2, psnr: 2403, largest: 224 },
    FrontPoint { prepare: 21779, instructions: 849, reflections: 3, level: QualityLevel::Fast, scale: 2, psnr: 2601, largest: 224 },
    FrontPoint { prepare: 21779, instructions: 1847, reflections: 2, level: QualityLevel::Fast, scale: 1, psnr: 2770, largest: 164 },
    FrontPoint { prepare: 21779, instructions: 2440, reflections: 3, level: QualityLevel::Fast, scale: 1, psnr: 5380, largest: 26 },
    FrontPoint { prepare: 21779, instructions: 2606, reflections: 4, level: QualityLevel::Fast, scale: 1, psnr: 6335, largest: 12 },
    FrontPoint { prepare: 21779, instructions: 2630, reflections: 5, level: QualityLevel::Fast, scale: 1, psnr: 6882, largest: 6 },
    FrontPoint { prepare: 21779, instructions: 2639, reflections: 6, level: QualityLevel::Fast, scale: 1, psnr: 7076, largest: 2 },
    FrontPoint { prepare: 21779, instructions: 3740, reflections: 5, level: QualityLevel::Exact, scale: 1, psnr: 7295, largest: 6 },
    FrontPoint { prepare: 21779, instructions: 3752, reflections: 6, level: QualityLevel::Exact, scale: 1, psnr: 8504, largest: 2 },
    FrontPoint { prepare: 21779, instructions: 3756, reflections: 7, level: QualityLevel::Exact, scale: 1, psnr: 9027, largest: 1 },
    FrontPoint { prepare: 21779, instructions: 3758, reflections: 8, level: QualityLevel::Exact, scale: 1, psnr: 9504, largest: 1 },
]);
/// primitives
pub const PRIMITIVES: ParetoFront = ParetoFront::new(&[
    FrontPoint { prepare: 5312, instructions: 51, reflections: 0, level: QualityLevel::Exact, scale: 4, psnr: 1923, largest: 255 },
    FrontPoint { prepare: 5312, instructions: 71, reflections: 1, level: QualityLevel::Exact, scale: 4, psnr: 2343, largest: 196 },
    FrontPoint { prepare: 5312, instructions: 218, reflections: 1, level: QualityLevel::Fast, scale: 2, psnr: 2659, largest: 212 },
    FrontPoint { prepare: 5312, instructions: 579, reflections: 1, level: QualityLevel::Fast, scale: 1, psnr: 4325, largest: 20 },
    FrontPoint { prepare: 5312, instructions: 615, reflections: 2, level: QualityLevel::Fast, scale: 1, psnr: 5801, largest: 20 },
    FrontPoint { prepare: 5312, instructions: 624, reflections: 3, level: QualityLevel::Fast, scale: 1, psnr: 7024, largest: 3 },
    FrontPoint { prepare: 5312, instructions: 626, reflections: 4, level: QualityLevel::Fast, scale: 1, psnr: 7115, largest: 1 },
    FrontPoint { prepare: 5312, instructions: 1040, reflections: 3, level: QualityLevel::Exact, scale: 1, psnr: 7748, largest: 3 },
    FrontPoint { prepare: 5312, instructions: 1041, reflections: 4, level: QualityLevel::Exact, scale: 1, psnr: 65535, largest: 0 },
]);
/// empty
pub const EMPTY: ParetoFront = ParetoFront::new(&[
    FrontPoint { prepare: 62, instructions: 2, reflections: 0, level: QualityLevel::Fast, scale: 1, psnr: 65535, largest: 0 },
]);
/// floor
pub const FLOOR: ParetoFront = ParetoFront::new(&[
    FrontPoint { prepare: 433, instructions: 15, reflections: 0, level: QualityLevel::Exact, scale: 4, psnr: 2432, largest: 124 },
    FrontPoint { prepare: 433, instructions: 25, reflections: 0, level: QualityLevel::Fast, scale: 2, psnr: 65535, largest: 0 },
]);
/// corner1
pub const CORNER1: ParetoFront = ParetoFront::new(&[
    FrontPoint { prepare: 523, instructions: 31, reflections: 0, level: QualityLevel::Exact, scale: 4, psnr: 3026, largest: 101 },
    FrontPoint { prepare: 523, instructions: 65, reflections: 0, level: QualityLevel::Fast, scale: 2, psnr: 3777, largest: 66 },
    FrontPoint { prepare: 523, instructions: 144, reflections: 0, level: QualityLevel::Fast, scale: 1, psnr: 5940, largest: 43 },
    FrontPoint { prepare: 523, instructions: 437, reflections: 0, level: QualityLevel::Exact, scale: 1, psnr: 6024, largest: 43 },
]);
/// cylinders
pub const CYLINDERS: ParetoFront = ParetoFront::new(&[
    FrontPoint { prepare: 4545, instructions: 26, reflections: 0, level: QualityLevel::Fast, scale: 4, psnr: 2041, largest: 255 },
    FrontPoint { prepare: 4545, instructions: 77, reflections: 0, level: QualityLevel::Fast, scale: 2, psnr: 2410, largest: 255 },
    FrontPoint { prepare: 4545, instructions: 212, reflections: 0, level: QualityLevel::Fast, scale: 1, psnr: 3907, largest: 35 },
    FrontPoint { prepare: 4545, instructions: 281, reflections: 1, level: QualityLevel::Fast, scale: 1, psnr: 6310, largest: 3 },
    FrontPoint { prepare: 4545, instructions: 316, reflections: 2, level: QualityLevel::Fast, scale: 1, psnr: 7986, largest: 1 },
    FrontPoint { prepare: 4545, instructions: 428, reflections: 3, level: QualityLevel::Exact, scale: 1, psnr: 65535, largest: 0 },
]);
