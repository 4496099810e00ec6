//! Scenes written in plain numbers and built by the compiler.

use super::capacity::{Capacity, Room};
use super::description::{Described, Description};
use super::prepare;
use crate::camera::Camera;
use crate::fault::Fault;
use crate::light::Light;
use crate::material::Material;
use crate::number::Number;
use crate::shape::plane::Plane;
use crate::vector::Position;

/// A [`SceneBuilder`] with the room of its scene as one type.
#[derive(Clone, Copy, Debug)]
pub struct SceneBuilderIn<R: Capacity>(Described<R>);

impl<R: Capacity> SceneBuilderIn<R> {
    /// What a ray that meets nothing adds, 0 to 16 a component; black unless it is named.
    pub const fn background(mut self, color: [f64; 3]) -> Self {
        self.0.background = numbers(color);
        Fault::refuse(prepare::background_fault(self.0.background));
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
        self.0.epsilon = Number::new(epsilon);
        Fault::refuse(prepare::epsilon_fault(self.0.epsilon));
        self
    }

    /// The camera the scene is meant to be seen with first. The binary point is chosen so that it
    /// has its place beside the shapes; any other camera can be used as well.
    pub const fn camera(mut self, camera: Camera) -> Self {
        self.0.camera = Some(camera);
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
        { [$($declaration:tt)*] [$($header:tt)*] [$($arguments:tt)*] }
        $({ $list:ident $kind:ident $described:ident $prepared:ident $room:ident $lists:ident $active:tt
            $nth:literal $too_many:ident $without:ident
            $(#[$doc:meta])* $add:ident($($field:ident: $type:ident),*) })*
    ) => {
        /// The description of a scene with room for `S` spheres, `P` planes, `C` cylinders, `L` lights and
        /// `M` different materials, for constants.
        ///
        /// Every method checks what it is given and panics with words that name the field and the fix;
        /// in a constant that stops the compiler. For scenes that are filled while the program runs there
        /// is [`crate::RuntimeScene`], which returns errors.
        ///
        /// ```compile_fail
        /// use reflet::{Material, Scene};
        /// const SCENE: Scene<1, 0, 0, 0> =
        ///     Scene::builder().sphere([0.0; 3], -1.0, Material::new([1.0; 3])).build();
        /// ```
        pub type SceneBuilder<$($declaration)*> = SceneBuilderIn<Room<$($arguments)*>>;

        impl<$($header)*> SceneBuilderIn<Room<$($arguments)*>> {
            /// An empty scene with a black background and an epsilon of 0.001.
            pub const fn new() -> Self {
                Self(Described::new())
            }

            $(
                $(#[$doc])*
                pub const fn $kind(mut self, $($field: plain!($type),)* material: Material) -> Self {
                    self.0.$list.refuse_more(Fault::$too_many);
                    let material = self.0.materials.id_of(material);
                    let $kind = crate::shape::$described {
                        $($field: $type::new($field),)*
                        material,
                    };
                    Fault::refuse($kind.fault());
                    self.0.$list.push($kind);
                    self
                }
            )*

            /// Adds an infinite plane through `point`; the normal may have any length but 0.
            pub const fn plane(mut self, point: [f64; 3], normal: [f64; 3], material: Material) -> Self {
                self.0.planes.refuse_more(Fault::TooManyPlanes);
                let plane = Plane {
                    point: Position::new(point),
                    normal: Position::new(normal),
                    material: self.0.materials.id_of(material),
                };
                Fault::refuse(plane.fault());
                self.0.planes.push(plane);
                self
            }

            /// Adds a point light; colour components are 0 to 16.
            pub const fn light(mut self, position: [f64; 3], color: [f64; 3]) -> Self {
                self.0.lights.refuse_more(Fault::TooManyLights);
                let light = Light {
                    position: Position::new(position),
                    color: numbers(color),
                };
                Fault::refuse(light.fault());
                self.0.lights.push(light);
                self
            }

            /// The description so far.
            pub const fn description(&self) -> Description<'_> {
                self.0.description()
            }

        }

        impl<$($header)*> Default for SceneBuilderIn<Room<$($arguments)*>> {
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
