// The answer: the governing verdict, the arc that is chosen, its pictures and tables.

import { app, caseNames, look, painted } from "../../base/design.js";
import { sentence } from "../../base/server.js";
import { percent, show, title, words } from "../../base/units.js";
import { badge, judgedIf, list, standing, table, verdict } from "../../parts/answers.js";
import { choose } from "../../parts/choose.js";
import { asked, TENSIONS, toFillIn } from "../../parts/problems.js";
import { Component, createRef, h } from "../../vendor/preact.js";
import { raise, raiseAlone } from "./advice.js";
import { bars } from "./bars.js";
import { BySource } from "./by_source.js";
import { figures, peek, placeText, reading } from "./figures.js";
import { alongside, marched, Pictures, QUANTITIES } from "./pictures.js";
import { pins } from "./pins.js";
import { questions } from "./questions.js";
import { answer, known, onAnswer, whole, wholeArc } from "./solving.js";

/** @import { Children, FullArc, QuickAnswer } from "../../types.d.ts" */

/**
 * @typedef {{quantity: string, part: number}} ResultsState
 * @extends {Component<{}, ResultsState>}
 */
export class Results extends Component {
  /** @type {ResultsState} */
  state = { quantity: QUANTITIES[0], part: 0.5 };
  plots = createRef();
  pulley = createRef();
  scale = createRef();
  budget = createRef();
  bySource = /** @type {BySource | null} */ (null);
  /** @type {unknown[]} */
  drawn = [];
  answered = false;

