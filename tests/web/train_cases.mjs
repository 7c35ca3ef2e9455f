// Solves trains with the kernel of the page: cases as JSON come in, answers go out.
import { readFileSync } from "node:fs";
import { app } from "../../src/wraparc/web/static/base/design.js";
import { in_page__quick as quick } from "../../src/wraparc/web/static/kernel.js";
import * as train from "../../src/wraparc/web/one_file/train_kernel.js";

const NUMBERS = { nan: Number.NaN, inf: Infinity, "-inf": -Infinity };
const read = (text) =>
  JSON.parse(text, (_, v) => (typeof v === "string" && v in NUMBERS ? NUMBERS[v] : v));
const told = (value) =>
  JSON.stringify(value, (_, v) =>
    typeof v !== "number" || Number.isFinite(v) ? v : v > 0 ? "inf" : v < 0 ? "-inf" : "nan",
  );
const motorOf = ({ kind, ...fields }) =>
  Object.assign(Object.create(train[kind].prototype), fields);

function solved({ form, laws, given, tested, lines, ends, names, softening, pulls, nominal, ...of }) {
  app.form = form;
  const members = laws.map((law, i) => train.in_page_train__member_of(law, given[i]));
  const motors = lines.map(({ motor }) => (motor ? motorOf(motor) : null));
  const turned = lines.map(
    ({ speed, scale, master, ratio, held }, i) =>
      new train.Line(speed, held ? null : motors[i], scale, master, ratio),
  );
  const belt = train.in_page_train__belt_of(given[0], ends.entry, ends.exit);
  const system = train.in_page_train__system_of(members, turned, belt, ends.runs);
  const { speed, reference } = of;
  const found = train.in_page_train__divided(
    system, names, softening, pulls, speed, reference, belt,
  );
  const arcs = found.pairs.map(({ entry, exit }, i) =>
    quick(
      laws[i],
      { ...given[i], entry_tension: entry, exit_tension: exit, belt_speed: found.belt_speeds[i] },
      tested[i],
      180,
    ),
  );
  if (!arcs.every((arc) => arc)) return { status: "left to the program", pairs: found.pairs };
  const { status, reason, ...rest } = train.in_page_train__told(
    system, names, found, arcs, nominal, motors,
  );
  return { status, reason, pairs: found.pairs, ...rest };
}
process.stdout.write(told(read(readFileSync(0, "utf-8")).map(solved)));
