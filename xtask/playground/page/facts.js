// What is known of the picture and its scene: time, rays, hash, needs, and frames a second of boards.

function showFrame({ time, rays, missing_levels, report }) {
  byId("time").textContent = milliseconds(time);
  byId("rays").textContent = count(rays);
  byId("missing").textContent =
    missing_levels < 0.05 ? "none that shows" : `${missing_levels.toFixed(1)} levels of 255`;
  byId("report").textContent = report;
}

function showScene({ shapes, planes, lights, needs, left_out }) {
  const many = (number, word) => `${number} ${word}${number === 1 ? "" : "s"}`;
  const flat = planes > 0 ? `, of them ${many(planes, "plane")}` : "";
  byId("counts").textContent = `${many(shapes, "shape")}${flat}, ${many(lights, "light")}.`;
  byId("needs").textContent = needs.join(", ") || "nothing";
  byId("left-out").textContent = left_out.join(", ") || "nothing";
}

/** Shows the hash drawn here beside the one of the board; `board` is undefined if no board has drawn this scene. */
function showHash(here, board) {
  byId("hash").textContent = here ?? "…";
  byId("hash-board").textContent = board ?? "not drawn there";
  const says = byId("hash-says");
  says.className = "";
  if (here === null) says.textContent = "Drawing …";
  else if (!board) says.textContent = "The emulated board has drawn the built-in scenes, unchanged.";
  else if (here === board) {
    says.className = "good";
    says.textContent = "✓ Equal: the board draws this picture, bit for bit.";
  } else {
    says.className = "bad";
    says.textContent = "✗ Not equal: please report this.";
  }
}

/** Frames a second of `name` on each board, or of castle times `ratio` where the scene is not measured. */
function boardRows(boards, name, ratio) {
  const rate = (value) => (value >= 10 ? value.toFixed(1) : value.toFixed(2));
  return boards
    .filter((row) => row.scene === name)
    .map((row) => {
      const value =
        ratio === null ? rate(row.frames_per_second) : `about ${(row.frames_per_second * ratio).toPrecision(2)}`;
      const less = row.is_limit ? "less than " : "";
      return element("tr", {}, element("th", { scope: "row" }, row.board), element("td", {}, less + value));
    });
}

function showMeasuredBoards(boards, name) {
  byId("boards-tag").textContent = "estimates";
  byId("boards").replaceChildren(...boardRows(boards, name, null));
  byId("boards-says").textContent =
    "At 240×240, Fast, N = 4, on all cores, with the time to send the picture. The instructions are counted in an emulator; their cycles are estimated.";
}

/** `ratio`: how many times as fast this scene is here as castle; `null` while it is measured. */
function showRoughBoards(boards, ratio) {
  byId("boards-tag").textContent = "rough";
  byId("boards").replaceChildren(...(ratio === null ? [] : boardRows(boards, "castle", ratio)));
  const says = byId("boards-says");
  if (ratio === null) says.textContent = "This scene is not measured. A rough estimate follows …";
  else
    says.replaceChildren(
      "Rough: this scene is not measured. These are castle's estimates at 240×240, Fast, N = 4, times the ratio of the two scenes' times in this browser. This command measures it: ",
      element("code", {}, "cargo xtask measure FILE.json --board pico2"),
    );
}
