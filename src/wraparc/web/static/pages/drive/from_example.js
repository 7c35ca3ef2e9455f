// What is left of an example that was typed over.
import { app, change } from "../../base/design.js";
import { h } from "../../vendor/preact.js";

/** What an overtyped example still says of itself: title and load cases. */
export function fromExample() {
  const { origin, doc } = app;
  if (!origin) return null;
  const same = (/** @type {string} */ key) =>
    JSON.stringify(doc[key]) === JSON.stringify(origin.document[key]);
  const cases = doc.load_case?.length && same("load_case");
  const title = doc.title && same("title");
  if ((same("belt") && same("pulley") && same("train")) || !(cases || title)) return null;
  const parts = [title && "its title", cases && `its ${doc.load_case?.length} load cases`].filter(
    Boolean,
  );
  const keep = () => {
    app.origin = null;
    change({ ...doc });
  };
  const clear = () => {
    const { load_case, ...rest } = doc;
    app.origin = null;
    change({ ...(cases ? rest : doc), ...(title && { title: "" }) });
    document.getElementById("f-title")?.focus();
  };
  return h(
    "div",
    { class: "card aside", role: "note", key: "origin" },
    h(
      "p",
      {},
      `This began as the example “${origin.title}” and still has `,
      parts.join(" and "),
      ".",
    ),
    h(
      "p",
      { class: "inline" },
      h("button", { type: "button", onClick: clear }, "Take them out"),
      h("button", { type: "button", onClick: keep }, "Apply"),
    ),
  );
}
