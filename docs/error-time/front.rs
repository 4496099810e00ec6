// Written by `cargo run --release --package report -- --core m3 --size 128x128`:
// what is best for a frame of so many instructions. Include it where `ParetoFront`, `FrontPoint` and
// `QualityLevel` are in scope.
/// castle
pub const CASTLE: ParetoFront = ParetoFront::new(&[
    FrontPoint { prepare: 88788, instructions: 75, reflections: 0, level: QualityLevel::Fast, scale: 4, psnr: 1309, largest: 231 },
    FrontPoint { prepare: 88788, instructions: 113, reflections: 1, level: QualityLevel::Exact, scale: 4, psnr: 2177, largest: 231 },
    FrontPoint { prepare: 87972, instructions: 357, reflections: 1, level: QualityLevel::Fast, scale: 2, psnr: 2550, largest: 211 },
    FrontPoint { prepare: 87805, instructions: 1103, reflections: 1, level: QualityLevel::Fast, scale: 1, psnr: 4252, largest: 76 },
    FrontPoint { prepare: 87805, instructions: 1130, reflections: 2, level: QualityLevel::Fast, scale: 1, psnr: 5906, largest: 16 },
    FrontPoint { prepare: 87805, instructions: 1133, reflections: 3, level: QualityLevel::Fast, scale: 1, psnr: 7629, largest: 3 },
    FrontPoint { prepare: 87805, instructions: 1134, reflections: 4, level: QualityLevel::Fast, scale: 1, psnr: 7698, largest: 1 },
    FrontPoint { prepare: 87805, instructions: 1421, reflections: 3, level: QualityLevel::Exact, scale: 1, psnr: 8425, largest: 3 },
]);
/// shading_lights
pub const SHADING_LIGHTS: ParetoFront = ParetoFront::new(&[
    FrontPoint { prepare: 2269, instructions: 49, reflections: 0, level: QualityLevel::Exact, scale: 4, psnr: 2214, largest: 184 },
    FrontPoint { prepare: 2269, instructions: 65, reflections: 1, level: QualityLevel::Exact, scale: 4, psnr: 2658, largest: 181 },
    FrontPoint { prepare: 2269, instructions: 232, reflections: 1, level: QualityLevel::Fast, scale: 2, psnr: 2889, largest: 180 },
    FrontPoint { prepare: 2269, instructions: 713, reflections: 1, level: QualityLevel::Fast, scale: 1, psnr: 6906, largest: 1 },
    FrontPoint { prepare: 2269, instructions: 957, reflections: 1, level: QualityLevel::Exact, scale: 1, psnr: 65535, largest: 0 },
]);
/// shading_speculars
pub const SHADING_SPECULARS: ParetoFront = ParetoFront::new(&[
    FrontPoint { prepare: 9573, instructions: 48, reflections: 0, level: QualityLevel::Exact, scale: 4, psnr: 1870, largest: 173 },
    FrontPoint { prepare: 9573, instructions: 69, reflections: 1, level: QualityLevel::Exact, scale: 4, psnr: 2228, largest: 147 },
    FrontPoint { prepare: 9573, instructions: 229, reflections: 1, level: QualityLevel::Fast, scale: 2, psnr: 2618, largest: 155 },
    FrontPoint { prepare: 9573, instructions: 715, reflections: 1, level: QualityLevel::Fast, scale: 1, psnr: 4775, largest: 10 },
    FrontPoint { prepare: 9573, instructions: 767, reflections: 2, level: QualityLevel::Fast, scale: 1, psnr: 6384, largest: 2 },
    FrontPoint { prepare: 9573, instructions: 780, reflections: 3, level: QualityLevel::Fast, scale: 1, psnr: 6643, largest: 2 },
    FrontPoint { prepare: 9573, instructions: 1021, reflections: 2, level: QualityLevel::Exact, scale: 1, psnr: 6716, largest: 2 },
    FrontPoint { prepare: 9573, instructions: 1033, reflections: 3, level: QualityLevel::Exact, scale: 1, psnr: 8203, largest: 1 },
    FrontPoint { prepare: 9573, instructions: 1035, reflections: 4, level: QualityLevel::Exact, scale: 1, psnr: 65535, largest: 0 },
]);
/// columns
pub const COLUMNS: ParetoFront = ParetoFront::new(&[
    FrontPoint { prepare: 22597, instructions: 68, reflections: 0, level: QualityLevel::Exact, scale: 4, psnr: 2647, largest: 177 },
    FrontPoint { prepare: 22597, instructions: 91, reflections: 1, level: QualityLevel::Exact, scale: 4, psnr: 2677, largest: 178 },
    FrontPoint { prepare: 22724, instructions: 245, reflections: 0, level: QualityLevel::Exact, scale: 2, psnr: 2936, largest: 163 },
    FrontPoint { prepare: 22724, instructions: 310, reflections: 1, level: QualityLevel::Exact, scale: 2, psnr: 2980, largest: 173 },
    FrontPoint { prepare: 22812, instructions: 751, reflections: 0, level: QualityLevel::Fast, scale: 1, psnr: 3829, largest: 56 },
    FrontPoint { prepare: 22812, instructions: 954, reflections: 1, level: QualityLevel::Fast, scale: 1, psnr: 5795, largest: 16 },
    FrontPoint { prepare: 22812, instructions: 1010, reflections: 2, level: QualityLevel::Fast, scale: 1, psnr: 7337, largest: 2 },
    FrontPoint { prepare: 22812, instructions: 1022, reflections: 3, level: QualityLevel::Fast, scale: 1, psnr: 7371, largest: 1 },
    FrontPoint { prepare: 22812, instructions: 1164, reflections: 2, level: QualityLevel::Exact, scale: 1, psnr: 8425, largest: 2 },
    FrontPoint { prepare: 22812, instructions: 1176, reflections: 3, level: QualityLevel::Exact, scale: 1, psnr: 65535, largest: 0 },
]);
/// mirror1
pub const MIRROR1: ParetoFront = ParetoFront::new(&[
    FrontPoint { prepare: 13827, instructions: 55, reflections: 0, level: QualityLevel::Exact, scale: 4, psnr: 1574, largest: 255 },
    FrontPoint { prepare: 13827, instructions: 80, reflections: 1, level: QualityLevel::Exact, scale: 4, psnr: 2297, largest: 255 },
    FrontPoint { prepare: 13827, instructions: 302, reflections: 1, level: QualityLevel::Exact, scale: 2, psnr: 2508, largest: 234 },
    FrontPoint { prepare: 13827, instructions: 996, reflections: 1, level: QualityLevel::Fast, scale: 1, psnr: 4363, largest: 47 },
    FrontPoint { prepare: 13827, instructions: 1170, reflections: 2, level: QualityLevel::Fast, scale: 1, psnr: 5691, largest: 17 },
    FrontPoint { prepare: 13827, instructions: 1196, reflections: 3, level: QualityLevel::Fast, scale: 1, psnr: 7475, largest: 3 },
    FrontPoint { prepare: 13827, instructions: 1200, reflections: 4, level: QualityLevel::Fast, scale: 1, psnr: 7948, largest: 1 },
    FrontPoint { prepare: 13827, instructions: 1265, reflections: 4, level: QualityLevel::Exact, scale: 1, psnr: 9027, largest: 1 },
    FrontPoint { prepare: 13827, instructions: 1267, reflections: 5, level: QualityLevel::Exact, scale: 1, psnr: 65535, largest: 0 },
]);
/// mirror2
pub const MIRROR2: ParetoFront = ParetoFront::new(&[
    FrontPoint { prepare: 21767, instructions: 66, reflections: 0, level: QualityLevel::Exact, scale: 4, psnr: 1790, largest: 251 },
    FrontPoint { prepare: 21767, instructions: 126, reflections: 1, level: QualityLevel::Exact, scale: 4, psnr: 2046, largest: 224 },
    FrontPoint { prepare: 21767, instructions: 189, reflections: 2, level: QualityLevel::Exact, scale: 4, psnr: 2226, largest: 224 },
    FrontPoint { prepare: 21767, instructions: 230, reflections: 3, level: QualityLevel::Exact, scale: 4, psnr: 2334, largest: 224 },
    FrontPoint { prepare: 21767, instructions: 724, reflections: 2, level: QualityLevel::Fast, scale: 2, psnr: 2403, largest: 224 },
    FrontPoint { prepare: 21767, instructions: 903, reflections: 3, level: QualityLevel::Exact, scale: 2, psnr: 2601, largest: 224 },
    FrontPoint { prepare: 21761, instructions: 2097, reflections: 2, level: QualityLevel::Fast, scale: 1, psnr: 2770, largest: 164 },
    FrontPoint { prepare: 21761, instructions: 2729, reflections: 3, level: QualityLevel::Fast, scale: 1, psnr: 5383, largest: 26 },
    FrontPoint { prepare: 21761, instructions: 2891, reflections: 4, level: QualityLevel::Fast, scale: 1, psnr: 6370, largest: 12 },
    FrontPoint { prepare: 21761, instructions: 2914, reflections: 5, level: QualityLevel::Fast, scale: 1, psnr: 7017, largest: 6 },
    FrontPoint { prepare: 21761, instructions: 2923, reflections: 6, level: QualityLevel::Fast, scale: 1, psnr: 7311, largest: 2 },
    FrontPoint { prepare: 21761, instructions: 2927, reflections: 8, level: QualityLevel::Fast, scale: 1, psnr: 7337, largest: 1 },
    FrontPoint { prepare: 21761, instructions: 3748, reflections: 6, level: QualityLevel::Exact, scale: 1, psnr: 8504, largest: 2 },
    FrontPoint { prepare: 21761, instructions: 3752, reflections: 7, level: QualityLevel::Exact, scale: 1, psnr: 9027, largest: 1 },
    FrontPoint { prepare: 21761, instructions: 3753, reflections: 8, level: QualityLevel::Exact, scale: 1, psnr: 9504, largest: 1 },
]);
/// primitives
pub const PRIMITIVES: ParetoFront = ParetoFront::new(&[
    FrontPoint { prepare: 5299, instructions: 51, reflections: 0, level: QualityLevel::Exact, scale: 4, psnr: 1923, largest: 255 },
    FrontPoint { prepare: 5299, instructions: 71, reflections: 1, level: QualityLevel::Exact, scale: 4, psnr: 2343, largest: 196 },
    FrontPoint { prepare: 5299, instructions: 238, reflections: 1, level: QualityLevel::Fast, scale: 2, psnr: 2659, largest: 212 },
    FrontPoint { prepare: 5299, instructions: 717, reflections: 1, level: QualityLevel::Fast, scale: 1, psnr: 4326, largest: 20 },
    FrontPoint { prepare: 5299, instructions: 754, reflections: 2, level: QualityLevel::Fast, scale: 1, psnr: 5817, largest: 20 },
    FrontPoint { prepare: 5299, instructions: 764, reflections: 3, level: QualityLevel::Fast, scale: 1, psnr: 7443, largest: 3 },
    FrontPoint { prepare: 5299, instructions: 765, reflections: 4, level: QualityLevel::Fast, scale: 1, psnr: 7741, largest: 1 },
    FrontPoint { prepare: 5299, instructions: 1036, reflections: 4, level: QualityLevel::Exact, scale: 1, psnr: 65535, largest: 0 },
]);
/// empty
pub const EMPTY: ParetoFront = ParetoFront::new(&[
    FrontPoint { prepare: 62, instructions: 2, reflections: 0, level: QualityLevel::Fast, scale: 1, psnr: 65535, largest: 0 },
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
    FrontPoint { prepare: 4546, instructions: 426, reflections: 3, level: QualityLevel::Exact, scale: 1, psnr: 65535, largest: 0 },
]);
