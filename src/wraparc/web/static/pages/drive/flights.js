// The lists of a conveyor: its flights, loading points, load cases, drives and resistances.
import { app, change, get, rowsOf, set } from "../../base/design.js";
import { changeNaming } from "../../base/removed.js";
import { field, idOf, more, parted, section } from "../../parts/field.js";
import { h } from "../../vendor/preact.js";

/** @import { Path, Spec } from "../../types.d.ts" */
/** @import { Choice, Choices } from "../../parts/field.js" */
/**
 * @typedef {object} List
 * @property {string} key of the conveyor
 * @property {string} one what a member is called
 * @property {string[]} first fields that are seen at once
 * @property {string[]} [replaces] keys of the conveyor whose values go into the first member
 */
/** @type {List[]} */
const LISTS = [
  {
    key: "flight",
    one: "flight",
    first: ["name", "length", "lift", "slope", "curve_radius"],
    replaces: ["length", "lift"],
  },
  {
    key: "loading",
    one: "loading point",
    first: ["name", "flight", "capacity"],
    replaces: ["capacity", "material_mass"],
  },
  { key: "load_case", one: "load case", first: ["name", "kind"] },
  { key: "drive", one: "drive", first: ["pulley", "at", "position"] },
  { key: "resistance", one: "resistance", first: ["at", "position"] },
];
/** Keys of the conveyor that its lists have taken over. */
export const replaced = () =>
  LISTS.flatMap((of) => (membersOf(of).length ? (of.replaces ?? []) : []));

/** @param {List} of */
const membersOf = ({ key }) => rowsOf(app.doc.conveyor?.[key]);
export const lists = () => [...LISTS.map(list), ...["travel", "cema"].map(table)];

/** @param {List} of */
function list(of) {
  const rows = membersOf(of);
  const title = section(`conveyor.${of.key}`).length || of.key === "resistance" ? titleOf(of) : "";
  const add = h(
    "button",
    { type: "button", key: "add", id: `add-${of.key}`, onClick: () => put(of) },
    `Add a ${of.one}`,
  );
  const help = h("p", { class: "help", key: "help" }, HELP[of.key]);
  return more(
    rows.length ? `${title}: ${rows.length}` : title,
    [help, ...rows.map((row, i) => member(of, row, i)), add],
    undefined,
    `conveyor-${of.key}`,
  );
}
/** @type {Record<string, string>} */
const HELP = {
  flight: "From the tail to the head, instead of one length and one lift.",
  loading: "Where material comes onto the belt, instead of one capacity.",
  load_case: "Besides full, empty, inclines, declines, start and stop.",
  drive: "Where each pulley of this drive is.",
  resistance: "Secondary and special resistances one by one, instead of the coefficient C.",
};
/** @param {List} of */
const titleOf = ({ key }) =>
  app.form.sections.find((s) => s.key === `conveyor.${key}`)?.title ?? "Resistances";
/** Resistances by their kind. */
const kinds = () => {
  const begin = "conveyor.resistance ";
  return app.form.sections.flatMap((s) =>
    s.key.startsWith(begin) ? [s.key.slice(begin.length)] : [],
  );
};
/** @param {List} of @param {any} row @param {number} i */
function member(of, row, i) {
  const at = ["conveyor", of.key, i];
  const kind = of.key === "resistance" ? row?.kind || "pulley" : "";
  const [first, rest] = parted(section(`conveyor.${of.key}${kind && ` ${kind}`}`), of.first);
  const make = (/** @type {Spec} */ s) => input(s, [...at, s.key]);
  const name = String(row?.name || row?.pulley || `${kind} ${i + 1}`.trim());
  return h(
    "fieldset",
    { key: `${of.key}-${i}` },
    h("legend", {}, `${of.one[0].toUpperCase()}${of.one.slice(1)} ${name}`),
    kind && choice("kind", "Kind", [...at, "kind"], kinds(), putKind(at)),
    first.map(make),
    of.key === "load_case" && [loaded([...at, "loaded"]), factors([...at, "factor"])],
    more(`More of ${name}`, rest.map(make), undefined, `more-${of.key}-${i}`),
    h("button", { type: "button", key: "remove", onClick: () => take(of, i) }, `Remove ${name}`),
  );
}
/** @param {Spec} s @param {Path} path */
function input(s, path) {
  const flights = membersOf(LISTS[0]).map((f) => f?.name || "");
  if (s.key === "flight") return choice("flight", "Flight", path, ["", ...flights]);
  const pulleys = app.doc.pulley.map((p) => p.name || "");
  if (s.key === "pulley") return choice("pulley", "Pulley", path, pulleys);
  const flight = s.key === "name" && path[1] === "flight";
  const how = flight ? { put: (/** @type {string} */ to) => rename(path, to) } : {};
  const long = app.units === "us" ? "ft" : "m";
  const inUnit = s.dimension === "length" && LONG.includes(s.key) ? long : undefined;
  return field({ spec: s, path, slider: false, placeholder: "", inUnit, ...how });
}
/** Lengths along the conveyor; others are those of a pulley or a skirt. */
const LONG = ["length", "lift", "curve_radius", "position", "splice_length"];
/** @param {string} key @param {string} title @param {Path} path @param {string[]} names
 * @param {(text: string) => any} [by] */