  componentDidMount() {
    const pick = (/** @type {number} */ part) => this.setState({ part });
    const { plots, pulley, scale } = this;
    this.pictures = new Pictures(plots.current, pulley.current, scale.current, pick);
    this.bySource = new BySource(this.budget.current);
    onAnswer(() => this.forceUpdate());
    this.paint();
  }
  componentDidUpdate() {
    this.paint();
  }
  /** Draw what has changed. */
  paint() {
    const arc = answer.quick;
    if (!arc || !this.pictures || arc.status !== "solved") return this.painted(arc);
    const { quantity, part } = this.state;
    const now = [arc, app.units, quantity, marched(), alongside.turn];
    if (now.some((v, i) => v !== this.drawn[i])) {
      this.pictures.draw(arc, quantity);
      this.bySource?.draw(arc);
    }
    this.pictures.at(arc, part);
    this.painted(arc);
    this.drawn = now;
  }
  /** @param {QuickAnswer | null} arc */
  painted(arc) {
    if (arc && arc !== this.drawn[0])
      document.dispatchEvent(new CustomEvent("painted", { detail: arc.sequence }));
    if (arc && !answer.awaited && !this.answered) {
      this.answered = true;
      painted().then(() => performance.mark("answered"));
    }
    this.drawn = [arc];
  }
  render() {
    const { quick: arc, problems, slow, foreign, awaited } = answer;
    const refused = problems.length > 0;
    const waits = (awaited || !arc) && !refused && !app.gone;
    const cls = ["results", refused && "refused", slow && "waiting", waits && "awaited"];
    return h(
      "div",
      { class: cls.filter(Boolean).join(" "), id: "results" },
      h(
        "div",
        { class: "pick" },
        h("h2", {}, app.doc.title || "Drive without a title"),
        h("span", { role: "status" }, slow && "Solving …"),
        picks(),
      ),
      h("div", { role: "alert" }, refused && whatIsWrong(!foreign && arc !== null)),
      h(
        "div",
        {
          class: "answer",
          "data-stands": stood(),
          hidden: !arc || awaited || (refused && foreign),
        },
        arc && top(arc),
        bars((known() || answer.full)?.bars),
        questions(),
        this.body(arc),
      ),
      h("p", { class: "peek", "aria-hidden": "true" }, arc && !refused && peeked(arc)),
    );
  }
  /** @param {QuickAnswer | null} arc */
  body(arc) {
    const solved = arc?.status === "solved";
    const full = wholeArc();
    const late = arc?.own ? "before" : "";
    const least = (known() || answer.full)?.least_tension;
    return [
      arc && keyFigures(arc),
      h(
        "div",
        { class: "pair", key: "pair" },
        h("div", { key: "pulley" }, this.pulleyCard(solved), this.place(arc, solved)),
        this.alongTheWrap(arc, solved),
      ),
      h(
        "figure",
        { class: "card", ref: this.budget, key: "budget", hidden: !solved },
        h("figcaption", {}),
        h("div", { class: "bars" }),
      ),
      answer.full?.conditions && h("div", { key: "conditions" }, table(answer.full.conditions)),
      answer.full && h("div", { key: "checks" }, table((known() || answer.full).checks)),
      least && h("div", { key: "least" }, table(least.table)),
      answer.full?.summary && h("div", { class: late, key: "summary" }, table(answer.full.summary)),
      h("div", { class: `tables ${late}`, key: "tables" }, full && tables(full)),
    ];
  }
  /** @param {boolean} solved */
  pulleyCard(solved) {
    const choose = (/** @type {Event & {currentTarget: HTMLSelectElement}} */ e) =>
      this.setState({ quantity: e.currentTarget.value });
    return h(
      "figure",
      { class: "card" },
      h("div", { ref: this.pulley, hidden: !solved }),
      !solved && h("p", { class: "help" }, NO_PICTURE),
      h(
        "figcaption",
        { hidden: !solved },
        h("label", { for: "quantity" }, "Colour and inner ring: "),
        h(
          "select",
          { id: "quantity", onChange: choose, value: this.state.quantity },
          QUANTITIES.map((q) => h("option", { value: q, key: q }, title(q))),
        ),
        h("div", { class: "scale", ref: this.scale }),
      ),
    );
  }
  /** The plots along the wrap, one under the other on one axis.
   * @param {QuickAnswer | null} arc @param {boolean} solved */
  alongTheWrap(arc, solved) {
    return h(
      "section",
      { class: "card", "aria-label": "Along the wrap", key: "along", hidden: !solved },
      h("h2", {}, "Along the wrap"),
      h("div", { key: "pins" }, arc && solved && pins(arc)),
      h("div", { class: "plots", ref: this.plots, key: "plots" }),
    );
  }
  /** Every quantity at one place of the wrap.
   * @param {QuickAnswer | null} arc @param {boolean} solved */
  place(arc, solved) {
    const { part } = this.state;
    const move = (/** @type {Event & {currentTarget: HTMLInputElement}} */ e) =>
      this.setState({ part: +e.currentTarget.value / 1000 });
    const cursor = {
      type: "range",
      id: "cursor",
      min: 0,
      max: 1000,
      step: 5,
      value: Math.round(part * 1000),
      "aria-valuetext": arc ? placeText(arc, part) : "",
      onInput: move,
    };
    return h(
      "section",
      { class: "card along", "aria-label": "At one place", key: "place", hidden: !solved },
      h("label", { for: "cursor" }, "Place on the arc"),
      h("input", cursor),
      arc && solved && reading(arc, part),
    );
  }
}
/** @param {QuickAnswer} arc */
const top = (arc) => [h("div", { id: "verdict", key: "verdict" }, verdicts(arc)), chips(arc)];
const NO_PICTURE =
  "No picture: the belt is in gross slip on this pulley, so there is no state at rest to draw.";

/**
 * What keeps the drive from being solved.
 * @param {boolean} before whether an answer stands below
 */
function whatIsWrong(before) {
  const empty = answer.problems.filter(toFillIn);
  const n = answer.problems.length - empty.length;
  const below = before ? "; the answer below is of the last drive that could" : "";
  const not = answer.problems.filter((p) => p.beyond);
  if (not.length)
    return h(
      "div",
      { class: "verdict" },
      h("p", { class: "headline" }, badge("NOT CHECKED"), ` Not solved in this page${below}.`),
      list(not.map(sentence)),
    );
  const values = n === 1 ? "One value" : `${n} values`;
  const shown = answer.unplaced.length ? answer.unplaced : answer.problems;
  if (n > 0)
    return h(
      "div",
      { class: "verdict bad" },
      h("p", { class: "headline" }, badge("NOT CHECKED"), ` ${values} cannot be used${below}.`),
      list(shown.map(sentence)),
    );
  const these = before ? `These numbers are needed${below}.` : "These numbers are still needed:";
  return h(
    "div",
    { class: "verdict" },
    h("p", { class: "headline" }, these),
    list(answer.problems.flatMap(asked)),
  );
}

