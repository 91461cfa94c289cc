// The package itself: its size, its imports, its types, its layouts, and what happens before init().
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { readdirSync, readFileSync } from 'node:fs';
import { join } from 'node:path';
import { test } from 'node:test';
import { fileURLToPath } from 'node:url';
import { gzipSync } from 'node:zlib';

const dist = fileURLToPath(new URL('../../bindings/wasm/dist', import.meta.url));
const main = JSON.stringify(new URL('../../bindings/wasm/dist/index.js', import.meta.url).href);
const wasm = readFileSync(join(dist, 'waywright.wasm'));
const runs = (program) => execFileSync(process.execPath, ['--input-type=module', '-e', program], { encoding: 'utf8' }).trim();

test('at most 550 kB, compressed', () => {
  const files = readdirSync(dist, { recursive: true }).filter((name) => /\.(js|wasm)$/.test(name));
  const sizes = files.map((name) => gzipSync(readFileSync(join(dist, name)), { level: 9 }).length);
  assert.ok(sizes.reduce((sum, size) => sum + size, 0) <= 550_000, sizes.join(' + '));
});

test('the module imports only what the package gives it', async () => {
  const imports = WebAssembly.Module.imports(await WebAssembly.compile(wasm)).map(({ module, name }) => `${module}.${name}`);
  const known = /^(env\.(progress|question|emscripten_notify_memory_growth)|wasi_snapshot_preview1\.(clock_time_get|proc_exit|fd_\w+|environ_\w+))$/;
  assert.deepEqual(imports.filter((name) => !known.test(name)), []);
});

test('before init() every call is refused', () => {
  const program = `
    import { World, WaywrightError, version } from ${main};
    for (const call of [() => new World({ min: { x: 0, y: 0 }, max: { x: 1, y: 1 } }), version]) {
      try { call(); } catch (error) { console.log(error instanceof WaywrightError, error.code); }
    }`;
  assert.equal(runs(program), 'true not-initialised\ntrue not-initialised');
});

test('init() from bytes, from a compiled module, and after a failure', () => {
  const path = JSON.stringify(join(dist, 'waywright.wasm'));
  const start = `import { init, initSync, version } from ${main}; import { readFileSync } from 'node:fs'; const bytes = readFileSync(${path});`;
  const printed = JSON.parse(readFileSync(join(dist, '../package.json'), 'utf8')).version;
  for (const call of [
    'await init({ module: bytes });',
    'await init({ module: await WebAssembly.compile(bytes) });',
    'initSync(bytes); await init();',
    'await init({ module: new Uint8Array(4) }).then(() => { throw 1; }, () => init());',
    'await Promise.all([init(), init()]);',
  ]) {
    assert.equal(runs(`${start} ${call} console.log(version());`), printed);
  }
});
