// Drive files changed in place: texts and documents as JSON come in, new texts go out.
import { readFileSync } from "node:fs";
import { documentOf } from "../../src/wraparc/web/one_file/texts.js";
import { rewritten, textOf } from "../../src/wraparc/web/static/base/toml.js";

const told = JSON.parse(readFileSync(0, "utf-8")).map(({ text, after }) => ({
  kept: rewritten(text, documentOf(text, ""), after),
  anew: textOf(after),
}));
process.stdout.write(JSON.stringify(told));
