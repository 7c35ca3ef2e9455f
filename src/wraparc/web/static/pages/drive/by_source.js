// Creep by source below the plots.
import { percent, shown, title, unit } from "../../base/units.js";
import { Budget } from "../../plots/budget.js";
import { alongside, marched } from "./pictures.js";

/** @import { QuickAnswer } from "../../types.d.ts" */

const PARTS = ["creep_shrinkage", "creep_compression", "creep_global"];

export class BySource {
  /** @type {QuickAnswer | null} */
  arc = null;
  wide = 0;
  /** @param {HTMLElement} figure with a caption and a box */
  constructor(figure) {
    const [caption, box] = figure.children;
    const parts = /** @type {[HTMLElement, HTMLElement]} */ ([caption, box]);
    this.budget = new Budget(...parts, "Creep by source");
    // drawing must not ask for the width: that would lay out the page at every step
    new ResizeObserver(([e]) => {
      const wide = Math.floor(e.contentRect.width);
      if (!wide || wide === this.wide) return;
      this.wide = wide;
      if (this.arc) this.draw(this.arc);
    }).observe(figure);
  }
  /** A bar for each method. @param {QuickAnswer} arc */
  draw(arc) {
    this.arc = arc;
    if (!this.wide) return;
    const [u, f] = unit("length");
    const n = arc.numbers;
    const side = n.effective_tension < 0 ? -1 : 1;
    const partsOf = (/** @type {Record<string, number>} */ m) => PARTS.map((k) => m[k] / f);
    const bars = [{ label: "distributed", parts: partsOf(n) }];
    const march = marched();
    if (march) bars.push({ label: "paper's integration", parts: partsOf(march.numbers) });
    if (alongside.pinned) bars.push({ label: "pinned", parts: partsOf(alongside.pinned.numbers) });
    const names = ["belt shrinkage", "lagging compression", "global creep"];
    const legend = PARTS.map((k, i) => {
      const share = n.exit_creep ? ` (${percent(n[k] / n.exit_creep, 2)})` : "";
      return `${names[i]} ${shown(k, n[k], 3)}${share}`;
    });
    const told = PARTS.map((k) => `${title(k)} ${shown(k, n[k], 3)}`).join(", ");
    const limit = (side * arc.creep_limit) / f;
    this.budget.draw(this.wide, bars, limit, u, `Creep by source: ${told}`, legend);
  }
}
