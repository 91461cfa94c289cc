// usage: node tests/screenshots.mjs FOLDER [NAME...]
// Draws a screenshot of each feature of the built page, for people to look at.
import { mkdirSync } from 'node:fs';
import { join } from 'node:path';
import { drag, launch, openPage, pixel, serve, settle } from './support.mjs';

const [folder = 'screenshots', ...wanted] = process.argv.slice(2);
const PHONE = { viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true, deviceScaleFactor: 2 };

const tab = (page, name) => page.getByRole('tab', { name }).click();
const button = (page, name) => page.getByRole('button', { name, exact: true }).click();

async function empty(page) {
  await tab(page, 'World');
  await button(page, 'Empty world');
  await tab(page, 'Path');
  await settle(page);
}

async function twoWalls(page) {
  await empty(page);
  await page.evaluate(async () => {
    const { session } = window.waywright;
    const wall = (id, points) => ({ id, before: null, after: { kind: 'polygon', points: Float64Array.from(points) } });
    await session.commit('walls', [wall(1, [46, 0, 52, 0, 50, 34]), wall(2, [50, 40, 54, 75, 44, 75])]);
  });
}

async function radius(page, text) {
  await page.getByLabel('Radius as a number').fill(text);
  await page.keyboard.press('Enter');
  await settle(page);
}

async function draw(page) {
  await empty(page);
  await page.keyboard.press('w');
  await drag(page, [20, 10], [30, 50]);
  await page.keyboard.press('b');
  await drag(page, [40, 30], [55, 45]);
  await page.keyboard.press('g');
  for (const at of [[62, 20], [75, 25], [72, 45]]) await page.mouse.click(...Object.values(await pixel(page, ...at)));
  await page.keyboard.press('Enter');
  await page.keyboard.press('p');
  for (const at of [[12, 40], [14, 44], [60, 60]]) await page.mouse.click(...Object.values(await pixel(page, ...at)));
  await page.keyboard.press('f');
  await drag(page, [30, 62], [55, 66], 20);
}

async function paintErase(page) {
  await draw(page);
  await page.keyboard.press('e');
  await drag(page, [42, 70], [42, 58], 10);
}

async function compare(page) {
  await page.getByLabel('Draw all three').check();
  await page.waitForTimeout(1500);
}

/** A film of the search, at a part of its length: from 0 to 1. */
const film = (part) => async (page) => {
  await tab(page, 'Inside');
  await button(page, 'One step');
  const slider = page.getByLabel('Step of the search');
  await page.waitForFunction(() => window.waywright.view.film !== null);
  await slider.fill(String(Math.round(part * Number(await slider.getAttribute('max')))));
};

async function bridges(page) {
  await tab(page, 'Inside');
  await page.getByLabel('Bridges').check();
  await page.waitForFunction(() => window.waywright.view.bridges !== null);
}

const faces = (name) => async (page) => {
  await tab(page, 'Inside');
  await page.getByLabel(name, { exact: true }).check();
};

async function circles(page) {
  await faces('Triangles')(page);
  await page.getByLabel(/Circumcircle/).check();
  await page.mouse.move(520, 420);
}

async function touched(page) {
  await tab(page, 'Inside');
  await page.getByLabel(/touched/).check();
  await page.keyboard.press('b');
  const view = await page.evaluate(() => window.waywright.view.camera.bounds());
  const at = (part) => [view[0] + part * (view[2] - view[0]), view[1] + 0.55 * (view[3] - view[1])];
  await drag(page, at(0.3), [at(0.34)[0], at(0.3)[1] + 0.05 * (view[3] - view[1])]);
}

async function crowd(page) {
  await tab(page, 'Crowd');
  await button(page, 'Start the crowd');
  await page.waitForTimeout(5000);
  await page.keyboard.press('w');
  await drag(page, [120, 160], [260, 220], 20);
  await page.waitForTimeout(400);
}

async function select(page) {
  await draw(page);
  await page.keyboard.press('v');
  await drag(page, [47, 38], [50, 52]);
}

async function keyboard(page) {
  await empty(page);
  await page.locator('#canvas').focus();
  await page.keyboard.press('g');
  for (const key of ['Shift+ArrowLeft', 'Space', 'Shift+ArrowUp', 'Shift+ArrowUp', 'Space', 'Shift+ArrowRight']) await page.keyboard.press(key);
}

