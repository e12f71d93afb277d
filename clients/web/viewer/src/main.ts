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
import type { Entity } from '@jostle/client/gen/play_pb';
import type { PredictionController } from '@jostle/client/prediction';
import * as THREE from 'three';
import { Camera } from './camera/camera';
import { exposeInspection } from './inspection';
import { cameraYaw, Driving, type Pad } from './interaction/driving';
import { surfaceHeightAt, unobstructedDistance } from './interaction/pick';
import { TOOLS, Tools, type Tool } from './interaction/tools';
import { ModuleView, RENDERED_CHANNEL_KINDS, type RenderedChannels } from './module_renderers/module_view';
import { POINT_CHANNEL_KINDS, PointObjectsView } from './point_objects/point_objects_view';
import { DebugPanel } from './panels/debug';
import { drawArrows, DriverPanel, offerText } from './panels/driver';
import { describePick, entityName } from './panels/entity_names';
import { EventsPanel } from './panels/events';
import { PauseBanner } from './panels/pause_banner';
import { StatsPanel } from './panels/stats';
import { TimelinePanel } from './panels/timeline';
import { Toasts } from './panels/toasts';
import { WorldsPanel } from './panels/worlds';
import { DebugView } from './scene/debug_view';
import { HitMarks } from './scene/hit_marks';
import { SceneView } from './scene/scene_view';
import { parseUrlParameters, takeToken } from './url_parameters';
import './style.css';

const byId = <T extends HTMLElement>(id: string) => document.getElementById(id) as T;
const errorText = (error: unknown) => (error instanceof Error ? error.message : String(error));

const parameters = parseUrlParameters(location.search);
const { quality } = parameters;

const canvas = byId<HTMLCanvasElement>('view');
const stateLine = byId('state');
document.documentElement.dataset['quality'] = quality;
const renderer = new THREE.WebGLRenderer({ canvas, antialias: quality === 'high' });
renderer.shadowMap.enabled = quality === 'high';
renderer.shadowMap.type = THREE.PCFShadowMap;
renderer.toneMapping = THREE.ACESFilmicToneMapping;

const camera = new Camera(canvas);
const view = new SceneView();
const poses = new RenderedPoses();
const toasts = new Toasts(byId('toasts'));

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
const listener: ConnectionListener = {
  state: (state, reason) => {
    const name = connection.welcome?.worldName ?? '';
    stateLine.textContent = state === 'playing' ? `in ${name}` : [reason, STATE_TEXTS[state]].filter(Boolean).join(' — ');
    stateLine.className = state;
    if (state !== 'playing') pauseBanner.update(undefined);
    if (state === 'stopped' && reason) void worlds.show();
  },
  entityList: (entities) => {
    view.setEntities(entities, connection.welcome?.clientId ?? 0);
    controllable = recorded ? [] : [...entities.values()].filter((entity) => entity.controllable);
    entitiesChanged = true;
    if (!entities.has(driving.entity)) driving.reset();
  },
  stats: (stats) => {
    statsPanel.update(stats);
    pauseBanner.update(recorded ? undefined : stats);
  },
  worldEvents: (events) => eventsPanel.addEvents(events, performance.now() + renderDelayMs()),
  inputRejected: (result) => toasts.show(result.message || 'the server rejected the input'),
  notice: (text) => toasts.show(text),
};
const open = parameters.networkConditions ? simulatedSocket(openSocket, parameters.networkConditions) : openSocket;
let recorded: RecordedStream | undefined; // played instead of a live world
const channelKinds = [...RENDERED_CHANNEL_KINDS, POINT_CHANNEL_KINDS, ...(parameters.predict ? [MOTION_CHANNEL] : [])];
const connection = new Connection({
  url: websocketUrl(),
  listener,
  openSocket: (url) => (recorded ? recorded.open() : open(url)),
  token,
  channelKinds,
  areaOfInterest: parameters.areaOfInterest,
});

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

