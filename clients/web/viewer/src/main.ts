// Starts the parts and runs the picture loop.

import * as THREE from 'three';
import {
  areaOfInterestFromQuery,
  Connection,
  type Events,
  MOTION,
  networkConditionsFromQuery,
  NO_CHANNELS,
  nowUs,
  openSocket,
  postToServer,
  Queries,
  RecordedStream,
  Recording,
  RenderedPoses,
  simulatedSocket,
  type State,
} from '@jostle/client';
import { Camera } from './camera/camera';
import type { Entity } from '@jostle/client/gen/play_pb';
import { Driving, cameraYaw, type Pad } from './interaction/driving';
import { DebugView } from './scene/debug_view';
import { HitMarks } from './scene/hit_marks';
import { unobstructedDistance, topAt } from './interaction/pick';
import { RENDERED_CHANNEL_KINDS, ModuleView, type RenderedChannels } from './module_renderers/module_view';
import type { PredictionController } from '@jostle/client/prediction';
import { DebugPanel } from './panels/debug';
import { drawArrows, DriverPanel, offerText } from './panels/driver';
import { EventsPanel } from './panels/events';
import { TimelinePanel } from './panels/timeline';
import { StatsPanel } from './panels/stats';
import { Toasts } from './panels/toasts';
import { WorldsPanel } from './panels/worlds';
import type { UnitKind } from './scene/shape_parts';
import { takeToken } from './token';
import { SceneView } from './scene/scene_view';
import { describePick, entityName } from './panels/entity_names';
import { TOOLS, Tools, type Tool } from './interaction/tools';
import { heightAt } from './scene/water';
import './style.css';

const byId = <T extends HTMLElement>(id: string) => document.getElementById(id) as T;

const canvas = byId<HTMLCanvasElement>('view');
const stateLine = byId('state');
// ?quality=medium: no shadows, no smooth edges, nothing blurred behind panels; ?quality=low: a quarter of the pixels each way as
// well. For machines without a graphics processor.
const quality = new URLSearchParams(location.search).get('quality') ?? 'high';
document.documentElement.dataset['quality'] = quality;
const renderer = new THREE.WebGLRenderer({ canvas, antialias: quality === 'high' });
renderer.shadowMap.enabled = quality === 'high';
renderer.shadowMap.type = THREE.PCFShadowMap;
renderer.toneMapping = THREE.ACESFilmicToneMapping;

const camera = new Camera(canvas);
const view = new SceneView();
const drawn = new RenderedPoses();
const toasts = new Toasts(byId('toasts'));

const STATE_WORDS: Record<State, string> = {
  connecting: 'connecting …',
  playing: '',
  waiting: 'trying again …',
  stopped: '',
};

