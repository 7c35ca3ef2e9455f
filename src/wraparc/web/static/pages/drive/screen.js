// The first screen of a drive: load cases, verdict, the pulley and one curve, checks and what would
// change the creep. Everything else of the answer is below it, fetched when it is opened.

import {
  app,
  caseNames,
  change,
  gripped,
  look,
  painted,
  redraw,
  set,
  wrong,
} from "../../base/design.js";
import { AGAIN, act, askAgain, GONE, part, sentence } from "../../base/server.js";
import {
  besideUnit,
  digits,
  dimensionOf,
  percent,
  show,
  shown,
  si,
  split,
  title,
  trim,
  unit,
  words,
  written,
} from "../../base/units.js";
import { behind, fetchLate } from "../../frame/header.js";
import { views } from "../../frame/tabs.js";
import { BELOW, levelClass, lined, linesOf, list, standing } from "../../parts/answers.js";
import { choose, oneOf } from "../../parts/choose.js";
import { NEEDED, shownFields, spec } from "../../parts/field.js";
import { TENSIONS } from "../../parts/problems.js";
import { Curve } from "../../plots/curve.js";
import { follow, Stage } from "../../plots/stage.js";
import { Component, createRef, h } from "../../vendor/preact.js";
import { lacking } from "./cases.js";
import { shownCase } from "./condition.js";
import { assumed, givenLoad } from "./inputs.js";
import { keysOf, movedTo } from "./load.js";
import { questions } from "./questions.js";
import { fullTension, limits, scaleOf } from "./ranges.js";
import { answer, known, onAnswer, placeOf, solver, whole, wholeArc } from "./solving.js";
import { rank, worseThan, worstOf } from "./worst.js";

/** @import { Bar, Children, FullArc, Level, Problem } from "../../types.d.ts" */
/** @import { QuickAnswer } from "../../types.d.ts" */
/** @import { Handle, StageData } from "../../plots/stage.js" */
/** @import { CurveData } from "../../plots/curve.js" */

/** What is drawn along the wrap, by its name, and how it is called.
 * @type {[string, string][]} */
const QUANTITIES = [
  ["creep", "Creep"],
  ["shear_stress", "Shear"],
  ["friction_used", "Friction"],
  ["tension", "Tension"],
  ["wrap_pressure", "Pressure"],
];
/** What a hand that moves T2 keeps. @type {[string, string][]} */
const KEEPS = [
  ["pull", "Te"],
  ["t1", "T1"],
];
/** What is fetched when it is opened. */
const late = {
  details: /** @type {typeof import("./details.js") | null} */ (null),
  begin: /** @type {typeof import("./begin.js") | null} */ (null),
};
/** What a drive shows whose load is still to be typed, on the strands. */
function beginning() {
  const { conveyor, train, load_case, pulley } = app.doc;
  const given = TENSIONS.filter((key) => pulley[0][key] != null);
  const load = answer.problems.some((p) => TENSIONS.some((key) => p.path.endsWith(key)));
  const empty = answer.foreign && !(conveyor || train || load_case) && (given.length < 2 || load);
  if (!empty && !document.activeElement?.closest(".typed")) return null;
  const come = (/** @type {typeof late.begin} */ found) => {
    late.begin = found;
    redraw();
  };
  if (!late.begin && !app.lacks) part(() => import("./begin.js")).then(come, () => {});
  return late.begin;
}
/** The order of the checks, as it was when the hand last let go. */
const order = { of: /** @type {unknown} */ (null), titles: /** @type {string[]} */ ([]) };
/** @param {number} v */
const degrees = (v) => (v * 180) / Math.PI;

/**
 * @typedef {{quantity: string, part: number | null, keeps: string, check: string,
 *   open: boolean}} ScreenState
 * @extends {Component<{form: Children}, ScreenState>}
 */
export class Screen extends Component {
  /** @type {ScreenState} */
  state = { quantity: "creep", part: null, keeps: "pull", check: "", open: false };
  stageBox = createRef();
  curveBox = createRef();
  spoken = createRef();
  /** @type {unknown[]} */
  drawn = [];
  answered = false;

