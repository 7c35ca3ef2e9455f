// @ts-nocheck
// Made from the Python source by `make kernel`: change that, not this.
import {
  Ends,
  Guess,
  answer__operating_point,
  capacity__stress_about,
  collocation__compliance_of,
  collocation__converged,
  collocation__first_course,
  collocation__held_stiffness,
  collocation__lag_length,
  collocation__meshed,
  collocation__misfits,
  collocation__overrun_at,
  collocation__ratio_behind_rest,
  collocation__solved,
  collocation__solved_or_softened,
  collocation__start_at,
  in_page__description_of,
  in_page__lift_of,
  meet__all_sliding,
  meet__by_growth,
  meet__held_along,
  meet__interface,
  meet__may_rest,
  meet__with_rest,
  profile__entry_ratio,
  profile__traction_of,
  pull__idles,
  quantities__counted,
  quantities__jumps,
  summary__geometry_of,
  traction__held_stress,
} from "../static/kernel.js";
import { display, figure_of, fixed, percent, quantity, term } from "./told.js";
const max = (a, b) => (b > a ? b : a);
const min = (a, b) => (b < a ? b : a);
const copysign = (a, b) => (b < 0 || Object.is(b, -0) ? -Math.abs(a) : Math.abs(a));
const modulo = (a, b) => (a % b !== 0 && a % b < 0 !== b < 0 ? (a % b) + b : a % b);
const EMPTY = /* @__PURE__ */ new Float64Array(0);
const zeros = (size) => (size > 0 ? new Float64Array(size) : EMPTY);

const $sum = (of) => of.reduce((a, b) => a + b, 0);
const $maxOf = (of) => of.reduce((a, b) => max(a, b));
const $minOf = (of) => of.reduce((a, b) => min(a, b));
const $made = (length, each) => Array.from({ length }, (_, i) => each(i));
const $zip = (...of) => $made(Math.min(...of.map((x) => x.length)), (i) => of.map((x) => x[i]));
const $pairwise = (of) => $zip(of, of.slice(1));
const $enumerate = (of) => Array.from(of, (x, i) => [i, x]);
const $range = (a, b) => (b === undefined ? $made(a, (i) => i) : $made(b - a, (i) => a + i));
const $repeated = (of, times) => $made(times, () => of).flat();
const $sorted = (of, key = (x) => x) => [...of].sort((a, b) => key(a) - key(b));
const $first = (of, other) => (of.length > 0 ? of[0] : other);
const $even = (x, how, digits) => {
  const [all, power] = x[how](100).split("e");
  const cut = all.slice(0, all.indexOf(".") + 1 + digits);
  const tie = /^50*$/.test(all.slice(cut.length)) && /[02468]\.?$/.test(cut);
  return tie ? cut.replace(/\.$/, "") + (power ? `e${power}` : "") : x[how](digits);
};
const $told = (x, sign, digits, how) => {
  const scientific = how === "f" ? "" : $even(x, "toExponential", digits - (how === "g"));
  let text = scientific || $even(x, "toFixed", digits);
  const power = Number(text.split("e")[1]);
  if (how === "g" && power >= -4 && power < digits) text = $even(x, "toFixed", digits - 1 - power);
  if (how === "g" && text.includes(".")) text = text.replace(/\.?0+(?=e|$)/, "");
  text = text.replace(/e([+-])(\d)$/, "e$10$2");
  return sign && !text.startsWith("-") ? `+${text}` : text;
};
const $text = (x) => {
  if (typeof x !== "string") throw new TypeError(`${x} is no text`);
  return x;
};

export class Member {
  constructor(law, geometry, radius, stretch, squeeze, offset = 0.0) {
    this.law = law;
    this.geometry = geometry;
    this.radius = radius;
    this.stretch = stretch;
    this.squeeze = squeeze;
    this.offset = offset;
  }
  get holds() {
    return quantities__jumps(this.law);
  }
  get length() {
    return this.geometry.radius * this.geometry.wrap_angle;
  }
  arm(entry) {
    return this.radius - this.squeeze * entry;
  }
  stretch_log(entry) {
    return Math.log1p(entry * this.stretch) - Math.log1p((-this.squeeze * entry) / this.radius);
  }
  rises(at) {
    return at.slopes.exit_by_place * this.length < -_LEAST_RISE * at.exit;
  }
  place_of(creep) {
    return this.rests ? copysign(Math.sqrt(Math.abs(creep) * REST_SCALE), creep) : creep;
  }
  passage(entry, place, near, tol) {
    let found, slopes;
    let arc = this._driven(place >= 0.0);
    if (!this.rests) {
      found = passage__passed(this.law, arc, entry, place, near, tol);
      return this._told(arc, entry, place, place, 1.0, found);
    }
    let fall = passage__slide_slope(this.law, arc, entry) / Math.sqrt(REST_SCALE);
    let creep = (place * Math.abs(place)) / REST_SCALE;
    if (Math.abs(fall * place) <= SLIDE * entry) {
      slopes = new Response(1.0, -fall, 0.0, 0.0);
      return new Passage(entry, entry - fall * place, place, 0.0, creep, creep, true, slopes);
    }
    found = passage__passed(this.law, arc, entry, creep, near, tol);
    return this._told(arc, entry, place, creep, (2.0 * Math.abs(place)) / REST_SCALE, found);
  }
  _driven(driving) {
    return Object.assign(Object.create(Object.getPrototypeOf(this.geometry)), this.geometry, {
      side: driving ? 1.0 : -1.0,
    });
  }
  _told(arc, entry, place, creep, by_place, at) {
    let gone, ratio;
    let met = at.met;
    if (!met.done) {
      gone = copysign(_BEYOND, place);
      ratio = copysign(LARGEST_RATIO, place);
      return new Passage(entry, entry * Math.exp(-gone), place, ratio, creep, creep);
    }
    let slopes = new Response(
      at.leaving_by_entry,
      at.leaving_by_creep * by_place,
      at.ratio_by_entry,
      at.ratio_by_creep * by_place,
    );
    let slip = profile__traction_of(arc, met, at.leaving, creep).slip;
    let held = this.holds && (met.rest > 0.0 || !this.rests);
    return new Passage(entry, at.leaving, place, at.ratio, creep, slip, held, slopes, met);
  }
  between(entry, exit_) {
    let arc = this._driven(entry >= exit_);
    let found = answer__operating_point(this.law, arc, entry, exit_);
    if (found.outcome !== 0) {
      return null;
    }
    let place = this.place_of(found.met.course.creep.at(-1));
    return Object.assign(
      Object.create(Object.getPrototypeOf(this.passage(entry, place, found.met, COARSE))),
      this.passage(entry, place, found.met, COARSE),
      { exit: exit_ },
    );
  }
  get rests() {
    return this.holds && this.geometry.shear === 0.0;
  }
  get compliance() {
    return this.geometry.compliance;
  }
  get largest_place() {
    return this.place_of(LARGEST_RATIO * this.length);
  }
  stretch_slope(entry) {
    return this.stretch / (1.0 + entry * this.stretch) + this.squeeze / this.arm(entry);
  }
}

export class Line {
  constructor(speed = 0.0, motor = null, scale = 1.0, master = -1, ratio = 1.0, give = 0.0) {
    this.speed = speed;
    this.motor = motor;
    this.scale = scale;
    this.master = master;
    this.ratio = ratio;
    this.give = give;
  }
  get follows() {
    return this.master >= 0;
  }
  log_speed(torque) {
    if (this.motor === null) {
      return this.speed - this.give * torque;
    }
    return Math.log(this.motor.drum_speed(torque) * this.scale);
  }
  log_speed_slope(torque) {
    if (this.motor === null) {
      return -this.give;
    }
    let step = 1e-6 * this.motor.drum_torque;
    return (0.5 * (this.log_speed(torque + step) - this.log_speed(torque - step))) / step;
  }
}

export class Driven {
  constructor(lines, reference) {
    this.lines = lines;
    this.reference = reference;
  }
  *[Symbol.iterator]() {
    yield this.lines;
    yield this.reference;
  }
}

export class Belt {
  constructor(entry, exit, lift, stiffness) {
    this.entry = entry;
    this.exit = exit;
    this.lift = lift;
    this.stiffness = stiffness;
  }
  *[Symbol.iterator]() {
    yield this.entry;
    yield this.exit;
    yield this.lift;
    yield this.stiffness;
  }
}

export class System {
  constructor(members, lines, entry, exit, runs) {
    this.members = members;
    this.lines = lines;
    this.entry = entry;
    this.exit = exit;
    this.runs = runs;
  }
  get pull() {
    return this.entry + $sum(this.runs) - this.exit;
  }
  get torque_scale() {
    return max(this.entry, this.exit) * this.members[0].radius;
  }
  torque(i, entry, exit_) {
    return (entry - exit_) * this.members[i].arm(entry);
  }
  speed_miss(i, at, level) {
    let member = this.members[i];
    let line = this.lines[i];
    let left = -Math.log1p(-min(at.ratio, 0.99)) + member.stretch_log(at.entry);
    return left - line.log_speed(this.torque(i, at.entry, at.exit)) - level;
  }
  speed_slopes(i, at) {
    let member = this.members[i];
    let slopes = at.slopes;
    let arm = member.arm(at.entry);
    let leaves = 1.0 - min(at.ratio, 0.99);
    let by_torque = this.lines[i].log_speed_slope(this.torque(i, at.entry, at.exit));
    let torque_by_entry =
      (1.0 - slopes.exit_by_entry) * arm - (at.entry - at.exit) * member.squeeze;
    let by_entry = slopes.ratio_by_entry / leaves + member.stretch_slope(at.entry);
    return [
      by_entry - by_torque * torque_by_entry,
      slopes.ratio_by_place / leaves + by_torque * slopes.exit_by_place * arm,
    ];
  }
}

export class Pair {
  constructor(entry, exit) {
    this.entry = entry;
    this.exit = exit;
  }
  *[Symbol.iterator]() {
    yield this.entry;
    yield this.exit;
  }
}

export class Passage {
  constructor(
    entry,
    exit,
    place = NaN,
    ratio = NaN,
    creep = NaN,
    slip = NaN,
    held = false,
    slopes = new Response(NaN, NaN, NaN, NaN),
    met = null,
  ) {
    this.entry = entry;
    this.exit = exit;
    this.place = place;
    this.ratio = ratio;
    this.creep = creep;
    this.slip = slip;
    this.held = held;
    this.slopes = slopes;
    this.met = met;
  }
}

export class _Point {
  constructor(level, state, misses) {
    this.level = level;
    this.state = state;
    this.misses = misses;
  }
  get size() {
    if (![...this.misses].every((miss) => Number.isFinite(miss))) {
      return Infinity;
    }
    let speeds = $maxOf([...this.misses.slice(0, -1)].map((miss) => Math.abs(miss)));
    return max(_SPEED_WEIGHT * speeds, Math.abs(this.misses.at(-1)));
  }
}

export class Linear {
  constructor(matrix, pulls, follows) {
    this.matrix = matrix;
    this.pulls = pulls;
    this.follows = follows;
  }
  share_slopes(total) {
    let changes, i, j, right;
    let count = this.pulls.length;
    let slopes = [...$range(count)].map((_) => $repeated([NaN], count));
    for (let each1 = 0, end1 = total !== 0.0 ? count : 0; each1 < end1; each1++) {
      j = each1;
      right = $repeated([0.0], count + 1);
      right[j] = this.follows[j] ? 0.0 : 1.0;
      changes = linear__solution(this.matrix, right);
      if (changes !== null) {
        for (let each2 = 0, end2 = count; each2 < end2; each2++) {
          i = each2;
          slopes[i][j] = newton___dot(this.pulls[i], changes) / total;
        }
      }
    }
    return slopes;
  }
}

export class Settled {
  constructor(passages, level, linear, rising) {
    this.passages = passages;
    this.level = level;
    this.linear = linear;
    this.rising = rising;
  }
  get stable() {
    return this.rising.every((x) => x);
  }
}

export class Located {
  constructor(status, reason, passages, level, settled = null, other_splits = [], fallen = []) {
    this.status = status;
    this.reason = reason;
    this.passages = passages;
    this.level = level;
    this.settled = settled;
    this.other_splits = other_splits;
    this.fallen = fallen;
  }
}

