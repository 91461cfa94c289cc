// Calls from inside a callback: a question, a progress function, a getter of an argument.
import assert from 'node:assert/strict';
import { test } from 'node:test';

import {
  boundingBox, ItemList, moduleMemory, Path, PathSearch, PathWatch, ReplayWriter, Script, Shape, translated, trim, unload, Walkers,
  World,
} from '../../bindings/wasm/dist/index.js';
import { at, DOMAIN, makeWorld, refuses } from './support.mjs';

const QUERY = { start: at(10, 70), goal: at(50, 40) };
const FENCE = { kind: 'insert', shape: Shape.segment(at(20, 0), at(20, 90)), id: 9 };
const spiral = (count) => new Float64Array(2 * count).map((_, i) => (i * 0.618033988749895) % 100);

test('a question keeps no trace of the changes that it asks about', () => {
  const world = makeWorld();
  const watch = new PathWatch(world);
  const writer = new ReplayWriter(world);
  const search = new PathSearch();
  search.begin(world, QUERY);
  watch.add(1, world.findPath(QUERY));
  const asked = world.attempt([FENCE], (changed) => {
    for (const call of [
      () => new PathWatch(changed), () => watch.update(), () => new ReplayWriter(changed), () => writer.tick(changed),
      () => changed.clone(), () => search.begin(changed, QUERY), () => search.step(1), () => changed.insertPoint(at(1, 1)),
      () => changed.attempt([], () => 1), () => changed.rewind(1), () => changed.keepHistory(1), () => changed.shrinkToFit(),
      () => changed.dispose(), () => unload(),
    ]) {
      refuses('invalid-argument', call);
    }
    return changed.findPath(QUERY).length;
  });
  assert.ok(asked > 60 + 20);
  assert.ok(!world.isDisposed);
  assert.deepEqual(watch.update(), { blocked: [], mayBeBlocked: [], mayBeTooLong: [] });
  writer.tick(world);
  assert.doesNotMatch(writer.take(), /segment 9/);
  world.apply([FENCE]);
  assert.deepEqual(watch.update().blocked, [1]);
  world.dispose();
});

test('a question may use and dispose of all other objects, and ask about other worlds', () => {
  const [world, other] = [makeWorld(), makeWorld()];
  const path = world.findPath(QUERY);
  const value = world.attempt([FENCE], () => {
    path.dispose();
    trim();
    other.insertPoints(spiral(200000));
    const inner = other.attempt([{ kind: 'remove', id: 1 }], (changed) => changed.itemCount);
    other.dispose();
    return inner;
  });
  assert.equal(value, 200001);
  assert.ok(world.validate().isValid);
  assert.equal(world.itemCount, 2);
});

test('a question that is not a function or answers later', async () => {
  const world = makeWorld();
  refuses('invalid-argument', () => world.attempt([], null));
  refuses('invalid-argument', () => world.attempt([], async () => { throw new Error('late'); }));
  await new Promise((done) => setTimeout(done, 5));
  assert.throws(() => world.attempt([], () => { throw undefined; }), (reason) => reason === undefined);
  assert.equal(world.attempt([], () => null), null);
});

test('a progress function must not disturb the call', () => {
  const items = new ItemList();
  const points = spiral(100000);
  items.addMany('point', { points, offsets: Uint32Array.from({ length: 100001 }, (_, i) => i) });
  const expected = new World(DOMAIN);
  expected.insertPoints(points);
  const world = new World(DOMAIN);
  let reports = 0;
  const progress = () => {
    reports += 1;
    for (const call of [
      () => world.insertPoints(spiral(5)), () => world.insertPolyline([1, 1, 2, 2]), () => items.dispose(), () => world.dispose(),
      () => new World(DOMAIN), () => new Path(), () => new Walkers(3), () => trim(), () => unload(), () => moduleMemory(),
      () => boundingBox([1, 1]), () => items.add(Shape.point(at(1, 1))), () => world.itemCount, () => world.findPaths([]),
    ]) {
      refuses('invalid-argument', call);
    }
  };
  world.insertAll(items, { progress });
  assert.ok(reports > 0 && !items.isDisposed && !world.isDisposed);
  assert.equal(world.meshHash(), expected.meshHash());
  const second = new World(DOMAIN);
  second.insertPoints(points, 0, { progress });
  assert.equal(second.meshHash(), expected.meshHash());
  const loaded = World.load(expected.save(), { progress });
  assert.equal(loaded.meshHash(), expected.meshHash());
  for (const each of [items, expected, world, second, loaded]) each.dispose();
});

test('a progress function that throws does not stop the call', () => {
  const world = new World(DOMAIN);
  const progress = () => { throw new RangeError('mine'); };
  assert.throws(() => world.insertPoints(spiral(10), 0, { progress }), /mine/);
  assert.equal(world.itemCount, 10);
  assert.ok(world.validate().isValid);
});

/** Returns an object whose members are getters that make calls of the package first. */
function lively(object, act) {
  const result = Array.isArray(object) ? [] : {};
  for (const [name, value] of Object.entries(object)) {
    const inner = typeof value === 'object' && value !== null && !ArrayBuffer.isView(value) && !(value instanceof Path) ? lively(value, act) : value;
    Object.defineProperty(result, name, { enumerable: true, get: () => (act(), inner) });
  }
  return result;
}

