// Arguments of wrong types: each is refused with a WaywrightError before the call does anything.
import assert from 'node:assert/strict';
import { after, test } from 'node:test';

import {
  boundingBox, centroid, findDifference, isInRange, isSavedWorld, ItemList, Mesh, Path, Paths, PathSearch, PathWatch,
  QueryContext, replay, ReplayWriter, Scene, sceneFormat, Script, Shape, svgFrame, SvgOverlay, svgToWorld, translated, Walkers,
  WaywrightError, World,
} from '../../bindings/wasm/dist/index.js';
import { at, DOMAIN, makeWorld, refuses } from './support.mjs';

const QUERY = { start: at(10, 70), goal: at(50, 40) };
const world = makeWorld({ keepBridges: true });
const state = () => [world.version, world.itemsHash(), world.meshHash()];
const before = state();
after(() => assert.deepEqual(state(), before));

const NO_NUMBERS = [undefined, null, '1', true, 5n, Symbol('5'), {}, [], () => 1, { valueOf: () => 1 }, Object.create(null)];

test('only numbers are coordinates', () => {
  for (const bad of NO_NUMBERS) {
    for (const call of [
      () => world.insertPoint(at(bad, 1)), () => world.insertPoint(at(1, bad)), () => world.insertSegment(at(1, 1), at(bad, 2)),
      () => world.insertPolyline([1, 1, 2, bad]), () => world.insertPolygon([at(1, 1), at(2, bad), at(3, 3)]),
      () => world.insertPolyline([at(1, 1), bad]), () => world.locate(at(bad, 1)), () => world.ray(at(1, 1), at(1, bad)),
      () => world.findPath({ start: at(bad, 1), goal: at(1, 1) }), () => world.findPaths([1, 1, 2, bad]),
      () => world.itemsIn({ min: at(1, 1), max: at(2, bad) }), () => new World({ min: at(0, bad), max: at(1, 1) }),
      () => world.isClear([1, 1, bad, 2]), () => boundingBox([bad, 1]), () => centroid({ kind: 'point', points: [at(bad, 1)] }),
      () => isInRange(bad), () => Shape.rectangle({ min: at(bad, 0), max: at(1, 1) }), () => Shape.polygon([[0, 0, 1, bad]]),
      () => world.findPathsFrom({ start: at(1, bad), goals: [1, 1] }), () => world.nearestFit({ point: at(bad, 1) }),
      () => new SvgOverlay().addDisc(at(1, bad), 1), () => svgFrame({ min: at(0, 0), max: at(1, bad) }),
    ]) {
      refuses('invalid-argument', call);
    }
  }
});

test('only numbers are radii, lengths and tolerances', () => {
  const path = world.findPath(QUERY);
  const walkers = new Walkers(1);
  for (const bad of NO_NUMBERS.slice(1)) {
    for (const call of [
      () => world.fitDisc(at(1, 1), { radius: bad }), () => world.ray(at(1, 1), at(2, 2), { radius: bad }),
      () => world.findPath({ ...QUERY, agent: { radius: bad } }), () => world.findPath({ ...QUERY, endTolerance: bad }),
      () => world.findPath({ ...QUERY, budgetExpansions: bad }), () => world.findPath({ ...QUERY, budgetNanoseconds: bad }),
      () => world.findPaths([1, 1, 2, 2], { agent: { radius: bad } }), () => world.nearestFit({ point: at(1, 1), limit: bad }),
      () => world.findPathsFrom({ start: at(1, 1), goals: [2, 2], agent: { radius: bad } }), () => world.wouldDisconnect([], [], { radius: bad }),
      () => path.at(bad), () => path.advance(path.at(0), bad), () => path.polyline(bad), () => walkers.set(0, path, bad),
      () => walkers.advance(bad), () => Shape.regularPolygon(at(1, 1), bad, 3), () => Shape.regularPolygon(at(1, 1), 1, bad),
      () => translated(Shape.point(at(1, 1)), bad, 1), () => new SvgOverlay().addPolyline([1, 1], bad),
      () => new SvgOverlay().addLabel(at(1, 1), 'text', 1, bad), () => world.toSvg(null, { width: bad }),
      () => new World(DOMAIN, { newVertexLimit: bad }), () => world.keepHistory(bad), () => new Walkers(bad),
      () => new ReplayWriter(world, bad), () => new PathSearch().step(bad),
    ]) {
      refuses('invalid-argument', call);
    }
  }
  for (const call of [
    () => path.at(NaN), () => path.advance(path.at(0), NaN), () => walkers.advance(NaN), () => walkers.set(0, path, NaN),
    () => path.polyline(NaN), () => path.advance({ ...path.at(0), distance: NaN }, 1),
  ]) {
    refuses('bad-distance', call);
  }
  for (const bad of [NaN, Infinity, 2 ** 101]) refuses('coordinate-range', () => path.nearest(at(bad, 1)));
  for (const segment of [-1, 0.5, NaN, null, '0', 2 ** 32]) {
    refuses('invalid-argument', () => path.advance({ ...path.at(0), segment }, 1));
  }
  assert.equal(path.at(-0).distance, 0);
  assert.equal(path.at(Infinity).distance, path.length);
  assert.equal(path.at(-Infinity).distance, 0);
});

