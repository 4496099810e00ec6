// Answers the firmware's semihosting calls: a breakpoint with the call and its argument in the first
// two registers.

const BREAKPOINT = 0xab;

const OPEN = 0x01;
const CLOSE = 0x02;
const WRITE_CHARACTER = 0x03;
const WRITE_TEXT = 0x04;
const WRITE = 0x05;
const EXIT = 0x18;
const EXIT_EXTENDED = 0x20;

const WENT_WELL = 0x20026;

export class Semihosting {
  /** Lines that the firmware printed, each with the counts at the time when it began. */
  lines = [];
  /** Whether the firmware has ended itself with success. */
  hasExited = false;

  #chip;
  #isNewLine = true;

  constructor(chip) {
    this.#chip = chip;
    chip.onBreakpoint = (core, number) => number === BREAKPOINT && this.#answer(core);
  }

  #answer(core) {
    const chip = this.#chip;
    const [question, argument] = core.registers;
    core.registers[0] = 0;
    switch (question) {
      case OPEN:
        core.registers[0] = 1;
        break;
      case CLOSE:
        break;
      case WRITE_CHARACTER:
        this.#write(chip.text(argument, 1));
        break;
      case WRITE_TEXT: {
        let length = 0;
        while (chip.rp2040.readUint8(argument + length) !== 0) {
          length += 1;
        }
        this.#write(chip.text(argument, length));
        break;
      }
      case WRITE:
        this.#write(chip.text(chip.word(argument + 4), chip.word(argument + 8)));
        break;
      case EXIT:
        this.#exit(core, argument, 0);
        break;
      case EXIT_EXTENDED:
        this.#exit(core, chip.word(argument), chip.word(argument + 4));
        break;
      default:
        return false;
    }
    return true;
  }

  #exit(core, reason, code) {
    this.hasExited = reason === WENT_WELL && code === 0;
    if (!this.hasExited) {
      this.#chip.stop(core, `the firmware gave up (0x${reason.toString(16)}, ${code})`);
    }
  }

  #write(text) {
    const { cycles, instructions } = this.#chip;
    for (const part of text.split(/(?<=\n)/)) {
      if (this.#isNewLine) {
        this.lines.push({ text: "", cycles, instructions });
      }
      this.lines.at(-1).text += part.replace(/\n$/, "");
      this.#isNewLine = part.endsWith("\n");
    }
  }
}
