//! Floor 0: the list of bounded kinds of shapes. It is tokens only and knows no type.
//!
//! Whatever exists once a kind is written from this list by a small macro beside its other parts: the
//! list hands itself to that macro. Planes are no bounded kind; they are written by hand.

/// Calls a macro with the list of bounded kinds. A second name comes first in what that macro is given:
/// of the macro it hands the list on to.
///
/// In front stand the const parameters of a scene's type, in three spellings: declared with the
/// defaults, declared, and named. The parameter of a new kind is the last and 0 unless it is given, so
/// that the types which are written without it stay what they are.
///
/// A kind has, in this order:
/// - the name of its list and its own, which is its module's too; its type as it is described, and as it
///   is prepared;
/// - its parameter, the type of its list in a `Capacity`, what its active list is called and how many it holds, and which of the parameters it is, in words;
/// - the `ErrorKind` where there are too many, and the method of `Needs` that leaves the kind out;
/// - what the methods that add one say they do, the name of the run-time scene's, and the fields of the
///   description without the material.
///
/// The order of the kinds is the order in which a ray asks them, and so that of their numbers.
macro_rules! kinds {
    ($write:ident $(, $next:ident)?) => {
        $write! {
            $($next)?
            {
                [const S: usize, const P: usize, const C: usize, const L: usize, const M: usize = 8, const D: usize = 0]
                [const S: usize, const P: usize, const C: usize, const L: usize, const M: usize, const D: usize]
                [S, P, C, L, M, D]
            }
            {
                spheres sphere Sphere PreparedSphere
                S Spheres [ActiveSpheres 16] set_sphere
                TooManySpheres without_spheres
                /// Adds a sphere with a radius greater than 0.
                add_sphere(center: Position, radius: Number)
            }
            {
                cylinders cylinder Cylinder PreparedCylinder
                C Cylinders [ActiveCylinders 8] set_cylinder
                TooManyCylinders without_cylinders
                /// Adds an open cylinder around its `center`; the axis may have any length but 0, radius and
                /// height are greater than 0.
                add_cylinder(center: Position, axis: Position, radius: Number, height: Number)
            }
            {
                discs disc Disc PreparedDisc
                D Discs [ActiveDiscs D] set_disc
                TooManyDiscs without_discs
                /// Adds a flat disc, which is seen from both sides; the normal may have any length but 0, the
                /// radius is greater than 0.
                add_disc(center: Position, normal: Position, radius: Number)
            }
        }
    };
}

/// Writes the type of a room with these counts: the const parameters of the list, in their order.
#[doc(hidden)]
#[macro_export]
macro_rules! __room {
    ($counts:expr) => {
        $crate::__private::Room<
            { $counts.parameter("S") },
            { $counts.parameter("P") },
            { $counts.parameter("C") },
            { $counts.parameter("L") },
            { $counts.parameter("M") },
            { $counts.parameter("D") },
        >
    };
}

/// Writes the described type of a part.
#[doc(hidden)]
#[macro_export]
macro_rules! __described {
    (sphere) => {
        $crate::description::Sphere
    };
    (cylinder) => {
        $crate::description::Cylinder
    };
    (disc) => {
        $crate::description::Disc
    };
    // These cannot move: `SceneBuilder` says so.
    (plane) => {
        $crate::description::Plane
    };
    (light) => {
        $crate::description::Light
    };
}
