// The page: its settings, and who is told when they change.

const WASM = /*{WASM}*/null;
const WORKER = /*{WORKER}*/null;
const DATA = /*{DATA}*/null;

const DISPLAYS = { rgb888: 0, rgb565: 1, gray4: 2, mono: 3, "rgb565-dither": 4, "gray4-dither": 5 };
const PRESETS = [
  ["320x320-rgb888", "320×320, 24 bits"],
  ["320x240-rgb565", "320×240, 16 bits"],
  ["240x240-rgb565", "240×240, 16 bits"],
  ["240x240-rgb565-dither", "240×240, 16 bits, dither"],
  ["160x128-rgb565", "160×128, 16 bits"],
  ["128x64-gray4", "128×64, 16 greys"],
  ["128x64-gray4-dither", "128×64, 16 greys, dither"],
  ["128x64-mono", "128×64, black and white, dither"],
  ["64x64-rgb888", "64×64, 24 bits: the size of the hash"],
];
const SETTINGS = ["n", "quality", "shading", "smooth", "preset"]; // ids of their fields
const OWN_VIEW = { turn: 0, rise: 0, zoom: 1000 };
const ZOOM = { least: 50, most: 3000 }; // thousandths of the scene's own field of view
const POLE = 89000; // highest angle of the camera above the target, in thousandths of a degree
const OWN_SCENE = "own";

const page = {
  scene: { text: "", index: -1 },
  view: OWN_VIEW,
  drawnView: OWN_VIEW, // of the last whole picture
  refusals: 0, // views refused since then
  lights: 0,
  rise: { least: 0, most: 0 },
  castleTime: Infinity, // least milliseconds of castle, measured here
  measured: null, // index and text of the scene whose facts the page shows
  isMeasured: false, // they are known, not only asked for
  chartsNear: false, // the charts are near the window: they are worth drawing
};

const engine = new Engine(Uint8Array.from(atob(WASM), (character) => character.charCodeAt(0)).buffer, WORKER);
let side = null; // a second engine, for what must not hold up the picture
let series = null;

const picture = new Picture(byId("picture"), byId("stage"), byId("picture-overlay"), 0.78);
const pixelPicture = new Picture(byId("pixel-picture"), byId("pixel-stage"), byId("pixel-overlay"), 0.6);
const rowPicture = new Picture(byId("row-picture"), byId("row-stage"), byId("row-overlay"), 0.55);
rowPicture.parts = 2; // a little uneven, but the bars below stay in the window

const editor = new Editor(
  () => (drawer.state = "drawing"),
  (text) => useText(text),
);
const drawer = new Drawer(engine, picture, request, { whole, refused, stopped });
const askPath = latest(() => question("path", pixels.pixel), (path) => pixels.show(path));
const askRow = latest(() => question("row", { y: rows.row }), ({ runs }) => rows.show(runs, page.lights));
const pixels = new PixelLesson(pixelPicture, picture, askPath);
const rows = new RowLesson(rowPicture, askRow);

/** Asks the drawing worker about the picture that is drawn; `null` while there is none. */
async function question(kind, values) {
  if (drawer.state !== "ready") return null;
  const answer = await ifWanted(engine.ask(kind, { ...request(), ...values }));
  return drawer.state === "ready" ? answer : null;
}

/** Does `ask`, then `show` with its answer. While an answer is awaited, only the newest further call is kept. */
function latest(ask, show) {
  let busy = false;
  let again = false;
  return async () => {
    again = true;
    if (busy) return;
    busy = true;
    while (again) {
      again = false;
      const answer = await ask();
      if (answer !== null) show(answer);
    }
    busy = false;
  };
}

function request() {
  const [size, ...display] = byId("preset").value.split("-");
  const [width, height] = size.split("x").map(Number);
  const value = (id) => Number(byId(id).value);
  const { turn, rise, zoom } = page.view;
  return {
    scene: { ...page.scene },
    view: { turn: Math.round(turn), rise: Math.round(rise), zoom: Math.round(zoom) },
    frame: {
      width,
      height,
      reflections: value("n"),
      quality: value("quality"),
      shading: value("shading"),
      smooth: value("smooth"),
      display: DISPLAYS[display.join("-")],
    },
  };
}

/** A whole picture is drawn: everything that depends on it follows. */
function whole(answer, view) {
  page.drawnView = view;
  page.refusals = 0;
  page.lights = answer.scene.lights;
  page.rise = riseLimits(answer.scene.camera);
  editor.accept();
  showFrame(answer);
  showScene(answer.scene);
  showScenesOfFile(answer.scene.names);
  for (const copy of [pixelPicture, rowPicture]) copy.copy(picture);
  askPath();
  askRow();
  forget();
  if (!side) {
    performance.mark("first picture");
    side = new Engine(engine.wasm, WORKER);
    series = new Series(side, sceneNamed("closed_room").json);
  }
  measure();
}

