// Shear tests: machine files to a lagging file.
import { turnTo } from "../base/address.js";
import { app, redraw, set } from "../base/design.js";
import { putLagging } from "../base/removed.js";
import { act, note, refusal, save, sentence } from "../base/server.js";
import { words } from "../base/units.js";
import { list, refused, standing, stands, table } from "../parts/answers.js";
import { h } from "../vendor/preact.js";
import { figureCard, hasFigure } from "./tests/figure.js";
import {
  allSaid,
  details,
  drop,
  expect,
  files,
  saidOf,
  sendFigure,
  session,
  takePicture,
  within,
} from "./tests/files.js";
import {
  asked,
  isFigure,
  planForm,
  rowOf,
  openPlan as takePlan,
  typedAt,
  unsaid,
} from "./tests/plan.js";
import { conditionPlots } from "./tests/plots.js";

/** Take a test plan in: the form at once, its tests when their files are dropped.
 * @param {any} plan */
export function openPlan(plan) {
  takePlan(plan);
  expect(plan.test ?? []);
}

/** @import { Problem, Table } from "../types.d.ts" */
/**
 * @typedef {{name: string, toml: string | null, lagging: any, sheet: any, left_out: Problem[],
 *   conditions: any[]}} Fit
 */

const state = {
  fitting: false,
  problems: /** @type {Problem[]} */ ([]),
  /** What is wrong with a row of the form, by part and key. */
  marks: /** @type {Record<string, string>} */ ({}),
  result: /** @type {Fit | null} */ (null),
  /** What it is of. */
  of: "",
  /** Why a law is to be used that does not describe its tests. */
  reason: "",
};
/** What a fit is of: the plan, and what is said of its files. */
const subject = () => JSON.stringify([asked(), session.files.map((f) => [f.name, saidOf(f)])]);
/** @param {string} reason why its misfit is accepted, if it is */
async function fit(reason = "") {
  Object.assign(state, { problems: [], fitting: true });
  state.marks = unsaid();
  const open = Object.keys(state.marks).length;
  redraw();
  try {
    if (!(await sendFigure()) || open) {
      requestAnimationFrame(() =>
        /** @type {HTMLElement | null} */ (
          document.querySelector("#tests [aria-invalid=true], #tests .wrong input")
        )?.focus(),
      );
      return;
    }
    await allSaid();
    const of = subject();
    const result = await within("fit", { ...asked(), accept_misfit: reason });
    Object.assign(state, { result, of });
    requestAnimationFrame(() =>
      document.getElementById("fitted")?.scrollIntoView({ block: "start" }),
    );
  } catch (x) {
    const problems = refusal(x);
    state.problems = problems.filter((p) => !rowOf(p.path));
    for (const p of problems) if (rowOf(p.path)) state.marks[typedAt(p.path)] = sentence(p);
    if (!state.problems.length) state.problems = problems;
  } finally {
    state.fitting = false;
    redraw();
  }
}
async function download() {
  if (!(await sendFigure())) return;
  await allSaid();
  const { toml, name } = await within("plan", asked());
  save(name, toml, "application/toml");
}
function use() {
  const { name, lagging } = /** @type {Fit} */ (state.result);
  putLagging(app.pulley, name, set(app.doc, ["lagging", name], lagging));
  note(`The lagging ${name} is on pulley ${app.doc.pulley[app.pulley].name} now.`);
  turnTo("drive");
  redraw();
}

export const Page = () =>
  h(
    "div",
    { class: "two" },
    planForm(state.marks),
    h(
      "div",
      { class: "results" },
      drop(),
      isFigure() && figureCard(takePicture),
      session.files.length > 0 && files(),
      session.files.length > 0 && details(),
      h(
        "p",
        { class: "bar", key: "fit" },
        h(
          "button",
          {
            type: "button",
            class: "main",
            disabled: !(isFigure()
              ? hasFigure() || session.files.some((f) => f.digitised.length)
              : session.files.some((f) => f.read)),
            onClick: act(() => fit()),
          },
          "Fit the lagging",
        ),
        h("button", { type: "button", onClick: act(download) }, "Download the test plan"),
        h("span", { role: "status" }, state.fitting && "Fitting …"),
      ),
      h(
        "div",
        { role: "alert", key: "problems" },
        state.problems.length > 0 && refused("The tests could not be fitted.", state.problems),
      ),
      state.result && result(state.result),
    ),
  );
/** @param {Fit} r */
function result(r) {
  const download = () => save(`${r.name}.toml`, r.toml || "", "application/toml");
  const wrong = [...state.problems, ...Object.keys(state.marks)];
  const found = stands(
    standing(state.of === subject(), wrong, state.fitting),
    h(
      "section",
      { class: "card", "aria-label": "Fitted lagging" },
      h("h2", {}, words(r.sheet?.title) || r.name),
      h("p", {}, words(r.sheet?.subtitle)),
      r.lagging
        ? h(
            "p",
            { class: "bar", key: "ready" },
            h("button", { type: "button", class: "main", onClick: use }, "Apply to drive"),
            h("button", { type: "button", onClick: download }, "Download the lagging file"),
          )
        : misfit(),
      r.left_out?.length > 0 &&
        h(
          "div",
          { class: "verdict warn" },
          h("p", { class: "headline" }, "Left out"),
          list(r.left_out.map(sentence)),
        ),
    ),
    r.conditions.map(condition),
    h(
      "div",
      { class: "tables" },
      (r.sheet?.tables || []).map((/** @type {Table} */ t) => table(t)),
    ),
  );
  return h("div", { key: "result", id: "fitted" }, found);
}
/** What must be said before a law that does not describe its tests can be used. */
const misfit = () =>
  h(
    "form",
    {
      key: "misfit",
      class: "verdict warn",
      onSubmit: (/** @type {Event} */ e) => {
        e.preventDefault();
        if (state.reason.trim()) act(() => fit(state.reason.trim()))(e);
      },
    },
    h("p", { class: "headline" }, "The law does not describe its tests."),
    h(
      "p",
      {},
      "Repair, repeat or leave out the tests named below. To use the law nevertheless, ",
      "give a reason: it is saved with the lagging.",
    ),
    h(
      "p",
      { class: "bar" },
      h(
        "label",
        {},
        "Reason",
        h("input", {
          type: "text",
          size: 40,
          maxLength: 500,
          value: state.reason,
          onInput: (/** @type {any} */ e) => {
            state.reason = e.currentTarget.value;
            redraw();
          },
        }),
      ),
      h("button", { disabled: !state.reason.trim() }, "Accept the misfit"),
    ),
  );
/** @param {any} c */
const condition = (c) =>
  h(
    "section",
    { class: "card", "aria-label": `Condition ${c.condition}`, key: c.condition },
    h("h2", {}, `Condition: ${c.condition}`, c.form && h("small", { class: "help" }, ` ${c.form}`)),
    list([...(c.misfit || []), ...(c.remarks || [])], "help"),
    conditionPlots(c),
  );
