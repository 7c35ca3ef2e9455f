// The inputs of a drive: load first, then pulley, lagging, belt, load cases, the drive as a whole.

import { app, change, edit, get, set } from "../../base/design.js";
import { nameCheck, renamePulley } from "../../base/names.js";
import { choose } from "../../parts/choose.js";
import { field, idOf, more, parted, section, spec } from "../../parts/field.js";
import { TENSIONS } from "../../parts/problems.js";
import { h } from "../../vendor/preact.js";
import { add, inCase, loadInCase, shared } from "./cases.js";
import { sideBySide, switched } from "./condition.js";
import { conveyor } from "./conveyor.js";
import { criteria } from "./criteria.js";
import { fromExample } from "./from_example.js";
import { givenBy } from "./load.js";

/** @import { Children, Path, Spec } from "../../types.d.ts" */
/** @import { Choice, Choices } from "../../parts/field.js" */

/** Pairs of tension, pull, power and torque that give the load. */
const PAIRS = ["01", "02", "12", "03", "13", "04", "14"].map((pair) =>
  [...pair].map((k) => TENSIONS[+k]),
);
/** @param {string} key */
const tensionSpec = (key) => spec("tensions", key);
/** @param {string} title @param {Children[]} rows */
export const group = (title, rows, key = title) =>
  h("fieldset", { key }, h("legend", {}, title), rows);
/** @typedef {() => Record<string, number> | null} Now numbers of the last answer for this pulley */

/** Whether load cases give tensions beside those of the pulleys. */
const byCase = () => app.doc.load_case && !app.doc.conveyor && !app.doc.train;
/** The load of a pulley itself: of the conveyor, of the train, or as given.
 * @param {number} i @param {Now} [now] */
export function ownLoad(i, now = () => null) {
  const of = byCase() && (isCase() ? "design" : "shared by all load cases");
  const rows = [...(app.doc.conveyor ? [] : load(i)), ...conveyor(now)];
  return group(of ? `Load: ${of}` : "Load", rows, "Load");
}
/** Whether the tensions of the pulleys make a load case, as they do where they are whole. */
export function isCase() {
  const { pulley, belt } = app.doc;
  const given = pulley.map((p) => [
    p.entry_tension != null,
    p.exit_tension != null,
    (p.effective_tension ?? p.torque ?? (belt.speed != null ? p.power : null)) != null,
  ]);
  for (const _ of [...given, ...given])
    given.forEach((g, i) => {
      g[0] ||= (g[1] && g[2]) || given[i - 1]?.[1];
      g[1] ||= (g[0] && g[2]) || given[i + 1]?.[0];
    });
  return given.every((g) => g[0] && g[1]);
}
/** Which two of tension, pull, power and torque are given. @param {number} i */
function load(i) {
  const p = app.doc.pulley[i];
  const given = TENSIONS.filter((t) => p[t] !== undefined);
  if (app.doc.train && !given.length)
    return [h("p", { class: "help" }, "The train gives the tensions: see the page Train.")];
  return loadRows(["pulley", i], given, (keys) => give(i, keys));
}
/** What was shown last: a box that is typed in stays while it is empty. */
let last = { of: "", keys: /** @type {string[]} */ ([]) };
/**
 * By which quantities a load is given, and their boxes.
 * @param {Path} at @param {string[]} given @param {(keys: string[]) => void} put
 * @param {(key: string) => string} [over] of an empty box @returns {Children[]}
 */
export function loadRows(at, given, put, over) {
  const pair = (/** @type {string[]} */ keys) => PAIRS.findIndex((p) => p.join() === keys.join());
  const of = at.join();
  const typed = (/** @type {string} */ k) => document.activeElement?.id === idOf([...at, k]);
  if (last.of !== of || !last.keys.some((k) => !given.includes(k) && typed(k)))
    last = { of, keys: pair(given) < 0 ? [...new Set([...PAIRS[0], ...given])] : given };
  const id = idOf(at, "pair");
  const pick = choose(
    Math.max(0, pair(last.keys)),
    PAIRS.map((keys, k) => [k, keys.map(sign).join(" and ")]),
    (k) => put(PAIRS[+k]),
    id,
  );
  return [
    h(
      "div",
      { class: "field", key: "pair" },
      h("label", { for: id }, "Load given by"),
      h("span", {}),
      h("span", { class: "box" }, pick),
    ),
    ...last.keys.map((k) =>
      field({ spec: tensionSpec(k), path: [...at, k], placeholder: over?.(k) }),
    ),
  ];
}
/** @param {string} key */
const sign = (key) => tensionSpec(key).symbol || tensionSpec(key).title;
/** Give the same load by two other numbers. @param {number} i @param {string[]} keys */
const give = (i, keys) => change(givenBy(app.doc, i, keys));

/** @param {number} i */
function pulley(i) {
  const skip = ["name", "lagging", "condition", ...TENSIONS];
  const fields = section("pulley").filter((f) => !skip.includes(f.key) && f.kind !== "table");
  const [main, rest] = parted(fields, ["diameter", "wrap_angle"]);
  const row = (/** @type {Spec} */ f) => field({ spec: f, path: ["pulley", i, f.key] });
  return [...main.map(row), more("More of the pulley", [pulleyName(i), ...rest.map(row)])];
}
/** @param {number} i @param {string} [page] */
export const pulleyName = (i, page) =>
  field({
    spec: spec("pulley", "name"),
    path: ["pulley", i, "name"],
    page,
    put: (name) => renamePulley(i, name),
    check: nameCheck(
      "pulley",
      app.doc.pulley.filter((_, k) => k !== i).map((p) => p.name),
    ),
  });

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
        (l) => /** @type {Choice} */ ([l.name, l.title || l.name]),
      ),
    },
  ];
}
/** Another lagging on a pulley: a condition of the one before means nothing for it.
 * @param {number} i @param {string} name */
