//! What the firmware prints: reads the first buffer of RTT, as a debug probe does.

use crate::memory::Memory;

/// Places in the control block: the first buffer's address, size, and places of writer and reader.
const BUFFER: u32 = 28;
const SIZE: u32 = 32;
const WRITER: u32 = 36;
const READER: u32 = 40;

/// Largest buffer that is believed.
const LARGEST: u32 = 0x1_0000;

#[derive(Default)]
pub struct Rtt {
    block: Option<u32>,
    text: Vec<u8>,
}

impl Rtt {
    pub fn new(block: Option<u32>) -> Self {
        let text = vec![];
        Self { block, text }
    }

    /// Takes what the buffer holds.
    pub fn poll(&mut self, memory: &mut Memory) {
        let Some(block) = self.block else {
            return;
        };
        let word = |offset| memory.read(block + offset, 4).unwrap_or(0);
        let [buffer, size, writer, reader] = [BUFFER, SIZE, WRITER, READER].map(word);
        if size == 0 || size > LARGEST || writer >= size || reader >= size {
            return;
        }
        let mut at = reader;
        while at != writer {
            self.text
                .push(memory.read(buffer + at, 1).unwrap_or(0) as u8);
            at = (at + 1) % size;
        }
        memory.write(block + READER, writer, 4);
    }

    pub fn lines(&self) -> Vec<String> {
        let text = String::from_utf8_lossy(&self.text);
        text.lines().map(String::from).collect()
    }
}
