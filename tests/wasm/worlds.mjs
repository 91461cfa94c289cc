// Runs the 200 worlds of tests/determinism/print_meshes.cpp with the classes of the package, and prints the same text. Works
// in browsers and in Node.
import { Path, WaywrightError, World } from '../../bindings/wasm/dist/index.js';

const STEPS_OF_GRID = 64;
const PATHS = 4;
const MASK = 2n ** 64n - 1n;

/** SplitMix64, like tests/support/random.hpp. */
class Random {
  constructor(seed) {
    this.state = BigInt(seed);
  }
  below(count) {
    this.state = (this.state + 0x9e3779b97f4a7c15n) & MASK;
    let z = this.state;
    z = ((z ^ (z >> 30n)) * 0xbf58476d1ce4e5b9n) & MASK;
    z = ((z ^ (z >> 27n)) * 0x94d049bb133111ebn) & MASK;
    return Number((z ^ (z >> 31n)) % BigInt(count));
  }
}

const words = new BigUint64Array(1);
const numbers = new Float64Array(words.buffer);

function bitsOf(value) {
  numbers[0] = value;
  return words[0].toString(16).padStart(16, '0');
}

function doublesOf(text) {
  const bits = new BigUint64Array(text.length / 16);
  for (let i = 0; i < bits.length; ++i) bits[i] = BigInt(`0x${text.slice(16 * i, 16 * i + 16)}`);
  return new Float64Array(bits.buffer);
}

const bitsOfPoint = ({ x, y }) => ` ${bitsOf(x)} ${bitsOf(y)}`;
const bitsOfAll = (values) => Array.from(values, (value) => ` ${bitsOf(value)}`).join('');
const idsText = (ids) => ` [${ids.map((id) => ` ${id}`).join('')} ]`;

/** Returns what `call` returns, or the code of the error that it throws. */
function codeOr(call) {
  try {
    return call();
  } catch (error) {
    if (error instanceof WaywrightError) return error.code;
    throw error;
  }
}

function changeOf({ kind, id, shape, fill, rings, points }) {
  if (kind === 'remove') return { kind, id: BigInt(id) };
  return { kind, id: BigInt(id), shape: { kind: shape, fill, ringSizes: rings, points: doublesOf(points) } };
}

function perform(world, step) {
  const changes = step.changes.map(changeOf);
  const [change] = changes;
  if (step.batch) world.apply(changes);
  else if (change.kind === 'insert') world.insert(change.shape, change.id);
  else if (change.kind === 'remove') world.remove(change.id);
  else world.replace(change.id, change.shape);
  return 'done';
}

function pathText(world, query, path) {
  const text = codeOr(() => {
    world.findPath(query, path);
    const { status, expansions, length, lowerBound } = path.info;
    return `${status} ${expansions} ${bitsOf(length)} ${bitsOf(lowerBound)}${bitsOfAll(path.points())}`;
  });
  return `${query.algorithm} ${text}\n`;
}

/** Positions on the path of a disc, and the path as points. */
function walkText(path, tolerance) {
  if (path.status !== 'found') return '';
  let text = '';
  for (let i = 0; i <= 16; ++i) {
    const { at, heading } = path.at((path.length * i) / 16);
    const nearest = path.nearest({ x: at.x + tolerance * heading.x, y: at.y + tolerance * heading.y });
    text += bitsOfPoint(at) + bitsOfPoint(heading) + bitsOfPoint(nearest.at);
  }
  return `${text}${bitsOfAll(path.polyline(tolerance))}\n`;
}

const flag = (value) => (value ? 1 : 0);

