// Uses the built page as people do: draws, drags, searches, undoes, shares, opens files, and types.
import assert from 'node:assert/strict';
import { after, before } from 'node:test';
import { drag, hashes, launch, openPage, pixel, serve, settle, test } from './support.mjs';

let server, base, browser, page;

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

/** An empty world of 100 x 75 with ends at (8, 8) and (92, 67), and no radius. */
async function empty() {
  await fresh();
  await page.getByRole('tab', { name: 'World' }).click();
  await page.getByRole('button', { name: 'Empty world' }).click();
  await page.getByRole('tab', { name: 'Path' }).click();
  await setRadius('0');
}

async function setRadius(text) {
  await page.getByLabel('Radius as a number').fill(text);
  await page.keyboard.press('Enter');
  await page.locator('#canvas').focus();
  await settle(page);
}

const route = () => page.evaluate(() => {
  const { routes, gap, blockers } = window.waywright.session.routes;
  const { status, length } = routes[0];
  return { status, length, line: [...routes[0].line], gap: gap && { ...gap, line: null }, blockers };
});
const itemCount = () => page.evaluate(() => window.waywright.session.summary.itemCount);
const noErrors = () => assert.deepEqual(page.errors.map(String), []);

test('opens on a world with a path and its two hashes', async () => {
  await fresh();
  assert.equal((await route()).status, 'found');
  const { items, mesh } = await hashes(page);
  assert.match(items, /^[0-9a-f]{32}$/);
  assert.match(mesh, /^[0-9a-f]{64}$/);
  assert.equal(await page.locator('#mesh-hash').textContent(), mesh.slice(0, 10));
  noErrors();
});

test('a wall that people draw makes the path go around it, and undo gives back the hashes', async () => {
  await empty();
  const first = await hashes(page);
  const straight = Math.hypot(84, 59);
  assert.ok(Math.abs((await route()).length - straight) < 1e-9);
  await page.keyboard.press('w');
  await drag(page, [50, 2], [50, 70]);
  await settle(page);
  assert.equal(await itemCount(), 1);
  const around = await route();
  // The path turns at the upper end of the wall. Pixels decide where the wall ends.
  const [, , turnX, turnY] = around.line;
  assert.ok(Math.abs(turnX - 50) < 0.2 && Math.abs(turnY - 70) < 0.2, `${turnX} ${turnY}`);
  const expected = Math.hypot(turnX - 8, turnY - 8) + Math.hypot(92 - turnX, 67 - turnY);
  assert.ok(Math.abs(around.length - expected) < 1e-9);
  assert.notDeepEqual((await hashes(page)).mesh, first.mesh);
  await page.keyboard.press('Control+z');
  await settle(page);
  assert.equal(await itemCount(), 0);
  const back = await hashes(page);
  assert.equal(back.items, first.items);
  assert.equal(back.mesh, first.mesh);
  await page.keyboard.press('Control+Shift+z');
  await settle(page);
  assert.equal((await route()).length, around.length);
  noErrors();
});

test('an obstacle that people drag pushes the path before they let it go', async () => {
  await empty();
  await page.keyboard.press('b');
  await drag(page, [45, 50], [55, 60]);
  await page.keyboard.press('v');
  await settle(page);
  const before = await route();
  const [a, b] = [await pixel(page, 50, 55), await pixel(page, 50, 37)];
  await page.mouse.move(a.x, a.y);
  await page.mouse.down();
  await page.mouse.move(b.x, b.y, { steps: 12 });
  await page.waitForFunction((length) => window.waywright.session.routes.routes[0].length > length + 0.5, before.length);
  assert.equal(await page.evaluate(() => window.waywright.session.document.log.length), 1);
  await page.mouse.up();
  await settle(page);
  assert.equal(await page.evaluate(() => window.waywright.session.document.log.length), 2);
  await page.keyboard.press('Control+z');
  await settle(page);
  assert.equal((await route()).length, before.length);
  noErrors();
});

