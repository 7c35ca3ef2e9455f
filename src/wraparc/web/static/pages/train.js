// Several drives on one belt: shares, speeds, and how exactly they must be matched.
import { app, gripped, look, redraw } from "../base/design.js";
import { aborted, act, ask, complain, later, onReturn, refusal } from "../base/server.js";
import { percent, show, shown } from "../base/units.js";
import { behind } from "../frame/header.js";
import { PAGES } from "../frame/registry.js";
import { list, standing } from "../parts/answers.js";
import { checked, facts, framed, marked, renewed, saying, silent } from "../parts/framed.js";
import { mark } from "../parts/problems.js";
import { judgedIf, stands, table, verdict } from "../parts/tables.js";
import { h } from "../vendor/preact.js";
import { picks as casePicks } from "./drive/screen.js";
import { answer, known } from "./drive/solving.js";
import { rank } from "./drive/worst.js";
import { chain } from "./train/chain.js";
import { addPulley, trainInputs } from "./train/inputs.js";
import { matchingPlots } from "./train/plots.js";
import { changes, reasons, shareBar, trimStrip } from "./train/strips.js";

/** @import { Refused } from "../parts/framed.js" */
/** @import { Design, Table } from "../types.d.ts" */

const state = {
  answer: /** @type {any} */ (null),
  /** The drive that it is of. */
  doc: /** @type {Design | null} */ (null),
  of: /** @type {Design | null} */ (null),
  opened: -1,
  problems: /** @type {Refused} */ ([]),
  /** How exactly drives must be matched, by load case and drive. */
  matched: /** @type {Record<string, any>} */ ({}),
  matching: "",
  /** The drive whose trim is explained. */
  drive: "",
};
const several = () => app.doc.pulley.length > 1;
const trimmed = () => app.doc.pulley.slice(1).map((p) => p.name || "");
export function update() {
  const names = trimmed();
  if (!names.includes(state.drive)) state.drive = names[0] || "";
  const { doc } = app;
  renewed(state, { answer: null, matched: {} });
  if (state.of === doc || gripped()) return;
  state.of = doc;
  if (several()) solve(app.doc);
  else Object.assign(state, { answer: null, doc: null, matched: {}, problems: [] });
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
    Object.assign(state, { answer, doc, matched: {}, problems: [] });
    mark([]);
  } catch (x) {
    if (aborted(x) || app.gone || doc !== app.doc) return;
    state.problems = marked(refusal(x));
  }
  redraw();
});
/** @param {string} load_case @param {string} drive */
const keyOf = (load_case, drive) => `${load_case}\n${drive}`;
/** Find how exactly drives must be matched in a load case.
 * @param {string} load_case @param {string[]} drives @param {boolean} map of trim and load too */
async function match(load_case, drives, map) {
  const doc = app.doc;
  try {
    for (const drive of drives) {
      state.matching = drive;
      redraw();
      const asked = { document: doc, load_case, drive, match: true, map, points: 41 };
      const answer = await ask("train", asked);
      if (doc !== app.doc) break;
      state.matched[keyOf(load_case, drive)] = answer.matching;
    }
  } catch (x) {
    complain(x);
  }
  state.matching = "";
  redraw();
}

const now = () => (several() ? standing(state.doc === app.doc, state.problems) : "fresh");
/** The load case that is looked at. @param {any} a the answer */
const shownIn = (a) =>
  a.load_cases.find((/** @type {any} */ c) => c.load_case === app.case) ?? a.load_cases[0];