export class Search {
  constructor(system, tol = Infinity) {
    this._system = system;
    this._tol = tol;
    this._last = [...system.members].map((_) => null);
    let share = system.pull / system.members.length;
    this._torques = [...system.members].map((member) => share * member.arm(system.entry));
    let leads = [...$enumerate(system.lines)]
      .filter(([i, line]) => line.follows && i < line.master)
      .map(([i, line]) => line.master);
    this._early = [...$enumerate(leads)]
      .filter(([i, lead]) => ![...leads.slice(0, i)].some((other) => lead === other))
      .map(([i, lead]) => lead);
    this._center = system__mean_level(system);
    this._w = NaN;
  }
  level(w) {
    return this._center + _LEVEL_SCALE * Math.sinh(w);
  }
  follow(level) {
    let arm, at, by_entry, by_place, grows, i, lead, line, member, moved, out, run, torque, turns;
    let system = this._system;
    let entry = this._system.entry;
    let rise = 0.0;
    let passages = [];
    let torques = [];
    for (const each1 of $enumerate($zip(system.lines, system.runs))) {
      [i, [line, run]] = each1;
      member = system.members[i];
      arm = member.arm(entry);
      if (line.follows) {
        lead = line.master;
        torque = this._torques[line.master];
        turns = 0.0;
        if (lead < i) {
          torque = system.torque(lead, passages[lead].entry, passages[lead].exit);
          turns = torques[lead];
        }
        out = max(entry - (line.ratio * torque) / arm, 1e-6 * entry);
        at = new Passage(entry, out);
        grows = rise - (line.ratio * turns) / arm;
      } else {
        at = this._turned(i, entry, level);
        [by_entry, by_place] = system.speed_slopes(i, at);
        moved = by_place > 0.0 ? (1.0 - by_entry * rise) / by_place : 0.0;
        grows = at.slopes.exit_by_entry * rise + at.slopes.exit_by_place * moved;
        this._last[i] = at;
      }
      torques.push((rise - grows) * arm - (entry - at.exit) * member.squeeze * rise);
      passages.push(at);
      entry = max(at.exit + run, 1e-6 * system.entry);
      rise = grows;
    }
    return new Followed(passages, rise);
  }
  _turned(i, entry, level) {
    let by_entry, by_place, place, short;
    let system = this._system;
    let member = this._system.members[i];
    let last = this._last[i];
    let end = member.largest_place;
    let found = last === null ? [] : [last];
    const miss = (place) => {
      let near = found.length > 0 ? found[found.length - 1].met : null;
      let at = member.passage(entry, place, near, this._tol);
      found.push(at);
      return [system.speed_miss(i, at, level), system.speed_slopes(i, at)[1]];
    };
    if (last === null) {
      place = system__first_place(system, i);
    } else {
      [by_entry, by_place] = system.speed_slopes(i, last);
      short = system.speed_miss(i, last, level) + by_entry * (entry - last.entry);
      place = by_place > 0.0 ? last.place - short / by_place : last.place;
    }
    roots__sloped_root(miss, place, -end, end, _TURNED);
    return found[found.length - 1];
  }
  solution(tolerance = 1e-5) {
    let before, lead;
    let scale = this._system.torque_scale;
    for (let each1 = 0, end1 = this._early.length > 0 ? 20 : 0; each1 < end1; each1++) {
      before = [...this._torques];
      for (const each2 of this._early) {
        lead = each2;
        this._lead(lead, before[lead], tolerance);
      }
      if ([...this._early].every((i) => Math.abs(this._torques[i] - before[i]) < 0.0001 * scale)) {
        break;
      }
    }
    return this._solution(tolerance);
  }
  _lead(lead, start, tolerance) {
    let scale = this._system.torque_scale;
    const miss = (torque) => {
      return this._torque_miss(lead, tolerance, torque);
    };
    roots__rising_root(miss, start, 0.1 * scale, -scale, scale, 1e-5 * scale);
  }
  _solution(tolerance) {
    let miss;
    let guess = this._w;
    if (Number.isNaN(guess)) {
      guess = Math.asinh(_FIRST_RATIO / _LEVEL_SCALE);
      guess = this._system.pull >= 0.0 ? guess : -guess;
    }
    [this._w, miss] = this._root(guess, -_LEVEL_END, _LEVEL_END, tolerance);
    return [this._w, miss];
  }
  _root(w, low, high, tolerance) {
    const miss = (x) => {
      let at = this.miss(x);
      return [at.miss, at.slope];
    };
    return roots__sloped_root(miss, w, low, high, tolerance);
  }
  _torque_miss(lead, tolerance, torque) {
    this._torques[lead] = torque;
    let [w] = this._solution(tolerance);
    let at = this.follow(this.level(w)).passages[lead];
    return torque - this._system.torque(lead, at.entry, at.exit);
  }
  all_solutions(tolerance = 1e-6) {
    let a, b;
    if (this._early.length > 0) {
      this.solution(tolerance);
    }
    let nodes = [...this._levels()].map((w) => this.miss(w));
    let tips = [...$pairwise(nodes)]
      .filter(([a, b]) => system___turns(a, b))
      .map(([a, b]) => this._tip(a, b));
    nodes = $sorted([...nodes, ...tips], (node) => node.w);
    let found = [];
    for (const each1 of $pairwise(nodes)) {
      [a, b] = each1;
      if (a.miss < 0.0 !== b.miss < 0.0) {
        found.push(this._crossing(a, b, tolerance));
      }
    }
    return found;
  }
  _crossing(a, b, tolerance) {
    let way = a.miss < 0.0 ? 1.0 : -1.0;
    const miss = (w) => {
      let at = this.miss(w);
      return [way * at.miss, way * at.slope];
    };
    let share = a.miss / (a.miss - b.miss);
    return roots__sloped_root(miss, a.w + share * (b.w - a.w), a.w, b.w, tolerance)[0];
  }
  _levels() {
    let sign = this._system.pull >= 0.0 ? 1.0 : -1.0;
    let nodes = [...$range(_SCAN + 1)].map((k) => (sign * _LEVEL_END * k) / _SCAN);
    if (sign * this.miss(0.0).miss > 0.0) {
      nodes = [...nodes, ...[...nodes.slice(1)].map((w) => -w)];
    }
    return $sorted(nodes);
  }
  _tip(a, b) {
    let at;
    let way = a.miss > 0.0 ? 1.0 : -1.0;
    let best = way * a.miss < way * b.miss ? a : b;
    for (let each1 = 0, end1 = _TIP_STEPS; each1 < end1; each1++) {
      at = this.miss((a.w * b.slope - b.w * a.slope) / (b.slope - a.slope));
      if (way * at.miss < way * best.miss) {
        best = at;
      }
      if (way * at.miss < 0.0 || b.w - a.w < _TIP) {
        break;
      }
      if (way * at.slope < 0.0) {
        a = at;
      } else {
        b = at;
      }
    }
    return best;
  }
  strongest() {
    let value, w;
    let sign = this._system.pull >= 0.0 ? 1.0 : -1.0;
    let best = 0.0;
    let best_value = -Infinity;
    for (const each1 of $sorted(this._levels(), Math.abs)) {
      w = each1;
      value = sign * this.miss(w).miss;
      if (sign * w >= 0.0 && value > best_value + 1e-9) {
        best = w;
        best_value = value;
      }
    }
    return best;
  }
  miss(w) {
    let found = this.follow(this.level(w));
    let last = found.passages[found.passages.length - 1].exit;
    let slope = (-found.by_level / last) * _LEVEL_SCALE * Math.cosh(w);
    return new Node(w, Math.log(this._system.exit / last), slope);
  }
}

export class Divided {
  constructor(pairs, located, belt_speeds, belt) {
    this.pairs = pairs;
    this.located = located;
    this.belt_speeds = belt_speeds;
    this.belt = belt;
  }
  *[Symbol.iterator]() {
    yield this.pairs;
    yield this.located;
    yield this.belt_speeds;
    yield this.belt;
  }
}

export class Nip {
  constructor(entry, pull, creep_ratio, radius, compression, offset, nominal) {
    this.entry = entry;
    this.pull = pull;
    this.creep_ratio = creep_ratio;
    this.radius = radius;
    this.compression = compression;
    this.offset = offset;
    this.nominal = nominal;
  }
  *[Symbol.iterator]() {
    yield this.entry;
    yield this.pull;
    yield this.creep_ratio;
    yield this.radius;
    yield this.compression;
    yield this.offset;
    yield this.nominal;
  }
}

export class Turning {
  constructor(
    share,
    speed_ratio,
    contraction_term,
    creep_term,
    compression_term,
    thickness_term,
    drum_ratio,
    surface_speed,
    rotation_speed,
    speed_trim,
    drum_torque,
    drum_power,
  ) {
    this.share = share;
    this.speed_ratio = speed_ratio;
    this.contraction_term = contraction_term;
    this.creep_term = creep_term;
    this.compression_term = compression_term;
    this.thickness_term = thickness_term;
    this.drum_ratio = drum_ratio;
    this.surface_speed = surface_speed;
    this.rotation_speed = rotation_speed;
    this.speed_trim = speed_trim;
    this.drum_torque = drum_torque;
    this.drum_power = drum_power;
  }
  *[Symbol.iterator]() {
    yield this.share;
    yield this.speed_ratio;
    yield this.contraction_term;
    yield this.creep_term;
    yield this.compression_term;
    yield this.thickness_term;
    yield this.drum_ratio;
    yield this.surface_speed;
    yield this.rotation_speed;
    yield this.speed_trim;
    yield this.drum_torque;
    yield this.drum_power;
  }
}

export class MotorPoint {
  constructor(
    motor_load,
    motor_torque,
    motor_speed,
    motor_power,
    gear_speed,
    electrical_power,
    motor_loss,
    coupling_loss,
    gear_loss,
  ) {
    this.motor_load = motor_load;
    this.motor_torque = motor_torque;
    this.motor_speed = motor_speed;
    this.motor_power = motor_power;
    this.gear_speed = gear_speed;
    this.electrical_power = electrical_power;
    this.motor_loss = motor_loss;
    this.coupling_loss = coupling_loss;
    this.gear_loss = gear_loss;
  }
}

export class Told {
  constructor(
    status,
    reason,
    turnings,
    points,
    sensitivity,
    other_splits,
    tension_error,
    speed_error,
  ) {
    this.status = status;
    this.reason = reason;
    this.turnings = turnings;
    this.points = points;
    this.sensitivity = sensitivity;
    this.other_splits = other_splits;
    this.tension_error = tension_error;
    this.speed_error = speed_error;
  }
  *[Symbol.iterator]() {
    yield this.status;
    yield this.reason;
    yield this.turnings;
    yield this.points;
    yield this.sensitivity;
    yield this.other_splits;
    yield this.tension_error;
    yield this.speed_error;
  }
}

export class Row {
  constructor(title, values, symbol = "", note = "", name = "", level = null) {
    this.title = title;
    this.values = values;
    this.symbol = symbol;
    this.note = note;
    this.name = name;
    this.level = level;
  }
}

export class Table {
  constructor(title, rows, heads = [""], note = "", name = "", short = null, brief = "") {
    this.title = title;
    this.rows = rows;
    this.heads = heads;
    this.note = note;
    this.name = name;
    this.short = short;
    this.brief = brief;
  }
}

export class KeyFigure {
  constructor(name, better = "low", elsewhere = []) {
    this.name = name;
    this.better = better;
    this.elsewhere = elsewhere;
  }
  *[Symbol.iterator]() {
    yield this.name;
    yield this.better;
    yield this.elsewhere;
  }
}

export class CaseResult {
  constructor(
    case_,
    status,
    reason,
    members,
    sensitivity,
    belt_speed,
    other_splits = [],
    tension_error = 0.0,
    speed_error = 0.0,
  ) {
    this.case = case_;
    this.status = status;
    this.reason = reason;
    this.members = members;
    this.sensitivity = sensitivity;
    this.belt_speed = belt_speed;
    this.other_splits = other_splits;
    this.tension_error = tension_error;
    this.speed_error = speed_error;
  }
  get power_loss() {
    return $sum([...this.members].map((m) => m.arc.energy.power_loss));
  }
  get loss_ratio() {
    let loss, m, mean, power, pull;
    loss = power = 0.0;
    for (const each1 of this.members) {
      m = each1;
      pull = m.arc.effective_tension;
      mean = m.arc.entry_creep_ratio + 0.5 * pull * m.arc.arc.compliance;
      loss += m.speed_ratio * pull * mean;
      power += m.speed_ratio * pull;
    }
    return power !== 0.0 ? loss / Math.abs(power) : NaN;
  }
  share_per_trim(drive, trimmed = null, trim = 0.001) {
    return trim * this.sensitivity[drive][trimmed === null ? drive : trimmed];
  }
  get within_creep_limit() {
    return this.status.solved && [...this.members].every((m) => m.arc.within_creep_limit);
  }
}

