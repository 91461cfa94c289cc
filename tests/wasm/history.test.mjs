// Going back, trying out, limits, saving, path watches and replay logs.
import assert from 'node:assert/strict';
import { test } from 'node:test';

import {
  findDifference, isInRange, isSavedWorld, LARGEST_COORDINATE, PathWatch, replay, ReplayWriter, Scene, Script, Shape, World,
} from '../../bindings/wasm/dist/index.js';
import { at, DOMAIN, makeWorld, refuses, usedBytes } from './support.mjs';

const WALL = { kind: 'insert', shape: Shape.segment(at(0, 80), at(45, 80)), id: 9 };
const FENCE = { kind: 'insert', shape: Shape.segment(at(40, 70), at(40, 100)), id: 8 };

test('going back to a tick', () => {
  const world = makeWorld();
  refuses('no-history', () => world.mark());
  world.keepHistory(3);
  const hash = world.meshHash();
  assert.equal(world.mark(), 1);
  world.remove(1);
  assert.equal(world.mark(), 2);
  world.rewind(1);
  assert.equal(world.meshHash(), hash);
  refuses('unknown-tick', () => world.rewind(7));
  for (let i = 0; i < 5; ++i) world.mark();
  refuses('old-tick', () => world.rewind(1));
  assert.ok(world.memory().history > 0);
});

test('trying changes out', () => {
  const world = makeWorld();
  const before = [world.version, world.meshHash()];
  const query = { start: at(10, 10), goal: at(50, 10) };
  assert.equal(world.findPath(query).status, 'found');
  assert.equal(world.attempt([FENCE], (changed) => changed.findPath(query).status), 'no-path');
  assert.ok(world.wouldDisconnect([FENCE], [query.start, query.goal]));
  assert.ok(!world.wouldDisconnect([WALL], [10, 10, 50, 10]));
  assert.throws(() => world.attempt([FENCE], () => { throw new RangeError('mine'); }), /mine/);
  refuses('invalid-argument', () => world.attempt([FENCE], (changed) => changed.remove(1)));
  refuses('unknown-id', () => world.attempt([{ kind: 'remove', id: 5 }], () => 1));
  assert.equal(world.attempt([], () => undefined), undefined);
  assert.deepEqual([world.version, world.meshHash()].slice(1), before.slice(1));
  assert.equal(world.findPath(query).status, 'found');
});

test('limits and ids', () => {
  const world = makeWorld({ newVertexLimit: 10 });
  assert.deepEqual(world.options, { keepAbstraction: true, keepBridges: false, newVertexLimit: 10 });
  refuses('too-many-vertices', () => world.insertPoints(new Float64Array(40).map((_, i) => 1 + i)));
  world.newVertexLimit = Infinity;
  assert.equal(world.newVertexLimit, Infinity);
  world.insertPoints(new Float64Array(40).map((_, i) => 1 + i));
  assert.equal(world.largestIdSeen, 22);
  world.reserveIds(100);
  assert.equal(world.insertPoint(at(1, 1)), 101);
  assert.ok(isInRange(1) && isInRange(LARGEST_COORDINATE) && !isInRange(2 * LARGEST_COORDINATE) && !isInRange(NaN));
});

test('a clone is independent', () => {
  const world = makeWorld();
  const clone = world.clone();
  assert.equal(clone.meshHash(), world.meshHash());
  clone.remove(1);
  assert.ok(world.contains(1));
  world.dispose();
  assert.deepEqual(clone.itemIds(), [2]);
});

