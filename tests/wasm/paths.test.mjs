// Paths: queries, answers, searches in slices, crowds. The shortest path around the wall of makeWorld turns at (40, 70).
import assert from 'node:assert/strict';
import { test } from 'node:test';

import { Path, Paths, PathSearch, Walkers, World } from '../../bindings/wasm/dist/index.js';
import { at, DOMAIN, makeWorld, refuses } from './support.mjs';

const QUERY = { start: at(10, 70), goal: at(50, 40) };
const LENGTH = 30 + Math.hypot(10, 30);

function near(actual, expected) {
  assert.ok(Math.abs(actual - expected) < 1e-9, `${actual} instead of ${expected}`);
}

test('the shortest path of a point agent', () => {
  const world = makeWorld();
  for (const algorithm of ['optimal', 'ta', 'tra']) {
    const path = world.findPath({ ...QUERY, algorithm, wantsChannel: true, wantsTime: true, budgetExpansions: Infinity });
    assert.equal(path.status, 'found');
    near(path.length, LENGTH);
    assert.deepEqual([...path.points()], [10, 70, 40, 70, 50, 40]);
    assert.equal(path.channel().length, 4 * path.info.channelCount);
    assert.ok(path.info.expansions > 0 && path.info.channelCount > 0 && path.info.nanoseconds >= 0);
    assert.deepEqual(path.pieces(), []);
  }
});

test('one path serves many queries', () => {
  const world = makeWorld();
  const path = new Path();
  const into = new Float64Array(64);
  assert.equal(world.findPath(QUERY, path), path);
  assert.equal(path.points(into).buffer, into.buffer);
  assert.equal(path.points(new Float64Array(2)).length, 6);
  world.findPath({ start: at(10, 10), goal: at(10, 20) }, path);
  near(path.length, 10);
  assert.deepEqual([...path.points(into)], [10, 10, 10, 20]);
});

test('positions on a path', () => {
  const path = makeWorld().findPath(QUERY);
  const position = path.at(10);
  assert.deepEqual([position.at, position.heading, position.segment], [at(20, 70), at(1, 0), 0]);
  assert.equal(path.advance(position, 25), position);
  near(position.distance, 35);
  assert.equal(position.segment, 1);
  near(path.nearest(at(30, 75)).distance, 20);
  assert.deepEqual(path.at(10, 'float32').at, at(20, 70));
  assert.deepEqual([...path.polyline(0.1)], [10, 70, 40, 70, 50, 40]);
});

test('paths of discs', () => {
  const world = makeWorld({ keepBridges: true });
  const path = world.findPath({ ...QUERY, start: at(10, 60), agent: { radius: 5 } });
  assert.equal(path.status, 'found');
  const pieces = path.pieces();
  assert.deepEqual(pieces.map(({ kind }) => kind), ['line', 'arc', 'line']);
  assert.deepEqual([pieces[1].centre, pieces[1].radius], [at(40, 70), 5]);
  assert.ok(path.polyline(0.01).length > 6);
  refuses('bad-distance', () => path.polyline(-1));
  const large = world.findPath({ start: at(20, 50), goal: at(60, 80), agent: { radius: 20 } });
  assert.equal(large.status, 'no-path');
  const { isConnected, isLimited, radius, fromItems, toItems } = large.widest();
  assert.deepEqual([isConnected, isLimited, radius], [true, true, 15]);
  assert.deepEqual([...fromItems, ...toItems].sort(), [0, 1]);
  refuses('no-bridges', () => makeWorld().findPath({ ...QUERY, agent: { radius: 5 } }));
});

test('blocked ends and no path', () => {
  const world = makeWorld({ keepBridges: true });
  const blocked = world.findPath({ start: at(70, 50), goal: at(1, 1), endTolerance: 0 });
  assert.equal(blocked.status, 'start-blocked');
  assert.deepEqual(blocked.blockers(), [2]);
  refuses('invalid-argument', () => blocked.at(0));
  const moved = world.findPath({ start: at(61, 50), goal: at(50, 90), endTolerance: 10 });
  assert.deepEqual(moved.info.movedStart.from, at(61, 50));
  world.insertPolyline([41, 80, 0, 80], 3);
  world.insertPolyline([41, 80, 40, 70], 4);
  const none = world.findPath({ start: at(10, 10), goal: at(50, 10), agent: { radius: 1 } });
  assert.equal(none.status, 'no-path');
  assert.equal(none.length, 0);
  assert.ok(none.widest() === null || none.widest().isConnected === false);
});

