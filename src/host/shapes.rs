//! The list of all kinds of shapes: that of the bounded kinds, with planes where the reference asks
//! them. It is tokens only and knows no type.
//!
//! `kinds!(shapes, write)` calls `write!` with it. An entry is as in the list of bounded kinds. The
//! field of a plane that scene files call otherwise says so.

macro_rules! shapes {
    ($write:ident $header:tt $first:tt $($more:tt)*) => {
        $write! {
            $header
            $first
            {
                planes plane Plane PreparedPlane
                P Planes [] "second"
                TooManyPlanes without_planes
                /// Adds an infinite plane through `point`; the normal may have any length but 0.
                add_plane(#[serde(rename = "center")] point: Position, normal: Position)
            }
            $($more)*
        }
    };
}
