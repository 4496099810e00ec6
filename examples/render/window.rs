//! Shows the scene in a window and reacts to its keys.

use std::env;
use std::thread;
use std::time::Duration;

use embedded_graphics::geometry::{OriginDimensions, Size};
use reflet::host::reference::Camera;
use reflet::scenes;
use sdl2::EventPump;
use sdl2::event::Event;
use sdl2::keyboard::Keycode;
use sdl2::pixels::PixelFormatEnum;
use sdl2::render::WindowCanvas;

use crate::arguments::Arguments;
use crate::picture::Drawing;
use crate::title::title;
use crate::watch::{Watch, draw_error};
use crate::{output, report};
use command_line::{Failure, Named, Quality, Settings, Source, exact};

/// Degrees by which one press of an arrow key turns the camera.
const STEP: i32 = 5;

/// Largest side in pixels to which a small picture is enlarged, by a whole factor.
const LARGE: u32 = 640;

const REST: Duration = Duration::from_millis(10);

/// Shows the scene until the window is closed.
pub fn show(source: Source, arguments: &Arguments) -> Result<(), Failure> {
    let Arguments { scene, chosen, .. } = arguments;
    if arguments.watch && !matches!(Named::of(scene, chosen)?, Named::File) {
        return Err(format!("--watch needs a scene file: {} is built in", source.name()).into());
    }
    let mut watch = arguments.watch.then(|| Watch::new(scene, chosen));
    let mut view = View::new(source, arguments);
    let (mut canvas, mut events) =
        open(arguments.size).map_err(|reason| format!("the window cannot be opened: {reason}"))?;
    let mut drawing = view.draw()?;
    let mut news = News::Window;
    loop {
        if news > News::Window {
            drawing = view.draw()?;
        }
        if news == News::Setting {
            output::print(arguments, &view.describe(&drawing))?;
        }
        if news > News::Nothing {
            present(&mut canvas, &drawing, &view.title(&drawing))?;
        }
        news = News::Nothing;
        for event in events.poll_iter() {
            let answer = view.answer(&event);
            if answer == News::End {
                return Ok(());
            }
            news = news.max(answer);
        }
        if let Some(read) = watch.as_mut().and_then(Watch::change) {
            news = news.max(view.read_again(read));
        }
        if news == News::Nothing {
            thread::sleep(REST);
        }
    }
}

/// Opens a window that shows pictures of one size.
fn open(size: Size) -> Result<(WindowCanvas, EventPump), String> {
    let sdl = sdl2::init()?;
    let factor = (LARGE / size.width.max(size.height)).max(1);
    let [width, height] = [size.width, size.height].map(|side| side * factor);
    let video = sdl.video()?;
    // Without a screen, SDL draws where nobody sees it, unless it is told to.
    let driver = video.current_video_driver();
    if matches!(driver, "dummy" | "offscreen") && env::var_os("SDL_VIDEODRIVER").is_none() {
        return Err("there is no screen".to_owned());
    }
    let window = video
        .window("reflet", width, height)
        .position_centered()
        .build();
    let canvas = window.map_err(|error| error.to_string())?.into_canvas();
    let canvas = canvas.build().map_err(|error| error.to_string())?;
    Ok((canvas, sdl.event_pump()?))
}

/// Shows a picture in the window, under a title.
fn present(canvas: &mut WindowCanvas, drawing: &Drawing, title: &str) -> Result<(), Failure> {
    let Size { width, height } = drawing.display.size();
    let creator = canvas.texture_creator();
    let mut texture = creator.create_texture_static(PixelFormatEnum::RGB24, width, height)?;
    texture.update(None, &drawing.display.to_be_bytes(), width as usize * 3)?;
    canvas.copy(&texture, None, None)?;
    canvas.window_mut().set_title(title)?;
    canvas.present();
    Ok(())
}

/// What an event changed. Larger values mean a larger change.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
enum News {
    Nothing,
    /// What the window showed is gone, and the picture is the same.
    Window,
    Camera,
    Setting,
    /// The window is closed.
    End,
}

