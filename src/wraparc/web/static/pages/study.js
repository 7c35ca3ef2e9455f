// Studies: many variants of the drive, started, followed, ended, looked at.
import { app, redraw } from "../base/design.js";
import { saveFrom } from "../base/save.js";
import { act, ask, complain, onReturn, refusal, sentence } from "../base/server.js";
import { words } from "../base/units.js";
import { list, standing } from "../parts/answers.js";
import { Picture } from "../parts/picture.js";
import { judgedIf, refused, stands, table, verdict } from "../parts/tables.js";
import { h } from "../vendor/preact.js";
import { form } from "./study/form.js";
import { asFile, freshPlan } from "./study/plan.js";
import { Spreads } from "./study/spread.js";

export { openStudy } from "./study/plan.js";

/** @import { Problem } from "../types.d.ts" */
/** @typedef {{id: string, title: string, state: string, done: number, total: number, message: any,
 *   problems: Problem[], [key: string]: any}} Job */

const state = {
  problems: /** @type {Problem[]} */ ([]),
  jobs: /** @type {Job[]} */ ([]),
  /** Answers of the studies that are unfolded; true while they are awaited. */
  opened: /** @type {Record<string, any>} */ ({}),
  timer: 0,
};

let visited = false;
export function update() {
  freshPlan();
  if (!visited) follow();
  visited = true;
}
onReturn(() => visited && follow());
async function begin() {
  state.problems = [];
  try {
    const job = await ask("studies", { study: asFile(), document: app.doc });
    state.opened[job.id] = true;
    await follow();
  } catch (x) {
    state.problems = refusal(x);
  }
  redraw();
}
let asked = 0;
/** Look after the jobs as long as one of them is at work and the page is open. */
async function follow() {
  const turn = ++asked;
  clearTimeout(state.timer);
  try {
    const { jobs } = await ask("studies");
    if (turn !== asked) return; // an older list would take a study away that was just begun
    state.jobs = jobs;
    for (const j of state.jobs)
      if (state.opened[j.id] === true && j.state === "done")
        state.opened[j.id] = await ask(`studies/${j.id}`);
  } catch (x) {
    if (!app.gone) complain(x);
    return;
  }
  redraw();
  if (state.jobs.some(busy)) state.timer = setTimeout(() => app.page === "study" && follow(), 400);
  else visited = app.page === "study";
}
/** @param {Job} j */
const busy = (j) => j.state === "queued" || j.state === "running";

export const Page = () => [
  h(
    "p",
    { class: "help", key: "help" },
    "Many variants of the drive of the first page. What runs here goes on when the page is closed.",
  ),
  h(
    "form",
    { class: "card", "aria-label": "Study", onSubmit: (e) => e.preventDefault(), key: "form" },
    form(begin),
  ),
  h(
    "div",
    { role: "alert", key: "problems" },
    state.problems.length > 0 && refused("The study cannot be run.", state.problems),
  ),
  h("div", { key: "jobs", id: "jobs", tabIndex: -1 }, state.jobs.map(job)),
];
/** @type {Record<string, string>} */
const STATES = { queued: "waiting" };
/** @param {Job} j */
function job(j) {
  const at = busy(j);
  const answer = state.opened[j.id];
  const end = async () => {
    if (!at && !confirm(`Delete “${j.title || "Study"}” with its results? This cannot be undone.`))
      return;
    await ask(`studies/${j.id}`, undefined, { method: "DELETE" });
    if (!at) delete state.opened[j.id];
    await follow();
    if (!at) document.getElementById("jobs")?.focus();
  };
  const unfold = async () => {
    state.opened[j.id] = answer ? null : await ask(`studies/${j.id}`);
    redraw();
  };
  const message = j.message ? ` ${words(j.message)}` : "";
  const count = at && j.total ? `${j.done} of ${j.total} designs` : "";
  return h(
    "section",
    {
      class: "card job",
      "aria-label": j.title || `Study ${j.id}`,
      "data-state": j.state,
      key: j.id,
    },
    h("h2", {}, j.title || "Study", " ", h("span", { class: "mark" }, STATES[j.state] || j.state)),
    h(
      "div",
      { class: "inline" },
      at &&
        h("progress", {
          max: j.total || 1,
          value: j.done || 0,
          "aria-label": "Progress",
          key: "bar",
        }),
      h("span", { role: at ? "status" : undefined, key: "said" }, count, message),
      h("button", { type: "button", onClick: act(end), key: "end" }, at ? "Cancel" : "Delete"),
      j.state === "done" &&
        h(
          "button",
          { type: "button", "aria-expanded": Boolean(answer), onClick: act(unfold), key: "show" },
          answer ? "Hide" : "Show",
        ),
    ),
    (j.problems || []).length > 0 && list(j.problems.map(sentence), "error"),
    answer && typeof answer === "object" && result(j, answer),
  );
}
/** What a study is of. @param {any} study @param {any} document */
const subject = (study, document) => JSON.stringify([study, document]);
/** @param {Job} j @param {any} full */
function result(j, full) {
  const download = (/** @type {string} */ name) =>
    act(async () => {
      const { href } = await ask(`studies/${j.id}/files/${name}/link`, {});
      saveFrom(href, name);
    });
  const picture = (/** @type {string} */ name) => {
    const what = name.replace(/\.\w+$/, "").replace(/[-_]/g, " ");
    const alt = `${what} of ${j.title || "the study"}; its numbers are in the tables`;
    return h(Picture, { path: `studies/${j.id}/pictures/${name}`, alt, key: name });
  };
  const now = subject(full.study, full.document) === subject(asFile(), app.doc);
  const how = standing(now, state.problems, false);
  return stands(
    how,
    full.verdict && verdict(judgedIf(how, full.verdict)),
    full.spreads?.length > 0 && h(Spreads, { spreads: full.spreads, key: "spreads" }),
    list(full.remarks, "help"),
    h(
      "div",
      { class: "tables one", key: "tables" },
      (full.tables || []).map((/** @type {any} */ t) => table(t)),
    ),
    h(
      "p",
      { class: "inline", key: "files" },
      (full.files || []).map((/** @type {string} */ n) =>
        h("button", { type: "button", onClick: download(n), key: n }, `Download ${n}`),
      ),
    ),
    h("div", { class: "pictures", key: "pictures" }, (full.pictures || []).map(picture)),
  );
}