  componentDidMount() {
    const point = (/** @type {number | null} */ part) => {
      if (part !== this.state.part) this.setState({ part });
    };
    this.stage = new Stage(this.stageBox.current, (key, v) => this.move(key, v), point);
    this.curve = new Curve(this.curveBox.current, point);
    onAnswer(() => this.forceUpdate());
    this.paint();
  }
  componentDidUpdate() {
    this.paint();
    if (!gripped()) solver()?.find();
  }
  /** Draw what has changed. */
  paint() {
    const arc = answer.foreign ? null : answer.quick;
    const { quantity, part } = this.state;
    const mark = limits();
    const now = [
      arc,
      app.units,
      quantity,
      mark.t1,
      mark.t2,
      mark.wrap,
      app.doc,
      known(),
      answer.pinned,
    ];
    if (this.stage && this.curve && now.some((v, i) => v !== this.drawn[i])) {
      this.stage.draw(stageData(arc, quantity));
      this.curve.draw(curveData(arc, quantity));
    }
    this.stage?.at(part);
    this.curve?.at(part);
    if (arc && arc !== this.drawn[0])
      document.dispatchEvent(new CustomEvent("painted", { detail: arc.sequence }));
    if (arc && !answer.awaited && !this.answered) {
      this.answered = true;
      painted().then(() => performance.mark("answered"));
    }
    this.drawn = now;
  }
  /** A handle was moved to a value. @param {Handle} key @param {number} v [SI] */
  move(key, v) {
    const i = app.pulley;
    if (key === "wrap") {
      const at = ["pulley", i, "wrap_angle"];
      return change(set(app.doc, at, written(v, "angle", 5)), "wrap");
    }
    const n = answer.quick?.numbers;
    if (!n) return;
    const both = key === "t2" && this.state.keeps === "pull";
    const ends =
      key === "t1"
        ? [v, n.exit_tension]
        : [both ? n.entry_tension + v - n.exit_tension : n.entry_tension, v];
    change(movedTo(app.doc, i, shownCase(i), ends, 6), key);
  }
  render() {
    const { slow, foreign, awaited } = answer;
    const arc = foreign ? null : answer.quick; // nothing stands under another drive's name
    const refused = unsolved().length > 0;
    const waits = (awaited || !arc) && !refused && !app.gone;
    const how = stood();
    const begin = beginning();
    const cls = [
      "screen",
      refused && "refused",
      slow && "waiting",
      waits && "awaited",
      begin && "begins",
    ];
    return h(
      "div",
      {
        class: cls.filter(Boolean).join(" "),
        id: "results",
        "data-whole": whole() ? "yes" : undefined,
        "data-stands": how,
        "data-alone": alone() ? "yes" : undefined,
        "data-judged": known() ? "yes" : undefined,
      },
      h("div", { class: "sub" }, app.page === "drive" && views(), picks()),
      h(
        "div",
        { class: "frame" },
        this.props.form,
        h(
          "section",
          { class: "hero card", "aria-label": "Answer" },
          (!arc && begin?.verdict()) || verdict(arc, refused),
          this.drawing(arc, begin?.strands()),
          this.along(arc),
        ),
        this.checks(arc, begin?.beside),
      ),
      foot(arc, cut() && !silent() && [gone(SAFE), askNow()]),
      questions(),
      this.below(arc),
    );
  }
  /** @param {QuickAnswer | null} arc @param {Children} typed */
  drawing(arc, typed) {
    const both = arc && handles(arc).t2;
    return h(
      "div",
      { class: "stage-box" },
      h("figure", { class: "stage-svg", ref: this.stageBox }),
      typed,
      both &&
        h(
          "div",
          { class: "over" },
          h("span", { "aria-hidden": "true" }, "Dragging T2: fix"),
          oneOf("keeps", "Dragging T2: fix", this.state.keeps, KEEPS, (keeps) =>
            this.setState({ keeps }),
          ),
        ),
    );
  }
  /** The quantity that is drawn, and its values at the place that is pointed at.
   * @param {QuickAnswer | null} arc */
  along(arc) {
    const { quantity, part } = this.state;
    return h(
      "div",
      { class: "curve" },
      h(
        "div",
        { class: "curve-head" },
        oneOf("quantity", "Quantity shown on pulley and curve", quantity, QUANTITIES, (quantity) =>
          this.setState({ quantity }),
        ),
        h("output", {}, arc?.status === "solved" && reading(arc, part ?? 1)),
      ),
      h("figure", { class: "curve-box", ref: this.curveBox }),
    );
  }
  /** @param {QuickAnswer | null} arc @param {() => Children} [none] */
  checks(arc, none) {
    const full = wholeArc();
    const all = sorted(full);
    const chosen = all.find((b) => b.title === this.state.check) ?? all[0];
    return h(
      "aside",
      { class: "checks card", "aria-label": "Checks against their limits" },
      h("h2", {}, "Checks", all.length > 0 && h("span", {}, "bar: % of limit")),
      !arc && none?.(),
      h(
        "ul",
        { class: "list" },
        all.map((b) => checkOf(b, chosen === b, () => this.setState({ check: b.title }))),
      ),
      chosen && reasonOf(chosen, full),
      h("div", { class: "changes" }, changes(arc)),
      arc && sources(arc),
    );
  }
  /** What is under the fold. @param {QuickAnswer | null} arc */
  below(arc) {
    const toggle = async (/** @type {Event & {currentTarget: HTMLDetailsElement}} */ e) => {
      const { open } = e.currentTarget;
      if (open) late.details ??= await part(() => import("./details.js")).catch(() => null);
      this.setState({ open });
    };
    const { open, part: at } = this.state;
    const place = { at: at ?? 0.5, put: (/** @type {number} */ part) => this.setState({ part }) };
    const inside = open && late.details && arc ? h(late.details.Details, { arc, ...place }) : null;
    return fold("details", toggle, inside);
  }
}
/** What is under the fold, closed at first. @param {string} id @param {any} onToggle
 * @param {Children} inside */
