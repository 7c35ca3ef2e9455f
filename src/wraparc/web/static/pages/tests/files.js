// The files of a testing machine: dropped, read, and what they do not tell themselves.
import { app, redraw } from "../../base/design.js";
import { Advice, act, ask, Refused, refusal, sentence } from "../../base/server.js";
import { list, scroll, table } from "../../parts/answers.js";
import { Box } from "../../parts/box.js";
import { valueIn } from "../../parts/choose.js";
import { h } from "../../vendor/preact.js";
import { figureFile, openPicture, refusePicture, unfinished } from "./figure.js";
import { figured, isFigure, useFigure } from "./plan.js";
import { asRead } from "./plots.js";

/** @import { Problem, Table, Text } from "../../types.d.ts" */
/**
 * @typedef {{name: string, unit: string, role: string}} Column
 * @typedef {{id: string, name: string, read: boolean, columns: Column[], problems: Problem[],
 *   refused: Problem[] | null, notes: Text[], tables: Table[], choices: any,
 *   preview: {travel: number[], force: number[]} | null, pressure_guess: string,
 *   digitised: {name: string, points: number, pressure: string | null}[],
 *   [key: string]: any}} TestFile
 */

const ROLES = [
  ["travel", "Travel"],
  ["force", "Pulling force"],
  ["normal_force", "Normal force"],
  ["time", "Time"],
];

export const session = {
  id: /** @type {string | null} */ (null),
  files: /** @type {TestFile[]} */ ([]),
  chosen: /** @type {string | null} */ (null),
  over: false,
};

/** Ask within the session; one that ran out begins anew, its files are then gone.
 * @param {string} path @param {any} [body] @param {any} [how] */
export async function within(path, body, how) {
  try {
    session.id ??= (await ask("tests", {})).session;
    return await ask(`tests/${session.id}/${path}`, body, how);
  } catch (x) {
    if (!(x instanceof Refused) || x.status !== 404) throw x;
    Object.assign(session, { id: null, files: [] });
    redraw();
    throw new Advice(
      "The calculator no longer has the tests (they expire half an hour after the last use, " +
        "and at a restart): drop the files again.",
    );
  }
}
/** @param {FileList | File[] | null | undefined} chosen */
async function send(chosen) {
  const files = [...(chosen ?? [])];
  const picture = files.find((f) => f.type.startsWith("image/"));
  const others = files.filter((f) => !f.type.startsWith("image/"));
  if (others.length) await upload(others);
  if (picture) await takePicture(picture);
}
/** @param {File[]} files */
async function upload(files) {
  const data = new FormData();
  for (const f of files) data.append("files", f, f.name);
  await take((await within("files", data)).files);
}
/** Begin with a picture; the points of the one before are kept as a file. @param {File} picture */
export async function takePicture(picture) {
  useFigure();
  if (unfinished())
    return refusePicture("Finish or delete the curves of this picture before the next.");
  await sendFigure();
  await openPicture(picture, (name) => session.files.some((f) => f.name === name));
}
let sending = /** @type {Promise<boolean>} */ (Promise.resolve(true));
/** Send the points of the picture that is open, in the place of what was sent of it before; one
 * after the other. @returns {Promise<boolean>} whether there is nothing left to say of them */
export function sendFigure() {
  sending = sending.catch(() => true).then(sendPoints);
  return sending;
}
async function sendPoints() {
  const file = isFigure() ? figureFile() : null;
  if (!file) return file === null;
  const before = session.files.find((f) => f.name === file.name);
  if (before && before.text === file.text) return true;
  if (before) await within(`files/${before.id}`, undefined, { method: "DELETE" });
  session.files = session.files.filter((f) => f !== before);
  await upload([new File([file.text], file.name, { type: "application/json" })]);
  const now = session.files.find((f) => f.name === file.name);
  if (now) now.text = file.text;
  redraw();
  return true;
}
/** A picture pasted while the page of tests is looked at. */
addEventListener("paste", (e) => {
  const picture = [...(e.clipboardData?.files ?? [])].find((f) => f.type.startsWith("image/"));
  if (!picture || app.page !== "tests") return;
  e.preventDefault();
  act(() => takePicture(picture))(e);
});
const example = async () => take((await within("example", {})).files);
/** What a plan says of files that are still to be dropped, by their name.
 * @type {Map<string, any>} */
