import { arena, copyList, copyPoint, flatten, packPoints, packText, type Point, type Points } from './buffers.js';
import { PATH_STATUSES, type PathStatus } from './enums.js';
import { toFlag, toNumber, toObject } from './errors.js';
import * as abi from './generated/abi.js';
import { addressOf, Handle, make } from './handle.js';
import { Path } from './path.js';
import { check, encode, lib, scratch } from './runtime.js';
import { copyPathQuery, copySvgOptions, packPathQuery, packSvgOptions, type PathQuery, type RayHit, type SvgOptions } from './structs.js';
import { answer, type Box, copyBox, get, packIds, put, readBox, readPoint, toEnum, toId, writeBox, writeEnds, writePoint } from './values.js';
import type { Location } from './world.js';

const LOCATIONS = ['vertex', 'edge', 'face'] as const;

/** The address of a text in the arena, or null. */
function packOptional(text: string | undefined): number {
  return text === undefined ? 0 : packText(encode(text)).address;
}

/** The transform between a world and its picture. */
export interface SvgFrame {
  readonly yDown: boolean;
  /** What the picture shows, in the coordinates of the world. */
  readonly shown: Box;
  /** The box, in pixels, of the map: the part of the picture that shows the world, without title, axes and legend. */
  readonly map: Box;
  /** The pixels of one unit of length. */
  readonly scale: number;
}

export function svgFrame(domain: Box, options: SvgOptions = {}): SvgFrame {
  const { ww_svg_frame: layout } = abi;
  const [box, copy] = [copyBox(domain), copySvgOptions(options)];
  arena.reset();
  const given = packSvgOptions(copy);
  const struct = answer(layout);
  check(lib.ww_svg_get_frame(writeBox(scratch.box, box), given, struct));
  return {
    yDown: get.flag(struct + layout.yDown),
    shown: readBox(struct + layout.shown),
    map: readBox(struct + layout.map),
    scale: get.float(struct + layout.scale),
  };
}

function packFrame(frame: SvgFrame): number {
  const { ww_svg_frame: layout } = abi;
  const { yDown, shown: givenShown, map: givenMap, scale } = toObject(frame, 'a frame');
  const [shown, map] = [copyBox(givenShown), copyBox(givenMap)];
  const struct = answer(layout);
  put.flag(struct + layout.yDown, toFlag(yDown, 'yDown'));
  writeBox(struct + layout.shown, shown);
  writeBox(struct + layout.map, map);
  put.float(struct + layout.scale, toNumber(scale, 'the scale'));
  return struct;
}

/** Returns the pixel of a point of the world. */
export function svgToPicture(frame: SvgFrame, point: Point): Point {
  const [at, given] = [copyPoint(point), packFrame(frame)];
  check(lib.ww_svg_to_picture(given, writePoint(scratch.a, at), scratch.b));
  return readPoint(scratch.b);
}

/** Returns the point of the world at a pixel. */
export function svgToWorld(frame: SvgFrame, pixels: Point): Point {
  const [at, given] = [copyPoint(pixels), packFrame(frame)];
  check(lib.ww_svg_to_world(given, writePoint(scratch.a, at), scratch.b));
  return readPoint(scratch.b);
}

/** The style of a mark. A colour is any CSS colour; the default is the colour of the theme. A hint is the text on hover. */
export interface MarkStyle {
  readonly colour?: string;
  readonly hint?: string;
}

/** The content of a picture on top of the world. The overlay copies everything that you add. */
export class SvgOverlay extends Handle {
  constructor() {
    super(make((address) => lib.ww_svg_overlay_create(address)), (address) => lib.ww_svg_overlay_destroy(address));
  }

  clear(): this {
    check(lib.ww_svg_overlay_clear(this.address));
    return this;
  }

  addPath(path: Path): this {
    check(lib.ww_svg_add_path(this.address, addressOf(Path, path)));
    return this;
  }

  /** Adds the path of a disc and its query. */
  addDiscPath(query: PathQuery, path: Path): this {
    const given = packPathQuery(copyPathQuery(query));
    check(lib.ww_svg_add_disc_path(this.address, given, addressOf(Path, path)));
    return this;
  }

