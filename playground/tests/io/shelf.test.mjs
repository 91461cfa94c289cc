// The examples: the engine loads them, and they are what their lines say.
import assert from 'node:assert/strict';
import test from 'node:test';

import { carryOut, makeWorld } from './engine.mjs';
import { decodeShare, encodeShare, items, operationsOf, parse, writeWws } from './support.mjs';

const { examples } = await import('../../src/io/shelf.ts');
const load = (id) => examples.find((example) => example.id === id).load();
const at = ([x, y]) => ({ x, y });

test('the examples have different names and a line each', () => {
  assert.equal(new Set(examples.map(({ id }) => id)).size, examples.length);
  for (const { id, title, line } of examples) {
    assert.match(id, /^[a-z-]+$/);
    assert.ok(title.length > 3 && line.endsWith('.') && line.length < 125, id);
  }
});

for (const { id, load: make } of examples) {
  test(`the engine loads the example ${id}`, () => {
    const example = make();
    assert.deepEqual(make(), example, 'the example is the same each time');
    const world = makeWorld(example.domain, { keepBridges: true });
    carryOut(world, operationsOf(example));
    assert.deepEqual(world.validate(), { isValid: true, fault: '' });
    assert.deepEqual(world.itemIds(), example.ids ?? example.items.map((_, i) => i + 1));
    const path = world.findPath({ start: at(example.start), goal: at(example.goal), agent: { radius: example.radius ?? 0 } });
    assert.equal(path.status, 'found');
    assert.deepEqual([path.info.movedStart, path.info.movedGoal], [null, null]);
    path.dispose();
    world.dispose();
  });

  test(`the example ${id} survives a script and a link`, async () => {
    const example = make();
    const { domain, start, goal } = example;
    const operations = operationsOf(example);
    const read = parse('a.wws', writeWws(domain, operations));
    assert.deepEqual(read.operations, operations);
    assert.deepEqual(read.items, example.items);
    assert.deepEqual(read.domain, domain);
    assert.equal(read.refused, undefined);
    const state = { domain, operations, start, goal, radius: 1, algorithm: 'optimal', view: null };
    assert.deepStrictEqual(await decodeShare(await encodeShare(state)), state);
  });
}

test('a disc takes the gap of exactly 2r, and no other', () => {
  const { domain, items: walls, start, goal, radius } = load('gaps');
  const world = makeWorld(domain, { keepBridges: true });
  carryOut(world, operationsOf({ items: walls }));
  const query = { start: at(start), goal: at(goal), agent: { radius } };
  const path = world.findPath(query);
  assert.ok(path.length > 12, 'the path makes a detour around the lower gap');
  // The largest double below 1 is half of the lower gap. So a disc with this radius takes the lower gap.
  assert.equal(world.findPath({ ...query, agent: { radius: 1 - 2 ** -53 } }).length, 10);
  world.insertSegment({ x: 0, y: 4 }, { x: 0, y: 6 });
  assert.equal(world.findPath(query, path).status, 'no-path');
  world.dispose();
});

test('the points of the example circle are on a circle', () => {
  const points = load('circle').items.map(({ xy: [x, y] }) => [BigInt(x), BigInt(y)]);
  assert.equal(new Set(points.map(String)).size, 324);
  for (const [x, y] of points) assert.equal(x * x + y * y, 32045n ** 2n);
});

test('the labyrinth connects every cell', () => {
  const { domain, items: walls, start } = load('labyrinth');
  const world = makeWorld(domain);
  carryOut(world, operationsOf({ items: walls }));
  for (let x = 5; x < domain[2]; x += 10) {
    for (let y = 5; y < domain[3]; y += 10) {
      const path = world.findPath({ start: at(start), goal: { x, y } });
      assert.equal(path.status, 'found', `${x}, ${y}`);
      path.dispose();
    }
  }
  world.dispose();
});

test('the items of the city and the squares do not touch each other', () => {
  for (const id of ['city', 'squares']) {
    const example = load(id);
    const world = makeWorld(example.domain);
    carryOut(world, operationsOf(example));
    const corners = new Set(example.items.flatMap((item) => items.ringsOf(item).flat().map(String)));
    const count = example.items.reduce((sum, item) => sum + items.ringsOf(item).flat().length, 0);
    assert.equal(corners.size, count, `${id}: no two items share a corner`);
    assert.equal(world.vertexCount, count + 4, `${id}: no two sides cross`);
    world.dispose();
  }
});
