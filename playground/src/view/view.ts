// The canvas: it draws a frame when something has changed.
import type { BridgesAnswer, MeshAnswer, XY } from '../engine/protocol';
import type { Session } from '../model/session';
import type { Bounds, Shape } from '../model/shape';
import { Camera, type Insets } from './camera';
import { Layer } from './layer';
import * as overlay from './overlay';
import { paintBridges, paintEdges, paintFaces, paintItems, paintShape } from './painters';
import { readTheme, type Theme } from './theme';

/** How long one frame may draw layers, in milliseconds. */
const LAYER_BUDGET = 6;
const TOUCHED_MILLISECONDS = 900;

export interface LookInside {
  mesh: boolean;
  circles: boolean;
  faces: 'none' | 'components' | 'levels';
  touched: boolean;
  bridges: boolean;
}

/** What a tool draws: in pixels, above everything else. */
export type Preview = (context: CanvasRenderingContext2D, camera: Camera, theme: Theme) => void;

export class View {
  readonly canvas: HTMLCanvasElement;
  readonly camera = new Camera();
  readonly look: LookInside = { mesh: false, circles: false, faces: 'none', touched: false, bridges: false };
  readonly selection = new Set<number>();
  theme: Theme = readTheme();
  mesh: MeshAnswer | null = null;
  bridges: BridgesAnswer | null = null;
  film: overlay.Scene | null = null;
  units: overlay.Units | null = null;
  pointer: XY | null = null;
  preview: Preview | null = null;
  /** The position of the keyboard's cursor, if it is in use. */
  cursor: XY | null = null;
  /** Durations of the last frames' drawing in milliseconds, for measurements. */
  readonly frameTimes: number[] = [];
  private readonly context: CanvasRenderingContext2D;
  private readonly session: Session;
  /** The shapes that people drag, where the pointer has them. */
  private readonly lifted = new Map<number, Shape>();
  private readonly items: Layer;
  private readonly edges: Layer;
  private readonly faces: Layer;
  private readonly bridgeLines: Layer;
  /** The radius of the agent for which `bridgeLines` is drawn. */
  private bridgeRadius = 0;
  private isWaiting = false;
  private touchedAt = -Infinity;
  private ratio = 1;

  constructor(canvas: HTMLCanvasElement, session: Session) {
    this.canvas = canvas;
    this.session = session;
    this.context = canvas.getContext('2d', { alpha: false })!;
    this.items = new Layer((context, camera, box) =>
      paintItems(context, camera, box, session.document, this.theme, this.lifted),
    );
    this.edges = new Layer((context, camera, box) => paintEdges(context, camera, box, this.mesh!, this.theme));
    this.faces = new Layer((context, camera, box) =>
      paintFaces(context, camera, box, this.mesh!, this.look.faces === 'components' ? 'components' : 'levels', this.theme),
    );
    this.bridgeLines = new Layer((context, camera, box) =>
      paintBridges(context, camera, box, this.bridges!, this.bridgeRadius, this.theme),
    );
    new ResizeObserver(() => this.resize()).observe(canvas);
    this.resize();
  }

  private resize(): void {
    const { clientWidth, clientHeight } = this.canvas;
    this.ratio = Math.min(window.devicePixelRatio || 1, 2);
    this.camera.width = Math.max(1, clientWidth);
    this.camera.height = Math.max(1, clientHeight);
    this.canvas.width = Math.round(this.camera.width * this.ratio);
    this.canvas.height = Math.round(this.camera.height * this.ratio);
    this.drawNow();
  }

  setTheme(): void {
    this.theme = readTheme();
    this.redrawAll();
  }

  setMesh(mesh: MeshAnswer | null): void {
    this.mesh = mesh;
    this.edges.invalidate();
    this.faces.invalidate();
    this.refresh();
  }

  setBridges(bridges: BridgesAnswer | null): void {
    this.bridges = bridges;
    this.bridgeLines.invalidate();
    this.refresh();
  }

  private showsBox(box: Bounds, insets: Insets): boolean {
    const { x, y, scale } = this.camera;
    const fitted = new Camera();
    fitted.copyFrom(this.camera);
    fitted.fit(box, insets);
    return fitted.x === x && fitted.y === y && fitted.scale === scale;
  }

  /** Shows what is worth seeing first. If the screen shows that already and `alternates`, shows the whole domain. */
  fit(insets: Insets, alternates: boolean): void {
    this.camera.yStep = this.session.document.yDown ? 1 : -1;
    const { view, domain } = this.session.document;
    const box = alternates && this.showsBox(view, insets) ? domain : view;
    this.camera.fit(box, insets);
    this.refresh();
  }

  /** Draws all layers again. */
  redrawAll(): void {
    for (const layer of [this.items, this.edges, this.faces, this.bridgeLines]) layer.invalidate();
    this.refresh();
  }

  /** Draws the items in a box again. */
  repaint(box: Bounds): void {
    this.items.repaint(box);
    this.refresh();
  }

