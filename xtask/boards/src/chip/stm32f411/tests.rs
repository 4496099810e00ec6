use super::table::{DMA, STREAM};
use super::*;

/// Register writes that enable the clocks of port A, DMA2, the power control and SPI1.
const CLOCKS: [(u32, u32); 3] = [
    (RCC + 0x30, 1 << 22 | 1),
    (RCC + 0x40, 1 << 28),
    (RCC + 0x44, 1 << 12),
];

/// Register writes for a core at 100 MHz: they set the PLL and the voltage, and make the PLL the clock of the core.
const FAST: [(u32, u32); 3] = [(RCC + 4, 200 << 6 | 25), (POWER, 3 << 14), (RCC + 8, 2)];

/// Register writes that set up the SPI for the panel, and allow the SPI to request bytes from the DMA.
const SPI_ON: [(u32, u32); 2] = [(SPI, SPI_WANTED), (SPI + 4, TX_DMA_ENABLED)];

/// Register writes that make the DMA send three bytes from RAM to the SPI. The last one starts it.
const THREE_BYTES: [(u32, u32); 4] = [
    (STREAM + 4, 3),
    (STREAM + 8, SPI + SPI_DATA),
    (STREAM + 0xc, 0x2000_0000),
    (STREAM, 3 << 25 | 1 << 10 | 1 << 6 | 1),
];

/// Writes values to registers, all in the cycle `now`. After a fault it stops, and returns its text.
fn write(chip: &mut Stm32f411, now: u64, registers: &[(u32, u32)]) -> Result<(), String> {
    registers.iter().try_for_each(|(address, value)| {
        let (address, size, core) = (*address, 4, 0);
        let access = Access {
            address,
            size,
            core,
            now,
        };
        let done = chip.write(access, *value);
        done.map(drop).map_err(|fault| fault.to_string())
    })
}

/// Enables the clocks of a new chip, then writes these values to registers. Returns the chip, and the fault if there is one.
fn chip(registers: &[&[(u32, u32)]]) -> (Stm32f411, Result<(), String>) {
    let mut chip = Stm32f411::new();
    let done = write(&mut chip, 0, &[&CLOCKS[..], &registers.concat()].concat());
    (chip, done)
}

#[test]
fn wrong_clock_and_low_voltage_are_found() {
    let with = |at: usize, wrong| {
        let mut registers = FAST;
        registers[at].1 = wrong;
        chip(&[&registers]).1
    };
    assert_eq!(chip(&[&FAST]).1, Ok(()));
    let slow = with(0, 192 << 6 | 25).unwrap_err();
    assert_eq!(slow, "the PLL gives 96000000 Hz, not 100000000 Hz");
    let low = with(1, 2 << 14).unwrap_err();
    assert_eq!(low, "100000000 Hz need the voltage of scale 1");
}

#[test]
fn slow_pin_does_not_follow_the_spi() {
    let (mode, function) = ((PORTS, 2 << 10), (PORTS + FUNCTIONS, FUNCTION_SPI << 20));
    let role = |speed: u32| {
        chip(&[&[mode, function, (PORTS + SPEEDS, speed << 10)]])
            .0
            .role(5)
    };
    assert_eq!(role(3), Role::Clock { unit: 1 });
    assert_eq!(role(2), Role::Idle);
}

#[test]
fn dma_sends_bytes_as_they_are_when_the_spi_has_room() {
    let (mut chip, done) = chip(&[&FAST, &SPI_ON, &THREE_BYTES]);
    assert_eq!(done, Ok(()));
    let mut memory = Memory::new((0x0800_0000, 0), (0x2000_0000, 16));
    memory.write(0x2000_0000, 0x30_2010, 4).unwrap();
    let mut next = |memory: &Memory, now| chip.advance(memory, now).unwrap().map(|it| it.byte);
    // A byte takes 16 cycles. One is on its way, and one waits.
    let sent = [0, 0, 0, 15].map(|now| next(&memory, now));
    assert_eq!(sent, [Some(0x10), Some(0x20), None, None]);
    memory.write(0x2000_0002, 0x99, 1).unwrap();
    let sent = [16, 16, 60].map(|now| next(&memory, now));
    assert_eq!(sent, [Some(0x99), None, None]);
    assert_eq!(chip.registers.get(DMA), 1 << 27);
    let again = write(&mut chip, 99, &THREE_BYTES).unwrap_err();
    assert_eq!(again, "the DMA's flags are not cleared");
    write(&mut chip, 99, &[(DMA + 8, 1 << 27)]).unwrap();
    assert_eq!(write(&mut chip, 99, &THREE_BYTES), Ok(()));
}

#[test]
fn wrong_uses_of_the_dma_are_found() {
    // Writes `value` to one of the registers that start the DMA, and returns the fault.
    let with = |at: usize, value| {
        let mut registers = THREE_BYTES;
        registers[at].1 = value;
        chip(&[&FAST, &SPI_ON, &registers]).1.unwrap_err()
    };
    assert_eq!(with(0, 0), "the DMA has nothing to send");
    assert_eq!(with(1, SPI), "the DMA sends to 0x40013000");
    let plain = THREE_BYTES[3].1;
    for wrong in [plain | 1 << 11, plain ^ 1 << 10, plain ^ 1 << 25] {
        assert_eq!(
            with(3, wrong),
            "the DMA does not send bytes one after another"
        );
    }
    let (_, changed) = chip(&[&FAST, &SPI_ON, &THREE_BYTES, &THREE_BYTES]);
    assert_eq!(changed.unwrap_err(), "the DMA is changed while it works");
}
