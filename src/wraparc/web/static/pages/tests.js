// Shear tests: machine files to a lagging file.
import { turnTo } from "../base/address.js";
import { app, redraw, set } from "../base/design.js";
import { noteUndo, putLagging } from "../base/removed.js";
import { save } from "../base/save.js";
import { act, refusal, sentence } from "../base/server.js";
import { words } from "../base/units.js";
import { levelClass, lined, linesOf, list, standing } from "../parts/answers.js";
import { notComputed, silent } from "../parts/framed.js";
import { stands, table } from "../parts/tables.js";
import { h } from "../vendor/preact.js";
import { glyph, said } from "./drive/screen.js";
import { figureCard, hasFigure } from "./tests/figure.js";
import {
  allSaid,
  asReadOf,
  chooseFiles,
  chosenFile,
  details,
  drop,
  dropped,
  expect,
  inputs,
  saidOf,
  say as sayOf,
  sendFigure,
  session,
  takePicture,
  within,
} from "./tests/files.js";
import {
  asked,
  fromWhat,
  isFigure,
  planForm,
  rowOf,
  openPlan as takePlan,
  typedAt,
  unsaid,
} from "./tests/plan.js";
import { conditionPlots, overPressureOf, overSlipOf } from "./tests/plots.js";
import { files, unitless, unitsAsked } from "./tests/rows.js";

/** Take a test plan in: the form at once, its tests when their files are dropped.
 * @param {any} plan */
export function openPlan(plan) {
  takePlan(plan);
  expect(plan.test ?? []);
}

/** @import { Problem, Table } from "../types.d.ts" */
/**
 * @typedef {{name: string, toml: string | null, lagging: any, sheet: any, left_out: Problem[],
 *   conditions: any[]}} Fit
 */

const state = {
  fitting: false,
  problems: /** @type {Problem[]} */ ([]),
  /** What is wrong with a row of the form, by part and key. */
  marks: /** @type {Record<string, string>} */ ({}),
  result: /** @type {Fit | null} */ (null),
  /** What it is of. */
  of: "",
  /** Why a law is to be used that does not describe its tests. */
  reason: "",
  /** The condition that is looked at. */
  condition: "",
};
/** What a fit is of: the plan, and what is said of its files. */
const subject = () => JSON.stringify([asked(), session.files.map((f) => [f.name, saidOf(f)])]);
/** @param {string} reason why its misfit is accepted, if it is */
async function fit(reason = "") {
  Object.assign(state, { problems: [], fitting: true });
  state.marks = unsaid();
  const open = Object.keys(state.marks).length;
  redraw();
  try {
    if (!(await sendFigure()) || open) {
      requestAnimationFrame(() =>
        /** @type {HTMLElement | null} */ (
          document.querySelector("#tests [aria-invalid=true], #tests .wrong input")
        )?.focus(),
      );
      return;
    }
    await allSaid();
    const of = subject();
    const result = await within("fit", { ...asked(), accept_misfit: reason });
    Object.assign(state, { result, of });
  } catch (x) {
    const problems = refusal(x);
    state.problems = problems.filter((p) => !rowOf(p.path));
    for (const p of problems) if (rowOf(p.path)) state.marks[typedAt(p.path)] = sentence(p);
    if (!state.problems.length) state.problems = problems;
  } finally {
    state.fitting = false;
    redraw();
  }
}
async function download() {
  if (!(await sendFigure())) return;
  await allSaid();
  const { toml, name } = await within("plan", asked());
  save(name, toml, "application/toml");
}
function use() {
  const { name, lagging } = /** @type {Fit} */ (state.result);
  const before = app.doc.lagging?.[name] ? ` It replaces the lagging ${name} of the design.` : "";
  putLagging(app.pulley, name, set(app.doc, ["lagging", name], lagging));
  const { name: pulley } = app.doc.pulley[app.pulley];
  noteUndo(`The lagging ${name} is on pulley ${pulley} now.${before} `);
  turnTo("drive");
  redraw();
}

