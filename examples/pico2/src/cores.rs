//! The views of the castle, and the second core, which traces their odd rows.

use cortex_m::singleton;
use embedded_graphics::geometry::Size;
use embedded_graphics::pixelcolor::{Rgb565, RgbColor};
use heapless::spsc::{Consumer, Producer, Queue};
use reflet::scenes::{BuiltIn, Castle};
use reflet::{Camera, PreparedFrame};
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

/// Returns the camera of the next view, 10° to the right.
pub fn after(camera: Camera) -> Camera {
    // A camera cannot look along its `up`: then it keeps its place.
    camera.orbited(10, 0).unwrap_or(camera)
}

/// Prepares a view.
pub fn prepare(camera: &Camera) -> PreparedFrame<Castle> {
    Castle::frame(camera).prepare(Size::new(SIDE, SIDE))
}

/// Traces row `y` of a view.
pub fn trace(frame: &PreparedFrame<Castle>, y: u32, row: &mut Row) {
    let rows = frame.on(&Castle);
    rows.expect("a constant scene never changes").row(y, 0, row);
}

/// Starts the second core, and returns the odd rows of view after view. Returns `None` if it is
/// called again or if the core does not answer.
pub fn start(psm: &mut PSM, ppb: &mut PPB, fifo: &mut SioFifo) -> Option<Consumer<'static, Row>> {
    // A queue holds one item less than its capacity.
    let (mut traced, rows) = singleton!(: Queue<Row, 2> = Queue::new())?.split();
    let mut cores = Multicore::new(psm, ppb, fifo);
    let second = cores.cores().get_mut(1)?;
    let work = move || trace_odd_rows(&mut traced);
    second.spawn(STACK.take()?, work).ok()?;
    Some(rows)
}

/// Runs on the second core, for ever. Waits for each row to be fetched.
fn trace_odd_rows(traced: &mut Producer<Row>) {
    let mut row = BLACK_ROW;
    let mut camera = Castle::CAMERA;
    loop {
        let frame = prepare(&camera);
        for y in (1..SIDE).step_by(2) {
            trace(&frame, y, &mut row);
            while traced.enqueue(row).is_err() {}
        }
        camera = after(camera);
    }
}