export class MemberResult {
  constructor(
    arc,
    share,
    speed_ratio,
    contraction_term,
    creep_term,
    compression_term,
    thickness_term,
    drum_ratio,
    surface_speed,
    rotation_speed,
    speed_trim,
    drum_torque,
    drum_power,
    motor = null,
  ) {
    this.arc = arc;
    this.share = share;
    this.speed_ratio = speed_ratio;
    this.contraction_term = contraction_term;
    this.creep_term = creep_term;
    this.compression_term = compression_term;
    this.thickness_term = thickness_term;
    this.drum_ratio = drum_ratio;
    this.surface_speed = surface_speed;
    this.rotation_speed = rotation_speed;
    this.speed_trim = speed_trim;
    this.drum_torque = drum_torque;
    this.drum_power = drum_power;
    this.motor = motor;
  }
  get name() {
    return this.arc.arc.pulley;
  }
}

export class Motor {
  constructor(
    rated_power,
    rated_speed,
    gear_ratio = 1.0,
    gear_efficiency = 1.0,
    motor_efficiency = null,
    count = 1,
    brakes = true,
  ) {
    this.rated_power = rated_power;
    this.rated_speed = rated_speed;
    this.gear_ratio = gear_ratio;
    this.gear_efficiency = gear_efficiency;
    this.motor_efficiency = motor_efficiency;
    this.count = count;
    this.brakes = brakes;
  }
  get holds_speed() {
    return false;
  }
  get rated_torque() {
    return this.rated_power / this.rated_speed;
  }
  get drum_torque() {
    return this.count * this.gear_ratio * this.rated_torque;
  }
  motor_speed(load, gear_speed) {
    return gear_speed;
  }
  load(drum_torque) {
    let eta = drum_torque >= 0.0 ? this.gear_efficiency : 1.0 / this.gear_efficiency;
    return drum_torque / (eta * this.drum_torque);
  }
  drum_speed(drum_torque) {
    let load = this.load(drum_torque);
    let end = this.largest_load();
    let within = min(max(load, -end), end);
    let excess = load - within;
    let speed = this.shaft_speed(within) / this.gear_ratio;
    return speed * Math.exp(-BEYOND * copysign(Math.log1p(Math.abs(excess)), excess));
  }
  limits() {
    let end = this.largest_load();
    return [this.brakes ? -end : 0.0, end];
  }
  shaft_speed(load) {}
  largest_load() {}
}

export class VariableSpeed extends Motor {
  constructor(
    rated_power,
    rated_speed,
    gear_ratio = 1.0,
    gear_efficiency = 1.0,
    motor_efficiency = null,
    count = 1,
    brakes = true,
    setting = 1.0,
    droop = 0.0,
    torque_limit = Infinity,
  ) {
    super();
    this.rated_power = rated_power;
    this.rated_speed = rated_speed;
    this.gear_ratio = gear_ratio;
    this.gear_efficiency = gear_efficiency;
    this.motor_efficiency = motor_efficiency;
    this.count = count;
    this.brakes = brakes;
    this.setting = setting;
    this.droop = droop;
    this.torque_limit = torque_limit;
  }
  get holds_speed() {
    return this.droop === 0.0;
  }
  shaft_speed(load) {
    return this.rated_speed * max(this.setting - this.droop * load, 0.001);
  }
  largest_load() {
    let stall = this.droop > 0.0 ? (0.9 * this.setting) / this.droop : Infinity;
    return min(this.torque_limit, stall);
  }
}

export class Induction extends Motor {
  constructor(
    rated_power,
    rated_speed,
    gear_ratio = 1.0,
    gear_efficiency = 1.0,
    motor_efficiency = null,
    count = 1,
    brakes = true,
    synchronous_speed,
    breakdown_ratio = 2.5,
  ) {
    super();
    this.rated_power = rated_power;
    this.rated_speed = rated_speed;
    this.gear_ratio = gear_ratio;
    this.gear_efficiency = gear_efficiency;
    this.motor_efficiency = motor_efficiency;
    this.count = count;
    this.brakes = brakes;
    this.synchronous_speed = synchronous_speed;
    this.breakdown_ratio = breakdown_ratio;
  }
  shaft_speed(load) {
    let ratio = this.breakdown_ratio;
    let x = load / ratio;
    let part = x / (1.0 + Math.sqrt(max(1.0 - x * x, 0.0)));
    let breakdown_slip = this.rated_slip * (ratio + Math.sqrt(ratio * ratio - 1.0));
    return this.synchronous_speed * max(1.0 - breakdown_slip * part, 0.001);
  }
  largest_load() {
    return this.breakdown_ratio;
  }
  get rated_slip() {
    return 1.0 - this.rated_speed / this.synchronous_speed;
  }
}

export class FluidCoupling extends Induction {
  constructor(
    rated_power,
    rated_speed,
    gear_ratio = 1.0,
    gear_efficiency = 1.0,
    motor_efficiency = null,
    count = 1,
    brakes = true,
    synchronous_speed,
    breakdown_ratio = 2.5,
    coupling_load,
    coupling_slip,
  ) {
    super();
    this.rated_power = rated_power;
    this.rated_speed = rated_speed;
    this.gear_ratio = gear_ratio;
    this.gear_efficiency = gear_efficiency;
    this.motor_efficiency = motor_efficiency;
    this.count = count;
    this.brakes = brakes;
    this.synchronous_speed = synchronous_speed;
    this.breakdown_ratio = breakdown_ratio;
    this.coupling_load = coupling_load;
    this.coupling_slip = coupling_slip;
  }
  shaft_speed(load) {
    let pump = super.shaft_speed(load);
    return pump * (1.0 - this._slip(load * (this.rated_speed / pump) ** 2));
  }
  motor_speed(load, gear_speed) {
    return super.shaft_speed(load);
  }
  _slip(load) {
    let size = Math.abs(load);
    let loads = this.coupling_load;
    let slips = this.coupling_slip;
    let i = 0;
    while (i < loads.length - 2 && size > loads[i + 1]) {
      i += 1;
    }
    let weight = (size - loads[i]) / (loads[i + 1] - loads[i]);
    let slip = slips[i] + weight * (slips[i + 1] - slips[i]);
    return copysign(min(slip, 0.95), load);
  }
  largest_load() {
    return this._end;
  }
  get _end() {
    let load, pump;
    let low = 0.0;
    let high = this.breakdown_ratio;
    for (let each1 = 0, end1 = 60; each1 < end1; each1++) {
      load = 0.5 * (low + high);
      pump = super.shaft_speed(load);
      if (load * (this.rated_speed / pump) ** 2 <= this.coupling_load.at(-1)) {
        low = load;
      } else {
        high = load;
      }
    }
    return high === this.breakdown_ratio ? high : low;
  }
}

export class Passed {
  constructor(
    met,
    leaving,
    ratio,
    leaving_by_entry,
    leaving_by_creep,
    ratio_by_entry,
    ratio_by_creep,
  ) {
    this.met = met;
    this.leaving = leaving;
    this.ratio = ratio;
    this.leaving_by_entry = leaving_by_entry;
    this.leaving_by_creep = leaving_by_creep;
    this.ratio_by_entry = ratio_by_entry;
    this.ratio_by_creep = ratio_by_creep;
  }
  *[Symbol.iterator]() {
    yield this.met;
    yield this.leaving;
    yield this.ratio;
    yield this.leaving_by_entry;
    yield this.leaving_by_creep;
    yield this.ratio_by_entry;
    yield this.ratio_by_creep;
  }
}

export class Response {
  constructor(exit_by_entry, exit_by_place, ratio_by_entry, ratio_by_place) {
    this.exit_by_entry = exit_by_entry;
    this.exit_by_place = exit_by_place;
    this.ratio_by_entry = ratio_by_entry;
    this.ratio_by_place = ratio_by_place;
  }
  *[Symbol.iterator]() {
    yield this.exit_by_entry;
    yield this.exit_by_place;
    yield this.ratio_by_entry;
    yield this.ratio_by_place;
  }
}

export class Followed {
  constructor(passages, by_level) {
    this.passages = passages;
    this.by_level = by_level;
  }
  *[Symbol.iterator]() {
    yield this.passages;
    yield this.by_level;
  }
}

export class Node {
  constructor(w, miss, slope) {
    this.w = w;
    this.miss = miss;
    this.slope = slope;
  }
  *[Symbol.iterator]() {
    yield this.w;
    yield this.miss;
    yield this.slope;
  }
}

const FINE = 1e-6;
const SHARP = 1e-5;
const _FIRST_RATIO = 0.0015;
const _SPEED_WEIGHT = 1000.0;
const COARSE = Infinity;
const _MOST = 30;
const _OF_ITSELF = 2.0;
const _OF_WRAP = 0.02;
const _NEAR = 1e-5;
const _HALVINGS = 15;
const SOLVED = "The drives transmit the load.";
const BREAKAWAY =
  "Gross slip: a drive cannot transmit its share of the load. Raise the slack-side tension (take-up), bring the speeds closer together, or choose a lagging with more friction.";
const _ROUNDS = 5;
const _SAME = 1e-7;
const _GIVE = 0.01;
const _LESS = 0.2;
const _LEAST_GIVE = 1e-6;
const UNSOLVED =
  "The solver did not reach its accuracy on this train. Please report the drive file; until then change a value slightly.";
const _IDLE = 1e-11;
const GIVEN_DIGITS = 4;
const BEYOND_MOTOR =
  "No operating point: a motor would have to work outside its curve. Change its set speed or gear, or choose another motor.";
const RESULT_DIGITS = 3;
const SMALL_PULL = 0.001;
const _AS_FAST = 5e-6;
const USUAL_OFFSET = 0.005;
const _TOLERATED = 0.05;
const NONE = "-";
const _ROUNDING = 1e-9;
const KEY_FIGURES = [
  new KeyFigure("entry_tension", "", ["short", "arcs", "tiles", "compare"]),
  new KeyFigure("exit_tension", "", ["short", "arcs", "tiles", "compare"]),
  new KeyFigure("effective_tension", "", ["short", "arcs", "tiles", "compare"]),
  new KeyFigure("tension_ratio", "", ["short", "arcs", "drives", "compare", "changes"]),
  new KeyFigure("exit_creep", "low", ["short", "arcs"]),
  new KeyFigure("exit_slip", "", ["short", "drives", "compare"]),
  new KeyFigure("peak_shear_stress", "low", ["tiles"]),
  new KeyFigure("peak_shear_angle", "low", ["short", "drives"]),
  new KeyFigure("mean_friction", "", ["short", "drives", "compare", "changes"]),
  new KeyFigure("creep_limit_margin", "high", ["short", "changes"]),
  new KeyFigure("equivalent_friction", "", ["short", "drives", "compare"]),
  new KeyFigure("power_loss", "low", []),
];
const ATTENTION = "ATTENTION";
const TRAIN_BALANCE = 1e-5;
const _LEAST_RISE = 1e-9;
const REST_SCALE = 0.001;
const POINT_STEPS = 20000.0;
const CREEP = 1;
const NO_MESH = Infinity;
const COARSELY = 0.0001;
const SETTLED = 1e-6;
const FIRST_STEPS = 15;
const MESHES = 3;
const LATER_STEPS = 20;
const ROUNDING = 1e-9;
const AFRESH = 0.01;
const LARGEST_FALL = 6.0;
const SLIDE = 1e-6;
const _BEYOND = 30.0;
const LARGEST_RATIO = 0.5;
const _LEVEL_SCALE = 1e-5;
const _TURNED = 1e-9;
const _REACH = 0.01;
const _LEVEL_END = 11.512925465070229;
const _SCAN = 18;
const _TIP_STEPS = 12;
const _TIP = 0.0001;
const BEYOND = 10.0;

/** The drives that break away where no division of the load is found, by index. */
export function in_page_train__fallen_of(of) {
  return of.located === null ? [] : [...of.located.fallen];
}

/** Pull that powers of the drives make [N]. */
export function in_page_train__total_of(powers, speed) {
  return $sum(powers) / speed;
}

/** Part of each in their sum [-]. */
export function in_page_train__parts_of(values) {
  let total = $sum(values);
  return [...values].map((value) => value / total);
}

/** How far tensions at both ends miss a pull, in parts of it [-]. */
export function in_page_train__miss_of(entry, exit_, runs, pull) {
  return Math.abs(entry - exit_ + runs - pull) / Math.abs(pull);
}

