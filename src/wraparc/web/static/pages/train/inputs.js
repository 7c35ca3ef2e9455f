// The inputs of a train: what is given of it, and its drives one behind the other.
import { app } from "../../base/design.js";
import { changeNaming, putLagging } from "../../base/removed.js";
import { field, spec } from "../../parts/field.js";
import { h } from "../../vendor/preact.js";
import { laggingChoices, laggingName } from "../drive/inputs.js";
import { pulleyName } from "../drive/more.js";
import { known } from "../drive/solving.js";
import { LOADS, movedKeys, shares, withDrive, withoutDrive } from "./convert.js";
import { typeShare } from "./strips.js";

/** @import { Path, Pulley, Spec } from "../../types.d.ts" */

/** @param {any} table @param {string[]} keys */
const without = (table, keys) =>
  Object.fromEntries(Object.entries(table).filter(([k]) => !keys.includes(k)));

export const addPulley = () =>
  changeNaming(withDrive(app.doc, known()?.arcs ?? []), movedKeys(app.doc));
/** @param {number} i */
function removePulley(i) {
  changeNaming(withoutDrive(app.doc, i), movedKeys(app.doc));
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
  const division =
    mode === "share" ? { share: shares(n) } : { speeds: mode === "equal" ? "equal" : speeds };
  changeNaming({ ...app.doc, train: { ...rest, ...division } }, ["share", "speeds"]);
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
const BY_CONVEYOR = "The conveyor gives the tensions: see One pulley, More inputs.";
/** @param {any} t @param {any} answer */
function trainFields(t, answer) {
  const mode = modeOf(t);
  const modes = [
    ["share", "shares"],
    ["speeds", "speed trims"],
    ["equal", "equal pulley speeds"],
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
    app.doc.conveyor
      ? h("p", { class: "help", key: "conveyor" }, BY_CONVEYOR)
      : LOADS.map((k) => make(spec("train", k), ["train", k], { slider: undefined })),
    h(
      "div",
      { class: "field", key: "mode" },
      h("label", { for: "train-mode" }, "Input"),
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
    !app.doc.conveyor && app.doc.pulley.slice(1).map(run),
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
    make(
      { key, title: p.name || "", kind: "number", help },
      ["train", key, i],
      key === "share" ? { put: (/** @type {any} */ text) => typeShare(i, text) } : {},
    ),
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
