//! The firmware: the bytes of an ELF file and where they lie, and where its RTT buffers are.

use std::fs;
use std::path::Path;

use object::read::elf::{ElfFile32, ProgramHeader};
use object::{Endianness, Object, ObjectSymbol, elf};

use crate::fault::Failure;

/// Name that `rtt-target` and SEGGER give to the control block.
const RTT: &str = "_SEGGER_RTT";

pub struct Firmware {
    /// Bytes that are flashed, each part with its address.
    pub parts: Vec<(u32, Vec<u8>)>,
    /// Address of the control block of RTT, if the firmware prints.
    pub rtt: Option<u32>,
}

impl Firmware {
    pub fn read(path: &Path) -> Result<Self, Failure> {
        let bytes = fs::read(path)?;
        Self::parse(&bytes).map_err(Failure::Program)
    }

    fn parse(bytes: &[u8]) -> Result<Self, String> {
        let file = ElfFile32::<Endianness>::parse(bytes).map_err(|error| error.to_string())?;
        let endian = file.endian();
        let mut parts = vec![];
        for header in file.elf_program_headers() {
            if header.p_type(endian) != elf::PT_LOAD || header.p_filesz(endian) == 0 {
                continue;
            }
            let data = header.data(endian, bytes);
            let data = data.map_err(|()| "a part is cut off")?;
            parts.push((header.p_paddr(endian), data.to_vec()));
        }
        let rtt = file.symbols().find(|it| it.name() == Ok(RTT));
        let rtt = rtt.map(|it| it.address() as u32);
        Ok(Self { parts, rtt })
    }
}
