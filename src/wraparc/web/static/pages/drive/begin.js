// A drive whose load is still to be typed: on the strands, and where else it may come from.
import { app, redraw, wrong } from "../../base/design.js";
import { act } from "../../base/server.js";
import { openExample } from "../../frame/opened.js";
import { NEEDED } from "../../parts/field.js";
import { h } from "../../vendor/preact.js";
import { describe } from "./conveyor.js";
import { loadBoxes } from "./inputs.js";
import { said } from "./screen.js";

/** @param {string} text @param {() => any} f */
const link = (text, f) =>
  h("p", { key: text }, h("button", { type: "button", class: "link", onClick: act(f) }, text));

/** The first box has the keys, where nothing else is typed in. @param {HTMLElement | null} box */
function reached(box) {
  if (!document.activeElement?.matches("main *")) box?.querySelector("input")?.focus();
}
/** The load, on the strands. */
export const strands = () =>
  h(
    "div",
    {
      class: "typed",
      role: "group",
      "aria-label": "Load",
      key: `load${app.opened}`, // another drive: its boxes are other ones
      ref: reached,
      onfocusout: () => setTimeout(redraw),
    },
    loadBoxes(app.pulley, "s"),
  );
/** What is to be typed; nothing where something typed is wrong. */
export const verdict = () =>
  [...wrong.at.values()].every((text) => text === NEEDED) &&
  said(
    "",
    "Type T1 and T2: the rest has usual values.",
    "Or begin from an example.",
    h(
      "button",
      {
        type: "button",
        class: "main advice",
        onClick: act(() => openExample(app.catalogue.examples[0].name)),
      },
      "Load the example",
    ),
  );
/** What stands in the place of the checks. */
export const beside = () =>
  h("div", { class: "from" }, [
    h(
      "p",
      { class: "help" },
      "The checks against CEMA, the belt rating, the tests and the creep limit appear here, " +
        "worst first.",
    ),
    h("h2", {}, "You do not know T1 and T2?"),
    link("Compute T1, T2 from the conveyor", describe),
    h("p", {}, "Length, lift and tonnage give them. Power and T2: see More inputs."),
    h("h2", {}, "Begin from"),
    app.catalogue.examples.map((x) => link(x.title, () => openExample(x.name))),
  ]);
