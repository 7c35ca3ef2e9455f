// The drive as it runs steadily: what stands where an event has not run yet.
import { app } from "../../base/design.js";
import { si } from "../../base/units.js";
import { follow } from "../../plots/stage.js";
import { answer, known } from "../drive/solving.js";

/** @import { FullAnswer, FullArc } from "../../types.d.ts" */
/** @import { Drum, Played } from "./course.js" */

const POINTS = 60;
/** @param {number[]} x @param {number[]} y */
function even(x, y) {
  const at = follow(x, y);
  return Array.from({ length: POINTS + 1 }, (_, k) => at(k / POINTS));
}
/** @param {FullArc} arc @returns {Drum} */
function drum({ pulley, numbers: n, profile: p, creep_limit }) {
  const { position } = p;
  const of = app.doc.pulley.find(({ name }) => name === pulley);
  return {
    ...{ name: pulley, creep_limit, belt_thickness: null, speed: [], torque: [], peak_shear: [] },
    diameter: si(of?.diameter, "length") || 1,
    wrap_angle: position[position.length - 1],
    ...{ entry_tension: [n.entry_tension], exit_tension: [n.exit_tension], share: [null] },
    exit_creep: [n.exit_creep],
    creep: [even(position, p.creep)],
    shear: [even(position, p.shear_stress)],
  };
}
/** @type {WeakMap<FullAnswer, {id: string, played: Played} | null>} */
const made = new WeakMap();
let count = 0;
/** @param {FullAnswer} all the load case of the largest tension, where all its arcs are solved */
function playedOf({ arcs }) {
  const [most] = [...arcs].sort((a, b) => b.numbers.entry_tension - a.numbers.entry_tension);
  const here = arcs.filter((a) => a.load_case === most?.load_case);
  if (!here.length || here.some((a) => a.status !== "solved" || !a.profile?.shear_stress))
    return null;
  const still = { duration: 0, time: [0], travel: [0], belt_speed: [0], frame_time: [0] };
  const drums = here.map(drum);
  return {
    id: `steady ${count++}`,
    played: { event: "", outcome: "", ...still, drums, steady: most.load_case },
  };
}
/** The picture of the design, or of before its last change, made once; none while there is none. */
export function steady() {
  const all = known() ?? answer.full;
  if (!all) return null;
  if (!made.has(all)) made.set(all, playedOf(all));
  return made.get(all);
}
