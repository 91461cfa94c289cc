// Disturbs the page as people and machines do: something else happens during a drag, the worker dies, the storage is
// missing, the window has no size, the zoom has no end. Page and world must live on.
import assert from 'node:assert/strict';
import { after, before } from 'node:test';
import { drag, hashes, launch, openPage, pixel, serve, settle, test } from './support.mjs';

let server, base, browser, page, first;

before(async () => {
  ({ server, base } = await serve());
  browser = await launch();
});
after(async () => {
  await browser?.close();
  server?.close();
});

async function fresh(fragment = '', options = {}) {
  await page?.context().close();
  page = await openPage(browser, base + fragment, options);
  await settle(page);
  return page;
}

const press = (...keys) => keys.reduce((done, key) => done.then(() => page.keyboard.press(key)), Promise.resolve());
const itemCount = () => page.evaluate(() => window.waywright.session.summary.itemCount);
const steps = () => page.evaluate(() => window.waywright.session.document.log.map(({ label }) => label));
const toast = (text) => page.locator('.toast', { hasText: text }).first();

/** An empty world of 100 x 75; its hash is `first`. */
async function empty() {
  await fresh();
  await page.getByRole('tab', { name: 'World' }).click();
  await page.getByRole('button', { name: 'Empty world' }).click();
  await settle(page);
  first = (await hashes(page)).mesh;
}

/** The empty world with a box that is selected; the mouse holds it and has moved it. */
async function holdBox() {
  await empty();
  await press('b');
  await drag(page, [40, 30], [60, 50]);
  await settle(page);
  await press('v');
  await hold([50, 40], [30, 30]);
}

async function hold(from, to) {
  const [a, b] = [await pixel(page, ...from), await pixel(page, ...to)];
  await page.mouse.move(a.x, a.y);
  await page.mouse.down();
  await page.mouse.move(b.x, b.y, { steps: 6 });
  await page.evaluate(() => new Promise((done) => setTimeout(done, 60)));
}

async function letGo() {
  const at = await pixel(page, 28, 28);
  await page.mouse.move(at.x, at.y, { steps: 3 });
  await page.mouse.up();
  await settle(page);
}

/** The page and its engine have the same items, and the log leads back to the empty world and again to the present one. */
async function isConsistent() {
  await settle(page);
  const now = await hashes(page);
  const cursor = await page.evaluate(() => window.waywright.session.document.cursor);
  assert.equal(await itemCount(), await page.evaluate(() => window.waywright.session.document.items.size));
  await page.evaluate(() => window.waywright.session.seek(0));
  await settle(page);
  assert.equal((await hashes(page)).mesh, first, 'the beginning of the log is the empty world');
  await page.evaluate((step) => window.waywright.session.seek(step), cursor);
  await settle(page);
  assert.equal((await hashes(page)).mesh, now.mesh, 'the log leads to the present world');
  assert.deepEqual(page.errors.map(String), []);
}

/** People can still build. */
async function isAlive() {
  const count = await itemCount();
  await page.evaluate(async () => {
    const { session } = window.waywright;
    const [x0, y0, x1, y1] = session.document.domain;
    const points = Float64Array.of(x0, y0, (x0 + x1) / 2, (y0 + y1) / 2);
    await session.commit('wall', [{ id: session.document.takeId(), before: null, after: { kind: 'segment', points } }]);
  });
  await settle(page);
  assert.equal(await itemCount(), count + 1);
}

test('undo during a drag takes the drag back', async () => {
  await holdBox();
  await press('Control+z');
  await letGo();
  assert.deepEqual(await steps(), ['insert box']);
  assert.equal(await itemCount(), 1);
  await isConsistent();
});

test('the slider of time during a drag', async () => {
  await holdBox();
  await page.evaluate(() => window.waywright.session.seek(0));
  await letGo();
  assert.equal(await itemCount(), 0);
  await isConsistent();
});

test('the removal of what the mouse holds', async () => {
  await holdBox();
  await press('Delete');
  await letGo();
  assert.equal(await itemCount(), 0);
  await isConsistent();
});

test('a move by keys of what the mouse holds', async () => {
  await holdBox();
  await press('Alt+ArrowLeft', 'Alt+ArrowUp', 'Control+d');
  await letGo();
  await isConsistent();
});