test('a corner of the selected obstacle can be dragged, and Escape takes a drag back', async () => {
  await empty();
  await page.keyboard.press('b');
  await drag(page, [40, 30], [60, 50]);
  await page.keyboard.press('v');
  await page.mouse.click(...Object.values(await pixel(page, 50, 45)));
  await settle(page);
  const before = await hashes(page);
  await drag(page, [60, 50], [70, 60]);
  await settle(page);
  const points = await page.evaluate(() => [...window.waywright.session.document.items.values()][0].points.join(' '));
  const corner = points.split(' ').map(Number).slice(4, 6);
  assert.ok(Math.abs(corner[0] - 70) < 0.3 && Math.abs(corner[1] - 60) < 0.3, points);
  await page.keyboard.press('Control+z');
  await settle(page);
  assert.equal((await hashes(page)).mesh, before.mesh);
  const [a, b] = [await pixel(page, 50, 40), await pixel(page, 30, 40)];
  await page.mouse.move(a.x, a.y);
  await page.mouse.down();
  await page.mouse.move(b.x, b.y, { steps: 5 });
  await page.keyboard.press('Escape');
  await page.mouse.up();
  await settle(page);
  assert.equal((await hashes(page)).mesh, before.mesh);
  noErrors();
});

test('a path that does not fit is explained by its gap, and the widest path fits', async () => {
  await empty();
  await page.evaluate(async () => {
    const { session } = window.waywright;
    const wall = (id, points) => ({ id, before: null, after: { kind: 'segment', points: Float64Array.from(points) } });
    await session.commit('walls', [wall(1, [50, 0, 50, 30]), wall(2, [50, 34, 50, 75])]);
  });
  await setRadius('3');
  const answer = await route();
  assert.equal(answer.status, 'no-path');
  assert.equal(answer.gap.radius, 2);
  assert.deepEqual([...answer.gap.fromItems, ...answer.gap.toItems].sort(), [1, 2]);
  assert.match(await page.locator('.why').textContent(), /gap of 4 is too narrow: this disc needs 6/);
  await page.getByRole('button', { name: 'Use radius 2' }).click();
  await settle(page);
  assert.equal((await route()).status, 'found');
  await setRadius('3');
  await page.getByRole('button', { name: 'Remove item 1' }).click();
  await settle(page);
  assert.equal((await route()).status, 'found');
  noErrors();
});

/** Puts a wall with a gap of 4 from (50, 30) to (50, 34) into an empty world. */
async function wallWithGap() {
  await empty();
  await page.evaluate(async () => {
    const { session } = window.waywright;
    const wall = (id, points) => ({ id, before: null, after: { kind: 'segment', points: Float64Array.from(points) } });
    await session.commit('walls', [wall(1, [50, 0, 50, 30]), wall(2, [50, 34, 50, 75])]);
  });
  await settle(page);
}

const colourAt = (at) => page.evaluate(async ({ x, y }) => {
  await new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done)));
  const { canvas } = window.waywright.view;
  const ratio = canvas.width / canvas.clientWidth;
  return [...canvas.getContext('2d').getImageData(Math.round(x * ratio), Math.round(y * ratio), 1, 1).data];
}, at);

test('the bridges are drawn, and say which gaps are too narrow for the agent', async () => {
  await wallWithGap();
  await page.getByRole('tab', { name: 'Inside' }).click();
  const gap = await pixel(page, 50, 32);
  const ground = await colourAt(gap);
  await page.getByLabel('Bridges').check();
  await page.waitForFunction(() => window.waywright.view.bridges !== null);
  // The gap, and the lines from both ends of the walls to the borders on the left and on the right.
  assert.deepEqual(await page.evaluate(() => [...window.waywright.view.bridges.bridges]), [
    ...[50, 30, 0, 30, 25], ...[50, 30, 50, 34, 2], ...[50, 30, 100, 30, 25], ...[50, 34, 0, 34, 25], ...[50, 34, 100, 34, 25],
  ]);
  const legend = page.locator('.legend', { hasText: 'too narrow' });
  assert.equal(await legend.textContent(), '5 that the agent passes0 that are too narrow');
  await page.getByRole('tab', { name: 'Path' }).click();
  await setRadius('3');
  await page.getByRole('tab', { name: 'Inside' }).click();
  assert.equal(await legend.textContent(), '4 that the agent passes1 that are too narrow');
  assert.notDeepEqual(await colourAt(gap), ground);
  await page.keyboard.press('Control+z'); // without the walls, there is no gap
  await page.waitForFunction(() => window.waywright.view.bridges?.bridges.length === 0);
  await page.getByLabel('Bridges').uncheck();
  assert.equal(await legend.count(), 0);
  noErrors();
});

