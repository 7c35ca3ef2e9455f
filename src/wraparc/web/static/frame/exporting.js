// Files that are made of the page that is looked at, or by the server of the drive.
import { app } from "../base/design.js";
import { save } from "../base/save.js";
import { Advice, askFile, part } from "../base/server.js";
import { fileName } from "./files.js";

/** @param {"svg" | "png"} kind */
export async function pictures(kind) {
  const { png, svg } = await part(() => import("./pictures.js"));
  const found = svg();
  if (!found) throw new Advice("There is no picture on this page yet.");
  const data =
    kind === "svg" ? new Blob([found.text], { type: "image/svg+xml" }) : await png(found);
  save(`${fileName()}-${app.page}.${kind}`, data);
}
/** A file that the server makes of the drive. @param {string} path @param {object} [more] */
export async function file(path, more) {
  const asked = { document: app.doc, units: app.units, name: fileName(), ...more };
  const [data, name] = await askFile(path, asked);
  save(name || `${fileName()}.${path.split("/")[1]}`, data);
}
