//! Floor 0: what can be wrong with a description, in words that name the field and the fix.

use core::fmt;

macro_rules! faults {
    (
        $header:tt
        $({ $list:ident $kind:ident $described:ident $prepared:ident $room:ident $lists:ident $active:tt
            $nth:literal $too_many:ident $without:ident $($more:tt)* })*
    ) => {
        /// What is wrong with one part of a scene.
        #[derive(Clone, Copy, Debug, PartialEq, Eq)]
        #[non_exhaustive]
        pub enum Fault {
            /// A radius that is zero or negative.
            Radius,
            /// A height that is zero or negative.
            Height,
            /// A normal of length zero.
            Normal,
            /// An axis of length zero.
            Axis,
            /// A coordinate, radius or height that is not a finite number within ±2³⁰.
            Coordinate,
            /// A radius, or half a height, below 2⁻²² of the scene's extent: the format cannot hold it.
            Tiny,
            /// A scene too small as a whole for the format.
            Extent,
            /// A colour component outside 0 to 16.
            Color,
            /// An ambient coefficient outside 0 to 16.
            Ambient,
            /// A diffuse coefficient outside 0 to 16.
            Diffuse,
            /// A specular coefficient outside 0 to 16.
            Specular,
            /// A shininess outside 0 to 2²⁰.
            Shininess,
            /// A mirror share α outside 0 to 1.
            Mirror,
            /// A background component outside 0 to 16.
            Background,
            /// An epsilon that is zero, negative, or not smaller than the scene.
            Epsilon,
            /// A material so bright under the lights of its scene that the sum may exceed 30.
            Brightness,
            $(
                #[doc = concat!("More ", stringify!($list), " than the scene's type has room for.")]
                $too_many,
            )*
            /// More planes than the scene's type has room for.
            TooManyPlanes,
            /// More lights than the scene's type has room for.
            TooManyLights,
            /// More different materials than the scene's type has room for.
            TooManyMaterials,
            /// A material that was never added to this scene.
            UnknownMaterial,
            /// A text that is not a decimal number.
            Number,
        }

        impl Fault {
            /// One sentence that names the field and the fix.
            pub const fn words(self) -> &'static str {
                match self {
                    Self::Radius => "radius must be greater than 0",
                    Self::Height => "height must be greater than 0",
                    Self::Normal => "normal must not be zero",
                    Self::Axis => "axis must not be zero",
                    Self::Coordinate => {
                        "coordinates and sizes must be finite and within -2^30 to 2^30 scene units"
                    }
                    Self::Tiny => {
                        "radius and half the height must be at least 2^-22 of the scene's extent: \
                         enlarge it or shrink the scene"
                    }
                    Self::Extent => "the scene must be larger than 2^-30 scene units: scale it up",
                    Self::Color => "color components must be within 0 to 16",
                    Self::Ambient => "ambient must be within 0 to 16",
                    Self::Diffuse => "diffuse must be within 0 to 16",
                    Self::Specular => "specular must be within 0 to 16",
                    Self::Shininess => "shininess must be within 0 to 2^20",
                    Self::Mirror => "mirror must be within 0 to 1",
                    Self::Background => "background components must be within 0 to 16",
                    Self::Epsilon => "epsilon must be greater than 0 and smaller than the scene",
                    Self::Brightness => {
                        "color * (ambient + the sum over lights of (diffuse + specular) * light color), \
                         with and without color, must stay below 30: dim the material or the lights"
                    }
                    $(
                        Self::$too_many => concat!(
                            "too many ", stringify!($list), ": raise the scene type's ", $nth, " bound"
                        ),
                    )*
                    Self::TooManyPlanes => "too many planes: raise the scene type's second bound",
                    Self::TooManyLights => "too many lights: raise the scene type's fourth bound",
                    Self::TooManyMaterials => "too many materials: raise the scene type's fifth bound",
                    Self::UnknownMaterial => "material does not exist in this scene: add it first",
                    Self::Number => {
                        "number must be decimal digits with an optional sign, point and exponent, \
                         such as -1.5 or 2e-3"
                    }
                }
            }
        }
    };
}
kinds!(faults);

impl Fault {
    /// Stops the compiler with [`Fault::words`] where there is a fault; for constants.
    pub(crate) const fn refuse(fault: Option<Self>) {
        if let Some(fault) = fault {
            panic!("{}", fault.words());
        }
    }
}

impl fmt::Display for Fault {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        formatter.write_str(self.words())
    }
}

impl core::error::Error for Fault {}