test('another tool while the mouse draws', async () => {
  await empty();
  await press('w');
  await hold([20, 20], [40, 40]);
  await press('p');
  await letGo();
  assert.equal(await itemCount(), 0);
  await isConsistent();
});

test('the space bar while the mouse draws, and the mouse while the space bar holds', async () => {
  await empty();
  await press('w');
  await hold([20, 20], [40, 40]);
  await press('Space', 'ArrowLeft', 'Space');
  await letGo();
  await press('Space', 'Shift+ArrowRight', 'Shift+ArrowRight');
  await drag(page, [60, 20], [70, 40]);
  await press('Space', 'Shift+ArrowRight', 'Space');
  await isConsistent();
});

test('another world while the mouse holds an item of the old one', async () => {
  await holdBox();
  await page.evaluate(() => (location.hash = '#example=nested'));
  await page.waitForFunction(() => window.waywright.session.document.title.startsWith('Nested'));
  await settle(page);
  const before = await hashes(page);
  await letGo();
  assert.equal((await hashes(page)).mesh, before.mesh);
  await press('Control+z');
  await settle(page);
  assert.equal((await hashes(page)).mesh, before.mesh);
  await isAlive();
});

test('more fingers while one draws, and keys at the same time', async () => {
  await fresh('', { viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true });
  await page.getByRole('tab', { name: 'World' }).tap();
  await page.getByRole('button', { name: 'Empty world' }).tap();
  await page.getByRole('tab', { name: 'World' }).tap();
  await settle(page);
  first = (await hashes(page)).mesh;
  await press('w');
  const { x, y } = await pixel(page, 50, 40);
  const session = await page.context().newCDPSession(page);
  const touch = (type, ...at) => session.send('Input.dispatchTouchEvent', {
    type, touchPoints: at.map(([dx, dy], id) => ({ x: x + dx, y: y + dy, id })),
  });
  await touch('touchStart', [0, 0]);
  await touch('touchMove', [40, 20]);
  await touch('touchStart', [40, 20], [-60, 0]);
  await press('Space', 'ArrowUp', 'Delete', 'Control+z');
  await touch('touchStart', [40, 20], [-60, 0], [0, 60]);
  await touch('touchMove', [60, 20], [-80, 0], [0, 90]);
  await touch('touchEnd');
  await press('Escape');
  await isConsistent();
});

test('two fingers during the drag of an end: the table compares again afterwards', async () => {
  await fresh('', { viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true });
  const { x, y } = await page.evaluate(() => window.waywright.view.camera.toScreen(window.waywright.session.ends.start));
  const session = await page.context().newCDPSession(page);
  const touch = (type, ...at) => session.send('Input.dispatchTouchEvent', {
    type, touchPoints: at.map(([dx, dy], id) => ({ x: x + dx, y: y + dy, id })),
  });
  await touch('touchStart', [0, 0]);
  await touch('touchMove', [5, 5]);
  await touch('touchStart', [5, 5], [60, -60]);
  await touch('touchEnd');
  await page.evaluate(() => {
    window.waywright.session.wishes.compares = true;
    window.waywright.session.askRoutes();
  });
  await settle(page);
  assert.equal(await page.evaluate(() => window.waywright.session.routes.routes.length), 3);
});

test('two fingers that zoom leave the selection', async () => {
  await fresh('', { viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true });
  await page.evaluate(() => window.waywright.view.selection.add(1));
  await page.evaluate(() => {
    const at = (id, x, type) => window.waywright.view.canvas.dispatchEvent(
      new PointerEvent(type, { pointerId: id, clientX: x, clientY: 300, pointerType: 'touch', bubbles: true }));
    HTMLCanvasElement.prototype.setPointerCapture = () => {};
    window.waywright.session.document.find = () => [];
    at(7, 150, 'pointerdown');
    window.waywright.view.selection.add(1);
    at(8, 250, 'pointerdown');
    at(8, 300, 'pointermove');
    at(8, 300, 'pointerup');
    at(7, 150, 'pointerup');
  });
  assert.equal(await page.evaluate(() => window.waywright.view.selection.size), 1);
});

