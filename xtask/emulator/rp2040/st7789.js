// Emulates the display's controller, as far as the firmware uses it: takes bytes, and holds the
// picture. It is strict: errors that a real controller might ignore end the run.

const SOFT_RESET = 0x01;
const SLEEP_OUT = 0x11;
const NORMAL_MODE = 0x13;
const INVERT_OFF = 0x20;
const INVERT_ON = 0x21;
const DISPLAY_ON = 0x29;
const COLUMNS = 0x2a;
const ROWS = 0x2b;
const WRITE = 0x2c;
const ADDRESS_MODE = 0x36;
const PIXEL_FORMAT = 0x3a;

const RGB565 = 0x55;

export class St7789 {
  constructor(width, height) {
    this.width = width;
    this.height = height;
    /** The picture as it was sent: row by row, two bytes a pixel, the high byte first. */
    this.picture = Buffer.alloc(width * height * 2);
    /** Called with the number of a row when its last pixel has been sent. */
    this.onRow = () => {};
    this.reset();
  }

  /** Resets all settings, as a low level at the reset pin does. The picture stays. */
  reset() {
    this.isAwake = false;
    this.isOn = false;
    this.isInverted = false;
    this.addressMode = 0;
    this.pixelFormat = 0x66;
    this.columns = [0, this.width - 1];
    this.rows = [0, this.height - 1];
    this.command = null;
    this.parameters = [];
  }

  /** Takes a byte that was sent while the data/command pin is low. */
  takeCommand(byte) {
    this.command = byte;
    this.parameters = [];
    switch (byte) {
      case SOFT_RESET:
        this.reset();
        break;
      case SLEEP_OUT:
        this.isAwake = true;
        break;
      case DISPLAY_ON:
        this.isOn = true;
        break;
      case INVERT_OFF:
      case INVERT_ON:
        this.isInverted = byte === INVERT_ON;
        break;
      case WRITE:
        this.#startPixels();
        break;
      case NORMAL_MODE:
      case COLUMNS:
      case ROWS:
      case ADDRESS_MODE:
      case PIXEL_FORMAT:
        break;
      default:
        throw new Error(`the ST7789 got the unknown command 0x${byte.toString(16)}`);
    }
  }

  /** Takes a byte that was sent while the data/command pin is high. */
  takeData(byte) {
    if (this.command === WRITE) {
      this.#takePixelByte(byte);
      return;
    }
    this.parameters.push(byte);
    const { length } = this.parameters;
    switch (this.command) {
      case COLUMNS:
        this.columns = this.#range(this.columns, this.width);
        break;
      case ROWS:
        this.rows = this.#range(this.rows, this.height);
        break;
      case ADDRESS_MODE:
        this.addressMode = byte;
        break;
      case PIXEL_FORMAT:
        this.pixelFormat = byte;
        break;
      default:
        throw new Error(`the ST7789 got data for the command ${this.command}, which takes none`);
    }
    if (length > (this.command === COLUMNS || this.command === ROWS ? 4 : 1)) {
      throw new Error(`the ST7789 got too much data for the command 0x${this.command.toString(16)}`);
    }
  }

  #range(before, size) {
    if (this.parameters.length !== 4) {
      return before;
    }
    const [first, last] = [0, 2].map((at) => this.parameters[at] * 256 + this.parameters[at + 1]);
    if (first > last || last >= size) {
      throw new Error(`the ST7789 got the range ${first} to ${last} of ${size}`);
    }
    return [first, last];
  }

  #startPixels() {
    if (!this.isAwake || !this.isOn || this.pixelFormat !== RGB565) {
      throw new Error("the ST7789 got pixels before it was awake, on and set to RGB565");
    }
    [this.x, this.y, this.half] = [this.columns[0], this.rows[0], 0];
  }

  #takePixelByte(byte) {
    if (this.y > this.rows[1]) {
      throw new Error("the ST7789 got more pixels than its window holds");
    }
    this.picture[(this.y * this.width + this.x) * 2 + this.half] = byte;
    if (this.half === 0) {
      this.half = 1;
      return;
    }
    this.half = 0;
    if (this.x === this.width - 1) {
      this.onRow(this.y);
    }
    this.x += 1;
    if (this.x > this.columns[1]) {
      this.x = this.columns[0];
      this.y += 1;
    }
  }
}
