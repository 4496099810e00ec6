//! The second core, which traces one row at a time.

use cortex_m::singleton;
use embedded_graphics::geometry::Size;
use embedded_graphics::pixelcolor::{Rgb565, RgbColor};
use heapless::spsc::{Consumer, Producer, Queue};
use reflet::Camera;
use reflet::scenes::Castle;
use rp235x_hal::multicore::{Multicore, Stack};
use rp235x_hal::pac::{PPB, PSM};
use rp235x_hal::sio::SioFifo;

/// Width and height of the picture in pixels.
pub const SIDE: u32 = 240;

/// The pixels of one row.
pub type Row = [Rgb565; SIDE as usize];

/// A row of black pixels, the initial value of row buffers.
pub const BLACK_ROW: Row = [Rgb565::BLACK; SIDE as usize];

/// Stack of the second core: 8192 words. A row of the castle takes 9 KiB at most.
static STACK: Stack<8192> = Stack::new();

/// The second core: takes a camera and the number of a row, and returns the row.
pub struct Second {
    questions: Producer<'static, (Camera, u32)>,
    answers: Consumer<'static, Row>,
}

impl Second {
    /// Starts the second core. Returns `None` if it is called again or if the core does not answer.
    pub fn start(psm: &mut PSM, ppb: &mut PPB, fifo: &mut SioFifo) -> Option<Self> {
        // A queue holds one item less than its capacity.
        let (questions, mut asked) = singleton!(: Queue<(Camera, u32), 2> = Queue::new())?.split();
        let (mut answered, answers) = singleton!(: Queue<Row, 2> = Queue::new())?.split();
        let mut cores = Multicore::new(psm, ppb, fifo);
        let [_, second] = cores.cores() else {
            return None;
        };
        let work = move || answer_all(&mut asked, &mut answered);
        second.spawn(STACK.take()?, work).ok()?;
        Some(Self { questions, answers })
    }

    /// Asks for row `y` of the castle.
    pub fn ask(&mut self, camera: Camera, y: u32) {
        let asked = self.questions.enqueue((camera, y));
        assert!(asked.is_ok(), "every row is awaited");
    }

    /// Waits for the row.
    pub fn answer(&mut self) -> Row {
        next(&mut self.answers)
    }
}

/// Runs on the second core, for ever: prepares each view once and traces its rows.
fn answer_all(asked: &mut Consumer<(Camera, u32)>, answered: &mut Producer<Row>) {
    let (mut camera, mut y) = next(asked);
    let mut row = BLACK_ROW;
    loop {
        let drawn = camera;
        let frame = Castle::frame(&drawn).prepare(Size::new(SIDE, SIDE));
        let rows = frame
            .on(&Castle)
            .expect("a constant scene never changes");
        while camera == drawn {
            rows.row(y, 0, &mut row);
            assert!(answered.enqueue(row).is_ok(), "every row is fetched");
            (camera, y) = next(asked);
        }
    }
}

fn next<T>(items: &mut Consumer<T>) -> T {
    loop {
        if let Some(item) = items.dequeue() {
            return item;
        }
    }
}
