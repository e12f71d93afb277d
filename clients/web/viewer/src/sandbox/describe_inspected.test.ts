import { create } from '@bufbuild/protobuf';
import { InspectedBodySchema, InspectedJointSchema } from '@jostle/client/gen/query_pb';
import { expect, it } from 'vitest';
import { bodyRows, jointRows, rotationText, vectorText } from './describe_inspected';

const names = { ofEntity: (id: number) => `box ${id}`, ofClient: (id: number) => `client ${id}` };

it('contact impulses of a step are shown as a force', () => {
  const points = [{ impulse: 0.1 }, { impulse: 0.0635 }];
  const body = create(InspectedBodySchema, { entity: 4, owner: 2, mass: 1, island: 3, islandBodies: 1, contactCount: 1, contacts: [{ points }] });
  const rows = new Map(bodyRows(body, 60, names));
  expect(rows.get('Contacts')).toBe('1 · 9.81 N in total');
  expect(rows.get('Island')).toBe('3 · 1 body');
  expect(rows.get('Owner')).toBe('client 2');
});

it('a static body has no velocity', () => {
  const rows = new Map(bodyRows(create(InspectedBodySchema, { entity: 4 }), 60, names));
  expect(rows.get('State')).toBe('static');
  expect(rows.has('Velocity')).toBe(false);
});

it('a hinge shows its angle, motor and breaking force', () => {
  const joint = { breakForce: 500, kind: { case: 'hinge' as const, value: { motorSpeed: 2 } } };
  const rows = new Map(jointRows(create(InspectedJointSchema, { id: 1, entityB: 5, joint, force: 120, coordinate: 0.5 }), names));
  expect(rows.get('Bodies')).toBe('the world and box 5');
  expect(rows.get('Force')).toBe('120 N of 500 N');
  expect(rows.get('Angle')).toBe('0.5 rad');
  expect(rows.get('Motor speed')).toBe('2 rad/s');
});

it('rotations and vectors are text', () => {
  const q = (x: number, y: number, z: number, w: number) => ({ $typeName: 'jostle.v1.Quat', x, y, z, w }) as const;
  expect(rotationText(q(0, 0, 0, 1))).toBe('0°');
  expect(rotationText(q(0, -Math.SQRT1_2, 0, -Math.SQRT1_2))).toBe('90.0° about 0.00, 1.00, 0.00');
  expect(vectorText({ $typeName: 'jostle.v1.Vec3', x: 1, y: -0.001, z: -2.345 })).toBe('1.00, 0.00, -2.35');
});