export const putLagging = (i, name) =>
  change(
    set(
      set(app.doc, ["pulley", i, "lagging"], name || undefined),
      ["pulley", i, "condition"],
      undefined,
    ),
  );

/** Numbers of a lagging that a design may give in place of the catalogue's. */
const PARTS = ["thickness", "shear_modulus", "compression_modulus"].concat([
  "bond_strength",
  "fatigue_limit",
]);
/** @param {number} i */
function lagging(i) {
  /** @type {Path} */
  const at = ["pulley", i, "lagging"];
  const now = laggingName(get(app.doc, at));
  const known = app.catalogue.laggings.find((x) => x.name === now);
  const parts = PARTS.map((key) => laggingPart(at, key, known?.[key]?.[app.units]));
  const whole = field({
    spec: spec("pulley", "lagging"),
    path: at,
    label: "Lagging",
    choices: laggingChoices(i),
    read: () => laggingName(get(app.doc, at)),
    put: (name) => putLagging(i, name),
  });
  return [
    whole,
    switched(i),
    known &&
      h(
        "p",
        { class: "origin", key: "origin" },
        h("span", { class: `mark ${known.kind}` }, known.kind),
        ` ${(known.source || "").replace(`${known.kind}: `, "")}`,
      ),
    more("Lagging in detail", parts, typeof get(app.doc, at) === "object"),
  ];
}
/** A number of the lagging that the design may give in place of the catalogue's.
 * @param {Path} at @param {string} key @param {string | undefined} placeholder */
const laggingPart = (at, key, placeholder) =>
  field({
    spec: spec("lagging", key),
    path: [...at, key],
    slider: key === "thickness" ? undefined : false,
    placeholder: placeholder || "",
    read: () => {
      const v = get(app.doc, at);
      return v && typeof v === "object" ? v[key] : undefined;
    },
    put: (value) => {
      const v = get(app.doc, at);
      const next = { ...(v && typeof v === "object" ? v : { preset: v }), [key]: value };
      if (value === undefined) delete next[key];
      edit(at, Object.keys(next).join() === "preset" ? next.preset : next);
    },
  });

function belt() {
  const skip = ["preset", "table"];
  const fields = section("belt").filter(
    (f) => !skip.includes(f.key) && !["table", "belt"].includes(f.kind),
  );
  const [main, rest] = parted(fields, ["width", "speed", "modulus"]);
  const row = (/** @type {Spec} */ f) =>
    field({ spec: f, path: ["belt", f.key], placeholder: ofPreset(f.key) ?? undefined });
  return [preset(), ...main.map(row), more("More of the belt", rest.map(row))];
}
const presetBelt = () => app.catalogue.belts.find((b) => b.name === app.doc.belt.preset);
/** @param {string} key @returns {string | undefined} */
const ofPreset = (key) => presetBelt()?.[key]?.[app.units];
function preset() {
  const { belts } = app.catalogue;
  const groups = [...new Set(belts.map((b) => b.kind))].map((kind) => ({
    group: kind || "other",
    choices: belts
      .filter((b) => b.kind === kind)
      .map((b) => /** @type {Choice} */ ([b.name, b.name])),
  }));
  return field({
    spec: spec("belt", "preset"),
    path: ["belt", "preset"],
    label: "Belt",
    choices: [{ choices: [["", "own values"]] }, ...groups],
    put: putBelt,
  });
}
/** A preset brings its own numbers: those typed over the last one would silently stay.
 * @param {string | undefined} name */
function putBelt(name) {
  const {
    modulus,
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
  change(set(app.doc, ["belt"], next));
}

function cases() {
  if (app.doc.conveyor && !app.doc.load_case) return [sideBySide(app.pulley)];
  const list = app.doc.load_case || [];
  return [
    sideBySide(app.pulley),
    h("p", { class: "help", key: "help" }, HELP),
    shared(),
    ...list.map((c, k) => more(c.name || `case ${k + 1}`, inCase(k), undefined, `case${k}`)),
    h("button", { type: "button", id: "add-case", key: "add", onClick: add }, "Add a load case"),
  ];
}
const HELP =
  'The load above is that of the load case shown. Others than "design" replace what they name.';

/** The form of the drive page. @param {Now} now */
export function inputs(now) {
  const i = app.pulley;
  const name = app.doc.pulley[i].name || String(i + 1);
  const [drive] = parted(section("drive"), ["title", "description", "creep_limit"]);
  return h(
    "form",
    {
      class: "inputs",
      "aria-label": "Drive",
      onSubmit: (e) => e.preventDefault(),
      noValidate: true,
    },
    fromExample(),
    app.case && byCase() ? loadInCase(i) : ownLoad(i, now),
    group(`Pulley ${name}`, pulley(i), "pulley"),
    group("Lagging", lagging(i)),
    group("Belt", belt()),
    group("Load cases", cases()),
    group("Held against", criteria()),
    group(
      "Drive",
      drive.map((f) => field({ spec: f, path: [f.key] })),
    ),
  );
}
