import { type Functions, guarded, ww_error, WW_BUFFER_TOO_SMALL, WW_INVALID_ARGUMENT, WW_OK } from './generated/abi.js';
import { type ErrorCode, refuse, shown, WaywrightError } from './errors.js';

/** The exports of the module: the functions of the C interface, and the functions and memory that the wrapper needs. */
interface Exports extends Functions {
  readonly memory: WebAssembly.Memory;
  readonly _initialize: () => void;
  readonly malloc: (size: number) => number;
  readonly free: (address: number) => void;
  readonly stackSave: () => number;
  readonly stackRestore: (stack: number) => void;
}

/** Returns an object in place of the functions of the module, for the time when no call is possible. Each call throws. */
function unavailable(code: ErrorCode, message: string): Functions {
  const refuseCall = (): never => {
    throw new WaywrightError(code, message);
  };
  return new Proxy({} as Functions, { get: refuseCall });
}

const notInitialised = unavailable('not-initialised', 'call and await init() before everything else');
const busy = unavailable('invalid-argument', 'a progress function must not call functions of the package');

/** Throws while a progress function runs: the call that it belongs to uses the memory for arguments. */
export function requireIdle(): void {
  if (lib === busy) lib.ww_version_number(); // throws
}

let exports: Exports | null = null;
let functions = notInitialised;
let initialStack = 0;

/** How often the module was unloaded. An object of an earlier module no longer exists. */
export let generation = 0;

/** The functions that drop addresses of the module when the module is unloaded. */
const forgetters: (() => void)[] = [];
export function onUnload(forget: () => void): void {
  forgetters.push(forget);
}

/** The function that drops objects that a call may have left unfinished when a trap stopped it. */
let forgetUnfinished = (): void => undefined;
export function onTrap(forget: () => void): void {
  forgetUnfinished = forget;
}

/** The functions of the module. */
export let lib: Functions = notInitialised;
/** The memory of the module. Each growth of the memory replaces these arrays. */
export let u8 = new Uint8Array(0);
export let i32 = new Int32Array(0);
export let u32 = new Uint32Array(0);
export let f64 = new Float64Array(0);
export let u64 = new BigUint64Array(0);

function refreshViews(): void {
  const buffer = exports === null ? new ArrayBuffer(0) : exports.memory.buffer;
  u8 = new Uint8Array(buffer);
  i32 = new Int32Array(buffer);
  u32 = new Uint32Array(buffer);
  f64 = new Float64Array(buffer);
  u64 = new BigUint64Array(buffer);
}

/** Addresses for the arguments and the answers of one call. */
export const scratch = { struct: 0, struct2: 0, a: 0, b: 0, box: 0, count: 0, count2: 0, id: 0, flag: 0, pointer: 0, hash: 0, agent: 0 };
const SCRATCH_BYTES = { struct: 512, struct2: 512, a: 16, b: 16, box: 32, count: 8, count2: 8, id: 8, flag: 8, pointer: 8, hash: 40, agent: 16 };

/** The progress function of the running call, and the error that it has thrown. */
let progress: ((done: number, total: number) => void) | null = null;
let progressError: { readonly reason: unknown } | null = null;

function reportProgress(done: number, total: number): void {
  if (progress === null || progressError !== null) return;
  lib = busy;
  try {
    progress(done >>> 0, total >>> 0);
  } catch (reason) {
    progressError = { reason };
  } finally {
    lib = functions;
  }
}

/** The question of the running call, and the error that it has thrown. */
let question: (() => void) | null = null;
let questionError: { readonly reason: unknown } | null = null;
let questionsRunning = 0;

function askQuestion(): number {
  const [asked, outerStack] = [question!, initialStack];
  question = null;
  initialStack = exports!.stackSave();
  questionsRunning += 1;
  try {
    asked();
    return WW_OK;
  } catch (reason) {
    questionError = { reason };
    return WW_INVALID_ARGUMENT;
  } finally {
    questionsRunning -= 1;
    initialStack = outerStack;
  }
}

/** Makes a call that asks a question. If the question throws an error, throws this error after the call. */
export function withQuestion(ask: () => void, call: () => number): void {
  question = ask;
  questionError = null;
  let status = WW_OK;
  try {
    status = call();
  } finally {
    question = null;
  }
  const thrown = questionError as { readonly reason: unknown } | null;
  questionError = null;
  if (thrown !== null) throw thrown.reason;
  check(status);
}

/** Makes a call that may report its progress. If the progress function throws an error, throws it after the call. */
export function withProgress<T>(report: ((done: number, total: number) => void) | undefined, call: () => T): T {
  if (report !== undefined && typeof report !== 'function') refuse(`progress is ${shown(report)}, not a function`);
  progress = report ?? null;
  progressError = null;
  try {
    return call();
  } finally {
    progress = null;
    const thrown = progressError as { readonly reason: unknown } | null;
    progressError = null;
    if (thrown !== null) throw thrown.reason;
  }
}

