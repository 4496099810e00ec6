// One row of the picture: its runs as coloured bars, a bar for each surface of the paths.

const BAR = 22; // height of a level's bar, in CSS pixels
const LIGHT = 6; // height of a light's bar
const GAP = 2;

class RowLesson {
  /** `picture` shows the row; `chosen(y)` asks for its runs. */
  constructor(picture, chosen) {
    this.picture = picture;
    this.chosen = chosen;
    this.down = 0.5; // of the picture's height
    this.runs = [];
    this.lights = 0;
    this.current = -1;
    this.hues = new Map(); // shape -> its number in the order in which shapes were met
    this.bars = byId("row-bars");
    byId("row-y").addEventListener("input", () => this.choose(Number(byId("row-y").value)));
    picture.frame.addEventListener("pointermove", (event) => this.choose(picture.dotAt(event).y, event));
    this.bars.addEventListener("pointermove", (event) => this.point(this.columnAt(event)));
    this.bars.addEventListener("keydown", (event) => this.key(event));
    picture.onFit = () => (this.bars.style.width = picture.frame.style.width);
  }

  /** Another scene: its shapes get colours anew. */
  reset() {
    this.hues.clear();
  }

  get row() {
    return Math.min(Math.floor(this.down * this.picture.height), this.picture.height - 1);
  }

  choose(y, event) {
    const changed = y !== this.row || this.runs.length === 0;
    this.down = (clamp(y, 0, this.picture.height - 1) + 0.5) / this.picture.height;
    if (changed) this.chosen(this.row);
    if (event) this.point(this.columnAt(event));
  }

  columnAt({ clientX }) {
    const box = this.picture.canvas.getBoundingClientRect();
    return clamp(Math.floor(((clientX - box.left) / box.width) * this.picture.width), 0, this.picture.width - 1);
  }

  point(column) {
    const found = this.runs.findIndex((run) => column >= run.from && column <= run.to);
    if (found >= 0) this.select(found);
  }

  key(event) {
    const moves = { ArrowLeft: this.current - 1, ArrowRight: this.current + 1, Home: 0, End: this.runs.length - 1 };
    if (!(event.key in moves)) return;
    event.preventDefault();
    this.select(clamp(moves[event.key], 0, this.runs.length - 1));
  }

  select(run) {
    this.current = run;
    byId("row-says").textContent = this.runs[run] ? runInWords(this.runs[run]) : "";
    this.showMarks();
  }

  color(shape) {
    if (!this.hues.has(shape)) this.hues.set(shape, this.hues.size);
    const number = this.hues.get(shape);
    return `hsl(${Math.round((number * 137.5 + 205) % 360)} ${38 + (number % 3) * 10}% ${45 + (number % 2) * 13}%)`;
  }

  show(runs, lights) {
    this.runs = runs;
    this.lights = lights;
    byId("row-y").max = this.picture.height - 1;
    byId("row-y").value = this.row;
    byId("row-value").textContent = this.row;
    byId("row-count").textContent =
      `Row ${this.row}: ${runs.length === 1 ? "1 run" : `${runs.length} runs`} in ${this.picture.width} pixels.`;
    const deepest = Math.max(1, ...runs.map((run) => run.levels.length));
    this.bars.replaceChildren(...Array.from({ length: deepest }, (_, level) => this.level(level)).flat());
    this.select(clamp(this.current, 0, runs.length - 1));
    this.showLegend();
  }

  /** Bars of one level: which shape each run meets there, and below it which lights reach it. */
  level(level) {
    const width = this.picture.width;
    const lights = this.lights * (LIGHT + GAP);
    const height = BAR + GAP + lights;
    const bars = drawing("svg", {
      viewBox: `0 0 ${width} ${height}`,
      height,
      preserveAspectRatio: "none",
      "aria-hidden": "true",
    });
    for (const run of this.runs) {
      const step = run.levels[level];
      const box = { x: run.from, width: run.to - run.from + 1 };
      if (!step) {
        if (level === run.levels.length && run.missed)
          bars.append(
            drawing("rect", { ...box, y: 0, height: BAR, class: "nothing" }, drawing("title", {}, "nothing")),
          );
        continue;
      }
      bars.append(
        drawing(
          "rect",
          { ...box, y: 0, height: BAR, fill: this.color(step.shape), class: "run" },
          drawing("title", {}, step.shape),
        ),
      );
      for (let light = 0; light < this.lights; light++) {
        const lit = step.lights.includes(light);
        bars.append(
          drawing("rect", { ...box, y: BAR + GAP + light * (LIGHT + GAP), height: LIGHT, class: lit ? "lit" : "dark" }),
        );
      }
    }
    return [element("p", { class: "level" }, this.levelName(level)), bars];
  }

  levelName(level) {
    if (level === 0) return "First hit";
    const flat = this.runs.every(
      (run) => run.levels.length <= level || run.levels.slice(0, level).every((step) => step.flat),
    );
    const mirrors = `${flat ? "flat " : ""}${level === 1 ? "mirror" : "mirrors"}`;
    return `After ${["", "one", "two", "three", "four"][level] ?? level} ${mirrors}`;
  }

  showMarks() {
    const run = this.runs[this.current];
    const y = this.row;
    const line = { x1: 0, x2: this.picture.width, y1: y + 0.5, y2: y + 0.5 };
    this.picture.overlay.replaceChildren(
      drawing("line", { ...line, class: "under" }),
      drawing("line", { ...line, class: "over" }),
    );
    if (run) this.picture.overlay.append(drawing("line", { ...line, x1: run.from, x2: run.to + 1, class: "chosen" }));
    for (const bars of this.bars.querySelectorAll("svg")) {
      bars.querySelector(".chosen")?.remove();
      if (run)
        bars.append(drawing("rect", { x: run.from, width: run.to - run.from + 1, y: 0, height: BAR, class: "chosen" }));
    }
  }

  showLegend() {
    const shapes = new Set(this.runs.flatMap((run) => run.levels.map((step) => step.shape)));
    const item = (mark, text) => element("li", {}, mark, text);
    const chip = (style, name = "") => element("span", { class: `swatch ${name}`, style, "aria-hidden": "true" });
    byId("row-legend").replaceChildren(
      ...[...shapes].map((shape) => item(chip(`background:${this.color(shape)}`), shape)),
      item(chip("", "nothing"), "nothing: the background"),
      ...(this.lights > 0
        ? [
            item(
              chip("", "lit"),
              this.lights === 1 ? "thin bar: light 0 reaches it" : `thin bars: lights 0 to ${this.lights - 1} reach it`,
            ),
            item(chip("", "dark"), "it is in shadow"),
          ]
        : []),
    );
  }
}

function runInWords({ from, to, levels, missed }) {
  const columns = from === to ? `Column ${from}` : `Columns ${from} to ${to}`;
  const step = ({ shape, flat, lights }, level) => {
    const mirrors = flat && (missed || level + 1 < levels.length);
    const lit = lights.length ? `lit by ${lights.length === 1 ? "light" : "lights"} ${lights.join(", ")}` : "in shadow";
    return `${shape}${mirrors ? ", a flat mirror" : ""}, ${lit}`;
  };
  const ends = missed ? ["nothing"] : [];
  return `${columns}: ${[...levels.map(step), ...ends].join("; then ")}.`;
}
