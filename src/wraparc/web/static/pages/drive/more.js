// What is turned less: how the load is given, the rest of pulley, lagging and belt, load cases, and
// what the drive is held against. Fetched behind the first page.
import { app, besides, blank, edit, get, look, set, touched } from "../../base/design.js";
import { nameCheck, renameCase, renamePulley } from "../../base/names.js";
import { changeNaming } from "../../base/removed.js";
import { words } from "../../base/units.js";
import { choose } from "../../parts/choose.js";
import { field, idOf, more, parted, section, spec } from "../../parts/field.js";
import { TENSIONS } from "../../parts/problems.js";
import { h } from "../../vendor/preact.js";
import { addCase, firstOf } from "./add_case.js";
import { after } from "./after.js";
import { byCase, isCase } from "./cases.js";
import { called, go, held } from "./condition.js";
import { conveyor } from "./conveyor.js";
import { criteria } from "./criteria.js";
import { catalogued, givenLoad, ofBelt, PAIRS, pairAt, putBelt } from "./inputs.js";
import { caseOf, follows, loadOn, pullsIn, takenOver } from "./load.js";
import { givenBy, givenInCase } from "./load_given.js";

/** @import { Children, Path, Spec } from "../../types.d.ts" */
/** @import { Now } from "./inputs.js" */

/** @param {string} key */
const tensionSpec = (key) => spec("tensions", key);
/** @param {string} title @param {Children[]} rows */
const group = (title, rows, key = title) => h("fieldset", { key }, h("legend", {}, title), rows);
/** How the load is given. @param {number} i @param {Now} now */
function load(i, now) {
  const of = givenLoad(i);
  const k = of?.k ?? -1;
  const shared = byCase() && (isCase() ? "design" : "shared by all load cases");
  const name = k < 0 ? shared : app.doc.load_case?.[k].name;
  const train = !of && app.doc.train;
  const rows = [
    of && by(i, of),
    train && h("p", { class: "help", key: "train" }, "The train gives the tensions."),
    k >= 0 && taken(i, k, of?.keys ?? []),
    ...conveyor(now),
  ];
  return group(name ? `Load: ${name}` : "Load", rows, "Load");
}
/** What a load case takes over. @param {number} i @param {number} k @param {string[]} keys */
function taken(i, k, keys) {
  if (!keys.some((key) => takenOver(app.doc, i, k, key))) return null;
  const from = isCase() ? 'the load case "design"' : "the pulley";
  const empty = follows(app.doc, i, k)
    ? `The other tension follows from ${from}: the take-up fixes the sum of both.`
    : `What is left empty is that of ${from}.`;
  return h("p", { class: "help", key: "taken" }, empty);
}
/** By which quantities. @param {number} i
 * @param {NonNullable<ReturnType<typeof givenLoad>>} of */
function by(i, { k, at, keys }) {
  const id = idOf(at, "pair");
  /** @param {string[]} pair */
  const give = (pair) => {
    const doc = k < 0 ? givenBy(app.doc, i, pair) : givenInCase(app.doc, i, k, pair);
    // a load that is not known yet is not told by another pair
    const known =
      k < 0 ? loadOn(app.doc, i)(pullsIn(app.doc.pulley[i])) : caseOf(app.doc, i, k).now;
    changeNaming(doc, Number.isFinite(known.effective_tension) ? TENSIONS : []);
  };
  const pick = choose(
    Math.max(0, pairAt(keys)),
    PAIRS.map((keys, k) => [k, keys.map(sign).join(" and ")]),
    (n) => give(PAIRS[+n]),
    id,
  );
  return h(
    "div",
    { class: "field", key: "pair" },
    h("label", { for: id }, "Load input"),
    h("span", {}),
    h("span", { class: "box" }, pick),
  );
}
/** @param {string} key */
const sign = (key) => tensionSpec(key).symbol || tensionSpec(key).title;