/** Handles a trap, which means a bug in the library, or too little stack. Resets the stack, so that later calls work. */
function trapped(reason: unknown): never {
  exports!.stackRestore(initialStack);
  forgetUnfinished();
  throw new WaywrightError(
    'internal-error',
    `the call was stopped in its middle (${String(reason)}); call unload() and init(), and make all objects anew`,
    null,
    0,
    reason,
  );
}

const ENOSYS = 52;

/** Returns the imports of the module: a clock and four functions of the wrapper. All other functions of WASI return an error. */
function importsFor(module: WebAssembly.Module): WebAssembly.Imports {
  const imports: Record<string, Record<string, unknown>> = {};
  for (const { module: space, name } of WebAssembly.Module.imports(module)) {
    (imports[space] ??= {})[name] = () => ENOSYS;
  }
  const wasi = (imports['wasi_snapshot_preview1'] ??= {});
  wasi['clock_time_get'] = (_clock: number, _precision: bigint, address: number): number => {
    u64[address >>> 3] = BigInt(Math.round(performance.now() * 1e6));
    return 0;
  };
  wasi['proc_exit'] = (code: number): never => {
    throw new Error(`the module ended with ${code}`);
  };
  const env = (imports['env'] ??= {});
  env['emscripten_notify_memory_growth'] = refreshViews;
  env['progress'] = reportProgress;
  env['question'] = askQuestion;
  return imports as WebAssembly.Imports;
}

/** Throws unless an instance has all functions of the wrapper. */
function requireExports(given: WebAssembly.Exports, called: Functions): void {
  const names = [...Object.keys(called), '_initialize', 'malloc', 'free', 'stackSave', 'stackRestore'];
  const missing = names.find((name) => typeof given[name] !== 'function');
  if (missing === undefined && given['memory'] !== undefined) return;
  throw new WaywrightError('unreadable', 'the module is not the waywright.wasm of this version of the package');
}

function toMemoryLimit(bytes: number): number {
  if (typeof bytes === 'number' && bytes > 0) return bytes;
  return refuse(`maximumMemory is ${shown(bytes)}, not a number of bytes`);
}

/** Lets all functions of the package use an instance of the module, unless they use one. */
function adopt(instance: WebAssembly.Instance, maximumMemory: number): void {
  if (exports !== null) return;
  const given = instance.exports as unknown as Exports;
  const called = guarded(given, trapped);
  requireExports(instance.exports, called);
  exports = given;
  refreshViews();
  exports._initialize();
  if (maximumMemory < 2 ** 32) exports.ww_js_set_memory_limit(maximumMemory);
  const sizes = Object.entries(SCRATCH_BYTES) as [keyof typeof scratch, number][];
  let address = exports.malloc(sizes.reduce((sum, [, size]) => sum + size, 0));
  for (const [name, size] of sizes) {
    scratch[name] = address;
    address += size;
  }
  initialStack = exports.stackSave();
  functions = called;
  lib = functions;
}

/** A compiled module: WebAssembly.Module, where the libraries of the program declare it. */
export type CompiledModule = typeof globalThis extends { WebAssembly: { Module: { prototype: infer T } } } ? T : object;
/** The bytes of a module. */
export type ModuleBytes = ArrayBuffer | ArrayBufferView;

/** The options of {@link init}. */
export interface InitOptions {
  /**
   * The module: its address, its bytes, or the compiled module. The default is the file waywright.wasm of the package. A
   * relative address counts from the file of the package.
   */
  readonly module?: string | URL | ModuleBytes | CompiledModule;
  /** The largest size of the module's memory in bytes. The default is 4 GiB, the most that WebAssembly allows. */
  readonly maximumMemory?: number;
}

async function bytesAt(url: URL): Promise<BufferSource> {
  if (url.protocol === 'file:') {
    const name = 'node:fs/promises';
    const files = (await import(/* @vite-ignore */ /* webpackIgnore: true */ name)) as typeof import('node:fs/promises');
    return files.readFile(url) as Promise<BufferSource>;
  }
  const answer = await fetch(url);
  if (!answer.ok) throw new WaywrightError('unreadable', `${url.href}: HTTP status ${answer.status}`);
  return answer.arrayBuffer();
}

/** Returns whether a value is a compiled module, also one of another window. */
function isModule(source: unknown): source is WebAssembly.Module {
  return Object.prototype.toString.call(source) === '[object WebAssembly.Module]';
}

function toBytes(source: ModuleBytes): BufferSource {
  const kind = Object.prototype.toString.call(source);
  if (ArrayBuffer.isView(source) || kind === '[object ArrayBuffer]' || kind === '[object SharedArrayBuffer]') return source as BufferSource;
  return refuse(`module is ${shown(source)}, not an address, bytes or a compiled module`);
}

async function compile(source: InitOptions['module']): Promise<WebAssembly.Module> {
  if (isModule(source)) return source;
  const given = source ?? new URL('./waywright.wasm', import.meta.url);
  if (typeof given !== 'string' && !(given instanceof URL)) return WebAssembly.compile(toBytes(given));
  return WebAssembly.compile(await bytesAt(new URL(given, import.meta.url)));
}