  addFailedPath(start: Point, goal: Point, status: PathStatus): this {
    const [number, [a, b]] = [toEnum(PATH_STATUSES, status), writeEnds(start, goal)];
    check(lib.ww_svg_add_failed_path(this.address, a, b, number));
    return this;
  }

  addRay(from: Point, to: Point, hit: RayHit): this {
    const { ww_ray_hit: layout } = abi;
    const { hit: isHit, at, contact, items: ids } = toObject(hit, 'a hit');
    const copy = { at: copyPoint(at), contact: copyPoint(contact), ids: copyList(ids, 'a list of ids', toId) };
    const [a, b] = writeEnds(from, to);
    arena.reset();
    const items = packIds(copy.ids);
    const struct = answer(layout);
    put.flag(struct + layout.hit, toFlag(isHit, 'hit'));
    writePoint(struct + layout.at, copy.at);
    writePoint(struct + layout.contact, copy.contact);
    check(lib.ww_svg_add_ray(this.address, a, b, struct, items.address, items.count));
    return this;
  }

  addLocation(at: Point, location: Location): this {
    const { ww_location: layout } = abi;
    const { kind, vertices: givenVertices, polygons: givenIds } = toObject(location, 'a location');
    const vertices = copyList(givenVertices, 'a list of vertices', copyPoint).slice(0, 3);
    const [ids, point] = [copyList(givenIds, 'a list of ids', toId), writePoint(scratch.a, at)];
    arena.reset();
    const polygons = packIds(ids);
    const struct = answer(layout);
    put.int(struct + layout.kind, toEnum(LOCATIONS, kind));
    put.size(struct + layout.vertexCount, vertices.length);
    vertices.forEach((vertex, i) => writePoint(struct + layout.vertices + 16 * i, vertex));
    check(lib.ww_svg_add_location(this.address, point, struct, polygons.address, polygons.count));
    return this;
  }

  addDisc(centre: Point, radius: number, style: MarkStyle = {}): this {
    const [copy, size, at] = [{ ...style }, toNumber(radius, 'the radius'), writePoint(scratch.a, centre)];
    arena.reset();
    const [colour, hint] = [packOptional(copy.colour), packOptional(copy.hint)];
    check(lib.ww_svg_add_disc(this.address, at, size, colour, hint));
    return this;
  }

  addPolyline(points: Points, width: number, style: MarkStyle & { readonly dashed?: boolean } = {}): this {
    const [copy, size, coordinates] = [{ ...style }, toNumber(width, 'the width'), flatten(points)];
    const isDashed = toFlag(copy.dashed ?? false, 'dashed');
    arena.reset();
    const [colour, hint] = [packOptional(copy.colour), packOptional(copy.hint)];
    const { address, count } = packPoints(coordinates);
    check(lib.ww_svg_add_polyline(this.address, address, count, size, isDashed ? 1 : 0, colour, hint));
    return this;
  }

  /** Adds a text beside `at`. The text keeps a disc of `radius` around `at` free. `size` is in pixels, 14 is usual. */
  addLabel(at: Point, text: string, radius: number, size = 14, colour?: string): this {
    const [point, free, height] = [writePoint(scratch.a, at), toNumber(radius, 'the radius'), toNumber(size, 'the size')];
    arena.reset();
    const [label, painted] = [packText(encode(text)).address, packOptional(colour)];
    check(lib.ww_svg_add_label(this.address, point, label, free, height, painted));
    return this;
  }

  /** Adds an entry to the legend. */
  addKey(text: string, colour: string): this {
    arena.reset();
    const [label, painted] = [packText(encode(text)).address, packText(encode(colour)).address];
    check(lib.ww_svg_add_key(this.address, label, painted));
    return this;
  }

  /** Appends SVG elements in the coordinates of the picture. They must be well-formed XML. */
  addElements(elements: string): this {
    arena.reset();
    check(lib.ww_svg_add_elements(this.address, packText(encode(elements)).address));
    return this;
  }
}
