// Shear tests: machine files to a lagging file.
import { turnTo } from "../base/address.js";
import { app, change, redraw } from "../base/design.js";
import { Advice, act, ask, note, Refused, refusal, save, sentence } from "../base/server.js";
import { words } from "../base/units.js";
import { list, refused, scroll, table } from "../parts/answers.js";
import { valueIn } from "../parts/choose.js";
import { h } from "../vendor/preact.js";
import { asRead, conditionPlots } from "./tests/plots.js";

/** @import { Problem, Table, Text } from "../types.d.ts" */
/**
 * @typedef {{name: string, unit: string, role: string}} Column
 * @typedef {{id: string, name: string, read: boolean, columns: Column[], problems: Problem[],
 *   refused: Problem[] | null, notes: Text[], tables: Table[], choices: any,
 *   preview: {travel: number[], force: number[]} | null, pressure_guess: string,
 *   [key: string]: any}} TestFile
 * @typedef {{name: string, toml: string, lagging: any, sheet: any, left_out: Problem[],
 *   conditions: any[]}} Fit
 */

const ROLES = [
  ["travel", "Travel"],
  ["force", "Pulling force"],
  ["normal_force", "Normal force"],
  ["time", "Time"],
];
/** @typedef {{key: string, label: string, value?: string, help?: string, list?: string[]}} Row */
/** @type {Record<string, Row[]>} */
const ROWS = {
  lagging: [
    {
      key: "name",
      label: "Name",
      value: "my-lagging",
      help: "Name that drive files ask for it by.",
    },
    { key: "title", label: "Title" },
    {
      key: "surface",
      label: "Surface",
      value: "rubber",
      list: ["", "bare", "rubber", "polyurethane", "ceramic"],
    },
    { key: "thickness", label: "Thickness", value: "12 mm" },
    { key: "shear_modulus", label: "Shear modulus G", value: "2.3 MPa" },
    { key: "compression_modulus", label: "Compression modulus E_c", value: "10 MPa" },
    {
      key: "roughness",
      label: "Roughness",
      help: "Of lagging and belt together, for the saturation estimate.",
    },
  ],
  rig: [
    { key: "sample_area", label: "Area of one face", value: "0.04 m2" },
    { key: "faces", label: "Faces that slide", value: "2", list: ["2", "1"] },
    {
      key: "compliance",
      label: "Compliance of the rig",
      help: "The rig's own travel for a force, such as 0.02 mm/kN.",
    },
  ],
  fit: [
    { key: "pieces", label: "Pieces over pressure", list: ["", "1", "2"] },
    { key: "transition_pressure", label: "Transition pressure", help: "Estimated if left empty." },
    { key: "remove_shear", label: "Take off the sample's own shear", list: ["", "true", "false"] },
  ],
};
const TITLES = { lagging: "Lagging", rig: "Rig", fit: "Fit" };
/** @type {Record<string, string>} */
const LIST_WORDS = { "": "as found best", true: "yes", false: "no" };

const state = {
  typed: /** @type {Record<string, Record<string, string>>} */ (
    Object.fromEntries(
      Object.entries(ROWS).map(([part, rows]) => [
        part,
        Object.fromEntries(rows.map((r) => [r.key, r.value || ""])),
      ]),
    )
  ),
  session: /** @type {string | null} */ (null),
  files: /** @type {TestFile[]} */ ([]),
  chosen: /** @type {string | null} */ (null),
  fitting: false,
  problems: /** @type {Problem[]} */ ([]),
  /** What is wrong with a row of the form, by part and key. */
  marks: /** @type {Record<string, string>} */ ({}),
  result: /** @type {Fit | null} */ (null),
  over: false,
};
/** Take lagging, rig and fit of a test plan into the form. @param {any} plan */
export function openPlan(plan) {
  for (const part of Object.keys(ROWS))
    for (const { key } of ROWS[part])
      if (plan[part]?.[key] !== undefined) state.typed[part][key] = String(plan[part][key]);
}

async function session() {
  state.session ??= (await ask("tests", {})).session;
  return state.session;
}
/** Ask within the session; one that ran out begins anew, its files are then gone.
 * @param {string} path @param {any} [body] @param {any} [how] */
