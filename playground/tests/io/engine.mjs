// Carries out operations with the npm package.
import { init, World } from '../../../bindings/wasm/dist/index.js';
import { items } from './support.mjs';

await init();

export function makeWorld([minX, minY, maxX, maxY], options = {}) {
  return new World({ min: { x: minX, y: minY }, max: { x: maxX, y: maxY } }, options);
}

/** Makes the changes among the operations. */
export function carryOut(world, operations) {
  world.keepHistory(operations.filter(({ kind }) => kind === 'mark').length);
  for (const operation of operations) {
    if (operation.kind === 'insert') world.insert(items.toShape(operation.item), operation.id);
    else if (operation.kind === 'replace') world.replace(operation.id, items.toShape(operation.item));
    else if (operation.kind === 'remove') world.remove(operation.id);
    else if (operation.kind === 'mark') world.mark();
    else if (operation.kind === 'rewind') world.rewind(operation.tick);
  }
}
