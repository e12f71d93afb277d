// Which moment of the world a picture shows, for servers that judge what is aimed at by what was seen (Aim.seen,
// CastRaysRequest.seen). The C++ client library has the same (jostle/client/rendered_time.h).

const RENDERING_TIMEOUT_US = 1_000_000;
const EXTRAPOLATE_US = 50_000; // as rendered_poses.ts

/** `renderTimeUs`: of RenderClock; 0, or more than a second before the newest frame: nobody draws, so what is known is the newest
 * frame. Pictures go on for 50 ms after it, not longer. */
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
