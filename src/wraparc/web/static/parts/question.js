// A question beside an answer: its form, the answer as a sheet, and whether that is of before.
import { app, redraw } from "../base/design.js";
import { act, ask, complain, GONE, onReturn, refusal, unanswered } from "../base/server.js";
import { words } from "../base/units.js";
import { h } from "../vendor/preact.js";
import { list, standing } from "./answers.js";
import { judgedIf, refused, stands, table, verdict } from "./tables.js";

/** @import { Children, Problem, Table, Text, Verdict } from "../types.d.ts" */

/** What is typed as a number; what is none goes as it is, to be refused in its own words.
 * @param {string} text */
export const numberOf = (text) => (Number.isFinite(+text) ? +text : text);
/** @typedef {{subtitle: Text, verdict: Verdict | null, tables: Table[], remarks: Text[],
 *   table_sources: string[]}} Sheet */

const AGAIN = { path: "", message: `${GONE} What was asked is asked again when it answers.` };
/** @typedef {{busy: boolean, problems: Problem[], lost: boolean}} Asking */
/** Ask, and keep what is refused. @param {Asking} one @param {() => Promise<void>} f */
export async function attempt(one, f) {
  Object.assign(one, { busy: true, problems: [], lost: false });
  redraw();
  try {
    await f();
  } catch (x) {
    one.lost = unanswered(x);
    one.problems = one.lost ? [AGAIN] : refusal(x);
  } finally {
    one.busy = false;
    redraw();
  }
}
/** Ask again what was lost. @param {Asking} one @param {() => boolean} shown
 * @param {() => Promise<void>} find */
export const again = (one, shown, find) =>
  onReturn(() => one.lost && shown() && find().catch(complain));

export class Question {
  lost = false;
  shown = false;
  busy = false;
  problems = /** @type {Problem[]} */ ([]);
  sheet = /** @type {Sheet | null} */ (null);
  of = "";
  /** @param {string} name @param {string} title @param {string} path of the server
   * @param {() => Record<string, any>} asked what is asked of the drive */
  constructor(name, title, path, asked) {
    Object.assign(this, { name, title, path });
    this.asked = () => ({ document: app.doc, ...asked() });
    again(this, () => this.shown, this.find);
  }
  open = () => {
    this.shown = true;
    redraw();
    return this.find();
  };
  find = () =>
    attempt(this, async () => {
      const asked = this.asked();
      try {
        this.sheet = await ask(this.path, asked);
      } catch (x) {
        this.sheet = null;
        throw x;
      }
      this.of = JSON.stringify(asked);
    });
  close = () => {
    this.shown = false;
    redraw();
  };
  /** @param {Children} fields */
  panel(fields) {
    if (!this.shown) return null;
    const submit = (/** @type {Event} */ e) => {
      e.preventDefault();
      act(this.find)(e);
    };
    return h(
      "section",
      { class: `card ${this.name}`, "aria-label": this.title, key: this.name },
      h("h2", {}, this.title),
      h(
        "form",
        { class: "bar", onSubmit: submit },
        fields,
        h("button", { class: "main" }, "Calculate"),
        h("button", { type: "button", onClick: this.close }, "Close"),
        h("span", { role: "status" }, this.busy && "Solving …"),
      ),
      this.problems.length > 0 && refused("", this.problems),
      this.sheet && this.told(this.sheet),
    );
  }
  name = "";
  title = "";
  path = "";
  /** What stands below the sheet. @param {any} sheet @returns {Children} */
  more = (sheet) => sheet && null;
  /** @param {Sheet} sheet */
  told(sheet) {
    const before = this.of !== JSON.stringify(this.asked());
    const how = standing(!before, this.problems, this.busy);
    return stands(
      how,
      sheet.verdict && verdict(judgedIf(how, sheet.verdict)),
      sheet.tables.map((t) => table(t)),
      list(sheet.remarks, "help"),
      sheet.table_sources.length > 0 &&
        h(
          "ol",
          { class: "help" },
          sheet.table_sources.map((s) => h("li", { key: s }, words(s))),
        ),
      this.more(sheet),
    );
  }
}
