// usage: node playground/record.mjs FOLDER
// Takes the frames of the moving picture of README.md: a box is drawn and dragged through the path, then the agent shrinks, then the
// mesh is shown. The frames are FOLDER/000.png, FOLDER/001.png and so on.
import { mkdirSync } from 'node:fs';
import { join } from 'node:path';
import { launch, openPage, pixel, serve, settle } from './tests/support.mjs';

const folder = process.argv[2];
if (folder === undefined) throw new Error('usage: node playground/record.mjs FOLDER');
mkdirSync(folder, { recursive: true });
const { server, base } = await serve();
const browser = await launch();
try {
  const page = await openPage(browser, base, { viewport: { width: 1120, height: 700 }, colorScheme: 'light' });
  await settle(page);
  let count = 0;
  const take = async () => {
    await settle(page);
    await page.evaluate(() => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done))));
    await page.screenshot({ path: join(folder, `${String(count++).padStart(3, '0')}.png`) });
  };
  const hold = async (frames) => {
    for (let i = 0; i < frames; ++i) await take();
  };
  const along = async (from, to, frames) => {
    const [a, b] = [await pixel(page, ...from), await pixel(page, ...to)];
    await page.mouse.move(a.x, a.y);
    await page.mouse.down();
    for (let i = 1; i <= frames; ++i) {
      const part = (1 - Math.cos((Math.PI * i) / frames)) / 2;
      await page.mouse.move(a.x + part * (b.x - a.x), a.y + part * (b.y - a.y));
      await take();
    }
    await page.mouse.up();
  };
  await hold(4);
  await page.keyboard.press('b');
  await along([262, 244], [284, 222], 6);
  await page.keyboard.press('v');
  await along([273, 233], [300, 205], 10);
  await along([300, 205], [330, 250], 10);
  await page.getByRole('tab', { name: 'Path' }).click();
  const radius = page.getByLabel('Radius as a number');
  for (const value of [1.75, 1.5, 1.25, 1, 0.75, 0.5]) {
    await radius.fill(String(value));
    await page.keyboard.press('Enter');
    await take();
  }
  await hold(3);
  await page.getByRole('tab', { name: 'Inside' }).click();
  await page.getByLabel('Triangles', { exact: true }).check();
  await hold(3);
  await along([330, 250], [262, 236], 14);
  await hold(6);
} finally {
  await browser.close();
  server.close();
}