const expected = new Map();
const SAID = ["pressure", "normal_force", "condition", "repeat", "sample", "use", "reason"];
/** Files that a test plan names. @param {any[]} tests */
export function expect(tests) {
  for (const { file, normal_force_column: normal_force, ...test } of tests) {
    /** @param {(key: string) => boolean} of */
    const part = (of) => Object.fromEntries(Object.entries(test).filter(([key]) => of(key)));
    const choices = { ...part((k) => CHOICES.includes(k)), ...(normal_force && { normal_force }) };
    const more = part((k) => !CHOICES.includes(k) && !SAID.includes(k));
    const name = String(file).split(/[\\/]/).pop() ?? "";
    expected.set(name, { ...part((k) => SAID.includes(k)), choices, more });
  }
  for (const f of session.files) told(f);
}
const CHOICES = [
  "travel",
  "force",
  "time",
  "units",
  "decimal",
  "delimiter",
  "encoding",
  "sheet",
].concat(["table", "block", "stress_area", "stroke", "stick_slip"]);
/** Say of a file what the plan says; false where it does not name it. @param {TestFile} f */
function told(f) {
  const plan = expected.get(f.name);
  if (plan) say(f, plan);
  return Boolean(plan);
}
/** @param {TestFile[]} found */
async function take(found) {
  for (const f of found) {
    const i = session.files.findIndex((x) => x.id === f.id);
    if (i < 0) session.files.push(f);
    else session.files[i] = f;
  }
  if (!session.files.some((f) => f.read) && found.every(ofDigitiser)) useFigure();
  const others = isFigure() ? [] : found.filter((f) => !told(f));
  const guessed = others.filter((f) => f.read && !f.pressure && f.pressure_guess);
  await Promise.all(guessed.map((f) => say(f, { pressure: f.pressure_guess })));
  redraw();
}
/** No machine writes JSON, or columns under pressures. @param {TestFile} f */
const ofDigitiser = (f) =>
  f.digitised.length > 0 && (/\.json$/i.test(f.name) || f.digitised.every((c) => c.pressure));
let saying = /** @type {Promise<void>} */ (Promise.resolve());
/** Wait until all that was said of files has arrived; what a lost server dropped is said again. */
export async function allSaid() {
  await saying.catch(() => {});
  for (const f of session.files.filter((x) => x.unsaid)) await say(f, {});
}
/** Say something of a file that it does not tell itself, after what was said before: the last word
 * counts. @param {TestFile} of @param {any} more */
function say(of, more) {
  Object.assign(session.files.find((x) => x.id === of.id) ?? of, more);
  redraw();
  saying = saying.catch(() => {}).then(() => tell(of));
  return saying;
}
/** What is said of a file that it does not tell itself. @param {TestFile} f */
export const saidOf = (f) => ({
  pressure: f.pressure || null,
  normal_force: f.normal_force || null,
  condition: f.condition || "dry",
  repeat: f.repeat || "",
  sample: f.sample || "",
  use: f.use !== false,
  reason: f.reason || "",
  choices: f.choices || {},
  curve_pressures: pressuresOf(f),
  more: f.more || {},
});
/** Pressures of the curves of a file, as soon as one of them is typed. @param {TestFile} f */
function pressuresOf(f) {
  const typed = f.typed_pressures ?? {};
  if (!isFigure() || !Object.values(typed).some(Boolean)) return {};
  return Object.fromEntries(f.digitised.map((c) => [c.name, typed[c.name] || c.pressure || ""]));
}
/** @param {TestFile} of */
async function tell(of) {
  const here = () => session.files.findIndex((x) => x.id === of.id);
  const f = session.files[here()] ?? of;
  const sent = { ...f };
  const told = saidOf(f);
  try {
    const answer = await within(`files/${f.id}`, told, { method: "PUT" });
    const i = here();
    if (i < 0) return;
    const later = Object.entries(session.files[i]).filter(
      ([key, value]) => key in told && value !== sent[key],
    );
    session.files[i] = {
      ...f,
      refused: null,
      unsaid: false,
      ...answer,
      ...Object.fromEntries(later),
    };
  } catch (x) {
    f.unsaid = true;
    f.refused = refusal(x); // throws what is no refusal: it is said again later
    f.unsaid = false;
  }
  redraw();
}
/** @param {TestFile} f */
async function remove(f) {
  await within(`files/${f.id}`, undefined, { method: "DELETE" });
  const i = session.files.indexOf(f);
  session.files.splice(i, 1);
  redraw();
  const next = session.files[Math.min(i, session.files.length - 1)];
  document.getElementById(next ? `remove-${next.id}` : "choose-files")?.focus();
}

