// Texts that are no TOML: what the page of one file says of each, null where it takes it.
import { readFileSync } from "node:fs";
import { documentOf } from "../../src/wraparc/web/one_file/texts.js";

const said = (text) => {
  try {
    documentOf(text, "drive.toml");
    return null;
  } catch (error) {
    return error.message;
  }
};
process.stdout.write(JSON.stringify(JSON.parse(readFileSync(0, "utf-8")).map(said)));
