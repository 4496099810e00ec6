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

const picture = new Picture(byId("picture"), byId("stage"), byId("picture-overlay"), 0.8);
const pixelPicture = new Picture(byId("pixel-picture"), byId("pixel-stage"), byId("pixel-overlay"), 0.6);
const rowPicture = new Picture(byId("row-picture"), byId("row-stage"), byId("row-overlay"), 0.55);
rowPicture.parts = 2; // a little uneven, but the bars below stay in the window

const editor = new Editor(
  () => (drawer.state = "drawing"),
  (text) => useText(text),
);
const drawer = new Drawer(engine, picture, request, { whole, refused, stopped });
const askPath = latest(
  () => question("path", pixels.pixel),
  (path) => pixels.show(path),
);
const askRow = latest(
  () => question("row", { y: rows.row }),
  ({ runs }) => rows.show(runs, page.lights),
);
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
  if (answer.what === "scene") editor.refuse(answer);
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
  const text =
    "The library stopped while it drew this picture. It is started again: change the scene or a setting to go on.";
  editor.refuse({ error: `${text} (${message})` });
  drawer.state = "error";
}

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
