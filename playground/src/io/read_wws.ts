import { makeItem } from './items';
import { LiveItems } from './live_items';
import { quoted, readNumber, readWhole, TextReader } from './text';
import {
  type Algorithm, ALGORITHMS, CornerCount, type Domain, type FillRule, InputError, isInRange, type ItemId, type ItemKind,
  LARGEST_OPERATION_COUNT, type Operation, type ParsedWorld, type PathQuery, rangeError, type RefusedLine, type XY,
} from './types';

const ADVICE = 'docs/formats.md describes world scripts';
const USAGES: Readonly<Record<string, string>> = {
  domain: 'domain X0 Y0 X1 Y1',
  point: 'point ID X Y',
  segment: 'segment ID X1 Y1 X2 Y2',
  polyline: 'polyline ID N X1 Y1 ... XN YN',
  polygon: 'polygon ID [nonzero] N X1 Y1 ... XN YN [/ N X1 Y1 ...]...',
  remove: 'remove ID',
  replace: 'replace KIND ID ...',
  locate: 'locate X Y',
  ray: 'ray X1 Y1 X2 Y2 [RADIUS]',
  disc: 'disc X Y RADIUS',
  nearest: 'nearest X Y RADIUS [goal X2 Y2]',
  path: 'path X1 Y1 X2 Y2 RADIUS [ALGORITHM] [tolerance DISTANCE]',
  clear: 'clear N X1 Y1 ... XN YN',
  check: 'check',
  hash: 'hash',
  tick: 'tick N [HASH]',
  mark: 'mark TICK',
  rewind: 'rewind TICK',
};
const KINDS: readonly string[] = ['point', 'segment', 'polyline', 'polygon'] satisfies ItemKind[];

/** Returns why every world refuses a query, or null. */
function refusalOf(operation: Operation): string | null {
  const radius = 'radius' in operation ? (operation.radius ?? 0) : 0;
  if (!(radius >= 0 && radius < Infinity)) return `the radius ${radius} is negative or not finite`;
  const tolerance = operation.kind === 'path' ? (operation.tolerance ?? 0) : 0;
  return tolerance >= 0 ? null : `the tolerance ${tolerance} is negative or not a number`;
}

class ScriptReader {
  private readonly reader: TextReader;
  private readonly corners = new CornerCount();
  private readonly operations: Operation[] = [];
  private readonly refused: RefusedLine[] = [];
  private usage = '';
  private live = new LiveItems([0, 0, 0, 0]);

  constructor(text: string) {
    this.reader = new TextReader(text);
  }

  private fail(expected: string, found: string): never {
    const usage = this.usage === '' ? '' : ` in '${this.usage}'`;
    throw new InputError(`expected ${expected}${usage}, found ${found}`, this.reader.where, ADVICE);
  }

  private failAt(expected: string, word: string): never {
    return this.fail(expected, word === '' ? 'the end of the line' : quoted(word));
  }

  run(): ParsedWorld {
    this.header();
    const domain = this.domain();
    this.live = new LiveItems(domain);
    while (this.reader.nextWithWord()) this.line();
    const query = this.operations.filter((operation): operation is PathQuery => operation.kind === 'path').pop();
    return {
      ...this.live.result(),
      domain,
      operations: this.operations,
      ...(query && { start: query.from, goal: query.to, radius: query.radius }),
      ...(this.refused.length > 0 && { refused: this.refused }),
    };
  }

  private header(): void {
    const expected = "the header 'waywright 1'";
    if (!this.reader.nextWithWord()) this.fail(expected, 'the end of the text');
    const word = this.reader.word();
    if (word !== 'waywright') this.failAt(expected, word);
    const version = this.reader.word();
    if (version !== '1') this.failAt('format version 1', version);
    this.endOfLine();
  }

  private domain(): Domain {
    const expected = "'domain X0 Y0 X1 Y1' before anything else";
    if (!this.reader.nextWithWord()) this.fail(expected, 'the end of the text');
    const word = this.reader.word();
    if (word !== 'domain') this.failAt(expected, word);
    this.usage = USAGES['domain']!;
    const domain: Domain = [this.coordinate(), this.coordinate(), this.coordinate(), this.coordinate()];
    this.endOfLine();
    for (const axis of [0, 1] as const) {
      if (!(domain[axis] < domain[axis + 2]!)) this.fail(`a number above ${domain[axis]}`, String(domain[axis + 2]));
    }
    return domain;
  }

  private line(): void {
    this.usage = '';
    const word = this.reader.word();
    if (word === 'domain') this.failAt('only one domain', word);
    if (!Object.hasOwn(USAGES, word)) this.failAt(`an operation (${Object.keys(USAGES).slice(1).join(', ')})`, word);
    this.usage = USAGES[word]!;
    const operation = this.operation(word);
    this.endOfLine();
    const reason = refusalOf(operation) ?? this.live.apply(operation);
    if (reason !== null) this.refused.push({ line: this.reader.lineNumber, reason });
    else this.operations.push(operation);
    if (this.operations.length + this.refused.length > LARGEST_OPERATION_COUNT) {
      const what = `the script has more than ${LARGEST_OPERATION_COUNT.toLocaleString('en')} operations`;
      throw new InputError(what, this.reader.where, "Use 'waywright run', which has no such limit");
    }
  }

