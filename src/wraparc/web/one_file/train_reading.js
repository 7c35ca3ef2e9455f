// The [train] table of a drive file and those of its load cases, as numbers.

import { si } from "../static/base/units.js";
import {
  tension_rules__behind_take_up as behindTakeUp,
  tension_rules__ends_of as endsOf,
  tension_rules__families as families,
  tension_rules__less_runs as lessRuns,
  tension_rules__overridden as overridden,
} from "../static/kernel.js";
import { inConditions, tell, whole } from "../static/pages/drive/assemble.js";
import { Reader } from "../static/pages/drive/reading.js";
import { orNull, tensionsBy } from "../static/parts/problems.js";
import * as K from "./train_kernel.js";

/** @import { Path } from "../static/types.d.ts" */
/**
 * What divides the load: parts of it, or what turns the drums.
 * @typedef {{parts?: number[], powers?: number[], speeds?: number[], absolute?: boolean,
 *   motors?: any[]}} Division
 * @typedef {{name: string, kind: string, condition: any, entry: number, exit: number,
 *   runs: number[], division: Division}} TrainCase
 */

const none = Number.NaN;
const LOADS = ["entry_tension", "exit_tension", "effective_tension", "power"];
const MODES = ["share", "speeds", "motor"];
const CASE = ["name", "description", "kind", "condition", "train"];
const OF_CASE = [...LOADS, "run", "share", "speeds"];
const KINDS = ["running", "starting", "braking"];
const DIVIDE =
  'Write share = ["50 %", "50 %"], speeds = "equal", or a [train.motor.NAME] for each pulley.';
/** How far shares may miss their sum, and powers the pull that the tensions make. */
const [SUM, POWER_SUM] = [1e-6, 5e-3];
const NOTHING = tensionsBy(() => none);
/** @param {any} v */
const isTable = (v) => typeof v === "object" && v !== null && !Array.isArray(v);

