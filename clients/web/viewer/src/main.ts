// Creates the parts of the viewer, connects them and runs the render loop.

import {
  Connection,
  MOTION_CHANNEL,
  NO_CHANNELS,
  nowUs,
  openSocket,
  postToServer,
  Queries,
  RecordedStream,
  Recording,
  RenderedPoses,
  simulatedSocket,
  type ConnectionListener,
  type ConnectionState,
} from '@jostle/client';
import type { Entity, WorldStats } from '@jostle/client/gen/play_pb';
import type { View } from '@jostle/client/gen/scene_pb';
import type { PredictionController } from '@jostle/client/prediction';
import * as THREE from 'three';
import { Camera } from './camera/camera';
import { exposeInspection } from './inspection';
import { cameraYaw, combinePads, Driving, type Pad } from './interaction/driving';
import { surfaceHeightAt, unobstructedDistance, type Pick } from './interaction/pick';
import { TOOL_ACTIONS, TOOLS, Tools, type Tool } from './interaction/tools';
import { TouchControls } from './interaction/touch_controls';
import { ModuleView, RENDERED_CHANNEL_KINDS, type RenderedChannels } from './module_renderers/module_view';
import { POINT_CHANNEL_KINDS, PointObjectsView } from './point_objects/point_objects_view';
import type { DebugPanel } from './panels/debug';
import { drawArrows, DriverPanel, offerText } from './panels/driver';
import { describePick, entityName } from './panels/entity_names';
import type { EventsPanel } from './panels/events';
import type { StatsPanel } from './panels/stats';
import type { LobbyPanel } from './lobby/lobby_panel';
import { ServerApi } from './lobby/server_api';
import { People } from './people/people';
import { Room } from './room/room';
import { StatusBanner } from './panels/status_banner';
import { TimelinePanel } from './panels/timeline';
import { Toasts } from './panels/toasts';
import { DebugView } from './scene/debug_view';
import { Sandbox } from './sandbox/sandbox';
import { Environment, PALETTES } from './scene/environment';
import { HitMarks } from './scene/hit_marks';
import { JointView } from './scene/joint_view';
import { InputMarks } from './scene/input_marks';
import { AutomaticQuality, LOW_QUALITY, QUALITY_LEVELS, type QualityLevel } from './scene/quality';
import { SceneView } from './scene/scene_view';
import { Commands, isTextInput } from './ui/commands';
import { ContextMenu, type MenuItem } from './ui/context_menu';
import { iconButton } from './ui/icons';
import { FrameTimes } from './ui/frame_times';
import { Panels } from './ui/panels';
import { ScaleBar } from './ui/scale_bar';
import { ThemeSwitch } from './ui/theme';
import { Toolbar } from './ui/toolbar';
import { layoutInsets } from './ui/layout';
import { parseUrlParameters, takeToken } from './url_parameters';
import './style.css';

const byId = <T extends HTMLElement>(id: string) => document.getElementById(id) as T;
const errorText = (error: unknown) => (error instanceof Error ? error.message : String(error));

const parameters = parseUrlParameters(location.search);

// --- rendering

const canvas = byId<HTMLCanvasElement>('view');
const renderer = new THREE.WebGLRenderer({ canvas, antialias: parameters.quality === 'auto' || parameters.quality === 'high' });
renderer.shadowMap.enabled = true;
renderer.shadowMap.type = THREE.PCFShadowMap;
renderer.toneMapping = THREE.NeutralToneMapping;

const camera = new Camera(canvas);
const view = new SceneView();
const environment = new Environment(view.scene);
const poses = new RenderedPoses();
const frameTimes = new FrameTimes();

const automaticQuality = parameters.quality === 'auto' ? new AutomaticQuality() : undefined;
const FIXED_QUALITY: Record<string, QualityLevel> = { high: QUALITY_LEVELS[0]!, medium: QUALITY_LEVELS[2]!, low: LOW_QUALITY };
let quality = FIXED_QUALITY[parameters.quality] ?? QUALITY_LEVELS[0]!;