const withFiles = () => session.files.length > 0;
const ready = () =>
  isFigure()
    ? hasFigure() || session.files.some((f) => f.digitised.length)
    : session.files.some((f) => f.read);
const how = () =>
  standing(state.of === subject(), [...state.problems, ...Object.keys(state.marks)], state.fitting);
/** The condition that is looked at. */
const now = () =>
  state.result?.conditions.find((c) => c.condition === state.condition) ??
  state.result?.conditions[0];

/** Conditions of the tests, each with how many there are. */
export function picks() {
  const names = [...new Set(session.files.map((f) => f.condition || "dry"))];
  if (!withFiles() || isFigure()) return fromWhat();
  const fresh = how() === "fresh" && !state.problems.length;
  const chips = h(
    "div",
    { class: "chips", role: "group", "aria-label": "Condition" },
    names.map((name) => {
      const own = session.files.filter((f) => (f.condition || "dry") === name);
      const used = own.filter((f) => f.read && f.use !== false).length;
      const c = state.result?.conditions.find((x) => x.condition === name);
      const level = fresh && c ? (c.misfit.length ? "ATTENTION" : "OK") : null;
      return h(
        "button",
        {
          type: "button",
          class: "chip",
          key: name,
          "aria-pressed": (now()?.condition ?? names[0]) === name,
          onClick: () => {
            state.condition = name;
            redraw();
          },
        },
        glyph(level),
        h("span", {}, name),
        " ",
        h(
          "i",
          { class: levelClass(level) },
          used === own.length ? `${used} tests` : `${used} of ${own.length}`,
        ),
      );
    }),
  );
  return [fromWhat(), chips];
}

export const Page = () =>
  h(
    "div",
    {
      class: "screen other measure",
      "data-stands": state.result ? how() : null,
      ...dropped(),
    },
    inputs(),
    h(
      "div",
      { class: "frame" },
      h(
        "div",
        { class: "inputs rail card" },
        withFiles() && files(chooseFiles),
        planForm(state.marks, withFiles() && !isFigure()),
      ),
      h(
        "section",
        { class: "hero card tests", "aria-label": "Tests and law" },
        say(),
        h("div", { class: "stage-box", key: "stage" }, stage()),
      ),
      h("aside", { class: "checks card", "aria-label": "Findings" }, findings()),
    ),
    below(),
  );
/** @param {Fit | null} r @returns {any} */
const verdictOf = (r) => r?.sheet?.verdict;
/** What the tests come to, and what is to be done next. */
function say() {
  const lacking = isFigure() ? [] : unitless();
  const total = session.files.length;
  const read = session.files.filter((f) => f.read).length;
  if (state.fitting) return silent("Fitting …", total ? `${read} of ${total} tests.` : "");
  if (state.problems.length)
    return notComputed(
      "The tests could not be fitted.",
      state.problems,
      button("Fit the lagging", () => fit()),
    );
  if (!withFiles() && !(isFigure() && hasFigure()))
    return silent(
      isFigure() ? "No figure yet." : "No tests yet.",
      lined(isFigure() ? FIGURE : NEEDS),
    );
  if (lacking.length) {
    const [column] = unitsAsked(lacking[0]);
    const n = lacking.length;
    const out = async () => {
      for (const f of lacking) await sayOf(f, { use: false, reason: `unit of ${column} unknown` });
    };
    const text = `Not computed: unit of ${column} missing in ${n} ${n > 1 ? "files" : "file"}.`;
    const also = lined([["Also", `${read} of ${total} tests are ready.`]]);
    return silent(
      text,
      also,
      button(n > 1 ? `Leave the ${n} files out` : "Leave the file out", out),
    );
  }
  const stand = how();
  const r = state.result;
  if (r && stand === "fresh") {
    const v = verdictOf(r);
    const act = r.lagging && button("Apply to drive", use);
    return v
      ? said(v.level, words(v.text), lined(linesOf(v)), act, null, null, v.label)
      : silent(words(r.sheet?.title) || r.name, "", act);
  }
  const text = isFigure() ? "Curves of a figure." : `${read} of ${total} tests read.`;
  const more = r ? "Inputs changed." : lined(NEXT);
  return silent(text, more, ready() && button("Fit the lagging", () => fit()));
}
/** @type {import("../parts/answers.js").Line[]} */
const NEEDS = [
  ["Needs", "Force, travel and normal force over time; 2 pressures or more."],
  ["Result", "Friction law with ± band, dry and wet, for use in the drive."],
];
/** @type {import("../parts/answers.js").Line[]} */
const FIGURE = [
  ["Needs", "A picture of friction over slip with numbers at its axes."],
  ["Result", "Friction law of what was published, for use in the drive."],
];
/** @type {import("../parts/answers.js").Line[]} */
const NEXT = [["Next", "The fit gives friction over slip and pressure with its band."]];
/** @param {string} text @param {() => any} does */
const button = (text, does) =>
  h(
    "button",
    {
      type: "button",
      class: "main advice",
      key: text,
      disabled: state.fitting,
      onClick: act(does),
    },
    text,
  );
