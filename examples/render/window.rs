//! Shows the scene in the simulator's window and reacts to its keys.

use std::panic::{self, AssertUnwindSafe};
use std::thread;
use std::time::Duration;

use embedded_graphics_simulator::sdl2::Keycode;
use embedded_graphics_simulator::{OutputSettingsBuilder, SimulatorEvent, Window};
use reflet::host::reference::Camera;
use reflet::scenes;

use crate::arguments::Arguments;
use crate::picture::Drawing;
use crate::watch::{Watch, draw_error};
use crate::{output, report};
use command_line::{Failure, Named, Settings, Source, exact};

/// Degrees by which one press of an arrow key turns the camera.
const STEP: i32 = 5;

/// The simulator sets the title once, before it opens the window.
const TITLE: &str = "reflet: arrows orbit, + - reflections, Tab next scene, Escape leaves";

const REST: Duration = Duration::from_millis(10);

/// Shows the scene until the window is closed.
pub fn show(source: Source, arguments: &Arguments) -> Result<(), Failure> {
    if arguments.watch && !matches!(Named::of(&arguments.scene, &arguments.chosen)?, Named::File) {
        return Err(format!("--watch needs a scene file: {} is built in", source.name()).into());
    }
    let mut watch = arguments.watch.then(|| Watch::new(arguments));
    let mut view = View::new(source, arguments);
    let mut drawing = view.draw()?;
    let mut window = open(arguments, &drawing)?;
    loop {
        let events: Vec<_> = window.events().collect();
        if events.contains(&SimulatorEvent::Quit) {
            return Ok(());
        }
        let news = events.into_iter().map(|event| view.answer(event)).max();
        let change = watch.as_mut().and_then(Watch::change);
        let change = change.map(|read| view.read_again(read));
        match news.max(change).unwrap_or(News::Nothing) {
            News::Nothing => thread::sleep(REST),
            news => {
                drawing = view.draw()?;
                if news == News::Setting {
                    output::print(arguments, &view.describe(&drawing))?;
                }
            }
        }
        window.update(&drawing.display);
    }
}

/// Opens the window. Small pictures are enlarged by a whole factor.
fn open(arguments: &Arguments, drawing: &Drawing) -> Result<Window, Failure> {
    let longer = arguments.size.width.max(arguments.size.height);
    let settings = OutputSettingsBuilder::new()
        .scale((640 / longer).max(1))
        .build();
    let first_update = || {
        let mut window = Window::new(TITLE, &settings);
        window.update(&drawing.display);
        window
    };
    // The simulator returns no errors: without a screen it panics.
    let loud = panic::take_hook();
    panic::set_hook(Box::new(|_| {}));
    let opened = panic::catch_unwind(AssertUnwindSafe(first_update));
    panic::set_hook(loud);
    opened.map_err(|reason| {
        let reason = reason
            .downcast_ref::<String>()
            .map_or("no reason is known", String::as_str);
        format!("the window cannot be opened: {reason}").into()
    })
}

/// What an event changed. Larger values mean a larger change.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
enum News {
    Nothing,
    Camera,
    Setting,
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
        let start = scenes::NAMES
            .iter()
            .position(|&name| name == source.name())
            .unwrap_or(0);
        let names = scenes::NAMES
            .iter()
            .cycle()
            .skip(start)
            .take(scenes::NAMES.len());
        let others = names
            .filter(|&&name| name != source.name())
            .filter_map(|name| Source::built_in(name));
        let others: Vec<_> = others.collect();
        let sources = [source].into_iter().chain(others).collect();
        let settings = arguments.settings();
        Self {
            arguments,
            sources,
            shown: 0,
            camera,
            settings,
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
        report::text(
            self.sources[self.shown].name(),
            self.arguments.size,
            self.settings,
            drawing,
        )
    }

    fn answer(&mut self, event: SimulatorEvent) -> News {
        let SimulatorEvent::KeyDown { keycode, .. } = event else {
            return News::Nothing;
        };
        match keycode {
            Keycode::Left => self.orbit(-STEP, 0),
            Keycode::Right => self.orbit(STEP, 0),
            Keycode::Up => self.orbit(0, STEP),
            Keycode::Down => self.orbit(0, -STEP),
            Keycode::Plus | Keycode::KpPlus | Keycode::Equals => self.reflect(1),
            Keycode::Minus | Keycode::KpMinus => self.reflect(-1),
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

    fn next_scene(&mut self) -> News {
        self.shown = (self.shown + 1) % self.sources.len();
        (_, self.camera) = self.sources[self.shown].reference();
        News::Setting
    }
}
