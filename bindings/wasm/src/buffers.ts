import { refuse, shown, toNumber, WaywrightError } from './errors.js';
import { allocate, f64, fits, onUnload, release, requireIdle, scratch, u32, u8 } from './runtime.js';

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

  clear(): void {
    if (this.address !== 0) release(this.address);
    this.forget();
  }

  forget(): void {
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
    if (fits(call(first.address, capacity, scratch.count))) {
      return { address: first.address, count: u32[scratch.count >>> 2]! };
    }
    first.reserve(u32[scratch.count >>> 2]! * size);
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
    const done = fits(call(first.address, roomA, scratch.count, second.address, roomB, scratch.count2));
    const [countA, countB] = [u32[scratch.count >>> 2]!, u32[scratch.count2 >>> 2]!];
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

  /** Starts a new call: the memory of the last call is free again. Read the caller's objects before: see flatten(). */
  reset(): void {
    requireIdle();
    this.used = 0;
    for (const chunk of this.full) release(chunk);
    this.full.length = 0;
    if (this.bytes > KEPT_BYTES) this.clear();
  }

  clear(): void {
    if (this.chunk !== 0) release(this.chunk);
    this.forget();
  }

  forget(): void {
    this.chunk = 0;
    this.bytes = 0;
    this.used = 0;
    this.full.length = 0;
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

/** Frees the memory for arguments and answers. */
export function freeBuffers(): void {
  arena.reset();
  for (const each of [arena, first, second]) each.clear();
}

onUnload(() => {
  for (const each of [arena, first, second]) each.forget();
});

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

const LARGEST_LIST = 0xffff0000 / 8;

/** Returns the length of a list that a caller has given. */
function lengthOf(list: ArrayLike<unknown>, what: string): number {
  const length: unknown = typeof list === 'object' && list !== null ? list.length : null;
  if (typeof length !== 'number' || !Number.isInteger(length) || length < 0) return refuse(`${what} is ${shown(list)}, not an array`);
  if (length > LARGEST_LIST) throw new WaywrightError('out-of-memory', `there is no memory for ${length} elements`);
  return length;
}

/** Returns a copy of the elements of a list that a caller has given. */
export function copyList<T, U>(list: ArrayLike<T>, what: string, convert: (element: T) => U): U[] {
  return Array.from({ length: lengthOf(list, what) }, (_, i) => convert(list[i] as T));
}

/** Returns a copy of a point that a caller has given. */
export function copyPoint(point: Point): Point {
  if (typeof point !== 'object' || point === null) return refuse(`a point is ${shown(point)}, not { x, y }`);
  return { x: toNumber(point.x, 'x of a point'), y: toNumber(point.y, 'y of a point') };
}

/**
 * Returns the coordinates of a list of points: the list itself if it is a Float64Array, or a copy. The functions that read
 * the objects of a caller come before those that write to the module, because an object of the caller may call the package:
 * a getter, for example.
 */
export function flatten(points: Points): Float64Array {
  const length = lengthOf(points as ArrayLike<unknown>, 'a list of points');
  const hasPoints = length > 0 && typeof points[0] === 'object';
  if (!hasPoints && length % 2 !== 0) refuse(`a list of coordinates has two numbers for each point, not ${length} numbers`);
  if (isFloat64Array(points)) return points;
  const total = hasPoints ? 2 * length : length;
  if (total > LARGEST_LIST) throw new WaywrightError('out-of-memory', `there is no memory for ${total} coordinates`);
  const numbers = new Float64Array(total);
  for (let i = 0; i < length; ++i) {
    if (hasPoints) {
      const { x, y } = copyPoint(points[i] as Point);
      numbers[2 * i] = x;
      numbers[2 * i + 1] = y;
    } else {
      numbers[i] = toNumber(points[i] as number, 'a coordinate');
    }
  }
  return numbers;
}

/** Returns whether a value is an array of a class, also of the class of another window. */
function isA(value: unknown, name: string): boolean {
  return ArrayBuffer.isView(value) && Object.prototype.toString.call(value) === `[object ${name}]`;
}

function isFloat64Array(value: unknown): value is Float64Array {
  return isA(value, 'Float64Array');
}

/** Copies the coordinates of points into the arena. */
export function packPoints(coordinates: Float64Array): List {
  const { length } = coordinates;
  const address = arena.take(8 * length);
  // A detached array has no element, and cannot be copied.
  if (length > 0) f64.subarray(address >>> 3, (address >>> 3) + length).set(coordinates);
  return { address, count: length / 2 };
}

/** Copies numbers into the arena, as 32-bit unsigned integers. */
export function packSizes(numbers: readonly number[]): List {
  const address = arena.take(4 * numbers.length);
  u32.set(numbers, address >>> 2);
  return { address, count: numbers.length };
}

/** Returns bytes that a caller has given, or throws. */
export function toBytes(bytes: Uint8Array): Uint8Array {
  return isA(bytes, 'Uint8Array') ? bytes : refuse(`the bytes are ${shown(bytes)}, not a Uint8Array`);
}

/** Copies a text, or other bytes, into the arena, with a zero byte at the end. */
export function packText(text: Uint8Array): List {
  const { length } = text;
  const address = arena.take(length + 1);
  if (length > 0) u8.subarray(address, address + length).set(text);
  u8[address + length] = 0;
  return { address, count: length };
}

/** Returns a whole number from 0 to 2^32 - 1, or throws. */
export function toSize(value: number): number {
  if (Number.isInteger(value) && value >= 0 && value < 2 ** 32) return value;
  return refuse(`${shown(value)} is not a whole number from 0 to 2^32 - 1`);
}

/** Returns an array for an answer if a caller has given one, and if the answer fits there. */
function roomIn<T extends Float64Array | Uint32Array>(into: T | undefined, length: number, name: string): T | null {
  if (into === undefined) return null;
  if (!isA(into, name)) refuse(`an answer goes into ${shown(into)}, not into a ${name}`);
  return into.length < length ? null : into;
}

/**
 * Copies numbers from the memory of the module to an array of JavaScript: to `into` if they fit there, otherwise to a new
 * array. Returns the part of the array that contains the numbers.
 */
export function copyNumbers(address: number, length: number, into?: Float64Array): Float64Array {
  const source = f64.subarray(address >>> 3, (address >>> 3) + length);
  const room = roomIn(into, length, 'Float64Array');
  if (room === null) return source.slice();
  if (length > 0) room.set(source);
  return room.length === length ? room : room.subarray(0, length);
}

/** Does the same as {@link copyNumbers} for 32-bit unsigned integers. */
export function copyIntegers(address: number, length: number, into?: Uint32Array): Uint32Array {
  const source = u32.subarray(address >>> 2, (address >>> 2) + length);
  const room = roomIn(into, length, 'Uint32Array');
  if (room === null) return source.slice();
  if (length > 0) room.set(source);
  return room.length === length ? room : room.subarray(0, length);
}
