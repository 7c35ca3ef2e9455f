// @ts-nocheck
// Made from the Python source by `make kernel`: change that, not this.
import {
  Among,
  Range,
  answer__operating_point,
  compact__branch_of,
  compact__cell_of,
  compact__friction_at,
  compact__peak,
  compact__plateau_at,
  compact__segment_of,
  compact__tail,
  in_page__description_of,
  numbers__idles,
  numbers__usual,
  profile__read,
  quantities__jumps,
  summary__geometry_of,
} from "../static/kernel.js";
import { display, term } from "./told.js";
const max = (a, b) => (b > a ? b : a);
const min = (a, b) => (b < a ? b : a);
const copysign = (a, b) => (b < 0 || Object.is(b, -0) ? -Math.abs(a) : Math.abs(a));
const modulo = (a, b) => (a % b !== 0 && a % b < 0 !== b < 0 ? (a % b) + b : a % b);
const NOTHING = new Float64Array(0);
const zeros = (size) => (size > 0 ? new Float64Array(size) : NOTHING);

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
const $told = (x, sign, digits, how) => {
  let text = how === "f" ? x.toFixed(digits) : x.toExponential(digits - (how === "g"));
  const power = Number(text.split("e")[1]);
  if (how === "g" && power >= -4 && power < digits) text = x.toFixed(digits - 1 - power);
  if (how === "g" && text.includes(".")) text = text.replace(/\.?0+(?=e|$)/, "");
  text = text.replace(/e([+-])(\d)$/, "e$10$2");
  return sign && !text.startsWith("-") ? `+${text}` : text;
};
const $text = (x) => {
  if (typeof x !== "string") throw new TypeError(`${x} is no text`);
  return x;
};

