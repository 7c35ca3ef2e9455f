// Which value of an input gives a wanted result: asked of the server, used with one press.
import { app, change, get, redraw, set } from "../../base/design.js";
import { act, ask } from "../../base/server.js";
import { dimensionOf, title, trim, unit, viewed, words, written } from "../../base/units.js";
import { standing } from "../../parts/answers.js";
import { choose, valueIn } from "../../parts/choose.js";
import { spec } from "../../parts/field.js";
import { Plot } from "../../parts/plot.js";
import { again, attempt } from "../../parts/question.js";
import { badge, refused, stands } from "../../parts/tables.js";
import { h } from "../../vendor/preact.js";
import { askedCase } from "./cases.js";
import { shownCase } from "./condition.js";
import { caseAt, keysOf, takenOver } from "./load.js";
import { answer } from "./solving.js";

/** @import { ChartData, Level, Path, Problem, Spec, Text } from "../../types.d.ts" */
/**
 * @typedef {{value: number, shown: Text, level: Level, label: string, text: Text}} Value
 * @typedef {{sentence: Text, found: Value[], tried: number[], results: (number | null)[]}} Found
 * @typedef {{path: Path, spec: Spec}} Input
 */

/** Results that can be wanted, the usual first. */
const RESULTS = ["exit_creep", "creep_limit_margin", "peak_shear_stress", "peak_shear_angle"]
  .concat(["exit_slip", "power_loss", "gross_slip_safety", "tested_slip_margin", "active_arc"])
  .concat(["equivalent_friction", "least_exit_tension", "mean_friction", "wear_rate"]);
const OF_PULLEY = ["wrap_angle", "diameter", "overrun"];
const OF_BELT = ["width", "modulus", "speed"];
const OF_LAGGING = ["thickness", "shear_modulus", "compression_modulus"];
const LOADS = ["entry_tension", "exit_tension", "effective_tension", "power", "torque"];

const state = {
  open: false,
  at: "",
  result: RESULTS[0],
  wanted: "",
  busy: false,
  lost: false,
  problems: /** @type {Problem[]} */ ([]),
  found: /** @type {Found | null} */ (null),
  /** Of what document and question it was found. */
  of: "",
};
/** Inputs of the drive that can be sought. @returns {Input[]} */
function inputs() {
  const i = app.pulley;
  const pulley = app.doc.pulley[i];
  const k = shownCase(i);
  const given = k < 0 ? LOADS.filter((key) => pulley[key] != null) : keysOf(app.doc, i, k);
  const load = k < 0 ? ["pulley", i] : caseAt(app.doc, i, k);
  /** @param {string} section @param {string[]} keys @param {Path} at */
  const of = (section, keys, at) =>
    keys.map((key) => ({ path: [...at, key], spec: spec(section, key) }));
  return [
    ...of("pulley", OF_PULLEY, ["pulley", i]),
    ...of("tensions", given, load),
    ...of("lagging", OF_LAGGING, ["pulley", i, "lagging"]),
    ...of("belt", OF_BELT, ["belt"]),
  ];
}
/** Open it for an input. @param {Path} [path] */
export function open(path) {
  Object.assign(state, { open: true, at: path?.join() ?? "", found: null, problems: [] });
  if (!state.wanted) offer();
  redraw();
  requestAnimationFrame(() => {
    const box = /** @type {HTMLInputElement | null} */ (document.getElementById("seek-value"));
    box?.scrollIntoView({ block: "center" });
    box?.select();
  });
}
/** What the result is now, as a first value to be changed. */
function offer() {
  const [u, f] = unit(dimensionOf(state.result));
  const now = answer.quick?.numbers[state.result];
  state.wanted = now == null ? "" : `${trim(now / f, 3)} ${u}`.trim();
}
/** @returns {Input} */
const input = () => inputs().find((x) => x.path.join() === state.at) ?? inputs()[0];
const BARE = /^[A-Za-z0-9_-]+$/;
/** A place as `--set` has it. @param {Path} path */
const keyPath = ([first, i, ...rest]) =>
  [first, first === "belt" ? i : (app.doc[first][+i].name ?? ""), ...rest]
    .map((step) => (BARE.test(String(step)) ? step : JSON.stringify(step)))
    .join(".");
/** What holds where the drive, or the load case, says nothing. @param {Input} of */
function otherwise({ path }) {
  const key = String(path[path.length - 1]);
  if (path[0] === "load_case") return takenOver(app.doc, app.pulley, +path[1], key);
  const { belt, pulley } = app.doc;
  const lagging = pulley[app.pulley].lagging;
  const from =
    path[0] === "belt"
      ? app.catalogue.belts.find((b) => b.name === belt.preset)
      : app.catalogue.laggings.find((l) => l.name === (lagging?.preset ?? lagging));
  return words(from?.[key]);
}
/** A wanted value with the unit that is shown beside it, if it has none. */
function wanted() {
  const text = state.wanted.trim();
  const [u] = unit(dimensionOf(state.result));
  return /^[-+.\de]+$/i.test(text) ? `${text} ${u}`.trim() : text;
}
const question = () => ({
  document: app.doc,
  field: keyPath(input().path),
  result: state.result,
  value: wanted(),
  pulley: app.doc.pulley[app.pulley].name ?? "",
  load_case: askedCase() ?? "",
  now: get(app.doc, input().path) == null ? otherwise(input()) : "",
});
const find = () =>
  attempt(state, async () => {
    const asked = question();
    state.found = null;
    state.found = await ask("seek", asked);
    state.of = JSON.stringify(asked);
  });
