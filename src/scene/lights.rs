//! How lights are added to a scene: lamps and suns, to constant scenes and while the program runs.

use super::builder::SceneBuilder;
use super::capacity::{Capacity, Room};
use super::{Handle, RuntimeScene};
use crate::error::Error;
use crate::error_kind::ErrorKind;
use crate::light::Light;
use crate::number::{Number, numbers};
use crate::vector::Position;

macro_rules! lights {
    (
        { $declaration:tt [$($header:tt)*] [$($arguments:tt)*] }
        $($kinds:tt)*
    ) => {
        #[doc(hidden)]
        impl<$($header)*> SceneBuilder<Room<$($arguments)*>> {
            /// Adds a point light. Each component of its colour is 0 to 16.
            #[track_caller]
            pub const fn light(self, position: [f64; 3], color: [f64; 3]) -> Self {
                self.lit(Light::lamp(Position::new(position), numbers(color)))
            }

            /// Adds a point light that falls off: at the distance d its strength is 1 / (1 + (d / range)²). `range` is in
            /// scene units, above 0, at most 2³⁰.
            ///
            /// ```
            /// use reflet::{Material, scene};
            ///
            /// scene! {
            ///     struct Lantern {
            ///         plane([0.0; 3], [0.0, 0.0, 1.0], Material::new([0.9, 0.8, 0.6]));
            ///         light_with_range([0.0, 0.0, 1.0], [4.0, 3.0, 2.0], 0.5);
            ///     }
            /// }
            /// assert!(reflet::needs::Needs::of::<Lantern>().ranges);
            /// ```
            #[track_caller]
            pub const fn light_with_range(
                self,
                position: [f64; 3],
                color: [f64; 3],
                range: f64,
            ) -> Self {
                let (position, range) = (Position::new(position), Number::new(range));
                self.lit(Light::ranged(position, numbers(color), range))
            }

            /// Adds a sun: a light that shines from one direction everywhere. `direction` points towards it and may
            /// have any length but 0. Each component of its colour is 0 to 16. No disc of it is seen.
            #[track_caller]
            pub const fn sun(self, direction: [f64; 3], color: [f64; 3]) -> Self {
                self.sun_with_disc(direction, color, 0.0)
            }

            /// Adds a sun whose disc is seen where a ray hits nothing, also in mirrors. `degrees` is the angle that
            /// the disc covers, 0 to 90; our own sun covers half a degree.
            #[track_caller]
            pub const fn sun_with_disc(self, direction: [f64; 3], color: [f64; 3], degrees: f64) -> Self {
                let (direction, disc) = (Position::new(direction), Number::new(degrees));
                self.lit(Light::sun(direction, numbers(color), disc))
            }

            #[track_caller]
            const fn lit(mut self, light: Light) -> Self {
                let index = self.described.lights.len;
                self.described.lights.refuse_more(light.kind(), ErrorKind::TooManyLights);
                self.refuse(light.kind(), Some(index), light.fault());
                self.described.lights.push(light);
                self.last = None;
                self
            }
        }
    };
}
kinds!(lights);

impl<R: Capacity> RuntimeScene<R> {
    /// Adds a point light and returns its handle. Each component of the colour is 0 to 16.
    ///
    /// # Errors
    /// The mistake in the light, or [`ErrorKind::TooManyLights`]. After an error the scene is unchanged.
    pub fn add_light(
        &mut self,
        position: impl Into<Position>,
        color: [impl Into<Number>; 3],
    ) -> Result<Handle<Light>, Error> {
        self.lit(Light::lamp(position.into(), color.map(Into::into)))
    }

    /// Adds a point light that falls off and returns its handle; see [`Light::range`].
    ///
    /// # Errors
    /// The mistake in the light, or [`ErrorKind::TooManyLights`]. After an error the scene is unchanged.
    pub fn add_light_with_range(
        &mut self,
        position: impl Into<Position>,
        color: [impl Into<Number>; 3],
        range: impl Into<Number>,
    ) -> Result<Handle<Light>, Error> {
        let color = color.map(Into::into);
        self.lit(Light::ranged(position.into(), color, range.into()))
    }

    /// Adds a sun and returns its handle: a light that shines from one direction everywhere. `direction` points
    /// towards it and may have any length but 0. Each component of the colour is 0 to 16. `degrees` is the angle that
    /// its disc covers where a ray hits nothing, 0 to 90; with 0 no disc is seen.
    ///
    /// ```
    /// use reflet::{RuntimeScene, room};
    ///
    /// let mut scene = RuntimeScene::<room!(lights: 1)>::new();
    /// let sun = scene.add_sun([3, -4, 6], [1.0, 0.9, 0.8], 0.5)?;
    /// let [described] = scene.description().lights else { unreachable!() };
    /// assert_eq!(described.sun.map(|disc| disc.to_f64()), Some(0.5));
    /// let mut scene = scene.build()?;
    /// scene.set_light(sun, [3, -4, 5])?; // it goes down
    /// # Ok::<(), reflet::Error>(())
    /// ```
    ///
    /// # Errors
    /// The mistake in the sun, or [`ErrorKind::TooManyLights`]. After an error the scene is unchanged.
    pub fn add_sun(
        &mut self,
        direction: impl Into<Position>,
        color: [impl Into<Number>; 3],
        degrees: impl Into<Number>,
    ) -> Result<Handle<Light>, Error> {
        let color = color.map(Into::into);
        self.lit(Light::sun(direction.into(), color, degrees.into()))
    }

    fn lit(&mut self, light: Light) -> Result<Handle<Light>, Error> {
        let (kind, fault) = (light.kind(), light.fault());
        let lights = &mut self.0.lights;
        let index = lights.add(light, fault, kind, ErrorKind::TooManyLights)?;
        Ok(Handle::new(index))
    }
}
