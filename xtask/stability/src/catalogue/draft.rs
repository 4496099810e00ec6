//! Builds a scene file part by part. Never judges a number.

use reflet::host::reference::Vector;
use serde_json::{Value, json};

/// A scene file that is being built, and how many reflections its paths follow.
#[derive(Clone)]
pub struct Draft {
    pub file: Value,
    pub reflections: u8,
}

/// Direction of z.
pub const UP: [f64; 3] = [0.0, 0.0, 1.0];

/// Position of the usual lamp, and position and target of the usual camera.
pub const LAMP: [f64; 3] = [3.0, -5.0, 4.0];
pub const EYE: [f64; 3] = [0.5, -4.0, 1.5];
pub const TARGET: [f64; 3] = [0.0, 0.0, 0.5];

impl Draft {
    /// Starts a scene with a camera 50 degrees wide whose `up` is along z.
    pub fn seen_from(position: [f64; 3], target: [f64; 3]) -> Self {
        Self::through(position, target, UP, 50.0)
    }

    /// Starts a scene with any camera and 4 reflections. It has these materials: chalk, gold, water, red, black, white
    /// and mirror.
    pub fn through(position: [f64; 3], target: [f64; 3], up: [f64; 3], fov: f64) -> Self {
        let file = json!({
            "camera": {"position": position, "target": target, "up": up, "fov": fov},
            // No channel is half way between two levels of 255, so rounding errors cannot change a level.
            "background": [0.21, 0.29, 0.52],
        });
        let reflections = 4;
        Self { file, reflections }
            .material("chalk", [0.9, 0.9, 0.8], [0.2, 0.8, 0.0, 1.0, 0.0])
            .material("gold", [0.7, 0.6, 0.0], [0.2, 0.4, 0.8, 4.0, 0.4])
            .material("water", [0.6, 0.8, 1.0], [0.2, 0.3, 1.0, 50.0, 0.5])
            .material("red", [0.9, 0.2, 0.1], [0.2, 0.6, 0.5, 20.0, 0.2])
            .material("black", [0.0; 3], [0.0, 0.0, 0.0, 1.0, 0.0])
            .material("white", [1.0; 3], [1.0, 1.0, 1.0, 10.0, 0.0])
            .material("mirror", [1.0; 3], [0.0, 0.0, 0.0, 1.0, 1.0])
    }

    fn part(mut self, list: &str, part: Value) -> Self {
        match &mut self.file[list] {
            Value::Array(parts) => parts.push(part),
            none => *none = json!([part]),
        }
        self
    }

    /// Adds a material: its colour, then its ambient, diffuse and specular coefficient, shininess and mirror share.
    pub fn material(self, name: &str, color: [f64; 3], coefficients: [f64; 5]) -> Self {
        let [ambient, diffuse, specular, shininess, mirror] = coefficients;
        let material = json!({
            "name": name, "color": color, "ambient": ambient, "diffuse": diffuse,
            "specular": specular, "shininess": shininess, "mirror": mirror,
        });
        self.part("materials", material)
    }

    /// Adds a white light.
    pub fn light(self, position: [f64; 3]) -> Self {
        self.shining(position, [1.0; 3])
    }

    pub fn shining(self, position: [f64; 3], color: [f64; 3]) -> Self {
        self.part("lights", json!({"position": position, "color": color}))
    }

    /// Adds a white light that falls off with this range.
    pub fn fading(self, position: [f64; 3], range: f64) -> Self {
        let light = json!({"position": position, "color": [1, 1, 1], "range": range});
        self.part("lights", light)
    }

    /// Adds a white sun, with a disc of this angle in degrees.
    pub fn sun(self, direction: [f64; 3], disc: f64) -> Self {
        let sun = json!({"direction": direction, "color": [1, 1, 1], "disc": disc});
        self.part("suns", sun)
    }

    pub fn sphere(self, center: [f64; 3], radius: f64, material: &str) -> Self {
        let sphere = json!({"center": center, "radius": radius, "material": material});
        self.part("spheres", sphere)
    }

