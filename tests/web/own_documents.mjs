// Documents read by the page: documents as JSON come in, drives in all their fields go out.
import { readFileSync } from "node:fs";
import { known, read } from "../../src/wraparc/web/static/documents.js";

const { catalogue, documents } = JSON.parse(readFileSync(0, "utf-8"));
known(catalogue);
/** A value in its fields, what JSON has no word for as text. */
const plain = (v) => {
  if (v === null || v === undefined) return null;
  if (typeof v === "number") return Number.isFinite(v) ? v : String(v);
  if (Array.isArray(v)) return v.map(plain);
  if (v instanceof Map) return [...v].map(plain);
  if (typeof v !== "object") return v;
  return Object.fromEntries(v.constructor.$names.map((name) => [name, plain(v[name])]));
};
const all = documents.map((document) => {
  const { found, problems } = read(document);
  return { found: plain(found), sentences: problems.map((p) => `${p.sentence} ${p.code}`) };
});
process.stdout.write(JSON.stringify(all));
