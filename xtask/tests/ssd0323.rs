//! Tests the driver of the default board's display on this machine: the bytes it sends, and that an
//! error of SPI or the pin is returned by the call that draws.

#[path = "../../examples/board/firmware/ssd0323.rs"]
mod ssd0323;

use std::{cell::RefCell, rc::Rc};

use embedded_graphics::pixelcolor::Gray4;
use embedded_graphics::prelude::*;
use embedded_graphics::primitives::Rectangle;
use embedded_hal::{digital, spi};

use reflet::scenes::{BuiltIn, Castle};
use ssd0323::{Error, Ssd0323};

/// A mock of the wires: records the sent bytes with the level of the data/command pin, and can fail
/// after a number of calls.
#[derive(Default)]
struct Wire {
    is_data: bool,
    sent: Vec<(char, u8)>,
    calls_left: Option<u32>,
}

impl Wire {
    fn call(&mut self) -> Result<(), Broken> {
        match &mut self.calls_left {
            Some(0) => Err(Broken),
            Some(calls) => {
                *calls -= 1;
                Ok(())
            }
            None => Ok(()),
        }
    }
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
struct Broken;

impl spi::Error for Broken {
    fn kind(&self) -> spi::ErrorKind {
        spi::ErrorKind::Other
    }
}

impl digital::Error for Broken {
    fn kind(&self) -> digital::ErrorKind {
        digital::ErrorKind::Other
    }
}

#[derive(Clone, Default)]
struct Wires(Rc<RefCell<Wire>>);

impl spi::ErrorType for Wires {
    type Error = Broken;
}

impl spi::SpiBus for Wires {
    fn write(&mut self, words: &[u8]) -> Result<(), Broken> {
        let mut wire = self.0.borrow_mut();
        wire.call()?;
        let letter = if wire.is_data { 'd' } else { 'c' };
        wire.sent.extend(words.iter().map(|&word| (letter, word)));
        Ok(())
    }

    fn flush(&mut self) -> Result<(), Broken> {
        self.0.borrow_mut().call()
    }

    fn read(&mut self, _: &mut [u8]) -> Result<(), Broken> {
        unreachable!("nothing can be read back")
    }

    fn transfer(&mut self, _: &mut [u8], _: &[u8]) -> Result<(), Broken> {
        unreachable!("nothing can be read back")
    }

    fn transfer_in_place(&mut self, _: &mut [u8]) -> Result<(), Broken> {
        unreachable!("nothing can be read back")
    }
}

impl digital::ErrorType for Wires {
    type Error = Broken;
}

impl digital::OutputPin for Wires {
    fn set_low(&mut self) -> Result<(), Broken> {
        self.0.borrow_mut().is_data = false;
        self.0.borrow_mut().call()
    }