const token = takeToken(
  { hash: location.hash, replaceHash: (hash) => history.replaceState(null, '', location.pathname + location.search + (hash && `#${hash}`)) },
  sessionStorage,
);
const connectionEvents: Events = {
  state: (state, why) => {
    const name = connection.welcome?.worldName ?? '';
    stateLine.textContent = state === 'playing' ? `in ${name}` : [why, STATE_WORDS[state]].filter(Boolean).join(' — ');
    stateLine.className = state;
    if (state === 'stopped' && why) void worlds.show();
  },
  entityList: (entities) => {
    view.setEntities(entities, connection.welcome?.clientId ?? 0);
    controllable = recorded ? [] : [...entities.values()].filter((entity) => entity.controllable);
    entitiesChanged = true;
    if (!entities.has(driving.entity)) driving.forget();
  },
  stats: (stats) => statsPanel.update(stats),
  worldEvents: (events) => eventsPanel.addEvents(events, performance.now() + renderDelayMs()),
  inputRejected: (result) => toasts.say(result.message || 'the server refused that'),
  notice: (text) => toasts.say(text),
};
// ?delay=80&jitter=20&stalls=250: as over a bad link.
const networkConditions = networkConditionsFromQuery(location.search);
const open = networkConditions ? simulatedSocket(openSocket, networkConditions) : openSocket;
// What is played instead of a live world.
let recorded: RecordedStream | undefined;
// ?predict=1: what a hand holds or a push hits answers at once.
const predicts = new URLSearchParams(location.search).get('predict') === '1';
const kinds = predicts ? [...RENDERED_CHANNEL_KINDS, MOTION] : RENDERED_CHANNEL_KINDS;
// ?sight=150&kbps=500: what is within 150 m of where one looks, and no more than that.
const connection = new Connection(websocketUrl(), connectionEvents, (url) => (recorded ? recorded.open() : open(url)), token, kinds, areaOfInterestFromQuery(location.search));
let prediction: PredictionController | undefined;
async function enablePrediction(): Promise<void> {
  const without = (error: unknown) => {
    prediction = undefined;
    toasts.say(`nothing is predicted: ${error instanceof Error ? error.message : error}`);
  };
  try {
    const { loadPrediction } = await import('@jostle/client/prediction');
    prediction = await loadPrediction(connection.frames, without);
    connection.enablePrediction(prediction);
  } catch (error) {
    without(error);
  }
}
if (predicts) void enablePrediction();
const statsPanel = new StatsPanel(byId('stats'), connection);
const queries = new Queries(() => (connection.state === 'playing' && !recorded ? (connection.welcome?.worldId ?? '') : ''), postToServer(token));
const readout = byId('readout');
const driving = new Driving((input) => connection.send(input));
let controllable: Entity[] = [];
let entitiesChanged = false;
let framedWorld: string | undefined; // whose whole the camera was turned to
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
    if (!connection.entities.get(entity)?.controllable) return toasts.say('nobody can drive that');
    takeControl(entity);
  },
  (x, y, z, radius) => moduleView.blasts.add(x, y, z, radius, performance.now()),
);
const driverPanel = new DriverPanel(byId('driver'), takeControl, () => driving.stopControlling());
const debugPanel = new DebugPanel(byId('debug'), queries, new DebugView(view.scene), view);
const hitMarks = new HitMarks(view.scene);
const moduleView = new ModuleView(view.scene);
const eventsPanel = new EventsPanel(
  byId('events'),
  hitMarks,
  (wanted) => connection.setEventsEnabled(wanted),
  (id) => entityName(connection.entities.get(id), id),
);
const worlds = new WorldsPanel(
  byId('worlds'),
  (world) => {
    play(undefined);
    connection.join(world);
  },
  (text) => toasts.say(text),
  () => connection.welcome?.worldId ?? '',
  token,
);

function websocketUrl(): string {
  const url = new URL('play', location.href);
  url.protocol = location.protocol === 'https:' ? 'wss:' : 'ws:';
  url.search = url.hash = '';
  return url.href;
}

let renderTimeUs = 0; // by the picture, on the server's clock

/** How far the picture is behind the newest that the server told. */
function renderDelayMs(): number {
  const newest = connection.frames.newest;
  return newest ? Math.max(0, (newest.serverUs - renderTimeUs) / 1000) : 0;
}

const timeline = new TimelinePanel(byId('timeline'));

/** undefined: a live world again. */
function play(stream: RecordedStream | undefined): void {
  recorded = stream;
  timeline.show(stream);
  tools.enabled = stream === undefined;
  document.documentElement.toggleAttribute('data-recording', stream !== undefined);
}

async function playRecording(name: string, bytes: Promise<ArrayBuffer>): Promise<void> {
  try {
    const recording = new Recording(new Uint8Array(await bytes));
    if (recording.truncationReason) toasts.say(`${name} is played as far as it goes: ${recording.truncationReason}`);
    driving.stopControlling();
    play(new RecordedStream(recording));
    connection.join('');
  } catch (error) {
    toasts.say(`${name}: ${error instanceof Error ? error.message : error}`);
  }
}

addEventListener('dragover', (event) => event.preventDefault());
addEventListener('drop', (event) => {
  event.preventDefault();
  const file = event.dataTransfer?.files[0];
  if (file) void playRecording(file.name, file.arrayBuffer());
});

async function fetched(url: string): Promise<ArrayBuffer> {
  const answer = await fetch(url);
  if (!answer.ok) throw new Error(`the server answers ${answer.status}`);
  return answer.arrayBuffer();
}

function choose(tool: Tool): void {
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
  button.onclick = () => choose(tool);
  byId('tools').append(button);
}
choose('drag');

