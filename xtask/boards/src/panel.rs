//! The controller of the panel, an ST7789: takes bytes and holds the picture. It is strict: errors
//! that a real controller might ignore are faults.

use crate::fault::{Fault, fault, require};

/// Width and height of the panel in pixels.
pub const SIDE: usize = 240;

/// Rows of the controller's memory. The panel shows 240 of them.
const MEMORY_ROWS: u32 = 320;

/// Time in microseconds for which no command may follow a reset or the end of sleep.
const WAKE_UP: u64 = 5_000;

const SWRESET: u8 = 0x01;
const SLPOUT: u8 = 0x11;
const NORON: u8 = 0x13;
const INVOFF: u8 = 0x20;
const INVON: u8 = 0x21;
const DISPON: u8 = 0x29;
const CASET: u8 = 0x2a;
const RASET: u8 = 0x2b;
const RAMWR: u8 = 0x2c;
const VSCRDEF: u8 = 0x33;
const MADCTL: u8 = 0x36;
const COLMOD: u8 = 0x3a;

/// Argument of COLMOD for RGB565 on all interfaces.
const RGB565: u8 = 0x55;

/// Each command that is accepted, with its number of arguments. Those of RAMWR are pixels.
const COMMANDS: [(u8, usize); 12] = [
    (SWRESET, 0),
    (SLPOUT, 0),
    (NORON, 0),
    (INVOFF, 0),
    (INVON, 0),
    (DISPON, 0),
    (CASET, 4),
    (RASET, 4),
    (RAMWR, 0),
    (VSCRDEF, 6),
    (MADCTL, 1),
    (COLMOD, 1),
];

/// Settings that a reset restores.
#[derive(Clone, Debug)]
struct Settings {
    is_awake: bool,
    is_on: bool,
    is_inverted: bool,
    address_mode: u8,
    pixel_format: u8,
    columns: [usize; 2],
    rows: [usize; 2],
}

const RESET: Settings = Settings {
    is_awake: false,
    is_on: false,
    is_inverted: false,
    address_mode: 0,
    pixel_format: 0x66,
    columns: [0, SIDE - 1],
    rows: [0, SIDE - 1],
};

pub struct Panel {
    settings: Settings,
    /// Command that takes arguments, and those that arrived.
    command: Option<(u8, usize)>,
    arguments: Vec<u8>,
    /// Column and row of the next pixel, and the first byte of a pixel.
    place: [usize; 2],
    half: Option<u8>,
    /// Time in microseconds before which no command may come.
    ready: u64,
    picture: Vec<u16>,
    /// Row whose last pixel arrived, until it is taken.
    finished_row: Option<usize>,
}

impl Panel {
    /// Creates a controller that is switched on.
    pub fn new() -> Self {
        Self {
            settings: RESET,
            command: None,
            arguments: vec![],
            place: [0; 2],
            half: None,
            ready: 0,
            picture: vec![0; SIDE * SIDE],
            finished_row: None,
        }
    }

    /// Pixels in RGB565, row by row from the top.
    pub fn picture(&self) -> &[u16] {
        &self.picture
    }

    /// Whether the colours are inverted, as in-plane switching panels need.
    pub fn is_inverted(&self) -> bool {
        self.settings.is_inverted
    }

    /// Argument of the last MADCTL.
    pub fn address_mode(&self) -> u8 {
        self.settings.address_mode
    }

    /// Returns the row whose last pixel has arrived since the last call.
    pub fn take_finished_row(&mut self) -> Option<usize> {
        self.finished_row.take()
    }

    /// Whether pixels may follow.
    pub fn is_writing(&self) -> bool {
        matches!(self.command, Some((RAMWR, _)))
    }

    /// Restores the settings, as a low level of the reset pin does. The picture stays.
    pub fn reset(&mut self) {
        self.settings = RESET;
        self.command = None;
        self.half = None;
    }

    /// Takes a byte. `time` is in microseconds.
    pub fn take(&mut self, byte: u8, is_data: bool, time: u64) -> Result<(), Fault> {
        match (is_data, self.command) {
            (false, _) => self.start(byte, time),
            (true, Some((RAMWR, _))) => self.take_pixel_byte(byte),
            (true, Some((command, count))) => self.take_argument(command, count, byte),
            (true, None) => Err(fault!(
                "the panel got the data {byte:#04x} before a command"
            )),
        }
    }

