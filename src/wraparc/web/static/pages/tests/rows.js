// The tests by condition, a row each; what one does not tell itself is asked under it.
import { redraw } from "../../base/design.js";
import { act, sentence } from "../../base/server.js";
import { words } from "../../base/units.js";
import { Box } from "../../parts/box.js";
import { choose } from "../../parts/choose.js";
import { h } from "../../vendor/preact.js";
import { glyph } from "../drive/screen.js";
import { remove, say, session } from "./files.js";
import { figured, isFigure } from "./plan.js";
import { shade } from "./plots.js";

/** @import { Children, Problem } from "../../types.d.ts" */
/** @import { TestFile } from "./files.js" */

/** Units that machines write, by the role of the column. */
const UNITS = ["mm", "cm", "m", "in", "N", "kN", "lbf", "kgf", "kPa", "MPa", "psi", "s"];

/** Columns of a file whose unit is asked. @param {TestFile} f */
export const unitsAsked = (f) =>
  f.problems
    .filter((p) => p.code === "unit" && !f.choices?.units?.[String(p.meant)])
    .map((p) => String(p.meant));
/** Files that lack nothing but units. */
export const unitless = () =>
  session.files.filter((f) => f.use !== false && !f.read && unitsAsked(f).length > 0);
/** A unit for a column of one file, or of all that lack that. */
const asks = { units: /** @type {Record<string, string>} */ ({}), all: true };

/** @param {TestFile} f @param {string} column @param {string} unit */
async function give(f, column, unit) {
  asks.units[column] = unit;
  const among = asks.all ? unitless().filter((x) => unitsAsked(x).includes(column)) : [f];
  for (const x of among)
    await say(x, {
      choices: { ...x.choices, units: { ...x.choices?.units, [column]: unit } },
    });
}
/** The question for units, under the first file that lacks one.
 * @param {TestFile} f @param {number} many */
const question = (f, many) =>
  h(
    "div",
    { class: "ask", key: "ask" },
    unitsAsked(f).map((column) =>
      h(
        "label",
        { key: column },
        h("span", {}, `unit of ${column}?`),
        choose(
          "",
          [["", "–"], ...UNITS.map((u) => /** @type {[string, string]} */ ([u, u]))],
          (u) => act(() => give(f, column, u))(new Event("change")),
        ),
      ),
    ),
    many > 1 &&
      h(
        "label",
        { class: "same" },
        h("input", {
          type: "checkbox",
          checked: asks.all,
          onChange: () => {
            asks.all = !asks.all;
            redraw();
          },
        }),
        `same for ${many} files`,
      ),
  );

/** Names of files tell condition and pressure: taken or not, once for all.
 * @param {TestFile} f */
const guessOf = (f) => ({
  ...(f.pressure_guess && { pressure: f.pressure_guess }),
  ...(f.condition_guess && { condition: f.condition_guess }),
});
/** What the name of a file tells that it does not say yet. @param {TestFile} f */
export function untold(f) {
  const guess = guessOf(f);
  const open = Object.entries(guess).filter(
    ([key, v]) => (f[key] || NONE[/** @type {"pressure"} */ (key)]) !== v && !said(f, key),
  );
  return Object.fromEntries(open);
}
/** @param {TestFile} f @param {string} key */
const said = (f, key) => (key === "condition" ? f[key] && f[key] !== "dry" : Boolean(f[key]));
export const names = { taken: true };
const NONE = { pressure: null, condition: "dry" };
async function byName() {
  names.taken = !names.taken;
  redraw();
  for (const f of session.files) {
    const guess = /** @type {Record<string, any>} */ (guessOf(f));
    const own = Object.keys(guess).filter((key) => f[key] === guess[key]);
    const more = names.taken
      ? untold(f)
      : Object.fromEntries(own.map((key) => [key, NONE[/** @type {"pressure"} */ (key)]]));
    if (Object.keys(more).length) await say(f, more);
  }
}
function nameQuestion() {
  const told = session.files.filter((f) => Object.keys(guessOf(f)).length);
  if (isFigure() || !told.length) return null;
  const keys = ["condition", "pressure"].filter((key) => told.some((f) => key in guessOf(f)));
  return h(
    "label",
    { class: "same by-name" },
    h("input", { type: "checkbox", checked: names.taken, onChange: act(byName) }),
    `${keys.join(" and ")} from the names`,
  );
}

