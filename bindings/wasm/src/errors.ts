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
  | 'empty-shape'
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
