// Draws what changes with every frame: routes, gaps, ends, units, the selection.
import { type FilmFrame, type MeshAnswer, type Route, WINDOW_NUMBERS, type XY } from '../engine/protocol';
import type { Session } from '../model/session';
import type { Bounds, Shape } from '../model/shape';
import type { Camera } from './camera';
import { outline, tracePoints } from './painters';
import type { Theme } from './theme';

type Context = CanvasRenderingContext2D;

const LEAST_END_PIXELS = 7;
/** One path with more triangles takes more time than several paths. */
const WINDOWS_PER_FILL = 300;

export function endPixels(radius: number, camera: Camera): number {
  return Math.max(LEAST_END_PIXELS, radius * camera.scale);
}

function strokeLine(context: Context, camera: Camera, line: Float64Array): void {
  context.beginPath();
  tracePoints(context, camera, line, 0, line.length / 2, false);
  context.stroke();
}

interface LineStyle {
  readonly colour: string;
  readonly width: number;
  readonly dash: number[];
}

function drawLine(context: Context, camera: Camera, line: Float64Array, { colour, width, dash }: LineStyle): void {
  context.save();
  context.strokeStyle = colour;
  context.lineWidth = width;
  context.lineJoin = 'round';
  context.lineCap = dash.length === 0 ? 'round' : 'butt';
  context.setLineDash(dash);
  strokeLine(context, camera, line);
  context.restore();
}

export function styleOf(algorithm: Route['algorithm'], theme: Theme): LineStyle {
  if (algorithm === 'optimal') return { colour: theme.accent, width: 3, dash: [] };
  if (algorithm === 'ta') return { colour: theme.second, width: 2.5, dash: [9, 5] };
  return { colour: theme.third, width: 2.5, dash: [2, 5] };
}

function drawBand(context: Context, camera: Camera, line: Float64Array, radius: number, colour: string): void {
  if (radius * camera.scale < 1 || line.length < 4) return;
  drawLine(context, camera, line, { colour, width: 2 * radius * camera.scale, dash: [] });
}

export function drawChannel(context: Context, camera: Camera, channel: Float64Array, theme: Theme): void {
  context.beginPath();
  for (let i = 0; i < channel.length; i += 4) {
    context.moveTo(camera.screenX(channel[i]!), camera.screenY(channel[i + 1]!));
    context.lineTo(camera.screenX(channel[i + 2]!), camera.screenY(channel[i + 3]!));
  }
  context.strokeStyle = theme.start;
  context.lineWidth = 1;
  context.stroke();
}

export function drawRoutes(context: Context, camera: Camera, session: Session, theme: Theme): void {
  const { routes } = session;
  if (routes === null) return;
  const [first] = routes.routes;
  if (session.wishes.widest && routes.gap?.line) {
    drawBand(context, camera, routes.gap.line, routes.gap.radius, theme['accent-soft']);
    drawLine(context, camera, routes.gap.line, { colour: theme.gap, width: 2, dash: [] });
  } else if (first !== undefined) {
    drawBand(context, camera, first.line, routes.radius, theme['accent-soft']);
  }
  for (const { channel } of routes.routes) if (channel !== null) drawChannel(context, camera, channel, theme);
  // The dashes of the other two lie on the line of `optimal`, so that all three show where they are the same.
  for (const route of routes.routes) {
    const style = session.wishes.compares ? styleOf(route.algorithm, theme) : styleOf('optimal', theme);
    drawLine(context, camera, route.line, style);
  }
}

function drawDot(context: Context, at: XY, radius: number, colour: string, ring: string): void {
  context.beginPath();
  context.arc(at.x, at.y, radius, 0, 7);
  context.fillStyle = colour;
  context.fill();
  context.lineWidth = 2;
  context.strokeStyle = ring;
  context.stroke();
}