test('the module crashes during a drag', async () => {
  await holdBox();
  await page.evaluate(() => void window.waywright.session.engine.ask('crash').catch(() => {}));
  const at = await pixel(page, 20, 20);
  await page.mouse.move(at.x, at.y, { steps: 20 });
  await toast('nothing is lost').waitFor();
  await letGo();
  assert.equal(await itemCount(), 1);
  await isConsistent();
  await isAlive();
});

test('the module crashes three times in a row while people look inside', async () => {
  await empty();
  await page.getByRole('tab', { name: 'Inside' }).click();
  await page.getByLabel('Triangles', { exact: true }).check();
  for (let i = 0; i < 3; ++i) {
    await page.evaluate(() => {
      const { session } = window.waywright;
      void session.engine.ask('crash').catch(() => {});
      session.notify('busy');
    });
    await page.waitForTimeout(50);
    await settle(page);
  }
  await toast('nothing is lost').waitFor();
  await isAlive();
});

test('the browser ends the worker', async () => {
  await empty();
  await press('b');
  await drag(page, [40, 30], [60, 50]);
  await settle(page);
  const before = await hashes(page);
  await page.evaluate(() => window.waywright.session.engine.worker.terminate());
  await toast('nothing is lost').waitFor({ timeout: 20_000 });
  await settle(page);
  assert.equal((await hashes(page)).mesh, before.mesh);
  await isAlive();
});

test('a module that does not load is explained', async () => {
  await page?.context().close();
  const context = await browser.newContext({ serviceWorkers: 'block' });
  page = await context.newPage();
  await context.route('**/*.wasm', (route) => route.abort());
  await page.goto(base);
  await toast('The engine').waitFor({ timeout: 30_000 });
  assert.match(await toast('The engine').textContent(), /Reload the page/);
});

test('a page without storage', async () => {
  await page?.context().close();
  const context = await browser.newContext();
  await context.addInitScript(() => {
    const fail = () => { throw new DOMException('denied', 'SecurityError'); };
    Object.defineProperty(window, 'localStorage', { get: fail });
    Object.defineProperty(window, 'caches', { get: fail });
  });
  page = await context.newPage();
  page.errors = [];
  page.on('pageerror', (error) => page.errors.push(error));
  await page.goto(base);
  await page.waitForSelector('html[data-ready]');
  await page.getByRole('button', { name: 'Dark or light' }).click();
  await settle(page);
  await isAlive();
  assert.deepEqual(page.errors.map(String), []);
});

test('a page with full storage', async () => {
  await fresh();
  await page.evaluate(() => {
    Storage.prototype.setItem = () => { throw new DOMException('full', 'QuotaExceededError'); };
  });
  const theme = () => page.evaluate(() => document.documentElement.dataset.theme);
  const old = await theme();
  await page.getByRole('button', { name: 'Dark or light' }).click();
  assert.notEqual(await theme(), old);
  assert.deepEqual(page.errors.map(String), []);
});

test('a window without a size', async () => {
  await fresh();
  const size = (text) => page.evaluate((value) => {
    Object.assign(window.waywright.view.canvas.style, { width: value, height: value });
  }, text);
  await size('0px');
  await page.waitForTimeout(100);
  await press('0', '+', '-');
  await size('100%');
  await page.waitForTimeout(100);
  await press('0');
  const { x, scale } = await page.evaluate(() => window.waywright.view.camera);
  assert.ok(Number.isFinite(x) && scale > 0.5 && scale < 10, `${x} ${scale}`);
  await page.setViewportSize({ width: 120, height: 90 });
  await press('0');
  await page.setViewportSize({ width: 1280, height: 800 });
  await isAlive();
  assert.deepEqual(page.errors.map(String), []);
});

test('the zoom has ends, and the key 0 comes back from both', async () => {
  await fresh();
  await page.mouse.move(400, 400);
  for (const [key, delta] of [['-', 20_000], ['+', -20_000]]) {
    for (let i = 0; i < 60; ++i) await page.mouse.wheel(0, delta);
    for (let i = 0; i < 30; ++i) await press(key);
    const { x, y, scale } = await page.evaluate(() => window.waywright.view.camera);
    assert.ok([x, y, scale].every(Number.isFinite) && scale > 0, `${x} ${y} ${scale}`);
    await page.mouse.down();
    await page.mouse.move(700, 500, { steps: 3 });
    await page.mouse.up();
    await press('0');
    const at = await pixel(page, 256, 192);
    assert.ok(at.x > 0 && at.x < 1280 && at.y > 0 && at.y < 800, JSON.stringify(at));
  }
  await isAlive();
  assert.deepEqual(page.errors.map(String), []);
});

