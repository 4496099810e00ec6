//! Floor 2: materials of surfaces: colour, Phong coefficients and reflection.

use crate::checker::Checker;
use crate::color::{Color, brightness};
use crate::error::Error;
use crate::error_kind::ErrorKind;
use crate::number::{Brightness, Exponent, Number, Unit, numbers};

/// Material as the user describes it: colour, Phong coefficients and share of reflection.
///
/// | field | range |
/// |---|---|
/// | color, ambient, diffuse, specular | 0 to 16 |
/// | shininess | 0 to 2²⁰, any real number; small whole numbers are fastest |
/// | mirror (α) | 0 (no reflection) to 1 (only reflection) |
/// | checker | a second colour, 0 to 16; size of a cell along each axis: 0, or 2⁻²⁷ to 2¹⁶ of the scene's extent |
///
/// ```
/// use reflet::Material;
/// const GOLD: Material =
///     Material::new([0.7, 0.6, 0.0]).ambient(0.2).diffuse(0.4).specular(0.8, 4.0).mirror(0.4);
/// ```
///
/// Numbers that are known at run time are checked there:
///
/// ```
/// use reflet::{ErrorKind, Material, Number};
/// let gold = Material::from_numbers([0.7, 0.6, 0.0], 0.2, 0.4, (0.8, 4.0), 0.4)?;
/// assert_eq!(gold.described_color()[1], Number::new(0.6));
/// let [ambient, diffuse, specular, shininess, mirror] = gold.described_coefficients();
/// assert_eq!([ambient, diffuse, specular], [0.2, 0.4, 0.8].map(Number::new));
/// assert_eq!((shininess, mirror), (Number::from(4), Number::new(0.4)));
///
/// let glare = Material::from_numbers([1, 1, 1], 0, 1, (0, 1), 2);
/// assert_eq!(glare.unwrap_err().kind(), ErrorKind::Mirror);
/// # Ok::<(), reflet::Error>(())
/// ```
///
/// A constant with a value out of range does not compile:
///
/// ```compile_fail
/// use reflet::Material;
/// const GLARE: Material = Material::new([1.0; 3]).mirror(1.5);
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Material {
    color: [Number; 3],
    ambient: Number,
    diffuse: Number,
    specular: Number,
    shininess: Number,
    mirror: Number,
    checker: Option<Checker>,
}

impl Material {
    /// Placeholder for an unused slot in a list of described materials. It is all zeros, which take no
    /// flash.
    pub(crate) const NONE: Self = Self {
        color: [Number::ZERO; 3],
        ambient: Number::ZERO,
        diffuse: Number::ZERO,
        specular: Number::ZERO,
        shininess: Number::ZERO,
        mirror: Number::ZERO,
        checker: None,
    };

    /// Creates a matte material: ambient 0.2, diffuse 0.8, no highlight, no reflection.
    ///
    /// Meant for constants. Panics if a component is outside of 0 to 16; in a constant, that is an error
    /// of the compiler. The other methods that take plain numbers do the same.
    #[track_caller]
    pub const fn new(color: [f64; 3]) -> Self {
        Self {
            color: numbers(color),
            ambient: Number::new(0.2),
            diffuse: Number::new(0.8),
            shininess: Number::ONE,
            ..Self::NONE
        }
        .checked()
    }

    /// Sets the ambient coefficient, 0 to 16: the share of the colour that is visible without any light.
    #[track_caller]
    pub const fn ambient(mut self, coefficient: f64) -> Self {
        self.ambient = Number::new(coefficient);
        self.checked()
    }

    /// Sets the diffuse coefficient, 0 to 16: the share of the light that the surface scatters evenly
    /// (Lambert).
    #[track_caller]
    pub const fn diffuse(mut self, coefficient: f64) -> Self {
        self.diffuse = Number::new(coefficient);
        self.checked()
    }

    /// Sets the strength, 0 to 16, and the shininess, 0 to 2²⁰, of the highlight.
    ///
    /// With shininess 0, the highlight has the same strength everywhere. In Phong's shading, it covers
    /// only points where the mirrored light points to the viewer's side: r · v > 0.
    #[track_caller]
    pub const fn specular(mut self, coefficient: f64, shininess: f64) -> Self {
        self.specular = Number::new(coefficient);
        self.shininess = Number::new(shininess);
        self.checked()
    }

    /// Sets α, 0 to 1: the share of the visible colour that is a reflection.
    #[track_caller]
    pub const fn mirror(mut self, alpha: f64) -> Self {
        self.mirror = Number::new(alpha);
        self.checked()
    }

    /// Gives every other cell of space another colour; each component is 0 to 16. The size is that of a cell
    /// along x, y and z, in scene units, and 0 along an axis in which a cell has no end. [`Checker`] has the
    /// formula.
    #[track_caller]
    pub const fn checker(mut self, color: [f64; 3], size: [f64; 3]) -> Self {
        self.checker = Some(Checker::new(numbers(color), numbers(size)));
        self.checked()
    }

    /// As [`Material::checker`], from numbers known at run time.
    ///
    /// # Errors
    /// [`ErrorKind::Color`] or [`ErrorKind::Checker`] if the colour or the size is out of range.
    pub fn with_checker(
        mut self,
        color: [impl Into<Number>; 3],
        size: [impl Into<Number>; 3],
    ) -> Result<Self, Error> {
        self.checker = Some(Checker::new(color.map(Into::into), size.map(Into::into)));
        self.valid()
    }

