//! Floor 7: what a picture can be off by where its paths were ended, from its report.

use super::{Picture, Report};
use crate::color::Color;
use crate::material::PreparedMaterial;
use crate::number::{Brightness, Unit};
use crate::scene::World;

impl<W: World, Q, K> Picture<W, Q, K> {
    /// How far a pixel of this picture that was traced can be from one whose paths are followed for
    /// ever, on account of the reflections that were left out, as a share of white: 0 to 1.
    ///
    /// What follows the last reflection adds up to no more than the path's weight Π αₖ times the
    /// brightest colour that anything in the scene can have; the largest such weight is the
    /// report's. In integers, a few instructions for each material and light, once a frame; rounded
    /// up to 2⁻³⁰, and 1 where it is more: a display shows nothing above white. Materials that no shape
    /// has count, too.
    ///
    /// Of the pixels between traced ones (see [`crate::Quality::STRIDE`]) it says nothing; what they
    /// and rounding add does not depend on the number of reflections alone: `docs/error-time` has it
    /// for every built-in scene.
    ///
    /// ```
    /// use embedded_graphics::{pixelcolor::Rgb888, prelude::*};
    /// use reflet::{StaticFrame, scenes::{BuiltIn, Mirror2}};
    ///
    /// let bound = |reflections| {
    ///     let frame = Mirror2::frame(&Mirror2::CAMERA).reflections(reflections);
    ///     let picture = frame.sized(Size::new(32, 32));
    ///     let mut row = [Rgb888::BLACK; 32];
    ///     picture.cut_off_bound(&picture.row(16, 0, &mut row))
    /// };
    /// assert!(bound(8) < bound(2));
    /// ```
    #[must_use]
    pub fn cut_off_bound(&self, report: &Report) -> Unit {
        // Q2.30 · Q6.26, rounded up.
        let weight = report.cut_off.to_bits().unsigned_abs();
        let product = u128::from(weight) * u128::from(self.brightest());
        let bound = product.div_ceil(1 << 26).min(1 << 30);
        Unit::from_bits(bound as i32)
    }

    /// The largest component of any colour that a path can meet, in steps of 2⁻²⁶, rounded up.
    fn brightest(&self) -> u64 {
        let parts = self.world.parts();
        let own = parts.materials.iter().map(|it| self.brightest_of(it));
        let most = own.max().unwrap_or(0);
        let most = most.max(bits(parts.background.largest()));
        // What all colours are 255 parts of.
        (most * 256).div_ceil(255)
    }

    /// (ambient + Σ over the lights of (diffuse + specular) · light) · colour, at its brightest.
    fn brightest_of(&self, material: &PreparedMaterial) -> u64 {
        // The kernels' cosines and powers may be above 1 by their rounding, by far less than 2⁻¹⁵.
        let strongest = bits(material.diffuse) + bits(material.specular);
        let strongest = strongest + strongest.div_ceil(1 << 15);
        let lamps = self.world.parts().lights.iter().map(|light| light.color);
        let component = |axis: usize| {
            let of = |color: Color| color.components().get(axis).map_or(0, |it| bits(*it));
            // Each at most 16, so that a sum of 2¹⁶ lights fits.
            let light: u64 = lamps.clone().map(of).sum();
            let received = (u128::from(light) * u128::from(strongest)).div_ceil(1 << 26);
            let all = received + u128::from(bits(material.ambient));
            (all * u128::from(of(material.color))).div_ceil(1 << 26) as u64
        };
        (0..3).map(component).max().unwrap_or(0)
    }
}

fn bits(brightness: Brightness) -> u64 {
    u64::from(brightness.to_bits().unsigned_abs())
}
