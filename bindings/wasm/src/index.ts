export type { Point, Points } from './buffers.js';
export { type ErrorCode, WaywrightError } from './errors.js';
export { QueryContext, trim } from './handle.js';
export { type Item, type ItemInfo, ItemList } from './items.js';
export { Mesh } from './mesh.js';
export {
  type Bridge,
  type MovedEnd,
  Path,
  type PathAlgorithm,
  type PathInfo,
  type PathOptions,
  type PathPiece,
  type PathPosition,
  type PathQuery,
  Paths,
  type PathsPoints,
  type PathStatus,
  type Precision,
  Walkers,
  type WidestPath,
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
  type ScenarioQuery,
  Scene,
  type SceneFormat,
  sceneFormat,
  Script,
  type ScriptLine,
  type ScriptLineKind,
} from './scene.js';
export { boundingBox, centroid, type FillRule, type ItemKind, type RaggedPoints, Shape, translated } from './shape.js';
export {
  type MarkStyle,
  type SvgFrame,
  svgFrame,
  type SvgOptions,
  SvgOverlay,
  type SvgTheme,
  svgToPicture,
  svgToWorld,
} from './svg.js';
export {
  type Agent,
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
  type ChangedBox,
  type CrossedItem,
  type DiscFit,
  type Location,
  type LocationKind,
  type ManyGoalsQuery,
  type MemoryUse,
  type NearestFit,
  type NearestFitQuery,
  type RayHit,
  type Validation,
  World,
} from './world.js';
export { isSavedWorld, type WorldOptions } from './world_history.js';
export type { BulkOptions, Change } from './world_items.js';
