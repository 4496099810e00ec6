//! The list of all kinds of shapes: that of the bounded kinds, with planes where the reference asks
//! them. It is tokens only and knows no type.
//!
//! `kinds!(shapes, write)` calls `write!` with the const parameters of a scene's type, and of each kind:
//! the name of its list and its own, its type, the run-time scene's method that adds one with the fields
//! of its description, its const parameter, the `Fault` where there are too many, and the fields as a
//! scene file calls them.

macro_rules! shapes {
    (all of $write:ident { $declaration:tt $header:tt $parameters:tt } $({
        $list:ident $kind:ident $described:ident $prepared:ident $room:ident $lists:ident $active:tt
        $set:ident $too_many:ident $without:ident
        $(#[$doc:meta])* $add:ident($($(#[$key:meta])* $field:ident: $type:ident),*)
    })*) => {
        $write! {
            $parameters
            $({
                $list $kind $described $add($($field: $type)*)
                $room $too_many { $($(#[$key])* pub $field: $type,)* }
            })*
        }
    };
    ($write:ident $header:tt $first:tt $($more:tt)*) => {
        shapes! {
            all of $write $header
            $first
            {
                planes plane Plane PreparedPlane P Planes [] set_plane TooManyPlanes without_planes
                add_plane(#[serde(rename = "center")] point: Position, normal: Position)
            }
            $($more)*
        }
    };
}
