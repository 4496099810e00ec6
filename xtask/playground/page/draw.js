// Asks for pictures: the newest request wins, and while the camera moves a slow picture is drawn coarsely.

const SMOOTH_MOTION = 60; // milliseconds that a picture may take while the camera moves
const REST = 150; // milliseconds without motion after which the whole picture is drawn

class Drawer {
  /**
   * `request()` gives the scene, the view and the frame to draw. `outcome` has whole(answer), refused(answer) and
   * stopped(message).
   */
  constructor(engine, picture, request, outcome) {
    this.engine = engine;
    this.picture = picture;
    this.request = request;
    this.outcome = outcome;
    this.running = null; // { moving } of the request that the worker draws
    this.pending = false; // the camera moved while a picture of the motion was drawn
    this.perSample = 0; // milliseconds of one sample, measured with the last picture
    this.rest = debounced(REST, () => this.redraw());
    this.waiting = []; // calls of `settled` that wait for the end of the drawing
  }

  get state() {
    return document.body.dataset.state;
  }

  /** "drawing", "ready" or "error". */
  set state(state) {
    document.body.dataset.state = state;
    this.picture.canvas.setAttribute("aria-busy", state === "drawing");
    if (state !== "drawing") for (const resolve of this.waiting.splice(0)) resolve();
  }

  /** Waits until the picture that was asked for last is drawn whole. Fails if the scene is refused. */
  async settled() {
    if (this.state === "drawing") await new Promise((resolve) => this.waiting.push(resolve));
    if (this.state === "error") throw new Error(byId("error").textContent);
  }

  /** Draws the whole picture. Cancels an older one. */
  redraw() {
    this.pending = false;
    this.state = "drawing";
    this.draw(false);
  }

  /** The camera moved. Draws what it sees as soon as the last picture of the motion is done, and the rest at rest. */
  move() {
    this.state = "drawing";
    this.rest();
    if (this.running && this.running.moving) this.pending = true;
    else this.draw(true);
  }

  /** Frame to draw while the camera moves: less samples, then a half or a third of the dots. */
  coarse(frame) {
    const once = frame.width * frame.height * this.perSample;
    if (once * frame.smooth ** 2 <= SMOOTH_MOTION) return frame;
    const part = once <= SMOOTH_MOTION ? 1 : once <= 4 * SMOOTH_MOTION ? 2 : 3;
    const size = (dots) => Math.ceil(dots / part);
    return { ...frame, width: size(frame.width), height: size(frame.height), smooth: 1 };
  }

  async draw(moving) {
    const { scene, view, frame } = this.request();
    const drawn = moving ? this.coarse(frame) : frame;
    const whole = drawn === frame;
    const paint = moving ? this.painter(drawn, frame) : this.bands(frame);
    const running = (this.running = { moving });
    try {
      const answer = await this.engine.ask("draw", { scene, view, frame: drawn }, (part) =>
        paint.rows(part.y, part.bytes),
      );
      if (this.running !== running) return;
      this.running = null;
      this.perSample = answer.time / (drawn.width * drawn.height * drawn.smooth ** 2);
      paint.finish();
      byId("coarse").hidden = whole;
      this.finished(answer, view, whole);
    } catch (error) {
      if (this.running === running) this.failed(error);
    }
  }

  finished(answer, view, whole) {
    if (this.pending) {
      this.pending = false;
      return this.draw(true);
    }
    if (!whole) return;
    this.state = "ready";
    this.outcome.whole(answer, view);
  }

  failed(error) {
    if (error instanceof Cancelled) return;
    this.running = null;
    this.pending = false;
    if (error instanceof Refused) this.outcome.refused(error.answer);
    else if (error instanceof Stopped) this.outcome.stopped(error.message);
    else throw error;
  }

  /** Paints each band as it comes. */
  bands(frame) {
    return {
      rows: (y, bytes) => {
        this.picture.resize(frame.width, frame.height);
        this.picture.paintRows(y, bytes);
      },
      finish: () => {},
    };
  }

  /** Paints all bands at once, enlarged, so that a moving picture does not tear. */
  painter(drawn, frame) {
    const sheet = element("canvas", { width: drawn.width, height: drawn.height });
    const context = sheet.getContext("2d");
    return {
      rows: (y, bytes) => {
        const rows = bytes.length / 4 / drawn.width;
        context.putImageData(new ImageData(new Uint8ClampedArray(bytes.buffer), drawn.width, rows), 0, y);
      },
      finish: () => {
        this.picture.resize(frame.width, frame.height);
        this.picture.enlarge(sheet);
      },
    };
  }
}
