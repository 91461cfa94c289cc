import { copyIntegers, copyNumbers, readList } from './buffers.js';
import { Handle, make } from './handle.js';
import { lib } from './runtime.js';
import { type ItemId, readIds } from './values.js';

/**
 * A copy of the mesh of a world, in canonical order: `World.snapshot` fills it. Use one object for many snapshots, because
 * it keeps its memory. A function with a parameter `into` writes to this array if the answer fits there, and returns the
 * part with the answer; otherwise it returns a new array.
 */
export class Mesh extends Handle {
  constructor() {
    super(make((address) => lib.ww_mesh_create(address)), (address) => lib.ww_mesh_destroy(address));
  }

  /** The vertices: x and y of each, rounded to the nearest doubles. */
  vertices(into?: Float64Array): Float64Array {
    const { address } = this;
    const list = readList(16, (buffer, capacity, count) => lib.ww_mesh_vertices(address, buffer, capacity, count));
    return copyNumbers(list.address, 2 * list.count, into);
  }

  /** The triangles: the indices of three vertices for each, counter-clockwise. */
  triangles(into?: Uint32Array): Uint32Array {
    const { address } = this;
    const list = readList(12, (buffer, capacity, count) => lib.ww_mesh_triangles(address, buffer, capacity, count));
    return copyIntegers(list.address, 3 * list.count, into);
  }

  /**
   * The constrained edges, four numbers for each: the indices of its two vertices, the index of its first id in `ids()`,
   * and the number of its ids.
   */
  constrainedEdges(into?: Uint32Array): Uint32Array {
    const { address } = this;
    const list = readList(16, (buffer, capacity, count) =>
      lib.ww_mesh_constrained_edges(address, buffer, capacity, count),
    );
    return copyIntegers(list.address, 4 * list.count, into);
  }

  /** The ids of the items on the constrained edges. */
  ids(): ItemId[] {
    const { address } = this;
    return readIds(readList(8, (buffer, capacity, count) => lib.ww_mesh_ids(address, buffer, capacity, count)));
  }
}