test('saving and loading', () => {
  const world = makeWorld({ keepBridges: true });
  const bytes = world.save();
  assert.ok(isSavedWorld(bytes) && !isSavedWorld(new Uint8Array([1, 2, 3])));
  const seen = [];
  const loaded = World.load(bytes, { progress: (done, total) => seen.push([done, total]) });
  assert.equal(loaded.meshHash(), world.meshHash());
  assert.equal(loaded.options.keepBridges, true);
  assert.ok(seen.length > 0 && seen.at(-1)[0] === seen.at(-1)[1]);
  assert.deepEqual([...new Scene().parseSavedWorld(bytes).items].map(({ id }) => id), [1, 2]);
  for (let i = 0; i < bytes.length; ++i) {
    const broken = bytes.slice();
    broken[i] ^= 0x55;
    assert.throws(() => World.load(broken), { name: 'WaywrightError' });
    assert.throws(() => World.load(bytes.subarray(0, i)), { name: 'WaywrightError', code: 'malformed' });
  }
  const load = () => refuses('malformed', () => World.load(new Uint8Array(1e5)));
  load();
  for (let i = 0; i < 5; ++i) load();
  const before = usedBytes();
  for (let i = 0; i < 100; ++i) load();
  assert.ok(usedBytes() - before < 10000);
});

test('the regions that changed', () => {
  const world = makeWorld();
  const { version } = world;
  world.remove(2);
  const [change] = world.changesSince(version);
  assert.deepEqual(change, {
    version: version + 1, box: { min: at(60, 40), max: at(80, 60) }, isInsertion: false, isRemoval: true,
  });
  assert.deepEqual(world.changesSince(world.version), []);
  for (let i = 0; i < 5000; ++i) world.replace(1, Shape.segment(at(40, 0), at(40, 70 + (i % 2))));
  assert.equal(world.changesSince(version), null);
});

test('a path watch', () => {
  const world = makeWorld();
  const watch = new PathWatch(world);
  watch.add(7, world.findPath({ start: at(10, 70), goal: at(50, 40) }));
  watch.add(2n ** 60n, world.findPath({ start: at(90, 90), goal: at(90, 95) }));
  assert.deepEqual([watch.size, watch.contains(7), watch.contains(8)], [2, true, false]);
  assert.deepEqual(watch.update(), { blocked: [], mayBeBlocked: [], mayBeTooLong: [] });
  world.insertSegment(at(20, 60), at(20, 80));
  assert.deepEqual(watch.update().blocked, [7]);
  world.insertSegment(at(85, 92), at(95, 92));
  assert.deepEqual(watch.update().blocked, [2n ** 60n]);
  world.remove(1);
  assert.deepEqual(watch.update().mayBeTooLong, [7]);
  assert.ok(watch.remove(7) && !watch.remove(7));
  watch.dispose();
  refuses('disposed', () => watch.update());
});

test('a replay log', () => {
  const world = makeWorld();
  const writer = new ReplayWriter(world, 2);
  const changes = [{ kind: 'insert', shape: Shape.point(at(3, 3)) }, { kind: 'remove', id: 1 }];
  writer.record(changes, world.apply(changes));
  for (let i = 0; i < 4; ++i) writer.tick(world);
  assert.equal(writer.lastTick, 4);
  let text = writer.take();
  assert.equal(writer.take(), '');
  world.insertPoint(at(5, 5), 50);
  writer.record([{ kind: 'insert', shape: Shape.point(at(5, 5)), id: 50 }]);
  writer.tick(world);
  writer.tick(world);
  text += writer.take();
  refuses('bad-id', () => writer.record(changes));
  const log = new Script().parse(text);
  const same = replay(log, { progress: () => undefined });
  assert.deepEqual([same.isSame, same.ticks, same.refusal], [true, 6, null]);
  const other = new Script().parse(text.replace(/^point 50 5 5$/m, 'point 50 5 6'));
  const different = replay(other);
  assert.deepEqual([different.isSame, different.tick, different.changed], [false, 6, [50]]);
  assert.notEqual(different.expected, different.computed);
  const refused = replay(new Script().parse(text.replace(/^point 50 5 5$/m, 'remove 77')));
  assert.deepEqual([refused.isSame, refused.refusal.code, refused.refusal.item], [false, 'unknown-id', 77]);
  assert.equal(findDifference(log, log), null);
  const difference = findDifference(log, other);
  assert.deepEqual([difference.kind, difference.item, difference.otherItem], ['change', 50, 50]);
  assert.equal(log.line(log.length - 1).kind, 'tick');
  assert.match(log.line(log.length - 1).itemsHash, /^[0-9a-f]{32}$/);
  writer.dispose();
});
