// The calculation note of the drive, and its results as files.
import { act } from "../base/server.js";
import { file } from "../frame/exporting.js";
import { h } from "../vendor/preact.js";

const head = { project: "", number: "", revision: "", author: "", paper: "a4" };
/** @type {[keyof typeof head, string][]} */
const HEADS = [
  ["project", "Project"],
  ["number", "Number"],
  ["revision", "Revision"],
  ["author", "Author"],
];
/** @type {[string, string][]} */
const PAPERS = [
  ["a4", "A4"],
  ["us-letter", "US Letter"],
];
const put = (/** @type {keyof typeof head} */ key) => (/** @type {any} */ e) => {
  head[key] = e.currentTarget.value;
};
const row = (/** @type {string} */ id, /** @type {string} */ label, /** @type {any} */ box) =>
  h(
    "div",
    { class: "field", key: id },
    h("label", { for: id }, label),
    h("span", {}),
    h("span", { class: "box" }, box),
  );
/** @param {keyof typeof head} key @param {string} label */
const text = (key, label) =>
  row(
    `head-${key}`,
    label,
    h("input", {
      type: "text",
      id: `head-${key}`,
      maxLength: 120,
      autocomplete: "off",
      onInput: put(key),
      value: head[key],
    }),
  );
const paper = () =>
  row(
    "head-paper",
    "Paper",
    h(
      "select",
      { id: "head-paper", value: head.paper, onChange: put("paper") },
      PAPERS.map(([value, name]) => h("option", { value, key: value }, name)),
    ),
  );
/** @param {string} kind */
function note(kind) {
  const filled = Object.entries(head).map(([key, value]) => [key, value.trim()]);
  return file(`report/${kind}`, { head: Object.fromEntries(filled.filter(([, value]) => value)) });
}
/** @param {string} name @param {() => any} f @param {boolean} [main] */
const press = (name, f, main) =>
  h("button", { type: "button", class: main ? "main" : "", key: name, onClick: act(f) }, name);

export const Page = () => [
  h(
    "form",
    { class: "card", key: "note", onSubmit: (/** @type {Event} */ e) => e.preventDefault() },
    h("h2", {}, "Calculation note"),
    HEADS.map(([key, label]) => text(key, label)),
    paper(),
    h(
      "p",
      { class: "inline" },
      press("Calculation note (PDF)", () => note("pdf"), true),
      press("Workbook (Excel)", () => note("xlsx")),
      press("Text (Markdown)", () => note("md")),
    ),
  ),
  h(
    "section",
    { class: "card", key: "results" },
    h("h2", {}, "Results"),
    h(
      "p",
      { class: "inline" },
      press("Results (JSON)", () => file("results/json")),
      press("Profiles along the wrap (CSV)", () => file("results/csv")),
    ),
  ),
];