function refused(answer) {
  if (answer.what === "view" && page.refusals < 3) return stepBack();
  const line = answer.line ?? lineOfPart(page.scene.text, page.scene.index, answer.error);
  if (answer.what === "scene") editor.refuse({ ...answer, line });
  else editor.refuse({ error: answer.error });
  drawer.state = "error";
}

/** The camera cannot go there: keeps its turn, then takes the last view that was drawn, then the scene's own. */
function stepBack() {
  const { drawnView } = page;
  page.view = [{ ...page.view, rise: drawnView.rise }, drawnView, OWN_VIEW][page.refusals++];
  say("The camera cannot go further.");
  drawer.redraw();
}

function stopped(message) {
  const text = "The library stopped while it drew this picture. It is started again: change the scene or a setting to go on.";
  editor.refuse({ error: `${text} (${message})` });
  drawer.state = "error";
}

/** Empties the facts of a new scene until they are measured. */
function forget() {
  const key = `${page.scene.index} ${page.scene.text}`;
  if (page.measured === key) return;
  page.measured = key;
  page.isMeasured = false;
  const known = knownScene();
  showHash(null, known ? DATA.hashes[known.name] : undefined);
  if (isOnBoards(known)) showMeasuredBoards(DATA.boards, known.name);
  else showRoughBoards(DATA.boards, null);
}

/** Hash, time and charts, in the second worker. */
const measure = debounced(300, async () => {
  const { scene, view, frame } = request();
  if (!page.isMeasured) await measureScene(scene, page.measured);
  if (page.chartsNear) series.showErrors(scene, view, frame);
});

async function measureScene(scene, key) {
  const known = knownScene();
  const hash = await ifWanted(side.ask("hash", { scene, view: OWN_VIEW }));
  if (page.measured !== key) return;
  if (hash !== null) showHash(hash, known ? DATA.hashes[known.name] : undefined);
  page.isMeasured = true;
  if (!isOnBoards(known)) showRough(scene, key);
}

/** Estimates frames a second by the times of this scene and of castle, both measured here. */
async function showRough(scene, key) {
  const time = await ifWanted(side.ask("time", { scene }));
  const castle = time && (await ifWanted(side.ask("time", { scene: { text: sceneNamed("castle").json, index: -1 } })));
  if (!castle || page.measured !== key) return;
  page.castleTime = Math.min(page.castleTime, castle);
  showRoughBoards(DATA.boards, page.castleTime / time);
}

const isOnBoards = (known) => known !== undefined && DATA.boards.some((row) => row.scene === known.name);
const sceneNamed = (name) => DATA.scenes.find((scene) => scene.name === name);

/** The scene of the list whose text is in the editor, unchanged. */
function knownScene() {
  return DATA.scenes.find((scene) => scene.json === page.scene.text && page.scene.index < 1);
}

/** Draws `text` from its own camera or from the present view. */
function useText(text, view = page.view) {
  page.scene = { text, index: text === page.scene.text ? page.scene.index : -1 };
  page.view = view;
  rows.reset();
  byId("scene").value = knownScene()?.name ?? OWN_SCENE;
  drawer.redraw();
}

function setText(text, view = OWN_VIEW) {
  editor.text = text;
  useText(text, view);
}

function showScenesOfFile(names) {
  const select = byId("scene-of-file");
  select.replaceChildren(...names.map((name, index) => element("option", { value: index }, name || `scene ${index}`)));
  select.value = Math.max(page.scene.index, 0);
  for (const part of [select, document.querySelector('label[for="scene-of-file"]')]) part.hidden = names.length < 2;
}

/** Highest and lowest `rise` for which the camera stays below the pole, in thousandths of a degree. */
function riseLimits({ position, target, up }) {
  const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
  const back = position.map((value, axis) => value - target[axis]);
  const sine = dot(back, up) / Math.sqrt(dot(back, back) * dot(up, up));
  const height = (Math.asin(clamp(sine, -1, 1)) * 180000) / Math.PI;
  return { least: Math.min(-POLE - height, 0), most: Math.max(POLE - height, 0) };
}

/** Moves the camera. Returns whether it moved. */
function moveTo(view) {
  view.rise = clamp(view.rise, page.rise.least, page.rise.most);
  const moves = ["turn", "rise", "zoom"].some((key) => view[key] !== page.view[key]);
  page.view = view;
  if (moves && drawer.state !== "error") drawer.move();
  return moves;
}

function fillSelects() {
  const scenes = byId("scene");
  for (const [group, label] of [["built in", "Built in"], ["sample", "Samples"]]) {
    const options = DATA.scenes.filter((scene) => scene.group === group).map((scene) => element("option", { value: scene.name }, scene.name));
    scenes.append(element("optgroup", { label }, ...options));
  }
  scenes.append(element("option", { value: OWN_SCENE, hidden: "" }, "your own"));
  byId("preset").append(...PRESETS.map(([value, label]) => element("option", { value }, label)));
  byId("version").textContent = DATA.version;
}

