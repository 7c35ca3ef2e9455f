// A plant's logs: dropped beside the open drive, learned from, followed, cancelled.
import { app, redraw } from "../base/design.js";
import { save } from "../base/save.js";
import { act, ask, complain, Refused, refusal } from "../base/server.js";
import { words } from "../base/units.js";
import { lined, linesOf, list, standing } from "../parts/answers.js";
import { notComputed, silent } from "../parts/framed.js";
import { Picture } from "../parts/picture.js";
import { stands, table } from "../parts/tables.js";
import { h } from "../vendor/preact.js";
import { said } from "./drive/screen.js";
import { filesOf } from "./tests/folder.js";

/** @import { Problem, Text } from "../types.d.ts" */
/** @typedef {{id: string, name: string, bytes: number}} LogFile */
/** @typedef {{title: string, value: Text, text: Text}} Found */

const state = {
  session: "",
  files: /** @type {LogFile[]} */ ([]),
  /** What is typed, by key of a learn file. */
  typed: /** @type {Record<string, string>} */ ({}),
  /** The job that is at work or done. @type {any} */
  job: null,
  /** What it is of. */
  of: "",
  problems: /** @type {Problem[]} */ ([]),
  over: false,
};
/** A field of the form: key, label, choices where there are some, what to know of it.
 * @typedef {[string, string, [string, string][] | null, string]} Field */
/** @type {Field[]} */
const OF_PULLEY = [
  ["gear_ratio", "Gear ratio", null, "Motor speed over pulley speed."],
  ["rated_torque", "Rated torque", null, "Of one motor: 100 % torque, as 4.2 kN m."],
  [
    "speed_is",
    "Motor speed by",
    [
      ["", "converter, estimated"],
      ["encoder", "encoder"],
    ],
    "",
  ],
  ["speed", "Tag of its speed", null, "Recognised by its words if left out."],
  ["torque", "Tag of its torque", null, "Recognised by its words if left out."],
];
/** @type {Field[]} */
const OF_ALL = [
  ["belt_speed.column", "Tag of the belt speed", null, "Recognised by its words if left out."],
  [
    "belt_speed.at",
    "Belt speed at",
    [
      ["", "tail"],
      ["slack", "slack belt behind the drive"],
      ["entry", "entry of the drive"],
    ],
    "",
  ],
  [
    "take_up.kind",
    "Take-up",
    [
      ["", "gravity"],
      ["fixed", "fixed"],
      ["winch", "winch"],
    ],
    "",
  ],
  ["zone", "Time zone", null, "Of times without an offset, as Europe/Berlin."],
];
/** The drives that a log has. @returns {string[]} */
const drives = () =>
  (app.doc.pulley ?? []).slice(0, 2).map((/** @type {{name?: string}} */ p) => p.name || "");
/** Tables of the learn file, of what is typed. */
function asked() {
  const found = /** @type {Record<string, any>} */ ({});
  const at = (/** @type {string} */ key) => state.typed[key]?.trim() || null;
  found.pulley = drives().map((name, i) => {
    const own = OF_PULLEY.map(([key]) => [key, at(`${i}.${key}`)]);
    const ratio = at(`${i}.gear_ratio`);
    const number = Number(ratio?.replace(",", "."));
    return { ...Object.fromEntries(own), name, gear_ratio: ratio && (number || ratio) };
  });
  for (const [key] of OF_ALL) {
    const [part, rest] = key.split(".");
    if (rest) found[part] = { ...found[part], [rest]: at(key) };
    else found[part] = at(key);
  }
  return found;
}
const subject = () => JSON.stringify([app.doc, asked(), state.files]);
const busy = () => state.job?.state === "queued" || state.job?.state === "running";
const done = () => state.job?.state === "done";
const how = () => standing(state.of === subject(), state.problems, busy());

/** Ask within the session; one that ran out begins anew. @param {string} path @param {any} [body]
 * @param {any} [more] */
