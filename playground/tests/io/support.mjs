// What the tests of src/io share.
import assert from 'node:assert/strict';
import { register } from 'node:module';

register('./typescript_hooks.mjs', import.meta.url);

export const { parseFile } = await import('../../src/io/formats.ts');
export const { decodeShare, encodeShare } = await import('../../src/io/share.ts');
export const { numberText, operationsOf, writeWws } = await import('../../src/io/wws.ts');
export const { InputError } = await import('../../src/io/types.ts');
export const { firstSyntaxError } = await import('../../src/io/json_place.ts');
export const items = await import('../../src/io/items.ts');

const encoder = new TextEncoder();

export const bytesOf = (text) => encoder.encode(text);
export const parse = (name, text) => parseFile(name, bytesOf(text));

/** A generator of random numbers that is the same on every machine: mulberry32. */
export class Random {
  constructor(seed) {
    this.state = seed;
  }

  /** A whole number from 0 to 2^32 - 1. */
  bits() {
    this.state = (this.state + 0x6d2b79f5) | 0;
    let t = this.state;
    t = Math.imul(t ^ (t >>> 15), t | 1);
    t ^= t + Math.imul(t ^ (t >>> 7), t | 61);
    return (t ^ (t >>> 14)) >>> 0;
  }

  /** A whole number from 0 to count - 1. */
  below(count) {
    return this.bits() % count;
  }

  pick(values) {
    return values[this.below(values.length)];
  }

  /** A double with random bits that a world accepts as a coordinate. */
  coordinate() {
    const view = new DataView(new ArrayBuffer(8));
    view.setUint32(0, this.bits());
    view.setUint32(4, this.bits());
    const exponent = 1023 - 99 + this.below(198);
    view.setUint16(0, (view.getUint16(0) & 0x800f) | (exponent << 4));
    return this.pick([view.getFloat64(0), view.getFloat64(0), this.below(1000) / 8, this.below(1000) / 100, 0, -0]);
  }
}

/** Fails unless the call throws an InputError that says what, where and what to do. Returns the error. */
export async function refuses(call, pattern, where = {}) {
  let thrown = null;
  try {
    await call();
  } catch (error) {
    thrown = error;
  }
  assert.ok(thrown instanceof InputError, `thrown: ${thrown?.stack}`);
  assert.match(thrown.message, pattern);
  assert.deepEqual(thrown.where, where, thrown.message);
  assert.ok(thrown.what.length > 10 && thrown.advice.length > 10, thrown.message);
  return thrown;
}
