// Written by `cargo run --release --package report -- --core m3 --size 128x128`:
// what is best for a frame of so many instructions. Include it where `ParetoFront`, `FrontPoint` and
// `QualityLevel` are in scope.
/// castle
pub const CASTLE: ParetoFront = ParetoFront::new(&[
    FrontPoint { prepare: 120449, instructions: 56, reflections: 0, level: QualityLevel::Fast, scale: 4, psnr: 1309, largest: 231 },
    FrontPoint { prepare: 120449, instructions: 103, reflections: 1, level: QualityLevel::Fast, scale: 4, psnr: 2177, largest: 231 },
    FrontPoint { prepare: 118368, instructions: 261, reflections: 1, level: QualityLevel::Fast, scale: 2, psnr: 2550, largest: 211 },
    FrontPoint { prepare: 117729, instructions: 755, reflections: 1, level: QualityLevel::Fast, scale: 1, psnr: 4250, largest: 76 },
    FrontPoint { prepare: 117729, instructions: 781, reflections: 2, level: QualityLevel::Fast, scale: 1, psnr: 5836, largest: 17 },
    FrontPoint { prepare: 117729, instructions: 785, reflections: 3, level: QualityLevel::Fast, scale: 1, psnr: 6616, largest: 17 },
    FrontPoint { prepare: 117729, instructions: 1015, reflections: 3, level: QualityLevel::Fine, scale: 1, psnr: 6846, largest: 17 },
]);
/// shading_lights
pub const SHADING_LIGHTS: ParetoFront = ParetoFront::new(&[
    FrontPoint { prepare: 3268, instructions: 35, reflections: 0, level: QualityLevel::Fast, scale: 4, psnr: 2214, largest: 184 },
    FrontPoint { prepare: 3268, instructions: 49, reflections: 1, level: QualityLevel::Fast, scale: 4, psnr: 2658, largest: 181 },
    FrontPoint { prepare: 3268, instructions: 139, reflections: 1, level: QualityLevel::Fast, scale: 2, psnr: 2889, largest: 180 },
    FrontPoint { prepare: 3268, instructions: 382, reflections: 1, level: QualityLevel::Fast, scale: 1, psnr: 7772, largest: 1 },
    FrontPoint { prepare: 3268, instructions: 622, reflections: 1, level: QualityLevel::Fine, scale: 1, psnr: 8902, largest: 1 },
]);
/// shading_speculars
pub const SHADING_SPECULARS: ParetoFront = ParetoFront::new(&[
    FrontPoint { prepare: 11390, instructions: 33, reflections: 0, level: QualityLevel::Fast, scale: 4, psnr: 1870, largest: 173 },
    FrontPoint { prepare: 11390, instructions: 54, reflections: 1, level: QualityLevel::Fast, scale: 4, psnr: 2228, largest: 147 },
    FrontPoint { prepare: 11372, instructions: 161, reflections: 1, level: QualityLevel::Fast, scale: 2, psnr: 2618, largest: 155 },
    FrontPoint { prepare: 11348, instructions: 461, reflections: 1, level: QualityLevel::Fast, scale: 1, psnr: 4776, largest: 10 },
    FrontPoint { prepare: 11348, instructions: 522, reflections: 2, level: QualityLevel::Fast, scale: 1, psnr: 6508, largest: 5 },
    FrontPoint { prepare: 11348, instructions: 537, reflections: 3, level: QualityLevel::Fast, scale: 1, psnr: 6931, largest: 5 },
    FrontPoint { prepare: 11348, instructions: 737, reflections: 3, level: QualityLevel::Fine, scale: 1, psnr: 7986, largest: 1 },
    FrontPoint { prepare: 11348, instructions: 739, reflections: 4, level: QualityLevel::Fine, scale: 1, psnr: 8390, largest: 1 },
]);
/// columns
pub const COLUMNS: ParetoFront = ParetoFront::new(&[
    FrontPoint { prepare: 23497, instructions: 54, reflections: 0, level: QualityLevel::Fast, scale: 4, psnr: 2641, largest: 177 },
    FrontPoint { prepare: 23497, instructions: 70, reflections: 1, level: QualityLevel::Fast, scale: 4, psnr: 2677, largest: 178 },
    FrontPoint { prepare: 23618, instructions: 159, reflections: 0, level: QualityLevel::Fast, scale: 2, psnr: 2935, largest: 163 },
    FrontPoint { prepare: 23618, instructions: 211, reflections: 1, level: QualityLevel::Fast, scale: 2, psnr: 2980, largest: 173 },
    FrontPoint { prepare: 23702, instructions: 464, reflections: 0, level: QualityLevel::Fast, scale: 1, psnr: 3823, largest: 56 },
    FrontPoint { prepare: 23702, instructions: 647, reflections: 1, level: QualityLevel::Fast, scale: 1, psnr: 5750, largest: 16 },
    FrontPoint { prepare: 23702, instructions: 700, reflections: 2, level: QualityLevel::Fast, scale: 1, psnr: 7986, largest: 2 },
    FrontPoint { prepare: 23702, instructions: 712, reflections: 3, level: QualityLevel::Fast, scale: 1, psnr: 8162, largest: 1 },
    FrontPoint { prepare: 23702, instructions: 886, reflections: 2, level: QualityLevel::Fine, scale: 1, psnr: 8249, largest: 2 },
    FrontPoint { prepare: 23702, instructions: 898, reflections: 3, level: QualityLevel::Fine, scale: 1, psnr: 8659, largest: 1 },
]);
/// mirror1
pub const MIRROR1: ParetoFront = ParetoFront::new(&[
    FrontPoint { prepare: 16293, instructions: 40, reflections: 0, level: QualityLevel::Fast, scale: 4, psnr: 1568, largest: 255 },
    FrontPoint { prepare: 16293, instructions: 68, reflections: 1, level: QualityLevel::Fast, scale: 4, psnr: 2282, largest: 255 },
    FrontPoint { prepare: 16293, instructions: 212, reflections: 1, level: QualityLevel::Fast, scale: 2, psnr: 2471, largest: 234 },
    FrontPoint { prepare: 16293, instructions: 261, reflections: 1, level: QualityLevel::Fine, scale: 2, psnr: 2508, largest: 234 },
    FrontPoint { prepare: 16293, instructions: 652, reflections: 1, level: QualityLevel::Fast, scale: 1, psnr: 4362, largest: 47 },
    FrontPoint { prepare: 16293, instructions: 821, reflections: 2, level: QualityLevel::Fast, scale: 1, psnr: 5683, largest: 16 },
    FrontPoint { prepare: 16293, instructions: 850, reflections: 3, level: QualityLevel::Fast, scale: 1, psnr: 7094, largest: 4 },
    FrontPoint { prepare: 16293, instructions: 855, reflections: 4, level: QualityLevel::Fast, scale: 1, psnr: 7235, largest: 4 },
    FrontPoint { prepare: 16293, instructions: 993, reflections: 3, level: QualityLevel::Fine, scale: 1, psnr: 7496, largest: 3 },
    FrontPoint { prepare: 16293, instructions: 1001, reflections: 4, level: QualityLevel::Fine, scale: 1, psnr: 8182, largest: 1 },
    FrontPoint { prepare: 16293, instructions: 1003, reflections: 5, level: QualityLevel::Fine, scale: 1, psnr: 8249, largest: 1 },
]);
/// mirror2
pub const MIRROR2: ParetoFront = ParetoFront::new(&[
    FrontPoint { prepare: 25125, instructions: 43, reflections: 0, level: QualityLevel::Fast, scale: 4, psnr: 1782, largest: 251 },
    FrontPoint { prepare: 25125, instructions: 91, reflections: 1, level: QualityLevel::Fast, scale: 4, psnr: 2038, largest: 224 },
    FrontPoint { prepare: 25125, instructions: 144, reflections: 2, level: QualityLevel::Fast, scale: 4, psnr: 2214, largest: 224 },
    FrontPoint { prepare: 25125, instructions: 180, reflections: 3, level: QualityLevel::Fast, scale: 4, psnr: 2318, largest: 224 },
    FrontPoint { prepare: 25101, instructions: 408, reflections: 2, level: QualityLevel::Fast, scale: 2, psnr: 2374, largest: 224 },
    FrontPoint { prepare: 25101, instructions: 520, reflections: 3, level: QualityLevel::Fast, scale: 2, psnr: 2555, largest: 224 },
    FrontPoint { prepare: 25101, instructions: 661, reflections: 3, level: QualityLevel::Fine, scale: 2, psnr: 2601, largest: 224 },
    FrontPoint { prepare: 24344, instructions: 1230, reflections: 2, level: QualityLevel::Fast, scale: 1, psnr: 2766, largest: 164 },
    FrontPoint { prepare: 24344, instructions: 1585, reflections: 3, level: QualityLevel::Fast, scale: 1, psnr: 4723, largest: 115 },
    FrontPoint { prepare: 24344, instructions: 1712, reflections: 4, level: QualityLevel::Fast, scale: 1, psnr: 4819, largest: 115 },
    FrontPoint { prepare: 24344, instructions: 2265, reflections: 3, level: QualityLevel::Fine, scale: 1, psnr: 5376, largest: 26 },
    FrontPoint { prepare: 24344, instructions: 2422, reflections: 4, level: QualityLevel::Fine, scale: 1, psnr: 6303, largest: 14 },
    FrontPoint { prepare: 24344, instructions: 2452, reflections: 5, level: QualityLevel::Fine, scale: 1, psnr: 6781, largest: 14 },
    FrontPoint { prepare: 24344, instructions: 2465, reflections: 6, level: QualityLevel::Fine, scale: 1, psnr: 6929, largest: 14 },
]);
/// primitives
pub const PRIMITIVES: ParetoFront = ParetoFront::new(&[
    FrontPoint { prepare: 6727, instructions: 30, reflections: 0, level: QualityLevel::Fast, scale: 4, psnr: 1923, largest: 255 },
    FrontPoint { prepare: 6727, instructions: 46, reflections: 1, level: QualityLevel::Fast, scale: 4, psnr: 2343, largest: 196 },
    FrontPoint { prepare: 6727, instructions: 141, reflections: 1, level: QualityLevel::Fast, scale: 2, psnr: 2658, largest: 212 },
    FrontPoint { prepare: 6727, instructions: 438, reflections: 1, level: QualityLevel::Fast, scale: 1, psnr: 4298, largest: 86 },
    FrontPoint { prepare: 6727, instructions: 473, reflections: 2, level: QualityLevel::Fast, scale: 1, psnr: 5711, largest: 20 },
    FrontPoint { prepare: 6727, instructions: 485, reflections: 3, level: QualityLevel::Fast, scale: 1, psnr: 6554, largest: 12 },
    FrontPoint { prepare: 6727, instructions: 487, reflections: 4, level: QualityLevel::Fast, scale: 1, psnr: 6582, largest: 12 },
    FrontPoint { prepare: 6727, instructions: 702, reflections: 3, level: QualityLevel::Fine, scale: 1, psnr: 6931, largest: 11 },
    FrontPoint { prepare: 6727, instructions: 704, reflections: 4, level: QualityLevel::Fine, scale: 1, psnr: 7003, largest: 11 },
]);
/// empty
pub const EMPTY: ParetoFront = ParetoFront::new(&[
    FrontPoint { prepare: 180, instructions: 2, reflections: 0, level: QualityLevel::Fast, scale: 1, psnr: 65535, largest: 0 },
]);
/// floor
pub const FLOOR: ParetoFront = ParetoFront::new(&[
    FrontPoint { prepare: 416, instructions: 11, reflections: 0, level: QualityLevel::Fine, scale: 4, psnr: 2432, largest: 124 },
    FrontPoint { prepare: 416, instructions: 41, reflections: 0, level: QualityLevel::Fine, scale: 2, psnr: 65535, largest: 0 },
]);
/// corner1
pub const CORNER1: ParetoFront = ParetoFront::new(&[
    FrontPoint { prepare: 729, instructions: 20, reflections: 0, level: QualityLevel::Fast, scale: 4, psnr: 3026, largest: 101 },
    FrontPoint { prepare: 729, instructions: 61, reflections: 0, level: QualityLevel::Fast, scale: 2, psnr: 3777, largest: 66 },
    FrontPoint { prepare: 729, instructions: 185, reflections: 0, level: QualityLevel::Fine, scale: 1, psnr: 6024, largest: 43 },
]);
/// cylinders
pub const CYLINDERS: ParetoFront = ParetoFront::new(&[
    FrontPoint { prepare: 4711, instructions: 19, reflections: 0, level: QualityLevel::Fast, scale: 4, psnr: 1996, largest: 255 },
    FrontPoint { prepare: 4711, instructions: 20, reflections: 0, level: QualityLevel::Fine, scale: 4, psnr: 2041, largest: 255 },
    FrontPoint { prepare: 4678, instructions: 60, reflections: 0, level: QualityLevel::Fast, scale: 2, psnr: 2395, largest: 255 },
    FrontPoint { prepare: 4678, instructions: 146, reflections: 0, level: QualityLevel::Fast, scale: 1, psnr: 3907, largest: 35 },
    FrontPoint { prepare: 4678, instructions: 224, reflections: 1, level: QualityLevel::Fast, scale: 1, psnr: 6296, largest: 6 },
    FrontPoint { prepare: 4678, instructions: 263, reflections: 2, level: QualityLevel::Fast, scale: 1, psnr: 7601, largest: 6 },
    FrontPoint { prepare: 4678, instructions: 280, reflections: 2, level: QualityLevel::Fine, scale: 1, psnr: 7973, largest: 1 },
    FrontPoint { prepare: 4678, instructions: 298, reflections: 3, level: QualityLevel::Fine, scale: 1, psnr: 9504, largest: 1 },
]);
