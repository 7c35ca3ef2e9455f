// Questions asked of an uneven pulley: will it heal, when to re-lag, does thicker lagging help?
import { app, redraw } from "../../base/design.js";
import { Advice, act, ask } from "../../base/server.js";
import { split } from "../../base/units.js";
import { standing } from "../../parts/answers.js";
import { valueIn } from "../../parts/choose.js";
import { again, attempt } from "../../parts/question.js";
import { judgedIf, refused, stands, table, verdict } from "../../parts/tables.js";
import { h } from "../../vendor/preact.js";
import { askedCase } from "../drive/cases.js";

/** @import { Children, Problem } from "../../types.d.ts" */
/**
 * @typedef {{title: string, button: string, path: string, help: string,
 *   given: {key: string, label: string, value: string, placeholder?: string}[],
 *   body: (given: Record<string, string>) => any}} Question
 */

/** @type {Record<string, Question>} */
const QUESTIONS = {
  wear: {
    title: "When is re-lagging due?",
    button: "Wear it on",
    path: "across/wear",
    help:
      "Each strip wears by its frictional energy, until the thinnest reaches the re-lagging " +
      "thickness. Without a wear coefficient, the rate follows from the hours run since the " +
      "lagging was new.",
    given: [
      { key: "least_thickness", label: "Re-lag at", value: "3 mm" },
      { key: "hours", label: "Hours run so far", value: "", placeholder: "not known" },
      { key: "passes", label: "Turns to look ahead", value: "", placeholder: "to re-lagging" },
    ],
    body: (g) => ({
      least_thickness: g.least_thickness || "3 mm",
      ...(g.hours.trim() ? { hours: count(g.hours, "Hours run so far", "20000") } : {}),
      ...(g.passes.trim() ? { passes: count(g.passes, "Turns to look ahead", "5000000") } : {}),
    }),
  },
  thickness: {
    title: "Does thicker lagging help, and what does it cost?",
    button: "Compare thicknesses",
    path: "across/thickness",
    help: "The same unevenness under new lagging of each thickness.",
    given: [{ key: "thicknesses", label: "Thicknesses", value: "8 mm, 12 mm, 20 mm" }],
    body: (g) => {
      // a comma between digits is no end of a thickness: the server asks what it means
      const thicknesses = g.thicknesses
        .split(/;|,(?!\d)|(?<!\d),/)
        .map((t) => t.trim())
        .filter(Boolean);
      if (thicknesses.length < 2)
        throw new Advice("Thicknesses: write two or more, such as 8 mm, 12 mm, 20 mm.");
      return { thicknesses };
    },
  },
};
const asked = Object.fromEntries(
  Object.entries(QUESTIONS).map(([name, q]) => [
    name,
    {
      given: Object.fromEntries(q.given.map((g) => [g.key, g.value])),
      answer: /** @type {any} */ (null),
      of: "",
      busy: false,
      lost: false,
      problems: /** @type {Problem[]} */ ([]),
    },
  ]),
);
/** A number of hours or turns; a comma is one of thousands, and nothing else.
 * @param {string} text @param {string} label @param {string} such */
function count(text, label, such) {
  const plain = text.trim().replace(/(?<=\d)[\s,](?=\d{3}(?!\d))/g, "");
  const number = split(plain);
  if (!number || number.unit) throw new Advice(`${label}: write a plain number, such as ${such}.`);
  return number.number;
}
/** What is asked now. @param {string} name */
const question = (name) => ({
  document: app.doc,
  pulley: app.doc.pulley[app.pulley].name || null,
  load_case: askedCase(),
  ...QUESTIONS[name].body(asked[name].given),
});
/** Whether an answer is of what is asked now. @param {string} name */
function fresh(name) {
  try {
    return asked[name].of === JSON.stringify(question(name));
  } catch {
    return false; // what is typed is no question
  }
}
/** @param {string} name */
function put(name) {
  const state = asked[name];
  state.answer = null; // what cannot be asked leaves no older answer beside what is said of it
  const now = question(name);
  return attempt(state, async () => {
    const answer = await ask(QUESTIONS[name].path, now);
    Object.assign(state, { answer, of: JSON.stringify(now) });
  });
}
for (const name of Object.keys(QUESTIONS))
  again(
    asked[name],
    () => true,
    () => put(name),
  );
/** @returns {Children} */
export const questions = () => Object.keys(QUESTIONS).map(card);
/** @param {string} name */
function card(name) {
  const q = QUESTIONS[name];
  const { given, answer, busy, problems } = asked[name];
  const how = standing(fresh(name), problems, busy);
  return h(
    "section",
    { class: "card", "aria-label": q.title, id: `question-${name}`, key: name },
    h("h2", {}, q.title),
    h("p", { class: "help" }, q.help),
    h(
      "div",
      { class: "bar" },
      q.given.map((g) =>
        h(
          "label",
          { key: g.key },
          g.label,
          h("input", {
            type: "text",
            id: `ask-${g.key}`,
            value: given[g.key],
            placeholder: g.placeholder,
            onInput: (e) => {
              given[g.key] = valueIn(e);
              redraw();
            },
          }),
        ),
      ),
      h(
        "button",
        { type: "button", class: "main", id: `ask-${name}`, onClick: act(() => put(name)) },
        q.button,
      ),
    ),
    h(
      "div",
      { role: "status", key: "answer" },
      problems.length > 0 && refused("", problems),
      answer && stands(how, verdict(judgedIf(how, answer.verdict)), table(answer.table)),
    ),
  );
}
