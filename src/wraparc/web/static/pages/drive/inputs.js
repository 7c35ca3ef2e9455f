// The inputs of a drive: load first, then pulley, lagging, belt, load cases, the drive as a whole.

import { app, change, edit, get, redraw, set } from "../../base/design.js";
import { freeName, nameCheck, renameCase, renamePulley } from "../../base/names.js";
import { choose } from "../../parts/choose.js";
import { field, more, parted, section, spec } from "../../parts/field.js";
import { TENSIONS } from "../../parts/problems.js";
import { h } from "../../vendor/preact.js";
import { conveyor } from "./conveyor.js";
import { criteria } from "./criteria.js";

/** @import { Children, Path, Spec } from "../../types.d.ts" */
/** @import { Choice, Choices } from "../../parts/field.js" */

/** Pairs of tension, pull, power and torque that give the load. */
const PAIRS = [
  [0, 1],
  [0, 2],
  [1, 2],
  [0, 3],
  [1, 3],
  [0, 4],
  [1, 4],
];
/** @param {string} key */
const tensionSpec = (key) => spec("tensions", key);
/** @param {string} title @param {Children[]} rows */
const group = (title, rows, key = title) => h("fieldset", { key }, h("legend", {}, title), rows);
/** @typedef {() => Record<string, number> | null} Now numbers of the last answer for this pulley */

/** The load of a pulley: of the conveyor, of the train, or as given. @param {number} i
 * @param {Now} now */
const loadOf = (i, now) => [...(app.doc.conveyor ? [] : load(i)), ...conveyor(now)];

/** Which two of tension, pull, power and torque are given. @param {number} i */
function load(i) {
  const p = app.doc.pulley[i];
  const given = TENSIONS.filter((t) => p[t] !== undefined);
  if (app.doc.train && !given.length)
    return [h("p", { class: "help" }, "The train gives the tensions: see the page Train.")];
  const keysOf = (/** @type {number[]} */ pair) => pair.map((k) => TENSIONS[k]);
  const found = PAIRS.find(
    (pair) => given.length === 2 && keysOf(pair).every((k) => given.includes(k)),
  );
  const keys = found ? keysOf(found) : [...new Set([...keysOf(PAIRS[0]), ...given])];
  const pick = choose(
    PAIRS.indexOf(found || PAIRS[0]),
    PAIRS.map((pair, k) => [k, keysOf(pair).map(sign).join(" and ")]),
    (k) => give(i, keysOf(PAIRS[+k])),
    `pair-${i}`,
  );
  return [
    h(
      "div",
      { class: "field", key: "pair" },
      h("label", { for: `pair-${i}` }, "Load given by"),
      h("span", {}),
      h("span", { class: "box" }, pick),
    ),
    ...keys.map((k) => field({ spec: tensionSpec(k), path: ["pulley", i, k] })),
  ];
}
/** @param {string} key */
const sign = (key) => tensionSpec(key).symbol || tensionSpec(key).title;
/** Give the same load by two other numbers. @param {number} i @param {string[]} keys */
const give = async (i, keys) => change((await import("./load.js")).givenBy(app.doc, i, keys));

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
    (known || late) && condition("switched"),
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

/** The switches of the condition, fetched behind the first page; their places are kept free.
 * @type {typeof import("./condition.js") | null} */
let late = null;
let fetching = false;
/** @param {"switched" | "sideBySide"} what */
function condition(what) {
  if (late) return late[what](app.pulley);
  if (!fetching)
    import("./condition.js").then((found) => {
      late = found;
      redraw();
    });
  fetching = true;
  return h("div", { class: "field late", key: "condition" });
}

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
  if (app.doc.conveyor && !app.doc.load_case) return [condition("sideBySide")];
  const list = app.doc.load_case || [];
  const add = () => {
    const names = ["design", ...list.map((c) => c.name)];
    const pulleys = app.doc.train
      ? { train: {} }
      : { pulley: { [app.doc.pulley[app.pulley].name || ""]: {} } };
    edit(["load_case"], [...list, { name: freeName("case", names), ...pulleys }]);
  };
  return [
    condition("sideBySide"),
    h(
      "p",
      { class: "help", key: "help" },
      'The load above is the case "design". Others replace what they name.',
    ),
    ...list.map((c, i) => more(c.name || `case ${i + 1}`, loadCase(i), undefined, `case${i}`)),
    h("button", { type: "button", id: "add-case", key: "add", onClick: add }, "Add a load case"),
  ];
}
/** @param {number} i @returns {Children[]} */
function loadCase(i) {
  const list = app.doc.load_case || [];
  const others = ["design", ...list.filter((_, k) => k !== i).map((c) => c.name)];
  const at = ["load_case", i, "pulley", app.doc.pulley[app.pulley].name || ""];
  const remove = () => {
    edit(["load_case"], list.length > 1 ? list.filter((_, k) => k !== i) : undefined);
    document.getElementById("add-case")?.focus();
  };
  return [
    field({
      spec: spec("load_case", "name"),
      path: ["load_case", i, "name"],
      put: (name) => renameCase(i, name),
      check: nameCheck("load case", others),
    }),
    field({ spec: spec("load_case", "description"), path: ["load_case", i, "description"] }),
    ...(app.doc.train
      ? []
      : TENSIONS.map((t) =>
          field({ spec: tensionSpec(t), path: [...at, t], slider: false, placeholder: "" }),
        )),
    h("button", { type: "button", key: "remove", onClick: remove }, "Remove this case"),
  ];
}

/** What an overtyped example still says of itself: title and load cases. */
function fromExample() {
  const { origin, doc } = app;
  if (!origin) return null;
  const same = (/** @type {string} */ key) =>
    JSON.stringify(doc[key]) === JSON.stringify(origin.document[key]);
  const cases = doc.load_case?.length && same("load_case");
  const title = doc.title && same("title");
  if ((same("belt") && same("pulley") && same("train")) || !(cases || title)) return null;
  const parts = [title && "its title", cases && `its ${doc.load_case?.length} load cases`].filter(
    Boolean,
  );
  const keep = () => {
    app.origin = null;
    change({ ...doc });
  };
  const clear = () => {
    const { load_case, ...rest } = doc;
    app.origin = null;
    change({ ...(cases ? rest : doc), ...(title && { title: "" }) });
    document.getElementById("f-title")?.focus();
  };
  return h(
    "div",
    { class: "card aside", role: "note", key: "origin" },
    h(
      "p",
      {},
      `This began as the example “${origin.title}” and still has `,
      parts.join(" and "),
      ".",
    ),
    h(
      "p",
      { class: "inline" },
      h("button", { type: "button", onClick: clear }, "Take them out"),
      h("button", { type: "button", onClick: keep }, "Keep them"),
    ),
  );
}

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
    group("Load", loadOf(i, now)),
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
