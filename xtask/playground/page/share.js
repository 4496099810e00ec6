// Ways out of the page: the clipboard, a file, and a link that contains the scene.

const LONGEST_TEXT = 16e6; // bytes; the library's reader takes no more

/** Copies `text`, or shows it where the browser does not let the page copy. */
async function copyText(text, done) {
  try {
    await navigator.clipboard.writeText(text);
    say(done);
  } catch {
    byId("text-dialog-text").value = text;
    byId("text-dialog").showModal();
    byId("text-dialog-text").select();
  }
}

function downloadText(name, text) {
  const url = URL.createObjectURL(new Blob([text], { type: "application/json" }));
  element("a", { href: url, download: name }).click();
  setTimeout(() => URL.revokeObjectURL(url), 1000);
}

/** All bytes of a stream. Fails if there are more than `most`. */
async function bytesOf(stream, most) {
  const chunks = [];
  let length = 0;
  const reader = stream.getReader();
  for (let next = await reader.read(); !next.done; next = await reader.read()) {
    length += next.value.length;
    if (length > most) {
      await reader.cancel();
      throw new Error("the text is too long");
    }
    chunks.push(next.value);
  }
  return new Uint8Array(await new Blob(chunks).arrayBuffer());
}

async function deflated(text) {
  const stream = new Blob([text]).stream().pipeThrough(new CompressionStream("deflate-raw"));
  const bytes = await bytesOf(stream, LONGEST_TEXT);
  let binary = "";
  for (const byte of bytes) binary += String.fromCharCode(byte);
  return btoa(binary).replaceAll("+", "-").replaceAll("/", "_").replaceAll("=", "");
}

async function inflated(base64url) {
  const binary = atob(base64url.replaceAll("-", "+").replaceAll("_", "/"));
  const bytes = Uint8Array.from(binary, (character) => character.charCodeAt(0));
  const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream("deflate-raw"));
  return new TextDecoder().decode(await bytesOf(stream, LONGEST_TEXT));
}

/** Link to this page with the scene and the settings in its fragment. */
async function linkTo(text, settings) {
  const fragment = new URLSearchParams({ scene: await deflated(text), ...settings });
  return `${location.href.split("#")[0]}#${fragment}`;
}

/** Scene and settings of the page's address, or `null`. Fails if they are damaged. */
async function linked() {
  const fragment = new URLSearchParams(location.hash.slice(1));
  if (!fragment.has("scene")) return null;
  const { scene, ...settings } = Object.fromEntries(fragment);
  return { text: await inflated(scene), settings };
}