byId('help').innerHTML = `<h2>How to play</h2><dl>${TOOLS.map(
  ({ key, label, hint }) => `<dt><kbd>${key}</kbd> ${label}</dt><dd>${hint}</dd>`,
).join('')}<dt>Camera</dt><dd>Drag the ground to turn, right button to shift, wheel to zoom; two fingers on touch</dd>
<dt><kbd>D</kbd></dt><dd>Debug view: what the solver sees</dd>
<dt><kbd>E</kbd></dt><dd>Events: what happens, in words (joins the world anew)</dd>
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
  if (driving.down(event.code)) return event.preventDefault();
  if (recorded && event.key === ' ' && event.target === document.body) timeline.toggle();
  const chosen = TOOLS.find(({ key }) => key === event.key);
  if (chosen) choose(chosen.tool);
  if (event.key === 'w') void worlds.toggle();
  if (event.key === 's') toggle('stats');
  if (event.key === 'd') toggle('debug');
  if (event.key === 'e') eventsPanel.toggle();
  if (event.key === '?') toggle('help');
});

addEventListener('keyup', (event) => driving.up(event.code));
addEventListener('blur', () => driving.blur());

/** Where an entity heads, seen from above: its own -z axis. */
function headingOf(pose: ArrayLike<number>): number {
  const [x, y, z, w] = [pose[3]!, pose[4]!, pose[5]!, pose[6]!];
  return Math.atan2(2 * (x * z + w * y), 1 - 2 * (x * x + y * y));
}

function takeControl(entity: number): void {
  driving.take(entity);
  camera.settle(moduleView.steeringOf(entity)?.distance ?? 8);
}

let pictureAt = performance.now();
function drive(): void {
  const now = performance.now();
  const seconds = Math.min(0.5, (now - pictureAt) / 1000);
  pictureAt = now;
  if (driving.entity === 0) return;
  const pad: Pad | undefined = navigator.getGamepads().find((one) => one !== null && one.mapping === 'standard') ?? undefined;
  driving.update(pad, cameraYaw(camera.camera.getWorldDirection(new THREE.Vector3())), now);
  const pose = view.poseOf(driving.entity);
  if (!pose) return;
  // Who goes where the camera looks leaves the camera to the pointer.
  const behind = moduleView.steeringOf(driving.entity)?.camera !== 'free';
  camera.follow(pose, behind ? headingOf(pose) : undefined, seconds);
}

/** Of who walks, who goes near walls. */
function clearDistance(): number {
  if (driving.entity === 0 || moduleView.steeringOf(driving.entity)?.camera !== 'free') return Infinity;
  return unobstructedDistance(view, camera.controls.target, camera.camera.position, driving.entity);
}

/** A world that is new to us is seen as a whole at first. */
function frameWorld(): void {
  const world = connection.welcome?.worldId;
  if (connection.state !== 'playing' || world === framedWorld || drawn.count === 0) return;
  framedWorld = world;
  camera.frame(view.outline());
  // Not under a hill.
  const { position } = camera.camera;
  const ground = topAt(view, position.x, position.z);
  if (ground !== undefined) position.y = Math.max(position.y, ground + 3);
}

/** What modules tell with the frame that is drawn. */
function renderedChannels(): RenderedChannels {
  const { frame = 0, channels = NO_CHANNELS } = drawn.source ?? {};
  const { channels: kinds = [], tickHz = 60 } = connection.welcome ?? {};
  return { frame, channels, secondsAfter: drawn.seconds, kinds, tickHz };
}

function drawModules(shown: RenderedChannels): void {
  moduleView.debug = debugPanel.on.fields;
  moduleView.update(shown, {
    nowMs: performance.now(),
    around: camera.controls.target,
    poseOf: (entity) => view.poseOf(entity),
    entityOf: (entity) => connection.entities.get(entity),
    decorate: (solids) => {
      if (tools.tool === 'drive' && driving.entity === 0) drawArrows(solids, controllable, (entity) => view.poseOf(entity), performance.now());
    },
  });
}

function colorBodies(shown: RenderedChannels): void {
  const colors = moduleView.bodyColors(shown, entitiesChanged, connection.entities);
  entitiesChanged = false;
  if (colors) view.setBodyColors(colors);
}

function updateDriverPanel(): void {
  driverPanel.update(
    {
      choosing: tools.tool === 'drive',
      driven: connection.entities.get(driving.entity),
      keys: moduleView.steeringOf(driving.entity)?.keys ?? '',
      words: moduleView.controlledStatusText(driving.entity),
      general: moduleView.statusText() || offerText(controllable),
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
  drawn.update(connection.frames, renderTimeUs, now);
  if (!recorded) prediction?.draw(drawn, connection.inputClock.position(now), now);
  timeline.update();
  const shown = renderedChannels();
  colorBodies(shown);
  view.update(drawn);
  frameWorld();
  drawModules(shown);
  updateDriverPanel();
  debugPanel.update();
  eventsPanel.update();
  hitMarks.update(performance.now());
  drive();
  connection.setInterestFocus(camera.controls.target.x, camera.controls.target.z);
  view.updateSun(camera.controls.target, camera.camera.position.distanceTo(camera.controls.target));
  camera.within(clearDistance(), () => renderer.render(view.scene, camera.camera));
  statsPanel.frameRendered();
});

// ?recording=URL plays one, as dropping a file does.
const recordingUrl = new URLSearchParams(location.search).get('recording');
if (recordingUrl) void playRecording(recordingUrl, fetched(recordingUrl));
else connection.join(new URLSearchParams(location.search).get('world') ?? '');

// A window for tests: read-only.
Object.defineProperty(window, 'jostle', {
  value: {
    get state() {
      return connection.state;
    },
    get tick() {
      return connection.frames.newest?.frame ?? 0;
    },
    get entities() {
      return connection.frames.newest?.entities.length ?? 0;
    },
    get snapshots() {
      return connection.snapshots;
    },
    /** Who the server says that we are; 0: nobody yet. */
    get client() {
      return connection.welcome?.clientId ?? 0;
    },
    /** How often it came back as who it was. */
    get resumed() {
      return connection.resumed;
    },
    get decodeErrors() {
      return connection.decodeErrors;
    },
    get stats() {
      return statsPanel.latest;
    },
    /** Which tick an input of now is meant for; 0: not known yet. */
    get inputTick() {
      return connection.inputClock.ready ? connection.inputClock.tick(nowUs()) : 0;
    },
    /** Of the recording that is played. */
    get recording() {
      return recorded && { tick: recorded.tick, seconds: recorded.seconds, length: recorded.length, playing: recorded.playing };
    },
    /** What is foreseen: whom, and how well; undefined: nothing, or not yet. */
    get prediction() {
      return prediction && { followed: prediction.followed, sent: prediction.sent, late: prediction.late, ...prediction.stats };
    },
    /** Ids of dynamic bodies that the scene made. */
    loose: () => [...connection.entities.values()].filter((e) => e.mass > 0).map((e) => e.id),
    /** How many parts of each kind are in the scene. */
    parts: () => view.partCounts(),
    /** How many lines modules have drawn in this picture. */
    moduleLines: () => moduleView.lines.count / 2,
    /** How many solid things modules have drawn. */
    moduleSolids: () => moduleView.solids.count,
    /** Where one of them is: 16 numbers, by columns. */
    solid: (kind: UnitKind, number: number) => [...moduleView.solids.matrixOf(kind, number).elements],
    /** How high each water that is drawn stands over a place, in m. */
    waters: (x: number, z: number) => moduleView.water.drawn.map((look) => heightAt(look, x, z)),
    controllable: () => controllable.map(({ id }) => id),
    /** Whom this page drives; 0: nobody. */
    get driven() {
      return driving.entity;
    },
    nameOf: (id: number) => connection.entities.get(id)?.name,
    pose: (id: number) => {
      const pose = view.poseOf(id);
      return pose ? [...pose] : undefined;
    },
    /** Where an entity is on the page, in pixels. */
    screen: (id: number) => {
      const pose = view.poseOf(id);
      if (!pose) return undefined;
      const p = new THREE.Vector3(pose[0], pose[1], pose[2]).project(camera.camera);
      return { x: ((p.x + 1) / 2) * innerWidth, y: ((1 - p.y) / 2) * innerHeight };
    },
  },
});
