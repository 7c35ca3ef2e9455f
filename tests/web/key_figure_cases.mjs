// Tiles and pins of the page for one arc: the form and numbers as JSON come in, titles go out.
import { readFileSync } from "node:fs";

// modules of the page look at the document and listen while they are loaded
const idle = new Proxy(() => idle, { get: (_, key) => (key === Symbol.toPrimitive ? () => "" : idle) });
for (const name of ["document", "window", "location", "history", "addEventListener"])
  globalThis[name] ??= idle;
const { app } = await import("../../src/wraparc/web/static/base/design.js");
const { figures } = await import("../../src/wraparc/web/static/pages/drive/figures.js");
const { differences } = await import("../../src/wraparc/web/static/pages/drive/pinned.js");

const { form, arc } = JSON.parse(readFileSync(0, "utf-8"));
Object.assign(app, { form, units: "si" });
/** Texts in elements of a kind, in their order. */
const texts = (of, kind) => {
  if (Array.isArray(of)) return of.flatMap((part) => texts(part, kind));
  if (typeof of !== "object" || of === null) return [];
  const { children } = of.props ?? {};
  return of.type === kind ? [[children].flat().join("")] : texts(children, kind);
};
const pinned = { name: "before", numbers: arc.numbers };
process.stdout.write(
  JSON.stringify({ tiles: texts(figures(arc), "dt"), pins: texts(differences(arc, pinned), "th") }),
);