function setQuality(level: QualityLevel): void {
  quality = level;
  document.documentElement.toggleAttribute('data-blur', level.blur);
  environment.setQuality(level);
  resize();
}

function resize(): void {
  renderer.setPixelRatio(Math.min(quality.pixelRatioMax, quality.pixelRatioMax < 1 ? 1 : devicePixelRatio));
  renderer.setSize(innerWidth, innerHeight, false);
  updateLayout();
  camera.resize(innerWidth, innerHeight);
}

function updateLayout(): void {
  camera.setInsets(layoutInsets(innerWidth, innerHeight));
}

const theme = new ThemeSwitch((name) => {
  environment.setPalette(PALETTES[name]);
  renderer.toneMappingExposure = PALETTES[name].exposure;
});

// --- connection

const toasts = new Toasts(byId('toasts'));
const stateLine = byId('state');

const STATE_TEXTS: Record<ConnectionState, string> = {
  connecting: 'connecting …',
  playing: '',
  waiting: 'reconnecting …',
  stopped: '',
};

const token = takeToken(
  { hash: location.hash, replaceHash: (hash) => history.replaceState(null, '', location.pathname + location.search + (hash && `#${hash}`)) },
  sessionStorage,
);
let playedBefore = false; // the current world was joined before this connection
let resumedBefore = 0;
const listener: ConnectionListener = {
  state: (state, reason) => {
    const name = connection.welcome?.worldName ?? '';
    stateLine.textContent = state === 'playing' ? name : STATE_TEXTS[state] || (reason ? 'not connected' : '');
    stateLine.className = state;
    banner.setConnection(state, reason);
    if (state === 'playing') onPlaying();
    if (state === 'playing') people.playing();
    if (state === 'stopped' && reason) panels.open('worlds');
  },
  entityList: (entities) => {
    view.setEntities(entities, connection.welcome?.clientId ?? 0);
    controllable = recorded ? [] : [...entities.values()].filter((entity) => entity.controllable);
    entitiesChanged = true;
    if (!entities.has(driving.entity)) driving.reset();
    sandbox.onWorldChanged();
  },
  stats: (stats) => {
    latestStats = stats;
    statsPanel?.update(stats);
    sandbox.onStats(stats);
    banner.setStats(recorded ? undefined : stats);
  },
  joints: (joints) => {
    jointView.setJoints(joints);
    sandbox.onWorldChanged();
  },
  worldEvents: (events) => eventsPanel?.addEvents(events, performance.now() + renderDelayMs()),
  inputRejected: (result) => people.rejected(result) || sandbox.rejected(result) || room.rejected(result) || toasts.show(result.message || 'the server rejected the input'),
  notice: (text) => toasts.show(text),
  playerEvent: (event) => people.playerEvent(event),
  dataChanged: () => {
    room.onDataChanged();
    people.dataChanged();
    sandbox.onDataChanged();
  },
  userMessage: (message) => people.message(message),
};
const open = parameters.networkConditions ? simulatedSocket(openSocket, parameters.networkConditions) : openSocket;
let recorded: RecordedStream | undefined; // played instead of a live world
const channelKinds = [...RENDERED_CHANNEL_KINDS, POINT_CHANNEL_KINDS, ...(parameters.predict ? [MOTION_CHANNEL] : [])];
const contextMenu = new ContextMenu(byId('context-menu'));
const panels = new Panels({ left: byId('dock-left'), right: byId('dock-right'), buttons: byId('panel-buttons') }, updateLayout);
const people = new People({
  connection: () => connection,
  view,
  camera,
  panels,
  contextMenu,
  token,
  rules: () => room.rules,
  grab: () => tools.grab,
  controlled: () => driving.entity,
  isRecorded: () => recorded !== undefined,
  join: joinWorld,
  showProblem: (text) => toasts.show(text),
});
const connection = new Connection({
  url: websocketUrl(),
  ...people.connectionOptions,
  joinCode: people.initialJoinCode(parameters.world),
  listener,
  openSocket: (url) => (recorded ? recorded.open() : open(url)),
  token,
  channelKinds,
  areaOfInterest: parameters.areaOfInterest,
  joints: true,
  players: true,
  attributes: true,
});