test('a search plays as a film of its windows: by steps, by the slider, and by itself', async () => {
  await wallWithGap();
  const around = await route();
  await page.getByRole('tab', { name: 'Inside' }).click();
  const shown = () => page.evaluate(() => {
    const { film } = window.waywright.view;
    return film && { count: film.count, total: film.windows.length / 12, isDone: film.frame.isDone, line: [...film.frame.line],
      window: [...film.windows.subarray(12 * (film.count - 1), 12 * film.count)] };
  });
  assert.equal(await shown(), null);
  const step = page.getByRole('button', { name: 'One step', exact: true });
  await step.click();
  await page.waitForFunction(() => window.waywright.view.film?.count === 1);
  const first = await shown();
  assert.deepEqual(first.window.slice(0, 2), [8, 8]); // the start is the root of the first window
  assert.equal(first.isDone, false);
  await step.click();
  assert.equal((await shown()).count, 2);
  await page.getByRole('button', { name: 'One step back' }).click();
  assert.deepEqual(await shown(), first);
  const slider = page.getByLabel('Step of the search');
  assert.equal(await slider.getAttribute('max'), String(first.total));
  await slider.fill(String(first.total));
  const last = await shown();
  assert.ok(last.isDone && last.count === first.total);
  assert.deepEqual(last.line, around.line);
  await page.getByRole('button', { name: 'Play the search' }).click(); // from the beginning
  await page.waitForFunction(() => window.waywright.view.film.count < 3);
  await page.waitForFunction((total) => window.waywright.view.film.count === total, first.total);
  await page.getByRole('button', { name: 'Play the search' }).waitFor(); // it has ended
  await page.keyboard.press('Control+z'); // another world: the film is over
  await settle(page);
  assert.equal(await shown(), null);
  noErrors();
});

test('the slider of time goes to each step and back', async () => {
  await empty();
  const seen = [await hashes(page)];
  await page.keyboard.press('b');
  for (const x of [20, 40, 60]) {
    await drag(page, [x, 20], [x + 10, 40]);
    await settle(page);
    seen.push(await hashes(page));
  }
  const slider = page.getByLabel('Time: steps of this session');
  for (const step of [0, 2, 1, 3]) {
    await slider.fill(String(step));
    await settle(page);
    assert.equal((await hashes(page)).mesh, seen[step].mesh, `step ${step}`);
  }
  noErrors();
});

test('paint and erase are one step of the log each', async () => {
  await empty();
  await page.keyboard.press('f');
  await drag(page, [20, 40], [80, 40], 20);
  await settle(page);
  const painted = await itemCount();
  assert.ok(painted > 5, String(painted));
  await page.keyboard.press('e');
  await drag(page, [50, 45], [50, 35], 10);
  await settle(page);
  assert.ok((await itemCount()) < painted);
  assert.equal(await page.evaluate(() => window.waywright.session.document.log.length), 2);
  await page.keyboard.press('Control+z');
  await page.keyboard.press('Control+z');
  await settle(page);
  assert.equal(await itemCount(), 0);
  noErrors();
});

test('the keyboard alone draws, selects, moves, removes and moves the ends', async () => {
  await empty();
  await page.locator('#canvas').focus();
  await page.keyboard.press('g');
  for (const keys of [['Shift+ArrowLeft'], ['Shift+ArrowRight', 'Shift+ArrowRight'], ['Shift+ArrowUp', 'Shift+ArrowUp']]) {
    for (const key of keys) await page.keyboard.press(key);
    await page.keyboard.press('Space');
  }
  await page.keyboard.press('Enter');
  await settle(page);
  assert.equal(await itemCount(), 1);
  const drawn = await hashes(page);
  await page.keyboard.press('Control+a');
  await page.keyboard.press('Alt+ArrowLeft');
  await settle(page);
  assert.notEqual((await hashes(page)).items, drawn.items);
  await page.keyboard.press('Control+z');
  await settle(page);
  assert.equal((await hashes(page)).items, drawn.items);
  await page.keyboard.press('Delete');
  await settle(page);
  assert.equal(await itemCount(), 0);
  const before = await page.evaluate(() => ({ ...window.waywright.session.ends.start }));
  await page.keyboard.press('s');
  await settle(page);
  assert.notDeepEqual(await page.evaluate(() => ({ ...window.waywright.session.ends.start })), before);
  await page.keyboard.press('w');
  await page.keyboard.press('Space');
  for (let i = 0; i < 4; ++i) await page.keyboard.press('Shift+ArrowLeft');
  await page.keyboard.press('Space');
  await settle(page);
  assert.equal(await itemCount(), 1);
  assert.notEqual(await page.locator('[aria-live]').textContent(), '');
  noErrors();
});

