// Runs firmware for the RP2040, or the measurement firmware for thumbv6m, and prints one line of
// JSON: how it ended, what it printed, and how many cycles and instructions it took.
//
//   node run.js FIRMWARE.elf [--limit CYCLES] [--cores 1|2] [--counts cycles|instructions]
//                            [--frames LIST [--rows ROWS] [--pictures PREFIX]]
//
// Without --frames the run ends when the firmware ends itself, by semihosting. --counts says what the
// timer of the measurement firmware counts: see measuring.js.
//
// --frames waits for pictures on the display and then ends the run. Its list has one part for each
// picture: the keys pressed before it, as in `-,select,right+up`. The keys of the first part are
// pressed while the first picture is being drawn. A picture is finished when its first ROWS rows are
// drawn (default: all rows), and is then written to PREFIX-I.rgb565.

import { writeFileSync } from "node:fs";
import { parseArgs } from "node:util";

import { Board } from "./board.js";
import { Chip } from "./chip.js";
import { Elf } from "./elf.js";
import { Rtt } from "./rtt.js";
import { Semihosting } from "./semihosting.js";

/** Cycles that the firmware gets after the last picture to print its report of it. */
const LAST_WORDS = 125_000;

/** Cycles between two steps, in which keys change and the run may end. */
const SLICE = 1000;

const { positionals, values } = parseArgs({
  allowPositionals: true,
  options: {
    cores: { type: "string", default: "2" },
    counts: { type: "string", default: "cycles" },
    frames: { type: "string" },
    limit: { type: "string", default: "1e12" },
    pictures: { type: "string" },
    rows: { type: "string", default: "240" },
  },
});

const chip = new Chip(new Elf(positionals[0]), Number(values.cores), values.counts);
const semihosting = new Semihosting(chip);
const rtt = new Rtt(chip);
const board = new Board(chip);
const wanted = (values.frames ?? "").split(",").filter((part) => part !== "");
const frames = [];

/** Whether the keys of the next picture have been given to the board. */
let isAsked = false;

while (!isOver()) {
  chip.run(SLICE);
  board.keys.tick(chip.cycles);
  if (frames.length < wanted.length) {
    watch();
  }
}
if (frames.length > 0) {
  chip.run(LAST_WORDS);
}
report();

function isOver() {
  return (
    chip.fault !== null ||
    semihosting.hasExited ||
    chip.cycles >= Number(values.limit) ||
    (wanted.length > 0 && frames.length === wanted.length)
  );
}

/** Presses the keys of the next picture, and saves the picture when it is finished. */
function watch() {
  if (!isAsked) {
    isAsked = board.isLit;
    if (isAsked) {
      const keys = wanted[frames.length];
      board.keys.press(keys === "-" ? [] : keys.split("+"));
    }
  } else if (board.keys.areAtRest && board.rows >= Number(values.rows)) {
    keep();
    board.rows = 0;
    isAsked = false;
  }
}

function keep() {
  const { cycles, instructions } = chip;
  if (values.pictures !== undefined) {
    writeFileSync(`${values.pictures}-${frames.length}.rgb565`, board.display.picture);
  }
  frames.push({ cycles, instructions });
}

function report() {
  const { cycles, instructions } = chip;
  const { isInverted, addressMode } = board.display;
  const isDone = semihosting.hasExited || (wanted.length > 0 && frames.length === wanted.length);
  const endless = isDone ? null : { reason: "the limit of cycles was reached" };
  const said = { rtt: rtt.lines, semihosting: semihosting.lines };
  const fault = chip.fault ?? endless;
  const display = { inverted: isInverted, addressMode };
  console.log(JSON.stringify({ fault, cycles, instructions, frames, said, display }));
}
