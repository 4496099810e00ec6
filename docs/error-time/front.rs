// Written by `cargo run --release --package report -- --core m3 --size 128x128`:
// what is best for a frame of so many instructions. Include it where `ParetoFront`, `FrontPoint` and
// `QualityLevel` are in scope.
/// castle
pub const CASTLE: ParetoFront = ParetoFront::new(&[
    FrontPoint { prepare: 88792, instructions: 75, reflections: 0, level: QualityLevel::Fast, scale: 4, psnr: 1309, largest: 231 },
    FrontPoint { prepare: 88792, instructions: 113, reflections: 1, level: QualityLevel::Exact, scale: 4, psnr: 2177, largest: 231 },
    FrontPoint { prepare: 87976, instructions: 355, reflections: 1, level: QualityLevel::Fast, scale: 2, psnr: 2550, largest: 211 },
    FrontPoint { prepare: 87809, instructions: 1085, reflections: 1, level: QualityLevel::Fast, scale: 1, psnr: 4252, largest: 76 },
    FrontPoint { prepare: 87809, instructions: 1112, reflections: 2, level: QualityLevel::Fast, scale: 1, psnr: 5906, largest: 16 },
    FrontPoint { prepare: 87809, instructions: 1115, reflections: 3, level: QualityLevel::Fast, scale: 1, psnr: 7629, largest: 3 },
    FrontPoint { prepare: 87809, instructions: 1422, reflections: 3, level: QualityLevel::Exact, scale: 1, psnr: 8425, largest: 3 },
]);
/// shading_lights
pub const SHADING_LIGHTS: ParetoFront = ParetoFront::new(&[
    FrontPoint { prepare: 2280, instructions: 50, reflections: 0, level: QualityLevel::Exact, scale: 4, psnr: 2214, largest: 184 },
    FrontPoint { prepare: 2280, instructions: 66, reflections: 1, level: QualityLevel::Exact, scale: 4, psnr: 2658, largest: 181 },
    FrontPoint { prepare: 2280, instructions: 195, reflections: 1, level: QualityLevel::Fast, scale: 2, psnr: 2889, largest: 180 },
    FrontPoint { prepare: 2280, instructions: 529, reflections: 1, level: QualityLevel::Fast, scale: 1, psnr: 6725, largest: 1 },
    FrontPoint { prepare: 2280, instructions: 969, reflections: 1, level: QualityLevel::Exact, scale: 1, psnr: 65535, largest: 0 },
]);
/// shading_speculars
pub const SHADING_SPECULARS: ParetoFront = ParetoFront::new(&[
    FrontPoint { prepare: 9577, instructions: 48, reflections: 0, level: QualityLevel::Exact, scale: 4, psnr: 1870, largest: 173 },
    FrontPoint { prepare: 9577, instructions: 69, reflections: 1, level: QualityLevel::Exact, scale: 4, psnr: 2228, largest: 147 },
    FrontPoint { prepare: 9577, instructions: 223, reflections: 1, level: QualityLevel::Fast, scale: 2, psnr: 2618, largest: 155 },
    FrontPoint { prepare: 9577, instructions: 661, reflections: 1, level: QualityLevel::Fast, scale: 1, psnr: 4771, largest: 10 },
    FrontPoint { prepare: 9577, instructions: 715, reflections: 2, level: QualityLevel::Fast, scale: 1, psnr: 6242, largest: 2 },
    FrontPoint { prepare: 9577, instructions: 727, reflections: 3, level: QualityLevel::Fast, scale: 1, psnr: 6412, largest: 1 },
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
    FrontPoint { prepare: 22817, instructions: 708, reflections: 0, level: QualityLevel::Fast, scale: 1, psnr: 3829, largest: 56 },
    FrontPoint { prepare: 22817, instructions: 908, reflections: 1, level: QualityLevel::Fast, scale: 1, psnr: 5791, largest: 16 },
    FrontPoint { prepare: 22817, instructions: 963, reflections: 2, level: QualityLevel::Fast, scale: 1, psnr: 7207, largest: 2 },
    FrontPoint { prepare: 22817, instructions: 1167, reflections: 2, level: QualityLevel::Exact, scale: 1, psnr: 8425, largest: 2 },
    FrontPoint { prepare: 22817, instructions: 1180, reflections: 3, level: QualityLevel::Exact, scale: 1, psnr: 65535, largest: 0 },
]);
/// mirror1
pub const MIRROR1: ParetoFront = ParetoFront::new(&[
    FrontPoint { prepare: 13831, instructions: 55, reflections: 0, level: QualityLevel::Exact, scale: 4, psnr: 1574, largest: 255 },
    FrontPoint { prepare: 13831, instructions: 81, reflections: 1, level: QualityLevel::Exact, scale: 4, psnr: 2297, largest: 255 },
    FrontPoint { prepare: 13831, instructions: 304, reflections: 1, level: QualityLevel::Exact, scale: 2, psnr: 2508, largest: 234 },
    FrontPoint { prepare: 13831, instructions: 976, reflections: 1, level: QualityLevel::Fast, scale: 1, psnr: 4363, largest: 47 },
    FrontPoint { prepare: 13831, instructions: 1137, reflections: 2, level: QualityLevel::Fast, scale: 1, psnr: 5690, largest: 17 },
    FrontPoint { prepare: 13831, instructions: 1163, reflections: 3, level: QualityLevel::Fast, scale: 1, psnr: 7432, largest: 3 },
    FrontPoint { prepare: 13831, instructions: 1167, reflections: 4, level: QualityLevel::Fast, scale: 1, psnr: 7832, largest: 1 },
    FrontPoint { prepare: 13831, instructions: 1271, reflections: 4, level: QualityLevel::Exact, scale: 1, psnr: 9027, largest: 1 },
    FrontPoint { prepare: 13831, instructions: 1273, reflections: 5, level: QualityLevel::Exact, scale: 1, psnr: 65535, largest: 0 },
]);
/// mirror2
pub const MIRROR2: ParetoFront = ParetoFront::new(&[
    FrontPoint { prepare: 21779, instructions: 65, reflections: 0, level: QualityLevel::Fast, scale: 4, psnr: 1790, largest: 251 },
    FrontPoint { prepare: 21779, instructions: 127, reflections: 1, level: QualityLevel::Exact, scale: 4, psnr: 2046, largest: 224 },
    FrontPoint { prepare: 21779, instructions: 190, reflections: 2, level: QualityLevel::Exact, scale: 4, psnr: 2226, largest: 224 },
    FrontPoint { prepare: 21779, instructions: 231, reflections: 3, level: QualityLevel::Exact, scale: 4, psnr: 2334, largest: 224 },
    FrontPoint { prepare: 21779, instructions: 657, reflections: 2, level: QualityLevel::Fast, scale: 2, psnr: 2403, largest: 224 },
    FrontPoint { prepare: 21779, instructions: 852, reflections: 3, level: QualityLevel::Fast, scale: 2, psnr: 2601, largest: 224 },
    FrontPoint { prepare: 21779, instructions: 1856, reflections: 2, level: QualityLevel::Fast, scale: 1, psnr: 2770, largest: 164 },
    FrontPoint { prepare: 21779, instructions: 2450, reflections: 3, level: QualityLevel::Fast, scale: 1, psnr: 5380, largest: 26 },
    FrontPoint { prepare: 21779, instructions: 2615, reflections: 4, level: QualityLevel::Fast, scale: 1, psnr: 6335, largest: 12 },
    FrontPoint { prepare: 21779, instructions: 2639, reflections: 5, level: QualityLevel::Fast, scale: 1, psnr: 6882, largest: 6 },
    FrontPoint { prepare: 21779, instructions: 2648, reflections: 6, level: QualityLevel::Fast, scale: 1, psnr: 7076, largest: 2 },
    FrontPoint { prepare: 21779, instructions: 3752, reflections: 5, level: QualityLevel::Exact, scale: 1, psnr: 7295, largest: 6 },
    FrontPoint { prepare: 21779, instructions: 3764, reflections: 6, level: QualityLevel::Exact, scale: 1, psnr: 8504, largest: 2 },
    FrontPoint { prepare: 21779, instructions: 3768, reflections: 7, level: QualityLevel::Exact, scale: 1, psnr: 9027, largest: 1 },
    FrontPoint { prepare: 21779, instructions: 3769, reflections: 8, level: QualityLevel::Exact, scale: 1, psnr: 9504, largest: 1 },
]);
/// primitives
pub const PRIMITIVES: ParetoFront = ParetoFront::new(&[
    FrontPoint { prepare: 5312, instructions: 52, reflections: 0, level: QualityLevel::Exact, scale: 4, psnr: 1923, largest: 255 },
    FrontPoint { prepare: 5312, instructions: 72, reflections: 1, level: QualityLevel::Exact, scale: 4, psnr: 2343, largest: 196 },
    FrontPoint { prepare: 5312, instructions: 221, reflections: 1, level: QualityLevel::Fast, scale: 2, psnr: 2659, largest: 212 },
    FrontPoint { prepare: 5312, instructions: 586, reflections: 1, level: QualityLevel::Fast, scale: 1, psnr: 4325, largest: 20 },
    FrontPoint { prepare: 5312, instructions: 622, reflections: 2, level: QualityLevel::Fast, scale: 1, psnr: 5801, largest: 20 },
    FrontPoint { prepare: 5312, instructions: 632, reflections: 3, level: QualityLevel::Fast, scale: 1, psnr: 7024, largest: 3 },
    FrontPoint { prepare: 5312, instructions: 633, reflections: 4, level: QualityLevel::Fast, scale: 1, psnr: 7115, largest: 1 },
    FrontPoint { prepare: 5312, instructions: 1048, reflections: 3, level: QualityLevel::Exact, scale: 1, psnr: 7748, largest: 3 },
    FrontPoint { prepare: 5312, instructions: 1049, reflections: 4, level: QualityLevel::Exact, scale: 1, psnr: 65535, largest: 0 },
]);
/// empty
pub const EMPTY: ParetoFront = ParetoFront::new(&[
    FrontPoint { prepare: 62, instructions: 2, reflections: 0, level: QualityLevel::Fast, scale: 1, psnr: 65535, largest: 0 },
]);
/// floor
pub const FLOOR: ParetoFront = ParetoFront::new(&[
    FrontPoint { prepare: 433, instructions: 15, reflections: 0, level: QualityLevel::Exact, scale: 4, psnr: 2432, largest: 124 },
    FrontPoint { prepare: 433, instructions: 26, reflections: 0, level: QualityLevel::Fast, scale: 2, psnr: 65535, largest: 0 },
]);
/// corner1
pub const CORNER1: ParetoFront = ParetoFront::new(&[
    FrontPoint { prepare: 523, instructions: 31, reflections: 0, level: QualityLevel::Exact, scale: 4, psnr: 3026, largest: 101 },
    FrontPoint { prepare: 523, instructions: 67, reflections: 0, level: QualityLevel::Fast, scale: 2, psnr: 3777, largest: 66 },
    FrontPoint { prepare: 523, instructions: 148, reflections: 0, level: QualityLevel::Fast, scale: 1, psnr: 5940, largest: 43 },
    FrontPoint { prepare: 523, instructions: 437, reflections: 0, level: QualityLevel::Exact, scale: 1, psnr: 6024, largest: 43 },
]);
/// cylinders
pub const CYLINDERS: ParetoFront = ParetoFront::new(&[
    FrontPoint { prepare: 4545, instructions: 27, reflections: 0, level: QualityLevel::Fast, scale: 4, psnr: 2041, largest: 255 },
    FrontPoint { prepare: 4545, instructions: 79, reflections: 0, level: QualityLevel::Fast, scale: 2, psnr: 2410, largest: 255 },
    FrontPoint { prepare: 4545, instructions: 216, reflections: 0, level: QualityLevel::Fast, scale: 1, psnr: 3907, largest: 35 },
    FrontPoint { prepare: 4545, instructions: 285, reflections: 1, level: QualityLevel::Fast, scale: 1, psnr: 6310, largest: 3 },
    FrontPoint { prepare: 4545, instructions: 320, reflections: 2, level: QualityLevel::Fast, scale: 1, psnr: 7986, largest: 1 },
    FrontPoint { prepare: 4545, instructions: 427, reflections: 3, level: QualityLevel::Exact, scale: 1, psnr: 65535, largest: 0 },
]);
