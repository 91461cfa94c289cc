// The types of the package: a program that uses every export compiles under strict rules, as users set them, and runs.
import assert from 'node:assert/strict';
import { execFileSync, spawnSync } from 'node:child_process';
import { copyFileSync, mkdirSync, mkdtempSync, readFileSync, rmSync, symlinkSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { after, test } from 'node:test';
import { fileURLToPath } from 'node:url';

const here = fileURLToPath(new URL('.', import.meta.url));
const packageFolder = fileURLToPath(new URL('../../bindings/wasm', import.meta.url));
const compiler = join(packageFolder, 'node_modules/typescript/bin/tsc');
const folder = mkdtempSync(join(tmpdir(), 'waywright-types-'));
after(() => rmSync(folder, { recursive: true }));

mkdirSync(join(folder, 'node_modules/@types'), { recursive: true });
symlinkSync(packageFolder, join(folder, 'node_modules/waywright'));
symlinkSync(join(packageFolder, 'node_modules/@types/node'), join(folder, 'node_modules/@types/node'));
writeFileSync(join(folder, 'package.json'), '{ "type": "module" }');
copyFileSync(join(here, 'every_export.ts'), join(folder, 'every_export.ts'));

const STRICT = {
  target: 'ES2022', strict: true, skipLibCheck: false, noUncheckedIndexedAccess: true, exactOptionalPropertyTypes: true,
  noImplicitOverride: true, noPropertyAccessFromIndexSignature: true, isolatedModules: true, verbatimModuleSyntax: true,
};

const USING = `
import { World } from 'waywright';
export function count(): number {
  using world = new World({ min: { x: 0, y: 0 }, max: { x: 1, y: 1 } });
  return world.itemCount;
}`;
// The compiler reports a line that compiles although it should not.
const WRONG = [
  'new World(100);', 'new World(domain, { keepBridge: true });', 'world.insertPoint([1, 1]);', 'world.findPath({ start: p });',
  'world.insertPoint({ x: null, y: 1 });', "world.findPath({ start: p, goal: p, algorithm: 'best' });", 'new Path(8, world);',
  'world.address;', 'new PathWatch(world).add(1, world);', 'world.findPath({ start: p, goal: p }, new Paths());',
];
const REFUSED = `
import { Path, Paths, PathWatch, World } from 'waywright';
declare const world: World;
const p = { x: 1, y: 1 };
const domain = { min: p, max: p };
void [Path, Paths, PathWatch, domain];
${WRONG.map((line) => `// @ts-expect-error\n${line}`).join('\n')}`;
writeFileSync(join(folder, 'using.ts'), USING);
writeFileSync(join(folder, 'refused.ts'), REFUSED);

const PROGRAM = ['every_export.ts', 'refused.ts'];
const CASES = {
  node: [{ module: 'NodeNext', lib: ['ES2022'], types: ['node'] }, PROGRAM],
  browser: [{ module: 'ESNext', moduleResolution: 'bundler', lib: ['ES2022', 'DOM'], types: [] }, PROGRAM],
  worker: [{ module: 'ESNext', moduleResolution: 'bundler', lib: ['ES2022', 'WebWorker'], types: [] }, PROGRAM],
  newest: [{ module: 'NodeNext', lib: ['ESNext', 'DOM'], types: ['node'] }, [...PROGRAM, 'using.ts']],
};
for (const [name, [options, files]] of Object.entries(CASES)) {
  test(`strict types: ${name}`, () => {
    writeFileSync(join(folder, `${name}.json`), JSON.stringify({ compilerOptions: { ...STRICT, ...options, outDir: name }, files }));
    const { stdout } = spawnSync(process.execPath, [compiler, '-p', join(folder, `${name}.json`)], { encoding: 'utf8' });
    assert.equal(stdout, '');
  });
}

test('the compiled program runs', () => {
  assert.equal(execFileSync(process.execPath, [join(folder, 'newest/every_export.js')], { encoding: 'utf8' }), 'passed\n');
});

test('the program uses every export', () => {
  const types = readFileSync(join(packageFolder, 'dist/index.d.ts'), 'utf8');
  const exported = [...types.matchAll(/export (?:type )?\{([^}]*)\}/g)].flatMap(([, names]) => names.split(','));
  const names = exported.map((name) => name.replace(/\btype\b/, '').trim()).filter((name) => name !== '');
  const program = readFileSync(join(here, 'every_export.ts'), 'utf8').replace(/import \{[^}]*\} from/, '');
  assert.ok(names.length > 80, String(names.length));
  assert.deepEqual(names.filter((name) => !new RegExp(`\\b${name}\\b`).test(program)), []);
});