test('every control has a name, and Tab reaches the controls', async () => {
  await fresh();
  const nameless = await page.evaluate(() =>
    [...document.querySelectorAll('button, input, select')]
      .filter((e) => !(e.getAttribute('aria-label') || e.textContent.trim() || e.labels?.length))
      .map((e) => e.outerHTML.slice(0, 80)));
  assert.deepEqual(nameless, []);
  const reached = new Set();
  for (let i = 0; i < 40; ++i) {
    await page.keyboard.press('Tab');
    reached.add(await page.evaluate(() => document.activeElement.getAttribute('aria-label') ?? document.activeElement.textContent));
  }
  for (const name of ['Wall', 'Examples', 'Check', 'Share', 'Path']) assert.ok([...reached].some((each) => each?.startsWith(name)), name);
});

test('a refused shape is explained in place, and nothing is lost', async () => {
  await empty();
  await page.keyboard.press('b');
  await drag(page, [40, 30], [50, 40]);
  await settle(page);
  const before = await hashes(page);
  await page.keyboard.press('p');
  await page.mouse.click(...Object.values(await pixel(page, 50, -1)));
  await settle(page);
  assert.match(await page.locator('.note').textContent(), /leave the domain/);
  assert.equal((await hashes(page)).mesh, before.mesh);
  noErrors();
});

test('a link gives the same world, log and query', async () => {
  await fresh();
  await page.keyboard.press('w');
  await drag(page, [120, 160], [200, 200]);
  await drag(page, [220, 160], [260, 200]);
  await settle(page);
  const [first, answer] = [await hashes(page), await route()];
  const address = await page.evaluate(() => window.waywright.files.share());
  assert.ok(address.length > 100);
  await fresh(address.slice(address.indexOf('#')));
  assert.deepEqual({ ...(await hashes(page)), version: 0 }, { ...first, version: 0 });
  assert.equal((await route()).length, answer.length);
  await page.keyboard.press('Control+z');
  await page.keyboard.press('Control+z');
  await settle(page);
  await page.reload();
  await page.waitForSelector('html[data-ready]');
  await settle(page);
  assert.equal((await hashes(page)).mesh, first.mesh);
  noErrors();
});

test('a damaged link says so and opens the first example', async () => {
  await fresh('#AQIDBAUGBwgJCgsM');
  assert.match(await page.locator('.toasts').textContent(), /link/i);
  assert.ok((await itemCount()) > 100);
  noErrors();
});

test('broken files are refused with what, where and what to do; the world stays', async () => {
  await fresh();
  const before = await hashes(page);
  const files = [
    ['broken.wws', 'waywright 1\ndomain 0 0 10 10\npolygon 1 3 1 1 2 x 3 3\n', /line 3/],
    ['empty.map', '', /empty/],
    ['picture.geojson', '{"type": "FeatureCollection", "features": [', /./],
    ['strange.xyz', 'hello', /format/],
  ];
  for (const [name, text, expected] of files) {
    await page.locator('input[type=file]').setInputFiles({ name, mimeType: 'text/plain', buffer: Buffer.from(text) });
    await page.locator('.toast', { hasText: name }).waitFor();
    assert.match(await page.locator('.toast', { hasText: name }).textContent(), expected);
  }
  await settle(page);
  assert.equal((await hashes(page)).mesh, before.mesh);
  noErrors();
});

