// Drives in time: an event is followed, then played; whether the drives pulsate, and what cures it.
import { app, redraw } from "../base/design.js";
import { act, ask, complain, onReturn, refusal } from "../base/server.js";
import { words } from "../base/units.js";
import { list, standing } from "../parts/answers.js";
import { Box } from "../parts/box.js";
import { choose } from "../parts/choose.js";
import { checked, framed, marked, notComputed, renewed, saying, silent } from "../parts/framed.js";
import { more } from "../parts/field.js";
import { Picture } from "../parts/picture.js";
import { mark } from "../parts/problems.js";
import { judgedIf, refused, stands, table, verdict } from "../parts/tables.js";
import { h } from "../vendor/preact.js";
import { answer, known } from "./drive/solving.js";
import { assumed, events, motionInputs } from "./events/inputs.js";
import { Player } from "./events/player.js";
import { steady } from "./events/steady.js";

/** @import { Refused } from "../parts/framed.js" */
/** @import { Bar, Design, Problem, Table } from "../types.d.ts" */
/** @typedef {"run" | "stability" | "map"} What */
/** @typedef {{id: string, state: string, done: number, total: number, message: string,
 *   problems: Problem[], what: What, of: Design, by: string, [key: string]: any}} Job */

const plan = { event: "", points: "60", step: "", over: "droop" };
const state = {
  problems: /** @type {Refused} */ ([]),
  jobs: /** @type {Record<What, Job | null>} */ ({ run: null, stability: null, map: null }),
  opened: -1,
  timer: 0,
  /** The last run that came to its end. */
  done: /** @type {Job | null} */ (null),
};
export function update() {
  const names = events().map(([n]) => n);
  if (!names.includes(plan.event)) plan.event = names[0] || "";
  const jobs = { run: null, stability: null, map: null };
  renewed(state, { problems: [], jobs, done: null });
}
onReturn(() => void follow());

/** @param {What} what */
async function begin(what) {
  state.problems = [];
  const old = state.jobs[what];
  const { event, points, step, over } = plan;
  const question = { document: app.doc, what, event, points: +points, step: step || null, over };
  const known = { what, of: app.doc, by: asked(what) };
  try {
    const job = await ask("events", question);
    state.jobs[what] = { ...job, ...known };
    mark([]);
  } catch (x) {
    state.problems = marked(refusal(x));
  }
  if (old) await forget(old);
  await follow();
}
/** What is not shown any more need not be kept. @param {Job} job */
async function forget(job) {
  if (!busy(job)) await ask(`events/${job.id}`, undefined, { method: "DELETE" }).catch(() => {});
}
/** Look after the jobs as long as one of them is at work and the page is open. */
async function follow() {
  clearTimeout(state.timer);
  try {
    for (const [what, job] of Object.entries(state.jobs))
      if (job && busy(job)) {
        const found = {
          ...(await ask(`events/${job.id}`)),
          what: job.what,
          of: job.of,
          by: job.by,
        };
        if (state.jobs[/** @type {What} */ (what)] !== job) continue;
        state.jobs[/** @type {What} */ (what)] = found;
        if (found.what === "run" && found.state === "done") state.done = found;
      }
  } catch (x) {
    if (!app.gone) complain(x);
    return;
  }
  redraw();
  if (Object.values(state.jobs).some((j) => j && busy(j))) state.timer = setTimeout(follow, 300);
}
/** @param {Job} j */
const busy = (j) => j.state === "queued" || j.state === "running";

export const Page = () => {
  const run = state.done;
  const still = run || steady();
  return framed(
    {
      of: "events",
      how: run ? now(run) : still && !known() ? standing(false, answer.problems) : undefined,
      form: h(
        "form",
        {
          class: "inputs rail card",
          "aria-label": "In time",
          onSubmit: (/** @type {Event} */ e) => e.preventDefault(),
        },
        asking(),
        motionInputs(),
      ),
      say: says(run),
      hero: still && h(Player, { run: still.played, rating: ratingOf(run), key: still.id }),
      drawing: intro(),
      tall: Boolean(run),
      side: checked("events", run?.bars),
    },
    run && result(run),
    pictures(),
  );
};
/** The tension [N] that a belt may have for a moment; 0 where none is known.
 * @param {Job | null} run */
function ratingOf(run) {
  const found = run?.bars?.find((/** @type {Bar} */ b) => b.name === "momentary_tension");
  return found?.share ? found.value / found.share : 0;
}
const again = () => {
  const job = state.jobs.run;
  return h(
    "button",
    {
      ...{ type: "button", class: "main advice", id: "follow" },
      disabled: Boolean(job && busy(job)),
      onClick: act(() => begin("run")),
    },
    state.done ? "Run again" : "Run it",
  );
};
/** One sentence on the run, and what to do: it is never judged by a design before.
 * @param {Job | null} run */
function says(run) {
  const job = state.jobs.run;
  if (job && busy(job)) return silent(`Following ${job.title} …`, progress(job), cancelling(job));
  if (job?.state === "failed") return notComputed("Not followed.", job.problems, again());
  if (state.problems.length) return notComputed("Not followed.", state.problems, again());
  if (job?.state === "cancelled") return silent("Cancelled.", "", again());
  if (!run) return silent(`Event ${plan.event}: not run yet.`, "", again());
  if (now(run) === "fresh") return saying("fresh", run.run.verdict);
  const changed = run.of !== app.doc ? "The design changed." : "Another event is selected.";
  return silent(changed, "Previous run.", again());
}
const intro = () =>
  h(
    "p",
    { class: "help intro", key: "intro" },
    "The drive appears here once it is solved, and plays once an event has run.",
  );
