export type { Point, Points } from './buffers.js';
export { type ErrorCode, WaywrightError } from './errors.js';
export { QueryContext, trim } from './handle.js';
export { type Item, type ItemInfo, ItemList } from './items.js';
export { Mesh } from './mesh.js';
export {
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
export { init, type InitOptions, initSync, moduleMemory } from './runtime.js';
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
export { type Box, type ItemId, type PredicateCounts, predicateCounts, type StageCounts, version } from './values.js';
export {
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
  type WorldOptions,
} from './world.js';
export type { BulkOptions, Change } from './world_items.js';
