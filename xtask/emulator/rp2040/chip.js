// An RP2040 with both cores. rp2040js brings one; the second shares its memory and peripherals
// and has a SIO, a PPB and a cycle count of its own. The cores take turns of a few cycles, so a
// run is the same every time.

import { RP2040 } from "rp2040js";

import { Mailboxes } from "./mailboxes.js";
import { measure } from "./measuring.js";

const FLASH = 0x10000000;
const RAM = 0x20000000;
const NANOSECONDS_A_CYCLE = 8;

/** Where the vectors are behind the second stage of the boot loader. */
const VECTORS = FLASH + 0x100;

/** How many cycles one core runs before the other has its turn. */
const TURN = 64;

/** The registers of the memory protection unit, in the PPB. */
const PROTECTION = { first: 0xd94, last: 0xda0 };

export class Chip {
  /** What stopped the run, and in which function, once something has. */
  fault = null;
  /** Executed by both cores. */
  instructions = 0;
  /** Called with the core and the number of a breakpoint; returns whether it was expected. */
  onBreakpoint = () => false;

  /** Firmware linked to address 0 is for measuring; its timer counts cycles or instructions. */
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

  /** Cycles since the reset. */
  get cycles() {
    return this.first.cycles;
  }

  /** Runs for at least so many cycles, less where there is a fault. */
  run(cycles) {
    const end = this.cycles + cycles;
    while (this.cycles < end && this.fault === null) {
      this.#turn();
    }
  }

  /** Ends the run, with the reason and where the core was. */
  stop(core, reason) {
    this.fault ??= { reason, function: this.elf.functionAt(core.PC) };
  }

  /** A word of memory, wherever it is. */
  word(address) {
    return this.rp2040.readUint32(address) >>> 0;
  }

  /** Bytes of memory as text. */
  text(address, length) {
    const bytes = Array.from({ length }, (_, index) => this.rp2040.readUint8(address + index));
    return Buffer.from(bytes).toString("utf8");
  }

  /** A turn of each core; time passes after it. */
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

  /** The same chip as the second core sees it. Of one class and shape, so that both are fast. */
  #twin() {
    const twin = new RP2040(this.rp2040.clock);
    const { core, sio, ppb } = twin;
    Object.assign(twin, this.rp2040, { core, sio, ppb });
    acceptMemoryProtection(ppb);
    this.#listen(twin);
    return twin;
  }

  /** What the real chip would take a fault on, rp2040js only remarks. */
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

  /** Does what the boot ROM and the second stage of the boot loader do for the first core. */
  #boot() {
    const vectors = this.#isMeasuring ? 0 : VECTORS;
    this.first.VTOR = vectors;
    this.first.SP = this.word(vectors);
    this.first.PC = this.word(vectors + 4) & ~1;
  }
}

/** rp2040js has no memory protection; what guards the second core's stack is taken and ignored. */
function acceptMemoryProtection(ppb) {
  const isProtection = (offset) => offset >= PROTECTION.first && offset <= PROTECTION.last;
  const read = ppb.readUint32.bind(ppb);
  const write = ppb.writeUint32.bind(ppb);
  ppb.readUint32 = (offset) => (isProtection(offset) ? 0 : read(offset));
  ppb.writeUint32 = (offset, value) => (isProtection(offset) ? undefined : write(offset, value));
}
