//! Flash and RAM: bytes at addresses. Knows no registers.

/// Bytes from an address on.
#[derive(Clone)]
struct Region {
    base: u32,
    bytes: Vec<u8>,
}

impl Region {
    #[inline(always)]
    fn place(&self, address: u32, size: usize) -> Option<usize> {
        let place = address.wrapping_sub(self.base) as usize;
        (place + size <= self.bytes.len()).then_some(place)
    }
}

#[derive(Clone)]
pub struct Memory {
    flash: Region,
    ram: Region,
}

impl Memory {
    /// Creates erased flash and RAM full of zeros. Each has a base address and a size in bytes.
    pub fn new((flash, flash_size): (u32, usize), (ram, ram_size): (u32, usize)) -> Self {
        let region = |base, bytes| Region { base, bytes };
        Self {
            flash: region(flash, vec![0xff; flash_size]),
            ram: region(ram, vec![0; ram_size]),
        }
    }

    /// Writes bytes into the flash. Returns `None` if they do not fit.
    pub fn program(&mut self, address: u32, bytes: &[u8]) -> Option<()> {
        let place = self.flash.place(address, bytes.len())?;
        self.flash.bytes[place..][..bytes.len()].copy_from_slice(bytes);
        Some(())
    }

    /// Returns the 4 bytes of the flash at an address.
    #[inline]
    pub fn code(&self, address: u32) -> Option<[u8; 4]> {
        let place = self.flash.place(address, 4)?;
        self.flash.bytes[place..].first_chunk().copied()
    }

    /// Reads 1, 2 or 4 bytes. Returns `None` where there is no memory.
    #[inline(always)]
    pub fn read(&self, address: u32, size: usize) -> Option<u32> {
        let region = if address < self.ram.base { &self.flash } else { &self.ram };
        let bytes = &region.bytes[region.place(address, size)?..];
        Some(match *bytes {
            [a, b, c, d, ..] if size == 4 => u32::from_le_bytes([a, b, c, d]),
            [a, b, ..] if size == 2 => u16::from_le_bytes([a, b]).into(),
            [a, ..] => a.into(),
            [] => return None,
        })
    }

    /// Writes 1, 2 or 4 bytes of RAM. Returns `None` where there is none.
    #[inline]
    pub fn write(&mut self, address: u32, value: u32, size: usize) -> Option<()> {
        let place = self.ram.place(address, size)?;
        self.ram.bytes[place..place + size].copy_from_slice(&value.to_le_bytes()[..size]);
        Some(())
    }
}
