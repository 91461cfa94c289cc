// Links: round trips bit by bit, and damaged links.
import assert from 'node:assert/strict';
import { deflateRawSync } from 'node:zlib';
import test from 'node:test';

import { decodeShare, encodeShare, items, Random, refuses } from './support.mjs';

const DIGITS = 'ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789-_';
const KINDS = ['point', 'segment', 'polyline', 'polygon'];

function makeRings(random, kind, number) {
  const point = () => [number(), number()];
  const ring = (count) => Array.from({ length: count }, point);
  if (kind === 'point') return [ring(1)];
  if (kind === 'segment') return [ring(2)];
  if (kind === 'polyline') return [ring(1 + random.below(6))];
  return Array.from({ length: 1 + random.below(3) }, () => ring(1 + random.below(6)));
}

function makeItem(random, number) {
  const kind = random.pick(KINDS);
  return items.makeItem(kind, makeRings(random, kind, number), random.pick(['even-odd', 'nonzero']));
}

function makeOperation(random, number) {
  const point = () => [number(), number()];
  const ends = () => ({ from: point(), to: point() });
  const id = random.pick([1 + random.below(100), Number.MAX_SAFE_INTEGER, 2n ** 53n, 2n ** 63n - 1n]);
  const radius = random.pick([0, 0.5, 1 / 3, 1e-300]);
  return random.pick([
    () => ({ kind: random.pick(['insert', 'replace']), id, item: makeItem(random, number) }),
    () => ({ kind: 'remove', id }),
    () => ({ kind: random.pick(['mark', 'rewind']), tick: 1 + random.below(1000) }),
    () => ({ kind: 'tick', tick: id, ...random.pick([{}, { hash: '0123456789abcdef0123456789abcdef' }]) }),
    () => ({ kind: random.pick(['check', 'hash']) }),
    () => ({ kind: 'locate', at: point() }),
    () => ({ kind: 'disc', at: point(), radius }),
    () => ({ kind: 'ray', ...ends(), ...random.pick([{}, { radius }]) }),
    () => ({ kind: 'nearest', at: point(), radius, ...random.pick([{}, { goal: point() }]) }),
    () => ({ kind: 'path', ...ends(), radius, ...random.pick([{}, { algorithm: 'tra' }, { tolerance: Infinity }]) }),
    () => ({ kind: 'clear', points: Array.from({ length: 1 + random.below(4) }, point) }),
  ])();
}

function makeState(random, number) {
  const point = () => [number(), number()];
  return {
    // Only with the first domain, all coordinates of a state can be multiples of a simple fraction.
    domain: random.pick([[0, -10, 100.5, 10], [-(2 ** 100), -1e20, 2 ** 100, 1e20]]),
    ...random.pick([{}, { yDown: true }]),
    operations: Array.from({ length: random.below(40) }, () => makeOperation(random, number)),
    start: random.pick([null, point()]),
    goal: random.pick([null, point()]),
    radius: random.pick([0, 1, 2 ** -1074]),
    algorithm: random.pick(['optimal', 'ta', 'tra']),
    view: random.pick([null, { x: number(), y: -0, scale: 1 / 7 }]),
  };
}

const SMALL = makeState(new Random(1), () => 7);

test('a link gives back the state, bit by bit', async () => {
  for (let seed = 0; seed < 300; ++seed) {
    const random = new Random(seed);
    const numbers = [
      () => random.coordinate(),
      () => random.below(4000) / 4,
      () => -random.below(100_000) / 1000,
      () => random.below(2) - 1 + random.below(1000) * 2 ** -52,
      () => random.pick([0, -0, 2 ** 50, 2 ** 50 + 2 ** -2, 2 ** -100, -(2 ** 100)]),
    ];
    const state = makeState(random, numbers[seed % numbers.length]);
    // deepStrictEqual compares numbers with Object.is, so it tells 0 and -0 apart.
    assert.deepStrictEqual(await decodeShare(await encodeShare(state)), state, `seed ${seed}`);
  }
});

