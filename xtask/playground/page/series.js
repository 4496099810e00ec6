// Two charts: the error of the whole picture against N, and a closed room as N grows.

const MOST_REFLECTIONS = 16;
const LEAST_ERROR = 0.001; // levels; the lower edge of the chart
const COMPARED = 96; // most dots a side of the pictures that are compared

class Series {
  constructor(engine, roomText) {
    this.engine = engine;
    this.room = JSON.parse(roomText);
    byId("room-alpha").value = this.room.materials[0].mirror;
    const later = debounced(150, () => this.showRoom());
    byId("room-alpha").addEventListener("input", () => {
      byId("room-value").textContent = fixed(Number(byId("room-alpha").value), 2);
      later();
    });
  }

  /** Compares pictures of `scene` in `view` at the shape of `frame`. */
  async showErrors(scene, view, frame) {
    const part = Math.min(1, COMPARED / Math.max(frame.width, frame.height));
    const width = Math.max(1, Math.round(frame.width * part));
    const height = Math.max(1, Math.round(frame.height * part));
    byId("errors-size").textContent = `${width}×${height}`;
    const rows = [];
    const done = await ifWanted(
      this.engine.ask("errors", { scene, view, width, height, most: MOST_REFLECTIONS }, (row) => {
        rows.push(row);
        if (rows.length === 1 || rows.length % 4 === 0) this.drawErrors(rows);
      }),
    );
    if (done !== null) this.drawErrors(rows);
  }

  drawErrors(rows) {
    const points = (key) => rows.map((row) => [row.reflections, row[key]]);
    const series = [
      { label: "Bound: Π α · brightest colour", kind: "bound", points: points("bound") },
      { label: "Largest error", kind: "largest", points: points("largest") },
      { label: "Mean error", kind: "mean", points: points("mean") },
      {
        label: "Half a level",
        kind: "half",
        points: [
          [0, 0.5],
          [MOST_REFLECTIONS, 0.5],
        ],
      },
    ];
    const most = Math.max(255, ...rows.map((row) => row.bound));
    showChart(byId("errors-chart"), {
      x: { least: 0, most: MOST_REFLECTIONS, step: 2, label: "reflections, N" },
      y: { least: LEAST_ERROR, most: 10 ** Math.ceil(Math.log10(most)), log: true, label: "levels of 255" },
      series,
      says: "Largest and mean error of the picture and the bound, in levels of 255, against the number of reflections",
    });
    const cell = (value) => element("td", {}, value);
    byId("errors-table").replaceChildren(
      ...rows.map((row) =>
        element(
          "tr",
          {},
          element("th", { scope: "row" }, String(row.reflections)),
          cell(short(row.largest)),
          cell(short(row.mean)),
          cell(short(row.bound)),
          cell(count(row.rays)),
        ),
      ),
    );
  }

  async showRoom() {
    const alpha = Number(byId("room-alpha").value);
    const wall = this.room.materials[0];
    wall.mirror = alpha;
    const rows = [];
    const scene = { text: JSON.stringify(this.room), index: -1 };
    const done = await ifWanted(this.engine.ask("room", { scene, most: MOST_REFLECTIONS }, (row) => rows.push(row)));
    if (done !== null) this.drawRoom(rows, alpha, wall.color);
  }

  drawRoom(rows, alpha, color) {
    const channels = ["red", "green", "blue"];
    const formula = (reflections, channel) => 255 * color[channel] * (1 - alpha ** (reflections + 1));
    const lines = channels.map((kind, channel) => ({
      label: `c · (1 − αᴺ⁺¹), ${kind}`,
      kind: `${kind} line`,
      points: rows.map((row) => [row.reflections, formula(row.reflections, channel)]),
    }));
    const dots = channels.map((kind, channel) => ({
      label: `pixel, ${kind}`,
      kind: `${kind} dot`,
      dots: true,
      points: rows.map((row) => [row.reflections, row.pixel[channel]]),
    }));
    showChart(byId("room-chart"), {
      x: { least: 0, most: MOST_REFLECTIONS, step: 2, label: "reflections, N" },
      y: { least: 0, most: 250, step: 50, label: "levels of 255" },
      series: [...lines, ...dots],
      says: "Pixel of a closed room against the number of reflections, beside the formula",
    });
    byId("room-says").textContent =
      alpha === 1
        ? "With α = 1 the pixel is black for every N: between perfect mirrors the recursion allows any colour, and the loop takes the darkest."
        : `For N → ∞ the pixel goes to c: ${color.map((value) => Math.round(255 * value)).join(", ")}.`;
    const cell = (values) => element("td", {}, values.join("  "));
    byId("room-table").replaceChildren(
      ...rows.map((row) =>
        element(
          "tr",
          {},
          element("th", { scope: "row" }, String(row.reflections)),
          cell(row.pixel),
          cell(channels.map((_, channel) => formula(row.reflections, channel).toFixed(1))),
        ),
      ),
    );
  }
}