test('arguments with getters that call the package', () => {
  const world = makeWorld({ keepBridges: true });
  const other = makeWorld({ keepBridges: true });
  const path = other.findPath(QUERY);
  const act = () => {
    other.locate(at(70, 50));
    other.insertPolyline([3, 97, 4, 98, 5, 97], 77);
    other.findPath({ start: at(90, 90), goal: at(95, 95), agent: { radius: 1 } });
    other.findPaths(spiral(2000), { algorithm: 'tra' });
    other.remove(77);
    other.ray(at(88, 88), at(89, 89));
    translated(Shape.point(at(1, 1)), 2, 2);
    path.nearest(at(33, 77));
    path.at(12);
    other.toSvg();
    trim();
  };
  const same = (call, ...given) => assert.deepEqual(call(...given.map((each) => lively(each, act))), call(...given));
  const house = { kind: 'polygon', points: [at(10, 10), at(14, 10), at(14, 14), at(11, 13)], ringSizes: [4], fill: 'nonzero' };
  const changes = [{ kind: 'insert', shape: house, id: 30 }, { kind: 'replace', id: 2, shape: house }, { kind: 'remove', id: 1 }];
  const hash = (list) => world.attempt(list, (changed) => changed.meshHash());
  same(hash, changes);
  same((list, points) => world.wouldDisconnect(list, points, { radius: 1 }), changes, [at(10, 70), at(50, 40)]);
  same((from, to) => world.ray(from, to), at(1, 1), at(90, 1));
  same((from, to) => world.ray(from, to, { radius: 1 }), at(5, 5), at(90, 5));
  same((box) => world.itemsIn(box), { min: at(30, 30), max: at(65, 65) });
  same((query) => [...world.findPath(query).points()], { ...QUERY, algorithm: 'ta', budgetExpansions: 100 });
  same((query) => world.findPath(query).pieces(), { ...QUERY, agent: { radius: 3 }, start: at(10, 60) });
  same((ends, options) => [...world.findPaths(ends, options).points().points], [10, 70, 50, 40, 1, 1, 90, 5], { algorithm: 'optimal' });
  same((query) => [...world.findPathsFrom(query).lengths()], { start: at(1, 1), goals: [at(50, 40), at(5, 5)], wantsPoints: true });
  same((query) => world.nearestFit(query), { point: at(70, 50), agent: { radius: 2 }, goal: at(1, 1) });
  same((point) => world.locate(point), at(70, 50));
  same((query) => world.widestPath(query.start, query.goal), QUERY);
  same((points) => world.isClear(points), [at(1, 1), at(2, 2), at(90, 1)]);
  same((shape) => translated(shape, 5, 6), { kind: 'segment', points: [at(1, 2), at(3, 4)] });
  same((options) => world.toSvg(null, options), { title: 'A title', width: 500, crop: { min: at(1, 1), max: at(50, 50) } });
  same((box, options) => new World(box, options).options, DOMAIN, { keepBridges: true, newVertexLimit: 5 });
  same((shapes) => [...addMany(shapes)].map(({ shape }) => [...shape.points]), { points: [1, 2, 3, 4, 5, 6], offsets: [0, 1, 3] });
  assert.ok(world.validate().isValid && other.validate().isValid);
});

function addMany(shapes) {
  const list = new ItemList();
  list.addMany('polyline', shapes);
  return list;
}

test('an argument that disposes of the object that the call is about', () => {
  for (const call of [
    (world, point) => world.insertPoint(point), (world, point) => world.locate(point), (world, point) => world.insertPolyline([point]),
    (world, point) => world.insert(Shape.segment(point, at(1, 1))), (world, point) => world.ray(at(1, 1), point),
    (world, point) => world.findPath({ start: at(1, 1), goal: point }), (world, point) => world.findPaths([point, at(2, 2)]),
    (world, point) => world.attempt([{ kind: 'insert', shape: Shape.point(point) }], () => 1),
    (world, point) => world.fitDisc(point, { radius: 1 }), (world, point) => world.isClear([at(1, 1), point]),
  ]) {
    const world = makeWorld({ keepBridges: true });
    refuses('disposed', () => call(world, { y: 3, get x() { world.dispose(); return 3; } }));
  }
});

test('a list that grows while it is read', () => {
  const list = [at(1, 1), { y: 2, get x() { for (let i = 0; i < 1000; ++i) list.push(at(i, i)); return 2; } }];
  assert.deepEqual(boundingBox(list), { min: at(1, 1), max: at(2, 2) });
  const script = new Script().parse('waywright 1\ndomain 0 0 1 1\n');
  assert.equal(script.length, 0);
});

test('the path of a walker has another answer', () => {
  const world = makeWorld();
  const path = world.findPath(QUERY);
  const walkers = new Walkers(2);
  walkers.set(0, path, 35);
  walkers.set(1, world.findPath(QUERY));
  world.findPath({ start: at(1, 1), goal: at(1, 2) }, path);
  assert.match(refuses('invalid-argument', () => walkers.advance(1)).message, /agent 0/);
  assert.equal(walkers.position(1).distance, 0);
  walkers.set(0, path);
  assert.deepEqual([...walkers.advance(0.5)].slice(0, 2), [1, 1.5]);
});

test('a wrapper behind a Proxy is disposed of once', () => {
  const world = makeWorld();
  const proxy = new Proxy(world, {});
  assert.equal(proxy.itemCount, 2);
  proxy.dispose();
  assert.ok(world.isDisposed && proxy.isDisposed);
  world.dispose();
});
