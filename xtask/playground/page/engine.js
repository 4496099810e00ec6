// A worker with the library in it, as a function that returns promises.

/** A newer request took the place of this one. */
class Cancelled extends Error {}

/** The library refused the request; `answer` says why. */
class Refused extends Error {
  constructor(answer) {
    super(answer.error);
    this.answer = answer;
  }
}

/** The library stopped. A new worker is ready for the next request. */
class Stopped extends Error {}

class Engine {
  /** `wasm` is the deflated module, `source` the worker's text. */
  constructor(wasm, source) {
    this.wasm = wasm;
    this.url = URL.createObjectURL(new Blob([source], { type: "text/javascript" }));
    this.next = 1;
    this.start();
  }

  start() {
    this.waiting = new Map();
    this.worker = new Worker(this.url);
    this.worker.onmessage = ({ data }) => this.receive(data);
    this.worker.onerror = (event) => this.restart(event.message);
    this.worker.postMessage({ wasm: this.wasm });
  }

  /** Asks the worker. `onPart` is called with each part of the answer, in order. */
  ask(kind, values = {}, onPart = () => {}) {
    const id = this.next++;
    return new Promise((resolve, reject) => {
      this.waiting.set(id, { resolve, reject, onPart });
      this.worker.postMessage({ id, kind, lane: kind, ...values });
    });
  }

  receive(data) {
    if ("stopped" in data) return this.restart(data.stopped);
    const asked = this.waiting.get(data.id);
    if (!asked) return;
    if ("part" in data) return asked.onPart(data.part);
    this.waiting.delete(data.id);
    if ("done" in data) asked.resolve(data.done);
    else if (data.cancelled) asked.reject(new Cancelled("cancelled"));
    else asked.reject(new Refused(data.refused));
  }

  restart(message) {
    const waiting = this.waiting;
    this.worker.terminate();
    this.start();
    for (const { reject } of waiting.values()) reject(new Stopped(message));
  }
}

/** Awaits `promise`; gives `null` where the answer no longer matters or could not be had, and says so if the library stopped. */
async function ifWanted(promise) {
  try {
    return await promise;
  } catch (error) {
    if (error instanceof Stopped)
      say(`The library stopped at a question and was started again. (${error.message})`, 12);
    if (error instanceof Cancelled || error instanceof Refused || error instanceof Stopped) return null;
    throw error;
  }
}
