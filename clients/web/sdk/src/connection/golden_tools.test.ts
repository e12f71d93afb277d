// proto/golden/sandbox_tools.jmsg (proto/WIRE.md): inputs that build and control time, and inspections.

import { readFileSync } from 'node:fs';
import { create, fromBinary, toBinary, type MessageInitShape } from '@bufbuild/protobuf';
import { expect, it } from 'vitest';
import { ClientMessageSchema, InputSchema } from '../gen/jostle/v1/play_pb.js';
import { InspectResponseSchema } from '../gen/jostle/v1/query_pb.js';

const bytes = readFileSync(new URL('../../../../../proto/golden/sandbox_tools.jmsg', import.meta.url));
const messages: { kind: number; data: Uint8Array }[] = [];
for (let at = 12, left = bytes.readUInt32LE(8); left > 0; left--) {
  const size = bytes.readUInt32LE(at + 4);
  messages.push({ kind: bytes.readUInt32LE(at), data: bytes.subarray(at + 8, at + 8 + size) });
  at += 8 + size;
}

it('has a message with inputs and two inspections', () => {
  expect(bytes.subarray(0, 4).toString()).toBe('JMSG');
  expect(messages.map(({ kind }) => kind)).toEqual([0, 1, 1]);
  expect(messages.reduce((sum, { data }) => sum + 8 + data.length, 12)).toBe(bytes.length);
});

it('has the bytes that this client writes for the inputs', () => {
  const hinge = { limit: { lower: -1, upper: 1.25 }, motorSpeed: 2, motorMaxTorque: 300 };
  const joint = {
    frame: { position: { y: 3 }, rotation: { x: 1 } },
    kind: { case: 'hinge' as const, value: hinge },
    collideConnected: true,
    breakForce: 5000,
  };
  const edit = {
    entity: 12,
    position: { x: 1.5, y: -2, z: 0.25 },
    rotation: { y: 1 },
    linearVelocity: { y: 4 },
    angularVelocity: { x: -0.5 },
    mass: 20,
    friction: 0,
    restitution: 0.75,
    color: 0xff8000,
    frozen: false,
    gravityScale: -0.5,
  };
  const inputs: MessageInitShape<typeof InputSchema>[] = [
    { kind: { case: 'edit' as const, value: edit } },
    { kind: { case: 'clone' as const, value: { entity: 12, offset: { x: 2, z: -1 }, jointed: true } } },
    { kind: { case: 'createJoint' as const, value: { entityB: 12, joint } } },
    { kind: { case: 'deleteJoint' as const, value: { joint: 300 } } },
    { kind: { case: 'undo' as const, value: {} } },
    { kind: { case: 'room' as const, value: { kind: { case: 'step' as const, value: { steps: 60 } } } } },
    { kind: { case: 'room' as const, value: { kind: { case: 'speed' as const, value: { percent: 25 } } } } },
    { kind: { case: 'room' as const, value: { kind: { case: 'rewind' as const, value: { tick: 1234 } } } } },
  ];
  const message = create(ClientMessageSchema, { message: { case: 'input', value: { firstSequence: 7, inputs: inputs.map((input) => create(InputSchema, input)) } } });
  expect(Buffer.from(toBinary(ClientMessageSchema, message)).toString('hex')).toBe(Buffer.from(messages[0]!.data).toString('hex'));
});

it('has the inspections that WIRE.md lists', () => {
  const [body, joint] = messages.slice(1).map(({ data }) => fromBinary(InspectResponseSchema, data));
  expect(body).toMatchObject({
    tick: 1234,
    body: { entity: 12, name: 'crate', owner: 3, mass: 20, kineticEnergy: 296, gravityScale: -0.5, island: 4, islandBodies: 2, contactCount: 300 },
  });
  expect(body!.body!.contacts[0]).toMatchObject({ entity: 4, otherShape: 2, points: [{ separation: -0.0009765625, impulse: 3.25 }, { impulse: 0 }] });
  expect(joint).toMatchObject({
    tick: 1235,
    joint: { id: 300, entityA: 0, entityB: 12, owner: 3, force: 5, torque: 2, coordinate: 0.5, joint: { breakForce: 5000, kind: { case: 'hinge' } } },
  });
});
