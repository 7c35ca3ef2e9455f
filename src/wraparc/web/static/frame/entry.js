// What a window asks for where it does not know the server: the address that was printed.
import { keepToken, proof, token } from "../base/proof.js";
import { askAgain } from "../base/server.js";
import { h } from "../vendor/preact.js";

const IN = /[?&]token=([\w-]+)/;
/** What is pasted is sent to no server but to one that proves to know it. A window that knew none
 * has nothing of one, and opens the address. @param {any} e */
async function enter(e) {
  e.preventDefault();
  const [input] = e.currentTarget.elements;
  const value = IN.exec(input.value)?.[1] ?? input.value.trim();
  const [same] = await proof(value, new AbortController().signal).catch(() => [false]);
  if (!same && !token()) {
    location.search = `?token=${encodeURIComponent(value)}`;
  } else if (same) {
    const began = !token();
    keepToken(value);
    if (began) location.reload();
    else askAgain();
  } else {
    input.setCustomValidity("The server that answers here does not know this address.");
    input.reportValidity();
  }
}
/** @param {any} e */
const typed = (e) => e.currentTarget.setCustomValidity("");
const KEPT = "Nothing is sent to it. The drive is saved in this browser as typed.";

/** The bar that asks for the address. */
export const entry = () =>
  h(
    "div",
    { class: "verdict bad gone", role: "alert", key: "gone" },
    h(
      "p",
      { class: "headline" },
      token()
        ? "The server was restarted, or another program answers here."
        : "This calculator requires its address.",
    ),
    h("p", {}, token() ? KEPT : "It is the one that wraparc serve printed (…/?token=…)."),
    h(
      "form",
      { class: "inline", onSubmit: enter },
      h("label", { for: "entry" }, "Address that wraparc serve printed"),
      h("input", { id: "entry", required: true, autocomplete: "off", onInput: typed }),
      h("button", { class: "main" }, "Continue"),
    ),
  );
