// An RP2040 with both cores. rp2040js emulates one core. The second shares its memory and
// peripherals, and has its own SIO, PPB and cycle count. The cores take turns of a few cycles, so a
// run gives the same result every time.

import { RP2040 } from "rp2040js";

import { Mailboxes } from "./mailboxes.js";
import { measure } from "./measuring.js";

const FLASH = 0x10000000;
const RAM = 0x20000000;
const NANOSECONDS_A_CYCLE = 8;

/** Address of the vectors: after the second stage of the boot loader. */
const VECTORS = FLASH + 0x100;

/** Cycles that one core runs before the other has its turn. */
const TURN = 64;

/** Offsets of the memory protection unit's registers in the PPB. */
const PROTECTION = { first: 0xd94, last: 0xda0 };

export class Chip {
  /** Reason why the run stopped, and the function in which it did; null while it runs. */
  fault = null;
  /** Number of executed instructions of both cores. */
  instructions = 0;
  /** Called at a breakpoint, with the core and its number. Returns whether it was expected. */
  onBreakpoint = () => false;

  /** Firmware linked to address 0 is measurement firmware: its timer counts cycles or instructions. */
  constructor(elf, cores, counts = "cycles") {
    this.elf = elf;
    this.rp2040 = new RP2040();
    if (this.#isMeasuring) {
      measure(this.rp2040, () => (counts === "cycles" ? this.cycles : this.instructions));
    }
    this.#load();
    this.#listen(this.rp2040);
    this.first = this.rp2040.core;
    this.second = this.#twin().core;
    this.mailboxes = new Mailboxes(this.rp2040, this.second, cores === 2);
    this.#boot();
  }

  get #isMeasuring() {
    return this.elf.segments.some(({ address }) => address === 0);
  }

  /** Number of cycles since the reset. */
  get cycles() {
    return this.first.cycles;
  }

  /** Runs for at least this many cycles, or until a fault. */
  run(cycles) {
    const end = this.cycles + cycles;
    while (this.cycles < end && this.fault === null) {
      this.#turn();
    }
  }

  /** Ends the run, and keeps the reason and the function in which the core was. */
  stop(core, reason) {
    this.fault ??= { reason, function: this.elf.functionAt(core.PC) };
  }

  /** Returns a word of any memory. */
  word(address) {
    return this.rp2040.readUint32(address) >>> 0;
  }

  /** Returns bytes of memory as text. */
  text(address, length) {
    const bytes = Array.from({ length }, (_, index) => this.rp2040.readUint8(address + index));
    return Buffer.from(bytes).toString("utf8");
  }

  /** Runs a turn of each core, then advances the time. */
  #turn() {
    const { first, second, mailboxes } = this;
    const start = first.cycles;
    this.#runUntil(first, start + TURN);
    if (mailboxes.secondIsStarted) {
      this.#runUntil(second, first.cycles);
    } else {
      second.cycles = first.cycles;
    }
    this.rp2040.clock.tick((first.cycles - start) * NANOSECONDS_A_CYCLE);
  }

  #runUntil(core, end) {
    while (core.cycles < end && this.fault === null) {
      if (core.waiting) {
        core.cycles = end;
      } else {
        core.executeInstruction();
        this.instructions += 1;
      }
    }
  }

  #load() {
    const { bootrom, flash, sram } = this.rp2040;
    for (const { address, bytes } of this.elf.segments) {
      if (address >= RAM) {
        sram.set(bytes, address - RAM);
      } else if (address >= FLASH) {
        flash.set(bytes, address - FLASH);
      } else {
        new Uint8Array(bootrom.buffer).set(bytes, address);
      }
    }
  }

  /**
   * Returns a view of the chip for the second core: its own core, SIO and PPB, all else shared. It has
   * the class and the fields of the first, so that the JavaScript engine runs both fast.
   */
  #twin() {
    const twin = new RP2040(this.rp2040.clock);
    const { core, sio, ppb } = twin;
    Object.assign(twin, this.rp2040, { core, sio, ppb });
    acceptMemoryProtection(ppb);
    this.#listen(twin);
    return twin;
  }

  /** Stops at warnings of rp2040js: on the real chip they would be faults. */
  #listen(view) {
    const remark = (component, message) => {
      if (component === "RP2040" || component === "CortexM0Core") {
        this.stop(view.core, message);
      }
    };
    const ignore = () => {};
    view.logger = { debug: ignore, info: ignore, warn: remark, error: remark };
    view.onBreak = (number) => {
      if (!this.onBreakpoint(view.core, number)) {
        this.stop(view.core, "breakpoint or undefined instruction");
      }
    };
  }

  /** Starts the first core as the boot ROM and the second stage of the boot loader do. */
  #boot() {
    const vectors = this.#isMeasuring ? 0 : VECTORS;
    this.first.VTOR = vectors;
    this.first.SP = this.word(vectors);
    this.first.PC = this.word(vectors + 4) & ~1;
  }
}

/**
 * Ignores writes to the memory protection unit, which rp2040js does not have. The firmware guards the
 * second core's stack with it.
 */
function acceptMemoryProtection(ppb) {
  const isProtection = (offset) => offset >= PROTECTION.first && offset <= PROTECTION.last;
  const read = ppb.readUint32.bind(ppb);
  const write = ppb.writeUint32.bind(ppb);
  ppb.readUint32 = (offset) => (isProtection(offset) ? 0 : read(offset));
  ppb.writeUint32 = (offset, value) => (isProtection(offset) ? undefined : write(offset, value));
}