/** The gap that is too narrow, or the one that limits the largest disc, and the items at its two ends. */
export function drawGap(context: Context, camera: Camera, session: Session, theme: Theme): void {
  const { routes, document } = session;
  if (routes === null) return;
  for (const id of routes.blockers) outlineItem(context, camera, document.items.get(id), theme.failed);
  const { gap } = routes;
  const isMissing = routes.routes[0]?.status !== 'found';
  if (gap === null || !gap.isConnected || !gap.isLimited || !(isMissing || session.wishes.widest)) return;
  const colour = isMissing ? theme.failed : theme.gap;
  for (const id of [...gap.fromItems, ...gap.toItems]) outlineItem(context, camera, document.items.get(id), colour);
  const [a, b] = [camera.toScreen(gap.from), camera.toScreen(gap.to)];
  drawLine(context, camera, Float64Array.of(gap.from.x, gap.from.y, gap.to.x, gap.to.y), { colour, width: 3, dash: [] });
  drawDot(context, a, 4, colour, theme.page);
  drawDot(context, b, 4, colour, theme.page);
  const label = (2 * gap.radius).toPrecision(4);
  context.font = '600 13px system-ui, sans-serif';
  context.lineWidth = 4;
  context.strokeStyle = theme.ground;
  context.fillStyle = colour;
  const [x, y] = [Math.max(a.x, b.x) + 10, (a.y + b.y) / 2 + 4];
  context.strokeText(label, x, y);
  context.fillText(label, x, y);
}

function outlineItem(context: Context, camera: Camera, shape: Shape | undefined, colour: string): void {
  if (shape !== undefined) outline(context, camera, shape, colour, 2);
}

/** An end: a ring of the size of the agent around a dot. The goal's dot is hollow. */
function drawEnd(context: Context, at: XY, pixels: number, colour: string, isGoal: boolean, theme: Theme): void {
  if (pixels > LEAST_END_PIXELS) {
    context.beginPath();
    context.arc(at.x, at.y, pixels, 0, 7);
    context.globalAlpha = 0.16;
    context.fillStyle = colour;
    context.fill();
    context.globalAlpha = 1;
    context.lineWidth = 1.5;
    context.strokeStyle = colour;
    context.stroke();
  }
  drawDot(context, at, LEAST_END_PIXELS, isGoal ? theme.ground : colour, isGoal ? colour : theme.ground);
  if (isGoal) drawDot(context, at, 2.5, colour, colour);
}

export function drawEnds(context: Context, camera: Camera, session: Session, theme: Theme): void {
  const { start, goal, radius } = session.ends;
  const pixels = endPixels(radius, camera);
  const status = session.routes?.routes[0]?.status;
  const startColour = status === 'start-blocked' ? theme.failed : theme.start;
  const goalColour = status === 'goal-blocked' ? theme.failed : theme.accent;
  drawEnd(context, camera.toScreen(start), pixels, startColour, false, theme);
  drawEnd(context, camera.toScreen(goal), pixels, goalColour, true, theme);
}

export function drawTouched(context: Context, camera: Camera, boxes: readonly Bounds[], alpha: number, theme: Theme): void {
  context.save();
  context.globalAlpha = alpha;
  context.strokeStyle = theme.touched;
  context.lineWidth = 1.5;
  context.setLineDash([4, 3]);
  for (const [x0, y0, x1, y1] of boxes) {
    const [a, b] = [camera.toScreen({ x: x0, y: y0 }), camera.toScreen({ x: x1, y: y1 })];
    context.strokeRect(Math.min(a.x, b.x) - 2, Math.min(a.y, b.y) - 2, Math.abs(a.x - b.x) + 4, Math.abs(a.y - b.y) + 4);
  }
  context.restore();
}

interface Circle {
  readonly x: number;
  readonly y: number;
  readonly radius: number;
}

/** The circle through three points, in plain doubles. */
function circumcircle(ax: number, ay: number, bx: number, by: number, cx: number, cy: number): Circle {
  const [ux, uy, vx, vy] = [bx - ax, by - ay, cx - ax, cy - ay];
  const d = 2 * (ux * vy - uy * vx);
  const [u, v] = [ux * ux + uy * uy, vx * vx + vy * vy];
  const [x, y] = [(vy * u - uy * v) / d, (ux * v - vx * u) / d];
  return { x: ax + x, y: ay + y, radius: Math.hypot(x, y) };
}

