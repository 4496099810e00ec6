//! The open scene: its file, the scene built of it, and the view.

use reflet::host::file::{FileError, FileScene, SceneFile};
use reflet::host::reference;
use reflet::{Camera, Error};
use serde::Serialize;

use crate::answer::{error, refused};
use crate::place;

/// Narrowest and widest field of view of the library, in degrees.
const FIELDS_OF_VIEW: [f64; 2] = [0.001, 179.999];

pub(crate) struct Opened {
    pub(crate) file: SceneFile,
    pub(crate) scene: Box<FileScene>,
    names: Vec<String>,
    pub(crate) view: Camera,
}

#[derive(Serialize)]
pub(crate) struct Facts {
    name: Option<String>,
    names: Vec<String>,
    shapes: usize,
    lights: usize,
    planes: usize,
    needs: Vec<&'static str>,
    left_out: Vec<&'static str>,
    camera: View,
}

/// A camera, with the keys of a scene file.
#[derive(Serialize)]
pub(crate) struct View {
    position: [f64; 3],
    target: [f64; 3],
    up: [f64; 3],
    fov: f64,
}

impl Opened {
    /// Reads the scene at `index`, the first if that is negative.
    pub(crate) fn read(text: &str, index: i32) -> Result<Self, String> {
        let files = SceneFile::parse_all(text).map_err(|error| refusal(&error, text))?;
        let names = files.iter().map(name).collect();
        let count = files.len();
        let index = usize::try_from(index).unwrap_or(0);
        let missing = || match count {
            0 => "there is no scene in the file: add one".to_owned(),
            _ => format!("there is no scene {index}: the file has {count}"),
        };
        let file = files.into_iter().nth(index);
        let file = file.ok_or_else(|| error(missing()))?;
        let scene = file.build().map_err(|error| refusal(&error, text))?;
        let (_, camera) = file.reference();
        let view = exact(&camera).expect("the scene was built with this camera");
        Ok(Self {
            file,
            scene,
            names,
            view,
        })
    }

    pub(crate) fn facts(&self) -> Facts {
        let (scene, _) = self.file.reference();
        let needs = self.scene.needs().list();
        let named = |is_needed| {
            let those = needs.iter().filter(move |it| it.is_needed == is_needed);
            those.map(|it| it.name).collect()
        };
        Facts {
            name: self.file.name().map(str::to_owned),
            names: self.names.clone(),
            shapes: scene.shapes().count(),
            lights: scene.lights.len(),
            planes: scene.planes.len(),
            needs: named(true),
            left_out: named(false),
            camera: self.camera(),
        }
    }

    pub(crate) fn camera(&self) -> View {
        let camera = reference::Camera::from(&self.view);
        View {
            position: camera.position,
            target: camera.target,
            up: camera.up,
            fov: camera.fov,
        }
    }

    /// Sets the view from the file's camera. Angles are in thousandths of a degree, `zoom` in thousandths.
    pub(crate) fn set_view(&mut self, turn: i32, rise: i32, zoom: u32) -> Result<(), Error> {
        let (_, camera) = self.file.reference();
        let mut view = exact(&camera)?;
        if (turn, rise) != (0, 0) {
            view = view.orbited(f64::from(turn) / 1e3, f64::from(rise) / 1e3)?;
        }
        let mut view = reference::Camera::from(&view);
        let [narrowest, widest] = FIELDS_OF_VIEW;
        view.fov = (view.fov * f64::from(zoom) / 1e3).clamp(narrowest, widest);
        // In doubles, so that the Rust source of this view draws the same picture.
        self.view = exact(&view)?;
        Ok(())
    }
}

/// Converts a camera in doubles to one of the library.
fn exact(camera: &reference::Camera) -> Result<Camera, Error> {
    Camera::new(camera.position, camera.target, camera.up, camera.fov)
}

fn name(file: &SceneFile) -> String {
    file.name().unwrap_or_default().to_owned()
}

/// Refuses a file, and says where in its text.
fn refusal(error: &FileError, text: &str) -> String {
    refused(error, place::of(error, text))
}
