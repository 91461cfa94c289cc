// Memory: disposing returns it, the garbage collector does so too, and running out of it is an error like any other.
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { test } from 'node:test';

import {
  ItemList, Mesh, moduleMemory, Path, Paths, PathSearch, QueryContext, Scenario, Scene, Script, SvgOverlay, Walkers, World,
} from '../../bindings/wasm/dist/index.js';
import { at, DOMAIN, makeWorld, refuses, usedBytes } from './support.mjs';

const QUERY = { start: at(10, 70), goal: at(50, 40) };

function useEverything() {
  const world = makeWorld({ keepBridges: true });
  const objects = [
    world, world.findPath(QUERY), world.findPaths([1, 1, 2, 2, 3, 3, 4, 4]), world.snapshot(), world.items(),
    new PathSearch(), new QueryContext(), new Walkers(10), new SvgOverlay(), new Script(), new Scenario(), new Scene(),
  ];
  objects[5].begin(world, QUERY);
  objects[5].step(5);
  objects[8].addPath(objects[1]).addLabel(at(1, 1), 'text', 1);
  world.toSvg(objects[8]);
  world.dump();
  world.shape(2);
  refuses('unknown-id', () => world.remove(99));
  return objects;
}

test('dispose returns all memory', () => {
  for (const object of useEverything()) object.dispose();
  const before = usedBytes();
  for (let i = 0; i < 50; ++i) for (const object of useEverything()) object.dispose();
  assert.equal(usedBytes(), before);
});

test('Symbol.dispose, a second dispose, and later uses', () => {
  const before = usedBytes();
  const objects = useEverything();
  for (const object of objects) {
    object[Symbol.dispose]();
    assert.ok(object.isDisposed);
    object.dispose();
  }
  assert.equal(usedBytes(), before);
  const [world, path, paths, mesh, items, search, context, walkers, overlay, script, scenario, scene] = objects;
  for (const call of [
    () => world.insertPoint(at(1, 1)), () => world.itemCount, () => world.findPath(QUERY), () => world.toSvg(),
    () => path.length, () => path.points(), () => paths.get(0), () => mesh.vertices(), () => items.length,
    () => search.step(1), () => makeWorld().locate(at(1, 1), context), () => walkers.advance(1), () => overlay.clear(),
    () => script.parse('domain 0 0 1 1'), () => scenario.length, () => scene.items, () => makeWorld().findPath(QUERY, path),
    () => makeWorld().snapshot(mesh), () => makeWorld().insertAll(items), () => search.begin(world, QUERY),
  ]) {
    refuses('disposed', call);
  }
});

test('the garbage collector frees what nobody disposes of', () => {
  const program = `
    import { init, moduleMemory, World } from ${JSON.stringify(new URL('../../bindings/wasm/dist/index.js', import.meta.url).href)};
    await init();
    const domain = { min: { x: 0, y: 0 }, max: { x: 1, y: 1 } };
    for (let i = 0; i < 3000; ++i) {
      new World(domain);
      if (i % 100 === 99) { globalThis.gc(); await new Promise((done) => setTimeout(done, 1)); }
    }
    const one = new World(domain).memory().total;
    console.log(moduleMemory().used < 1000 * one ? 'freed' : 'kept');
  `;
  const output = execFileSync(process.execPath, ['--expose-gc', '--input-type=module', '-e', program], { encoding: 'utf8' });
  assert.equal(output.trim(), 'freed');
});

test('arrays of the caller stay valid when the memory grows', () => {
  const world = makeWorld();
  const points = world.findPath(QUERY).points();
  const { total } = moduleMemory();
  const large = new Float64Array(2 * 600000).map((_, i) => (i * 0.618033988749895) % 100);
  const other = new World(DOMAIN);
  other.insertPoints(large);
  assert.ok(moduleMemory().total > total);
  assert.deepEqual([...points], [10, 70, 40, 70, 50, 40]);
  const mesh = other.snapshot();
  assert.equal(mesh.triangles().length, 3 * other.triangleCount);
  for (const object of [other, mesh, world]) object.dispose();
});

test('too little memory is an error, and everything else goes on', () => {
  const program = `
    import assert from 'node:assert/strict';
    import { init, ItemList, Mesh, moduleMemory, Path, Shape, WaywrightError, World } from ${JSON.stringify(new URL('../../bindings/wasm/dist/index.js', import.meta.url).href)};
    await init({ maximumMemory: 24 * 2 ** 20 });
    const domain = { min: { x: 0, y: 0 }, max: { x: 100, y: 100 } };
    const world = new World(domain, { keepBridges: true });
    world.insertSegment({ x: 40, y: 0 }, { x: 40, y: 70 });
    let errors = 0;
    const points = (count, seed) => new Float64Array(2 * count).map((_, i) => ((i + seed) * 0.618033988749895) % 100);
    for (const count of [40000, 20000, 10000, 5000, 2000, 1000, 500, 200, 100, 50, 20, 10, 5, 2, 1]) {
      for (let i = 0; i < 20; ++i) {
        const before = [world.version, world.itemsHash(), world.vertexCount, world.triangleCount];
        try {
          world.insertPoints(points(count, count + i * 0.37));
        } catch (error) {
          if (!(error instanceof WaywrightError) || error.code !== 'out-of-memory') throw error;
          errors += 1;
          assert.deepEqual([world.version, world.itemsHash(), world.vertexCount, world.triangleCount], before);
          break;
        }
      }
    }
    assert.ok(errors >= 10, String(errors));
    let refused = 0;
    const attempts = [() => new World(domain), () => world.snapshot(), () => world.dump(), () => world.items(), () => new Path(),
      () => new Float64Array(world.snapshot().vertices())];
    for (let i = 0; i < 200; ++i) for (const attempt of attempts) {
      try { globalThis.kept = [globalThis.kept, attempt()]; } catch (error) {
        if (!(error instanceof WaywrightError) || error.code !== 'out-of-memory') throw error;
        assert.match(error.message, /memory/);
        refused += 1;
      }
    }
    assert.ok(refused > 0);
    for (let list = globalThis.kept; list; list = list[0]) list[1]?.dispose?.();
    assert.ok(moduleMemory().total <= 24 * 2 ** 20);
    world.dispose();
    const again = new World(domain);
    again.insertPoints(points(20000, 1));
    assert.ok(again.validate().isValid);
    assert.equal(again.findPath({ start: { x: 1, y: 1 }, goal: { x: 1, y: 4 } }).length, 3);
    console.log('survived');
  `;
  const output = execFileSync(process.execPath, ['--input-type=module', '-e', program], { encoding: 'utf8' });
  assert.equal(output.trim(), 'survived');
});

test('lists of impossible sizes', () => {
  const world = makeWorld();
  // An array-like object without elements costs nothing, and claims to be huge.
  const huge = { length: 2 ** 33 };
  refuses('out-of-memory', () => world.insertPoints(huge));
  refuses('out-of-memory', () => world.insertPolygon({ length: 2 ** 32 }));
  refuses('out-of-memory', () => new Walkers(2 ** 31));
  assert.equal(world.itemCount, 2);
  assert.ok(new Mesh().vertices().length === 0 && new ItemList().length === 0 && new Paths().length === 0 && new Path().length === 0);
});