test('the page names the lines of a script that every world refuses, and opens the rest', async () => {
  await fresh();
  const text = 'waywright 1\ndomain 0 0 10 10\npoint 1 1 1\npoint 1 2 2\nmark 1\npoint 4 3 3\nremove 9\n';
  await page.locator('input[type=file]').setInputFiles({ name: 'twice.wws', mimeType: 'text/plain', buffer: Buffer.from(text) });
  const toast = page.locator('.toast', { hasText: '2 lines were refused' });
  await toast.waitFor();
  assert.match(await toast.textContent(), /line 4: an item has id 1 already; line 7: no item has id 9/);
  assert.equal(await itemCount(), 2);
  await page.keyboard.press('Control+z');
  await settle(page);
  assert.equal(await itemCount(), 1);
  noErrors();
});

test('files of each format open', async () => {
  await fresh();
  const geojson = JSON.stringify({ type: 'Polygon', coordinates: [[[1, 1], [4, 1], [4, 3], [1, 1]]] });
  const files = [
    ['one.wws', 'waywright 1\ndomain 0 0 10 10\npolygon 5 3 1 1 4 1 4 3\npath 0.5 0.5 9 9 0\n', 1],
    ['two.map', 'type octile\nheight 3\nwidth 4\nmap\n....\n.@@.\n....\n', 1],
    ['three.geojson', geojson, 1],
    ['four.poly', '3 2 0 0\n1 0 0\n2 5 0\n3 0 5\n2 0\n1 1 2\n2 2 3\n0\n', 2],
  ];
  for (const [name, text, least] of files) {
    await page.locator('input[type=file]').setInputFiles({ name, mimeType: 'text/plain', buffer: Buffer.from(text) });
    await page.waitForFunction((title) => window.waywright.session.document.title === title, name);
    await settle(page);
    assert.ok((await itemCount()) >= least, name);
  }
  noErrors();
});

test('each example first shows its ends and its items, and the key 0 also shows its whole domain', async () => {
  await fresh();
  const seen = () => page.evaluate(() => {
    const { session, view } = window.waywright;
    const [low, high] = [{ x: 60, y: 60 }, { x: 940, y: 720 }];
    const screen = (x, y) => view.camera.toScreen({ x, y });
    const onScreen = (x, y) => {
      const at = screen(x, y);
      return at.x > low.x && at.x < high.x && at.y > low.y && at.y < high.y ? 1 : 0;
    };
    /** The corners of the box of each item, or of the part of it that is on the screen. */
    const clamp = (at) => ({ x: Math.min(high.x, Math.max(low.x, at.x)), y: Math.min(high.y, Math.max(low.y, at.y)) });
    const shown = [...session.document.items.keys()].flatMap((id) => {
      const [x0, y0, x1, y1] = session.document.boundsOf(id);
      const [a, b] = [screen(x0, y1), screen(x1, y0)];
      const isShown = a.x < high.x && b.x > low.x && Math.min(a.y, b.y) < high.y && Math.max(a.y, b.y) > low.y;
      return isShown ? [clamp(a), clamp(b)] : [];
    });
    const all = [...session.document.items.values()].flatMap(({ points }) => [...points]);
    // The items of one example lie on one line.
    const isLine = (axis) => all.every((value, i) => i % 2 !== axis || value === all[axis]);
    const extent = (name, axis) => isLine(axis)
      ? Infinity
      : Math.max(...shown.map((at) => at[name])) - Math.min(...shown.map((at) => at[name]));
    const [x0, y0, x1, y1] = session.document.domain;
    const { start, goal } = session.ends;
    return {
      ends: onScreen(start.x, start.y) + onScreen(goal.x, goal.y),
      extents: [extent('x', 0), extent('y', 1)],
      frame: onScreen(x0, y0) + onScreen(x1, y1),
    };
  });
  for (const id of await page.evaluate(() => window.waywright.files.exampleIds)) {
    await page.evaluate((name) => (location.hash = `#example=${name}`), id);
    await settle(page);
    const { ends, extents } = await seen();
    assert.equal(ends, 2, id);
    assert.ok(extents.every((extent) => extent > 100), `${id}: the items on the screen extend over ${extents} pixels`);
    await page.locator('#canvas').focus();
    await page.keyboard.press('0');
    const first = (await seen()).frame;
    await page.keyboard.press('0');
    assert.ok(first === 2 || (await seen()).frame === 2, id);
  }
  noErrors();
});