function onPlaying(): void {
  if (playedBefore) banner.setReconnected(connection.resumed > resumedBefore ? 'session' : 'new client');
  playedBefore = true;
  resumedBefore = connection.resumed;
  banner.setPlayed();
}

/** The user leaves the world or joins it again, which is no lost connection. */
function beginWorld(): void {
  playedBefore = false;
  banner.begin();
}

function joinWorld(world: string, joinCode = ''): void {
  beginWorld();
  connection.join(world, joinCode);
}

function websocketUrl(): string {
  const url = new URL('play', location.href);
  url.protocol = location.protocol === 'https:' ? 'wss:' : 'ws:';
  url.search = url.hash = '';
  return url.href;
}

let prediction: PredictionController | undefined;
async function enablePrediction(): Promise<void> {
  const disable = (error: unknown) => {
    prediction = undefined;
    toasts.show(`prediction is disabled: ${errorText(error)}`);
  };
  try {
    const { loadPrediction } = await import('@jostle/client/prediction');
    prediction = await loadPrediction(connection.frames, disable);
    connection.enablePrediction(prediction);
  } catch (error) {
    disable(error);
  }
}
if (parameters.predict) void enablePrediction();

// --- tools

const queries = new Queries(() => (connection.state === 'playing' && !recorded ? (connection.welcome?.worldId ?? '') : ''), postToServer(token));
const readout = byId('readout');
const driving = new Driving((input) => connection.send(input));
const touchControls = new TouchControls(byId('touch-controls'));
const inputMarks = new InputMarks();
let controllable: Entity[] = [];
let entitiesChanged = false;
let touchUsed = matchMedia('(pointer: coarse)').matches;
addEventListener('pointerdown', ({ pointerType }) => (touchUsed = pointerType === 'touch'), { capture: true });

const commands = new Commands();
const room: Room = new Room({
  scene: view.scene,
  panels,
  connection,
  nameOf: (client) => people.nameOfClient(client),
  selectedBox: () => (sandbox.selection.body === 0 ? undefined : view.boxOf(sandbox.selection.body)),
  cameraTarget: () => camera.controls.target,
});
const sandbox = new Sandbox({
  room,
  connection,
  queries,
  view,
  panels,
  commands,
  hint: byId('tool-hint'),
  isPlanar: () => camera.planar,
  focus: focusBody,
  stats: () => latestStats,
});
const tools = new Tools({
  canvas,
  camera,
  view,
  connection,
  queries,
  onHover(hit) {
    people.hover(hit?.point);
    readout.hidden = hit === undefined;
    if (hit) readout.textContent = describePick(connection.entities.get(hit.entity), hit);
  },
  takeControl(entity) {
    if (!connection.entities.get(entity)?.controllable) return toasts.show('this entity is not controllable');
    takeControl(entity);
  },
  onExplosion: (x, y, z, radius) => moduleView.blasts.add(x, y, z, radius, performance.now()),
  onSpawn: (position, radius) => inputMarks.spawned(position, radius, performance.now()),
  onMenu: openBodyMenu,
  spawnOptions: sandbox.spawnOptions,
  onSandboxClick: (tool, hit, ray) => (tool === 'joint' ? hit && sandbox.jointTool.click(hit) : sandbox.inspectAt(hit, ray)),
  onFocus: (hit) => hit && focusBody(hit.entity),
});

function focusBody(entity: number): void {
  const box = view.boxOf(entity);
  if (box.isEmpty()) return;
  const size = box.getSize(new THREE.Vector3());
  camera.focus(box.getCenter(new THREE.Vector3()), Math.max(size.x, size.y, size.z) / 2);
}

