//! A scene as it was described, and a walk through its bounded shapes whatever their kinds.

use crate::camera::Camera;
use crate::light::Light;
use crate::material::Material;
use crate::number::Number;
use crate::shape::Extent;
use crate::shape::plane::Plane;

macro_rules! description {
    (
        $header:tt
        $($list:ident $lists:ident $room:tt $kind:ident $described:ident $prepared:ident { $($more:tt)* })*
    ) => {
        /// A scene as it was described: plain numbers, before they are laid on the grid.
        #[derive(Clone, Copy, Debug)]
        pub struct Description<'a> {
            $(
                #[doc = concat!("The ", stringify!($list), ".")]
                pub $list: &'a [crate::shape::$described],
            )*
            /// The planes.
            pub planes: &'a [Plane],
            /// The lights.
            pub lights: &'a [Light],
            /// The materials the shapes name.
            pub materials: &'a [Material],
            /// What a ray that meets nothing adds.
            pub background: [Number; 3],
            /// How far above a surface rays start that leave it; see [`SceneBuilder::epsilon`](crate::SceneBuilder::epsilon).
            pub epsilon: Number,
            /// The camera the scene is meant to be seen with first.
            pub camera: Option<Camera>,
        }

        impl Description<'_> {
            /// The extent of a bounded shape with this number; the kinds follow each other.
            pub(super) const fn extent(&self, number: usize) -> Option<Extent> {
                $(
                    if number < self.$list.len() {
                        return Some(self.$list[number].extent());
                    }
                    let number = number - self.$list.len();
                )*
                let _ = number;
                None
            }

            /// The smallest epsilon of rays inside of a shape, in steps: what the strictest kind asks for,
            /// and not less than `least`.
            pub(super) const fn smallest_inside(&self, least: i32) -> i32 {
                let mut smallest = least;
                $(
                    let own = crate::shape::$prepared::SMALLEST_INSIDE;
                    if !self.$list.is_empty() && own > smallest {
                        smallest = own;
                    }
                )*
                smallest
            }
        }
    };
}
kinds!(description);
