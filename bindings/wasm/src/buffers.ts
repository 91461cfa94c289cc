import { refuse, WaywrightError } from './errors.js';
import { allocate, f64, fits, release, slots, u32, u8 } from './runtime.js';

/** The largest buffer, in bytes, that the wrapper keeps after a call. It frees a larger one. */
const KEPT_BYTES = 1 << 20;

/** A buffer in the memory of the module, for lists in answers. It grows if a list does not fit. */
class ListBuffer {
  address = 0;
  bytes = 0;

  reserve(bytes: number): void {
    if (bytes <= this.bytes) return;
    this.clear();
    const wanted = Math.max(bytes, 256);
    this.address = allocate(wanted);
    this.bytes = wanted;
  }

  /** Frees the buffer if it is large. */
  trim(): void {
    if (this.bytes > KEPT_BYTES) this.clear();
  }

  private clear(): void {
    if (this.address !== 0) release(this.address);
    this.address = 0;
    this.bytes = 0;
  }
}

const first = new ListBuffer();
const second = new ListBuffer();

/** The elements of a list, at an address in the memory of the module. They are valid until the next call. */
export interface List {
  readonly address: number;
  readonly count: number;
}

/** Reads a list: makes the call, and makes it again with a larger buffer if the list does not fit. */
export function readList(size: number, call: (buffer: number, capacity: number, count: number) => number): List {
  first.trim();
  first.reserve(1);
  for (;;) {
    const capacity = Math.floor(first.bytes / size);
    if (fits(call(first.address, capacity, slots.count))) {
      return { address: first.address, count: u32[slots.count >>> 2]! };
    }
    first.reserve(u32[slots.count >>> 2]! * size);
  }
}

/** Reads two lists of one call. */
export function readTwoLists(
  size: number,
  call: (a: number, capacityA: number, countA: number, b: number, capacityB: number, countB: number) => number,
): readonly [List, List] {
  first.trim();
  second.trim();
  first.reserve(1);
  second.reserve(1);
  for (;;) {
    const [roomA, roomB] = [Math.floor(first.bytes / size), Math.floor(second.bytes / size)];
    const done = fits(call(first.address, roomA, slots.count, second.address, roomB, slots.count2));
    const [countA, countB] = [u32[slots.count >>> 2]!, u32[slots.count2 >>> 2]!];
    if (done) return [{ address: first.address, count: countA }, { address: second.address, count: countB }];
    first.reserve(countA * size);
    second.reserve(countB * size);
  }
}

/** The memory of the module for the arguments of one call. */
class Arena {
  private chunk = 0;
  private bytes = 0;
  private used = 0;
  private readonly full: number[] = [];

  /** Starts a new call: the memory that the last call has taken is free again. */
  reset(): void {
    this.used = 0;
    for (const chunk of this.full) release(chunk);
    this.full.length = 0;
    if (this.bytes <= KEPT_BYTES) return;
    release(this.chunk);
    this.chunk = 0;
    this.bytes = 0;
  }

  /** Returns the address of `bytes` bytes, a multiple of 8. */
  take(bytes: number): number {
    const wanted = Math.ceil(bytes / 8) * 8;
    if (this.used + wanted > this.bytes) {
      const size = Math.max(wanted, 4096, Math.min(2 * this.bytes, KEPT_BYTES));
      const chunk = allocate(size);
      if (this.chunk !== 0) this.full.push(this.chunk);
      this.chunk = chunk;
      this.bytes = size;
      this.used = 0;
    }
    const address = this.chunk + this.used;
    this.used += wanted;
    return address;
  }
}

export const arena = new Arena();

/** A point in the plane. */
export interface Point {
  readonly x: number;
  readonly y: number;
}

/**
 * A list of points: an array of points, or an array of numbers `x0, y0, x1, y1, ...` of any type. A Float64Array needs
 * the fewest conversions.
 */
export type Points = Float64Array | ArrayLike<number> | readonly Point[];

/** Returns the number of points in a list. */
export function pointCount(points: Points): number {
  const { length } = points;
  if (length > 0 && typeof points[0] === 'object') return length;
  if (length % 2 !== 0) refuse(`a list of coordinates has two numbers for each point, not ${length} numbers`);
  return length / 2;
}

/** Writes points to an address of the module. */
export function writePoints(points: Points, address: number): void {
  const at = address >>> 3;
  if (points.length === 0) return;
  if (typeof points[0] !== 'object') {
    f64.set(points as ArrayLike<number>, at);
    return;
  }
  const list = points as readonly Point[];
  for (let i = 0; i < list.length; ++i) {
    const point = list[i] ?? refuse('a list of points has a hole');
    f64[at + 2 * i] = point.x;
    f64[at + 2 * i + 1] = point.y;
  }
}

/** Copies points into the arena. */
export function packPoints(points: Points): List {
  const count = pointCount(points);
  const address = arena.take(16 * count);
  writePoints(points, address);
  return { address, count };
}

/** Copies numbers into the arena, as 32-bit unsigned integers. */
export function packSizes(numbers: ArrayLike<number>): List {
  const address = arena.take(4 * numbers.length);
  for (let i = 0; i < numbers.length; ++i) u32[(address >>> 2) + i] = toSize(numbers[i]!);
  return { address, count: numbers.length };
}

/** Copies a text, or other bytes, into the arena, with a zero byte at the end. */
export function packText(text: Uint8Array): List {
  const address = arena.take(text.length + 1);
  u8.set(text, address);
  u8[address + text.length] = 0;
  return { address, count: text.length };
}

/** Returns a whole number from 0 to 2^32 - 1, or throws. */
export function toSize(value: number): number {
  if (!(value >= 0 && value < 2 ** 32 && Number.isInteger(value))) {
    throw new WaywrightError('invalid-argument', `${String(value)} is not a whole number from 0 to 2^32 - 1`);
  }
  return value;
}

/**
 * Copies numbers from the memory of the module to an array of JavaScript: to `into` if they fit there, otherwise to a new
 * array. Returns the part of the array that contains the numbers.
 */
export function copyNumbers(address: number, length: number, into?: Float64Array): Float64Array {
  const source = f64.subarray(address >>> 3, (address >>> 3) + length);
  if (into === undefined || into.length < length) return source.slice();
  into.set(source);
  return into.length === length ? into : into.subarray(0, length);
}

/** Does the same as {@link copyNumbers} for 32-bit unsigned integers. */
export function copyIntegers(address: number, length: number, into?: Uint32Array): Uint32Array {
  const source = u32.subarray(address >>> 2, (address >>> 2) + length);
  if (into === undefined || into.length < length) return source.slice();
  into.set(source);
  return into.length === length ? into : into.subarray(0, length);
}
