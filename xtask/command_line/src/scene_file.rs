//! Writes a scene as a scene file, laid out for reading: one part a line, and nothing that is the
//! default.

use reflet::Number;
use reflet::host::reference::{Camera, Checker, Light, Material, Scene, Shape, Sky};

/// Returns the names of a built-in scene's materials, from its source: the constants in the order in
/// which the parts name them first. If that is not one for each material, they are numbered.
pub fn materials(source: &str, scene: &Scene) -> Vec<String> {
    let parts = source.lines().skip_while(|line| *line != "scene! {");
    let mut names: Vec<String> = Vec::new();
    for line in parts {
        let part = line.strip_suffix(");");
        let last = part.and_then(|it| it.rsplit(", ").next());
        let is_name = |it: &&str| it.starts_with(|letter: char| letter.is_ascii_uppercase());
        if let Some(name) = last.filter(is_name) {
            let name = name.to_lowercase().replace('_', " ");
            if !names.contains(&name) {
                names.push(name);
            }
        }
    }
    let count = scene.materials.len();
    if names.len() == count {
        names
    } else {
        (1..=count).map(|it| format!("material {it}")).collect()
    }
}

/// Returns a scene as the text of a scene file. `materials` are the names of its materials, in order.
pub fn text(name: &str, materials: &[String], scene: &Scene, camera: &Camera) -> String {
    let named = materials.iter().zip(&scene.materials);
    let mut entries = vec![
        format!(r#""name": {}"#, quoted(name)),
        format!(r#""camera": {}"#, view(camera)),
    ];
    let named = named.map(|(name, it)| material(name, it));
    entries.extend(list("materials", named));
    let lights = |is_sun: bool| {
        let these = scene.lights.iter();
        these
            .filter(move |it| it.sun.is_some() == is_sun)
            .map(light)
    };
    entries.extend(list("lights", lights(false)));
    entries.extend(list("suns", lights(true)));
    for kind in ["spheres", "planes", "cylinders", "discs", "triangles"] {
        let shapes = scene.shapes().filter(|it| it.list == kind);
        let shapes = shapes.map(|it| shape(&it, &materials[it.material]));
        entries.extend(list(kind, shapes));
    }
    match &scene.sky {
        Some(it) => entries.push(format!(r#""sky": {}"#, sky(it))),
        None if scene.background != [0.0; 3] => {
            entries.push(format!(r#""background": {}"#, vector(scene.background)));
        }
        None => {}
    }
    if scene.epsilon != Scene::default().epsilon {
        entries.push(format!(r#""epsilon": {}"#, scene.epsilon));
    }
    format!("{{\n  {}\n}}\n", entries.join(",\n  "))
}

/// Returns a list with one part a line, or `None` if it is empty.
fn list(name: &str, parts: impl Iterator<Item = String>) -> Option<String> {
    let parts: Vec<_> = parts.collect();
    let text = format!("\"{name}\": [\n    {}\n  ]", parts.join(",\n    "));
    (!parts.is_empty()).then_some(text)
}

fn view(camera: &Camera) -> String {
    let [position, target, up] = [camera.position, camera.target, camera.up].map(vector);
    let fov = camera.fov;
    format!(r#"{{ "position": {position}, "target": {target}, "up": {up}, "fov": {fov} }}"#)
}

fn material(name: &str, material: &Material) -> String {
    let defaults = reflet::Material::new([0.0; 3]).described_coefficients();
    let given = [
        ("ambient", material.ambient),
        ("diffuse", material.diffuse),
        ("specular", material.specular),
        ("shininess", material.shininess),
        ("mirror", material.mirror),
    ];
    let mut fields = vec![("name", quoted(name)), ("color", vector(material.color))];
    for ((key, value), default) in given.into_iter().zip(defaults.map(Number::to_f64)) {
        if value != default {
            fields.push((key, value.to_string()));
        }
    }
    fields.extend(material.checker.as_ref().map(|it| ("checker", checker(it))));
    object(&fields)
}

fn checker(checker: &Checker) -> String {
    let [color, size] = [checker.color, checker.size].map(vector);
    format!(r#"{{ "color": {color}, "size": {size} }}"#)
}

fn light(light: &Light) -> String {
    let [place, color] = [light.position, light.color].map(vector);
    let range = light.range.map(|range| format!(r#", "range": {range}"#));
    let range = range.unwrap_or_default();
    match light.sun {
        None => format!(r#"{{ "position": {place}, "color": {color}{range} }}"#),
        Some(0.0) => format!(r#"{{ "direction": {place}, "color": {color} }}"#),
        Some(disc) => format!(r#"{{ "direction": {place}, "color": {color}, "disc": {disc} }}"#),
    }
}

fn shape(shape: &Shape<'_>, material: &str) -> String {
    let keys: &[&str] = match shape.kind {
        "cylinder" => &["center", "axis", "radius", "height"],
        "sphere" => &["center", "radius"],
        "triangle" => &["corners", "normals"],
        _ => &["center", "normal", "radius"],
    };
    // As source of Rust, `1.0` stands for 1.
    let short = |it: String| it.replace(".0,", ",").replace(".0]", "]");
    let fields = shape.fields.iter();
    let fields = fields.map(|field| short(format!("{field:?},")));
    let fields = fields.map(|it| it.trim_end_matches(',').to_owned());
    let pairs = keys.iter().copied().zip(fields);
    // The normals of a triangle are an `Option`.
    let given = pairs.filter(|(_, it)| it != "None");
    let plain = |it: &str| {
        it.trim_start_matches("Some(")
            .trim_end_matches(')')
            .to_owned()
    };
    let mut pairs: Vec<_> = given.map(|(key, it)| (key, plain(&it))).collect();
    pairs.push(("material", quoted(material)));
    object(&pairs)
}

fn sky(sky: &Sky) -> String {
    let [up, below, horizon, above] = [sky.up, sky.below, sky.horizon, sky.above].map(vector);
    format!(r#"{{ "up": {up}, "below": {below}, "horizon": {horizon}, "above": {above} }}"#)
}

fn object(fields: &[(&str, String)]) -> String {
    let fields = fields.iter();
    let fields: Vec<_> = fields
        .map(|(key, value)| format!(r#""{key}": {value}"#))
        .collect();
    format!("{{ {} }}", fields.join(", "))
}

fn vector([x, y, z]: [f64; 3]) -> String {
    format!("[{x}, {y}, {z}]")
}

fn quoted(text: &str) -> String {
    format!("{text:?}")
}