function openBodyMenu(hit: Pick | undefined, x: number, y: number): void {
  const entity = hit && connection.entities.get(hit.entity);
  const items: MenuItem[] = [];
  if (entity) items.push(...sandbox.menuItems(entity.id, tools.enabled));
  if (entity && entity.mass > 0) items.push({ label: 'Focus', run: () => focusBody(entity.id) });
  if (entity?.controllable && tools.enabled) items.push({ label: 'Drive', refusal: room.rules.refusal('control'), run: () => takeControl(entity.id) });
  if (entity && tools.enabled && entity.owner !== 0 && entity.owner === connection.welcome?.clientId)
    items.push({ label: 'Delete', refusal: room.rules.refusal('delete', 'self'), run: () => connection.send({ kind: { case: 'delete', value: { entity: entity.id } } }) });
  items.push({ label: 'Show all', run: fitView });
  contextMenu.open(hit ? describePick(entity, hit) : 'View', items, x, y);
}

const toolbar = new Toolbar<Tool>(byId('tools'), TOOLS, selectTool, (rule) => toasts.show(rule));
room.onChange((rules) => {
  toolbar.setRefusals((tool) => (TOOL_ACTIONS[tool] ? rules.refusal(TOOL_ACTIONS[tool]) : ''));
  if (toolbar.refusalOf(tools.tool)) selectTool('inspect');
});
function selectTool(tool: Tool): void {
  tools.tool = tool;
  sandbox.jointTool.setSelected(tool === 'joint');
  toolbar.show(tool);
  canvas.style.cursor = tool === 'drag' ? '' : 'crosshair';
}

const driverPanel = new DriverPanel(byId('driver'), takeControl, () => driving.stopControlling());
const debugView = new DebugView(view.scene);
const hitMarks = new HitMarks(view.scene);
const jointView = new JointView(view.scene);
const moduleView = new ModuleView(view.scene);
const pointObjectsView = new PointObjectsView(view.scene);
const scaleBar = new ScaleBar(byId('scale'));

// --- panels, each loaded when it is opened

let latestStats: WorldStats | undefined;
let statsPanel: StatsPanel | undefined;
let debugPanel: DebugPanel | undefined;
let eventsPanel: EventsPanel | undefined;
let lobby: LobbyPanel | undefined;

const banner = new StatusBanner({
  element: byId('banner'),
  world: () => connection.welcome?.worldId ?? '',
  token,
  showMessage: (text) => toasts.show(text),
  reconnect: () => connection.retryNow(),
  openWorlds: () => panels.open('worlds'),
  onChange: updateLayout,
});

panels.register({
  id: 'worlds',
  title: 'Worlds',
  hint: 'Join, create and delete worlds',
  key: 'w',
  icon: 'worlds',
  side: 'left',
  async load(content) {
    const { LobbyPanel } = await import('./lobby/lobby_panel');
    const join = (world: string, name: string, joinCode: string) => {
      play(undefined);
      if (joinCode) people.joinCodes.set(name, joinCode);
      joinWorld(world, joinCode);
    };
    lobby = new LobbyPanel({
      content,
      api: new ServerApi(token),
      contextMenu,
      close: () => panels.close('worlds'),
      join,
      joinCodeOf: (name) => people.joinCodes.get(name),
      current: () => connection.welcome?.worldId ?? '',
      showProblem: (text) => toasts.show(text),
    });
    return lobby;
  },
});
panels.register({
  id: 'stats',
  title: 'Statistics',
  hint: 'Latency, bandwidth and load',
  key: 's',
  icon: 'stats',
  side: 'right',
  async load(content) {
    const { StatsPanel } = await import('./panels/stats');
    statsPanel = new StatsPanel(content, connection);
    if (latestStats) statsPanel.update(latestStats);
    return {};
  },
});
panels.register({
  id: 'debug',
  title: 'Debug view',
  hint: 'Contacts, islands, joints and bounds of the solver',
  key: 'd',
  icon: 'debug',
  side: 'left',
  async load(content) {
    const { DebugPanel } = await import('./panels/debug');
    debugPanel = new DebugPanel(content, queries, debugView, view);
    return {};
  },
});
panels.register({
  id: 'events',
  title: 'Events',
  hint: 'Contacts, hits and triggers; opening the panel rejoins the world',
  key: 'e',
  icon: 'events',
  side: 'left',
  async load(content) {
    const { EventsPanel } = await import('./panels/events');
    eventsPanel = new EventsPanel(
      content,
      hitMarks,
      (enabled) => {
        beginWorld();
        connection.setEventsEnabled(enabled);
      },
      (id) => entityName(connection.entities.get(id), id),
    );
    return eventsPanel;
  },
});
sandbox.register();
people.registerPanels();
room.register();
panels.register({
  id: 'help',
  title: 'Help',
  hint: 'Tools, keys and gestures',
  key: '?',
  icon: 'help',
  side: 'left',
  async load(content) {
    const { helpPanel } = await import('./panels/help');
    return helpPanel(content, TOOLS, commands.all);
  },
});
const viewCommands = [
  { icon: 'fit', label: 'Show all', hint: 'Shows all bodies', key: 'f', run: fitView },
  { icon: 'theme', label: 'Theme', hint: 'Light or dark theme', key: 't', run: () => theme.toggle() },
] as const;
panels.register({
  id: 'menu',
  title: 'Menu',
  hint: 'Panels and settings',
  key: '',
  icon: 'menu',
  side: 'left',
  narrowOnly: true,
  async load(content) {
    const { menuPanel } = await import('./panels/menu');
    const others = panels.definitions.filter(({ id }) => id !== 'menu');
    return menuPanel(content, others, (id) => panels.open(id), viewCommands);
  },
});

