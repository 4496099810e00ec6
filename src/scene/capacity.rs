//! The room of a scene as one type. Generic code has this type as its only parameter, instead of one
//! number for each list.

use core::fmt::Debug;

use super::access::Parts;
use super::description::{Described, Description};
use super::prepare::PlainScene;

/// An array of any length, as generic code uses it.
pub trait Array<T>: AsRef<[T]> + AsMut<[T]> + Copy + Debug {
    /// Creates an array in which every item is `item`.
    fn filled(item: T) -> Self;
}

impl<T: Copy + Debug, const N: usize> Array<T> for [T; N] {
    #[inline(always)]
    fn filled(item: T) -> Self {
        [item; N]
    }
}

macro_rules! capacity {
    (
        { [$($declaration:tt)*] [$($header:tt)*] [$($arguments:tt)*] }
        $({ $list:ident $kind:ident $described:ident $prepared:ident $room:ident $lists:ident $($more:tt)* })*
    ) => {
        /// The number of parts of each kind that a scene has, or has room for.
        #[derive(Clone, Copy, Debug)]
        pub struct Counts {
            $(
                #[doc = concat!("Number of ", stringify!($list), ".")]
                pub $list: usize,
            )*
            /// Number of planes.
            pub planes: usize,
            /// Number of lights.
            pub lights: usize,
            /// Number of materials.
            pub materials: usize,
        }

        impl Counts {
            /// Returns the counts for the fields of a `room!`. A list that is not named gets 0,
            /// materials get 8.
            pub const fn of_fields(fields: &[(&str, usize)]) -> Self {
                let mut counts = Self { $($list: 0,)* planes: 0, lights: 0, materials: 8 };
                let mut index = 0;
                while index < fields.len() {
                    let (name, count) = fields[index];
                    assert!(count < 1 << 16, "room!(..) has room for at most 65535 of each kind");
                    index += 1;
                    $(
                        if is_same(name, stringify!($list)) {
                            counts.$list = count;
                            continue;
                        }
                    )*
                    match name.as_bytes() {
                        b"planes" => counts.planes = count,
                        b"lights" => counts.lights = count,
                        b"materials" => counts.materials = count,
                        _ => panic!("{}", concat!(
                            "room!(..) has no such list; it has "
                            $(, stringify!($list), ", ")*, "planes, lights, materials"
                        )),
                    }
                }
                counts
            }

            /// Returns the number of bounded shapes of all kinds.
            pub(crate) const fn bounded(&self) -> usize {
                0 $(+ self.$list)*
            }
        }

        /// The room of a scene: `S` spheres, `P` planes, `C` cylinders, `L` lights, `M` materials, `D`
        /// discs, `F` triangles.
        #[derive(Clone, Copy, Debug)]
        pub struct Room<$($declaration)*>;

        /// The room of a scene as a trait: an array type for each of its lists, for items of any type.
        ///
        /// The crate implements it for every [`Room`]. Users do not implement it. Constant code can
        /// index the arrays only where the room's numbers are parameters: in `impl<const S: usize, ..>
        /// SceneBuilder<Room<S, ..>>`, `R::Spheres<T>` is `[T; S]`.
        pub trait Capacity: Copy + Debug + 'static {
            $(
                #[doc = concat!("Array with one item for each of the ", stringify!($list), " that fit the room.")]
                type $lists<T: Copy + Debug>: Array<T>;
            )*
            /// Array with one item for each of the planes that fit the room.
            type Planes<T: Copy + Debug>: Array<T>;
            /// Array with one item for each of the lights that fit the room.
            type Lights<T: Copy + Debug>: Array<T>;
            /// Array with one item for each of the materials that fit the room.
            type Materials<T: Copy + Debug>: Array<T>;

            /// Number of parts of each kind that fit the room.
            const COUNTS: Counts;

            // Constant functions, written for every room: they cannot be generic over rooms.

            /// Returns an empty description with a black background and an epsilon of 0.001.
            fn empty() -> Described<Self>;

            /// Returns what is read of a description.
            fn description(described: &Described<Self>) -> Description<'_>;

            /// Returns the parts of a prepared scene.
            fn parts(scene: &PlainScene<Self>) -> Parts<'_>;
        }

        impl<$($header)*> Capacity for Room<$($arguments)*> {
            $(type $lists<T: Copy + Debug> = [T; $room];)*
            type Planes<T: Copy + Debug> = [T; P];
            type Lights<T: Copy + Debug> = [T; L];
            type Materials<T: Copy + Debug> = [T; M];

            const COUNTS: Counts = Counts {
                $($list: $room,)*
                planes: P,
                lights: L,
                materials: M,
            };

            fn empty() -> Described<Self> {
                Described::new()
            }

            fn description(described: &Described<Self>) -> Description<'_> {
                described.description()
            }

            #[inline(always)]
            fn parts(scene: &PlainScene<Self>) -> Parts<'_> {
                scene.constant_parts()
            }
        }
    };
}
kinds!(capacity);

/// Tests whether two names are equal, in constant code.
pub(super) const fn is_same(one: &str, other: &str) -> bool {
    let (one, other) = (one.as_bytes(), other.as_bytes());
    let mut index = 0;
    while index < one.len() && index < other.len() && one[index] == other[index] {
        index += 1;
    }
    index == one.len() && index == other.len()
}

#[cfg(test)]
mod tests;
