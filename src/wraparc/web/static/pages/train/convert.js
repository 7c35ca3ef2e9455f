// One drive to several and back: what is said of the load moves along.
import { besides, rowsOf, set } from "../../base/design.js";
import { si, written } from "../../base/units.js";

/** @import { Design, FullArc, Pulley } from "../../types.d.ts" */

/** What the load of a train is given by; of one pulley too, with the torque on it. */
export const LOADS = ["entry_tension", "exit_tension", "effective_tension", "power"];
const TENSIONS = [...LOADS, "torque"];
const ORDINALS = ["second", "third", "fourth", "fifth"];
const DIGITS = 9;

/** @param {any} table @param {string[]} keys */
const only = (table, keys) =>
  Object.fromEntries(keys.filter((k) => table?.[k] != null).map((k) => [k, table[k]]));
/** @param {any} table @param {string[]} keys */
const without = (table, keys) =>
  Object.fromEntries(Object.entries(table ?? {}).filter(([k]) => !keys.includes(k)));
/** Equal shares that add up to the whole. @param {number} n */
export function shares(n) {
  const each = Math.floor(10000 / n) / 100;
  return Array.from({ length: n }, (_, i) => `${i ? each : +(100 - each * (n - 1)).toFixed(2)} %`);
}
/** @param {Design} doc */
function nextName(doc) {
  const names = doc.pulley.map((p) => p.name);
  return ORDINALS.find((x) => !names.includes(x)) || `drive ${names.length + 1}`;
}
/** Layers of a belt, with which a torque makes less pull than over the radius alone. */
const LAYERS = ["pulley_cover", "carry_cover", "thickness"];
/** Whether a torque is known as a pull. @param {Design} doc */
const turns = (doc) =>
  si(doc.pulley[0].diameter, "length") > 0 && !LAYERS.some((key) => doc.belt[key] != null);
/** Keys that a drive more or less moves elsewhere in the design. @param {Design} doc */
export const movedKeys = (doc) => (turns(doc) ? TENSIONS : LOADS);
/** A table of tensions of one pulley as one of a train: a torque as the pull that it makes.
 * @param {Design} doc @param {any} table @returns {any} */
function ofTrain(doc, table) {
  const found = only(table, LOADS);
  if (!turns(doc)) return found;
  const pull = (2 * si(table?.torque, "torque")) / si(doc.pulley[0].diameter, "length");
  return Number.isFinite(pull) && found.effective_tension == null
    ? { ...found, effective_tension: written(pull, "force", DIGITS) }
    : found;
}
const KINDS = /** @type {Record<string, string>} */ ({ start: "starting", stop: "braking" });
/** The first condition behind the names of load cases, if there are several. @param {Design} doc */
const besideOf = (doc) => besides(doc).map((c) => `, ${c.name ?? c}`)[0] ?? "";
/** @param {Design} doc @param {FullArc} arc */
const caseOf = (doc, { load_case: name }) => {
  const first = besideOf(doc);
  return first && name.endsWith(first) ? name.slice(0, -first.length) : name;
};
/** The load cases that a conveyor gives, with the tensions that were found of them.
 * @param {Design} doc @param {FullArc[]} arcs @returns {[any, any][]} each with its tensions */
export function conveyorCases(doc, arcs) {
  const first = besideOf(doc);
  const here = arcs.filter((a) => !first || a.load_case.endsWith(first));
  const given = rowsOf(doc.conveyor?.load_case);
  return here.map((arc) => {
    const own = caseOf(doc, arc);
    const said = given.find((c) => c?.name === own)?.kind ?? KINDS[own];
    const kind = said && said !== "running" && { kind: said };
    const n = arc.numbers;
    const ends = ["entry_tension", "exit_tension"].map((key) => [
      key,
      written(n[key] ?? Number.NaN, "force", DIGITS),
    ]);
    return [{ name: own, ...kind }, Object.fromEntries(ends)];
  });
}