export function drop() {
  const over = (/** @type {boolean} */ on) => (/** @type {DragEvent} */ e) => {
    e.preventDefault();
    session.over = on;
    redraw();
  };
  const input = {
    type: "file",
    multiple: true,
    id: "test-files",
    class: "away",
    tabIndex: -1,
    "aria-label": "Files of the testing machine or of a digitiser",
    onChange: act((e) => {
      const own = /** @type {HTMLInputElement} */ (e.currentTarget);
      const chosen = [...(own.files ?? [])];
      own.value = ""; // so that the same files can be chosen again
      return send(chosen);
    }),
  };
  const choose = () => document.getElementById("test-files")?.click();
  return h(
    "div",
    {
      class: `drop${session.over ? " over" : ""}`,
      key: "drop",
      onDragOver: over(true),
      onDragLeave: over(false),
      onDrop: (e) => {
        over(false)(e);
        act(() => send(e.dataTransfer?.files))(e);
      },
    },
    h(
      "p",
      {},
      isFigure()
        ? "Drop the picture of a figure here, or points of a digitiser: JSON or CSV."
        : "Drop the files of the testing machine here: text or Excel, one test a file.",
    ),
    h("input", input),
    h(
      "p",
      { class: "inline drop-buttons" },
      h(
        "button",
        { type: "button", class: "main", id: "choose-files", onClick: choose },
        "Choose files …",
      ),
      !isFigure() &&
        h("button", { type: "button", onClick: act(example) }, "Try it with made-up tests"),
    ),
  );
}
export function files() {
  const n = session.files.length;
  const what = isFigure() ? ["file of points", "files of points"] : ["test", "tests"];
  const heads = ["File", "Read as", "Set pressure", "Condition", "Use"];
  return h(
    "section",
    { class: "card", "aria-label": "Tests", key: "files" },
    h("h2", {}, `${n} ${what[n === 1 ? 0 : 1]}`),
    scroll(
      "Files of tests",
      h(
        "table",
        { class: "grid-table" },
        h(
          "thead",
          {},
          h(
            "tr",
            {},
            heads.map((t) => h("th", { scope: "col", key: t }, t)),
            h("td", {}),
          ),
        ),
        h("tbody", {}, session.files.map(fileRow)),
      ),
    ),
  );
}
/** @param {TestFile} f */
function fileRow(f) {
  const open = session.chosen === f.id;
  const unfold = () => {
    session.chosen = open ? null : f.id;
    redraw();
  };
  const curves = isFigure() ? f.digitised : [];
  const as = (f.columns || []).filter((c) => c.role).map(columnText);
  const read = isFigure() ? curves.length > 0 : f.read;
  const problems = curves.length ? [] : f.problems || [];
  return h(
    "tr",
    { class: open ? "pinned" : "", key: f.id },
    h(
      "th",
      { scope: "row" },
      h("button", { type: "button", "aria-expanded": open, onClick: unfold }, f.name),
    ),
    h(
      "td",
      { class: read ? "" : "bad" },
      curves.length
        ? curves.map((c) => curveRow(f, c))
        : read
          ? as.join(", ")
          : h("b", {}, "not understood yet"),
      [...problems, ...(f.refused || [])].map((p, i) =>
        h("p", { class: "error", key: i }, sentence(p)),
      ),
    ),
    h(
      "td",
      { class: f.refused ? "wrong" : "" },
      curves.length < 2 && box(f, "pressure", "Set pressure", 9),
    ),
    h("td", {}, box(f, "condition", "Condition", 7)),
    h(
      "td",
      { class: "use" },
      h("input", {
        type: "checkbox",
        checked: f.use !== false,
        "aria-label": `Use ${f.name}`,
        onChange: act((e) =>
          say(f, { use: /** @type {HTMLInputElement} */ (e.currentTarget).checked }),
        ),
      }),
      f.use === false && box(f, "reason", "Why not to use", 14, "why not"),
    ),
    h(
      "td",
      {},
      h(
        "button",
        {
          type: "button",
          id: `remove-${f.id}`,
          "aria-label": `Remove ${f.name}`,
          onClick: act(() => remove(f)),
        },
        "✕",
      ),
    ),
  );
}
/** A curve of a digitised file; its pressure can be said where its name does not.
 * @param {TestFile} f @param {TestFile["digitised"][0]} c */
