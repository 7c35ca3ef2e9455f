// A drive told by its conveyor or by where its pulleys stand, as one that gives tensions and wrap.
import { get } from "../static/base/design.js";
import { si } from "../static/base/units.js";
import { assemble, beyond, NOT_HERE } from "../static/pages/drive/assemble.js";
import { Reader } from "../static/pages/drive/reading.js";
import { section } from "../static/parts/field.js";
import { TENSIONS } from "../static/parts/problems.js";
import * as K from "./train_kernel.js";

/** @import { Book, Design, Path, Problem } from "../static/types.d.ts" */

const LEAVE = "Leave it out, or the [conveyor] table.";
const TURNS = ["clockwise", "counterclockwise"];
const POINT = ["x", "y", "diameter", "turn"];
const FURTHEST = 1e5;
/** @param {any} v */
const isTable = (v) => typeof v === "object" && v !== null && !Array.isArray(v);

/**
 * The same drive with tensions and wrap angles in its file.
 * @param {any} doc @returns {{doc: any, problems: Problem[], held: number}} with what the take-up
 *   of its conveyor holds, nan without one
 */
export function plainDrive(doc) {
  const r = new Reader(doc);
  const pulley = doc.pulley.map((/** @type {any} */ p, /** @type {number} */ i) => {
    if (!p.belt_path) return p;
    const { belt_path: _, ...rest } = p;
    return { ...rest, wrap_angle: `${wrapOf(r, i)} rad` };
  });
  const turned = { ...doc, pulley };
  const one = doc.conveyor && !doc.train && doc.pulley.length === 1;
  const [found, held] = one ? fromConveyor(r, turned) : [turned, Number.NaN];
  return { doc: found, problems: r.problems, held };
}
/** As `assemble`, of any drive of one pulley. @param {Design} design @param {Book} book */
export function assembled(design, book) {
  const { doc, problems, held } = plainDrive(design);
  if (problems.length && !beyond(doc)) return { judging: null, problems };
  const found = assemble(doc, book);
  // what a take-up holds follows from the conveyor in every load case
  if (found.judging && !Number.isNaN(held))
    Object.assign(found.judging, { take_up: false, held_at: held });
  return found;
}

/** Wrap angle of a pulley from its belt path; nan where that cannot be read.
 * @param {Reader} r @param {number} i */
function wrapOf(r, i) {
  const { diameter, wrap_angle, belt_path: path } = r.doc.pulley[i];
  const at = /** @type {Path} */ (["pulley", i, "belt_path"]);
  if (!isTable(path)) return r.wrong(at, "must be a table");
  if (wrap_angle != null)
    r.wrong(["pulley", i, "wrap_angle"], "belt_path gives it already", "Leave one of them out.");
  const own = r.number("pulley", ["pulley", i, "diameter"]);
  const before = r.problems.length;
  const point = pointOf(
    r,
    at,
    { ...path, diameter },
    [...POINT.filter((k) => k !== "diameter"), "before", "after"],
    own,
  );
  const ends = ["before", "after"].map((key) => {
    const place = [...at, key];
    if (isTable(path[key])) return pointOf(r, place, path[key], POINT);
    r.wrong(place, path[key] == null ? "missing" : "must be a table");
    return point;
  });
  if (r.problems.length > before) return Number.NaN;
  const overlaps = K.belt_path__overlaps(ends[0], point, ends[1]);
  for (const p of overlaps) r.wrong([...at, p.key], p.message, p.remedy);
  return overlaps.length ? Number.NaN : K.belt_path__turned_by(ends[0], point, ends[1]);
}
/** @param {Reader} r @param {Path} at @param {any} table @param {string[]} keys
 * @param {number} [diameter] */
function pointOf(r, at, table, keys, diameter) {
  const allowed = diameter === undefined ? keys : [...keys, "diameter"];
  const other = Object.keys(table).find((key) => !allowed.includes(key));
  if (other !== undefined) r.wrong([...at, other], "unknown key");
  const [x, y] = ["x", "y"].map((key) => lengthAt(r, [...at, key], -FURTHEST, FURTHEST, true));
  const size = diameter ?? lengthAt(r, [...at, "diameter"], 0, 1e3, false);
  const turn = table.turn ?? TURNS[0];
  if (!TURNS.includes(turn)) r.wrong([...at, "turn"], `must be one of ${TURNS.join(", ")}`);
  return new K.Point(x, y, Number.isNaN(size) ? 0 : size, turn);
}

