// The slack side that a design standard asks for: its friction or factor and its rule in words.

/** @import { Book, BookLaw } from "../../types.d.ts" */
/** @typedef {{friction: number, factor: number, rule: string, why: string}} Asked */

const none = Number.NaN;
/** Of angles in degrees. */
const ROUNDING = 1e-9;

/**
 * What a standard asks of a pulley with a lagging; no rule where none is asked for.
 * @param {import("./assemble.js").Said} said @param {BookLaw} law @param {Book} book
 * @returns {Asked}
 */
export function standardOf({ standard, takeUp, lagging, pulley }, law, book) {
  const { rows, manual, own, silent } = book.standards;
  const asked = { friction: none, factor: none, rule: "", why: "" };
  if (standard.name === "none") return asked;
  const surface = lagging.surface;
  const name = standard.name || "CEMA";
  if (name === "CEMA" && takeUp.kind === "fixed" && surface) {
    const table = manual[surface === "bare" ? "bare" : "lagged"];
    const angle = (pulley.wrap_angle * 180) / Math.PI;
    const row = table.filter((r) => +r.angle <= angle + ROUNDING).pop();
    if (!row || angle > +table[table.length - 1].angle + ROUNDING)
      return { ...asked, rule: name, why: silent.manual };
    return { ...asked, factor: +row.factor, rule: row.rule };
  }
  if (name === "own") {
    const { friction } = standard;
    return { ...asked, friction, rule: own.replace("⟦friction⟧", friction.toFixed(2)) };
  }
  const lagged = lagging.name;
  if (!surface)
    return { ...asked, rule: name, why: silent.surface.replace("⟦lagging⟧", () => lagged) };
  const condition = standard.condition || law.condition;
  const found = rows.find(
    (r) => r.standard === name && r.surface === surface && ["", condition].includes(r.condition),
  );
  if (found) return { ...asked, friction: +found.friction, rule: found.rule };
  const why = silent.condition
    .replace("⟦surface⟧", () => surface)
    .replace("⟦condition⟧", () => condition);
  return { ...asked, rule: name, why };
}
