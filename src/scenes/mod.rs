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

pub use castle::Castle;
pub use columns::Columns;
pub use corner1::Corner1;
pub use cylinders::Cylinders;
pub use empty::Empty;
pub use floor::Floor;
pub use mirror1::Mirror1;
pub use mirror2::Mirror2;
pub use primitives::Primitives;
pub use shading_lights::ShadingLights;
pub use shading_speculars::ShadingSpeculars;

use crate::accel::Apart;
use crate::{Camera, FrameBuilder};

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
pub const NAMES: [&str; 11] = [
    Castle::NAME,
    ShadingLights::NAME,
    ShadingSpeculars::NAME,
    Columns::NAME,
    Mirror1::NAME,
    Mirror2::NAME,
    Primitives::NAME,
    Empty::NAME,
    Floor::NAME,
    Corner1::NAME,
    Cylinders::NAME,
];

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

/// Runs the visitor on the scene called `name`, or returns `None` if there is no such scene.
pub fn visit<V: Visitor>(name: &str, visitor: V) -> Option<V::Output> {
    Some(match name {
        Castle::NAME => visitor.visit::<Castle>(),
        ShadingLights::NAME => visitor.visit::<ShadingLights>(),
        ShadingSpeculars::NAME => visitor.visit::<ShadingSpeculars>(),
        Columns::NAME => visitor.visit::<Columns>(),
        Mirror1::NAME => visitor.visit::<Mirror1>(),
        Mirror2::NAME => visitor.visit::<Mirror2>(),
        Primitives::NAME => visitor.visit::<Primitives>(),
        Empty::NAME => visitor.visit::<Empty>(),
        Floor::NAME => visitor.visit::<Floor>(),
        Corner1::NAME => visitor.visit::<Corner1>(),
        Cylinders::NAME => visitor.visit::<Cylinders>(),
        _ => return None,
    })
}

#[cfg(test)]
mod tests;
