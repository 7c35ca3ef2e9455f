// The menu Export: pictures of the page, results, profiles, the calculation note.
import { app } from "../base/design.js";
import { Advice, askFile, part, save } from "../base/server.js";
import { h } from "../vendor/preact.js";
import { fileName } from "./files.js";
import { item } from "./header.js";
import { PAGES } from "./registry.js";

const head = { project: "", number: "", revision: "", author: "", paper: "a4" };

/** What can be taken away from the page that is looked at. */
export const exportMenu = () => [
  item("Pictures of this page (SVG)", () => pictures("svg")),
  item("Pictures of this page (PNG)", () => pictures("png")),
  item("Profiles along the wrap (CSV)", () => file("results/csv")),
  ...(PAGES.saved ? files() : []),
];
const files = () => [item("Results (JSON)", () => file("results/json")), ...reportParts()];
/** @param {"svg" | "png"} kind */
async function pictures(kind) {
  const { png, svg } = await part(() => import("./pictures.js"));
  const found = svg();
  if (!found) throw new Advice("There is no picture on this page yet.");
  const data =
    kind === "svg" ? new Blob([found.text], { type: "image/svg+xml" }) : await png(found);
  save(`${fileName()}-${app.page}.${kind}`, data);
}
/** A file that the server makes of the drive. @param {string} path @param {object} [more] */
async function file(path, more) {
  const asked = { document: app.doc, units: app.units, name: fileName(), ...more };
  const [data, name] = await askFile(path, asked);
  save(name || `${fileName()}.${path.split("/")[1]}`, data);
}
/** @type {[keyof typeof head, string][]} */
const HEADS = [
  ["project", "Project"],
  ["number", "Number"],
  ["revision", "Revision"],
  ["author", "Author"],
];
function reportParts() {
  const put = (/** @type {keyof typeof head} */ k) => (/** @type {any} */ e) => {
    head[k] = e.currentTarget.value;
  };
  const papers = [
    ["a4", "A4"],
    ["us-letter", "US Letter"],
  ];
  const box = (/** @type {keyof typeof head} */ k) =>
    h("input", {
      type: "text",
      id: `head-${k}`,
      maxLength: 120,
      autocomplete: "off",
      onInput: put(k),
      value: head[k],
    });
  const make = (/** @type {string} */ kind) => () => {
    const filled = Object.entries(head).map(([k, v]) => [k, v.trim()]);
    return file(`report/${kind}`, { head: Object.fromEntries(filled.filter(([, v]) => v)) });
  };
  return [
    h("p", { class: "help", key: "note" }, "Calculation note"),
    h(
      "div",
      { class: "stack pad", key: "head" },
      HEADS.map(([k, label]) => h("label", { key: k }, label, box(k))),
      h(
        "label",
        {},
        "Paper",
        h(
          "select",
          { id: "head-paper", value: head.paper, onChange: put("paper") },
          papers.map(([v, t]) => h("option", { value: v, key: v }, t)),
        ),
      ),
    ),
    item("Calculation note (PDF)", make("pdf")),
    item("Workbook (Excel)", make("xlsx")),
    item("Text (Markdown)", make("md")),
  ];
}
