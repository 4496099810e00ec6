//! Floor 0: the list of the kinds of bounded shapes. It contains only tokens and knows no type.
//!
//! Code that is needed once for each kind is written by small macros, which stand in the files that need
//! the code. The list passes itself to such a macro. Planes are not bounded; their code is written by
//! hand.

/// Calls the macro `$write` with the list of the kinds of bounded shapes. If `$next` is given, it is
/// passed before the list: the macro to which `$write` passes the list on.
///
/// The list begins with the const parameters of a scene's type, in three forms: declared with defaults,
/// declared, and named. A new kind adds its parameter at the end, with the default 0, so that types
/// written without it stay the same.
///
/// Each kind has these tokens, in this order:
/// - the name of its list; its own name, which is also its module's; the type of its description; its
///   prepared type;
/// - its const parameter; the type of its list in a `Capacity`; the name and the capacity of its active
///   list; the position of the parameter, as a word;
/// - the `ErrorKind` for too many shapes; the method of `Needs` that leaves the kind out;
/// - the documentation of the methods that add a shape; the name of the method of a run-time scene; the
///   fields of the description without the material.
///
/// Rays test the kinds in this order, and the numbers of the shapes follow it.
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
                /// Adds an open cylinder around its `center`. The axis may have any length except 0.
                /// Radius and height are greater than 0.
                add_cylinder(center: Position, axis: Position, radius: Number, height: Number)
            }
            {
                discs disc Disc PreparedDisc
                D Discs [ActiveDiscs D] set_disc
                TooManyDiscs without_discs
                /// Adds a flat disc, which is visible from both sides. The normal may have any length
                /// except 0. The radius is greater than 0.
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
