// Read-only state of the viewer as window.jostle, for browser tests and the console.

import { nowUs, type Connection, type RecordedStream } from '@jostle/client';
import type { WorldStats } from '@jostle/client/gen/play_pb';
import type { PredictionController } from '@jostle/client/prediction';
import * as THREE from 'three';
import type { Camera } from './camera/camera';
import type { People } from './people/people';
import type { Driving } from './interaction/driving';
import type { ModuleView } from './module_renderers/module_view';
import type { FrameTimes } from './ui/frame_times';
import type { PointObjectsView } from './point_objects/point_objects_view';
import type { JointView } from './scene/joint_view';
import type { Room } from './room/room';
import type { Sandbox } from './sandbox/sandbox';
import type { SceneView } from './scene/scene_view';
import type { UnitKind } from './scene/shape_parts';
import { heightAt } from './scene/water';

export interface Inspected {
  readonly people: People;
  readonly connection: Connection;
  readonly view: SceneView;
  readonly moduleView: ModuleView;
  readonly pointObjectsView: PointObjectsView;
  readonly camera: Camera;
  readonly driving: Driving;
  readonly frameTimes: FrameTimes;
  readonly jointView: JointView;
  readonly sandbox: Sandbox;
  readonly room: Room;
  stats(): WorldStats | undefined;
  qualityName(): string;
  recording(): RecordedStream | undefined;
  prediction(): PredictionController | undefined;
  controllableEntities(): number[];
}

export function exposeInspection(inspected: Inspected): void {
  const { connection, view, moduleView, pointObjectsView, camera, driving, frameTimes, jointView, sandbox, people, room } = inspected;
  const { stats, qualityName, recording, prediction, controllableEntities } = inspected;
  /** Position of a point of the world on the page, in pixels. */
  const toScreen = (x: number, y: number, z: number) => {
    camera.camera.updateMatrixWorld();
    const p = new THREE.Vector3(x, y, z).project(camera.camera);
    return { x: ((p.x + 1) / 2) * innerWidth, y: ((1 - p.y) / 2) * innerHeight };
  };
  const value = {
    get state() {
      return connection.state;
    },
    /** Tick of the newest frame; 0 before the first. */
    get tick() {
      return connection.frames.newest?.frame ?? 0;
    },
    get entityCount() {
      return connection.frames.newest?.entities.length ?? 0;
    },
    /** Drawn point objects. */
    get pointObjectCount() {
      return pointObjectsView.count;
    },
    /** Rendered points of a point object (x y z ...) by its index; undefined: there is none. */
    pointsOf: (index: number) => {
      const object = [...connection.points.objects.values()][index];
      return object?.hasPoints ? [...object.positions.subarray(0, 3 * object.count)] : undefined;
    },
    /** Number of drawn joints. */
    get jointCount() {
      return jointView.count;
    },
    /** Ids of the joints of the world. */
    jointIds: () => [...connection.joints.joints.keys()],
    /** The selected body or joint; undefined: none. */
    get selected() {
      return sandbox.selection.current;
    },
    /** The inspected body or joint as the server sent it last; undefined: none. */
    get inspected() {
      const response = sandbox.newestInspection;
      return response?.body ?? response?.joint;
    },
    /** Number of vertices of the marks of the selection. */
    get selectionVertexCount() {
      return sandbox.selectionView.lines.count;
    },
    /** The settings and bans of the room as the client received them; undefined: the world is no room. */
    get room() {
      return connection.data.room;
    },
    /** Number of vertices of the drawn protected areas. */
    get areaVertexCount() {
      return room.areaVertexCount;
    },
    /** Attributes of an entity by key. */
    attributesOf: (id: number) => Object.fromEntries([...connection.data.attributesOf({ kind: 'entity', id })].map(([key, { value }]) => [key, typeof value.value === 'bigint' ? Number(value.value) : value.value])),
    get snapshots() {
      return connection.snapshots;
    },
    /** The other players as this page shows them. */
    get people() {
      return people.inspect();
    },
    /** Assigned by the server; 0: not connected yet. */
    get clientId() {
      return connection.welcome?.clientId ?? 0;
    },
    /** Number of resumed connections. */
    get resumed() {
      return connection.resumed;
    },
    get decodeErrors() {
      return connection.decodeErrors;
    },
    get stats() {
      return stats();
    },
    /** Durations of the script of rendered frames in ms, without drawing. */
    get frameScript() {
      return { frames: frameTimes.frames, median: frameTimes.percentile(0.5), p90: frameTimes.percentile(0.9) };
    },
    resetFrameScript: () => frameTimes.reset(),
    get quality() {
      return qualityName();
    },
    get planar() {
      return camera.planar;
    },
    /** Target of the camera: x y z, and its distance in m. */
    get cameraTarget() {
      return [...camera.controls.target.toArray(), camera.distance];
    },
    /** The tick of an input made now; 0: unknown. */
    get inputTick() {
      return connection.inputClock.ready ? connection.inputClock.tick(nowUs()) : 0;
    },
    /** Playback state; undefined: a live world. */
    get recording() {
      const stream = recording();
      return stream && { tick: stream.tick, seconds: stream.seconds, length: stream.length, playing: stream.playing };
    },
    /** Followed body and statistics of prediction; undefined: disabled or not loaded. */
    get prediction() {
      const controller = prediction();
      return controller && { followed: controller.followed, sent: controller.sent, late: controller.late, ...controller.stats };
    },
    /** 0: none. */
    get controlledEntity() {
      return driving.entity;
    },
    controllableEntities,
    dynamicBodies: () => [...connection.entities.values()].filter((entity) => entity.mass > 0).map((entity) => entity.id),
    entityName: (id: number) => connection.entities.get(id)?.name,
    /** Rendered pose: px py pz qx qy qz qw. */
    poseOf: (id: number) => {
      const pose = view.poseOf(id);
      return pose ? [...pose] : undefined;
    },
    /** Position of an entity on the page, in pixels. */
    screenPosition: (id: number) => {
      const pose = view.poseOf(id);
      return pose && toScreen(pose[0]!, pose[1]!, pose[2]!);
    },
    toScreen,
    /** Number of rendered parts of each kind. */
    partCounts: () => view.partCounts(),
    /** Number of lines that modules rendered in the last frame. */
    moduleLineCount: () => moduleView.lines.count / 2,
    /** Number of solids that modules rendered in the last frame. */
    moduleSolidCount: () => moduleView.solids.count,
    /** Matrix of one of these solids: 16 numbers, by columns. */
    moduleSolidMatrix: (kind: UnitKind, index: number) => [...moduleView.solids.matrixOf(kind, index).elements],
    /** Height in m of each rendered water surface at a position. */
    waterHeights: (x: number, z: number) => moduleView.water.surfaces.map((surface) => heightAt(surface, x, z)),
  };
  Object.defineProperty(window, 'jostle', { value });
}