export const picks = () => casePicks("-train");
export const Page = () => {
  const a = several() ? state.answer : null;
  const c = a && shownIn(a);
  const how = now();
  const m = c?.drives.find((/** @type {any} */ d) => d.pulley === state.drive);
  return framed(
    {
      of: "train",
      how: c && how === "fresh" ? standing(Boolean(known()), answer.problems) : how,
      form: trainInputs(a),
      say: c
        ? saying(how, a.verdict, more(a, c, m), action(a, c), state.problems)
        : several()
          ? saying(how, /** @type {any} */ (null), "", null, state.problems)
          : silent("One pulley takes the whole load.", "", adding()),
      drawing: c ? loadCase(c) : !several() && h("p", { class: "help intro" }, SHARED),
      curve: c && [
        c.reason && h("p", { class: "error", key: "reason" }, c.reason),
        c.drives.every((/** @type {any} */ d) => d.share != null) && shareBar(c),
        c.drives.map((/** @type {any} */ d, /** @type {number} */ i) =>
          trimStrip(c, i, keptIn(c, d.pulley), chooser(d.pulley)),
        ),
      ],
      tall: app.doc.pulley.length > 3,
      side: c && [
        checked("train", barsOf(c)),
        m?.drum_ratio && facts(`Why ${m.pulley} turns ${turns(m)}`, reasons(m)),
        m && facts("If something changes", changes(m)),
      ],
    },
    a && stands(how, result(a)),
    c && (PAGES.saved ? matchings(c) : h("p", { class: "help", key: "trim" }, TRIM)),
  );
};
const SHARED = "Drives on one belt share its load: their speeds and speed tolerances appear here.";
const adding = () =>
  h("button", { type: "button", class: "main advice", onClick: addPulley }, "Add a second drive");
/** @param {any} c @param {string} drive */
const matchedIn = (c, drive) => state.matched[keyOf(c.load_case, drive)];
/** @param {any} c @param {string} drive */
function keptIn(c, drive) {
  const m = now() === "fresh" && matchedIn(c, drive);
  return m ? keeping(c, m) : null;
}
/** Choose the drive that is explained, where there are several. @param {string} drive */
const chooser = (drive) =>
  app.doc.pulley.length > 2
    ? {
        pressed: drive === state.drive,
        put: () => {
          state.drive = drive;
          redraw();
        },
      }
    : null;
/** The checks of a load case, with their pulleys. @param {any} c */
const barsOf = (c) => arcsOf(c).flatMap((x) => x.bars.map((b) => ({ ...b, pulley: x.pulley })));
/** What to do, where else it is worse, or how the drives turn.
 * @param {any} a @param {any} c @param {any} m */
function more(a, c, m) {
  const at = a.load_cases.indexOf(c);
  const levels = a.judged.map(rank);
  const worst = levels.indexOf(Math.max(...levels));
  const elsewhere = a.load_cases[worst].load_case;
  const to = () => look({ case: elsewhere });
  if (levels[worst] > levels[at])
    return h(
      "span",
      { class: "line" },
      h("b", {}, "Governing"),
      " ",
      h("button", { type: "button", class: "link", onClick: to }, elsewhere),
    );
  return a.verdict.action ? null : slower(m, c.drives[0]);
}
/** How much slower or faster a drum turns than the first. @param {any} m */
const turns = (m) =>
  `${percent(Math.abs(m.drum_ratio - 1), 3)} ${m.drum_ratio < 1 ? "slower" : "faster"}`;
/** @param {any} m @param {any} first */
const slower = (m, first) =>
  m?.drum_ratio > 0 ? `Run ${m.pulley} ${turns(m)} than ${first.pulley}.` : undefined;
/** What helps, with its number; where all is kept, how exactly the drives must be matched.
 * @param {any} a @param {any} c */
function action(a, c) {
  if (rank(a.verdict) <= 0) return toMatch(c);
  return now() === "fresh" && behind()?.offered();
}
/** The limits of the trims, on a press. @param {any} c */
const toMatch = (c) =>
  PAGES.saved &&
  !trimmed().every((drive) => matchedIn(c, drive)) &&
  h(
    "button",
    {
      type: "button",
      class: "main advice",
      disabled: Boolean(state.matching) || now() !== "fresh",
      onClick: act(() => match(c.load_case, trimmed(), false)),
    },
    state.matching ? "Calculating …" : "Find the trim limits",
  );