/** The same of several drives: tensions at both ends, runs between, shares where shares are given.
 * @param {Design} doc @param {FullArc[]} arcs @returns {any[]} */
export function conveyorTrains(doc, arcs) {
  const names = doc.pulley.map((p) => p.name ?? "");
  /** @param {FullArc | undefined} arc @param {"entry_tension" | "exit_tension"} key */
  const end = (arc, key) => arc?.numbers[key] ?? Number.NaN;
  const force = (/** @type {number} */ v) => written(v, "force", DIGITS);
  return conveyorCases(
    doc,
    arcs.filter((a) => a.pulley === names[0]),
  ).map(([of, ends]) => {
    const here = names.map((n) => arcs.find((a) => a.pulley === n && caseOf(doc, a) === of.name));
    const pulls = here.map((a) => end(a, "entry_tension") - end(a, "exit_tension"));
    const all = pulls.reduce((sum, of) => sum + of, 0);
    const run = names
      .map((n, i) => [n, i ? end(here[i], "entry_tension") - end(here[i - 1], "exit_tension") : 0])
      .filter(([, v]) => v)
      .map(([n, v]) => [n, force(/** @type {number} */ (v))]);
    const train = {
      entry_tension: ends.entry_tension,
      exit_tension: force(end(here[here.length - 1], "exit_tension")),
      ...(run.length && { run: Object.fromEntries(run) }),
      ...(doc.train?.share && {
        share: pulls.map((of) => `${+((100 * of) / all).toPrecision(9)} %`),
      }),
    };
    return { ...of, train };
  });
}
/** A drive with one more behind the others, which is given no load but a first second one.
 * @param {Design} doc @param {FullArc[]} arcs of the drive as a whole, as far as they are known
 * @returns {Design} */
export function withDrive(doc, arcs) {
  const name = nextName(doc);
  const last = doc.pulley[doc.pulley.length - 1];
  const more = { ...without(last, TENSIONS), name };
  if (doc.train) return ofTrainWith(doc, more);
  if (doc.pulley.length > 1) return { ...doc, pulley: [...doc.pulley, ...idleBehind(doc, more)] };
  const { conveyor, load_case, ...rest } = doc;
  const pulley = /** @type {Pulley[]} */ ([without(last, TENSIONS), more]);
  const train = { ...ofTrain(doc, last), share: shares(2) };
  if (conveyor) {
    const found = conveyorCases(doc, arcs).map(([of, ends]) => ({ ...of, train: ends }));
    return { ...rest, pulley, ...(found.length && { load_case: found }), train };
  }
  const cases = load_case?.map((/** @type {any} */ c) => {
    const { pulley: of, ...own } = c;
    return { ...own, train: ofTrain(doc, of?.[last.name ?? ""]) };
  });
  return { ...rest, pulley, ...(cases && { load_case: cases }), train };
}
/** @param {Design} doc @param {any} more @returns {Design} */
function ofTrainWith(doc, more) {
  const add = (/** @type {any} */ t) => ({
    ...t,
    ...(Array.isArray(t.share) && { share: [...t.share, "0 %"] }),
    ...(Array.isArray(t.speeds) && { speeds: [...t.speeds, "100 %"] }),
    ...(Array.isArray(t.diameters) && { diameters: [...t.diameters, more.diameter] }),
  });
  const next = withTrains({ ...doc, pulley: [...doc.pulley, more] }, add);
  const places = rowsOf(doc.conveyor?.drive);
  const last = places[places.length - 1]; // the new one is where the last is, and brakes nothing
  const place = {
    ...last,
    pulley: more.name,
    ...(last?.brake_share != null && { brake_share: 0 }),
  };
  return places.length ? set(next, ["conveyor", "drive"], [...places, place]) : next;
}
/** A document with the tables of its train changed, of load cases too.
 * @param {Design} doc @param {(train: any) => any} f @returns {Design} */