export class Member {
  constructor(law, geometry, radius, stretch, squeeze) {
    this.law = law;
    this.geometry = geometry;
    this.radius = radius;
    this.stretch = stretch;
    this.squeeze = squeeze;
  }
  get holds() {
    return quantities__jumps(this.law);
  }
  arm(entry) {
    return this.radius - this.squeeze * entry;
  }
  stretch_log(entry) {
    return Math.log1p(entry * this.stretch) - Math.log1p((-this.squeeze * entry) / this.radius);
  }
  stretch_slope(entry) {
    return this.stretch / (1.0 + entry * this.stretch) + this.squeeze / this.arm(entry);
  }
  effort_at(ratio) {
    return Math.asinh(ratio / RATIO_SCALE);
  }
  passage(entry, effort, steps) {
    let gone, par, z;
    let side = effort >= 0.0 ? 1.0 : -1.0;
    if (this.holds) {
      par = this.parameters(entry, side);
      z = Math.abs(effort) - (this.rests ? 0.0 : 1.0);
      z = min(z, effort__largest_effort(this.law, par));
    } else {
      effort = min(max(effort, -_LARGEST_EFFORT), _LARGEST_EFFORT);
      if (this.parameters(entry, 1.0).kick !== 0.0) {
        side = 1.0;
      }
      par = this.parameters(entry, side);
      z = effort__effort_of(par, RATIO_SCALE * Math.sinh(effort));
    }
    let shot = effort__shoot_from(this.law, par, z, steps);
    if (!Number.isFinite(shot.log_tension)) {
      gone = copysign(_BEYOND, effort);
      return new Passage(entry, entry * Math.exp(-gone), effort, 0.01 * gone, gone, gone, false);
    }
    let ratio = this.holds ? shot.creep_ratio : RATIO_SCALE * Math.sinh(effort);
    return new Passage(
      entry,
      entry * Math.exp(shot.log_tension),
      effort,
      ratio,
      shot.creep,
      shot.slip,
      shot.stuck_length > 0.0,
    );
  }
  between(entry, exit_) {
    let side = entry >= exit_ ? 1.0 : -1.0;
    let geometry = Object.assign(
      Object.create(Object.getPrototypeOf(this.geometry)),
      this.geometry,
      { side: side },
    );
    let found = answer__operating_point(this.law, geometry, entry, exit_);
    if (found.outcome !== 0) {
      return null;
    }
    let told = profile__read(geometry, found.met, new Range(NaN, NaN, NaN));
    let effort = this.effort_at(told.creep_ratio);
    if (this.holds) {
      effort = this._effort_of(this.parameters(entry, side), told);
    }
    let held = told.stuck > 0.0;
    return new Passage(entry, exit_, effort, told.creep_ratio, told.creep, told.slip, held);
  }
  _effort_of(par, told) {
    let slide;
    let length = par.length;
    let zone = told.stuck;
    if (this.rests) {
      slide = (par.side * told.creep_ratio * length) / CREEP_SCALE;
      return par.side * (zone > 0.0 ? 1.0 - zone / length : 1.0 + max(slide, 0.0));
    }
    let end = stick__zone_end(this.law, par, length)[1];
    if (zone >= length) {
      return (par.side * told.creep) / end;
    }
    zone = zone > 0.0 ? zone : min(end / told.creep_ratio, length);
    return (par.side * length) / zone;
  }
  slopes(at, steps = 24) {
    let by_effort;
    let rise = at.entry * _STEP;
    let sign = at.effort >= 0.0 ? 1.0 : -1.0;
    let further = this.passage(at.entry, at.effort + sign * _STEP, steps);
    let tighter = this.passage(at.entry + rise, at.effort, steps);
    let here = this.passage(at.entry, at.effort, steps);
    if (this.holds) {
      by_effort = (further.ratio - here.ratio) / (sign * _STEP);
    } else {
      by_effort = RATIO_SCALE * Math.cosh(at.effort);
    }
    return new Slopes(
      (tighter.exit - here.exit) / rise,
      (further.exit - here.exit) / (sign * _STEP),
      this.holds ? (tighter.ratio - here.ratio) / rise : 0.0,
      by_effort,
    );
  }
  get rests() {
    let par = quantities__parameters_at(1.0, this.geometry);
    return this.holds && par.shear + par.onset === 0.0;
  }
  get compliance() {
    return this.geometry.compliance;
  }
  parameters(entry, side) {
    return quantities__parameters_at(
      entry,
      Object.assign(Object.create(Object.getPrototypeOf(this.geometry)), this.geometry, {
        side: side,
      }),
    );
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

export class Search {
  constructor(system, steps = 8) {
    this._system = system;
    this._steps = steps;
    let count = system.members.length;
    this._efforts = $repeated([NaN], count);
    this._slopes = $repeated([0.0], count);
    let share = system.pull / count;
    this._torques = [...system.members].map((member) => share * member.arm(system.entry));
    let leads = [...$enumerate(system.lines)]
      .filter(([i, line]) => line.follows && i < line.master)
      .map(([i, line]) => line.master);
    this._early = [...$enumerate(leads)]
      .filter(([i, lead]) => ![...leads.slice(0, i)].some((other) => lead === other))
      .map(([i, lead]) => lead);
    this._center = this._mean_level();
    this._w = NaN;
  }
  _mean_level() {
    let system = this._system;
    let tension = 0.5 * (system.entry + system.exit);
    let levels = [...$zip(system.members, system.lines, this._torques)]
      .filter(([member, line, torque]) => !line.follows)
      .map(([member, line, torque]) => member.stretch_log(tension) - line.log_speed(torque));
    return $sum(levels) / levels.length;
  }
  level(w) {
    return this._center + _LEVEL_SCALE * Math.sinh(w);
  }
  follow(level) {
    let i, lead, line, out, pull, run, torque;
    let system = this._system;
    let entry = this._system.entry;
    let passages = [];
    for (const each1 of $enumerate($zip(system.lines, system.runs))) {
      [i, [line, run]] = each1;
      if (line.follows) {
        lead = line.master;
        torque = this._torques[lead];
        if (lead < i) {
          torque = system.torque(lead, passages[lead].entry, passages[lead].exit);
        }
        pull = (line.ratio * torque) / system.members[i].arm(entry);
        out = max(entry - pull, 1e-6 * entry);
        passages.push(new Passage(entry, out, NaN, NaN, NaN, NaN, false));
      } else {
        passages.push(this._turned(i, entry, level));
      }
      entry = max(passages.at(-1).exit + run, 1e-6 * system.entry);
    }
    return passages;
  }
  _turned(i, entry, level) {
    let ratio;
    let system = this._system;
    let member = this._system.members[i];
    let line = this._system.lines[i];
    if (line.motor === null && line.give === 0.0 && !member.holds) {
      ratio = -Math.expm1(member.stretch_log(entry) - line.speed - level);
      ratio = min(max(ratio, -0.5), 0.5);
      return member.passage(entry, member.effort_at(ratio), this._steps);
    }
    let found = [];
    let steps = this._steps;
    const miss = (effort) => {
      let at = member.passage(entry, effort, steps);
      found.push([effort, at]);
      return system.speed_miss(i, at, level);
    };
    let end = this._largest_effort(i, entry);
    let guess = this._efforts[i];
    if (Number.isNaN(guess)) {
      guess = member.holds ? 0.5 : member.effort_at(0.001);
      guess = system.pull >= 0.0 ? guess : -guess;
    }
    const found1 = roots__rising_root(miss, guess, 0.3, -end, end, _TURNED, this._slopes[i]);
    let effort = found1[0];
    this._efforts[i] = effort;
    this._slopes[i] = this._slope(
      i,
      [...found.slice(-2)].map(([_, at]) => at),
      level,
    );
    return $first(
      [...found].filter(([tried, at]) => tried === effort).map(([tried, at]) => at),
      found.at(-1)[1],
    );
  }
  _slope(i, two, level) {
    if (two.length < 2 || two[0].effort === two[1].effort) {
      return 0.0;
    }
    let a = this._system.speed_miss(i, two[0], level);
    let b = this._system.speed_miss(i, two[1], level);
    return max((b - a) / (two[1].effort - two[0].effort), 0.0);
  }
  _largest_effort(i, entry) {
    let member = this._system.members[i];
    if (!member.holds) {
      return member.effort_at(0.5);
    }
    let par = member.parameters(entry, 1.0);
    let top = effort__largest_effort(member.law, par);
    if (member.rests) {
      return 1.0 + (0.5 * par.length) / CREEP_SCALE;
    }
    return 1.0 + top;
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
    let guess = this._w;
    if (Number.isNaN(guess)) {
      guess = Math.asinh(0.0015 / _LEVEL_SCALE);
      guess = this._system.pull >= 0.0 ? guess : -guess;
    }
    const found1 = roots__rising_root(
      this._of_level(),
      guess,
      0.3,
      -_LEVEL_END,
      _LEVEL_END,
      tolerance,
    );
    let w = found1[0];
    let miss = found1[1];
    this._w = w;
    return [w, miss];
  }
  _of_level() {
    const miss = (w) => {
      return this.miss(w);
    };
    return miss;
  }
  _torque_miss(lead, tolerance, torque) {
    this._torques[lead] = torque;
    let [w] = this._solution(tolerance);
    let at = this.follow(this.level(w))[lead];
    return torque - this._system.torque(lead, at.entry, at.exit);
  }
  all_solutions(tolerance = 1e-6) {
    let a, b, c, fa, fb, fc;
    if (this._early.length > 0) {
      this.solution(tolerance);
    }
    let points = [...this._nodes()].map((w) => [w, this.miss(w)]);
    for (const each1 of $zip(points.slice(0, -2), points.slice(1, -1), points.slice(2))) {
      [[a, fa], [b, fb], [c, fc]] = each1;
      if (
        Math.abs(fb) < min(Math.abs(fa), Math.abs(fc)) &&
        fa > 0.0 === fb > 0.0 &&
        fb > 0.0 === fc > 0.0
      ) {
        points.push(this._tip(a, [b, fb], c));
      }
    }
    let miss = this._of_level();
    return [...$pairwise($sorted(points, (point) => point[0]))]
      .filter(([[a, fa], [b, fb]]) => fa < 0.0 !== fb < 0.0)
      .map(([[a, fa], [b, fb]]) => roots__bracketed_root(miss, a, fa, b, fb, tolerance)[0]);
  }
  _nodes() {
    let sign = this._system.pull >= 0.0 ? 1.0 : -1.0;
    let nodes = [...$range(_SCAN + 1)].map((k) => (sign * _LEVEL_END * k) / _SCAN);
    if (sign * this.miss(0.0) > 0.0) {
      nodes = [...nodes, ...[...nodes.slice(1)].map((w) => -w)];
    }
    return $sorted(nodes);
  }
  _tip(a, at, c) {
    let b, f, fb, w;
    for (let each1 = 0, end1 = 40; each1 < end1; each1++) {
      [b, fb] = at;
      w = 0.62 * b + 0.38 * (b - a > c - b ? a : c);
      f = this.miss(w);
      if (f > 0.0 !== fb > 0.0) {
        return [w, f];
      }
      if (Math.abs(f) < Math.abs(fb)) {
        [a, c] = w > b ? [b, c] : [a, b];
        at = [w, f];
      } else {
        [a, c] = w > b ? [a, w] : [w, c];
      }
      if (c - a < 0.0001) {
        break;
      }
    }
    return at;
  }
  strongest() {
    let value, w;
    let sign = this._system.pull >= 0.0 ? 1.0 : -1.0;
    let best = 0.0;
    let best_value = -Infinity;
    for (const each1 of $sorted(this._nodes(), Math.abs)) {
      w = each1;
      value = sign * this.miss(w);
      if (sign * w >= 0.0 && value > best_value + 1e-9) {
        best = w;
        best_value = value;
      }
    }
    return best;
  }
  miss(w) {
    return Math.log(this._system.exit / this.follow(this.level(w)).at(-1).exit);
  }
}

export class _Point {
  constructor(efforts, level, state, misses, steps) {
    this.efforts = efforts;
    this.level = level;
    this.state = state;
    this.misses = misses;
    this.steps = steps;
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

export class Divided {
  constructor(pairs, located, belt_speeds) {
    this.pairs = pairs;
    this.located = located;
    this.belt_speeds = belt_speeds;
  }
  *[Symbol.iterator]() {
    yield this.pairs;
    yield this.located;
    yield this.belt_speeds;
  }
}

export class Nip {
  constructor(entry, pull, creep_ratio, radius, compression, nominal) {
    this.entry = entry;
    this.pull = pull;
    this.creep_ratio = creep_ratio;
    this.radius = radius;
    this.compression = compression;
    this.nominal = nominal;
  }
  *[Symbol.iterator]() {
    yield this.entry;
    yield this.pull;
    yield this.creep_ratio;
    yield this.radius;
    yield this.compression;
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

export class Passage {
  constructor(entry, exit, effort, ratio, creep, slip, held) {
    this.entry = entry;
    this.exit = exit;
    this.effort = effort;
    this.ratio = ratio;
    this.creep = creep;
    this.slip = slip;
    this.held = held;
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

export class Problem {
  constructor(message, remedy = "", file = "", key = "", value = "", line = null) {
    this.message = message;
    this.remedy = remedy;
    this.file = file;
    this.key = key;
    this.value = value;
    this.line = line;
  }
}

export class Conveyor {
  constructor(
    length,
    lift = 0.0,
    belt_mass,
    carry_idler_mass,
    return_idler_mass,
    material_mass = null,
    capacity = null,
    friction_factor = 0.02,
    length_coefficient = null,
    secondary_resistance = null,
    special_resistance = 0.0,
    return_share = 0.0,
    start_factor = null,
    start_time = null,
    stop_time = null,
    take_up_tension = null,
    counterweight = null,
    take_up_distance = 0.0,
    drive_at = "head",
    speed = null,
    sheave_ratio = 2.0,
  ) {
    this.length = length;
    this.lift = lift;
    this.belt_mass = belt_mass;
    this.carry_idler_mass = carry_idler_mass;
    this.return_idler_mass = return_idler_mass;
    this.material_mass = material_mass;
    this.capacity = capacity;
    this.friction_factor = friction_factor;
    this.length_coefficient = length_coefficient;
    this.secondary_resistance = secondary_resistance;
    this.special_resistance = special_resistance;
    this.return_share = return_share;
    this.start_factor = start_factor;
    this.start_time = start_time;
    this.stop_time = stop_time;
    this.take_up_tension = take_up_tension;
    this.counterweight = counterweight;
    this.take_up_distance = take_up_distance;
    this.drive_at = drive_at;
    this.speed = speed;
    this.sheave_ratio = sheave_ratio;
  }
  *misfits() {
    let given, message;
    let long = display(this.length, "length");
    if (Math.abs(this.lift) >= this.length) {
      given = display(this.lift, "length");
      yield new Problem(
        "" + "must be less than the length, " + $text(long),
        undefined,
        undefined,
        "lift",
        given,
      );
    }
    if (this.take_up_distance > this.length) {
      given = display(this.take_up_distance, "length");
      message = "" + "is more than the length, " + $text(long) + ", which is the tail";
      yield new Problem(message, undefined, undefined, "take_up_distance", given);
    }
    if (this.secondary_resistance === null && this.length_coefficient === null) {
      yield* resistance__no_coefficient(this.length);
    }
  }
  get material() {
    if (this.material_mass !== null) {
      return this.material_mass;
    }
    return conveyor___known(this.capacity, 0.0) / conveyor___known(this.speed, 1.0);
  }
  sizes() {
    return [
      this.length,
      this.lift,
      this.belt_mass,
      this.carry_idler_mass,
      this.return_idler_mass,
      conveyor___known(this.material_mass, NaN),
      conveyor___known(this.capacity, NaN),
      this.friction_factor,
      conveyor___known(this.secondary_resistance, NaN),
      this.special_resistance === 0.0 ? NaN : this.special_resistance,
      conveyor___known(this.start_time, NaN),
      conveyor___known(this.stop_time, NaN),
      conveyor___known(this.take_up_tension, NaN),
      conveyor___known(this.counterweight, NaN),
    ];
  }
  reckoned() {
    let acceleration, kind, name;
    let full = this._state("full", "running", this.material, 0.0);
    let states = [full, this._state("empty", "running", 0.0, 0.0)];
    for (const each1 of this._changes(full.pull)) {
      [name, kind, acceleration] = each1;
      states.push(this._state(name, kind, this.material, acceleration));
    }
    return states;
  }
  unfit(states) {
    let least, message, remedy, state;
    let problems = [];
    if (this.start_factor !== null && states[0].pull <= 0.0) {
      message = "the full conveyor runs by itself, and no factor starts it";
      remedy = 'Write start_time = "20 s" instead.';
      problems.push(new Problem(message, remedy, undefined, "start_factor"));
    }
    for (const each1 of states) {
      state = each1;
      least = min(min(min(state.head, state.tail), state.entry), state.exit);
      if (least <= 0.0) {
        problems.push(conveyor___slack(state, least));
      }
    }
    return problems;
  }
  *_changes(pull) {
    let moving;
    if (this.start_factor !== null) {
      moving = this._moving(this.material) + this._moving(null);
      yield ["start", "starting", ((this.start_factor - 1.0) * pull) / (this.length * moving)];
    }
    if (this.start_time !== null && this.speed !== null) {
      yield ["start", "starting", this.speed / this.start_time];
    }
    if (this.stop_time !== null && this.speed !== null) {
      yield ["stop", "braking", -this.speed / this.stop_time];
    }
  }
  _moving(material) {
    if (material === null) {
      return this.return_idler_mass + this.belt_mass;
    }
    return this.carry_idler_mass + this.belt_mass + material;
  }
  _state(name, kind, material, acceleration) {
    let resistances = [...this._resistances(material, acceleration)];
    let carrying = $sum([...resistances].map((r) => r.carrying));
    let returning = $sum([...resistances].map((r) => r.returning));
    let head = this.take_up - (returning * this.take_up_distance) / this.length;
    let tail = head + returning;
    let at_head = this.drive_at === "head";
    let entry = at_head ? tail + carrying : tail;
    let leaving = at_head ? head : head - carrying;
    return new State(name, kind, resistances, head, tail, entry, leaving);
  }
  *_resistances(material, acceleration) {
    let coefficient;
    let belt = this.belt_mass;
    let loaded = this.belt_mass + material;
    let share = this.return_share;
    let factor = this.friction_factor;
    let length = this.length;
    let lift = this.lift;
    let main = new Resistance(
      "main",
      resistance__main_resistance(factor, length, lift, this.carry_idler_mass, loaded),
      resistance__main_resistance(factor, length, lift, this.return_idler_mass, belt),
      "" +
        $text(MAIN) +
        ", f = " +
        $told(this.friction_factor, false, 6, "g") +
        $text(this._unusual),
    );
    yield main;
    let secondary = this.secondary_resistance;
    let source = GIVEN;
    if (secondary === null) {
      coefficient = conveyor___known(this.coefficient, 1.0);
      secondary = (coefficient - 1.0) * main.total;
      source = "" + $text(SECONDARY) + ", C = " + $told(coefficient, false, 3, "g");
      source += this.length_coefficient === null ? "" : " (given)";
    }
    yield new Resistance("secondary", (1.0 - share) * secondary, share * secondary, source);
    let up = resistance__slope_resistance(this.lift, loaded);
    let down = -resistance__slope_resistance(this.lift, belt);
    yield new Resistance("slope", up, down, SLOPE);
    let special = this.special_resistance;
    yield new Resistance("special", (1.0 - share) * special, share * special, GIVEN);
    let carrying = resistance__inertia(acceleration, this.length, this._moving(material));
    let returning = resistance__inertia(acceleration, this.length, this._moving(null));
    yield new Resistance("inertia", carrying, returning, INERTIA);
  }
  get take_up() {
    if (this.take_up_tension !== null) {
      return this.take_up_tension;
    }
    return (conveyor___known(this.counterweight, 0.0) * GRAVITY) / this.sheave_ratio;
  }
  get coefficient() {
    if (this.secondary_resistance !== null) {
      return null;
    }
    return conveyor___known(this.length_coefficient, resistance__coefficient_at(this.length));
  }
  get _unusual() {
    let [least, most] = USUAL_FRICTION;
    if (least <= this.friction_factor && this.friction_factor <= most) {
      return "";
    }
    return (
      "" +
      ", outside the usual " +
      $told(least, false, 3, "f") +
      " to " +
      $told(most, false, 3, "f")
    );
  }
}

export class Point {
  constructor(x, y, diameter = 0.0, turn = "clockwise") {
    this.x = x;
    this.y = y;
    this.diameter = diameter;
    this.turn = turn;
  }
  get side() {
    return (this.diameter / 2.0) * (this.turn === "counterclockwise" ? 1.0 : -1.0);
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

export class Carrying {
  constructor(entry, exit, driving, tested_slip, plain) {
    this.entry = entry;
    this.exit = exit;
    this.driving = driving;
    this.tested_slip = tested_slip;
    this.plain = plain;
  }
  *[Symbol.iterator]() {
    yield this.entry;
    yield this.exit;
    yield this.driving;
    yield this.tested_slip;
    yield this.plain;
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

export class System {
  constructor(members, lines, entry, exit, runs, corrections = []) {
    this.members = members;
    this.lines = lines;
    this.entry = entry;
    this.exit = exit;
    this.runs = runs;
    this.corrections = corrections;
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
    if (this.corrections.length > 0) {
      left += this.corrections[i];
    }
    return left - line.log_speed(this.torque(i, at.entry, at.exit)) - level;
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
  bears(momentary) {
    return momentary ? min(MOMENTARY, this.largest_load()) : 1.0;
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
  bears(momentary) {
    return min(super.bears(momentary), LOW_VOLTAGE * this.breakdown_ratio);
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

export class Sliding {
  constructor(log_tension, slip, work, segment, branch, sign) {
    this.log_tension = log_tension;
    this.slip = slip;
    this.work = work;
    this.segment = segment;
    this.branch = branch;
    this.sign = sign;
  }
  *[Symbol.iterator]() {
    yield this.log_tension;
    yield this.slip;
    yield this.work;
    yield this.segment;
    yield this.branch;
    yield this.sign;
  }
}

export class Shot {
  constructor(log_tension, slip, creep, stress, work, creep_ratio, stuck_length) {
    this.log_tension = log_tension;
    this.slip = slip;
    this.creep = creep;
    this.stress = stress;
    this.work = work;
    this.creep_ratio = creep_ratio;
    this.stuck_length = stuck_length;
  }
  *[Symbol.iterator]() {
    yield this.log_tension;
    yield this.slip;
    yield this.creep;
    yield this.stress;
    yield this.work;
    yield this.creep_ratio;
    yield this.stuck_length;
  }
}

export class Slopes {
  constructor(exit_by_entry, exit_by_effort, ratio_by_entry, ratio_by_effort) {
    this.exit_by_entry = exit_by_entry;
    this.exit_by_effort = exit_by_effort;
    this.ratio_by_entry = ratio_by_entry;
    this.ratio_by_effort = ratio_by_effort;
  }
}

export class State {
  constructor(name, kind, resistances, head, tail, entry, exit) {
    this.name = name;
    this.kind = kind;
    this.resistances = resistances;
    this.head = head;
    this.tail = tail;
    this.entry = entry;
    this.exit = exit;
  }
  get pull() {
    return $sum([...this.resistances].map((resistance) => resistance.total));
  }
}

export class Resistance {
  constructor(name, carrying, returning, source) {
    this.name = name;
    this.carrying = carrying;
    this.returning = returning;
    this.source = source;
  }
  get total() {
    return this.carrying + this.returning;
  }
}

export class Parameters {
  constructor(
    entry_tension,
    entry_pressure,
    radius,
    length,
    compliance,
    shear,
    kick,
    width,
    side,
    onset,
  ) {
    this.entry_tension = entry_tension;
    this.entry_pressure = entry_pressure;
    this.radius = radius;
    this.length = length;
    this.compliance = compliance;
    this.shear = shear;
    this.kick = kick;
    this.width = width;
    this.side = side;
    this.onset = onset;
  }
  *[Symbol.iterator]() {
    yield this.entry_tension;
    yield this.entry_pressure;
    yield this.radius;
    yield this.length;
    yield this.compliance;
    yield this.shear;
    yield this.kick;
    yield this.width;
    yield this.side;
    yield this.onset;
  }
}

const SMALL_PULL = 0.001;
const _GIVE = 0.01;
const FINE = 24;
const SHARP = 16;
const COARSE = 8;
const _SPEED_WEIGHT = 1000.0;
const _LARGEST_STEP = 1.5;
const _LEAST_GIVE = 1e-6;
const BREAKAWAY =
  "Breakaway: a drive cannot hold its part of the load. Raise the slack-side tension (take-up), bring the speeds closer together, or choose a lagging with more friction.";
const UNSOLVED =
  "The solver did not reach its accuracy on this train. Please report the drive file; until then change a value slightly.";
const SOLVED = "The drives carry the load.";
const _CORRECTED = 1e-12;
const _SURE = 0.01;
const _IDLE = 1e-11;
const GIVEN_DIGITS = 4;
const BEYOND_MOTOR =
  "No operating point: a motor would have to work beyond its curve. Change its set speed or gear, or choose another motor.";
const USUAL_MOTORS = [
  [250.0, 20000000.0],
  [10.0, 400.0],
  [0.6, 1.7],
];
const _EITHER = [
  ["material_mass", "capacity", 'material_mass = "120 kg/m"'],
  ["take_up_tension", "counterweight", 'take_up_tension = "40 kN"'],
  ["length_coefficient", "secondary_resistance", ""],
  ["start_factor", "start_time", ""],
];
const _NEED_SPEED = ["capacity", "start_time", "stop_time"];
const USUAL_CONVEYOR = [
  ["length", 3.0, 30000.0],
  ["lift", -1500.0, 1500.0],
  ["belt_mass", 1.0, 200.0],
  ["carry_idler_mass", 0.5, 200.0],
  ["return_idler_mass", 0.2, 100.0],
  ["material_mass", 0.5, 4000.0],
  ["capacity", 0.1, 15000.0],
  ["friction_factor", 0.01, 0.04],
  ["secondary_resistance", 10.0, 500000.0],
  ["special_resistance", 10.0, 200000.0],
  ["start_time", 1.0, 600.0],
  ["stop_time", 1.0, 600.0],
  ["take_up_tension", 300.0, 2000000.0],
  ["counterweight", 30.0, 200000.0],
];
const FULLEST = 700.0;
const STEEPEST = 0.5;
const NONE = "-";
const _AS_FAST = 5e-6;
const _TOLERATED = 0.05;
const RESULT_DIGITS = 3;
const _ROUNDING = 1e-9;
const ATTENTION = "ATTENTION";
const TRAIN_BALANCE = 1e-5;
const RATIO_SCALE = 1e-5;
const LARGEST_RATIO = 1.0;
const SMALL_RATIO = 1e-7;
const CREEP_SCALE = 0.00635;
const LIMIT = 0;
const PLASTIC = 1;
const _LARGEST_EFFORT = 12.100712129903211;
const TABLE = 3;
const MOST_LAGS = 100.0;
const LAGS_PER_MESH = 2.0;
const FEWEST_CUT_STEPS = 16;
const LARGEST_LOG = 50.0;
const FARTHEST_SLIP = 1000.0;
const MESH_POWER = 4;
const LARGEST_LOG_STEP = 0.12;
const KNOTS = 1;
const PIECES = 2;
const NEAREST = 1e-7;
const STEEP = 0.5;
const CELL_PARTS = 3.0;
const FEW_STEPS = 0.05;
const PART_OF_LAG = 0.3;
const _MOST_TRIALS = 200;
const WILD_LOG_STEP = 1.0;
const WILD_SLIP = 10000.0;
const MOST_CUTS = 200;
const RISE = 0;
const PREVIOUS_BRANCH = 3;
const LOWER_EDGE = 0;
const UPPER_EDGE = 1;
const NO_SLIP = 2;
const ELASTIC = 0;
const NEXT_BRANCH = 4;
const SMOOTH_CUT_TOLERANCE = 0.0003;
const CUT_TOLERANCE = 1e-6;
const SLIP_CUT_TOLERANCE = 1e-9;
const LANDINGS = 40;
const SMALLEST = 1e-16;
const _BEYOND = 30.0;
const _STEP = 0.0001;
const _LEVEL_SCALE = 1e-5;
const _TURNED = 1e-9;
const _LEVEL_END = 11.512925465070229;
const _SCAN = 18;
const _ROWS = [
  [80.0, 1.92],
  [90.0, 1.86],
  [100.0, 1.78],
  [120.0, 1.7],
  [140.0, 1.63],
  [160.0, 1.56],
  [180.0, 1.5],
  [200.0, 1.45],
  [250.0, 1.38],
  [300.0, 1.31],
  [350.0, 1.27],
  [400.0, 1.25],
  [450.0, 1.22],
  [500.0, 1.2],
  [550.0, 1.18],
  [600.0, 1.17],
  [700.0, 1.14],
  [800.0, 1.12],
  [900.0, 1.1],
  [1000.0, 1.09],
  [1500.0, 1.06],
  [2000.0, 1.05],
];
const GRAVITY = 9.80665;
const MAIN = "DIN 22101:2002-08, 6.2; ISO 5048:1989: f L g (m'R + (m'G + m'L) cos delta)";
const GIVEN = "given";
const SECONDARY = "DIN 22101:2002-08, 6.3.3: (C - 1) times the main resistance";
const SLOPE = "DIN 22101:2002-08, 6.4: g H (m'G + m'L), up on one strand and down on the other";
const INERTIA =
  "force to accelerate belt, material and rotating idlers (DIN 22101:2002-08, 7.3), the idlers with their whole rotating mass";
const MOMENTARY = 1.6;
const BEYOND = 10.0;
const LOW_VOLTAGE = 0.81;
const LEAST_COMPLIANCE = 1e-16;
const USUAL_FRICTION = [0.016, 0.03];

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
  let geometry = summary__geometry_of(arc, law.onset_compliance);
  return new Member(law, geometry, 0.5 * arc.diameter, 1.0 / arc.axial_stiffness, squeeze);
}

/** Return the surface speed of the first drum, without compression [m/s]. */
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

/** Growth of the tight and of the slack side of one of several pulleys with the pull of all [N]. */
export function numbers__rise_among(pulls, index, fixed, after) {
  let total = $sum(pulls);
  let mine = pulls[index];
  let ahead = $sum(pulls.slice(0, index));
  let behind = $sum(pulls.slice(index + 1));
  let lost = fixed ? 0.5 * Math.abs(total) : 0.0;
  if (!fixed && after >= 0) {
    lost = total >= 0.0 ? $sum(pulls.slice(after + 1)) : -$sum(pulls.slice(0, after + 1));
  }
  let entry = (total >= 0.0 ? mine + behind : -ahead) - lost;
  let leaving = (total >= 0.0 ? behind : -ahead - mine) - lost;
  return mine >= 0.0 ? [entry, leaving] : [leaving, entry];
}

/** What a pulley shares with the others; `after` is where the take-up stands, -1 for none. */
export function in_page_train__among(pairs, index, fixed, after) {
  let first = pairs[0];
  let last = pairs[pairs.length - 1];
  let pulls = [...pairs].map((at) => at.entry - at.exit);
  let slack = $sum(pulls) >= 0.0 ? last.exit : first.entry;
  let end = after >= 0 ? pairs[after].exit : slack;
  const found1 = numbers__rise_among(pulls, index, fixed, after);
  let tight_rise = found1[0];
  let slack_rise = found1[1];
  return new Among(
    end,
    fixed ? first.entry + last.exit : end,
    slack,
    first.entry >= last.exit ? last.exit : first.entry,
    tight_rise,
    slack_rise,
  );
}

/** Pull of drives against each other, 0 where they work together [N]. */
export function numbers__pull_against(pulls) {
  let small = SMALL_PULL * $maxOf([...pulls].map((pull) => Math.abs(pull)));
  if (!($minOf(pulls) < -small && $maxOf(pulls) > small)) {
    return 0.0;
  }
  return min($sum([...pulls].map((p) => max(p, 0.0))), $sum([...pulls].map((p) => max(-p, 0.0))));
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

/** Efforts of passages; those known by their tensions only are solved for them. */
export function newton___efforts(system, passages) {
  let at, known, member;
  let efforts = [];
  for (const each1 of $zip(system.members, passages)) {
    [member, at] = each1;
    known = at;
    if (Number.isNaN(at.effort)) {
      known = member.between(at.entry, at.exit);
    }
    if (known === null) {
      return null;
    }
    efforts.push(known.effort);
  }
  return efforts;
}

export function newton___state(system, efforts, steps) {
  let at, effort, member, run;
  let entry = system.entry;
  let state = [];
  for (const each1 of $zip(system.members, efforts, system.runs)) {
    [member, effort, run] = each1;
    at = member.passage(max(entry, 1e-6 * system.entry), effort, steps);
    state.push(at);
    entry = at.exit + run;
  }
  return [...state];
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

export function newton___point(system, efforts, level, steps) {
  let state = newton___state(system, efforts, steps);
  return new _Point([...efforts], level, state, newton___misses(system, state, level), steps);
}

export function newton___speed_row(system, i, at, s, entry, torque) {
  let creep = [...entry].map((x) => s.ratio_by_entry * x);
  creep[i] += s.ratio_by_effort;
  let stretch = system.members[i].stretch_slope(at.entry);
  let slope = system.lines[i].log_speed_slope(system.torque(i, at.entry, at.exit));
  let row = [...$zip(creep, entry, torque)].map(
    ([c, x, t]) => c / (1.0 - at.ratio) + stretch * x - slope * t,
  );
  row[row.length - 1] -= 1.0;
  return row;
}

/** Return the equations near a state, and whether each drive rises with its creep. */
export function newton__linearized(system, passages, steps = 24) {
  let arm, at, i, leaving, line, lost, member, pairs, pull, s;
  let count = passages.length;
  let matrix = [...$range(count + 1)].map((_) => $repeated([0.0], count + 1));
  let pulls = [];
  let torques = [];
  let entry = $repeated([0.0], count + 1);
  let slopes = [...$zip(system.members, passages)].map(([m, at]) => m.slopes(at, steps));
  for (const each1 of $enumerate($zip(passages, slopes))) {
    [i, [at, s]] = each1;
    member = system.members[i];
    leaving = [...entry].map((x) => s.exit_by_entry * x);
    leaving[i] += s.exit_by_effort;
    pull = [...$zip(entry, leaving)].map(([x, y]) => x - y);
    arm = member.arm(at.entry);
    lost = (at.entry - at.exit) * member.squeeze;
    pulls.push(pull);
    torques.push([...$zip(pull, entry)].map(([x, y]) => x * arm - lost * y));
    if (!system.lines[i].follows) {
      matrix[i] = newton___speed_row(system, i, at, s, entry, torques[i]);
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
  let rising = [...[...slopes].map((s) => s.exit_by_effort <= 0.0)];
  return [new Linear(matrix, pulls, [...[...system.lines].map((line) => line.follows)]), rising];
}

/** Whether two states are so near that slopes of one serve for the other. */
export function newton___near(a, b) {
  return [...$zip(a, b)].every(([x, y]) => Math.abs(x.exit / y.exit - 1.0) < 0.001);
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

/** Take the step of the linear equations, shortened until it helps if `search`. */
export function newton___stepped(at, system, matrix, search) {
  let efforts, new_;
  let step = linear__solution(
    matrix,
    [...at.misses].map((miss) => -miss),
  );
  if (step === null || ![...step].every((change) => Number.isFinite(change))) {
    return null;
  }
  let longest = $maxOf([...step.slice(0, -1)].map((change) => Math.abs(change)));
  let scale = min(1.0, _LARGEST_STEP / max(longest, 1e-300));
  for (let each1 = 0, end1 = search ? 15 : 1; each1 < end1; each1++) {
    efforts = [...$zip(at.efforts, step.slice(0, -1))].map(([e, d]) => e + scale * d);
    new_ = newton___point(system, efforts, at.level + scale * step.at(-1), at.steps);
    if (new_.size < at.size) {
      return new_;
    }
    scale *= 0.5;
  }
  return null;
}

/** Return slopes that give a change over a step, and others as before (Broyden). */
export function linear__corrected(matrix, step, change) {
  let found, missing, row;
  let square = $sum([...step].map((s) => s * s));
  if (square === 0.0) {
    return [...matrix].map((row) => [...row]);
  }
  let made = [];
  for (const each1 of $zip(matrix, change)) {
    [row, found] = each1;
    missing = found - $sum([...$zip(row, step)].map(([a, s]) => a * s));
    made.push([...$zip(row, step)].map(([a, s]) => a + (missing * s) / square));
  }
  return made;
}

/** Return slopes that are true between two points (Broyden), little changed otherwise. */
export function newton___learned(matrix, a, b) {
  let step = [...$zip([...a.efforts, a.level], [...b.efforts, b.level])].map(([x, y]) => y - x);
  return linear__corrected(
    matrix,
    step,
    [...$zip(a.misses, b.misses)].map(([x, y]) => y - x),
  );
}

/** Meet all equations from a state nearby; None if that fails. */
export function newton__settle(
  system,
  passages,
  level,
  steps = 24,
  near = null,
  tolerance = 1e-13,
) {
  let done, first, i, k, linear, matrix, new_, rising, slow;
  let efforts = newton___efforts(system, passages);
  if (efforts === null) {
    return null;
  }
  let at = newton___point(system, efforts, level, steps);
  for (let each1 = 0, end1 = 30; each1 < end1; each1++) {
    i = each1;
    if (i === 0 && near !== null) {
      linear = near.linear;
      rising = near.rising;
    } else {
      const found2 = newton__linearized(system, at.state, steps);
      linear = found2[0];
      rising = found2[1];
    }
    first = at;
    matrix = linear.matrix;
    for (let each3 = 0, end3 = 10; each3 < end3; each3++) {
      k = each3;
      if (at.size <= tolerance * _SPEED_WEIGHT) {
        if (near === null && !newton___near(first.state, at.state)) {
          const found4 = newton__linearized(system, at.state, steps);
          linear = found4[0];
          rising = found4[1];
        }
        return new Settled(at.state, at.level, linear, rising);
      }
      new_ = newton___stepped(at, system, matrix, k === 0);
      if (new_ === null || new_.size >= at.size) {
        break;
      }
      matrix = newton___learned(matrix, at, new_);
      slow = new_.size > 0.3 * at.size;
      at = new_;
      if (slow) {
        break;
      }
    }
    if (at === first && (i > 0 || near === null)) {
      done = at.size <= 1000.0 * tolerance * _SPEED_WEIGHT;
      return done ? new Settled(at.state, at.level, linear, rising) : null;
    }
  }
  return null;
}

export function locate___same(a, b) {
  let pairs = $zip(a.passages, b.passages);
  return [...pairs].every(([x, y]) => Math.abs(x.exit / y.exit - 1.0) < 1e-6);
}

/** Return the levels found by a search, the states there, and starts that led to none. */
export function locate___states(system, search, softening, steps) {
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
    start = [...search.follow(search.level(w))];
    found = newton__settle(system, start, search.level(w), steps);
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
  let give = _GIVE;
  let now = state;
  while (now !== null && give > 0.0) {
    give = give > _LEAST_GIVE ? give * 0.2 : 0.0;
    now = newton__settle(locate___eased(system, give), now.passages, now.level);
  }
  return now;
}

/** Return "a breaks" or "a and b break". */
export function locate___listed(names, indices) {
  let verb = indices.length === 1 ? "breaks" : "break";
  return "" + $text([...indices].map((i) => names[i]).join(" and ")) + " " + $text(verb);
}

/** Say which drives break away. */
export function locate__away(names, indices) {
  return "" + $text(locate___listed(names, indices)) + " away: no creep makes enough friction.";
}

/** Return the failure of a train, with the drives that break away. */
export function locate___broken(system, names, passages, level) {
  let i, known, member, p;
  let fallen = [];
  let exact = [];
  for (const each1 of $enumerate($zip(system.members, passages))) {
    [i, [member, p]] = each1;
    known = p;
    if (Number.isNaN(p.effort)) {
      known = member.between(p.entry, p.exit);
      if (known === null) {
        fallen.push(i);
      }
    } else if (member.slopes(p, FINE).exit_by_effort >= 0.0) {
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
      "" + "The friction of " + $text(names.join(" and ")) + " together cannot carry the load.";
  } else {
    status = UNSOLVED;
  }
  return new Located(status, reason, [...exact], level, undefined, undefined, [...fallen]);
}

export function locate___shares(system, state) {
  return [...[...state.passages].map((p) => (p.entry - p.exit) / system.pull)];
}

export function locate___them(indices) {
  return indices.length === 1 ? "it" : "them";
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
      "At these speeds " +
      $text(locate___listed(names, fallen)) +
      " away: the only balance there is has " +
      $text(locate___them(fallen)) +
      " sliding, past the peak of friction.";
  }
  return new Located(status, reason, state.passages, state.level, state, others, fallen);
}

/** Return the tensions at which the arcs, solved for their tensions, meet the speeds. */
export function locate___corrected(system, located, steps) {
  let better, offsets, old, pairs, solved, state, step;
  for (let each1 = 0, end1 = 4; each1 < end1; each1++) {
    state = located.settled;
    if (state === null || located.status !== SOLVED) {
      break;
    }
    solved = [...$zip(system.members, state.passages)].map(([m, p]) => m.between(p.entry, p.exit));
    pairs = [...$zip(solved, state.passages)];
    offsets = [...pairs]
      .filter(([s, p]) => s !== null)
      .map(([s, p]) => Math.log1p(-p.ratio) - Math.log1p(-s.ratio));
    if (offsets.length < pairs.length) {
      break;
    }
    old = system.corrections.length > 0 ? system.corrections : $repeated([0.0], offsets.length);
    if ($maxOf([...$zip(offsets, old)].map(([a, b]) => Math.abs(a - b))) < _CORRECTED) {
      break;
    }
    system = Object.assign(Object.create(Object.getPrototypeOf(system)), system, {
      corrections: [...offsets],
    });
    better = newton__settle(system, state.passages, state.level, steps, state);
    if (better === null) {
      break;
    }
    located = Object.assign(Object.create(Object.getPrototypeOf(located)), located, {
      settled: better,
      passages: better.passages,
      level: better.level,
    });
    step = $maxOf(
      [...$zip(better.passages, state.passages)].map(([a, b]) =>
        Math.abs(Math.log(a.exit / b.exit)),
      ),
    );
    if (step * $maxOf([...offsets].map((offset) => Math.abs(offset))) < _CORRECTED * _SURE) {
      break;
    }
  }
  return located;
}

/** Return the stable state of a train whose drums turn as given. */
export function locate__locate(system, names, softening) {
  let failed, level, levels, search, start, states, steps, stiff;
  let eased = locate___eased(system, _GIVE);
  let fine = softening || eased !== system ? FINE : SHARP;
  for (const each1 of [COARSE, SHARP, FINE]) {
    steps = each1;
    search = new Search(eased, steps);
    const found2 = locate___states(eased, search, softening, fine);
    levels = found2[0];
    states = found2[1];
    failed = found2[2];
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
    return locate___broken(system, names, [...search.follow(level)], level);
  }
  if (states.length === 0) {
    start = failed.length > 0 ? failed[0] : [...search.follow(search.level(levels[0]))];
    return locate___broken(system, names, start, search.level(levels[0]));
  }
  return locate___corrected(system, locate___chosen(system, names, states), fine);
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
export function in_page_train__divided(system, names, softening, pulls, speed, reference) {
  let pairs;
  let found = null;
  if (pulls.length > 0) {
    pairs = train__along(system.entry, system.exit, system.runs, pulls);
  } else {
    found = locate__locate(system, names, softening);
    pairs = [...found.passages].map((at) => new Pair(at.entry, at.exit));
    if (found.status === SOLVED) {
      pairs = turning__rounded(pairs, system.exit, system.runs);
    } else if (found.status === BREAKAWAY) {
      pairs = turning__as_asked(pairs, system.entry, system.exit, system.runs);
    }
  }
  let stretch = system.members[0].stretch;
  let at_first = speed;
  if (found !== null && reference === reference) {
    at_first = reference * Math.exp(-found.level) * (1.0 + pairs[0].entry * stretch);
  }
  let first = 1.0 + pairs[0].entry * stretch;
  let speeds = [...pairs].map((at) => (at_first * (1.0 + at.entry * stretch)) / first);
  return new Divided(pairs, found, speeds);
}

export function in_page_train___nip(member, arc, nominal) {
  let found = arc.summary;
  return new Nip(
    found.entry_tension,
    found.effective_tension,
    found.entry_creep_ratio,
    member.radius,
    member.squeeze * found.entry_tension,
    nominal,
  );
}

/** Return how a drum turns against the first one. */
export function turning__turning(first, at, stiffness, total, belt_speed) {
  let a = at.entry;
  let a1 = first.entry;
  let g = at.creep_ratio;
  let g1 = first.creep_ratio;
  let leaves = g < 1.0 ? 1.0 - g : NaN;
  let ratio = ((1.0 + a / stiffness) * (1.0 - g1)) / ((1.0 + a1 / stiffness) * leaves);
  let arm = at.radius - at.compression;
  let arm1 = first.radius - first.compression;
  let surface = belt_speed / leaves;
  let pull = g === g ? at.pull : NaN;
  return new Turning(
    total !== 0.0 ? pull / total : NaN,
    ratio,
    (a - a1) / stiffness,
    g - g1,
    at.compression / at.radius - first.compression / first.radius,
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

export function in_page_train___passage(member, arc) {
  let found = arc.summary;
  let entry = found.entry_tension;
  let leaving = found.exit_tension;
  let g = found.entry_creep_ratio;
  if (member.holds) {
    return member.between(entry, leaving);
  }
  let creep = found.exit_creep;
  let slip = found.exit_slip;
  return new Passage(entry, leaving, member.effort_at(g), g, creep, slip, false);
}

/** Largest relative miss between what leaves a pulley and what the next one takes [-]. */
export function turning__tension_error(leaving, runs, entries, exit_) {
  let taken = [...entries.slice(1), exit_];
  return $maxOf(
    [...$zip(leaving, runs, taken)].map(([out, run, a]) => Math.abs((out + run) / a - 1.0)),
  );
}

/** Largest miss of the speeds or torques asked for, from the arcs alone [-]. */
export function turning__speed_error(system, nips, torques, level) {
  let asked, i, left, line;
  let misses = [];
  for (const each1 of $enumerate(system.lines)) {
    [i, line] = each1;
    if (line.follows) {
      asked = line.ratio * torques[line.master];
      misses.push(Math.abs(torques[i] - asked) / system.torque_scale);
    } else {
      left = -Math.log1p(-nips[i].creep_ratio) + system.members[i].stretch_log(nips[i].entry);
      misses.push(Math.abs(left - line.log_speed(torques[i]) - level));
    }
  }
  return $maxOf(misses);
}

/** Return two rotation speeds [rad/s] in as many digits as tell them apart. */
export function turning___apart(one, other) {
  let digits;
  let told = ["", ""];
  for (let each1 = 4, end1 = 10; each1 < end1; each1++) {
    digits = each1;
    told = [
      display(one, "rotation_speed", "si", digits),
      display(other, "rotation_speed", "si", digits),
    ];
    if (told[0] !== told[1]) {
      break;
    }
  }
  return told;
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
        ? "it cannot hold back"
        : "" + "it holds back " + $told(-low, false, 3, "g") + " rated torques";
    return (
      "" +
      "The belt drives the drum of " +
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
      " would need " +
      $told(point.motor_load, false, 3, "g") +
      " times its rated torque at " +
      $text(turns) +
      " of its drum; its curve ends at " +
      $told(high, false, 3, "g") +
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
  let nips = [...$zip(system.members, arcs, nominal)].map(([at, arc, diameter]) =>
    in_page_train___nip(at, arc, diameter),
  );
  for (const each1 of fallen) {
    i = each1;
    nips[i] = Object.assign(Object.create(Object.getPrototypeOf(nips[i])), nips[i], {
      creep_ratio: NaN,
    });
  }
  let failed = located !== null && located.status !== SOLVED;
  let stiffness = 1.0 / system.members[0].stretch;
  let turnings = [...$zip(nips, of.belt_speeds)].map(([nip, speed]) =>
    turning__turning(nips[0], nip, stiffness, system.pull, speed),
  );
  let points = [...$zip(motors, turnings)].map(([motor, at]) =>
    motor === null ? null : turning__motor_point(motor, at.drum_torque, at.rotation_speed),
  );
  let stuck = [...$enumerate(arcs)]
    .filter(([i, arc]) => !arc.solved || fallen.includes(i))
    .map(([i, arc]) => i);
  let passages = [...arcs].map((_) => null);
  if (stuck.length === 0) {
    passages = [...$zip(system.members, arcs)].map(([m, arc]) => in_page_train___passage(m, arc));
  }
  let torques = [...turnings].map((at) => at.drum_torque);
  let tension_miss = NaN;
  if (stuck.length === 0 && (located === null || located.settled !== null)) {
    leaving = [...arcs].map((arc) => arc.profile.tension[arc.profile.tension.length - 1]);
    entries = [...arcs].map((arc) => arc.summary.entry_tension);
    tension_miss = turning__tension_error(leaving, system.runs, entries, system.exit);
  }
  let speed_miss = failed ? NaN : 0.0;
  if (located !== null && !failed) {
    speed_miss = turning__speed_error(system, nips, torques, located.level);
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

/** Torque over rated torque that a motor bears [-]. */
export function in_page_train__borne(motor, momentary) {
  return motor.bears(momentary);
}

/** What `USUAL_MOTORS` are the ends of; speeds of motor and drum in rad/s, nan if unknown. */
export function numbers__compared_motor(power, speed, drum, radius, belt) {
  return [power, speed, (drum * radius) / belt];
}

/** Whether a motor is of usual size, and turns the drum about as fast as the belt runs. */
export function numbers__usual_motor(power, speed, drum, radius, belt) {
  let values = numbers__compared_motor(power, speed, drum, radius, belt);
  return [...$zip(values, USUAL_MOTORS)].every(([value, ends]) =>
    numbers__usual(value, ends[0], ends[1]),
  );
}

/** Whether a motor is of usual size and its gear fits the belt speed [m, m/s]. */
export function in_page_train__fits(motor, radius, speed) {
  let turns = motor.rated_speed / motor.gear_ratio;
  return numbers__usual_motor(motor.rated_power, motor.rated_speed, turns, radius, speed);
}

/** Return what is said twice or not at all, and what needs the belt speed. */
export function conveyor__choices(given) {
  let example, first, key, message, remedy, second;
  let problems = [];
  for (const each1 of _EITHER) {
    [first, second, example] = each1;
    if (given.includes(first) && given.includes(second)) {
      message = "" + $text(first) + " and " + $text(second) + " both say the same";
      problems.push(new Problem(message, "Leave one of them out.", undefined, second));
    } else if (example !== "" && !given.includes(first) && !given.includes(second)) {
      remedy = "" + "Write " + $text(example) + ", or " + $text(second) + ".";
      problems.push(new Problem("missing", remedy, undefined, first));
    }
  }
  for (const each2 of _NEED_SPEED) {
    key = each2;
    if (given.includes(key) && !given.includes("speed")) {
      remedy = 'Write speed = "3 m/s" in [belt].';
      problems.push(new Problem("needs the belt speed", remedy, undefined, key));
    }
  }
  return problems;
}

/** What of a conveyor does not fit together. */
export function in_page_conveyor__misfits(of) {
  return [...of.misfits()];
}

/** Key of a size that conveyors of a belt width [m] do not have; empty where all are usual. */
export function in_page_conveyor__unusual(of, width) {
  let key, least, most, value;
  for (const each1 of $zip(of.sizes(), USUAL_CONVEYOR)) {
    [value, [key, least, most]] = each1;
    if (!numbers__usual(value, least, most)) {
      return key;
    }
  }
  if (of.material > FULLEST * width ** 2) {
    return of.capacity === null ? "material_mass" : "capacity";
  }
  return Math.abs(of.lift) > STEEPEST * of.length ? "lift" : "";
}

/** Load cases of a conveyor, whatever tensions they leave. */
export function in_page_conveyor__states(of) {
  return of.reckoned();
}

/** What keeps the belt from running so. */
export function in_page_conveyor__unfit(of, found) {
  return of.unfit(found);
}

/** Return the direction of the straight belt between two pulleys [rad]. */
export function belt_path___direction(start, end) {
  let dx = end.x - start.x;
  let dy = end.y - start.y;
  let offset = end.side - start.side;
  return Math.atan2(dy, dx) - Math.asin(offset / Math.hypot(dx, dy));
}

/** Return the same of pulleys that do not overlap [rad]. */
export function belt_path__turned_by(before, pulley, after) {
  let incoming = belt_path___direction(before, pulley);
  let outgoing = belt_path___direction(pulley, after);
  let turned = pulley.turn === "counterclockwise" ? outgoing - incoming : incoming - outgoing;
  turned = modulo(turned, 6.283185307179586);
  return 6.283185307179586 - turned < 1e-9 ? 0.0 : turned;
}

/** Return a problem for each neighbour that overlaps the pulley. */
export function belt_path__overlaps(before, pulley, after) {
  let distance, end, key, message, remedy;
  let problems = [];
  for (const each1 of [
    [before, "before"],
    [after, "after"],
  ]) {
    [end, key] = each1;
    distance = Math.hypot(end.x - pulley.x, end.y - pulley.y);
    if (distance < (end.diameter + pulley.diameter) / 2.0 || distance === 0.0) {
      message =
        "" +
        "its centre is only " +
        $text(display(distance, "length")) +
        " from that of the pulley, and the two overlap";
      remedy = "Check the coordinates and the diameters.";
      problems.push(new Problem(message, remedy, undefined, key));
    }
  }
  return problems;
}

/** Return a value [SI] with its unit, `NONE` for nan and words for infinity. */
export function sheet__quantity(value, dimension, system = "si", digits = 3) {
  if (Number.isNaN(value)) {
    return NONE;
  }
  if (Math.abs(value) === Infinity) {
    return "without bound";
  }
  return display(value, dimension, system, digits);
}

/** Return the value [SI] of a quantity of the glossary with its unit. */
export function sheet__named(name, value, system = "si") {
  return sheet__quantity(value, term(name).dimension, system);
}

/** Whether an arc hands nothing over: its pulley is not driven. */
export function rules__idle(arc) {
  return numbers__idles(arc.entry_tension, arc.exit_tension);
}

/** Return a share as percent, `NONE` for nan. */
export function sheet__percent(share, digits = 3) {
  if (Number.isNaN(share)) {
    return NONE;
  }
  return "" + $text(display(100.0 * share, "number", undefined, digits)) + " %";
}

export function train_words___shares(case_, system) {
  let pulls;
  if ([...case_.members].some((m) => Number.isNaN(m.share))) {
    pulls = [...case_.members]
      .map(
        (m) =>
          "" +
          $text(m.name) +
          " " +
          $text(sheet__named("effective_tension", m.arc.effective_tension, system)),
      )
      .join(", ");
    return "" + "nothing is shared; the drives pull " + $text(pulls);
  }
  return [...case_.members]
    .map((m) =>
      rules__idle(m.arc.arc)
        ? "" + $text(m.name) + " is not driven"
        : "" + $text(m.name) + " carries " + $text(sheet__percent(m.share)),
    )
    .join(", ");
}

export function train_words___against(case_) {
  return numbers__pull_against([...case_.members].map((m) => m.arc.effective_tension));
}

/** Whether drives work against each other. */
export function train_words___fights(case_) {
  return train_words___against(case_) > 0.0;
}

export function train_words___fight(case_, system) {
  let loaded = [...case_.members].filter((m) => !rules__idle(m.arc.arc));
  let forward = [...loaded].filter((m) => m.arc.effective_tension > 0.0).map((m) => m.name);
  let back = [...loaded].filter((m) => m.arc.effective_tension < 0.0).map((m) => m.name);
  let lost = train_words___against(case_);
  let drive = forward.length === 1 ? "drives" : "drive";
  let brake = back.length === 1 ? "brakes" : "brake";
  return (
    "" +
    "The drives fight: " +
    $text(forward.join(" and ")) +
    " " +
    $text(drive) +
    " while " +
    $text(back.join(" and ")) +
    " " +
    $text(brake) +
    ", " +
    $text(sheet__named("effective_tension", lost, system)) +
    " of pull against each other."
  );
}

/** Return a term in percent, without a sign where nothing of it is shown. */
export function train_words___signed(term) {
  let text = "" + $told(100.0 * term, true, 3, "f");
  return text === "+0.000" || text === "-0.000" ? "0" : text;
}

/** Say whether the rule of the slightly faster second drive holds. */
export function train_words___rule(ratio) {
  let holds = ratio > 0.0 ? "holds" : "does not hold";
  return "" + ", and the rule of the slightly faster second drive " + $text(holds);
}

/** Say which of the terms makes a drum faster or slower. */
export function train_words___reason(m, ratio) {
  let shorter = m.contraction_term + m.compression_term;
  if (ratio > 0.0 && m.creep_term > 0.0 && shorter <= 0.0) {
    return "its extra creep outweighs contraction and compression";
  }
  if (ratio <= 0.0 && 0.0 < m.creep_term && shorter < 0.0) {
    return "contraction and compression outweigh its extra creep";
  }
  if (shorter < 0.0) {
    return "contraction, compression and a smaller creep all ask for it";
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
  if (Math.abs(ratio) < _AS_FAST) {
    return (
      "" +
      "The drum of " +
      $text(m.name) +
      " " +
      $text(verb) +
      " as fast as that of " +
      $text(first) +
      ", at equal diameters: " +
      $text(terms) +
      "."
    );
  }
  let rule = asked && m.creep_term > 0.0 ? train_words___rule(ratio) : "";
  return (
    "" +
    "The drum of " +
    $text(m.name) +
    " " +
    $text(verb) +
    " " +
    $told(Math.abs(100.0 * ratio), false, 3, "f") +
    " % " +
    $text(way) +
    " than that of " +
    $text(first) +
    ", at equal diameters (" +
    $text(terms) +
    "): " +
    $text(train_words___reason(m, ratio)) +
    $text(rule) +
    "."
  );
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
    if (i === 0 || slope === 0.0) {
      continue;
    }
    how = own_way ? " with its motors as they are" : "";
    yield "" +
      "A trim of 0.1 % on " +
      $text(m.name) +
      " moves " +
      $text(sheet__percent(slope, 2)) +
      " of the load" +
      $text(how) +
      ": to keep its share within " +
      $text(sheet__percent(_TOLERATED)) +
      ", speeds and diameters must match within " +
      $text(train_words___needed(slope)) +
      " %.";
  }
}

export function train_words___are(parts) {
  return parts.length === 1 ? "is" : "are";
}

/** Say what is lost between the mains and the drums, and what the mains give. */
export function* train_words___motor_losses(case_, system) {
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
      parts.push("" + $text(sheet__named(name, lost, system)) + " in the " + $text(what));
    }
  }
  if (parts.length === 0) {
    return;
  }
  let electrical = $sum([...points].map((p) => p.electrical_power));
  if (Number.isNaN(electrical)) {
    tail = "; what the motors themselves lose is not told without their motor_efficiency";
  } else {
    mains = sheet__named("electrical_power", electrical, system);
    tail = "" + "; the motors take " + $text(mains) + " from the mains";
  }
  yield "" +
    "Between mains and drums " +
    $text(parts.join(", ")) +
    " " +
    $text(train_words___are(parts)) +
    " lost" +
    $text(tail) +
    ".";
}

/** Tell of the load case that governs: who carries what, how the drums turn, what is lost. */
export function* train_words__case_sentences(case_, cases, system) {
  let listed, m;
  if (case_.status !== SOLVED) {
    yield "" + "Load case " + $text(case_.case.name) + ": " + $text(case_.reason);
    return;
  }
  yield "" +
    "Load case " +
    $text(case_.case.name) +
    ": " +
    $text(train_words___shares(case_, system)) +
    ".";
  if (case_.other_splits.length > 0) {
    listed = [...case_.other_splits]
      .map((split) => [...split].map((s) => sheet__percent(s)).join(", "))
      .join("; ");
    yield "" +
      "Friction falls with slip here: the same speeds are also met by the shares " +
      $text(listed) +
      ", which are unstable; the stable split is shown.";
  }
  if (train_words___fights(case_)) {
    yield train_words___fight(case_, system);
  }
  if (case_.members.length > 1) {
    for (const each1 of case_.members.slice(1)) {
      m = each1;
      yield train_words___speed_sentence(case_, m);
    }
    yield* train_words___matching(case_, cases);
  }
  let loss = sheet__percent(case_.loss_ratio);
  let power = Number.isNaN(case_.power_loss)
    ? ""
    : "" + " " + $text(sheet__named("power_loss", case_.power_loss, system)) + ",";
  yield "" + "Creep costs" + $text(power) + " " + $text(loss) + " of the power.";
  yield* train_words___motor_losses(case_, system);
}

/** Tell of another load case who carries what. */
export function* train_words__short_sentences(case_, system) {
  if (case_.status !== SOLVED) {
    yield "" + "Load case " + $text(case_.case.name) + ": " + $text(case_.reason);
    return;
  }
  let tail = train_words___fights(case_) ? ", the drives working against each other" : "";
  yield "" +
    "Load case " +
    $text(case_.case.name) +
    ": " +
    $text(train_words___shares(case_, system)) +
    $text(tail) +
    ".";
}

export function train_sheet___shown(value, name, system, digits) {
  return Number.isNaN(value) ? NONE : display(value, term(name).dimension, system, digits);
}

/** Return a small ratio as percent with its sign: ``-0.3121 %``. */
export function train_sheet__signed(ratio) {
  if (Number.isNaN(ratio)) {
    return NONE;
  }
  let text = "" + $told(100.0 * ratio, true, 4, "f") + " %";
  return text === "+0.0000 %" || text === "-0.0000 %" ? "0" : text;
}

export function train_sheet___share(m) {
  return rules__idle(m.arc.arc) && !Number.isNaN(m.share) ? "not driven" : sheet__percent(m.share);
}

/** Return the rise of tension before each pulley, where there is any. */
export function train_sheet___run_rows(case_, system) {
  if (case_.case.runs.length === 0) {
    return [];
  }
  let entry = term("run");
  let texts = [NONE, ...[...case_.case.runs].map((run) => sheet__named("run", run, system))];
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

export function train_sheet___motor_rows(members, system) {
  let points = [...members].filter((m) => m.motor !== null).map((m) => m.motor);
  if (points.length === 0) {
    return [];
  }
  const of = (name, show) => {
    let texts = [...members].map((m) => (m.motor !== null ? show(m.motor[name]) : "follows"));
    return new Row(term(name).title, [...texts], term(name).symbol, undefined, name);
  };
  const told = (name) => {
    return of(name, (value) => sheet__named(name, value, system));
  };
  return [
    of("motor_load", sheet__percent),
    told("motor_power"),
    told("motor_torque"),
    of("motor_speed", (value) => display(value, "rotation_speed", system, GIVEN_DIGITS)),
    ...[...train_sheet___motor_extras(points)].map((name) => told(name)),
  ];
}

/** Return a trim as percent of nominal: ``99.655 %``. */
export function train_sheet__trim_text(trim) {
  return Number.isNaN(trim) ? NONE : "" + $told(100.0 * trim, false, 3, "f") + " %";
}

export function train_sheet___creep_row(case_, system) {
  let creep, m, part;
  let texts = [];
  for (const each1 of case_.members) {
    m = each1;
    creep = m.arc.exit_creep;
    part = "" + " (" + $text(sheet__percent(Math.abs(creep) / m.arc.arc.creep_limit)) + ")";
    texts.push(
      "" +
        $text(sheet__named("exit_creep", creep, system)) +
        $text(Number.isNaN(creep) ? "" : part),
    );
  }
  let over = [...case_.members].some((m) => !m.arc.within_creep_limit);
  let entry = term("exit_creep");
  let level = over ? ATTENTION : null;
  let note = "and as a part of the limit";
  return new Row(entry.title, [...texts], entry.symbol, note, "exit_creep", level);
}

/** Return what creep costs; of a drum that is not driven nothing but rounding is left. */
export function train_sheet___lost(m, system) {
  let loss = m.arc.energy.power_loss;
  return sheet__named(
    "power_loss",
    rules__idle(m.arc.arc) && !Number.isNaN(loss) ? 0.0 : loss,
    system,
  );
}

export function train_sheet___loss_note(case_, system) {
  if (Number.isNaN(case_.loss_ratio)) {
    return "";
  }
  let ratio = "" + $text(sheet__percent(case_.loss_ratio)) + " of the power";
  if (Number.isNaN(case_.power_loss)) {
    return "" + "together " + $text(ratio);
  }
  return (
    "" +
    "together " +
    $text(sheet__named("power_loss", case_.power_loss, system)) +
    ", " +
    $text(ratio)
  );
}

export function train_sheet___sensitivity_row(case_) {
  let texts = [...$range(case_.members.length)].map((i) =>
    case_.sensitivity[i][i] !== 0.0 ? sheet__percent(case_.share_per_trim(i), 2) : NONE,
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
export function train_sheet__case_table(case_, system) {
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
    return row(name, (m) => sheet__named(name, of(m), system), "");
  };
  const known = (name, of, digits) => {
    return row(name, (m) => train_sheet___shown(of(m), name, system, digits), "");
  };
  const small = (name, of, note) => {
    return row(name, (m) => train_sheet__signed(of(m)), note);
  };
  let rows = [
    row("share", train_sheet___share, ""),
    told("effective_tension", (m) => m.arc.effective_tension),
    ...train_sheet___run_rows(case_, system),
    told("entry_tension", (m) => m.arc.entry_tension),
    told("exit_tension", (m) => m.arc.exit_tension),
    known("drum_power", (m) => m.drum_power, RESULT_DIGITS),
    known("drum_torque", (m) => m.drum_torque, RESULT_DIGITS),
    ...train_sheet___motor_rows(members, system),
    small("speed_ratio", (m) => m.speed_ratio - 1.0, "exactly"),
    small("contraction_term", (m) => m.contraction_term, "to first order"),
    small("creep_term", (m) => m.creep_term, "to first order"),
    small("compression_term", (m) => m.compression_term, "to first order"),
    small("drum_ratio", (m) => m.drum_ratio - 1.0, "exactly, for equal diameters"),
    known("rotation_speed", (m) => m.rotation_speed, 6),
    row(
      "speed_trim",
      (m) => train_sheet__trim_text(m.speed_trim),
      "what a speed control is set to",
    ),
    train_sheet___creep_row(case_, system),
  ];
  if (![...members].every((m) => Number.isNaN(m.arc.capacities.creep_limit_margin))) {
    rows.push(told("creep_limit_margin", (m) => m.arc.capacities.creep_limit_margin));
  }
  rows.push(
    row("power_loss", (m) => train_sheet___lost(m, system), train_sheet___loss_note(case_, system)),
  );
  rows.push(train_sheet___sensitivity_row(case_));
  let note = case_.status === SOLVED ? train_sheet___precision(case_) : case_.reason;
  return new Table(
    "" + "Drives: load case " + $text(case_.case.name),
    [...rows],
    train_sheet___names(case_),
    note,
    "drives",
  );
}

export function arc_tables___gross_note(plain, creep, system) {
  if (plain) {
    return "the whole wrap slips";
  }
  if (Math.abs(creep) === Infinity) {
    return "extrapolated, approached as creep grows without bound";
  }
  return (
    "" + "extrapolated, at " + $text(sheet__named("gross_slip_creep", creep, system)) + " of creep"
  );
}

/** Return the table of the capacities of an arc. */
export function arc_tables__capacity_rows(c, of, system) {
  let note, slip;
  let [tight, slack] = of.driving ? ["T1", "T2"] : ["T2", "T1"];
  let held = sheet__named("tension", max(of.entry, of.exit), system);
  let actual = max(of.entry / of.exit, of.exit / of.entry);
  const row = (name, value, note) => {
    return new Row(
      term(name).title,
      [sheet__named(name, value, system)],
      term(name).symbol,
      note,
      name,
    );
  };
  const ratio = (name, value, margin, note) => {
    let shown = Number.isNaN(margin)
      ? ""
      : "" + "margin " + $text(sheet__named("tension_ratio", margin, system)) + "; ";
    return row(name, value, "" + $text(shown) + $text(note));
  };
  let rows = [
    ratio(
      "creep_limit_capacity",
      c.creep_limit_capacity,
      c.creep_limit_margin,
      "the design number",
    ),
    row("equivalent_friction", c.equivalent_friction, "compare with design values"),
  ];
  if (!Number.isNaN(of.tested_slip)) {
    slip = sheet__named("slip", of.tested_slip, system);
    note = "" + "slip at the largest tested, " + $text(slip);
    rows.push(ratio("tested_slip_capacity", c.tested_slip_capacity, c.tested_slip_margin, note));
  }
  let gross = arc_tables___gross_note(of.plain, c.gross_slip_creep, system);
  rows.push(row("gross_slip_capacity", c.gross_slip_capacity, gross));
  note =
    "" +
    "Ratios " +
    $text(tight) +
    "/" +
    $text(slack) +
    " with " +
    $text(tight) +
    " held at " +
    $text(held) +
    "; margin is the capacity over the actual ratio, " +
    $text(sheet__named("tension_ratio", actual, system)) +
    ".";
  return new Table("Capacity", [...rows], undefined, note, "capacity");
}

/** Effort of an entry creep ratio, laws without a jump; the inverse of :func:`ratio_of`. */
export function effort__effort_of(par, g) {
  let r = (par.side * g) / SMALL_RATIO;
  if (par.kick !== 0.0) {
    return Math.asinh(r);
  }
  return r > 0.0 ? Math.log(r) : -60.0;
}

/** Shear stress a law holds without slip [Pa] and its derivative by pressure [-]. */
export function stick__onset_stress(law, pressure) {
  let segment = compact__segment_of(law, pressure);
  let branch = law.kind === LIMIT ? PLASTIC : 0;
  const found1 = compact__friction_at(law, segment, branch, 0.0, pressure);
  let mu = found1[0];
  let mu_p = found1[2];
  return [mu * pressure, mu + pressure * mu_p];
}

/** Effort at which the entry creep ratio is 1. */
export function effort__largest_effort(law, par) {
  if (!quantities__jumps(law)) {
    return effort__effort_of(par, par.side * LARGEST_RATIO);
  }
  let compliance = par.shear + par.onset;
  if (compliance === 0.0) {
    return 1.0 + (LARGEST_RATIO * par.length) / CREEP_SCALE;
  }
  let u = compliance * stick__onset_stress(law, par.entry_pressure)[0];
  return max(par.length / u, 10.0);
}

/** Shear-lag lengths in the arc [-]; 0 for a law without slip before its limit. */
export function effort__lags(law, par) {
  let mu, mu_pk, slip, slip_pk;
  let p = par.entry_pressure;
  let segment = compact__segment_of(law, p);
  if (law.kind === LIMIT && law.coefficients[3] === 0.0) {
    return 0.0;
  }
  if (law.kind === LIMIT) {
    slip = law.coefficients[3];
    mu = 1.0 / p;
  } else if (law.kind === TABLE) {
    const found1 = compact__friction_at(law, segment, 1, law.slips[1], p);
    mu = found1[0];
    slip = law.slips[1];
  } else {
    const found2 = compact__peak(law, segment, p);
    slip_pk = found2[0];
    mu_pk = found2[1];
    slip = 0.18 * slip_pk;
    mu = mu_pk;
  }
  let lag = Math.sqrt((par.shear + slip / (mu * p)) / (par.width * par.compliance));
  return par.length / lag;
}

/** Mesh steps for an arc: more where the belt hands over its tension in a short exit part. */
export function effort__mesh_steps(law, par, steps) {
  return Math.trunc(steps * max(1.0, min(effort__lags(law, par), MOST_LAGS) / LAGS_PER_MESH));
}

/** Length l = sqrt(c_e EA' / B), over which a stuck belt hands over its tension [m]. */
export function stick__shear_lag_length(par) {
  return Math.sqrt((par.shear + par.onset) / (par.width * par.compliance));
}

/** Tension [N] and creep [m] at the end of a stuck zone of a given length, where slip begins. */
export function stick__zone_end(law, par, length) {
  let f, new_, slope, tau, tau_p, u;
  let compliance = par.shear + par.onset;
  if (compliance === 0.0) {
    return [par.entry_tension, 0.0];
  }
  let lag = stick__shear_lag_length(par);
  let e = Math.exp(-length / lag);
  let rise = -Math.expm1(-length / lag);
  let half = Math.tanh((0.5 * length) / lag);
  let ease = lag * par.compliance;
  let area = par.width * par.radius;
  let low = 0.0;
  let high = par.entry_tension * 1000000.0;
  let t = par.entry_tension;
  for (let each1 = 0, end1 = 200; each1 < end1; each1++) {
    const found2 = stick__onset_stress(law, t / area);
    tau = found2[0];
    tau_p = found2[1];
    u = par.side * compliance * tau;
    f = t - par.entry_tension + (par.kick * rise + (u - par.kick * e) * half) / ease;
    if (f > 0.0) {
      high = t;
    } else {
      low = t;
    }
    slope = 1.0 + (((par.side * compliance * tau_p) / area) * half) / ease;
    new_ = slope > 0.0 ? t - f / slope : 0.5 * (low + high);
    if (!(low < new_ && new_ < high)) {
      new_ = 0.5 * (low + high);
    }
    if (Math.abs(new_ - t) <= 1e-15 * par.entry_tension) {
      t = new_;
      break;
    }
    t = new_;
  }
  return [t, par.side * compliance * stick__onset_stress(law, t / area)[0]];
}

/** Entry creep ratio g = (a - x_c) / l of a stuck zone [-]; may underflow to 0. */
export function stick__zone_creep_ratio(par, length, end_creep) {
  if (par.shear + par.onset === 0.0) {
    return 0.0;
  }
  let lag = stick__shear_lag_length(par);
  let e = Math.exp(-length / lag);
  let a = (2.0 * (end_creep - par.kick * e) * e) / -Math.expm1((-2.0 * length) / lag);
  return (a - par.kick) / lag;
}

/** Tension [N] and creep [m] at s inside a stuck zone of a given length and end creep. */
export function stick__zone_point(par, s, length, end_creep) {
  if (par.shear + par.onset === 0.0) {
    return [par.entry_tension, 0.0];
  }
  let lag = stick__shear_lag_length(par);
  let e = Math.exp(-s / lag);
  let e_end = Math.exp(-length / lag);
  let scale =
    ((end_creep - par.kick * e_end) * Math.exp((s - length) / lag)) /
    -Math.expm1((-2.0 * length) / lag);
  let rise = -Math.expm1(-s / lag);
  let creep = par.kick * e + scale * -Math.expm1((-2.0 * s) / lag);
  let pull = par.kick * rise + scale * rise * rise;
  return [max(par.entry_tension - pull / (lag * par.compliance), 1e-6 * par.entry_tension), creep];
}

/** dq/ds [1/m], dx/ds [-] and d(friction work)/ds = tau dx/ds [N/m2] of one piece of the law. */
export function step__rates(law, par, g, segment, branch, sign, q, x) {
  let e, lost, sp;
  let radius = par.radius;
  let shear = par.shear;
  if (Math.abs(q) < 0.1) {
    lost = -Math.expm1(q);
    e = 1.0 - lost;
  } else {
    e = Math.exp(min(max(q, -LARGEST_LOG), LARGEST_LOG));
    lost = 1.0 - e;
  }
  let p = par.entry_pressure * e;
  const found1 = compact__friction_at(law, segment, branch, x * sign, p);
  let mu = found1[0];
  let mu_x = found1[1];
  let mu_p = found1[2];
  let dq = -mu / radius;
  let dx = g + par.entry_tension * lost * par.compliance;
  if (shear > 0.0) {
    sp = shear * p;
    dx = (dx + (sp * (mu + p * mu_p) * mu) / radius) / (1.0 + sp * mu_x);
  }
  return [sign * dq, dx, sign * mu * p * dx];
}

/** Longest step near a point of no slip amid the mesh, where the slope of the law is infinite. */
export function march___near_no_slip(away, s, nearest) {
  if (away < 0.0) {
    return max(-0.7 * away, nearest);
  }
  return away < 0.1 * s ? max(2.0 * away, nearest) : Infinity;
}

/** Wrap pressure [Pa] at ln(T/T1); a trial far off the solution may ask for any. */
export function step__pressure_at(par, q) {
  return par.entry_pressure * Math.exp(min(max(q, -LARGEST_LOG), LARGEST_LOG));
}

/** Longest step in a steep cell of a measured table [m], nan where the cell is not steep. */
export function creep_step__cell_step(law, par, g, segment, branch, sign, q, x) {
  if (branch >= law.slips.length - 1) {
    return NaN;
  }
  let low = law.slips[branch];
  let high = law.slips[branch + 1];
  let p = step__pressure_at(par, q);
  let change = compact__friction_at(law, segment, branch, high, p)[0];
  change -= compact__friction_at(law, segment, branch, low, p)[0];
  let shear = (par.shear * p * Math.abs(change)) / (high - low);
  if (shear < STEEP) {
    return NaN;
  }
  let first = low + par.shear * p * compact__friction_at(law, segment, branch, low, p)[0];
  let last = high + par.shear * p * compact__friction_at(law, segment, branch, high, p)[0];
  let here = sign * x + par.shear * p * compact__friction_at(law, segment, branch, sign * x, p)[0];
  let rate = sign * (g + par.entry_tension * (1.0 - p / par.entry_pressure) * par.compliance);
  if (rate === 0.0) {
    return Infinity;
  }
  let part = Math.abs(last - first) / (1.0 + CELL_PARTS * min(shear, 6.0));
  let left = rate > 0.0 ? last - here : here - first;
  return min(part, max(1.02 * left, 0.0) + 0.01 * part) / Math.abs(rate);
}

/** Shear-lag length sqrt(dx / (dmu p B C)) of what is ahead in a cell of a table [m]. */
export function creep_step__cell_lag(law, par, segment, branch, q, slip, friction) {
  let ahead = law.slips[branch + 1] - slip;
  if (ahead <= 0.0) {
    return Infinity;
  }
  let p = step__pressure_at(par, q);
  let change = compact__friction_at(law, segment, branch, law.slips[branch + 1], p)[0] - friction;
  let stiffness = Math.abs(change) * p * par.width * par.compliance;
  return stiffness > 0.0 ? Math.sqrt(ahead / stiffness) : Infinity;
}

/** Friction mu [-] and slip x [m] with x + ease mu(x, p) = creep (Newton, inside a bracket). */
export function table_slip__slip_under_table(law, segment, ease, pressure, creep, share) {
  let a0, a1, a2, a3, change, found, i, j, miss, mu, mu_x, slope, start, t, trial;
  let edges = law.edges;
  let c = law.coefficients;
  let slips = law.slips;
  let last = edges.length - 1;
  let cells = slips.length;
  let row = 0;
  let above = 0;
  let weight = 0.0;
  let factor = 1.0;
  if (last >= 0 && segment >= last) {
    row = last;
    factor = edges[last] / pressure;
  } else if (segment >= 0) {
    row = segment;
    above = 4 * cells;
    weight = (pressure - edges[segment]) / (edges[segment + 1] - edges[segment]);
  }
  let o = 4 * row * cells;
  ease *= factor;
  let held = c[o] + weight * (c[o + above] - c[o]);
  if (ease > 0.0 && creep <= ease * held) {
    return [(factor * creep) / ease, 0.0];
  }
  let low = 0.0;
  let high = creep;
  let x = share > 0.0 ? share * creep : creep;
  let cell = -1;
  start = a0 = a1 = a2 = a3 = 0.0;
  mu = mu_x = change = 0.0;
  for (let each1 = 0, end1 = _MOST_TRIALS; each1 < end1; each1++) {
    found = compact__cell_of(slips, x);
    if (found !== cell) {
      cell = found;
      start = slips[found];
      i = o + 4 * cell;
      j = i + above;
      a0 = c[i] + weight * (c[j] - c[i]);
      a1 = c[i + 1] + weight * (c[j + 1] - c[i + 1]);
      a2 = c[i + 2] + weight * (c[j + 2] - c[i + 2]);
      a3 = c[i + 3] + weight * (c[j + 3] - c[i + 3]);
    }
    t = x - start;
    mu = a0 + t * (a1 + t * (a2 + t * a3));
    mu_x = a1 + t * (2.0 * a2 + 3.0 * t * a3);
    miss = x + ease * mu - creep;
    if (miss > 0.0) {
      high = x;
    } else {
      low = x;
    }
    slope = 1.0 + ease * mu_x;
    trial = slope > 0.0 ? x - miss / slope : low;
    change = trial - x;
    if (Math.abs(change) > 1e-15 * x && !(low < trial && trial < high)) {
      trial = 0.5 * (low + high);
      change = trial - x;
    }
    if (Math.abs(change) <= 1e-15 * x) {
      break;
    }
    x = trial;
  }
  return [factor * (mu + mu_x * change), x + change];
}

/** Shear stress [Pa] and slip [m] that belong to a creep, with a guess of slip over creep. */
export function creep_step___stress_of_creep(law, par, q, u, share) {
  let size = Math.abs(u);
  let p = step__pressure_at(par, q);
  const found1 = table_slip__slip_under_table(
    law,
    compact__segment_of(law, p),
    par.shear * p,
    p,
    size,
    share,
  );
  let mu = found1[0];
  let x = found1[1];
  let tau = p * mu;
  if (size - x > 1e-6 * size) {
    tau = (size - x) / par.shear;
  }
  return u > 0.0 ? [tau, x] : [-tau, -x];
}

/** Changes of q, creep u and tau du over z of the arc, and slip over creep. */
export function creep_step___creep_rates(law, par, g, z, q, u, share) {
  let p = step__pressure_at(par, q);
  const found1 = creep_step___stress_of_creep(law, par, q, u, share);
  let tau = found1[0];
  let x = found1[1];
  share = u !== 0.0 ? x / u : 1.0;
  let du = (g + par.entry_tension * (1.0 - p / par.entry_pressure) * par.compliance) * z;
  return [(-tau / (p * par.radius)) * z, du, tau * du, share];
}

/** Increment to the second stage, at 1/3. */
export function butcher__to_second(k1) {
  return k1 / 3.0;
}

/** Increment to the third stage, at 2/3. */
export function butcher__to_third(k2) {
  return (k2 * 2.0) / 3.0;
}

/** Increment to the fourth stage, at 1/3. */
export function butcher__to_fourth(k1, k2, k3) {
  return (k1 + 4.0 * k2 - k3) / 12.0;
}

/** Increment to the fifth stage, at 1/2. */
export function butcher__to_fifth(k1, k2, k3, k4) {
  return (18.0 * k2 - k1 - 3.0 * k3 - 6.0 * k4) / 16.0;
}

/** Increment to the sixth stage, at 1/2. */
export function butcher__to_sixth(k2, k3, k4, k5) {
  return (9.0 * k2 - 3.0 * k3 - 6.0 * k4 + 4.0 * k5) / 8.0;
}

/** Increment to the seventh stage, at the end. */
export function butcher__to_last(k1, k2, k3, k4, k6) {
  return (9.0 * k1 - 36.0 * k2 + 63.0 * k3 + 72.0 * k4 - 64.0 * k6) / 44.0;
}

/** Increment over the whole step. */
export function butcher__to_end(k1, k3, k4, k5, k6, k7) {
  return (11.0 * (k1 + k7) + 81.0 * (k3 + k4) - 32.0 * (k5 + k6)) / 120.0;
}

/** `wraparc.arc.kernel.step.step` with creep as the state, and the table as it is throughout. */
export function creep_step__creep_step(law, par, g, sign, q, x, span, xi, h) {
  let a2, a3, a4, a5, a6, a7, b2, b3, b4, b5, b6, b7, mu, w3, w4, w5, w6, w7;
  let f = MESH_POWER * span;
  let z = xi ** 3 * f * h;
  let p = step__pressure_at(par, q);
  let segment = compact__segment_of(law, p);
  const found1 = compact__friction_at(
    law,
    segment,
    compact__branch_of(law, segment, sign * x, p),
    sign * x,
    p,
  );
  mu = found1[0];
  let tau = sign * mu * p;
  let u = x + par.shear * tau;
  const found2 = creep_step___creep_rates(
    law,
    par,
    g,
    z,
    q,
    u,
    u !== 0.0 ? (sign * x) / Math.abs(u) : 1.0,
  );
  let a1 = found2[0];
  let b1 = found2[1];
  let w1 = found2[2];
  let n = found2[3];
  let z3 = (xi + h / 3.0) ** 3 * f * h;
  const found3 = creep_step___creep_rates(
    law,
    par,
    g,
    z3,
    q + butcher__to_second(a1),
    u + butcher__to_second(b1),
    n,
  );
  a2 = found3[0];
  b2 = found3[1];
  n = found3[3];
  z = (xi + (h * 2.0) / 3.0) ** 3 * f * h;
  const found4 = creep_step___creep_rates(
    law,
    par,
    g,
    z,
    q + butcher__to_third(a2),
    u + butcher__to_third(b2),
    n,
  );
  a3 = found4[0];
  b3 = found4[1];
  w3 = found4[2];
  n = found4[3];
  let q4 = q + butcher__to_fourth(a1, a2, a3);
  let u4 = u + butcher__to_fourth(b1, b2, b3);
  const found5 = creep_step___creep_rates(law, par, g, z3, q4, u4, n);
  a4 = found5[0];
  b4 = found5[1];
  w4 = found5[2];
  n = found5[3];
  z = (xi + 0.5 * h) ** 3 * f * h;
  let q5 = q + butcher__to_fifth(a1, a2, a3, a4);
  let u5 = u + butcher__to_fifth(b1, b2, b3, b4);
  const found6 = creep_step___creep_rates(law, par, g, z, q5, u5, n);
  a5 = found6[0];
  b5 = found6[1];
  w5 = found6[2];
  n = found6[3];
  let q6 = q + butcher__to_sixth(a2, a3, a4, a5);
  let u6 = u + butcher__to_sixth(b2, b3, b4, b5);
  const found7 = creep_step___creep_rates(law, par, g, z, q6, u6, n);
  a6 = found7[0];
  b6 = found7[1];
  w6 = found7[2];
  n = found7[3];
  z = (xi + h) ** 3 * f * h;
  let q7 = q + butcher__to_last(a1, a2, a3, a4, a6);
  let u7 = u + butcher__to_last(b1, b2, b3, b4, b6);
  const found8 = creep_step___creep_rates(law, par, g, z, q7, u7, n);
  a7 = found8[0];
  b7 = found8[1];
  w7 = found8[2];
  n = found8[3];
  let q_end = q + butcher__to_end(a1, a3, a4, a5, a6, a7);
  let u_end = u + butcher__to_end(b1, b3, b4, b5, b6, b7);
  const found9 = creep_step___stress_of_creep(law, par, q_end, u_end, n);
  let tau_end = found9[0];
  let x_end = found9[1];
  let stored = 0.5 * par.shear * (tau_end ** 2 - tau ** 2);
  return [q_end, x_end, butcher__to_end(w1, w3, w4, w5, w6, w7) - stored];
}

/** One step of length h in xi with the rates k1 at its start: q, x and friction work done. */
export function step__step(law, par, g, segment, branch, sign, q, x, span, xi, h, k1) {
  let f = MESH_POWER * span;
  let z = xi * xi * xi * f * h;
  let a1 = k1[0] * z;
  let b1 = k1[1] * z;
  let w1 = k1[2] * z;
  let t = xi + h / 3.0;
  let z3 = t * t * t * f * h;
  let r = step__rates(
    law,
    par,
    g,
    segment,
    branch,
    sign,
    q + butcher__to_second(a1),
    x + butcher__to_second(b1),
  );
  let a2 = r[0] * z3;
  let b2 = r[1] * z3;
  t = xi + (h * 2.0) / 3.0;
  z = t * t * t * f * h;
  r = step__rates(
    law,
    par,
    g,
    segment,
    branch,
    sign,
    q + butcher__to_third(a2),
    x + butcher__to_third(b2),
  );
  let a3 = r[0] * z;
  let b3 = r[1] * z;
  let w3 = r[2] * z;
  let q4 = q + butcher__to_fourth(a1, a2, a3);
  let x4 = x + butcher__to_fourth(b1, b2, b3);
  r = step__rates(law, par, g, segment, branch, sign, q4, x4);
  let a4 = r[0] * z3;
  let b4 = r[1] * z3;
  let w4 = r[2] * z3;
  t = xi + 0.5 * h;
  z = t * t * t * f * h;
  let q5 = q + butcher__to_fifth(a1, a2, a3, a4);
  let x5 = x + butcher__to_fifth(b1, b2, b3, b4);
  r = step__rates(law, par, g, segment, branch, sign, q5, x5);
  let a5 = r[0] * z;
  let b5 = r[1] * z;
  let w5 = r[2] * z;
  let q6 = q + butcher__to_sixth(a2, a3, a4, a5);
  let x6 = x + butcher__to_sixth(b2, b3, b4, b5);
  r = step__rates(law, par, g, segment, branch, sign, q6, x6);
  let a6 = r[0] * z;
  let b6 = r[1] * z;
  let w6 = r[2] * z;
  t = xi + h;
  z = t * t * t * f * h;
  let q7 = q + butcher__to_last(a1, a2, a3, a4, a6);
  let x7 = x + butcher__to_last(b1, b2, b3, b4, b6);
  r = step__rates(law, par, g, segment, branch, sign, q7, x7);
  let a7 = r[0] * z;
  let b7 = r[1] * z;
  let w7 = r[2] * z;
  return [
    q + butcher__to_end(a1, a3, a4, a5, a6, a7),
    x + butcher__to_end(b1, b3, b4, b5, b6, b7),
    butcher__to_end(w1, w3, w4, w5, w6, w7),
  ];
}

/** `step`, or `creep_step` in a steep cell of a table. */
export function march___stride(steep, law, par, g, segment, branch, sign, q, x, span, xi, h, k) {
  if (steep) {
    return creep_step__creep_step(law, par, g, sign, q, x, span, xi, h);
  }
  return step__step(law, par, g, segment, branch, sign, q, x, span, xi, h, k);
}

/** Slip beyond the boundary of branches `boundary` and `boundary + 1` [m]; negative before. */
export function compact__branch_gap(law, segment, boundary, slip, pressure) {
  let mu_pk, residual, slip_pk, slope;
  if (law.kind === TABLE) {
    return slip - law.slips[boundary + 1];
  }
  if (law.kind === LIMIT) {
    return slip - law.coefficients[3] * compact__plateau_at(law, segment, pressure) * pressure;
  }
  const found1 = compact__peak(law, segment, pressure);
  slip_pk = found1[0];
  mu_pk = found1[1];
  if (boundary === RISE) {
    return slip - slip_pk;
  }
  const found2 = compact__tail(law, segment, pressure);
  slope = found2[0];
  residual = found2[1];
  if (slope === 0.0) {
    return -1.0;
  }
  return slip - slip_pk - min(residual - mu_pk, 0.0) / slope;
}

/** Whether a branch ends at larger slips. */
export function cut___has_next(law, branch) {
  if (law.kind === LIMIT) {
    return branch === ELASTIC;
  }
  if (law.kind === TABLE) {
    return branch < law.slips.length - 1;
  }
  return branch < 2;
}

/** How far a state with slip magnitude x is beyond one side of a piece; negative inside. */
export function cut__beyond(law, par, segment, branch, side, q, x) {
  let last = law.edges.length - 1;
  if (side === LOWER_EDGE) {
    return segment >= 0 ? Math.log(law.edges[segment] / par.entry_pressure) - q : -1.0;
  }
  if (side === UPPER_EDGE) {
    return segment < last ? q - Math.log(law.edges[segment + 1] / par.entry_pressure) : -1.0;
  }
  if (side === NO_SLIP) {
    return -x;
  }
  let p = step__pressure_at(par, q);
  if (side === PREVIOUS_BRANCH) {
    return branch > 0 ? -compact__branch_gap(law, segment, branch - 1, x, p) : -1.0;
  }
  if (!cut___has_next(law, branch)) {
    return -1.0;
  }
  return compact__branch_gap(law, segment, branch, x, p);
}

/** Whether a state with slip magnitude x lies in a piece of the law. */
export function cut__within(law, par, segment, branch, q, x) {
  let p = step__pressure_at(par, q);
  let last = law.edges.length - 1;
  if (x < 0.0 || (segment >= 0 && p < law.edges[segment])) {
    return false;
  }
  if (segment < last && p >= law.edges[segment + 1]) {
    return false;
  }
  if (branch === RISE && (law.kind === KNOTS || law.kind === PIECES)) {
    return x <= compact__peak(law, segment, p)[0];
  }
  return (
    cut__beyond(law, par, segment, branch, PREVIOUS_BRANCH, q, x) <= 0.0 &&
    cut__beyond(law, par, segment, branch, NEXT_BRANCH, q, x) <= 0.0
  );
}

/** Cubic through a and b with slopes da and db over h, at the fraction f. */
export function step__hermite(f, h, a, da, b, db) {
  let e = 1.0 - f;
  return e * e * ((1.0 + 2.0 * f) * a + f * h * da) + f * f * ((3.0 - 2.0 * f) * b - e * h * db);
}

/** Where a step first leaves its piece: the fraction of the step and the side crossed. */
export function cut__first_crossing(law, par, segment, branch, sign, h, start, end) {
  let a, b, fa, fb, fm, m, qm, side, xm;
  let first = 1.0;
  let crossed = -1;
  for (let each1 = 0, end1 = 5; each1 < end1; each1++) {
    side = each1;
    fb = cut__beyond(law, par, segment, branch, side, end[0], sign * end[1]);
    if (fb <= 0.0) {
      continue;
    }
    a = 0.0;
    b = 1.0;
    fa = cut__beyond(law, par, segment, branch, side, start[0], sign * start[1]);
    if (fa >= 0.0) {
      b = 0.0;
    } else {
      for (let each2 = 0, end2 = 60; each2 < end2; each2++) {
        m = (a * fb - b * fa) / (fb - fa);
        qm = step__hermite(m, h, start[0], start[2], end[0], end[2]);
        xm = step__hermite(m, h, start[1], start[3], end[1], end[3]);
        fm = cut__beyond(law, par, segment, branch, side, qm, sign * xm);
        if (fm * fb <= 0.0) {
          a = b;
          fa = fb;
        } else {
          fa *= 0.5;
        }
        b = m;
        fb = fm;
        if (Math.abs(b - a) < 1e-12 || fm === 0.0) {
          break;
        }
      }
    }
    if (b < first) {
      first = b;
      crossed = side;
    }
  }
  return [first, crossed];
}

/** How near a cut must land: inner knots of pressure only bend the law's slope. */
export function cut__cut_tolerance(law, segment, side) {
  let last = law.edges.length - 1;
  let smooth =
    law.kind === KNOTS &&
    ((side === LOWER_EDGE && segment > 0) ||
      (side === UPPER_EDGE && 0 <= segment && segment < last - 1));
  if (side === LOWER_EDGE || side === UPPER_EDGE) {
    return smooth ? SMOOTH_CUT_TOLERANCE : CUT_TOLERANCE;
  }
  return SLIP_CUT_TOLERANCE;
}

/** Carry a sliding state from xi to xi_end on a mesh of span xi^4. */
export function march__advance(law, par, g, state, span, xi, xi_end, cut) {
  let cell,
    dq,
    f,
    f_last,
    f_next,
    gap,
    gap_last,
    h,
    high,
    j1,
    jacobian,
    k,
    lag,
    low,
    most,
    p,
    q1,
    r,
    reach,
    s,
    side,
    steep,
    t,
    tolerance,
    tries,
    w1,
    x1;
  let [q, x, work, segment, branch, sign] = state;
  let switches = 0;
  while (xi < xi_end) {
    if (!(-LARGEST_LOG < q && q < LARGEST_LOG && Math.abs(x) < FARTHEST_SLIP)) {
      break;
    }
    h = xi_end - xi;
    k = step__rates(law, par, g, segment, branch, sign, q, x);
    jacobian = MESH_POWER * span * xi * xi * xi;
    dq = Math.abs(k[0]) * jacobian;
    if (dq * h > LARGEST_LOG_STEP) {
      h = LARGEST_LOG_STEP / dq;
    }
    most = NaN;
    if ((law.kind === KNOTS || law.kind === PIECES) && x * k[1] !== 0.0) {
      s = span * xi ** MESH_POWER;
      reach = march___near_no_slip(x / k[1], s, NEAREST * par.length);
      if (span * (xi + h) ** MESH_POWER - s > reach) {
        h = ((s + reach) / span) ** (1.0 / MESH_POWER) - xi;
      }
    }
    if (law.kind === TABLE) {
      most = creep_step__cell_step(law, par, g, segment, branch, sign, q, x);
      cell = branch < law.slips.length - 1 ? law.slips[branch + 1] - law.slips[branch] : Infinity;
      if (Math.abs(k[1]) * span * ((xi + h) ** MESH_POWER - xi ** MESH_POWER) > cell) {
        reach = xi ** MESH_POWER + cell / (Math.abs(k[1]) * span);
        h = reach ** (1.0 / MESH_POWER) - xi;
      }
      reach = span * ((xi + h) ** MESH_POWER - xi ** MESH_POWER);
      if (Math.abs(k[1]) * reach > FEW_STEPS * cell) {
        lag = creep_step__cell_lag(
          law,
          par,
          segment,
          branch,
          q,
          Math.abs(x),
          Math.abs(k[0]) * par.radius,
        );
        if (reach > PART_OF_LAG * lag) {
          h = (xi ** MESH_POWER + (PART_OF_LAG * lag) / span) ** (1.0 / MESH_POWER) - xi;
        }
      }
      if (span * ((xi + h) ** MESH_POWER - xi ** MESH_POWER) > most) {
        h = (xi ** MESH_POWER + most / span) ** (1.0 / MESH_POWER) - xi;
      }
    }
    steep = most === most;
    const found1 = march___stride(steep, law, par, g, segment, branch, sign, q, x, span, xi, h, k);
    q1 = found1[0];
    x1 = found1[1];
    w1 = found1[2];
    tries = 0;
    while (!(Math.abs(q1 - q) < WILD_LOG_STEP && Math.abs(x1) < WILD_SLIP) && tries < 40) {
      tries += 1;
      h *= 0.25;
      const found2 = march___stride(
        steep,
        law,
        par,
        g,
        segment,
        branch,
        sign,
        q,
        x,
        span,
        xi,
        h,
        k,
      );
      q1 = found2[0];
      x1 = found2[1];
      w1 = found2[2];
    }
    if (tries === 40) {
      break;
    }
    if (!cut) {
      p = step__pressure_at(par, q1);
      sign = sign * x1 >= 0.0 ? sign : -sign;
      segment = compact__segment_of(law, p);
      branch = compact__branch_of(law, segment, sign * x1, p);
    } else if (switches < MOST_CUTS && !cut__within(law, par, segment, branch, q1, sign * x1)) {
      switches += 1;
      t = xi + h;
      r = step__rates(law, par, g, segment, branch, sign, q1, x1);
      j1 = MESH_POWER * span * t * t * t;
      const found3 = cut__first_crossing(
        law,
        par,
        segment,
        branch,
        sign,
        h,
        [q, x, k[0] * jacobian, k[1] * jacobian],
        [q1, x1, r[0] * j1, r[1] * j1],
      );
      f = found3[0];
      side = found3[1];
      if (f > 0.0) {
        tolerance = cut__cut_tolerance(law, segment, side);
        if (side === NO_SLIP) {
          tolerance = min(tolerance, 0.001 * Math.abs(x));
        }
        f_last = 0.0;
        gap_last = cut__beyond(law, par, segment, branch, side, q, sign * x);
        low = 0.0;
        high = 1.0;
        for (let each4 = 0, end4 = LANDINGS; each4 < end4; each4++) {
          tries = each4;
          const found5 = march___stride(
            steep,
            law,
            par,
            g,
            segment,
            branch,
            sign,
            q,
            x,
            span,
            xi,
            h * f,
            k,
          );
          q1 = found5[0];
          x1 = found5[1];
          w1 = found5[2];
          gap = cut__beyond(law, par, segment, branch, side, q1, sign * x1);
          if (Math.abs(gap) < tolerance || gap === gap_last || tries === LANDINGS - 1) {
            break;
          }
          [low, high] = gap > 0.0 ? [low, f] : [f, high];
          f_next = f - (gap * (f - f_last)) / (gap - gap_last);
          f_last = f;
          gap_last = gap;
          if (!(low < f_next && f_next < high) || tries > 3) {
            f_next = 0.5 * (low + high);
          }
          f = f_next;
        }
        q = q1;
        x = x1;
        h *= f;
        work += w1;
        xi = min(xi + h, xi_end);
      }
      if (side === LOWER_EDGE) {
        segment -= 1;
      } else if (side === UPPER_EDGE) {
        segment += 1;
      } else if (side === NO_SLIP) {
        sign = -sign;
      } else if (side === PREVIOUS_BRANCH) {
        branch -= 1;
      } else if (side === NEXT_BRANCH) {
        branch += 1;
      }
      continue;
    }
    [q, x, work] = [q1, x1, work + w1];
    xi = h === xi_end - xi ? xi_end : xi + h;
  }
  return new Sliding(q, x, work, segment, branch, sign);
}

/** Carry a state from mesh node `first` over the `span` [m] that is left to the exit. */
export function march__carry_to_exit(law, par, g, state, span, first, steps) {
  let i;
  let h = 1.0 / steps;
  let cut = steps >= FEWEST_CUT_STEPS || law.kind === LIMIT || law.kind === TABLE;
  for (let each1 = first, end1 = steps; each1 < end1; each1++) {
    i = each1;
    state = march__advance(law, par, g, state, span, i * h, (i + 1) * h, cut);
  }
  return state;
}

/** A stuck zone of length `zone`, then sliding to the exit with entry creep ratio g. */
export function stick__stick_slip(law, par, zone, end_creep, g, steps) {
  let length = par.length;
  let compliance = par.shear + par.onset;
  let [tension, creep] =
    zone > 0.0 ? stick__zone_point(par, zone, zone, end_creep) : [par.entry_tension, 0.0];
  let q = Math.log(tension / par.entry_tension);
  let tau = compliance > 0.0 ? creep / compliance : 0.0;
  let entry_tau = compliance > 0.0 ? par.kick / compliance : 0.0;
  let x = par.onset * tau;
  let work = 0.5 * par.onset * (tau * tau - entry_tau * entry_tau);
  let p = par.entry_pressure * Math.exp(q);
  let segment = compact__segment_of(law, p);
  let branch = compact__branch_of(law, segment, Math.abs(x), p);
  let state = new Sliding(q, x, work, segment, branch, par.side);
  if (zone >= length) {
    return state;
  }
  return march__carry_to_exit(law, par, g, state, length - zone, 0, steps);
}

/** Entry creep ratio of an effort, laws without a jump [-]. */
export function effort__ratio_of(par, z) {
  if (par.kick !== 0.0) {
    return par.side * SMALL_RATIO * Math.sinh(z);
  }
  return par.side * SMALL_RATIO * Math.exp(z);
}

/** Slip x in (0, creep] that solves x + (h/G) mu(x, p) p = creep, creep > 0 [m]. */
export function creep_step__slip_at_entry(law, par, creep, q) {
  let branch, dx, f, mu, mu_pk, mu_x, r, slip_pk, x_new;
  let p = step__pressure_at(par, q);
  let shear = par.shear;
  let segment = compact__segment_of(law, p);
  if (law.kind === TABLE) {
    return table_slip__slip_under_table(law, segment, shear * p, p, creep, 1.0)[1];
  }
  let low = 0.0;
  let high = creep;
  let x = creep;
  if (law.kind === KNOTS || law.kind === PIECES) {
    const found1 = compact__peak(law, segment, p);
    slip_pk = found1[0];
    mu_pk = found1[1];
    r = min(creep / slip_pk, 1.0);
    x = creep / (1.0 + ((shear * p * mu_pk) / slip_pk) * (1.0 - Math.log(max(r, SMALLEST))));
  }
  for (let each2 = 0, end2 = 200; each2 < end2; each2++) {
    branch = compact__branch_of(law, segment, x, p);
    const found3 = compact__friction_at(law, segment, branch, x, p);
    mu = found3[0];
    mu_x = found3[1];
    f = x + shear * mu * p - creep;
    if (f > 0.0) {
      high = x;
    } else {
      low = x;
    }
    dx = f / (1.0 + shear * p * mu_x);
    x_new = x - dx;
    if (Math.abs(dx) <= 1e-15 * x) {
      return x_new;
    }
    if (!(low < x_new && x_new < high)) {
      x_new = 0.5 * (low + high);
    }
    if (Math.abs(x_new - x) <= 1e-15 * x) {
      return x_new;
    }
    x = x_new;
  }
  return x;
}

/** March while the creep of the kick is used up, with creep as the independent variable. */
export function march__to_zero_slip(law, par, g, steps) {
  let a,
    branch,
    dq1,
    ds1,
    dw1,
    dx1,
    e,
    i,
    p,
    qs,
    r,
    rate,
    segment,
    stage,
    sum_q,
    sum_s,
    sum_w,
    sum_x,
    weight,
    xs,
    zeta;
  let kick = Math.abs(par.kick);
  let length = par.length;
  let sign = par.kick > 0.0 ? 1.0 : -1.0;
  let q = 0.0;
  let s = 0.0;
  let work = 0.0;
  let x = creep_step__slip_at_entry(law, par, kick, 0.0);
  let h = 1.0 / steps;
  for (let each1 = 0, end1 = steps - 1; each1 < end1; each1++) {
    i = each1;
    p = step__pressure_at(par, q);
    segment = compact__segment_of(law, p);
    branch = compact__branch_of(law, segment, x, p);
    zeta = i * h;
    dq1 = dx1 = ds1 = dw1 = 0.0;
    sum_q = sum_x = sum_s = sum_w = 0.0;
    for (let each2 = 0, end2 = 4; each2 < end2; each2++) {
      stage = each2;
      a = stage === 0 ? 0.0 : stage === 3 ? h : 0.5 * h;
      weight = stage === 0 || stage === 3 ? h / 6.0 : h / 3.0;
      qs = q + a * dq1;
      xs = max(x + a * dx1, 0.0);
      rate = sign * (g + par.entry_tension * -Math.expm1(qs) * par.compliance);
      if (rate >= 0.0) {
        return [0, 0.0, 0.0, 0.0];
      }
      r = step__rates(law, par, g, segment, branch, sign, qs, sign * xs);
      e = 1.0 - zeta - a;
      ds1 = (-4.0 * kick * e * e * e) / rate;
      dq1 = r[0] * ds1;
      dx1 = sign * r[1] * ds1;
      dw1 = r[2] * ds1;
      sum_q += weight * dq1;
      sum_x += weight * dx1;
      sum_s += weight * ds1;
      sum_w += weight * dw1;
    }
    if (s + sum_s >= length) {
      return [2, 0.0, 0.0, 0.0];
    }
    [q, x, s, work] = [q + sum_q, x + sum_x, s + sum_s, work + sum_w];
    if (x <= 0.0) {
      return [0, 0.0, 0.0, 0.0];
    }
  }
  rate = sign * (g + par.entry_tension * -Math.expm1(q) * par.compliance);
  if (rate >= 0.0) {
    return [0, 0.0, 0.0, 0.0];
  }
  let ds = (kick * h ** 4) / -rate;
  if (s + ds >= length) {
    return [2, 0.0, 0.0, 0.0];
  }
  let dq = step__rates(law, par, g, segment, branch, sign, q, sign * x)[0];
  return [1, s + ds, q + 0.5 * ds * dq, work];
}

/** Sliding a short way s past a point of no slip, where creep grows at `rate` (no kick). */
export function march___leave(law, par, rate, q, s) {
  let mu;
  let sign = rate > 0.0 ? 1.0 : -1.0;
  let x = creep_step__slip_at_entry(law, par, Math.abs(rate) * s, q);
  let p = step__pressure_at(par, q);
  let segment = compact__segment_of(law, p);
  let branch = compact__branch_of(law, segment, x, p);
  const found1 = compact__friction_at(law, segment, branch, x, p);
  mu = found1[0];
  let dq = (0.5 * mu * s) / par.radius;
  return new Sliding(q - sign * dq, sign * x, 0.5 * mu * p * x, segment, branch, sign);
}

/** March the whole arc with a law that starts without a jump. */
export function march__sweep(law, par, g, steps) {
  let cell, gone, p, q, rate, s, segment, sign, state, status, work, x;
  let kick = par.kick;
  let length = par.length;
  if (kick !== 0.0) {
    sign = kick > 0.0 ? 1.0 : -1.0;
    x = creep_step__slip_at_entry(law, par, Math.abs(kick), 0.0);
    p = par.entry_pressure;
    segment = compact__segment_of(law, p);
    state = new Sliding(0.0, sign * x, 0.0, segment, compact__branch_of(law, segment, x, p), sign);
    if (sign * g < 0.0 && (law.kind === KNOTS || law.kind === PIECES)) {
      const found1 = march__to_zero_slip(law, par, g, steps);
      status = found1[0];
      s = found1[1];
      q = found1[2];
      work = found1[3];
      if (status === 1) {
        rate = g + par.entry_tension * -Math.expm1(q) * par.compliance;
        cell = (length - s) / steps ** MESH_POWER;
        gone = march___leave(law, par, rate, q, cell);
        state = Object.assign(Object.create(Object.getPrototypeOf(gone)), gone, {
          work: gone.work + work,
        });
        return march__carry_to_exit(law, par, g, state, length - s, 1, steps);
      }
    }
    return march__carry_to_exit(law, par, g, state, length, 0, steps);
  }
  if (g === 0.0) {
    return new Sliding(0.0, 0.0, 0.0, compact__segment_of(law, par.entry_pressure), 0, 1.0);
  }
  if (law.kind === LIMIT || law.kind === TABLE) {
    sign = g > 0.0 ? 1.0 : -1.0;
    state = new Sliding(0.0, 0.0, 0.0, compact__segment_of(law, par.entry_pressure), 0, sign);
    return march__carry_to_exit(law, par, g, state, length, 0, steps);
  }
  state = march___leave(law, par, g, 0.0, length / steps ** MESH_POWER);
  return march__carry_to_exit(law, par, g, state, length, 1, steps);
}

/** Shear stress [Pa] and creep u = x + (h/G) tau [m] of a sliding state. */
export function march__stress_and_creep(law, par, state) {
  let mu;
  let [q, x, , segment, branch, sign] = state;
  if (x === 0.0 && (law.kind === KNOTS || law.kind === PIECES)) {
    return [0.0, 0.0];
  }
  let p = step__pressure_at(par, q);
  const found1 = compact__friction_at(law, segment, branch, sign * x, p);
  mu = found1[0];
  let tau = sign * mu * p;
  return [tau, x + par.shear * tau];
}

/** Exit quantities of a state at the exit. */
export function effort__shot_of(law, par, state, g, zone) {
  const found1 = march__stress_and_creep(law, par, state);
  let tau = found1[0];
  let creep = found1[1];
  return new Shot(state.log_tension, state.slip, creep, tau, state.work, g, zone);
}

/** March one arc to its exit at effort z. */
export function effort__shoot_from(law, par, z, steps) {
  let compliance, creep, end, g, length, state, tau;
  let zone = 0.0;
  steps = effort__mesh_steps(law, par, steps);
  if (quantities__jumps(law)) {
    length = par.length;
    compliance = par.shear + par.onset;
    end = g = 0.0;
    if (compliance === 0.0) {
      zone = length * min(max(1.0 - z, 0.0), 1.0);
      if (z > 1.0) {
        g = (par.side * (z - 1.0) * CREEP_SCALE) / length;
      }
    } else {
      zone = length / (1.0 + max(z, 0.0));
      end = stick__zone_end(law, par, zone)[1];
      if (z < 0.0) {
        end *= 1.0 + z;
      }
      g = stick__zone_creep_ratio(par, zone, end);
    }
    state = stick__stick_slip(law, par, zone, end, g, steps);
    if (zone >= length) {
      creep = stick__zone_point(par, length, length, end)[1];
      tau = compliance > 0.0 ? creep / compliance : 0.0;
      return new Shot(state.log_tension, state.slip, creep, tau, state.work, g, zone);
    }
  } else {
    g = effort__ratio_of(par, z);
    state = march__sweep(law, par, g, steps);
  }
  return effort__shot_of(law, par, state, g, zone);
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
export function roots__rising_root(f, x, reach, low, high, tolerance, slope = 0.0) {
  let b, fb;
  x = min(max(x, low), high);
  let value = f(x);
  if (Math.abs(value) <= tolerance) {
    return [x, value];
  }
  if (slope > 0.0) {
    reach = min((1.1 * Math.abs(value)) / slope, 4.0 * reach);
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

export function newton___dot(one, other) {
  return $sum([...$zip(one, other)].map(([a, b]) => a * b));
}

/** Return the same [-], nan below the table. */
export function resistance__coefficient_at(length) {
  let end, high, low, start;
  let found = length < _ROWS[0][0] ? NaN : _ROWS.at(-1)[1];
  for (const each1 of $pairwise(_ROWS)) {
    [[start, high], [end, low]] = each1;
    if (start <= length && length <= end) {
      return high + ((low - high) * (length - start)) / (end - start);
    }
  }
  return found;
}

/** Return why a conveying length has no coefficient; nothing where it has one. */
export function resistance__no_coefficient(length) {
  if (!Number.isNaN(resistance__coefficient_at(length))) {
    return [];
  }
  let least = _ROWS[0][0];
  return [
    new Problem(
      "" + "is below " + $told(least, false, 6, "g") + " m, where no coefficient C is tabulated",
      "Give secondary_resistance, or a length_coefficient of your own.",
      undefined,
      "length",
      display(length, "length"),
    ),
  ];
}

export function conveyor___known(value, other) {
  return value === null ? other : value;
}

/** Return the problem of a load case in which the belt is pushed. */
export function conveyor___slack(state, least) {
  let where =
    least === state.entry || least === state.exit ? "beside the drive pulley" : "at the far end";
  let message =
    "" +
    "leaves a belt tension of " +
    $text(display(least, "force")) +
    " " +
    $text(where) +
    " in load case " +
    $text(state.name) +
    ", and a belt cannot push";
  let remedy = "Give a larger take-up tension.";
  return new Problem(message, remedy, undefined, "take_up_tension");
}

/** Return the main resistance of one strand, f L g (m'_R + m' cos delta) [N]. */
export function resistance__main_resistance(friction_factor, length, lift, rotating, carried) {
  let cosine = Math.sqrt(1.0 - (lift / length) ** 2);
  return friction_factor * length * GRAVITY * (rotating + carried * cosine);
}

/** Return the gradient resistance of a strand that carries a mass per length up by H [N]. */
export function resistance__slope_resistance(lift, carried) {
  return GRAVITY * lift * carried;
}

/** Return the force that accelerates a strand, a L m' [N]. */
export function resistance__inertia(acceleration, length, moving) {
  return acceleration * length * moving;
}

/** Numbers of one arc at an entry tension [N]. */
export function quantities__parameters_at(entry_tension, geometry) {
  let pressure = entry_tension / (geometry.width * geometry.radius);
  return new Parameters(
    entry_tension,
    pressure,
    geometry.radius,
    geometry.radius * geometry.wrap_angle,
    max(geometry.compliance, LEAST_COMPLIANCE),
    geometry.shear,
    geometry.kick + geometry.kick_coefficient * pressure * Math.sqrt(pressure),
    geometry.width,
    geometry.side,
    geometry.onset,
  );
}
