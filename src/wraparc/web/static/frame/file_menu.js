// The menu File.
import { turnTo } from "../base/address.js";
import { app, redraw } from "../base/design.js";
import { drafts, forgetDrafts, openDraft, otherDrafts } from "../base/drafts.js";
import { noteBack } from "../base/removed.js";
import { act, part } from "../base/server.js";
import { h } from "../vendor/preact.js";
import { download } from "./files.js";
import { item } from "./header.js";
import { draftTitle } from "./offer.js";
import { newDrive, openExample } from "./opened.js";
import { PAGES } from "./registry.js";

function choose() {
  const input = document.createElement("input");
  input.type = "file";
  input.accept = ".toml";
  input.addEventListener(
    "change",
    act(async () => {
      const file = input.files?.[0];
      if (file) await (await part(() => import("./opening.js"))).openFile(file);
    }),
  );
  input.click();
}
const exporting = () => part(() => import("./exporting.js"));
const drawn = async (/** @type {"svg" | "png"} */ kind) => (await exporting()).pictures(kind);
const profiles = async () => (await exporting()).file("results/csv");
export function fileMenu() {
  const kept = otherDrafts();
  return [
    item("New drive", newDrive),
    item(PAGES.saved ? "Open a drive or lagging file …" : "Open a drive file …", choose),
    item("Download the drive file", download),
    PAGES.saved &&
      item("Save, and saved designs …", () => {
        turnTo("saved");
        redraw();
      }),
    PAGES.saved &&
      item("Copy a link to this design", async () =>
        (await part(() => import("./link.js"))).copied(),
      ),
    item("Pictures of this page (SVG)", () => drawn("svg")),
    item("Pictures of this page (PNG)", () => drawn("png")),
    !PAGES.saved && item("Profiles along the wrap (CSV)", profiles),
    item("Print", () => print()),
    h("p", { class: "help", key: "examples" }, "Examples"),
    app.catalogue.examples.map((x) => item(x.title, () => openExample(x.name))),
    kept.length > 0 && h("p", { class: "help", key: "drafts" }, "Drafts saved in this browser"),
    kept.map((d) => item(draftTitle(d), () => openDraft(d))),
    drafts().length > 0 &&
      item("Delete all drafts", () => noteBack(forgetDrafts(), "All drafts are deleted. ")),
  ];
}
