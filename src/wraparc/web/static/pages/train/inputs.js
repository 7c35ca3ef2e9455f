// The inputs of a train: what is given of it, and its drives one behind the other.
import { app, change, edit, putLagging } from "../../base/design.js";
import { field, spec } from "../../parts/field.js";
import { h } from "../../vendor/preact.js";
import { laggingChoices, laggingName } from "../drive/inputs.js";
import { pulleyName } from "../drive/more.js";

/** @import { Design, Path, Pulley, Spec } from "../../types.d.ts" */

const LOADS = ["entry_tension", "exit_tension", "effective_tension", "power"];
const TENSIONS = [...LOADS, "torque"];
const ORDINALS = ["second", "third", "fourth", "fifth"];
/** @param {any} table @param {string[]} keys */
const only = (table, keys) =>
  Object.fromEntries(keys.filter((k) => table?.[k] !== undefined).map((k) => [k, table[k]]));
/** @param {any} table @param {string[]} keys */
const without = (table, keys) =>
  Object.fromEntries(Object.entries(table).filter(([k]) => !keys.includes(k)));
/** Equal shares that add up to the whole. @param {number} n */
function shares(n) {
  const each = Math.floor(10000 / n) / 100;
  return Array.from({ length: n }, (_, i) => `${i ? each : +(100 - each * (n - 1)).toFixed(2)} %`);
}

export function addPulley() {
  const { doc } = app;
  const last = doc.pulley[doc.pulley.length - 1];
  const names = doc.pulley.map((p) => p.name);
  const name = ORDINALS.find((x) => !names.includes(x)) || `drive ${names.length + 1}`;
  const bare = /** @type {Pulley[]} */ (doc.pulley.map((p) => without(p, TENSIONS)));
  const pulley = [...bare, { ...without(last, TENSIONS), name }];
  /** @type {any} */
  const given = doc.train || Object.fromEntries(Object.entries(only(last, LOADS)).slice(0, 2));
  const train = { ...given };
  if (given.share) train.share = [...given.share, "0 %"];
  else if (Array.isArray(given.speeds)) train.speeds = [...given.speeds, "100 %"];
  else if (!given.speeds) train.share = shares(pulley.length);
  // cases of a single pulley say nothing of a train
  const kept = doc.train ? doc : without(doc, ["load_case"]);
  change(/** @type {Design} */ ({ ...kept, pulley, train }));
}
/** @param {number} i */
function removePulley(i) {
  const { doc } = app;
  const pulley = doc.pulley.filter((_, k) => k !== i);
  const train = doc.train || {};
  if (pulley.length === 1) {
    const single = { ...pulley[0], ...only(train, LOADS) };
    change(/** @type {Design} */ ({ ...without(doc, ["train", "load_case"]), pulley: [single] }));
  } else {
    const rest = Object.fromEntries(
      ["share", "speeds"]
        .filter((key) => Array.isArray(train[key]))
        .map((key) => [
          key,
          train[key].filter((/** @type {any} */ _, /** @type {number} */ k) => k !== i),
        ]),
    );
    change({ ...doc, pulley, ...(doc.train && { train: { ...train, ...rest } }) });
  }
  document.getElementById("add-pulley")?.focus();
}
/** @param {any} t */
const modeOf = (t) =>
  t.share
    ? "share"
    : Array.isArray(t.speeds)
      ? "speeds"
      : t.speeds
        ? "equal"
        : t.motor
          ? "motor"
          : "";
/** @param {string} mode @param {any} answer */
function putMode(mode, answer) {
  const rest = without(app.doc.train, ["share", "speeds", "motor"]);
  const drives = answer?.load_cases?.[0]?.drives;
  const speeds = app.doc.pulley.map((_, i) => {
    const trim = drives?.[i]?.speed_trim;
    return trim ? `${(100 * trim).toFixed(3)} %` : "100 %";
  });
  const n = app.doc.pulley.length;
  if (mode === "share") edit(["train"], { ...rest, share: shares(n) });
  else edit(["train"], { ...rest, speeds: mode === "equal" ? "equal" : speeds });
}

/** @param {Spec} s @param {Path} path @param {any} [more] */
const make = (s, path, more) => field({ spec: s, path, page: "t", slider: false, ...more });
/** @param {any} answer of the last train that was solved */
export const trainInputs = (answer) =>
  h(
    "form",
    { class: "inputs rail card", "aria-label": "Train", onSubmit: (e) => e.preventDefault() },
    app.doc.train && trainFields(app.doc.train, answer),
    app.doc.pulley.map((_, i) => drive(i)),
    h(
      "button",
      {
        type: "button",
        id: "add-pulley",
        onClick: addPulley,
        disabled: app.doc.pulley.length >= 10,
      },
      "Add a drive behind",
    ),
  );
/** @param {any} t @param {any} answer */
function trainFields(t, answer) {
  const mode = modeOf(t);
  const modes = [
    ["share", "shares"],
    ["speeds", "speed trims"],
    ["equal", "equal drum speeds"],
    ...(mode === "motor" ? [["motor", "motors (in the file)"]] : []),
  ];
  const choose = {
    id: "train-mode",
    value: mode,
    onChange: (/** @type {any} */ e) => putMode(e.currentTarget.value, answer),
  };
  return h(
    "fieldset",
    { key: "train" },
    h("legend", {}, "Train"),
    LOADS.map((k) => make(spec("train", k), ["train", k], { slider: undefined })),
    h(
      "div",
      { class: "field", key: "mode" },
      h("label", { for: "train-mode" }, "Given"),
      h("span", {}),
      h(
        "span",
        { class: "box" },
        h(
          "select",
          choose,
          modes.map(([v, text]) => h("option", { value: v, key: v }, text)),
        ),
      ),
    ),
    mode === "share" && each("share", "Such as 50 %, or a power such as 300 kW."),
    mode === "speeds" && each("speeds", "Such as 99.7 %, or 71.6 rpm."),
    app.doc.pulley.slice(1).map(run),
  );
}
/** @type {Record<string, string>} */
const MEANINGS = {
  share: "Part of the load of each drive: the speeds are computed.",
  speeds: "Speed of each drive to the first: the shares are computed.",
};
/** A number of each drive. @param {string} key @param {string} help */
const each = (key, help) => [
  h("p", { class: "help", key: `help-${key}` }, MEANINGS[key]),
  app.doc.pulley.map((p, i) =>
    make({ key, title: p.name || "", kind: "number", help }, ["train", key, i]),
  ),
];
/** @param {Pulley} p */
const run = (p) =>
  make(
    {
      key: "run",
      title: `Run before ${p.name}`,
      kind: "quantity",
      dimension: "force",
      help: "Rise of tension over the run from the pulley before; 0 if left empty.",
    },
    ["train", "run", p.name || ""],
  );
/** @param {number} i */
const drive = (i) =>
  h(
    "fieldset",
    { key: `drive${i}` },
    h("legend", {}, `Drive ${i + 1}`),
    pulleyName(i, "t"),
    ["diameter", "wrap_angle"].map((k) => make(spec("pulley", k), ["pulley", i, k])),
    make(spec("pulley", "lagging"), ["pulley", i, "lagging"], {
      choices: laggingChoices(i),
      read: () => laggingName(app.doc.pulley[i].lagging),
      put: (/** @type {string} */ name) => putLagging(i, name),
    }),
    app.doc.pulley.length > 1 &&
      h("button", { type: "button", onClick: () => removePulley(i) }, "Remove this drive"),
  );
