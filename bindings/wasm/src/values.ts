import { arena, copyPoint, type List, packPoints, packText, type Point } from './buffers.js';
import { refuse, shown, toNumber, toObject, WaywrightError } from './errors.js';
import * as abi from './generated/abi.js';
import { check, f64, i32, idAt, lib, scratch, textAt, u32, u64, u8 } from './runtime.js';

/** A closed box. */
export interface Box {
  readonly min: Point;
  readonly max: Point;
}

/**
 * The id of an item: 1 to 2^63 - 1. Ids up to 2^53 - 1 are numbers, larger ids are bigints. Functions accept both forms of
 * an id. In a list of the items on a wall, 0 is the border of the domain.
 */
export type ItemId = number | bigint;

function isUnsigned(value: unknown): value is number | bigint {
  return typeof value === 'bigint' ? value >= 0n && value < 2n ** 64n : Number.isSafeInteger(value) && (value as number) >= 0;
}

/** Converts an id to the type that the functions of the module take. */
export function toId(id: ItemId): bigint {
  if (isUnsigned(id)) return BigInt(id);
  throw new WaywrightError('bad-id', `${shown(id)} is not an id: ids are whole numbers from 1 to 2^63 - 1`);
}

/** Returns another number of 64 bits as the module takes it: a version, a tick or a key. */
export function toLong(value: number | bigint, what: string): bigint {
  return isUnsigned(value) ? BigInt(value) : refuse(`${shown(value)} is not a ${what}: it is not a whole number from 0 to 2^53 - 1`);
}

/** Copies ids of the module. */
export function readIds({ address, count }: List, stride = 8): ItemId[] {
  const ids = new Array<ItemId>(count);
  for (let i = 0; i < count; ++i) ids[i] = idAt(address + stride * i);
  return ids;
}

/** Copies a text into the arena, and writes its address to a struct. */
export function putText(address: number, text: Uint8Array): void {
  u32[address >>> 2] = packText(text).address;
}

/** Copies points into the arena, and writes their address and their number to a struct. */
export function putPoints(address: number, count: number, coordinates: Float64Array): void {
  const list = packPoints(coordinates);
  u32[address >>> 2] = list.address;
  u32[count >>> 2] = list.count;
}

/** Copies ids into the arena. */
export function packIds(ids: readonly bigint[]): List {
  const address = arena.take(8 * ids.length);
  u64.set(ids, address >>> 3);
  return { address, count: ids.length };
}

/** Writes a point of a caller. Reads it before: see flatten(). */
export function writePoint(address: number, point: Point): number {
  const { x, y } = copyPoint(point);
  f64[address >>> 3] = x;
  f64[(address >>> 3) + 1] = y;
  return address;
}

/** Writes two points of a caller to scratch.a and scratch.b. */
export function writeEnds(from: Point, to: Point): readonly [number, number] {
  const [a, b] = [copyPoint(from), copyPoint(to)];
  return [writePoint(scratch.a, a), writePoint(scratch.b, b)];
}

export function readPoint(address: number): Point {
  return { x: f64[address >>> 3]!, y: f64[(address >>> 3) + 1]! };
}

/** Returns a copy of a box that a caller has given. */
export function copyBox(box: Box): Box {
  const { min, max } = toObject(box, 'a box');
  return { min: copyPoint(min), max: copyPoint(max) };
}

export function writeBox(address: number, box: Box): number {
  const { min, max } = copyBox(box);
  writePoint(address, min);
  writePoint(address + 16, max);
  return address;
}

export function readBox(address: number): Box {
  return { min: readPoint(address), max: readPoint(address + 16) };
}

/** Reads the members of structs. */
export const get = {
  flag: (address: number): boolean => i32[address >>> 2] !== 0,
  int: (address: number): number => i32[address >>> 2]!,
  size: (address: number): number => u32[address >>> 2]!,
  float: (address: number): number => f64[address >>> 3]!,
  long: (address: number): number => Number(u64[address >>> 3]!),
};

/** Writes the members of structs. */
export const put = {
  flag: (address: number, value: boolean): void => void (i32[address >>> 2] = value ? 1 : 0),
  int: (address: number, value: number): void => void (i32[address >>> 2] = value),
  size: (address: number, value: number): void => void (u32[address >>> 2] = value),
  float: (address: number, value: number): void => void (f64[address >>> 3] = value),
  long: (address: number, value: bigint): void => void (u64[address >>> 3] = value),
};