struct View<'a> {
    arguments: &'a Arguments,
    /// The scene of the command line, then the other built-in ones.
    sources: Vec<Source>,
    shown: usize,
    camera: Camera,
    settings: Settings,
    /// What is wrong with the watched file.
    error: Option<String>,
}

impl<'a> View<'a> {
    fn new(source: Source, arguments: &'a Arguments) -> Self {
        let (_, camera) = source.reference();
        let mut names = scenes::NAMES.to_vec();
        if let Some(own) = names.iter().position(|&name| name == source.name()) {
            names.rotate_left(own);
            names.remove(0);
        }
        let others = names.into_iter().filter_map(Source::built_in);
        Self {
            arguments,
            sources: [source].into_iter().chain(others).collect(),
            shown: 0,
            camera,
            settings: arguments.settings(),
            error: None,
        }
    }

    fn draw(&self) -> Result<Drawing, Failure> {
        let source = &self.sources[self.shown];
        let drawing =
            Drawing::in_fixed_point(source, &self.camera, self.arguments.size, self.settings)?;
        let mut drawing = drawing.dithered(self.arguments.dither);
        if let Some(error) = &self.error {
            draw_error(error, &mut drawing.display);
        }
        Ok(drawing)
    }

    /// Takes the scene of the watched file. After an error the scene before it stays.
    fn read_again(&mut self, read: Result<Source, Failure>) -> News {
        match read {
            Ok(source) => {
                if self.shown == 0 {
                    (_, self.camera) = source.reference();
                }
                (self.sources[0], self.error) = (source, None);
            }
            Err(error) => self.error = Some(error.to_string()),
        }
        News::Camera
    }

    fn describe(&self, drawing: &Drawing) -> String {
        let name = self.sources[self.shown].name();
        report::text(name, self.arguments.size, self.settings, drawing)
    }

    /// Returns the title of the window.
    fn title(&self, drawing: &Drawing) -> String {
        let name = self.sources[self.shown].name();
        title(name, self.settings, drawing.seconds)
    }

    fn answer(&mut self, event: &Event) -> News {
        let keycode = match event {
            Event::Quit { .. } => return News::End,
            Event::Window { .. } => return News::Window,
            Event::KeyDown {
                keycode: Some(keycode),
                ..
            } => *keycode,
            _ => return News::Nothing,
        };
        match keycode {
            Keycode::Escape => News::End,
            Keycode::Left => self.orbit(-STEP, 0),
            Keycode::Right => self.orbit(STEP, 0),
            Keycode::Up => self.orbit(0, STEP),
            Keycode::Down => self.orbit(0, -STEP),
            Keycode::Plus | Keycode::KpPlus | Keycode::Equals => self.reflect(1),
            Keycode::Minus | Keycode::KpMinus => self.reflect(-1),
            Keycode::S => self.smooth(),
            Keycode::Tab => self.next_scene(),
            _ => News::Nothing,
        }
    }

    /// Turns the camera, unless it would look along its `up`.
    fn orbit(&mut self, azimuth: i32, elevation: i32) -> News {
        match exact(&self.camera).and_then(|camera| camera.orbited(azimuth, elevation)) {
            Ok(camera) => {
                self.camera = Camera::from(&camera);
                News::Camera
            }
            Err(_) => News::Nothing,
        }
    }

    fn reflect(&mut self, more: i8) -> News {
        self.settings.reflections = self.settings.reflections.saturating_add_signed(more);
        News::Setting
    }

    /// Changes between jagged edges and the smooth ones of `Smooth<2>` and `Smooth<4>`. A quality without smooth edges stays.
    fn smooth(&mut self) -> News {
        self.settings.quality = match self.settings.quality {
            Quality::Fast => Quality::Smooth2,
            Quality::Smooth2 => Quality::Smooth4,
            Quality::Smooth4 => Quality::Fast,
            other => other,
        };
        News::Setting
    }

    fn next_scene(&mut self) -> News {
        self.shown = (self.shown + 1) % self.sources.len();
        (_, self.camera) = self.sources[self.shown].reference();
        News::Setting
    }
}
