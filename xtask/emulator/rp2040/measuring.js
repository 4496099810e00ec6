// What the measurement firmware needs of its board, an MPS2 with the AN385 image: flash at 0, RAM,
// and a timer. Its core here is the M0+ of the RP2040, whose cycles are known.
//
// The firmware takes the timer for one that ticks 128 ns in 40 ns steps for every instruction; here
// it does so for every cycle, so what the firmware reports as instructions are cycles.

/** Of flash and of RAM. */
const SIZE = 4 * 1024 * 1024;

const TIMER = 0x40000;
const VALUE = 4;
const TICKS_A_CYCLE = 128 / 40;

/** Makes the chip look like that board from where the firmware stands. */
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
