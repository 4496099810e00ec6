//! Shares the rows of a picture between both cores, by turns.

use core::ops::Range;

use cortex_m::singleton;
use heapless::spsc::{Consumer, Producer, Queue};
use rp235x_hal::multicore::{Multicore, Stack};
use rp235x_hal::pac::{PPB, PSM};
use rp235x_hal::sio::SioFifo;

use crate::screen::{Line, Screen};
use crate::view::{Rows, View};

/// Stack of the second core: 8192 words. A row of the castle takes 9 KiB at most.
static STACK: Stack<8192> = Stack::new();

/// A view, and the row of it that the second core has to trace.
type Question = (View, u32);

/// Both cores.
pub struct Cores {
    questions: Producer<'static, Question>,
    answers: Consumer<'static, Line>,
}

impl Cores {
    /// Starts the second core. Returns `None` if it does not answer or if it is called again.
    pub fn new((mut psm, mut ppb, mut fifo): (PSM, PPB, SioFifo)) -> Option<Self> {
        // A queue holds one item less than its capacity.
        let (questions, asked) = singleton!(: Queue<Question, 2> = Queue::new())?.split();
        let (answered, answers) = singleton!(: Queue<Line, 2> = Queue::new())?.split();
        let mut cores = Multicore::new(&mut psm, &mut ppb, &mut fifo);
        let work = move || answer_all(asked, answered);
        cores.cores().get_mut(1)?.spawn(STACK.take()?, work).ok()?;
        Some(Self { questions, answers })
    }

    /// Draws a view, whose prepared picture on this core is `rows`. The first row of each area covers it.
    /// Ends as soon as `stop` returns `true`.
    pub fn draw(
        &mut self,
        (view, rows): (&View, &dyn Rows),
        mut areas: impl Iterator<Item = Range<u32>>,
        screen: &mut Screen,
        mut stop: impl FnMut() -> bool,
    ) {
        let mut line = Line::BLACK;
        while let (Some(area), Some(other)) = (areas.next(), areas.next()) {
            let is_asked = self.questions.enqueue((*view, other.start)).is_ok();
            assert!(is_asked, "every row is awaited");
            rows.row(area.start, &mut line);
            screen.show(area, &line);
            while !self.answers.ready() {}
            screen.show(other, &self.answers.dequeue().unwrap_or(Line::BLACK));
            if stop() {
                break;
            }
        }
        screen.send();
    }
}

/// Runs on the second core, for ever: prepares each view once and traces its rows.
fn answer_all(mut asked: Consumer<'static, Question>, mut answered: Producer<'static, Line>) {
    let mut line = Line::BLACK;
    let mut question = next(&mut asked);
    loop {
        let (view, mut y) = question;
        question = view.with_rows(|rows| {
            loop {
                rows.row(y, &mut line);
                assert!(answered.enqueue(line).is_ok(), "every row is fetched");
                let question = next(&mut asked);
                if question.0 != view {
                    return question;
                }
                y = question.1;
            }
        });
    }
}

/// Waits for the next question.
fn next(asked: &mut Consumer<'static, Question>) -> Question {
    loop {
        if let Some(question) = asked.dequeue() {
            return question;
        }
    }
}