again(state, () => state.open, find);
/** Put a found value into the drive. @param {Value} v */
function use(v) {
  const { path, spec: s } = input();
  const text = written(v.value, s.dimension ?? "number");
  const at = path.slice(0, -1);
  const held = get(app.doc, at);
  // a lagging of the catalogue becomes a table that is based on it
  const doc = typeof held === "string" ? set(app.doc, at, { preset: held }) : app.doc;
  change(set(doc, path, text));
}
/** The card, where it is open. */
export function panel() {
  if (!state.open) return null;
  const shut = () => {
    state.open = false;
    redraw();
  };
  return h(
    "section",
    { class: "card seek", "aria-label": "Goal seek", key: "seek" },
    h("h2", {}, "Which value gives a wanted result?"),
    h(
      "form",
      {
        class: "bar",
        onSubmit: (/** @type {Event} */ e) => {
          e.preventDefault();
          act(find)(e);
        },
      },
      choices(),
      h("button", { class: "main" }, "Find"),
      h("button", { type: "button", onClick: shut }, "Close"),
      h("span", { role: "status" }, state.busy && "Searching …"),
    ),
    state.problems.length > 0 && refused("", state.problems),
    state.found && found(state.found),
  );
}
function choices() {
  const forget = (/** @type {Partial<typeof state>} */ now) => {
    Object.assign(state, now, { found: null });
    redraw();
  };
  const names = inputs().map(
    (x) => /** @type {[string, string]} */ ([x.path.join(), x.spec.title]),
  );
  const value = {
    type: "text",
    id: "seek-value",
    size: 10,
    value: state.wanted,
    autocomplete: "off",
    onInput: (/** @type {Event} */ e) => forget({ wanted: valueIn(e) }),
  };
  const results = RESULTS.map((name) => /** @type {[string, string]} */ ([name, title(name)]));
  const other = (/** @type {string} */ result) => {
    state.result = result;
    offer();
    forget({});
  };
  return [
    h(
      "label",
      { key: "in" },
      "Input",
      choose(input().path.join(), names, (at) => forget({ at })),
    ),
    h("label", { key: "out" }, "Result", choose(state.result, results, other, "seek-result")),
    h("label", { key: "value" }, "is to be", h("input", value)),
  ];
}
/** @param {Found} f */
function found(f) {
  const stale = state.of !== JSON.stringify(question());
  return stands(
    standing(!stale, state.problems, state.busy),
    h("p", { role: "status" }, h("strong", {}, words(f.sentence))),
    f.found.map((v) =>
      h(
        "p",
        { class: "inline", key: v.value },
        h(
          "button",
          { type: "button", class: "main", onClick: () => use(v) },
          `Use ${words(v.shown)}`,
        ),
        badge(v.level, v.label),
        h("span", { class: "help" }, words(v.text)),
      ),
    ),
    h(Plot, { data: chart(f), key: `${state.of}${app.units}`, ...look() }),
  );
}
const look = () => {
  const { spec: s } = input();
  const [u] = unit(s.dimension ?? "number");
  return { title: `${title(state.result)} over ${s.title}`, xlabel: `${s.title} [${u || "-"}]` };
};
/** @type {{found: Found | null, units: string, data: ChartData | null}} */
let drawn = { found: null, units: "", data: null };
/** How many times the wanted result, or that of now, is drawn at most. */
const FAR = 3;
/** The result over the range that was tried. @param {Found} f @returns {ChartData} */
function chart(f) {
  if (drawn.data && drawn.found === f && drawn.units === app.units) return drawn.data;
  const [, fx] = unit(input().spec.dimension ?? "number");
  const [u, fy] = unit(dimensionOf(state.result));
  const [to] = viewed(wanted(), dimensionOf(state.result));
  const now = answer.quick?.numbers[state.result] ?? 0;
  const most = FAR * Math.max(Math.abs(+to), Math.abs(now / fy));
  const seen = (/** @type {number | null} */ v) => v != null && Math.abs(v / fy) <= most;
  const data = {
    x: f.tried.map((v) => v / fx),
    lines: [{ y: f.results.map((v) => (seen(v) ? Number(v) / fy : null)), cls: "blue" }],
    ylabel: `[${u || "-"}]`,
    limit: { y: +to, label: `wanted ${wanted()}` },
    points: f.found.map((v) => /** @type {[number, number]} */ ([v.value / fx, +to])),
  };
  drawn = { found: f, units: app.units, data };
  return data;
}
