// Written by `cargo run --release --package report -- --core m3 --size 128x128`:
// what is best for a frame of so many instructions. Include it where `ParetoFront`, `FrontPoint` and
// `QualityLevel` are in scope.
/// castle
pub const CASTLE: ParetoFront = ParetoFront::new(&[
    FrontPoint { prepare: 120450, instructions: 56, reflections: 0, level: QualityLevel::Fast, scale: 4, psnr: 1309, largest: 231 },
    FrontPoint { prepare: 120450, instructions: 104, reflections: 1, level: QualityLevel::Fast, scale: 4, psnr: 2177, largest: 231 },
    FrontPoint { prepare: 118369, instructions: 261, reflections: 1, level: QualityLevel::Fast, scale: 2, psnr: 2550, largest: 211 },
    FrontPoint { prepare: 117730, instructions: 755, reflections: 1, level: QualityLevel::Fast, scale: 1, psnr: 4250, largest: 76 },
    FrontPoint { prepare: 117730, instructions: 782, reflections: 2, level: QualityLevel::Fast, scale: 1, psnr: 5836, largest: 17 },
    FrontPoint { prepare: 117730, instructions: 786, reflections: 3, level: QualityLevel::Fast, scale: 1, psnr: 6616, largest: 17 },
    FrontPoint { prepare: 117730, instructions: 1015, reflections: 3, level: QualityLevel::Fine, scale: 1, psnr: 6846, largest: 17 },
]);
/// shading_lights
pub const SHADING_LIGHTS: ParetoFront = ParetoFront::new(&[
    FrontPoint { prepare: 3285, instructions: 35, reflections: 0, level: QualityLevel::Fast, scale: 4, psnr: 2214, largest: 184 },
    FrontPoint { prepare: 3285, instructions: 49, reflections: 1, level: QualityLevel::Fast, scale: 4, psnr: 2658, largest: 181 },
    FrontPoint { prepare: 3285, instructions: 139, reflections: 1, level: QualityLevel::Fast, scale: 2, psnr: 2889, largest: 180 },
    FrontPoint { prepare: 3285, instructions: 382, reflections: 1, level: QualityLevel::Fast, scale: 1, psnr: 7772, largest: 1 },
    FrontPoint { prepare: 3285, instructions: 622, reflections: 1, level: QualityLevel::Fine, scale: 1, psnr: 8902, largest: 1 },
]);
/// shading_speculars
pub const SHADING_SPECULARS: ParetoFront = ParetoFront::new(&[
    FrontPoint { prepare: 11391, instructions: 33, reflections: 0, level: QualityLevel::Fast, scale: 4, psnr: 1870, largest: 173 },
    FrontPoint { prepare: 11391, instructions: 54, reflections: 1, level: QualityLevel::Fast, scale: 4, psnr: 2228, largest: 147 },
    FrontPoint { prepare: 11373, instructions: 161, reflections: 1, level: QualityLevel::Fast, scale: 2, psnr: 2618, largest: 155 },
    FrontPoint { prepare: 11349, instructions: 462, reflections: 1, level: QualityLevel::Fast, scale: 1, psnr: 4776, largest: 10 },
    FrontPoint { prepare: 11349, instructions: 523, reflections: 2, level: QualityLevel::Fast, scale: 1, psnr: 6508, largest: 5 },
    FrontPoint { prepare: 11349, instructions: 537, reflections: 3, level: QualityLevel::Fast, scale: 1, psnr: 6931, largest: 5 },
    FrontPoint { prepare: 11349, instructions: 737, reflections: 3, level: QualityLevel::Fine, scale: 1, psnr: 7986, largest: 1 },
    FrontPoint { prepare: 11349, instructions: 739, reflections: 4, level: QualityLevel::Fine, scale: 1, psnr: 8390, largest: 1 },
]);
/// columns
pub const COLUMNS: ParetoFront = ParetoFront::new(&[
    FrontPoint { prepare: 23498, instructions: 54, reflections: 0, level: QualityLevel::Fast, scale: 4, psnr: 2641, largest: 177 },
    FrontPoint { prepare: 23498, instructions: 70, reflections: 1, level: QualityLevel::Fast, scale: 4, psnr: 2677, largest: 178 },
    FrontPoint { prepare: 23619, instructions: 160, reflections: 0, level: QualityLevel::Fast, scale: 2, psnr: 2935, largest: 163 },
    FrontPoint { prepare: 23619, instructions: 212, reflections: 1, level: QualityLevel::Fast, scale: 2, psnr: 2980, largest: 173 },
    FrontPoint { prepare: 23703, instructions: 465, reflections: 0, level: QualityLevel::Fast, scale: 1, psnr: 3823, largest: 56 },
    FrontPoint { prepare: 23703, instructions: 648, reflections: 1, level: QualityLevel::Fast, scale: 1, psnr: 5750, largest: 16 },
    FrontPoint { prepare: 23703, instructions: 701, reflections: 2, level: QualityLevel::Fast, scale: 1, psnr: 7986, largest: 2 },
    FrontPoint { prepare: 23703, instructions: 713, reflections: 3, level: QualityLevel::Fast, scale: 1, psnr: 8162, largest: 1 },
    FrontPoint { prepare: 23703, instructions: 887, reflections: 2, level: QualityLevel::Fine, scale: 1, psnr: 8249, largest: 2 },
    FrontPoint { prepare: 23703, instructions: 899, reflections: 3, level: QualityLevel::Fine, scale: 1, psnr: 8659, largest: 1 },
]);
/// mirror1
pub const MIRROR1: ParetoFront = ParetoFront::new(&[
    FrontPoint { prepare: 16294, instructions: 40, reflections: 0, level: QualityLevel::Fast, scale: 4, psnr: 1568, largest: 255 },
    FrontPoint { prepare: 16294, instructions: 68, reflections: 1, level: QualityLevel::Fast, scale: 4, psnr: 2282, largest: 255 },
    FrontPoint { prepare: 16294, instructions: 212, reflections: 1, level: QualityLevel::Fast, scale: 2, psnr: 2471, largest: 234 },
    FrontPoint { prepare: 16294, instructions: 261, reflections: 1, level: QualityLevel::Fine, scale: 2, psnr: 2508, largest: 234 },
    FrontPoint { prepare: 16294, instructions: 653, reflections: 1, level: QualityLevel::Fast, scale: 1, psnr: 4362, largest: 47 },
    FrontPoint { prepare: 16294, instructions: 822, reflections: 2, level: QualityLevel::Fast, scale: 1, psnr: 5683, largest: 16 },
    FrontPoint { prepare: 16294, instructions: 851, reflections: 3, level: QualityLevel::Fast, scale: 1, psnr: 7094, largest: 4 },
    FrontPoint { prepare: 16294, instructions: 856, reflections: 4, level: QualityLevel::Fast, scale: 1, psnr: 7235, largest: 4 },
    FrontPoint { prepare: 16294, instructions: 993, reflections: 3, level: QualityLevel::Fine, scale: 1, psnr: 7496, largest: 3 },
    FrontPoint { prepare: 16294, instructions: 1002, reflections: 4, level: QualityLevel::Fine, scale: 1, psnr: 8182, largest: 1 },
    FrontPoint { prepare: 16294, instructions: 1004, reflections: 5, level: QualityLevel::Fine, scale: 1, psnr: 8249, largest: 1 },
]);
/// mirror2
pub const MIRROR2: ParetoFront = ParetoFront::new(&[
    FrontPoint { prepare: 25126, instructions: 43, reflections: 0, level: QualityLevel::Fast, scale: 4, psnr: 1782, largest: 251 },
    FrontPoint { prepare: 25126, instructions: 91, reflections: 1, level: QualityLevel::Fast, scale: 4, psnr: 2038, largest: 224 },
    FrontPoint { prepare: 25126, instructions: 144, reflections: 2, level: QualityLevel::Fast, scale: 4, psnr: 2214, largest: 224 },
    FrontPoint { prepare: 25126, instructions: 180, reflections: 3, level: QualityLevel::Fast, scale: 4, psnr: 2318, largest: 224 },
    FrontPoint { prepare: 25102, instructions: 409, reflections: 2, level: QualityLevel::Fast, scale: 2, psnr: 2374, largest: 224 },
    FrontPoint { prepare: 25102, instructions: 521, reflections: 3, level: QualityLevel::Fast, scale: 2, psnr: 2555, largest: 224 },
    FrontPoint { prepare: 25102, instructions: 661, reflections: 3, level: QualityLevel::Fine, scale: 2, psnr: 2601, largest: 224 },
    FrontPoint { prepare: 24345, instructions: 1231, reflections: 2, level: QualityLevel::Fast, scale: 1, psnr: 2766, largest: 164 },
    FrontPoint { prepare: 24345, instructions: 1586, reflections: 3, level: QualityLevel::Fast, scale: 1, psnr: 4723, largest: 115 },
    FrontPoint { prepare: 24345, instructions: 1713, reflections: 4, level: QualityLevel::Fast, scale: 1, psnr: 4819, largest: 115 },
    FrontPoint { prepare: 24345, instructions: 2266, reflections: 3, level: QualityLevel::Fine, scale: 1, psnr: 5376, largest: 26 },
    FrontPoint { prepare: 24345, instructions: 2422, reflections: 4, level: QualityLevel::Fine, scale: 1, psnr: 6303, largest: 14 },
    FrontPoint { prepare: 24345, instructions: 2452, reflections: 5, level: QualityLevel::Fine, scale: 1, psnr: 6781, largest: 14 },
    FrontPoint { prepare: 24345, instructions: 2465, reflections: 6, level: QualityLevel::Fine, scale: 1, psnr: 6929, largest: 14 },
]);
/// primitives
pub const PRIMITIVES: ParetoFront = ParetoFront::new(&[
    FrontPoint { prepare: 6744, instructions: 30, reflections: 0, level: QualityLevel::Fast, scale: 4, psnr: 1923, largest: 255 },
    FrontPoint { prepare: 6744, instructions: 46, reflections: 1, level: QualityLevel::Fast, scale: 4, psnr: 2343, largest: 196 },
    FrontPoint { prepare: 6744, instructions: 141, reflections: 1, level: QualityLevel::Fast, scale: 2, psnr: 2658, largest: 212 },
    FrontPoint { prepare: 6744, instructions: 439, reflections: 1, level: QualityLevel::Fast, scale: 1, psnr: 4298, largest: 86 },
    FrontPoint { prepare: 6744, instructions: 474, reflections: 2, level: QualityLevel::Fast, scale: 1, psnr: 5711, largest: 20 },
    FrontPoint { prepare: 6744, instructions: 486, reflections: 3, level: QualityLevel::Fast, scale: 1, psnr: 6554, largest: 12 },
    FrontPoint { prepare: 6744, instructions: 488, reflections: 4, level: QualityLevel::Fast, scale: 1, psnr: 6582, largest: 12 },
    FrontPoint { prepare: 6744, instructions: 702, reflections: 3, level: QualityLevel::Fine, scale: 1, psnr: 6931, largest: 11 },
    FrontPoint { prepare: 6744, instructions: 704, reflections: 4, level: QualityLevel::Fine, scale: 1, psnr: 7003, largest: 11 },
]);
/// empty
pub const EMPTY: ParetoFront = ParetoFront::new(&[
    FrontPoint { prepare: 181, instructions: 2, reflections: 0, level: QualityLevel::Fast, scale: 1, psnr: 65535, largest: 0 },
]);
/// floor
pub const FLOOR: ParetoFront = ParetoFront::new(&[
    FrontPoint { prepare: 417, instructions: 11, reflections: 0, level: QualityLevel::Fine, scale: 4, psnr: 2432, largest: 124 },
    FrontPoint { prepare: 417, instructions: 42, reflections: 0, level: QualityLevel::Fine, scale: 2, psnr: 65535, largest: 0 },
]);
/// corner1
pub const CORNER1: ParetoFront = ParetoFront::new(&[
    FrontPoint { prepare: 729, instructions: 20, reflections: 0, level: QualityLevel::Fast, scale: 4, psnr: 3026, largest: 101 },
    FrontPoint { prepare: 729, instructions: 61, reflections: 0, level: QualityLevel::Fast, scale: 2, psnr: 3777, largest: 66 },
    FrontPoint { prepare: 729, instructions: 185, reflections: 0, level: QualityLevel::Fine, scale: 1, psnr: 6024, largest: 43 },
]);
/// cylinders
pub const CYLINDERS: ParetoFront = ParetoFront::new(&[
    FrontPoint { prepare: 4728, instructions: 19, reflections: 0, level: QualityLevel::Fast, scale: 4, psnr: 1996, largest: 255 },
    FrontPoint { prepare: 4728, instructions: 20, reflections: 0, level: QualityLevel::Fine, scale: 4, psnr: 2041, largest: 255 },
    FrontPoint { prepare: 4695, instructions: 60, reflections: 0, level: QualityLevel::Fast, scale: 2, psnr: 2395, largest: 255 },
    FrontPoint { prepare: 4695, instructions: 147, reflections: 0, level: QualityLevel::Fast, scale: 1, psnr: 3907, largest: 35 },
    FrontPoint { prepare: 4695, instructions: 225, reflections: 1, level: QualityLevel::Fast, scale: 1, psnr: 6296, largest: 6 },
    FrontPoint { prepare: 4695, instructions: 263, reflections: 2, level: QualityLevel::Fast, scale: 1, psnr: 7601, largest: 6 },
    FrontPoint { prepare: 4695, instructions: 281, reflections: 2, level: QualityLevel::Fine, scale: 1, psnr: 7973, largest: 1 },
    FrontPoint { prepare: 4695, instructions: 298, reflections: 3, level: QualityLevel::Fine, scale: 1, psnr: 9504, largest: 1 },
]);