  /** Takes items out of the layer while people drag them. They are drawn at once; the engine may need longer. */
  lift(shapes: readonly (readonly [id: number, shape: Shape])[]): void {
    for (const [id, shape] of shapes) {
      const isNew = !this.lifted.has(id);
      this.lifted.set(id, shape);
      const box = this.session.document.boundsOf(id);
      if (isNew && box !== undefined) this.items.repaint(box);
    }
    this.refresh();
  }
  drop(): void {
    const ids = [...this.lifted.keys()];
    this.lifted.clear();
    for (const id of ids) {
      const box = this.session.document.boundsOf(id);
      if (box !== undefined) this.items.repaint(box);
    }
    this.refresh();
  }
  isLifted(id: number): boolean {
    return this.lifted.has(id);
  }

  flashTouched(): void {
    this.touchedAt = performance.now();
    this.refresh();
  }

  /** Draws a frame soon. */
  refresh(): void {
    if (this.isWaiting) return;
    this.isWaiting = true;
    requestAnimationFrame(() => {
      this.isWaiting = false;
      this.drawNow();
    });
  }

  private drawNow(): void {
    const begin = performance.now();
    const { context, camera, ratio, theme } = this;
    context.setTransform(ratio, 0, 0, ratio, 0, 0);
    context.fillStyle = theme.page;
    context.fillRect(0, 0, camera.width, camera.height);
    this.drawGround();
    if (this.film !== null) overlay.drawSeen(context, camera, this.film, theme);
    const isComplete = this.drawLayers(begin + LAYER_BUDGET);
    this.drawOverlay();
    this.frameTimes.push(performance.now() - begin);
    if (this.frameTimes.length > 600) this.frameTimes.shift();
    if (!isComplete || performance.now() - this.touchedAt < TOUCHED_MILLISECONDS) this.refresh();
  }

  private drawGround(): void {
    const { context, camera, theme } = this;
    const [x0, y0, x1, y1] = this.session.document.domain;
    const [a, b] = [camera.toScreen({ x: x0, y: y0 }), camera.toScreen({ x: x1, y: y1 })];
    const rectangle = [Math.min(a.x, b.x), Math.min(a.y, b.y), Math.abs(a.x - b.x), Math.abs(a.y - b.y)] as const;
    context.fillStyle = theme.ground;
    context.fillRect(...rectangle);
    context.strokeStyle = theme['solid-outline'];
    context.lineWidth = 1;
    context.strokeRect(...rectangle);
  }

  private drawLayers(deadline: number): boolean {
    const layers = [this.items];
    if (this.mesh !== null && this.look.faces !== 'none') layers.unshift(this.faces);
    if (this.mesh !== null && this.look.mesh) layers.push(this.edges);
    if (this.bridges !== null && this.look.bridges) layers.push(this.updatedBridges());
    let isComplete = true;
    for (const layer of layers) {
      if (!layer.update(this.camera, this.ratio, deadline)) isComplete = false;
      layer.draw(this.context, this.camera);
    }
    return isComplete;
  }

  private updatedBridges(): Layer {
    const { radius } = this.session.ends;
    if (radius !== this.bridgeRadius) this.bridgeLines.invalidate();
    this.bridgeRadius = radius;
    return this.bridgeLines;
  }

  private drawOverlay(): void {
    const { context, camera, session, theme, mesh } = this;
    for (const shape of this.lifted.values()) paintShape(context, camera, shape, theme);
    if (this.look.circles && mesh !== null && this.pointer !== null) {
      const face = overlay.faceAt(mesh, this.pointer);
      if (face >= 0) overlay.drawFace(context, camera, mesh, face, theme);
    }
    if (this.film !== null) overlay.drawFilm(context, camera, this.film, theme);
    else overlay.drawRoutes(context, camera, session, theme);
    if (this.units !== null) overlay.drawUnits(context, camera, this.units, theme);
    overlay.drawGap(context, camera, session, theme);
    this.drawTouched();
    overlay.drawSelection(context, camera, session, this.selection, theme);
    overlay.drawEnds(context, camera, session, theme);
    this.preview?.(context, camera, theme);
    this.drawCursor();
  }

  private drawTouched(): void {
    const age = performance.now() - this.touchedAt;
    if (!this.look.touched || age >= TOUCHED_MILLISECONDS) return;
    const alpha = 1 - age / TOUCHED_MILLISECONDS;
    overlay.drawTouched(this.context, this.camera, this.session.touched, alpha, this.theme);
  }

  private drawCursor(): void {
    if (this.cursor === null) return;
    const { context, theme } = this;
    const { x, y } = this.camera.toScreen(this.cursor);
    context.strokeStyle = theme.text;
    context.lineWidth = 1.5;
    context.beginPath();
    for (const [dx, dy] of [[1, 0], [-1, 0], [0, 1], [0, -1]] as const) {
      context.moveTo(x + 4 * dx, y + 4 * dy);
      context.lineTo(x + 12 * dx, y + 12 * dy);
    }
    context.stroke();
  }
}