export const fold = (id, onToggle, inside) =>
  h("details", { id, class: "card", onToggle }, h("summary", {}, "Details"), inside);
/** What keeps the load case that is looked at from being solved. */
const unsolved = () => (lacking() ? lackingKeys() : answer.problems);
const stood = () => standing(answer.quickDoc === app.doc, unsolved());

// The verdict.

const MEASURE = /(\d[\d.,]* [a-zA-Z%°]+(?:\/[a-z²³]+)?)/;
/** A sentence whose numbers stay beside their units. @param {Children} text @returns {Children} */
const unparted = (text) =>
  typeof text === "string"
    ? text
        .split(MEASURE)
        .map((part, i) => (i % 2 ? h("span", { class: "whole", key: i }, part) : part))
    : text;
/** So many lines stand apart below the sentence, two of them twice as tall. */
const MOST_APART = 3;
/** @param {Children} more @returns {number} */
const linesIn = (more) =>
  Array.isArray(more) ? more.reduce((n, m) => n + linesIn(m), 0) : Number(Boolean(more));
/** @param {Level | ""} level @param {Children} text @param {Children} more
 * @param {Children} [action] @param {Children} [alert] @param {string | null} [id]
 * @param {string} [label] what stands for the level */
export const said = (level, text, more, action, alert = null, id = "verdict", label = level) =>
  h(
    "div",
    { class: `say ${levelClass(level || null)} ${alert ? "refused-say" : ""}`, id },
    glyph(level || null, 28),
    h(
      "div",
      { role: "status", class: linesIn(more) > MOST_APART ? "" : "apart" },
      h(
        "p",
        { class: String(text).length > 60 ? "long" : "" },
        h(
          "span",
          {},
          level && h("span", { class: "level" }, label, h("span", { class: "away" }, ":"), " "),
          unparted(text),
        ),
      ),
      h("small", {}, more),
    ),
    h("div", { role: "alert", tabIndex: alert ? 0 : undefined }, alert),
    h("div", { class: "act" }, action),
  );
/** The verdict on the whole drive, with a way to the load case that governs. Until all of it is
 * known nothing is judged.
 * @param {QuickAnswer | null} arc @param {boolean} refused */
function verdict(arc, refused) {
  if (lacking()) return behind()?.caseLacks(lackingKeys()) ?? said("", "Missing.", "");
  if (refused) return notComputed(arc !== null);
  if (silent()) return said("", gone(arc && "Previous results."), SAFE, askNow());
  if (!arc) return said("", "Solving …", "");
  const how = stood();
  if (how !== "fresh") return said("", "Solving …", BELOW);
  const full = known();
  if (!full) return said("", creepOf(arc), "");
  const v = full.verdict;
  const does = action(v);
  const lines = linesOf({ ...v, action: whole() || !does ? v.action : null }, MOST_ALSO);
  if (full.unsearched && !does && !v.action && rank(v) > 0 && solver()?.hopeless())
    lines.unshift(["Action", HOPELESS]);
  const usual = assumed().join(", ");
  if (usual) lines.push(["Assumed", `${usual}.`]);
  const more = [alone() && lined([ALONE]), elsewhere(full.arcs, arc), lined(lines)];
  return said(v.level, words(v.text), more, does, null, undefined, v.label);
}
/** Further checks that the card has room for; all of them stand beside it. */
const MOST_ALSO = 1;
const HOPELESS = "No change tried here passes; the server searches combinations.";
/** Whether the page judges without the server. */
const alone = () => app.gone && !whole();
/** @type {import("../../parts/answers.js").Line} */
const ALONE = ["Server", "No answer: judged by this page alone."];
/** The tensions that the load case looked at still lacks. */
const lackingKeys = () =>
  givenLoad(app.pulley)?.keys.filter((key) => app.doc.pulley[app.pulley][key] == null) ?? [];