/** Rotation speeds of drums by their trims, in any one unit. */
export function in_page_train__trimmed(trims, nominal) {
  return [...$zip(trims, nominal)].map(([trim, diameter]) => trim / diameter);
}

/** Pulls of drums that take parts of it all [N]. */
export function in_page_train__shared(fractions, total) {
  return [...fractions].map((fraction) => fraction * total);
}

/** Least tension of pulleys [N]. */
export function in_page_train__least_of(pairs) {
  return $minOf([...pairs].map((at) => min(at.entry, at.exit)));
}

/** A pulley of a train, by its numbers. */
export function in_page_train__member_of(law, given) {
  let arc = in_page__description_of(given);
  let squeeze = (2.0 * (arc.thickness / arc.compression_modulus)) / (arc.width * arc.diameter);
  let geometry = summary__geometry_of(arc);
  let stretch = 1.0 / (arc.axial_stiffness + arc.centrifugal);
  let e = arc.pitch_offset;
  return new Member(law, geometry, 0.5 * arc.diameter + e, stretch, squeeze, e);
}

/** Return the speed of the first drum at R + e, without compression [m/s]. */
export function turning__surface_of_first(speeds, radii) {
  return speeds[0] * radii[0];
}

/** Return the logarithms of surface speeds over that of the first drum [-]. */
export function turning__held_speeds(speeds, radii) {
  let first = turning__surface_of_first(speeds, radii);
  return [...$zip(speeds, radii)].map(([speed, radius]) => Math.log((speed * radius) / first));
}

/** Lines of drums that turn at given speeds, in any one unit. */
export function in_page_train__turned(speeds, radii) {
  return [...turning__held_speeds(speeds, radii)].map((at) => new Line(at));
}

/** Return the lines of drums on motors. */
export function turning__driven(motors, masters, ratios, radii) {
  let master, motor, radius, ratio;
  let speeds = [...$zip(motors, radii)]
    .filter(([motor, radius]) => motor !== null)
    .map(([motor, radius]) => motor.drum_speed(0.0) * radius);
  let reference = speeds[0];
  let lines = [];
  for (const each1 of $zip(motors, masters, ratios, radii)) {
    [motor, master, ratio, radius] = each1;
    if (motor === null) {
      lines.push(new Line(undefined, undefined, undefined, master, ratio));
    } else if (motor.holds_speed) {
      lines.push(new Line(Math.log((motor.drum_speed(0.0) * radius) / reference)));
    } else {
      lines.push(new Line(undefined, motor, radius / reference));
    }
  }
  return new Driven(lines, reference);
}

/** The belt of a train with tensions at its ends [N]. */
export function in_page_train__belt_of(given, entry, exit_) {
  return new Belt(entry, exit_, in_page__lift_of(given), given.modulus * given.width);
}

/** The equations of a train, whose tensions are those above m v^2. */
export function in_page_train__system_of(members, lines, belt, runs) {
  return new System(members, lines, belt.entry - belt.lift, belt.exit - belt.lift, runs);
}

/** Return the tensions of pulleys whose pulls are known; `runs` has 0 behind the last [N]. */
export function train__along(entry, exit_, runs, pulls) {
  let i, out, pull, run;
  let pairs = [];
  let now = entry;
  for (const each1 of $enumerate($zip(pulls, runs))) {
    [i, [pull, run]] = each1;
    out = i === pulls.length - 1 ? exit_ : now - pull;
    pairs.push(new Pair(now, out));
    now = out + run;
  }
  return pairs;
}

/** Where a pulley may be, before anything is known [m]. */
export function system__first_place(system, i) {
  let member = system.members[i];
  let place = member.place_of(_FIRST_RATIO * member.length);
  return system.pull >= 0.0 ? place : -place;
}

/** Level at which the drives together creep about nothing. */
export function system__mean_level(system) {
  let tension = 0.5 * (system.entry + system.exit);
  let share = system.pull / system.members.length;
  let levels = [...$zip(system.members, system.lines)]
    .filter(([member, line]) => !line.follows)
    .map(
      ([member, line]) =>
        member.stretch_log(tension) - line.log_speed(share * member.arm(system.entry)),
    );
  return $sum(levels) / levels.length;
}

/** Passages of a train of which nothing is known but their places, and a level. */
export function system__guessed(system) {
  let places = [...$range(system.members.length)].map((i) => system__first_place(system, i));
  return [
    [...places].map((x) => new Passage(system.entry, system.exit, x)),
    system__mean_level(system),
  ];
}

/** Passages with their places; those known by their tensions only are solved for them. */
export function newton___starts(system, passages) {
  let at, known, member;
  let starts = [];
  for (const each1 of $zip(system.members, passages)) {
    [member, at] = each1;
    known = at;
    if (Number.isNaN(at.place)) {
      known = member.between(at.entry, at.exit);
    }
    if (known === null) {
      return null;
    }
    starts.push(known);
  }
  return starts;
}

export function newton___misses(system, state, level) {
  let torques = [...$enumerate(state)].map(([i, at]) => system.torque(i, at.entry, at.exit));
  let misses = [...$enumerate(system.lines)].map(([i, line]) =>
    line.follows
      ? (torques[i] - line.ratio * torques[line.master]) / system.torque_scale
      : system.speed_miss(i, state[i], level),
  );
  return [...misses, Math.log(state.at(-1).exit / system.exit)];
}

export function newton___point(system, places, arcs, level, tol) {
  let at, member, near, place, run;
  let entry = system.entry;
  let state = [];
  for (const each1 of $zip(system.members, places, arcs, system.runs)) {
    [member, place, near, run] = each1;
    at = member.passage(max(entry, 1e-6 * system.entry), place, near, tol);
    state.push(at);
    entry = at.exit + run;
  }
  return new _Point(level, [...state], newton___misses(system, state, level));
}

/** Return the equations near a state, and whether each drive rises with its creep. */
export function newton__linearized(system, passages) {
  let arm, at, by_entry, by_place, i, leaving, line, lost, member, pairs, pull;
  let count = passages.length;
  let matrix = [...$range(count + 1)].map((_) => $repeated([0.0], count + 1));
  let pulls = [];
  let torques = [];
  let entry = $repeated([0.0], count + 1);
  for (const each1 of $enumerate(passages)) {
    [i, at] = each1;
    member = system.members[i];
    leaving = [...entry].map((x) => at.slopes.exit_by_entry * x);
    leaving[i] += at.slopes.exit_by_place;
    pull = [...$zip(entry, leaving)].map(([x, y]) => x - y);
    arm = member.arm(at.entry);
    lost = (at.entry - at.exit) * member.squeeze;
    pulls.push(pull);
    torques.push([...$zip(pull, entry)].map(([x, y]) => x * arm - lost * y));
    if (!system.lines[i].follows) {
      [by_entry, by_place] = system.speed_slopes(i, at);
      matrix[i] = [...entry].map((x) => by_entry * x);
      matrix[i][i] += by_place;
      matrix[i][count] -= 1.0;
    }
    entry = leaving;
  }
  for (const each2 of $enumerate(system.lines)) {
    [i, line] = each2;
    if (line.follows) {
      pairs = $zip(torques[i], torques[line.master]);
      matrix[i] = [...pairs].map(([x, y]) => (x - line.ratio * y) / system.torque_scale);
    }
  }
  matrix[count] = [...entry].map((x) => x / passages.at(-1).exit);
  let rising = [...[...$zip(system.members, passages)].map(([m, at]) => m.rises(at))];
  return [new Linear(matrix, pulls, [...[...system.lines].map((line) => line.follows)]), rising];
}

/** Solve linear equations by elimination, the largest of each column for pivot. */
export function linear__solution(matrix, right) {
  let best, factor, i, j, k, pivot, rest;
  let count = right.length;
  let rows = [...$zip(matrix, right)].map(([row, value]) => [...row, value]);
  for (let each1 = 0, end1 = count; each1 < end1; each1++) {
    k = each1;
    best = k;
    for (let each2 = k + 1, end2 = count; each2 < end2; each2++) {
      i = each2;
      if (Math.abs(rows[i][k]) > Math.abs(rows[best][k])) {
        best = i;
      }
    }
    pivot = rows[best];
    rows[best] = rows[k];
    rows[k] = pivot;
    if (!(Math.abs(pivot[k]) > 0.0)) {
      return null;
    }
    for (let each3 = k + 1, end3 = count; each3 < end3; each3++) {
      i = each3;
      factor = rows[i][k] / pivot[k];
      for (let each4 = k + 1, end4 = count + 1; each4 < end4; each4++) {
        j = each4;
        rows[i][j] -= factor * pivot[j];
      }
    }
  }
  let found = $repeated([0.0], count);
  for (let each5 = count - 1, end5 = -1; each5 > end5; each5 += -1) {
    k = each5;
    rest = rows[k][count];
    for (let each6 = k + 1, end6 = count; each6 < end6; each6++) {
      j = each6;
      rest -= rows[k][j] * found[j];
    }
    found[k] = rest / rows[k][k];
  }
  return found;
}

export function newton___places(at) {
  return [...at.state].map((passage) => passage.place);
}

export function newton___arcs(at) {
  return [...at.state].map((passage) => passage.met);
}

/** Take the step of the linear equations, shortened until it helps. */
export function newton___stepped(at, system, matrix) {
  let change, member, most, new_, passage, places;
  let step = linear__solution(
    matrix,
    [...at.misses].map((miss) => -miss),
  );
  if (step === null || ![...step].every((change) => Number.isFinite(change))) {
    return null;
  }
  let scale = 1.0;
  for (const each1 of $zip(system.members, at.state, step.slice(0, -1))) {
    [member, passage, change] = each1;
    most = _OF_ITSELF * Math.abs(passage.place) + member.place_of(_OF_WRAP * member.length);
    scale = min(scale, most / max(Math.abs(change), 1e-300));
  }
  for (let each2 = 0, end2 = at.size > _NEAR ? _HALVINGS : 2; each2 < end2; each2++) {
    places = [...$zip(newton___places(at), step.slice(0, -1))].map(([x, d]) => x + scale * d);
    new_ = newton___point(
      system,
      places,
      newton___arcs(at),
      at.level + scale * step.at(-1),
      COARSE,
    );
    if (new_.size < at.size) {
      return new_;
    }
    scale *= 0.5;
  }
  return null;
}

/** Meet all equations from a state nearby; None if that fails. */
export function newton__settle(system, passages, level, tol = 1e-6, tolerance = 1e-14) {
  let done, linear, new_, rising;
  let starts = newton___starts(system, passages);
  if (starts === null) {
    return null;
  }
  let places = [...starts].map((at) => at.place);
  let arcs = [...starts].map((at) => at.met);
  let enough = tolerance * _SPEED_WEIGHT;
  let again = false;
  let smooth = ![...system.members].some((member) => member.holds);
  let meshed = tol === COARSE || (smooth && [...arcs].every((arc) => arc !== null));
  let at = newton___point(system, places, arcs, level, meshed ? tol : COARSE);
  for (let each1 = 0, end1 = _MOST; each1 < end1; each1++) {
    const found2 = newton__linearized(system, at.state);
    linear = found2[0];
    rising = found2[1];
    new_ = at.size > enough ? newton___stepped(at, system, linear.matrix) : null;
    if (new_ !== null) {
      at = new_;
      again = false;
    } else if (!meshed) {
      meshed = true;
      at = newton___point(system, newton___places(at), newton___arcs(at), at.level, tol);
    } else if (at.size > enough && !again) {
      again = true;
      at = newton___point(system, newton___places(at), newton___arcs(at), at.level, COARSE);
    } else {
      done = at.size <= 1000.0 * enough;
      return done ? new Settled(at.state, at.level, linear, rising) : null;
    }
  }
  return null;
}

export function locate___shares(system, state) {
  return [...[...state.passages].map((p) => (p.entry - p.exit) / system.pull)];
}

/** Return the names of drives, "a and b". */
export function locate___listed(names, indices) {
  return [...indices].map((i) => names[i]).join(" and ");
}

