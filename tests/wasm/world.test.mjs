// Worlds: changing and reading items, queries, the mesh. The expected values come from the scene that makeWorld draws.
import assert from 'node:assert/strict';
import { test } from 'node:test';

import {
  boundingBox, centroid, ItemList, Mesh, predicateCounts, QueryContext, Shape, translated, version, World,
} from '../../bindings/wasm/dist/index.js';
import { at, DOMAIN, makeWorld, refuses } from './support.mjs';

test('a world knows its domain and its items', () => {
  const world = makeWorld();
  assert.deepEqual(world.domain, DOMAIN);
  assert.equal(world.itemCount, 2);
  assert.deepEqual(world.itemIds(), [1, 2]);
  assert.ok(world.contains(1) && world.contains(2n) && !world.contains(3));
  assert.deepEqual([...world.shape(1).points], [40, 0, 40, 70]);
  assert.equal(world.shape(2).kind, 'polygon');
  const items = world.items();
  assert.equal(items.length, 2);
  assert.deepEqual(items.info(1), { id: 2, kind: 'polygon', fill: 'even-odd', pointCount: 4, ringCount: 1 });
  assert.deepEqual([...items].map(({ id }) => id), [1, 2]);
  world.remove(1);
  assert.deepEqual(world.itemIds(), [2]);
  world.replace(2, Shape.point(at(5, 5)));
  assert.equal(world.shape(2).kind, 'point');
  assert.equal(world.version, 4);
});

test('ids of all sizes', () => {
  const world = new World(DOMAIN);
  const largest = 2n ** 63n - 1n;
  assert.equal(world.insertPoint(at(1, 1)), 1);
  assert.equal(world.insertPoint(at(2, 1), Number.MAX_SAFE_INTEGER), Number.MAX_SAFE_INTEGER);
  assert.equal(world.insertPoint(at(3, 1), largest), largest);
  assert.deepEqual(world.itemIds(), [1, Number.MAX_SAFE_INTEGER, largest]);
  world.remove(BigInt(Number.MAX_SAFE_INTEGER));
  assert.ok(!world.contains(Number.MAX_SAFE_INTEGER));
});

test('many items at once', () => {
  const world = new World(DOMAIN);
  const list = new ItemList([{ shape: Shape.segment(at(1, 1), at(9, 9)) }, { id: 7, shape: Shape.point(at(5, 1)) }]);
  list.addMany('polygon', { points: new Float64Array([20, 20, 30, 20, 30, 30, 50, 50, 60, 50, 60, 60]), offsets: [0, 3, 6] }, 10);
  assert.equal(list.length, 4);
  const seen = [];
  const ids = world.insertAll(list, { progress: (done, total) => seen.push([done, total]) });
  assert.deepEqual(ids.slice(1), [7, 10, 11]);
  assert.ok(seen.length > 0 && seen.at(-1)[0] === seen.at(-1)[1], String(seen));
  assert.deepEqual(world.itemsAt(at(29, 22)), [10]);
  assert.equal(world.insertPoints(new Float64Array([70, 70, 71, 71]), 100), 100);
  assert.ok(world.contains(101));
  const done = world.apply([
    { kind: 'insert', shape: Shape.point(at(80, 80)), id: 200 },
    { kind: 'remove', id: 10 },
    { kind: 'replace', id: 11, shape: Shape.rectangle({ min: at(1, 50), max: at(5, 60) }) },
  ]);
  assert.deepEqual(done, [200, 10, 11]);
  assert.deepEqual(world.itemsAt(at(2, 55)), [11]);
  refuses('unknown-id', () => world.apply([{ kind: 'insert', shape: Shape.point(at(1, 2)), id: 300 }, { kind: 'remove', id: 10 }]));
  assert.ok(!world.contains(300));
});

test('an error of the progress function comes after the call, and calls in it are refused', () => {
  const world = new World(DOMAIN);
  assert.throws(() => world.insertAll([{ shape: Shape.point(at(1, 1)), id: 3 }], { progress: () => { throw new TypeError('mine'); } }), /mine/);
  assert.ok(world.contains(3));
  refuses('invalid-argument', () => world.insertPoints([2, 2], 0, { progress: () => world.itemCount }));
  assert.equal(world.itemCount, 2);
});

test('polygons with holes, in both fill rules', () => {
  const rings = [[10, 10, 90, 10, 90, 90, 10, 90], [at(40, 40), at(60, 40), at(60, 60), at(40, 60)]];
  for (const [fill, hit] of [['even-odd', []], ['nonzero', [1]]]) {
    const world = new World(DOMAIN);
    world.insert(Shape.polygon(rings, fill), 1);
    assert.deepEqual(world.itemsAt(at(20, 20)), [1]);
    assert.deepEqual(world.itemsAt(at(50, 50)), hit);
    assert.deepEqual([...world.items().ringSizes(0)], [4, 4]);
  }
});

