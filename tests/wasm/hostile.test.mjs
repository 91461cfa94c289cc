// Hostile input: every refused call throws a WaywrightError, changes nothing, and leaves all objects usable.
import assert from 'node:assert/strict';
import { after, test } from 'node:test';

import { ItemList, Path, Paths, PathSearch, Script, Shape, World } from '../../bindings/wasm/dist/index.js';
import { at, DOMAIN, makeWorld, refuses } from './support.mjs';

const world = makeWorld({ keepBridges: true });
const state = () => [world.version, world.itemsHash(), world.meshHash()];
const before = state();
after(() => {
  assert.deepEqual(state(), before);
  assert.ok(world.validate().isValid);
});

test('coordinates that no world accepts', () => {
  for (const bad of [NaN, Infinity, -Infinity, 2 ** 101, 2 ** -101]) {
    refuses('coordinate-range', () => world.insertPoint(at(bad, 1)));
    refuses('coordinate-range', () => world.insertPolygon([1, 1, 2, 2, 3, bad]));
    refuses('coordinate-range', () => world.insertPolyline(new Float64Array([1, 1, Number(bad), 2])));
    refuses('coordinate-range', () => world.findPath({ start: at(1, bad), goal: at(1, 1) }));
    refuses('coordinate-range', () => world.locate(at(bad, bad)));
  }
  const error = refuses('out-of-domain', () => world.insertPolyline([1, 1, 2, 2, 300, 3]));
  assert.equal(error.index, 2);
  refuses('out-of-domain', () => world.ray(at(1, 1), at(1, -1)));
  refuses('bad-radius', () => world.fitDisc(at(1, 1), { radius: -1 }));
  refuses('bad-radius', () => world.findPath({ start: at(1, 1), goal: at(2, 2), agent: { radius: NaN } }));
  refuses('bad-distance', () => world.findPath({ start: at(1, 1), goal: at(2, 2), endTolerance: -1 }));
  refuses('bad-domain', () => new World({ min: at(1, 1), max: at(1, 2) }));
  refuses('coordinate-range', () => new World({ min: at(NaN, 1), max: at(1, 2) }));
});

test('lists of wrong lengths and kinds', () => {
  refuses('invalid-argument', () => world.insertPolyline([1, 2, 3]));
  refuses('invalid-argument', () => world.findPaths([1, 1]));
  refuses('invalid-argument', () => world.insertPolyline([at(1, 1), undefined, at(2, 2)]));
  refuses('invalid-argument', () => world.insert({ kind: 'circle', points: [1, 1] }));
  refuses('invalid-argument', () => world.insert({ kind: 'segment', points: [1, 1, 2, 2], ringSizes: [3] }));
  refuses('invalid-argument', () => world.insert({ kind: 'polygon', points: [1, 1, 2, 2, 3, 1], ringSizes: [2, -1, 2] }));
  refuses('invalid-argument', () => world.insert({ kind: 'polygon', points: [1, 1, 2, 2, 3, 1], ringSizes: [2 ** 32, 3] }));
  refuses('bad-shape', () => world.insertPolygon([]));
  refuses('bad-shape', () => world.insert({ kind: 'polygon', points: [], ringSizes: [] }));
  assert.equal(Shape.regularPolygon(at(0, 0), 1, 2).points.length, 0);
  refuses('bad-shape', () => world.insert(Shape.regularPolygon(at(0, 0), 1, 2)));
  refuses('invalid-argument', () => new ItemList().addMany('polygon', { points: new Float64Array(6), offsets: [0, 4] }));
  refuses('invalid-argument', () => new ItemList().addMany('polygon', { points: new Float64Array(6), offsets: [2, 1] }));
  refuses('invalid-argument', () => world.apply([{ kind: 'move', id: 1 }]));
  const empty = new World(DOMAIN);
  assert.deepEqual(empty.apply([]), []);
  assert.deepEqual(empty.insertAll([]), []);
  assert.equal(world.findPaths([]).length, 0);
});

test('ids and indices that are none', () => {
  for (const bad of [-1, 1.5, NaN, Infinity, 2 ** 60, -1n, 2n ** 64n, '1', null, {}]) {
    refuses('bad-id', () => world.insertPoint(at(1, 1), bad));
    refuses('bad-id', () => world.contains(bad));
  }
  refuses('bad-id', () => world.insertPoint(at(1, 1), 2n ** 63n));
  refuses('id-in-use', () => world.insertPoint(at(1, 1), 2));
  assert.equal(refuses('unknown-id', () => world.remove(77)).item, 77);
  for (const index of [-1, 0, 1.5, NaN, 2 ** 40]) {
    refuses('invalid-argument', () => new ItemList().info(index));
    refuses('invalid-argument', () => new Paths().get(index));
    refuses('invalid-argument', () => new Script().line(index));
  }
});

test('objects in states that a call does not expect', () => {
  refuses('invalid-argument', () => new Path().at(1));
  refuses('invalid-argument', () => world.findPath({ start: at(1, 1), goal: at(2, 2), algorithm: 'best' }));
  refuses('invalid-argument', () => world.findPath({ start: at(1, 1), goal: at(2, 2), algorithm: 'ta', budgetExpansions: -1 }));
  refuses('not-supported', () => makeWorld({ keepAbstraction: false }).findPath({ start: at(1, 1), goal: at(2, 2), algorithm: 'tra' }));
  const path = world.findPath({ start: at(1, 1), goal: at(2, 2) });
  const position = path.at(0);
  position.segment = 1e6;
  refuses('invalid-argument', () => path.advance(position, 1));
  const search = new PathSearch();
  assert.equal(search.isRunning, false);
  assert.equal(search.path.length, 0);
  refuses('malformed', () => new Script().parse('\0\0\0'));
});

test('a trap leaves the module usable', () => {
  // Deep in the stack of JavaScript, the module has too little stack.
  const dive = (depth, call) => (depth === 0 ? call() : dive(depth - 1, call));
  const works = (depth) => {
    try {
      return dive(depth, () => true);
    } catch {
      return false;
    }
  };
  let deepest = 1000;
  while (works(deepest + 100)) deepest += 100;
  const other = makeWorld();
  let stopped = 0;
  for (let i = 0; i < 2000; ++i) {
    try {
      dive(deepest - (i % 2000), () => other.validate());
    } catch (error) {
      assert.ok(error instanceof RangeError || error.code === 'internal-error', String(error));
      stopped += 1;
    }
  }
  assert.ok(stopped > 0);
  for (let i = 0; i < 100; ++i) {
    const next = makeWorld();
    assert.equal(next.findPath({ start: at(1, 1), goal: at(1, 5) }).length, 4);
    next.dispose();
  }
  other.dispose();
  assert.deepEqual(state(), before);
});
