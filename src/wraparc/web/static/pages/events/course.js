// A run in time as it is played: what holds at an instant, between the rows and frames kept.

/**
 * @typedef {{name: string, diameter: number, wrap_angle: number, creep_limit: number,
 *   belt_thickness: number | null, entry_tension: number[], exit_tension: number[],
 *   speed: number[], torque: number[],
 *   share: (number | null)[], exit_creep: number[], peak_shear: number[],
 *   creep: number[][], shear: number[][]}} Drum
 * @typedef {{event: string, outcome: string, duration: number, time: number[], travel: number[],
 *   belt_speed: number[], frame_time: number[], drums: Drum[], steady?: string}} Played
 *   steady: the load case, where nothing has run yet
 * @typedef {[number, number]} Between a place in a list and the part of the way to the next
 */

/** Where an instant lies in rising times. @param {number[]} times @param {number} t
 * @returns {Between} */
export function between(times, t) {
  let lo = 0;
  let hi = times.length - 1;
  if (t >= times[hi]) return [Math.max(hi - 1, 0), hi ? 1 : 0];
  while (hi - lo > 1) {
    const mid = (lo + hi) >> 1;
    if (times[mid] <= t) lo = mid;
    else hi = mid;
  }
  return [lo, Math.max(0, (t - times[lo]) / (times[hi] - times[lo] || 1))];
}
/** @param {(number | null)[]} values @param {Between} at */
export function value(values, [i, w]) {
  const a = values[i];
  const b = values[i + 1] ?? a;
  return a == null || b == null ? Number.NaN : a + w * (b - a);
}
/** A picture of the wrap between two frames. @param {number[][]} frames @param {Between} at */
export function wrap(frames, [i, w]) {
  const b = frames[i + 1] ?? frames[i];
  return frames[i].map((a, k) => a + w * (b[k] - a));
}
/** Angles that a drum has turned by at the rows [rad]. @param {Played} run @param {Drum} drum */
export function angles(run, drum) {
  const found = [0];
  for (let i = 1; i < run.time.length; i++)
    found.push(
      found[i - 1] + 0.5 * (run.time[i] - run.time[i - 1]) * (drum.speed[i] + drum.speed[i - 1]),
    );
  return found;
}
/** Largest size in frames. @param {number[][][]} of */
export const largest = (of) => {
  let most = 0;
  for (const frames of of)
    for (const row of frames) for (const v of row) most = Math.max(most, Math.abs(v));
  return most || 1;
};