let loading: Promise<void> | null = null;

/**
 * Loads the WebAssembly module. Await it once before everything else. Further calls return the same promise and ignore
 * their options, unless the first one failed, or the module was unloaded.
 */
export function init(options: InitOptions = {}): Promise<void> {
  loading ??= (async () => {
    const limit = toMemoryLimit(options.maximumMemory ?? 2 ** 32);
    const module = await compile(options.module);
    adopt(await WebAssembly.instantiate(module, importsFor(module)), limit);
  })().catch((reason: unknown) => {
    loading = null;
    throw reason;
  });
  return loading;
}

/** Does the same as {@link init} at once, without a promise. Browsers refuse this in the main thread. */
export function initSync(module: CompiledModule | ModuleBytes, maximumMemory = 2 ** 32): void {
  if (exports !== null) return;
  const limit = toMemoryLimit(maximumMemory);
  const compiled = isModule(module) ? module : new WebAssembly.Module(toBytes(module));
  adopt(new WebAssembly.Instance(compiled, importsFor(compiled)), limit);
  loading = Promise.resolve();
}

/**
 * Frees the whole memory of the module, with all objects in it: they count as disposed. Afterwards {@link init} or
 * {@link initSync} loads the module anew. Does nothing if the module is not loaded.
 */
export function unload(): void {
  requireIdle();
  if (questionsRunning > 0) refuse('the question of an attempt must not unload the module');
  if (exports === null) return;
  generation += 1;
  exports = null;
  loading = null;
  functions = notInitialised;
  lib = functions;
  refreshViews();
  for (const forget of forgetters) forget();
}

/** The size of the module's memory, and the part of it that is in use, in bytes. The memory never becomes smaller. */
export function moduleMemory(): { readonly total: number; readonly used: number } {
  const used = lib.ww_js_memory_in_use() >>> 0;
  return { total: u8.byteLength, used };
}

/** Returns the address of `bytes` bytes. */
export function allocate(bytes: number): number {
  requireIdle();
  if (exports === null) return lib.ww_version_number(); // throws
  let address = 0;
  try {
    if (bytes <= 0xffff0000) address = exports.malloc(bytes) >>> 0;
  } catch (reason) {
    trapped(reason);
  }
  if (address === 0) throw new WaywrightError('out-of-memory', `there is no memory for ${bytes} bytes`);
  return address;
}

export function release(address: number): void {
  try {
    exports!.free(address);
  } catch (reason) {
    trapped(reason);
  }
}

const decoder = new TextDecoder();
const encoder = new TextEncoder();

/** Returns the text of `length` bytes at an address. */
export function textAt(address: number, length: number): string {
  return decoder.decode(u8.subarray(address, address + length));
}

/** Returns the text at an address up to its zero byte. */
export function cTextAt(address: number): string {
  return textAt(address, u8.indexOf(0, address >>> 0) - (address >>> 0));
}

export function encode(text: string): Uint8Array {
  return encoder.encode(typeof text === 'string' ? text : refuse(`a text is ${shown(text)}, not a string`));
}

/** Returns the id at an address: a number if it is one exactly, otherwise a bigint. */
export function idAt(address: number): number | bigint {
  const at = address >>> 2;
  const high = u32[at + 1]!;
  return high < 2 ** 21 ? high * 2 ** 32 + u32[at]! : u64[address >>> 3]!;
}

const MESSAGE_BYTES = 1024;

/** Returns the error of the last call, which has returned `status`. */
function lastError(status: number): WaywrightError {
  const error = scratch.struct;
  u32[(error + ww_error.structSize) >>> 2] = ww_error.size_;
  lib.ww_last_error(error);
  const code = cTextAt(lib.ww_status_name(status)) as ErrorCode;
  // The wrapper reports a lack of memory itself without a message.
  if (i32[(error + ww_error.status) >>> 2] !== status) return new WaywrightError(code, 'there is not enough memory');
  const item = idAt(error + ww_error.item);
  const index = Number(u64[(error + ww_error.index) >>> 3]);
  const stack = exports!.stackSave();
  const buffer = (stack - MESSAGE_BYTES) & ~15;
  exports!.stackRestore(buffer);
  lib.ww_last_error_message(buffer, MESSAGE_BYTES, 0);
  // The library names one of its own functions.
  const message = cTextAt(buffer).replace('keep_history()', 'keepHistory()');
  exports!.stackRestore(stack);
  return new WaywrightError(code, message, item === 0 ? null : item, index);
}

/** Throws the error of a call unless its status is WW_OK. */
export function check(status: number): void {
  if (status !== WW_OK) throw lastError(status);
}

/** Returns whether a list has fitted in its buffer. Throws every other error. */
export function fits(status: number): boolean {
  if (status === WW_BUFFER_TOO_SMALL) return false;
  check(status);
  return true;
}