function withTrains(doc, f) {
  const cases = doc.load_case?.map((/** @type {any} */ c) =>
    c.train ? { ...c, train: f(c.train) } : c,
  );
  return { ...doc, ...(doc.train && { train: f(doc.train) }), ...(cases && { load_case: cases }) };
}
/** A pulley that idles behind those that each give their tensions.
 * @param {Design} doc @param {any} more */
function idleBehind({ pulley }, more) {
  const { exit_tension: behind } = pulley[pulley.length - 1];
  return [behind == null ? more : { ...more, entry_tension: behind, exit_tension: behind }];
}

/** A drive without one of its pulleys. @param {Design} doc @param {number} i @returns {Design} */
export function withoutDrive(doc, i) {
  const pulley = doc.pulley.filter((_, k) => k !== i);
  const { name = "" } = doc.pulley[i];
  let next = /** @type {Design} */ ({ ...doc, pulley });
  const { drum } = doc.motion ?? {};
  if (drum?.[name]) next = set(next, ["motion", "drum"], without(drum, [name]));
  if (doc.take_up?.after === name) next = set(next, ["take_up", "after"], undefined);
  if (doc.conveyor?.drive) {
    const places = placesWithout(rowsOf(doc.conveyor.drive), name);
    next = set(next, ["conveyor", "drive"], places.length ? places : undefined);
  }
  if (!doc.train) {
    const cases = doc.load_case?.map((/** @type {any} */ c) =>
      c.pulley ? { ...c, pulley: without(c.pulley, [name]) } : c,
    );
    return { ...next, ...(cases && { load_case: cases }) };
  }
  if (pulley.length > 1) return withTrains(next, (t) => withoutOne(t, doc, i));
  const [single] = pulley;
  const { train, load_case, ...rest } = next;
  const cases = load_case?.map((/** @type {any} */ c) => {
    const { train: of, ...own } = c;
    return { ...own, pulley: { [single.name ?? ""]: only(of, LOADS) } };
  });
  const alone = { ...single, ...only(train, LOADS) };
  return /** @type {Design} */ ({
    ...rest,
    pulley: [alone],
    ...(cases && { load_case: cases }),
  });
}
/** Places of drives without one; who brakes must be said anew where that one did.
 * @param {any[]} places @param {string} name */
function placesWithout(places, name) {
  const left = places.filter((d) => d?.pulley !== name);
  const braked = places.some((d) => d?.pulley === name && Number.parseFloat(d.brake_share) > 0);
  return braked ? left.map((d) => without(d, ["brake_share"])) : left;
}
/** A table of a train without what is of one drive; the shares of the others keep their ratios.
 * @param {any} table @param {Design} doc @param {number} i @returns {any} */
function withoutOne(table, doc, i) {
  const names = doc.pulley.map((p) => p.name ?? "");
  const first = i === 0 ? [names[1]] : []; // no run leads to the first drive
  const next = { ...table };
  for (const key of ["share", "speeds", "diameters"])
    if (Array.isArray(table[key]))
      next[key] = table[key].filter((/** @type {any} */ _, /** @type {number} */ k) => k !== i);
  if (Array.isArray(table.share)) next.share = asBefore(table.share, next.share);
  for (const key of ["run", "motor"])
    if (table[key]) next[key] = without(table[key], [names[i], ...(key === "run" ? first : [])]);
  return next;
}
/** Shares that add up to what all did, where they are parts of the load.
 * @param {any[]} all @param {any[]} left */
function asBefore(all, left) {
  const parts = (/** @type {any[]} */ of) => of.map((v) => si(v, "number"));
  const sum = (/** @type {number[]} */ of) => of.reduce((a, b) => a + b, 0);
  const [whole, rest] = [sum(parts(all)), sum(parts(left))];
  if (!(Math.abs(rest) > 0) || Math.abs(whole - rest) < 1e-9) return left;
  const scaled = parts(left).map((v) => +((100 * v * whole) / rest).toFixed(2));
  scaled[0] = +(100 * whole - sum(scaled.slice(1))).toFixed(2);
  return scaled.map((v) => `${v} %`);
}