test('only true and false are flags', () => {
  for (const bad of [null, 0, 1, 'no', {}]) {
    refuses('invalid-argument', () => new World(DOMAIN, { keepBridges: bad }));
    refuses('invalid-argument', () => new World(DOMAIN, { keepAbstraction: bad }));
    refuses('invalid-argument', () => world.findPath({ ...QUERY, wantsChannel: bad }));
    refuses('invalid-argument', () => world.findPathsFrom({ start: at(1, 1), goals: [2, 2], wantsPoints: bad }));
    refuses('invalid-argument', () => world.toSvg(null, { mesh: bad }));
  }
});

test('a message names what is wrong, and not the inside of the package', () => {
  const text = (code, call) => refuses(code, call).message;
  assert.match(text('invalid-argument', () => world.insertPoint({ x: null, y: 1 })), /x of a point is null/);
  assert.match(text('invalid-argument', () => world.insertPoint(null)), /a point is null/);
  assert.match(text('invalid-argument', () => world.findPath()), /query is undefined/);
  assert.match(text('invalid-argument', () => world.isClear(new Map())), /class Map/);
  assert.match(text('invalid-argument', () => world.changesSince(1.5)), /1.5 is not a version/);
  assert.match(text('invalid-argument', () => world.rewind('1')), /'1' is not a tick/);
  assert.match(text('no-history', () => world.rewind(1)), /keepHistory\(\)/);
  assert.match(text('no-history', () => world.mark()), /keepHistory\(\)/);
  assert.match(text('invalid-argument', () => new PathWatch(world).add(NaN, new Path())), /NaN is not a key/);
  assert.match(text('invalid-argument', () => world.findPath(QUERY, world)), /class World.*Path/);
  const inside = text('invalid-argument', () => world.attempt([], (changed) => changed.remove(1)));
  assert.match(inside, /trying changes out/);
  assert.doesNotMatch(inside, /ww_/);
});

test('an object of another class', () => {
  const search = new PathSearch();
  for (const bad of [null, 0, 8, {}, { address: 8 }, new Mesh(), 'path', []]) {
    for (const call of [
      () => world.findPath(QUERY, bad), () => world.findPaths([1, 1, 2, 2], {}, bad), () => world.items(bad),
      () => world.locate(at(1, 1), bad ?? 0), () => world.snapshot(bad instanceof Mesh ? new Path() : bad),
      () => search.begin(bad, QUERY), () => new PathWatch(bad), () => new PathWatch(world).add(1, bad),
      () => new ReplayWriter(bad), () => new ReplayWriter(world).tick(bad), () => replay(bad),
      () => findDifference(bad, new Script()), () => new Script().scene(bad), () => new Script().item(0, bad),
      () => new Scene().set(DOMAIN, bad), () => new SvgOverlay().addPath(bad), () => world.findAffected([bad], 0),
      () => new Path().copy(bad), () => world.toSvg(bad ?? 0),
    ]) {
      refuses('invalid-argument', call);
    }
  }
  for (const bad of [8, 100, '0 0 1 1', null, [0, 0, 1, 1]]) refuses('invalid-argument', () => new World(bad));
  refuses('invalid-argument', () => new ItemList(8));
  refuses('invalid-argument', () => new ItemList([null]));
  assert.equal(new Path(8, world).length, 0);
});

test('an answer that belongs to another object is never overwritten', () => {
  const search = new PathSearch();
  search.begin(world, QUERY);
  while (!search.step(100));
  const paths = world.findPaths([1, 1, 1, 5]);
  const scene = new Scene().set(DOMAIN, new ItemList([{ id: 5, shape: Shape.point(at(1, 1)) }]));
  for (const call of [
    () => world.findPath(QUERY, search.path), () => world.findPath(QUERY, paths.get(0)), () => new Path().copy(paths.get(0)),
    () => world.items(scene.items), () => scene.items.clear(), () => scene.items.add(Shape.point(at(2, 2))),
    () => scene.items.addMany('point', { points: new Float64Array(2), offsets: [0, 1] }),
  ]) {
    assert.match(refuses('invalid-argument', call).message, /belongs to a (PathSearch|Paths|Scene)/);
  }
  assert.deepEqual([scene.items.length, paths.lengths()[0]], [1, 4]);
  assert.ok(search.path.length > 50);
});