/** Return the stable one of several states; there is none where a drive is past its peak. */
export function locate___chosen(system, names, states) {
  states = $sorted(states, (s) => $maxOf([...s.passages].map((p) => Math.abs(p.creep))));
  let state = $first(
    [...states].filter((s) => s.stable),
    states[0],
  );
  let others = [...[...states].filter((s) => s !== state).map((s) => locate___shares(system, s))];
  let past = $zip(system.members, state.passages, state.rising);
  let fallen = [
    ...[...$enumerate(past)]
      .filter(([i, [m, p, rising]]) => !rising || (m.holds && !p.held))
      .map(([i, [m, p, rising]]) => i),
  ];
  let status = SOLVED;
  let reason = "";
  if (fallen.length > 0) {
    status = BREAKAWAY;
    reason =
      "" +
      "At these speeds gross slip on " +
      $text(locate___listed(names, fallen)) +
      ": the only balance has " +
      $text(fallen.length === 1 ? "it" : "them") +
      " sliding, past the peak of friction.";
  }
  return new Located(status, reason, state.passages, state.level, state, others, fallen);
}

/** Return the tensions at which the arcs, solved for their tensions, meet the speeds. */
export function locate___as_told(system, located) {
  let at, better, member, p, pairs, solved, state;
  for (let each1 = 0, end1 = _ROUNDS; each1 < end1; each1++) {
    state = located.settled;
    if (state === null || located.status !== SOLVED) {
      break;
    }
    solved = [];
    for (const each2 of $zip(system.members, state.passages)) {
      [member, p] = each2;
      at = member.between(p.entry, p.exit);
      if (at === null) {
        return located;
      }
      solved.push(at);
    }
    better = newton__settle(system, solved, state.level, COARSE);
    if (better === null) {
      break;
    }
    located = Object.assign(Object.create(Object.getPrototypeOf(located)), located, {
      settled: better,
      passages: better.passages,
      level: better.level,
    });
    pairs = $zip(better.passages, state.passages);
    if ($maxOf([...pairs].map(([a, b]) => Math.abs(Math.log(a.exit / b.exit)))) < _SAME) {
      break;
    }
  }
  return located;
}

/** Return the train with a little give in its held speeds, where laws hold the belt. */
export function locate___eased(system, give) {
  if (
    ![...$zip(system.members, system.lines)].some(([m, line]) => m.holds && line.motor === null)
  ) {
    return system;
  }
  let lines = [
    ...[...system.lines].map((line) =>
      line.motor === null
        ? Object.assign(Object.create(Object.getPrototypeOf(line)), line, {
            give: give / system.torque_scale,
          })
        : line,
    ),
  ];
  return Object.assign(Object.create(Object.getPrototypeOf(system)), system, { lines: lines });
}

export function locate___same(a, b) {
  let pairs = $zip(a.passages, b.passages);
  return [...pairs].every(([x, y]) => Math.abs(x.exit / y.exit - 1.0) < 1e-6);
}

/** Return the levels found by a search, the states there, and starts that led to none. */
export function locate___states(system, search, softening, tol) {
  let found, levels, miss, start, w;
  if (softening) {
    levels = search.all_solutions();
  } else {
    [w, miss] = search.solution(0.0001);
    levels = Math.abs(miss) < 0.001 ? [w] : [];
  }
  let states = [];
  let failed = [];
  for (const each1 of levels) {
    w = each1;
    start = [...search.follow(search.level(w)).passages];
    found = newton__settle(system, start, search.level(w), tol);
    if (found === null) {
      failed.push(start);
    } else if (![...states].some((other) => locate___same(found, other))) {
      states.push(found);
    }
  }
  return [levels, states, failed];
}

/** Return what becomes of a state of the eased train as the give goes. */
export function locate___stiffened(system, state) {
  let found, less;
  let give = _GIVE;
  let factor = _LESS;
  let now = state;
  while (give > 0.0) {
    less = give > _LEAST_GIVE ? factor * give : 0.0;
    found = newton__settle(locate___eased(system, less), now.passages, now.level);
    if (found !== null) {
      give = less;
      now = found;
      factor = max(factor * factor, _LESS);
    } else if (less > 0.0 && factor < 0.97) {
      factor = Math.sqrt(factor);
    } else {
      return null;
    }
  }
  return now;
}

/** Return which drives slip. */
export function locate__away(names, indices) {
  return (
    "" +
    "Gross slip on " +
    $text(locate___listed(names, indices)) +
    ": no creep gives enough friction."
  );
}

/** Return the failure of a train, with the drives that break away. */
export function locate___broken(system, names, passages, level) {
  let i, known, member, p;
  let fallen = [];
  let exact = [];
  for (const each1 of $enumerate($zip(system.members, passages))) {
    [i, [member, p]] = each1;
    known = p;
    if (Number.isNaN(p.place)) {
      known = member.between(p.entry, p.exit);
      if (known === null) {
        fallen.push(i);
      }
    } else if (!member.rises(p)) {
      fallen.push(i);
    }
    exact.push(known === null ? p : known);
  }
  let status = BREAKAWAY;
  let reason = "";
  if (fallen.length > 0) {
    reason = locate__away(names, fallen);
  } else if (Math.abs(passages.at(-1).exit / system.exit - 1.0) > 0.001) {
    fallen = [...$range(names.length)];
    reason =
      "" + "The friction of " + $text(names.join(" and ")) + " together cannot transmit the load.";
  } else {
    status = UNSOLVED;
  }
  return new Located(status, reason, [...exact], level, undefined, undefined, [...fallen]);
}

/** Return the stable state of a train whose drums turn as given. */
export function locate__locate(system, names, softening) {
  let failed, levels, search, start, states, stiff, tol;
  let fine = softening ? FINE : SHARP;
  const found1 = system__guessed(system);
  let passages = found1[0];
  let level = found1[1];
  let state = softening ? null : newton__settle(system, passages, level, fine);
  if (state !== null) {
    return locate___as_told(system, locate___chosen(system, names, [state]));
  }
  let eased = locate___eased(system, _GIVE);
  for (const each2 of [COARSE, SHARP]) {
    tol = each2;
    search = new Search(eased, tol);
    const found3 = locate___states(eased, search, softening, fine);
    levels = found3[0];
    states = found3[1];
    failed = found3[2];
    if (levels.length > 0 && failed.length === 0) {
      break;
    }
  }
  if (eased !== system) {
    stiff = [...states].map((state) => locate___stiffened(system, state));
    states = [...stiff].filter((s) => s !== null);
  }
  if (levels.length === 0) {
    level = search.level(search.strongest());
    return locate___broken(system, names, [...search.follow(level).passages], level);
  }
  if (states.length === 0) {
    level = search.level(levels[0]);
    start = failed.length > 0 ? failed[0] : [...search.follow(level).passages];
    return locate___broken(system, names, start, level);
  }
  return locate___as_told(system, locate___chosen(system, names, states));
}

/** Return tensions that meet the last one exactly; what is idle but for rounding is idle. */
export function turning__rounded(pairs, exit_, runs) {
  let last = pairs.length - 1;
  let exits = [...pairs].map((at) =>
    Math.abs(at.entry - at.exit) > _IDLE * at.entry ? at.exit : at.entry,
  );
  exits[last] = exit_;
  if (last > 0 && Math.abs(pairs[last].entry - exit_) <= _IDLE * exit_) {
    exits[last - 1] = exit_ - runs[last - 1];
  }
  let entries = [
    pairs[0].entry,
    ...[...$zip(exits.slice(0, -1), runs.slice(0, -1))].map(([b, run]) => b + run),
  ];
  return [...$zip(entries, exits)].map(([a, b]) => new Pair(a, b));
}

/** Return tensions between the ends that are asked for, the load divided as between others. */
export function turning__as_asked(pairs, entry, exit_, runs) {
  let pulls = [...pairs].map((at) => at.entry - at.exit);
  let total = $sum(pulls);
  if (total === 0.0) {
    return [...pairs];
  }
  let part = (entry - exit_ + $sum(runs)) / total;
  let found = train__along(
    entry,
    exit_,
    runs,
    [...pulls].map((pull) => part * pull),
  );
  return $minOf([...found].map((at) => min(at.entry, at.exit))) > 0.0 ? found : [...pairs];
}

/** Tensions of all pulleys, from what is given: their pulls, or what turns their drums. */
export function in_page_train__divided(system, names, softening, pulls, speed, reference, belt) {
  let light, pairs;
  let lift = belt.lift;
  let stiffness = belt.stiffness;
  let found = null;
  if (pulls.length > 0) {
    pairs = train__along(belt.entry, belt.exit, system.runs, pulls);
  } else {
    found = locate__locate(system, names, softening);
    pairs = [...found.passages].map((at) => new Pair(at.entry + lift, at.exit + lift));
    if (found.status === SOLVED) {
      pairs = turning__rounded(pairs, belt.exit, system.runs);
    } else if (found.status === BREAKAWAY) {
      pairs = turning__as_asked(pairs, belt.entry, belt.exit, system.runs);
    }
  }
  let at_first = speed;
  if (found !== null && reference === reference) {
    light = 1.0 + (pairs[0].entry - lift) / (stiffness + lift);
    at_first = reference * Math.exp(-found.level) * light;
  }
  let first = 1.0 + pairs[0].entry / stiffness;
  let speeds = [...pairs].map((at) => (at_first * (1.0 + at.entry / stiffness)) / first);
  return new Divided(pairs, found, speeds, belt);
}

export function in_page_train___nip(member, arc, nominal, lift) {
  let found = arc.summary;
  return new Nip(
    found.entry_tension,
    found.effective_tension,
    found.entry_creep_ratio,
    member.radius - member.offset,
    member.squeeze * (found.entry_tension - lift),
    member.offset,
    nominal,
  );
}

/** Speed of a belt over its speed at another place, (1 + T/EA)/(1 + T_0/EA) [-]. */
export function pitch__strain_ratio(tension, reference, stiffness) {
  return (1.0 + tension / stiffness) / (1.0 + reference / stiffness);
}

/** R - delta + e, at which the belt pulls and runs [m]. */
export function pitch__pitch_radius(radius, compression, offset) {
  return radius - compression + offset;
}

/** Return how a drum turns against the first one. */
export function turning__turning(first, at, stiffness, total, belt_speed) {
  let a = at.entry;
  let a1 = first.entry;
  let g = at.creep_ratio;
  let g1 = first.creep_ratio;
  let leaves = g < 1.0 ? 1.0 - g : NaN;
  let ratio = (pitch__strain_ratio(a, a1, stiffness) * (1.0 - g1)) / leaves;
  let arm = pitch__pitch_radius(at.radius, at.compression, at.offset);
  let arm1 = pitch__pitch_radius(first.radius, first.compression, first.offset);
  let surface = belt_speed / leaves;
  let pull = g === g ? at.pull : NaN;
  return new Turning(
    total !== 0.0 ? pull / total : NaN,
    ratio,
    (a - a1) / stiffness,
    g - g1,
    at.compression / at.radius - first.compression / first.radius,
    (1.0 + first.offset / first.radius) / (1.0 + at.offset / at.radius) - 1.0,
    (((ratio * arm1) / arm) * at.radius) / first.radius,
    surface,
    surface / arm,
    (((ratio * arm1) / arm) * at.nominal) / first.nominal,
    pull * arm,
    surface * at.pull,
  );
}

/** Return where a motor works at a torque on its drum and a speed of it [N m, rad/s]. */
export function turning__motor_point(motor, torque, rotation) {
  let eta;
  let load = motor.load(torque);
  let each = load * motor.rated_torque;
  let gear_speed = rotation * motor.gear_ratio;
  let speed = motor.motor_speed(load, gear_speed);
  let shaft = motor.count * each * speed;
  let electrical = NaN;
  if (motor.motor_efficiency !== null) {
    eta = motor.motor_efficiency;
    electrical = shaft >= 0.0 ? shaft / eta : shaft * eta;
  }
  return new MotorPoint(
    load,
    each,
    speed,
    each * speed,
    gear_speed,
    electrical,
    electrical - shaft,
    motor.count * each * (speed - gear_speed) + 0.0,
    motor.count * each * gear_speed - torque * rotation,
  );
}

/** Largest relative miss between what leaves a pulley and what the next one takes [-]. */
export function turning__tension_error(leaving, runs, entries, exit_) {
  let taken = [...entries.slice(1), exit_];
  return $maxOf(
    [...$zip(leaving, runs, taken)].map(([out, run, a]) => Math.abs((out + run) / a - 1.0)),
  );
}

/** Largest miss of the speeds or torques asked for, from the arcs alone [-]; lift is m v^2. */
export function turning__speed_error(system, nips, torques, level, lift) {
  let asked, entry, i, left, line;
  let misses = [];
  for (const each1 of $enumerate(system.lines)) {
    [i, line] = each1;
    if (line.follows) {
      asked = line.ratio * torques[line.master];
      misses.push(Math.abs(torques[i] - asked) / system.torque_scale);
    } else {
      entry = nips[i].entry - lift;
      left = -Math.log1p(-nips[i].creep_ratio) + system.members[i].stretch_log(entry);
      misses.push(Math.abs(left - line.log_speed(torques[i]) - level));
    }
  }
  return $maxOf(misses);
}