    /// Creates a material from numbers known at run time.
    ///
    /// # Errors
    /// Returns the fault of the first field that is out of range.
    pub fn from_numbers(
        color: [impl Into<Number>; 3],
        ambient: impl Into<Number>,
        diffuse: impl Into<Number>,
        (specular, shininess): (impl Into<Number>, impl Into<Number>),
        mirror: impl Into<Number>,
    ) -> Result<Self, Error> {
        Self {
            color: color.map(Into::into),
            ambient: ambient.into(),
            diffuse: diffuse.into(),
            specular: specular.into(),
            shininess: shininess.into(),
            mirror: mirror.into(),
            checker: None,
        }
        .valid()
    }

    /// Returns the material if all fields are in range, else the fault of the first that is not.
    fn valid(self) -> Result<Self, Error> {
        match self.fault() {
            Some(fault) => Err(Error::of("material", fault)),
            None => Ok(self),
        }
    }

    /// Returns the material if all fields are in range. Panics otherwise.
    #[track_caller]
    const fn checked(self) -> Self {
        Error::refuse("material", self.fault());
        self
    }

    /// Returns the fault of the first field that is out of range, or `None`.
    const fn fault(&self) -> Option<ErrorKind> {
        if !is_color(self.color) {
            Some(ErrorKind::Color)
        } else if !self.ambient.is_within(0, Color::MAX) {
            Some(ErrorKind::Ambient)
        } else if !self.diffuse.is_within(0, Color::MAX) {
            Some(ErrorKind::Diffuse)
        } else if !self.specular.is_within(0, Color::MAX) {
            Some(ErrorKind::Specular)
        } else if !self.shininess.is_within(0, Exponent::MAX) {
            Some(ErrorKind::Shininess)
        } else if !self.mirror.is_within(0, 1) {
            Some(ErrorKind::Mirror)
        } else if let Some(checker) = &self.checker {
            checker.fault()
        } else {
            None
        }
    }

    /// Tests whether two materials are equal. It can be called in constants, unlike `==`.
    pub(crate) const fn same(&self, other: &Self) -> bool {
        are_same(self.color, other.color)
            && are_same(
                self.described_coefficients(),
                other.described_coefficients(),
            )
            && match (&self.checker, &other.checker) {
                (Some(one), Some(other)) => one.same(other),
                (None, None) => true,
                _ => false,
            }
    }

    /// Returns the described colour: red, green and blue.
    pub const fn described_color(&self) -> [Number; 3] {
        self.color
    }

    /// Returns the described checker, if there is one.
    pub const fn described_checker(&self) -> Option<Checker> {
        self.checker
    }

    /// Returns the described coefficients: ambient, diffuse, specular, shininess and α, in this order.
    pub const fn described_coefficients(&self) -> [Number; 5] {
        [
            self.ambient,
            self.diffuse,
            self.specular,
            self.shininess,
            self.mirror,
        ]
    }
}

/// Tests whether every component of a colour is within 0 to [`Color::MAX`].
pub(crate) const fn is_color([red, green, blue]: [Number; 3]) -> bool {
    red.is_within(0, Color::MAX) && green.is_within(0, Color::MAX) && blue.is_within(0, Color::MAX)
}

/// Tests whether all numbers are equal, in pairs. It can be called in constants, unlike `==`.
pub(crate) const fn are_same<const N: usize>(one: [Number; N], other: [Number; N]) -> bool {
    let mut index = 0;
    while index < N && one[index].same(other[index]) {
        index += 1;
    }
    index == N
}

/// Material as the kernels read it, in fixed point.
#[derive(Clone, Copy, Debug)]
pub struct PreparedMaterial {
    /// Colour, scaled by [`Color::in_levels`].
    pub(crate) color: Color,
    pub(crate) ambient: Brightness,
    pub(crate) diffuse: Brightness,
    pub(crate) specular: Brightness,
    pub(crate) shininess: Exponent,
    /// Share of reflection α, 0 to 1.
    pub(crate) mirror: Unit,
}

impl PreparedMaterial {
    /// Placeholder for an unused slot: a scene's type may allow more materials than the scene has.
    pub(crate) const NONE: Self = Self::new(&Material::new([0.0; 3]));

    /// Tests whether the material reflects: α is above 0.
    #[inline(always)]
    pub(crate) const fn mirrors(&self) -> bool {
        self.mirror.to_bits() > 0
    }

    /// Tests whether a surface of the material can send light of its own, besides what it mirrors. A black one cannot.
    #[inline(always)]
    pub(crate) const fn has_own(&self) -> bool {
        self.ambient.to_bits() | self.diffuse.to_bits() | self.specular.to_bits() != 0
    }

    /// Converts a described material to fixed point: coefficients to 2⁻²⁶, α to 2⁻³⁰. Those of a black one are 0.
    pub(crate) const fn new(material: &Material) -> Self {
        let color = Color::from_numbers(material.color).in_levels();
        let is_black = color.largest().to_bits() == 0 && material.checker.is_none();
        let lit = if is_black { &Material::NONE } else { material };
        Self {
            color,
            ambient: brightness(lit.ambient),
            diffuse: brightness(lit.diffuse),
            specular: brightness(lit.specular),
            shininess: Exponent::new(material.shininess),
            mirror: Unit::from_bits(material.mirror.quantised(30)),
        }
    }
}

#[cfg(test)]
mod tests;
