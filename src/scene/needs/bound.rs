//! Limits: the most that a scene may need. What lies beyond a limit is not linked.

use super::{Mirrors, Needs, Shininess};
use crate::error::Error;
use crate::error_kind::ErrorKind;

/// The most that a scene may need, as a type; see [`Limited`](crate::needs::Limited).
///
/// ```
/// use reflet::needs::{Mirrors, Needs, NeedsLimit};
///
/// /// Whatever scene comes, nothing in it mirrors.
/// struct Matte;
///
/// impl NeedsLimit for Matte {
///     const NEEDS: Needs = Needs::ALL.without_mirrors();
/// }
/// assert!(Matte::NEEDS.mirrors == Mirrors::None);
/// ```
pub trait NeedsLimit {
    /// The most that is needed.
    const NEEDS: Needs;
}

impl Needs {
    /// Whether a scene that needs this needs no more than `bound`.
    ///
    /// # Errors
    /// The first thing that the bound leaves out.
    pub const fn within(&self, bound: &Self) -> Result<(), Error> {
        let (needed, allowed) = (self.levels(), bound.levels());
        let mut index = 0;
        while index < needed.len() {
            let (need, level) = needed[index];
            if level > allowed[index].1 {
                return Err(Error::of(need, ErrorKind::Limit));
            }
            index += 1;
        }
        Ok(())
    }

    /// The same without planes.
    #[must_use]
    pub const fn without_planes(self) -> Self {
        Self {
            planes: false,
            ..self
        }
    }

    /// The same without lights, and so without shadows and highlights.
    #[must_use]
    pub const fn without_lights(self) -> Self {
        Self {
            lights: false,
            shadows: false,
            sets: false,
            ..self.without_highlights()
        }
    }

    /// The same without highlights.
    #[must_use]
    pub const fn without_highlights(self) -> Self {
        Self {
            highlights: false,
            shininess: Shininess::None,
            ..self
        }
    }

    /// The same with no powers but these.
    #[must_use]
    pub const fn with_shininess(self, shininess: Shininess) -> Self {
        Self { shininess, ..self }
    }

    /// The same without mirrors.
    #[must_use]
    pub const fn without_mirrors(self) -> Self {
        Self {
            mirrors: Mirrors::None,
            reflections: 0,
            mirrored: false,
            ..self
        }
    }

    /// The same with no mirrors but these.
    #[must_use]
    pub const fn with_mirrors(self, mirrors: Mirrors) -> Self {
        match mirrors {
            Mirrors::None => self.without_mirrors(),
            _ => Self { mirrors, ..self },
        }
    }

    /// The same with so many reflections at most. What lies beyond is cut off, not refused.
    #[must_use]
    pub const fn with_reflections(self, reflections: u8) -> Self {
        Self {
            reflections,
            ..self
        }
    }

    /// The same in grey.
    #[must_use]
    pub const fn without_colors(self) -> Self {
        Self {
            colors: false,
            ..self
        }
    }
}

/// Limits a path to `N` reflections when the program is compiled: with 0, no code for mirrors is linked.
#[derive(Clone, Copy, Debug)]
pub struct MostReflections<const N: u8>;

impl<const N: u8> NeedsLimit for MostReflections<N> {
    const NEEDS: Needs = Needs::ALL.with_reflections(N);
}
