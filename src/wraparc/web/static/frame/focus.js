// The keyboard stays beside what it pressed, where that is gone, hidden or of no use any more.
import { app } from "../base/design.js";

/** What has the focus and what that stands in, from the inside out. @type {HTMLElement[]} */
let held = [];
/** @param {EventTarget | null} target */
function hold(target) {
  held = [];
  for (let e = target; e instanceof HTMLElement; e = e.parentElement) held.push(e);
}
addEventListener("focusin", ({ target }) => hold(target));
addEventListener("pointerdown", () => (held = []));
/** @param {HTMLElement} e */
const there = (e) => e.isConnected && !e.matches(":disabled, [hidden], [hidden] *");
/** Called after everything is drawn anew, and when an answer is drawn alone. */
export function keepFocus() {
  const now = document.activeElement;
  if (!held[0] || there(held[0]) || (now !== document.body && now !== held[0])) return;
  const again = held[0].id && document.getElementById(held[0].id); // drawn anew elsewhere
  if (again && there(again)) return again.focus({ preventScroll: true });
  const near = held.find((e) => e.id !== "main" && there(e) && e.textContent);
  const to = near?.closest("main, header") ? near : document.getElementById(`${app.page}-title`);
  if (!to?.hasAttribute("tabindex")) to?.setAttribute("tabindex", "-1");
  to?.focus({ preventScroll: true });
}
document.addEventListener("painted", keepFocus);