const TRIM =
  "This page does not calculate speed tolerances. On the command line: wraparc trim FILE.";

/** How exactly each drive must be matched. @param {any} c */
const matchings = (c) => trimmed().map((drive) => matching(c, drive));
/** @param {any} c @param {string} drive */
function matching(c, drive) {
  const m = matchedIn(c, drive);
  const find = act(() => match(c.load_case, [drive], true));
  return h(
    "section",
    { class: "card", "aria-label": `Matching of ${drive}`, key: `match ${drive}` },
    h("h2", {}, `Speed tolerance, ${drive}`),
    !m?.map &&
      h(
        "button",
        { type: "button", disabled: Boolean(state.matching), onClick: find },
        state.matching === drive ? "Calculating …" : "Draw the map of trim and load",
      ),
    state.matching === drive &&
      h("p", { class: "help", role: "status" }, "Some hundred solves: up to half a minute."),
    m &&
      stands(
        now(),
        verdict(judgedIf(now(), m.verdict)),
        matchingPlots(m),
        h(
          "div",
          { class: "tables" },
          (m.tables || []).map((/** @type {Table} */ t) => table(t, t.name !== "drives")),
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
/** The arcs of a load case, solved. @param {any} c */
const arcsOf = (c) =>
  ((known() ?? answer.full)?.arcs ?? []).filter((a) => a.load_case === c.load_case);
/** @param {any} c */
function loadCase(c) {
  const arcs = arcsOf(c);
  // a page without a server has no course along the wrap
  const most = Math.max(0, ...arcs.flatMap((a) => a.profile?.shear_stress?.map(Math.abs) ?? []));
  const of = new Map(
    arcs.map(({ pulley, creep_limit: limit, levels, profile: p }) => [
      pulley,
      {
        ...{ limit, position: p?.position, shear: p?.shear_stress },
        level: now() === "fresh" && levels.creep,
      },
    ]),
  );
  const sum = (/** @type {string} */ key) =>
    arcs.reduce((all, { numbers: n }) => all + (n[key] ?? Number.NaN), 0);
  /** @type {[string, string][]} */
  const figures = [
    ["Effective tension Te", "effective_tension"],
    ["Power", "transmitted_power"],
    ["Power lost, all drives", "power_loss"],
  ];
  const told = figures.filter(([, key]) => Number.isFinite(sum(key)));
  return [
    h(
      "figure",
      { class: "stage-svg", "aria-label": `Load case ${c.load_case}`, key: c.load_case },
      chain(c, of, most),
    ),
    h(
      "dl",
      { class: "kv sums", key: "sums" },
      told.map(([name, key]) =>
        h("div", { key }, h("dt", {}, name), h("dd", {}, h("b", {}, shown(key, sum(key), 3)))),
      ),
    ),
    most > 0 &&
      h("p", { class: "legend", key: "legend" }, `colour: shear, to ${show(most, "pressure", 3)}`),
  ];
}
/** Trims with which every drive keeps its creep limit, by what was found over the trim.
 * @param {any} c @param {any} m */
function keeping(c, m) {
  const [curve] = m.curves;
  const arcs = arcsOf(c);
  const kept = curve.values.filter((/** @type {number} */ _, /** @type {number} */ k) =>
    arcs.every((a) => Math.abs(curve.exit_creep[a.pulley][k] ?? Infinity) <= a.creep_limit),
  );
  if (!kept.length) return null;
  const step = curve.values[1] - curve.values[0];
  const marks = curve.marks.filter((/** @type {any} */ k) => k.what === "creep_limit");
  return [kept[0], kept[kept.length - 1]].map(
    (end) => marks.find((/** @type {any} */ k) => Math.abs(k.at - end) < step)?.at ?? end,
  );
}