async function within(path, body, how) {
  try {
    return await ask(`tests/${await session()}/${path}`, body, how);
  } catch (x) {
    if (!(x instanceof Refused) || x.status !== 404) throw x;
    Object.assign(state, { session: null, files: [] });
    redraw();
    throw new Advice(
      "The calculator no longer has the tests (it keeps them for half an hour after the last " +
        "use, and not when it is started anew): drop the files again.",
    );
  }
}
/** @param {FileList | null | undefined} chosen */
async function send(chosen) {
  if (!chosen?.length) return;
  const data = new FormData();
  for (const f of chosen) data.append("files", f, f.name);
  await take((await within("files", data)).files);
}
const example = async () => take((await within("example", {})).files);
/** @param {TestFile[]} found */
async function take(found) {
  for (const f of found) {
    const i = state.files.findIndex((x) => x.id === f.id);
    if (i < 0) state.files.push(f);
    else state.files[i] = f;
  }
  for (const f of found)
    if (f.read && !f.pressure && f.pressure_guess) await say(f, { pressure: f.pressure_guess });
  redraw();
}
/** Say something of a file that it does not tell itself. @param {TestFile} f @param {any} more */
async function say(f, more) {
  const told = {
    pressure: f.pressure || null,
    normal_force: f.normal_force || null,
    condition: f.condition || "dry",
    repeat: f.repeat || "",
    sample: f.sample || "",
    choices: f.choices || {},
    ...more,
  };
  try {
    const now = await within(`files/${f.id}`, told, { method: "PUT" });
    const i = state.files.findIndex((x) => x.id === f.id);
    state.files[i] = { ...f, refused: null, ...now };
  } catch (x) {
    Object.assign(f, more, { refused: refusal(x) });
  }
  redraw();
}
/** @param {TestFile} f */
async function remove(f) {
  await within(`files/${f.id}`, undefined, { method: "DELETE" });
  const i = state.files.indexOf(f);
  state.files.splice(i, 1);
  redraw();
  const next = state.files[Math.min(i, state.files.length - 1)];
  document.getElementById(next ? `remove-${next.id}` : "choose-files")?.focus();
}

/** What is typed of a part of the plan; numbers and truth values as such. @param {string} part */
function said(part) {
  const given = Object.entries(state.typed[part]).filter(([, v]) => v.trim());
  const numbers = ["faces", "pieces"];
  return Object.fromEntries(
    given.map(([k, v]) => [
      k,
      numbers.includes(k) ? +v : v === "true" || v === "false" ? v === "true" : v.trim(),
    ]),
  );
}
async function fit() {
  Object.assign(state, { problems: [], fitting: true });
  state.marks = {};
  redraw();
  try {
    const plan = { lagging: said("lagging"), rig: said("rig"), fit: said("fit") };
    state.result = await within("fit", plan);
    requestAnimationFrame(() =>
      document.getElementById("fitted")?.scrollIntoView({ block: "start" }),
    );
  } catch (x) {
    const problems = refusal(x);
    state.problems = problems.filter((p) => !rowOf(p.path));
    for (const p of problems) if (rowOf(p.path)) state.marks[p.path] = sentence(p);
    if (!state.problems.length) state.problems = problems;
  } finally {
    state.fitting = false;
    redraw();
  }
}
/** @param {string} path */
function rowOf(path) {
  const [part, key] = (path || "").split(".");
  return ROWS[part]?.some((r) => r.key === key);
}
function use() {
  const { name, lagging } = /** @type {Fit} */ (state.result);
  const pulley = app.doc.pulley.map((p, i) => {
    const { condition, ...rest } = p;
    return i === app.pulley ? { ...rest, lagging: name } : p;
  });
  change({ ...app.doc, lagging: { ...app.doc.lagging, [name]: lagging }, pulley });
  note(`The lagging ${name} is on pulley ${pulley[app.pulley].name} now.`);
  turnTo("drive");
  redraw();
}

export const Page = () =>
  h(
    "div",
    { class: "two" },
    h(
      "form",
      {
        class: "inputs",
        "aria-label": "Lagging and rig",
        onSubmit: (/** @type {Event} */ e) => e.preventDefault(),
      },
      Object.entries(TITLES).map(([part, title]) =>
        h(
          "fieldset",
          { key: part },
          h("legend", {}, title),
          ROWS[part].map((r) => row(part, r)),
        ),
      ),
    ),
    h(
      "div",
      { class: "results" },
      drop(),
      state.files.length > 0 && files(),
      state.files.length > 0 && details(),
      h(
        "p",
        { class: "bar", key: "fit" },
        h(
          "button",
          {
            type: "button",
            class: "main",
            disabled: !state.files.some((f) => f.read),
            onClick: act(fit),
          },
          "Fit the lagging",
        ),
        h("span", { role: "status" }, state.fitting && "Fitting …"),
      ),
      h(
        "div",
        { role: "alert", key: "problems" },
        state.problems.length > 0 && refused("The tests could not be fitted.", state.problems),
      ),
      state.result && result(state.result),
    ),
  );
