// Compares with the native command. WAYWRIGHT_COMMAND names it; without it, these tests are skipped.
import assert from 'node:assert/strict';
import { execFileSync, spawnSync } from 'node:child_process';
import { existsSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import test, { after } from 'node:test';
import { fileURLToPath } from 'node:url';

import { carryOut, makeWorld } from './engine.mjs';
import { operationsOf, parse, parseFile, Random, writeWws } from './support.mjs';

const { examples } = await import('../../src/io/shelf.ts');
const BUILT = fileURLToPath(new URL('../../../build/dev/tools/waywright/waywright', import.meta.url));
const COMMAND = process.env.WAYWRIGHT_COMMAND ?? BUILT;
const skip = existsSync(COMMAND) ? false : `there is no ${COMMAND}`;
const MAPS = fileURLToPath(new URL('../../../examples/maps/', import.meta.url));
const folder = mkdtempSync(join(tmpdir(), 'waywright-'));
after(() => rmSync(folder, { recursive: true }));

function save(name, text) {
  const path = join(folder, name);
  writeFileSync(path, text);
  return path;
}

/** The script that the command makes of a file. */
const convert = (path) => execFileSync(COMMAND, ['convert', path, '-'], { encoding: 'utf8', maxBuffer: 1e8 });

/** The script of the items that are left in a world. */
function scriptOf(world) {
  return writeWws(world.domain, operationsOf({ items: world.items, ids: world.ids }));
}

function nativeHashes(script) {
  const path = save('hash.wws', `${script}hash\n`);
  const answers = execFileSync(COMMAND, ['run', path], { encoding: 'utf8', maxBuffer: 1e8 }).trim().split('\n');
  const { items: itemsHash, mesh } = JSON.parse(answers[answers.length - 1]);
  return [itemsHash, mesh];
}

function engineHashes(domain, operations) {
  const world = makeWorld(domain);
  carryOut(world, operations);
  const hashes = [world.itemsHash(), world.meshHash()];
  world.dispose();
  return hashes;
}

for (const { id, load } of examples) {
  test(`the command gets the hashes of the example ${id} from its script`, { skip }, () => {
    const example = load();
    const operations = operationsOf(example);
    assert.deepEqual(nativeHashes(writeWws(example.domain, operations)), engineHashes(example.domain, operations));
  });
}

test('a script of random operations has the same hashes in the command and in the engine', { skip }, () => {
  const hasMarks = spawnSync(COMMAND, ['run', save('m.wws', 'waywright 1\ndomain 0 0 1 1\nmark 1\n')]).status === 0;
  for (let seed = 0; seed < 20; ++seed) {
    const script = randomScript(new Random(seed), hasMarks);
    const { domain, operations } = parse('a.wws', script);
    const written = writeWws(domain, operations);
    const expected = nativeHashes(script);
    assert.deepEqual(nativeHashes(written), expected, `seed ${seed}`);
    assert.deepEqual(engineHashes(domain, operations), expected, `seed ${seed}`);
    // The items that are left have the same hash, too.
    assert.deepEqual(nativeHashes(scriptOf(parse('a.wws', script))), expected, `seed ${seed}`);
  }
});

/** Some of its lines are refused: an id is in use or unknown, or a corner is outside the domain. */
function randomScript(random, hasMarks) {
  const long = () => `${random.below(9)}.${random.bits()}`;
  const number = () => random.pick([random.below(11), random.below(12), random.below(1000) / 100, long()]);
  const ring = (count) => Array.from({ length: count }, () => `${number()} ${number()}`).join(' ');
  const counted = (count) => `${count} ${ring(count)}`;
  let marks = 0;
  const item = () => {
    const id = 1 + random.below(12);
    return random.pick([
      () => `point ${id} ${ring(1)}`,
      () => `segment ${id} ${ring(2)}`,
      () => `polyline ${id} ${counted(1 + random.below(4))}`,
      () => `polygon ${id} ${random.pick(['', 'nonzero '])}${counted(3)} / ${counted(1 + random.below(5))}`,
    ])();
  };
  const lines = Array.from({ length: 60 }, () => {
    const kind = random.below(12);
    if (kind === 0 && hasMarks) return `mark ${++marks}`;
    if (kind === 1 && marks > 0) return `rewind ${(marks = 1 + random.below(marks))}`;
    if (kind < 4) return `remove ${1 + random.below(12)}`;
    return kind < 6 ? `replace ${item()}` : item();
  });
  return `waywright 1\ndomain 0 0 10 10\n${lines.join('\n')}\n`;
}

test('maps become the items that the command makes of them', { skip }, () => {
  for (let seed = 0; seed < 60; ++seed) {
    const random = new Random(seed);
    const [width, height] = [1 + random.below(24), 1 + random.below(24)];
    const cells = random.pick(['.@', '..T', '.OW', '.GS@OTW', '@@@.', '@']);
    const rows = Array.from({ length: height }, () => Array.from({ length: width }, () => random.pick(cells)).join(''));
    const text = `type octile\nheight ${height}\nwidth ${width}\nmap\n${rows.join('\n')}\n`;
    assert.equal(scriptOf(parse('a.map', text)), convert(save('a.map', text)), `seed ${seed}`);
  }
});

test('files of Triangle become the items that the command makes of them', { skip }, () => {
  for (let seed = 0; seed < 40; ++seed) {
    const random = new Random(seed);
    const first = random.below(2);
    const count = 1 + random.below(12);
    const scale = random.pick([1, 1, 1e-9, 1e9, 1e25]);
    const number = () => (random.below(2000) - 1000) * random.pick([1, 0.01, scale]);
    const points = Array.from({ length: count }, (_, i) => `${first + i} ${number()} ${number()} # a vertex\n`).join('');
    const vertex = () => first + random.below(count);
    const segments = Array.from({ length: random.below(9) }, (_, i) => `${i} ${vertex()} ${vertex()}`);
    const poly = `${count} 2\n${points}${segments.length}\n${segments.join('\n')}\n0\n`;
    assert.equal(scriptOf(parse('a.poly', poly)), convert(save('a.poly', poly)), `seed ${seed}`);
    const node = `${count} 2\n${points}`;
    assert.equal(scriptOf(parse('a.node', node)), convert(save('a.node', node)), `seed ${seed}`);
  }
});

test('scripts become the items that the command finds in them', { skip }, () => {
  for (const name of ['highground.wws', 'rocks.wws']) {
    assert.equal(scriptOf(parseFile(name, readFileSync(join(MAPS, name)))), convert(join(MAPS, name)));
  }
});

test('numbers are written as the command writes them', { skip }, () => {
  const random = new Random(99);
  const large = () => random.bits() * 2 ** random.below(60);
  const decimal = () => (random.below(2) - 0.5) * random.below(10 ** (1 + random.below(9))) * 10 ** -random.below(9);
  const number = () => random.pick([() => random.coordinate() + 0, large, decimal, () => 10 ** random.below(25)])() + 0;
  const far = 2 ** 100;
  const list = Array.from({ length: 4000 }, () => [number(), number()]);
  const script = writeWws([-far, -far, far, far], operationsOf({ items: [{ kind: 'polyline', points: list }] }));
  const converted = convert(save('a.wws', script));
  const words = converted.split(/\s/);
  assert.deepEqual(script.split(/\s/).filter((word, i) => word !== words[i]), []);
  assert.deepStrictEqual(parse('a.wws', converted).items[0].points, list);
});
