// What Python has in the words of trains, for what is translated of these.
export {
  cell__fixed as fixed,
  cell__percent as percent,
  cell__quantity as quantity,
  display__display as display,
} from "../static/cells.js";
export { term } from "../static/documents.js";

/** A key figure of an arc. @param {any} arc @param {string} name @returns {number} */
export const figure_of = ({ figures }, name) => figures[name] ?? Number.NaN;