function choice(key, title, path, names, by) {
  const spec = { key, title, kind: "choice", help: "" };
  const choices = [{ choices: names.map((n) => /** @type {Choice} */ ([n, n || "the tail"])) }];
  return field({ spec, path, slider: false, choices, ...(by && { put: by }) });
}
/** Name a flight; what names it follows. @param {Path} path @param {string} to */
function rename(path, to) {
  const from = get(app.doc, path);
  const used = membersOf(LISTS[0]).filter((f) => f?.name === from).length === 1;
  let doc = set(app.doc, path, to);
  if (from && to && used) {
    const as = (/** @type {any} */ name) => (name === from ? to : name);
    membersOf(LISTS[1]).forEach((of, i) => {
      if (of?.flight === from) doc = set(doc, ["conveyor", "loading", i, "flight"], to);
    });
    membersOf(LISTS[2]).forEach((of, i) => {
      const at = ["conveyor", "load_case", i];
      if (Array.isArray(of?.loaded)) doc = set(doc, [...at, "loaded"], of.loaded.map(as));
      if (of?.factor?.[from] == null) return;
      const factor = Object.entries(of.factor).map(([name, v]) => [as(name), v]);
      doc = set(doc, [...at, "factor"], Object.fromEntries(factor));
    });
  }
  change(doc, path.join());
}
/** Another kind of resistance has other keys: its place stays. @param {Path} at */
const putKind = (at) => (/** @type {string} */ kind) => {
  const { at: place, position } = get(app.doc, at) ?? {};
  const kept = Object.fromEntries(Object.entries({ at: place, position }).filter(([, v]) => v));
  changeNaming(set(app.doc, at, { kind, ...kept }), ["kind"]);
};
/** Which flights have material in a load case. @param {Path} path */
function loaded(path) {
  const now = get(app.doc, path);
  const flights = membersOf(LISTS[0]).map((f) => f?.name || "");
  const several = Array.isArray(now) ? now.join(", ") : "";
  /** @type {Choices[]} */
  const choices = [
    {
      choices: [
        ["", "all flights"],
        ["none", "none"],
        ["inclines", "inclines"],
        ["declines", "declines"],
      ],
    },
    { group: "Flights", choices: flights.map((n) => [`=${n}`, n]) },
  ];
  if (Array.isArray(now) && now.length > 1) choices.push({ choices: [["=", several]] });
  const value = Array.isArray(now) ? `=${now.length > 1 ? "" : now[0]}` : now || "";
  const put = (/** @type {string} */ v) => {
    if (v === "=") return;
    change(set(app.doc, path, v.startsWith("=") ? [v.slice(1)] : v || undefined));
  };
  const spec = { key: "loaded", title: "Loaded", kind: "choice", help: "Flights with material." };
  return field({ spec, path, slider: false, choices, read: () => value, put });
}
/** Material over that of the full belt, by flight. @param {Path} path */
const factors = (path) =>
  membersOf(LISTS[0]).map((f) => {
    const name = String(f?.name || "");
    const help = "Material over that of the full belt; 100 % if left empty.";
    const spec = { key: name, title: `Material, ${name}`, kind: "number", help };
    return field({ spec, path: [...path, name], slider: false, placeholder: "" });
  });
/** One more member; the first takes over what the conveyor says itself. @param {List} of */
function put(of) {
  const rows = membersOf(of);
  /** @type {any} */
  const conveyor = { ...app.doc.conveyor };
  const one = of.key === "drive" ? { pulley: free() } : named(of, rows.length + 1);
  for (const key of rows.length ? [] : (of.replaces ?? [])) {
    if (conveyor[key] != null) one[key] = conveyor[key];
    delete conveyor[key];
  }
  change({ ...app.doc, conveyor: { ...conveyor, [of.key]: [...rows, one] } });
  const at = idOf(["conveyor", of.key, rows.length, of.first[0]]);
  requestAnimationFrame(() => document.getElementById(at)?.focus());
}
/** @param {List} of @param {number} n @returns {any} */
const named = (of, n) =>
  of.key === "resistance" ? { kind: "pulley" } : { name: `${of.one} ${n}` };
/** The first pulley whose place is not given yet. */
const free = () => {
  const given = membersOf(LISTS[3]).map((d) => d?.pulley);
  return app.doc.pulley.map((p) => p.name || "").find((n) => !given.includes(n)) ?? "";
};
/** @param {List} of @param {number} i */
function take(of, i) {
  const rest = membersOf(of).filter((_, k) => k !== i);
  const { [of.key]: _, ...without } = /** @type {any} */ (app.doc.conveyor);
  changeNaming({ ...app.doc, conveyor: rest.length ? { ...without, [of.key]: rest } : without });
  requestAnimationFrame(() => document.getElementById(`add-${of.key}`)?.focus());
}
/** @param {string} key */
function table(key) {
  const of = app.form.sections.find((s) => s.key === `conveyor.${key}`);
  const rows = (of?.fields ?? []).map((s) => input(s, ["conveyor", key, s.key]));
  return more(of?.title ?? key, rows, undefined, `conveyor-${key}`);
}
