// Written by `cargo run --release --package report -- --core m3 --size 128x128`:
// what is best for a frame of so many instructions. Include it where `ParetoFront`, `FrontPoint` and
// `QualityLevel` are in scope.
/// castle
pub const CASTLE: ParetoFront = ParetoFront::new(&[
    FrontPoint { prepare: 88791, instructions: 74, reflections: 0, level: QualityLevel::Fast, scale: 4, psnr: 1309, largest: 231 },
    FrontPoint { prepare: 88791, instructions: 111, reflections: 1, level: QualityLevel::Exact, scale: 4, psnr: 2177, largest: 231 },
    FrontPoint { prepare: 87975, instructions: 355, reflections: 1, level: QualityLevel::Fast, scale: 2, psnr: 2550, largest: 211 },
    FrontPoint { prepare: 87808, instructions: 1088, reflections: 1, level: QualityLevel::Fast, scale: 1, psnr: 4252, largest: 76 },
    FrontPoint { prepare: 87808, instructions: 1114, reflections: 2, level: QualityLevel::Fast, scale: 1, psnr: 5906, largest: 16 },
    FrontPoint { prepare: 87808, instructions: 1118, reflections: 3, level: QualityLevel::Fast, scale: 1, psnr: 7629, largest: 3 },
    FrontPoint { prepare: 87808, instructions: 1402, reflections: 3, level: QualityLevel::Exact, scale: 1, psnr: 8425, largest: 3 },
]);
/// shading_lights
pub const SHADING_LIGHTS: ParetoFront = ParetoFront::new(&[
    FrontPoint { prepare: 2281, instructions: 49, reflections: 0, level: QualityLevel::Exact, scale: 4, psnr: 2214, largest: 184 },
    FrontPoint { prepare: 2281, instructions: 65, reflections: 1, level: QualityLevel::Exact, scale: 4, psnr: 2658, largest: 181 },
    FrontPoint { prepare: 2281, instructions: 226, reflections: 1, level: QualityLevel::Fast, scale: 2, psnr: 2889, largest: 180 },
    FrontPoint { prepare: 2281, instructions: 675, reflections: 1, level: QualityLevel::Fast, scale: 1, psnr: 6906, largest: 1 },
    FrontPoint { prepare: 2281, instructions: 962, reflections: 1, level: QualityLevel::Exact, scale: 1, psnr: 65535, largest: 0 },
]);
/// shading_speculars
pub const SHADING_SPECULARS: ParetoFront = ParetoFront::new(&[
    FrontPoint { prepare: 9576, instructions: 48, reflections: 0, level: QualityLevel::Exact, scale: 4, psnr: 1870, largest: 173 },
    FrontPoint { prepare: 9576, instructions: 69, reflections: 1, level: QualityLevel::Exact, scale: 4, psnr: 2228, largest: 147 },
    FrontPoint { prepare: 9576, instructions: 228, reflections: 1, level: QualityLevel::Fast, scale: 2, psnr: 2618, largest: 155 },
    FrontPoint { prepare: 9576, instructions: 709, reflections: 1, level: QualityLevel::Fast, scale: 1, psnr: 4775, largest: 10 },
    FrontPoint { prepare: 9576, instructions: 761, reflections: 2, level: QualityLevel::Fast, scale: 1, psnr: 6384, largest: 2 },
    FrontPoint { prepare: 9576, instructions: 774, reflections: 3, level: QualityLevel::Fast, scale: 1, psnr: 6643, largest: 2 },
    FrontPoint { prepare: 9576, instructions: 1023, reflections: 2, level: QualityLevel::Exact, scale: 1, psnr: 6716, largest: 2 },
    FrontPoint { prepare: 9576, instructions: 1035, reflections: 3, level: QualityLevel::Exact, scale: 1, psnr: 8203, largest: 1 },
    FrontPoint { prepare: 9576, instructions: 1037, reflections: 4, level: QualityLevel::Exact, scale: 1, psnr: 65535, largest: 0 },
]);
/// columns
pub const COLUMNS: ParetoFront = ParetoFront::new(&[
    FrontPoint { prepare: 22601, instructions: 68, reflections: 0, level: QualityLevel::Exact, scale: 4, psnr: 2647, largest: 177 },
    FrontPoint { prepare: 22601, instructions: 91, reflections: 1, level: QualityLevel::Exact, scale: 4, psnr: 2677, largest: 178 },
    FrontPoint { prepare: 22728, instructions: 245, reflections: 0, level: QualityLevel::Exact, scale: 2, psnr: 2936, largest: 163 },
    FrontPoint { prepare: 22728, instructions: 310, reflections: 1, level: QualityLevel::Exact, scale: 2, psnr: 2980, largest: 173 },
    FrontPoint { prepare: 22816, instructions: 750, reflections: 0, level: QualityLevel::Fast, scale: 1, psnr: 3829, largest: 56 },
    FrontPoint { prepare: 22816, instructions: 950, reflections: 1, level: QualityLevel::Fast, scale: 1, psnr: 5795, largest: 16 },
    FrontPoint { prepare: 22816, instructions: 1006, reflections: 2, level: QualityLevel::Fast, scale: 1, psnr: 7337, largest: 2 },
    FrontPoint { prepare: 22816, instructions: 1019, reflections: 3, level: QualityLevel::Fast, scale: 1, psnr: 7371, largest: 1 },
    FrontPoint { prepare: 22816, instructions: 1167, reflections: 2, level: QualityLevel::Exact, scale: 1, psnr: 8425, largest: 2 },
    FrontPoint { prepare: 22816, instructions: 1179, reflections: 3, level: QualityLevel::Exact, scale: 1, psnr: 65535, largest: 0 },
]);
/// mirror1
pub const MIRROR1: ParetoFront = ParetoFront::new(&[
    FrontPoint { prepare: 13830, instructions: 55, reflections: 0, level: QualityLevel::Exact, scale: 4, psnr: 1574, largest: 255 },
    FrontPoint { prepare: 13830, instructions: 81, reflections: 1, level: QualityLevel::Exact, scale: 4, psnr: 2297, largest: 255 },
    FrontPoint { prepare: 13830, instructions: 304, reflections: 1, level: QualityLevel::Exact, scale: 2, psnr: 2508, largest: 234 },
    FrontPoint { prepare: 13830, instructions: 992, reflections: 1, level: QualityLevel::Fast, scale: 1, psnr: 4363, largest: 47 },
    FrontPoint { prepare: 13830, instructions: 1168, reflections: 2, level: QualityLevel::Fast, scale: 1, psnr: 5691, largest: 17 },
    FrontPoint { prepare: 13830, instructions: 1193, reflections: 3, level: QualityLevel::Fast, scale: 1, psnr: 7475, largest: 3 },
    FrontPoint { prepare: 13830, instructions: 1197, reflections: 4, level: QualityLevel::Fast, scale: 1, psnr: 7948, largest: 1 },
    FrontPoint { prepare: 13830, instructions: 1272, reflections: 4, level: QualityLevel::Exact, scale: 1, psnr: 9027, largest: 1 },
    FrontPoint { prepare: 13830, instructions: 1273, reflections: 5, level: QualityLevel::Exact, scale: 1, psnr: 65535, largest: 0 },
]);
/// mirror2
pub const MIRROR2: ParetoFront = ParetoFront::new(&[
    FrontPoint { prepare: 21778, instructions: 64, reflections: 0, level: QualityLevel::Fast, scale: 4, psnr: 1790, largest: 251 },
    FrontPoint { prepare: 21778, instructions: 127, reflections: 1, level: QualityLevel::Exact, scale: 4, psnr: 2046, largest: 224 },
    FrontPoint { prepare: 21778, instructions: 190, reflections: 2, level: QualityLevel::Exact, scale: 4, psnr: 2226, largest: 224 },
    FrontPoint { prepare: 21778, instructions: 231, reflections: 3, level: QualityLevel::Exact, scale: 4, psnr: 2334, largest: 224 },
    FrontPoint { prepare: 21778, instructions: 690, reflections: 2, level: QualityLevel::Fast, scale: 2, psnr: 2403, largest: 224 },
    FrontPoint { prepare: 21778, instructions: 876, reflections: 3, level: QualityLevel::Fast, scale: 2, psnr: 2601, largest: 224 },
    FrontPoint { prepare: 21772, instructions: 2009, reflections: 2, level: QualityLevel::Fast, scale: 1, psnr: 2770, largest: 164 },
    FrontPoint { prepare: 21772, instructions: 2640, reflections: 3, level: QualityLevel::Fast, scale: 1, psnr: 5383, largest: 26 },
    FrontPoint { prepare: 21772, instructions: 2801, reflections: 4, level: QualityLevel::Fast, scale: 1, psnr: 6365, largest: 12 },
    FrontPoint { prepare: 21772, instructions: 2824, reflections: 5, level: QualityLevel::Fast, scale: 1, psnr: 6996, largest: 6 },
    FrontPoint { prepare: 21772, instructions: 2833, reflections: 6, level: QualityLevel::Fast, scale: 1, psnr: 7271, largest: 2 },
    FrontPoint { prepare: 21772, instructions: 3769, reflections: 6, level: QualityLevel::Exact, scale: 1, psnr: 8504, largest: 2 },
    FrontPoint { prepare: 21772, instructions: 3773, reflections: 7, level: QualityLevel::Exact, scale: 1, psnr: 9027, largest: 1 },
    FrontPoint { prepare: 21772, instructions: 3775, reflections: 8, level: QualityLevel::Exact, scale: 1, psnr: 9504, largest: 1 },
]);
/// primitives
pub const PRIMITIVES: ParetoFront = ParetoFront::new(&[
    FrontPoint { prepare: 5311, instructions: 51, reflections: 0, level: QualityLevel::Fast, scale: 4, psnr: 1923, largest: 255 },
    FrontPoint { prepare: 5311, instructions: 72, reflections: 1, level: QualityLevel::Exact, scale: 4, psnr: 2343, largest: 196 },
    FrontPoint { prepare: 5311, instructions: 230, reflections: 1, level: QualityLevel::Fast, scale: 2, psnr: 2659, largest: 212 },
    FrontPoint { prepare: 5311, instructions: 678, reflections: 1, level: QualityLevel::Fast, scale: 1, psnr: 4326, largest: 20 },
    FrontPoint { prepare: 5311, instructions: 715, reflections: 2, level: QualityLevel::Fast, scale: 1, psnr: 5817, largest: 20 },
    FrontPoint { prepare: 5311, instructions: 724, reflections: 3, level: QualityLevel::Fast, scale: 1, psnr: 7440, largest: 3 },
    FrontPoint { prepare: 5311, instructions: 725, reflections: 4, level: QualityLevel::Fast, scale: 1, psnr: 7733, largest: 1 },
    FrontPoint { prepare: 5311, instructions: 1043, reflections: 4, level: QualityLevel::Exact, scale: 1, psnr: 65535, largest: 0 },
]);
/// empty
pub const EMPTY: ParetoFront = ParetoFront::new(&[
    FrontPoint { prepare: 62, instructions: 2, reflections: 0, level: QualityLevel::Fast, scale: 1, psnr: 65535, largest: 0 },
]);
/// floor
pub const FLOOR: ParetoFront = ParetoFront::new(&[
    FrontPoint { prepare: 434, instructions: 10, reflections: 0, level: QualityLevel::Fast, scale: 4, psnr: 2432, largest: 124 },
    FrontPoint { prepare: 434, instructions: 32, reflections: 0, level: QualityLevel::Fast, scale: 2, psnr: 65535, largest: 0 },
]);
/// corner1
pub const CORNER1: ParetoFront = ParetoFront::new(&[
    FrontPoint { prepare: 523, instructions: 29, reflections: 0, level: QualityLevel::Fast, scale: 4, psnr: 3026, largest: 101 },
    FrontPoint { prepare: 523, instructions: 74, reflections: 0, level: QualityLevel::Fast, scale: 2, psnr: 3777, largest: 66 },
    FrontPoint { prepare: 523, instructions: 190, reflections: 0, level: QualityLevel::Fast, scale: 1, psnr: 6003, largest: 43 },
]);
/// cylinders
pub const CYLINDERS: ParetoFront = ParetoFront::new(&[
    FrontPoint { prepare: 4543, instructions: 26, reflections: 0, level: QualityLevel::Fast, scale: 4, psnr: 2041, largest: 255 },
    FrontPoint { prepare: 4543, instructions: 77, reflections: 0, level: QualityLevel::Fast, scale: 2, psnr: 2410, largest: 255 },
    FrontPoint { prepare: 4543, instructions: 212, reflections: 0, level: QualityLevel::Fast, scale: 1, psnr: 3907, largest: 35 },
    FrontPoint { prepare: 4543, instructions: 281, reflections: 1, level: QualityLevel::Fast, scale: 1, psnr: 6310, largest: 3 },
    FrontPoint { prepare: 4543, instructions: 316, reflections: 2, level: QualityLevel::Fast, scale: 1, psnr: 7986, largest: 1 },
    FrontPoint { prepare: 4543, instructions: 427, reflections: 3, level: QualityLevel::Exact, scale: 1, psnr: 65535, largest: 0 },
]);
