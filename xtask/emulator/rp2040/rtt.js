// Reads the firmware's output by RTT: text in a ring buffer in its memory, found by its symbol.

const CONTROL_BLOCK = "_SEGGER_RTT";

/** Offset of the description of the first buffer to the debugger, in the control block. */
const BUFFER = 0x18;

/** More than any buffer: a larger size means that something has written over the control block. */
const LARGEST = 0x10000;

export class Rtt {
  #chip;
  #control;
  #text = "";

  constructor(chip) {
    this.#chip = chip;
    this.#control = chip.elf.address(CONTROL_BLOCK);
  }

  /** Lines that the firmware has printed so far. */
  get lines() {
    this.#collect();
    return this.#text.split("\n").filter((line) => line !== "");
  }

  #collect() {
    if (this.#control === undefined) {
      return;
    }
    const at = this.#control + BUFFER;
    const [buffer, size, written, read] = [4, 8, 12, 16].map((offset) => this.#chip.word(at + offset));
    if (size > LARGEST || written > size) {
      const { first } = this.#chip;
      this.#chip.stop(first, "the RTT buffer is overwritten, perhaps by a stack that is too small");
      return;
    }
    if (written === size) {
      return;
    }
    this.#text += written >= read
      ? this.#chip.text(buffer + read, written - read)
      : this.#chip.text(buffer + read, size - read) + this.#chip.text(buffer, written);
    this.#chip.rp2040.writeUint32(at + 16, written);
  }
}
