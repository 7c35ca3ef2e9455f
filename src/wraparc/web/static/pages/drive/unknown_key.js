// An unknown key of a file, named as it was meant or taken out by one press.
import { app, change, get, set } from "../../base/design.js";
import { changeNaming, noteUndo } from "../../base/removed.js";
import { place } from "../../parts/problems.js";
import { h } from "../../vendor/preact.js";

/** @import { Children, Problem } from "../../types.d.ts" */

/** @param {string} text @param {() => void} onClick */
const press = (text, onClick) => h("button", { type: "button", class: "main", onClick }, text);
/** What names the first unknown key of a file as it was meant, or takes it out.
 * @param {Problem[]} problems @returns {Children} */
export function mend(problems) {
  const one = problems.find(({ code }) => code === "unknown_key");
  if (!one) return null;
  const at = place(one.path);
  const key = String(at.at(-1));
  const meant = String(one.meant);
  const without = () => set(app.doc, at, undefined);
  const rename = () => {
    change(set(without(), [...at.slice(0, -1), meant], get(app.doc, at)));
    noteUndo(`${key} is ${meant} now. `);
  };
  return h(
    "span",
    { class: "mend" },
    one.meant && press(`Rename ${key} to ${meant}`, rename),
    press(`Remove ${key}`, () => changeNaming(without())),
  );
}