test('many paths in one call', () => {
  const world = makeWorld();
  const ends = [10, 70, 50, 40, 1, 1, 1, 5, 70, 50, 1, 1];
  const paths = world.findPaths(ends, { endTolerance: 0 });
  assert.equal(paths.length, 3);
  const lengths = paths.lengths();
  near(lengths[0], LENGTH);
  assert.equal(lengths[1], 4);
  assert.ok(Number.isNaN(lengths[2]));
  const { points, offsets } = paths.points();
  assert.deepEqual([...offsets], [0, 3, 5, 5]);
  assert.deepEqual([...points], [10, 70, 40, 70, 50, 40, 1, 1, 1, 5]);
  assert.equal(paths.get(2).status, 'start-blocked');
  const into = paths.points(new Float64Array(10), new Uint32Array(4));
  assert.deepEqual([...into.points], [...points]);
  const from = world.findPathsFrom({ start: at(10, 70), goals: [at(50, 40), at(10, 75)], wantsPoints: true }, paths);
  assert.equal(from, paths);
  assert.deepEqual([...paths.lengths()].map(Math.round), [Math.round(LENGTH), 5]);
  assert.ok(world.defaultEndTolerance > 0);
});

test('a path of a list is valid until the list changes', () => {
  const world = makeWorld();
  const paths = world.findPaths([10, 70, 50, 40], {}, new Paths());
  const path = paths.get(0);
  near(path.length, LENGTH);
  refuses('invalid-argument', () => paths.get(1));
  world.findPaths([1, 1, 1, 5], {}, paths);
  refuses('disposed', () => path.length);
  const last = paths.get(0);
  paths.dispose();
  refuses('disposed', () => last.points());
});

test('a search in slices', () => {
  const world = makeWorld();
  const search = new PathSearch();
  search.begin(world, QUERY);
  assert.ok(search.isRunning);
  let slices = 0;
  while (!search.step(1)) slices += 1;
  assert.ok(slices > 0);
  const { path } = search;
  near(path.length, LENGTH);
  assert.equal(search.restarts, 0);
  search.begin(world, QUERY);
  refuses('disposed', () => path.length);
  search.step(1);
  world.insertPoint(at(1, 99));
  while (!search.step(1));
  near(search.path.length, LENGTH);
  search.begin(world, QUERY);
  search.cancel();
  assert.equal(search.isRunning, false);
  const short = new World(DOMAIN);
  search.begin(short, QUERY);
  short.dispose();
  refuses('world-gone', () => search.step(10));
});

test('the windows of a search', () => {
  const world = makeWorld();
  const search = new PathSearch();
  search.begin(world, QUERY);
  while (!search.step(1));
  assert.equal(search.windows().length, 0); // nobody asked for them
  search.recordWindows(true);
  search.begin(world, QUERY);
  while (!search.step(1));
  const windows = search.windows();
  assert.ok(windows.length >= 12 * search.path.info.expansions && search.path.info.expansions > 0);
  assert.deepEqual([...windows.subarray(0, 2), windows[10]], [QUERY.start.x, QUERY.start.y, 0]);
  for (let i = 0; i < windows.length; i += 12) {
    const [, , ax, ay, bx, by, cx, cy, dx, dy, length, bound] = windows.subarray(i, i + 12);
    for (const [x, y] of [[cx, cy], [dx, dy]]) near((bx - ax) * (y - ay), (by - ay) * (x - ax)); // on the edge
    assert.ok(bound >= length);
  }
  const into = new Float64Array(windows.length + 5);
  assert.deepEqual(search.windows(into), windows);
  assert.deepEqual(into.subarray(0, windows.length), windows);
});

test('following changes', () => {
  const world = makeWorld();
  const paths = [world.findPath(QUERY), world.findPath({ start: at(90, 90), goal: at(90, 95) })];
  const before = world.version;
  assert.ok(world.isClear([10, 70, 40, 70, 50, 40]));
  assert.ok(!world.isClearBetween(at(10, 10), at(50, 10)));
  world.insertSegment(at(20, 60), at(20, 80));
  assert.ok(world.isAffected(paths[0], before));
  assert.ok(!world.isAffected(paths[1], before));
  assert.ok(world.isAffected([10, 70, 40, 70], before));
  assert.deepEqual(world.findAffected(paths, before), [0]);
});

test('walkers', () => {
  const world = makeWorld();
  const walkers = new Walkers(3);
  const path = world.findPath(QUERY);
  walkers.set(0, path);
  walkers.set(2, path, 5);
  const into = new Float64Array(12);
  assert.equal(walkers.advance(10, into), into);
  assert.deepEqual([...into], [20, 70, 1, 0, 0, 0, 0, 0, 25, 70, 1, 0]);
  walkers.set(0, null);
  assert.deepEqual([...walkers.advance(5)].slice(0, 2), [20, 70]);
  assert.equal(walkers.position(2).distance, 20);
  refuses('invalid-argument', () => walkers.set(3, path));
  path.dispose();
  refuses('disposed', () => walkers.advance(1));
});
