// The worker beside the page that finds the numbers of the checks.

/** @typedef {(numbers: any[] | null) => void} Done */

const worker = new Worker(new URL("./worker.js", import.meta.url), { type: "module" });
/** @type {Done[]} */
const waiting = [];
worker.onmessage = (e) => waiting.shift()?.(e.data);
/** Numbers of the checks of some arcs; null where they are for the server.
 * @param {import("./numbers.js").Asked[]} arcs @returns {Promise<any[] | null>} */
export const beside = (arcs) =>
  new Promise((done) => {
    waiting.push(done);
    worker.postMessage(arcs);
  });