/** @param {number} i */
function pulley(i) {
  const skip = ["name", "lagging", "condition", "diameter", "wrap_angle", ...TENSIONS];
  const fields = section("pulley").filter((f) => !skip.includes(f.key) && f.kind !== "table");
  return [pulleyName(i), ...fields.map((f) => field({ spec: f, path: ["pulley", i, f.key] }))];
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

/** @param {number} i */
function lagging(i) {
  const known = catalogued(i);
  const parts = section("lagging").map((f) => laggingPart(f, i, words(known?.[f.key])));
  const origin =
    known &&
    h("p", { class: "origin", key: "origin" }, (known.source || "").replace(`${known.kind}: `, ""));
  return [ofCondition(i), origin, ...parts];
}
/** A number of the lagging that the design may give in place of the catalogue's.
 * @param {Spec} of @param {number} i @param {string} placeholder */
function laggingPart(of, i, placeholder) {
  /** @type {Path} */
  const at = ["pulley", i, "lagging"];
  const { key } = of;
  return field({
    spec: of,
    path: [...at, key],
    placeholder,
    read: () => get(app.doc, at)?.[key],
    put: (value) => {
      const v = get(app.doc, at);
      const next = { ...(v && typeof v === "object" ? v : { preset: v }), [key]: value };
      if (value === undefined) delete next[key];
      edit(at, Object.keys(next).join() === "preset" ? next.preset : next);
    },
  });
}

function belt() {
  const skip = ["preset", "table", "width"];
  const fields = section("belt").filter(
    (f) => !skip.includes(f.key) && !["table", "belt"].includes(f.kind),
  );
  const [main, others] = parted(fields, ["speed", "modulus"]);
  return [standardName(), ...[...main, ...others].map(ofBelt)];
}
/** A belt that the catalogue does not have, by its standard name. */
function standardName() {
  const of = spec("belt", "preset");
  const listed = app.catalogue.belts.some((b) => b.name === app.doc.belt.preset);
  return field({
    spec: { ...of, kind: "text" },
    path: ["belt", "preset"],
    page: "named",
    label: "Standard name",
    placeholder: "EP 630/3",
    read: () => (listed ? undefined : app.doc.belt.preset),
    put: putBelt,
    check: () => "",
  });
}
function cases() {
  if (app.doc.conveyor && !app.doc.load_case) return [sideBySide(app.pulley)];
  const list = app.doc.load_case || [];
  return [
    sideBySide(app.pulley),
    h("p", { class: "help", key: "help" }, HELP),
    shared(),
    ...list.map((c, k) => more(c.name || `case ${k + 1}`, inCase(k), undefined, `case${k}`)),
    h(
      "button",
      { type: "button", id: "add-case", key: "add", onClick: addCase },
      "Add a load case",
    ),
  ];
}
const HELP =
  'The load above is that of the load case shown. Others than "design" replace what they name.';

/** Back to what the load cases share, where that makes no load case. */
const shared = () =>
  app.doc.load_case && !app.doc.train && !isCase()
    ? showing("Show the load that all share", "design")
    : null;
/** @param {string} text @param {string} name */
const showing = (text, name) =>
  h("button", { type: "button", key: "show", onClick: () => look({ case: name }) }, text);
/** What a load case is called and means. @param {number} k @returns {Children[]} */
function inCase(k) {
  const { load_case = [], train } = app.doc;
  const others = ["design", ...load_case.filter((_, j) => j !== k).map((c) => c.name)];
  const remove = () => {
    const left = load_case.length > 1 ? load_case.filter((_, j) => j !== k) : undefined;
    changeNaming(set(app.doc, ["load_case"], left));
    document.getElementById("add-case")?.focus();
  };
  return [
    field({
      spec: spec("load_case", "name"),
      path: ["load_case", k, "name"],
      put: (to) => renameCase(k, to),
      check: nameCheck("load case", others),
    }),
    field({ spec: spec("load_case", "description"), path: ["load_case", k, "description"] }),
    !train && showing("Show and change its load", firstOf(app.doc, load_case[k].name ?? "")),
    h("button", { type: "button", key: "remove", onClick: remove }, "Remove this case"),
  ];
}
/** For what the condition holds. @param {number} i */
function ofCondition(i) {
  const { at, all, shown } = held(i);
  const alone = { pulley: "this pulley", load_case: `load case ${shown}` }[at[0]];
  const several = app.doc.pulley.length > 1 && "Of all pulleys.";
  const beside = all.length && `Every load case in ${all.map(called).join(" and ")}; shown is one.`;
  const note = alone ? `Of ${alone} alone.` : beside || several;
  return [
    note && h("p", { class: "help", key: "condition-note" }, `Condition: ${note}`),
    alone &&
      h(
        "button",
        { type: "button", key: "of", onClick: () => changeNaming(set(app.doc, at, undefined)) },
        "Take that of the drive",
      ),
  ];
}

/** Conditions that published values cover, side by side. */
const SEVERAL = [
  ["dry", "wet"],
  ["dry", "wet", "wet and dirty"],
];
/** Whether every load case is solved in one condition, or in several. @param {number} i */
function sideBySide(i) {
  const { row, base, at } = held(i);
  const now = besides(app.doc);
  const known = SEVERAL.findIndex((names) => JSON.stringify(names) === JSON.stringify(now));
  const put = (/** @type {string} */ k) => {
    const names = SEVERAL[+k - 1];
    const main = at.length > 1 ? now[0] : row;
    const seen = names?.includes(called(row)) ? called(row) : names?.[0];
    go(
      set(app.doc, ["condition"], names ?? main),
      at[0] === "load_case" || !names ? base : `${base}, ${seen}`,
    );
  };
  return h(
    "div",
    { class: "field", key: "condition" },
    h("label", { for: "condition" }, "Solved in"),
    h("span", {}),
    h(
      "span",
      { class: "box" },
      choose(
        now.length ? known + 1 || "own" : 0,
        [
          [0, "the condition of the lagging"],
          ...SEVERAL.map((c, k) => /** @type {[number, string]} */ ([k + 1, c.join(" | ")])),
          ...(now.length && known < 0
            ? [/** @type {[string, string]} */ (["own", "as in the file"])]
            : []),
        ],
        put,
        "condition",
      ),
    ),
  );
}

/** @param {number} i @param {Now} now */
export const moreInputs = (i, now) => after(() => all(i, now));
/** @param {number} i @param {Now} now */
function all(i, now) {
  const name = app.doc.pulley[i].name || String(i + 1);
  const [drive] = parted(section("drive"), ["title", "description", "creep_limit", "covered"]);
  return [
    load(i, now),
    group(`Pulley ${name}`, pulley(i), "pulley"),
    group("Lagging", lagging(i)),
    group("Belt", belt()),
    group("Load cases", cases()),
    group("Criteria", criteria()),
    group(
      "Drive",
      drive.map((f) => field({ spec: f, path: [f.key] })),
    ),
  ];
}

/** What a new drive begins with, beside its load. @type {Path[]} */
const BEGUN = [
  ["belt", "preset"],
  ["belt", "width"],
  ["pulley", 0, "diameter"],
  ["pulley", 0, "wrap_angle"],
  ["pulley", 0, "lagging"],
];
/** Whether a value of a new drive was never touched. @param {Path} at */
export const isAssumed = (at) =>
  app.begun &&
  BEGUN.some((of) => of.join() === at.join()) &&
  !touched.has(at.join()) &&
  [blank("si"), blank("us")].some((of) => get(of, at) === get(app.doc, at));
/** Values of a new drive that nobody has touched, as texts. @returns {string[]} */
export const assumed = () => BEGUN.filter(isAssumed).map((at) => get(app.doc, at));
