//! Writes a scene as Rust source: a constant scene, ready to compile. [`names`] makes identifiers of the
//! file's names, [`write`] writes the lines. Nothing is checked here.

mod names;
mod write;

use alloc::string::{String, ToString};
use alloc::vec::Vec;

use super::SceneFile;
use crate::camera;
use crate::host::reference::{Camera, Scene};

/// The Rust source of a constant scene, with its numbers to the last digit.
///
/// The source declares one type with [`scene!`](crate::scene), one constant for each material that a shape
/// has, and the constant `CAMERA`. It compiles if the scene can be built and is lit: a constant scene must have a
/// light or ambient light. rustfmt lays it out as usual.
///
/// ```
/// use reflet::host::file::{RustSource, SceneFile};
/// use reflet::Camera;
///
/// let text = r#"{
///     "name": "two balls",
///     "camera": {"position": [0, -5, 2], "target": [0, 0, 1], "up": [0, 0, 1], "fov": 50},
///     "materials": [{"name": "old gold", "color": [0.7, 0.6, 0], "ambient": 0.2}],
///     "spheres": [{"center": [0, 0, 1], "radius": 0.1, "material": "old gold"}]
/// }"#;
/// let file = SceneFile::parse(text, None).unwrap();
/// let source: RustSource<'_> = file.rust_source();
/// assert_eq!(source.type_name(), "TwoBalls");
/// let text = source.text();
/// assert!(text.contains("const OLD_GOLD: Material = Material::new([0.7, 0.6, 0.0])"));
/// assert!(text.contains("sphere([0.0, 0.0, 1.0], 0.1, OLD_GOLD);"));
///
/// let camera = Camera::look_at([0.0, -9.0, 2.0], [0.0, 0.0, 1.0], [0.0, 0.0, 1.0]);
/// let text = file.rust_source().camera(&camera).text();
/// assert!(text.contains("Camera::look_at([0.0, -9.0, 2.0], [0.0, 0.0, 1.0], [0.0, 0.0, 1.0]).fov(50.0);"));
/// ```
#[derive(Clone, Debug)]
pub struct RustSource<'a> {
    name: &'a str,
    /// Names of the materials, which may be any text.
    materials: Vec<String>,
    scene: &'a Scene,
    camera: Camera,
    motion: Option<Motion>,
}

/// The shape of a source that can move, and its room.
#[derive(Clone, Copy, Debug)]
struct Motion {
    /// Its kind: the first shape of this kind moves.
    kind: &'static str,
    low: [f64; 3],
    high: [f64; 3],
}

impl<'a> RustSource<'a> {
    /// Creates the source of a scene whose materials have numbers instead of names.
    ///
    /// ```
    /// use reflet::host::file::RustSource;
    /// use reflet::host::reference::{Camera, Scene};
    ///
    /// let camera =
    ///     Camera { position: [0.0; 3], target: [0.0, 1.0, 0.0], up: [0.0, 0.0, 1.0], fov: 50.0 };
    /// let scene = Scene { background: [0.0, 0.0, 0.5], ..Scene::default() };
    /// let text = RustSource::new("night", &scene, &camera).text();
    /// assert!(text.contains("pub struct Night {\n        background([0.0, 0.0, 0.5]);"));
    /// ```
    pub fn new(name: &'a str, scene: &'a Scene, camera: &Camera) -> Self {
        let materials = 0..scene.materials.len();
        Self {
            name,
            materials: materials.map(|it| it.to_string()).collect(),
            scene,
            camera: camera.clone(),
            motion: None,
        }
    }

    /// Sets the name of the scene.
    #[must_use]
    pub fn name(self, name: &'a str) -> Self {
        Self { name, ..self }
    }

    /// Sets the camera of the scene.
    #[must_use]
    pub fn camera(mut self, camera: &camera::Camera) -> Self {
        self.camera = camera.into();
        self
    }

    /// Lets the first shape of a kind, such as `sphere`, move in the box between two corners. Its handle has
    /// the name `MOVING`.
    ///
    /// ```
    /// use reflet::host::file::RustSource;
    /// use reflet::host::reference::{Camera, Material, Scene, Sphere};
    /// # let camera = Camera { position: [0.0; 3], target: [0.0, 1.0, 0.0], up: [0.0, 0.0, 1.0], fov: 50.0 };
    /// # let chalk = Material { color: [1.0; 3], ambient: 1.0, diffuse: 0.0, specular: 0.0, shininess: 1.0, mirror: 0.0, checker: None };
    ///
    /// let ball = Sphere { center: [0.0, 5.0, 0.0], radius: 1.0, material: 0 };
    /// let scene = Scene { spheres: vec![ball], materials: vec![chalk], ..Scene::default() };
    /// let source = RustSource::new("ball", &scene, &camera);
    /// let text = source.motion("sphere", [-2.0, 3.0, -2.0], [2.0, 7.0, 2.0]).text();
    /// assert!(text.contains("motion([-2.0, 3.0, -2.0], [2.0, 7.0, 2.0]);"));
    /// assert!(text.contains("sphere MOVING([0.0, 5.0, 0.0], 1.0, MATERIAL_0);"));
    /// ```
    #[must_use]
    pub fn motion(mut self, kind: &'static str, low: [f64; 3], high: [f64; 3]) -> Self {
        self.motion = Some(Motion { kind, low, high });
        self
    }

    /// Returns the name of the scene's type: `TwoBalls` for a scene called `two balls`.
    pub fn type_name(&self) -> String {
        names::type_name(self.name)
    }

    /// Returns the source.
    ///
    /// # Panics
    /// A shape names a material that the scene does not have. The scene of a file never does.
    pub fn text(&self) -> String {
        let type_name = self.type_name();
        let materials = names::constants(&self.materials, &type_name);
        write::text(self, &type_name, &materials)
    }
}

impl SceneFile {
    /// Returns the Rust source of the scene as a constant scene, with the file's camera. A scene without a
    /// name is called `scene`. Whether the scene can be built is not checked.
    pub fn rust_source(&self) -> RustSource<'_> {
        RustSource {
            materials: self.materials.clone(),
            ..RustSource::new(self.name().unwrap_or("scene"), &self.scene, &self.camera)
        }
    }
}

#[cfg(test)]
mod tests;