/** @param {QuickAnswer} arc */
const creepOf = (arc) =>
  arc.status === "solved"
    ? `${title("exit_creep")} ${shown("exit_creep", Math.abs(arc.numbers.exit_creep))}, ` +
      `${percent(use(arc))} of the limit.`
    : "Gross slip.";
const SAFE = `${AGAIN} Nothing typed is lost.`;
/** @param {Children} more */
const gone = (more) => h("span", { class: "gone", role: "alert" }, GONE, " ", more);
const askNow = () =>
  h("button", { type: "button", class: "main advice", onClick: askAgain }, "Calculate");
const cut = () => app.gone && !app.stranger && app.page === "drive";
/** Whether what is asked now waits for a server that is gone: the page solves most by itself. */
const silent = () => cut() && !answer.problems.length && stood() !== "fresh";
/** What keeps the drive from being solved. @param {boolean} before whether an answer stands */
function notComputed(before) {
  const { problems, unplaced } = answer;
  const not = problems.filter((p) => p.beyond);
  const reasons = not.length ? not : unplaced;
  const below = before ? BELOW : "";
  const head = not.length ? "Not solved in this page." : "Not computed.";
  if (reasons.length)
    return said("", "", "", null, [
      h("p", {}, `${head} ${below}`),
      list(reasons.map(sentence), "reasons"),
      mended(reasons),
    ]);
  return said("", missing(), below);
}
/** What mends an unknown key, fetched with all that is behind the first answer.
 * @param {Problem[]} problems */
function mended(problems) {
  if (!behind() && !app.lacks) fetchLate(null);
  return behind()?.mend(problems);
}
/** The fields that are wrong, each with its reason under it, or still to be filled in. */
export function missing() {
  const all = [...wrong.at];
  const bad = all.filter(([, text]) => text !== NEEDED);
  const names = new Set((bad.length ? bad : all).map(([key]) => nameOf(key)));
  return `${bad.length ? "Not computed" : "Missing"}: ${few([...names])}.`;
}
/** The first of what is listed, and how many more there are. @param {string[]} all */
function few(all) {
  const [a, b, c, ...more] = all;
  return [a, b, c, more[0] && `and ${more.length} more`].filter(Boolean).join(", ");
}
/** @param {string} key of a field */
function nameOf(key) {
  const [at, i] = key.split(",");
  const of = at === "pulley" && app.doc.pulley[1] ? `, pulley ${app.doc.pulley[+i].name}` : "";
  return `${shownFields.get(key)?.[0]}${of}`;
}
const use = (/** @type {QuickAnswer | FullArc} */ a) =>
  a.status === "solved" ? Math.abs(a.numbers.exit_creep) / a.creep_limit : Infinity;
/** The load case or pulley that governs, where another is looked at, and a way there.
 * @param {FullArc[]} arcs @param {QuickAnswer} arc */
function elsewhere(arcs, arc) {
  const here = arcs.find((a) => a.pulley === arc.pulley && a.load_case === arc.load_case);
  const worst = worstOf(arcs);
  if (!here || rank(worst) < 1 || worseThan(worst, here) >= -0.001) return null;
  const { pulley: name, load_case } = worst;
  const onClick = () => look({ case: load_case, pulley: placeOf(name) });
  const place = name === arc.pulley ? load_case : `${load_case}, ${name}`;
  const to = h("button", { type: "button", class: "link", onClick }, place);
  return h("span", { class: "line" }, h("b", {}, "Governing"), " ", to);
}
/** What helps, solved before it is offered. @param {{level: Level}} v @returns {Children} */
const action = (v) => (rank(v) < 1 ? null : (behind()?.offered() ?? solver()?.cure()));

// Load cases.

/** The pulley that comes off worst in a load case, the one that is looked at before its like.
 * @param {FullArc[] | undefined} arcs @param {string} name @param {string | undefined} own */
