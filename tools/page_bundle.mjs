// The calculator of one file: the modules of the page bundled with what answers them there.
import { readFile, writeFile } from "node:fs/promises";
import { dirname, join, resolve } from "node:path";
import { fileURLToPath } from "node:url";
import { build } from "esbuild";

const root = resolve(dirname(fileURLToPath(import.meta.url)), "..");
const here = join(root, "src/wraparc/web/one_file");
const pages = join(root, "src/wraparc/web/static");
/** Modules that are others in the file. */
const INSTEAD = {
  "base/server.js": "server.js",
  "frame/opening.js": "opening.js",
  "frame/registry.js": "registry.js",
  "pages/drive/beside.js": "beside.js",
};
/** Questions that only a server answers: the file has no button for them. */
const ABSENT = ["seek", "what_if", "choosing", "site", "measured"].map((name) =>
  join(pages, "pages/drive", `${name}.js`),
);
/** Modules of the first script, which the second finds there. */
const SHARED = ["kernel.js", "pages/drive/numbers.js"].map((name) => join(pages, name));
/** The library that the pages have as one file. */
const TOML = join(pages, "vendor/smol-toml.js");
const instead = {
  name: "instead",
  setup({ onResolve, onLoad }) {
    onResolve({ filter: /^\./ }, ({ path, importer, resolveDir }) => {
      const found = resolve(resolveDir, path);
      if (found === TOML) return { path: join(root, "node_modules/smol-toml/dist/index.js") };
      if (SHARED.includes(found)) return { path: found, namespace: "shared" };
      if (ABSENT.includes(found)) return { path: found, namespace: "absent" };
      for (const [name, other] of Object.entries(INSTEAD)) {
        const mine = join(here, other);
        if (found === join(pages, name) && importer !== mine) return { path: mine };
      }
      return undefined;
    });
    onLoad({ filter: /.*/, namespace: "absent" }, () => ({ contents: "" }));
    onLoad({ filter: /.*/, namespace: "shared" }, () => ({ contents: "module.exports = solver;" }));
  },
};
const common = {
  bundle: true,
  minify: true,
  write: false,
  charset: "utf8",
  format: "iife",
  target: ["chrome109", "firefox115", "safari16.4"],
  legalComments: "none",
  absWorkingDir: root,
};
/** @param {string} name @param {object} how */
async function built(name, how) {
  const { outputFiles } = await build({ ...common, ...how, entryPoints: [join(here, name)] });
  return outputFiles[0].text;
}
/** The reader and writer of TOML as one module, for the pages. */
async function vendored() {
  const contents = 'export { parse, stringify, TomlDate } from "smol-toml";';
  const how = { stdin: { contents, resolveDir: root }, format: "esm" };
  const { outputFiles } = await build({ ...common, ...how });
  return outputFiles[0].text;
}
const made = {
  "../../static/vendor/smol-toml.js": await vendored(),
  "solver.js": await built("solver.js", { globalName: "solver" }),
  "page.js": await built("main.js", { plugins: [instead] }),
  "page.css": await built("style.css", {}),
};
const folder = join(here, "built");
const check = process.argv.includes("--check");
let stale = false;
for (const [name, text] of Object.entries(made)) {
  const file = join(folder, name);
  const held = await readFile(file, "utf-8").catch(() => "");
  if (held === text) continue;
  stale = true;
  if (!check) await writeFile(file, text);
}
if (check && stale) {
  process.stderr.write(`${folder} is not what its source gives: make kernel\n`);
  process.exit(1);
}
