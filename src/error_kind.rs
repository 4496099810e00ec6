//! Floor 0: the kinds of errors, each with a message that names the field and the fix.

use core::fmt;

/// Writes the kinds of errors from two lists of variants, each with its message. The variants for too many bounded shapes
/// stand between them.
macro_rules! faults {
    (
        {
            { $($(#[$first_note:meta])* $first:ident $first_message:literal;)* }
            { $($(#[$last_note:meta])* $last:ident $last_message:literal;)* }
        }
        $header:tt
        $({ $list:ident $kind:ident $described:ident $prepared:ident $room:ident $lists:ident $active:tt
            $set:ident $too_many:ident $without:ident $($more:tt)* })*
    ) => {
        /// The kind of an [`Error`](crate::Error): what is wrong with a part of a scene, a camera or a
        /// call.
        ///
        /// A program that lets users edit a scene can mark the field that is wrong:
        ///
        /// ```
        /// use reflet::{ErrorKind, Material};
        ///
        /// fn field(kind: ErrorKind) -> &'static str {
        ///     match kind {
        ///         ErrorKind::Radius | ErrorKind::Tiny | ErrorKind::BelowEpsilon => "radius",
        ///         ErrorKind::Height => "height",
        ///         ErrorKind::Normal | ErrorKind::Axis => "direction",
        ///         ErrorKind::Coordinate | ErrorKind::Extent | ErrorKind::Corners => "position",
        ///         ErrorKind::Color | ErrorKind::Brightness => "color",
        ///         ErrorKind::Ambient => "ambient",
        ///         ErrorKind::Diffuse => "diffuse",
        ///         ErrorKind::Specular => "specular",
        ///         ErrorKind::Shininess => "shininess",
        ///         ErrorKind::Mirror => "mirror",
        ///         ErrorKind::Background => "background",
        ///         ErrorKind::Epsilon => "epsilon",
        ///         ErrorKind::View | ErrorKind::Up | ErrorKind::FieldOfView => "camera",
        ///         ErrorKind::TooManySpheres | ErrorKind::TooManyCylinders => "room",
        ///         ErrorKind::TooManyDiscs | ErrorKind::TooManyPlanes => "room",
        ///         ErrorKind::TooManyTriangles => "room",
        ///         ErrorKind::TooManyLights | ErrorKind::TooManyMaterials => "room",
        ///         ErrorKind::UnusedRoom => "room",
        ///         ErrorKind::UnknownMaterial => "material",
        ///         ErrorKind::Motion | ErrorKind::NothingMoves | ErrorKind::TooManyMoving => "motion",
        ///         ErrorKind::NoLight => "lights",
        ///         _ => "scene",
        ///     }
        /// }
        ///
        /// let error = Material::from_numbers([1, 1, 1], 0, 1, (0, -4), 0).unwrap_err();
        /// assert_eq!(field(error.kind()), "shininess");
        /// assert_eq!(error.kind().message(), "shininess must be within 0 to 2^20");
        /// ```
        #[derive(Clone, Copy, Debug, PartialEq, Eq)]
        #[cfg_attr(feature = "defmt", derive(defmt::Format))]
        #[non_exhaustive]
        pub enum ErrorKind {
            $($(#[$first_note])* $first,)*
            $(
                #[doc = concat!("More ", stringify!($list), " than the scene's type has room for.")]
                $too_many,
            )*
            $($(#[$last_note])* $last,)*
        }

        impl ErrorKind {
            /// Returns an English phrase that names the wrong field and its allowed range, or the fix.
            pub const fn message(self) -> &'static str {
                match self {
                    $(Self::$first => $first_message,)*
                    $(
                        Self::$too_many => concat!(
                            "too many ", stringify!($list), ": raise `", stringify!($list), "` in room!(..), or take fewer in a scene!"
                        ),
                    )*
                    $(Self::$last => $last_message,)*
                }
            }
        }
    };
}
kinds!(faults, {
    {
        /// A radius that is zero or negative.
        Radius "radius must be greater than 0";
        /// A height that is zero or negative.
        Height "height must be greater than 0";
        /// A normal of length zero.
        Normal "normal must not be zero";
        /// An axis of length zero.
        Axis "axis must not be zero";
        /// Corners of a triangle on one line, or almost: its smallest altitude is below 2⁻²⁰ of its longest side.
        Corners "corners must not lie on one line: make the smallest altitude at least 2^-20 of the longest side";
        /// A coordinate, radius or height that is not a finite number within ±2³⁰.
        Coordinate "coordinates and sizes must be finite and within -2^30 to 2^30 scene units";
        /// A radius, half a height or an altitude below 2⁻²² of the scene's extent: the format cannot hold it.
        Tiny "radius, half the height and a triangle's altitudes must be at least 2^-22 of the scene's extent: \
            enlarge it or shrink the scene";
        /// A shape that is not larger than an epsilon of 0.001 or less, and neither are all shapes
        /// together.
        BelowEpsilon "radius and height must be larger than epsilon, which is 0.001 by default: \
            enlarge the shape or set a smaller epsilon";
        /// Shapes that together measure no more than 2⁻³⁰ scene units: too small for the number
        /// format.
        Extent "extent must be larger than 2^-30 scene units: scale the scene up";
        /// A colour component outside 0 to 16.
        Color "color components must be within 0 to 16, where white is 1";
        /// An ambient coefficient outside 0 to 16.
        Ambient "ambient must be within 0 to 16";
        /// A diffuse coefficient outside 0 to 16.
        Diffuse "diffuse must be within 0 to 16";
        /// A specular coefficient outside 0 to 16.
        Specular "specular must be within 0 to 16";
        /// A shininess outside 0 to 2²⁰.
        Shininess "shininess must be within 0 to 2^20";
        /// A mirror coefficient α outside 0 to 1.
        Mirror "mirror must be within 0 to 1";
        /// A checker whose cells are smaller than 2⁻²⁷ of the scene's extent or larger than 2¹⁶ times, have a
        /// negative size, or no end along any axis.
        Checker "checker sizes must be 0 or 2^-27 to 2^16 of the scene's extent, and not all 0";
        /// A background component outside 0 to 16.
        Background "background components must be within 0 to 16";
        /// A sky whose `up` has length zero.
        Sky "up must not be zero";
        /// A sun whose direction has length zero, or whose disc is not within 0 to 90 degrees.
        Sun "direction must not be zero, and disc must be within 0 to 90 degrees";
        /// A range of a light that is not above 0, or above 2³⁰, or a sun's.
        Range "range must be greater than 0 and at most 2^30 scene units: a light without one does not fall off";
        /// An epsilon that is zero, negative, or not smaller than the scene's extent.
        Epsilon "epsilon must be greater than 0 and smaller than the scene";
        /// A material that may send out more than 30 times white under the lights of its scene.
        Brightness "color * (ambient + the sum over lights of (diffuse + specular) * light color), \
            with and without color, must stay below 30: dim the material or the lights";
    }
    {
        /// More planes than the scene's type has room for.
        TooManyPlanes "too many planes: raise `planes` in room!(..), or take fewer in a scene!";
        /// More lights than the scene's type has room for.
        TooManyLights "too many lights: raise `lights` in room!(..), or take fewer in a scene!";
        /// More materials than the scene's type has room for.
        TooManyMaterials "too many materials: raise `materials` in room!(..), or take fewer in a scene!";
        /// A [`MaterialId`](crate::MaterialId) of a material that was never added to this scene.
        UnknownMaterial "material does not exist in this scene: add it first";
        /// A [`Handle`](crate::Handle) of a part that this scene does not have, or that cannot move.
        UnknownHandle "handle is of another scene: use one that this scene returned";
        /// A room for more parts than the constant scene has: the unused room would take flash.
        UnusedRoom "room!(..) has room for more than the scene uses: lower it";
        /// A constant scene that is all black: surfaces scatter light, but no light and no ambient
        /// exists.
        NoLight "nothing lights the scene: add a light, or give a material some ambient";
        /// A constant scene in which more than 16 shapes move.
        TooManyMoving "at most 16 shapes of a constant scene move: use a RuntimeScene";
        /// A name for a part of a constant scene that cannot move, such as a plane or a light.
        NothingMoves "only bounded shapes of a constant scene can have a name and move: use a RuntimeScene";
        /// A motion box that is missing, has `low` above `high`, or does not hold the ball around a part that moves.
        Motion "motion box must hold the ball around every part that moves, in every place: declare or enlarge it";
        /// A camera whose position and target are the same point.
        View "target must differ from the position";
        /// A camera whose `up` is zero or within 2⁻²⁴ of parallel to the view direction.
        Up "up must not be zero or parallel to the view direction";
        /// A field of view that is not between 0.001 and 179.999 degrees.
        FieldOfView "fov must be between 0.001 and 179.999 degrees";
        /// A need of a scene that a [`NeedsLimit`](crate::needs::NeedsLimit) leaves out.
        Limit "the scene needs this, but its NeedsLimit leaves it out: allow it there";
        /// A scene that has changed since its frame was prepared, or is another scene.
        Changed "changed since the frame was prepared: prepare the frame again";
        /// A text that is not a decimal number, such as `"1,5"`.
        Number "text must be decimal digits with an optional sign, point and exponent, such as -1.5 or 2e-3";
    }
});

impl fmt::Display for ErrorKind {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        formatter.write_str(self.message())
    }
}