for (const { icon, label, hint, key, run } of viewCommands) {
  const button = iconButton(icon, label);
  button.title = `${hint} (${key.toUpperCase()})`;
  button.className = 'wide-only';
  button.onclick = run;
  byId('panel-buttons').append(button);
}

for (const { tool, key, label } of TOOLS) commands.register({ key, label, run: () => toolbar.choose(tool) });
for (const { id, key, title } of panels.definitions) if (key) commands.register({ key, label: title, run: () => panels.toggle(id) });
for (const { key, hint, run } of viewCommands) commands.register({ key, label: hint, run });

addEventListener('keydown', (event) => {
  if (event.ctrlKey || event.metaKey || event.altKey || isTextInput(event.target)) return;
  if (event.key === 'Escape') return escape();
  if (driving.keyDown(event.code)) return event.preventDefault();
  if (event.target === canvas && camera.key(event.code)) return event.preventDefault();
  const onPage = event.target === document.body || event.target === canvas;
  if (recorded && event.key === ' ' && onPage) return timeline.toggle();
  if (commands.run(event.key)) event.preventDefault();
});
addEventListener('keyup', (event) => driving.keyUp(event.code));
addEventListener('blur', () => driving.blur());

function escape(): void {
  if (contextMenu.close()) return canvas.focus();
  if (driving.entity !== 0) return driving.stopControlling();
  if (sandbox.cancel()) return;
  if (people.stopFollowing()) return;
  panels.closeNewest();
}

// --- recordings

let renderTimeUs = 0; // of the last rendered frame, on the server's clock

/** How far rendering is behind the newest frame. */
function renderDelayMs(): number {
  const newest = connection.frames.newest;
  return newest ? Math.max(0, (newest.serverUs - renderTimeUs) / 1000) : 0;
}

const timeline = new TimelinePanel(byId('timeline'));

/** undefined: back to a live world. */
function play(stream: RecordedStream | undefined): void {
  recorded = stream;
  timeline.show(stream);
  tools.enabled = stream === undefined;
  document.documentElement.toggleAttribute('data-recording', stream !== undefined);
  updateLayout();
}

async function playRecording(name: string, bytes: Promise<ArrayBuffer>): Promise<void> {
  try {
    const recording = new Recording(new Uint8Array(await bytes));
    if (recording.truncationReason) toasts.show(`${name}: incomplete recording: ${recording.truncationReason}`);
    for (const { reason, length, snapshotsSkipped } of recording.damage)
      toasts.show(`${name}: damaged recording: ${reason}; ${length} bytes and ${snapshotsSkipped} snapshots are skipped`);
    driving.stopControlling();
    play(new RecordedStream(recording));
    joinWorld('');
  } catch (error) {
    toasts.show(`${name}: ${errorText(error)}`);
  }
}