test('a link has only characters that need no escape, and may come with # and blanks', async () => {
  const link = await encodeShare(SMALL);
  assert.match(link, /^[A-Za-z0-9_-]+$/);
  assert.deepStrictEqual(await decodeShare(` #${link}\n`), SMALL);
});

test('a link of numbers with few digits is short', async () => {
  const random = new Random(5);
  const insertions = Array.from({ length: 100 }, (_, i) => {
    const [x, y] = [random.below(4000) / 4, random.below(4000) / 4];
    return { kind: 'insert', id: i + 1, item: { kind: 'segment', points: [[x, y], [x + random.below(40) / 4, y]] } };
  });
  const link = await encodeShare({ ...SMALL, operations: insertions });
  assert.ok(link.length < 1300, `${link.length} characters for 200 points`);
});

test('no changed character of a link is accepted', async () => {
  const state = makeState(new Random(3), () => 0.25);
  const link = await encodeShare(state);
  for (let i = 0; i < link.length; ++i) {
    const next = (step) => DIGITS[(DIGITS.indexOf(link[i]) + step) % 64];
    for (const digit of [next(1), next(32), '%', 'é']) {
      const changed = link.slice(0, i) + digit + link.slice(i + 1);
      await assert.rejects(decodeShare(changed), { name: 'InputError' }, `character ${i}`);
    }
  }
});

