//! What is wrong with a scene, and where.

use core::fmt;

use crate::fault::Fault;

macro_rules! error {
    (
        $header:tt
        $({ $list:ident $kind:ident $described:ident $prepared:ident $($more:tt)* })*
    ) => {
        /// A part of a scene, and what is wrong with it. Parts are counted from 0.
        #[derive(Clone, Copy, Debug, PartialEq, Eq)]
        #[non_exhaustive]
        pub enum SceneError {
            $(
                #[doc = concat!("The ", stringify!($kind), " with this number.")]
                $described(usize, Fault),
            )*
            /// The plane with this number.
            Plane(usize, Fault),
            /// The light with this number.
            Light(usize, Fault),
            /// The material with this number.
            Material(usize, Fault),
            /// The scene as a whole.
            Scene(Fault),
        }

        impl SceneError {
            /// The name of the part, its number if there are several, and what is wrong.
            const fn taken_apart(self) -> (&'static str, Option<usize>, Fault) {
                match self {
                    $(Self::$described(index, fault) => (stringify!($kind), Some(index), fault),)*
                    Self::Plane(index, fault) => ("plane", Some(index), fault),
                    Self::Light(index, fault) => ("light", Some(index), fault),
                    Self::Material(index, fault) => ("material", Some(index), fault),
                    Self::Scene(fault) => ("scene", None, fault),
                }
            }
        }
    };
}
kinds!(error);

impl SceneError {
    /// What is wrong.
    pub const fn fault(self) -> Fault {
        self.taken_apart().2
    }
}

impl fmt::Display for SceneError {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.taken_apart() {
            (part, Some(index), fault) => write!(formatter, "{part} {index}: {fault}"),
            (part, None, fault) => write!(formatter, "{part}: {fault}"),
        }
    }
}

impl core::error::Error for SceneError {}
