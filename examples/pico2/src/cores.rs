//! The views of the scene, and the second core, which traces their odd rows.

use cortex_m::singleton;
use embedded_graphics::{pixelcolor::Rgb565, prelude::*};
use heapless::spsc::{Consumer, Producer, Queue};
use reflet::{Camera, PreparedFrame};
use rp235x_hal::multicore::{Multicore, Stack};
use rp235x_hal::pac::{PPB, PSM};
use rp235x_hal::sio::SioFifo;

use crate::{CAMERA, Shown};

/// Width and height of the picture in pixels.
pub const SIDE: u32 = 240;

/// The pixels of one row.
pub type Row = [Rgb565; SIDE as usize];

/// Stack of the second core: 8192 words. A row of the castle takes 9 KiB at most.
static STACK: Stack<8192> = Stack::new();

/// Prepares a view.
pub fn prepare(camera: &Camera) -> PreparedFrame<Shown> {
    Shown::frame(camera).prepare(Size::new(SIDE, SIDE))
}

/// Traces row `y` of a view.
pub fn trace(frame: &PreparedFrame<Shown>, y: u32, row: &mut Row) {
    let rows = frame.on(&Shown);
    rows.expect("a constant scene never changes").row(y, 0, row);
}

/// Starts the second core, and returns the odd rows of view after view. Returns `None` if it is
/// called again or if the core does not answer.
pub fn start(psm: &mut PSM, ppb: &mut PPB, fifo: &mut SioFifo) -> Option<Consumer<'static, Row>> {
    // A queue holds one item less than its capacity.
    let (mut traced, rows) = singleton!(: Queue<Row, 2> = Queue::new())?.split();
    let mut cores = Multicore::new(psm, ppb, fifo);
    let work = move || trace_odd_rows(&mut traced);
    cores.cores().get_mut(1)?.spawn(STACK.take()?, work).ok()?;
    Some(rows)
}

/// Runs on the second core, for ever, with the cameras of the first. Waits for each row to be fetched.
fn trace_odd_rows(traced: &mut Producer<Row>) {
    let mut row = [Rgb565::BLACK; SIDE as usize];
    let mut camera = CAMERA;
    loop {
        let frame = prepare(&camera);
        for y in (1..SIDE).step_by(2) {
            trace(&frame, y, &mut row);
            while traced.enqueue(row).is_err() {}
        }
        camera = camera.orbited(10, 0).unwrap_or(camera);
    }
}
