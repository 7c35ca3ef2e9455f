// What Python has in the words of trains, for what is translated of these.
export {
  cell__percent as percent,
  cell__quantity as quantity,
  display__display as display,
} from "../static/cells.js";
export { term } from "../static/documents.js";
