// The inputs of a drive: load first, then pulley, lagging, belt, load cases, the drive as a whole.

import { app, get, painted, redraw, set } from "../../base/design.js";
import { changeNaming, putLagging } from "../../base/removed.js";
import { part } from "../../base/server.js";
import { viewed, words } from "../../base/units.js";
import { field, idOf, spec } from "../../parts/field.js";
import { TENSIONS } from "../../parts/problems.js";
import { h } from "../../vendor/preact.js";
import { byCase } from "./cases.js";
import { shownCase, switched } from "./condition.js";
import { caseAt, keysOf, takenOver } from "./load.js";
import { scaleOf } from "./ranges.js";

/** @import { Path, Spec } from "../../types.d.ts" */
/** @import { Choice, Choices } from "../../parts/field.js" */

/** Pairs of tension, pull, power and torque that give the load. */
export const PAIRS = ["01", "02", "12", "03", "13", "04", "14"].map((pair) =>
  [...pair].map((k) => TENSIONS[+k]),
);
/** @typedef {() => Record<string, number> | null} Now numbers of the last answer for this pulley */

/**
 * By which quantities the load of a pulley is given that is shown, and where; none where the train
 * or the conveyor gives it.
 * @param {number} i
 */
export function givenLoad(i) {
  const k = byCase() ? shownCase(i) : -1;
  if (k >= 0) return { k, at: caseAt(app.doc, i, k), keys: shownKeys(keysOf(app.doc, i, k), k) };
  const given = TENSIONS.filter((t) => app.doc.pulley[i][t] !== undefined);
  if (app.doc.conveyor || (app.doc.train && !given.length)) return null;
  return { k, at: /** @type {Path} */ (["pulley", i]), keys: shownKeys(given, k) };
}
/** What was shown last: a box that is typed in stays while it is empty. */
let last = { of: "", keys: /** @type {string[]} */ ([]) };
/** @param {string[]} given @param {number} k load case */
function shownKeys(given, k) {
  const at = k < 0 ? ["pulley", app.pulley] : caseAt(app.doc, app.pulley, k);
  const of = at.join();
  const typed = (/** @type {string} */ key) =>
    document.activeElement?.id.slice(1) === idOf([...at, key], "");
  if (last.of !== of || !last.keys.some((key) => !given.includes(key) && typed(key)))
    last = { of, keys: pairAt(given) < 0 ? [...new Set([...PAIRS[0], ...given])] : given };
  return last.keys;
}
/** @param {string[]} keys */
export const pairAt = (keys) => PAIRS.findIndex((p) => p.join() === keys.join());
/** The boxes of the load. @param {number} i @param {string} [page] */
export function loadBoxes(i, page) {
  const of = givenLoad(i);
  return of?.keys.map((key) => {
    const over = of.k < 0 ? undefined : takenOver(app.doc, i, of.k, key);
    const path = [...of.at, key];
    const s = spec("tensions", key);
    return field({ spec: s, path, placeholder: over, scale: scaleOf(key), page, slider: !page });
  });
}
/** @param {number} i @param {string} key */
const ofPulley = (i, key, label = "") =>
  field({
    spec: spec("pulley", key),
    path: ["pulley", i, key],
    assumed: isAssumed(["pulley", i, key]),
    label: label || undefined,
    scale: scaleOf(key),
  });
/** What the word beside the choice says. */
const MADE_UP = " (illustrative)";
/** @param {any} l @returns {string} */
export const laggingName = (l) => (l && typeof l === "object" ? l.preset || l.name || "" : l || "");
/** @param {number} i @returns {Choices[]} */
export function laggingChoices(i) {
  const own = Object.keys(app.doc.lagging || {});
  const now = laggingName(app.doc.pulley[i].lagging);
  const known = own.includes(now) || app.catalogue.laggings.some((l) => l.name === now);
  return [
    ...(known ? [] : [{ choices: [/** @type {Choice} */ ([now, now || "choose"])] }]),
    ...(own.length
      ? [
          {
            group: "of this design",
            choices: own.map((n) => /** @type {Choice} */ ([n, app.doc.lagging?.[n].title || n])),
          },
        ]
      : []),
    {
      group: "catalogue",
      choices: app.catalogue.laggings.map(
        (l) => /** @type {Choice} */ ([l.name, (l.title || l.name).replace(MADE_UP, "")]),
      ),
    },
  ];
}
/** The lagging of a pulley by name, and what is known of where its numbers come from.
 * @param {number} i */
