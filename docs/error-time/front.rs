// Written by `cargo run --release --package report -- --core m3 --size 128x128`:
// what is best for a frame of so many instructions. Include it where `ParetoFront`, `FrontPoint` and
// `QualityLevel` are in scope.
/// castle
pub const CASTLE: ParetoFront = ParetoFront::new(&[
    FrontPoint { prepare: 88788, instructions: 74, reflections: 0, level: QualityLevel::Fast, scale: 4, psnr: 1309, largest: 231 },
    FrontPoint { prepare: 88788, instructions: 111, reflections: 1, level: QualityLevel::Exact, scale: 4, psnr: 2177, largest: 231 },
    FrontPoint { prepare: 87972, instructions: 355, reflections: 1, level: QualityLevel::Fast, scale: 2, psnr: 2550, largest: 211 },
    FrontPoint { prepare: 87805, instructions: 1096, reflections: 1, level: QualityLevel::Fast, scale: 1, psnr: 4252, largest: 76 },
    FrontPoint { prepare: 87805, instructions: 1123, reflections: 2, level: QualityLevel::Fast, scale: 1, psnr: 5906, largest: 16 },
    FrontPoint { prepare: 87805, instructions: 1126, reflections: 3, level: QualityLevel::Fast, scale: 1, psnr: 7629, largest: 3 },
    FrontPoint { prepare: 87805, instructions: 1401, reflections: 3, level: QualityLevel::Exact, scale: 1, psnr: 8425, largest: 3 },
]);
/// shading_lights
pub const SHADING_LIGHTS: ParetoFront = ParetoFront::new(&[
    FrontPoint { prepare: 2269, instructions: 49, reflections: 0, level: QualityLevel::Exact, scale: 4, psnr: 2214, largest: 184 },
    FrontPoint { prepare: 2269, instructions: 65, reflections: 1, level: QualityLevel::Exact, scale: 4, psnr: 2658, largest: 181 },
    FrontPoint { prepare: 2269, instructions: 228, reflections: 1, level: QualityLevel::Fast, scale: 2, psnr: 2889, largest: 180 },
    FrontPoint { prepare: 2269, instructions: 689, reflections: 1, level: QualityLevel::Fast, scale: 1, psnr: 6906, largest: 1 },
    FrontPoint { prepare: 2269, instructions: 954, reflections: 1, level: QualityLevel::Exact, scale: 1, psnr: 65535, largest: 0 },
]);
/// shading_speculars
pub const SHADING_SPECULARS: ParetoFront = ParetoFront::new(&[
    FrontPoint { prepare: 9573, instructions: 49, reflections: 0, level: QualityLevel::Exact, scale: 4, psnr: 1870, largest: 173 },
    FrontPoint { prepare: 9573, instructions: 70, reflections: 1, level: QualityLevel::Exact, scale: 4, psnr: 2228, largest: 147 },
    FrontPoint { prepare: 9573, instructions: 227, reflections: 1, level: QualityLevel::Fast, scale: 2, psnr: 2618, largest: 155 },
    FrontPoint { prepare: 9573, instructions: 707, reflections: 1, level: QualityLevel::Fast, scale: 1, psnr: 4775, largest: 10 },
    FrontPoint { prepare: 9573, instructions: 759, reflections: 2, level: QualityLevel::Fast, scale: 1, psnr: 6384, largest: 2 },
    FrontPoint { prepare: 9573, instructions: 772, reflections: 3, level: QualityLevel::Fast, scale: 1, psnr: 6643, largest: 2 },
    FrontPoint { prepare: 9573, instructions: 1034, reflections: 2, level: QualityLevel::Exact, scale: 1, psnr: 6716, largest: 2 },
    FrontPoint { prepare: 9573, instructions: 1047, reflections: 3, level: QualityLevel::Exact, scale: 1, psnr: 8203, largest: 1 },
    FrontPoint { prepare: 9573, instructions: 1049, reflections: 4, level: QualityLevel::Exact, scale: 1, psnr: 65535, largest: 0 },
]);
/// columns
pub const COLUMNS: ParetoFront = ParetoFront::new(&[
    FrontPoint { prepare: 22597, instructions: 68, reflections: 0, level: QualityLevel::Exact, scale: 4, psnr: 2647, largest: 177 },
    FrontPoint { prepare: 22597, instructions: 91, reflections: 1, level: QualityLevel::Exact, scale: 4, psnr: 2677, largest: 178 },
    FrontPoint { prepare: 22724, instructions: 244, reflections: 0, level: QualityLevel::Exact, scale: 2, psnr: 2936, largest: 163 },
    FrontPoint { prepare: 22724, instructions: 309, reflections: 1, level: QualityLevel::Exact, scale: 2, psnr: 2980, largest: 173 },
    FrontPoint { prepare: 22812, instructions: 747, reflections: 0, level: QualityLevel::Fast, scale: 1, psnr: 3829, largest: 56 },
    FrontPoint { prepare: 22812, instructions: 947, reflections: 1, level: QualityLevel::Fast, scale: 1, psnr: 5795, largest: 16 },
    FrontPoint { prepare: 22812, instructions: 1002, reflections: 2, level: QualityLevel::Fast, scale: 1, psnr: 7337, largest: 2 },
    FrontPoint { prepare: 22812, instructions: 1015, reflections: 3, level: QualityLevel::Fast, scale: 1, psnr: 7371, largest: 1 },
    FrontPoint { prepare: 22812, instructions: 1161, reflections: 2, level: QualityLevel::Exact, scale: 1, psnr: 8425, largest: 2 },
    FrontPoint { prepare: 22812, instructions: 1173, reflections: 3, level: QualityLevel::Exact, scale: 1, psnr: 65535, largest: 0 },
]);
/// mirror1
pub const MIRROR1: ParetoFront = ParetoFront::new(&[
    FrontPoint { prepare: 13827, instructions: 55, reflections: 0, level: QualityLevel::Exact, scale: 4, psnr: 1574, largest: 255 },
    FrontPoint { prepare: 13827, instructions: 81, reflections: 1, level: QualityLevel::Exact, scale: 4, psnr: 2297, largest: 255 },
    FrontPoint { prepare: 13827, instructions: 304, reflections: 1, level: QualityLevel::Exact, scale: 2, psnr: 2508, largest: 234 },
    FrontPoint { prepare: 13827, instructions: 995, reflections: 1, level: QualityLevel::Fast, scale: 1, psnr: 4363, largest: 47 },
    FrontPoint { prepare: 13827, instructions: 1172, reflections: 2, level: QualityLevel::Fast, scale: 1, psnr: 5691, largest: 17 },
    FrontPoint { prepare: 13827, instructions: 1197, reflections: 3, level: QualityLevel::Fast, scale: 1, psnr: 7475, largest: 3 },
    FrontPoint { prepare: 13827, instructions: 1201, reflections: 4, level: QualityLevel::Fast, scale: 1, psnr: 7948, largest: 1 },
    FrontPoint { prepare: 13827, instructions: 1271, reflections: 4, level: QualityLevel::Exact, scale: 1, psnr: 9027, largest: 1 },
    FrontPoint { prepare: 13827, instructions: 1273, reflections: 5, level: QualityLevel::Exact, scale: 1, psnr: 65535, largest: 0 },
]);
/// mirror2
pub const MIRROR2: ParetoFront = ParetoFront::new(&[
    FrontPoint { prepare: 21767, instructions: 66, reflections: 0, level: QualityLevel::Exact, scale: 4, psnr: 1790, largest: 251 },
    FrontPoint { prepare: 21767, instructions: 126, reflections: 1, level: QualityLevel::Exact, scale: 4, psnr: 2046, largest: 224 },
    FrontPoint { prepare: 21767, instructions: 189, reflections: 2, level: QualityLevel::Exact, scale: 4, psnr: 2226, largest: 224 },
    FrontPoint { prepare: 21767, instructions: 230, reflections: 3, level: QualityLevel::Exact, scale: 4, psnr: 2334, largest: 224 },
    FrontPoint { prepare: 21767, instructions: 718, reflections: 2, level: QualityLevel::Fast, scale: 2, psnr: 2403, largest: 224 },
    FrontPoint { prepare: 21767, instructions: 903, reflections: 3, level: QualityLevel::Exact, scale: 2, psnr: 2601, largest: 224 },
    FrontPoint { prepare: 21761, instructions: 2065, reflections: 2, level: QualityLevel::Fast, scale: 1, psnr: 2770, largest: 164 },
    FrontPoint { prepare: 21761, instructions: 2694, reflections: 3, level: QualityLevel::Fast, scale: 1, psnr: 5383, largest: 26 },
    FrontPoint { prepare: 21761, instructions: 2856, reflections: 4, level: QualityLevel::Fast, scale: 1, psnr: 6370, largest: 12 },
    FrontPoint { prepare: 21761, instructions: 2879, reflections: 5, level: QualityLevel::Fast, scale: 1, psnr: 7017, largest: 6 },
    FrontPoint { prepare: 21761, instructions: 2889, reflections: 6, level: QualityLevel::Fast, scale: 1, psnr: 7311, largest: 2 },
    FrontPoint { prepare: 21761, instructions: 2892, reflections: 8, level: QualityLevel::Fast, scale: 1, psnr: 7337, largest: 1 },
    FrontPoint { prepare: 21761, instructions: 3748, reflections: 6, level: QualityLevel::Exact, scale: 1, psnr: 8504, largest: 2 },
    FrontPoint { prepare: 21761, instructions: 3752, reflections: 7, level: QualityLevel::Exact, scale: 1, psnr: 9027, largest: 1 },
    FrontPoint { prepare: 21761, instructions: 3753, reflections: 8, level: QualityLevel::Exact, scale: 1, psnr: 9504, largest: 1 },
]);
/// primitives
pub const PRIMITIVES: ParetoFront = ParetoFront::new(&[
    FrontPoint { prepare: 5299, instructions: 50, reflections: 0, level: QualityLevel::Fast, scale: 4, psnr: 1923, largest: 255 },
    FrontPoint { prepare: 5299, instructions: 71, reflections: 1, level: QualityLevel::Exact, scale: 4, psnr: 2343, largest: 196 },
    FrontPoint { prepare: 5299, instructions: 232, reflections: 1, level: QualityLevel::Fast, scale: 2, psnr: 2659, largest: 212 },
    FrontPoint { prepare: 5299, instructions: 691, reflections: 1, level: QualityLevel::Fast, scale: 1, psnr: 4326, largest: 20 },
    FrontPoint { prepare: 5299, instructions: 728, reflections: 2, level: QualityLevel::Fast, scale: 1, psnr: 5817, largest: 20 },
    FrontPoint { prepare: 5299, instructions: 737, reflections: 3, level: QualityLevel::Fast, scale: 1, psnr: 7443, largest: 3 },
    FrontPoint { prepare: 5299, instructions: 738, reflections: 4, level: QualityLevel::Fast, scale: 1, psnr: 7741, largest: 1 },
    FrontPoint { prepare: 5299, instructions: 1027, reflections: 4, level: QualityLevel::Exact, scale: 1, psnr: 65535, largest: 0 },
]);
/// empty
pub const EMPTY: ParetoFront = ParetoFront::new(&[
    FrontPoint { prepare: 181, instructions: 2, reflections: 0, level: QualityLevel::Fast, scale: 1, psnr: 65535, largest: 0 },
]);
/// floor
pub const FLOOR: ParetoFront = ParetoFront::new(&[
    FrontPoint { prepare: 434, instructions: 12, reflections: 0, level: QualityLevel::Fast, scale: 4, psnr: 2432, largest: 124 },
    FrontPoint { prepare: 434, instructions: 39, reflections: 0, level: QualityLevel::Fast, scale: 2, psnr: 65535, largest: 0 },
]);
/// corner1
pub const CORNER1: ParetoFront = ParetoFront::new(&[
    FrontPoint { prepare: 522, instructions: 29, reflections: 0, level: QualityLevel::Fast, scale: 4, psnr: 3026, largest: 101 },
    FrontPoint { prepare: 522, instructions: 83, reflections: 0, level: QualityLevel::Fast, scale: 2, psnr: 3777, largest: 66 },
    FrontPoint { prepare: 522, instructions: 211, reflections: 0, level: QualityLevel::Fast, scale: 1, psnr: 6003, largest: 43 },
]);
/// cylinders
pub const CYLINDERS: ParetoFront = ParetoFront::new(&[
    FrontPoint { prepare: 4546, instructions: 26, reflections: 0, level: QualityLevel::Fast, scale: 4, psnr: 2041, largest: 255 },
    FrontPoint { prepare: 4546, instructions: 77, reflections: 0, level: QualityLevel::Fast, scale: 2, psnr: 2410, largest: 255 },
    FrontPoint { prepare: 4546, instructions: 213, reflections: 0, level: QualityLevel::Fast, scale: 1, psnr: 3907, largest: 35 },
    FrontPoint { prepare: 4546, instructions: 281, reflections: 1, level: QualityLevel::Fast, scale: 1, psnr: 6310, largest: 3 },
    FrontPoint { prepare: 4546, instructions: 316, reflections: 2, level: QualityLevel::Fast, scale: 1, psnr: 7986, largest: 1 },
    FrontPoint { prepare: 4546, instructions: 429, reflections: 3, level: QualityLevel::Exact, scale: 1, psnr: 65535, largest: 0 },
]);
