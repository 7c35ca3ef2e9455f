// Drives put together by the page: documents as JSON come in, what it judges them by goes out.
import { readFileSync } from "node:fs";
import { app } from "../../src/wraparc/web/static/base/design.js";
import { assemble } from "../../src/wraparc/web/static/pages/drive/assemble.js";

const { form, book, documents } = JSON.parse(readFileSync(0, "utf-8"));
app.form = form;
const all = documents.map((doc) => {
  app.doc = doc;
  return assemble(doc, book);
});
const plain = (_, v) => (typeof v === "number" && !Number.isFinite(v) ? String(v) : v);
process.stdout.write(JSON.stringify(all, plain));
