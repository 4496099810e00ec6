//! Eleven built-in scenes, as constants, for first experiments; tests and measurements use them, too.
//!
//! Each scene is a type. [`visit`] finds a scene by its name.
//!
//! ```
//! use reflet::scenes::{BuiltIn, Visitor, visit};
//!
//! struct CountSpheres;
//!
//! impl Visitor for CountSpheres {
//!     type Output = usize;
//!
//!     fn visit<S: BuiltIn>(self) -> usize {
//!         S::with_description(|scene| scene.spheres.len())
//!     }
//! }
//!
//! assert_eq!(visit("castle", CountSpheres), Some(40));
//! assert_eq!(visit("sandcastle", CountSpheres), None);
//! ```

mod castle;
mod columns;
mod corner1;
mod cylinders;
mod empty;
mod floor;
mod mirror1;
mod mirror2;
mod primitives;
#[cfg(feature = "host")]
#[cfg(test)]
mod sets;
mod shading_lights;
mod shading_speculars;

use crate::accel::Apart;
use crate::{Camera, FrameBuilder};

/// A scene that is built into the library.
pub trait BuiltIn: Apart {
    /// Name of the scene, such as `castle`.
    const NAME: &'static str;

    /// Camera that the scene was designed for.
    const CAMERA: Camera;

    /// Views the scene through a camera: 4 reflections, quality `Fast`, shading `BlinnPhong`.
    fn frame(camera: &Camera) -> FrameBuilder<'_, Self> {
        FrameBuilder::new(Self::INSTANCE, camera)
    }
}

/// A function that [`visit`] calls for a scene chosen by name: like a closure, but generic over the type
/// of the scene.
pub trait Visitor {
    /// Type of the visitor's result.
    type Output;

    /// Runs the visitor on the scene `S`.
    fn visit<S: BuiltIn>(self) -> Self::Output;
}

/// Declares the built-in scenes: the module and the type of each, in the order in which programs show
/// them. A scene has the name of its module.
macro_rules! built_in {
    ($($module:ident $scene:ident)*) => {
        $(
            pub use $module::$scene;

            impl BuiltIn for $scene {
                const NAME: &'static str = stringify!($module);
                const CAMERA: Camera = $module::CAMERA;
            }
        )*

        /// Names of the eleven built-in scenes, in the order in which programs show them.
        ///
        /// ```
        /// use reflet::scenes::{BuiltIn, NAMES};
        /// use reflet::scenes::{Columns, Cylinders, Primitives, ShadingLights, ShadingSpeculars};
        ///
        /// assert_eq!((NAMES[0], NAMES.len()), ("castle", 11));
        /// assert_eq!(NAMES[1..4], [ShadingLights::NAME, ShadingSpeculars::NAME, Columns::NAME]);
        /// assert!(NAMES.contains(&Cylinders::NAME) && NAMES.contains(&Primitives::NAME));
        /// ```
        pub const NAMES: [&str; 11] = [$($scene::NAME),*];

        /// Runs the visitor on the scene called `name`, or returns `None` if there is no such scene.
        pub fn visit<V: Visitor>(name: &str, visitor: V) -> Option<V::Output> {
            match name {
                $($scene::NAME => Some(visitor.visit::<$scene>()),)*
                _ => None,
            }
        }
    };
}

built_in! {
    castle Castle
    shading_lights ShadingLights
    shading_speculars ShadingSpeculars
    columns Columns
    mirror1 Mirror1
    mirror2 Mirror2
    primitives Primitives
    empty Empty
    floor Floor
    corner1 Corner1
    cylinders Cylinders
}

#[cfg(test)]
mod tests;