const stood = () => standing(answer.quickDoc === app.doc, answer.problems);
/** The load that the pulleys share, where it is begun and no load case: it is left out of all.
 * @param {QuickAnswer} arc */
function unsolved({ load_case: shown }) {
  const begun = app.doc.pulley.some((p) => TENSIONS.some((key) => p[key] != null));
  if (app.case || !begun || caseNames(app.doc)[0]?.split(",")[0] !== DESIGN) return null;
  if (shown.split(",")[0] === DESIGN) return null;
  return h(
    "p",
    { class: "verdict warn", role: "status", key: "unsolved" },
    badge("NOT CHECKED"),
    ` Load case ${DESIGN} lacks a tension and is left out. Shown is ${shown}.`,
  );
}
const DESIGN = "design";

/** The governing verdict over all load cases first, the arc that is chosen below it.
 * @param {QuickAnswer} arc */
function verdicts(arc) {
  const full = known() || answer.full;
  const several = app.doc.pulley.length > 1 || caseNames(app.doc).length > 1;
  const chosen = `Shown below: pulley ${arc.pulley}, load case ${arc.load_case}`;
  const all = known()?.least_tension?.raise_to;
  const worse = worstIn(known()?.arcs, arc.load_case);
  const own = h(
    "div",
    { class: "chosen", key: "chosen" },
    h(
      "p",
      {},
      h("strong", {}, chosen),
      " ",
      ...(!arc.level || stood() !== "fresh"
        ? [peek(arc)]
        : [badge(arc.level, arc.verdict.told), " ", words(arc.verdict.headline)]),
      worse && worse.level !== arc.level && [` Pulley ${worse.pulley}: `, badge(worse.level), "."],
      " ",
      known() && !all && raiseAlone(wholeArc()),
    ),
  );
  const lost = unsolved(arc);
  if (known() && full)
    return [
      lost,
      h(
        "div",
        { key: "governing" },
        verdict(judgedIf(lost ? "stale" : "fresh", full.verdict), null, raise(all)),
      ),
      several && own,
      whole() &&
        h("p", { class: "away", role: "status", key: "spoken" }, words(full.verdict.headline)),
    ];
  if (!several && arc.level)
    return [h("div", { key: "governing" }, verdict(judgedIf(stood(), arc.verdict)))];
  if (!full || answer.foreign)
    return [h("p", { class: "help", key: "governing" }, "All load cases are being solved."), own];
  const now = answer.problems.length ? "Before" : "All is being solved anew; before";
  const solving = h("p", { class: "help" }, `${now} the change:`);
  return [
    h("div", { key: "governing" }, verdict(judgedIf("computing", full.verdict), solving)),
    own,
  ];
}
/** One line for the phone: the verdict on the whole, and the arc that is shown.
 * @param {QuickAnswer} arc */
function peeked(arc) {
  const alone = app.doc.pulley.length < 2;
  if (alone && caseNames(app.doc).length < 2)
    return [badge(arc.level, arc.verdict?.told), peek(arc)];
  const all = known()?.verdict;
  const whose = alone ? arc.load_case : `${arc.pulley}, ${arc.load_case}`;
  return [
    all && badge(all.level, all.told),
    ` ${alone ? "all load cases" : "the whole drive"}; ${whose}:`,
    peek(arc),
  ];
}
/** What to know about the data. @param {QuickAnswer} arc */
function chips(arc) {
  const kinds = [...new Set((answer.full?.sources || []).map((x) => x.kind))];
  const out = arc.numbers.outside_tested_share;
  const { tested } = arc;
  const range =
    tested &&
    `p ${show(tested.pressure_min, "pressure", 3)} to ` +
      `${show(tested.pressure_max, "pressure", 3)}, slip to ${show(tested.slip_max, "length", 3)}`;
  /** @param {string} kind @param {Children} text */
  const chip = (kind, text) => h("span", { class: `mark ${kind}`, key: kind }, text);
  return h(
    "p",
    { class: "chips", key: "chips" },
    kinds.includes("illustrative") && chip("illustrative", "illustrative data: no real product"),
    kinds.includes("calibrated") && chip("calibrated", "calibrated data"),
    out > 0
      ? chip("outside", `outside the tested range on ${percent(out)} of the wrap`)
      : tested && arc.status === "solved" && chip("inside", `within the tested range (${range})`),
    (arc.remarks || []).map((r, i) => h("span", { class: "remark", key: i }, words(r))),
  );
}
/** @param {QuickAnswer} arc */
const keyFigures = (arc) =>
  h(
    "section",
    { class: "card", "aria-label": "Key figures", key: "figures" },
    h("h2", {}, "Key figures"),
    figures(arc),
  );

