// Makes 10,000 edits on the page, and compares the hashes with those of the native command.
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { mkdtempSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { hashes, launch, openPage, serve, settle, test } from './support.mjs';

const COMMAND = process.env.WAYWRIGHT_COMMAND;
const EDITS = Number(process.env.WAYWRIGHT_EDITS ?? 10_000);

/** Runs on the page: inserts, moves and removes items at random, and sometimes goes back. */
async function edit(count) {
  const { session } = window.waywright;
  let state = 12345;
  const random = () => {
    state = (Math.imul(state, 1664525) + 1013904223) >>> 0;
    return state / 2 ** 32;
  };
  const shape = () => {
    const [x, y, size] = [10 + 480 * random(), 10 + 360 * random(), 1 + 7 * random()];
    const kind = ['point', 'segment', 'polyline', 'polygon'][Math.floor(4 * random())];
    const corners = { point: 1, segment: 2, polyline: 4, polygon: 3 + Math.floor(6 * random()) }[kind];
    const points = new Float64Array(2 * corners);
    for (let i = 0; i < points.length; ++i) points[i] = (i % 2 === 0 ? x : y) + size * (2 * random() - 1);
    return { kind, points };
  };
  for (let i = 0; i < count; ++i) {
    const { items } = session.document;
    const ids = i % 50 === 0 || i === 0 ? (window.ids = [...items.keys()]) : window.ids;
    const id = ids[Math.floor(random() * ids.length)];
    const before = items.get(id);
    const choice = random();
    if (choice < 0.05) {
      for (let k = 0; k < 3; ++k) session.undo();
      await session.settled();
    } else if (choice < 0.5 || before === undefined) {
      await session.commit('insert', [{ id: session.document.takeId(), before: null, after: shape() }]);
    } else if (choice < 0.75) {
      await session.commit('remove', [{ id, before, after: null }]);
    } else {
      await session.commit('move', [{ id, before, after: shape() }]);
    }
  }
}

test(`${EDITS} edits on the page end with the native hashes, and the link gives them again`, { timeout: 1_200_000 }, async (t) => {
  if (COMMAND === undefined) return t.skip('WAYWRIGHT_COMMAND, the path of the native command, is not set');
  const { server, base } = await serve();
  const browser = await launch();
  const folder = mkdtempSync(join(tmpdir(), 'waywright-'));
  try {
    const page = await openPage(browser, base);
    for (let done = 0; done < EDITS; done += 1000) await page.evaluate(edit, Math.min(1000, EDITS - done));
    await settle(page);
    const onPage = await hashes(page);
    const download = page.waitForEvent('download');
    await page.evaluate(() => window.waywright.files.saveScript());
    const path = join(folder, 'world.wws');
    await (await download).saveAs(path);
    const lines = execFileSync(COMMAND, ['run', path, '--strict'], { encoding: 'utf8', maxBuffer: 2 ** 28 }).trim().split('\n').map(JSON.parse);
    const [native] = lines.filter(({ op }) => op === 'hash');
    assert.ok(lines.some(({ op, ok }) => op === 'check' && ok));
    assert.equal(onPage.items, native.items);
    assert.equal(onPage.mesh, native.mesh);
    const length = await page.evaluate(() => window.waywright.session.routes.routes[0].length);
    assert.equal(length, lines.find(({ op }) => op === 'path').length ?? 0);
    const address = await page.evaluate(() => window.waywright.files.share());
    assert.notEqual(address, null, 'the world fits into a link');
    const again = await openPage(browser, address);
    await settle(again);
    assert.deepEqual([(await hashes(again)).items, (await hashes(again)).mesh], [native.items, native.mesh]);
    await again.reload();
    await again.waitForSelector('html[data-ready]', { timeout: 60_000 });
    await settle(again);
    assert.equal((await hashes(again)).mesh, native.mesh, 'reloaded');
    const { log } = await again.evaluate(() => ({ log: window.waywright.session.document.log.length }));
    t.diagnostic(`hashes ${native.items} ${native.mesh}; link of ${address?.length} characters; ${log} steps`);
    assert.deepEqual(page.errors.map(String), []);
  } finally {
    await browser.close();
    server.close();
    rmSync(folder, { recursive: true });
  }
});
