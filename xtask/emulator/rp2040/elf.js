// Reads a 32-bit little-endian ELF file: its segments with their addresses, and its functions.

import { readFileSync } from "node:fs";

const LOAD = 1;
const SYMBOL_TABLE = 2;
const FUNCTION = 2;

export class Elf {
  constructor(path) {
    this.bytes = readFileSync(path);
    const { bytes } = this;
    if (bytes.length < 52 || bytes.readUInt32BE(0) !== 0x7f454c46 || bytes[4] !== 1) {
      throw new Error(`${path} is not a 32-bit ELF file`);
    }
    this.segments = this.#headers(28, 42).map((at) => ({
      type: bytes.readUInt32LE(at),
      address: bytes.readUInt32LE(at + 12),
      bytes: this.#slice(bytes.readUInt32LE(at + 4), bytes.readUInt32LE(at + 16)),
    }));
    this.segments = this.segments.filter(({ type, bytes }) => type === LOAD && bytes.length > 0);
    this.symbols = this.#symbols();
  }

  /** Returns the address of the symbol of this name, if there is one. */
  address(name) {
    return this.symbols.find((symbol) => symbol.name === name)?.address;
  }

  /** Returns the linker's name of the function that contains an address, else the address as text. */
  functionAt(address) {
    const holds = ({ type, address: start, size }) =>
      type === FUNCTION && address >= (start & ~1) && address < (start & ~1) + size;
    return this.symbols.find(holds)?.name ?? `0x${address.toString(16)}`;
  }

  /** Returns the offsets of a table's headers. The arguments are offsets in the file header. */
  #headers(offsetAt, sizeAt) {
    const start = this.bytes.readUInt32LE(offsetAt);
    const size = this.bytes.readUInt16LE(sizeAt);
    const count = this.bytes.readUInt16LE(sizeAt + 2);
    return Array.from({ length: count }, (_, index) => start + index * size);
  }

  #slice(offset, size) {
    return this.bytes.subarray(offset, offset + size);
  }

  #symbols() {
    const { bytes } = this;
    const sections = this.#headers(32, 46).map((at) => ({
      type: bytes.readUInt32LE(at + 4),
      bytes: this.#slice(bytes.readUInt32LE(at + 16), bytes.readUInt32LE(at + 20)),
      link: bytes.readUInt32LE(at + 24),
    }));
    const table = sections.find(({ type }) => type === SYMBOL_TABLE);
    if (!table) {
      return [];
    }
    const names = sections[table.link].bytes;
    return Array.from({ length: table.bytes.length / 16 }, (_, index) => {
      const symbol = table.bytes.subarray(index * 16);
      const name = symbol.readUInt32LE(0);
      return {
        name: names.toString("utf8", name, names.indexOf(0, name)),
        address: symbol.readUInt32LE(4),
        size: symbol.readUInt32LE(8),
        type: symbol[12] & 0xf,
      };
    });
  }
}
