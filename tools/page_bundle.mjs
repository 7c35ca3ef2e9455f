// The page as it is served, and the calculator of one file: bundled from the modules of the page.
import { mkdir, readdir, readFile, rm, writeFile } from "node:fs/promises";
import { dirname, join, relative, resolve } from "node:path";
import { fileURLToPath } from "node:url";
import { build } from "esbuild";

const root = resolve(dirname(fileURLToPath(import.meta.url)), "..");
const here = join(root, "src/wraparc/web/one_file");
const pages = join(root, "src/wraparc/web/static");
const common = {
  bundle: true,
  minify: true,
  write: false,
  charset: "utf8",
  target: ["chrome109", "firefox115", "safari16.4"],
  legalComments: "none",
  absWorkingDir: root,
};
/** The library that the pages have as one file. */
const TOML = join(pages, "vendor/smol-toml.js");

// The calculator of one file.

/** Modules that are others in the file. */
const INSTEAD = {
  "base/server.js": "server.js",
  "frame/entry.js": "nothing.js",
  "frame/opening.js": "opening.js",
  "frame/registry.js": "registry.js",
  "pages/drive/beside.js": "beside.js",
  "pages/drive/flights.js": "nothing.js",
  "pages/drive/questions.js": "questions.js",
  "pages/drive/reserve.js": "nothing.js",
  "pages/drive/unknown_key.js": "nothing.js",
};
/** Modules of the first script, which the second finds there. */
const KERNEL = join(pages, "kernel.js");
const SHARED = [KERNEL, join(pages, "pages/drive/numbers.js")];
const instead = {
  name: "instead",
  setup({ onResolve, onLoad }) {
    onResolve({ filter: /^\./ }, ({ path, importer, resolveDir }) => {
      const found = resolve(resolveDir, path);
      if (found === TOML) return { path: join(root, "node_modules/smol-toml/dist/index.js") };
      if (SHARED.includes(found)) return { path: found, namespace: "shared" };
      for (const [name, other] of Object.entries(INSTEAD)) {
        const mine = join(here, other);
        if (found === join(pages, name) && importer !== mine) return { path: mine };
      }
      return undefined;
    });
    onLoad({ filter: /.*/, namespace: "shared" }, () => ({ contents: "module.exports = solver;" }));
  },
};
/** @param {string} file @param {object} how */
async function built(file, how) {
  const entryPoints = [join(here, file)];
  const { outputFiles } = await build({ ...common, format: "iife", ...how, entryPoints });
  return outputFiles[0].text;
}
/** What is not on the first screen before what is: that has the last word. */
const STYLES = ["late.css", "style.css"].map((name) => join(pages, name));
/** @param {string} file */
const styleOf = async (file) =>
  (await build({ ...common, entryPoints: [file] })).outputFiles[0].text;
/** The reader and writer of TOML as one module, for the pages. */
async function vendored() {
  const contents = 'export { parse, stringify, TomlDate, TomlError } from "smol-toml";';
  const how = { stdin: { contents, resolveDir: root }, format: "esm" };
  const { outputFiles } = await build({ ...common, ...how });
  return outputFiles[0].text;
}

// The page as it is served: one script with all that the first page needs; what comes later apart,
// each under the name of its source, and takes what the first script has from there.

/** The worker is fetched by its address. */
const WORKER = join(pages, "pages/drive/worker.js");
/** The address of a file of the page. @param {string} file */
const address = (file) => `/static/${relative(pages, file).replaceAll("\\", "/")}`;
/** Imports of modules that are files of their own; those of `first` are all in the first script.
 * @param {Set<string>} late @param {string[]} first */
