// Finds the items near a box, for drawing and pointing.
import { type Bounds, overlap } from './shape';

/** An item that would lie in more cells is in one list for all. */
const MOST_CELLS = 256;

export class Grid {
  private readonly domain: Bounds;
  private readonly columns: number;
  private readonly cells: (Set<number> | undefined)[];
  private readonly large = new Set<number>();
  private readonly boxes = new Map<number, Bounds>();

  constructor(domain: Bounds, expected: number) {
    this.domain = domain;
    this.columns = Math.max(8, Math.min(256, Math.ceil(Math.sqrt(expected))));
    this.cells = new Array<Set<number> | undefined>(this.columns * this.columns);
  }

  private cell(value: number, axis: 0 | 1): number {
    const low = this.domain[axis];
    const size = this.domain[axis + 2]! - low;
    return Math.min(this.columns - 1, Math.max(0, Math.floor(((value - low) / size) * this.columns)));
  }

  /** Calls `use` with each cell of a box. Returns false if there are too many. */
  private forCells(box: Bounds, most: number, use: (index: number) => void): boolean {
    const [x0, y0, x1, y1] = [this.cell(box[0], 0), this.cell(box[1], 1), this.cell(box[2], 0), this.cell(box[3], 1)];
    if ((x1 - x0 + 1) * (y1 - y0 + 1) > most) return false;
    for (let y = y0; y <= y1; ++y) for (let x = x0; x <= x1; ++x) use(y * this.columns + x);
    return true;
  }

  set(id: number, box: Bounds): void {
    this.remove(id);
    this.boxes.set(id, box);
    const fits = this.forCells(box, MOST_CELLS, (index) => (this.cells[index] ??= new Set()).add(id));
    if (!fits) this.large.add(id);
  }

  remove(id: number): void {
    const box = this.boxes.get(id);
    if (box === undefined) return;
    this.boxes.delete(id);
    if (!this.large.delete(id)) this.forCells(box, MOST_CELLS, (index) => this.cells[index]?.delete(id));
  }

  box(id: number): Bounds | undefined {
    return this.boxes.get(id);
  }

  /** The items whose boxes overlap a box, ascending. */
  find(box: Bounds): number[] {
    const found = new Set<number>();
    const consider = (id: number): void => {
      if (overlap(this.boxes.get(id)!, box)) found.add(id);
    };
    this.large.forEach(consider);
    this.forCells(box, Infinity, (index) => this.cells[index]?.forEach(consider));
    return [...found].sort((a, b) => a - b);
  }
}
