import { toSize } from './buffers.js';
import { refuse, shown } from './errors.js';
import { u32 } from './runtime.js';

// Numbers that may be Infinity: the module has a largest number instead.

const LARGEST_SIZE = 2 ** 32 - 1;

/** Returns a number of vertices or ticks as the module takes it. */
export function toLimit(limit: number): number {
  if (limit !== Infinity && !(Number.isInteger(limit) && limit >= 0)) {
    refuse(`${shown(limit)} is no limit: it is neither Infinity nor a whole number from 0`);
  }
  return Math.min(limit, LARGEST_SIZE);
}

/** Returns a limit of the module. */
export function fromLimit(limit: number): number {
  return limit === LARGEST_SIZE ? Infinity : limit;
}

export function getLimit(address: number): number {
  return fromLimit(u32[address >>> 2]!);
}

/** Returns a number of triangles as the module takes it. */
export function toExpansions(budget: number): bigint {
  return budget === Infinity ? 2n ** 64n - 1n : BigInt(toSize(budget));
}

/** Returns a time in nanoseconds as the module takes it. */
export function toNanoseconds(budget: number): bigint {
  if (budget === Infinity) return 2n ** 63n - 1n;
  if (Number.isSafeInteger(budget)) return BigInt.asUintN(64, BigInt(budget));
  return refuse(`a budget of ${shown(budget)} ns is not a whole number`);
}
