// The one ramp of quantities, in every picture.

/** The colour of a quantity, light for little: of the light page, the dark one and of paper.
 * @param {number} t a share of the most */
export function colour(t) {
  const x = Math.max(0, Math.min(1, t)) * 3;
  const i = Math.min(2, Math.floor(x));
  return `color-mix(in srgb, var(--q${i + 1}) ${Math.round(100 * (x - i))}%, var(--q${i}))`;
}
/** The colour of a quantity with a limit: the ramp ends there, what exceeds it is orange.
 * @param {number} v @param {number} most @param {number} limit 0 for none */
export const shade = (v, most, limit) =>
  limit && v > limit ? "var(--warn-fill)" : colour(v / (limit || most || 1));