async function within(path, body, more) {
  try {
    state.session ||= (await ask("logs", {})).session;
    return await ask(`logs/${state.session}/${path}`, body, more);
  } catch (x) {
    if (!(x instanceof Refused) || x.status !== 404) throw x;
    Object.assign(state, { session: "", files: [] });
    throw x;
  }
}
/** @param {FileList | File[] | null | undefined} chosen */
async function send(chosen) {
  const data = new FormData();
  const all = [...(chosen ?? [])];
  for (const file of all) data.append("files", file, file.name);
  if (!all.length) return;
  state.problems = [];
  state.files = (await within("files", data)).files;
  redraw();
}
/** @param {LogFile} file */
const remove = (file) => async () => {
  state.files = (await within(`files/${file.id}`, undefined, { method: "DELETE" })).files;
  redraw();
};
async function begin() {
  Object.assign(state, { problems: [], of: subject() });
  try {
    state.job = await within("learn", { document: app.doc, learn: asked() });
    redraw();
    await follow();
  } catch (x) {
    state.problems = refusal(x);
  }
  redraw();
}
const PAUSE = 400;
/** Look after the job until it ends. */
async function follow() {
  while (busy()) {
    await new Promise((go) => setTimeout(go, PAUSE));
    if (!busy()) return; // cancelled meanwhile
    const { id } = state.job;
    const answer = await ask(`logs/jobs/${id}`).catch((x) => {
      if (state.job?.id === id) throw x; // else it was cancelled while it was asked after
    });
    if (state.job?.id !== id || !busy()) return;
    state.job = answer;
    if (answer.state === "failed") state.problems = answer.problems;
    redraw();
  }
}
async function cancel() {
  const { id } = state.job;
  state.job = null;
  redraw();
  await ask(`logs/jobs/${id}`, undefined, { method: "DELETE" }).catch(complain);
}

const chooser = () => document.getElementById("log-files")?.click();
/** @param {boolean} on */
const over = (on) => (/** @type {DragEvent} */ e) => {
  e.preventDefault();
  if (state.over === on) return;
  state.over = on;
  redraw();
};
const dropped = () => ({
  onDragOver: over(true),
  onDragLeave: over(false),
  onDrop: (/** @type {DragEvent} */ e) => {
    over(false)(e);
    act(async () => send(await filesOf(e.dataTransfer)))(e);
  },
});

export const Page = () =>
  h(
    "div",
    { class: "screen other measure", "data-stands": done() ? how() : null, ...dropped() },
    h("input", {
      type: "file",
      multiple: true,
      id: "log-files",
      class: "away",
      tabIndex: -1,
      "aria-label": "Logs of the control system",
      onChange: act((e) => {
        const own = /** @type {HTMLInputElement} */ (e.currentTarget);
        const chosen = [...(own.files ?? [])];
        own.value = ""; // so that the same files can be chosen again
        return send(chosen);
      }),
    }),
    h(
      "div",
      { class: "frame" },
      h("div", { class: "inputs rail card" }, state.files.length > 0 && files(), form()),
      h(
        "section",
        { class: "hero card tests", "aria-label": "Logs and what they say" },
        h("div", { id: "logs-verdict", key: "say" }, say()),
        h("div", { class: "stage-box", key: "stage" }, stage()),
      ),
      h("aside", { class: "checks card", "aria-label": "Findings" }, findings()),
    ),
    below(),
  );
const MB = 1e6;
/** The logs that were dropped. */
const files = () =>
  h(
    "section",
    { "aria-label": "Logs", key: "files" },
    h("h2", {}, "Logs", h("span", {}, `${state.files.length}`)),
    h(
      "ul",
      { class: "plain" },
      state.files.map((file) =>
        h(
          "li",
          { key: file.id },
          h("span", {}, `${file.name}, ${(file.bytes / MB).toFixed(1)} MB `),
          h(
            "button",
            { type: "button", "aria-label": `Remove ${file.name}`, onClick: act(remove(file)) },
            "×",
          ),
        ),
      ),
    ),
    h("p", {}, h("button", { type: "button", onClick: chooser }, "Add logs …")),
  );
const form = () =>
  h(
    "form",
    { class: "plan", "aria-label": "What the logs do not say", key: "form", onSubmit: stay },
    drives().map((name, i) =>
      h(
        "fieldset",
        { key: name || i },
        h("legend", {}, `Pulley ${name}`),
        OF_PULLEY.map((field) => row(field, `${i}.${field[0]}`)),
      ),
    ),
    h(
      "fieldset",
      { key: "all" },
      h("legend", {}, "Belt and take-up"),
      OF_ALL.map((field) => row(field, field[0])),
    ),
  );