/** A length that has no field. @param {Reader} r @param {Path} path @param {number} least
 * @param {number} most @param {boolean} needed */
function lengthAt(r, path, least, most, needed) {
  const value = get(r.doc, path);
  if (value == null) return needed ? r.wrong(path, "missing") : Number.NaN;
  const read = si(value, "length");
  const allowed = `must be a length between ${least} m and ${most} m`;
  return read >= least && read <= most ? read : r.wrong(path, allowed);
}
/** A drive with the load cases of its conveyor, and what its take-up holds.
 * @param {Reader} r @param {any} doc @returns {[any, number]} */
function fromConveyor(r, doc) {
  const { conveyor: table, take_up: takeUp, load_case: cases, ...rest } = doc;
  const [pulley] = doc.pulley;
  const told = TENSIONS.find((key) => pulley[key] != null);
  if (told) r.wrong(["pulley", 0, told], "the [conveyor] table gives the tensions already", LEAVE);
  if (cases) r.wrong(["load_case"], "the [conveyor] table gives the load cases already", LEAVE);
  if (takeUp?.kind === "fixed")
    r.wrong(
      ["take_up", "kind"],
      "a fixed take-up holds another tension in every load case, and [conveyor] has one",
      "Give the tensions of each load case instead of [conveyor].",
    );
  if (takeUp?.after)
    r.wrong(
      ["take_up", "after"],
      "the [conveyor] table says where its take-up stands, take_up_distance",
      "Leave it out.",
    );
  const { found: states, held } = statesOf(r, table);
  if (r.problems.length) return [rest, Number.NaN]; // what is wrong with it is told, and no more of it
  const given = states.map((s) => ({
    name: s.name,
    kind: s.kind,
    pulley: { [pulley.name]: { entry_tension: `${s.entry} N`, exit_tension: `${s.exit} N` } },
  }));
  return [{ ...rest, ...(takeUp && { take_up: takeUp }), load_case: given }, held];
}
/** @param {Reader} r @param {any} table @returns {{found: any[], held: number}} */
function statesOf(r, table) {
  const none = { found: [], held: Number.NaN };
  if (!isTable(table)) {
    r.wrong(["conveyor"], "must be a table");
    return none;
  }
  const keys = section("conveyor").map((s) => s.key);
  const other = Object.keys(table).find((key) => !keys.includes(key));
  if (other !== undefined) r.wrong(["conveyor", other], "unknown key");
  const numbers = {
    ...Object.fromEntries(
      keys.filter((k) => k !== "drive_at").map((k) => [k, r.number("conveyor", ["conveyor", k])]),
    ),
    speed: r.number("belt", ["belt", "speed"]),
    sheave_ratio: r.number("take_up", ["take_up", "sheave_ratio"]),
  };
  const known = Object.fromEntries(Object.entries(numbers).filter(([, v]) => !Number.isNaN(v)));
  const drive = r.choice("conveyor", ["conveyor", "drive_at"]);
  const tell = (/** @type {any[]} */ of) => {
    for (const p of of) r.wrong(["conveyor", p.key], p.message, p.remedy);
    return of.length > 0;
  };
  if (tell(K.conveyor__choices(Object.keys(known))) || r.problems.length) return none;
  const made = new /** @type {any} */ (K.Conveyor)();
  const of = Object.assign(made, known, drive && { drive_at: drive });
  if (tell(K.in_page_conveyor__misfits(of))) return none;
  const odd = K.in_page_conveyor__unusual(of, r.number("belt", ["belt", "width"]));
  if (odd) {
    r.wrong(["conveyor", odd], NOT_HERE[3]);
    r.problems[r.problems.length - 1].beyond = true;
    return none;
  }
  const found = K.in_page_conveyor__states(of);
  tell(K.in_page_conveyor__unfit(of, found));
  return { found, held: of.take_up };
}
