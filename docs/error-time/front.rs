// Written by `cargo run --release --package report -- --core m3 --size 128x128`:
// what is best for a frame of so many instructions. Include it where `Front`, `FrontPoint` and `Grade`
// are in scope.
/// castle
pub const CASTLE: Front = Front::new(&[
    FrontPoint { prepare: 123469, instructions: 55, reflections: 0, grade: Grade::Fast, scale: 4, psnr: 1309, largest: 231 },
    FrontPoint { prepare: 123469, instructions: 102, reflections: 1, grade: Grade::Fast, scale: 4, psnr: 2177, largest: 231 },
    FrontPoint { prepare: 121490, instructions: 258, reflections: 1, grade: Grade::Fast, scale: 2, psnr: 2550, largest: 211 },
    FrontPoint { prepare: 120877, instructions: 747, reflections: 1, grade: Grade::Fast, scale: 1, psnr: 4250, largest: 76 },
    FrontPoint { prepare: 120877, instructions: 774, reflections: 2, grade: Grade::Fast, scale: 1, psnr: 5836, largest: 17 },
    FrontPoint { prepare: 120877, instructions: 777, reflections: 3, grade: Grade::Fast, scale: 1, psnr: 6616, largest: 17 },
    FrontPoint { prepare: 120877, instructions: 1012, reflections: 3, grade: Grade::Fine, scale: 1, psnr: 6846, largest: 17 },
]);
/// shading_lights
pub const SHADING_LIGHTS: Front = Front::new(&[
    FrontPoint { prepare: 3299, instructions: 35, reflections: 0, grade: Grade::Fast, scale: 4, psnr: 2214, largest: 184 },
    FrontPoint { prepare: 3299, instructions: 49, reflections: 1, grade: Grade::Fast, scale: 4, psnr: 2658, largest: 181 },
    FrontPoint { prepare: 3299, instructions: 138, reflections: 1, grade: Grade::Fast, scale: 2, psnr: 2889, largest: 180 },
    FrontPoint { prepare: 3299, instructions: 380, reflections: 1, grade: Grade::Fast, scale: 1, psnr: 7772, largest: 1 },
    FrontPoint { prepare: 3299, instructions: 628, reflections: 1, grade: Grade::Fine, scale: 1, psnr: 8902, largest: 1 },
]);
/// shading_speculars
pub const SHADING_SPECULARS: Front = Front::new(&[
    FrontPoint { prepare: 12222, instructions: 33, reflections: 0, grade: Grade::Fast, scale: 4, psnr: 1870, largest: 173 },
    FrontPoint { prepare: 12222, instructions: 53, reflections: 1, grade: Grade::Fast, scale: 4, psnr: 2228, largest: 147 },
    FrontPoint { prepare: 12204, instructions: 160, reflections: 1, grade: Grade::Fast, scale: 2, psnr: 2618, largest: 155 },
    FrontPoint { prepare: 12179, instructions: 458, reflections: 1, grade: Grade::Fast, scale: 1, psnr: 4776, largest: 10 },
    FrontPoint { prepare: 12179, instructions: 518, reflections: 2, grade: Grade::Fast, scale: 1, psnr: 6508, largest: 5 },
    FrontPoint { prepare: 12179, instructions: 533, reflections: 3, grade: Grade::Fast, scale: 1, psnr: 6931, largest: 5 },
    FrontPoint { prepare: 12179, instructions: 740, reflections: 3, grade: Grade::Fine, scale: 1, psnr: 7986, largest: 1 },
    FrontPoint { prepare: 12179, instructions: 742, reflections: 4, grade: Grade::Fine, scale: 1, psnr: 8390, largest: 1 },
]);
/// columns
pub const COLUMNS: Front = Front::new(&[
    FrontPoint { prepare: 24894, instructions: 53, reflections: 0, grade: Grade::Fast, scale: 4, psnr: 2641, largest: 177 },
    FrontPoint { prepare: 24894, instructions: 70, reflections: 1, grade: Grade::Fast, scale: 4, psnr: 2677, largest: 178 },
    FrontPoint { prepare: 25015, instructions: 158, reflections: 0, grade: Grade::Fast, scale: 2, psnr: 2935, largest: 163 },
    FrontPoint { prepare: 25015, instructions: 211, reflections: 1, grade: Grade::Fast, scale: 2, psnr: 2980, largest: 173 },
    FrontPoint { prepare: 25099, instructions: 460, reflections: 0, grade: Grade::Fast, scale: 1, psnr: 3823, largest: 56 },
    FrontPoint { prepare: 25099, instructions: 647, reflections: 1, grade: Grade::Fast, scale: 1, psnr: 5750, largest: 16 },
    FrontPoint { prepare: 25099, instructions: 700, reflections: 2, grade: Grade::Fast, scale: 1, psnr: 7986, largest: 2 },
    FrontPoint { prepare: 25099, instructions: 712, reflections: 3, grade: Grade::Fast, scale: 1, psnr: 8162, largest: 1 },
    FrontPoint { prepare: 25099, instructions: 885, reflections: 2, grade: Grade::Fine, scale: 1, psnr: 8249, largest: 2 },
    FrontPoint { prepare: 25099, instructions: 897, reflections: 3, grade: Grade::Fine, scale: 1, psnr: 8659, largest: 1 },
]);
/// mirror1
pub const MIRROR1: Front = Front::new(&[
    FrontPoint { prepare: 17206, instructions: 40, reflections: 0, grade: Grade::Fast, scale: 4, psnr: 1568, largest: 255 },
    FrontPoint { prepare: 17206, instructions: 68, reflections: 1, grade: Grade::Fast, scale: 4, psnr: 2282, largest: 255 },
    FrontPoint { prepare: 17206, instructions: 211, reflections: 1, grade: Grade::Fast, scale: 2, psnr: 2471, largest: 234 },
    FrontPoint { prepare: 17206, instructions: 260, reflections: 1, grade: Grade::Fine, scale: 2, psnr: 2508, largest: 234 },
    FrontPoint { prepare: 17206, instructions: 648, reflections: 1, grade: Grade::Fast, scale: 1, psnr: 4362, largest: 47 },
    FrontPoint { prepare: 17206, instructions: 815, reflections: 2, grade: Grade::Fast, scale: 1, psnr: 5683, largest: 16 },
    FrontPoint { prepare: 17206, instructions: 845, reflections: 3, grade: Grade::Fast, scale: 1, psnr: 7094, largest: 4 },
    FrontPoint { prepare: 17206, instructions: 850, reflections: 4, grade: Grade::Fast, scale: 1, psnr: 7235, largest: 4 },
    FrontPoint { prepare: 17206, instructions: 983, reflections: 3, grade: Grade::Fine, scale: 1, psnr: 7496, largest: 3 },
    FrontPoint { prepare: 17206, instructions: 991, reflections: 4, grade: Grade::Fine, scale: 1, psnr: 8182, largest: 1 },
    FrontPoint { prepare: 17206, instructions: 993, reflections: 5, grade: Grade::Fine, scale: 1, psnr: 8249, largest: 1 },
]);
/// mirror2
pub const MIRROR2: Front = Front::new(&[
    FrontPoint { prepare: 26530, instructions: 43, reflections: 0, grade: Grade::Fast, scale: 4, psnr: 1782, largest: 251 },
    FrontPoint { prepare: 26530, instructions: 90, reflections: 1, grade: Grade::Fast, scale: 4, psnr: 2038, largest: 224 },
    FrontPoint { prepare: 26530, instructions: 143, reflections: 2, grade: Grade::Fast, scale: 4, psnr: 2214, largest: 224 },
    FrontPoint { prepare: 26530, instructions: 178, reflections: 3, grade: Grade::Fast, scale: 4, psnr: 2318, largest: 224 },
    FrontPoint { prepare: 26474, instructions: 405, reflections: 2, grade: Grade::Fast, scale: 2, psnr: 2374, largest: 224 },
    FrontPoint { prepare: 26474, instructions: 517, reflections: 3, grade: Grade::Fast, scale: 2, psnr: 2555, largest: 224 },
    FrontPoint { prepare: 26474, instructions: 659, reflections: 3, grade: Grade::Fine, scale: 2, psnr: 2601, largest: 224 },
    FrontPoint { prepare: 25717, instructions: 1221, reflections: 2, grade: Grade::Fast, scale: 1, psnr: 2766, largest: 164 },
    FrontPoint { prepare: 25717, instructions: 1574, reflections: 3, grade: Grade::Fast, scale: 1, psnr: 4723, largest: 115 },
    FrontPoint { prepare: 25717, instructions: 1701, reflections: 4, grade: Grade::Fast, scale: 1, psnr: 4819, largest: 115 },
    FrontPoint { prepare: 25717, instructions: 2257, reflections: 3, grade: Grade::Fine, scale: 1, psnr: 5376, largest: 26 },
    FrontPoint { prepare: 25717, instructions: 2415, reflections: 4, grade: Grade::Fine, scale: 1, psnr: 6303, largest: 14 },
    FrontPoint { prepare: 25717, instructions: 2445, reflections: 5, grade: Grade::Fine, scale: 1, psnr: 6781, largest: 14 },
    FrontPoint { prepare: 25717, instructions: 2458, reflections: 6, grade: Grade::Fine, scale: 1, psnr: 6929, largest: 14 },
]);
/// primitives
pub const PRIMITIVES: Front = Front::new(&[
    FrontPoint { prepare: 7670, instructions: 30, reflections: 0, grade: Grade::Fast, scale: 4, psnr: 1923, largest: 255 },
    FrontPoint { prepare: 7670, instructions: 46, reflections: 1, grade: Grade::Fast, scale: 4, psnr: 2343, largest: 196 },
    FrontPoint { prepare: 7670, instructions: 140, reflections: 1, grade: Grade::Fast, scale: 2, psnr: 2658, largest: 212 },
    FrontPoint { prepare: 7670, instructions: 436, reflections: 1, grade: Grade::Fast, scale: 1, psnr: 4298, largest: 86 },
    FrontPoint { prepare: 7670, instructions: 471, reflections: 2, grade: Grade::Fast, scale: 1, psnr: 5711, largest: 20 },
    FrontPoint { prepare: 7670, instructions: 484, reflections: 3, grade: Grade::Fast, scale: 1, psnr: 6554, largest: 12 },
    FrontPoint { prepare: 7670, instructions: 486, reflections: 4, grade: Grade::Fast, scale: 1, psnr: 6582, largest: 12 },
    FrontPoint { prepare: 7670, instructions: 703, reflections: 3, grade: Grade::Fine, scale: 1, psnr: 6931, largest: 11 },
    FrontPoint { prepare: 7670, instructions: 706, reflections: 4, grade: Grade::Fine, scale: 1, psnr: 7003, largest: 11 },
]);
/// empty
pub const EMPTY: Front = Front::new(&[
    FrontPoint { prepare: 57, instructions: 2, reflections: 0, grade: Grade::Fast, scale: 1, psnr: 65535, largest: 0 },
]);
/// floor
pub const FLOOR: Front = Front::new(&[
    FrontPoint { prepare: 417, instructions: 6, reflections: 0, grade: Grade::Fast, scale: 4, psnr: 2432, largest: 124 },
    FrontPoint { prepare: 417, instructions: 20, reflections: 0, grade: Grade::Fast, scale: 2, psnr: 65535, largest: 0 },
]);
/// corner1
pub const CORNER1: Front = Front::new(&[
    FrontPoint { prepare: 729, instructions: 20, reflections: 0, grade: Grade::Fast, scale: 4, psnr: 3026, largest: 101 },
    FrontPoint { prepare: 729, instructions: 61, reflections: 0, grade: Grade::Fast, scale: 2, psnr: 3777, largest: 66 },
    FrontPoint { prepare: 729, instructions: 185, reflections: 0, grade: Grade::Fine, scale: 1, psnr: 6024, largest: 43 },
]);
/// cylinders
pub const CYLINDERS: Front = Front::new(&[
    FrontPoint { prepare: 5075, instructions: 19, reflections: 0, grade: Grade::Fast, scale: 4, psnr: 1996, largest: 255 },
    FrontPoint { prepare: 5075, instructions: 20, reflections: 0, grade: Grade::Fine, scale: 4, psnr: 2041, largest: 255 },
    FrontPoint { prepare: 5045, instructions: 60, reflections: 0, grade: Grade::Fast, scale: 2, psnr: 2395, largest: 255 },
    FrontPoint { prepare: 5045, instructions: 148, reflections: 0, grade: Grade::Fast, scale: 1, psnr: 3907, largest: 35 },
    FrontPoint { prepare: 5045, instructions: 221, reflections: 1, grade: Grade::Fast, scale: 1, psnr: 6296, largest: 6 },
    FrontPoint { prepare: 5045, instructions: 257, reflections: 2, grade: Grade::Fast, scale: 1, psnr: 7601, largest: 6 },
    FrontPoint { prepare: 5045, instructions: 276, reflections: 2, grade: Grade::Fine, scale: 1, psnr: 7973, largest: 1 },
    FrontPoint { prepare: 5045, instructions: 292, reflections: 3, grade: Grade::Fine, scale: 1, psnr: 9504, largest: 1 },
]);
