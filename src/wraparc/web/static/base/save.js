// Files for the user. Fetched with what makes the first.

/** @param {string} name @param {Blob | string} data @param {string} [type] */
export function save(name, data, type = "text/plain") {
  const url = URL.createObjectURL(data instanceof Blob ? data : new Blob([data], { type }));
  const link = document.createElement("a");
  link.href = url;
  link.download = name;
  link.click();
  setTimeout(() => URL.revokeObjectURL(url), 9000);
}

/** Have the browser save what a link of one use leads to.
 * @param {string} href @param {string} name */
export const saveFrom = (href, name) =>
  Object.assign(document.createElement("a"), { href, download: name }).click();