test('no cut or prolonged link is accepted', async () => {
  const link = await encodeShare(SMALL);
  for (let i = 0; i < link.length; ++i) await assert.rejects(decodeShare(link.slice(0, i)), { name: 'InputError' });
  const lengths = new Set();
  for (let seed = 0; seed < 20; ++seed) {
    const another = await encodeShare(makeState(new Random(seed), () => 7));
    lengths.add(another.length % 4);
    for (const digit of DIGITS) await assert.rejects(decodeShare(another + digit), { name: 'InputError' }, another);
  }
  assert.deepEqual([...lengths].sort(), [0, 2, 3]);
  await refuses(() => decodeShare(''), /no text after #/);
  await refuses(() => decodeShare(link.slice(0, 40)), /checksum is wrong.*Copy the whole link/);
  await refuses(() => decodeShare(link.slice(0, 8)), /it ends too early/);
  await refuses(() => decodeShare(`${link.slice(0, 3)}!${link.slice(4)}`), /character '!'/, { column: 4 });
});

test('a link of another version is refused', async () => {
  const link = await encodeShare(SMALL);
  // The first 6 bits are those of the version without its last two. 'A' and 'B' begin versions 0 to 7.
  await refuses(() => decodeShare(`B${link.slice(1)}`), /has version 5 of the format.*reload/);
});

// Links whose checksum is right, but whose state is not.

function crc(bytes, polynomial) {
  let rest = 0xffffffff;
  for (const byte of bytes) {
    rest ^= byte;
    for (let i = 0; i < 8; ++i) rest = rest & 1 ? (rest >>> 1) ^ polynomial : rest >>> 1;
  }
  return ~rest >>> 0;
}

function seal(compressed) {
  const bytes = Buffer.alloc(9 + compressed.length);
  bytes[0] = 1;
  bytes.writeUInt32LE(crc(compressed, 0xedb88320), 1);
  bytes.writeUInt32LE(crc(compressed, 0x82f63b78), 5);
  compressed.copy(bytes, 9);
  return bytes.toString('base64url');
}

const forge = (payload) => seal(deflateRawSync(Buffer.from(payload)));
const list = (...values) => [1, values.length, 1, ...values];
const HEAD = [0, 0, 0]; // y up, no start, no goal
const TAIL = [0, 0]; // optimal, no view
const DOMAIN = [0, 0, 20, 20]; // the differences 0, 0, 10, 10

test('the checksums are those of CRC-32 and CRC-32C', () => {
  assert.equal(crc(Buffer.from('123456789'), 0xedb88320), 0xcbf43926);
  assert.equal(crc(Buffer.from('123456789'), 0x82f63b78), 0xe3069283);
});

test('a forged link is accepted if it is a state, and refused if not', async () => {
  const codes = (...operations) => [HEAD.length + TAIL.length + operations.length, ...HEAD, ...TAIL, ...operations];
  const state = (...operations) => [...codes(...operations), ...list(...DOMAIN), ...list(2)];
  assert.deepStrictEqual(await decodeShare(forge(state(0))), {
    domain: [0, 0, 10, 10], operations: [], start: null, goal: null, radius: 1, algorithm: 'optimal', view: null,
  });
  assert.equal((await decodeShare(forge(state(1, 1, 4)))).operations[0].id, 3);
  const ends = [0xff, 0xff, 0xff, 0xff, 0xff, 0xff, 0xff, 0xff, 0xff, 0x01];
  await refuses(() => decodeShare(seal(Buffer.from('no deflate'))), /cannot be unpacked/);
  await refuses(() => decodeShare(forge([])), /ends too early/);
  await refuses(() => decodeShare(forge([100, 0])), /count in it is too large/);
  await refuses(() => decodeShare(forge(state(3, 12))), /count in it is too large|ends too early/);
  await refuses(() => decodeShare(forge(state(1, 99))), /unknown code 99/);
  await refuses(() => decodeShare(forge(state(1, 0, 0, 9))), /unknown kind 9/);
  await refuses(() => decodeShare(forge(state(1, 0, 0, 0))), /lacks coordinates/);
  await refuses(() => decodeShare(forge(state(1, 1, 1))), /the id 0/);
  await refuses(() => decodeShare(forge(state(1, 1, ...ends))), /the id -?\d+/);
  await refuses(() => decodeShare(forge(state(1, 1, ...ends.fill(0xff)))), /number in it is too large/);
  await refuses(() => decodeShare(forge(state(1, 11, 127))), /count in it is too large/);
  await refuses(() => decodeShare(forge([...state(0), 0])), /more than its state/);
  await refuses(() => decodeShare(forge(state(0, 0))), /more than its state/);
  await refuses(() => decodeShare(forge([...codes(0), ...list(0, 0, 19, 0), ...list(2)])), /domain is empty/);
  // 1 is the difference -1.
  await refuses(() => decodeShare(forge([...codes(0), ...list(...DOMAIN), ...list(1)])), /its radius is not a number from 0/);
  await refuses(() => decodeShare(forge([...codes(0), 7, 0])), /unknown kind 7/);
  await refuses(() => decodeShare(forge([...codes(0), 1, 4, 3, ...DOMAIN])), /unknown divisor 3/);
});

test('a link whose state is huge is refused before it fills the memory', async () => {
  await refuses(() => decodeShare(seal(deflateRawSync(Buffer.alloc(60_000_000)))), /state is too large/);
});

test('a forged link with a coordinate that no world accepts is refused', async () => {
  const doubles = [NaN, 0, 10, 10];
  for (const value of [NaN, Infinity, 2 ** 101, 2 ** -101]) {
    doubles[0] = value;
    const planes = Array.from({ length: 8 }, (_, plane) => doubles.map((number) => bytesOfDouble(number)[plane])).flat();
    const payload = [6, ...HEAD, ...TAIL, 0, 0, 4, ...planes, ...list(2)];
    await refuses(() => decodeShare(forge(payload)), /not 0 and not of a size/);
  }
});

function bytesOfDouble(value) {
  const bytes = Buffer.alloc(8);
  bytes.writeDoubleBE(value);
  return [...bytes];
}

test('a state that no link can give back is refused', async () => {
  await refuses(() => encodeShare({ ...SMALL, start: [NaN, 0] }), /coordinate NaN/);
  await refuses(() => encodeShare({ ...SMALL, goal: [0, 1e31] }), /coordinate 1e\+31/);
  await refuses(() => encodeShare({ ...SMALL, radius: NaN }), /NaN/);
  await refuses(() => encodeShare({ ...SMALL, algorithm: 'best' }), /'best' is no algorithm/);
});
