// What Python has in the words of trains, for what is translated of these.
import { app } from "../static/base/design.js";

export {
  cell__percent as percent,
  cell__quantity as quantity,
  display__display as display,
} from "../static/cells.js";
/** What the glossary has of a quantity. @param {string} name */
export const term = (name) => app.form.glossary[name];