/** The triangle of a mesh that contains a position, or -1. */
export function faceAt({ vertices, triangles }: MeshAnswer, { x, y }: XY): number {
  for (let i = 0; i < triangles.length; i += 3) {
    let isInside = true;
    for (let k = 0; k < 3 && isInside; ++k) {
      const [a, b] = [2 * triangles[i + k]!, 2 * triangles[i + ((k + 1) % 3)]!];
      const [ax, ay] = [vertices[a]!, vertices[a + 1]!];
      isInside = (vertices[b]! - ax) * (y - ay) - (vertices[b + 1]! - ay) * (x - ax) >= 0;
    }
    if (isInside) return i / 3;
  }
  return -1;
}

export function drawFace(context: Context, camera: Camera, mesh: MeshAnswer, face: number, theme: Theme): void {
  const corners: number[] = [];
  for (let k = 0; k < 3; ++k) {
    const at = 2 * mesh.triangles[3 * face + k]!;
    corners.push(mesh.vertices[at]!, mesh.vertices[at + 1]!);
  }
  const [ax, ay, bx, by, cx, cy] = corners as [number, number, number, number, number, number];
  const circle = circumcircle(ax, ay, bx, by, cx, cy);
  context.beginPath();
  tracePoints(context, camera, corners, 0, 3, true);
  context.fillStyle = theme['accent-soft'];
  context.fill();
  context.strokeStyle = theme.accent;
  context.lineWidth = 1.5;
  context.stroke();
  const pixels = circle.radius * camera.scale;
  if (!(pixels < 1e5)) return;
  context.beginPath();
  context.arc(camera.screenX(circle.x), camera.screenY(circle.y), pixels, 0, 7);
  context.stroke();
}

/** What the page shows of a film: one moment of it. */
export interface Scene {
  readonly frame: FilmFrame;
  readonly windows: Float64Array;
  /** How many of the windows the search has followed. */
  readonly count: number;
}

/** The triangle between the root of a window and its interval. */
function traceWindow(context: Context, camera: Camera, windows: Float64Array, at: number): void {
  context.moveTo(camera.screenX(windows[at]!), camera.screenY(windows[at + 1]!));
  context.lineTo(camera.screenX(windows[at + 8]!), camera.screenY(windows[at + 9]!));
  context.lineTo(camera.screenX(windows[at + 6]!), camera.screenY(windows[at + 7]!));
  context.closePath();
}

function traceSegment(context: Context, camera: Camera, numbers: Float64Array, at: number): void {
  context.moveTo(camera.screenX(numbers[at]!), camera.screenY(numbers[at + 1]!));
  context.lineTo(camera.screenX(numbers[at + 2]!), camera.screenY(numbers[at + 3]!));
}

/** The ground that the windows of a search have seen, below everything else. */
export function drawSeen(context: Context, camera: Camera, { windows, count }: Scene, theme: Theme): void {
  const end = WINDOW_NUMBERS * count;
  context.fillStyle = theme.seen;
  for (let first = 0; first < end; first += WINDOW_NUMBERS * WINDOWS_PER_FILL) {
    context.beginPath();
    const last = Math.min(end, first + WINDOW_NUMBERS * WINDOWS_PER_FILL);
    for (let at = first; at < last; at += WINDOW_NUMBERS) traceWindow(context, camera, windows, at);
    context.fill();
  }
  context.beginPath();
  for (let at = 0; at < end; at += WINDOW_NUMBERS) traceSegment(context, camera, windows, at + 6);
  context.strokeStyle = theme['seen-edge'];
  context.lineWidth = 1;
  context.stroke();
}

