// Opens the page, stops its server, and opens the page again.
import assert from 'node:assert/strict';
import { hashes, launch, openPage, serve, settle, test } from './support.mjs';

test('after the first visit the page works without a network', async () => {
  const { server, base } = await serve();
  const browser = await launch();
  try {
    const page = await openPage(browser, base);
    await settle(page);
    const first = await hashes(page);
    await page.evaluate(async () => {
      await navigator.serviceWorker.ready;
      while (navigator.serviceWorker.controller === null) await new Promise((resolve) => setTimeout(resolve, 20));
    });
    server.closeAllConnections();
    await new Promise((done) => server.close(done));
    await assert.rejects(fetch(base));
    await page.goto(`${base}?again`);
    await page.waitForSelector('html[data-ready]', { timeout: 60_000 });
    await settle(page);
    assert.deepEqual(await hashes(page), first);
    assert.deepEqual(page.errors.map(String), []);
  } finally {
    await browser.close();
    server.close();
  }
});
