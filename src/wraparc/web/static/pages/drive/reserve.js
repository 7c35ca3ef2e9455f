// The reserve of the verdict: how little of an input changes its level, each change to press.
import { app, gripped, redraw } from "../../base/design.js";
import { ask, later, refusal } from "../../base/server.js";
import { percent, words } from "../../base/units.js";
import { levelClass } from "../../parts/answers.js";
import { h } from "../../vendor/preact.js";
import { answer, whole } from "./solving.js";
import { changed, take } from "./way.js";

/** @import { Children, Design } from "../../types.d.ts" */
/** @import { ReserveAnswer, ReserveChange } from "../../api.d.ts" */

/** Most changes that are drawn, down and up [-]: those that the program looks for. */
const ENDS = [0.5, 1];
const WAIT = 300; // what is asked for the drive itself goes first
/** The last one, and the design that it is of. */
const last = {
  doc: /** @type {Design | null} */ (null),
  found: /** @type {ReserveAnswer | null} */ (null),
};
/** @type {AbortController | null} */
let stop = null;
/** The design that was asked of last. @type {Design | null} */
let asked = null;

/** Ask for it, once the whole answer is there and the hand rests. */
export function find() {
  if (asked && asked !== app.doc) {
    stop?.abort();
    asked = null;
  }
  if (whole() && !gripped() && app.doc !== asked && app.doc !== last.doc && !app.gone) soon();
}
const soon = later(WAIT, async () => {
  const { doc } = app;
  const { full } = answer;
  if (!full || !whole() || gripped() || doc === asked || doc === last.doc) return;
  asked = doc;
  stop = new AbortController();
  try {
    const found = await ask("solve/reserve", { document: doc }, { signal: stop.signal });
    Object.assign(last, { doc, found });
    full.verdict.reserve_text = found.text;
  } catch (x) {
    if (!app.gone && doc === app.doc) refusal(x);
  }
  redraw();
});

/** The changes of each input, down and up. @returns {[string, (ReserveChange | undefined)[]][]} */
function inputs() {
  /** @type {Map<string, (ReserveChange | undefined)[]>} */
  const all = new Map();
  for (const one of last.found?.changes ?? []) {
    const name = words(one.name);
    const sides = all.get(name) ?? [];
    sides[+(one.change > 0)] ??= one;
    all.set(name, sides);
  }
  return [...all];
}
/** The list: of now, or that of before while another is on its way. @returns {Children} */
export function reserve() {
  const { found, doc } = last;
  if (!found) return null;
  const rows = inputs();
  if (!rows.length) return h("p", { class: "none" }, words(found.text));
  const now = doc === app.doc && !gripped();
  return h(
    "ul",
    { class: now ? "reserves" : "reserves before", tabIndex: 0, "aria-label": "Reserve" },
    rows.map(([name, sides]) =>
      h(
        "li",
        { key: name },
        h("span", { class: "n", title: name }, name),
        ENDS.map((end, i) => side(name, sides[i], end, now)),
      ),
    ),
  );
}
/** A change to one side: a bar to where the level changes, over the uncertainty of the input.
 * @param {string} name @param {ReserveChange | undefined} one @param {number} end
 * @param {boolean} now */
function side(name, one, end, now) {
  if (!one) return h("span", { class: "side", key: end }, h("span", {}, "–"), h("u", {}));
  const { level, change, uncertainty, uncertainty_kind: kind, source, load_case, changes } = one;
  const text = words(one.shown);
  const wide = (/** @type {number} */ v) => ({
    style: { width: `${100 * Math.min(1, Math.abs(v) / end)}%` },
  });
  const at = `${level} at ${name} ${text}`;
  const off = `uncertainty ${percent(uncertainty, 2)}, ${kind}${source ? `: ${source}` : ""}`;
  const title = [load_case ? `${at} (${load_case})` : at, off].join("; ");
  const inside = [
    h("span", { class: levelClass(level) }, text),
    h("u", {}, h("i", wide(uncertainty)), h("b", { class: levelClass(level), ...wide(change) })),
  ];
  if (!changes.length) return h("span", { class: "side", title, key: end }, inside, away(level));
  const press = () => take(changed(one), `${name} ${text}.`);
  return h(
    "button",
    { type: "button", class: "side", key: end, title, disabled: !now, onClick: press },
    inside,
    away(`${name}, ${level}`),
  );
}
/** @param {string} text for who does not see the colour */
const away = (text) => h("span", { class: "away" }, text);