/** @param {string} part @param {Row} r */
function row(part, r) {
  const id = `t-${part}-${r.key}`;
  const problem = state.marks[`${part}.${r.key}`];
  const common = {
    id,
    value: state.typed[part][r.key],
    "aria-invalid": Boolean(problem),
    "aria-describedby": `${id}-e`,
    onInput: (/** @type {any} */ e) => {
      state.typed[part][r.key] = e.currentTarget.value;
    },
  };
  const options = r.list?.map((x) => h("option", { value: x, key: x }, LIST_WORDS[x] ?? x));
  return h(
    "div",
    { class: `field${problem ? " wrong" : ""}`, key: r.key },
    h("label", { for: id }, r.label),
    h("span", {}),
    h(
      "span",
      { class: "box" },
      options
        ? h("select", common, options)
        : h("input", { ...common, type: "text", autocomplete: "off" }),
    ),
    r.help && h("p", { class: "help" }, r.help),
    h("p", { class: "error", id: `${id}-e` }, problem),
  );
}
function drop() {
  const over = (/** @type {boolean} */ on) => (/** @type {DragEvent} */ e) => {
    e.preventDefault();
    state.over = on;
    redraw();
  };
  const input = {
    type: "file",
    multiple: true,
    id: "test-files",
    class: "away",
    tabIndex: -1,
    "aria-label": "Files of the testing machine",
    onChange: act((e) => send(/** @type {HTMLInputElement} */ (e.currentTarget).files)),
  };
  const choose = () => document.getElementById("test-files")?.click();
  return h(
    "div",
    {
      class: `drop${state.over ? " over" : ""}`,
      key: "drop",
      onDragOver: over(true),
      onDragLeave: over(false),
      onDrop: (e) => {
        over(false)(e);
        act(() => send(e.dataTransfer?.files))(e);
      },
    },
    h("p", {}, "Drop the files of the testing machine here: text or Excel, one test a file."),
    h("input", input),
    h(
      "p",
      { class: "inline drop-buttons" },
      h(
        "button",
        { type: "button", class: "main", id: "choose-files", onClick: choose },
        "Choose files …",
      ),
      h("button", { type: "button", onClick: act(example) }, "Try it with made-up tests"),
    ),
  );
}
function files() {
  const n = state.files.length;
  const heads = ["File", "Read as", "Set pressure", "Condition"];
  return h(
    "section",
    { class: "card", "aria-label": "Tests", key: "files" },
    h("h2", {}, `${n} ${n === 1 ? "test" : "tests"}`),
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
        h("tbody", {}, state.files.map(fileRow)),
      ),
    ),
  );
}
/** @param {TestFile} f */
function fileRow(f) {
  const open = state.chosen === f.id;
  const unfold = () => {
    state.chosen = open ? null : f.id;
    redraw();
  };
  const as = (f.columns || []).filter((c) => c.role).map(columnText);
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
      { class: f.read ? "" : "bad" },
      f.read ? as.join(", ") : h("b", {}, "not understood yet"),
      [...(f.problems || []), ...(f.refused || [])].map((p, i) =>
        h("p", { class: "error", key: i }, sentence(p)),
      ),
    ),
    h("td", { class: f.refused ? "wrong" : "" }, box(f, "pressure", "Set pressure", 9)),
    h("td", {}, box(f, "condition", "Condition", 7)),
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
/** @param {Column} c */
const columnText = (c) => `${c.role.replace("_", " ")}: ${c.name}${c.unit ? ` [${c.unit}]` : ""}`;
/** @param {TestFile} f @param {string} key @param {string} label @param {number} size */
const box = (f, key, label, size) =>
  h("input", {
    type: "text",
    size,
    value: f[key] || "",
    "aria-label": `${label} of ${f.name}`,
    "aria-invalid": Boolean(f.refused?.some((p) => p.path.includes(key))),
    onChange: act((e) => {
      const text = /** @type {HTMLInputElement} */ (e.currentTarget).value.trim();
      return say(f, { [key]: text || (key === "condition" ? "dry" : null) });
    }),
  });
/** The file that is unfolded, or the first that is not understood. */
function details() {
  const f = state.files.find((x) => x.id === state.chosen) || state.files.find((x) => !x.read);
  if (!f) return null;
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
  const names = [["", "as found"], ...(f.columns || []).map((x) => [x.name, x.name])];
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
      h("input", {
        type: "text",
        size: 6,
        value: c.units?.[x.name] || "",
        onChange: act((e) => put({ units: { ...c.units, [x.name]: valueIn(e).trim() } })),
      }),
    );
  const unitless = (f.columns || []).filter((x) => !x.unit || c.units?.[x.name]);
  return h("div", { class: "bar" }, ROLES.map(role), unitless.map(unit));
}
/** @param {Fit} r */
function result(r) {
  const download = () => save(`${r.name}.toml`, r.toml, "application/toml");
  return h(
    "div",
    { key: "result", id: "fitted" },
    h(
      "section",
      { class: "card", "aria-label": "Fitted lagging" },
      h("h2", {}, r.sheet?.title || r.name),
      h("p", {}, words(r.sheet?.subtitle)),
      h(
        "p",
        { class: "bar" },
        h("button", { type: "button", class: "main", onClick: use }, "Use it in the drive at once"),
        h("button", { type: "button", onClick: download }, "Download the lagging file"),
      ),
      r.left_out?.length > 0 &&
        h(
          "div",
          { class: "verdict warn" },
          h("p", { class: "headline" }, "Left out"),
          list(r.left_out.map(sentence)),
        ),
    ),
    r.conditions.map(condition),
    h(
      "div",
      { class: "tables" },
      (r.sheet?.tables || []).map((/** @type {Table} */ t) => table(t)),
    ),
  );
}
/** @param {any} c */
const condition = (c) =>
  h(
    "section",
    { class: "card", "aria-label": `Condition ${c.condition}`, key: c.condition },
    h("h2", {}, `Condition: ${c.condition}`, c.form && h("small", { class: "help" }, ` ${c.form}`)),
    list([...(c.misfit || []), ...(c.remarks || [])], "help"),
    conditionPlots(c),
  );
