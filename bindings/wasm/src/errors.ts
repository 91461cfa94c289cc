/** The code of a {@link WaywrightError}. The codes before `out-of-memory` are values of `waywright::ErrorCode` in C++. */
export type ErrorCode =
  | 'coordinate-range'
  | 'out-of-domain'
  | 'id-in-use'
  | 'unknown-id'
  | 'bad-radius'
  | 'bad-distance'
  | 'bad-id'
  | 'bad-domain'
  | 'bad-shape'
  | 'too-large'
  | 'too-many-vertices'
  | 'world-gone'
  | 'not-supported'
  | 'no-bridges'
  | 'no-history'
  | 'old-tick'
  | 'unknown-tick'
  | 'unreadable'
  | 'malformed'
  | 'unwritable'
  | 'out-of-memory'
  | 'invalid-argument'
  | 'internal-error'
  | 'disposed'
  | 'not-initialised';

/** The error that each function of the package throws if it refuses a call. A refused call has changed no world. */
export class WaywrightError extends Error {
  /** The kind of the error. */
  readonly code: ErrorCode;
  /** The id of the item that caused the error, or null. */
  readonly item: number | bigint | null;
  /** The index of the refused element in its list (from 0), or a line number (from 1). */
  readonly index: number;

  constructor(code: ErrorCode, message: string, item: number | bigint | null = null, index = 0, cause?: unknown) {
    super(message, cause === undefined ? undefined : { cause });
    this.name = 'WaywrightError';
    this.code = code;
    this.item = item;
    this.index = index;
  }
}

/** @internal */
export function refuse(message: string): never {
  throw new WaywrightError('invalid-argument', message);
}

/** @internal Returns how a message calls a value that it refuses. */
export function shown(value: unknown): string {
  if (typeof value === 'string') return value.length > 40 ? 'a long text' : `'${value}'`;
  if (typeof value === 'function') return 'a function';
  if (typeof value !== 'object' || value === null) return String(value);
  if (Array.isArray(value)) return 'an array';
  const name: unknown = value.constructor?.name;
  return typeof name === 'string' && name !== 'Object' ? `an object of the class ${name}` : 'an object';
}

/** @internal Returns a number, or throws. */
export function toNumber(value: number, what: string): number {
  return typeof value === 'number' ? value : refuse(`${what} is ${shown(value)}, not a number`);
}

/** @internal Returns an object, or throws. */
export function toObject<T extends object>(value: T, what: string): T {
  return typeof value === 'object' && value !== null ? value : refuse(`${what} is ${shown(value)}, not an object`);
}

/** @internal Returns a truth value, or throws. */
export function toFlag(value: boolean, what: string): boolean {
  return typeof value === 'boolean' ? value : refuse(`${what} is ${shown(value)}, not true or false`);
}
