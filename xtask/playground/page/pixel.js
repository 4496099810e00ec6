// One pixel's path: the table, the sum, and the formula with the pixel's numbers.

class PixelLesson {
  /** The cursor moves in `picture`; `large` shows the path, too, once a pixel is chosen. `asked()` asks for a path. */
  constructor(picture, large, asked) {
    this.picture = picture;
    this.large = large;
    this.asked = asked;
    this.isChosen = false;
    this.at = { across: 0.5, down: 0.6 }; // of the picture's width and height, so that it stays when the size changes
    this.channel = 0;
    this.path = null;
    picture.canvas.addEventListener("click", (event) => this.choose(picture.dotAt(event)));
    picture.canvas.addEventListener("keydown", (event) => this.key(event));
    for (const id of ["pixel-x", "pixel-y"]) {
      byId(id).addEventListener("change", () =>
        this.choose({ x: Number(byId("pixel-x").value), y: Number(byId("pixel-y").value) }),
      );
    }
    radios("channel", (value) => {
      this.channel = Number(value);
      this.showFormula();
    });
  }

  get pixel() {
    const { width, height } = this.picture;
    return {
      x: Math.min(Math.floor(this.at.across * width), width - 1),
      y: Math.min(Math.floor(this.at.down * height), height - 1),
    };
  }

  choose({ x, y }) {
    const { width, height } = this.picture;
    this.at = {
      across: (clamp(Math.round(x), 0, width - 1) + 0.5) / width,
      down: (clamp(Math.round(y), 0, height - 1) + 0.5) / height,
    };
    this.showCursor();
    this.isChosen = true;
    byId("path-table").setAttribute("aria-busy", "true");
    this.asked();
  }

  key(event) {
    const by = event.shiftKey ? 10 : 1;
    const moves = { ArrowLeft: [-by, 0], ArrowRight: [by, 0], ArrowUp: [0, -by], ArrowDown: [0, by] };
    if (event.key === "Enter") {
      event.preventDefault();
      this.readOut();
    }
    const move = moves[event.key];
    if (!move) return;
    event.preventDefault();
    this.choose({ x: this.pixel.x + move[0], y: this.pixel.y + move[1] });
  }

  /** Takes the path away from the large picture. */
  hide() {
    this.isChosen = false;
    this.large.overlay.replaceChildren();
  }

  showCursor() {
    const { x, y } = this.pixel;
    byId("pixel-x").max = this.picture.width - 1;
    byId("pixel-y").max = this.picture.height - 1;
    byId("pixel-x").value = x;
    byId("pixel-y").value = y;
  }

  readOut() {
    if (!this.path) return;
    const { steps, pixel } = this.path;
    const shapes = steps.map((step) => step.shape).join(", then ");
    byId("path-read").textContent =
      `Column ${this.pixel.x}, row ${this.pixel.y}: ${shapes || "nothing"}. Red ${pixel[0]}, green ${pixel[1]}, blue ${pixel[2]}.`;
  }

  show(path) {
    this.path = path;
    this.showCursor();
    this.picture.showPath(this.pixel, path.steps);
    if (this.isChosen) this.large.showPath(this.pixel, path.steps);
    byId("path-table").replaceChildren(...pathRows(path));
    byId("path-table").setAttribute("aria-busy", "false");
    byId("path-sum").replaceChildren(swatch(path.sum), triple(path.sum));
    byId("path-pixel").replaceChildren(swatch(path.pixel.map((level) => level / 255)), path.pixel.join("  "));
    byId("path-end").textContent = pathEnd(path);
    this.showFormula();
  }

  showFormula() {
    if (!this.path) return;
    const back = recursion(this.path, this.channel);
    const forth = loop(this.path, this.channel);
    byId("recursion").textContent = back.lines.join("\n");
    byId("loop").textContent = forth.lines.join("\n");
    const level = this.path.pixel[this.channel];
    byId("agree").textContent =
      `Both give ${fixed(back.value)} and ${fixed(forth.value)}: times 255 that is ${(Math.min(back.value, 1) * 255).toFixed(2)}. The pixel has ${level}.`;
  }
}