    fn start(&mut self, command: u8, time: u64) -> Result<(), Fault> {
        self.is_complete()?;
        let known = COMMANDS.iter().find(|it| it.0 == command);
        let known = known.ok_or(fault!("the panel got the unknown command {command:#04x}"))?;
        require!(
            time >= self.ready,
            "the panel got the command {command:#04x} {} µs before it was ready after its reset or sleep",
            self.ready - time
        );
        self.command = Some(*known);
        self.arguments.clear();
        match command {
            SWRESET => {
                self.reset();
                self.ready = time + WAKE_UP;
            }
            SLPOUT => {
                self.settings.is_awake = true;
                self.ready = time + WAKE_UP;
            }
            DISPON => self.settings.is_on = true,
            INVOFF | INVON => self.settings.is_inverted = command == INVON,
            RAMWR => self.start_pixels()?,
            _ => {}
        }
        Ok(())
    }

    /// Tests that the last command got all that it takes.
    fn is_complete(&self) -> Result<(), Fault> {
        let Some((command, count)) = self.command else {
            return Ok(());
        };
        let arrived = self.arguments.len();
        require!(
            arrived == count,
            "the panel got {arrived} of {count} arguments of the command {command:#04x}"
        );
        require!(self.half.is_none(), "the panel got half of a pixel");
        Ok(())
    }

    fn take_argument(&mut self, command: u8, count: usize, byte: u8) -> Result<(), Fault> {
        require!(
            self.arguments.len() < count,
            "the panel got more than {count} arguments of the command {command:#04x}"
        );
        self.arguments.push(byte);
        if self.arguments.len() == count {
            self.set(command)?;
        }
        Ok(())
    }

    fn set(&mut self, command: u8) -> Result<(), Fault> {
        match command {
            CASET => self.settings.columns = self.window()?,
            RASET => self.settings.rows = self.window()?,
            VSCRDEF => {
                let rows: u32 = [0, 2, 4].map(|at| self.word(at)).iter().sum();
                require!(
                    rows == MEMORY_ROWS,
                    "the panel's parts for scrolling have {rows} rows, not {MEMORY_ROWS}"
                );
            }
            MADCTL => {
                let mode = self.arguments[0];
                require!(mode & 3 == 0, "the panel got the address mode {mode:#04x}");
                self.settings.address_mode = mode;
            }
            COLMOD => {
                let format = self.arguments[0];
                require!(
                    format == RGB565,
                    "the panel got the pixel format {format:#04x}, which is not RGB565"
                );
                self.settings.pixel_format = format;
            }
            _ => unreachable!("only these have arguments"),
        }
        Ok(())
    }

    fn word(&self, at: usize) -> u32 {
        u32::from(self.arguments[at]) << 8 | u32::from(self.arguments[at + 1])
    }

    fn window(&self) -> Result<[usize; 2], Fault> {
        let [first, last] = [0, 2].map(|at| self.word(at) as usize);
        require!(
            first <= last && last < SIDE,
            "the panel got the window {first} to {last} of {SIDE}"
        );
        Ok([first, last])
    }

    fn start_pixels(&mut self) -> Result<(), Fault> {
        let it = &self.settings;
        require!(
            it.is_awake && it.is_on && it.pixel_format == RGB565,
            "the panel got pixels before it was awake, on and set to RGB565"
        );
        self.place = [it.columns[0], it.rows[0]];
        Ok(())
    }

    fn take_pixel_byte(&mut self, byte: u8) -> Result<(), Fault> {
        let [x, y] = self.place;
        let Settings { columns, rows, .. } = self.settings;
        require!(
            y <= rows[1],
            "the panel got more pixels than its window holds"
        );
        let Some(high) = self.half.take() else {
            self.half = Some(byte);
            return Ok(());
        };
        self.picture[y * SIDE + x] = u16::from_be_bytes([high, byte]);
        if x == SIDE - 1 {
            self.finished_row = Some(y);
        }
        self.place = if x < columns[1] { [x + 1, y] } else { [columns[0], y + 1] };
        Ok(())
    }
}