    fn set_high(&mut self) -> Result<(), Broken> {
        self.0.borrow_mut().is_data = true;
        self.0.borrow_mut().call()
    }
}

/// Returns a display that has been set up, and its wire without the bytes of the set-up.
fn display() -> (Ssd0323<Wires, Wires>, Rc<RefCell<Wire>>) {
    let wires = Wires::default();
    let display = Ssd0323::new(wires.clone(), wires.clone()).unwrap();
    wires.0.borrow_mut().sent.clear();
    (display, wires.0)
}

/// Returns what is sent for a window: its commands, then its pixels.
fn window(commands: [u8; 6], data: &[u8]) -> Vec<(char, u8)> {
    let data = data.iter().map(|byte| ('d', *byte));
    commands
        .map(|byte| ('c', byte))
        .into_iter()
        .chain(data)
        .collect()
}

#[test]
fn row_is_sent_at_once_with_its_window_two_pixels_a_byte() {
    let (mut display, wire) = display();
    let area = Rectangle::new(Point::new(4, 9), Size::new(4, 2));
    let colors = (1..=8).map(Gray4::new).inspect(|color| {
        if *color == Gray4::new(5) {
            assert_eq!(wire.borrow().sent.len(), 8, "the first row is out");
        }
    });
    display.fill_contiguous(&area, colors).unwrap();
    let first = window([0x15, 2, 3, 0x75, 9, 9], &[0x12, 0x34]);
    let second = window([0x15, 2, 3, 0x75, 10, 10], &[0x56, 0x78]);
    assert_eq!(wire.borrow().sent, [first, second].concat());
}

#[test]
fn whole_row_is_sent_as_an_area_of_one_row_is() {
    let row: [_; ssd0323::WIDTH] = core::array::from_fn(|x| Gray4::new((x % 16) as u8));
    let [(mut display, wire), (mut other, expected)] = [display(), display()];
    display.show_row(7, &row).unwrap();
    let area = Rectangle::new(Point::new(0, 7), Size::new(128, 1));
    other.fill_contiguous(&area, row).unwrap();
    assert_eq!(wire.borrow().sent, expected.borrow().sent);
}

#[test]
fn pair_of_single_pixels_is_sent() {
    let (mut display, wire) = display();
    let pixel = |(x, grey)| Pixel(Point::new(x, 63), Gray4::new(grey));
    display
        .draw_iter([(126, 0xa), (127, 0xb)].map(pixel))
        .unwrap();
    let expected = window([0x15, 63, 63, 0x75, 63, 63], &[0xab]);
    assert_eq!(wire.borrow().sent, expected);
}

#[test]
fn half_a_pair_is_refused() {
    let (mut display, wire) = display();
    for (x, y, width) in [(0, 0, 1), (1, 0, 2), (2, 5, 3), (127, 0, 2), (-1, 0, 2)] {
        let area = Rectangle::new(Point::new(x, y), Size::new(width, 1));
        let refused = display.fill_solid(&area, Gray4::new(15));
        assert_eq!(refused, Err(Error::HalfPair), "{area:?}");
    }
    let bytes = wire.borrow().sent.len();
    assert!(bytes <= 7, "all pairs but one are refused whole");
}

#[test]
fn what_lies_outside_is_left_out() {
    let (mut display, wire) = display();
    let area = Rectangle::new(Point::new(-2, -1), Size::new(4, 2));
    let colors = (1..=8).map(Gray4::new);
    display.fill_contiguous(&area, colors).unwrap();
    let expected = window([0x15, 0, 0, 0x75, 0, 0], &[0x78]);
    assert_eq!(wire.borrow().sent, expected);
    let outside = Rectangle::new(Point::new(128, 0), Size::new(8, 8));
    display.fill_solid(&outside, Gray4::new(15)).unwrap();
    assert_eq!(wire.borrow().sent.len(), 7);
}

#[test]
fn fewer_colors_than_pixels_leave_the_rest_as_it_is() {
    let (mut display, wire) = display();
    let area = Rectangle::new(Point::zero(), Size::new(4, 2));
    let colors = (1..=2).map(Gray4::new);
    display.fill_contiguous(&area, colors).unwrap();
    let expected = window([0x15, 0, 0, 0x75, 0, 0], &[0x12]);
    assert_eq!(wire.borrow().sent, expected);
}

#[test]
fn display_is_black_and_only_then_switched_on() {
    let wires = Wires::default();
    Ssd0323::new(wires.clone(), wires.clone()).unwrap();
    let sent = &wires.0.borrow().sent;
    assert_eq!(sent.first(), Some(&('c', 0xae)));
    assert_eq!(sent.last(), Some(&('c', 0xaf)));
    let data: Vec<_> = sent.iter().filter(|(letter, _)| *letter == 'd').collect();
    assert_eq!(data.len(), 64 * 64);
    assert!(data.iter().all(|(_, byte)| *byte == 0));
}

#[test]
fn error_of_spi_comes_back_from_the_call_that_draws() {
    let frame = Castle::frame(&Castle::CAMERA);
    // Order of the calls of a row: `p` goes to the pin, `b` to SPI.
    let errors = "pbbpbbpbb".repeat(2);
    for (calls, kind) in errors.chars().enumerate() {
        let (mut display, wire) = display();
        wire.borrow_mut().calls_left = Some(calls as u32);
        let expected = match kind {
            'p' => Error::Pin(Broken),
            _ => Error::Bus(Broken),
        };
        let drawn = frame.draw(&mut display);
        assert_eq!(drawn, Err(expected), "after {calls} calls");
        // The last call of a row only waits until the row is sent.
        let rows_sent = wire.borrow().sent.len() / (6 + 64);
        assert_eq!(rows_sent, (calls + 1) / 9, "nothing more is drawn");
    }
    for calls in 0..50 {
        let wires = Wires::default();
        wires.0.borrow_mut().calls_left = Some(calls);
        let failed = Ssd0323::new(wires.clone(), wires);
        assert!(failed.is_err(), "set-up after {calls} calls");
    }
}
