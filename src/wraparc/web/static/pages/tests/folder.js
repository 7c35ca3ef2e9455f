// What is dropped or chosen: folders are read to their files, and a plan among them comes first.

/** Files of a folder that no testing machine writes. */
const NO_TEST = /^\.|\.(md|pdf|docx?|pptx?|zip|py|html?|log)$/i;
const isPlan = (/** @type {File} */ f) => /\.toml$/i.test(f.name);

/** @typedef {{plans: File[], pictures: File[], tests: File[]}} Sorted */
/** @param {Iterable<File>} files @returns {Sorted} */
export function sorted(files) {
  const all = [...files].filter((f) => !NO_TEST.test(f.name));
  const pictures = all.filter((f) => f.type.startsWith("image/"));
  const rest = all.filter((f) => !pictures.includes(f));
  const tests = rest.filter((f) => !isPlan(f));
  tests.sort((a, b) => a.name.localeCompare(b.name, undefined, { numeric: true }));
  return { plans: rest.filter(isPlan), pictures, tests };
}
/** All files of a drop, those of its folders too. @param {DataTransfer | null} of */
export async function filesOf(of) {
  const entries = [...(of?.items ?? [])].map((item) => item.webkitGetAsEntry?.() ?? null);
  if (!entries.some((e) => e?.isDirectory)) return [...(of?.files ?? [])];
  return (await Promise.all(entries.map(within))).flat();
}
/** @param {any} entry of a file system @returns {Promise<File[]>} */
async function within(entry) {
  if (!entry) return [];
  if (entry.isFile) return [await new Promise((done, fail) => entry.file(done, fail))];
  const reader = entry.createReader();
  const found = [];
  for (;;) {
    // a reader gives a hundred at a time
    const some = await new Promise((done, fail) => reader.readEntries(done, fail));
    if (!some.length) break;
    found.push(...some);
  }
  return (await Promise.all(found.map(within))).flat();
}
