// Which moment of the world a picture shows, for servers that judge what is aimed at by what was seen (Aim.seen,
// CastRaysRequest.seen). The C++ client library has the same (jostle/client/rendered_time.h).

const NOT_DRAWN_US = 1_000_000;
const EXTRAPOLATE_US = 50_000; // as interpolate.ts

/** `shownUs`: of RenderClock; 0, or more than a second before the newest frame: nobody draws, so what is known is the newest
 * frame. Pictures go on for 50 ms after it, not longer. */
export function shownMoment(
  newest: { frame: number; serverUs: number } | undefined,
  shownUs: number,
  tickHz: number,
): { tick: number; fraction: number } | undefined {
  if (!newest) return undefined;
  const afterUs = Math.min(shownUs - newest.serverUs, EXTRAPOLATE_US);
  if (shownUs === 0 || afterUs < -NOT_DRAWN_US || !(tickHz > 0)) return { tick: newest.frame, fraction: 0 };
  const tick = Math.max(1, newest.frame + (afterUs * tickHz) / 1e6);
  return { tick: Math.floor(tick), fraction: tick - Math.floor(tick) };
}
