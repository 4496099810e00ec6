// Orbits and zooms the camera: pointer, wheel, two fingers and keys.

const TURN_OF_A_PIXEL = 400; // thousandths of a degree for one CSS pixel of a drag
const TURN_OF_A_KEY = 5000;
const CLICK = 5; // CSS pixels that a pointer may move during a click

/** `actions`: turn(by, rise), zoom(factor), reset(), click(event), hide(), enter(). Zoom is called with factors of the field of view. */
function makeOrbit(canvas, actions) {
  const pointers = new Map();
  let moved = 0;
  let spread = 0;

  const distance = () => {
    const [a, b] = [...pointers.values()];
    return Math.hypot(a.x - b.x, a.y - b.y);
  };

  canvas.addEventListener("pointerdown", (event) => {
    if (event.button !== 0) return;
    canvas.setPointerCapture(event.pointerId);
    pointers.set(event.pointerId, { x: event.clientX, y: event.clientY });
    if (pointers.size === 1) moved = 0;
    if (pointers.size === 2) spread = distance();
  });

  canvas.addEventListener("pointermove", (event) => {
    const last = pointers.get(event.pointerId);
    if (!last) return;
    const by = { x: event.clientX - last.x, y: event.clientY - last.y };
    moved += Math.hypot(by.x, by.y);
    if (pointers.size === 2) {
      pointers.set(event.pointerId, { x: event.clientX, y: event.clientY });
      moved = Infinity;
      const now = distance();
      if (now > 0 && spread > 0) actions.zoom(spread / now);
      spread = now;
    } else if (moved > CLICK) {
      pointers.set(event.pointerId, { x: event.clientX, y: event.clientY });
      actions.turn(-by.x * TURN_OF_A_PIXEL, by.y * TURN_OF_A_PIXEL);
    }
  });

  const lift = (event) => {
    if (!pointers.delete(event.pointerId)) return;
    if (event.type === "pointerup" && moved <= CLICK) actions.click(event);
  };
  canvas.addEventListener("pointerup", lift);
  canvas.addEventListener("pointercancel", lift);

  canvas.addEventListener(
    "wheel",
    (event) => {
      const lines = event.deltaMode === 1 ? 20 : 1;
      // At the end of the range the page scrolls on.
      if (actions.zoom(Math.exp(clamp(event.deltaY * lines, -200, 200) * 0.0015))) event.preventDefault();
    },
    { passive: false },
  );

  const keys = {
    ArrowLeft: () => actions.turn(-TURN_OF_A_KEY, 0),
    ArrowRight: () => actions.turn(TURN_OF_A_KEY, 0),
    ArrowUp: () => actions.turn(0, TURN_OF_A_KEY),
    ArrowDown: () => actions.turn(0, -TURN_OF_A_KEY),
    "+": () => actions.zoom(1 / 1.1),
    "=": () => actions.zoom(1 / 1.1),
    "-": () => actions.zoom(1.1),
    0: () => actions.reset(),
    Enter: () => actions.enter(),
    Escape: () => actions.hide(),
  };
  canvas.addEventListener("keydown", (event) => {
    const action = keys[event.key];
    if (!action || event.ctrlKey || event.metaKey || event.altKey) return;
    event.preventDefault();
    action();
  });
}
