// Draws equations for `equations.py`: a line of JSON in, a line of JSON out.
import { createInterface } from "node:readline";
import katex from "katex";

for await (const line of createInterface({ input: process.stdin })) {
  const { latex, display } = JSON.parse(line);
  let answer;
  try {
    answer = { html: katex.renderToString(latex, { displayMode: display, strict: "error" }) };
  } catch (error) {
    answer = { fault: String(error.message) };
  }
  process.stdout.write(`${JSON.stringify(answer)}\n`);
}
