//! Floor 0: the list of the bounded kinds of shapes. It consists of tokens and knows no type.
//!
//! Code that exists once for each kind is written by a small macro that receives this list. Each such
//! macro stands beside the code it completes. Planes are not bounded; their code is written by hand.

/// Calls the macro `$write` with the list of the bounded kinds of shapes.
///
/// An optional second token `$next` is passed in front of the list: the macro to which `$write` hands the
/// list on, or a `$` with which `$write` declares a macro.
///
/// The first group holds the const parameters of a scene's type in three spellings: declared with
/// defaults, declared without, and named. The parameter of a new kind comes last and defaults to 0, so
/// that types written without it keep their meaning.
///
/// The entry of a kind holds, in this order:
/// - the name of its list; its own name, which is also its module's; its described type; its prepared
///   type;
/// - its const parameter; the type of its list in a `Capacity`; the type and the length of its active
///   list; the name of the method that moves a shape of this kind;
/// - the variant of `ErrorKind` for too many shapes; the method of `Needs` that leaves the kind out;
/// - the documentation of the methods that add a shape; the name of that method in the run-time scene;
///   the fields of the description without the material.
///
/// Rays test the kinds in the order of this list, and shapes are numbered in the same order.
macro_rules! kinds {
    ($write:ident $(, $next:tt)?) => {
        $write! {
            $($next)?
            {
                [const S: usize, const P: usize, const C: usize, const L: usize, const M: usize = 8, const D: usize = 0, const F: usize = 0]
                [const S: usize, const P: usize, const C: usize, const L: usize, const M: usize, const D: usize, const F: usize]
                [S, P, C, L, M, D, F]
            }
            {
                spheres sphere Sphere PreparedSphere
                S Spheres [ActiveSpheres 16] set_sphere
                TooManySpheres without_spheres
                /// Adds a sphere; its radius is greater than 0, in scene units.
                add_sphere(center: Position, radius: Number)
            }
            {
                cylinders cylinder Cylinder PreparedCylinder
                C Cylinders [ActiveCylinders 8] set_cylinder
                TooManyCylinders without_cylinders
                /// Adds an open cylinder with its middle at `center`. The axis may have any length but
                /// 0; radius and height are greater than 0, in scene units.
                add_cylinder(center: Position, axis: Position, radius: Number, height: Number)
            }
            {
                discs disc Disc PreparedDisc
                D Discs [ActiveDiscs D] set_disc
                TooManyDiscs without_discs
                /// Adds a flat disc, visible from both sides. The normal may have any length but 0; the
                /// radius is greater than 0, in scene units.
                add_disc(center: Position, normal: Position, radius: Number)
            }
            {
                triangles triangle Triangle PreparedTriangle
                F Triangles [ActiveTriangles F] set_triangle
                TooManyTriangles without_triangles
                /// Adds a triangle, visible from both sides. The corners must not lie on one line. `normals` are
                /// those at the corners, each of any length but 0, or `None` for a flat triangle.
                add_triangle(corners: Corners, normals: Normals)
            }
        }
    };
}

/// Writes the type `Room<..>` with these counts: its const parameters, in their order.
#[doc(hidden)]
#[macro_export]
macro_rules! __room {
    ($counts:expr) => {
        $crate::__private::Room<
            { $counts.spheres },
            { $counts.planes },
            { $counts.cylinders },
            { $counts.lights },
            { $counts.materials },
            { $counts.discs },
            { $counts.triangles },
        >
    };
}

/// Writes what one line of a [`scene!`](crate::scene) stands for: the call that adds the part, its name,
/// or its handle.
///
/// A part and its arguments are token trees. With any other kind of fragment, the compiler loses the
/// line on which the user wrote them.
#[doc(hidden)]
#[macro_export]
macro_rules! __line {
    (add $scene:ident $part:tt $arguments:tt) => {
        $scene.$part $arguments
    };
    (add $scene:ident $part:tt $handle:ident $arguments:tt) => {
        $scene.$part $arguments.moves_as($crate::__private::stringify!($handle))
    };
    (name $arguments:tt) => {
        ""
    };
    (name $handle:ident $arguments:tt) => {
        $crate::__private::stringify!($handle)
    };
    (handle $part:tt $arguments:tt) => {};
    (handle $part:tt $handle:ident $arguments:tt) => {
        #[doc = $crate::__private::concat!(
            "Handle of a ", $crate::__private::stringify!($part), " that can move."
        )]
        pub const $handle: $crate::Handle<$crate::__private::described::$part> =
            $crate::Handle::named(
                <Self as $crate::__private::SceneLines>::NAMES,
                $crate::__private::stringify!($handle),
            );
    };
}