const statsPanel = new StatsPanel(byId('stats'), connection);
const pauseBanner = new PauseBanner(byId('pause-banner'), () => connection.welcome?.worldId ?? '', (text) => toasts.show(text), token);
const queries = new Queries(() => (connection.state === 'playing' && !recorded ? (connection.welcome?.worldId ?? '') : ''), postToServer(token));
const readout = byId('readout');
const driving = new Driving((input) => connection.send(input));
let controllable: Entity[] = [];
let entitiesChanged = false;
let framedWorld: string | undefined; // the world to which the camera was adjusted
const tools = new Tools(
  canvas,
  camera,
  view,
  connection,
  queries,
  (hit) => {
    readout.hidden = hit === undefined;
    if (hit) readout.textContent = describePick(connection.entities.get(hit.entity), hit);
  },
  (entity) => {
    if (!connection.entities.get(entity)?.controllable) return toasts.show('this entity is not controllable');
    takeControl(entity);
  },
  (x, y, z, radius) => moduleView.blasts.add(x, y, z, radius, performance.now()),
);
const driverPanel = new DriverPanel(byId('driver'), takeControl, () => driving.stopControlling());
const debugPanel = new DebugPanel(byId('debug'), queries, new DebugView(view.scene), view);
const hitMarks = new HitMarks(view.scene);
const moduleView = new ModuleView(view.scene);
const pointObjectsView = new PointObjectsView(view.scene);
const eventsPanel = new EventsPanel(
  byId('events'),
  hitMarks,
  (enabled) => connection.setEventsEnabled(enabled),
  (id) => entityName(connection.entities.get(id), id),
);
const worlds = new WorldsPanel(
  byId('worlds'),
  (world) => {
    play(undefined);
    connection.join(world);
  },
  (text) => toasts.show(text),
  () => connection.welcome?.worldId ?? '',
  token,
);

function websocketUrl(): string {
  const url = new URL('play', location.href);
  url.protocol = location.protocol === 'https:' ? 'wss:' : 'ws:';
  url.search = url.hash = '';
  return url.href;
}

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
}

async function playRecording(name: string, bytes: Promise<ArrayBuffer>): Promise<void> {
  try {
    const recording = new Recording(new Uint8Array(await bytes));
    if (recording.truncationReason) toasts.show(`${name}: incomplete recording: ${recording.truncationReason}`);
    for (const { reason, length, snapshotsSkipped } of recording.damage)
      toasts.show(`${name}: damaged recording: ${reason}; ${length} bytes and ${snapshotsSkipped} snapshots are skipped`);
    driving.stopControlling();
    play(new RecordedStream(recording));
    connection.join('');
  } catch (error) {
    toasts.show(`${name}: ${errorText(error)}`);
  }
}

addEventListener('dragover', (event) => event.preventDefault());
addEventListener('drop', (event) => {
  event.preventDefault();
  const file = event.dataTransfer?.files[0];
  if (file) void playRecording(file.name, file.arrayBuffer());
});

async function download(url: string): Promise<ArrayBuffer> {
  const response = await fetch(url);
  if (!response.ok) throw new Error(`the server responded with HTTP status ${response.status}`);
  return response.arrayBuffer();
}

function selectTool(tool: Tool): void {
  tools.tool = tool;
  for (const button of byId('tools').querySelectorAll('button'))
    button.setAttribute('aria-pressed', String(button.dataset['tool'] === tool));
  canvas.style.cursor = tool === 'drag' ? '' : 'crosshair';
}

for (const { tool, key, label, hint } of TOOLS) {
  const button = document.createElement('button');
  button.type = 'button';
  button.dataset['tool'] = tool;
  button.title = `${hint} (${key})`;
  button.innerHTML = `<kbd>${key}</kbd> ${label}`;
  button.onclick = () => selectTool(tool);
  byId('tools').append(button);
}
selectTool('drag');

byId('help').innerHTML = `<h2>Controls</h2><dl>${TOOLS.map(
  ({ key, label, hint }) => `<dt><kbd>${key}</kbd> ${label}</dt><dd>${hint}</dd>`,
).join('')}<dt>Camera</dt><dd>Drag the ground to turn, right button to pan, wheel to zoom; two fingers on touch screens</dd>
<dt><kbd>D</kbd></dt><dd>Debug view of the solver</dd>
<dt><kbd>E</kbd></dt><dd>Events; opening the panel rejoins the world</dd>
<dt><kbd>W</kbd> <kbd>S</kbd> <kbd>?</kbd></dt><dd>Worlds, statistics, this help</dd></dl>`;

const toggle = (id: string) => {
  byId(id).hidden = !byId(id).hidden;
};
byId('worlds-button').onclick = () => void worlds.toggle();
byId('stats-button').onclick = () => toggle('stats');
byId('debug-button').onclick = () => toggle('debug');
byId('events-button').onclick = () => eventsPanel.toggle();
byId('help-button').onclick = () => toggle('help');
addEventListener('keydown', (event) => {
  if (event.ctrlKey || event.metaKey || event.altKey) return;
  if (event.key === 'Escape') driving.stopControlling();
  if (driving.keyDown(event.code)) return event.preventDefault();
  if (recorded && event.key === ' ' && event.target === document.body) timeline.toggle();
  const selected = TOOLS.find(({ key }) => key === event.key);
  if (selected) selectTool(selected.tool);
  if (event.key === 'w') void worlds.toggle();
  if (event.key === 's') toggle('stats');
  if (event.key === 'd') toggle('debug');
  if (event.key === 'e') eventsPanel.toggle();
  if (event.key === '?') toggle('help');
});

