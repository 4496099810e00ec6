"use strict";
// Runs the library. Draws pictures in slices of time and answers questions about them. Knows nothing of the page.
//
// Requests are { id, kind, lane, ...arguments }. A kind of `tasks` takes long: it runs in slices, one task at a time,
// and a newer request of the same lane cancels it. A kind of `questions` is answered at once.
// Replies are { id, part }, and at last one of { id, done }, { id, refused }, { id, cancelled } or { stopped }.

const SLICE = 12; // milliseconds of drawing between two looks at the messages
const ENOUGH = 300; // milliseconds after which a time is known well enough
const HASHED = { width: 64, height: 64, reflections: 4, quality: 0, shading: 0, smooth: 1, display: 0 };
const TIMED = { ...HASHED, width: 240, height: 240 };
const OWN_VIEW = { turn: 0, rise: 0, zoom: 1000 };

let library = null; // exports of the wasm module
let opened = null; // { text, index, answer } of the scene that the library holds
let started = null; // promise that the library is loaded
const queue = []; // tasks { request, steps }; the first one runs

/** The library refused a scene, a view or a frame; `answer` says why. */
class Refused extends Error {
  constructor(answer, what) {
    super(answer.error);
    this.answer = { ...answer, what };
  }
}

function answerText() {
  const start = library.answer_ptr() >>> 0;
  return new TextDecoder().decode(new Uint8Array(library.memory.buffer, start, library.answer_len() >>> 0));
}

const answer = () => JSON.parse(answerText());

/** Throws if a call returned 1. `what` names what was refused. */
function accept(result, what) {
  if (result !== 0) throw new Refused(answer(), what);
}

function open({ text, index }) {
  if (opened && opened.text === text && opened.index === index) return;
  opened = null;
  const bytes = new TextEncoder().encode(text);
  const start = library.text_room(bytes.length) >>> 0;
  new Uint8Array(library.memory.buffer, start, bytes.length).set(bytes);
  accept(library.open(bytes.length, index), "scene");
  opened = { text, index, answer: answer() };
}

function setView({ turn, rise, zoom }) {
  accept(library.set_view(turn, rise, zoom), "view");
}

function prepare(frame) {
  const { width, height, reflections, quality, shading, smooth, display } = frame;
  accept(library.frame(width, height, reflections, quality, shading, smooth, display), "frame");
}

/** Draws all rows. Hands finished bands to `band(y, bytes)`. Returns the time spent and the library's report. */
function* drawFrame(frame, band) {
  let sliceStart = performance.now();
  let spent = 0;
  prepare(frame);
  const rowBytes = frame.width * 4;
  const bytes = new Uint8Array(rowBytes * frame.height);
  let first = 0;
  for (let y = 0; y < frame.height; y++) {
    const start = library.row(y) >>> 0; // first: the call may let the memory grow, which takes the old buffer away
    bytes.set(new Uint8Array(library.memory.buffer, start, rowBytes), (y - first) * rowBytes);
    const now = performance.now();
    if (now - sliceStart < SLICE && y + 1 < frame.height) continue;
    spent += now - sliceStart;
    band(first, bytes.slice(0, (y + 1 - first) * rowBytes));
    first = y + 1;
    if (first < frame.height) yield;
    sliceStart = performance.now();
  }
  accept(library.finish(), "frame");
  return { time: spent, ...answer() };
}

const ignore = () => {};

const tasks = {
  *draw({ scene, view, frame }, part) {
    open(scene);
    setView(view);
    const report = yield* drawFrame(frame, (y, bytes) => part({ y, bytes }, [bytes.buffer]));
    return { ...report, scene: opened.answer };
  },
  *hash({ scene, view }) {
    open(scene);
    setView(view);
    return (yield* drawFrame(HASHED, ignore)).hash;
  },
  /** Time of a frame: the least of some, because the browser compiles wasm better while it runs. */
  *time({ scene }) {
    open(scene);
    setView(OWN_VIEW);
    const times = [];
    for (let total = 0; times.length < 2 || (times.length < 8 && total < ENOUGH); total += times.at(-1)) {
      times.push((yield* drawFrame(TIMED, ignore)).time);
    }
    return Math.min(...times);
  },
  *errors({ scene, view, width, height, most }, part) {
    open(scene);
    setView(view);
    for (let reflections = 0; reflections <= most; reflections++) {
      accept(library.error_at(width, height, reflections), "frame");
      const at = answer();
      part(at);
      if (at.largest === 0 && at.bound === 0) return;
      yield;
    }
  },
  *room({ scene, most }, part) {
    open(scene);
    setView(OWN_VIEW);
    for (let reflections = 0; reflections <= most; reflections++) {
      prepare({ ...HASHED, width: 5, height: 5, reflections, quality: 1 });
      accept(library.path(2, 2), "frame");
      part({ reflections, ...answer() });
      yield;
    }
  },
};

const questions = {
  path: ({ x, y }) => (accept(library.path(x, y), "path"), answer()),
  row: ({ y }) => (accept(library.row_paths(y), "row"), answer()),
  camera: () => (accept(library.camera(), "camera"), answer()),
  rust: () => (accept(library.rust(), "scene"), answerText()),
};

/** Answers a question about the picture that was drawn last. A new worker first takes over its scene, view and frame. */
function answerTo(request) {
  if (!opened) {
    open(request.scene);
    setView(request.view);
    prepare(request.frame);
  }
  postMessage({ id: request.id, done: questions[request.kind](request) });
}

/** Runs `step` and posts its outcome. A trap ends this worker's use: the page starts another one. */
function guarded(request, step) {
  try {
    step();
  } catch (error) {
    if (error instanceof Refused) postMessage({ id: request.id, refused: error.answer });
    else postMessage({ stopped: String(error && error.message) });
  }
}

const wake = new MessageChannel();
wake.port1.onmessage = runSlice;

/** Runs the first task until it yields or ends. */
function runSlice() {
  const task = queue[0];
  if (!task) return;
  let over = true;
  guarded(task.request, () => {
    const { done, value } = task.steps.next();
    if (done) postMessage({ id: task.request.id, done: value });
    over = done;
  });
  if (over) queue.shift();
  if (queue.length > 0) wake.port2.postMessage(0);
}

function begin(request) {
  const older = queue.findIndex((task) => task.request.lane === request.lane);
  if (older >= 0) postMessage({ id: queue.splice(older, 1)[0].request.id, cancelled: true });
  const part = (value, transfer = []) => postMessage({ id: request.id, part: value }, transfer);
  queue.push({ request, steps: tasks[request.kind](request, part) });
  wake.port2.postMessage(0);
}

/** Loads the library from its deflated module. */
async function load(deflated) {
  const bytes = new Blob([deflated]).stream().pipeThrough(new DecompressionStream("deflate-raw"));
  const module = new Response(bytes, { headers: { "Content-Type": "application/wasm" } });
  library = (await WebAssembly.instantiateStreaming(module)).instance.exports;
}

onmessage = async ({ data }) => {
  if (data.wasm) {
    started = load(data.wasm);
    started.catch((error) => postMessage({ stopped: String(error && error.message) }));
    return;
  }
  await started;
  if (tasks[data.kind]) begin(data);
  else guarded(data, () => answerTo(data));
};
