// usage: node tests/measure.mjs
// Prints how long the frames of the page take: a drag among 10,000 obstacles, a pan, 1,000 units; and the size of a visit.
// The time between frames is never less than the period of the screen, 16.67 ms at 60 Hz. The work of a frame is what the
// main thread of the page does from one frame to the next one: events, scripts, layout and painting.
import { readdirSync, readFileSync } from 'node:fs';
import { join } from 'node:path';
import { gzipSync } from 'node:zlib';
import { launch, openPage, ROOT, serve, settle } from './support.mjs';
import { frameWork, TRACED } from './frame_work.mjs';

/** The gzip size of the files that a first visit loads. */
function transferSize() {
  const files = readdirSync(ROOT, { recursive: true, withFileTypes: true }).filter((file) => file.isFile());
  const visited = files.filter(({ name }) => !name.startsWith('waywright-playground') && name !== 'sw.js');
  return visited.reduce((sum, { parentPath, name }) => sum + gzipSync(readFileSync(join(parentPath, name)), { level: 9 }).length, 0);
}

function summarise(name, times) {
  const sorted = [...times].sort((a, b) => a - b);
  const at = (part) => sorted[Math.floor(part * (sorted.length - 1))].toFixed(2);
  console.log(`${name}: ${sorted.length} samples, median ${at(0.5)} ms, p95 ${at(0.95)} ms, largest ${at(1)} ms`);
}

/** Opens a world of 10,000 octagons that do not touch. */
async function openLarge(page) {
  const text = ['waywright 1', 'domain 0 0 1000 1000'];
  for (let i = 0; i < 10_000; ++i) {
    const [x, y] = [5 + 10 * (i % 100) + Math.sin(7 * i), 5 + 10 * Math.floor(i / 100) + Math.cos(5 * i)];
    const corners = Array.from({ length: 8 }, (_, k) => `${x + 3 * Math.cos((k * Math.PI) / 4)} ${y + 3 * Math.sin((k * Math.PI) / 4)}`);
    text.push(`polygon ${i + 1} 8 ${corners.join(' ')}`);
  }
  text.push('path 0.5 0.5 999.5 999.5 0.5');
  await page.locator('input[type=file]').setInputFiles({ name: 'large.wws', mimeType: 'text/plain', buffer: Buffer.from(text.join('\n') + '\n') });
  await page.waitForFunction(() => window.waywright.session.document.title === 'large.wws', null, { timeout: 120_000 });
  await settle(page);
}

/** Records the times between frames, the times of drawing, and the round trips of the engine, while `act` runs. */
async function record(page, act) {
  await page.evaluate(() => {
    const { view, session } = window.waywright;
    view.frameTimes.length = 0;
    window.record = { frames: [], trips: [], changes: [], searches: [], isRunning: true };
    let last = performance.now();
    const frame = (now) => {
      window.record.frames.push(now - last);
      last = now;
      if (window.record.isRunning) requestAnimationFrame(frame);
    };
    requestAnimationFrame(frame);
    const { engine } = session;
    const ask = (window.originalAsk ??= engine.ask.bind(engine));
    engine.ask = async (name, ...args) => {
      const begin = performance.now();
      const answer = await ask(name, ...args);
      if (name !== 'edit') return answer;
      window.record.trips.push(performance.now() - begin);
      window.record.changes.push(answer.summary.milliseconds);
      window.record.searches.push(answer.routes.routes[0].milliseconds);
      return answer;
    };
  });
  await act();
  return page.evaluate(() => {
    window.record.isRunning = false;
    return { ...window.record, draws: [...window.waywright.view.frameTimes] };
  });
}

/** Prints the work of each frame while `act` runs. The trace itself costs time, so this is another run than record(). */
async function summariseWork(name, page, act) {
  await browser.startTracing(page, { categories: TRACED });
  await act();
  const { time, processor } = frameWork(JSON.parse((await browser.stopTracing()).toString()));
  summarise(`${name}, work of a frame`, time);
  summarise(`${name}, processor time of a frame`, processor);
}

async function dragObstacle(page) {
  const at = (x, y) => page.evaluate(([a, b]) => window.waywright.view.camera.toScreen({ x: a, y: b }), [x, y]);
  const a = await at(505, 505);
  await page.mouse.move(a.x, a.y);
  await page.mouse.down();
  for (let i = 0; i < 240; ++i) {
    await page.mouse.move(a.x + 40 * Math.sin(i / 12), a.y + 30 * Math.sin(i / 17));
    await page.waitForTimeout(4);
  }
  // The next drag finds the obstacle where this one has found it.
  await page.mouse.move(a.x, a.y);
  await page.mouse.up();
  await settle(page);
}

async function setRadius(page, radius) {
  await page.getByLabel('Radius as a number').fill(String(radius));
  await page.keyboard.press('Enter');
  await settle(page);
}

async function panAndZoom(page) {
  await page.mouse.move(500, 400);
  await page.mouse.down({ button: 'right' });
  for (let i = 0; i < 120; ++i) await page.mouse.move(500 + 150 * Math.sin(i / 10), 400 + 80 * Math.sin(i / 14));
  await page.mouse.up({ button: 'right' });
  for (let i = 0; i < 30; ++i) await page.mouse.wheel(0, i < 15 ? -60 : 60);
}

const { server, base } = await serve();
const browser = await launch();
try {
  const begin = Date.now();
  const page = await openPage(browser, base);
  console.log(`transfer (gzip): ${(transferSize() / 1e6).toFixed(3)} MB; world on the screen after ${Date.now() - begin} ms`);
  const paint = await page.evaluate(() => performance.getEntriesByName('first-contentful-paint')[0]?.startTime);
  console.log(`first contentful paint: ${paint?.toFixed(0)} ms`);
  await page.getByRole('tab', { name: 'Crowd' }).click();
  await page.getByRole('button', { name: 'Start the crowd' }).click();
  await page.waitForTimeout(6000);
  const crowd = await record(page, () => page.waitForTimeout(5000));
  summarise('1,000 units, between frames', crowd.frames);
  summarise('1,000 units, drawing of a frame', crowd.draws);
  await summariseWork('1,000 units', page, () => page.waitForTimeout(3000));
  console.log(`1,000 units, p95 of a tick: ${await page.locator('dt:text("95th") + dd').textContent()}`);
  await page.getByRole('button', { name: 'Stop' }).click();
  await page.getByRole('tab', { name: 'Path' }).click();
  await openLarge(page);
  for (const radius of [0.5, 0]) {
    await setRadius(page, radius);
    const name = `10,000 obstacles, radius ${radius}, drag`;
    const drag = await record(page, () => dragObstacle(page));
    summarise(`${name}, between frames`, drag.frames);
    summarise(`${name}, drawing of a frame`, drag.draws);
    summarise(`${name}, change and path, until the page has them`, drag.trips);
    summarise(`${name}, change`, drag.changes);
    summarise(`${name}, path`, drag.searches);
    await summariseWork(name, page, () => dragObstacle(page));
  }
  const pan = await record(page, () => panAndZoom(page));
  summarise('10,000 obstacles, pan and zoom, between frames', pan.frames);
  summarise('10,000 obstacles, pan and zoom, drawing of a frame', pan.draws);
  if (process.env.WAYWRIGHT_SCREENSHOT) await page.screenshot({ path: process.env.WAYWRIGHT_SCREENSHOT });
  if (page.errors.length > 0) throw page.errors[0];
} finally {
  await browser.close();
  server.close();
}
