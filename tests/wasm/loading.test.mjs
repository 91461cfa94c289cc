// Loading and unloading the module, workers, and what the garbage collector does. Each test runs in a process of its own.
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { test } from 'node:test';

const main = JSON.stringify(new URL('../../bindings/wasm/dist/index.js', import.meta.url).href);
const wasm = JSON.stringify(new URL('../../bindings/wasm/dist/waywright.wasm', import.meta.url).href);
const HEAD = `
  import assert from 'node:assert/strict';
  import { readFileSync } from 'node:fs';
  import * as waywright from ${main};
  const { init, initSync, moduleMemory, Path, PathSearch, PathWatch, ReplayWriter, trim, unload, WaywrightError, World } = waywright;
  const bytes = readFileSync(new URL(${wasm}));
  const domain = { min: { x: 0, y: 0 }, max: { x: 100, y: 100 } };
  const query = { start: { x: 1, y: 1 }, goal: { x: 9, y: 9 } };
  const spiral = (count) => new Float64Array(2 * count).map((_, i) => (i * 0.618033988749895) % 100);
  const refuses = (code, call) => assert.throws(call, (error) => error instanceof WaywrightError && error.code === code);
  const collect = async () => { for (let i = 0; i < 5; ++i) { globalThis.gc(); await new Promise((done) => setTimeout(done, 5)); } };
`;
function passes(name, program) {
  test(name, () => {
    const output = execFileSync(process.execPath, ['--expose-gc', '--input-type=module', '-e', `${HEAD}${program}\nconsole.log('passed');`], { encoding: 'utf8' });
    assert.equal(output.trim(), 'passed');
  });
}

passes('init() and initSync() at the same time take one module into use', `
  const loading = init();
  initSync(bytes);
  const world = new World(domain);
  world.insertPoints(spiral(1000));
  const hash = world.meshHash();
  await loading;
  await init({ maximumMemory: 2 ** 25 });
  initSync(bytes);
  assert.equal(world.meshHash(), hash);
  assert.equal(new World(domain).itemCount, 0);
  assert.equal(world.meshHash(), hash);
`);

passes('a module, bytes or options that are none', `
  const other = Uint8Array.of(0, 97, 115, 109, 1, 0, 0, 0);
  for (const maximumMemory of [NaN, 0, -1, '1000', {}, 5n]) {
    await assert.rejects(init({ maximumMemory }), { code: 'invalid-argument' });
    refuses('invalid-argument', () => initSync(bytes, maximumMemory));
  }
  for (const module of [5, {}, [], true]) await assert.rejects(init({ module }), { code: 'invalid-argument' });
  refuses('invalid-argument', () => initSync('waywright.wasm'));
  await assert.rejects(init({ module: other }), { code: 'unreadable' });
  refuses('unreadable', () => initSync(other));
  await assert.rejects(init({ module: new URL('missing.wasm', ${wasm}) }));
  refuses('not-initialised', () => new World(domain));
  refuses('not-initialised', () => moduleMemory());
  trim();
  unload();
  await init({ module: new URL(${wasm}) });
  assert.equal(new World(domain).itemCount, 0);
`);

passes('the smallest memory limit', `
  await init({ maximumMemory: 1 });
  const world = new World(domain);
  refuses('out-of-memory', () => world.insertPoints(spiral(300000)));
  assert.equal(world.itemCount, 0);
  world.insertPoints(spiral(10));
  assert.ok(world.validate().isValid);
`);

passes('unload() frees the memory, and its objects count as disposed', `
  const compiled = await WebAssembly.compile(bytes);
  let memory = null;
  const { instantiate } = WebAssembly;
  WebAssembly.instantiate = async (...given) => {
    const instance = await instantiate(...given);
    memory = new WeakRef(instance.exports.memory);
    return instance;
  };
  let old = [];
  for (let round = 0; round < 3; ++round) {
    await init({ module: compiled });
    const world = new World(domain);
    for (const each of old) {
      assert.ok(each.isDisposed);
      refuses('disposed', () => each.address);
      each.dispose();
    }
    assert.equal(world.insertPoints(spiral(100000)), 1);
    const path = world.findPath(query);
    const { length } = path;
    assert.equal(world.itemIds().length, 100000);
    assert.equal(world.findPath(query).length, length);
    const search = new PathSearch();
    search.begin(world, query);
    old = [world, path, search, new PathWatch(world), new ReplayWriter(world), world.findPaths([1, 1, 2, 2]), world.snapshot()];
    assert.ok(moduleMemory().total > 2 ** 24);
    unload();
    refuses('not-initialised', () => moduleMemory());
    refuses('not-initialised', () => new World(domain));
    refuses('not-initialised', () => world.itemCount);
    refuses('disposed', () => search.step(1));
  }
  await collect();
  assert.equal(memory.deref(), undefined);
  unload();
`);

