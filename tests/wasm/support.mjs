// What the tests of the package share.
import assert from 'node:assert/strict';

import { init, moduleMemory, trim, WaywrightError, World } from '../../bindings/wasm/dist/index.js';

await init();

export const DOMAIN = { min: { x: 0, y: 0 }, max: { x: 100, y: 100 } };
export const at = (x, y) => ({ x, y });

/** A world of 100 x 100 with a wall from (40, 0) to (40, 70), and a square obstacle around (70, 50). */
export function makeWorld(options) {
  const world = new World(DOMAIN, options);
  world.insertSegment(at(40, 0), at(40, 70), 1);
  world.insertPolygon([60, 40, 80, 40, 80, 60, 60, 60], 2);
  return world;
}

/** Fails unless the call throws a WaywrightError with this code. Returns the error. */
export function refuses(code, call) {
  let thrown = null;
  try {
    call();
  } catch (error) {
    thrown = error;
  }
  assert.ok(thrown instanceof WaywrightError, `thrown: ${thrown}`);
  assert.equal(thrown.code, code, thrown.message);
  assert.ok(thrown.message.length > 0);
  return thrown;
}

/** Returns how many bytes of the module are in use, without the memory that the package keeps for the next calls. */
export function usedBytes() {
  trim();
  return moduleMemory().used;
}
