//! Scenes written in plain numbers and built by the compiler.

use super::capacity::{Capacity, Counts, Room};
use super::description::{Described, Description};
use super::prepare;
use crate::camera::Camera;
use crate::error::Error;
use crate::error_kind::ErrorKind;
use crate::light::Light;
use crate::material::Material;
use crate::number::Number;
use crate::shape::plane::Plane;
use crate::vector::Position;

/// The most parts of a constant scene that may move.
const MOST_MOVING: usize = 16;

/// The description of a constant scene, part by part; [`scene!`](crate::scene) writes it.
///
/// Every method checks its arguments. A mistake stops the compiler with a message that names the part
/// and the fix. The room is a type, [`room!`](crate::room). A scene that is filled while the program runs
/// is a [`RuntimeScene`](crate::RuntimeScene), which returns errors.
///
/// ```
/// use reflet::{Material, Scene, SceneBuilder, room};
///
/// const BALL: Scene<room!(spheres: 1, lights: 1)> = SceneBuilder::new()
///     .sphere([0.0; 3], 1.0, Material::new([1.0; 3]))
///     .light([3.0, -4.0, 6.0], [1.0; 3])
///     .build();
/// # let _ = BALL;
/// ```
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
    described: Described<R>,
    /// Name and index of the part that was added last.
    last: Option<(&'static str, usize)>,
    moving: [Option<(&'static str, usize)>; MOST_MOVING],
}

impl<R: Capacity> SceneBuilder<R> {
    /// What a ray that meets nothing adds, 0 to 16 a component; black unless it is named.
    pub const fn background(mut self, color: [f64; 3]) -> Self {
        self.described.background = numbers(color);
        Error::refuse(
            "scene",
            prepare::background_fault(self.described.background),
        );
        self
    }

    /// How far above a surface the shadow rays and mirrored rays start that leave it, in scene units;
    /// 0.001 unless it is named.
    ///
    /// It must be above 0. The built scene has it in whole steps of its grid, rounded to the nearest, and
    /// refuses 2²⁸ steps and more: the radius of the ball that holds the shapes. A scene of planes alone
    /// takes any epsilon up to 2³⁰ scene units, because its ball grows with it.
    ///
    /// Less than 2 steps become 2. A ray that leaves the inside of a sphere or cylinder can meet the same
    /// shape again; for it less than 8 steps become 8, or 16 in a scene with cylinders. So no surface
    /// shadows itself, however small epsilon is. But lights, planes and the scene's camera that stand
    /// outside of the shapes' ball and further from its middle than 2²² times epsilon may be kept as
    /// far places, which take more instructions.
    ///
    /// If epsilon is too large, rays start beyond what lies nearer to the surface than epsilon: shadows and
    /// reflections do not reach the place where two shapes touch. It should be small beside the smallest
    /// shape and the smallest gap.
    pub const fn epsilon(mut self, epsilon: f64) -> Self {
        self.described.epsilon = Number::new(epsilon);
        Error::refuse("scene", prepare::epsilon_fault(self.described.epsilon));
        self
    }

    /// Sets the box in which parts of the scene move, by two opposite corners.
    ///
    /// The scene's grid is chosen for the whole box, so that a part that moves in it changes no bit of the
    /// others. The ball around a part that moves must stay inside of the box.
    pub const fn motion(mut self, low: [f64; 3], high: [f64; 3]) -> Self {
        let motion = [Position::new(low), Position::new(high)];
        Error::refuse("motion", prepare::motion_fault(motion));
        self.described.motion = Some(motion);
        self
    }

    /// Marks the shape that was added last as one that moves, for [`scene!`](crate::scene).
    #[doc(hidden)]
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

    /// Returns the shapes that move, by name and index; `None` from some index on.
    pub(crate) const fn moving(&self) -> &[Option<(&'static str, usize)>] {
        &self.moving
    }

    /// The camera the scene is meant to be seen with first. The binary point is chosen so that it
    /// has its place beside the shapes; any other camera can be used as well.
    pub const fn camera(mut self, camera: Camera) -> Self {
        self.described.camera = Some(camera);
        self
    }
}

/// What a constant is written with in place of a description's type.
macro_rules! plain {
    (Position) => {
        [f64; 3]
    };
    (Number) => {
        f64
    };
}

macro_rules! builder {
    (
        { $declaration:tt [$($header:tt)*] [$($arguments:tt)*] }
        $({ $list:ident $kind:ident $described:ident $prepared:ident $room:ident $lists:ident $active:tt
            $set:ident $too_many:ident $without:ident
            $(#[$doc:meta])* $add:ident($($field:ident: $type:ident),*) })*
    ) => {
        impl<$($header)*> SceneBuilder<Room<$($arguments)*>> {
            /// An empty scene with a black background and an epsilon of 0.001.
            pub const fn new() -> Self {
                Self {
                    described: Described::new(),
                    last: None,
                    moving: [None; MOST_MOVING],
                }
            }

            $(
                $(#[$doc])*
                pub const fn $kind(mut self, $($field: plain!($type),)* material: Material) -> Self {
                    let index = self.described.$list.len;
                    self.described.$list.refuse_more(stringify!($kind), ErrorKind::$too_many);
                    let material = self.described.materials.id_of(material);
                    let $kind = crate::shape::$described {
                        $($field: $type::new($field),)*
                        material,
                    };
                    Error::refuse_at(stringify!($kind), index, $kind.fault());
                    self.described.$list.push($kind);
                    self.last = Some((stringify!($kind), index));
                    self
                }
            )*

            /// Adds an infinite plane through `point`; the normal may have any length but 0.
            pub const fn plane(mut self, point: [f64; 3], normal: [f64; 3], material: Material) -> Self {
                let index = self.described.planes.len;
                self.described.planes.refuse_more("plane", ErrorKind::TooManyPlanes);
                let plane = Plane {
                    point: Position::new(point),
                    normal: Position::new(normal),
                    material: self.described.materials.id_of(material),
                };
                Error::refuse_at("plane", index, plane.fault());
                self.described.planes.push(plane);
                self.last = None;
                self
            }

            /// Adds a point light; colour components are 0 to 16.
            pub const fn light(mut self, position: [f64; 3], color: [f64; 3]) -> Self {
                let index = self.described.lights.len;
                self.described.lights.refuse_more("light", ErrorKind::TooManyLights);
                let light = Light {
                    position: Position::new(position),
                    color: numbers(color),
                };
                Error::refuse_at("light", index, light.fault());
                self.described.lights.push(light);
                self.last = None;
                self
            }

            /// The description so far.
            pub const fn description(&self) -> Description<'_> {
                self.described.description()
            }

            /// Returns how many parts of each kind there are.
            #[doc(hidden)]
            pub const fn counts(&self) -> Counts {
                self.description().counts()
            }

        }

        impl<$($header)*> Default for SceneBuilder<Room<$($arguments)*>> {
            fn default() -> Self {
                Self::new()
            }
        }
    };
}
kinds!(builder);

const fn numbers([red, green, blue]: [f64; 3]) -> [Number; 3] {
    [Number::new(red), Number::new(green), Number::new(blue)]
}

#[cfg(test)]
pub(crate) mod tests;