/** Return two rotation speeds [rad/s] in as many digits as tell them apart, or alike. */
export function turning___apart(one, other) {
  let digits, told;
  for (const each1 of [4, 5, 6, 4]) {
    digits = each1;
    told = [...[...[one, other]].map((of) => display(of, "rotation_speed", "si", digits))];
    if (told[0] !== told[1]) {
      break;
    }
  }
  return [told[0], told[1]];
}

/** Say how a motor would have to leave its curve, or nothing; the drum turns at `rotation`. */
export function turning__beyond_motor(name, rotation, motor, point) {
  let end, means, top, turns;
  let [low, high] = motor.limits();
  let rounding = 1e-9;
  if (point.motor_load < low - rounding) {
    end = low / (low >= 0.0 ? motor.gear_efficiency : 1.0 / motor.gear_efficiency);
    const found1 = turning___apart(rotation, motor.drum_speed(end * motor.drum_torque));
    turns = found1[0];
    top = found1[1];
    means =
      low === 0.0
        ? "it cannot brake"
        : "" + "it brakes with " + $told(-low, false, 3, "g") + " rated torques";
    if (turns === top) {
      return (
        "" +
        "The belt drives pulley " +
        $text(name) +
        " at " +
        $text(turns) +
        ", where its motor ends: " +
        $text(means) +
        "."
      );
    }
    return (
      "" +
      "The belt drives pulley " +
      $text(name) +
      " at " +
      $text(turns) +
      ", faster than its motor allows: " +
      $text(top) +
      " at most, where " +
      $text(means) +
      "."
    );
  }
  if (point.motor_load > high + rounding) {
    turns = display(rotation, "rotation_speed", "si", GIVEN_DIGITS);
    return (
      "" +
      "The motor of " +
      $text(name) +
      " needs " +
      $told(point.motor_load, false, 3, "g") +
      " times its rated torque, its curve ends at " +
      $told(high, false, 3, "g") +
      "; its pulley turns at " +
      $text(turns) +
      "."
    );
  }
  return "";
}

/** Return d share_i / d ln(speed of drive j) [-]; nan where that is not known. */
export function turning__sensitivity(system, located, passages) {
  if (located !== null && located.settled !== null) {
    return located.settled.linear.share_slopes(system.pull);
  }
  let count = passages.length;
  let known = [...passages].filter((at) => at !== null);
  if (known.length < count) {
    return [...$range(count)].map((_) => $repeated([NaN], count));
  }
  let rigid = Object.assign(Object.create(Object.getPrototypeOf(system)), system, {
    lines: [...[...$range(count)].map((_) => new Line())],
  });
  return newton__linearized(rigid, known)[0].share_slopes(system.pull);
}

/** What a train has beside its arcs, these solved for their tensions. */
export function in_page_train__told(system, names, of, arcs, nominal, motors) {
  let at, beyond, entries, i, leaving, motor, name, point;
  let located = of.located;
  let fallen = in_page_train__fallen_of(of);
  let lift = of.belt.lift;
  let nips = [...$zip(system.members, arcs, nominal)].map(([at, arc, diameter]) =>
    in_page_train___nip(at, arc, diameter, lift),
  );
  for (const each1 of fallen) {
    i = each1;
    nips[i] = Object.assign(Object.create(Object.getPrototypeOf(nips[i])), nips[i], {
      creep_ratio: NaN,
    });
  }
  let failed = located !== null && located.status !== SOLVED;
  let turnings = [...$zip(nips, of.belt_speeds)].map(([nip, speed]) =>
    turning__turning(nips[0], nip, of.belt.stiffness, system.pull, speed),
  );
  let points = [...$zip(motors, turnings)].map(([motor, at]) =>
    motor === null ? null : turning__motor_point(motor, at.drum_torque, at.rotation_speed),
  );
  let stuck = [...$enumerate(arcs)]
    .filter(([i, arc]) => !arc.solved || fallen.includes(i))
    .map(([i, arc]) => i);
  let passages = [...arcs].map((_) => null);
  if (stuck.length === 0) {
    passages = [...$zip(system.members, arcs)].map(([m, arc]) =>
      m.between(arc.summary.entry_tension - lift, arc.summary.exit_tension - lift),
    );
  }
  let torques = [...turnings].map((at) => at.drum_torque);
  let tension_miss = NaN;
  if (stuck.length === 0 && (located === null || located.settled !== null)) {
    leaving = [...arcs].map((arc) => arc.profile.tension[arc.profile.tension.length - 1]);
    entries = [...arcs].map((arc) => arc.summary.entry_tension);
    tension_miss = turning__tension_error(leaving, system.runs, entries, of.belt.exit);
  }
  let speed_miss = failed ? NaN : 0.0;
  if (located !== null && !failed) {
    speed_miss = turning__speed_error(system, nips, torques, located.level, lift);
  }
  let status = SOLVED;
  let reason = "";
  if (located !== null && failed) {
    status = located.status;
    reason = located.reason;
  } else if (stuck.length > 0) {
    status = BREAKAWAY;
    reason = locate__away(names, stuck);
  }
  for (const each2 of $zip(names, turnings, motors, points)) {
    [name, at, motor, point] = each2;
    beyond = "";
    if (status === SOLVED && motor !== null && point !== null) {
      beyond = turning__beyond_motor(name, at.rotation_speed, motor, point);
    }
    if (beyond !== "") {
      status = BEYOND_MOTOR;
      reason = beyond;
    }
  }
  return new Told(
    status,
    reason,
    turnings,
    points,
    turning__sensitivity(system, located, passages),
    located === null ? [] : located.other_splits,
    tension_miss,
    speed_miss,
  );
}

/** Return the cell of the value [SI] of a quantity of the glossary. */
export function sheet__named(name, value) {
  return quantity(value, term(name).dimension, RESULT_DIGITS, name);
}

/** Whether an arc hands nothing over: its pulley is not driven. */
export function rule__idle(arc) {
  return pull__idles(arc.entry_tension, arc.exit_tension);
}

export function train_words___shares(case_) {
  let pulls;
  if ([...case_.members].some((m) => Number.isNaN(m.share))) {
    pulls = [...case_.members]
      .map(
        (m) =>
          "" +
          $text(m.name) +
          " " +
          $text(sheet__named("effective_tension", m.arc.effective_tension)),
      )
      .join(", ");
    return "" + "nothing is shared; the Te of the drives is " + $text(pulls);
  }
  return [...case_.members]
    .map((m) =>
      rule__idle(m.arc.arc)
        ? "" + $text(m.name) + " is not driven"
        : "" + $text(m.name) + " takes " + $text(percent(m.share)),
    )
    .join(", ");
}

/** Pull of drives against each other, 0 where they work together [N]. */
export function numbers__pull_against(pulls) {
  let small = SMALL_PULL * $maxOf([...pulls].map((pull) => Math.abs(pull)));
  if (!($minOf(pulls) < -small && $maxOf(pulls) > small)) {
    return 0.0;
  }
  return min($sum([...pulls].map((p) => max(p, 0.0))), $sum([...pulls].map((p) => max(-p, 0.0))));
}

export function train_words___against(case_) {
  return numbers__pull_against([...case_.members].map((m) => m.arc.effective_tension));
}

/** Whether drives work against each other. */
export function train_words___fights(case_) {
  return train_words___against(case_) > 0.0;
}

export function train_words___fight(case_) {
  let loaded = [...case_.members].filter((m) => !rule__idle(m.arc.arc));
  let forward = [...loaded].filter((m) => m.arc.effective_tension > 0.0).map((m) => m.name);
  let back = [...loaded].filter((m) => m.arc.effective_tension < 0.0).map((m) => m.name);
  let lost = train_words___against(case_);
  let drive = forward.length === 1 ? "drives" : "drive";
  let brake = back.length === 1 ? "brakes" : "brake";
  return (
    "" +
    "The drives oppose each other: " +
    $text(forward.join(" and ")) +
    " " +
    $text(drive) +
    " while " +
    $text(back.join(" and ")) +
    " " +
    $text(brake) +
    ", by " +
    $text(sheet__named("effective_tension", lost)) +
    "."
  );
}

/** Return a term in percent, without a sign where nothing of it is shown. */
export function train_words___signed(term) {
  let text = "" + $told(100.0 * term, true, 3, "f");
  return text === "+0.000" || text === "-0.000" ? "0" : text;
}

/** Say whether the rule of the slightly faster second drive holds. */
export function train_words___rule(ratio) {
  let applies = ratio > 0.0 ? "applies" : "does not apply";
  return "" + ", and the rule of the slightly faster second drive " + $text(applies);
}

/** Say which of the terms makes a drum faster or slower. */
export function train_words___reason(m, ratio) {
  let way;
  let others = m.contraction_term + m.compression_term + m.creep_term;
  if (m.arc.arc.pitch_offset !== null && Math.abs(m.thickness_term) > Math.abs(others)) {
    way = m.thickness_term < 0.0 ? "farther out" : "closer in";
    return "" + "its tension member runs " + $text(way) + " than on the first pulley";
  }
  let shorter = m.contraction_term + m.compression_term + m.thickness_term;
  if (ratio > 0.0 && m.creep_term > 0.0 && shorter <= 0.0) {
    return "its extra creep outweighs contraction and compression";
  }
  if (ratio <= 0.0 && 0.0 < m.creep_term && shorter < 0.0) {
    return "contraction and compression outweigh its extra creep";
  }
  if (shorter < 0.0) {
    return "contraction, compression and a smaller creep all require it";
  }
  return "the belt is as tight there as at the first drive, or tighter";
}

/** Say how fast a drum turns against the first one, and which term decides. */
export function train_words___speed_sentence(case_, m) {
  let first = case_.members[0].name;
  let ratio = m.drum_ratio - 1.0;
  let asked = case_.case.pulls_given;
  let verb = asked ? "must turn" : "turns";
  let way = ratio > 0.0 ? "faster" : "slower";
  let terms =
    "" +
    "belt contraction " +
    $text(train_words___signed(m.contraction_term)) +
    " %, lagging compression " +
    $text(train_words___signed(m.compression_term)) +
    " %, extra creep " +
    $text(train_words___signed(m.creep_term)) +
    " %";
  if (m.arc.arc.pitch_offset !== null) {
    terms += "" + ", belt thickness " + $text(train_words___signed(m.thickness_term)) + " %";
  }
  if (Math.abs(ratio) < _AS_FAST) {
    return (
      "" +
      $text(m.name) +
      " " +
      $text(verb) +
      " as fast as " +
      $text(first) +
      ", at equal diameters: " +
      $text(terms) +
      "."
    );
  }
  let rule = asked && m.creep_term > 0.0 ? train_words___rule(ratio) : "";
  return (
    "" +
    $text(m.name) +
    " " +
    $text(verb) +
    " " +
    $told(Math.abs(100.0 * ratio), false, 3, "f") +
    " % " +
    $text(way) +
    " than " +
    $text(first) +
    ", at equal diameters (" +
    $text(terms) +
    "): " +
    $text(train_words___reason(m, ratio)) +
    $text(rule) +
    "."
  );
}

/** Return what the speed of a drum [m] misses without the thickness of the belt. */
export function turning__surface_sentence(diameter) {
  let shift = (100.0 * USUAL_OFFSET) / (0.5 * diameter);
  let [belt, drum] = [...[2.0 * USUAL_OFFSET, diameter]].map((d) => quantity(d, "length"));
  return (
    "" +
    "Pulley speeds are those at the lagging surface: " +
    $text(belt) +
    " of belt on a pulley of " +
    $text(drum) +
    " would lower them by " +
    $told(shift, false, 2, "f") +
    " %."
  );
}

/** Say that the speeds of drums are without the thickness of the belt, if that is not known. */
export function* train_words__surface_speeds(case_) {
  let m;
  for (const each1 of case_.members) {
    m = each1;
    if (m.arc.arc.pitch_offset === null) {
      yield turning__surface_sentence(m.arc.arc.diameter);
      return;
    }
  }
}

/** Tensions at both ends of a train, in the digits that loads are told apart by. */
export function train_words___load(case_) {
  let last = case_.members[case_.members.length - 1];
  return (
    "" +
    $told(case_.members[0].arc.entry_tension, false, 6, "e") +
    " " +
    $told(last.arc.exit_tension, false, 6, "e")
  );
}

