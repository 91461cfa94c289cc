import { InputError, type ItemId } from './types';

/** Writes whole numbers of any size: 7 bits in each byte, the lowest first. Bit 7 says that another byte follows. */
export class ByteWriter {
  private bytes = new Uint8Array(256);
  private length = 0;

  private reserve(count: number): void {
    if (this.length + count <= this.bytes.length) return;
    const larger = new Uint8Array(Math.max(2 * this.bytes.length, this.length + count));
    larger.set(this.bytes.subarray(0, this.length));
    this.bytes = larger;
  }

  byte(value: number): void {
    this.reserve(1);
    this.bytes[this.length++] = value;
  }

  append(bytes: Uint8Array): void {
    this.reserve(bytes.length);
    this.bytes.set(bytes, this.length);
    this.length += bytes.length;
  }

  /** Requires: `value` is not negative. */
  whole(value: ItemId): void {
    if (typeof value === 'bigint') return this.wholeBig(value);
    let rest = value;
    while (rest >= 128) {
      this.byte((rest % 128) | 128);
      rest = Math.floor(rest / 128);
    }
    this.byte(rest);
  }

  private wholeBig(value: bigint): void {
    let rest = value;
    for (; rest >= 128n; rest >>= 7n) this.byte(Number(rest & 127n) | 128);
    this.byte(Number(rest));
  }

  /** Writes a number of either sign. Requires: its size is below 2^52. */
  signed(value: number): void {
    this.whole(value < 0 ? -2 * value - 1 : 2 * value);
  }

  result(): Uint8Array {
    return this.bytes.slice(0, this.length);
  }
}

/** Returns the error for a link that has been changed or cut. `column` is a character of its text. */
export function damaged(what: string, column?: number): InputError {
  const where = column === undefined ? {} : { column };
  const advice = 'Copy the whole link again, from its first character to its last';
  return new InputError(`the link is damaged: ${what}`, where, advice);
}

const LARGEST_ID = 2n ** 63n - 1n;

/** Reads what ByteWriter has written. Throws an InputError at the end of the bytes, and for a number that is too large. */
export class ByteReader {
  private readonly bytes: Uint8Array;
  private at = 0;

  constructor(bytes: Uint8Array) {
    this.bytes = bytes;
  }

  get remaining(): number {
    return this.bytes.length - this.at;
  }

  byte(): number {
    const byte = this.bytes[this.at];
    if (byte === undefined) throw damaged('it ends too early');
    ++this.at;
    return byte;
  }

  take(count: number): Uint8Array {
    if (count > this.remaining) throw damaged('it ends too early');
    this.at += count;
    return this.bytes.subarray(this.at - count, this.at);
  }

  /** Reads a whole number from 0 to 2^63 - 1: a bigint if it is above 2^53 - 1. */
  id(): ItemId {
    const start = this.at;
    let value = 0;
    for (let scale = 1; scale < 2 ** 49; scale *= 128) {
      const byte = this.byte();
      value += (byte & 127) * scale;
      if (byte < 128) return value;
    }
    this.at = start;
    return this.largeId();
  }

  private largeId(): ItemId {
    const value = this.bigWhole();
    if (value > LARGEST_ID) throw damaged('a number in it is too large');
    return value > BigInt(Number.MAX_SAFE_INTEGER) ? value : Number(value);
  }

  /** Reads a whole number of up to 10 bytes. */
  bigWhole(): bigint {
    let value = 0n;
    for (let shift = 0n; shift <= 63n; shift += 7n) {
      const byte = this.byte();
      value |= BigInt(byte & 127) << shift;
      if (byte < 128) return value;
    }
    throw damaged('a number in it is too large');
  }

  /** Reads a whole number up to 2^53 - 1. */
  whole(): number {
    const value = this.id();
    if (typeof value === 'bigint') throw damaged('a number in it is too large');
    return value;
  }

  signed(): number {
    const value = this.whole();
    return value % 2 === 1 ? -(value + 1) / 2 : value / 2;
  }

  /** Reads a count of things of which each takes `size` bytes or more in a whole of `bytes`. */
  count(size: number, bytes = this.remaining): number {
    const count = this.whole();
    if (count * size > bytes) throw damaged('a count in it is too large');
    return count;
  }
}
