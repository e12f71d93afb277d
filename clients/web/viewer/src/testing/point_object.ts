// Point objects for tests.

import { create, type MessageInitShape } from '@bufbuild/protobuf';
import { PointObjectView } from '@jostle/client';
import { PointObjectSchema } from '@jostle/client/gen/play_pb';

/** An object with sampled positions, which did not come from a server. */
export function pointObject(description: MessageInitShape<typeof PointObjectSchema>, positions: number[]): PointObjectView {
  const made = new PointObjectView(create(PointObjectSchema, { stepUm: 1000, ...description }), 1);
  Object.defineProperty(made, 'hasPoints', { value: true });
  made.positions = Float32Array.from(positions);
  made.count = positions.length / 3;
  return made;
}
