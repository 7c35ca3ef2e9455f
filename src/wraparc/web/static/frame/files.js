// Drives to keep.
import { app } from "../base/design.js";
import { part } from "../base/server.js";

/** Name of a file of this design, without its ending. */
export const fileName = () =>
  (app.doc.title || app.name || "drive")
    .toLowerCase()
    .replace(/[^a-z0-9]+/g, "-")
    .replace(/^-|-$/g, "") || "drive";
export const download = async () => (await part(() => import("./download.js"))).download();
