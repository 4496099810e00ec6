// Written by `cargo run --release --package report -- --core m3 --size 128x128`:
// what is best for a frame of so many instructions. Include it where `Front`, `FrontPoint` and `Grade`
// are in scope.
/// castle
pub const CASTLE: Front = Front::new(&[
    FrontPoint { prepare: 123469, instructions: 55, reflections: 0, grade: Grade::Fast, scale: 4, psnr: 1309, largest: 231 },
    FrontPoint { prepare: 123469, instructions: 102, reflections: 1, grade: Grade::Fast, scale: 4, psnr: 2177, largest: 231 },
    FrontPoint { prepare: 121490, instructions: 257, reflections: 1, grade: Grade::Fast, scale: 2, psnr: 2550, largest: 211 },
    FrontPoint { prepare: 120877, instructions: 743, reflections: 1, grade: Grade::Fast, scale: 1, psnr: 4250, largest: 76 },
    FrontPoint { prepare: 120877, instructions: 770, reflections: 2, grade: Grade::Fast, scale: 1, psnr: 5835, largest: 17 },
    FrontPoint { prepare: 120877, instructions: 773, reflections: 3, grade: Grade::Fast, scale: 1, psnr: 6611, largest: 17 },
    FrontPoint { prepare: 120877, instructions: 1005, reflections: 3, grade: Grade::Fine, scale: 1, psnr: 6838, largest: 17 },
]);
/// shading_lights
pub const SHADING_LIGHTS: Front = Front::new(&[
    FrontPoint { prepare: 3299, instructions: 34, reflections: 0, grade: Grade::Fast, scale: 4, psnr: 2214, largest: 184 },
    FrontPoint { prepare: 3299, instructions: 49, reflections: 1, grade: Grade::Fast, scale: 4, psnr: 2658, largest: 181 },
    FrontPoint { prepare: 3299, instructions: 138, reflections: 1, grade: Grade::Fast, scale: 2, psnr: 2889, largest: 180 },
    FrontPoint { prepare: 3299, instructions: 381, reflections: 1, grade: Grade::Fast, scale: 1, psnr: 7705, largest: 1 },
    FrontPoint { prepare: 3299, instructions: 629, reflections: 1, grade: Grade::Fine, scale: 1, psnr: 8182, largest: 1 },
]);
/// shading_speculars
pub const SHADING_SPECULARS: Front = Front::new(&[
    FrontPoint { prepare: 12222, instructions: 33, reflections: 0, grade: Grade::Fast, scale: 4, psnr: 1870, largest: 173 },
    FrontPoint { prepare: 12222, instructions: 54, reflections: 1, grade: Grade::Fast, scale: 4, psnr: 2228, largest: 147 },
    FrontPoint { prepare: 12204, instructions: 161, reflections: 1, grade: Grade::Fast, scale: 2, psnr: 2618, largest: 155 },
    FrontPoint { prepare: 12179, instructions: 460, reflections: 1, grade: Grade::Fast, scale: 1, psnr: 4776, largest: 10 },
    FrontPoint { prepare: 12179, instructions: 521, reflections: 2, grade: Grade::Fast, scale: 1, psnr: 6505, largest: 5 },
    FrontPoint { prepare: 12179, instructions: 536, reflections: 3, grade: Grade::Fast, scale: 1, psnr: 6925, largest: 5 },
    FrontPoint { prepare: 12179, instructions: 742, reflections: 3, grade: Grade::Fine, scale: 1, psnr: 7902, largest: 1 },
    FrontPoint { prepare: 12179, instructions: 744, reflections: 4, grade: Grade::Fine, scale: 1, psnr: 8203, largest: 1 },
]);
/// columns
pub const COLUMNS: Front = Front::new(&[
    FrontPoint { prepare: 24894, instructions: 53, reflections: 0, grade: Grade::Fast, scale: 4, psnr: 2641, largest: 177 },
    FrontPoint { prepare: 24894, instructions: 69, reflections: 1, grade: Grade::Fast, scale: 4, psnr: 2677, largest: 178 },
    FrontPoint { prepare: 25015, instructions: 156, reflections: 0, grade: Grade::Fast, scale: 2, psnr: 2935, largest: 163 },
    FrontPoint { prepare: 25015, instructions: 209, reflections: 1, grade: Grade::Fast, scale: 2, psnr: 2980, largest: 173 },
    FrontPoint { prepare: 25099, instructions: 455, reflections: 0, grade: Grade::Fast, scale: 1, psnr: 3823, largest: 56 },
    FrontPoint { prepare: 25099, instructions: 639, reflections: 1, grade: Grade::Fast, scale: 1, psnr: 5750, largest: 16 },
    FrontPoint { prepare: 25099, instructions: 692, reflections: 2, grade: Grade::Fast, scale: 1, psnr: 7913, largest: 2 },
    FrontPoint { prepare: 25099, instructions: 703, reflections: 3, grade: Grade::Fast, scale: 1, psnr: 8057, largest: 1 },
    FrontPoint { prepare: 25099, instructions: 876, reflections: 2, grade: Grade::Fine, scale: 1, psnr: 8142, largest: 2 },
    FrontPoint { prepare: 25099, instructions: 887, reflections: 3, grade: Grade::Fine, scale: 1, psnr: 8425, largest: 1 },
]);
/// mirror1
pub const MIRROR1: Front = Front::new(&[
    FrontPoint { prepare: 17206, instructions: 39, reflections: 0, grade: Grade::Fast, scale: 4, psnr: 1568, largest: 255 },
    FrontPoint { prepare: 17206, instructions: 67, reflections: 1, grade: Grade::Fast, scale: 4, psnr: 2282, largest: 255 },
    FrontPoint { prepare: 17206, instructions: 209, reflections: 1, grade: Grade::Fast, scale: 2, psnr: 2471, largest: 234 },
    FrontPoint { prepare: 17206, instructions: 257, reflections: 1, grade: Grade::Fine, scale: 2, psnr: 2508, largest: 234 },
    FrontPoint { prepare: 17206, instructions: 640, reflections: 1, grade: Grade::Fast, scale: 1, psnr: 4362, largest: 47 },
    FrontPoint { prepare: 17206, instructions: 807, reflections: 2, grade: Grade::Fast, scale: 1, psnr: 5682, largest: 16 },
    FrontPoint { prepare: 17206, instructions: 834, reflections: 3, grade: Grade::Fast, scale: 1, psnr: 7034, largest: 4 },
    FrontPoint { prepare: 17206, instructions: 835, reflections: 4, grade: Grade::Fast, scale: 1, psnr: 7144, largest: 4 },
    FrontPoint { prepare: 17206, instructions: 974, reflections: 3, grade: Grade::Fine, scale: 1, psnr: 7479, largest: 3 },
    FrontPoint { prepare: 17206, instructions: 983, reflections: 4, grade: Grade::Fine, scale: 1, psnr: 8106, largest: 1 },
    FrontPoint { prepare: 17206, instructions: 985, reflections: 5, grade: Grade::Fine, scale: 1, psnr: 8162, largest: 1 },
]);
/// mirror2
pub const MIRROR2: Front = Front::new(&[
    FrontPoint { prepare: 26530, instructions: 42, reflections: 0, grade: Grade::Fast, scale: 4, psnr: 1782, largest: 251 },
    FrontPoint { prepare: 26530, instructions: 89, reflections: 1, grade: Grade::Fast, scale: 4, psnr: 2038, largest: 224 },
    FrontPoint { prepare: 26530, instructions: 140, reflections: 2, grade: Grade::Fast, scale: 4, psnr: 2214, largest: 224 },
    FrontPoint { prepare: 26530, instructions: 175, reflections: 3, grade: Grade::Fast, scale: 4, psnr: 2318, largest: 224 },
    FrontPoint { prepare: 26474, instructions: 399, reflections: 2, grade: Grade::Fast, scale: 2, psnr: 2374, largest: 224 },
    FrontPoint { prepare: 26474, instructions: 509, reflections: 3, grade: Grade::Fast, scale: 2, psnr: 2555, largest: 224 },
    FrontPoint { prepare: 26474, instructions: 649, reflections: 3, grade: Grade::Fine, scale: 2, psnr: 2600, largest: 224 },
    FrontPoint { prepare: 25717, instructions: 1200, reflections: 2, grade: Grade::Fast, scale: 1, psnr: 2766, largest: 164 },
    FrontPoint { prepare: 25717, instructions: 1546, reflections: 3, grade: Grade::Fast, scale: 1, psnr: 4723, largest: 115 },
    FrontPoint { prepare: 25717, instructions: 1651, reflections: 4, grade: Grade::Fast, scale: 1, psnr: 4819, largest: 115 },
    FrontPoint { prepare: 25717, instructions: 2222, reflections: 3, grade: Grade::Fine, scale: 1, psnr: 5375, largest: 26 },
    FrontPoint { prepare: 25717, instructions: 2379, reflections: 4, grade: Grade::Fine, scale: 1, psnr: 6302, largest: 14 },
    FrontPoint { prepare: 25717, instructions: 2409, reflections: 5, grade: Grade::Fine, scale: 1, psnr: 6777, largest: 14 },
    FrontPoint { prepare: 25717, instructions: 2423, reflections: 6, grade: Grade::Fine, scale: 1, psnr: 6922, largest: 14 },
]);
/// primitives
pub const PRIMITIVES: Front = Front::new(&[
    FrontPoint { prepare: 7670, instructions: 30, reflections: 0, grade: Grade::Fast, scale: 4, psnr: 1923, largest: 255 },
    FrontPoint { prepare: 7670, instructions: 46, reflections: 1, grade: Grade::Fast, scale: 4, psnr: 2343, largest: 196 },
    FrontPoint { prepare: 7670, instructions: 139, reflections: 1, grade: Grade::Fast, scale: 2, psnr: 2658, largest: 212 },
    FrontPoint { prepare: 7670, instructions: 433, reflections: 1, grade: Grade::Fast, scale: 1, psnr: 4298, largest: 86 },
    FrontPoint { prepare: 7670, instructions: 468, reflections: 2, grade: Grade::Fast, scale: 1, psnr: 5710, largest: 20 },
    FrontPoint { prepare: 7670, instructions: 480, reflections: 3, grade: Grade::Fast, scale: 1, psnr: 6548, largest: 12 },
    FrontPoint { prepare: 7670, instructions: 482, reflections: 4, grade: Grade::Fast, scale: 1, psnr: 6577, largest: 12 },
    FrontPoint { prepare: 7670, instructions: 700, reflections: 3, grade: Grade::Fine, scale: 1, psnr: 6918, largest: 11 },
    FrontPoint { prepare: 7670, instructions: 703, reflections: 4, grade: Grade::Fine, scale: 1, psnr: 6987, largest: 11 },
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
    FrontPoint { prepare: 729, instructions: 62, reflections: 0, grade: Grade::Fast, scale: 2, psnr: 3777, largest: 66 },
    FrontPoint { prepare: 729, instructions: 187, reflections: 0, grade: Grade::Fine, scale: 1, psnr: 6023, largest: 43 },
]);
/// cylinders
pub const CYLINDERS: Front = Front::new(&[
    FrontPoint { prepare: 5075, instructions: 19, reflections: 0, grade: Grade::Fast, scale: 4, psnr: 1996, largest: 255 },
    FrontPoint { prepare: 5075, instructions: 20, reflections: 0, grade: Grade::Fine, scale: 4, psnr: 2041, largest: 255 },
    FrontPoint { prepare: 5045, instructions: 60, reflections: 0, grade: Grade::Fast, scale: 2, psnr: 2395, largest: 255 },
    FrontPoint { prepare: 5045, instructions: 147, reflections: 0, grade: Grade::Fast, scale: 1, psnr: 3907, largest: 35 },
    FrontPoint { prepare: 5045, instructions: 220, reflections: 1, grade: Grade::Fast, scale: 1, psnr: 6296, largest: 6 },
    FrontPoint { prepare: 5045, instructions: 255, reflections: 2, grade: Grade::Fast, scale: 1, psnr: 7596, largest: 6 },
    FrontPoint { prepare: 5045, instructions: 275, reflections: 2, grade: Grade::Fine, scale: 1, psnr: 7948, largest: 1 },
    FrontPoint { prepare: 5045, instructions: 292, reflections: 3, grade: Grade::Fine, scale: 1, psnr: 9027, largest: 1 },
]);
