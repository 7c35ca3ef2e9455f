// The drive file of the design: the text that was opened with what has changed, comments too.
import { app } from "../base/design.js";
import { save } from "../base/save.js";
import { ask, note } from "../base/server.js";
import { rewritten } from "../base/toml.js";
import { fileName } from "./files.js";

export async function download() {
  const { doc, source } = app;
  const kept = source && rewritten(source.toml, source.document, doc);
  if (source?.toml.includes("#") && kept === null)
    note("Comments of the opened file are dropped: too much has changed.");
  const toml = kept ?? (await ask("toml/write", { document: doc })).toml;
  save(`${fileName()}.toml`, toml, "application/toml");
}
