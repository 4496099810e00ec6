// The connection between the cores: their numbers, the two FIFOs, and the boot ROM code through which
// the first core starts the second. rp2040js has none of these.

const CORE_NUMBER = 0x000;
const FIFO_STATUS = 0x050;
const FIFO_WRITE = 0x054;
const FIFO_READ = 0x058;

const IS_FILLED = 1;
const HAS_ROOM = 2;
const DEPTH = 8;

const POWER_MANAGER = 0x40010;
const FORCE_OFF = 0x4;
const SECOND_CORE = 1 << 16;

/** Tests whether both cores share a register of the SIO: those of pins and spin locks. */
function isShared(offset) {
  return (offset >= 0x004 && offset < 0x050) || offset === 0x05c || offset >= 0x100;
}

export class Mailboxes {
  /** Whether the second core runs firmware. */
  secondIsStarted = false;

  #fifos = [[], []];
  #cores;
  #isThere;
  #isOff = false;
  #words = [];

  constructor(rp2040, second, isThere) {
    this.#cores = [rp2040.core, second];
    this.#isThere = isThere;
    const { sio } = rp2040;
    const shared = { read: sio.readUint32.bind(sio), write: sio.writeUint32.bind(sio) };
    this.#connect(0, sio, shared);
    this.#connect(1, second.rp2040.sio, shared);
    this.#watchPower(rp2040.peripherals[POWER_MANAGER]);
  }

  #connect(number, sio, shared) {
    const [incoming, outgoing] = [this.#fifos[number], this.#fifos[1 - number]];
    const read = sio.readUint32.bind(sio);
    const write = sio.writeUint32.bind(sio);
    sio.readUint32 = (offset) => {
      switch (offset) {
        case CORE_NUMBER:
          return number;
        case FIFO_STATUS:
          return (incoming.length > 0 && IS_FILLED) | (outgoing.length < DEPTH && HAS_ROOM);
        case FIFO_READ:
          return incoming.shift() ?? 0;
        default:
          return isShared(offset) ? shared.read(offset) : read(offset);
      }
    };
    sio.writeUint32 = (offset, value) => {
      switch (offset) {
        case FIFO_STATUS:
          return;
        case FIFO_WRITE:
          this.#send(1 - number, value >>> 0);
          return;
        default:
          (isShared(offset) ? shared.write : write)(offset, value);
      }
    };
  }

  #send(to, word) {
    if (to === 1 && this.#isThere && !this.secondIsStarted) {
      this.#hear(word);
      return;
    }
    if (this.#fifos[to].length < DEPTH) {
      this.#fifos[to].push(word);
    }
    this.#wake(this.#cores[to]);
  }

  #wake(core) {
    core.eventRegistered = !core.waiting;
    core.waiting = false;
  }

  /** The second core's boot ROM: echoes each word, and starts at 1, vectors, stack and entry. */
  #hear(word) {
    if (this.#isOff) {
      return;
    }
    this.#words = word === 0 ? [] : [...this.#words, word];
    this.#send(0, word);
    const [one, vectors, stack, entry] = this.#words;
    if (one === 1 && entry !== undefined) {
      const [, second] = this.#cores;
      Object.assign(second, { VTOR: vectors, SP: stack, PC: entry & ~1 });
      this.secondIsStarted = true;
    }
  }

  /** When the second core leaves its reset, its boot ROM sends a 0 to the first. */
  #watchPower(manager) {
    const write = manager.writeUint32.bind(manager);
    manager.writeUint32 = (offset, value) => {
      write(offset, value);
      const isOff = (manager.readUint32(FORCE_OFF) & SECOND_CORE) !== 0;
      if (isOff) {
        this.secondIsStarted = false;
        this.#fifos[1].length = 0;
        this.#words = [];
      } else if (this.#isOff && this.#isThere) {
        this.#send(0, 0);
      }
      this.#isOff = isOff;
    };
  }
}