function wireControls() {
  byId("scene").addEventListener("change", () => {
    const scene = sceneNamed(byId("scene").value);
    if (scene) setText(scene.json);
  });
  byId("scene-of-file").addEventListener("change", () => {
    page.scene = { text: page.scene.text, index: Number(byId("scene-of-file").value) };
    page.view = OWN_VIEW;
    rows.reset();
    drawer.redraw();
  });
  for (const id of SETTINGS) {
    byId(id).addEventListener("input", () => {
      byId("n-value").textContent = byId("n").value;
      drawer.redraw();
    });
  }
  byId("controls").addEventListener("submit", (event) => event.preventDefault());
  makeOrbit(picture.canvas, {
    turn: (by, rise) => moveTo({ ...page.view, turn: page.view.turn + by, rise: page.view.rise + rise }),
    zoom: (by) => moveTo({ ...page.view, zoom: clamp(page.view.zoom * by, ZOOM.least, ZOOM.most) }),
    reset: () => moveTo({ ...OWN_VIEW }),
    click: (event) => {
      pixels.choose(picture.dotAt(event));
      rows.choose(picture.dotAt(event).y, event);
    },
    hide: () => pixels.hide(),
    enter: () => byId("pixel-picture").focus(),
  });
  picture.canvas.addEventListener("pointermove", (event) => event.buttons === 0 && rows.choose(picture.dotAt(event).y));
}

/** Text of the editor with the camera as it stands. */
async function textWithCamera() {
  await drawer.settled();
  const { text, index } = page.scene;
  const { turn, rise, zoom } = request().view;
  if (turn === 0 && rise === 0 && zoom === OWN_VIEW.zoom) return text;
  return withCamera(text, index, await engine.ask("camera", request()));
}

async function rust() {
  await drawer.settled();
  return engine.ask("rust", request());
}

function wireButtons() {
  const button = (id, action) =>
    byId(id).addEventListener("click", async () => {
      try {
        await action();
      } catch (error) {
        say(`Not done: ${error.message}`, 12);
      }
    });
  button("copy-rust", async () => copyText(await rust(), "Copied: the constant scene in Rust, ready to compile."));
  button("download", async () => downloadText(`${knownScene()?.name ?? "scene"}.json`, await textWithCamera()));
  button("copy-link", async () => {
    const settings = Object.fromEntries(SETTINGS.map((id) => [id, byId(id).value]));
    await copyText(await linkTo(await textWithCamera(), settings), "Copied: a link that contains the scene.");
  });
  button("reset-view", () => moveTo({ ...OWN_VIEW }));
}

function wireTheme() {
  const set = (theme) => (document.documentElement.dataset.theme = theme);
  let kept = "auto";
  try {
    kept = localStorage.getItem("reflet theme") ?? "auto";
  } catch {
    // Storage may be closed to files. The page then follows the system at each visit.
  }
  const input = document.querySelector(`input[name="theme"][value="${CSS.escape(kept)}"]`);
  if (input) {
    input.checked = true;
    set(kept);
  }
  radios("theme", (theme) => {
    set(theme);
    try {
      localStorage.setItem("reflet theme", theme);
    } catch {
      // As above.
    }
  });
}

/** Takes the scene and the settings of the page's address. Returns whether it has some. */
async function openLink() {
  try {
    const link = await linked();
    if (!link) return false;
    for (const id of SETTINGS) {
      const field = byId(id);
      const before = field.value;
      if (id in link.settings) field.value = link.settings[id];
      if (field.value === "") field.value = before; // a choice that this version does not have
    }
    byId("n-value").textContent = byId("n").value;
    setText(link.text);
    return true;
  } catch (error) {
    say(`The link cannot be read: ${error.message}`, 20);
    return false;
  }
}

/** Draws the charts once they come near the window. */
function watchCharts() {
  const watch = new IntersectionObserver(
    (seen) => {
      if (!seen.some((entry) => entry.isIntersecting)) return;
      watch.disconnect();
      drawer.settled().then(() => {
        page.chartsNear = true;
        series.showRoom();
        measure();
      }, watchCharts);
    },
    { rootMargin: "1500px" },
  );
  watch.observe(byId("errors-chart"));
}

async function begin() {
  fillSelects();
  wireTheme();
  wireControls();
  wireButtons();
  if (!(await openLink())) setText(sceneNamed("castle").json);
  addEventListener("hashchange", openLink);
  watchCharts();
}

/** For tests and for the curious. `hash` is that of the present view at 64×64, N = 4, Fast, Blinn-Phong. */
window.reflet = {
  rust,
  hash: async () => {
    await drawer.settled();
    const { scene, view } = request();
    return side.ask("hash", { scene, view, lane: "asked" });
  },
  text: () => editor.text,
  setText,
};

begin();
