// The tick that the last rendered frame showed, for lag compensation on the server (Aim.view_time,
// CastRaysRequest.view_time). Same as jostle/client/rendered_time.h of the C++ client library.

const RENDERING_TIMEOUT_US = 1_000_000;
const EXTRAPOLATE_US = 50_000; // as in rendered_poses.ts

/**
 * `renderTimeUs`: of RenderClock. If it is 0, or more than 1 s before the newest frame, nothing is
 * rendered and the newest frame counts. The result is at most 50 ms after the newest frame, the limit
 * of extrapolation.
 */
export function renderedTime(
  newest: { frame: number; serverUs: number } | undefined,
  renderTimeUs: number,
  tickHz: number,
): { tick: number; fraction: number } | undefined {
  if (!newest) return undefined;
  const afterUs = Math.min(renderTimeUs - newest.serverUs, EXTRAPOLATE_US);
  if (renderTimeUs === 0 || afterUs < -RENDERING_TIMEOUT_US || !(tickHz > 0)) return { tick: newest.frame, fraction: 0 };
  const tick = Math.max(1, newest.frame + (afterUs * tickHz) / 1e6);
  return { tick: Math.floor(tick), fraction: tick - Math.floor(tick) };
}
