// The drive page: what is turned most beside the drawing that answers.
import { app } from "../base/design.js";
import { h } from "../vendor/preact.js";
import { inputs } from "./drive/inputs.js";
import { Screen } from "./drive/screen.js";
import { nowOf } from "./drive/solving.js";

export const DrivePage = () => h(Screen, { form: inputs(() => nowOf(app.pulley)) });
