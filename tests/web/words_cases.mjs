// Texts as the page shows them: what the server sends and slots as JSON come in, texts go out.
import { readFileSync } from "node:fs";
import { app } from "../../src/wraparc/web/static/base/design.js";
import { words } from "../../src/wraparc/web/static/base/units.js";

const { form, texts } = JSON.parse(readFileSync(0, "utf-8"));
app.form = form;
const told = texts.map((text) =>
  ["si", "us"].map((units) => {
    app.units = units;
    return words(text);
  }),
);
process.stdout.write(JSON.stringify(told));
