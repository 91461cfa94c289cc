import { arena, packText, type Point, readList, toBytes, toSize } from './buffers.js';
import { PATH_ALGORITHMS, type PathAlgorithm } from './enums.js';
import { toFlag } from './errors.js';
import * as abi from './generated/abi.js';
import { Address, addressOf, Handle, make, ownAddressOf } from './handle.js';
import { ItemList } from './items.js';
import { check, cTextAt, encode, idAt, lib, scratch, textAt, u32 } from './runtime.js';
import { type Agent, readAgent, readScenarioQuery, type ScenarioQuery } from './structs.js';
import {
  answer, askSize, askText, type Box, fromEnum, get, type ItemId, itemsHashAt, readBox, readPoint, writeBox,
} from './values.js';

export type SceneFormat = 'script' | 'movingai' | 'triangle-poly' | 'triangle-node' | 'saved-world';
const SCENE_FORMATS = ['script', 'movingai', 'triangle-poly', 'triangle-node', 'saved-world'] as const;

/** Returns the format for the ending of a file name. */
export function sceneFormat(fileName: string): SceneFormat {
  const name = encode(fileName);
  arena.reset();
  const { address } = packText(name);
  check(lib.ww_scene_format_of(address, scratch.flag));
  return fromEnum(SCENE_FORMATS, get.int(scratch.flag));
}

/** Copies a text and its name for error messages into the arena, and calls `parse`. */
function parse(text: string, name: string, call: (text: number, length: number, name: number) => number): void {
  arena.reset();
  const given = packText(encode(text));
  check(call(given.address, given.count, packText(encode(name)).address));
}

/** A domain and items, as a file gives them. */
export class Scene extends Handle {
  constructor() {
    super(make((address) => lib.ww_scene_create(address)), (address) => lib.ww_scene_destroy(address));
  }

  /** Reads a map of Moving AI. Here and in the next functions, `name` is the name of the text in error messages. */
  parseMovingaiMap(text: string, name = 'map'): this {
    const scene = this.change();
    parse(text, name, (at, length, called) => lib.ww_scene_parse_movingai_map(at, length, called, scene));
    return this;
  }

  /** Reads a file .poly of Triangle. If it has no vertices, `nodeText` is the text of the .node file of the same name. */
  parseTrianglePoly(text: string, name = 'poly', nodeText: string | null = null, nodeName = 'node'): this {
    const scene = this.change();
    arena.reset();
    const node = nodeText === null ? { address: 0, count: 0 } : packText(encode(nodeText));
    const poly = packText(encode(text));
    const [called, nodeCalled] = [packText(encode(name)).address, packText(encode(nodeName)).address];
    const { address, count } = poly;
    check(lib.ww_scene_parse_triangle_poly(address, count, called, node.address, node.count, nodeCalled, scene));
    return this;
  }

  /** Reads a file .node of Triangle. */
  parseTriangleNode(text: string, name = 'node'): this {
    const scene = this.change();
    parse(text, name, (at, length, called) => lib.ww_scene_parse_triangle_node(at, length, called, scene));
    return this;
  }

  /** Reads a saved world: its domain and its items. */
  parseSavedWorld(bytes: Uint8Array, name = 'world'): this {
    const scene = this.change();
    const given = toBytes(bytes);
    arena.reset();
    const { address, count } = packText(given);
    check(lib.ww_scene_parse_saved_world(address, count, packText(encode(name)).address, scene));
    return this;
  }

  /** Sets the scene to a copy of a domain and items. */
  set(domain: Box, items: ItemList, yDown = false): this {
    const [box, list] = [writeBox(scratch.box, domain), addressOf(ItemList, items)];
    const isDown = toFlag(yDown, 'yDown');
    check(lib.ww_scene_set(this.change(), box, list, isDown ? 1 : 0));
    return this;
  }

  /** @internal Prepares a change: the items of the scene become invalid. */
  change(): number {
    this.changed();
    return this.address;
  }

  private get info(): number {
    const struct = answer(abi.ww_scene_info);
    check(lib.ww_scene_get_info(this.address, struct));
    return struct;
  }

  get domain(): Box {
    return readBox(this.info + abi.ww_scene_info.domain);
  }
  /** Whether the y axis of the file points down. */
  get yDown(): boolean {
    return get.flag(this.info + abi.ww_scene_info.yDown);
  }

  /** The items. They belong to the scene, and are valid until it changes. */
  get items(): ItemList {
    check(lib.ww_scene_items(this.address, scratch.pointer));
    return new ItemList(new Address(u32[scratch.pointer >>> 2]!, this));
  }

  /** The scene as a world script. */
  toScript(): string {
    return askText((text) => lib.ww_scene_to_script(this.address, text));
  }
}

