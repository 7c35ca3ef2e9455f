// Solves drives with the kernel of the page: cases as JSON come in, answers go out.
import { readFileSync } from "node:fs";
import * as kernel from "../../src/wraparc/web/static/kernel.js";

const NUMBERS = { nan: Number.NaN, inf: Infinity, "-inf": -Infinity };
const read = (text) =>
  JSON.parse(text, (_, v) => (typeof v === "string" && v in NUMBERS ? NUMBERS[v] : v));
const told = (value) =>
  JSON.stringify(value, (_, v) =>
    typeof v !== "number" || Number.isFinite(v) ? v : v > 0 ? "inf" : v < 0 ? "-inf" : "nan",
  );

function solved({ law, geometry, load, steps, points, parts }) {
  const found = kernel.answer__answer(law, geometry, load, steps);
  const capacities = parts
    ? [...kernel.answer__find_capacities(law, geometry, load, parts, steps)]
    : [];
  if (found.outcome !== 0) return { outcome: found.outcome, capacities };
  const out = new Float64Array(kernel.answer__profile_size(law, found, points));
  const [shot, count] = kernel.answer__profile_of(law, found, load.exit_tension, points, out);
  const { pressure_min, pressure_max, slip_max } = load;
  return {
    outcome: found.outcome,
    count,
    shot: [...shot],
    records: [...out.slice(0, 6 * count)],
    peak: kernel.profile__peak_stress(law, found.par, shot.creep_ratio, out, count),
    active: kernel.profile__active_length(out, count),
    outside: kernel.profile__share_outside(
      found.par, out, count, pressure_min, pressure_max, slip_max,
    ),
    capacities,
  };
}
process.stdout.write(told(read(readFileSync(0, "utf-8")).map(solved)));
