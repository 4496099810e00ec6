// The parts that are wired to the Raspberry Pi Pico of examples/pico: the display and the keys.

import { GPIOPinState } from "rp2040js";

import { Keys } from "./keys.js";
import { St7789 } from "./st7789.js";

const SIDE = 240;
const SPI = 1;
const PINS = { dataCommand: 8, chipSelect: 9, reset: 12, backlight: 13 };
const KEYS = { up: 2, select: 3, left: 16, down: 18, right: 20 };

export class Board {
  /**
   * Number of rows of the picture that were drawn while the backlight was on, counted from the top.
   * A key press sets it to 0.
   */
  rows = 0;

  #chip;

  constructor(chip) {
    this.#chip = chip;
    const { rp2040 } = chip;
    this.keys = new Keys(rp2040, KEYS);
    this.keys.onPress = () => {
      this.rows = 0;
    };
    this.display = new St7789(SIDE, SIDE);
    this.display.onRow = (y) => {
      this.rows = this.isLit && (y === 0 || y === this.rows) ? y + 1 : this.rows;
    };
    rp2040.spi[SPI].onTransmit = (byte) => {
      this.#pass(byte);
      rp2040.spi[SPI].completeTransmit(0xff);
    };
    rp2040.gpio[PINS.reset].addListener((level) => {
      if (level === GPIOPinState.Low) {
        this.display.reset();
      }
    });
  }

  get isLit() {
    return this.#isHigh("backlight");
  }

  #isHigh(name) {
    return this.#chip.rp2040.gpio[PINS[name]].value === GPIOPinState.High;
  }

  #pass(byte) {
    if (this.#isHigh("chipSelect")) {
      return;
    }
    try {
      if (this.#isHigh("dataCommand")) {
        this.display.takeData(byte);
      } else {
        this.display.takeCommand(byte);
      }
    } catch (error) {
      this.#chip.stop(this.#chip.first, error.message);
    }
  }
}