passes('objects of an unloaded module are not freed in the next one', `
  await init();
  (() => { for (let i = 0; i < 500; ++i) new World(domain); })();
  unload();
  await init();
  const worlds = Array.from({ length: 500 }, () => new World(domain));
  await collect();
  const { used } = moduleMemory();
  for (const world of worlds) assert.equal(world.insertPoint({ x: 1, y: 1 }), 1);
  assert.ok(moduleMemory().used >= used);
`);

passes('the garbage collector does not free what another object needs', `
  await init();
  const search = new PathSearch();
  const watch = (() => { const world = new World(domain); search.begin(world, query); return new PathWatch(world); })();
  const other = new PathSearch();
  (() => other.begin(new World(domain), query))();
  const path = (() => new World(domain).findPaths([1, 1, 1, 5]).get(0))();
  await collect();
  assert.deepEqual(watch.update().blocked, []);
  while (!other.step(1));
  assert.ok(other.path.length > 11);
  assert.equal(path.length, 4);
`);

passes('a disposed wrapper behind a Proxy is not freed again', `
  await init();
  (() => { for (let i = 0; i < 200; ++i) new Proxy(new World(domain), {}).dispose(); })();
  const worlds = Array.from({ length: 200 }, () => new World(domain));
  await collect();
  for (const world of worlds) assert.equal(world.insertPoint({ x: 1, y: 1 }), 1);
`);

passes('the garbage collector frees every kind of object', `
  await init();
  const make = () => {
    const world = new World(domain);
    const path = world.findPath(query);
    const watch = new PathWatch(world);
    watch.add(1, path);
    const search = new PathSearch();
    search.begin(world, query);
    const { ItemList, Mesh, Scenario, Scene, Script, SvgOverlay, QueryContext, Walkers } = waywright;
    return [new ReplayWriter(world), world.findPaths([1, 1, 2, 2]), world.snapshot(), world.items(), world.clone(), new Mesh(),
      new ItemList(), new Scene(), new Script(), new Scenario(), new SvgOverlay(), new QueryContext(), new Walkers(50), search.path];
  };
  (() => make())();
  await collect();
  trim();
  const before = moduleMemory().used;
  (() => { for (let i = 0; i < 100; ++i) make(); })();
  await collect();
  trim();
  assert.equal(moduleMemory().used, before);
`);

passes('workers share a compiled module, and have worlds of their own', `
  const { Worker } = await import('node:worker_threads');
  const module = await WebAssembly.compile(bytes);
  await init({ module });
  const world = new World(domain);
  world.insertPoints(spiral(1000));
  const saved = world.save();
  const program = \`
    import { parentPort, workerData } from 'node:worker_threads';
    const { init, World } = await import(\${JSON.stringify(${main})});
    await init({ module: workerData.module });
    const world = World.load(workerData.saved);
    world.insertPoint({ x: 50, y: 50.5 });
    parentPort.postMessage(world.items().length);
  \`;
  const counts = await Promise.all(Array.from({ length: 2 }, () => new Promise((done, fail) => {
    const url = new URL('data:text/javascript,' + encodeURIComponent(program));
    new Worker(url, { workerData: { module, saved } }).once('message', done).once('error', fail);
  })));
  assert.deepEqual(counts, [1001, 1001]);
  assert.equal(world.itemCount, 1000);
  assert.throws(() => structuredClone(world), { name: 'DataCloneError' });
`);

passes('after a world that is too large, everything else works', `
  await init({ maximumMemory: 2 ** 25 });
  const world = new World(domain);
  world.insertPoints(spiral(1000));
  const hash = world.meshHash();
  let large = new World(domain, { keepBridges: true });
  refuses('out-of-memory', () => { for (;;) large.insertPoints(spiral(200000)); });
  assert.equal(world.meshHash(), hash);
  large.dispose();
  large = new World(domain);
  large.insertPoints(spiral(20000));
  assert.ok(large.validate().isValid);
  unload();
  await init();
  large = new World(domain);
  large.insertPoints(spiral(400000));
  assert.equal(large.itemCount, 400000);
`);
