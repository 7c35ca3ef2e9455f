// The text of a file to a document; what keeps it from being one is said as wraparc solve says it.
import { Advice } from "../static/base/server.js";
import { plain } from "../static/base/toml.js";
import { syntaxProblem } from "../static/reader.js";
import { parse, TomlError } from "../static/vendor/smol-toml.js";

/** @param {string} text @param {string} name */
export function documentOf(text, name) {
  try {
    return plain(parse(text));
  } catch (error) {
    if (!(error instanceof TomlError)) throw error;
    throw new Advice(syntaxProblem(text, error.line, name).__str__());
  }
}
