// A line chart in SVG. Colours and fonts come from the style sheet.

const CHART = { height: 280, left: 56, right: 14, top: 12, bottom: 40 };

/** Place of `value` between `least` and `most`, 0 to 1; in powers of ten if `log`. */
function along(value, { least, most, log }) {
  const at = (number) => (log ? Math.log10(Math.max(number, least)) : number);
  return (at(value) - at(least)) / (at(most) - at(least));
}

/** Values at which an axis has a line. */
function ticks({ least, most, log, step }) {
  const values = [];
  if (log)
    for (let power = Math.round(Math.log10(least)); 10 ** power <= most * 1.001; power++) values.push(10 ** power);
  else for (let value = least; value <= most + step / 1000; value += step) values.push(value);
  return values;
}

/**
 * `x` and `y` are axes: { least, most, step, log, label }. `series` is a list of { label, kind, dots, points }: points
 * are pairs, `kind` is a class of the style sheet, `dots` draws marks instead of a line. `says` describes the chart.
 * `width` is in CSS pixels.
 */
function lineChart({ x, y, series, says }, width) {
  const { height, left, right, top: above, bottom } = CHART;
  const across = (value) => left + along(value, x) * (width - left - right);
  const down = (value) => height - bottom - clamp(along(value, y), 0, 1) * (height - above - bottom);
  const chart = drawing("svg", { viewBox: `0 0 ${width} ${height}`, role: "img", "aria-label": says });
  for (const value of ticks(y)) {
    const at = down(value);
    chart.append(
      drawing("line", { x1: left, x2: width - right, y1: at, y2: at, class: "grid" }),
      drawing("text", { x: left - 8, y: at + 4, "text-anchor": "end" }, String(Number(value.toPrecision(3)))),
    );
  }
  for (const value of ticks(x)) {
    chart.append(
      drawing("text", { x: across(value), y: height - bottom + 18, "text-anchor": "middle" }, String(value)),
    );
  }
  chart.append(
    drawing("text", { x: (left + width - right) / 2, y: height - 4, "text-anchor": "middle" }, x.label),
    drawing(
      "text",
      {
        x: 12,
        y: (above + height - bottom) / 2,
        "text-anchor": "middle",
        transform: `rotate(-90 12 ${(above + height - bottom) / 2})`,
      },
      y.label,
    ),
  );
  for (const { label, kind, dots, points } of series) {
    const places = points.map(([a, b]) => [across(a).toFixed(1), down(b).toFixed(1)]);
    if (dots)
      chart.append(
        ...places.map(([cx, cy]) => drawing("circle", { cx, cy, r: 4, class: kind }, drawing("title", {}, label))),
      );
    else chart.append(drawing("polyline", { points: places.map((point) => point.join(",")).join(" "), class: kind }));
  }
  return chart;
}

/** Names of the series with a piece of each line. */
function chartKey(series) {
  const item = ({ label, kind, dots }) => {
    const piece = drawing("svg", { viewBox: "0 0 28 10", width: 28, height: 10, "aria-hidden": "true" });
    piece.append(
      dots
        ? drawing("circle", { cx: 14, cy: 5, r: 4, class: kind })
        : drawing("line", { x1: 0, x2: 28, y1: 5, y2: 5, class: kind }),
    );
    return element("li", {}, piece, label);
  };
  return element("ul", { class: "key" }, ...series.map(item));
}

function showChart(place, chart) {
  const width = clamp(place.clientWidth, 280, 640); // so that its text is as large as the text beside it
  place.replaceChildren(chartKey(chart.series), lineChart(chart, width));
}
