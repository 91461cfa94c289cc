// Draws items and the mesh into layers.
import { BRIDGE_NUMBERS, type BridgesAnswer, LEVEL, type MeshAnswer } from '../engine/protocol';
import type { Document } from '../model/document';
import { type Bounds, ringRanges, type Shape } from '../model/shape';
import type { Camera } from './camera';
import type { Theme } from './theme';

type Context = OffscreenCanvasRenderingContext2D | CanvasRenderingContext2D;

const ITEMS_PER_SLICE = 48;
const FACES_PER_SLICE = 600;
const EDGES_PER_SLICE = 1500;

export function tracePoints(
  context: Context, camera: Camera, points: ArrayLike<number>, first: number, end: number, closes: boolean,
): void {
  for (let i = first; i < end; ++i) {
    const [x, y] = [camera.screenX(points[2 * i]!), camera.screenY(points[2 * i + 1]!)];
    if (i === first) context.moveTo(x, y);
    else context.lineTo(x, y);
  }
  if (closes) context.closePath();
}

function traceShape(context: Context, camera: Camera, shape: Shape): void {
  const ranges = ringRanges(shape);
  for (let r = 0; r < ranges.length; r += 2) {
    tracePoints(context, camera, shape.points, ranges[r]!, ranges[r + 1]!, shape.kind === 'polygon');
  }
}

function paintPolygon(context: Context, camera: Camera, shape: Shape, theme: Theme, isTiny: boolean): void {
  context.fillStyle = theme.solid;
  context.beginPath();
  traceShape(context, camera, shape);
  context.fill(shape.fill ?? 'evenodd');
  if (isTiny) return;
  context.strokeStyle = theme['solid-outline'];
  context.lineWidth = 1;
  context.stroke();
}

function paintWall(context: Context, camera: Camera, shape: Shape, theme: Theme): void {
  context.beginPath();
  traceShape(context, camera, shape);
  context.strokeStyle = theme.wall;
  context.lineWidth = 2.5;
  context.lineCap = 'round';
  context.lineJoin = 'round';
  context.stroke();
}

function paintPoint(context: Context, camera: Camera, shape: Shape, theme: Theme): void {
  context.beginPath();
  context.arc(camera.screenX(shape.points[0]!), camera.screenY(shape.points[1]!), 2.5, 0, 7);
  context.fillStyle = theme.point;
  context.fill();
}

export function paintShape(context: Context, camera: Camera, shape: Shape, theme: Theme, isTiny = false): void {
  if (shape.kind === 'polygon') paintPolygon(context, camera, shape, theme, isTiny);
  else if (shape.points.length === 2) paintPoint(context, camera, shape, theme);
  else paintWall(context, camera, shape, theme);
}

/** Draws the outline of a shape. */
export function outline(context: Context, camera: Camera, shape: Shape, colour: string, width: number): void {
  context.beginPath();
  if (shape.points.length === 2) {
    context.arc(camera.screenX(shape.points[0]!), camera.screenY(shape.points[1]!), 6, 0, 7);
  } else {
    traceShape(context, camera, shape);
  }
  context.strokeStyle = colour;
  context.lineWidth = width;
  context.lineJoin = 'round';
  context.stroke();
}

/** Draws the items of a document, without the hidden ones: polygons first, then walls and points. */
export function* paintItems(
  context: Context, camera: Camera, box: Bounds, document: Document, theme: Theme, hidden: ReadonlyMap<number, Shape>,
): Generator<void> {
  const found = document.find(box).filter((id) => !hidden.has(id));
  let painted = 0;
  for (const wantsPolygons of [true, false]) {
    for (const id of found) {
      const shape = document.items.get(id)!;
      if ((shape.kind === 'polygon') !== wantsPolygons) continue;
      const [x0, y0, x1, y1] = document.boundsOf(id)!;
      paintShape(context, camera, shape, theme, Math.max(x1 - x0, y1 - y0) * camera.scale < 3);
      if (++painted % ITEMS_PER_SLICE === 0) yield;
    }
  }
}

