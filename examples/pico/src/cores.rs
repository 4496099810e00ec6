//! Shares the rows of a picture between both cores: the first traces the even rows, the second the
//! odd ones.
//!
//! If no second core answers, as in most emulators, the first traces all rows.

use core::ops::Range;

use cortex_m::singleton;
use heapless::spsc::{Consumer, Producer, Queue};

use crate::board::chip::Timer;
use crate::board::chip::hal::fugit::ExtU64;
use crate::board::chip::hal::multicore::{Multicore, Stack};
use crate::board::chip::hal::pac::{PPB, PSM};
use crate::board::chip::hal::sio::SioFifo;
use crate::screen::{Line, Screen};
use crate::view::View;

/// Stack of the second core: 4096 words. A row of the castle takes 9 KiB at most, and 2 KiB more with smooth edges.
static STACK: Stack<4096> = Stack::new();

/// Number of words that the FIFO between the cores holds.
const FIFO_DEPTH: usize = 8;

/// Rows of a prepared picture, whatever its scene.
pub trait Rows {
    /// Traces row `y` of the panel.
    fn row(&self, y: u32, line: &mut Line);
}

/// The first core, and the second if there is one.
pub struct Cores {
    second: Option<Second>,
}

impl Cores {
    /// Starts the second core if there is one.
    pub fn new((mut psm, mut ppb, mut fifo): (PSM, PPB, SioFifo), timer: Timer) -> Self {
        let is_there = second_answers(&mut psm, &mut fifo, timer);
        let start = || Second::start(&mut psm, &mut ppb, &mut fifo);
        Self {
            second: is_there.then(start).flatten(),
        }
    }

    /// Returns the number of cores: 1 or 2.
    pub fn count(&self) -> usize {
        1 + usize::from(self.second.is_some())
    }

    /// Draws a view, whose prepared picture on this core is `rows`, with both cores by turns. The first
    /// row of each area covers it. Ends as soon as `stop` returns something, and returns that.
    ///
    /// The second core is asked for its row one turn ahead. So neither core waits for the other after each pair of rows.
    pub fn draw<T>(
        &mut self,
        (view, rows): (&View, &dyn Rows),
        mut areas: impl Iterator<Item = Range<u32>>,
        screen: &mut Screen,
        mut stop: impl FnMut() -> Option<T>,
    ) -> Option<T> {
        let mut line = Line::BLACK;
        let mut stopped = None;
        let mut turn = self.next_turn(view, &mut areas);
        while let (None, [Some(area), other]) = (&stopped, turn.clone()) {
            turn = self.next_turn(view, &mut areas);
            rows.row(area.start, &mut line);
            screen.show(area, &line);
            stopped = stop();
            if let Some(other) = other {
                match &mut self.second {
                    Some(second) => line = awaited(&mut second.answers),
                    None => rows.row(other.start, &mut line),
                }
                screen.show(other, &line);
            }
        }
        if let (Some(second), [_, Some(_)]) = (&mut self.second, turn) {
            // Its last row is awaited, though nobody will see it.
            awaited(&mut second.answers);
        }
        screen.send();
        stopped
    }

    /// Returns the areas of the next turn: one for each core. Asks the second core for its own.
    fn next_turn(
        &mut self,
        view: &View,
        areas: &mut impl Iterator<Item = Range<u32>>,
    ) -> [Option<Range<u32>>; 2] {
        let turn = [areas.next(), areas.next()];
        if let (Some(second), [_, Some(other)]) = (&mut self.second, &turn) {
            let is_asked = second.questions.enqueue((*view, other.start)).is_ok();
            assert!(is_asked, "every row is awaited");
        }
        turn
    }
}

/// The second core, which traces one row at a time.
struct Second {
    questions: Producer<'static, (View, u32)>,
    answers: Consumer<'static, Line>,
}

impl Second {
    fn start(psm: &mut PSM, ppb: &mut PPB, fifo: &mut SioFifo) -> Option<Self> {
        // One row is awaited and one is asked for. A queue holds one item less than its capacity.
        let questions = singleton!(: Queue<(View, u32), 3> = Queue::new())?;
        let answers = singleton!(: Queue<Line, 3> = Queue::new())?;
        let (questions, asked) = questions.split();
        let (answered, answers) = answers.split();
        let mut cores = Multicore::new(psm, ppb, fifo);
        let [_, second] = cores.cores() else {
            return None;
        };
        second
            .spawn(STACK.take()?, move || answer_all(asked, answered))
            .ok()?;
        Some(Self { questions, answers })
    }
}

/// Runs on the second core, for ever: prepares each view once and traces its rows.
fn answer_all(mut asked: Consumer<'static, (View, u32)>, mut answered: Producer<'static, Line>) {
    let mut question = awaited(&mut asked);
    loop {
        let (view, _) = question;
        question = view.with_rows(|rows| answer_about(rows, question, &mut asked, &mut answered));
    }
}

/// Traces the rows of one view. Returns the first question about another view.
fn answer_about(
    rows: &dyn Rows,
    (view, mut y): (View, u32),
    asked: &mut Consumer<'static, (View, u32)>,
    answered: &mut Producer<'static, Line>,
) -> (View, u32) {
    let mut line = Line::BLACK;
    loop {
        rows.row(y, &mut line);
        assert!(answered.enqueue(line).is_ok(), "every row is fetched");
        let question = awaited(asked);
        if question.0 != view {
            return question;
        }
        y = question.1;
    }
}

/// Waits for the next item.
fn awaited<T>(items: &mut Consumer<'static, T>) -> T {
    loop {
        if let Some(item) = items.dequeue() {
            return item;
        }
    }
}

/// Resets the second core, and tests whether its boot ROM sends a 0 to the first, as it does before
/// it can be started. Without this test, starting a core that is not there would wait for ever.
fn second_answers(psm: &mut PSM, fifo: &mut SioFifo, timer: Timer) -> bool {
    psm.frce_off().modify(|_, power| power.proc1().set_bit());
    while psm.frce_off().read().proc1().bit_is_clear() {}
    for _ in 0..FIFO_DEPTH {
        fifo.read();
    }
    psm.frce_off().modify(|_, power| power.proc1().clear_bit());
    let deadline = timer.get_counter() + 10.millis::<1, 1_000_000>();
    loop {
        if let Some(greeting) = fifo.read() {
            return greeting == 0;
        }
        if timer.get_counter() > deadline {
            return false;
        }
    }
}
