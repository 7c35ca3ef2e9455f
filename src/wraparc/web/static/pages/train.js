// Several drives on one belt: shares, speeds, and how exactly they must be matched.
import { app, redraw } from "../base/design.js";
import { aborted, act, ask, complain, later, onReturn, refusal } from "../base/server.js";
import { PAGES } from "../frame/registry.js";
import {
  judgedIf,
  list,
  refused,
  scroll,
  standing,
  stands,
  table,
  verdict,
} from "../parts/answers.js";
import { mark } from "../parts/problems.js";
import { h } from "../vendor/preact.js";
import { chain } from "./train/chain.js";
import { trainInputs } from "./train/inputs.js";
import { matchingPlots } from "./train/plots.js";

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
  if (state.of === app.doc) return;
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
export const Page = () =>
  h(
    "div",
    { class: "two" },
    trainInputs(state.answer),
    h(
      "div",
      { class: "results" },
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
    ),
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
    h("div", { class: "plots" }, a.load_cases.map(loadCase)),
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
    "section",
    { class: "card", "aria-label": `Load case ${c.load_case}`, key: c.load_case },
    h("h2", {}, `Load case ${c.load_case}`),
    c.reason && h("p", { class: "error" }, c.reason),
    scroll(`Drives in load case ${c.load_case}`, chain(c)),
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
