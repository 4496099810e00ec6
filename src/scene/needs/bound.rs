//! Limits of needs: the features that a scene may use. Code beyond a limit is not linked.

use super::{Mirrors, Needs, Shininess};
use crate::error::Error;
use crate::error_kind::ErrorKind;

/// A limit of needs as a type: the most that a scene may need. [`Limited`](crate::needs::Limited) uses
/// it.
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
    /// Largest needs that a scene may have.
    const NEEDS: Needs;

    /// Whether code within the limit is linked even if the scene does not need it. Measurements use it to show what needs
    /// save.
    #[doc(hidden)]
    const IS_LINKED_WHOLE: bool = false;
}

impl Needs {
    /// Checks that these needs are no more than `bound`.
    ///
    /// ```
    /// use reflet::ErrorKind;
    /// use reflet::needs::{Mirrors, Needs};
    ///
    /// const CURVED: Needs = Needs::ALL.without_planes().without_discs().without_triangles();
    /// const ROUND: Needs = CURVED.without_cylinders();
    /// assert!(ROUND.spheres && ROUND.within(&Needs::ALL).is_ok());
    /// assert!(ROUND.without_spheres().without_sky().is_nothing());
    ///
    /// let error = Needs::ALL.within(&ROUND).unwrap_err();
    /// assert_eq!((error.part(), error.kind()), ("cylinders", ErrorKind::Limit));
    ///
    /// let dim = Needs::ALL.without_lights().without_highlights().without_colors();
    /// let both = ROUND.both(&dim.with_mirrors(Mirrors::All).with_reflections(2));
    /// assert!(both.spheres && !both.planes && !both.lights && !both.highlights && !both.colors);
    /// assert_eq!((both.mirrors, both.reflections), (Mirrors::All, 2));
    /// let mirrors = both.list().into_iter().find(|need| need.name == "mirrors").unwrap();
    /// assert!(mirrors.is_needed && mirrors.why.contains("every mirror is 1"));
    /// ```
    ///
    /// # Errors
    /// [`ErrorKind::Limit`] with the name of the first need that is more; reflections and the choice of
    /// shadow candidates are never refused.
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

    /// Returns these needs without planes.
    #[must_use]
    pub const fn without_planes(self) -> Self {
        Self {
            planes: false,
            plane_mirrors: false,
            facing_mirrors: false,
            ..self
        }
    }

    /// Returns these needs without lights, and so without shadows and highlights.
    #[must_use]
    pub const fn without_lights(self) -> Self {
        Self {
            lights: false,
            near_lights: false,
            far_lights: false,
            ranges: false,
            shadows: false,
            sets: false,
            ..self.without_highlights()
        }
    }

    /// Returns these needs for scenes whose lights do not fall off with distance.
    #[must_use]
    pub const fn without_ranges(mut self) -> Self {
        self.ranges = false;
        self
    }

    /// Returns these needs without highlights.
    #[must_use]
    pub const fn without_highlights(self) -> Self {
        Self {
            highlights: false,
            shininess: Shininess::None,
            ..self
        }
    }

    /// Returns these needs with highlights of no other powers than `shininess`.
    #[must_use]
    pub const fn with_shininess(self, shininess: Shininess) -> Self {
        Self { shininess, ..self }
    }

    /// Returns these needs without mirrors, and so without reflections.
    #[must_use]
    pub const fn without_mirrors(self) -> Self {
        Self {
            mirrors: Mirrors::None,
            reflections: 0,
            mirrored: false,
            plane_mirrors: false,
            facing_mirrors: false,
            ..self
        }
    }

    /// Returns these needs with no other mirrors than `mirrors`.
    #[must_use]
    pub const fn with_mirrors(self, mirrors: Mirrors) -> Self {
        match mirrors {
            Mirrors::None => self.without_mirrors(),
            _ => Self { mirrors, ..self },
        }
    }

    /// Returns these needs with at most `reflections` reflections of a path, 0 to 255. A scene that
    /// could use more is not refused: its paths are cut off.
    #[must_use]
    pub const fn with_reflections(mut self, reflections: u8) -> Self {
        self.reflections = reflections;
        self
    }

    /// Returns these needs for scenes without checkers.
    #[must_use]
    pub const fn without_checkers(mut self) -> Self {
        self.checkers = false;
        self
    }

    /// Returns these needs for scenes whose background has one colour.
    #[must_use]
    pub const fn without_sky(self) -> Self {
        Self { sky: false, ..self }
    }

    /// Returns these needs for scenes in grey, whose colours are computed in one channel.
    #[must_use]
    pub const fn without_colors(mut self) -> Self {
        self.colors = false;
        self
    }
}

/// A limit of `N` reflections for each path, 0 to 255, set when the program is compiled.
///
/// With 0, no code for mirrors is linked.
///
/// ```
/// use embedded_graphics::{mock_display::MockDisplay, pixelcolor::Rgb888};
/// use reflet::needs::{Limited, MostReflections};
/// use reflet::scenes::{BuiltIn, Mirror2};
///
/// let once = Limited::<_, MostReflections<1>>::new(&Mirror2)?;
/// let mut display = MockDisplay::<Rgb888>::new();
/// let report = once.frame(&Mirror2::CAMERA).reflections(1).draw(&mut display).unwrap();
/// assert!(report.rays <= 2 * 64 * 64); // a camera ray and one reflection for each pixel
/// # Ok::<(), reflet::Error>(())
/// ```
#[derive(Clone, Copy, Debug)]
pub struct MostReflections<const N: u8>;

impl<const N: u8> NeedsLimit for MostReflections<N> {
    const NEEDS: Needs = Needs::ALL.with_reflections(N);
}
