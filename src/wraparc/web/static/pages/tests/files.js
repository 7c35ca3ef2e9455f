// The files of a testing machine: dropped, read, and what they do not tell themselves.
import { app, redraw } from "../../base/design.js";
import { noteBack } from "../../base/removed.js";
import { Advice, act, ask, note, Refused, refusal, sentence } from "../../base/server.js";
import { list } from "../../parts/answers.js";
import { Box } from "../../parts/box.js";
import { valueIn } from "../../parts/choose.js";
import { table } from "../../parts/tables.js";
import { h } from "../../vendor/preact.js";
import { figureFile, openPicture, refusePicture, unfinished } from "./figure.js";
import { filesOf, sorted } from "./folder.js";
import { isFigure, openPlan as takePlan, useFigure } from "./plan.js";
import { asRead } from "./plots.js";
import { names, untold } from "./rows.js";

/** @import { Problem, Table, Text } from "../../types.d.ts" */
/**
 * @typedef {{name: string, unit: string, role: string}} Column
 * @typedef {{id: string, name: string, read: boolean, columns: Column[], problems: Problem[],
 *   refused: Problem[] | null, notes: Text[], tables: Table[], choices: any,
 *   preview: {travel: number[], force: number[]} | null, pressure_guess: string | null,
 *   condition_guess: string | null, number: string | null,
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
  const { plans, pictures, tests } = sorted(chosen ?? []);
  for (const f of plans) await openPlanFile(f);
  if (tests.length) await upload(tests);
  if (pictures.length && (!tests.length || isFigure())) await takePicture(pictures[0]);
}
/** A plan that lies beside its tests. @param {File} file */
async function openPlanFile(file) {
  const { document } = await ask("toml/read", { toml: await file.text(), name: file.name });
  if (!document.test && !document.rig) throw new Advice(`${file.name} is no plan of tests.`);
  takePlan(document);
  expect(document.test ?? []);
}
/** What was dropped, to be sent again where its removal is undone. @type {Map<string, File>} */
const uploaded = new Map();
/** @param {File[]} files */
async function upload(files) {
  const data = new FormData();
  for (const f of files) {
    data.append("files", f, f.name);
    uploaded.set(f.name, f);
  }
  await take((await within(names.taken ? "files?named=true" : "files", data)).files);
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
  const guesses = names.taken ? others.map((f) => /** @type {const} */ ([f, untold(f)])) : [];
  const guessed = guesses.filter(([, more]) => Object.keys(more).length);
  await Promise.all(guessed.map(([f, more]) => say(f, more)));
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
export function say(of, more) {
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
  const f = session.files[here()];
  if (!f) return; // removed before it was said
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
export async function remove(f) {
  await saying.catch(() => {});
  await within(`files/${f.id}`, undefined, { method: "DELETE" });
  const i = session.files.findIndex((x) => x.id === f.id);
  const [gone] = session.files.splice(i, 1);
  const file = uploaded.get(f.name);
  const back = () => {
    expected.set(f.name, saidOf(gone));
    return file && upload([file]).then(chooseAgain);
  };
  const chooseAgain = () => {
    session.chosen = session.files.find((x) => x.name === f.name)?.id ?? null;
    redraw();
  };
  if (file) noteBack(back, `${f.name} is removed. `);
  else note(`${f.name} is removed.`);
  const next = session.files[Math.min(i, session.files.length - 1)];
  session.chosen = next?.id ?? null;
  redraw();
  document.getElementById(next ? `remove-${next.id}` : "choose-files")?.focus();
}

const chooser = (/** @type {string} */ id) => () => document.getElementById(id)?.click();
export const chooseFiles = chooser("test-files");
/** @param {string} id @param {any} more */
const input = (id, more) =>
  h("input", {
    type: "file",
    multiple: true,
    id,
    class: "away",
    tabIndex: -1,
    ...more,
    onChange: act((e) => {
      const own = /** @type {HTMLInputElement} */ (e.currentTarget);
      const chosen = [...(own.files ?? [])];
      own.value = ""; // so that the same files can be chosen again
      return send(chosen);
    }),
  });
/** What takes files by a hand, wherever on the page they are dropped. */
export const inputs = () => [
  input("test-files", { "aria-label": "Files of the testing machine or of a digitiser" }),
  input("test-folder", { "aria-label": "Folder of the tests", webkitdirectory: true }),
];
/** @param {boolean} on */
const over = (on) => (/** @type {DragEvent} */ e) => {
  e.preventDefault();
  if (session.over === on) return;
  session.over = on;
  redraw();
};
export const dropped = () => ({
  onDragOver: over(true),
  onDragLeave: over(false),
  onDrop: (/** @type {DragEvent} */ e) => {
    over(false)(e);
    act(async () => send(await filesOf(e.dataTransfer)))(e);
  },
});
/** The rig in a drawing, and what can be dropped. */
export const drop = () =>
  h(
    "div",
    { class: `drop${session.over ? " over" : ""}`, key: "drop" },
    !isFigure() && rig(),
    h(
      "p",
      { class: "headline" },
      isFigure() ? "Drop the picture of a figure here" : "Drop the folder of the tests here",
    ),
    h(
      "p",
      { class: "help" },
      isFigure()
        ? "A picture, or points of a digitiser: JSON or CSV."
        : "CSV, TXT, Excel, TRA, MTR, DAT: one test a file. A plan in the folder is read first.",
    ),
    h(
      "p",
      { class: "inline drop-buttons" },
      !isFigure() &&
        h(
          "button",
          { type: "button", class: "main", onClick: chooser("test-folder") },
          "Choose folder …",
        ),
      h(
        "button",
        {
          type: "button",
          class: isFigure() ? "main" : "",
          id: "choose-files",
          onClick: chooseFiles,
        },
        "Choose files …",
      ),
      !isFigure() &&
        h("button", { type: "button", onClick: act(example) }, "Example: 6 made-up tests"),
    ),
  );
const ARROWS = "M140 0V16m-5-7 5 8 5-8M140 190V174m-5 7 5-8 5 8M282 95H320m-8-5 9 5-9 5";
/** Two samples pressed on a belt that is pulled out between them. */
function rig() {
  const bars = Array.from({ length: 11 }, (_, i) => i);
  const layer = (/** @type {number} */ y) =>
    bars.map((i) =>
      h("rect", {
        x: 64 + 14 * i,
        y,
        width: 12,
        height: 32,
        class: "step",
        "fill-opacity": 0.3 + i / 16,
      }),
    );
  return h(
    "svg",
    { class: "rig", viewBox: "0 0 350 192", "aria-hidden": "true" },
    h("rect", { x: 60, y: 22, width: 160, height: 26, rx: 4, class: "plate" }),
    h("rect", { x: 60, y: 142, width: 160, height: 26, rx: 4, class: "plate" }),
    layer(48),
    layer(110),
    h("rect", { x: 20, y: 80, width: 256, height: 30, class: "belt-piece" }),
    h("path", { d: ARROWS, class: "arrow" }),
    h("text", { x: 150, y: 12 }, "pressure"),
    h("text", { x: 282, y: 84 }, "force, travel"),
    h("text", { x: 30, y: 100, class: "on" }, "belt"),
    h("text", { x: 0, y: 66 }, "lagging"),
    h("text", { x: 0, y: 130 }, "lagging"),
  );
}
/** The file that is unfolded, or the first that is not understood. */
export const chosenFile = () =>
  session.files.find((x) => x.id === session.chosen) ?? session.files.find((x) => !x.read);
/** The record of a file, while there is no law yet. @param {TestFile | undefined} f */
export function asReadOf(f) {
  const of = f?.preview ? f : session.files.find((x) => x.preview);
  return of?.preview
    ? asRead(of.preview, of.name)
    : h("p", { class: "intro help" }, "No curve yet.");
}
export function details() {
  const f = chosenFile();
  if (!f || isFigure()) return null;
  return h(
    "section",
    { class: "card", "aria-label": f.name, key: `details-${f.id}` },
    h("h2", {}, f.name),
    h(
      "div",
      { class: "cols" },
      h("div", {}, f.preview && asRead(f.preview, f.name), choices(f), list(f.notes, "help")),
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
