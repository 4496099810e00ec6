// The editor: a text area with line numbers and one marked line.

class Editor {
  /** `changed` is called with the text when the user has stopped typing for a moment; `typed` at each key. */
  constructor(typed, changed) {
    this.area = byId("editor");
    this.gutter = byId("gutter");
    this.mark = byId("marked-line");
    this.marked = null;
    this.lines = 0;
    const settled = debounced(250, () => changed(this.area.value));
    this.area.addEventListener("input", () => {
      this.number();
      typed();
      settled();
    });
    this.area.addEventListener("scroll", () => this.follow());
  }

  get text() {
    return this.area.value;
  }

  set text(text) {
    this.area.value = text;
    this.area.scrollTop = 0;
    this.number();
  }

  number() {
    const lines = this.area.value.split("\n").length;
    if (lines !== this.lines) {
      this.lines = lines;
      this.gutter.textContent = Array.from({ length: lines }, (_, line) => line + 1).join("\n");
    }
    this.follow();
  }

  /** Keeps line numbers and mark beside the text that is scrolled. */
  follow() {
    this.gutter.scrollTop = this.area.scrollTop;
    this.mark.hidden = this.marked === null;
    if (this.marked === null) return;
    const style = getComputedStyle(this.area);
    const top = parseFloat(style.paddingTop) + (this.marked - 1) * parseFloat(style.lineHeight);
    this.mark.style.transform = `translateY(${top - this.area.scrollTop}px)`;
  }

  /** Shows an error, at its line if it has one. */
  refuse({ error, line, column }) {
    const box = byId("error");
    const place = line
      ? ["Line ", element("span", { id: "error-line" }, String(line)), column ? `, column ${column}: ` : ": "]
      : [];
    box.replaceChildren(...place, error.replace(/^line \d+, column \d+: /, ""));
    if (line) {
      const go = element("button", { type: "button", class: "link" }, "Go to the line");
      go.addEventListener("click", () => this.go(line));
      box.append(" ", go);
    }
    box.hidden = false;
    this.area.setAttribute("aria-invalid", "true");
    this.marked = line || null;
    this.follow();
  }

  accept() {
    byId("error").hidden = true;
    byId("error").replaceChildren();
    this.area.removeAttribute("aria-invalid");
    this.marked = null;
    this.follow();
  }

  go(line) {
    const lines = this.area.value.split("\n");
    const start = lines.slice(0, line - 1).join("\n").length + (line > 1 ? 1 : 0);
    this.area.focus();
    this.area.setSelectionRange(start, start + (lines[line - 1] ?? "").length);
    this.area.scrollTop = (line - 4) * parseFloat(getComputedStyle(this.area).lineHeight);
  }
}
