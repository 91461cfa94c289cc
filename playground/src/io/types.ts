/** A point of the plane: x, y. */
export type XY = readonly [number, number];
/** A closed box: minimum x, minimum y, maximum x, maximum y. */
export type Domain = readonly [number, number, number, number];
/** The id of an item: 1 to 2^63 - 1. Ids up to 2^53 - 1 are numbers, larger ids are bigints. */
export type ItemId = number | bigint;
/** Which positions lie inside a polygon. Without a fill rule, it is `even-odd`. */
export type FillRule = 'even-odd' | 'nonzero';
export type Algorithm = 'optimal' | 'ta' | 'tra';
export const ALGORITHMS: readonly Algorithm[] = ['optimal', 'ta', 'tra'];

/** The shape of an item, as a world script has it. The side from the last corner of a ring to the first belongs to the ring. */
export type Item =
  | { readonly kind: 'point'; readonly xy: XY }
  | { readonly kind: 'segment'; readonly points: readonly [XY, XY] }
  | { readonly kind: 'polyline'; readonly points: readonly XY[] }
  | { readonly kind: 'polygon'; readonly rings: readonly (readonly XY[])[]; readonly fill?: FillRule };
export type ItemKind = Item['kind'];

/** One line of a world script after its domain: a change of the world, a query or a check. */
export type Operation =
  | { readonly kind: 'insert' | 'replace'; readonly id: ItemId; readonly item: Item }
  | { readonly kind: 'remove'; readonly id: ItemId }
  | { readonly kind: 'mark' | 'rewind'; readonly tick: number }
  | { readonly kind: 'tick'; readonly tick: ItemId; readonly hash?: string }
  | { readonly kind: 'locate'; readonly at: XY }
  | { readonly kind: 'ray'; readonly from: XY; readonly to: XY; readonly radius?: number }
  | { readonly kind: 'disc'; readonly at: XY; readonly radius: number }
  | { readonly kind: 'nearest'; readonly at: XY; readonly radius: number; readonly goal?: XY }
  | PathQuery
  | { readonly kind: 'clear'; readonly points: readonly XY[] }
  | { readonly kind: 'check' | 'hash' };

export interface PathQuery {
  readonly kind: 'path';
  readonly from: XY;
  readonly to: XY;
  readonly radius: number;
  readonly algorithm?: Algorithm;
  /** The largest distance by which the search may move a blocked end. Infinity is no limit. */
  readonly tolerance?: number;
}

/** A line of a script that every world refuses, and that is therefore not among the operations. */
export interface RefusedLine {
  readonly line: number;
  readonly reason: string;
}

/** What a file or an example contains. */
export interface ParsedWorld {
  /** The items that are left after all operations. Without `ids`, their ids are 1, 2, 3, ... */
  readonly items: readonly Item[];
  readonly ids?: readonly ItemId[];
  readonly domain?: Domain;
  /** Whether the y axis of the file points down. */
  readonly yDown?: boolean;
  /** The ends of the last path query of a script, or a suggestion. */
  readonly start?: XY;
  readonly goal?: XY;
  readonly radius?: number;
  /** The part of the domain that is worth seeing first. Without it, that is the whole domain. */
  readonly view?: Domain;
  /** All operations of a script in their order. They make `items`, and more: the next id and the marks. */
  readonly operations?: readonly Operation[];
  readonly refused?: readonly RefusedLine[];
}

/** Where an input is wrong. Lines, columns and bytes count from 1. `path` names a member of a JSON text. */
export interface Where {
  readonly line?: number;
  readonly column?: number;
  readonly byte?: number;
  readonly path?: string;
}

function describe({ line, column, byte, path }: Where): string {
  const parts = [
    path,
    line === undefined ? undefined : `line ${line}`,
    column === undefined ? undefined : `column ${column}`,
    byte === undefined ? undefined : `byte ${byte}`,
  ];
  return parts.filter((part) => part !== undefined && part !== '').join(', ');
}

/** An input that cannot be read. The message says what is wrong, where, and what to do. */
export class InputError extends Error {
  /** What is wrong. */
  readonly what: string;
  readonly where: Where;
  /** What the user can do. */
  readonly advice: string;

  constructor(what: string, where: Where, advice: string) {
    const place = describe(where);
    super(`${place === '' ? '' : `${place}: `}${what}. ${advice}.`);
    this.name = 'InputError';
    this.what = what;
    this.where = where;
    this.advice = advice;
  }
}

/** The largest input. */
export const LARGEST_FILE = 50_000_000;
export const LARGEST_CORNER_COUNT = 2_000_000;
export const LARGEST_OPERATION_COUNT = 2_000_000;

/** The magnitudes of the coordinates that a world accepts, besides 0. */
export const LARGEST_COORDINATE = 2 ** 100;
export const SMALLEST_COORDINATE = 2 ** -100;

/** Returns whether a world accepts a coordinate. */
export function isInRange(coordinate: number): boolean {
  const size = Math.abs(coordinate);
  return size === 0 || (size >= SMALLEST_COORDINATE && size <= LARGEST_COORDINATE);
}

/** Returns the error for a coordinate that no world accepts. */
export function rangeError(found: string, where: Where): InputError {
  return new InputError(
    `the coordinate ${found} is not 0 and not of a size from 2^-100 to 2^100`,
    where,
    'A world accepts 0 and numbers from about 7.9e-31 to 1.3e30, with either sign; scale or correct this coordinate',
  );
}

/** Counts the corners of an input, and refuses too many. */
export class CornerCount {
  private count = 0;

  add(where: () => Where): void {
    if (++this.count <= LARGEST_CORNER_COUNT) return;
    throw new InputError(
      `the input has more than ${LARGEST_CORNER_COUNT.toLocaleString('en')} corners`,
      where(),
      'Cut the input into pieces, simplify it, or use the native command, which has no such limit',
    );
  }
}
