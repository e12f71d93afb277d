/** The channel that says how bodies move (proto/WIRE.md, "Channels"): who predicts asks for it. */
export const MOTION = 'jostle.motion';
