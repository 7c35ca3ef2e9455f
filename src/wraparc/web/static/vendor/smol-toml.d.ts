// The types of the vendored file, which is bundled from the package of this version.
export { parse, stringify, TomlDate, TomlError } from "smol-toml";