/** Share that a trim of 0.1 % moves at most of a load, in any condition [-]; 0 if not known. */
export function train_words___steepest(of, cases, drive) {
  let one, slope, solved;
  let most = 0.0;
  for (const each1 of cases) {
    one = each1;
    solved = one.status === SOLVED && train_words___load(one) === train_words___load(of);
    slope = solved ? Math.abs(one.share_per_trim(drive)) : 0.0;
    if (Number.isFinite(slope)) {
      most = max(most, slope);
    }
  }
  return most;
}

/** How well speeds must match for a tolerated share, rounded down [%]. */
export function train_words___needed(slope) {
  let needed = (0.1 * _TOLERATED) / slope;
  let step = 10.0 ** (Math.floor(Math.log10(needed)) - 1);
  return "" + $told(Math.floor(needed / step + 1e-9) * step, false, 2, "g");
}

/** Say how much load a trim moves, in the condition where it moves most. */
export function* train_words___matching(case_, cases) {
  let how, i, m, slope;
  let own_way = case_.case.on_motors;
  for (const each1 of $enumerate(case_.members)) {
    [i, m] = each1;
    slope = train_words___steepest(case_, cases, i);
    if (i === 0 || slope === 0.0 || rule__idle(m.arc.arc)) {
      continue;
    }
    how = own_way ? " with its motors as they are" : "";
    yield "" +
      "A trim of 0.1 % on " +
      $text(m.name) +
      " moves " +
      $text(percent(slope, 2)) +
      " of the load" +
      $text(how) +
      ": for a share within " +
      $text(percent(_TOLERATED)) +
      ", speeds and diameters must match within " +
      $text(train_words___needed(slope)) +
      " %.";
  }
}

/** Say what is lost between the mains and the drums, and what the mains give. */
export function* train_words___motor_losses(case_) {
  let lost, mains, name, tail, values, what;
  let points = [...case_.members].filter((m) => m.motor !== null).map((m) => m.motor);
  let turned = $sum([...points].map((p) => Math.abs(p.motor_power)));
  let parts = [];
  for (const each1 of [
    ["coupling_loss", "fluid couplings"],
    ["gear_loss", "gears"],
    ["motor_loss", "motors"],
  ]) {
    [name, what] = each1;
    values = [...points].map((p) => p[name]);
    lost = $sum([...values].filter((v) => !Number.isNaN(v)));
    if (lost > 1e-9 * turned) {
      parts.push("" + $text(sheet__named(name, lost)) + " in the " + $text(what));
    }
  }
  if (parts.length === 0) {
    return;
  }
  let electrical = $sum([...points].map((p) => p.electrical_power));
  if (Number.isNaN(electrical)) {
    tail = "; motor losses need motor_efficiency";
  } else {
    mains = sheet__named("electrical_power", electrical);
    tail = "" + "; the motors take " + $text(mains) + " from the mains";
  }
  let are = parts.length === 1 ? "is" : "are";
  yield "" +
    "Between mains and pulleys " +
    $text(parts.join(", ")) +
    " " +
    $text(are) +
    " lost" +
    $text(tail) +
    ".";
}

/** Tell of the load case that governs: who carries what, how the drums turn, what is lost. */
export function* train_words__case_sentences(case_, cases) {
  let listed, m;
  if (case_.status !== SOLVED) {
    yield "" + "Load case " + $text(case_.case.name) + ": " + $text(case_.reason);
    return;
  }
  yield "" +
    "Load case " +
    $text(case_.case.name) +
    ": " +
    $text(train_words___shares(case_)) +
    ".";
  if (case_.other_splits.length > 0) {
    listed = [...case_.other_splits]
      .map((split) => [...split].map((s) => percent(s)).join(", "))
      .join("; ");
    yield "" +
      "Friction falls with slip here: the same speeds are also met by the shares " +
      $text(listed) +
      ", which are unstable; the stable split is shown.";
  }
  if (train_words___fights(case_)) {
    yield train_words___fight(case_);
  }
  if (case_.members.length > 1) {
    for (const each1 of case_.members.slice(1)) {
      m = each1;
      if (!rule__idle(m.arc.arc)) {
        yield train_words___speed_sentence(case_, m);
      }
    }
    yield* train_words__surface_speeds(case_);
    yield* train_words___matching(case_, cases);
  }
  let loss = percent(case_.loss_ratio);
  let power = Number.isNaN(case_.power_loss)
    ? ""
    : "" + " " + $text(sheet__named("power_loss", case_.power_loss)) + ",";
  yield "" + "Creep costs" + $text(power) + " " + $text(loss) + " of the power.";
  yield* train_words___motor_losses(case_);
}

/** Tell of another load case who carries what. */
export function* train_words__short_sentences(case_) {
  if (case_.status !== SOLVED) {
    yield "" + "Load case " + $text(case_.case.name) + ": " + $text(case_.reason);
    return;
  }
  let tail = train_words___fights(case_) ? ", the drives working against each other" : "";
  yield "" +
    "Load case " +
    $text(case_.case.name) +
    ": " +
    $text(train_words___shares(case_)) +
    $text(tail) +
    ".";
}

export function train_sheet___shown(value, name, digits) {
  return quantity(value, term(name).dimension, digits);
}

/** Return a small ratio as percent with its sign: ``-0.3121 %``. */
export function train_sheet__signed(ratio) {
  return fixed(ratio, 4, "percent signed");
}

export function train_sheet___share(m) {
  return rule__idle(m.arc.arc) && !Number.isNaN(m.share) ? "not driven" : percent(m.share);
}

/** Return the rise of tension before each pulley, where there is any. */
export function train_sheet___run_rows(case_) {
  if (case_.case.runs.length === 0) {
    return [];
  }
  let entry = term("run");
  let texts = [NONE, ...[...case_.case.runs].map((run) => sheet__named("run", run))];
  return [new Row(entry.title, texts, entry.symbol, undefined, "run")];
}

/** Return what there is to tell between mains and drum: nothing that is the same or unknown. */
export function train_sheet___motor_extras(points) {
  let names = [];
  if ([...points].some((p) => p.gear_speed !== p.motor_speed)) {
    names.push("gear_speed");
    names.push("coupling_loss");
  }
  if ([...points].some((p) => Math.abs(p.gear_loss) > _ROUNDING * Math.abs(p.motor_power))) {
    names.push("gear_loss");
  }
  if (![...points].every((p) => Number.isNaN(p.electrical_power))) {
    names.push("motor_loss");
    names.push("electrical_power");
  }
  return names;
}

export function train_sheet___motor_rows(members) {
  let points = [...members].filter((m) => m.motor !== null).map((m) => m.motor);
  if (points.length === 0) {
    return [];
  }
  const of = (name, show) => {
    let texts = [...members].map((m) => (m.motor !== null ? show(m.motor[name]) : "follows"));
    return new Row(term(name).title, [...texts], term(name).symbol, undefined, name);
  };
  const told = (name) => {
    return of(name, (value) => sheet__named(name, value));
  };
  return [
    of("motor_load", percent),
    told("motor_power"),
    told("motor_torque"),
    of("motor_speed", (value) => quantity(value, "rotation_speed", GIVEN_DIGITS)),
    ...[...train_sheet___motor_extras(points)].map((name) => told(name)),
  ];
}

/** Return a trim as percent of nominal: ``99.655 %``. */
export function train_sheet__trim_text(trim) {
  return fixed(trim, 3, "percent fixed");
}

export function key_figures___stands_in(place, figure) {
  let elsewhere = figure.elsewhere;
  return !elsewhere.includes(place);
}

/** Return the key figures that stand in a place of their own there, in their order. */
export function key_figures__key_figures(place) {
  return [...KEY_FIGURES].filter((figure) => key_figures___stands_in(place, figure));
}

/** Whether a key figure is a row of its own: tensions stand above, a margin may be unknown. */
export function train_sheet___has_key_row(members, name) {
  if (name === "entry_tension" || name === "exit_tension" || name === "effective_tension") {
    return false;
  }
  let searched = name === "creep_limit_margin";
  return !(searched && [...members].every((m) => Number.isNaN(figure_of(m.arc, name))));
}

export function train_sheet___creep_row(case_) {
  let creep, m, part;
  let texts = [];
  for (const each1 of case_.members) {
    m = each1;
    creep = m.arc.exit_creep;
    part = "" + " (" + $text(percent(m.arc.share_of_limit)) + ")";
    texts.push(
      "" + $text(sheet__named("exit_creep", creep)) + $text(Number.isNaN(creep) ? "" : part),
    );
  }
  let over = [...case_.members].some((m) => !m.arc.within_creep_limit);
  let entry = term("exit_creep");
  let level = over ? ATTENTION : null;
  let note = "and as a part of the limit";
  return new Row(entry.title, [...texts], entry.symbol, note, "exit_creep", level);
}

/** Return what creep costs; of a drum that is not driven nothing but rounding is left. */
export function train_sheet___lost(m) {
  let loss = m.arc.energy.power_loss;
  return sheet__named("power_loss", rule__idle(m.arc.arc) && !Number.isNaN(loss) ? 0.0 : loss);
}

export function train_sheet___loss_note(case_) {
  if (Number.isNaN(case_.loss_ratio)) {
    return "";
  }
  let ratio = "" + $text(percent(case_.loss_ratio)) + " of the power";
  if (Number.isNaN(case_.power_loss)) {
    return "" + "together " + $text(ratio);
  }
  return (
    "" + "together " + $text(sheet__named("power_loss", case_.power_loss)) + ", " + $text(ratio)
  );
}

/** Return the row of a key figure of the drives. */
export function train_sheet___key_row(case_, name) {
  let texts;
  if (name === "exit_creep") {
    return train_sheet___creep_row(case_);
  }
  let entry = term(name);
  let members = case_.members;
  if (name === "power_loss") {
    texts = [...[...members].map((m) => train_sheet___lost(m))];
    return new Row(entry.title, texts, entry.symbol, train_sheet___loss_note(case_), name);
  }
  let values = [...[...members].map((m) => sheet__named(name, figure_of(m.arc, name)))];
  return new Row(entry.title, values, entry.symbol, undefined, name);
}

export function train_sheet___sensitivity_row(case_) {
  let texts = [...$range(case_.members.length)].map((i) =>
    case_.sensitivity[i][i] !== 0.0 ? percent(case_.share_per_trim(i), 2) : NONE,
  );
  let entry = term("share_sensitivity");
  return new Row(entry.title, [...texts], entry.symbol, "of the load", "share_sensitivity");
}

export function train_sheet___precision(case_) {
  let miss = max(max(case_.tension_error, case_.speed_error), TRAIN_BALANCE);
  return (
    "" +
    "Tensions, speeds and torques of the drives agree within " +
    $told(miss, false, 0, "e") +
    " of their size."
  );
}

export function train_sheet___names(case_) {
  return [...[...case_.members].map((m) => m.name)];
}

/** Return how the drives share one load case, and the speeds that go with it. */
export function train_sheet__case_table(case_) {
  let members = case_.members;
  const row = (name, of, note) => {
    return new Row(
      term(name).title,
      [...[...members].map((m) => of(m))],
      term(name).symbol,
      note,
      name,
    );
  };
  const told = (name, of) => {
    return row(name, (m) => sheet__named(name, of(m)), "");
  };
  const known = (name, of, digits) => {
    return row(name, (m) => train_sheet___shown(of(m), name, digits), "");
  };
  const small = (name, of, note) => {
    return row(name, (m) => train_sheet__signed(of(m)), note);
  };
  let thick = [];
  if ([...members].some((m) => m.arc.arc.pitch_offset !== null)) {
    thick = [small("thickness_term", (m) => m.thickness_term, "")];
  }
  let rows = [
    row("share", train_sheet___share, ""),
    told("effective_tension", (m) => m.arc.effective_tension),
    ...train_sheet___run_rows(case_),
    told("entry_tension", (m) => m.arc.entry_tension),
    told("exit_tension", (m) => m.arc.exit_tension),
    known("drum_power", (m) => m.drum_power, RESULT_DIGITS),
    known("drum_torque", (m) => m.drum_torque, RESULT_DIGITS),
    ...train_sheet___motor_rows(members),
    small("speed_ratio", (m) => m.speed_ratio - 1.0, "exactly"),
    small("contraction_term", (m) => m.contraction_term, "to first order"),
    small("creep_term", (m) => m.creep_term, "to first order"),
    small("compression_term", (m) => m.compression_term, "to first order"),
    ...thick,
    small("drum_ratio", (m) => m.drum_ratio - 1.0, "exactly, for equal diameters"),
    known("rotation_speed", (m) => m.rotation_speed, 6),
    row(
      "speed_trim",
      (m) => train_sheet__trim_text(m.speed_trim),
      "what a speed control is set to",
    ),
    ...[...key_figures__key_figures("drives")]
      .filter((f) => train_sheet___has_key_row(members, f.name))
      .map((f) => train_sheet___key_row(case_, f.name)),
    train_sheet___sensitivity_row(case_),
  ];
  let note = case_.status === SOLVED ? train_sheet___precision(case_) : case_.reason;
  return new Table(
    "" + "Drives: load case " + $text(case_.case.name),
    [...rows],
    train_sheet___names(case_),
    note,
    "drives",
  );
}

