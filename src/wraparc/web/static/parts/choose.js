// Something to choose from.
import { h } from "../vendor/preact.js";

/** @param {Event} e */
export const valueIn = (e) =>
  /** @type {HTMLInputElement | HTMLSelectElement} */ (e.currentTarget).value;
/**
 * @param {string | number} value @param {[string | number, string][]} choices
 * @param {(value: string) => void} put @param {string} [id]
 */
export const choose = (value, choices, put, id) =>
  h(
    "select",
    { id, value, onChange: (/** @type {Event} */ e) => put(valueIn(e)) },
    choices.map(([v, text]) => h("option", { value: String(v), key: v }, text)),
  );
/**
 * One of a few, side by side.
 * @param {string} name @param {string} legend @param {string} now
 * @param {[string, string][]} choices @param {(value: any) => void} put
 */
export const oneOf = (name, legend, now, choices, put, cls = "switch") =>
  h(
    "fieldset",
    { class: cls },
    h("legend", { class: "away" }, legend),
    choices.map(([value, text]) => {
      const onChange = () => put(value);
      const own = { type: "radio", name, value, checked: value === now, onChange };
      return h("label", { key: value }, h("input", own), h("span", {}, text));
    }),
  );
