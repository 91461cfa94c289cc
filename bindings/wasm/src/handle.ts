import { freeBuffers } from './buffers.js';
import { refuse, shown, WaywrightError } from './errors.js';
import { check, generation, lib, onTrap, onUnload, requireIdle, scratch, u32 } from './runtime.js';

type Destroy = (address: number) => void;

/**
 * An object of the module that a wrapper holds. It is not the wrapper itself: a wrapper may be used through a Proxy, and
 * then a call of `dispose` must still be seen when the garbage collector finds the wrapper.
 */
interface Held {
  /** 0 if the object was disposed. */
  address: number;
  readonly destroy: Destroy | null;
  /** The module that made the object. */
  readonly generation: number;
}

/** Frees the objects of the module whose wrappers the garbage collector has found. */
const registry = new FinalizationRegistry<Held>(({ address, destroy, generation: made }) => {
  if (address !== 0 && destroy !== null && made === generation) destroy(address);
});

declare global {
  // For programs whose libraries do not declare it.
  interface SymbolConstructor {
    readonly dispose: unique symbol;
  }
}

const disposeKey: typeof Symbol.dispose = (Symbol.dispose ?? Symbol.for('Symbol.dispose')) as typeof Symbol.dispose;

/** @internal The address of an object of the module, for the constructor of its wrapper. */
export class Address {
  constructor(
    readonly value: number,
    /** The object that it belongs to, or null. */
    readonly owner: Handle | null = null,
  ) {}
}

/**
 * An object in the memory of the module. `dispose()` frees this memory at once. If you do not call `dispose()`, the garbage
 * collector frees the memory at some later time. With TypeScript 5.2 or a later version you can also write
 * `using world = new World(...)`.
 */
export abstract class Handle {
  private readonly held_: Held;
  private readonly owner_: Handle | null;
  private readonly ownerChange_: number;
  private change_ = 0;
  private users_ = 0;

  /**
   * @internal Takes over the object at an address. If `destroy` is another handle, the object belongs to this owner, and the
   * wrapper is valid until the owner changes.
   */
  protected constructor(address: number, destroy: Destroy | Handle) {
    const isOwned = destroy instanceof Handle;
    this.owner_ = isOwned ? destroy : null;
    this.ownerChange_ = isOwned ? destroy.change_ : 0;
    this.held_ = { address, destroy: isOwned ? null : destroy, generation };
    if (!isOwned) registry.register(this, this.held_, this);
  }

  /** Whether the object can no longer be used. */
  get isDisposed(): boolean {
    const { address, generation: made } = this.held_;
    return address === 0 || made !== generation || (this.owner_ !== null && this.owner_.change_ !== this.ownerChange_);
  }

  /** @internal */
  get address(): number {
    if (this.isDisposed) {
      const isOutdated = this.held_.address !== 0 && this.held_.generation === generation;
      const reason = isOutdated ? 'belonged to an object that has changed since' : 'was disposed';
      throw new WaywrightError('disposed', `this ${this.constructor.name} ${reason}`);
    }
    return this.held_.address;
  }

  /** @internal The address for a call that changes the object. */
  get ownAddress(): number {
    const { address } = this;
    if (this.owner_ === null) return address;
    return refuse(`this ${this.constructor.name} belongs to a ${this.owner_.constructor.name}: only its owner changes it`);
  }

  /** @internal Invalidates the wrappers of the objects that belong to this one. */
  protected changed(): void {
    this.change_ += 1;
  }

  /** @internal Refuses `dispose` during a call that uses the object. */
  protected using<T>(call: () => T): T {
    this.users_ += 1;
    try {
      return call();
    } finally {
      this.users_ -= 1;
    }
  }

  /** Frees the memory of the object. Later uses of the object throw. A second call does nothing. */
  dispose(): void {
    const { address, destroy, generation: made } = this.held_;
    if (address === 0) return;
    requireIdle();
    if (this.users_ > 0) refuse(`a call that uses this ${this.constructor.name} has not ended yet`);
    this.held_.address = 0;
    this.change_ += 1;
    if (destroy === null || made !== generation) return;
    registry.unregister(this);
    destroy(address);
  }

  [disposeKey](): void {
    this.dispose();
  }
}

/** @internal Returns the address of an object that a caller has given. Throws if it has another class. */
export function addressOf<T extends Handle>(type: abstract new (...given: never[]) => T, given: T): number {
  return toHandle(type, given).address;
}

/** @internal Like {@link addressOf}, for a call that changes the object. */
export function ownAddressOf<T extends Handle>(type: abstract new (...given: never[]) => T, given: T): number {
  return toHandle(type, given).ownAddress;
}

function toHandle<T extends Handle>(type: abstract new (...given: never[]) => T, given: T): T {
  return given instanceof type ? given : refuse(`${shown(given)} is given where a ${type.name} is necessary`);
}

/** Makes a call that writes the address of an object, and returns this address. */
export function make(create: (address: number) => number): number {
  check(create(scratch.pointer));
  return u32[scratch.pointer >>> 2]!;
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
const forgetCommon = (): void => void (common = null);
onUnload(forgetCommon);
onTrap(forgetCommon);

/** @internal Returns the address of a context, or of the shared context if `context` is undefined. */
export function contextAddress(context: QueryContext | undefined): number {
  return addressOf(QueryContext, context ?? (common ??= new QueryContext()));
}

/** Frees the memory that the package keeps for later calls. */
export function trim(): void {
  freeBuffers();
  common?.dispose();
  common = null;
}