/** Reads one train. */
export class TrainReader {
  /** @param {any} doc @param {any[]} motors that the page knows @param {number} speed
   * @param {number[]} nominal @param {any} takeUp @param {string} design name of the first case */
  constructor(doc, motors, speed, nominal, takeUp, design) {
    this.doc = doc;
    this.motors = motors;
    this.speed = speed;
    this.drum = { diameter: null, speed: orNull(speed) };
    this.nominal = nominal;
    this.takeUp = takeUp;
    this.design = design;
    this.r = new Reader(doc);
    this.names = doc.pulley.map((/** @type {any} */ p) => p.name);
  }
  /** The load cases; with problems in the reader where they cannot be read. */
  cases() {
    const { r, doc } = this;
    this.shape();
    if (r.problems.length) return [];
    const { train } = doc;
    const base = this.pulls(["train"]);
    const list = doc.load_case ?? [];
    /** @type {(TrainCase | null)[]} */
    const found = [];
    if (!list.length || whole(base, this.drum) || this.powers(train))
      found.push(this.read({ name: this.design }, base, null, ["train"]));
    list.forEach((/** @type {any} */ c, /** @type {number} */ i) => {
      const at = /** @type {Path} */ (["load_case", i]);
      r.text([...at, "name"], true);
      if (!KINDS.includes(c.kind ?? "running"))
        r.wrong([...at, "kind"], `must be one of ${KINDS.join(", ")}`);
      found.push(this.read(c, base, c.train ?? {}, [...at, "train"]));
    });
    const names = found.map((c) => c?.name);
    const twice = names.find((n, i) => n !== undefined && names.indexOf(n) < i);
    if (twice !== undefined) r.wrong(["load_case"], `"${twice}" names two load cases`);
    if (r.problems.length) return [];
    return /** @type {any} */ (inConditions(/** @type {any} */ (found), doc.condition));
  }
  /** Tables and keys that are none. */
  shape() {
    const { r, doc } = this;
    /** @param {Path} at @param {any} table @param {string[]} keys */
    const known = (at, table, keys) => {
      if (table === undefined) return;
      if (!isTable(table)) return r.wrong(at, "must be a table");
      const other = Object.keys(table).find((key) => !keys.includes(key));
      if (other !== undefined) r.wrong([...at, other], "unknown key");
    };
    known(["train"], doc.train, [...OF_CASE, "diameters", "motor"]);
    if (doc.conveyor)
      r.wrong(
        ["conveyor"],
        "gives the tensions of one drive, and those of a train stand in [train]",
      );
    doc.pulley.forEach((/** @type {any} */ p, /** @type {number} */ i) => {
      const key = [...LOADS, "torque"].find((k) => p[k] !== undefined);
      if (key) r.wrong(["pulley", i, key], FOLLOW, "Leave it out.");
    });
    (doc.load_case ?? []).forEach((/** @type {any} */ c, /** @type {number} */ i) => {
      if (c?.pulley)
        r.wrong(["load_case", i, "pulley"], FOLLOW, "Write a [load_case.train] table.");
      else known(["load_case", i], c, CASE);
      known(["load_case", i, "train"], c?.train, OF_CASE);
    });
  }
  /** @param {Path} at @returns {any} */
  pulls(at) {
    return tensionsBy((key) => (LOADS.includes(key) ? this.r.number("train", [...at, key]) : none));
  }
  /** @param {any} table The pull that powers in place of shares make; 0 for none. */
  powers(table) {
    const values = (table?.share ?? []).map((/** @type {any} */ v) => si(v, "power"));
    if (!values.length || values.some(Number.isNaN) || !(this.speed > 0)) return 0;
    return K.in_page_train__total_of(values, this.speed);
  }
  /** @param {any} table @param {Path} at */
  runs(table, at) {
    const others = Object.keys(table?.run ?? {}).filter((n) => !this.names.slice(1).includes(n));
    if (others.length) {
      const first = others[0] === this.names[0];
      const there = this.names
        .slice(1)
        .map((/** @type {string} */ n) => `"${n}"`)
        .join(", ");
      this.r.wrong(
        [...at, "run", others[0]],
        first ? "the first pulley has no run before it" : `no such pulley; runs lead to ${there}`,
      );
    }
    return this.names.slice(1).map((/** @type {string} */ n) => {
      const given = table?.run?.[n];
      if (given == null) return none;
      const read = si(given, "force");
      if (!Number.isFinite(read)) this.r.wrong([...at, "run", n], "cannot be read as a force");
      return read;
    });
  }
  /** One load case. @param {any} c @param {any} base @param {any} over @param {Path} at
   * @returns {TrainCase | null} */
  read(c, base, over, at) {
    const { r, doc, drum, takeUp } = this;
    const { train } = doc;
    const before = r.problems.length;
    const own = this.runs(train, ["train"]).map(orNothing);
    const runs = over
      ? this.runs(over, at).map((/** @type {number} */ v, /** @type {number} */ i) =>
          Number.isNaN(v) ? own[i] : v,
        )
      : own;
    const division = this.division(over, at);
    const sums = {
      base: K.in_page_train__total_of(own, 1),
      case: K.in_page_train__total_of(runs, 1),
    };
    const fixed = takeUp.kind === "fixed";
    const table = over ? this.pulls(at) : null;
    let given = table ? overridden(base, table, fixed, drum, sums) : base;
    const pull = this.powers(over && "share" in over ? over : train);
    if (pull && families(given).length < 2) given = { ...given, effective_tension: pull };
    tell(r, at, given, drum, table ?? given);
    given = lessRuns(given, sums.case, drum);
    if (over && division) given = this.behind(given, base, { over, division, runs, own, sums }, at);
    if (r.problems.length > before || !division) return null;
    const { entry, exit } = endsOf(given, drum);
    const { name, kind = "running", condition } = c;
    const found = { name, kind, condition, entry, exit, runs: [...runs, 0], division };
    if (pull && K.in_page_train__miss_of(entry, exit, sums.case, pull) > POWER_SUM) {
      r.wrong(
        [...at, "share"],
        "the powers and the tensions make two pulls",
        "Leave one of them out.",
      );
      return null;
    }
    return found;
  }
  /** Tensions of a case that gives its pull alone, by a take-up between drives.
   * @param {any} given @param {any} base @param {any} of @param {Path} at */
  behind(given, base, { over, division, runs, own, sums }, at) {
    const k = this.names.slice(0, -1).indexOf(this.takeUp.after) + 1;
    const tells = ["effective_tension", "power", ...MODES, "run"].some((key) => key in over);
    if (k < 1 || over.entry_tension != null || over.exit_tension != null || !tells) return given;
    const first = this.division(null, ["train"]);
    if (!division.parts || !first?.parts) {
      this.r.wrong(
        at,
        "gives its pull alone, and how much of it the drives behind the take-up take follows " +
          "from their speeds or motors",
        `Give exit_tension too, so that the belt behind ${this.takeUp.after} keeps its tension.`,
      );
      return given;
    }
    const sum = (/** @type {number[]} */ of) => K.in_page_train__total_of(of, 1);
    /** @param {number[]} parts @param {number[]} gains */
    const part = (parts, gains) => ({
      share: sum(parts.slice(k)),
      behind: sum(gains.slice(k - 1)),
      runs: sum(gains),
    });
    const before = endsOf(lessRuns(base, sums.base, this.drum), this.drum);
    const ends = behindTakeUp(
      endsOf(given, this.drum),
      before,
      part(division.parts, runs),
      part(first.parts, own),
    );
    return ends ? { ...NOTHING, entry_tension: ends.entry, exit_tension: ends.exit } : given;
  }
  /** @param {any} over @param {Path} at @returns {Division | null} */
  division(over, at) {
    const { r, doc, names } = this;
    const own = over && MODES.some((mode) => mode in over);
    const [table, place] = own ? [over, at] : [doc.train, /** @type {Path} */ (["train"])];
    const modes = MODES.filter((mode) => mode in table);
    if (modes.length > 1) {
      r.wrong(
        place,
        `${modes.join(" and ")} each decide how the load divides`,
        "Keep one of them.",
      );
      return null;
    }
    if (modes[0] === "motor") return this.onMotors(table.motor, place);
    if (modes[0]) return this.values(modes[0], table[modes[0]], [...place, modes[0]]);
    if (doc.train.diameters) return { speeds: this.trimmed(names.map(() => 1)) };
    if (names.length === 1) return { parts: [1] };
    r.wrong(place, "nothing says how the load divides", DIVIDE);
    return null;
  }
  /** @param {number[]} trims */
  trimmed(trims) {
    return K.in_page_train__trimmed(trims, this.nominal);
  }
  /** Shares or speeds. @param {string} mode @param {any} given @param {Path} at
   * @returns {Division | null} */
  values(mode, given, at) {
    const { r, names } = this;
    if (mode === "speeds" && given === "equal") return { speeds: names.map(() => 1) };
    if (!Array.isArray(given) || given.length !== names.length) {
      r.wrong(at, `must have one value for each of the ${names.length} pulleys, in belt order`);
      return null;
    }
    const [other, words] =
      mode === "share"
        ? ["power", 'a share like 0.5 or "50 %", or a power like "300 kW"']
        : ["rotation_speed", 'a trim like "99.7 %" or a drum speed like "71.6 rpm"'];
    const plain = given.map((v) => (typeof v === "number" ? v : si(v, "number")));
    const others = given.map((v) => (typeof v === "string" ? si(v, other) : none));
    const bad = given.findIndex((_, i) => Number.isNaN(plain[i]) && Number.isNaN(others[i]));
    const off = plain.findIndex((v) => (mode === "share" ? Math.abs(v) > 100 : v <= 0 || v > 10));
    if (bad >= 0) r.wrong([...at, bad], `must be ${words}`);
    else if (off >= 0)
      r.wrong(
        [...at, off],
        mode === "share" ? "must be between -100 and 100" : "must be more than 0 and at most 10",
      );
    else if (plain.some(Number.isNaN) && !plain.every(Number.isNaN))
      r.wrong(at, "must be all of one kind");
    else return this.divided(mode, plain, others, at);
    return null;
  }
  /** @param {string} mode @param {number[]} plain @param {number[]} others @param {Path} at
   * @returns {Division | null} */
  divided(mode, plain, others, at) {
    const { r } = this;
    const shares = !Number.isNaN(plain[0]);
    if (mode === "speeds") {
      if (shares) return { speeds: this.trimmed(plain) };
      if (others.every((v) => v > 0)) return { speeds: others, absolute: true };
      r.wrong(at, "every speed must be positive");
      return null;
    }
    const total = K.in_page_train__total_of(shares ? plain : others, 1);
    if (!shares && total !== 0) return { parts: K.in_page_train__parts_of(others) };
    if (shares && Math.abs(total - 1) <= SUM) return { parts: plain };
    if (shares)
      r.wrong(
        at,
        `the shares must sum to 1 and sum to ${+total.toPrecision(6)}`,
        "Give fractions like 0.5 or 50 %.",
      );
    else r.wrong(at, "the powers sum to 0, so that there is nothing to share");
    return null;
  }
  /** Motors as the page was made with them. @param {any} tables @param {Path} at
   * @returns {Division | null} */
  onMotors(tables, at) {
    const { r, names } = this;
    const other = Object.keys(tables).find((n) => !names.includes(n));
    if (other !== undefined) r.wrong([...at, "motor", other], "no such pulley");
    const missing = names.find((/** @type {string} */ n) => !(n in tables));
    if (missing !== undefined) r.wrong([...at, "motor", missing], "missing");
    if (other !== undefined || missing !== undefined) return null;
    const motors = names.map((/** @type {string} */ n) => {
      const text = JSON.stringify(tables[n]);
      return this.motors.find((m) => JSON.stringify(m.table) === text);
    });
    const strange = motors.findIndex((/** @type {any} */ m) => !m);
    if (strange < 0) return { motors };
    r.wrong(
      [...at, "motor", names[strange]],
      "a motor that this page was not made with",
      "Make the page anew with it, `wraparc page FILE`, or solve with `wraparc solve`.",
    );
    return null;
  }
}
const FOLLOW = "the tensions of single pulleys follow from [train]";
/** @param {number} v */
const orNothing = (v) => (Number.isNaN(v) ? 0 : v);
