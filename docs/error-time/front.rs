// Written by `cargo run --release --package report -- --core m3 --size 128x128`:
// what is best for a frame of so many instructions. Include it where `ParetoFront`, `FrontPoint` and
// `QualityLevel` are in scope.
/// castle
pub const CASTLE: ParetoFront = ParetoFront::new(&[
    FrontPoint { prepare: 87224, instructions: 75, reflections: 0, level: QualityLevel::Exact, scale: 4, psnr: 1309, largest: 231 },
    FrontPoint { prepare: 87224, instructions: 113, reflections: 1, level: QualityLevel::Exact, scale: 4, psnr: 2177, largest: 231 },
    FrontPoint { prepare: 86404, instructions: 383, reflections: 1, level: QualityLevel::Fast, scale: 2, psnr: 2550, largest: 211 },
    FrontPoint { prepare: 86243, instructions: 1210, reflections: 1, level: QualityLevel::Fast, scale: 1, psnr: 4252, largest: 76 },
    FrontPoint { prepare: 86243, instructions: 1236, reflections: 2, level: QualityLevel::Fast, scale: 1, psnr: 5909, largest: 16 },
    FrontPoint { prepare: 86243, instructions: 1240, reflections: 3, level: QualityLevel::Fast, scale: 1, psnr: 7788, largest: 3 },
    FrontPoint { prepare: 86243, instructions: 1442, reflections: 3, level: QualityLevel::Exact, scale: 1, psnr: 8425, largest: 3 },
]);
/// shading_lights
pub const SHADING_LIGHTS: ParetoFront = ParetoFront::new(&[
    FrontPoint { prepare: 2491, instructions: 49, reflections: 0, level: QualityLevel::Exact, scale: 4, psnr: 2214, largest: 184 },
    FrontPoint { prepare: 2491, instructions: 65, reflections: 1, level: QualityLevel::Exact, scale: 4, psnr: 2658, largest: 181 },
    FrontPoint { prepare: 2491, instructions: 252, reflections: 1, level: QualityLevel::Exact, scale: 2, psnr: 2889, largest: 180 },
    FrontPoint { prepare: 2491, instructions: 738, reflections: 1, level: QualityLevel::Fast, scale: 1, psnr: 6915, largest: 1 },
    FrontPoint { prepare: 2491, instructions: 954, reflections: 1, level: QualityLevel::Exact, scale: 1, psnr: 65535, largest: 0 },
]);
/// shading_speculars
pub const SHADING_SPECULARS: ParetoFront = ParetoFront::new(&[
    FrontPoint { prepare: 9647, instructions: 49, reflections: 0, level: QualityLevel::Exact, scale: 4, psnr: 1870, largest: 173 },
    FrontPoint { prepare: 9647, instructions: 70, reflections: 1, level: QualityLevel::Exact, scale: 4, psnr: 2228, largest: 147 },
    FrontPoint { prepare: 9647, instructions: 246, reflections: 1, level: QualityLevel::Fast, scale: 2, psnr: 2618, largest: 155 },
    FrontPoint { prepare: 9647, instructions: 728, reflections: 1, level: QualityLevel::Fast, scale: 1, psnr: 4776, largest: 10 },
    FrontPoint { prepare: 9647, instructions: 780, reflections: 2, level: QualityLevel::Fast, scale: 1, psnr: 6422, largest: 2 },
    FrontPoint { prepare: 9647, instructions: 793, reflections: 3, level: QualityLevel::Fast, scale: 1, psnr: 6717, largest: 1 },
    FrontPoint { prepare: 9647, instructions: 1048, reflections: 3, level: QualityLevel::Exact, scale: 1, psnr: 8203, largest: 1 },
    FrontPoint { prepare: 9647, instructions: 1050, reflections: 4, level: QualityLevel::Exact, scale: 1, psnr: 65535, largest: 0 },
]);
/// columns
pub const COLUMNS: ParetoFront = ParetoFront::new(&[
    FrontPoint { prepare: 22893, instructions: 68, reflections: 0, level: QualityLevel::Exact, scale: 4, psnr: 2647, largest: 177 },
    FrontPoint { prepare: 22893, instructions: 90, reflections: 1, level: QualityLevel::Exact, scale: 4, psnr: 2677, largest: 178 },
    FrontPoint { prepare: 23024, instructions: 244, reflections: 0, level: QualityLevel::Exact, scale: 2, psnr: 2936, largest: 163 },
    FrontPoint { prepare: 23024, instructions: 309, reflections: 1, level: QualityLevel::Exact, scale: 2, psnr: 2980, largest: 173 },
    FrontPoint { prepare: 23118, instructions: 758, reflections: 0, level: QualityLevel::Fast, scale: 1, psnr: 3829, largest: 56 },
    FrontPoint { prepare: 23118, instructions: 968, reflections: 1, level: QualityLevel::Fast, scale: 1, psnr: 5797, largest: 16 },
    FrontPoint { prepare: 23118, instructions: 1022, reflections: 2, level: QualityLevel::Fast, scale: 1, psnr: 7421, largest: 2 },
    FrontPoint { prepare: 23118, instructions: 1034, reflections: 3, level: QualityLevel::Fast, scale: 1, psnr: 7463, largest: 1 },
    FrontPoint { prepare: 23118, instructions: 1158, reflections: 2, level: QualityLevel::Exact, scale: 1, psnr: 8425, largest: 2 },
    FrontPoint { prepare: 23118, instructions: 1170, reflections: 3, level: QualityLevel::Exact, scale: 1, psnr: 65535, largest: 0 },
]);
/// mirror1
pub const MIRROR1: ParetoFront = ParetoFront::new(&[
    FrontPoint { prepare: 13772, instructions: 55, reflections: 0, level: QualityLevel::Exact, scale: 4, psnr: 1574, largest: 255 },
    FrontPoint { prepare: 13772, instructions: 81, reflections: 1, level: QualityLevel::Exact, scale: 4, psnr: 2297, largest: 255 },
    FrontPoint { prepare: 13772, instructions: 305, reflections: 1, level: QualityLevel::Exact, scale: 2, psnr: 2508, largest: 234 },
    FrontPoint { prepare: 13772, instructions: 1089, reflections: 1, level: QualityLevel::Fast, scale: 1, psnr: 4363, largest: 47 },
    FrontPoint { prepare: 13772, instructions: 1196, reflections: 2, level: QualityLevel::Fast, scale: 1, psnr: 5691, largest: 17 },
    FrontPoint { prepare: 13772, instructions: 1221, reflections: 3, level: QualityLevel::Fast, scale: 1, psnr: 7500, largest: 3 },
    FrontPoint { prepare: 13772, instructions: 1226, reflections: 4, level: QualityLevel::Fast, scale: 1, psnr: 8027, largest: 1 },
    FrontPoint { prepare: 13772, instructions: 1274, reflections: 4, level: QualityLevel::Exact, scale: 1, psnr: 9027, largest: 1 },
    FrontPoint { prepare: 13772, instructions: 1275, reflections: 5, level: QualityLevel::Exact, scale: 1, psnr: 65535, largest: 0 },
]);
/// mirror2
pub const MIRROR2: ParetoFront = ParetoFront::new(&[
    FrontPoint { prepare: 21655, instructions: 66, reflections: 0, level: QualityLevel::Exact, scale: 4, psnr: 1790, largest: 251 },
    FrontPoint { prepare: 21655, instructions: 126, reflections: 1, level: QualityLevel::Exact, scale: 4, psnr: 2046, largest: 224 },
    FrontPoint { prepare: 21655, instructions: 189, reflections: 2, level: QualityLevel::Exact, scale: 4, psnr: 2226, largest: 224 },
    FrontPoint { prepare: 21655, instructions: 230, reflections: 3, level: QualityLevel::Exact, scale: 4, psnr: 2334, largest: 224 },
    FrontPoint { prepare: 21655, instructions: 732, reflections: 2, level: QualityLevel::Exact, scale: 2, psnr: 2403, largest: 224 },
    FrontPoint { prepare: 21655, instructions: 906, reflections: 3, level: QualityLevel::Exact, scale: 2, psnr: 2601, largest: 224 },
    FrontPoint { prepare: 21649, instructions: 2204, reflections: 2, level: QualityLevel::Fast, scale: 1, psnr: 2770, largest: 164 },
    FrontPoint { prepare: 21649, instructions: 2982, reflections: 3, level: QualityLevel::Fast, scale: 1, psnr: 5384, largest: 26 },
    FrontPoint { prepare: 21649, instructions: 3158, reflections: 4, level: QualityLevel::Fast, scale: 1, psnr: 6379, largest: 12 },
    FrontPoint { prepare: 21649, instructions: 3182, reflections: 5, level: QualityLevel::Fast, scale: 1, psnr: 7062, largest: 6 },
    FrontPoint { prepare: 21649, instructions: 3192, reflections: 6, level: QualityLevel::Fast, scale: 1, psnr: 7404, largest: 2 },
    FrontPoint { prepare: 21649, instructions: 3195, reflections: 8, level: QualityLevel::Fast, scale: 1, psnr: 7436, largest: 1 },
    FrontPoint { prepare: 21649, instructions: 3754, reflections: 6, level: QualityLevel::Exact, scale: 1, psnr: 8504, largest: 2 },
    FrontPoint { prepare: 21649, instructions: 3758, reflections: 7, level: QualityLevel::Exact, scale: 1, psnr: 9027, largest: 1 },
    FrontPoint { prepare: 21649, instructions: 3759, reflections: 8, level: QualityLevel::Exact, scale: 1, psnr: 9504, largest: 1 },
]);
/// primitives
pub const PRIMITIVES: ParetoFront = ParetoFront::new(&[
    FrontPoint { prepare: 5858, instructions: 51, reflections: 0, level: QualityLevel::Exact, scale: 4, psnr: 1923, largest: 255 },
    FrontPoint { prepare: 5858, instructions: 71, reflections: 1, level: QualityLevel::Exact, scale: 4, psnr: 2343, largest: 196 },
    FrontPoint { prepare: 5858, instructions: 239, reflections: 1, level: QualityLevel::Fast, scale: 2, psnr: 2659, largest: 212 },
    FrontPoint { prepare: 5858, instructions: 754, reflections: 1, level: QualityLevel::Fast, scale: 1, psnr: 4326, largest: 20 },
    FrontPoint { prepare: 5858, instructions: 796, reflections: 2, level: QualityLevel::Fast, scale: 1, psnr: 5820, largest: 20 },
    FrontPoint { prepare: 5858, instructions: 805, reflections: 3, level: QualityLevel::Fast, scale: 1, psnr: 7550, largest: 3 },
    FrontPoint { prepare: 5858, instructions: 806, reflections: 4, level: QualityLevel::Fast, scale: 1, psnr: 7986, largest: 1 },
    FrontPoint { prepare: 5858, instructions: 1027, reflections: 4, level: QualityLevel::Exact, scale: 1, psnr: 65535, largest: 0 },
]);
/// empty
pub const EMPTY: ParetoFront = ParetoFront::new(&[
    FrontPoint { prepare: 181, instructions: 2, reflections: 0, level: QualityLevel::Fast, scale: 1, psnr: 65535, largest: 0 },
]);
/// floor
pub const FLOOR: ParetoFront = ParetoFront::new(&[
    FrontPoint { prepare: 434, instructions: 12, reflections: 0, level: QualityLevel::Fast, scale: 4, psnr: 2432, largest: 124 },
    FrontPoint { prepare: 434, instructions: 38, reflections: 0, level: QualityLevel::Fast, scale: 2, psnr: 65535, largest: 0 },
]);
/// corner1
pub const CORNER1: ParetoFront = ParetoFront::new(&[
    FrontPoint { prepare: 747, instructions: 31, reflections: 0, level: QualityLevel::Exact, scale: 4, psnr: 3026, largest: 101 },
    FrontPoint { prepare: 747, instructions: 85, reflections: 0, level: QualityLevel::Fast, scale: 2, psnr: 3777, largest: 66 },
    FrontPoint { prepare: 747, instructions: 198, reflections: 0, level: QualityLevel::Fast, scale: 1, psnr: 6003, largest: 43 },
]);
/// cylinders
pub const CYLINDERS: ParetoFront = ParetoFront::new(&[
    FrontPoint { prepare: 4570, instructions: 26, reflections: 0, level: QualityLevel::Fast, scale: 4, psnr: 2041, largest: 255 },
    FrontPoint { prepare: 4570, instructions: 77, reflections: 0, level: QualityLevel::Fast, scale: 2, psnr: 2410, largest: 255 },
    FrontPoint { prepare: 4570, instructions: 213, reflections: 0, level: QualityLevel::Fast, scale: 1, psnr: 3907, largest: 35 },
    FrontPoint { prepare: 4570, instructions: 281, reflections: 1, level: QualityLevel::Fast, scale: 1, psnr: 6310, largest: 3 },
    FrontPoint { prepare: 4570, instructions: 316, reflections: 2, level: QualityLevel::Fast, scale: 1, psnr: 7986, largest: 1 },
    FrontPoint { prepare: 4570, instructions: 425, reflections: 3, level: QualityLevel::Exact, scale: 1, psnr: 65535, largest: 0 },
]);
