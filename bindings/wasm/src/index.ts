export type { Point, Points } from './buffers.js';
export type { PathAlgorithm, PathStatus, SvgTheme } from './enums.js';
export { type ErrorCode, WaywrightError } from './errors.js';
export { QueryContext, trim } from './handle.js';
export { type Item, type ItemInfo, ItemList } from './items.js';
export { Mesh } from './mesh.js';
export {
  type Bridge,
  Path,
  type PathPosition,
  Paths,
  type PathsPoints,
  type Precision,
  Walkers,
} from './path.js';
export { PathSearch } from './path_search.js';
export { type PathChanges, PathWatch } from './path_watch.js';
export {
  type DifferenceKind,
  findDifference,
  replay,
  type ReplayDifference,
  type ReplayResult,
  ReplayWriter,
} from './replay.js';
export { type CompiledModule, init, type InitOptions, initSync, type ModuleBytes, moduleMemory, unload } from './runtime.js';
export {
  Scenario,
  Scene,
  type SceneFormat,
  sceneFormat,
  Script,
  type ScriptLine,
  type ScriptLineKind,
} from './scene.js';
export type {
  Agent,
  ChangedBox,
  CrossedItem,
  ManyGoalsQuery,
  MemoryUse,
  MovedEnd,
  NearestFit,
  NearestFitQuery,
  PathInfo,
  PathOptions,
  PathPiece,
  PathQuery,
  RayHit,
  ScenarioQuery,
  SvgOptions,
  WidestPath,
  WorldOptions,
} from './structs.js';
export { boundingBox, centroid, type FillRule, type ItemKind, type RaggedPoints, Shape, translated } from './shape.js';
export {
  type MarkStyle,
  type SvgFrame,
  svgFrame,
  SvgOverlay,
  svgToPicture,
  svgToWorld,
} from './svg.js';
export {
  type Box,
  isInRange,
  type ItemId,
  LARGEST_COORDINATE,
  type PredicateCounts,
  predicateCounts,
  SMALLEST_COORDINATE,
  type StageCounts,
  version,
} from './values.js';
export {
  type DiscFit,
  type Location,
  type LocationKind,
  type Validation,
  World,
} from './world.js';
export { isSavedWorld } from './world_history.js';
export type { BulkOptions, Change } from './world_items.js';