/** All files, by condition. @param {() => void} add */
export function files(add) {
  const n = session.files.length;
  const what = isFigure() ? ["file of points", "files of points"] : ["test", "tests"];
  const lacking = unitless();
  const conditions = [...new Set(session.files.map((f) => f.condition || "dry"))];
  return h(
    "section",
    { class: "tests-list", "aria-label": "Files of the tests", key: "files" },
    h(
      "h2",
      {},
      `${n} ${what[n === 1 ? 0 : 1]}`,
      h("button", { type: "button", class: "link", id: "choose-files", onClick: add }, "Add …"),
    ),
    nameQuestion(),
    h(
      "div",
      { class: "rows-of", tabIndex: 0, role: "group", "aria-label": "Files" },
      conditions.map((c) => {
        const own = session.files.filter((f) => (f.condition || "dry") === c);
        return h(
          "div",
          { key: c },
          !isFigure() &&
            h(
              "p",
              { class: "of" },
              h("b", {}, `${c[0].toUpperCase()}${c.slice(1)} · ${own.length}`),
              h("span", {}, "pressure"),
              h("span", {}, "no."),
            ),
          h(
            "ul",
            {},
            own.map((f) => row(f, lacking)),
          ),
        );
      }),
    ),
  );
}
/** @param {TestFile} f */
const level = (f) =>
  f.use === false
    ? null
    : (isFigure() ? f.digitised.length : f.read) && !f.refused
      ? "OK"
      : "ATTENTION";
/** @param {TestFile} f @param {TestFile[]} lacking */
function row(f, lacking) {
  const open = session.chosen === f.id;
  const unfold = () => {
    session.chosen = open ? null : f.id;
    redraw();
  };
  const curves = isFigure() ? f.digitised : [];
  const how = level(f);
  return h(
    "li",
    { key: f.id, class: open ? "pinned" : f.use === false ? "unused" : "" },
    h(
      "button",
      { type: "button", "aria-expanded": open, onClick: unfold, title: f.name },
      glyph(/** @type {any} */ (how)),
      h("i", { class: "dot", style: { background: shade(f.pressure) } }),
      h("span", { class: "name" }, f.name),
      h("span", {}, words(f.pressure ?? "").replace(/ kPa$/, "")),
      h("span", {}, f.number ?? ""),
    ),
    curves.map((c) => curveRow(f, c)),
    lacking[0] === f && question(f, lacking.length),
    (open || f.refused || (!f.read && !unitsAsked(f).length && !curves.length)) &&
      fields(f, curves.length),
  );
}
/** What is said of a file. @param {TestFile} f @param {number} curves */
function fields(f, curves) {
  const problems = curves ? [] : f.problems.filter((p) => p.code !== "unit");
  return h(
    "div",
    { class: "ask", key: "fields" },
    [...problems, ...(f.refused || [])].map((p, i) => h("p", { class: "error", key: i }, plain(p))),
    curves < 2 && box(f, "pressure", "Set pressure"),
    box(f, "condition", "Condition"),
    !isFigure() && box(f, "repeat", "Repeat"),
    h(
      "label",
      { class: "same" },
      h("input", {
        type: "checkbox",
        checked: f.use !== false,
        "aria-label": `Use ${f.name}`,
        onChange: act((e) =>
          say(f, { use: /** @type {HTMLInputElement} */ (e.currentTarget).checked }),
        ),
      }),
      "used in the fit",
    ),
    f.use === false && box(f, "reason", "Why not to use", "why not"),
    h(
      "button",
      {
        type: "button",
        id: `remove-${f.id}`,
        "aria-label": `Remove ${f.name}`,
        onClick: act(() => remove(f)),
      },
      "Remove",
    ),
  );
}
/** A problem without what a file of a plan would say. @param {Problem} p */
const plain = (p) => (/[={[]|--/.test(String(p.remedy ?? "")) ? p.message : sentence(p));
/** @param {TestFile} f @param {string} key @param {string} label @param {string} [hint] */
const box = (f, key, label, hint) =>
  h(
    "label",
    { key },
    h("span", {}, label),
    h(Box, {
      id: `test-${f.id}-${key}`,
      size: 9,
      placeholder: hint,
      value: f[key] || "",
      "aria-label": `${label} of ${f.name}`,
      "aria-invalid": Boolean(f.refused?.some((p) => p.path.includes(key))),
      put: act((v) =>
        say(f, { [key]: v || (key === "condition" ? "dry" : key === "repeat" ? "" : null) }),
      ),
    }),
  );
/** A curve of a digitised file; its pressure can be said where its name does not.
 * @param {TestFile} f @param {TestFile["digitised"][0]} c @returns {Children} */
const curveRow = (f, c) =>
  h(
    "p",
    { key: c.name, class: "curve-of" },
    `${c.name || "curve"}, ${c.points} points `,
    c.name &&
      f.digitised.length > 1 &&
      f.digitised.some((x) => !x.pressure) &&
      figured() === "friction" &&
      h(Box, {
        size: 9,
        placeholder: c.pressure || "pressure",
        value: f.typed_pressures?.[c.name] || "",
        "aria-label": `Pressure of ${c.name} of ${f.name}`,
        put: act((v) => say(f, { typed_pressures: { ...f.typed_pressures, [c.name]: v } })),
      }),
  );
