// Answers of the page itself to moved numbers: cases as JSON come in, answers go out.
import { readFileSync } from "node:fs";
import { app } from "../../src/wraparc/web/static/base/design.js";
import { differences, ownAnswer } from "../../src/wraparc/web/static/pages/drive/own.js";

const { form, cases } = JSON.parse(readFileSync(0, "utf-8"));
app.form = form;
const told = cases.map(({ base, doc, found }) => {
  const own = ownAnswer(base, doc, 24);
  return own && { own, differences: differences(own, found) };
});
process.stdout.write(JSON.stringify(told));
