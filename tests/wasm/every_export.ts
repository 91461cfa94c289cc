// Uses every export of the package as TypeScript sees it. types.test.mjs compiles this file under strict rules, and runs it.
import {
  type Agent, boundingBox, type Box, type Bridge, type BulkOptions, centroid, type Change, type ChangedBox, type CompiledModule, type CrossedItem, type DifferenceKind,
  type DiscFit, type ErrorCode, type FillRule, findDifference, init, type InitOptions, initSync, isInRange, isSavedWorld,
  type Item, type ItemId, type ItemInfo, type ItemKind, ItemList, LARGEST_COORDINATE, type Location, type LocationKind,
  type ManyGoalsQuery, type MarkStyle, type MemoryUse, Mesh, type ModuleBytes, moduleMemory, type MovedEnd, type NearestFit,
  type NearestFitQuery, Path, type PathAlgorithm, type PathChanges, type PathInfo, type PathOptions, type PathPiece,
  type PathPosition, type PathQuery, Paths, PathSearch, type PathsPoints, type PathStatus, PathWatch, type Point, type Points,
  type Precision, type PredicateCounts, predicateCounts, QueryContext, type RaggedPoints, type RayHit, replay,
  type ReplayDifference, type ReplayResult, ReplayWriter, Scenario, type ScenarioQuery, Scene, type SceneFormat, sceneFormat,
  Script, type ScriptLine, type ScriptLineKind, Shape, SMALLEST_COORDINATE, type StageCounts, type SvgFrame, svgFrame,
  type SvgOptions, SvgOverlay, type SvgTheme, svgToPicture, svgToWorld, translated, trim, unload, type Validation, version,
  Walkers, WaywrightError, type WidestPath, World, type WorldOptions,
} from 'waywright';

const loading: InitOptions = { maximumMemory: 2 ** 28 };
await init(loading);
const bytes: ModuleBytes | CompiledModule = new Uint8Array(0);
initSync(bytes); // does nothing: the module is loaded

const domain: Box = { min: { x: 0, y: 0 }, max: { x: 100, y: 100 } };
const worldOptions: WorldOptions = { keepBridges: true, newVertexLimit: Infinity };
const world = new World(domain, worldOptions);
const start: Point = { x: 10, y: 70 };
const goal: Point = { x: 50, y: 40 };
const line: Points = [40, 0, 40, 70];
const kind: ItemKind = 'polygon';
const fill: FillRule = 'nonzero';
const house: Shape = { kind, fill, points: Float64Array.of(60, 40, 80, 40, 80, 60), ringSizes: [3] };
const wall: ItemId = world.insertPolyline(line);
const change: Change = { kind: 'insert', shape: house, id: 7n };
const bulk: BulkOptions = { progress: (done: number, total: number): void => void (done <= total) };
world.apply([change]);
world.keepHistory(3);
const tick: number = world.mark();
world.insertAll([{ shape: Shape.regularPolygon({ x: 20, y: 20 }, 3, 5) }] satisfies Item[], bulk);
world.insertPoints(new Float32Array([1, 1, 2, 2]), 0, bulk);
world.rewind(tick);

const list = new ItemList([{ id: 5, shape: translated(Shape.rectangle(domain), 1, 1) }]);
const many: RaggedPoints = { points: Float64Array.of(1, 1, 2, 2), offsets: [0, 1, 2] };
list.addMany('point', many, 9);
const info: ItemInfo = list.info(0);
const middle: Point = centroid(house);
const around: Box = boundingBox([start, goal]);

const context = new QueryContext();
const location: Location = world.locate(middle, context);
const locationKind: LocationKind = location.kind;
const crossed: CrossedItem[] = world.itemsCrossed(start, goal);
const hit: RayHit = world.ray(start, goal);
const agent: Agent = { radius: 2 };
const fit: DiscFit = world.fitDisc(start, agent);
const nearestQuery: NearestFitQuery = { point: middle, agent };
const nearest: NearestFit = world.nearestFit(nearestQuery);
const bridges: Bridge[] = world.bridges(domain);
const widest: WidestPath = world.widestPath(start, goal);

const algorithm: PathAlgorithm = 'ta';
const options: PathOptions = { algorithm, wantsChannel: true, budgetExpansions: Infinity };
const query: PathQuery = { start, goal, ...options };
const path: Path = world.findPath(query);
const pathInfo: PathInfo = path.info;
const status: PathStatus = path.status;
const moved: MovedEnd | null = pathInfo.movedStart;
const pieces: PathPiece[] = world.findPath({ start, goal, agent }).pieces();
const precision: Precision = 'float32';
const position: PathPosition = path.advance(path.at(1), 2, precision);
const paths: Paths = world.findPaths([start, goal], options);
const points: PathsPoints = paths.points();
const goals: ManyGoalsQuery = { start, goals: [goal] };
world.findPathsFrom(goals, paths);
const search = new PathSearch();
search.begin(world, query);
while (!search.step(10));
const watch = new PathWatch(world);
watch.add(1, path);
const changes: PathChanges = watch.update();
const walkers = new Walkers(1);
walkers.set(0, path);
walkers.advance(1);
const boxes: ChangedBox[] | null = world.changesSince(0);
const asked: number = world.attempt([{ kind: 'remove', id: wall }], (changed) => changed.findPath(query).length);

const mesh: Mesh = world.snapshot(new Mesh());
const memory: MemoryUse = world.memory();
const validation: Validation = world.validate();
const saved: Uint8Array = world.save();
const counts: PredicateCounts = predicateCounts();
const stages: StageCounts = counts.orientation;

const format: SceneFormat = sceneFormat('a.map');
const scene = new Scene().set(domain, list);
const writer = new ReplayWriter(world);
writer.record([change], [7]);
writer.tick(world);
const script = new Script().parse(writer.take());
const scriptLine: ScriptLine = script.line(0);
const lineKind: ScriptLineKind = scriptLine.kind;
const result: ReplayResult = replay(script);
const difference: ReplayDifference | null = findDifference(script, script);
const differenceKind: DifferenceKind | undefined = difference?.kind;
const scenario = new Scenario().parse('version 1\n3\ta.map\t512\t256\t1\t2\t30\t40\t47.5\n');
const scenarioQuery: ScenarioQuery = scenario.query(0);

const theme: SvgTheme = 'dark';
const svgOptions: SvgOptions = { theme, crop: around };
const frame: SvgFrame = svgFrame(domain, svgOptions);
const style: MarkStyle = { colour: 'red' };
const overlay = new SvgOverlay().addDisc(svgToWorld(frame, svgToPicture(frame, start)), 1, style);
const picture: string = world.toSvg(overlay, svgOptions);

let code: ErrorCode = 'malformed';
try {
  world.remove(12345);
} catch (error) {
  if (error instanceof WaywrightError) code = error.code;
}
const used: number = moduleMemory().used;
const facts: readonly unknown[] = [
  info, locationKind, crossed, hit, fit, nearest, bridges, widest, status, moved, pieces, position, points, changes, boxes, asked, mesh,
  memory, validation, stages, format, scene, lineKind, result, differenceKind, scenarioQuery, picture, code, used,
  isSavedWorld(saved), isInRange(LARGEST_COORDINATE), isInRange(SMALLEST_COORDINATE),
];
if (code !== 'unknown-id' || facts.includes(undefined) === (differenceKind !== undefined)) throw new Error('wrong facts');
path.dispose();
trim();
unload();
if (!world.isDisposed || !/^\d+\.\d+\.\d+$/.test(await init().then(version))) throw new Error('not unloaded');
console.log('passed');