/** The path of a disc, and what a disc touches that moves along a segment. */
function discPathText(world, query, path, tolerance) {
  const { start, goal, agent } = query;
  const found = codeOr(() => {
    world.findPath(query, path);
    const { status, expansions, length } = path.info;
    const pieces = path.pieces().map(({ from, to, startAngle, endAngle }) =>
      bitsOfAll([from.x, from.y, to.x, to.y, startAngle, endAngle]),
    );
    return { text: `disc path ${status} ${expansions} ${bitsOf(length)}${pieces.join('')}\n${walkText(path, tolerance)}` };
  });
  if (typeof found === 'string') return '';
  const swept = codeOr(() => {
    const { hit, at, contact, items } = world.ray(start, goal, agent);
    return { text: `sweep ${flag(hit)}${bitsOfPoint(at)}${bitsOfPoint(contact)}${idsText(items)}\n` };
  });
  return found.text + (swept.text ?? '');
}

function widestText(world, start, goal) {
  const text = codeOr(() => {
    const { isConnected, isLimited, radius, from, to, fromItems, toItems } = world.widestPath(start, goal);
    const ends = bitsOfPoint(from) + bitsOfPoint(to) + idsText(fromItems) + idsText(toItems);
    return `${flag(isConnected)} ${flag(isLimited)} ${bitsOf(radius)}${ends}`;
  });
  return `widest ${text}\n`;
}

/** Which items are in the way of discs at a point, and where these discs fit near to it. */
function fitsText(world, start, goal, extent) {
  let text = '';
  for (const radius of [0, 2 ** -8 * extent, 2 ** -5 * extent, 2 ** -3 * extent]) {
    const fit = codeOr(() => world.fitDisc(start, { radius }));
    text += `disc${typeof fit === 'string' ? ` ${fit}` : idsText(fit.items)}`;
    for (const wanted of [{}, { goal }]) {
      const nearest = codeOr(() => world.nearestFit({ point: start, agent: { radius }, ...wanted }));
      if (typeof nearest === 'string') continue;
      text += ` ${flag(nearest.isFound)} ${bitsOf(nearest.distance)}${bitsOfPoint(nearest.at)}`;
    }
    text += '\n';
  }
  return text;
}

function discsText(world, start, goal, extent, path) {
  let text = fitsText(world, start, goal, extent);
  for (const radius of [2 ** -10 * extent, 2 ** -6 * extent, 2 ** -4 * extent]) {
    for (const algorithm of ['optimal', 'tra']) {
      text += discPathText(world, { start, goal, agent: { radius }, algorithm }, path, 2 ** -9 * extent);
    }
  }
  return text + widestText(world, start, goal);
}

function pathsText(world, { min, max }, seed) {
  const random = new Random(seed);
  const path = new Path();
  const between = (low, high) => low + ((high - low) / STEPS_OF_GRID) * random.below(STEPS_OF_GRID + 1);
  const randomPoint = () => {
    const x = between(min.x, max.x);
    const y = between(min.y, max.y);
    return { x, y };
  };
  let text = '';
  for (let i = 0; i < PATHS; ++i) {
    const start = randomPoint();
    const goal = randomPoint();
    for (const algorithm of ['optimal', 'ta', 'tra']) text += pathText(world, { start, goal, algorithm }, path);
    text += pathText(world, { start, goal, algorithm: 'ta', budgetExpansions: Infinity }, path);
    text += discsText(world, start, goal, max.x - min.x, path);
  }
  path.dispose();
  return text;
}

/** Runs one world. `line` describes it as export_changes.cpp does. Returns the text of print_meshes.cpp. */
export function worldText(line) {
  const { flavour, seed, domain, steps } = JSON.parse(line);
  const [x0, y0, x1, y1] = doublesOf(domain);
  const box = { min: { x: x0, y: y0 }, max: { x: x1, y: y1 } };
  const world = new World(box, { keepBridges: true });
  let text = `script ${flavour} ${seed}\n`;
  for (const step of steps) {
    text += `${codeOr(() => perform(world, step))} ${world.itemsHash()} ${world.meshHash()}\n`;
  }
  text += world.dump() + pathsText(world, box, seed);
  world.dispose();
  return text;
}
