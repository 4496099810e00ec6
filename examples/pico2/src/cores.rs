//! The views of the scene, and the second core, which traces their odd rows.

use cortex_m::singleton;
use embedded_graphics::{prelude::*, primitives::Rectangle};
use heapless::spsc::{Consumer, Producer, Queue};
use reflet::{Camera, PreparedFrame};
use rp235x_hal::multicore::{Multicore, Stack};
use rp235x_hal::pac::{PPB, PSM};
use rp235x_hal::sio::SioFifo;

use crate::screen::{Line, SIDE};
use crate::{CAMERA, Shown};

/// Stack of the second core: 8192 words. A row of the castle takes 9 KiB at most.
static STACK: Stack<8192> = Stack::new();

/// Prepares a view.
pub fn prepare(camera: &Camera) -> PreparedFrame<Shown> {
    Shown::frame(camera).prepare(Size::new(SIDE, SIDE))
}

/// Traces row `y` of a view.
pub fn trace(frame: &PreparedFrame<Shown>, y: u32, line: &mut Line) {
    let rows = frame.on(&Shown).expect("a constant scene never changes");
    let row = Rectangle::new(Point::new(0, y as i32), Size::new(SIDE, 1));
    let Ok(_) = rows.draw_area(row, -row.top_left, line);
}

/// Starts the second core, and returns the odd rows of view after view. Returns `None` if it is
/// called again or if the core does not answer.
pub fn start(psm: &mut PSM, ppb: &mut PPB, fifo: &mut SioFifo) -> Option<Consumer<'static, Line>> {
    // A queue holds one item less than its capacity.
    let (mut traced, rows) = singleton!(: Queue<Line, 2> = Queue::new())?.split();
    let mut cores = Multicore::new(psm, ppb, fifo);
    let work = move || trace_odd_rows(&mut traced);
    cores.cores().get_mut(1)?.spawn(STACK.take()?, work).ok()?;
    Some(rows)
}

/// Runs on the second core, for ever, with the cameras of the first. Waits for each row to be fetched.
fn trace_odd_rows(traced: &mut Producer<Line>) {
    let mut line = Line::BLACK;
    let mut camera = CAMERA;
    loop {
        let frame = prepare(&camera);
        for y in (1..SIDE).step_by(2) {
            trace(&frame, y, &mut line);
            while traced.enqueue(line).is_err() {}
        }
        camera = camera.orbited(10, 0).unwrap_or(camera);
    }
}
