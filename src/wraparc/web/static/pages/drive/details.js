// Everything that an answer has besides the first screen. Fetched when it is opened.
import { app, caseNames } from "../../base/design.js";
import { words } from "../../base/units.js";
import { standing } from "../../parts/answers.js";
import { judgedIf, table, verdict } from "../../parts/tables.js";
import { Component, createRef, h } from "../../vendor/preact.js";
import { after } from "./after.js";
import { BySource } from "./by_source.js";
import { figures, placeText, reading } from "./figures.js";
import { alongside, marched, Pictures } from "./pictures.js";
import { pins } from "./pins.js";
import { answer, known, wholeArc } from "./solving.js";
import { offered } from "./way.js";

/** @import { FullArc, QuickAnswer } from "../../types.d.ts" */

/**
 * @typedef {{arc: QuickAnswer, at: number, put: (part: number) => void}} DetailsProps
 * @extends {Component<DetailsProps>}
 */
class Answer extends Component {
  plots = createRef();
  budget = createRef();
  bySource = /** @type {BySource | null} */ (null);
  /** @type {unknown[]} */
  drawn = [];

  componentDidMount() {
    this.pictures = new Pictures(this.plots.current, (part) => this.props.put(part));
    this.bySource = new BySource(this.budget.current);
    this.paint();
  }
  componentDidUpdate() {
    this.paint();
  }
  paint() {
    const { arc, at } = this.props;
    if (!this.pictures || arc.status !== "solved") return;
    const now = [arc, app.units, marched(), alongside.turn];
    if (now.some((v, i) => v !== this.drawn[i])) {
      this.pictures.draw(arc);
      this.bySource?.draw(arc);
      this.drawn = now;
    }
    this.pictures.at(at);
  }
  render() {
    const { arc } = this.props;
    const solved = arc.status === "solved";
    const full = wholeArc();
    const late = arc.own ? "before" : "";
    const least = (known() || answer.full)?.least_tension;
    return h(
      "div",
      { class: "details", "data-stands": standing(answer.quickDoc === app.doc, answer.problems) },
      governing(),
      chips(arc),
      h(
        "section",
        { class: "card", "aria-label": "Key figures", key: "figures" },
        h("h2", {}, "Key figures"),
        figures(arc),
      ),
      h(
        "section",
        { class: "card", "aria-label": "Along the wrap", key: "along", hidden: !solved },
        h("h2", {}, "Along the wrap"),
        h("div", { key: "pins" }, solved && pins(arc)),
        h("div", { class: "plots", ref: this.plots, key: "plots" }),
      ),
      this.place(arc, solved),
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
    );
  }
  /** Every quantity at one place of the wrap.
   * @param {QuickAnswer} arc @param {boolean} solved */
  place(arc, solved) {
    const { at, put } = this.props;
    const cursor = {
      type: "range",
      id: "cursor",
      min: 0,
      max: 1000,
      step: 5,
      value: Math.round(at * 1000),
      "aria-valuetext": solved ? placeText(arc, at) : "",
      onInput: (/** @type {Event & {currentTarget: HTMLInputElement}} */ e) =>
        put(+e.currentTarget.value / 1000),
    };
    return h(
      "section",
      { class: "card along", "aria-label": "At one place", key: "place", hidden: !solved },
      h("label", { for: "cursor" }, "Place on the arc"),
      h("input", cursor),
      solved && reading(arc, at),
    );
  }
}
/** @param {DetailsProps} props */
export const Details = (props) => after(() => h(Answer, props));
/** The verdict on the drive in all its load cases. */
function governing() {
  const full = known() || answer.full;
  const several = app.doc.pulley.length > 1 || caseNames(app.doc).length > 1;
  if (!full || answer.foreign) return null;
  const how = known() ? "fresh" : standing(false, answer.problems);
  const title = several ? "The whole drive" : "";
  return h(
    "div",
    { key: "governing", class: "governing" },
    title && h("h2", {}, title),
    verdict(judgedIf(how, full.verdict), null, offered()),
  );
}
/** What to know about the data. @param {QuickAnswer} arc */
const chips = (arc) =>
  h(
    "p",
    { class: "chips", key: "chips" },
    (arc.remarks || []).map((r, i) => h("span", { class: "remark", key: i }, words(r))),
  );
/** @param {FullArc} arc */
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
