// The worker of the file, made from its own solver: there is no other file to load.
import { numbersOfAll } from "../static/pages/drive/numbers.js";

/** @import { Asked } from "../static/pages/drive/numbers.js" */

const program = document.getElementById("solver")?.textContent ?? "";
const ANSWER = "onmessage = (e) => postMessage(solver.numbersOfAll(e.data));";
/** @type {{arcs: Asked[], done: (numbers: any[] | null) => void}[]} */
const waiting = [];

/** @returns {Worker | null} */
function made() {
  try {
    const found = new Worker(URL.createObjectURL(new Blob([program, "\n", ANSWER])));
    found.onmessage = (e) => waiting.shift()?.done(e.data);
    found.onerror = () => {
      worker = null; // a browser that lets a file have none: the page does it itself
      for (const { arcs, done } of waiting.splice(0)) done(numbersOfAll(arcs));
    };
    return found;
  } catch {
    return null;
  }
}
let worker = made();

/** Numbers of the checks of some arcs. @param {Asked[]} arcs @returns {Promise<any[] | null>} */
export const beside = (arcs) =>
  new Promise((done) => {
    if (!worker) return done(numbersOfAll(arcs));
    waiting.push({ arcs, done });
    worker.postMessage(arcs);
  });
