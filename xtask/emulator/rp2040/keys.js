// A person at the keys: presses one after the other, in the chip's own time.

const CYCLES_A_MILLISECOND = 125_000;

/** How long a key is held, and how long the hand then rests. */
const HELD = 100 * CYCLES_A_MILLISECOND;

export class Keys {
  /** Called when a key goes down. */
  onPress = () => {};

  #pins;
  #presses = [];
  #until = 0;
  #held = null;

  /** `pins` names the pin of each key; a pressed one is low. */
  constructor(rp2040, pins) {
    this.#pins = Object.fromEntries(
      Object.entries(pins).map(([name, pin]) => [name, rp2040.gpio[pin]]),
    );
    Object.values(this.#pins).forEach((pin) => pin.setInputValue(true));
  }

  /** Whether every press has been seen through. */
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

  /** Moves the hand on to this time. */
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