async function refused(page) {
  await draw(page);
  await page.keyboard.press('p');
  await page.mouse.click(...Object.values(await pixel(page, 50, -1)));
}

async function crash(page) {
  await page.evaluate(() => window.waywright.session.engine.ask('crash').catch(() => {}));
  await page.locator('.toast', { hasText: 'nothing is lost' }).waitFor();
}

async function broken(page) {
  const buffer = Buffer.from('waywright 1\ndomain 0 0 10 10\npolygon 1 3 1 1 2 x 3 3\n');
  await page.locator('input[type=file]').setInputFiles({ name: 'broken.wws', mimeType: 'text/plain', buffer });
}

async function drop(page) {
  await page.evaluate(() => {
    const data = new DataTransfer();
    data.items.add(new File(['{}'], 'a.json'));
    window.dispatchEvent(new DragEvent('dragover', { dataTransfer: data, cancelable: true }));
  });
}

async function time(page) {
  await draw(page);
  await page.getByLabel('Time: steps of this session').fill('3');
  await settle(page);
}

const then = (...acts) => async (page) => {
  for (const act of acts) await act(page);
};

const SCENES = {
  first: [''],
  dark: ['', null, { colorScheme: 'dark' }],
  draw: ['', draw],
  select: ['', select],
  erase: ['', paintErase],
  time: ['', time],
  compare: ['', compare],
  why: ['', then(twoWalls, (page) => radius(page, '4'))],
  blocked: ['', then(twoWalls, (page) => radius(page, '9'))],
  widest: ['', then(twoWalls, (page) => page.getByLabel('Widest path').check())],
  channel: ['', then((page) => radius(page, '0'), (page) => page.getByLabel('Triangles on the path').check())],
  mesh: ['', faces('Triangles')],
  circles: ['', circles],
  components: ['#example=city', faces('Components')],
  corridors: ['', faces('Corridors')],
  film: ['', then((page) => radius(page, '0'), film(0.5))],
  film_end: ['', then((page) => radius(page, '0'), film(1))],
  film_disc: ['', film(0.5)],
  film_dark: ['', then((page) => radius(page, '0'), film(0.7)), { colorScheme: 'dark' }],
  bridges: ['', bridges],
  bridges_narrow: ['', then(twoWalls, (page) => radius(page, '4'), bridges)],
  bridges_city: ['#example=city', bridges],
  touched: ['', touched],
  crowd: ['', crowd],
  crowd_dark: ['', crowd, { colorScheme: 'dark' }],
  world: ['', (page) => tab(page, 'World')],
  shelf: ['', (page) => button(page, 'Examples')],
  keys: ['', (page) => button(page, 'Keys')],
  keyboard: ['', keyboard],
  check: ['', then((page) => page.locator('#check').click(), (page) => page.locator('.toast').waitFor())],
  share: ['', (page) => button(page.locator('header'), 'Share')],
  refused: ['', refused],
  broken: ['', broken],
  crash: ['', crash],
  drop: ['', drop],
  phone: ['', null, PHONE],
  phone_panel: ['', (page) => tab(page, 'Path'), PHONE],
};

/** The examples of the shelf, one screenshot each. */
async function addExamples(browser, base) {
  const page = await openPage(browser, base);
  await button(page, 'Examples');
  const ids = await page.evaluate(() => window.waywright.files.exampleIds);
  for (const id of ids) SCENES[`example_${id}`] = [`#example=${id}`];
  await page.context().close();
}

const { server, base } = await serve();
const browser = await launch();
mkdirSync(folder, { recursive: true });
try {
  await addExamples(browser, base);
  for (const [name, [fragment, act, options]] of Object.entries(SCENES)) {
    if (wanted.length > 0 && !wanted.includes(name)) continue;
    const page = await openPage(browser, base + fragment, options);
    await settle(page);
    await act?.(page);
    if (!['touched', 'crowd', 'crowd_dark'].includes(name)) await settle(page);
    await page.waitForTimeout(200);
    await page.screenshot({ path: join(folder, `${name}.png`) });
    if (page.errors.length > 0) console.log(name, page.errors.map(String));
    await page.context().close();
  }
} finally {
  await browser.close();
  server.close();
}