test('arrays of other classes', () => {
  const line = [1, 1, 2, 2];
  for (const same of [
    line, new Float64Array(line), new Float32Array(line), new Uint8Array(line), [at(1, 1), at(2, 2)],
    new Float64Array(new SharedArrayBuffer(32)).map((_, i) => line[i]), Object.assign(new Float64Array(new SharedArrayBuffer(32)), line),
    { length: 4, ...line }, new Float64Array([0, ...line]).subarray(1),
  ]) {
    assert.equal(world.isClear(same), true);
    assert.deepEqual(boundingBox(same), { min: at(1, 1), max: at(2, 2) });
  }
  for (const bad of [
    new BigInt64Array(4), new DataView(new ArrayBuffer(32)), new ArrayBuffer(32), '1122', new Map(), new Set(line), 5,
    [1, 1, , 2], [at(1, 1), 2, 3], [1, at(1, 1)], [[1, 1], [2, 2]], { length: -2 }, { length: 2.5 }, { length: '4' },
    new Float64Array(3), null, undefined,
  ]) {
    refuses('invalid-argument', () => world.isClear(bad));
  }
  const detached = new Float64Array(line);
  structuredClone(detached, { transfer: [detached.buffer] });
  refuses('bad-shape', () => world.insertPolyline(detached));
  refuses('invalid-argument', () => Shape.polygon([[0, 0], [4, 0], [4, 4]]));
  assert.equal(Shape.polygon([[at(0, 0)], [at(4, 0)]]).ringSizes.length, 2);
  refuses('invalid-argument', () => world.insert({ kind: 'polygon', points: [1, 1, 2, 2, 3, 1], ringSizes: 3 }));
});

test('arrays for answers', () => {
  const path = world.findPath(QUERY);
  for (const bad of [null, [], new Float32Array(64), new ArrayBuffer(512), new Uint32Array(64)]) {
    refuses('invalid-argument', () => path.points(bad));
    if (!(bad instanceof Uint32Array)) refuses('invalid-argument', () => world.snapshot().triangles(bad));
  }
  const shared = new Float64Array(new SharedArrayBuffer(512));
  assert.equal(path.points(shared).buffer, shared.buffer);
  const detached = new Float64Array(64);
  structuredClone(detached, { transfer: [detached.buffer] });
  assert.equal(path.points(detached).length, 6);
});

test('texts and bytes', () => {
  for (const bad of [undefined, null, 5, new Uint8Array(4), ['text']]) {
    if (bad !== undefined) refuses('invalid-argument', () => new Scene().parseMovingaiMap('', bad));
    refuses('invalid-argument', () => new Script().parse(bad));
    refuses('invalid-argument', () => sceneFormat(bad));
    refuses('invalid-argument', () => new SvgOverlay().addElements(bad));
  }
  const bytes = world.save();
  for (const bad of [undefined, null, 'text', [...bytes], bytes.buffer, new Uint16Array(8), new DataView(bytes.buffer)]) {
    refuses('invalid-argument', () => World.load(bad));
    refuses('invalid-argument', () => isSavedWorld(bad));
    refuses('invalid-argument', () => new Scene().parseSavedWorld(bad));
  }
  assert.equal(World.load(Buffer.from(bytes)).itemsHash(), world.itemsHash());
  assert.ok(isSavedWorld(bytes) && !isSavedWorld(new Uint8Array(0)));
});

test('lists, shapes, changes, options and frames', () => {
  for (const bad of [null, 5, 'text']) {
    for (const call of [
      () => world.insert(bad), () => world.replace(1, bad), () => world.apply(bad), () => world.apply([bad]),
      () => world.attempt([bad], () => 1), () => world.attempt([], bad), () => world.insertAll(bad), () => world.insertAll([bad]),
      () => world.insertAll([], bad), () => world.insertAll([], { progress: bad }), () => world.insertPoints([], 0, { progress: bad }),
      () => World.load(world.save(), bad), () => new World(DOMAIN, bad), () => world.findPaths([], bad),
      () => world.toSvg(null, bad), () => svgToWorld(bad, at(1, 1)), () => new ItemList().addMany('point', bad),
      () => new SvgOverlay().addRay(at(1, 1), at(2, 2), bad), () => new SvgOverlay().addLocation(at(1, 1), bad),
      () => world.itemsIn(bad), () => world.findAffected(bad, 0), () => new Walkers(1).set(0, bad ?? {}),
      () => world.apply([{ kind: 'toString', id: 1 }]), () => new ReplayWriter(world).record(bad),
      () => new Path().advance(bad, 1),
    ]) {
      refuses('invalid-argument', call);
    }
  }
  const list = new ItemList();
  refuses('invalid-argument', () => list.addMany('point', { points: new Float64Array(6), offsets: [0, 1, 2, 1] }));
  assert.equal(list.length, 0);
  assert.ok(new WaywrightError('disposed', 'text') instanceof Error);
  assert.deepEqual(world.itemsAt(at(1, 1), new QueryContext()), []);
  assert.equal(new Paths().length, 0);
});
