// usage: compare.mjs NATIVE_PROGRAM
// Does the same work natively (work.cpp) and with the npm package in Node, three times in turn. Prints the best times.
import { execFileSync } from 'node:child_process';

import { init, Path, World } from '../../bindings/wasm/dist/index.js';

const SIZE = 1000;
const DOMAIN = { min: { x: 0, y: 0 }, max: { x: SIZE, y: SIZE } };
const ROUNDS = 3;

class Random {
  state = 1;
  next() {
    this.state = (Math.imul(this.state, 1664525) + 1013904223) >>> 0;
    return this.state / 4294967296;
  }
}

function square(random) {
  const x = 10 + 970 * random.next();
  const y = 10 + 970 * random.next();
  const dx = 4 * random.next();
  const dy = 4 * random.next();
  return { kind: 'polygon', points: [x, y, x + 4, y + dy, x + 4 - dx, y + 6, x - dx, y + 4] };
}

function findPaths(world, random, count, radius) {
  const path = new Path();
  let sum = 0;
  for (let i = 0; i < count; ++i) {
    const start = { x: SIZE * random.next(), y: SIZE * random.next() };
    const goal = { x: SIZE * random.next(), y: SIZE * random.next() };
    sum += world.findPath({ start, goal, agent: { radius } }, path).length;
  }
  path.dispose();
  return sum;
}

function work() {
  const results = {};
  const time = (name, call) => {
    const start = performance.now();
    const sum = call();
    results[name] = { seconds: (performance.now() - start) / 1000, sum };
  };
  const random = new Random();
  const world = new World(DOMAIN, { keepBridges: true });
  time('insert_polygons', () => {
    for (let id = 1; id <= 2000; ++id) world.insert(square(random), id);
    return world.vertexCount;
  });
  time('drag_polygons', () => {
    for (let id = 1; id <= 2000; ++id) world.replace(id, square(random));
    return world.vertexCount;
  });
  time('point_paths', () => findPaths(world, random, 1000, 0));
  time('disc_paths', () => findPaths(world, random, 100, 2));
  time('insert_points', () => {
    const points = new World(DOMAIN);
    points.insertPoints(new Float64Array(200000).map(() => SIZE * random.next()));
    const count = points.triangleCount;
    points.dispose();
    return count;
  });
  world.dispose();
  return results;
}

function native(program) {
  const lines = execFileSync(program, { encoding: 'utf8' }).trim().split('\n').map((line) => line.split(' '));
  return Object.fromEntries(lines.map(([name, seconds, sum]) => [name, { seconds: Number(seconds), sum: Number(sum) }]));
}

await init();
const best = {};
for (let round = 0; round < ROUNDS; ++round) {
  for (const [kind, results] of [['native', native(process.argv[2])], ['wasm', work()]]) {
    for (const [name, { seconds, sum }] of Object.entries(results)) {
      const entry = (best[name] ??= { native: Infinity, wasm: Infinity, sum });
      if (entry.sum !== sum) throw new Error(`${name}: ${kind} computes ${sum} instead of ${entry.sum}`);
      entry[kind] = Math.min(entry[kind], seconds);
    }
  }
}
for (const [name, { native: n, wasm }] of Object.entries(best)) {
  console.log(`${name.padEnd(16)} native ${n.toFixed(4)} s, WebAssembly ${wasm.toFixed(4)} s: ${(wasm / n).toFixed(2)} times`);
}