const ITEMS_HASH_DIGITS = 32;

/** Returns the digits of the hash of items at an address. */
export function itemsHashAt(address: number): string {
  check(lib.ww_items_hash_text(address, scratch.hash, ITEMS_HASH_DIGITS + 1, 0));
  return textAt(scratch.hash, ITEMS_HASH_DIGITS);
}

/** Prepares a struct for an answer. */
export function answer(struct: { readonly size_: number }, address = scratch.struct): number {
  u32[address >>> 2] = struct.size_;
  return address;
}

/** Returns the number of an enumerator, or throws. */
export function toEnum<T extends string>(names: readonly T[], name: T): number {
  const index = names.indexOf(name);
  return index >= 0 ? index : refuse(`${shown(name)} is none of ${names.join(', ')}`);
}

/** Returns the name of an enumerator. */
export function fromEnum<T extends string>(names: readonly T[], index: number): T {
  return names[index] ?? refuse(`the module has answered ${index}, which is none of ${names.join(', ')}`);
}

/** Makes a call that writes a number or a truth value to an address. */
export function askFlag(call: (address: number) => number): boolean {
  check(call(scratch.flag));
  return i32[scratch.flag >>> 2] !== 0;
}
export function askSize(call: (address: number) => number): number {
  check(call(scratch.count));
  return u32[scratch.count >>> 2]!;
}
export function askFloat(call: (address: number) => number): number {
  check(call(scratch.a));
  return f64[scratch.a >>> 3]!;
}
export function askLong(call: (address: number) => number): number {
  check(call(scratch.id));
  return Number(u64[scratch.id >>> 3]!);
}
export function askId(call: (address: number) => number): ItemId {
  check(call(scratch.id));
  return idAt(scratch.id);
}

/** Makes a call that writes to a text object, calls `read` with the bytes, and returns its result. */
function askBytes<T>(call: (text: number) => number, read: (address: number, size: number) => T): T {
  check(lib.ww_text_create(scratch.pointer));
  const text = u32[scratch.pointer >>> 2]!;
  try {
    check(call(text));
    return readBytes(text, read);
  } finally {
    lib.ww_text_destroy(text);
  }
}

/** Calls `read` with the bytes of a text object, and returns its result. */
export function readBytes<T>(text: number, read: (address: number, size: number) => T): T {
  check(lib.ww_text_bytes(text, scratch.pointer, scratch.count));
  return read(u32[scratch.pointer >>> 2]!, u32[scratch.count >>> 2]!);
}

/** Makes a call that writes to a text object, and returns the text, or a copy of the bytes. */
export function askText(call: (text: number) => number): string {
  return askBytes(call, textAt);
}
export function askCopy(call: (text: number) => number): Uint8Array {
  return askBytes(call, (address, size) => u8.slice(address, address + size));
}

/** The magnitudes of the coordinates that a world accepts, besides 0. */
export const LARGEST_COORDINATE = 2 ** 100;
export const SMALLEST_COORDINATE = 2 ** -100;

/** Returns whether a world accepts a coordinate. */
export function isInRange(coordinate: number): boolean {
  return lib.ww_is_in_range(toNumber(coordinate, 'a coordinate')) !== 0;
}

/** The version of the library: `0.1.0`. */
export function version(): string {
  const number = lib.ww_version_number();
  return `${Math.floor(number / 10000)}.${Math.floor(number / 100) % 100}.${number % 100}`;
}

/** How many calls of one predicate each stage of the arithmetic has decided. */
export interface StageCounts {
  readonly doubles: number;
  readonly lattice: number;
  readonly integers: number;
}
export interface PredicateCounts {
  readonly orientation: StageCounts;
  readonly inCircle: StageCounts;
  readonly order: StageCounts;
  readonly crossing: StageCounts;
}

/** Returns the counts since the module was loaded. */
export function predicateCounts(): PredicateCounts {
  const { ww_predicate_counts: layout, ww_stage_counts: stage } = abi;
  const struct = answer(layout);
  check(lib.ww_get_predicate_counts(struct));
  const stages = (address: number): StageCounts => ({
    doubles: get.long(address + stage.doubles),
    lattice: get.long(address + stage.lattice),
    integers: get.long(address + stage.integers),
  });
  return {
    orientation: stages(struct + layout.orientation),
    inCircle: stages(struct + layout.inCircle),
    order: stages(struct + layout.order),
    crossing: stages(struct + layout.crossing),
  };
}
