// Emulates what the measurement firmware needs of its board, an MPS2 with the AN385 image: flash at
// 0, RAM, and a timer. The core here is the M0+ of the RP2040, whose cycles are known.
//
// The firmware expects a timer of 40 ns ticks that advances 128 ns with every instruction. Here it
// advances 128 ns with every cycle, so the instructions that the firmware reports are cycles.

/** Size of the flash and of the RAM, in bytes. */
const SIZE = 4 * 1024 * 1024;

const TIMER = 0x40000;
const VALUE = 4;
const TICKS_A_CYCLE = 128 / 40;

/** Replaces memory and timer of the chip by those of the MPS2. `clock` returns the timer's count. */
export function measure(rp2040, clock) {
  rp2040.bootrom = new Uint32Array(SIZE / 4);
  rp2040.sram = new Uint8Array(SIZE);
  rp2040.sramView = new DataView(rp2040.sram.buffer);
  rp2040.peripherals[TIMER] = {
    readUint32: (offset) =>
      offset === VALUE ? 0xffffffff - (Math.floor(clock() * TICKS_A_CYCLE) % 2 ** 32) : 0,
    writeUint32Atomic: () => {},
  };
}
