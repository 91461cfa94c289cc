import { arena, copyList, readList, toSize } from './buffers.js';
import { refuse, WaywrightError, type ErrorCode } from './errors.js';
import * as abi from './generated/abi.js';
import { addressOf, Handle, make } from './handle.js';
import { check, cTextAt, idAt, lib, scratch, textAt, withProgress } from './runtime.js';
import { Script } from './scene.js';
import { answer, askLong, fromEnum, get, type ItemId, itemsHashAt, packIds, readBytes, readIds, toId } from './values.js';
import { World } from './world.js';
import { type BulkOptions, type Change, copyChanges, packChanges, progressOf } from './world_items.js';

/** Writes a replay log: a world script with the items of a world, each change, and a hash of the items every few ticks. */
export class ReplayWriter extends Handle {
  private readonly log_: number;

  /** Starts a log with the items of the world. Writes a hash at each tick whose number is a multiple of `ticksPerHash`. */
  constructor(world: World, ticksPerHash = 1) {
    const [ticks, address] = [BigInt(toSize(ticksPerHash)), addressOf(World, world)];
    const log = make((text) => lib.ww_text_create(text));
    let writer = 0;
    try {
      writer = make((at) => lib.ww_js_replay_writer_create(address, ticks, log, at));
    } finally {
      if (writer === 0) lib.ww_text_destroy(log);
    }
    super(writer, (at) => {
      lib.ww_replay_writer_destroy(at);
      lib.ww_text_destroy(log);
    });
    this.log_ = log;
  }

  /** Records changes that the world has made. `ids` has the id of each change: the answer of `World.apply`. */
  record(changes: readonly Change[], ids?: readonly ItemId[]): void {
    const [copies, wanted] = [copyChanges(changes), ids === undefined ? null : copyList(ids, 'a list of ids', toId)];
    if (wanted !== null && wanted.length !== copies.length) refuse('each change needs one id');
    arena.reset();
    const list = packChanges(copies);
    const given = wanted === null ? 0 : packIds(wanted).address;
    check(lib.ww_replay_writer_record(this.address, list, copies.length, given));
  }

  /** Ends a tick. Ticks count from 1. */
  tick(world: World): void {
    check(lib.ww_replay_writer_tick(this.address, addressOf(World, world)));
  }

  get lastTick(): number {
    return askLong((tick) => lib.ww_replay_writer_last_tick(this.address, tick));
  }

  /** Returns the text that the writer has written since the last call of this function, and drops it. */
  take(): string {
    void this.address; // throws if the writer was disposed
    const text = readBytes(this.log_, textAt);
    check(lib.ww_js_text_clear(this.log_));
    return text;
  }
}

/** The answer of a replay. The members from `tick` on have no meaning if `isSame` is true. */
export interface ReplayResult {
  /** Whether all changes were made and all hashes are equal. */
  readonly isSame: boolean;
  /** The number of ticks that were replayed. */
  readonly ticks: number;
  /** The first tick whose hash differs, or during which a change was refused. */
  readonly tick: number;
  /** The last tick before `tick` whose hash is equal, or 0. */
  readonly lastSame: number;
  /** The line of the hash or of the refused change in the script. */
  readonly line: number;
  /** The hash in the log, and the hash of the replayed world. */
  readonly expected: string;
  readonly computed: string;
  /** The items that were changed after tick `lastSame`, or the refused item. */
  readonly changed: ItemId[];
  /** Why the world refused a change, or null. */
  readonly refusal: WaywrightError | null;
}

function readRefusal(replay: number): WaywrightError {
  const { ww_error: layout } = abi;
  const struct = scratch.struct2;
  const { address, count } = readList(1, (...list) => lib.ww_replay_refusal(replay, answer(layout, struct), ...list));
  const code = cTextAt(lib.ww_status_name(get.int(struct + layout.status))) as ErrorCode;
  return new WaywrightError(
    code, textAt(address, count - 1), idAt(struct + layout.item), get.long(struct + layout.index),
  );
}

function readResult(replay: number): ReplayResult {
  const { ww_replay_result: layout } = abi;
  const struct = answer(layout);
  check(lib.ww_replay_get_result(replay, struct));
  const isRefused = get.flag(struct + layout.isRefused);
  const result = {
    isSame: get.flag(struct + layout.isSame),
    ticks: get.long(struct + layout.ticks),
    tick: get.long(struct + layout.tick),
    lastSame: get.long(struct + layout.lastSame),
    line: get.size(struct + layout.line),
    expected: itemsHashAt(struct + layout.expected),
    computed: itemsHashAt(struct + layout.computed),
  };
  const changed = readIds(readList(8, (...list) => lib.ww_replay_changed(replay, ...list)));
  return { ...result, changed, refusal: isRefused ? readRefusal(replay) : null };
}

/** Makes the changes of a log in a new world, and compares the hash of its items with each hash in the log. */
export function replay(log: Script, options: BulkOptions = {}): ReplayResult {
  const [given, progress] = [addressOf(Script, log), progressOf(options)];
  const address = make((at) => lib.ww_replay_create(at));
  try {
    const reports = progress === undefined ? 0 : 1;
    withProgress(progress, () => check(lib.ww_js_replay_run(address, given, reports)));
    return readResult(address);
  } finally {
    lib.ww_replay_destroy(address);
  }
}

export type DifferenceKind = 'domain' | 'change' | 'hash' | 'length';
const DIFFERENCE_KINDS = ['domain', 'change', 'hash', 'length'] as const;

/** The first difference between two logs. */
export interface ReplayDifference {
  /** What differs: the domain, a change, only a hash, or the number of ticks. */
  readonly kind: DifferenceKind;
  /** The lines in the two logs, or 0 if a log ends before the difference. */
  readonly line: number;
  readonly otherLine: number;
  /** The tick during which the logs begin to differ. */
  readonly tick: number;
  /** For the kind `change`: the items that the two logs change there, or 0. */
  readonly item: ItemId;
  readonly otherItem: ItemId;
  /** The items that were changed since the last equal hash, if a hash differs. */
  readonly changed: ItemId[];
}

/** Compares two logs, change by change and hash by hash. Returns null if they are equal. */
export function findDifference(log: Script, other: Script): ReplayDifference | null {
  const { ww_replay_difference: layout } = abi;
  const struct = scratch.struct;
  const [first, second] = [addressOf(Script, log), addressOf(Script, other)];
  const changed = readIds(
    readList(8, (...list) => lib.ww_find_difference(first, second, answer(layout), ...list)),
  );
  if (!get.flag(struct + layout.isDifferent)) return null;
  return {
    kind: fromEnum(DIFFERENCE_KINDS, get.int(struct + layout.kind)),
    line: get.size(struct + layout.line),
    otherLine: get.size(struct + layout.otherLine),
    tick: get.long(struct + layout.tick),
    item: idAt(struct + layout.item),
    otherItem: idAt(struct + layout.otherItem),
    changed,
  };
}
