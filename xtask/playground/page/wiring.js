// Ties the page's fields, buttons and address to its state.

function fillSelects() {
  const scenes = byId("scene");
  for (const [group, label] of [
    ["built in", "Built in"],
    ["sample", "Samples"],
  ]) {
    const options = DATA.scenes
      .filter((scene) => scene.group === group)
      .map((scene) => element("option", { value: scene.name }, scene.name));
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
