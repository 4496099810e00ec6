// Presses keys one after another, as a person would, in the chip's emulated time.

const CYCLES_A_MILLISECOND = 125_000;

/** Cycles for which a key is held, and cycles of the pause after it. */
const HELD = 100 * CYCLES_A_MILLISECOND;

export class Keys {
  /** Called when a key goes down. */
  onPress = () => {};

  #pins;
  #presses = [];
  #until = 0;
  #held = null;

  /** `pins` has the pin of each key. A pressed key pulls its pin low. */
  constructor(rp2040, pins) {
    this.#pins = Object.fromEntries(
      Object.entries(pins).map(([name, pin]) => [name, rp2040.gpio[pin]]),
    );
    Object.values(this.#pins).forEach((pin) => pin.setInputValue(true));
  }

  /** Whether all presses are finished. */
  get areAtRest() {
    return this.#held === null && this.#presses.length === 0;
  }

  press(names) {
    for (const name of names) {
      if (!(name in this.#pins)) {
        throw new Error(`there is no key ${name}, only ${Object.keys(this.#pins).join(", ")}`);
      }
    }
    this.#presses.push(...names);
  }

  /** Presses and releases keys up to this time. */
  tick(cycles) {
    if (cycles < this.#until) {
      return;
    }
    if (this.#held !== null) {
      this.#held.setInputValue(true);
      this.#held = null;
      this.#until = cycles + HELD;
    } else if (this.#presses.length > 0) {
      this.#held = this.#pins[this.#presses.shift()];
      this.#held.setInputValue(false);
      this.onPress();
      this.#until = cycles + HELD;
    }
  }
}
