// The solver of the file, which its page and its worker share.
export * from "../static/kernel.js";
export { numbersOfAll } from "../static/pages/drive/numbers.js";
