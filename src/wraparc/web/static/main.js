// Starts the calculator: what it must know, the design to begin with, and what follows a change.
import { again, brought, keepAddress, keepMine, pageOfAddress } from "./base/address.js";
import { app, look, redraw, watch } from "./base/design.js";
import { beginWith, keepDraft, offerDraft, openShown } from "./base/drafts.js";
import { keepToken, takeToken } from "./base/proof.js";
import { ask, cancel, onReturn, part, told, unanswered, waited } from "./base/server.js";
import { keepFocus } from "./frame/focus.js";
import { Header, listen } from "./frame/header.js";
import { Main, present } from "./frame/pages.js";
import { PAGES } from "./frame/registry.js";
import { came, solve } from "./pages/drive/solving.js";
import { h, render } from "./vendor/preact.js";

/** @param {string} id */
const box = (id) => /** @type {HTMLElement} */ (document.getElementById(id));

/** Draw everything that is seen; Preact changes only what is another. */
function draw() {
  const title = [app.doc?.title, PAGES[app.page].title, "wraparc"].filter(Boolean).join(" – ");
  if (document.title !== title) document.title = title;
  const { tab } = PAGES[app.page];
  Object.assign(document.documentElement.dataset, { units: app.units, tab });
  present()?.update?.();
  render(h(Header, {}), box("header"));
  render(h(Main, {}), box("main"));
  if (box("toast").className !== (told.bad ? "bad" : ""))
    box("toast").className = told.bad ? "bad" : "";
  render(told.text, box("toast"));
  render(atWork(), box("work"));
  keepFocus();
}
/** What takes longer than a second, and a way to end it. */
const atWork = () =>
  !app.gone && waited() > 0
    ? [`Calculating for ${waited()} s `, h("button", { type: "button", onClick: cancel }, "Cancel")]
    : null;
/** What a sheet of paper must say of itself. */
const PrintHead = () => {
  const file = app.design ? `${app.design.name}, version ${app.design.version}` : app.name;
  const parts = [file, `wraparc ${app.about.version}`, `printed ${new Date().toLocaleString()}`];
  return h("p", {}, parts.filter(Boolean).join("; "));
};
let drawing = false;
function changed() {
  if (!app.doc) return; // the design of a link is still on its way
  solve(); // the request leaves first, the page follows while it is on its way
  keepDraft();
  keepAddress();
  if (drawing) return;
  drawing = true;
  queueMicrotask(() => {
    drawing = false;
    try {
      draw();
    } catch (x) {
      console.error(x); // not by a note: to show that is to draw, and to fail, without end
      render(String(x), box("toast"));
    }
  });
}
const openLink = async () => (await part(() => import("./frame/link.js"))).openLink();
/** A page of the history, or a link that was put into the address. */
async function arrive() {
  const page = pageOfAddress();
  if (brought()) await openLink();
  keepMine();
  look({ page: PAGES[page] ? page : "drive" });
}

async function begin() {
  const paths = ["schema", "catalogue", "start", "about", "start/solved"];
  const [form, catalogue, first, about, solved] = await Promise.all(paths.map((p) => ask(p)));
  Object.assign(app, { form, catalogue, about });
  box("wait").remove();
  box("about").textContent =
    `wraparc ${about.version}. Illustrative laggings describe no real product.`;
  const page = pageOfAddress();
  app.page = PAGES[page] ? page : "drive";
  watch(changed);
  const opened = again ? openShown() : brought() && (await openLink());
  if (!opened) {
    if (solved) came.set(first.document, solved);
    if (!location.hash && first.document.pulley.length > 1 && PAGES.saved) app.page = "train";
    beginWith(first.document, { name: first.name, source: first });
  }
  offerDraft();
  keepMine();
  redraw();
  listen();
}
function skip() {
  const link = box("skip");
  link.addEventListener("click", (e) => {
    e.preventDefault();
    box(`${app.page}-title`).focus();
  });
}
function paper() {
  const head = () => render(h(PrintHead, {}), box("print-head"));
  matchMedia("print").addEventListener("change", head);
  addEventListener("beforeprint", () => {
    draw();
    head();
    for (const d of document.querySelectorAll("main details.table:not([open])")) {
      d.setAttribute("open", "");
      d.setAttribute("data-shut", "");
    }
  });
  addEventListener("afterprint", () => {
    for (const d of document.querySelectorAll("[data-shut]")) {
      d.removeAttribute("open");
      d.removeAttribute("data-shut");
    }
  });
}

takeToken();
skip();
paper();
addEventListener("hashchange", arrive);
begin().catch(async (x) => {
  if (app.stranger) {
    keepToken(""); // of another start: this page is of the server that answers
    return render((await part(() => import("./frame/entry.js"))).entry(), box("main"));
  }
  if (unanswered(x)) onReturn(() => location.reload());
  else console.error(x);
  render(h("p", { class: "verdict bad", role: "alert" }, x.message), box("main"));
});
