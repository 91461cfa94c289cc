import wasmUrl from '../../../bindings/wasm/dist/waywright.wasm?url';
import { EngineClient } from './client';

/** Makes the client of a worker that loads the module from its own file. */
export function makeEngine(): EngineClient {
  return new EngineClient(
    () => new Worker(new URL('./worker.ts', import.meta.url), { type: 'module' }),
    () => Promise.resolve(new URL(wasmUrl, import.meta.url).href),
  );
}
