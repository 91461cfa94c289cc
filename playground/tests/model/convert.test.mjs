// Converts documents to links and scripts, and back.
import assert from 'node:assert/strict';
import test from 'node:test';

import { decodeShare, parse } from '../io/support.mjs';

const { linkOf, openParsed, openShared, scriptOf } = await import('../../src/model/convert.ts');

const open = (name, text) => openParsed(parse(name, text), name).document;
const session = (document, ends = { start: { x: 1, y: 1 }, goal: { x: 2, y: 2 }, radius: 0 }) => ({ document, ends, algorithm: 'tra' });
const throughLink = async (document) => openShared(await decodeShare(await linkOf(session(document), null))).document;
const ids = (document) => document.sortedItems().map(([id]) => id);

test('a link keeps the direction of the y axis', async () => {
  const map = open('a.map', 'type octile\nheight 1\nwidth 2\nmap\n.@\n');
  assert.equal(map.yDown, true);
  assert.equal((await throughLink(map)).yDown, true);
  assert.equal((await throughLink(open('a.wws', 'waywright 1\ndomain 0 0 9 9\n'))).yDown, false);
});

test('a script does not use the ids of removed items again', () => {
  const document = open('a.wws', 'waywright 1\ndomain 0 0 9 9\npoint 1 1 1\npoint 8 2 2\nremove 8\n');
  assert.deepEqual(ids(document), [1]);
  assert.equal(document.takeId(), 9);
});

test('the ticks of a script are the steps of the log', async () => {
  const text = 'waywright 1\ndomain 0 0 9 9\npoint 1 1 1\ntick 1\npoint 2 2 2\nremove 1\ntick 2\nreplace point 2 3 3\n';
  const document = open('a.wws', text);
  assert.deepEqual(document.log.map(({ label }) => label), ['change 2 items', 'move point']);
  assert.deepEqual(ids(document), [2]);
  document.moveTo(0, document.changesTo(0));
  assert.deepEqual(ids(document), [1]);
  document.moveTo(2, document.changesTo(2));
  const again = await throughLink(document);
  assert.deepEqual(again.log.map(({ label }) => label), ['change 2 items', 'move point']);
  assert.equal(scriptOf(session(again)), scriptOf(session(document)));
});

test('a script with rewinds opens with the items that are left', () => {
  const text = 'waywright 1\ndomain 0 0 9 9\npoint 1 1 1\nmark 1\npoint 2 2 2\nmark 2\npoint 7 3 3\nrewind 1\ntick 5\npoint 3 4 4\n';
  const document = open('a.wws', text);
  assert.deepEqual(ids(document), [1, 3]);
  assert.equal(document.takeId(), 8);
});

test('a link whose first step changes an item opens with the changed item', () => {
  const point = (x) => ({ kind: 'point', xy: [x, x] });
  const operations = [
    { kind: 'insert', id: 1, item: point(1) }, { kind: 'insert', id: 2, item: point(2) },
    { kind: 'remove', id: 1 }, { kind: 'replace', id: 2, item: point(3) },
  ];
  const state = { domain: [0, 0, 9, 9], operations, start: null, goal: null, radius: 0, algorithm: 'optimal', view: null };
  const { document } = openShared(state);
  assert.deepEqual(ids(document), [2]);
  assert.deepEqual([...document.items.get(2).points], [3, 3]);
});
