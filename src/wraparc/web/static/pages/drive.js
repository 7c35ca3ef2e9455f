// The drive page: inputs on the left, the answer moving as they change.
import { app } from "../base/design.js";
import { h } from "../vendor/preact.js";
import { inputs } from "./drive/inputs.js";
import { Results } from "./drive/results.js";
import { nowOf } from "./drive/solving.js";

export const DrivePage = () => {
  const form = inputs(() => nowOf(app.pulley));
  return h("div", { class: "two" }, form, h(Results, {}));
};
