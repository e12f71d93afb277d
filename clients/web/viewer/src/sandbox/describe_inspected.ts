// The state of a body or joint as labelled values.

import type { InspectedBody, InspectedJoint } from '@jostle/client/gen/query_pb';
import type { Entity } from '@jostle/client/gen/play_pb';
import type { Quat, Vec3 } from '@jostle/client/gen/common_pb';
import { formatValue as formatPlotted } from './line_plot';

export type Row = readonly [label: string, value: string];

const DEGREES = 180 / Math.PI;

/** Four significant digits without zeros at the end. */
function formatValue(value: number): string {
  const text = formatPlotted(value);
  return /^-?\d+\.\d+$/.test(text) ? text.replace(/\.?0+$/, '') : text;
}

export function vectorText(v: Vec3 | undefined, digits = 2): string {
  const { x = 0, y = 0, z = 0 } = v ?? {};
  return [x, y, z].map((value) => fixed(value, digits)).join(', ');
}

/** Without a negative zero. */
function fixed(value: number, digits: number): string {
  const text = value.toFixed(digits);
  return Number(text) === 0 ? text.replace('-', '') : text;
}

/** The angle of a rotation and its axis. */
export function rotationText(q: Quat | undefined): string {
  const { x = 0, y = 0, z = 0, w = 1 } = q ?? {};
  const sine = Math.hypot(x, y, z);
  const degrees = 2 * Math.atan2(sine, Math.abs(w)) * DEGREES;
  if (degrees < 0.05) return '0°';
  const sign = w < 0 ? -1 : 1;
  return `${degrees.toFixed(1)}° about ${[x, y, z].map((value) => fixed((sign * value) / sine, 2)).join(', ')}`;
}

const length = (v: Vec3 | undefined) => Math.hypot(v?.x ?? 0, v?.y ?? 0, v?.z ?? 0);

export interface Names {
  ofEntity(id: number): string;
  ofClient(id: number): string;
}

export function bodyRows(body: InspectedBody, hz: number, names: Names): Row[] {
  const dynamic = body.mass > 0;
  const [material] = body.materials;
  return [
    ['Owner', body.owner === 0 ? 'the scene' : names.ofClient(body.owner)],
    ['Position', `${vectorText(body.position)} m`],
    ['Rotation', rotationText(body.rotation)],
    ...(dynamic
      ? ([
          ['Velocity', `${vectorText(body.linearVelocity)} m/s`],
          ['Speed', `${formatValue(length(body.linearVelocity))} m/s`],
          ['Spin', `${vectorText(body.angularVelocity)} rad/s`],
          ['Mass', `${formatValue(body.mass)} kg`],
          ['Inertia', `${[body.inertiaX?.x ?? 0, body.inertiaY?.y ?? 0, body.inertiaZ?.z ?? 0].map(formatValue).join(', ')} kg\u00a0m²`],
          ['Kinetic energy', `${formatValue(body.kineticEnergy)} J`],
          ['Gravity scale', formatValue(body.gravityScale)],
          ['State', body.asleep ? 'asleep' : 'awake'],
          ['Island', body.island === 0 ? 'none' : `${body.island} · ${count(body.islandBodies, 'body', 'bodies')}`],
        ] as Row[])
      : ([['State', body.frozen ? 'frozen' : 'static']] as Row[])),
    ...(material
      ? ([
          ['Density', `${formatValue(material.density)} kg/m³`],
          ['Friction', formatValue(material.friction)],
          ['Restitution', formatValue(material.restitution)],
        ] as Row[])
      : []),
    ['Contacts', contactsText(body, hz)],
  ];
}

function contactsText({ contacts, contactCount }: InspectedBody, hz: number): string {
  if (contactCount === 0) return 'none';
  const impulse = contacts.flatMap(({ points }) => points).reduce((sum, point) => sum + point.impulse, 0);
  return `${contactCount} · ${formatValue(impulse * hz)} N in total`;
}

function count(n: number, one: string, many: string): string {
  return `${n} ${n === 1 ? one : many}`;
}

const JOINT_NAMES: Record<string, string> = { coneTwist: 'cone twist', sixDof: 'six degrees of freedom', fixed: 'weld', velocityRow: 'velocity row' };
const COORDINATE_UNITS: Record<string, readonly [string, string]> = { hinge: ['Angle', 'rad'], slider: ['Travel', 'm'], distance: ['Length', 'm'] };

export function jointKindName(kind: string | undefined): string {
  return kind === undefined ? 'ball' : (JOINT_NAMES[kind] ?? kind);
}

export function jointRows(joint: InspectedJoint, names: Names): Row[] {
  const kind = joint.joint?.kind.case;
  const coordinate = COORDINATE_UNITS[kind ?? ''];
  const { breakForce = 0, breakTorque = 0 } = joint.joint ?? {};
  const motor = joint.joint?.kind.case === 'hinge' || joint.joint?.kind.case === 'slider' ? joint.joint.kind.value.motorSpeed : undefined;
  return [
    ['Kind', jointKindName(kind)],
    ['Bodies', `${joint.entityA === 0 ? 'the world' : names.ofEntity(joint.entityA)} and ${names.ofEntity(joint.entityB)}`],
    ['Owner', joint.owner === 0 ? 'the scene' : names.ofClient(joint.owner)],
    ['Anchor', `${vectorText(joint.anchorB)} m`],
    ['Force', `${formatValue(joint.force)} N${breakForce > 0 ? ` of ${formatValue(breakForce)} N` : ''}`],
    ['Torque', `${formatValue(joint.torque)} N m${breakTorque > 0 ? ` of ${formatValue(breakTorque)} N m` : ''}`],
    ...(coordinate ? ([[coordinate[0], `${formatValue(joint.coordinate)} ${coordinate[1]}`]] as Row[]) : []),
    ...(motor === undefined ? [] : ([['Motor speed', `${formatValue(motor)} ${kind === 'hinge' ? 'rad/s' : 'm/s'}`]] as Row[])),
  ];
}

/** What the client knows of a body without the server's response. */
export function entityRows(entity: Entity, pose: ArrayLike<number> | undefined, names: Names): Row[] {
  return [
    ['Owner', entity.owner === 0 ? 'the scene' : names.ofClient(entity.owner)],
    ...(pose ? ([['Position', `${[0, 1, 2].map((k) => fixed(pose[k]!, 2)).join(', ')} m`]] as Row[]) : []),
    ['Mass', entity.mass > 0 ? `${formatValue(entity.mass)} kg` : 'not dynamic'],
    ['Shapes', String(entity.shapes.length)],
  ];
}