addEventListener('dragover', (event) => event.preventDefault());
addEventListener('drop', (event) => {
  event.preventDefault();
  const file = event.dataTransfer?.files[0];
  if (file?.name.endsWith('.json')) void uploadScene(file);
  else if (file) void playRecording(file.name, file.arrayBuffer());
});

async function uploadScene(file: File): Promise<void> {
  panels.open('worlds');
  while (!lobby) await new Promise((resolve) => setTimeout(resolve, 50)); // until its code is loaded
  await lobby.upload(file);
}

async function download(url: string): Promise<ArrayBuffer> {
  const response = await fetch(url);
  if (!response.ok) throw new Error(`the server responded with HTTP status ${response.status}`);
  return response.arrayBuffer();
}

// --- camera

let framedWorld: string | undefined; // the world to which the camera was adjusted

/** Shows the whole scene when a world is joined for the first time. */
function frameWorld(): void {
  const world = connection.welcome?.worldId;
  if (connection.state !== 'playing' || world === framedWorld || poses.count === 0) return;
  framedWorld = world;
  camera.setPlanar(connection.welcome?.planar ?? false);
  if (!showSceneView(connection.welcome?.view)) camera.frame(view.extent());
  liftAboveGround();
}

/** Returns whether the scene defines a view. Its numbers are untrusted. */
function showSceneView(sceneView: View | undefined): boolean {
  const { eye, target, fieldOfView = 0 } = sceneView ?? {};
  if (!eye || !target) return false;
  const [from, to] = [new THREE.Vector3(eye.x, eye.y, eye.z), new THREE.Vector3(target.x, target.y, target.z)];
  const distance = from.distanceTo(to);
  if (!(distance > 1e-3 && distance < 1e6)) return false;
  const degrees = (fieldOfView * 180) / Math.PI;
  camera.setView(from, to, degrees >= 5 && degrees <= 150 ? degrees : 0);
  return true;
}

function fitView(): void {
  if (driving.entity === 0) camera.frame(view.extent(), true);
}

/** Keeps the camera above hills. */
function liftAboveGround(): void {
  if (camera.planar) return;
  const { position } = camera.camera;
  const ground = surfaceHeightAt(view, position.x, position.z);
  if (ground !== undefined) position.y = Math.max(position.y, ground + 3);
}

/** Heading of an entity seen from above: that of its own -z axis. */
function headingOf(pose: ArrayLike<number>): number {
  const [x, y, z, w] = [pose[3]!, pose[4]!, pose[5]!, pose[6]!];
  return Math.atan2(2 * (x * z + w * y), 1 - 2 * (x * x + y * y));
}

function takeControl(entity: number): void {
  driving.takeControl(entity);
  camera.startApproach(moduleView.steeringOf(entity)?.distance ?? 8);
}

function drive(seconds: number): void {
  const shown = driving.entity !== 0 && touchUsed;
  document.documentElement.toggleAttribute('data-touch-driving', shown);
  touchControls.show(shown ? (moduleView.steeringOf(driving.entity)?.buttons ?? ['1', '2']) : undefined);
  if (driving.entity === 0) return;
  const gamepad: Pad | undefined = navigator.getGamepads().find((one) => one !== null && one.mapping === 'standard') ?? undefined;
  const pad = combinePads(gamepad, shown ? touchControls : undefined);
  driving.update(pad, cameraYaw(camera.camera.getWorldDirection(new THREE.Vector3())), performance.now());
  const pose = view.poseOf(driving.entity);
  if (!pose) return;
  // An entity that moves relative to the camera leaves the direction of the camera to the pointer.
  const behind = moduleView.steeringOf(driving.entity)?.camera !== 'free';
  camera.follow(pose, behind ? headingOf(pose) : undefined, seconds);
}

/** Limits the camera distance for characters, which move close to walls. */
function clearDistance(): number {
  if (driving.entity === 0 || moduleView.steeringOf(driving.entity)?.camera !== 'free') return Infinity;
  return unobstructedDistance(view, camera.controls.target, camera.camera.position, driving.entity);
}

// --- the render loop

