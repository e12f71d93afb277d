/** Channel kind with the velocities of bodies (proto/WIRE.md, "Channels"). Prediction needs it. */
export const MOTION_CHANNEL = 'jostle.motion';