/** An arc that is held all along, much longer than l; None where it is not. */
export function passage___held(law, arc, ends) {
  let lag = collocation__lag_length(arc);
  let taken = collocation__held_stiffness(arc);
  const found1 = collocation__overrun_at(arc, ends.tension);
  let overrun = found1[0];
  let by_tension = found1[1];
  let leaving = ends.tension - taken * (overrun + ends.goal);
  let face = Object.assign(
    Object.create(Object.getPrototypeOf(meet__interface(law, arc))),
    meet__interface(law, arc),
    { slides: arc.side, rests: true },
  );
  let met = meet__held_along(face, arc, new Guess(ends.tension, leaving, ends.goal));
  if (met === null) {
    return null;
  }
  return new Passed(
    met,
    leaving,
    -overrun / lag,
    1.0 - taken * by_tension,
    -taken,
    -by_tension / lag,
    0.0,
  );
}

/** The arc found, or None where it has a rest arc and should not, or the other way round. */
export function passage___checked(face, arc, found) {
  let behind;
  if (face.rests) {
    behind = meet__with_rest(face, arc, found);
    return behind.done ? behind : null;
  }
  let met = meet__all_sliding(face, found);
  return face.slides * profile__entry_ratio(arc, met) < -ROUNDING ? null : met;
}

/** The arc from one nearly the same; None where it is another kind. */
export function passage___again(law, arc, ends, near, tol) {
  let finer, new_;
  let length = arc.radius * arc.wrap_angle;
  let at = near.course;
  let rests = near.face.rests;
  if (!near.done || at.place.at(-1) === 0.0 || near.face.slides * ends.goal < 0.0) {
    return null;
  }
  let face = Object.assign(
    Object.create(Object.getPrototypeOf(meet__interface(law, arc))),
    meet__interface(law, arc),
    { slides: near.face.slides, rests: rests },
  );
  if (!rests && at.place.at(-1) !== length) {
    at = Object.assign(Object.create(Object.getPrototypeOf(at)), at, {
      place: [...at.place].map((place) => (length / at.place.at(-1)) * place),
    });
  }
  let enough = tol === NO_MESH ? COARSELY : SETTLED;
  let found = collocation__converged(face, arc, ends, at, FIRST_STEPS, enough);
  for (let each1 = 0, end1 = tol < NO_MESH ? MESHES : 0; each1 < end1; each1++) {
    if (!found.done) {
      return null;
    }
    if ($maxOf(collocation__misfits(face, arc, found.course, CREEP)) <= tol) {
      break;
    }
    const found2 = collocation__meshed(face, arc, found.course, CREEP, tol);
    finer = found2[0];
    new_ = found2[2];
    if (!finer) {
      break;
    }
    found = collocation__converged(face, arc, ends, new_, LATER_STEPS, enough);
  }
  return found.done ? passage___checked(face, arc, found) : null;
}

/** The arc with a rest arc at its entry, or None: from a slide under the traction that holds. */
export function passage___behind_rest(face, arc, ends, tol) {
  let stress = traction__held_stress(face.law, ends.tension / (arc.width * arc.radius));
  let bend = 0.5 * collocation__compliance_of(arc) * arc.width * stress;
  let more = Math.abs(ends.goal) - arc.shear * stress;
  if (more <= 0.0) {
    return null;
  }
  let lag = collocation__lag_length(arc);
  let grows = lag === 0.0 ? 0.0 : (arc.shear * stress) / lag;
  let slide = (2.0 * more) / (grows + Math.sqrt(grows * grows + 4.0 * bend * more));
  slide = min(slide, arc.radius * arc.wrap_angle);
  let fall = min((arc.width * stress * slide) / ends.tension, LARGEST_FALL);
  let leaving = ends.tension * Math.exp(-arc.side * fall);
  let first = collocation__first_course(arc, slide, ends.tension, leaving, ends.goal);
  first = Object.assign(Object.create(Object.getPrototypeOf(first)), first, {
    ratio: collocation__ratio_behind_rest(face, arc, ends.tension)[0],
  });
  let found = collocation__solved(face, arc, ends, first, tol);
  return found.done ? passage___checked(face, arc, found) : null;
}

/** The arc from a guess of its tensions. */
export function passage___afresh(law, arc, ends, tol) {
  let behind;
  let face = meet__interface(law, arc);
  if (meet__may_rest(law, arc)) {
    behind = passage___behind_rest(
      Object.assign(Object.create(Object.getPrototypeOf(face)), face, {
        slides: arc.side,
        rests: true,
      }),
      arc,
      ends,
      tol,
    );
    if (behind !== null) {
      return behind;
    }
  }
  let p = ends.tension / (arc.width * arc.radius);
  let used = capacity__stress_about(face, p, 0.6 * ends.goal);
  let fall = min(((0.9 * used) / p) * arc.wrap_angle, LARGEST_FALL);
  let guess = new Guess(ends.tension, ends.tension * Math.exp(-arc.side * fall), ends.goal);
  let first = collocation__first_course(
    arc,
    arc.radius * arc.wrap_angle,
    guess.entry,
    guess.leaving,
    guess.creep,
  );
  let found = collocation__solved_or_softened(face, arc, ends, first, tol);
  let met = meet__all_sliding(face, found);
  if (!met.done) {
    met = meet__by_growth(law, arc, ends, guess, tol);
  }
  if (met.rest === 0.0 && met.face.slides * profile__entry_ratio(arc, met) < -ROUNDING) {
    return Object.assign(Object.create(Object.getPrototypeOf(met)), met, { done: false });
  }
  return met;
}

/** What an arc says, with its slopes. */
export function passage___told(arc, met) {
  let by_creep, end_slope, lag, overrun_slope, part, ratio, ratio_by_entry, taken;
  let [first, last, first_goal, last_goal] = met.slopes;
  let leaving = met.course.tension.at(-1);
  if (met.rest > 0.0) {
    overrun_slope = collocation__overrun_at(arc, met.entry)[1];
    lag = collocation__lag_length(arc);
    ratio_by_entry = lag === 0.0 ? 0.0 : -overrun_slope / lag;
    if (arc.shear > 0.0) {
      taken = collocation__held_stiffness(arc);
      end_slope = collocation__start_at(met.face, arc, met.course.tension[0])[1];
      part = (1.0 - taken * overrun_slope) / (1.0 + taken * end_slope);
    } else {
      part = 1.0;
    }
    by_creep = last_goal - (last * first_goal) / first;
    ratio = profile__entry_ratio(arc, met);
    return new Passed(met, leaving, ratio, (last / first) * part, by_creep, ratio_by_entry, 0.0);
  }
  by_creep = last_goal - (last * first_goal) / first;
  ratio_by_entry = 1.0 / first - collocation__compliance_of(arc);
  return new Passed(
    met,
    leaving,
    profile__entry_ratio(arc, met),
    last / first,
    by_creep,
    ratio_by_entry,
    -first_goal / first,
  );
}

/** Pass an arc with an entry tension [N] and an exit creep [m]. */
export function passage__passed(law, arc, entry, creep, near, tol) {
  let ends, held;
  [arc, ends] = [quantities__counted(arc, POINT_STEPS), new Ends(1.0, 0.0, entry, CREEP, creep)];
  if (arc.shear > 0.0 && meet__may_rest(law, arc)) {
    held = passage___held(law, arc, ends);
    if (held !== null) {
      return held;
    }
  }
  let met = near === null ? null : passage___again(law, arc, ends, near, tol);
  if (met === null) {
    met = passage___afresh(law, arc, ends, min(tol, AFRESH));
  }
  return passage___told(arc, met);
}

/** (T(0) - T(L))/sqrt(u(L)) of a short slide behind a rest arc where nothing shears [N/m^0.5]. */
export function passage__slide_slope(law, arc, entry) {
  let stress = traction__held_stress(law, entry / (arc.width * arc.radius));
  return Math.sqrt((2.0 * arc.width * stress) / collocation__compliance_of(arc));
}

export function newton___dot(one, other) {
  return $sum([...$zip(one, other)].map(([a, b]) => a * b));
}

/** Return x with |f(x)| <= tolerance, and f(x), of a rising function that tells its slope. */
export function roots__sloped_root(f, x, low, high, tolerance) {
  let above, before, below, new_, reach, slope, slow, way;
  [x, before, reach] = [min(max(x, low), high), 0.0, _REACH * (high - low)];
  below = above = false;
  let value = 0.0;
  for (let each1 = 0, end1 = 80; each1 < end1; each1++) {
    [value, slope] = f(x);
    if (Math.abs(value) <= tolerance || (x === high && value < 0.0) || (x === low && value > 0.0)) {
      break;
    }
    if (value < 0.0) {
      low = x;
      below = true;
    } else {
      high = x;
      above = true;
    }
    slow = Math.abs(value) > 0.5 * Math.abs(before) && 0.5 * Math.abs(before) > 0.0;
    way = value < 0.0 ? 1.0 : -1.0;
    new_ = slope > 0.0 ? x - value / slope : x + way * reach;
    if (below && above && (slow || !(low < new_ && new_ < high))) {
      new_ = 0.5 * (low + high);
    } else if (slow && !(below && above)) {
      new_ = x + way * max(reach, Math.abs(new_ - x));
      reach *= 2.0;
    }
    before = value;
    new_ = min(max(new_, low), high);
    if (new_ === x) {
      break;
    }
    x = new_;
  }
  return [x, value];
}

/** Return a root between a and b, where f has different signs; see `rising_root`. */
export function roots__bracketed_root(f, a, fa, b, fb, tolerance) {
  let i, value, x;
  let width = Math.abs(b - a);
  let kept = 0;
  for (let each1 = 0, end1 = 200; each1 < end1; each1++) {
    i = each1;
    x = (a * fb - b * fa) / (fb - fa);
    if (modulo(i, 3) === 2) {
      if (Math.abs(b - a) > 0.5 * width) {
        x = 0.5 * (a + b);
      }
      width = Math.abs(b - a);
    }
    if (!(min(a, b) < x && x < max(a, b))) {
      x = 0.5 * (a + b);
    }
    if (x === a || x === b) {
      break;
    }
    value = f(x);
    if (Math.abs(value) <= tolerance) {
      return [x, value];
    }
    if (value < 0.0 === fa < 0.0) {
      a = x;
      fa = value;
      fb *= kept === 1 ? 0.5 : 1.0;
      kept = 1;
    } else {
      b = x;
      fb = value;
      fa *= kept === -1 ? 0.5 : 1.0;
      kept = -1;
    }
  }
  let at_a = f(a);
  let at_b = f(b);
  return Math.abs(at_a) <= Math.abs(at_b) ? [a, at_a] : [b, at_b];
}

/** Return x with |f(x)| <= tolerance, and f(x), of a function that rises through its root. */
export function roots__rising_root(f, x, reach, low, high, tolerance) {
  let b, fb;
  x = min(max(x, low), high);
  let value = f(x);
  if (Math.abs(value) <= tolerance) {
    return [x, value];
  }
  let direction = value < 0.0 ? 1.0 : -1.0;
  let end = direction > 0.0 ? high : low;
  let a = x;
  let fa = value;
  while (true) {
    if (a === end) {
      return [a, fa];
    }
    b = direction > 0.0 ? min(a + reach, end) : max(a - reach, end);
    fb = f(b);
    if (Math.abs(fb) <= tolerance) {
      return [b, fb];
    }
    if (fa * fb < 0.0) {
      return roots__bracketed_root(f, a, fa, b, fb, tolerance);
    }
    [a, fa, reach] = [b, fb, 2.0 * reach];
  }
}

/** Whether the curve turns between two nodes on one side of zero, towards it and away. */
export function system___turns(a, b) {
  let way = a.miss > 0.0 ? 1.0 : -1.0;
  return way * b.miss > 0.0 && way * a.slope < 0.0 && 0.0 < way * b.slope;
}