function worstIn(arcs, name, own) {
  const here = arcs?.filter((a) => a.load_case === name) ?? [];
  const mine = (/** @type {FullArc} */ a) => +(a.pulley === own);
  return here.sort((a, b) => rank(b) - rank(a) || mine(b) - mine(a) || worseThan(a, b))[0];
}
/** Choice of pulley and load case: each case with what it comes to.
 * @param {string} [of] another view, whose names of parts are its own */
export function picks(of = "") {
  const names = app.doc.pulley.map((p) => p.name || "");
  const fresh = lacking() ? !answer.problems.length : stood() === "fresh";
  const arcs = fresh ? known()?.arcs : undefined;
  const cases =
    arcs && !lacking() ? [...new Set(arcs.map((a) => a.load_case))] : caseNames(app.doc);
  const at = Math.max(0, cases.indexOf(app.case || cases[0]));
  const to = (/** @type {number} */ i) => look({ case: cases[i] });
  const lacks = lacking() ? `${spec("tensions", lackingKeys()[0]).symbol}?` : "–";
  const chip = (/** @type {string} */ name, /** @type {number} */ i) => {
    const own = of === "-train" ? undefined : names[app.pulley]; // there all are seen at once
    const arc = worstIn(arcs, name, own);
    const whose = own && arc && arc.pulley !== own ? `: ${arc.pulley}` : "";
    const most = arc && (arc.status === "solved" ? short(mostUsed(arc)) : "slips");
    const spoken = arc ? `Highest use of a limit: ${most}; ${arc.short}` : "";
    return h(
      "button",
      {
        type: "button",
        class: "chip",
        key: name,
        "aria-pressed": i === at,
        onClick: () => to(i),
        title: spoken,
      },
      glyph(arc?.level ?? null),
      h("span", {}, `${name}${whose}`),
      " ",
      h("i", { class: levelClass(arc?.level) }, most ?? (arcs ? lacks : "–")),
    );
  };
  const many = cases.length > MANY;
  return h(
    "span",
    { class: "chips" },
    pick(`pick-pulley${of}`, "Pulley", names, app.pulley, (i) => look({ pulley: i })),
    many && pick(`pick-case${of}`, "Load case", cases, at, to),
    !many && [
      h("span", { class: "cw", key: "of" }, "Load case"),
      h("span", { ...CASES, id: `cases${of}` }, cases.map(chip)),
      !app.doc.conveyor &&
        !app.doc.train &&
        h(
          "button",
          {
            type: "button",
            class: "chip",
            key: "add",
            "aria-label": "Add a load case",
            onClick: more,
          },
          "+",
        ),
    ],
  );
}
const more = act(async () => (await part(() => import("./add_case.js"))).addCase());
/** The highest use of any limit. @param {FullArc} arc */
const mostUsed = ({ bars }) => Math.max(0, ...bars.map(used));
/** A share that a chip has room for. @param {number} v */
const short = (v) => (v < 10 ? percent(v) : ">999 %");
const MANY = 6; // load cases: more are a list
const CASES = {
  class: "cases",
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

// Checks and what would change the creep.

/** Glyphs of the levels, as paths in a square of 14. @type {Record<string, string>} */
const GLYPHS = {
  OK: "M2 7.5 5.5 11 12 3.5",
  ATTENTION: "M7 1 13.5 13H.5zM7 5v4M7 10.2v1.4",
  FAILS: "M7 1a6 6 0 1 1-.01 0M4.5 4.5l5 5m0-5-5 5",
};
/** @param {Level | null} level @param {number} [n] size */
export function glyph(level, n = 13) {
  const d = level ? (GLYPHS[level] ?? GLYPHS.FAILS) : "";
  const path = level
    ? h("path", { d, class: "stroke" })
    : h("circle", { cx: 7, cy: 7, r: 5, class: "stroke dashed" });
  const size = { width: n, height: n, viewBox: "0 0 14 14", "aria-hidden": "true" };
  return h("svg", { class: `g ${levelClass(level)}`, ...size }, path);
}
/** How much of a limit is used. @param {Bar} b */
const used = (b) => (b.at_most ? b.share : 1 / b.share);
/** @param {Bar[]} bars */
export const worstFirst = (bars) =>
  [...bars].sort((a, b) => rank(b) - rank(a) || used(b) - used(a));
/** The checks of an arc, worst first; while a hand moves something, in the order of before.
 * @param {FullArc | undefined} full @returns {Bar[]} */
function sorted(full) {
  const bars = full?.bars ?? [];
  const of = `${full?.pulley} ${full?.load_case}`;
  if (!gripped() || order.of !== of) {
    const all = worstFirst(bars);
    Object.assign(order, { of, titles: all.map((b) => b.title) });
    return all;
  }
  return order.titles.map((title) => bars.find((b) => b.title === title) ?? { ...NOT_MADE, title });
}
/** @typedef {Bar & {pulley?: string}} Checked pulley: where several are shown
 * @param {Checked} b */
const inFull = (b) => (b.pulley ? `${b.title}, ${b.pulley}` : b.title);
/** A check against its limit. @param {Checked} b @param {boolean} chosen @param {() => void} choose
 * @param {string} [of] where its reason stands */
export function checkOf(b, chosen, choose, of = "why") {
  const cls = levelClass(b.level);
  const width = Math.max(1, Math.min(100, 50 * (used(b) > 0 ? used(b) : 2)));
  return h(
    "li",
    { key: inFull(b), class: cls },
    h(
      "button",
      { type: "button", "aria-expanded": chosen, "aria-controls": of, onClick: choose },
      glyph(b.level),
      h(
        "span",
        { class: `n ${cls}`, title: inFull(b) },
        b.title,
        h("span", { class: "away" }, b.pulley && `, ${b.pulley}`, `, ${b.level}`),
      ),
      h("span", { class: "v" }, h("b", { class: cls }, words(b.found)), " ", atLimit(b)),
      h(
        "span",
        { class: "use" },
        h("u", { class: cls, style: { width: `${width}%` } }),
        h("s", {}),
      ),
    ),
  );
}
/** A check that is not made at the place where the hand is. */
const NOT_MADE = /** @type {Bar} */ ({
  title: "",
  level: "NOT CHECKED",
  place: "",
  at_most: true,
  share: 0,
  found: "–",
  limit: "",
  says: "",
  source: "",
});
/** The limit of a check, without the unit that its value has. @param {Bar} b */
const atLimit = (b) => `${b.at_most ? "≤" : "≥"} ${besideUnit(b.limit, b.found)}`;
const sense = (/** @type {Bar} */ b) => (b.at_most ? "max" : "min");
/** Reason, place and source of a check. @param {Checked} b @param {FullArc | undefined} full */
export function reasonOf(b, full, id = "why") {
  const told = answer.full?.arcs
    .find((a) => a.pulley === full?.pulley && a.load_case === full?.load_case)
    ?.bars.find((x) => x.title === b.title);
  return h(
    "div",
    { class: "why", id, role: "region", "aria-label": "Reason and source", tabIndex: 0 },
    h("h3", {}, `${inFull(b)}: ${percent(b.share)} of the limit`),
    h("p", {}, words(b.says) || `${words(b.found)}, ${sense(b)} ${words(b.limit)}.`),
    h("p", { class: "src" }, [words(b.place), b.source || told?.source].filter(Boolean).join(". ")),
  );
}
/** Effect of changes, and reserve; until they are there, what has their place.
 * @param {QuickAnswer | null} arc */
const changes = (arc) =>
  solver()?.pane() ?? (arc && !app.gone ? [h("h2", {}, "Effect of changes"), bones()] : null);
export const bones = () =>
  h(
    "ul",
    { class: "ways", "aria-hidden": "true" },
    [1, 2, 3, 4, 5].map((i) => h("li", { key: i }, h("span", { class: "way bone" }))),
  );
const PARTS = [
  ["creep_shrinkage", "belt shrinks", "q2"],
  ["creep_compression", "lagging", "q3"],
  ["creep_global", "slips back", "q1"],
];
/** Where the creep comes from. @param {QuickAnswer} arc */
function sources({ status, numbers: n }) {
  if (status !== "solved" || !n.exit_creep) return null;
  const parts = PARTS.map(([key, name, cls]) => ({ name, cls, share: n[key] / n.exit_creep }));
  return h(
    "div",
    { class: "sources3" },
    h("h2", {}, "Creep by cause"),
    h(
      "div",
      { class: "src3", "aria-hidden": "true" },
      parts.map((p) =>
        h("i", { class: p.cls, key: p.cls, style: { width: `${Math.max(0, 100 * p.share)}%` } }),
      ),
    ),
    h(
      "div",
      { class: "key" },
      parts.map((p) => h("span", { key: p.cls }, p.name, " ", h("b", {}, percent(p.share, 2)))),
    ),
  );
}
/** What the data is worth. @param {QuickAnswer | null} arc @param {Children} [more] */
export function foot(arc, more) {
  const kinds = [...new Set((answer.full?.sources || []).map((x) => x.kind))];
  const out = arc?.numbers.outside_tested_share;
  const range =
    out > 0
      ? `Outside the tested range on ${percent(out)} of the wrap.`
      : arc?.tested && arc.status === "solved" && "All within the tested range.";
  const all = (arc?.remarks || []).map(words).join(" ");
  return h(
    "div",
    { class: "foot-line", title: all },
    kinds.includes("illustrative") &&
      h("span", { class: "mark illustrative" }, "Illustrative data: no real product."),
    kinds.includes("calibrated") && h("span", { class: "mark calibrated" }, "Calibrated data."),
    h("span", { class: out > 0 ? "mark outside" : "" }, range),
    more,
  );
}

// The drawing.

/** Handles of what can be moved. @param {QuickAnswer} arc @returns {StageData["handles"]} */
function handles(arc) {
  const i = app.pulley;
  const { doc } = app;
  const n = arc.numbers;
  const k = shownCase(i);
  const given = k < 0 ? TENSIONS.filter((key) => doc.pulley[i][key] != null) : keysOf(doc, i, k);
  const own = !doc.conveyor && !doc.train && given.length > 1;
  /** @param {string} label @param {string} key @param {string} of @param {number} now */
  const handle = (label, key, of, now) => {
    const { least = now, most = now } = scaleOf(key) ?? {};
    const [, size] = unit(of);
    const step = size * 10 ** (Math.floor(Math.log10(most / size)) - 2);
    return { label, now, least, most, text: written(now, of, 4), unit: size, step };
  };
  const wrap =
    split(doc.pulley[i].wrap_angle) && handle("Wrap angle", "wrap_angle", "angle", wrapOf(arc));
  return {
    ...(own && {
      t1: handle("Tight-side tension T1", "entry_tension", "force", n.entry_tension),
      t2: handle("Slack-side tension T2", "exit_tension", "force", n.exit_tension),
    }),
    ...(wrap && { wrap }),
  };
}
/** Wrap of an arc [rad], also of one without a course. @param {QuickAnswer} arc */
function wrapOf(arc) {
  const at = arc.profile.position;
  if (at?.length) return +at[at.length - 1].toPrecision(10);
  return si(app.doc.pulley[app.pulley].wrap_angle, "angle") || Math.PI;
}
/** @param {QuickAnswer | null} arc @param {string} q @returns {StageData} */
function stageData(arc, q) {
  const solved = arc?.status === "solved";
  const n = arc?.numbers ?? {};
  const [t1, t2] = [n.entry_tension ?? 0.7, n.exit_tension ?? 0.3];
  const p = arc?.profile ?? {};
  const phi = arc ? wrapOf(arc) : Math.PI;
  const values = solved ? p[q] : [0, 0];
  const limit = solved && q === "creep" ? arc.creep_limit : 0;
  const most = Math.max(...values.map(Math.abs), limit * 1.02, 1e-30);
  const of = limits();
  const fresh = arc && answer.quickDoc === app.doc;
  const [u, f] = unit(dimensionOf(q));
  const force = (/** @type {number} */ v) => show(v, "force", 3);
  /** @param {number | null} v @returns {[number, string] | undefined} */
  const mark = (v) => (v === null ? undefined : [v, `limit at ${force(v)}`]);
  const marks = { t1: mark(of.t1), t2: mark(of.t2), wrap: mark(of.wrap) };
  const [, name] = QUANTITIES.find(([key]) => key === q) ?? ["", ""];
  return {
    phi,
    t1: Math.abs(t1),
    t2: Math.abs(t2),
    full: arc ? fullTension(t1, t2) : 1,
    position: solved ? p.position : [0, phi],
    tension: solved ? p.tension : [t1, t2],
    values,
    most,
    limit,
    level: levelClass(arc && fresh ? creepLevel(arc) : null),
    solved,
    hub: hub(arc),
    figures: arc ? figuresOf(n) : [],
    legend: solved
      ? `${name.toLowerCase()} to ${digits(+trim((limit || most) / f, 3))} ${u}` +
        (limit ? ", orange above" : "")
      : "",
    told: arc
      ? `Pulley with its wrapped arc; ${hub(arc).filter(Boolean).join(" ")}`
      : "Pulley, not solved yet",
    texts: {
      t1: arc ? `T1 ${force(t1)}` : "T1",
      t2: arc ? `T2 ${force(t2)}` : "T2",
      wrap: arc ? `${digits(degrees(phi))}°` : "",
    },
    handles: arc && !answer.problems.length ? handles(arc) : {},
    marks: fresh ? /** @type {StageData["marks"]} */ (marks) : {},
  };
}
/** @type {[string, string][]} */
const FIGURES = [
  ["Effective tension Te", "effective_tension"],
  ["Power", "transmitted_power"],
  ["T1 / T2", "tension_ratio"],
  ["Power lost to creep", "power_loss"],
];
/** Of several pulleys it is said that the loss is of one. @param {Record<string, any>} n
 * @returns {[string, string][]} */
const figuresOf = (n) =>
  FIGURES.map(([label, key]) => [
    key === "power_loss" && app.doc.pulley.length > 1 ? "Power lost here" : label,
    figure(key, n),
  ]);
/** @param {string} key @param {Record<string, any>} n */
const figure = (key, n) =>
  key === "transmitted_power"
    ? shown(key, n[key] ?? (n.effective_tension * si(app.doc.belt.speed, "speed") || null), 3)
    : shown(key, n[key], 3);
/** @param {QuickAnswer} arc @returns {Level} */
function creepLevel(arc) {
  if (arc.status !== "solved") return "FAILS";
  if (arc.levels.creep && !arc.own) return arc.levels.creep;
  return use(arc) > 1 ? "ATTENTION" : "OK";
}
/** What stands in the hub: one number, and what it is held against.
 * @param {QuickAnswer | null} arc */
function hub(arc) {
  const [u, f] = unit("length");
  if (!arc) return ["creep at exit", `– ${u}`, "", "", ""];
  const { numbers: n, creep_limit: limit } = arc;
  if (arc.status !== "solved") return ["gross slip", "slips", "", "no state at rest", ""];
  const turns = n.effective_tension < 0 ? "brakes; " : n.effective_tension ? "" : "idles; ";
  const creep = digits(Math.abs(n.exit_creep) / f);
  return [`${turns}creep at exit`, creep, u, `limit ${show(limit, "length")}`, percent(use(arc))];
}
/** @param {QuickAnswer | null} arc @param {string} q @returns {CurveData} */
function curveData(arc, q) {
  const solved = arc?.status === "solved";
  const [u, f] = unit(dimensionOf(q));
  const limit = solved && q === "creep" ? arc.creep_limit : 0;
  const slips = arc && !solved;
  const pull = Math.abs(arc?.numbers.effective_tension ?? 0);
  const margin = wholeArc()?.bars.find((b) => b.name === "gross_slip")?.value ?? 0;
  /** @type {[string, number, string][]} */
  const bars = [["Required Te", pull, show(pull, "force", 3)]];
  if (slips && margin > 0)
    bars.push(["Transmissible Te", pull * margin, show(pull * margin, "force", 3)]);
  const scaled = (/** @type {string} */ key) => (solved ? arc.profile[key].map((v) => v / f) : []);
  return {
    wrap: degrees(arc ? wrapOf(arc) : Math.PI),
    position: solved ? arc.profile.position : [0, 1],
    values: scaled(q),
    limit: limit / f,
    limitText: limit ? `limit ${show(limit, "length")}` : "",
    beside: solved ? (q === "friction_used" ? scaled("friction") : pinnedCourse(arc, q, f)) : null,
    bars: slips ? bars : [],
    note: slips ? "Gross slip: no curve." : arc ? "" : "No result yet.",
    told: `${title(q)} along the wrap${u && ` [${u}]`}`,
  };
}
/** What was pinned, at the same shares of the wrap. @param {QuickAnswer} arc @param {string} q
 * @param {number} f */
function pinnedCourse({ profile: { position } }, q, f) {
  const of = answer.pinned;
  const at = of && follow(of.position, of[q]);
  return at && position.map((v) => at(v / position[position.length - 1]) / f);
}
/** @param {QuickAnswer} arc @param {number} part @returns {Children[]} */
function reading({ profile: p }, part) {
  const value = (/** @type {string} */ key) => Math.abs(follow(p.position, p[key])(part));
  const at = `${digits(degrees(part * p.position[p.position.length - 1]))}°`;
  const [u, f] = unit("pressure");
  const bold = (/** @type {string} */ text) => h("b", {}, text);
  const pressure = (/** @type {string} */ key) => bold(digits(value(key) / f));
  return [
    ...["at ", bold(at), ": creep ", bold(shown("creep", value("creep"), 3))],
    ...[", shear ", pressure("shear_stress"), ", pressure ", pressure("wrap_pressure"), ` ${u}`],
  ];
}