const LEVELS = ["OK", "ATTENTION", "FAILS", "FAULT OF THE PROGRAM"];
/** The pulley that comes off worst in a load case, the one that is chosen before its like.
 * @param {FullArc[] | undefined} arcs @param {string} name */
function worstIn(arcs, name) {
  const own = app.doc.pulley[app.pulley].name;
  const rank = (/** @type {FullArc} */ a) => 2 * LEVELS.indexOf(a.level) + +(a.pulley === own);
  const here = arcs?.filter((a) => a.load_case === name) ?? [];
  return here.sort((a, b) => rank(b) - rank(a))[0];
}
/** Choice of pulley and load case, where there are several: each case with what it comes to. */
function picks() {
  const names = app.doc.pulley.map((p) => p.name || "");
  const arcs = answer.problems.length ? undefined : known()?.arcs;
  const cases = arcs ? [...new Set(arcs.map((a) => a.load_case))] : caseNames(app.doc);
  const at = Math.max(0, cases.indexOf(app.case || cases[0]));
  const [usual] = caseNames(app.doc);
  const to = (/** @type {number} */ i) => look({ case: cases[i] === usual ? "" : cases[i] });
  /** @param {string} name @param {number} i */
  const chip = (name, i) => {
    const arc = worstIn(arcs, name);
    const whose = arc && arc.pulley !== names[app.pulley] ? `: ${arc.pulley}` : "";
    const share = arc?.status === "solved" && Math.abs(arc.numbers.exit_creep) / arc.creep_limit;
    const creeps = share ? percent(share) : arc?.short;
    return h(
      "button",
      {
        type: "button",
        key: name,
        "aria-pressed": i === at,
        onClick: () => to(i),
        title: share ? `Creep is ${creeps} of its limit: ${arc?.short}` : "",
      },
      arc ? badge(arc.level, `${name}${whose} ${creeps}`) : name,
    );
  };
  const many = cases.length > MANY;
  return h(
    "span",
    { class: "inline" },
    pick("pick-pulley", "Pulley", names, app.pulley, (i) => look({ pulley: i })),
    many && pick("pick-case", "Load case", cases, at, to),
    !many && cases.length > 1 && ["Load case ", h("span", CASES, cases.map(chip))],
  );
}
const MANY = 8; // load cases: more are a list
const CASES = {
  id: "cases",
  class: "inline cases",
  role: "group",
  "aria-label": "Load case",
  key: "cases",
};
/** @param {string} id @param {string} label @param {string[]} texts @param {number} at
 * @param {(i: number) => void} put */
const pick = (id, label, texts, at, put) =>
  texts.length > 1 &&
  h(
    "span",
    { key: id },
    h("label", { for: id }, `${label} `),
    choose(
      at,
      texts.map((t, i) => [i, t]),
      (i) => put(+i),
      id,
    ),
  );
/** @param {import("../../types.d.ts").FullArc} arc */
function tables(arc) {
  const first = ["answer", "comparison"];
  const sorted = arc.tables
    .filter((t) => t.key !== "creep")
    .sort((x, y) => +first.includes(y.key) - +first.includes(x.key));
  return [
    sorted.map((t) => table(t, t.key !== "inputs")),
    arc.table_sources.length > 0 &&
      h(
        "section",
        { class: "sources", "aria-label": "Sources", key: "sources" },
        h("h2", {}, "Sources"),
        h(
          "ol",
          {},
          arc.table_sources.map((x) => h("li", { key: x }, x)),
        ),
      ),
  ];
}
