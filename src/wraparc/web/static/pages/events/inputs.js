// The inputs of drives in time: what moves, how each drum is driven, what happens.
import { app, get, set } from "../../base/design.js";
import { changeNaming } from "../../base/removed.js";
import { field, more, section } from "../../parts/field.js";
import { h } from "../../vendor/preact.js";

/** @import { Path, Spec } from "../../types.d.ts" */

/** Fields that are seen at once; the others are folded away. */
const FIRST = ["conveyor_mass", "inertia", "run"];
const KINDS = "control ";
/** @type {Record<string, string>} */
const WORDS = {
  "exact-speed": "exact speed",
  droop: "droop",
  "speed-loop": "speed controller",
  induction: "induction motor on line",
  "fluid-coupling": "motor with fluid coupling",
  follower: "follows the torque of another drive",
};
/** @param {Spec} s @param {Path} path @param {any} [more] */
const make = (s, path, more) => field({ spec: s, path, page: "e", slider: false, ...more });

export const motionInputs = () => [
  h(
    "fieldset",
    { key: "motion" },
    h("legend", {}, "What moves"),
    rows(section("motion"), ["motion"], {
      load_case: {
        choices: [
          {
            choices: [
              ["", "the running case of maximum Te"],
              ...(app.doc.load_case || []).map((c) => [c.name || "", c.name || ""]),
            ],
          },
        ],
      },
    }),
  ),
  app.doc.pulley.map((p, i) => drum(p.name || "", i)),
];
/** @param {Spec[]} specs @param {Path} at @param {Record<string, any>} [how] */
function rows(specs, at, how = {}) {
  const row = (/** @type {Spec} */ s) => make(s, [...at, s.key], how[s.key]);
  const given = (/** @type {Spec} */ s) => get(app.doc, [...at, s.key]) != null;
  const first = specs.filter((s) => FIRST.includes(s.key) || s.required);
  const rest = specs.filter((s) => !first.includes(s));
  return [first.map(row), more("More", rest.map(row), rest.some(given), `more-${at.join()}`)];
}
/** @param {string} name @param {number} i */
function drum(name, i) {
  const at = ["motion", "drum", name];
  const specs = section("motion_drum").filter((s) => i > 0 || s.key !== "run");
  return h(
    "fieldset",
    { key: name },
    h("legend", {}, `Pulley ${name}`),
    rows(specs, at),
    control(name, [...at, "control"]),
  );
}
/** @param {string} name @param {Path} at */
function control(name, at) {
  const kinds = app.form.sections
    .filter((s) => s.key.startsWith(KINDS))
    .map((s) => s.key.slice(KINDS.length));
  const kind = get(app.doc, [...at, "kind"]) || "";
  const others = app.doc.pulley.map((p) => p.name || "").filter((n) => n !== name);
  const put = (/** @type {string | undefined} */ k) => {
    const more = k === "follower" && others.length > 0 ? { master: others[0] } : {};
    changeNaming(set(app.doc, at, k ? { kind: k, ...more } : undefined), ["kind"]);
  };
  const choices = [["", "droop of 1 %"], ...kinds.map((k) => [k, WORDS[k] || k])];
  const given = { title: "Driven by", key: "kind", kind: "choice", help: "How it is driven." };
  return [
    make(given, [...at, "kind"], { choices: [{ choices }], put, key: "kind" }),
    kind &&
      rows(section(KINDS + kind), at, {
        master: { choices: [{ choices: others.map((n) => [n, n]) }] },
      }),
  ];
}
/** Events of the design, or the usual ones. @returns {[string, string][]} */
export function events() {
  const own = app.doc.motion?.event;
  const names = Array.isArray(own) && own.length ? own.map((e) => e?.name || "") : USUAL;
  return names.map((n) => [n, n]);
}
const USUAL = ["start", "start and stop"];
export const assumed = () => !app.doc.motion?.event?.length;