  private operation(word: string): Operation {
    switch (word) {
      case 'remove':
        return { kind: word, id: this.id() };
      case 'replace':
        return this.replacement();
      case 'mark':
      case 'rewind':
        return { kind: word, tick: word === 'mark' ? this.markTick() : this.rewindTick() };
      case 'tick':
        return this.tick();
      case 'check':
      case 'hash':
        return { kind: word };
      default:
        return KINDS.includes(word) ? this.change('insert', word as ItemKind) : this.query(word);
    }
  }

  private query(word: string): Operation {
    switch (word) {
      case 'locate':
        return { kind: word, at: this.point() };
      case 'disc':
        return { kind: word, at: this.point(), radius: this.number() };
      case 'ray': {
        const ends = { from: this.point(), to: this.point() };
        return this.reader.atEnd ? { kind: word, ...ends } : { kind: word, ...ends, radius: this.number() };
      }
      case 'nearest':
        return this.nearest();
      case 'clear':
        return { kind: word, points: this.ring(this.reader.word()) };
      default:
        return this.path();
    }
  }

  private change(kind: 'insert' | 'replace', shape: ItemKind): Operation {
    const id = this.id();
    if (shape === 'point') return { kind, id, item: makeItem(shape, [this.points(1)]) };
    if (shape === 'segment') return { kind, id, item: makeItem(shape, [this.points(2)]) };
    if (shape === 'polyline') return { kind, id, item: makeItem(shape, [this.ring(this.reader.word())]) };
    let word = this.reader.word();
    const fill: FillRule = word === 'nonzero' ? word : 'even-odd';
    if (fill === 'nonzero') word = this.reader.word();
    const rings = [this.ring(word)];
    while (!this.reader.atEnd) {
      word = this.reader.word();
      if (word !== '/') this.failAt("'/' or the end of the line", word);
      rings.push(this.ring(this.reader.word()));
    }
    return { kind, id, item: makeItem(shape, rings, fill) };
  }

  private replacement(): Operation {
    const word = this.reader.word();
    if (!KINDS.includes(word)) this.failAt("'point', 'segment', 'polyline' or 'polygon'", word);
    this.usage = `replace ${USAGES[word]!}`;
    return this.change('replace', word as ItemKind);
  }

  private ring(countWord: string): XY[] {
    const count = readWhole(countWord);
    if (count === null || count === 0) this.failAt('a count of points, 1 or more,', countWord);
    return this.points(Number(count));
  }

  private points(count: number): XY[] {
    const points: XY[] = [];
    while (points.length < count) {
      points.push(this.point());
      this.corners.add(() => this.reader.where);
    }
    return points;
  }

  private point(): XY {
    return [this.coordinate(), this.coordinate()];
  }

  private number(): number {
    const word = this.reader.word();
    return readNumber(word) ?? this.failAt('a number', word);
  }

  private coordinate(): number {
    const word = this.reader.word();
    const value = readNumber(word) ?? this.failAt('a number', word);
    if (!isInRange(value)) throw rangeError(quoted(word), this.reader.where);
    return value;
  }

  private id(): ItemId {
    const word = this.reader.word();
    return readWhole(word) || this.failAt('an id from 1 to 9223372036854775807', word);
  }

  private endOfLine(): void {
    if (!this.reader.atEnd) this.failAt('the end of the line', this.reader.word());
  }

  private nearest(): Operation {
    const query = { kind: 'nearest', at: this.point(), radius: this.number() } as const;
    if (this.reader.atEnd) return query;
    const word = this.reader.word();
    return word === 'goal' ? { ...query, goal: this.point() } : this.failAt("'goal' or the end of the line", word);
  }

  private path(): Operation {
    const query: PathQuery = { kind: 'path', from: this.point(), to: this.point(), radius: this.number() };
    if (this.reader.atEnd) return query;
    let word = this.reader.word();
    const algorithm: Algorithm | undefined = ALGORITHMS.find((name) => name === word);
    const chosen = algorithm === undefined ? query : { ...query, algorithm };
    if (algorithm !== undefined) {
      if (this.reader.atEnd) return chosen;
      word = this.reader.word();
    }
    const expected = algorithm === undefined ? "'optimal', 'ta', 'tra' or 'tolerance'" : "'tolerance'";
    return word === 'tolerance' ? { ...chosen, tolerance: this.number() } : this.failAt(expected, word);
  }

  private tick(): Operation {
    const word = this.reader.word();
    const tick = readWhole(word) ?? this.failAt('the number of a tick', word);
    if (this.reader.atEnd) return { kind: 'tick', tick };
    const hash = this.reader.word();
    return /^[0-9a-f]{32}$/.test(hash)
      ? { kind: 'tick', tick, hash }
      : this.failAt('32 hexadecimal digits or the end of the line', hash);
  }

  private markTick(): number {
    const next = this.live.lastMark + 1;
    const word = this.reader.word();
    return readWhole(word) === next ? next : this.failAt(`tick ${next}, the one after the last mark,`, word);
  }

  private rewindTick(): number {
    const last = this.live.lastMark;
    const word = this.reader.word();
    const tick = readWhole(word);
    if (typeof tick === 'number' && tick >= 1 && tick <= last) return tick;
    return this.failAt(last === 0 ? 'a mark before' : `a tick from 1 to ${last}, the last mark,`, word);
  }
}

/** Reads a world script. */
export function readWws(text: string): ParsedWorld {
  return new ScriptReader(text).run();
}
