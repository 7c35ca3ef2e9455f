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

function solved({ law, geometry, load, points, parts }) {
  const { entry_tension, exit_tension, pressure_min, pressure_max, slip_max } = load;
  const found = kernel.answer__operating_point(law, geometry, entry_tension, exit_tension);
  const capacities = parts
    ? [...kernel.capacity__find_capacities(law, geometry, load, parts)]
    : [];
  if (found.outcome !== 0) return { outcome: found.outcome, capacities };
  const [out, count] = kernel.profile__records(geometry, found.met, points);
  const tested = { pressure_min, pressure_max, slip_max };
  return {
    outcome: found.outcome,
    count,
    read: [...kernel.profile__read(geometry, found.met, tested)],
    records: [...out.slice(0, 5 * count)],
    capacities,
  };
}
process.stdout.write(told(read(readFileSync(0, "utf-8")).map(solved)));
