// Finds the numbers of the checks beside the page, so that its pictures do not wait for them.
import { numbersOfAll } from "./numbers.js";

/** @param {MessageEvent} e */
globalThis.onmessage = (e) => postMessage(numbersOfAll(e.data));
