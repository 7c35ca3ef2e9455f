// A list to choose from.
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