/** The window that the search follows now: its triangle, its edge, its interval and its root. */
function drawWindow(context: Context, camera: Camera, windows: Float64Array, at: number, theme: Theme): void {
  context.beginPath();
  traceWindow(context, camera, windows, at);
  context.fillStyle = theme['accent-soft'];
  context.fill();
  for (const [first, width] of [[2, 1.5], [6, 4]] as const) {
    context.beginPath();
    traceSegment(context, camera, windows, at + first);
    context.strokeStyle = theme.second;
    context.lineWidth = width;
    context.stroke();
  }
  drawDot(context, camera.toScreen({ x: windows[at]!, y: windows[at + 1]! }), 4, theme.second, theme.page);
}

export function drawFilm(context: Context, camera: Camera, { frame, windows, count }: Scene, theme: Theme): void {
  if (count > 0 && !frame.isDone) drawWindow(context, camera, windows, WINDOW_NUMBERS * (count - 1), theme);
  drawChannel(context, camera, frame.channel, theme);
  const style = styleOf('optimal', theme);
  drawLine(context, camera, frame.line, frame.isDone ? style : { ...style, dash: [6, 6] });
}

export interface Units {
  readonly radii: Float32Array;
  /** x, y and the state of each. */
  states: Float32Array;
}

const STUCK = 2;
/** The largest radius for which the page copies a picture of a disc, because this is faster than to draw a circle. */
const LARGEST_SPRITE = 48;

/** Pictures of discs, by colour and radius in pixels. */
class Sprites {
  private readonly pictures = new Map<string, OffscreenCanvas>();

  get(radius: number, colour: string, ratio: number): OffscreenCanvas {
    const key = `${radius} ${colour} ${ratio}`;
    const known = this.pictures.get(key);
    if (known !== undefined) return known;
    if (this.pictures.size > 64) this.pictures.clear();
    const size = 2 * Math.ceil(radius * ratio) + 2;
    const picture = new OffscreenCanvas(size, size);
    const context = picture.getContext('2d')!;
    context.beginPath();
    context.arc(size / 2, size / 2, radius * ratio, 0, 7);
    context.fillStyle = colour;
    context.fill();
    this.pictures.set(key, picture);
    return picture;
  }
}

const sprites = new Sprites();

export function drawUnits(context: Context, camera: Camera, { radii, states }: Units, theme: Theme): void {
  if (states.length === 0) return;
  const ratio = context.getTransform().a;
  const { width, height, scale } = camera;
  for (let i = 0; i < radii.length; ++i) {
    const radius = Math.max(1, radii[i]! * scale);
    const [x, y] = [camera.screenX(states[3 * i]!), camera.screenY(states[3 * i + 1]!)];
    if (x + radius < 0 || y + radius < 0 || x - radius > width || y - radius > height) continue;
    const colour = states[3 * i + 2] === STUCK ? theme.failed : theme.unit;
    if (radius > LARGEST_SPRITE) {
      context.beginPath();
      context.arc(x, y, radius, 0, 7);
      context.fillStyle = colour;
      context.fill();
      continue;
    }
    const picture = sprites.get(radius, colour, ratio);
    const size = picture.width / ratio;
    context.drawImage(picture, x - size / 2, y - size / 2, size, size);
  }
}

/** The outlines of selected items, and handles at the corners of a single one. */
export function drawSelection(context: Context, camera: Camera, session: Session, ids: ReadonlySet<number>, theme: Theme): void {
  for (const id of ids) outlineItem(context, camera, session.document.items.get(id), theme.accent);
  if (ids.size !== 1) return;
  const [id] = ids;
  const shape = session.document.items.get(id!);
  if (shape === undefined || shape.points.length > 400) return;
  for (let i = 0; i + 1 < shape.points.length; i += 2) {
    const [x, y] = [camera.screenX(shape.points[i]!), camera.screenY(shape.points[i + 1]!)];
    context.fillStyle = theme.page;
    context.strokeStyle = theme.accent;
    context.lineWidth = 1.5;
    context.fillRect(x - 3.5, y - 3.5, 7, 7);
    context.strokeRect(x - 3.5, y - 3.5, 7, 7);
  }
}