function laggingPick(i) {
  /** @type {Path} */
  const at = ["pulley", i, "lagging"];
  const kind = catalogued(i)?.kind;
  const condition = switched(i);
  return h(
    "div",
    { class: condition ? "pick-row both" : "pick-row", key: "lagging" },
    field({
      spec: spec("pulley", "lagging"),
      path: at,
      label: "Lagging",
      assumed: isAssumed(at),
      choices: laggingChoices(i),
      read: () => laggingName(get(app.doc, at)),
      put: (name) => putLagging(i, name),
    }),
    kind && h("span", { class: `kind ${kind}` }, kind),
    condition,
  );
}
/** @param {number} i */
export const catalogued = (i) =>
  app.catalogue.laggings.find((x) => x.name === laggingName(app.doc.pulley[i].lagging));
/** @param {Spec} s */
export const ofBelt = (s) =>
  field({
    spec: s,
    path: ["belt", s.key],
    assumed: isAssumed(["belt", s.key]),
    placeholder: ofPreset(s.key) ?? undefined,
    scale: scaleOf(s.key),
  });
const presetBelt = () => app.catalogue.belts.find((b) => b.name === app.doc.belt.preset);
/** @param {string} key @returns {string | undefined} */
const ofPreset = (key) => words(presetBelt()?.[key]) || undefined;
function preset() {
  const { belts } = app.catalogue;
  const groups = [...new Set(belts.map((b) => b.kind))].map((kind) => ({
    group: kind || "other",
    choices: belts
      .filter((b) => b.kind === kind)
      .map((b) => /** @type {Choice} */ ([b.name, b.name])),
  }));
  const own = app.doc.belt.preset;
  const named = own && !presetBelt() ? [{ group: "by its name", choices: [[own, own]] }] : [];
  return field({
    spec: spec("belt", "preset"),
    path: ["belt", "preset"],
    label: "Belt",
    assumed: isAssumed(["belt", "preset"]),
    choices: /** @type {Choices[]} */ ([{ choices: [["", "own values"]] }, ...named, ...groups]),
    put: putBelt,
  });
}
/** A preset brings its own numbers: those typed over the last one go, and are named.
 * @param {string | undefined} name */
export function putBelt(name) {
  const {
    modulus,
    modulus_test,
    modulus_loads,
    rating,
    least_pulley_diameter,
    name: _,
    kind,
    sources,
    provenance,
    preset: __,
    ...kept
  } = app.doc.belt;
  const own = modulus || ofPreset("modulus");
  const next = name ? { preset: name, ...kept } : { ...kept, ...(own && { modulus: own }) };
  changeNaming(set(app.doc, ["belt"], next), ["preset"]);
}

/** What is turned less, fetched behind the first page. */
const late = { more: /** @type {typeof import("./more.js") | null} */ (null) };
painted().then(async () => {
  late.more = await part(() => import("./more.js")).catch(() => null);
  redraw();
});
/** The form of the drive page: what is turned most, and all else below it. @param {Now} now */
export function inputs(now) {
  const i = app.pulley;
  return h(
    "form",
    {
      class: "inputs rail card",
      "aria-label": "Drive",
      onSubmit: (e) => e.preventDefault(),
      noValidate: true,
    },
    h("h2", {}, "Inputs", h("span", {}, assumed()[0] ? "italic: assumed" : "green: passes")),
    loadBoxes(i),
    ofPulley(i, "wrap_angle"),
    laggingPick(i),
    h("div", { class: "pick-row", key: "belt" }, preset()),
    ofPulley(i, "diameter", "Diameter"),
    ofBelt(spec("belt", "width")),
    h(
      "details",
      { class: "more", id: "more", key: "more" },
      h("summary", {}, "More inputs"),
      late.more?.moreInputs(i, now),
    ),
    also(),
  );
}
const isAssumed = (/** @type {Path} */ at) => late.more?.isAssumed(at) ?? false;
/** Values of a new drive that nobody has touched, as texts. @returns {string[]} */
export const assumed = () => late.more?.assumed() ?? [];
/** Some of what is not turned here, to be seen. */
function also() {
  const { belt, creep_limit, take_up, design_standard } = app.doc;
  /** @type {[Spec, any][]} */
  const rows = [
    [spec("belt", "speed"), belt.speed],
    [spec("belt", "modulus"), belt.modulus ?? ofPreset("modulus")],
    [spec("drive", "creep_limit"), creep_limit ?? spec("drive", "creep_limit").default],
    [spec("take_up", "kind"), take_up?.kind],
    [spec("design_standard", "name"), design_standard?.name],
  ];
  const seen = (/** @type {Spec} */ s, /** @type {any} */ v) =>
    s.dimension ? viewed(v, s.dimension).join(" ") : String(v);
  return h(
    "dl",
    { class: "kv", key: "also" },
    rows
      .filter(([, v]) => v != null && v !== "")
      .map(([s, v]) => h("div", { key: s.key }, h("dt", {}, s.title), h("dd", {}, seen(s, v)))),
  );
}
