//! Measures how many times as long as the library the double-precision reference takes for a
//! picture.
//!
//! Both draw the same scene with the same camera, size, reflections and shading, to 8 bits a
//! channel. Both trace every pixel, on the same single thread. They take turns, a frame each, so
//! that other work of the machine slows both down alike: the quotient is more reliable than the two
//! times.
//!
//! `cargo bench --package benchmark` prints the time of a frame and, at the end, a table of the
//! quotients.

use std::cell::RefCell;
use std::error::Error;
use std::hint::black_box;
use std::time::{Duration, Instant};

use benchmark::{Mirrors, Order};
use criterion::Criterion;
use embedded_graphics::prelude::Size;
use rayon::ThreadPoolBuilder;
use reflet::__private::Drawable;
use reflet::FrameBuilder;
use reflet::host::compare::compare;
use reflet::host::file::SceneFile;
use reflet::host::reference::{Picture, Shading};
use reflet::host::{painted, reference};
use reflet::quality::Exact;
use reflet::scenes::{BuiltIn, Castle};

const SIDE: u32 = 128;
const REFLECTIONS: u8 = 4;

/// The reference should take at least this many times as long as the library.
const BAR: f64 = 3.0;

fn main() -> Result<(), Box<dyn Error>> {
    // The reference uses all threads of the pool that it is called in.
    let pool = ThreadPoolBuilder::new().num_threads(1).build()?;
    pool.install(|| run().map_err(|error| error.to_string()))?;
    Ok(())
}

fn run() -> Result<(), Box<dyn Error>> {
    let pairs = [castle()?, spheres(64)?, spheres(256)?];
    let mut criterion = Criterion::default()
        .without_plots()
        .sample_size(25)
        .warm_up_time(Duration::from_millis(500))
        .measurement_time(Duration::from_secs(5))
        .configure_from_args();
    for pair in &pairs {
        pair.measure(&mut criterion);
    }
    criterion.final_summary();
    let lines: Vec<_> = pairs.iter().filter_map(Pair::line).collect();
    if !lines.is_empty() {
        println!(
            "reference / library, {SIDE}x{SIDE}, {REFLECTIONS} reflections; the bar is {BAR}\n"
        );
        println!("{:<12}  median  middle half    all", "scene");
        println!("{}", lines.join("\n"));
    }
    Ok(())
}

fn castle() -> Result<Pair, Box<dyn Error>> {
    let scene = Castle::with_description(|description| reference::Scene::from(&description));
    let camera = reference::Camera::from(&Castle::CAMERA);
    Pair::new(
        "castle".to_owned(),
        || by_library(&Castle, Castle::frame(&Castle::CAMERA)),
        move || by_reference(&scene, &camera),
    )
}

/// Returns the scene with this number of spheres, which `cargo xtask scale` also measures.
fn spheres(count: usize) -> Result<Pair, Box<dyn Error>> {
    let text = benchmark::scene(count, Mirrors::EveryOther, Order::Spiral);
    let file = SceneFile::parse(&text, None)?;
    let (built, (_, camera)) = (file.build()?, file.runtime()?);
    let (scene, reference_camera) = file.reference();
    Pair::new(
        format!("{count} spheres"),
        move || by_library(&*built, built.frame(&camera)),
        move || by_reference(&scene, &reference_camera),
    )
}

/// Draws a frame with the library, including its preparation.
fn by_library<S: Drawable>(scene: &S, frame: FrameBuilder<'_, S>) -> Picture {
    let frame = frame.quality::<Exact>().reflections(REFLECTIONS);
    let frame = frame.prepare(Size::new_equal(SIDE));
    painted(&frame.on(scene).expect("the frame is this scene's"))
}

fn by_reference(scene: &reference::Scene, camera: &reference::Camera) -> Picture {
    let (reflections, shading) = (REFLECTIONS.into(), Shading::BlinnPhong);
    reference::render(scene, camera, SIDE, SIDE, reflections, shading)
}

type Draw = Box<dyn Fn() -> Picture>;

struct Pair {
    name: String,
    library: Draw,
    reference: Draw,
    /// Measured quotients reference / library. Each is over some frames in turns.
    quotients: RefCell<Vec<f64>>,
}

impl Pair {
    /// Fails if the two pictures differ: then their times could not be compared.
    fn new(
        name: String,
        library: impl Fn() -> Picture + 'static,
        reference: impl Fn() -> Picture + 'static,
    ) -> Result<Self, Box<dyn Error>> {
        let difference = compare(&library(), &reference())?;
        if difference.within1 < 0.999 {
            return Err(format!("{name}: not the same picture: {difference:?}").into());
        }
        Ok(Self {
            name,
            library: Box::new(library),
            reference: Box::new(reference),
            quotients: RefCell::default(),
        })
    }

    fn measure(&self, criterion: &mut Criterion) {
        let mut group = criterion.benchmark_group(&self.name);
        group.bench_function("reference", |bencher| {
            bencher.iter_custom(|frames| self.in_turns(frames).0);
        });
        group.bench_function("library", |bencher| {
            bencher.iter_custom(|frames| self.in_turns(frames).1);
        });
        group.finish();
    }

    /// Draws `frames` frames with each. Returns the time of the reference and that of the library.
    fn in_turns(&self, frames: u64) -> (Duration, Duration) {
        let (mut reference, mut library) = (Duration::ZERO, Duration::ZERO);
        for _ in 0..frames {
            reference += time(&self.reference);
            library += time(&self.library);
        }
        let quotient = reference.as_secs_f64() / library.as_secs_f64();
        self.quotients.borrow_mut().push(quotient);
        (reference, library)
    }

    /// Returns the row of the table, or `None` if the command line left out this scene.
    fn line(&self) -> Option<String> {
        let mut all = self.quotients.borrow().clone();
        all.sort_by(f64::total_cmp);
        let last = all.len().checked_sub(1)?;
        let [least, low, median, high, most] = [0, 1, 2, 3, 4].map(|part| all[last * part / 4]);
        Some(format!(
            "{:<12}  {median:>6.2}  {low:.2} to {high:.2}   {least:.2} to {most:.2}",
            self.name
        ))
    }
}

fn time(draw: &Draw) -> Duration {
    let start = Instant::now();
    black_box(draw());
    start.elapsed()
}
