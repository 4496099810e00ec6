// Pictures on the page, dot by dot: the large one, and its copies beside the formula and the row.

class Picture {
  /** `frame` is the box of canvas and overlay; `room` is the share of the window's height that it may take. */
  constructor(canvas, frame, overlay, room) {
    this.canvas = canvas;
    this.frame = frame;
    this.overlay = overlay;
    this.room = room;
    this.context = canvas.getContext("2d");
    this.parts = 1; // the size of a dot is a multiple of 1 / parts of the screen's pixels
    this.onFit = () => {};
    new ResizeObserver(() => this.fit()).observe(frame.parentElement);
    addEventListener("resize", () => this.fit());
  }

  get width() {
    return this.canvas.width;
  }

  get height() {
    return this.canvas.height;
  }

  /** Sets the size in dots. The old picture stays, enlarged or reduced, until dots are painted over it. */
  resize(width, height) {
    if (this.width === width && this.height === height) return;
    const old = element("canvas", { width: this.width, height: this.height });
    old.getContext("2d").drawImage(this.canvas, 0, 0);
    this.canvas.width = width;
    this.canvas.height = height;
    this.enlarge(old);
    this.fit();
  }

  /** Chooses the size on the page: a whole number of the screen's pixels for each dot, if there is room. */
  fit() {
    const ratio = devicePixelRatio || 1;
    const across = (this.frame.parentElement.clientWidth * ratio) / this.width;
    const down = (innerHeight * this.room * ratio) / this.height;
    const scale = Math.max(Math.min(across, down), Math.min(across, 1));
    const whole = scale >= 1 ? Math.floor(scale * this.parts) / this.parts : scale;
    this.overlay.setAttribute("viewBox", `0 0 ${this.width} ${this.height}`);
    this.frame.style.width = `${(this.width * whole) / ratio}px`;
    this.onFit();
  }

  paintRows(y, bytes) {
    const rows = bytes.length / 4 / this.width;
    this.context.putImageData(new ImageData(new Uint8ClampedArray(bytes.buffer), this.width, rows), 0, y);
  }

  /** Fills the canvas with another one, dot by dot. */
  enlarge(canvas) {
    this.context.imageSmoothingEnabled = false;
    this.context.drawImage(canvas, 0, 0, this.width, this.height);
  }

  copy(picture) {
    this.resize(picture.width, picture.height);
    this.context.drawImage(picture.canvas, 0, 0);
  }

  /** Dot under a pointer. */
  dotAt({ clientX, clientY }) {
    const box = this.canvas.getBoundingClientRect();
    const along = (at, start, length, dots) => clamp(Math.floor(((at - start) / length) * dots), 0, dots - 1);
    return {
      x: along(clientX, box.left, box.width, this.width),
      y: along(clientY, box.top, box.height, this.height),
    };
  }

  /** Draws a path over the picture: the pixel, then the points that the path hits. */
  showPath(pixel, steps) {
    const first = [pixel.x + 0.5, pixel.y + 0.5];
    const seen = steps.slice(1).map((step) => step.seen);
    const known = seen.findIndex((point) => point === null); // behind the camera: the line ends before it
    const points = [first, ...(known < 0 ? seen : seen.slice(0, known))];
    const line = points.map((point) => point.join(",")).join(" ");
    const dot = Math.max(this.width, this.height) / 100;
    const marks = points.map(([x, y], i) =>
      drawing("circle", { cx: x, cy: y, r: i === 0 ? dot * 1.4 : dot, class: i === 0 ? "start" : "hit" }),
    );
    this.overlay.replaceChildren(
      drawing("polyline", { points: line, class: "under" }),
      drawing("polyline", { points: line, class: "over" }),
      ...marks,
    );
  }
}
