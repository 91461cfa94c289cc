#!/usr/bin/env node
// usage: run_script.mjs SCRIPT
// Carries out a world script with the classes of the package, and prints the answers of `waywright run`.
import { readFileSync } from 'node:fs';

import { init, ItemList, Path, QueryContext, Script, WaywrightError, World } from '../../bindings/wasm/dist/index.js';

const pair = ({ x, y }) => [x, y];
const pairs = (numbers) => Array.from({ length: numbers.length / 2 }, (_, i) => [numbers[2 * i], numbers[2 * i + 1]]);
const compare = (a, b) => (BigInt(a) < BigInt(b) ? -1 : BigInt(a) > BigInt(b) ? 1 : 0);

/** Returns JSON with ids of all sizes. */
function toJson(value) {
  if (typeof value === 'bigint') return String(value);
  if (Array.isArray(value)) return `[${value.map(toJson).join(',')}]`;
  if (value === null || typeof value !== 'object') return JSON.stringify(value);
  const members = Object.entries(value).filter(([, member]) => member !== undefined);
  return `{${members.map(([name, member]) => `${JSON.stringify(name)}:${toJson(member)}`).join(',')}}`;
}

/** The objects that all lines use. */
const used = {};

function pieces() {
  const points = pairs(used.path.points());
  const lines = points.slice(1).map((point, i) => ({ line: [points[i], point].flat() }));
  const rest = used.path.length > 0 ? used.path.pieces() : [];
  return lines.concat(
    rest.map(({ kind, from, to, centre, radius, startAngle, endAngle }) =>
      kind === 'line' ? { line: [from, to].flatMap(pair) } : { arc: [...pair(centre), radius, startAngle, endAngle] },
    ),
  );
}

function widest() {
  const found = used.path.widest();
  if (found === null || !found.isLimited) return undefined;
  const items = [...new Set([...found.fromItems, ...found.toItems])].sort(compare);
  return { radius: found.radius, gap: [pair(found.from), pair(found.to)], items };
}

function findPath(world, line) {
  const query = { start: line.from, goal: line.to, agent: line.agent };
  if (line.algorithm !== null) query.algorithm = line.algorithm;
  if (line.endTolerance !== null) query.endTolerance = line.endTolerance;
  const path = world.findPath(query, used.path, used.context);
  const { status, length, movedStart, movedGoal } = path.info;
  const moved = (end) => (end === null ? undefined : [pair(end.from), pair(end.to)]);
  if (status === 'found') {
    return { found: true, length, pieces: pieces(), moved_start: moved(movedStart), moved_goal: moved(movedGoal) };
  }
  return { found: false, reason: status, items: status === 'no-path' ? undefined : path.blockers(), widest: widest() };
}

function locate(world, line) {
  const { kind, vertices, polygons } = world.locate(line.from, used.context);
  return { at: kind, vertices: vertices.map(pair), inside: polygons };
}

function castRay(world, line) {
  const isDisc = line.hasRadius;
  const found = world.ray(line.from, line.to, line.agent, used.context);
  if (!found.hit) return { hit: false };
  return { hit: true, at: pair(found.at), contact: isDisc ? pair(found.contact) : undefined, items: found.items };
}

function findNearestFit(world, line) {
  const query = { point: line.from, agent: line.agent };
  if (line.hasGoal) query.goal = line.to;
  const found = world.nearestFit(query, used.context);
  return found.isFound ? { found: true, at: pair(found.at) } : { found: false };
}

function checkWorld(world) {
  const { isValid, fault } = world.validate();
  return isValid ? { ok: true } : { ok: false, fault };
}

/** What a line does: it returns the answer, or nothing. */
const actions = {
  insert: (world, line) => void world.insert(used.items.get(0).shape, line.id),
  remove: (world, line) => world.remove(line.id),
  replace: (world, line) => world.replace(line.id, used.items.get(0).shape),
  locate,
  ray: castRay,
  disc: (world, line) => {
    const { fits, items } = world.fitDisc(line.from, line.agent, used.context);
    return { free: fits, items };
  },
  nearest: findNearestFit,
  path: findPath,
  clear: (world) => ({ clear: world.isClear(used.items.points(0), {}, used.context) }),
  check: checkWorld,
  tick: (world, { tick, itemsHash }) => {
    const computed = world.itemsHash();
    if (itemsHash === null || itemsHash === computed) return undefined;
    return { tick, same: false, expected: itemsHash, computed };
  },
  mark: (world) => void world.mark(),
  rewind: (world, { tick }) => world.rewind(tick),
  hash: (world) => ({ items: world.itemsHash(), mesh: world.meshHash() }),
};

/** Carries out one line, and returns the answer or the error as JSON, or null. */
function answerOf(world, line) {
  const opening = { line: line.line, op: line.word };
  try {
    const answer = actions[line.kind](world, line);
    return answer === undefined ? null : toJson({ ...opening, ...answer });
  } catch (error) {
    if (!(error instanceof WaywrightError) || error.code === 'invalid-argument') throw error;
    return toJson({ ...opening, error: error.code, message: error.message });
  }
}

/** Carries out a world script. Returns the answers. */
export function runScript(text, name) {
  used.items = new ItemList();
  used.path = new Path();
  used.context = new QueryContext();
  const script = new Script().parse(text, name);
  const lines = Array.from({ length: script.length }, (_, i) => script.line(i));
  const needsBridges = lines.some((line) => (line.kind === 'path' || line.hasGoal) && line.agent.radius > 0);
  const world = new World(script.domain, { keepBridges: needsBridges });
  world.keepHistory(lines.length);
  const answers = [];
  lines.forEach((line, i) => {
    script.item(i, used.items);
    const answer = answerOf(world, line);
    if (answer !== null) answers.push(answer);
  });
  for (const object of [world, script, used.context, used.path, used.items]) object.dispose();
  return answers;
}

if (process.argv[1]?.endsWith('run_script.mjs')) {
  const name = process.argv[2];
  await init();
  const answers = runScript(readFileSync(name, 'utf8'), name);
  process.stdout.write(answers.map((answer) => `${answer}\n`).join(''));
}
