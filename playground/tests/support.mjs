// Serves the built page and opens it in Chromium.
import { readFile } from 'node:fs/promises';
import { createServer } from 'node:http';
import { extname, join } from 'node:path';
import { test as plainTest } from 'node:test';
import { fileURLToPath } from 'node:url';
import { chromium } from 'playwright-core';

/** WAYWRIGHT_PAGE names the folder of another build. */
export const ROOT = process.env.WAYWRIGHT_PAGE ?? fileURLToPath(new URL('../dist', import.meta.url));
const TYPES = { '.html': 'text/html', '.js': 'text/javascript', '.css': 'text/css', '.wasm': 'application/wasm' };
const CHROMIUM = process.env.WAYWRIGHT_CHROMIUM ?? '/usr/bin/chromium';

/** Most tests take 2 to 7 seconds. Without a limit, a test waits forever if Chromium does not answer. */
const TEST_MILLISECONDS = 120_000;

/** Defines a test. `options` can contain another `timeout`. */
export function test(name, options, body) {
  if (body === undefined) return plainTest(name, { timeout: TEST_MILLISECONDS }, options);
  return plainTest(name, { timeout: TEST_MILLISECONDS, ...options }, body);
}

/** Serves a folder. Returns the server and its address. */
export async function serve(root = ROOT) {
  const server = createServer(async (request, response) => {
    const path = new URL(request.url, 'http://localhost').pathname;
    try {
      const bytes = await readFile(join(root, path === '/' ? 'index.html' : path));
      response.writeHead(200, { 'content-type': TYPES[extname(path)] ?? 'text/html' }).end(bytes);
    } catch {
      response.writeHead(404).end();
    }
  });
  await new Promise((done) => server.listen(0, '127.0.0.1', done));
  return { server, base: `http://127.0.0.1:${server.address().port}/` };
}

export async function launch() {
  const args = ['--no-sandbox', '--disable-gpu', '--disable-background-networking', '--no-first-run', '--disable-component-update', '--disable-sync'];
  return chromium.launch({ executablePath: CHROMIUM, headless: true, args });
}

/** Opens the page and waits for its world. An error on the page fails the test. */
export async function openPage(browser, address, options = {}) {
  const context = await browser.newContext({ viewport: { width: 1280, height: 800 }, ...options });
  const page = await context.newPage();
  page.errors = [];
  page.on('pageerror', (error) => page.errors.push(error));
  page.on('console', (message) => {
    if (message.type() === 'error') page.errors.push(new Error(message.text()));
  });
  await page.goto(address);
  await page.waitForSelector('html[data-ready]', { timeout: 60_000 });
  return page;
}

/** Waits until nothing waits for the engine and the hashes are those of the present world. */
export async function settle(page) {
  await page.evaluate(async () => {
    const { session } = window.waywright;
    await session.settled();
    const begin = Date.now();
    while (session.hashes?.version !== session.summary?.version && Date.now() - begin < 60000) {
      await new Promise((resolve) => setTimeout(resolve, 20));
    }
  });
}

export const hashes = (page) => page.evaluate(() => ({ ...window.waywright.session.hashes }));

/** The pixel of a position of the world. */
export const pixel = (page, x, y) => page.evaluate(([a, b]) => window.waywright.view.camera.toScreen({ x: a, y: b }), [x, y]);

/** Drags the mouse from one position of the world to another. */
export async function drag(page, from, to, steps = 8) {
  const [a, b] = [await pixel(page, ...from), await pixel(page, ...to)];
  await page.mouse.move(a.x, a.y);
  await page.mouse.down();
  await page.mouse.move(b.x, b.y, { steps });
  await page.mouse.up();
}
