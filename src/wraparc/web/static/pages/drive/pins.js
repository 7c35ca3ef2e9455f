// What stands beside the arc in the plots: the paper's integration, and a design that was pinned.
import { app, redraw } from "../../base/design.js";
import { act, part } from "../../base/server.js";
import { h } from "../../vendor/preact.js";
import { alongside } from "./pictures.js";
import { answer } from "./solving.js";

/** @import { QuickAnswer } from "../../types.d.ts" */

/** @param {Partial<typeof alongside>} what */
function put(what) {
  Object.assign(alongside, what, { turn: alongside.turn + 1 });
  answer.pinned = alongside.pinned?.profile ?? null;
  redraw();
}
/** @type {typeof import("./pinned.js") | null} */
let late = null;
/** @param {QuickAnswer} arc */
async function pin({ numbers, profile, load_case }) {
  late ??= await part(() => import("./pinned.js"));
  const name = `${app.doc.title || app.name || "this drive"}, load case ${load_case}`;
  put({ pinned: { name, numbers, profile } });
}
/** @param {QuickAnswer} arc */
export function pins(arc) {
  const { pinned, march } = alongside;
  const tick = {
    type: "checkbox",
    id: "march",
    checked: march,
    onChange: () => put({ march: !march }),
  };
  const button = (/** @type {string} */ text, /** @type {(e: Event) => any} */ f) =>
    h("button", { type: "button", onClick: f, key: text }, text);
  return [
    h(
      "p",
      { class: "inline", key: "controls" },
      h("label", { class: "inline" }, h("input", tick), "Compare with the paper's integration"),
      button(
        pinned ? "Pin this design instead" : "Pin this design",
        act(() => pin(arc)),
      ),
      pinned && button("Take the pin out", () => put({ pinned: null })),
    ),
    pinned && late?.differences(arc, pinned),
  ];
}
