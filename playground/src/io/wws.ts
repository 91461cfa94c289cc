import { ringsOf } from './items';
import type { Domain, Item, ItemId, Operation, ParsedWorld, XY } from './types';

/** Returns a number without an exponent. Above 2^53, all its digits count. */
function fixedText(size: number, digits: string, exponent: number): string {
  if (exponent < 0) return `0.${'0'.repeat(-exponent - 1)}${digits}`;
  if (digits.length > exponent + 1) return `${digits.slice(0, exponent + 1)}.${digits.slice(exponent + 1)}`;
  return String(BigInt(size));
}

/**
 * Returns the shortest decimal number that reads back as the same double, and `0` for -0, as the native library writes it.
 * Infinity and NaN become the words that world scripts have for them.
 */
export function numberText(value: number): string {
  if (!Number.isFinite(value)) return Number.isNaN(value) ? 'nan' : value > 0 ? 'inf' : '-inf';
  const size = Math.abs(value);
  const [mantissa, exponentText] = size.toExponential().split('e') as [string, string];
  const exponent = Number(exponentText);
  const scientific = `${mantissa}e${exponent < 0 ? '-' : '+'}${String(Math.abs(exponent)).padStart(2, '0')}`;
  const digits = mantissa.replace('.', '');
  // A number without an exponent is chosen by its length, before a text of many digits is made.
  const isFixed = fixedLength(digits.length, exponent) <= scientific.length;
  return `${value < 0 ? '-' : ''}${isFixed ? fixedText(size, digits, exponent) : scientific}`;
}

function fixedLength(digitCount: number, exponent: number): number {
  if (exponent < 0) return digitCount + 1 - exponent;
  return digitCount > exponent + 1 ? digitCount + 1 : exponent + 1;
}

function numbersText(values: readonly number[]): string {
  return values.map((value) => ` ${numberText(value)}`).join('');
}

function ringText(ring: readonly XY[], withCount: boolean): string {
  return `${withCount ? ` ${ring.length}` : ''}${ring.map(numbersText).join('')}`;
}

/** Returns the line that inserts an item. */
export function itemText(id: ItemId, item: Item): string {
  const withCount = item.kind === 'polyline' || item.kind === 'polygon';
  const fill = item.kind === 'polygon' && item.fill === 'nonzero' ? ' nonzero' : '';
  const rings = ringsOf(item).map((ring) => ringText(ring, withCount));
  return `${item.kind} ${id}${fill}${rings.join(' /')}`;
}

function queryText(query: Exclude<Operation, { kind: 'insert' | 'replace' | 'remove' }>): string {
  switch (query.kind) {
    case 'locate':
      return `locate${numbersText(query.at)}`;
    case 'disc':
      return `disc${numbersText([...query.at, query.radius])}`;
    case 'nearest':
      return `nearest${numbersText([...query.at, query.radius])}${query.goal ? ` goal${numbersText(query.goal)}` : ''}`;
    case 'ray':
      return `ray${numbersText([...query.from, ...query.to, ...(query.radius === undefined ? [] : [query.radius])])}`;
    case 'path': {
      const algorithm = query.algorithm === undefined ? '' : ` ${query.algorithm}`;
      const tolerance = query.tolerance === undefined ? '' : ` tolerance ${numberText(query.tolerance)}`;
      return `path${numbersText([...query.from, ...query.to, query.radius])}${algorithm}${tolerance}`;
    }
    case 'clear':
      return `clear${ringText(query.points, true)}`;
    case 'tick':
      return `tick ${query.tick}${query.hash === undefined ? '' : ` ${query.hash}`}`;
    case 'mark':
    case 'rewind':
      return `${query.kind} ${query.tick}`;
    default:
      return query.kind;
  }
}

/** Returns one operation as a line of a world script, without its line end. */
export function operationText(operation: Operation): string {
  switch (operation.kind) {
    case 'insert':
      return itemText(operation.id, operation.item);
    case 'replace':
      return `replace ${itemText(operation.id, operation.item)}`;
    case 'remove':
      return `remove ${operation.id}`;
    default:
      return queryText(operation);
  }
}

/** Returns the world script of a list of operations. `waywright run` gets the same world from it. */
export function writeWws(domain: Domain, operations: readonly Operation[]): string {
  const lines = operations.map((operation) => `${operationText(operation)}\n`);
  return `waywright 1\ndomain${numbersText(domain)}\n${lines.join('')}`;
}

/** Returns the operations that make a world: its own ones, or an insertion for each item. */
export function operationsOf(world: ParsedWorld): readonly Operation[] {
  if (world.operations) return world.operations;
  return world.items.map((item, i) => ({ kind: 'insert', id: world.ids?.[i] ?? i + 1, item }));
}