const curveRow = (f, c) =>
  h(
    "p",
    { key: c.name },
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
/** @param {Column} c */
const columnText = (c) => `${c.role.replace("_", " ")}: ${c.name}${c.unit ? ` [${c.unit}]` : ""}`;
/** @param {TestFile} f @param {string} key @param {string} label @param {number} size
 * @param {string} [hint] */
const box = (f, key, label, size, hint) =>
  h(Box, {
    size,
    placeholder: hint,
    value: f[key] || "",
    "aria-label": `${label} of ${f.name}`,
    "aria-invalid": Boolean(f.refused?.some((p) => p.path.includes(key))),
    put: act((v) => say(f, { [key]: v || (key === "condition" ? "dry" : null) })),
  });
/** The file that is unfolded, or the first that is not understood. */
export function details() {
  const f =
    session.files.find((x) => x.id === session.chosen) || session.files.find((x) => !x.read);
  if (!f || isFigure()) return null;
  return h(
    "section",
    { class: "card", "aria-label": f.name, key: `details-${f.id}` },
    h("h2", {}, f.name),
    h(
      "div",
      { class: "cols" },
      h("div", {}, f.preview && asRead(f.preview), choices(f), list(f.notes, "help")),
      h(
        "div",
        {},
        (f.tables || []).map((t) => table(t)),
      ),
    ),
  );
}
/** @param {TestFile} f */
function choices(f) {
  const c = f.choices || {};
  const names = [["", "automatic"], ...(f.columns || []).map((x) => [x.name, x.name])];
  const put = (/** @type {any} */ more) => say(f, { choices: { ...c, ...more } });
  const role = (/** @type {string[]} */ [key, label]) =>
    h(
      "label",
      { key },
      label,
      h(
        "select",
        { value: c[key] || "", onChange: act((e) => put({ [key]: valueIn(e) || null })) },
        names.map(([v, t]) => h("option", { value: v, key: v }, t)),
      ),
    );
  const unit = (/** @type {Column} */ x) =>
    h(
      "label",
      { key: x.name },
      `Unit of ${x.name}`,
      h(Box, {
        size: 6,
        value: c.units?.[x.name] || "",
        put: act((v) => put({ units: { ...c.units, [x.name]: v } })),
      }),
    );
  const unitless = (f.columns || []).filter((x) => !x.unit || c.units?.[x.name]);
  const said = [...(f.problems || []), ...(f.refused || [])].map(sentence).join(" ");
  const typed = (/** @type {string} */ key, /** @type {string} */ label, /** @type {any} */ as) =>
    (c[key] || said.includes(key)) &&
    h(
      "label",
      { key },
      label,
      h(Box, {
        size: 8,
        value: c[key] || "",
        put: act((v) => put({ [key]: as(v) || null })),
      }),
    );
  const stroke = h(
    "label",
    { key: "stroke" },
    "Stroke",
    h(
      "select",
      {
        value: c.stroke || "first",
        onChange: act((e) => put({ stroke: valueIn(e) === "first" ? null : valueIn(e) })),
      },
      ["first", "last", "all", "mean"].map((t) => h("option", { value: t, key: t }, t)),
    ),
  );
  return h(
    "div",
    { class: "bar" },
    ROLES.map(role),
    unitless.map(unit),
    stroke,
    typed("block", "Which of the tests side by side", Number),
    typed("stress_area", "Area that the stress is over", String),
  );
}
