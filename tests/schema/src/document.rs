//! Makes random scene files of well-formed scenes, many with mistakes. Never reads a file.

use arbitrary::{Result, Unstructured};
use reflet::host::file as limits;
use serde_json::{Value, json};

/// The lists of a scene file, and the largest number of parts in each.
pub const LISTS: [(&str, usize); 8] = [
    ("spheres", limits::MAX_SPHERES),
    ("planes", limits::MAX_PLANES),
    ("cylinders", limits::MAX_CYLINDERS),
    ("discs", limits::MAX_DISCS),
    ("triangles", limits::MAX_TRIANGLES),
    ("lights", limits::MAX_LIGHTS),
    ("suns", limits::MAX_SUNS),
    ("materials", limits::MAX_MATERIALS),
];

/// Numbers at the edges of a range, or close to them. Except zero, none is below 2^-65: the library
/// rounds such a number to zero, and the schema does not.
pub const EDGES: [f64; 26] = [
    -1e300,
    -1_073_741_825.0,
    -1_073_741_824.0,
    -1.0,
    -1e-9,
    0.0,
    1e-9,
    0.000_999,
    0.001,
    0.5,
    1.0,
    1.000_000_1,
    2.0,
    15.999,
    16.0,
    16.000_001,
    30.0,
    179.999,
    179.999_01,
    180.0,
    1_048_576.0,
    1_048_576.1,
    1_073_741_823.0,
    1_073_741_824.0,
    1_073_741_824.5,
    1e300,
];

/// Makes a file: some of these scenes in an array or one alone, with some mistakes.
pub fn file(bytes: &mut Unstructured, scenes: &[Value]) -> Result<Value> {
    let is_array = bytes.ratio(1, 4)?;
    let counts = if is_array { 0..=3 } else { 1..=1 };
    let count = bytes.int_in_range(counts)?;
    let mut made = Vec::new();
    for number in 0..count {
        let mut scene = bytes.choose(scenes)?.clone();
        scene["name"] = json!(number.to_string());
        if bytes.ratio(1, 16)? {
            scene["spheres"][0]["material"] = json!("brass");
        }
        for _ in 0..bytes.int_in_range(0..=3)? {
            spoil(bytes, &mut scene)?;
        }
        made.push(scene);
    }
    match made.pop() {
        Some(scene) if !is_array => Ok(scene),
        last => Ok(made.into_iter().chain(last).collect()),
    }
}

/// Changes a scene at a random place. Most changes are mistakes.
fn spoil(bytes: &mut Unstructured, scene: &mut Value) -> Result<()> {
    let places = places(scene);
    let place = bytes.choose(&places)?;
    let at = scene.pointer_mut(place).expect("the place was found");
    match bytes.int_in_range(0..=7)? {
        0 => *at = wrong(bytes)?,
        1 => drop_from(bytes, at)?,
        7 if at.is_array() => {
            let items = at.as_array_mut().expect("it is an array");
            items.extend(items.last().cloned());
        }
        2 => {
            let key = *bytes.choose(&["colour", "", "name", "radius"])?;
            if let Some(fields) = at.as_object_mut() {
                fields.insert(key.to_owned(), json!(1));
            }
        }
        3 => {
            let (list, most) = *bytes.choose(&LISTS)?;
            let count = most + bytes.int_in_range(0..=1)?;
            fill(scene, list, count);
        }
        4 if at.is_string() => *at = json!(*bytes.choose(&["clay", "gold", "brass"])?),
        5 if at.is_array() => *at = json!([0, 0, 0]),
        _ if at.is_number() => *at = json!(*bytes.choose(&EDGES)?),
        _ => {}
    }
    Ok(())
}

/// Makes a value that is wrong at most places. No array is as long as an object has keys.
fn wrong(bytes: &mut Unstructured) -> Result<Value> {
    let values = json!([null, true, "clay", 3, [], {}, [0], [0, 0, "1"], [1, 2, 3]]);
    let values = values.as_array().expect("it is an array");
    bytes.choose(values).cloned()
}

/// Removes a key or an item.
fn drop_from(bytes: &mut Unstructured, at: &mut Value) -> Result<()> {
    match at {
        Value::Object(fields) if !fields.is_empty() => {
            let keys: Vec<_> = fields.keys().cloned().collect();
            fields.remove(bytes.choose(&keys)?);
        }
        Value::Array(items) => drop(items.pop()),
        _ => {}
    }
    Ok(())
}

/// Repeats the first part of a list until the list has `count` parts. An empty list stays empty.
/// Every repeated material gets its own name.
pub fn fill(scene: &mut Value, list: &str, count: usize) {
    let Some(Value::Array(parts)) = scene.get_mut(list) else {
        return;
    };
    for number in parts.len()..count {
        let Some(mut part) = parts.first().cloned() else {
            return;
        };
        if list == "materials" && part.is_object() {
            part["name"] = json!(number.to_string());
        }
        parts.push(part);
    }
}

/// Returns JSON pointers to a value and to all values inside it.
pub fn places(value: &Value) -> Vec<String> {
    let inner: Vec<(String, &Value)> = match value {
        Value::Object(fields) => fields.iter().map(|(key, it)| (key.clone(), it)).collect(),
        Value::Array(items) => {
            let numbered = items.iter().enumerate().take(4);
            numbered.map(|(at, it)| (at.to_string(), it)).collect()
        }
        _ => Vec::new(),
    };
    let mut found = vec![String::new()];
    for (key, value) in inner {
        found.extend(places(value).iter().map(|place| format!("/{key}{place}")));
    }
    found
}
