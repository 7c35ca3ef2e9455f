// Several drives on one belt: shares, speeds, and how exactly they must be matched.
import { app, gripped, redraw } from "../base/design.js";
import { aborted, act, ask, complain, later, onReturn, refusal } from "../base/server.js";
import { percent } from "../base/units.js";
import { PAGES } from "../frame/registry.js";
import { judgedIf, list, refused, standing, stands, table, verdict } from "../parts/answers.js";
import { checked, facts, framed, saying, silent } from "../parts/framed.js";
import { mark } from "../parts/problems.js";
import { h } from "../vendor/preact.js";
import { picks as casePicks } from "./drive/screen.js";
import { answer, known } from "./drive/solving.js";
import { chain } from "./train/chain.js";
import { trainInputs } from "./train/inputs.js";
import { matchingPlots } from "./train/plots.js";
import { changes, reasons, shareBar, trimStrip } from "./train/strips.js";

/** @import { Design, Problem, Table } from "../types.d.ts" */

const state = {
  answer: /** @type {any} */ (null),
  /** The drive that it is of. */
  doc: /** @type {Design | null} */ (null),
  of: /** @type {Design | null} */ (null),
  problems: /** @type {Problem[]} */ ([]),
  matched: /** @type {any} */ (null),
  /** What of the drives it is of. */
  by: "",
  matching: false,
  drive: "",
  map: false,
};
const several = () => app.doc.pulley.length > 1;
export function update() {
  const names = app.doc.pulley.map((p) => p.name || "");
  if (!names.slice(1).includes(state.drive)) state.drive = names[1] || "";
  if (state.of === app.doc || gripped()) return;
  state.of = app.doc;
  if (several()) solve(app.doc);
  else Object.assign(state, { answer: null, matched: null, problems: [] });
}
onReturn(() => {
  state.of = null;
});
/** @type {AbortController | null} */
let stop = null;
const solve = later(200, async (/** @type {Design} */ doc) => {
  stop?.abort();
  stop = new AbortController();
  const asked = { document: doc, load_case: null, match: false };
  try {
    const answer = await ask("train", asked, { signal: stop.signal });
    if (doc !== app.doc) return;
    Object.assign(state, { answer, doc, matched: null, problems: [] });
    mark([]);
  } catch (x) {
    if (aborted(x) || app.gone) return;
    const problems = refusal(x);
    const rest = mark(problems);
    state.problems = rest.length ? rest : problems;
  }
  redraw();
});
async function match() {
  const doc = app.doc;
  state.matching = true;
  redraw();
  try {
    const { drive, map } = state;
    const by = trimmed();
    const asked = {
      document: doc,
      load_case: null,
      drive: drive || null,
      match: true,
      map,
      points: 41,
    };
    const answer = await ask("train", asked);
    if (doc === app.doc) Object.assign(state, { matched: answer.matching, by });
  } catch (x) {
    complain(x);
  }
  state.matching = false;
  redraw();
}

const trimmed = () => `${state.drive} ${state.map}`;
const now = () => standing(state.doc === app.doc, state.problems);
const matchedNow = () => (state.by === trimmed() ? now() : standing(false, [], state.matching));
/** The load case that is looked at. @param {any} a the answer */
const shownIn = (a) =>
  a.load_cases.find((/** @type {any} */ c) => c.load_case === app.case) ?? a.load_cases[0];

export const picks = () => casePicks("-train");
export const Page = () => {
  const c = several() && state.answer ? shownIn(state.answer) : null;
  const i = Math.max(
    1,
    app.doc.pulley.findIndex((p) => p.name === state.drive),
  );
  const m = c?.drives[i];
  return framed(
    {
      how: now(),
      form: trainInputs(state.answer),
      say: c
        ? saying(now(), state.answer.verdict, slower(m, c.drives[0]), toMatch())
        : silent(lacks()),
      drawing: c && loadCase(c),
      curve: c && [
        c.reason && h("p", { class: "error", key: "reason" }, c.reason),
        c.drives.every((/** @type {any} */ d) => d.share != null) && shareBar(c),
        trimStrip(c, i, matchedNow() === "fresh" ? state.matched : null),
      ],
      side: c && [
        checked("train", (a) => a.load_case === c.load_case),
        m?.drum_ratio && facts(`Why ${m.pulley} turns ${turns(m)}`, reasons(m)),
        m && facts("If something changes", changes(m)),
      ],
    },
    h(
      "div",
      { role: "alert", key: "problems" },
      state.problems.length > 0 && refused("", state.problems),
    ),
    several()
      ? state.answer && stands(now(), result(state.answer))
      : h("p", { class: "verdict", key: "single" }, SINGLE),
    // some hundred solves: for a server
    PAGES.saved ? matchForm() : several() && h("p", { class: "help", key: "trim" }, TRIM),
    state.matching && h("p", { class: "help", role: "status", key: "wait" }, WAIT),
    state.matched && stands(matchedNow(), matching(state.matched)),
  );
};
const lacks = () =>
  several()
    ? state.problems.length
      ? "Not computed."
      : "Solving …"
    : "One pulley: add a second drive.";