addEventListener('keyup', (event) => driving.keyUp(event.code));
addEventListener('blur', () => driving.blur());

/** Heading of an entity seen from above: that of its own -z axis. */
function headingOf(pose: ArrayLike<number>): number {
  const [x, y, z, w] = [pose[3]!, pose[4]!, pose[5]!, pose[6]!];
  return Math.atan2(2 * (x * z + w * y), 1 - 2 * (x * x + y * y));
}

function takeControl(entity: number): void {
  driving.takeControl(entity);
  camera.startApproach(moduleView.steeringOf(entity)?.distance ?? 8);
}

let lastDriveMs = performance.now();
function drive(): void {
  const nowMs = performance.now();
  const seconds = Math.min(0.5, (nowMs - lastDriveMs) / 1000);
  lastDriveMs = nowMs;
  if (driving.entity === 0) return;
  const pad: Pad | undefined = navigator.getGamepads().find((one) => one !== null && one.mapping === 'standard') ?? undefined;
  driving.update(pad, cameraYaw(camera.camera.getWorldDirection(new THREE.Vector3())), nowMs);
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

/** Shows the whole scene when a world is joined for the first time. */
function frameWorld(): void {
  const world = connection.welcome?.worldId;
  if (connection.state !== 'playing' || world === framedWorld || poses.count === 0) return;
  framedWorld = world;
  camera.frame(view.bounds());
  // Keep the camera above hills.
  const { position } = camera.camera;
  const ground = surfaceHeightAt(view, position.x, position.z);
  if (ground !== undefined) position.y = Math.max(position.y, ground + 3);
}

function renderedChannels(): RenderedChannels {
  const { frame = 0, channels = NO_CHANNELS } = poses.source ?? {};
  const { channels: kinds = [], tickHz = 60 } = connection.welcome ?? {};
  return { frame, channels, secondsAfter: poses.secondsFromSource, kinds, tickHz };
}

function renderModules(rendered: RenderedChannels): void {
  moduleView.debug = debugPanel.on.fields;
  moduleView.update(rendered, {
    nowMs: performance.now(),
    cameraTarget: camera.controls.target,
    poseOf: (entity) => view.poseOf(entity),
    entityOf: (entity) => connection.entities.get(entity),
    decorate: (solids) => {
      if (tools.tool === 'drive' && driving.entity === 0) drawArrows(solids, controllable, (entity) => view.poseOf(entity), performance.now());
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
      worldStatus: moduleView.statusText() || offerText(controllable),
    },
    controllable,
  );
}

function resize(): void {
  renderer.setPixelRatio(quality === 'low' ? 0.25 : quality === 'medium' ? 1 : Math.min(2, devicePixelRatio));
  renderer.setSize(innerWidth, innerHeight, false);
  camera.resize(innerWidth, innerHeight);
}
addEventListener('resize', resize);
resize();
// Statistics cover too much of a small screen.
if (innerWidth < 700) byId('stats').hidden = true;

renderer.setAnimationLoop(() => {
  camera.controls.update();
  const now = nowUs();
  renderTimeUs = recorded ? recorded.advance(now) : connection.renderClock.advance(now);
  poses.update(connection.frames, renderTimeUs, now);
  if (!recorded) prediction?.applyTo(poses, connection.inputClock.position(now), now);
  timeline.update();
  const rendered = renderedChannels();
  colorBodies(rendered);
  view.update(poses);
  frameWorld();
  renderModules(rendered);
  connection.samplePoints(renderTimeUs);
  pointObjectsView.update(connection.points.objects, (entity) => view.poseOf(entity));
  updateDriverPanel();
  debugPanel.update();
  eventsPanel.update();
  hitMarks.update(performance.now());
  drive();
  connection.setInterestFocus(camera.controls.target.x, camera.controls.target.z);
  view.updateSun(camera.controls.target, camera.camera.position.distanceTo(camera.controls.target));
  camera.renderWithin(clearDistance(), () => renderer.render(view.scene, camera.camera));
  statsPanel.frameRendered();
});

if (parameters.recording) void playRecording(parameters.recording, download(parameters.recording));
else connection.join(parameters.world);

exposeInspection({
  connection,
  view,
  moduleView,
  pointObjectsView,
  camera,
  driving,
  statsPanel,
  recording: () => recorded,
  prediction: () => prediction,
  controllableEntities: () => controllable.map(({ id }) => id),
});