const apart = (late, first = []) => ({
  name: "apart",
  setup({ onResolve }) {
    onResolve({ filter: /^\./ }, ({ path, resolveDir, kind }) => {
      const found = resolve(resolveDir, path);
      if (first.includes(found)) return { path: address(join(pages, "main.js")), external: true };
      if (kind !== "dynamic-import") return undefined;
      late.add(found);
      return { path: address(found), external: true };
    });
  },
});
const EXPORT = /^export (?:async )?(?:const|function|class) (\w+)/gm;
/** An export of a library, which is minified. */
const RENAMED = /(?<=export\{[^}]*)\w+ as (\w+)/g;
/** By this a test puts a design on the page. */
const DRIVEN_BY = "take";
/** What a later file takes from the first script: only that is told by name there. */
const TAKEN = /import\{([^}]*)\}from"\/static\/main\.js"/g;
async function served() {
  const late = new Set([WORKER]);
  const esm = { ...common, format: "esm", outdir: join(pages, "built"), outbase: pages };
  const entry = join(pages, "main.js");
  const how = { ...esm, metafile: true, plugins: [apart(late)] };
  const { metafile } = await build({ ...how, entryPoints: [entry] });
  const inputs = Object.keys(metafile.inputs).map((name) => join(root, name));
  const first = inputs.filter((file) => file !== KERNEL); // the little that it takes of it is twice
  let found = { outputFiles: [] };
  for (let known = 0; known < late.size; ) {
    known = late.size;
    const plugins = [apart(late, first)];
    found = await build({ ...esm, splitting: true, plugins, entryPoints: [...late].sort() });
  }
  const takes = found.outputFiles.flatMap(({ text }) => [...text.matchAll(TAKEN)]);
  const taken = takes.flatMap(([, names]) => names.split(",").map((n) => n.split(" as ")[0]));
  const exported = first.map(async (file) => {
    const text = await readFile(file, "utf-8");
    const all = [...text.matchAll(EXPORT), ...text.matchAll(RENAMED)].map(([, name]) => name);
    const names = all.filter((name) => taken.includes(name) || name === DRIVEN_BY);
    return `export { ${names.join(", ")} } from ${JSON.stringify(file)};`;
  });
  const contents = [`import ${JSON.stringify(entry)};`, ...(await Promise.all(exported))].join("");
  const stdin = { contents, resolveDir: pages };
  const main = await build({
    ...how,
    stdin,
    outdir: undefined,
    outfile: join(esm.outdir, "main.js"),
  });
  const style = await build({ ...esm, entryPoints: STYLES });
  const all = [main, found, style].flatMap(({ outputFiles }) => outputFiles);
  const plain = ["index.html", "icon.svg"].map(async (name) => [
    join(esm.outdir, name),
    await readFile(join(pages, name), "utf-8"),
  ]);
  return [...all.map(({ path, text }) => [path, text]), ...(await Promise.all(plain))];
}

const folder = join(here, "built");
const folders = [folder, join(pages, "built")];
const vendor = await vendored();
const made = new Map([
  [TOML, vendor],
  [join(folder, "solver.js"), await built("solver.js", { globalName: "solver" })],
  [join(folder, "page.js"), await built("main.js", { plugins: [instead] })],
  [join(folder, "start.js"), await built("start.js", { format: "esm" })],
  [join(folder, "page.css"), (await Promise.all(STYLES.map(styleOf))).join("")],
  ...(await served()),
]);
const check = process.argv.includes("--check");
/** @type {string[]} */
const stale = [];
for (const [file, text] of made) {
  if ((await readFile(file, "utf-8").catch(() => "")) === text) continue;
  stale.push(file);
  if (check) continue;
  await mkdir(dirname(file), { recursive: true });
  await writeFile(file, text);
}
for (const held of folders)
  for (const one of await readdir(held, { recursive: true, withFileTypes: true })) {
    const file = join(one.parentPath, one.name);
    if (one.isDirectory() || made.has(file)) continue;
    stale.push(file);
    if (!check) await rm(file);
  }
if (check && stale.length) {
  for (const file of stale)
    process.stderr.write(`${relative(root, file)} is not what its source gives: make kernel\n`);
  process.exit(1);
}
