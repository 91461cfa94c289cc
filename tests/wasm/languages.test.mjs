// Compares the column of JavaScript in docs/languages.md with the package.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { test } from 'node:test';

import * as waywright from '../../bindings/wasm/dist/index.js';

const page = readFileSync(new URL('../../docs/languages.md', import.meta.url), 'utf8');
const types = readFileSync(new URL('../../bindings/wasm/dist/index.d.ts', import.meta.url), 'utf8');
const rows = page.split('\n').filter((line) => line.startsWith('| ')).map((line) => line.split(' | '));
const names = rows.flatMap((cells) => [...cells.at(-1).matchAll(/`(?:new )?(\w+(?:\.\w+)?)`/g)].map((match) => match[1]));
// Each class has these; and what its type declares as internal.
const COMMON = new Set(['constructor', 'dispose', 'isDisposed', 'address', 'ownAddress', 'changed', 'using']);

/** Returns the names of all public members that a class declares. */
function membersOf(name) {
  const members = new Set();
  for (let each = waywright[name].prototype; each !== Object.prototype; each = Object.getPrototypeOf(each)) {
    for (const member of Object.getOwnPropertyNames(each)) members.add(member);
  }
  return [...members].filter((member) => !COMMON.has(member)).map((member) => `${name}.${member}`);
}

function exists(name) {
  const [owner, member] = name.split('.');
  const value = waywright[owner];
  if (value === undefined) return member === undefined && new RegExp(`\\b${owner}\\b`).test(types);
  if (member === undefined || member in value || member in (value.prototype ?? {})) return true;
  return value === waywright.WaywrightError && ['code', 'item', 'index', 'message'].includes(member);
}

test('every name in the table exists', () => {
  assert.ok(names.length > 100);
  assert.ok(rows.every((cells) => cells.length === 5), 'a row without five columns');
  assert.deepEqual(names.filter((name) => !exists(name) && !/^(invalid-argument|x|y|init)$/.test(name)), []);
});

test('the table names every operation of the classes', () => {
  const internal = new Set([
    'Path.renew', 'Path.answers', 'Paths.renew', 'Scene.change', 'Scene.info', 'World.constructor',
    ...membersOf('Walkers'), 'ItemList.constructor',
  ]);
  const classes = ['World', 'Path', 'Paths', 'PathSearch', 'PathWatch', 'Mesh', 'ItemList', 'Scene', 'Script', 'Scenario',
    'SvgOverlay', 'ReplayWriter'];
  const missing = classes.flatMap(membersOf).filter((name) => !internal.has(name) && !names.includes(name));
  assert.deepEqual(missing, []);
});
