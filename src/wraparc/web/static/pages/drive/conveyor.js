// The conveyor in the place of tensions: its resistances give the pull of every load case.

import { app, set } from "../../base/design.js";
import { changeNaming } from "../../base/removed.js";
import { written } from "../../base/units.js";
import { field, more, parted, section } from "../../parts/field.js";
import { h } from "../../vendor/preact.js";
import { conveyorCases, conveyorTrains } from "../train/convert.js";
import { lists, replaced } from "./flights.js";
import { without } from "./load.js";
import { known } from "./solving.js";

/** @import { Children, Design } from "../../types.d.ts" */
/** @import { Now } from "./inputs.js" */

/** Fields that are seen at once; the others are folded away. */
const FIRST = [
  "length",
  "lift",
  "capacity",
  "belt_mass",
  "carry_idler_mass",
  "return_idler_mass",
  "take_up_tension",
  "counterweight",
  "start_factor",
  "stop_time",
];

/** Put a conveyor in the place of the tensions. */
export function describe() {
  const { load_case: _, ...rest } = app.doc;
  changeNaming({ ...rest, conveyor: { lift: "0 m" }, pulley: [without(app.doc.pulley[0])] });
  document.getElementById("more")?.setAttribute("open", "");
  requestAnimationFrame(() => document.getElementById("f-conveyor-length")?.focus());
}
/** A drive with the tensions of the load case shown, where no others are known.
 * @param {any} doc @param {ReturnType<Now>} numbers @returns {Design} */
function withShown(doc, numbers) {
  let next = doc;
  for (const key of ["entry_tension", "exit_tension"])
    if (numbers) next = set(next, ["pulley", 0, key], written(numbers[key], "force", 5));
  return next;
}
/** @param {Now} now @returns {Children[]} */
export function conveyor(now) {
  if (app.doc.conveyor) return given(now);
  if (app.doc.train || app.doc.pulley.length > 1 || !section("conveyor").length) return [];
  return [
    h(
      "button",
      { type: "button", id: "describe-conveyor", key: "describe", onClick: describe },
      "Tensions from the conveyor",
    ),
  ];
}
/** @param {Now} now @returns {Children[]} */
function given(now) {
  const own = section("conveyor").filter((s) => !replaced().includes(s.key));
  const [first, others] = parted(own, FIRST);
  const long = app.units === "us" ? "ft" : "m"; // what is said of a conveyor
  const row = (/** @type {any} */ s) => {
    const inUnit = s.dimension === "length" ? long : undefined;
    return field({ spec: s, path: ["conveyor", s.key], slider: false, placeholder: "", inUnit });
  };
  const remove = () => {
    const { conveyor: _, ...rest } = app.doc;
    const { name = "" } = rest.pulley[0];
    const arcs = known()?.arcs ?? [];
    const load_case = rest.train
      ? conveyorTrains(app.doc, arcs)
      : conveyorCases(app.doc, arcs).map(([of, ends]) => ({ ...of, pulley: { [name]: ends } }));
    changeNaming(load_case.length ? { ...rest, load_case } : withShown(rest, now()));
    requestAnimationFrame(() => document.getElementById("describe-conveyor")?.focus());
  };
  return [
    h(
      "p",
      { class: "help", key: "help" },
      "By DIN 22101 and ISO 5048; the load cases full, empty, start and stop follow from it.",
    ),
    ...first.map(row),
    more("More of the conveyor", others.map(row), undefined, "conveyor"),
    ...lists(),
    h("button", { type: "button", key: "remove", onClick: remove }, "Give the tensions themselves"),
  ];
}