/** Whether a triangle or an edge, given by the first numbers of its vertices, can be in a box. */
function isNear(vertices: Float64Array, indices: Uint32Array, first: number, count: number, box: Bounds): boolean {
  let [left, right, below, above] = [true, true, true, true];
  for (let k = first; k < first + count; ++k) {
    const [x, y] = [vertices[2 * indices[k]!]!, vertices[2 * indices[k]! + 1]!];
    left &&= x < box[0];
    right &&= x > box[2];
    below &&= y < box[1];
    above &&= y > box[3];
  }
  return !(left || right || below || above);
}

export function* paintEdges(
  context: Context, camera: Camera, box: Bounds, mesh: MeshAnswer, theme: Theme,
): Generator<void> {
  const { vertices, edges } = mesh;
  context.strokeStyle = theme.mesh;
  context.lineWidth = 1;
  context.beginPath();
  let painted = 0;
  for (let i = 0; i < edges.length; i += 2) {
    if (!isNear(vertices, edges, i, 2, box)) continue;
    const [a, b] = [2 * edges[i]!, 2 * edges[i + 1]!];
    context.moveTo(camera.screenX(vertices[a]!), camera.screenY(vertices[a + 1]!));
    context.lineTo(camera.screenX(vertices[b]!), camera.screenY(vertices[b + 1]!));
    if (++painted % EDGES_PER_SLICE !== 0) continue;
    context.stroke();
    yield;
    context.strokeStyle = theme.mesh;
    context.lineWidth = 1;
    context.beginPath();
  }
  context.stroke();
}

/** Draws the bridges: in one colour those that an agent with this radius passes, in another those that stop it. */
export function* paintBridges(
  context: Context, camera: Camera, box: Bounds, { bridges }: BridgesAnswer, radius: number, theme: Theme,
): Generator<void> {
  for (const passes of [true, false]) {
    let first = 0;
    while (first < bridges.length) {
      const end = Math.min(bridges.length, first + BRIDGE_NUMBERS * EDGES_PER_SLICE);
      context.strokeStyle = passes ? theme.second : theme.failed;
      context.lineWidth = passes ? 1 : 2;
      context.setLineDash(passes ? [4, 3] : []);
      context.beginPath();
      for (; first < end; first += BRIDGE_NUMBERS) {
        const [x0, y0, x1, y1, largest] = bridges.subarray(first, first + BRIDGE_NUMBERS) as unknown as number[];
        if (largest! >= radius !== passes) continue;
        if (Math.max(x0!, x1!) < box[0] || Math.min(x0!, x1!) > box[2]) continue;
        if (Math.max(y0!, y1!) < box[1] || Math.min(y0!, y1!) > box[3]) continue;
        context.moveTo(camera.screenX(x0!), camera.screenY(y0!));
        context.lineTo(camera.screenX(x1!), camera.screenY(y1!));
      }
      context.stroke();
      context.setLineDash([]);
      yield;
    }
  }
}

/** Returns the hue of a component. Multiples of the golden angle give consecutive numbers very different hues. */
function componentColour(number: number): string {
  return `hsl(${Math.round((number * 137.508 + 205) % 360)} 45% 55% / 0.28)`;
}

function faceColour(mesh: MeshAnswer, face: number, mode: 'components' | 'levels', theme: Theme): string | null {
  if (mode === 'components') {
    const component = mesh.components[face]!;
    return component < 0 ? null : componentColour(component);
  }
  const level = mesh.levels[face]!;
  if (level === LEVEL.deadEnd) return theme['level-1'];
  if (level === LEVEL.corridor) return theme['level-2'];
  return level === LEVEL.junction ? theme['level-3'] : null;
}

export function* paintFaces(
  context: Context, camera: Camera, box: Bounds, mesh: MeshAnswer, mode: 'components' | 'levels', theme: Theme,
): Generator<void> {
  const { vertices, triangles } = mesh;
  let painted = 0;
  for (let face = 0; 3 * face < triangles.length; ++face) {
    const colour = faceColour(mesh, face, mode, theme);
    if (colour === null || !isNear(vertices, triangles, 3 * face, 3, box)) continue;
    context.beginPath();
    for (let k = 0; k < 3; ++k) {
      const at = 2 * triangles[3 * face + k]!;
      context.lineTo(camera.screenX(vertices[at]!), camera.screenY(vertices[at + 1]!));
    }
    context.closePath();
    context.fillStyle = colour;
    context.fill();
    if (++painted % FACES_PER_SLICE === 0) yield;
  }
}
