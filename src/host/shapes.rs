//! The list of all kinds of shapes: the bounded kinds of `kinds!`, with planes inserted as the second
//! kind. The reference tests the kinds in this order. The list is tokens only; it knows no type.
//!
//! `kinds!(shapes, write)` calls the macro `write!` with the const parameters of a scene's type, and
//! with one group of tokens for each kind:
//! - the name of its list (`spheres`), its own name (`sphere`) and its type (`Sphere`);
//! - the run-time scene's method that adds such a shape, with the fields of the description;
//! - its const parameter, and the `ErrorKind` for too many shapes of this kind;
//! - the fields with the names that a scene file uses.

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