    pub fn plane(self, center: [f64; 3], normal: [f64; 3], material: &str) -> Self {
        let plane = json!({"center": center, "normal": normal, "material": material});
        self.part("planes", plane)
    }

    pub fn cylinder(
        self,
        center: [f64; 3],
        axis: [f64; 3],
        (radius, height): (f64, f64),
        material: &str,
    ) -> Self {
        let cylinder = json!({
            "center": center, "axis": axis, "radius": radius, "height": height,
            "material": material,
        });
        self.part("cylinders", cylinder)
    }

    pub fn disc(self, center: [f64; 3], normal: [f64; 3], radius: f64, material: &str) -> Self {
        let disc = json!({
            "center": center, "normal": normal, "radius": radius, "material": material,
        });
        self.part("discs", disc)
    }

    /// Adds a flat triangle.
    pub fn triangle(self, corners: [[f64; 3]; 3], material: &str) -> Self {
        let triangle = json!({"corners": corners, "material": material});
        self.part("triangles", triangle)
    }

    pub fn reflections(mut self, reflections: u8) -> Self {
        self.reflections = reflections;
        self
    }

    pub fn background(mut self, background: [f64; 3]) -> Self {
        self.file["background"] = json!(background);
        self
    }

    /// Sets epsilon: the distance by which rays are lifted off surfaces.
    pub fn epsilon(mut self, epsilon: f64) -> Self {
        self.file["epsilon"] = json!(epsilon);
        self
    }
}

/// Position and size of a still life on a floor: its points are moved, then scaled.
#[derive(Clone, Copy)]
pub struct Setting {
    /// Offset of its middle, before scaling.
    pub offset: [f64; 3],
    /// Scale factor of all its lengths and points.
    pub scale: f64,
}

impl Setting {
    /// The still life at the origin, in its own size.
    pub const HERE: Self = Self {
        offset: [0.0; 3],
        scale: 1.0,
    };

    /// Returns a point of the still life after moving and scaling.
    pub fn at(&self, at: [f64; 3]) -> [f64; 3] {
        ((Vector(at) + Vector(self.offset)) * self.scale).0
    }

    /// Adds three spheres and a leaning cylinder on a plane of water, without lights.
    pub fn furnish(&self, draft: Draft) -> Draft {
        let (at, scale) = (|it| self.at(it), self.scale);
        let size = (0.4 * scale, 1.4 * scale);
        draft
            .sphere(at([-1.0, 0.0, 0.6]), 0.6 * scale, "gold")
            .sphere(at([0.6, -0.4, 0.4]), 0.4 * scale, "water")
            .sphere(at([1.3, 0.7, 0.8]), 0.8 * scale, "chalk")
            .cylinder(at([0.2, 1.2, 0.7]), [0.1, 0.0, 1.0], size, "red")
            .plane(at([0.0; 3]), UP, "water")
            .epsilon(1e-3 * scale)
    }

    /// Adds the two lights of the still life.
    pub fn lit(&self, draft: Draft) -> Draft {
        draft
            .shining(self.at(LAMP), [0.8, 0.8, 0.7])
            .shining(self.at([-2.0, -6.0, 1.5]), [0.3, 0.3, 0.4])
    }

    /// Returns the still life with its water, its lights and its usual camera.
    pub fn still_life(&self) -> Draft {
        let (eye, target) = (self.at(EYE), self.at(TARGET));
        self.lit(self.furnish(Draft::seen_from(eye, target)))
    }
}

/// Returns an empty scene with the usual camera.
pub fn usual() -> Draft {
    Draft::seen_from(EYE, TARGET)
}

/// Returns the still life with its water and lights, for any camera.
pub fn still_life(position: [f64; 3], target: [f64; 3], fov: f64) -> Draft {
    let here = Setting::HERE;
    here.lit(here.furnish(Draft::through(position, target, UP, fov)))
}

/// Returns the still life with its water and usual camera, lit by this light only.
pub fn lit_by(light: [f64; 3]) -> Draft {
    Setting::HERE.furnish(usual()).light(light)
}