/** Drops files on the page: each a name and a number of bytes or a text. */
const drop = (files) => page.evaluate((list) => {
  const data = new DataTransfer();
  for (const [name, content] of list) {
    data.items.add(new File([typeof content === 'number' ? new Uint8Array(content) : content], name));
  }
  window.dispatchEvent(new DragEvent('drop', { dataTransfer: data, cancelable: true }));
}, files);

const SCRIPT = 'waywright 1\ndomain 0 0 10 10\npolygon 1 3 1 1 5 1 1 5\n';

test('several files at once: the page opens the first and names the others', async () => {
  await fresh();
  await drop([['one.wws', SCRIPT], ['two.wws', SCRIPT], ['three.wws', SCRIPT]]);
  await toast('one.wws').waitFor();
  assert.match(await toast('one.wws').textContent(), /one file at a time.*two\.wws, three\.wws/);
  await page.waitForFunction(() => window.waywright.session.document.title === 'one.wws', null, { timeout: 10_000 });
  await settle(page);
  assert.equal(await page.evaluate(() => window.waywright.session.document.title), 'one.wws');
});

test('a folder is refused with what to do', async () => {
  await fresh();
  const before = await hashes(page);
  await page.evaluate(() => {
    const item = { kind: 'file', webkitGetAsEntry: () => ({ isDirectory: true, name: 'maps' }) };
    const event = new DragEvent('drop', { cancelable: true });
    Object.defineProperty(event, 'dataTransfer', { value: { types: ['Files'], files: [new File([], 'maps')], items: [item] } });
    window.dispatchEvent(event);
  });
  await toast('maps').waitFor();
  assert.match(await toast('maps').textContent(), /a folder.*Drop a file/);
  assert.equal((await hashes(page)).mesh, before.mesh);
});

test('a file of 100 MB is refused before the page reads it, and does not stop the page', async () => {
  await fresh();
  await page.evaluate(() => {
    File.prototype.arrayBuffer = () => { throw new Error('the page has read the file'); };
  });
  await drop([['large.wws', 100_000_000]]);
  await toast('large.wws').waitFor();
  assert.match(await toast('large.wws').textContent(), /100000000 bytes, and the largest size is 50000000/);
  await isAlive();
});

test('the page answers while it reads a file of 20 MB', { timeout: 180_000 }, async () => {
  await fresh();
  await page.evaluate(() => {
    const polygon = (i) => {
      const [x, y] = [5 + 990 * Math.abs(Math.sin(i)), 5 + 990 * Math.abs(Math.cos(7 * i))];
      const corners = Array.from({ length: 8 }, (_, k) => `${x + 0.1 * Math.cos((k * Math.PI) / 4)} ${y + 0.1 * Math.sin((k * Math.PI) / 4)}`);
      return `polygon ${i + 1} 8 ${corners.join(' ')}\n`;
    };
    const text = `waywright 1\ndomain -1 -1 1001 1001\n${Array.from({ length: 65_000 }, (_, i) => polygon(i)).join('')}`;
    const file = new File([text], 'many.wws');
    window.longest = 0;
    let last = performance.now();
    const look = () => {
      window.longest = Math.max(window.longest, performance.now() - last);
      last = performance.now();
      setTimeout(look);
    };
    look();
    void window.waywright.files.openFile(file);
  });
  await page.waitForFunction(() => window.waywright.session.document.title === 'many.wws', null, { timeout: 170_000 });
  const longest = await page.evaluate(() => window.longest);
  assert.ok(longest < 500, `the page did not answer for ${longest.toFixed(0)} ms`);
  assert.equal(await page.evaluate(() => window.waywright.session.document.items.size), 65_000);
});

test('a file that vanishes while the page reads it', async () => {
  await fresh();
  await page.evaluate(() => {
    File.prototype.arrayBuffer = () => Promise.reject(new DOMException('A requested file could not be found.', 'NotFoundError'));
  });
  await drop([['gone.wws', SCRIPT]]);
  await toast('gone.wws').waitFor();
  assert.match(await toast('gone.wws').textContent(), /could not be found.*has not changed/);
  await isAlive();
});