/** The drop zone, the figure that is read, or curves. */
function stage() {
  if (isFigure()) return [figureCard(takePicture), !hasFigure() && drop()];
  if (!withFiles()) return drop();
  const c = now();
  if (!c) return asReadOf(chosenFile());
  return h(
    "div",
    { class: how() === "fresh" ? "curves" : "curves before", key: c.condition },
    overSlipOf(c, fileOf(c)),
    overPressureOf(c),
  );
}
/** Name in the fit of the file that is chosen. @param {any} c @returns {string | null} */
function fileOf(c) {
  const f = session.files.find((x) => x.id === session.chosen);
  const is = (/** @type {any} */ v) => f && v.file === `${f.id}: ${f.name}`;
  return c.curves.find(is)?.file ?? null;
}
/** Names of what is found, before anything is. */
const COMING = [
  "Columns and units",
  "Test order",
  "Force zero",
  "Peak reached",
  "Repeat scatter",
].concat(["Maximum deviation"]);
const chosen = { finding: "" };
/** @typedef {{title: string, level: any, value: any, text: any, tests: number | null}} Finding */
function findings() {
  const c = now();
  const total = session.files.filter(
    (f) => (f.condition || "dry") === (c?.condition ?? "dry"),
  ).length;
  const lacking = isFigure() ? [] : unitless();
  const own = /** @type {Finding[]} */ ([
    ...(lacking.length
      ? [
          {
            title: `Unit of ${unitsAsked(lacking[0])[0]} missing`,
            level: "ATTENTION",
            value: `${lacking.length} of ${session.files.length}`,
            text: `${lacking.map((f) => f.name).join(", ")}: choose it once, under the file.`,
            tests: lacking.length,
          },
        ]
      : []),
    ...(state.result?.left_out ?? []).map((p) => ({
      title: "Left out",
      level: "ATTENTION",
      value: "",
      text: sentence(p),
      tests: null,
    })),
    ...(c?.findings ?? []),
  ]);
  if (!own.length)
    return [
      h(
        "h2",
        { key: "head" },
        "Findings",
        h("span", {}, withFiles() ? "come with the fit" : "come with the files"),
      ),
      h(
        "ul",
        { class: "list coming", key: "list" },
        COMING.map((title) => h("li", { key: title }, h("span", {}, title), h("span", {}, "–"))),
      ),
      h(
        "p",
        { class: "why", key: "why" },
        "Then curves of all tests in the middle, the law below, what is wrong with the tests here.",
      ),
    ];
  const one = own.find((f) => f.title === chosen.finding) ?? own[0];
  const open = own.filter((f) => f.level !== "OK").length;
  return [
    h("h2", { key: "head" }, "Findings", h("span", {}, `${open} of ${own.length} to look at`)),
    h(
      "ul",
      { class: "list", key: "list" },
      own.map((f, i) => finding(f, f === one, Math.max(total, 1), i)),
    ),
    h(
      "div",
      {
        class: "why",
        id: "why-tests",
        role: "region",
        "aria-label": "Finding",
        tabIndex: 0,
        key: "why",
      },
      h("h3", {}, one.title),
      h("p", {}, words(one.text) || words(one.value)),
    ),
    state.result && !state.result.lagging && how() === "fresh" && misfit(),
  ];
}
/** @param {Finding} f @param {boolean} open @param {number} total @param {number} i */
function finding(f, open, total, i) {
  const cls = levelClass(f.level);
  const press = () => {
    chosen.finding = f.title;
    redraw();
  };
  return h(
    "li",
    { key: `${f.title}${i}`, class: cls },
    h(
      "button",
      { type: "button", "aria-expanded": open, "aria-controls": "why-tests", onClick: press },
      glyph(f.level),
      h("span", { class: `n ${cls}` }, f.title, h("span", { class: "away" }, `, ${f.level}`)),
      h("span", { class: "v" }, h("b", { class: cls }, words(f.value))),
      f.tests
        ? h(
            "span",
            { class: "use part" },
            h("u", { class: cls, style: { width: `${Math.min(100, (100 * f.tests) / total)}%` } }),
          )
        : h("span", {}),
    ),
  );
}
/** All that is behind: files to take away, columns, what the fits leave over, tables. */
function below() {
  const r = state.result;
  return h(
    "details",
    { id: "tests-details", class: "card" },
    h("summary", {}, "Details"),
    h(
      "div",
      { class: "details" },
      h(
        "p",
        { class: "bar", key: "bar" },
        h("button", { type: "button", onClick: act(download) }, "Download the test plan"),
        r?.lagging &&
          h(
            "button",
            {
              type: "button",
              onClick: () => save(`${r.name}.toml`, r.toml || "", "application/toml"),
            },
            "Download the lagging file",
          ),
      ),
      withFiles() && details(),
      r && result(r),
    ),
  );
}
/** @param {Fit} r */
function result(r) {
  const found = stands(
    how(),
    h(
      "section",
      { class: "card", "aria-label": "Fitted lagging" },
      h("h2", {}, words(r.sheet?.title) || r.name),
      h("p", {}, words(r.sheet?.subtitle)),
      r.left_out?.length > 0 &&
        h(
          "div",
          { class: "verdict warn" },
          h("p", { class: "headline" }, "Left out"),
          list(r.left_out.map(sentence)),
        ),
    ),
    r.conditions.map(condition),
    h(
      "div",
      { class: "tables" },
      (r.sheet?.tables || []).map((/** @type {Table} */ t) => table(t)),
    ),
  );
  return h("div", { key: "result", id: "fitted" }, found);
}
/** What must be said before a law that does not describe its tests can be used. */
const misfit = () =>
  h(
    "form",
    {
      key: "misfit",
      class: "verdict warn",
      onSubmit: (/** @type {Event} */ e) => {
        e.preventDefault();
        if (state.reason.trim()) act(() => fit(state.reason.trim()))(e);
      },
    },
    h("p", { class: "headline" }, "The law does not describe its tests."),
    h(
      "p",
      {},
      "Repair, repeat or leave out the tests named below. To use the law nevertheless, ",
      "give a reason: it is saved with the lagging.",
    ),
    h(
      "p",
      { class: "bar" },
      h(
        "label",
        {},
        "Reason",
        h("input", {
          type: "text",
          size: 40,
          maxLength: 500,
          value: state.reason,
          onInput: (/** @type {any} */ e) => {
            state.reason = e.currentTarget.value;
            redraw();
          },
        }),
      ),
      h("button", { disabled: !state.reason.trim() }, "Accept the misfit"),
    ),
  );
/** @param {any} c */
const condition = (c) =>
  h(
    "section",
    { class: "card", "aria-label": `Condition ${c.condition}`, key: c.condition },
    h("h2", {}, `Condition: ${c.condition}`, c.form && h("small", { class: "help" }, ` ${c.form}`)),
    list([...(c.misfit || []), ...(c.remarks || [])], "help"),
    conditionPlots(c),
  );