function renderedChannels(): RenderedChannels {
  const { frame = 0, channels = NO_CHANNELS } = poses.source ?? {};
  const { channels: kinds = [], tickHz = 60 } = connection.welcome ?? {};
  return { frame, channels, secondsAfter: poses.secondsFromSource, kinds, tickHz };
}

const poseOf = (entity: number) => view.poseOf(entity);

function renderModules(rendered: RenderedChannels): void {
  moduleView.debug = debugPanel?.on.fields ?? false;
  moduleView.update(rendered, {
    nowMs: performance.now(),
    cameraTarget: camera.controls.target,
    poseOf,
    entityOf: (entity) => connection.entities.get(entity),
    decorate: (solids) => {
      if (tools.tool === 'drive' && driving.entity === 0) drawArrows(solids, controllable, poseOf, performance.now());
      inputMarks.draw(solids, tools.grab, poseOf, camera.distance, performance.now());
      people.draw(solids, poseOf);
    },
  });
}

function colorBodies(rendered: RenderedChannels): void {
  const colors = moduleView.bodyColors(rendered, entitiesChanged, connection.entities);
  entitiesChanged = false;
  if (colors) view.setBodyColors(colors);
}

function updateDriverPanel(): void {
  driverPanel.update(
    {
      toolSelected: tools.tool === 'drive',
      controlled: connection.entities.get(driving.entity),
      keys: moduleView.steeringOf(driving.entity)?.keys ?? '',
      status: moduleView.controlledStatusText(driving.entity),
      worldStatus: moduleView.statusText() || offerText(controllable, touchUsed),
      touch: touchUsed,
    },
    controllable,
  );
}

/** Everything of a rendered frame except the calls that draw. */
function updateFrame(seconds: number): void {
  const now = nowUs();
  renderTimeUs = recorded ? recorded.advance(now) : connection.renderClock.advance(now);
  poses.update(connection.frames, renderTimeUs, now);
  if (!recorded) prediction?.applyTo(poses, connection.inputClock.position(now), now);
  timeline.update();
  const rendered = renderedChannels();
  colorBodies(rendered);
  view.update(poses);
  jointView.update(view);
  sandbox.update();
  room.update();
  frameWorld();
  camera.update(seconds);
  renderModules(rendered);
  connection.samplePoints(renderTimeUs);
  pointObjectsView.update(connection.points.objects, poseOf);
  updateDriverPanel();
  debugPanel?.update();
  panels.update();
  hitMarks.update(performance.now());
  drive(seconds);
  people.update(seconds);
  connection.setInterestFocus(camera.controls.target.x, camera.controls.target.z);
  environment.update(camera.controls.target, camera.distance, camera.planar);
  scaleBar.update(camera.viewHeight / innerHeight);
}

let lastFrameMs = performance.now();
renderer.setAnimationLoop(() => {
  const startMs = performance.now();
  const seconds = Math.min(0.5, (startMs - lastFrameMs) / 1000);
  lastFrameMs = startMs;
  if (automaticQuality?.frame(startMs)) setQuality(QUALITY_LEVELS[automaticQuality.level]!);
  updateFrame(seconds);
  const clear = clearDistance();
  frameTimes.add(performance.now() - startMs);
  camera.renderWithin(clear, () => renderer.render(view.scene, camera.camera));
  statsPanel?.frameRendered();
});

setQuality(quality);
selectTool('drag');
addEventListener('resize', resize);
new ResizeObserver(updateLayout).observe(byId('bottom'));
people.askForName();
// Statistics cover too much of a small screen.
if (!panels.isNarrow) panels.open('stats');

if (parameters.recording) void playRecording(parameters.recording, download(parameters.recording));
else joinWorld(parameters.world, people.joinCodes.get(parameters.world));

exposeInspection({
  people,
  connection,
  view,
  moduleView,
  pointObjectsView,
  camera,
  driving,
  frameTimes,
  jointView,
  sandbox,
  room,
  stats: () => latestStats,
  qualityName: () => quality.name,
  recording: () => recorded,
  prediction: () => prediction,
  controllableEntities: () => controllable.map(({ id }) => id),
});
