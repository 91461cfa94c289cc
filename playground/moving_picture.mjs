// usage: node moving_picture.mjs [FILE]
// Draws the moving picture of README.md, an animated WebP, from frames of the built page in Chromium.
import { writeFileSync } from 'node:fs';
import { fileURLToPath } from 'node:url';
import { launch, openPage, pixel, serve, settle } from './tests/support.mjs';

const [path = fileURLToPath(new URL('../docs/images/playground.webp', import.meta.url))] = process.argv.slice(2);
const SIZE = { width: 1024, height: 640 };
const FRAME_MILLISECONDS = 70;
const QUALITY = 0.6;

/** One chunk of a RIFF file. */
function chunk(name, ...pieces) {
  const data = Buffer.concat(pieces);
  const head = Buffer.alloc(8);
  head.write(name, 'latin1');
  head.writeUInt32LE(data.length, 4);
  return Buffer.concat([head, data, Buffer.alloc(data.length % 2)]);
}

function uint24(...values) {
  const bytes = Buffer.alloc(3 * values.length);
  values.forEach((value, i) => bytes.writeUIntLE(value, 3 * i, 3));
  return bytes;
}

/** The image chunks of a WebP file. */
function imageOf(webp) {
  const pieces = [];
  for (let at = 12; at < webp.length; ) {
    const size = webp.readUInt32LE(at + 4);
    const end = at + 8 + size + (size % 2);
    if (['VP8 ', 'VP8L', 'ALPH'].includes(webp.toString('latin1', at, at + 4))) pieces.push(webp.subarray(at, end));
    at = end;
  }
  return Buffer.concat(pieces);
}

/** Joins frames to one WebP file: https://developers.google.com/speed/webp/docs/riff_container */
function animate(frames) {
  const header = chunk('VP8X', Buffer.from([2, 0, 0, 0]), uint24(SIZE.width - 1, SIZE.height - 1));
  const loop = chunk('ANIM', Buffer.alloc(6));
  const images = frames.map(({ box: [x, y, width, height], milliseconds, webp }) =>
    chunk('ANMF', uint24(x / 2, y / 2, width - 1, height - 1, milliseconds), Buffer.from([2]), imageOf(webp)));
  const body = Buffer.concat([Buffer.from('WEBP'), header, loop, ...images]);
  return chunk('RIFF', body);
}

/** Runs on the page `about:blank`: keeps the last frame, and encodes the box in which the new one differs. */
async function encode({ png, size: { width, height }, quality }) {
  const image = new Image();
  image.src = `data:image/png;base64,${png}`;
  await image.decode();
  const canvas = Object.assign(document.createElement('canvas'), { width, height });
  const context = canvas.getContext('2d', { willReadFrequently: true });
  context.drawImage(image, 0, 0, width, height);
  const now = new Uint32Array(context.getImageData(0, 0, width, height).data.buffer);
  const before = (window.last ??= new Uint32Array(now.length));
  let [x0, y0, x1, y1] = [width, height, -1, -1];
  for (let i = 0; i < now.length; ++i) {
    if (now[i] === before[i]) continue;
    const [x, y] = [i % width, Math.floor(i / width)];
    [x0, y0, x1, y1] = [Math.min(x0, x), Math.min(y0, y), Math.max(x1, x), Math.max(y1, y)];
  }
  window.last = now;
  if (x1 < 0) return null;
  [x0, y0] = [x0 - (x0 % 2), y0 - (y0 % 2)];
  const part = Object.assign(document.createElement('canvas'), { width: x1 - x0 + 1, height: y1 - y0 + 1 });
  part.getContext('2d').drawImage(canvas, -x0, -y0);
  const url = part.toDataURL('image/webp', quality);
  return { box: [x0, y0, part.width, part.height], data: url.slice(url.indexOf(',') + 1) };
}

class Camera {
  frames = [];

  constructor(page, encoder) {
    Object.assign(this, { page, encoder });
  }

  async shoot(milliseconds = FRAME_MILLISECONDS) {
    await this.page.evaluate(async () => {
      await window.waywright.session.settled();
      await new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done)));
    });
    const png = (await this.page.screenshot()).toString('base64');
    const frame = await this.encoder.evaluate(encode, { png, size: SIZE, quality: QUALITY });
    if (frame === null) this.frames.at(-1).milliseconds += milliseconds;
    else this.frames.push({ box: frame.box, milliseconds, webp: Buffer.from(frame.data, 'base64') });
  }
}

/** Moves the pressed mouse along positions of the world, with a frame for each step. */
async function dragAlong(page, camera, positions, steps) {
  const pixels = [];
  for (const at of positions) pixels.push(await pixel(page, ...at));
  await page.mouse.move(pixels[0].x, pixels[0].y);
  await page.mouse.down();
  for (let i = 1; i < pixels.length; ++i) {
    for (let k = 1; k <= steps; ++k) {
      const [a, b, part] = [pixels[i - 1], pixels[i], 0.5 - Math.cos((Math.PI * k) / steps) / 2];
      await page.mouse.move(a.x + part * (b.x - a.x), a.y + part * (b.y - a.y));
      await camera.shoot();
    }
  }
  await page.mouse.up();
}

/** Drags an end, draws a wall, compares the algorithms, shows the widest path, and starts a crowd. */
async function play(page, camera) {
  await camera.shoot(700);
  await dragAlong(page, camera, [[422, 304], [300, 60], [440, 90]], 9);
  await page.keyboard.press('w');
  await dragAlong(page, camera, [[180, 130], [330, 60]], 8);
  await camera.shoot(500);
  await page.getByLabel('Draw all three').check();
  await settle(page);
  await camera.shoot(1200);
  await page.getByLabel('Draw all three').uncheck();
  await page.getByLabel('Widest path').check();
  await settle(page);
  await camera.shoot(1600);
  await page.getByLabel('Widest path').uncheck();
  await page.getByRole('tab', { name: 'Crowd' }).click();
  await page.getByRole('button', { name: 'Start the crowd' }).click();
  await page.waitForTimeout(8000);
  for (let i = 0; i < 10; ++i) await camera.shoot(130);
}

const { server, base } = await serve();
const browser = await launch();
try {
  const page = await openPage(browser, base, { viewport: SIZE });
  const encoder = await browser.newPage();
  await settle(page);
  await page.waitForTimeout(800);
  const camera = new Camera(page, encoder);
  await play(page, camera);
  const file = animate(camera.frames);
  writeFileSync(path, file);
  console.log(`${path}: ${camera.frames.length} frames, ${(file.length / 1e6).toFixed(2)} MB`);
  if (page.errors.length > 0) throw page.errors[0];
} finally {
  await browser.close();
  server.close();
}
