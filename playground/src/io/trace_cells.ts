import type { CornerCount, Item, XY } from './types';

// The sides of a cell, in the order in which a ring follows them. Direction (s + 3) mod 4 leads out of the cell across
// side s.
const TOP = 0;
const RIGHT = 1;
const BOTTOM = 2;
const LEFT = 3;

// The groups of cells count from FIRST_GROUP. Smaller numbers mean that the cell is in no group.
const FREE = 0;
const UNMARKED = 1;
const FIRST_GROUP = 2;

/**
 * The blocked cells of a map, and the rings around their groups. A group is a set of blocked cells that are connected
 * through their sides.
 *
 * At a lattice point where two blocked cells touch diagonally and the other two cells are free, a ring can turn in two
 * directions. If the blocked cells are in different groups, each ring turns around its own cell. If they are in one
 * group, the ring passes from one blocked cell to the other. So every ring is simple, and two rings of a group meet only
 * in points. The library's own reader of maps works in the same way, and makes the same items.
 */
class Tracer {
  private readonly stride: number;
  private readonly group: Uint32Array;
  private readonly topTraced: Uint8Array;
  private readonly count: CornerCount;
  /** Where the ring is: a cell and one of its sides. */
  private cell = 0;
  private side = TOP;

  constructor(rows: readonly string[], count: CornerCount) {
    this.count = count;
    this.stride = rows[0]!.length + 2; // a free cell at each end
    this.group = new Uint32Array(this.stride * (rows.length + 2));
    this.topTraced = new Uint8Array(this.group.length);
    rows.forEach((row, y) => {
      const first = (y + 1) * this.stride + 1;
      for (let x = 0; x < row.length; ++x) if (!'.GS'.includes(row[x]!)) this.group[first + x] = UNMARKED;
    });
  }

  /** Returns the groups as polygons, in the order of their first cells. Each has its outer ring first. */
  run(): Item[] {
    const groups: XY[][][] = [];
    for (let cell = this.stride; cell < this.group.length - this.stride; ++cell) {
      if (this.group[cell] === FREE) continue;
      if (this.group[cell] === UNMARKED) {
        this.fill(cell, FIRST_GROUP + groups.length);
        groups.push([]);
      }
      // Every ring has a top side. The first top side in a group's first cell belongs to the outer ring.
      if (this.group[cell - this.stride] === FREE && this.topTraced[cell] === 0) {
        groups[this.group[cell]! - FIRST_GROUP]!.push(this.trace(cell));
      }
    }
    return groups.map((rings) => ({ kind: 'polygon', rings }));
  }

  private neighbour(cell: number, direction: number): number {
    const step = [1, this.stride, -1, -this.stride][direction % 4]!;
    return cell + step;
  }

  private fill(first: number, group: number): void {
    this.group[first] = group;
    const stack = [first];
    for (let cell = stack.pop(); cell !== undefined; cell = stack.pop()) {
      for (let direction = 0; direction < 4; ++direction) {
        const other = this.neighbour(cell, direction);
        if (this.group[other] !== UNMARKED) continue;
        this.group[other] = group;
        stack.push(other);
      }
    }
  }

  /** Moves to the next side of the ring. */
  private advance(): void {
    const outwards = (this.side + 3) % 4;
    const ahead = this.neighbour(this.cell, this.side);
    const diagonal = this.neighbour(ahead, outwards);
    const isAheadBlocked = this.group[ahead] !== FREE;
    const isOutward = isAheadBlocked ? this.group[diagonal] !== FREE : this.group[diagonal] === this.group[this.cell];
    if (isOutward) {
      this.cell = diagonal;
      this.side = outwards;
    } else if (isAheadBlocked) {
      this.cell = ahead;
    } else {
      this.side = (this.side + 1) % 4;
    }
  }

  /** The lattice point at which the ring starts to follow its side. */
  private corner(): XY {
    this.count.add(() => ({ line: this.row() + 5 }));
    const x = (this.cell % this.stride) - 1 + (this.side === RIGHT || this.side === BOTTOM ? 1 : 0);
    return [x, this.row() + (this.side === BOTTOM || this.side === LEFT ? 1 : 0)];
  }

  private row(): number {
    return Math.floor(this.cell / this.stride) - 1;
  }

  /** Follows the ring that has the top side of a cell. This side starts at a corner of the ring. */
  private trace(first: number): XY[] {
    this.cell = first;
    this.side = TOP;
    const ring = [this.corner()];
    this.topTraced[first] = 1;
    for (;;) {
      const before = this.side;
      this.advance();
      if (this.cell === first && this.side === TOP) return ring;
      if (this.side !== before) ring.push(this.corner());
      if (this.side === TOP) this.topTraced[this.cell] = 1;
    }
  }
}

/** Returns one polygon for each group of blocked cells. Cell (x, y) is the square from (x, y) to (x + 1, y + 1). */
export function traceCells(rows: readonly string[], count: CornerCount): Item[] {
  return new Tracer(rows, count).run();
}
