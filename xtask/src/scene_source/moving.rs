//! The shape of a scene that moves in a measurement: the first sphere, or the first bounded shape.

use reflet::host::reference::Scene;

/// Side of the motion box, in diameters of the ball around the shape.
const ROOM: f64 = 1.125;

#[derive(Clone, Debug)]
pub struct Moving {
    /// Name of its kind, such as `sphere`.
    pub kind: &'static str,
    /// Its numbers as Rust source: the arguments of `set_sphere`, without the handle.
    fields: Vec<String>,
    center: [f64; 3],
    /// Radius of the ball around it.
    radius: f64,
}

impl Moving {
    /// Chooses it; `None` if the scene has no bounded shape.
    pub fn of(scene: &Scene) -> Option<Self> {
        let sphere = scene
            .spheres
            .first()
            .map(|it| ("sphere", it.center, it.radius));
        let cylinder = scene.cylinders.first().map(|it| {
            let radius = it.radius.hypot(it.height / 2.0);
            ("cylinder", it.center, radius)
        });
        let disc = scene.discs.first().map(|it| ("disc", it.center, it.radius));
        let (kind, center, radius) = sphere.or(cylinder).or(disc)?;
        let shape = scene.shapes().find(|it| it.kind == kind)?;
        Some(Self {
            kind,
            fields: shape.fields.iter().map(|it| format!("{it:?}")).collect(),
            center,
            radius,
        })
    }

    /// Returns the corners of the box in which the shape moves.
    pub fn room(&self) -> [[f64; 3]; 2] {
        [-ROOM, ROOM].map(|side| self.center.map(|middle| middle + side * self.radius))
    }

    /// Returns the `firmware::Moves` of the scene, of which `scene` is the type: the shape is moved to
    /// where it is. The compiler does not know that.
    pub fn moves(&self, scene: &str) -> String {
        let kind = self.kind;
        let field = |field: &String| {
            if field.starts_with('[') {
                format!("reflet::Position::new({field})")
            } else {
                format!("reflet::Number::new({field})")
            }
        };
        let fields: Vec<_> = self.fields.iter().map(field).collect();
        let (fields, names) = (fields.join(", "), ["a", "b", "c", "d"]);
        let names = names[..self.fields.len()].join(", ");
        format!(
            "impl firmware::Moves for {scene} {{\n    \
                 fn move_shape(scene: &mut reflet::MovingScene<Self>) -> Result<(), reflet::Error> {{\n        \
                     let ({names}) = core::hint::black_box(const {{ ({fields}) }});\n        \
                     scene.set_{kind}(Self::MOVING, {names})\n    \
                 }}\n\
             }}\n\n"
        )
    }
}

#[cfg(test)]
mod tests {
    use reflet::host::reference::{Cylinder, Sphere};

    use super::*;

    #[test]
    fn first_sphere_moves_before_a_cylinder() {
        let cylinder = Cylinder {
            center: [0.0; 3],
            axis: [0.0, 0.0, 1.0],
            radius: 3.0,
            height: 8.0,
            material: 0,
        };
        let mut scene = Scene::default();
        assert!(Moving::of(&scene).is_none());
        scene.cylinders.push(cylinder);
        let moving = Moving::of(&scene).unwrap();
        assert_eq!((moving.kind, moving.radius), ("cylinder", 5.0));
        let fields = "[0.0, 0.0, 0.0] [0.0, 0.0, 1.0] 3.0 8.0";
        assert_eq!(moving.fields.join(" "), fields);
        scene.spheres.push(Sphere {
            center: [1.0, 2.0, 3.0],
            radius: 8.0,
            material: 0,
        });
        let moving = Moving::of(&scene).unwrap();
        assert_eq!(moving.room(), [[-8.0, -7.0, -6.0], [10.0, 11.0, 12.0]]);
    }
}