export type ScriptLineKind =
  | 'insert' | 'remove' | 'replace' | 'locate' | 'ray' | 'disc' | 'nearest' | 'path' | 'check' | 'hash' | 'clear' | 'tick'
  | 'mark' | 'rewind';
export const SCRIPT_LINE_KINDS = [
  'insert', 'remove', 'replace', 'locate', 'ray', 'disc', 'nearest', 'path', 'check', 'hash', 'clear', 'tick', 'mark',
  'rewind',
] as const;

/** One line of a world script. `Script.item` gives the shape of an insertion or a replacement. */
export interface ScriptLine {
  readonly kind: ScriptLineKind;
  /** The first word of the line. */
  readonly word: string;
  /** The line in the text, from 1. */
  readonly line: number;
  readonly id: ItemId;
  readonly from: Point;
  readonly to: Point;
  /** Whether a line `ray` has a radius. */
  readonly hasRadius: boolean;
  /** The agent of a query, with the radius in the line; a point if the line has no radius. */
  readonly agent: Required<Agent>;
  /** The algorithm in the line, or null if the line has no algorithm. */
  readonly algorithm: PathAlgorithm | null;
  /** The tolerance in the line, or null if the line has no tolerance. */
  readonly endTolerance: number | null;
  readonly hasGoal: boolean;
  /** Of a line `tick`: its number. Of a line `mark` or `rewind`: the tick of `World.mark`. */
  readonly tick: number;
  /** Of a line `tick`: the hash of the items, or null if it has none. */
  readonly itemsHash: string | null;
}

/** The lines of a world script. */
export class Script extends Handle {
  constructor() {
    super(make((address) => lib.ww_script_create(address)), (address) => lib.ww_script_destroy(address));
  }

  parse(text: string, name = 'script'): this {
    const { address } = this;
    parse(text, name, (at, length, called) => lib.ww_script_parse(at, length, called, address));
    return this;
  }

  get domain(): Box {
    check(lib.ww_script_domain(this.address, scratch.box, 0));
    return readBox(scratch.box);
  }

  /** The number of lines. */
  get length(): number {
    return askSize((count) => lib.ww_script_line_count(this.address, count));
  }

  line(index: number): ScriptLine {
    const { ww_script_line: layout } = abi;
    const struct = answer(layout);
    check(lib.ww_script_get_line(this.address, toSize(index), struct));
    const has = (flag: number): boolean => get.flag(struct + flag);
    const algorithm = get.int(struct + layout.algorithm);
    return {
      kind: fromEnum(SCRIPT_LINE_KINDS, get.int(struct + layout.kind)),
      word: cTextAt(get.size(struct + layout.word)),
      line: get.size(struct + layout.line),
      id: idAt(struct + layout.id),
      from: readPoint(struct + layout.from),
      to: readPoint(struct + layout.to),
      hasRadius: has(layout.hasRadius),
      agent: readAgent(struct + layout.agent),
      algorithm: has(layout.hasAlgorithm) ? fromEnum(PATH_ALGORITHMS, algorithm) : null,
      endTolerance: has(layout.hasEndTolerance) ? get.float(struct + layout.endTolerance) : null,
      hasGoal: has(layout.hasGoal),
      tick: get.long(struct + layout.tick),
      itemsHash: has(layout.hasItemsHash) ? itemsHashAt(struct + layout.itemsHash) : null,
    };
  }

  /** The item of one line, in the given list or in a new one. */
  item(index: number, list: ItemList = new ItemList()): ItemList {
    check(lib.ww_script_item(this.address, toSize(index), ownAddressOf(ItemList, list)));
    return list;
  }

  /** The items that are left after all changes, in the given scene or in a new one. */
  scene(scene: Scene = new Scene()): Scene {
    const [script, into] = [this.address, addressOf(Scene, scene)];
    scene.change();
    check(lib.ww_script_scene(script, into));
    return scene;
  }
}

/** The queries of a scenario of Moving AI. */
export class Scenario extends Handle {
  constructor() {
    super(make((address) => lib.ww_scenario_create(address)), (address) => lib.ww_scenario_destroy(address));
  }

  parse(text: string, name = 'scenario'): this {
    const { address } = this;
    parse(text, name, (at, length, called) => lib.ww_scenario_parse(at, length, called, address));
    return this;
  }

  /** The number of queries. */
  get length(): number {
    return askSize((count) => lib.ww_scenario_count(this.address, count));
  }

  query(index: number): ScenarioQuery {
    const [scenario, at] = [this.address, toSize(index)];
    const map = readList(1, (...list) => lib.ww_scenario_get(scenario, at, answer(abi.ww_scenario_query), ...list));
    return readScenarioQuery(scratch.struct, textAt(map.address, map.count - 1));
  }
}