const stay = (/** @type {Event} */ e) => e.preventDefault();
/** @param {Field} field @param {string} key */
function row([, label, choices, help], key) {
  const id = `log-${key.replace(".", "-")}`;
  const common = {
    id,
    value: state.typed[key] ?? "",
    title: help || undefined,
    onInput: (/** @type {any} */ e) => {
      state.typed[key] = e.currentTarget.value;
      redraw();
    },
  };
  return h(
    "div",
    { class: "field", key },
    h("label", { for: id }, label),
    h("span", {}),
    h(
      "span",
      { class: "box" },
      choices
        ? h(
            "select",
            common,
            choices.map(([value, text]) => h("option", { value, key: value }, text)),
          )
        : h("input", { ...common, type: "text", autocomplete: "off" }),
    ),
  );
}
/** @type {import("../parts/answers.js").Line[]} */
const NEEDS = [
  ["Needs", "Motor speed, torque and belt speed of 3 days or more, running empty and loaded."],
  ["Result", "Zero and friction of this drive, wet episodes, an alarm line by torque."],
];
/** @param {string} text @param {() => any} does */
const button = (text, does) =>
  h("button", { type: "button", class: "main advice", key: text, onClick: act(does) }, text);
const start = () => button("Learn from the logs", begin);
/** What the logs come to. */
function say() {
  const { job } = state;
  if (busy())
    return silent(
      "Learning …",
      [
        h("progress", { max: job.total || 1, value: job.done || 0, "aria-label": "Progress" }),
        ` ${job.message}`,
      ],
      button("Cancel", cancel),
    );
  if (state.problems.length)
    return notComputed("Nothing was learned.", state.problems, state.files.length > 0 && start());
  if (!state.files.length) return silent("No log yet.", lined(NEEDS));
  if (!done() || how() !== "fresh") {
    const text = `${state.files.length} ${state.files.length > 1 ? "logs" : "log"} ready.`;
    return silent(text, done() ? "Inputs changed." : lined(NEEDS), start());
  }
  const v = job.verdict;
  const get = () => save(job.name, job.toml, "application/toml");
  const does = button("Save the learned drive", get);
  return said(v.level, words(v.text), lined(linesOf(v)), does, null, null, v.label);
}
/** The drop zone, or the pictures. */
function stage() {
  if (done())
    return h(
      "div",
      { class: how() === "fresh" ? "curves" : "curves before", key: state.job.id },
      state.job.pictures.map((/** @type {string} */ name) =>
        h(Picture, {
          key: name,
          path: `logs/jobs/${state.job.id}/pictures/${encodeURIComponent(name)}`,
          alt: `${name.replace(/\.svg$/, "")}; its numbers are in the tables`,
        }),
      ),
    );
  return h(
    "div",
    { class: `drop${state.over ? " over" : ""}`, key: "drop" },
    h("p", { class: "headline" }, "Drop the logs of the control system here"),
    h("p", { class: "help" }, "CSV or TXT as exported: a column a tag, or a row a reading."),
    h(
      "p",
      { class: "inline drop-buttons" },
      h("button", { type: "button", class: "main", onClick: chooser }, "Choose logs …"),
    ),
  );
}
const COMING = ["Change of friction", "Friction reserve", "Zero of speed", "Alarm line"];
function findings() {
  const own = /** @type {Found[]} */ (done() ? state.job.findings : []);
  if (!own.length)
    return [
      h("h2", { key: "head" }, "Findings", h("span", {}, "come with the logs")),
      h(
        "ul",
        { class: "list coming", key: "list" },
        COMING.map((name) => h("li", { key: name }, h("span", {}, name), h("span", {}, "–"))),
      ),
    ];
  return [
    h("h2", { key: "head" }, "Findings"),
    h(
      "div",
      { class: "facts", key: "facts" },
      own.map((f, i) =>
        h(
          "p",
          { key: `${f.title}${i}` },
          h("span", { class: "help" }, words(f.title), ": "),
          h("b", {}, words(f.value)),
          words(f.text) && h("span", { class: "help" }, ` (${words(f.text)})`),
        ),
      ),
    ),
  ];
}
/** All tables of the answer. */
function below() {
  const r = done() ? state.job : null;
  return (
    r &&
    h(
      "details",
      { id: "logs-details", class: "card" },
      h("summary", {}, "Details"),
      h(
        "div",
        { class: "details", key: "details" },
        stands(
          how(),
          h("h2", {}, words(r.title)),
          list(r.remarks, "help"),
          h(
            "div",
            { class: "tables" },
            r.tables.map((/** @type {any} */ t) => table(t)),
          ),
        ),
      ),
    )
  );
}
