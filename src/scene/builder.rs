//! The builder of constant scenes, which takes plain numbers and runs when the program is compiled.

use core::panic::Location;

use super::capacity::{Capacity, Counts, Room};
use super::description::{Described, Description};
use super::prepare;
use crate::background::Background;
use crate::camera::Camera;
use crate::error::Error;
use crate::error_kind::ErrorKind;
use crate::material::Material;
use crate::number::{Number, numbers};
use crate::shape::plane::Plane;
use crate::shape::{Corners, Normals};
use crate::vector::Position;

/// Largest number of shapes of a constant scene that may move.
const MOST_MOVING: usize = 16;

/// A builder of constant scenes, which takes their parts one by one. [`scene!`](crate::scene) writes its
/// calls.
///
/// Every method checks its arguments. A mistake stops the compiler with a message that names the part
/// and the fix. `R` is the room, written with [`room!`](crate::room). A scene that is filled while the
/// program runs is a [`RuntimeScene`](crate::RuntimeScene), which returns errors.
///
/// ```
/// use reflet::{Camera, Material, Scene, SceneBuilder, room};
///
/// const BALL: Scene<room!(spheres: 1, lights: 1)> = SceneBuilder::new()
///     .sphere([0.0; 3], 1.0, Material::new([1.0; 3]))
///     .light([3.0, -4.0, 6.0], [1.0; 3])
///     .build();
/// assert!(BALL.needs().spheres);
///
/// const TIN: Material = Material::new([0.8; 3]).mirror(0.3);
/// const CAN: SceneBuilder<room!(planes: 1, cylinders: 1, discs: 1)> = SceneBuilder::new()
///     .cylinder([0.0, 0.0, 1.0], [0.0, 0.0, 1.0], 1.0, 2.0, TIN)
///     .disc([0.0, 0.0, 2.0], [0.0, 0.0, 1.0], 1.0, TIN)
///     .plane([0.0; 3], [0.0, 0.0, 1.0], TIN)
///     .background([0.3, 0.4, 0.6])
///     .epsilon(0.01)
///     .motion([-3.0, -3.0, -3.0], [3.0, 3.0, 3.0])
///     .camera(Camera::look_at([0.0, -9.0, 3.0], [0.0, 0.0, 1.0], [0.0, 0.0, 1.0]));
/// assert_eq!(CAN.description().discs.len(), 1);
/// ```
///
/// A radius below 0 does not compile:
///
/// ```compile_fail
/// use reflet::{Material, Scene, SceneBuilder, room};
///
/// const BALL: Scene<room!(spheres: 1, lights: 1)> = SceneBuilder::new()
///     .sphere([0.0; 3], -1.0, Material::new([1.0; 3]))
///     .light([3.0, -4.0, 6.0], [1.0; 3])
///     .build();
/// ```
#[derive(Clone, Copy, Debug)]
pub struct SceneBuilder<R: Capacity> {
    pub(super) described: Described<R>,
    /// Kind and index of the shape that was added last, or `None` after a plane or a light.
    pub(super) last: Option<(&'static str, usize)>,
    moving: [Option<(&'static str, usize)>; MOST_MOVING],
    /// Where the builder was created. For [`scene!`](crate::scene) this is the macro.
    start: &'static Location<'static>,
}

impl<R: Capacity> SceneBuilder<R> {
    /// Panics if `fault` is `Some`. The text has the line of the call, unless the call comes from a macro:
    /// its place is then that of the macro, where the builder was created, too.
    #[track_caller]
    pub(super) const fn refuse(
        &self,
        part: &'static str,
        index: Option<usize>,
        fault: Option<ErrorKind>,
    ) {
        let Some(kind) = fault else { return };
        let (call, start) = (Location::caller(), self.start);
        let is_known = call.line() != start.line() || call.column() != start.column();
        let line = if is_known { Some(call.line()) } else { None };
        Error::new(part, index, kind).stop_in_line(line)
    }

    /// Sets the colour of rays that hit nothing; each component is 0 to 16. Defaults to black.
    #[track_caller]
    pub const fn background(mut self, color: [f64; 3]) -> Self {
        self.set_background(Background::of_color(numbers(color)));
        self
    }

    /// Sets a sky as the background: the direction straight up, and the colours straight down, at the
    /// horizon and straight up; each component is 0 to 16. [`Sky`](crate::description::Sky) has the formula.
    #[track_caller]
    pub const fn sky(mut self, up: [f64; 3], [below, horizon, above]: [[f64; 3]; 3]) -> Self {
        let colors = [numbers(below), numbers(horizon), numbers(above)];
        self.set_background(Background::of_sky(Position::new(up), colors));
        self
    }

    #[track_caller]
    const fn set_background(&mut self, background: Background) {
        self.described.background = background;
        if let Some((part, fault)) = background.fault() {
            self.refuse(part, None, Some(fault));
        }
    }

    /// Sets epsilon: how far above a surface its shadow rays and reflected rays start, in scene units.
    /// Defaults to 0.001.
    ///
    /// Epsilon must be above 0. The built scene rounds it to the nearest whole step of its grid, and
    /// refuses 2²⁸ steps or more: the radius of the ball that holds the shapes. A scene that has only
    /// planes takes any epsilon up to 2³⁰ scene units, because its ball grows with epsilon.
    ///
    /// Values below 2 steps become 2. A ray that leaves the inside of a sphere or cylinder can hit the
    /// same shape again: for such rays, values below 8 steps become 8, or 16 in a scene with cylinders.
    /// So no surface shadows itself, however small epsilon is. A light, a plane or the scene's camera
    /// that stands outside of the shapes' ball, and further from its middle than 2²² times epsilon, may
    /// be stored as a far point, which takes more instructions.
    ///
    /// If epsilon is too large, rays start beyond shapes that lie nearer to the surface than epsilon:
    /// shadows and reflections do not reach the place where two shapes touch. Choose an epsilon that is
    /// small compared with the smallest shape and the smallest gap.
    #[track_caller]
    pub const fn epsilon(mut self, epsilon: f64) -> Self {
        self.described.epsilon = Number::new(epsilon);
        let fault = prepare::epsilon_fault(self.described.epsilon);
        self.refuse("scene", None, fault);
        self
    }

    /// Sets the box in which shapes of the scene may move, by its lowest and its highest corner.
    ///
    /// The scene's grid is chosen for the whole box, so that a shape that moves in it changes no bit of
    /// the others. The ball around a shape that moves must stay inside of the box.
    #[track_caller]
    pub const fn motion(mut self, low: [f64; 3], high: [f64; 3]) -> Self {
        let motion = [Position::new(low), Position::new(high)];
        self.refuse("motion", None, prepare::motion_fault(motion));
        self.described.motion = Some(motion);
        self
    }

    /// Marks the shape that was added last as a shape that moves. [`scene!`](crate::scene) calls this.
    #[doc(hidden)]
    #[track_caller]
    pub const fn moves_as(mut self, name: &'static str) -> Self {
        let Some((part, index)) = self.last else {
            Error::of(name, ErrorKind::NothingMoves).stop();
        };
        let mut free = 0;
        while free < MOST_MOVING && self.moving[free].is_some() {
            free += 1;
        }
        if free == MOST_MOVING {
            Error::at(part, index, ErrorKind::TooManyMoving).stop();
        }
        self.moving[free] = Some((part, index));
        self
    }

    /// Returns kind and index of each shape that moves. The rest of the list is `None`.
    pub(crate) const fn moving(&self) -> &[Option<(&'static str, usize)>] {
        &self.moving
    }

    /// Sets the camera that the scene is usually viewed with. The scene's grid is chosen so that this
    /// camera is near, which takes fewer instructions. Any other camera can view the scene, too.
    pub const fn camera(mut self, camera: Camera) -> Self {
        self.described.camera = Some(camera);
        self
    }
}

/// The types of arguments in constant code: floats, by the names of the fields' types.
mod plain {
    pub type Position = [f64; 3];
    pub type Number = f64;
    pub type Corners = [[f64; 3]; 3];
    pub type Normals = Option<[[f64; 3]; 3]>;
}

macro_rules! builder {
    (
        { $declaration:tt [$($header:tt)*] [$($arguments:tt)*] }
        $({ $list:ident $kind:ident $described:ident $prepared:ident $room:ident $lists:ident $active:tt
            $set:ident $too_many:ident $without:ident
            $(#[$doc:meta])* $add:ident($($field:ident: $type:ident),*) })*
    ) => {
        #[doc(hidden)]
        impl<$($header)*> SceneBuilder<Room<$($arguments)*>> {
            /// Creates an empty scene with a black background and an epsilon of 0.001.
            #[track_caller]
            pub const fn new() -> Self {
                Self {
                    described: Described::new(),
                    last: None,
                    moving: [None; MOST_MOVING],
                    start: Location::caller(),
                }
            }

            $(
                $(#[$doc])*
                #[track_caller]
                pub const fn $kind(mut self, $($field: plain::$type,)* material: Material) -> Self {
                    let index = self.described.$list.len;
                    self.described.$list.refuse_more(stringify!($kind), ErrorKind::$too_many);
                    let material = self.described.materials.id_of(material);
                    let $kind = crate::shape::$described {
                        $($field: $type::new($field),)*
                        material,
                    };
                    self.refuse(stringify!($kind), Some(index), $kind.fault());
                    self.described.$list.push($kind);
                    self.last = Some((stringify!($kind), index));
                    self
                }
            )*

            /// Adds an infinite plane through `point`. The normal may have any length but 0.
            #[track_caller]
            pub const fn plane(mut self, point: [f64; 3], normal: [f64; 3], material: Material) -> Self {
                let index = self.described.planes.len;
                self.described.planes.refuse_more("plane", ErrorKind::TooManyPlanes);
                let plane = Plane {
                    point: Position::new(point),
                    normal: Position::new(normal),
                    material: self.described.materials.id_of(material),
                };
                self.refuse("plane", Some(index), plane.fault());
                self.described.planes.push(plane);
                self.last = None;
                self
            }

            /// Returns the description of the parts added so far.
            pub const fn description(&self) -> Description<'_> {
                self.described.description()
            }

            /// Returns the number of parts of each kind added so far.
            #[doc(hidden)]
            pub const fn counts(&self) -> Counts {
                self.description().counts()
            }

        }

        #[doc(hidden)]
        impl<$($header)*> Default for SceneBuilder<Room<$($arguments)*>> {
            fn default() -> Self {
                Self::new()
            }
        }
    };
}
kinds!(builder);

#[cfg(test)]
pub(crate) mod tests;
