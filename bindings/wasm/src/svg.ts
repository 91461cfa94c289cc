import { arena, packPoints, packText, type Point, type Points } from './buffers.js';
import * as abi from './generated/abi.js';
import { Handle, make } from './handle.js';
import { packQuery, type Path, PATH_STATUSES, type PathQuery, type PathStatus } from './path.js';
import { check, encode, lib, slots } from './runtime.js';
import { answer, type Box, get, packIds, put, readBox, readPoint, toEnum, writeBox, writePoint } from './values.js';
import type { Location, RayHit } from './world.js';

export type SvgTheme = 'automatic' | 'light' | 'dark';
const SVG_THEMES = ['automatic', 'light', 'dark'] as const;
const LOCATIONS = ['vertex', 'edge', 'face'] as const;

export interface SvgOptions {
  /** The default is `automatic`. */
  readonly theme?: SvgTheme;
  /** In pixels. The default is 1200. */
  readonly width?: number;
  /** Whether the picture shows the mesh, axes and ids. The default is true. */
  readonly mesh?: boolean;
  readonly axes?: boolean;
  readonly ids?: boolean;
  readonly yDown?: boolean;
  /** The box that the picture shows. The default is the domain. */
  readonly crop?: Box;
  readonly title?: string;
}

/** The address of a text in the arena, or null. */
function packOptional(text: string | undefined): number {
  return text === undefined ? 0 : packText(encode(text)).address;
}

/** Writes options to a struct of the module. The title goes into the arena. */
export function packSvgOptions(options: SvgOptions): number {
  const { ww_svg_options: layout } = abi;
  const title = packOptional(options.title);
  const struct = slots.struct2;
  check(lib.ww_svg_options_init(struct, layout.size_));
  if (options.theme !== undefined) put.int(struct + layout.theme, toEnum(SVG_THEMES, options.theme));
  if (options.width !== undefined) put.float(struct + layout.width, options.width);
  for (const flag of ['mesh', 'axes', 'ids', 'yDown'] as const) {
    const value = options[flag];
    if (value !== undefined) put.flag(struct + layout[flag], value);
  }
  if (options.crop !== undefined) {
    put.flag(struct + layout.hasCrop, true);
    writeBox(struct + layout.crop, options.crop);
  }
  put.size(struct + layout.title, title);
  return struct;
}

/** The transform between a world and its picture. */
export interface SvgFrame {
  readonly yDown: boolean;
  /** What the picture shows, in the coordinates of the world. */
  readonly shown: Box;
  /** The box of the map in the picture, in pixels. */
  readonly map: Box;
  /** The pixels of one unit of length. */
  readonly scale: number;
}

export function svgFrame(domain: Box, options: SvgOptions = {}): SvgFrame {
  const { ww_svg_frame: layout } = abi;
  arena.reset();
  const given = packSvgOptions(options);
  const struct = answer(layout);
  check(lib.ww_svg_get_frame(writeBox(slots.box, domain), given, struct));
  return {
    yDown: get.flag(struct + layout.yDown),
    shown: readBox(struct + layout.shown),
    map: readBox(struct + layout.map),
    scale: get.float(struct + layout.scale),
  };
}

function packFrame(frame: SvgFrame): number {
  const { ww_svg_frame: layout } = abi;
  const struct = answer(layout);
  put.flag(struct + layout.yDown, frame.yDown);
  writeBox(struct + layout.shown, frame.shown);
  writeBox(struct + layout.map, frame.map);
  put.float(struct + layout.scale, frame.scale);
  return struct;
}

/** Returns the pixel of a point of the world. */
export function svgToPicture(frame: SvgFrame, point: Point): Point {
  check(lib.ww_svg_to_picture(packFrame(frame), writePoint(slots.a, point), slots.b));
  return readPoint(slots.b);
}

/** Returns the point of the world at a pixel. */
export function svgToWorld(frame: SvgFrame, pixels: Point): Point {
  check(lib.ww_svg_to_world(packFrame(frame), writePoint(slots.a, pixels), slots.b));
  return readPoint(slots.b);
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
    check(lib.ww_svg_add_path(this.address, path.address));
    return this;
  }

  /** Adds the path of a disc and its query. */
  addDiscPath(query: PathQuery, path: Path): this {
    check(lib.ww_svg_add_disc_path(this.address, packQuery(query, query.start, query.goal), path.address));
    return this;
  }

  addFailedPath(start: Point, goal: Point, status: PathStatus): this {
    const number = toEnum(PATH_STATUSES, status);
    check(lib.ww_svg_add_failed_path(this.address, writePoint(slots.a, start), writePoint(slots.b, goal), number));
    return this;
  }

  addRay(from: Point, to: Point, hit: RayHit): this {
    const { ww_ray_hit: layout } = abi;
    arena.reset();
    const items = packIds(hit.items);
    const struct = answer(layout);
    put.flag(struct + layout.hit, hit.hit);
    writePoint(struct + layout.at, hit.at);
    writePoint(struct + layout.contact, hit.contact);
    const [a, b] = [writePoint(slots.a, from), writePoint(slots.b, to)];
    check(lib.ww_svg_add_ray(this.address, a, b, struct, items.address, items.count));
    return this;
  }

  addLocation(at: Point, location: Location): this {
    const { ww_location: layout } = abi;
    arena.reset();
    const polygons = packIds(location.polygons);
    const struct = answer(layout);
    put.int(struct + layout.kind, toEnum(LOCATIONS, location.kind));
    put.size(struct + layout.vertexCount, Math.min(location.vertices.length, 3));
    location.vertices.slice(0, 3).forEach((vertex, i) => writePoint(struct + layout.vertices + 16 * i, vertex));
    const point = writePoint(slots.a, at);
    check(lib.ww_svg_add_location(this.address, point, struct, polygons.address, polygons.count));
    return this;
  }

  addDisc(centre: Point, radius: number, style: MarkStyle = {}): this {
    arena.reset();
    const [colour, hint] = [packOptional(style.colour), packOptional(style.hint)];
    check(lib.ww_svg_add_disc(this.address, writePoint(slots.a, centre), radius, colour, hint));
    return this;
  }

  addPolyline(points: Points, width: number, style: MarkStyle & { readonly dashed?: boolean } = {}): this {
    arena.reset();
    const [colour, hint] = [packOptional(style.colour), packOptional(style.hint)];
    const { address, count } = packPoints(points);
    check(lib.ww_svg_add_polyline(this.address, address, count, width, style.dashed === true ? 1 : 0, colour, hint));
    return this;
  }

  /** Adds a text beside `at`. The text keeps a disc of `radius` around `at` free. `size` is in pixels, 14 is usual. */
  addLabel(at: Point, text: string, radius: number, size = 14, colour?: string): this {
    arena.reset();
    const [label, painted] = [packText(encode(text)).address, packOptional(colour)];
    check(lib.ww_svg_add_label(this.address, writePoint(slots.a, at), label, radius, size, painted));
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
