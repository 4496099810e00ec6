// Where the camera stands in the text of a scene file.

/** End of the JSON value that starts at `at`. The text is valid JSON: the library has read it. */
function valueEnd(text, at) {
  const skip = /\s*/y;
  const scalar = /"(?:[^"\\]|\\.)*"|[^\s,\]}]+/y;
  let depth = 0;
  for (;;) {
    skip.lastIndex = at;
    skip.exec(text);
    at = skip.lastIndex;
    const character = text[at];
    if (character === undefined) return at;
    if (character === "{" || character === "[") depth++;
    if (character === "}" || character === "]") depth--;
    if ("{}[],:".includes(character)) at++;
    else {
      scalar.lastIndex = at;
      scalar.exec(text);
      at = Math.max(scalar.lastIndex, at + 1);
    }
    if (depth === 0) return at;
  }
}

/** Spans of the parts of the object or list that starts at `at`: { key, start, end }. */
function partsOf(text, at) {
  const separator = /[\s,]*/y;
  const key = /"((?:[^"\\]|\\.)*)"\s*:\s*/y;
  const named = text[at] === "{";
  const parts = [];
  let next = at + 1;
  for (;;) {
    separator.lastIndex = next;
    separator.exec(text);
    next = separator.lastIndex;
    if (next >= text.length || text[next] === "}" || text[next] === "]") return parts;
    let name = String(parts.length);
    if (named) {
      key.lastIndex = next;
      const found = key.exec(text);
      if (!found) return parts;
      name = found[1];
      next = key.lastIndex;
    }
    const end = valueEnd(text, next);
    parts.push({ key: name, start: next, end });
    next = end;
  }
}

function cameraText({ position, target, up, fov }) {
  const list = (values) => `[${values.join(", ")}]`;
  return `{ "position": ${list(position)}, "target": ${list(target)}, "up": ${list(up)}, "fov": ${fov} }`;
}

/** Start of the text of scene `index`; -1 is the first one. -1 if there is none. */
function sceneStart(text, index) {
  const start = text.search(/[[{]/);
  if (start < 0 || text[start] === "{") return start;
  return partsOf(text, start)[Math.max(index, 0)]?.start ?? -1;
}

/** `text` with `camera` as the camera of scene `index`. */
function withCamera(text, index, camera) {
  const start = sceneStart(text, index);
  const found = start < 0 ? null : partsOf(text, start).find((part) => part.key === "camera");
  return found ? text.slice(0, found.start) + cameraText(camera) + text.slice(found.end) : text;
}