/** What is run. */
function asking() {
  const put = (/** @type {"event" | "points" | "step"} */ key) => (/** @type {string} */ v) => {
    plan[key] = v;
    redraw();
  };
  /** @type {[string, string][]} */
  const finer = [
    ["30", "quick"],
    ["60", "usual"],
    ["120", "fine"],
  ];
  const row = (/** @type {string} */ id, /** @type {string} */ title, /** @type {any} */ box) =>
    h(
      "div",
      { class: "field wide", key: id },
      h("label", { for: id }, title),
      h("span", {}),
      h("span", { class: "box" }, box),
    );
  return h(
    "fieldset",
    { key: "asking" },
    h("legend", {}, "What happens"),
    row("e-event", "Event", choose(plan.event, events(), put("event"), "e-event")),
    more(
      "More: accuracy, step",
      [
        row("e-points", "Accuracy", choose(plan.points, finer, put("points"), "e-points")),
        row(
          "e-step",
          "Time step",
          h(Box, {
            id: "e-step",
            value: plan.step,
            placeholder: "chosen",
            autocomplete: "off",
            put: put("step"),
          }),
        ),
      ],
      false,
      "finer",
    ),
    assumed() &&
      h(
        "p",
        { class: "help", key: "assumed" },
        "The design has no events: the usual ones are offered, with ramps of 20 s up and 15 s ",
        "down. Write [[motion.event]] tables in its file for others.",
      ),
  );
}
/** @param {Job} job */
const progress = (job) =>
  h(
    "span",
    { class: "inline" },
    h("progress", { max: job.total || 1, value: job.done || 0, "aria-label": "Progress" }),
    job.state === "queued" ? "waiting for another run" : words(job.message),
  );
/** @param {Job} job */
const cancelling = (job) =>
  h(
    "button",
    {
      type: "button",
      class: "advice",
      onClick: act(async () => {
        await ask(`events/${job.id}`, undefined, { method: "DELETE" });
        await follow();
      }),
    },
    "Cancel",
  );
/** How the job of a picture stands while it is at work, and how it ended if not well.
 * @param {What} what @param {string} title */
function atWork(what, title) {
  const job = state.jobs[what];
  if (!job || job.state === "done") return null;
  if (job.state === "failed")
    return h("div", { role: "alert", key: `failed ${what}` }, refused("", job.problems));
  if (job.state === "cancelled")
    return h("p", { class: "verdict", role: "status", key: `stopped ${what}` }, "Cancelled.");
  return h(
    "section",
    { class: "card job", "aria-label": title, "data-state": job.state, key: `at ${what}` },
    h("h2", {}, title),
    h("div", { class: "inline", role: "status" }, progress(job), cancelling(job)),
  );
}
/** @param {Job} job */
const result = (job) => stands(now(job), ...told(job));
/** What is asked of the design. @param {What} what */
const asked = (what) =>
  ({
    run: [plan.event, plan.points, plan.step],
    stability: [],
    map: [plan.over],
  })[what].join();
/** @param {Job} job */
const now = (job) =>
  standing(job.of === app.doc && job.by === asked(job.what), state.problems, false);
/** @param {Job} job */
const told = (job) => [
  h("h2", { key: "asked" }, `${job.title}: does the drive pass?`),
  h("div", { key: "run" }, verdict(judgedIf(now(job), job.run.verdict))),
  h("h2", { key: "pulsates" }, "Is the drive stable?"),
  h("div", { key: "stability" }, verdict(judgedIf(now(job), job.stability.verdict))),
  job.note && h("p", { class: "help", key: "note" }, job.note),
  h(
    "div",
    { class: "tables one", key: "tables" },
    [...job.run.tables, ...job.stability.tables].map((/** @type {Table} */ t, i) =>
      table({ ...t, key: `e${i}` }),
    ),
  ),
  list([...new Set([...job.run.remarks, ...job.stability.remarks].map(words))], "help"),
  sources(job.run.table_sources),
];
/** @param {string[]} texts */
const sources = (texts) =>
  texts.length > 0 && h("p", { class: "help", key: "sources" }, `Source: ${texts.join("; ")}.`);

function pictures() {
  /** @type {[string, string][]} */
  const overs = [
    ["droop", "droop and inertia"],
    ["coupling slip", "coupling slip and inertia"],
  ];
  const put = (/** @type {string} */ v) => {
    plan.over = v;
    redraw();
  };
  const draw = (/** @type {What} */ what) => ({
    type: /** @type {const} */ ("button"),
    disabled: Boolean(state.jobs[what] && busy(/** @type {Job} */ (state.jobs[what]))),
    onClick: act(() => begin(what)),
  });
  return h(
    "section",
    { class: "card", "aria-label": "Small vibrations", key: "pictures" },
    h("h2", {}, "Small vibrations"),
    h(
      "div",
      { class: "bar" },
      h("button", draw("stability"), "Plot Te against run-out (Bode)"),
      h("label", {}, "Map over", choose(plan.over, overs, put, "e-over")),
      h("button", draw("map"), "Plot the stability map"),
    ),
    atWork("stability", "Looking for vibrations"),
    drawn("stability", "Response of Te and creep to run-out, by frequency"),
    atWork("map", "Looking for vibrations over the map"),
    drawn("map", "Where the drives oscillate by themselves"),
  );
}
/** @param {What} what @param {string} alt */
function drawn(what, alt) {
  const job = state.jobs[what];
  if (job?.state !== "done") return null;
  const path = `events/${job.id}/pictures/${job.pictures[0]}`;
  const found = stands(
    now(job),
    what === "stability" && verdict(judgedIf(now(job), job.stability.verdict)),
    h(Picture, { path, alt: `${alt}; the tables say it in numbers`, key: job.id }),
  );
  return h("figure", { key: `drawn ${what}` }, found);
}