/** Rows of the table: one for each surface, and one for the background if the last ray hits nothing. */
function pathRows({ steps, missed, background, sum }) {
  const cell = (...content) => element("td", {}, ...content);
  const rows = steps.map((step, i) => {
    const added = step.color.map((value) => (1 - step.alpha) * step.weight * value);
    const lit = step.lights.length ? `lit by light ${step.lights.join(", ")}` : "in shadow";
    const about = [step.material, step.inside ? "from inside" : null, lit].filter(Boolean).join(", ");
    return element(
      "tr",
      {},
      element("th", { scope: "row" }, String(i)),
      cell(step.shape, element("small", {}, about)),
      cell(short(step.alpha)),
      cell(short(step.weight)),
      cell(swatch(step.color), triple(step.color, 3)),
      cell(triple(added, 3)),
      cell(swatch(step.sum), triple(step.sum, 3)),
      cell(short(step.bound), element("small", {}, `${short(step.bound * 255)} levels`)),
    );
  });
  if (missed) {
    const weight = weightAfter(steps);
    const color = background ?? [0, 0, 0];
    rows.push(
      element(
        "tr",
        {},
        element("th", { scope: "row" }, String(steps.length)),
        cell("nothing", element("small", {}, "the background counts as a surface with α = 0")),
        cell("0"),
        cell(short(weight)),
        cell(swatch(color), triple(color, 3)),
        cell(
          triple(
            color.map((value) => weight * value),
            3,
          ),
        ),
        cell(swatch(sum), triple(sum, 3)),
        cell("0"),
      ),
    );
  }
  return rows;
}

function weightAfter(steps) {
  const last = steps.at(-1);
  return last ? last.weight * last.alpha : 1;
}

function pathEnd({ steps, end, brightest }) {
  if (end === "missed") return "The last ray hits nothing. The sum is exact: nothing is missing.";
  if (end === "no weight left") return "No weight is left. No later surface changes the pixel.";
  return `The path is cut off after ${steps.length - 1} reflections. At most the weight that is left, ${short(weightAfter(steps))}, times the brightest colour of the scene, ${short(brightest)}, is missing.`;
}

/** The recursion, evaluated from the last surface back. */
function recursion({ steps, missed, background, end }, channel) {
  let value = missed && background ? background[channel] : 0;
  const why = { missed: "the background", "no weight left": "its weight is 0" }[end] ?? "cut off: counts as 0";
  const lines = [`c(${steps.length}) = ${fixed(value)}   ${why}`];
  for (let i = steps.length - 1; i >= 0; i--) {
    const { alpha, color } = steps[i];
    const next = value;
    value = (1 - alpha) * color[channel] + alpha * next;
    lines.push(
      `c(${i}) = (1 − ${fixed(alpha, 3)}) · ${fixed(color[channel])} + ${fixed(alpha, 3)} · ${fixed(next)} = ${fixed(value)}`,
    );
  }
  return { lines, value };
}

/** The loop, from the first surface on. */
function loop({ steps, missed, background }, channel) {
  let weight = 1;
  let sum = 0;
  const lines = ["w = 1, s = 0"];
  steps.forEach(({ alpha, color }, i) => {
    const share = weight - alpha * weight;
    sum += share * color[channel];
    weight *= alpha;
    lines.push(
      `i = ${i}:  s += ${fixed(share)} · ${fixed(color[channel])}  → s = ${fixed(sum)},  w = ${fixed(weight)}`,
    );
  });
  if (missed) {
    const added = background ? background[channel] : 0;
    sum += weight * added;
    lines.push(`miss:   s += ${fixed(weight)} · ${fixed(added)}  → s = ${fixed(sum)}`);
  } else
    lines.push(
      weight === 0 ? "w = 0: stop" : `stop: at most w = ${fixed(weight)} times the brightest colour is missing`,
    );
  return { lines, value: sum };
}