test('shapes', () => {
  assert.deepEqual([...Shape.rectangle({ min: at(1, 2), max: at(3, 5) }).points], [1, 2, 3, 2, 3, 5, 1, 5]);
  const square = Shape.regularPolygon(at(0, 0), 1, 4);
  assert.equal(square.points.length, 8);
  assert.deepEqual([...translated(Shape.segment(at(1, 2), at(3, 4)), 10, 20).points], [11, 22, 13, 24]);
  assert.deepEqual(centroid(Shape.rectangle({ min: at(0, 0), max: at(4, 2) })), at(2, 1));
  assert.deepEqual(boundingBox([3, 1, -2, 7]), { min: at(-2, 1), max: at(3, 7) });
});

test('locating and asking', () => {
  const world = makeWorld();
  const context = new QueryContext();
  assert.deepEqual(world.locate(at(40, 70), context), { kind: 'vertex', vertices: [at(40, 70)], polygons: [] });
  assert.equal(world.locate(at(40, 30)).kind, 'edge');
  const inside = world.locate(at(70, 45));
  assert.equal(inside.kind, 'face');
  assert.equal(inside.vertices.length, 3);
  assert.deepEqual(inside.polygons, [2]);
  assert.deepEqual(world.itemsCrossed(at(0, 50), at(70, 50)), [{ id: 1, at: at(40, 50) }, { id: 2, at: at(60, 50) }]);
  assert.deepEqual(world.itemsIn({ min: at(39, 0), max: at(61, 50) }), [1, 2]);
  assert.deepEqual(world.ray(at(1, 50), at(99, 50)), { hit: true, at: at(40, 50), contact: at(40, 50), items: [1] });
  assert.equal(world.ray(at(1, 90), at(99, 90)).hit, false);
  const border = world.ray(at(0, 0), at(0, 50), {}, context);
  assert.deepEqual(border.items, [0]);
});

test('discs', () => {
  const world = makeWorld({ keepBridges: true });
  assert.deepEqual(world.fitDisc(at(20, 50), { radius: 20 }), { fits: true, items: [] });
  assert.deepEqual(world.fitDisc(at(20, 50), { radius: 25 }), { fits: false, items: [0, 1] });
  const swept = world.ray(at(10, 50), at(90, 50), { radius: 5 });
  assert.deepEqual([swept.hit, swept.at, swept.contact, swept.items], [true, at(35, 50), at(40, 50), [1]]);
  const fit = world.nearestFit({ point: at(38, 50), agent: { radius: 5 } });
  assert.deepEqual([fit.isFound, fit.at, fit.distance], [true, at(35, 50), 3]);
  assert.equal(world.nearestFit({ point: at(38, 50), agent: { radius: 5 }, limit: 2 }).isFound, false);
  const widest = world.widestPath(at(10, 10), at(50, 10));
  assert.deepEqual([widest.isConnected, widest.isLimited, widest.radius], [true, true, 10]);
});

test('bridges', () => {
  const world = new World(DOMAIN, { keepBridges: true });
  world.insertPolygon([40, 40, 60, 40, 60, 60, 40, 60], 1);
  const all = world.bridges(DOMAIN);
  assert.equal(all.length, 8); // two borders for each corner of the house
  const first = { from: at(40, 40), to: at(0, 40), radius: 20, hasFoot: true, fromItems: [1], toItems: [0] };
  assert.deepEqual(all[0], first);
  assert.deepEqual(world.bridges({ min: at(20, 30), max: at(30, 50) }, new QueryContext()), [first]);
  assert.deepEqual(world.bridges({ min: at(200, 200), max: at(300, 300) }), []);
  refuses('bad-domain', () => world.bridges({ min: at(5, 0), max: at(4, 9) }));
  refuses('no-bridges', () => makeWorld().bridges(DOMAIN));
});

test('mesh, hashes, texts and memory', () => {
  const world = makeWorld();
  const mesh = world.snapshot(new Mesh());
  const [vertices, triangles, edges] = [mesh.vertices(), mesh.triangles(), mesh.constrainedEdges()];
  assert.equal(vertices.length, 2 * world.vertexCount);
  assert.equal(triangles.length, 3 * world.triangleCount);
  let area = 0;
  for (let i = 0; i < triangles.length; i += 3) {
    const [a, b, c] = [...triangles.slice(i, i + 3)].map((v) => at(vertices[2 * v], vertices[2 * v + 1]));
    area += ((b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x)) / 2;
  }
  assert.ok(Math.abs(area - 10000) < 1e-6);
  const ids = mesh.ids();
  const first = edges.slice(0, 4);
  assert.ok(ids.slice(first[2], first[2] + first[3]).length === first[3]);
  assert.equal(Math.max(...ids), 2);
  const into = new Float64Array(1000);
  assert.equal(mesh.vertices(into).buffer, into.buffer);
  assert.deepEqual(mesh.vertices(into), vertices);
  assert.match(world.itemsHash(), /^[0-9a-f]{32}$/);
  assert.match(world.meshHash(), /^[0-9a-f]{64}$/);
  assert.deepEqual(world.validate(), { isValid: true, fault: '' });
  assert.ok(world.dump().length > 100);
  const { total, vertices: bytes } = world.memory();
  assert.ok(total > bytes && bytes > 0);
  world.shrinkToFit();
  assert.match(version(), /^\d+\.\d+\.\d+$/);
  assert.ok(predicateCounts().orientation.doubles > 0);
});