/** How much slower or faster a drum turns than the first. @param {any} m */
const turns = (m) =>
  `${percent(Math.abs(m.drum_ratio - 1), 3)} ${m.drum_ratio < 1 ? "slower" : "faster"}`;
/** @param {any} m @param {any} first */
const slower = (m, first) =>
  m?.drum_ratio > 0 ? `Run ${m.pulley} ${turns(m)} than ${first.pulley}.` : undefined;
/** The limits of the trim, on a press. */
const toMatch = () =>
  PAGES.saved &&
  !(state.matched && matchedNow() === "fresh") &&
  h(
    "button",
    { type: "button", class: "main advice", disabled: state.matching, onClick: act(match) },
    state.matching ? "At work …" : "Find the trim limits",
  );
const SINGLE =
  "This drive has one pulley. Add a second one on the left, or open a tandem from the menu File.";
const TRIM =
  "How exactly the drives must be matched is not found in this page. " +
  "On the command line: wraparc trim FILE.";
const WAIT =
  "Solving the train some hundred times; this takes some seconds, " +
  "with the map up to half a minute …";

function matchForm() {
  const drives = app.doc.pulley.slice(1).map((p) => p.name || "");
  const choose = {
    id: "train-drive",
    value: state.drive,
    onChange: (/** @type {any} */ e) => {
      state.drive = e.currentTarget.value;
      redraw();
    },
  };
  const map = {
    type: "checkbox",
    id: "train-map",
    checked: state.map,
    onChange: (/** @type {any} */ e) => {
      state.map = e.currentTarget.checked;
      redraw();
    },
  };
  return h(
    "section",
    { class: "card", "aria-label": "Matching", key: "match" },
    h("h2", {}, "Matching the drives"),
    h(
      "div",
      { class: "bar" },
      h(
        "label",
        {},
        "Drive that is trimmed",
        h(
          "select",
          choose,
          drives.map((n) => h("option", { value: n, key: n }, n)),
        ),
      ),
      h("label", { class: "inline" }, h("input", map), "map of trim and load too"),
      h(
        "button",
        {
          type: "button",
          class: "main",
          disabled: !several() || state.matching,
          onClick: act(match),
        },
        "Work out how exactly they must be matched",
      ),
    ),
  );
}
/** @param {any} a */
const result = (a) =>
  h(
    "div",
    { key: "result" },
    verdict(judgedIf(now(), a.verdict)),
    list(a.remarks, "help"),
    h(
      "div",
      { class: "tables one" },
      (a.tables || []).map((/** @type {Table} */ t) =>
        table(t, ["drives", "cases"].includes(t.name)),
      ),
    ),
  );
/** @param {any} c */
const loadCase = (c) =>
  h(
    "figure",
    { class: "stage-svg", "aria-label": `Load case ${c.load_case}`, key: c.load_case },
    chain(c, limitsIn(c)),
  );
/** Limits of the creep and how each is kept, by pulley. @param {any} c */
const limitsIn = (c) =>
  new Map(
    ((known() ?? answer.full)?.arcs ?? [])
      .filter((a) => a.load_case === c.load_case)
      .map((a) => [a.pulley, { limit: a.creep_limit, level: now() === "fresh" && a.levels.creep }]),
  );
/** @param {any} m */
const matching = (m) =>
  h(
    "div",
    { key: "matching" },
    verdict(judgedIf(matchedNow(), m.verdict)),
    matchingPlots(m),
    h(
      "div",
      { class: "tables" },
      (m.tables || []).map((/** @type {Table} */ t) => table(t, t.name !== "drives")),
    ),
  );