test('of two files, the one that people have opened last stays', async () => {
  await fresh();
  await page.evaluate(() => {
    const read = File.prototype.arrayBuffer;
    File.prototype.arrayBuffer = async function () {
      if (this.name === 'slow.wws') await new Promise((done) => setTimeout(done, 400));
      return read.call(this);
    };
  });
  await drop([['slow.wws', SCRIPT]]);
  await drop([['fast.wws', SCRIPT]]);
  await page.waitForTimeout(700);
  await settle(page);
  assert.equal(await page.evaluate(() => window.waywright.session.document.title), 'fast.wws');
});

test('a wrong radius is explained next to its field', async () => {
  await fresh();
  const field = page.getByLabel('Radius as a number');
  const radius = () => page.evaluate(() => window.waywright.session.ends.radius);
  const old = await radius();
  for (const text of ['abc', '-1', 'NaN', '1e999', '']) {
    await field.fill(text);
    await page.keyboard.press('Enter');
    await page.locator('#radius-error', { hasText: 'number from 0' }).waitFor({ timeout: 3000 });
    assert.equal(await field.getAttribute('aria-invalid'), 'true');
    assert.equal(await radius(), old);
  }
  await field.fill('1.5');
  await page.keyboard.press('Enter');
  assert.equal(await page.locator('#radius-error').isVisible(), false);
  assert.equal(await radius(), 1.5);
  await field.fill('1e300');
  await page.keyboard.press('Enter');
  await settle(page);
  await isAlive();
  assert.deepEqual(page.errors.map(String), []);
});

test('damaged links open the first example and say why', async () => {
  await fresh();
  const link = await page.evaluate(() => window.waywright.files.share());
  const text = link.slice(link.indexOf('#') + 1);
  const old = `AA${text.slice(2)}`;
  const flipped = text.slice(0, 40) + (text[40] === 'A' ? 'B' : 'A') + text.slice(41);
  for (const broken of [text.slice(0, -7), flipped, old, 'example=nothing', '%00%FF', '<script>', 'A', text.repeat(2)]) {
    await fresh(`#${broken}`);
    assert.match(await page.locator('.toasts').textContent(), /The link.*(damaged|version|no example)/, broken.slice(0, 20));
    assert.ok((await itemCount()) > 100);
    assert.deepEqual(page.errors.map(String), []);
  }
});

test('a world that no link can hold says why, and stays', async () => {
  await empty();
  // A link cannot hold this coordinate: it is not 0, and its size is below 2^-100.
  await page.evaluate(() => (window.waywright.session.ends.start = { x: 1e-32, y: 5 }));
  await page.locator('header').getByRole('button', { name: 'Share' }).click();
  await toast('no link').waitFor();
  assert.match(await toast('no link').textContent(), /1e-32.*Save the world as \.wws/);
  await page.evaluate(() => (window.waywright.session.ends.start = { x: 5, y: 5 }));
  await isAlive();
  assert.deepEqual(page.errors.map(String), []);
});

/** The buttons of the page that people cannot hit: something covers their middle, or they reach beyond the window. */
const hiddenButtons = () => page.evaluate(() =>
  [...document.querySelectorAll('header.top button, nav button, .tabs button, footer button')]
    .filter((button) => button.getClientRects().length > 0)
    .filter((button) => {
      const { left, top, right, bottom } = button.getBoundingClientRect();
      const hit = document.elementFromPoint((left + right) / 2, (top + bottom) / 2);
      return left < 0 || top < 0 || right > innerWidth || bottom > innerHeight || !button.contains(hit);
    })
    .map((button) => button.getAttribute('aria-label') ?? button.textContent));

test('in a window of any size, people can hit every button', async () => {
  await fresh();
  const sizes = [[1280, 800], [1280, 500], [900, 600], [844, 390], [640, 400], [667, 375], [568, 320], [390, 844], [320, 480]];
  for (const [width, height] of sizes) {
    await page.setViewportSize({ width, height });
    assert.deepEqual(await hiddenButtons(), [], `${width} x ${height}`);
  }
});
