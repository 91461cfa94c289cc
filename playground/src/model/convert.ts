// Converts between files, links and the page's document.
import { domainAround, toShape as packItem } from '../io/items';
import { encodeShare, type ShareState, type View as SharedView } from '../io/share';
import {
  InputError, type Domain, type Item, type ItemId, type Operation, type ParsedWorld, type RefusedLine, type XY as Pair,
} from '../io/types';
import { operationsOf as operationsOfParsed, writeWws } from '../io/wws';
import type { XY } from '../engine/protocol';
import { type Change, Document, type IdentifiedShape } from './document';
import { type Reader, Replay } from './replay';
import type { Ends, Session } from './session';
import { type Bounds, ringRanges, type Shape } from './shape';

export function toShape(item: Item): Shape {
  const { kind, points, ringSizes, fill } = packItem(item);
  return {
    kind, points,
    ...(ringSizes.length === 1 ? {} : { rings: ringSizes }),
    ...(fill === 'nonzero' ? { fill } : {}),
  };
}

function pairs(points: Float64Array, first: number, end: number): Pair[] {
  return Array.from({ length: end - first }, (_, i) => [points[2 * (first + i)]!, points[2 * (first + i) + 1]!] as const);
}

export function toItem(shape: Shape): Item {
  const all = pairs(shape.points, 0, shape.points.length / 2);
  if (shape.kind === 'point') return { kind: 'point', xy: all[0]! };
  if (shape.kind === 'segment') return { kind: 'segment', points: [all[0]!, all[1]!] };
  if (shape.kind === 'polyline') return { kind: 'polyline', points: all };
  const ranges = ringRanges(shape);
  const rings: Pair[][] = [];
  for (let r = 0; r < ranges.length; r += 2) rings.push(pairs(shape.points, ranges[r]!, ranges[r + 1]!));
  return { kind: 'polygon', rings, ...(shape.fill === undefined ? {} : { fill: shape.fill }) };
}

function toNumber(id: ItemId): number {
  if (typeof id === 'number') return id;
  throw new InputError(`the item ${id} has an id above 2^53`, {}, 'Give it a smaller id: this page counts in numbers up to 2^53');
}

const toPoint = (pair: Pair): XY => ({ x: pair[0], y: pair[1] });

/** The ends of the path in a new world: the ends in the file, or two opposite corners of the domain. */
function endsFor([x0, y0, x1, y1]: Bounds, given: { start?: Pair | null; goal?: Pair | null; radius?: number }): Ends {
  const at = (part: number): XY => ({ x: x0 + part * (x1 - x0), y: y0 + part * (y1 - y0) });
  return {
    start: given.start ? toPoint(given.start) : at(0.04),
    goal: given.goal ? toPoint(given.goal) : at(0.96),
    radius: given.radius ?? 0,
  };
}

export interface Opened {
  readonly document: Document;
  readonly ends: Ends;
  /** The lines of a script that every world refuses. */
  readonly refused: readonly RefusedLine[];
}

const READER: Reader = { id: toNumber, shape: ({ item }) => toShape(item) };

/** The document of a file or an example. The marks and ticks of a script become steps of the log. */
export function openParsed(world: ParsedWorld, title: string): Opened {
  const domain: Bounds = world.domain ?? domainAround(world.items);
  const document = new Document(domain, [], title, {
    yDown: world.yDown ?? false, size: world.items.length, view: world.view ?? domain,
  });
  new Replay(document, READER).run(operationsOfParsed(world));
  return { document, ends: endsFor(domain, world), refused: world.refused ?? [] };
}

/** The document of a link, with its log. */
export function openShared(state: ShareState): Opened {
  const { domain, yDown = false, operations } = state;
  const document = new Document(domain, [], 'from a link', { yDown, size: operations.length });
  new Replay(document, READER).run(operations);
  return { document, ends: endsFor(domain, state), refused: [] };
}

function operationOf({ id, before, after }: Change): Operation {
  if (after === null) return { kind: 'remove', id };
  return { kind: before === null ? 'insert' : 'replace', id, item: toItem(after) };
}

/** The items at the beginning of the log. */
function firstItems(document: Document): IdentifiedShape[] {
  const items = new Map(document.items);
  for (const { id, after } of document.changesTo(0)) {
    if (after === null) items.delete(id);
    else items.set(id, after);
  }
  return [...items].sort(([a], [b]) => a - b);
}

/** The operations of a document up to the position in its log; `tick` separates the steps. */
export function operationsOf(document: Document): Operation[] {
  const operations: Operation[] = firstItems(document).map(([id, shape]) => ({ kind: 'insert', id, item: toItem(shape) }));
  document.log.slice(0, document.cursor).forEach(({ changes }, i) => {
    operations.push({ kind: 'tick', tick: i + 1 });
    for (const change of changes) operations.push(operationOf(change));
  });
  return operations;
}

const toPair = ({ x, y }: XY): Pair => [x, y];

export function linkOf(session: Session, view: SharedView | null): Promise<string> {
  const { document, ends, algorithm } = session;
  return encodeShare({
    domain: document.domain as Domain,
    yDown: document.yDown,
    operations: operationsOf(document),
    start: toPair(ends.start),
    goal: toPair(ends.goal),
    radius: ends.radius,
    algorithm, view,
  });
}

/** The world script of all operations. At its end it asks for the path and the hashes. */
export function scriptOf(session: Session): string {
  const { document, ends, algorithm } = session;
  const operations = operationsOf(document).filter(({ kind }) => kind !== 'tick');
  const query: Operation = {
    kind: 'path', from: toPair(ends.start), to: toPair(ends.goal), radius: ends.radius, algorithm,
  };
  return writeWws(document.domain as Domain, [...operations, query, { kind: 'check' }, { kind: 'hash' }]);
}
