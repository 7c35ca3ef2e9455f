// A draft from before, offered beside a design that is only opened.
import { redraw } from "../base/design.js";
import { forgetDrafts, offered, openDraft } from "../base/drafts.js";
import { noteBack } from "../base/removed.js";
import { timeOf } from "../base/units.js";
import { h } from "../vendor/preact.js";

/** @import { Draft } from "../base/drafts.js" */

/** @param {Draft} d */
export const draftTitle = (d) =>
  `${d.doc.title || d.name || "Drive without a title"}, ${timeOf(d.when)}`;

/** @param {Draft} draft */
export function offer(draft) {
  const close = () => {
    offered.draft = null;
    redraw();
  };
  const forget = () => {
    const back = forgetDrafts(draft);
    close();
    noteBack(() => {
      offered.draft = draft;
      back();
    }, "The draft is deleted. ");
  };
  return h(
    "div",
    { class: "card aside", role: "note", key: "draft" },
    h("p", {}, `A draft is saved in this browser: ${draftTitle(draft)}.`),
    h(
      "p",
      { class: "inline" },
      h("button", { type: "button", class: "main", onClick: () => openDraft(draft) }, "Open it"),
      h("button", { type: "button", onClick: close }, "Not now"),
      h("button", { type: "button", onClick: forget }, "Forget it"),
    ),
  );
}