test('at the largest zooms, items are drawn where the path and the pointer have them', async () => {
  await fresh('#example=neighbouring-doubles');
  const colours = await page.evaluate(() => {
    const { view } = window.waywright;
    const context = view.canvas.getContext('2d');
    const ratio = view.canvas.width / view.camera.width;
    return [[0, 14], [14, 14], [14, 0]].map(([i, j]) => {
      const at = view.camera.toScreen({ x: 1 + i * 2 ** -52, y: 1 + j * 2 ** -52 });
      return [...context.getImageData(at.x * ratio, at.y * ratio, 1, 1).data.slice(0, 3)].join();
    });
  });
  // The colour of points, and of the wall that ends at the first one, in the light theme.
  assert.deepEqual(colours, ['34,48,60', '86,120,154', '86,120,154']);
  noErrors();
});

test('after a crash of the module the page restores the last world', async () => {
  await empty();
  await page.keyboard.press('b');
  await drag(page, [40, 30], [50, 40]);
  await settle(page);
  const before = await hashes(page);
  await page.evaluate(() => window.waywright.session.engine.ask('crash').catch(() => {}));
  await page.locator('.toast', { hasText: 'nothing is lost' }).waitFor();
  await page.evaluate(() => (window.waywright.session.hashes = null));
  await page.keyboard.press('b');
  await drag(page, [60, 30], [70, 40]);
  await page.keyboard.press('Control+z');
  await settle(page);
  assert.equal((await hashes(page)).mesh, before.mesh);
  assert.equal(await page.evaluate(() => window.waywright.session.document.log.length), 2);
});

test('check validates the world', async () => {
  await fresh();
  await page.locator('#check').click();
  await page.locator('.toast', { hasText: 'The world is valid' }).waitFor({ timeout: 60_000 });
  noErrors();
});

test('on a phone, fingers draw and two fingers zoom', async () => {
  await fresh('', { viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true });
  await page.getByRole('tab', { name: 'World' }).tap();
  await page.getByRole('button', { name: 'Empty world' }).tap();
  await page.getByRole('tab', { name: 'World' }).tap();
  await page.getByRole('button', { name: 'Point', exact: true }).tap();
  await settle(page);
  const { x, y } = await pixel(page, 50, 40);
  await page.touchscreen.tap(x, y);
  await settle(page);
  assert.equal(await itemCount(), 1);
  const scale = await page.evaluate(() => window.waywright.view.camera.scale);
  const session = await page.context().newCDPSession(page);
  const touch = (type, spread) => session.send('Input.dispatchTouchEvent', {
    type, touchPoints: spread === null ? [] : [{ x: x - spread, y, id: 1 }, { x: x + spread, y, id: 2 }],
  });
  await touch('touchStart', 30);
  for (const spread of [40, 50, 60]) await touch('touchMove', spread);
  await touch('touchEnd', null);
  assert.ok((await page.evaluate(() => window.waywright.view.camera.scale)) > 1.5 * scale);
  assert.equal(await itemCount(), 1);
  noErrors();
});

test('a crowd walks, and goes on while people build', async () => {
  await fresh();
  await page.getByRole('tab', { name: 'Crowd' }).click();
  await page.getByRole('button', { name: 'Start the crowd' }).click();
  await page.waitForFunction(() => window.waywright.view.units?.states.length === 3000);
  await page.waitForFunction(() => {
    const { states } = window.waywright.view.units;
    return states.filter((state, i) => i % 3 === 2 && state === 1).length > 900;
  }, null, { timeout: 60_000 });
  const positions = () => page.evaluate(() => [...window.waywright.view.units.states.slice(0, 300)]);
  const first = await positions();
  await page.keyboard.press('w');
  await drag(page, [120, 160], [200, 200]);
  await page.waitForTimeout(300);
  const second = await positions();
  const moved = first.filter((value, i) => i % 3 !== 2 && value !== second[i]).length;
  assert.ok(moved > 100, `${moved} coordinates changed`);
  await page.getByRole('button', { name: 'Stop' }).click();
  noErrors();
});
