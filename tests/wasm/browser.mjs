// usage: browser.mjs CHROMIUM EXPORT_CHANGES PRINT_MESHES
// Runs the 200 worlds in Chromium and compares the text with that of the native program. Then opens the example, on its page
// and in a worker, and moves the mouse.
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { readFile } from 'node:fs/promises';
import { createServer } from 'node:http';
import { createRequire } from 'node:module';
import { extname, join } from 'node:path';
import { fileURLToPath } from 'node:url';

const [executablePath, exportChanges, printMeshes] = process.argv.slice(2);
const root = fileURLToPath(new URL('../..', import.meta.url));
const { chromium } = createRequire(join(root, 'bindings/wasm/package.json'))('playwright-core');
const TYPES = { '.html': 'text/html', '.js': 'text/javascript', '.mjs': 'text/javascript', '.wasm': 'application/wasm' };
const run = (program) => execFileSync(program, { encoding: 'utf8', maxBuffer: 2 ** 30 });

const server = createServer(async (request, response) => {
  const path = new URL(request.url, 'http://localhost').pathname;
  try {
    const bytes = await readFile(join(root, path));
    response.writeHead(200, { 'content-type': TYPES[extname(path)] ?? 'text/plain' }).end(bytes);
  } catch {
    response.writeHead(404).end();
  }
});

async function compareWorlds(page) {
  const worlds = run(exportChanges).trimEnd().split('\n');
  const expected = run(printMeshes);
  let text = '';
  for (let i = 0; i < worlds.length; i += 20) {
    text += await page.evaluate(async (lines) => {
      const { init } = await import('/bindings/wasm/dist/index.js');
      const { worldText } = await import('/tests/wasm/worlds.mjs');
      await init();
      return lines.map(worldText).join('');
    }, worlds.slice(i, i + 20));
  }
  assert.equal(worlds.length, 200);
  assert.ok(text === expected, `the texts differ: ${text.length} and ${expected.length} characters`);
  console.log(`${worlds.length} worlds, ${text.length} equal characters`);
}

async function tryExample(page, url) {
  await page.goto(url);
  const status = page.locator('#status');
  await page.waitForFunction(() => document.querySelector('#status').textContent.startsWith('move'));
  const box = await page.locator('canvas').boundingBox();
  await page.mouse.move(box.x + 100, box.y + 40);
  await page.waitForFunction(() => document.querySelector('#status').textContent.startsWith('a path'));
  // The canvas has a border of one pixel. The mouse is at (99, 39), and the start of the path at (40, 40).
  const length = Number((await status.textContent()).split(' ').at(-1));
  assert.ok(Math.abs(length - Math.hypot(59, 1)) < 0.11, String(length));
  await page.mouse.move(box.x + 250, box.y + 100);
  await page.waitForFunction(() => Number(document.querySelector('#status').textContent.split(' ').at(-1)) > 700);
  console.log(`${url}: ${await status.textContent()}`);
}

await new Promise((done) => server.listen(0, '127.0.0.1', done));
const base = `http://127.0.0.1:${server.address().port}/bindings/wasm/example/index.html`;
const args = ['--no-sandbox', '--disable-gpu', '--disable-background-networking', '--no-first-run'];
args.push('--disable-component-update', '--disable-sync');
const browser = await chromium.launch({ executablePath, headless: true, args });
try {
  const page = await browser.newPage();
  page.on('pageerror', (error) => {
    console.error(error);
    process.exitCode = 1;
  });
  await tryExample(page, base);
  await tryExample(page, `${base}?worker`);
  await compareWorlds(page);
} finally {
  await browser.close();
  server.close();
}
