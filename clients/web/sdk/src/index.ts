/**
 * Client library of the Jostle physics server: joins a world, renders smooth poses and sends inputs.
 * README.md has an example.
 *
 * Units: m, kg, s, rad, N. Rotations are unit quaternions x y z w. Times with the suffix Us are
 * microseconds; "local clock" is nowUs(), "server's clock" is that of Welcome.epochUs. Entities are
 * numbers from 1 that are never reused in a world; 0 is none.
 *
 * The messages of the protocol are in `@jostle/client/gen/play_pb` and its siblings, prediction is in
 * `@jostle/client/prediction`.
 *
 * @packageDocumentation
 */

// A client of one world: the usual entry point.
export { Client, connect, ConnectError, type BodyEdit, type CloneOptions, type ConnectOptions, type NewJoint, type RoomCommand, type Vector } from './client.js';

// The parts of a client, for applications with their own render loop.
export { nowUs } from './clock/clock_sync.js';
export {
  type AreaOfInterest,
  type Precision,
  Connection,
  openSocket,
  type ConnectionListener,
  type ConnectionOptions,
  type ConnectionState,
  type Input,
  type PredictionListener,
  type Socket,
} from './connection/connection.js';
export { JointList, type ListedJoint } from './connection/joint_list.js';
export { WorldData, type AttributeTarget, type AttributeValue } from './connection/world_data.js';
export { FrameBuffer, POSE_FLOATS, type PoseFrame } from './interpolation/frame_buffer.js';
export { PointObjects, PointObjectView } from './interpolation/point_objects.js';
export { RenderedPoses } from './interpolation/rendered_poses.js';
export { subdivideGrid, subdivideMesh, subdivideStrand, type TriangleMesh } from './interpolation/subdivision.js';
export { type PointLayout } from './snapshot/point_layout.js';
export { MOTION_CHANNEL, NO_CHANNELS, type Channel, type Channels } from './snapshot/channels.js';

// Queries about the joined world.
export { postToServer, Queries, withToken, type Post } from './queries/queries.js';

// Playback of recordings.
export { RecordedStream } from './recording/recorded_stream.js';
export { Recording, RecordingError, type DamagedRange, type RecordedMessage } from './recording/recording.js';

// Simulated network conditions.
export { IDEAL_NETWORK, NetworkSimulator, isImpaired, type Delivery, type NetworkConditions, type Transit } from './network_simulator/network_simulator.js';
export { simulatedSocket } from './network_simulator/simulated_socket.js';
