// A box for text that counts once it is left.
import { Component, h } from "../vendor/preact.js";
import { valueIn } from "./choose.js";

/** What is being typed stays, whatever is drawn meanwhile. */
export class Box extends Component {
  /** @type {string | undefined} */
  typed = undefined;
  /** @param {{value: string, put: (text: string) => void, [attribute: string]: any}} props */
  render({ value, put, ...more }) {
    return h("input", {
      type: "text",
      ...more,
      value: this.typed ?? value,
      onInput: (/** @type {Event} */ e) => {
        this.typed = valueIn(e);
      },
      onChange: (/** @type {Event} */ e) => {
        this.typed = undefined;
        put(valueIn(e).trim());
      },
    });
  }
}
