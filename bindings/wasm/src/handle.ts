import { WaywrightError } from './errors.js';
import { check, lib, slots, u32 } from './runtime.js';

type Destroy = (address: number) => void;

/** Frees the objects of the module whose wrappers the garbage collector has found. */
const registry = new FinalizationRegistry<{ readonly address: number; readonly destroy: Destroy }>(
  ({ address, destroy }) => destroy(address),
);

const disposeKey: typeof Symbol.dispose = (Symbol.dispose ?? Symbol.for('Symbol.dispose')) as typeof Symbol.dispose;

/**
 * An object in the memory of the module. `dispose()` frees this memory at once. If you do not call `dispose()`, the garbage
 * collector frees the memory at some later time. With TypeScript 5.2 or a later version you can also write
 * `using world = new World(...)`.
 */
export abstract class Handle {
  private address_ = 0;
  private readonly owner_: Handle | null;
  private readonly ownerChange_: number;
  private change_ = 0;

  /**
   * @internal Takes over the object at an address. If `destroy` is another handle, the object belongs to this owner, and the
   * wrapper is valid until the owner changes.
   */
  protected constructor(address: number, destroy: Destroy | Handle) {
    this.address_ = address;
    this.owner_ = destroy instanceof Handle ? destroy : null;
    this.ownerChange_ = this.owner_ === null ? 0 : this.owner_.change_;
    if (!(destroy instanceof Handle)) registry.register(this, { address, destroy }, this);
    this.destroy_ = destroy instanceof Handle ? null : destroy;
  }
  private readonly destroy_: Destroy | null;

  /** Whether the object can still be used. */
  get isDisposed(): boolean {
    return this.address_ === 0 || (this.owner_ !== null && this.owner_.change_ !== this.ownerChange_);
  }

  /** @internal */
  get address(): number {
    if (this.isDisposed) {
      const reason = this.address_ === 0 ? 'was disposed' : 'belonged to an object that has changed since';
      throw new WaywrightError('disposed', `this ${this.constructor.name} ${reason}`);
    }
    return this.address_;
  }

  /** @internal Invalidates the wrappers of the objects that belong to this one. */
  protected changed(): void {
    this.change_ += 1;
  }

  /** Frees the memory of the object. Later uses of the object throw. A second call does nothing. */
  dispose(): void {
    if (this.address_ === 0) return;
    const address = this.address_;
    this.address_ = 0;
    this.change_ += 1;
    if (this.destroy_ === null) return;
    registry.unregister(this);
    this.destroy_(address);
  }

  [disposeKey](): void {
    this.dispose();
  }
}

/** Makes a call that writes the address of an object, and returns this address. */
export function make(create: (address: number) => number): number {
  check(create(slots.pointer));
  return u32[slots.pointer >>> 2]!;
}

/**
 * The memory that queries keep between calls. A query without a context uses a context that all these queries share. Make a
 * context of your own only if you want to free its memory yourself.
 */
export class QueryContext extends Handle {
  constructor() {
    super(make((address) => lib.ww_context_create(address)), (address) => lib.ww_context_destroy(address));
  }
}

let common: QueryContext | null = null;

/** @internal Returns the address of a context, or of the shared context if `context` is undefined. */
export function contextAddress(context: QueryContext | undefined): number {
  return (context ?? (common ??= new QueryContext())).address;
}

/** Frees the memory of the shared context. The next query without a context makes a new one. */
export function trim(): void {
  common?.dispose();
  common = null;
}
