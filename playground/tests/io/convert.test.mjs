// From scripts and links to the document of the page, and back.
import assert from 'node:assert/strict';
import test from 'node:test';

import { decodeShare, parse } from './support.mjs';

const { linkOf, openParsed, openShared, operationsOf } = await import('../../src/model/convert.ts');

const HEAD = 'waywright 1\ndomain 0 0 10 10\n';
const open = (text) => openParsed(parse('a.wws', HEAD + text), 'a.wws');
const ids = ({ items }) => [...items.keys()].sort((a, b) => a - b);
const share = async ({ document, ends }) => {
  const text = await linkOf({ document, ends, algorithm: 'optimal' }, null);
  return openShared(await decodeShare(text));
};

test('a link keeps the direction of the y axis', async () => {
  const down = openParsed(parse('a.map', 'type octile\nheight 3\nwidth 4\nmap\n....\n.@@.\n....\n'), 'a.map');
  assert.equal(down.document.yDown, true);
  assert.equal((await share(down)).document.yDown, true);
  assert.equal((await share(open('point 1 2 2\n'))).document.yDown, false);
});

test('a script keeps the ids that it has used', () => {
  const { document } = open('point 1 2 2\npoint 9 3 3\nremove 9\n');
  assert.deepEqual(ids(document), [1]);
  assert.equal(document.takeId(), 10);
});

test('marks and ticks become steps, and a rewind brings back the items and the next id', () => {
  const { document } = open('point 1 2 2\nmark 1\npoint 2 3 3\nremove 1\nmark 2\npoint 7 4 4\nrewind 1\npoint 3 5 5\n');
  assert.deepEqual(ids(document), [1, 3]);
  assert.equal(document.nextId, 4);
  assert.equal(document.log.length, 4);
  document.moveTo(2, document.changesTo(2));
  assert.deepEqual(ids(document), [2, 7]);
  document.moveTo(0, document.changesTo(0));
  assert.deepEqual(ids(document), [1]);
});

test('ticks of a replay log become steps', () => {
  const { document } = open('point 1 2 2\ntick 1\nreplace point 1 3 3\ntick 2\nremove 1\n');
  assert.equal(document.log.length, 2);
  assert.deepEqual(ids(document), []);
});

test('a link may remove and replace before its first step', () => {
  const insert = (id) => ({ kind: 'insert', id, item: { kind: 'point', xy: [id, id] } });
  const state = {
    domain: [0, 0, 10, 10], start: null, goal: null, radius: 0, algorithm: 'optimal', view: null,
    operations: [insert(1), insert(2), { kind: 'remove', id: 1 }, { ...insert(2), kind: 'replace', item: { kind: 'point', xy: [5, 6] } }],
  };
  const { document } = openShared(state);
  assert.deepEqual(ids(document), [2]);
  assert.deepEqual([...document.items.get(2).points], [5, 6]);
  assert.equal(document.log.length, 0);
});

test('an impossible operation of a link changes nothing', () => {
  const state = {
    domain: [0, 0, 10, 10], start: null, goal: null, radius: 0, algorithm: 'optimal', view: null,
    operations: [{ kind: 'remove', id: 5 }, { kind: 'rewind', tick: 3 }, { kind: 'tick', tick: 1 }, { kind: 'remove', id: 6 }],
  };
  const { document } = openShared(state);
  assert.deepEqual([ids(document), document.log.length], [[], 0]);
});

test('a link keeps the items after steps', async () => {
  const first = open('point 1 2 2\ntick 1\npoint 2 3 3\ntick 2\nremove 1\n');
  const second = await share(first);
  assert.deepEqual(operationsOf(second.document), operationsOf(first.document));
  assert.equal(second.document.log.length, 2);
});

test('refused lines are told', () => {
  const { refused } = open('point 1 2 2\npoint 1 3 3\nremove 8\n');
  assert.deepEqual(refused.map(({ line }) => line), [4, 5]);
});
