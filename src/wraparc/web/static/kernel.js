// @ts-nocheck
// Made from the Python source by `make kernel`: change that, not this.
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

export class Description {
  constructor(
    entry_tension,
    exit_tension,
    diameter,
    wrap_angle,
    width,
    axial_stiffness,
    thickness,
    shear_modulus,
    compression_modulus,
    overrun,
    recovery,
    belt_speed,
    wear_coefficient,
    shear_compliance,
    pitch_offset,
    centrifugal,
  ) {
    this.entry_tension = entry_tension;
    this.exit_tension = exit_tension;
    this.diameter = diameter;
    this.wrap_angle = wrap_angle;
    this.width = width;
    this.axial_stiffness = axial_stiffness;
    this.thickness = thickness;
    this.shear_modulus = shear_modulus;
    this.compression_modulus = compression_modulus;
    this.overrun = overrun;
    this.recovery = recovery;
    this.belt_speed = belt_speed;
    this.wear_coefficient = wear_coefficient;
    this.shear_compliance = shear_compliance;
    this.pitch_offset = pitch_offset;
    this.centrifugal = centrifugal;
  }
  *[Symbol.iterator]() {
    yield this.entry_tension;
    yield this.exit_tension;
    yield this.diameter;
    yield this.wrap_angle;
    yield this.width;
    yield this.axial_stiffness;
    yield this.thickness;
    yield this.shear_modulus;
    yield this.compression_modulus;
    yield this.overrun;
    yield this.recovery;
    yield this.belt_speed;
    yield this.wear_coefficient;
    yield this.shear_compliance;
    yield this.pitch_offset;
    yield this.centrifugal;
  }
}

export class Geometry {
  constructor(
    side,
    radius,
    wrap_angle,
    width,
    compliance,
    shear,
    overrun_constant,
    overrun_coefficient,
    left,
  ) {
    this.side = side;
    this.radius = radius;
    this.wrap_angle = wrap_angle;
    this.width = width;
    this.compliance = compliance;
    this.shear = shear;
    this.overrun_constant = overrun_constant;
    this.overrun_coefficient = overrun_coefficient;
    this.left = left;
  }
  *[Symbol.iterator]() {
    yield this.side;
    yield this.radius;
    yield this.wrap_angle;
    yield this.width;
    yield this.compliance;
    yield this.shear;
    yield this.overrun_constant;
    yield this.overrun_coefficient;
    yield this.left;
  }
}

export class Load {
  constructor(
    entry_tension,
    exit_tension,
    creep_limit,
    pressure_min,
    pressure_max,
    slip_max,
    steepest_fall,
  ) {
    this.entry_tension = entry_tension;
    this.exit_tension = exit_tension;
    this.creep_limit = creep_limit;
    this.pressure_min = pressure_min;
    this.pressure_max = pressure_max;
    this.slip_max = slip_max;
    this.steepest_fall = steepest_fall;
  }
  *[Symbol.iterator]() {
    yield this.entry_tension;
    yield this.exit_tension;
    yield this.creep_limit;
    yield this.pressure_min;
    yield this.pressure_max;
    yield this.slip_max;
    yield this.steepest_fall;
  }
}

export class Interface {
  constructor(law, shear, slides, rests) {
    this.law = law;
    this.shear = shear;
    this.slides = slides;
    this.rests = rests;
  }
  *[Symbol.iterator]() {
    yield this.law;
    yield this.shear;
    yield this.slides;
    yield this.rests;
  }
}

export class Guess {
  constructor(entry, leaving, creep) {
    this.entry = entry;
    this.leaving = leaving;
    this.creep = creep;
  }
  *[Symbol.iterator]() {
    yield this.entry;
    yield this.leaving;
    yield this.creep;
  }
}

export class Course {
  constructor(place, creep, tension, stage, ratio) {
    this.place = place;
    this.creep = creep;
    this.tension = tension;
    this.stage = stage;
    this.ratio = ratio;
  }
  *[Symbol.iterator]() {
    yield this.place;
    yield this.creep;
    yield this.tension;
    yield this.stage;
    yield this.ratio;
  }
}

export class Slopes {
  constructor(first, last, first_goal, last_goal) {
    this.first = first;
    this.last = last;
    this.first_goal = first_goal;
    this.last_goal = last_goal;
  }
  *[Symbol.iterator]() {
    yield this.first;
    yield this.last;
    yield this.first_goal;
    yield this.last_goal;
  }
}

export class Met {
  constructor(done, course, slopes, rest, entry, face) {
    this.done = done;
    this.course = course;
    this.slopes = slopes;
    this.rest = rest;
    this.entry = entry;
    this.face = face;
  }
  *[Symbol.iterator]() {
    yield this.done;
    yield this.course;
    yield this.slopes;
    yield this.rest;
    yield this.entry;
    yield this.face;
  }
}

export class Answer {
  constructor(outcome, met) {
    this.outcome = outcome;
    this.met = met;
  }
  *[Symbol.iterator]() {
    yield this.outcome;
    yield this.met;
  }
}

export class Piece {
  constructor(slip, branch) {
    this.slip = slip;
    this.branch = branch;
  }
  *[Symbol.iterator]() {
    yield this.slip;
    yield this.branch;
  }
}

export class Traction {
  constructor(stress, by_creep, by_pressure, slip) {
    this.stress = stress;
    this.by_creep = by_creep;
    this.by_pressure = by_pressure;
    this.slip = slip;
  }
  *[Symbol.iterator]() {
    yield this.stress;
    yield this.by_creep;
    yield this.by_pressure;
    yield this.slip;
  }
}

export class Ends {
  constructor(at_entry, at_exit, tension, kind, goal) {
    this.at_entry = at_entry;
    this.at_exit = at_exit;
    this.tension = tension;
    this.kind = kind;
    this.goal = goal;
  }
  *[Symbol.iterator]() {
    yield this.at_entry;
    yield this.at_exit;
    yield this.tension;
    yield this.kind;
    yield this.goal;
  }
}

export class Solved {
  constructor(done, course, slopes) {
    this.done = done;
    this.course = course;
    this.slopes = slopes;
  }
  *[Symbol.iterator]() {
    yield this.done;
    yield this.course;
    yield this.slopes;
  }
}

export class Limit {
  constructor(kind, most) {
    this.kind = kind;
    this.most = most;
  }
  *[Symbol.iterator]() {
    yield this.kind;
    yield this.most;
  }
}

export class _Tried {
  constructor(creep, carried, course) {
    this.creep = creep;
    this.carried = carried;
    this.course = course;
  }
  *[Symbol.iterator]() {
    yield this.creep;
    yield this.carried;
    yield this.course;
  }
}

export class Point {
  constructor(place, tension, creep, slip, stress) {
    this.place = place;
    this.tension = tension;
    this.creep = creep;
    this.slip = slip;
    this.stress = stress;
  }
  *[Symbol.iterator]() {
    yield this.place;
    yield this.tension;
    yield this.creep;
    yield this.slip;
    yield this.stress;
  }
}

export class Columns {
  constructor(
    position,
    tension,
    wrap_pressure,
    friction,
    friction_used,
    slip,
    creep,
    shear_stress,
    shear_angle,
    sliding,
  ) {
    this.position = position;
    this.tension = tension;
    this.wrap_pressure = wrap_pressure;
    this.friction = friction;
    this.friction_used = friction_used;
    this.slip = slip;
    this.creep = creep;
    this.shear_stress = shear_stress;
    this.shear_angle = shear_angle;
    this.sliding = sliding;
  }
  *[Symbol.iterator]() {
    yield this.position;
    yield this.tension;
    yield this.wrap_pressure;
    yield this.friction;
    yield this.friction_used;
    yield this.slip;
    yield this.creep;
    yield this.shear_stress;
    yield this.shear_angle;
    yield this.sliding;
  }
}

export class Summary {
  constructor(
    entry_tension,
    exit_tension,
    effective_tension,
    tension_ratio,
    exit_creep,
    creep_shrinkage,
    creep_compression,
    creep_global,
    exit_slip,
    entry_creep_ratio,
    exit_creep_ratio,
    peak_shear_stress,
    peak_shear_angle,
    peak_shear_position,
    mean_friction,
    active_arc,
    k_factor,
    outside_tested_share,
    stuck_arc,
    transmitted_power,
    sliding_power,
    shear_loss,
    power_loss,
    efficiency,
    frictional_energy,
    wear_rate,
    identity_error,
  ) {
    this.entry_tension = entry_tension;
    this.exit_tension = exit_tension;
    this.effective_tension = effective_tension;
    this.tension_ratio = tension_ratio;
    this.exit_creep = exit_creep;
    this.creep_shrinkage = creep_shrinkage;
    this.creep_compression = creep_compression;
    this.creep_global = creep_global;
    this.exit_slip = exit_slip;
    this.entry_creep_ratio = entry_creep_ratio;
    this.exit_creep_ratio = exit_creep_ratio;
    this.peak_shear_stress = peak_shear_stress;
    this.peak_shear_angle = peak_shear_angle;
    this.peak_shear_position = peak_shear_position;
    this.mean_friction = mean_friction;
    this.active_arc = active_arc;
    this.k_factor = k_factor;
    this.outside_tested_share = outside_tested_share;
    this.stuck_arc = stuck_arc;
    this.transmitted_power = transmitted_power;
    this.sliding_power = sliding_power;
    this.shear_loss = shear_loss;
    this.power_loss = power_loss;
    this.efficiency = efficiency;
    this.frictional_energy = frictional_energy;
    this.wear_rate = wear_rate;
    this.identity_error = identity_error;
  }
  *[Symbol.iterator]() {
    yield this.entry_tension;
    yield this.exit_tension;
    yield this.effective_tension;
    yield this.tension_ratio;
    yield this.exit_creep;
    yield this.creep_shrinkage;
    yield this.creep_compression;
    yield this.creep_global;
    yield this.exit_slip;
    yield this.entry_creep_ratio;
    yield this.exit_creep_ratio;
    yield this.peak_shear_stress;
    yield this.peak_shear_angle;
    yield this.peak_shear_position;
    yield this.mean_friction;
    yield this.active_arc;
    yield this.k_factor;
    yield this.outside_tested_share;
    yield this.stuck_arc;
    yield this.transmitted_power;
    yield this.sliding_power;
    yield this.shear_loss;
    yield this.power_loss;
    yield this.efficiency;
    yield this.frictional_energy;
    yield this.wear_rate;
    yield this.identity_error;
  }
}

export class Range {
  constructor(pressure_min, pressure_max, slip_max) {
    this.pressure_min = pressure_min;
    this.pressure_max = pressure_max;
    this.slip_max = slip_max;
  }
  *[Symbol.iterator]() {
    yield this.pressure_min;
    yield this.pressure_max;
    yield this.slip_max;
  }
}

export class Read {
  constructor(
    creep,
    slip,
    stress,
    entry_stress,
    creep_ratio,
    loss,
    miss,
    stuck,
    active,
    peak,
    peak_at,
    outside,
  ) {
    this.creep = creep;
    this.slip = slip;
    this.stress = stress;
    this.entry_stress = entry_stress;
    this.creep_ratio = creep_ratio;
    this.loss = loss;
    this.miss = miss;
    this.stuck = stuck;
    this.active = active;
    this.peak = peak;
    this.peak_at = peak_at;
    this.outside = outside;
  }
  *[Symbol.iterator]() {
    yield this.creep;
    yield this.slip;
    yield this.stress;
    yield this.entry_stress;
    yield this.creep_ratio;
    yield this.loss;
    yield this.miss;
    yield this.stuck;
    yield this.active;
    yield this.peak;
    yield this.peak_at;
    yield this.outside;
  }
}

export class Quick {
  constructor(solved, summary, profile, outside, stretches) {
    this.solved = solved;
    this.summary = summary;
    this.profile = profile;
    this.outside = outside;
    this.stretches = stretches;
  }
  *[Symbol.iterator]() {
    yield this.solved;
    yield this.summary;
    yield this.profile;
    yield this.outside;
    yield this.stretches;
  }
}

export class Least {
  constructor(slack, most) {
    this.slack = slack;
    this.most = most;
  }
  *[Symbol.iterator]() {
    yield this.slack;
    yield this.most;
  }
}

export class Carried {
  constructor(creep_limit, tested_slip, gross_slip, gross_creep, least_slack, most_pull) {
    this.creep_limit = creep_limit;
    this.tested_slip = tested_slip;
    this.gross_slip = gross_slip;
    this.gross_creep = gross_creep;
    this.least_slack = least_slack;
    this.most_pull = most_pull;
  }
  *[Symbol.iterator]() {
    yield this.creep_limit;
    yield this.tested_slip;
    yield this.gross_slip;
    yield this.gross_creep;
    yield this.least_slack;
    yield this.most_pull;
  }
}

export class Loaded {
  constructor(law, geometry, load, peaks) {
    this.law = law;
    this.geometry = geometry;
    this.load = load;
    this.peaks = peaks;
  }
  *[Symbol.iterator]() {
    yield this.law;
    yield this.geometry;
    yield this.load;
    yield this.peaks;
  }
}

export class Line {
  constructor(tight, slack, tight_rise, slack_rise) {
    this.tight = tight;
    this.slack = slack;
    this.tight_rise = tight_rise;
    this.slack_rise = slack_rise;
  }
  *[Symbol.iterator]() {
    yield this.tight;
    yield this.slack;
    yield this.tight_rise;
    yield this.slack_rise;
  }
}

export class AtLimit {
  constructor(limit, cause, met) {
    this.limit = limit;
    this.cause = cause;
    this.met = met;
  }
  *[Symbol.iterator]() {
    yield this.limit;
    yield this.cause;
    yield this.met;
  }
}

export class Sliding {
  constructor(place, cause) {
    this.place = place;
    this.cause = cause;
  }
  *[Symbol.iterator]() {
    yield this.place;
    yield this.cause;
  }
}

export class Along {
  constructor(place, met) {
    this.place = place;
    this.met = met;
  }
  *[Symbol.iterator]() {
    yield this.place;
    yield this.met;
  }
}

export class Bracket {
  constructor(low, high) {
    this.low = low;
    this.high = high;
  }
  *[Symbol.iterator]() {
    yield this.low;
    yield this.high;
  }
}

export class Pull {
  constructor(pull, tight, top) {
    this.pull = pull;
    this.tight = tight;
    this.top = top;
  }
  *[Symbol.iterator]() {
    yield this.pull;
    yield this.tight;
    yield this.top;
  }
}

export class Found {
  constructor(
    solved,
    summary,
    capacities,
    place,
    cause,
    lift,
    least_for_slip,
    least_when_covered,
    least_when_wet,
    largest_slip,
    slip_speed,
    covered_creep,
    wet,
    loads,
  ) {
    this.solved = solved;
    this.summary = summary;
    this.capacities = capacities;
    this.place = place;
    this.cause = cause;
    this.lift = lift;
    this.least_for_slip = least_for_slip;
    this.least_when_covered = least_when_covered;
    this.least_when_wet = least_when_wet;
    this.largest_slip = largest_slip;
    this.slip_speed = slip_speed;
    this.covered_creep = covered_creep;
    this.wet = wet;
    this.loads = loads;
  }
  *[Symbol.iterator]() {
    yield this.solved;
    yield this.summary;
    yield this.capacities;
    yield this.place;
    yield this.cause;
    yield this.lift;
    yield this.least_for_slip;
    yield this.least_when_covered;
    yield this.least_when_wet;
    yield this.largest_slip;
    yield this.slip_speed;
    yield this.covered_creep;
    yield this.wet;
    yield this.loads;
  }
}

export class CapacityNumbers {
  constructor(
    creep_limit_capacity,
    creep_limit_margin,
    equivalent_friction,
    least_exit_tension,
    largest_effective_tension,
    tested_slip_capacity,
    tested_slip_margin,
    gross_slip_capacity,
    extrapolated_gross_slip_margin,
    gross_slip_creep,
  ) {
    this.creep_limit_capacity = creep_limit_capacity;
    this.creep_limit_margin = creep_limit_margin;
    this.equivalent_friction = equivalent_friction;
    this.least_exit_tension = least_exit_tension;
    this.largest_effective_tension = largest_effective_tension;
    this.tested_slip_capacity = tested_slip_capacity;
    this.tested_slip_margin = tested_slip_margin;
    this.gross_slip_capacity = gross_slip_capacity;
    this.extrapolated_gross_slip_margin = extrapolated_gross_slip_margin;
    this.gross_slip_creep = gross_slip_creep;
  }
  *[Symbol.iterator]() {
    yield this.creep_limit_capacity;
    yield this.creep_limit_margin;
    yield this.equivalent_friction;
    yield this.least_exit_tension;
    yield this.largest_effective_tension;
    yield this.tested_slip_capacity;
    yield this.tested_slip_margin;
    yield this.gross_slip_capacity;
    yield this.extrapolated_gross_slip_margin;
    yield this.gross_slip_creep;
  }
}

export class Resultant {
  constructor(resultant_force, resultant_angle, belt_safety, most_shaft_load, least_shaft_load) {
    this.resultant_force = resultant_force;
    this.resultant_angle = resultant_angle;
    this.belt_safety = belt_safety;
    this.most_shaft_load = most_shaft_load;
    this.least_shaft_load = least_shaft_load;
  }
  *[Symbol.iterator]() {
    yield this.resultant_force;
    yield this.resultant_angle;
    yield this.belt_safety;
    yield this.most_shaft_load;
    yield this.least_shaft_load;
  }
}

export class LoadGiven {
  constructor(
    entry_tension = null,
    exit_tension = null,
    effective_tension = null,
    torque = null,
    power = null,
  ) {
    this.entry_tension = entry_tension;
    this.exit_tension = exit_tension;
    this.effective_tension = effective_tension;
    this.torque = torque;
    this.power = power;
  }
  *[Symbol.iterator]() {
    yield this.entry_tension;
    yield this.exit_tension;
    yield this.effective_tension;
    yield this.torque;
    yield this.power;
  }
}

export class NipTensions {
  constructor(entry, exit) {
    this.entry = entry;
    this.exit = exit;
  }
  *[Symbol.iterator]() {
    yield this.entry;
    yield this.exit;
  }
}

export class LoadFault {
  constructor(message, remedy, lacks) {
    this.message = message;
    this.remedy = remedy;
    this.lacks = lacks;
  }
  *[Symbol.iterator]() {
    yield this.message;
    yield this.remedy;
    yield this.lacks;
  }
}

const ROUNDING = 1e-12;
const LEAST_TENSION = 0.1;
const MOST_TENSION = 1000000000.0;
const OVERRUN = 1.25;
const LIMIT = 0;
const TABLE = 3;
const PLASTIC = 1;
const BEYOND_CELL = 0.1;
const KNOTS = 1;
const RISE = 0;
const KNOT_STRIDE = 16;
const SMALLEST = 1e-16;
const PIECES = 2;
const PIECE_STRIDE = 25;
const MOST_EXPONENT = 300.0;
const LINE = 1;
const ELASTIC = 0;
const POINT_STEPS = 20000.0;
const NO_PULL = 1e-12;
const SOLVED = 0;
const LEAST_COMPLIANCE = 1e-16;
const NO_SLOPES = new Slopes(NaN, NaN, NaN, NaN);
const FIRST_ELEMENTS = 8;
const GRADING = 2.0;
const C0 = 0.1127016653792583;
const C1 = 0.5;
const C2 = 0.8872983346207417;
const LEAST_CREEP = 1e-16;
const NEAR_PEAK = 0.8;
const LEAST_SHARE = 1e-16;
const NEAR = 1e-5;
const HELD = new Piece(0.0, -1);
const NEWTON = 1e-8;
const ACCURACY = 1e-15;
const RESIDUAL = 2;
const _PIECE = 0.25;
const BREAKAWAY = 1;
const TENSION = 0;
const MESH = 1e-6;
const STIFF = 40.0;
const FIRST_SLIDES = [0.5, 0.1, 0.01, 0.001];
const FIRST_STEPS = 15;
const COARSELY = 0.0001;
const A00 = 0.1388888888888889;
const A01 = -0.03597666752493894;
const A02 = 0.009789444015308318;
const A10 = 0.3002631949808646;
const A11 = 0.2222222222222222;
const A12 = -0.022485417203086805;
const A20 = 0.26798833376246944;
const A21 = 0.48042111196938336;
const A22 = 0.1388888888888889;
const B0 = 0.2777777777777778;
const B1 = 0.4444444444444444;
const B2 = 0.2777777777777778;
const CREEP = 1;
const LEAST_LEFT = 0.2;
const FREELY = 1e-10;
const LEAST_PULL = 1e-5;
const MOST_STRETCH = 0.5;
const FARTHEST = 1000000.0;
const MOST_ROUNDS = 14;
const LONGEST = 2.0;
const F0 = 13.121638910345695;
const F1 = -1.333333333333333;
const F2 = 0.2116944229876385;
const L0 = 19.788305577012366;
const L1 = -14.666666666666666;
const L2 = 6.878361089654304;
const SMALL = 1e-5;
const KINK = 0.0001;
const _S = 2.32379000772445;
const D0 = 0.033810499613777495;
const D1 = -0.07500000000000001;
const D2 = 0.2661895003862225;
const MOST_KINKS = 60;
const LEAST_PART = 1.0;
const MOST_PART = 8.0;
const MOST_ELEMENTS = 400;
const TURN = 0.001;
const KINK_ROUNDS = 2;
const LATER_STEPS = 20;
const MOST_AMPLIFIED = 100.0;
const AMPLIFIED = 10.0;
const ROUGH = 0.001;
const SOFTER = 10.0;
const SOFTEST = 3.0;
const LEAST_SHEAR = 1e-9;
const FIRST_SOFTER = 0.0625;
const MOST_SOFTENED = 60;
const LEAST_SOFTER = 0.97;
const PRESSURES = 5;
const CAPACITY_STEPS = 25000.0;
const ON_THE_RISE = 0.6;
const FIRST_PART = 0.4;
const MOST_LOOKS = 40;
const LOOKS = 14;
const MOST_USED = 0.95;
const LARGEST_FALL = 6.0;
const SLIP = 2;
const FIRST_GOAL = 0.01;
const STEPS = 40;
const LEAST_GROWTH = 1.01;
const WIDER = 1.5;
const CLOSE = 0.001;
const LEAST_GUESS = 1e-7;
const NEARER = 0.01;
const AWAY = 8.0;
const UNSOLVED = 2;
const RATIO_END = 1.0;
const RECORD = 5;
const ALIKE = 1e-12;
const NEXT_SLIP = 1e-300;
const HALVINGS = 45;
const LOBATTO = 0.27639320225002106;
const AT_ENDS = 0.08333333333333333;
const INSIDE = 0.4166666666666667;
const ACTIVE_SHARE = 0.01;
const IDLE = 1e-9;
const CAPACITIES = 30;
const CREEP_LIMIT = 2;
const LEAST = 8;
const HIGHEST = 1000.0;
const MISFIT = 1e-5;
const LEAST_OVER = 0.0001;
const DEEPEST = 3.0;
const ROUNDS = 60;
const NEAR_TOP = 0.0001;
const TESTED_SLIP = 4;
const GROSS_SLIP = 16;
const SLIP_KIND = 2;
const TESTED = 1;
const EARLY = 0.8;
const SLIDES = 0.0635;
const CREEP_KIND = 1;
const FAR = 200.0;
const BY_CREEP = 2;
const BY_SLIP = 4;
const BY_LAW = 16;
const MOST = 2;
const DIFFERENCE = 0.001;
const LEAST_CARRIED = 1e-9;
const _NEAR = 1e-8;
const PLACES = [0.00012, 0.25, 0.5, 0.75, 0.99988];
const ABOUT = 0.9;
const NARROWER = 4;
const BESIDE = 0.00012;
const SIDES = 24;
const GRAVITY = 9.80665;
const ENDS = ["entry_tension", "exit_tension"];
const EFFECTIVE = ["effective_tension", "torque", "power"];
const ONE_TOO_MANY = "Leave one of them out.";
const _ALIKE = 1e-6;
const FEW = "Give two of entry_tension, exit_tension, effective_tension (torque, power).";

/** Effective tension of a torque at the shaft of a pulley, 2 M/D [N]. */
export function load_case__pull_of_torque(torque, diameter) {
  return (2.0 * torque) / diameter;
}

/** Effective tension of a power at a belt speed, P/v [N]. */
export function load_case__pull_of_power(power, speed) {
  return power / speed;
}

/** Effective tension that a drive gives, nan where it gives both tensions [N]. */
export function in_page__pull_of(given) {
  if (given.torque === given.torque) {
    return load_case__pull_of_torque(given.torque, given.diameter + 2.0 * given.pitch_offset);
  }
  if (given.power === given.power) {
    return load_case__pull_of_power(given.power, given.speed);
  }
  return given.effective_tension;
}

/** Return the exit tension; that of the entry where rounding alone sets the two apart [N]. */
export function load_case__exit_behind(entry, leaving) {
  return Math.abs(entry - leaving) <= ROUNDING * entry ? entry : leaving;
}

/** M v^2, what of the tension presses on no pulley [N]. */
export function pitch__centrifugal_force(mass, speed) {
  return mass * speed * speed;
}

/** M v^2 of a belt [N]; 0 where its mass or its speed is not known. */
export function in_page__lift_of(given) {
  let force = pitch__centrifugal_force(given.mass, given.speed);
  return force === force ? force : 0.0;
}

/** Arc of a drive by its numbers. */
export function in_page__description_of(given) {
  let pull = in_page__pull_of(given);
  let entry = given.entry_tension;
  let leaving = given.exit_tension;
  let first = entry === entry ? entry : leaving + pull;
  return new Description(
    first,
    load_case__exit_behind(first, leaving === leaving ? leaving : entry - pull),
    given.diameter,
    given.wrap_angle,
    given.width,
    given.modulus * given.width,
    given.thickness,
    given.shear_modulus,
    given.compression_modulus,
    given.overrun,
    given.recovery,
    given.belt_speed === given.belt_speed ? given.belt_speed : given.speed,
    given.wear_coefficient,
    (given.slip_with_shear ? 0.0 : given.thickness / given.shear_modulus) + given.cover_compliance,
    given.pitch_offset,
    in_page__lift_of(given),
  );
}

/** Radius [m], wrap angle [rad] and width [m] of the same arc without thickness. */
export function pitch__thin_belt(radius, wrap_angle, width, offset) {
  let share = radius / (radius + offset);
  return [radius + offset, wrap_angle * share, width * share];
}

/** Overrun by formula over the entry pressure to the power 1.5 [m/Pa^1.5]. */
export function summary__overrun_coefficient(compliance, radius) {
  let found = (OVERRUN * compliance ** 1.5) / radius ** 0.5;
  return found;
}

/** Extra compliance kappa = 2 h/(B D R E_c), from the recovery of the lagging [1/N]. */
export function summary__recovery_compliance(arc) {
  if (!arc.recovery) {
    return 0.0;
  }
  let squeeze = arc.thickness / arc.compression_modulus;
  return (2.0 * squeeze) / (arc.width * arc.diameter * (0.5 * arc.diameter));
}

/** Numbers of the arc for the solver. */
export function summary__geometry_of(arc) {
  let radius = 0.5 * arc.diameter;
  const found1 = pitch__thin_belt(radius, arc.wrap_angle, arc.width, arc.pitch_offset);
  let pitch = found1[0];
  let wrap = found1[1];
  let width = found1[2];
  let given = arc.overrun === arc.overrun;
  let by_formula = summary__overrun_coefficient(arc.thickness / arc.compression_modulus, radius);
  return new Geometry(
    arc.entry_tension >= arc.exit_tension ? 1.0 : -1.0,
    pitch,
    wrap,
    width,
    1.0 / arc.axial_stiffness + summary__recovery_compliance(arc),
    arc.shear_compliance,
    given ? arc.overrun : 0.0,
    given ? 0.0 : by_formula,
    null,
  );
}

/** Wrap pressure at a tension [N], 2 (T - m v^2)/(B D) [Pa]. */
export function summary__pressure_of(arc, tension) {
  return (2.0 * (tension - arc.centrifugal)) / (arc.width * arc.diameter);
}

/** Whether friction falls so steeply that slip and shear of the lagging are not unique. */
export function summary__too_steep(arc, fall) {
  let tight = max(arc.entry_tension, arc.exit_tension);
  return arc.shear_compliance * summary__pressure_of(arc, tight) * fall <= -1.0;
}

/** Whether a law holds the belt without slip: its friction begins above zero. */
export function quantities__jumps(law) {
  return (
    (law.kind === LIMIT && law.coefficients[3] === 0.0) ||
    (law.kind === TABLE && law.coefficients[0] > 0.0)
  );
}

/** Segment of a pressure [Pa]: -1 below the first edge, n - 1 from the last edge on. */
export function compact__segment_of(law, pressure) {
  let middle;
  let edges = law.edges;
  let n = edges.length;
  if (n === 0 || pressure < edges[0]) {
    return -1;
  }
  if (pressure >= edges[n - 1]) {
    return n - 1;
  }
  let low = 0;
  let high = n - 1;
  while (high - low > 1) {
    middle = Math.floor((low + high) / 2);
    if (pressure >= edges[middle]) {
      low = middle;
    } else {
      high = middle;
    }
  }
  return low;
}

/** A measured table: a cubic in slip for each pressure, blended linearly in pressure. */
export function compact___table(law, segment, branch, slip, pressure) {
  let at, cell, factor, t;
  let edges = law.edges;
  let c = law.coefficients;
  let slips = law.slips;
  let last = edges.length - 1;
  let cells = slips.length;
  t = at = slip - slips[branch];
  if (branch < cells - 1) {
    cell = slips[branch + 1] - slips[branch];
    if (t > (1.0 + BEYOND_CELL) * cell) {
      at = (1.0 + BEYOND_CELL) * cell;
    } else if (t < -BEYOND_CELL * cell) {
      at = -BEYOND_CELL * cell;
    }
  }
  let row = segment >= last ? last : segment;
  let o = 4 * (max(row, 0) * cells + branch);
  let c1 = c[o + 1];
  let c2 = c[o + 2];
  let c3 = c[o + 3];
  let mu_x = c1 + at * (2.0 * c2 + 3.0 * at * c3);
  let mu = c[o] + at * (c1 + at * (c2 + at * c3)) + mu_x * (t - at);
  if (segment < 0 || last < 0) {
    return [mu, mu_x, 0.0];
  }
  if (segment >= last) {
    factor = edges[last] / pressure;
    return [mu * factor, mu_x * factor, (-mu * factor) / pressure];
  }
  o += 4 * cells;
  c1 = c[o + 1];
  c2 = c[o + 2];
  c3 = c[o + 3];
  let high_x = c1 + at * (2.0 * c2 + 3.0 * at * c3);
  let higher = c[o] + at * (c1 + at * (c2 + at * c3)) + high_x * (t - at) - mu;
  let width = edges[segment + 1] - edges[segment];
  let w = (pressure - edges[segment]) / width;
  return [mu + w * higher, mu_x + w * (high_x - mu_x), higher / width];
}

/** Value and derivative of the cubic with coefficients c[o:o+4] at t. */
export function compact___cubic(c, o, t) {
  let a1 = c[o + 1];
  let a2 = c[o + 2];
  let a3 = c[o + 3];
  return [c[o] + t * (a1 + t * (a2 + t * a3)), a1 + t * (2.0 * a2 + 3.0 * t * a3)];
}

/** Value and derivative of a trend line f(c0 + c1 v + c2 v^2 + c3 v^3). */
export function compact___trend(c, o, p) {
  let logarithmic = c[o + 4] !== 0.0;
  let v = logarithmic ? Math.log(p) : p;
  const found1 = compact___cubic(c, o, v);
  let y = found1[0];
  let dy = found1[1];
  if (logarithmic) {
    dy /= p;
  }
  if (c[o + 5] !== 0.0) {
    y = c[o + 5] * Math.exp(y);
    dy *= y;
  }
  return [y, dy];
}

/** Peak slip [m], peak friction [-] and their derivatives by pressure, integral-log laws. */
export function compact__peak(law, segment, pressure) {
  let friction, friction_p, o, slip, slip_p, t;
  let edges = law.edges;
  let c = law.coefficients;
  let last = edges.length - 1;
  if (law.kind === KNOTS) {
    if (segment < 0) {
      return [c[0], c[4], 0.0, 0.0];
    }
    if (segment >= last) {
      segment = last - 1;
      pressure = edges[last];
    }
    o = segment * KNOT_STRIDE;
    t = pressure - edges[segment];
    const found1 = compact___cubic(c, o, t);
    slip = found1[0];
    slip_p = found1[1];
    const found2 = compact___cubic(c, o + 4, t);
    friction = found2[0];
    friction_p = found2[1];
    return [slip, friction, slip_p, friction_p];
  }
  let held = segment < 0;
  if (held) {
    segment = 0;
    pressure = edges[0];
  } else if (segment >= last) {
    segment = last - 1;
    pressure = edges[last];
  }
  o = segment * PIECE_STRIDE;
  const found3 = compact___trend(c, o, pressure);
  let a = found3[0];
  let a_p = found3[1];
  const found4 = compact___trend(c, o + 6, pressure);
  let b = found4[0];
  let b_p = found4[1];
  let unit = c[o + 24];
  let number = Math.exp(min(max(b / a - 1.0, -MOST_EXPONENT), MOST_EXPONENT));
  if (held) {
    return [unit * number, -a * number, 0.0, 0.0];
  }
  let number_p = (number * (b_p - (b * a_p) / a)) / a;
  return [unit * number, -a * number, unit * number_p, -a_p * number - a * number_p];
}

/** Post-peak slope [1/m], residual friction [-] and their derivatives by pressure. */
export function compact__tail(law, segment, pressure) {
  let o, residual, residual_p, slope, slope_p, t;
  let kind = law.kind;
  let edges = law.edges;
  let c = law.coefficients;
  let last = edges.length - 1;
  let held = segment < 0;
  if (held) {
    if (kind === KNOTS) {
      return [c[8], c[12], 0.0, 0.0];
    }
    segment = 0;
    pressure = edges[0];
  } else if (segment >= last) {
    segment = last - 1;
    pressure = edges[last];
  }
  if (kind === KNOTS) {
    o = segment * KNOT_STRIDE;
    t = pressure - edges[segment];
    const found1 = compact___cubic(c, o + 8, t);
    slope = found1[0];
    slope_p = found1[1];
    const found2 = compact___cubic(c, o + 12, t);
    residual = found2[0];
    residual_p = found2[1];
  } else {
    o = segment * PIECE_STRIDE;
    const found3 = compact___trend(c, o + 12, pressure);
    slope = found3[0];
    slope_p = found3[1];
    const found4 = compact___trend(c, o + 18, pressure);
    residual = found4[0];
    residual_p = found4[1];
  }
  if (held) {
    return [slope, residual, 0.0, 0.0];
  }
  return [slope, residual, slope_p, residual_p];
}

/** The limit mu_0 (p / p_0)^-n and its derivative by pressure. */
export function compact___limit(c, pressure) {
  if (c[2] === 0.0) {
    return [c[0], 0.0];
  }
  let at = max(pressure, 1e-12);
  let mu = c[0] * (at / c[1]) ** -c[2];
  return [mu, (-c[2] * mu) / at];
}

/** Friction held below the tested pressures, the traction held above them. */
export function compact___held(law, segment, pressure, mu, mu_x, mu_p) {
  let factor;
  let last = law.edges.length - 1;
  if (last >= 0 && segment >= last) {
    factor = law.edges[last] / pressure;
    return [mu * factor, mu_x * factor, (-mu * factor) / pressure];
  }
  if (segment < 0 && 0 <= last) {
    return [mu, mu_x, 0.0];
  }
  return [mu, mu_x, mu_p];
}

/** Friction of one piece of a law and its derivatives. */
export function compact__friction_at(law, segment, branch, slip, pressure) {
  let d,
    form,
    lr,
    m1,
    m2,
    m3,
    mu,
    mu_p,
    mu_pk,
    mu_pk_p,
    mu_x,
    o,
    r,
    residual,
    residual_p,
    slip_pk,
    slip_pk_p,
    slope,
    slope_p,
    t,
    x1,
    x2,
    x3;
  let kind = law.kind;
  let edges = law.edges;
  let c = law.coefficients;
  if (kind === TABLE) {
    return compact___table(law, segment, branch, slip, pressure);
  }
  let last = edges.length - 1;
  if (kind === KNOTS && branch === RISE && 0 <= segment && segment < last) {
    o = segment * KNOT_STRIDE;
    t = pressure - edges[segment];
    x1 = c[o + 1];
    x2 = c[o + 2];
    x3 = c[o + 3];
    m1 = c[o + 5];
    m2 = c[o + 6];
    m3 = c[o + 7];
    slip_pk = c[o] + t * (x1 + t * (x2 + t * x3));
    mu_pk = c[o + 4] + t * (m1 + t * (m2 + t * m3));
    r = slip / slip_pk;
    if (r < SMALLEST) {
      r = SMALLEST;
    }
    lr = Math.log(r);
    form = r - r * lr;
    return [
      mu_pk * form,
      (-mu_pk * lr) / slip_pk,
      (m1 + t * (2.0 * m2 + 3.0 * t * m3)) * form +
        (mu_pk * lr * r * (x1 + t * (2.0 * x2 + 3.0 * t * x3))) / slip_pk,
    ];
  }
  let at = pressure;
  if (segment >= last && last >= 0) {
    at = edges[last];
  } else if (segment < 0 && last >= 0) {
    at = edges[0];
  }
  if (kind === KNOTS || kind === PIECES) {
    const found1 = compact__peak(law, segment, pressure);
    slip_pk = found1[0];
    mu_pk = found1[1];
    slip_pk_p = found1[2];
    mu_pk_p = found1[3];
    if (branch === RISE) {
      r = max(slip / slip_pk, SMALLEST);
      lr = Math.log(r);
      form = r - r * lr;
      mu = mu_pk * form;
      mu_x = (-mu_pk * lr) / slip_pk;
      mu_p = mu_pk_p * form + (mu_pk * lr * r * slip_pk_p) / slip_pk;
    } else {
      const found2 = compact__tail(law, segment, pressure);
      slope = found2[0];
      residual = found2[1];
      slope_p = found2[2];
      residual_p = found2[3];
      if (branch === LINE) {
        d = slip - slip_pk;
        mu = mu_pk + slope * d;
        mu_x = slope;
        mu_p = mu_pk_p + slope_p * d - slope * slip_pk_p;
      } else {
        mu_x = 0.0;
        [mu, mu_p] = residual < mu_pk ? [residual, residual_p] : [mu_pk, mu_pk_p];
      }
    }
  } else if (kind === LIMIT && branch === ELASTIC) {
    mu_x = 1.0 / (c[3] * pressure);
    mu = slip * mu_x;
    return [mu, mu_x, -mu / pressure];
  } else {
    mu_x = 0.0;
    const found3 = compact___limit(c, at);
    mu = found3[0];
    mu_p = found3[1];
  }
  return compact___held(law, segment, pressure, mu, mu_x, mu_p);
}

/** Largest traction that a law holds without slip [Pa]; 0 of a law that rises from nothing. */
export function traction__held_stress(law, pressure) {
  let segment = compact__segment_of(law, pressure);
  let branch = law.kind === LIMIT ? PLASTIC : 0;
  return compact__friction_at(law, segment, branch, 0.0, pressure)[0] * pressure;
}

/** Creep up to which a law that jumps holds the belt without slip at a pressure [m]. */
export function summary__held_creep(law, shear, pressure) {
  return (shear + law.onset_compliance) * traction__held_stress(law, pressure);
}

/** Whether the overrun is more than a law that jumps holds: no creep at rest is unique then. */
export function summary__overrun_loosens(law, geometry, pressure) {
  if (!quantities__jumps(law)) {
    return false;
  }
  let overrun = Math.abs(
    geometry.overrun_constant + geometry.overrun_coefficient * pressure * Math.sqrt(pressure),
  );
  return overrun > 0.0 && overrun > summary__held_creep(law, geometry.shear, pressure);
}

/** Whether it is for the server to say what is wrong with an arc. */
export function in_page__refused(law, arc, fall) {
  let entry = arc.entry_tension;
  let leaving = arc.exit_tension;
  if (!(min(entry, leaving) >= LEAST_TENSION && max(entry, leaving) <= MOST_TENSION)) {
    return true;
  }
  if (arc.centrifugal >= min(entry, leaving)) {
    return true;
  }
  let geometry = summary__geometry_of(arc);
  let pressure = summary__pressure_of(arc, entry);
  return summary__too_steep(arc, fall) || summary__overrun_loosens(law, geometry, pressure);
}

/** Tensions and limits of an arc. */
export function in_page__load_of(given, arc, tested) {
  let high, low, slip;
  low = high = slip = NaN;
  if (tested !== null) {
    low = tested.pressure_min;
    high = tested.pressure_max;
    slip = tested.slip_max;
  }
  let limit = given.creep_limit;
  let fall = given.steepest_fall;
  let lift = arc.centrifugal;
  return new Load(arc.entry_tension - lift, arc.exit_tension - lift, limit, low, high, slip, fall);
}

/** An arc whose solver ends after so many steps, unless they are counted already. */
export function quantities__counted(arc, most) {
  return arc.left === null
    ? Object.assign(Object.create(Object.getPrototypeOf(arc)), arc, { left: [most] })
    : arc;
}

/** Traction of an arc by its law. */
export function meet__interface(law, arc) {
  let rigid = quantities__jumps(law) && arc.shear === 0.0;
  return new Interface(law, arc.shear, rigid ? arc.side : 0.0, false);
}

/** C = 1/EA' [1/N]. */
export function collocation__compliance_of(arc) {
  return max(arc.compliance, LEAST_COMPLIANCE);
}

/** An arc that is held all along, by what is known of its ends and K [-]. */
export function meet__resting(face, arc, at, ratio) {
  let leaving = at.leaving;
  let course = new Course(
    [0.0, 0.0],
    $repeated([at.creep], 2),
    $repeated([leaving], 2),
    $repeated([leaving], 3),
    ratio,
  );
  return new Met(true, course, NO_SLOPES, arc.radius * arc.wrap_angle, at.entry, face);
}

/** Overrun x_c at an entry tension [m], and its slope by that [m/N]. */
export function collocation__overrun_at(arc, tension) {
  let area = arc.width * arc.radius;
  let grown = arc.overrun_coefficient * (tension / area) ** 1.5;
  return [arc.overrun_constant + grown, (1.5 * grown) / tension];
}

/** A first guess on a mesh graded to the entry: ln T falls evenly, creep grows to `end` [m]. */
export function collocation__first_course(arc, length, entry, leaving, end) {
  let h, i;
  let n = FIRST_ELEMENTS;
  let fall = Math.log(entry / leaving);
  let start = collocation__overrun_at(arc, entry)[0];
  let shares = [...$range(n + 1)].map((i) => (i / n) ** GRADING);
  let stage = [];
  for (let each1 = 0, end1 = n; each1 < end1; each1++) {
    i = each1;
    h = shares[i + 1] - shares[i];
    stage.push(...[...[C0, C1, C2]].map((c) => entry * Math.exp(-fall * (shares[i] + c * h))));
  }
  return new Course(
    [...shares].map((share) => length * share),
    [...shares].map((share) => start + (end - start) * share),
    [...shares].map((share) => entry * Math.exp(-fall * share)),
    stage,
    (end - start) / length + collocation__compliance_of(arc) * 0.5 * (entry + leaving),
  );
}

/** A belt that nothing drives: it rests, and no stress is on it. */
export function answer___still(face, arc, tension) {
  if (face.slides !== 0.0) {
    return meet__resting(
      face,
      arc,
      new Guess(tension, tension, 0.0),
      collocation__compliance_of(arc) * tension,
    );
  }
  let course = collocation__first_course(arc, arc.radius * arc.wrap_angle, tension, tension, 0.0);
  return new Met(true, course, NO_SLOPES, 0.0, tension, face);
}

/** Largest friction a law offers at a pressure at any slip [-]. */
export function compact__plateau_at(law, segment, pressure) {
  let branch, mu;
  let kind = law.kind;
  let edges = law.edges;
  let slips = law.slips;
  let last = edges.length - 1;
  if (kind === KNOTS || kind === PIECES) {
    const found1 = compact__peak(law, segment, pressure);
    mu = found1[1];
    if (last >= 0 && segment >= last) {
      mu *= edges[last] / pressure;
    }
    return mu;
  }
  if (kind === LIMIT) {
    const found2 = compact__friction_at(law, segment, PLASTIC, 0.0, pressure);
    mu = found2[0];
    return mu;
  }
  let best = 0.0;
  for (let each3 = 0, end3 = slips.length; each3 < end3; each3++) {
    branch = each3;
    const found4 = compact__friction_at(law, segment, branch, slips[branch], pressure);
    mu = found4[0];
    best = max(best, mu);
  }
  return best;
}

/** Largest traction of a law at a pressure, at any slip [Pa]. */
export function traction__plateau_stress(law, pressure) {
  return compact__plateau_at(law, compact__segment_of(law, pressure), pressure) * pressure;
}

/** Slip over peak slip r <= 1 on the rise of the integral-log law: r + k r (1 - ln r) = w. */
export function traction___rise(k, w) {
  let change, lr, miss, slope;
  let short = 1.0 + k - w;
  let near = short > 0.0 ? (2.0 * short) / (1.0 + Math.sqrt(1.0 + 2.0 * k * short)) : 0.0;
  let r = near < NEAR_PEAK ? 1.0 - near : w / (1.0 + k * (1.0 - Math.log(min(w, 1.0))));
  for (let each1 = 0, end1 = 30; each1 < end1; each1++) {
    lr = Math.log(r);
    miss = r + k * r * (1.0 - lr) - w;
    slope = 1.0 - k * lr;
    change = miss / (slope + (0.5 * miss * k) / (r * slope));
    r -= change;
    if (r < LEAST_SHARE) {
      r = LEAST_SHARE;
    } else if (r > 1.0) {
      r = 1.0;
    }
    if (-NEAR * r <= change && change <= NEAR * r) {
      break;
    }
  }
  return r;
}

/** Limit of friction [-] and its derivative by pressure [1/Pa], for a law with a limit. */
export function compact__limit_at(law, segment, pressure) {
  let last = law.edges.length - 1;
  let at = pressure;
  if (last >= 0 && segment >= last) {
    at = law.edges[last];
  } else if (segment < 0 && 0 <= last) {
    at = law.edges[0];
  }
  const found1 = compact___limit(law.coefficients, at);
  let mu = found1[0];
  let mu_p = found1[1];
  const found2 = compact___held(law, segment, pressure, mu, 0.0, mu_p);
  mu = found2[0];
  mu_p = found2[2];
  return [mu, mu_p];
}

/** Of a law with a limit, reached elastically or at once. */
export function traction___under_limit(law, segment, ease, pressure, creep) {
  let limit = compact__limit_at(law, segment, pressure)[0];
  let onset = law.coefficients[3] * pressure;
  if (creep > (ease + onset) * limit) {
    return new Piece(creep - ease * limit, PLASTIC);
  }
  if (onset > 0.0) {
    return new Piece((creep * onset) / (ease + onset), ELASTIC);
  }
  return ease > 0.0 ? HELD : new Piece(creep, PLASTIC);
}

/** Of a measured table: the cell whose creeps hold it, then Newton's method in a bracket. */
export function traction___in_table(law, segment, ease, pressure, creep) {
  let change, inside, miss, new_, slope, t;
  let c = law.coefficients;
  let slips = law.slips;
  let edges = law.edges;
  let cells = slips.length;
  let last = edges.length - 1;
  let o = 4 * cells * max(min(segment, last), 0);
  let up = o;
  let w = 0.0;
  if (0 <= segment && segment < last) {
    up = o + 4 * cells;
    w = (pressure - edges[segment]) / (edges[segment + 1] - edges[segment]);
  }
  if (segment >= last && last >= 0) {
    ease *= edges[last] / pressure;
  }
  let before = ease * (c[o] + w * (c[up] - c[o]));
  let cell = 0;
  if (creep <= before) {
    return HELD;
  }
  let after = before;
  while (cell < cells - 1) {
    [o, up] = [o + 4, up + 4];
    after = slips[cell + 1] + ease * (c[o] + w * (c[up] - c[o]));
    if (creep <= after) {
      break;
    }
    before = after;
    cell += 1;
  }
  if (cell === cells - 1) {
    return new Piece(slips[cell] + creep - after, cell);
  }
  let low = slips[cell];
  let high = slips[cell + 1];
  let start = slips[cell];
  [o, up] = [o - 4, up - 4];
  let c0 = c[o] + w * (c[up] - c[o]);
  let c1 = c[o + 1] + w * (c[up + 1] - c[o + 1]);
  let c2 = c[o + 2] + w * (c[up + 2] - c[o + 2]);
  let c3 = c[o + 3] + w * (c[up + 3] - c[o + 3]);
  let x = low + ((high - low) * (creep - before)) / (after - before);
  for (let each1 = 0, end1 = 100; each1 < end1; each1++) {
    t = x - start;
    miss = x + ease * (c0 + t * (c1 + t * (c2 + t * c3))) - creep;
    [low, high] = miss > 0.0 ? [low, x] : [x, high];
    slope = 1.0 + ease * (c1 + t * (2.0 * c2 + 3.0 * t * c3));
    new_ = slope > 0.0 ? x - miss / slope : low;
    inside = low < new_ && new_ < high;
    if (!inside) {
      new_ = 0.5 * (low + high);
    }
    [change, x] = [Math.abs(new_ - x), new_];
    if (change <= (inside ? NEWTON : ACCURACY) * x) {
      break;
    }
  }
  return new Piece(x, cell);
}

/** Share of friction that is left where traction is held, above the tested pressures [-]. */
export function traction___hold(law, segment, pressure) {
  let last = law.edges.length - 1;
  return segment >= last && last >= 0 ? law.edges[last] / pressure : 1.0;
}

/** Slip and branch of a law at a magnitude of creep, > 0 [m]: u = x + c mu(x, p) p inverted. */
export function traction__piece_at(law, segment, shear, pressure, creep) {
  let mu_pk, residual, slip_pk, slope;
  let ease = shear * pressure;
  if (law.kind === LIMIT) {
    return traction___under_limit(law, segment, ease, pressure, creep);
  }
  if (law.kind === TABLE) {
    return traction___in_table(law, segment, ease, pressure, creep);
  }
  const found1 = compact__peak(law, segment, pressure);
  slip_pk = found1[0];
  mu_pk = found1[1];
  let hold = traction___hold(law, segment, pressure);
  mu_pk *= hold;
  let beyond = creep - slip_pk - ease * mu_pk;
  if (beyond <= 0.0) {
    return new Piece(slip_pk * traction___rise((ease * mu_pk) / slip_pk, creep / slip_pk), RISE);
  }
  const found2 = compact__tail(law, segment, pressure);
  slope = found2[0];
  residual = found2[1];
  [slope, residual] = [hold * slope, min(hold * residual, mu_pk)];
  let line = beyond / (1.0 + ease * slope);
  if (mu_pk + slope * line >= residual) {
    return new Piece(slip_pk + line, LINE);
  }
  return new Piece(creep - ease * residual, RESIDUAL);
}

/** Traction at a creep of either sign. Most of the time of a solve is spent here and in `_rise`. */
export function traction__traction(law, shear, pressure, creep) {
  let branch, c, form, lr, m1, m2, m3, mu_pk, o, r, slip_pk, t, x1, x2, x3;
  let sign = creep >= 0.0 ? 1.0 : -1.0;
  let whole = sign * creep;
  let size = whole < LEAST_CREEP ? LEAST_CREEP : whole;
  let segment = compact__segment_of(law, pressure);
  let ease = shear * pressure;
  let slip = -1.0;
  let mu = 0.0;
  let mu_x = 0.0;
  let mu_p = 0.0;
  if (law.kind === KNOTS && 0 <= segment && segment < law.edges.length - 1) {
    c = law.coefficients;
    o = segment * KNOT_STRIDE;
    t = pressure - law.edges[segment];
    x1 = c[o + 1];
    x2 = c[o + 2];
    x3 = c[o + 3];
    m1 = c[o + 5];
    m2 = c[o + 6];
    m3 = c[o + 7];
    slip_pk = c[o] + t * (x1 + t * (x2 + t * x3));
    mu_pk = c[o + 4] + t * (m1 + t * (m2 + t * m3));
    if (size - slip_pk - ease * mu_pk <= 0.0) {
      slip = slip_pk * traction___rise((ease * mu_pk) / slip_pk, size / slip_pk);
      r = slip / slip_pk;
      if (r < SMALLEST) {
        r = SMALLEST;
      }
      lr = Math.log(r);
      form = r - r * lr;
      mu_x = (-mu_pk * lr) / slip_pk;
      mu = mu_pk * form;
      mu_p = (m1 + t * (2.0 * m2 + 3.0 * t * m3)) * form;
      mu_p += (mu_pk * lr * r * (x1 + t * (2.0 * x2 + 3.0 * t * x3))) / slip_pk;
    }
  }
  if (slip < 0.0) {
    const found1 = traction__piece_at(law, segment, shear, pressure, size);
    slip = found1.slip;
    branch = found1.branch;
    if (branch < 0) {
      return new Traction(creep / shear, 1.0 / shear, 0.0, 0.0);
    }
    const found2 = compact__friction_at(law, segment, branch, slip, pressure);
    mu = found2[0];
    mu_x = found2[1];
    mu_p = found2[2];
  }
  let stiff = 1.0 / (1.0 + ease * mu_x);
  let scale = whole / size;
  return new Traction(
    sign * mu * pressure * scale,
    pressure * mu_x * stiff,
    sign * (mu + pressure * mu_p) * stiff * scale,
    sign * slip * scale,
  );
}

/** Creep at which the mean friction of an arc is used at its mean tension [m]. */
export function collocation__mean_creep(face, arc, entry, leaving, used = 0.95) {
  let middle;
  let area = arc.width * arc.radius;
  let fall = Math.abs(Math.log(entry / leaving));
  let p = Math.sqrt(entry * leaving) / area;
  let stress = min((fall / arc.wrap_angle) * p, used * traction__plateau_stress(face.law, p));
  if (stress <= 0.0) {
    return 0.0;
  }
  let high = 1e-9;
  while (traction__traction(face.law, face.shear, p, high).stress < stress && high < 1000.0) {
    high *= 4.0;
  }
  let low = 0.25 * high;
  for (let each1 = 0, end1 = 12; each1 < end1; each1++) {
    middle = Math.sqrt(low * high);
    if (traction__traction(face.law, face.shear, p, middle).stress < stress) {
      low = middle;
    } else {
      high = middle;
    }
  }
  return arc.side * high;
}

/** Segment below a pressure [Pa], and how far ln p may fall in it in one piece. */
export function gross_slip___piece(law, p) {
  let segment = compact__segment_of(law, p * (1.0 - 1e-12));
  return [segment, segment >= 0 ? min(_PIECE, Math.log(p / law.edges[segment])) : _PIECE];
}

/** Friction a law is left with at a pressure, at slips without bound [-]. */
export function compact__residual_at(law, segment, pressure) {
  let mu, residual, slope;
  let kind = law.kind;
  let edges = law.edges;
  let slips = law.slips;
  let last = edges.length - 1;
  if (kind === KNOTS || kind === PIECES) {
    const found1 = compact__peak(law, segment, pressure);
    mu = found1[1];
    const found2 = compact__tail(law, segment, pressure);
    slope = found2[0];
    residual = found2[1];
    if (slope < 0.0) {
      mu = min(residual, mu);
    }
    if (last >= 0 && segment >= last) {
      mu *= edges[last] / pressure;
    }
    return mu;
  }
  if (kind === LIMIT) {
    return compact__plateau_at(law, segment, pressure);
  }
  let cell = slips.length - 1;
  const found3 = compact__friction_at(law, segment, cell, slips[cell], pressure);
  mu = found3[0];
  return mu;
}

/** Largest friction of a law at a pressure, or what is left of it [-]. */
export function gross_slip___friction(law, segment, pressure, left) {
  if (left) {
    return compact__residual_at(law, segment, pressure);
  }
  return compact__plateau_at(law, segment, pressure);
}

/** Wrap angle over which ln T falls from -q to -q - span in one piece. */
export function gross_slip___angle(law, pressure, segment, q, span, left) {
  let node, p, weight;
  let total = 0.0;
  for (const each1 of [
    [0.0, 128.0 / 225.0],
    [-0.5384693101056831, 0.47862867049936647],
    [0.5384693101056831, 0.47862867049936647],
    [-0.906179845938664, 0.23692688505618908],
    [0.906179845938664, 0.23692688505618908],
  ]) {
    [node, weight] = each1;
    p = pressure * Math.exp(-q - 0.5 * span * (1.0 + node));
    total += weight / gross_slip___friction(law, segment, p, left);
  }
  return 0.5 * span * total;
}

/** ln(tight/slack) at gross slip. */
export function gross_slip___capacity(law, tight_pressure, wrap_angle, left) {
  let change, f, mu, part, segment, span, taken;
  let q = 0.0;
  let angle = wrap_angle;
  for (let each1 = 0, end1 = 4 * law.edges.length + 400; each1 < end1; each1++) {
    const found2 = gross_slip___piece(law, tight_pressure * Math.exp(-q));
    segment = found2[0];
    span = found2[1];
    taken = gross_slip___angle(law, tight_pressure, segment, q, span, left);
    if (taken < angle) {
      angle -= taken;
      q += span;
      continue;
    }
    part = (span * angle) / taken;
    for (let each3 = 0, end3 = 50; each3 < end3; each3++) {
      f = gross_slip___angle(law, tight_pressure, segment, q, part, left) - angle;
      mu = gross_slip___friction(law, segment, tight_pressure * Math.exp(-q - part), left);
      change = f * mu;
      part -= change;
      if (Math.abs(change) < 1e-15) {
        break;
      }
    }
    return q + part;
  }
  return q;
}

/** ln(tight/slack) at gross slip with the largest friction of the law everywhere. */
export function gross_slip__plateau_capacity(law, tight_pressure, wrap_angle) {
  return gross_slip___capacity(law, tight_pressure, wrap_angle, false);
}

/** An arc that meets nothing. */
export function meet__unmet(face, at) {
  return new Met(false, at, NO_SLOPES, 0.0, at.tension[0], face);
}

/** Both tensions given [N]: the operating point. */
export function collocation__between_tensions(entry, leaving) {
  return new Ends(1.0, 0.0, entry, TENSION, leaving);
}

/** Shear-lag length l = sqrt(c EA'/B) of a lagging that holds the belt [m]. */
export function collocation__lag_length(arc) {
  return Math.sqrt(arc.shear / (arc.width * collocation__compliance_of(arc)));
}

/** Whether a rest arc that is much longer than l may stand at the entry. */
export function meet__may_rest(law, arc) {
  return (
    quantities__jumps(law) && STIFF * collocation__lag_length(arc) < arc.radius * arc.wrap_angle
  );
}

/** Tension per creep that is taken up at the end of a held belt much longer than l, B l/c [N/m]. */
export function collocation__held_stiffness(arc) {
  return (arc.width * collocation__lag_length(arc)) / arc.shear;
}

/** An arc that is held all along by what is known of its ends; None where it is not. */
export function meet__held_along(face, arc, at) {
  let leaving = at.leaving;
  let creep = at.creep;
  if (leaving <= 0.0) {
    return null;
  }
  if (
    Math.abs(creep) >
    arc.shear * traction__held_stress(face.law, leaving / (arc.width * arc.radius))
  ) {
    return null;
  }
  let ratio = collocation__compliance_of(arc) * leaving + creep / collocation__lag_length(arc);
  return meet__resting(face, arc, at, ratio);
}

/** An arc that is held all along, much longer than l; None where it is not. */
export function meet___at_rest(face, arc, ends, guess) {
  if (ends.kind !== TENSION || ends.at_entry !== 1.0) {
    return null;
  }
  let creep =
    (guess.entry - guess.leaving) / collocation__held_stiffness(arc) -
    collocation__overrun_at(arc, guess.entry)[0];
  return meet__held_along(
    face,
    arc,
    Object.assign(Object.create(Object.getPrototypeOf(guess)), guess, { creep: creep }),
  );
}

/** Traction mu(x, p) p at a magnitude of slip, > 0 [Pa], and its slope by p at that slip. */
export function traction__stress_of_slip(law, pressure, slip) {
  let segment = compact__segment_of(law, pressure);
  let branch = traction__piece_at(law, segment, 0.0, pressure, slip).branch;
  const found1 = compact__friction_at(law, segment, branch, slip, pressure);
  let mu = found1[0];
  let mu_p = found1[2];
  return [mu * pressure, mu + pressure * mu_p];
}

/** Creep at the start of a course by the tension there [m], and its slope by that [m/N]. */
export function collocation__start_at(face, arc, tension) {
  if (!face.rests) {
    return collocation__overrun_at(arc, tension);
  }
  let area = arc.width * arc.radius;
  const found1 = traction__stress_of_slip(face.law, tension / area, LEAST_CREEP);
  let held = found1[0];
  let by_pressure = found1[1];
  return [face.slides * face.shear * held, (face.slides * face.shear * by_pressure) / area];
}

/** K behind a rest arc much longer than l, u' = u_r/l at its end [-], and its slope [1/N]. */
export function collocation__ratio_behind_rest(face, arc, tension) {
  const found1 = collocation__start_at(face, arc, tension);
  let creep = found1[0];
  let by_tension = found1[1];
  let c = collocation__compliance_of(arc);
  let lag = collocation__lag_length(arc);
  if (lag === 0.0) {
    return [c * tension, c];
  }
  return [c * tension + creep / lag, c + by_tension / lag];
}

/** Count a step over a mesh, or as much work; whether there are none left. */
export function collocation__spent(arc, at) {
  if (arc.left === null) {
    return false;
  }
  arc.left[0] -= at.place.length - 1;
  return arc.left[0] < 0.0;
}

/** Creeps at the stages of an element of length h that begins at the creep u [m]. */
export function collocation__stage_creeps(h, ratio, c, u, k) {
  let [k0, k1, k2] = k;
  return [
    u + h * (C0 * ratio - c * (A00 * k0 + A01 * k1 + A02 * k2)),
    u + h * (C1 * ratio - c * (A10 * k0 + A11 * k1 + A12 * k2)),
    u + h * (C2 * ratio - c * (A20 * k0 + A21 * k1 + A22 * k2)),
  ];
}

/** Traction of a belt that slides one way, at a creep that way or at the least that slides. */
export function collocation___sliding(face, pressure, creep) {
  const found1 = traction__stress_of_slip(face.law, pressure, LEAST_CREEP);
  let held = found1[0];
  let by_pressure = found1[1];
  if (face.slides * creep > face.shear * held + LEAST_CREEP) {
    return traction__traction(face.law, face.shear, pressure, creep);
  }
  return new Traction(face.slides * held, 0.0, face.slides * by_pressure, 0.0);
}

/** Traction of an interface at a wrap pressure [Pa] and a creep [m]. */
export function collocation__traction_at(face, pressure, creep) {
  if (face.slides !== 0.0) {
    return collocation___sliding(face, pressure, creep);
  }
  return traction__traction(face.law, face.shear, pressure, creep);
}

/** Slopes of the stage stresses by the stage tensions, d tau_j = w_j dT_j - v_j h C sum A dT. */
export function collocation__stage_matrix(hb, hc, v, w) {
  let [v0, v1, v2] = v;
  let [w0, w1, w2] = w;
  let j00 = w0 - v0 * hc * A00;
  let j01 = -v0 * hc * A01;
  let j02 = -v0 * hc * A02;
  let j10 = -v1 * hc * A10;
  let j11 = w1 - v1 * hc * A11;
  let j12 = -v1 * hc * A12;
  let j20 = -v2 * hc * A20;
  let j21 = -v2 * hc * A21;
  let j22 = w2 - v2 * hc * A22;
  let m00 = 1.0 + hb * (A00 * j00 + A01 * j10 + A02 * j20);
  let m01 = hb * (A00 * j01 + A01 * j11 + A02 * j21);
  let m02 = hb * (A00 * j02 + A01 * j12 + A02 * j22);
  let m10 = hb * (A10 * j00 + A11 * j10 + A12 * j20);
  let m11 = 1.0 + hb * (A10 * j01 + A11 * j11 + A12 * j21);
  let m12 = hb * (A10 * j02 + A11 * j12 + A12 * j22);
  let m20 = hb * (A20 * j00 + A21 * j10 + A22 * j20);
  let m21 = hb * (A20 * j01 + A21 * j11 + A22 * j21);
  let m22 = 1.0 + hb * (A20 * j02 + A21 * j12 + A22 * j22);
  let a00 = m11 * m22 - m12 * m21;
  let a01 = m02 * m21 - m01 * m22;
  let a02 = m01 * m12 - m02 * m11;
  let a10 = m12 * m20 - m10 * m22;
  let a11 = m00 * m22 - m02 * m20;
  let a12 = m02 * m10 - m00 * m12;
  let a20 = m10 * m21 - m11 * m20;
  let a21 = m01 * m20 - m00 * m21;
  let a22 = m00 * m11 - m01 * m10;
  return [
    [j00, j01, j02, j10, j11, j12, j20, j21, j22],
    [a00, a01, a02, a10, a11, a12, a20, a21, a22],
    m00 * a00 + m01 * a10 + m02 * a20,
  ];
}

/** An element made linear, its stages eliminated. */
export function collocation__condensed(face, arc, h, c, at, i) {
  let g0, g1, g2, k, k0, k1, k2, q0, q1, q2, y0, y1, y2;
  let area = arc.width * arc.radius;
  let hb = h * arc.width;
  let hc = h * c;
  let u = at.creep[i];
  let tension = at.tension[i];
  let ratio = at.ratio;
  [k0, k1, k2] = k = at.stage.slice(3 * i, 3 * i + 3);
  let [u0, u1, u2] = collocation__stage_creeps(h, ratio, c, u, k);
  const found1 = collocation__traction_at(face, k0 / area, u0);
  let f0 = found1.stress;
  let v0 = found1.by_creep;
  let w0 = found1.by_pressure;
  const found2 = collocation__traction_at(face, k1 / area, u1);
  let f1 = found2.stress;
  let v1 = found2.by_creep;
  let w1 = found2.by_pressure;
  const found3 = collocation__traction_at(face, k2 / area, u2);
  let f2 = found3.stress;
  let v2 = found3.by_creep;
  let w2 = found3.by_pressure;
  const found4 = collocation__stage_matrix(hb, hc, [v0, v1, v2], [w0 / area, w1 / area, w2 / area]);
  let j = found4[0];
  let a = found4[1];
  let det = found4[2];
  let [j00, j01, j02, j10, j11, j12, j20, j21, j22] = j;
  let [a00, a01, a02, a10, a11, a12, a20, a21, a22] = a;
  let stages = [];
  let end = [];
  let shrunk = ratio - c * (B0 * k0 + B1 * k1 + B2 * k2);
  let x0 = v0 * C0;
  let x1 = v1 * C1;
  let x2 = v2 * C2;
  let grown = 0.0;
  if (face.rests) {
    x0 = (v0 * (u0 - u)) / h;
    x1 = (v1 * (u1 - u)) / h;
    x2 = (v2 * (u2 - u)) / h;
    grown = hb;
  }
  let columns = [
    [
      tension - k0 - hb * (A00 * f0 + A01 * f1 + A02 * f2),
      tension - k1 - hb * (A10 * f0 + A11 * f1 + A12 * f2),
      tension - k2 - hb * (A20 * f0 + A21 * f1 + A22 * f2),
      f0,
      f1,
      f2,
    ],
    [
      -hb * (A00 * v0 + A01 * v1 + A02 * v2),
      -hb * (A10 * v0 + A11 * v1 + A12 * v2),
      -hb * (A20 * v0 + A21 * v1 + A22 * v2),
      v0,
      v1,
      v2,
    ],
    [1.0, 1.0, 1.0, 0.0, 0.0, 0.0],
    [
      -hb * h * (A00 * x0 + A01 * x1 + A02 * x2) - grown * (A00 * f0 + A01 * f1 + A02 * f2),
      -hb * h * (A10 * x0 + A11 * x1 + A12 * x2) - grown * (A10 * f0 + A11 * f1 + A12 * f2),
      -hb * h * (A20 * x0 + A21 * x1 + A22 * x2) - grown * (A20 * f0 + A21 * f1 + A22 * f2),
      h * x0,
      h * x1,
      h * x2,
    ],
  ];
  if (face.rests) {
    x0 = h * v0 * C0;
    x1 = h * v1 * C1;
    x2 = h * v2 * C2;
    columns.push([
      -hb * (A00 * x0 + A01 * x1 + A02 * x2),
      -hb * (A10 * x0 + A11 * x1 + A12 * x2),
      -hb * (A20 * x0 + A21 * x1 + A22 * x2),
      x0,
      x1,
      x2,
    ]);
  }
  for (const each5 of columns) {
    [q0, q1, q2, g0, g1, g2] = each5;
    y0 = (a00 * q0 + a01 * q1 + a02 * q2) / det;
    y1 = (a10 * q0 + a11 * q1 + a12 * q2) / det;
    y2 = (a20 * q0 + a21 * q1 + a22 * q2) / det;
    stages.push(...[y0, y1, y2]);
    end.push(-hc * (B0 * y0 + B1 * y1 + B2 * y2));
    end.push(
      -hb *
        (B0 * (g0 + j00 * y0 + j01 * y1 + j02 * y2) +
          B1 * (g1 + j10 * y0 + j11 * y1 + j12 * y2) +
          B2 * (g2 + j20 * y0 + j21 * y1 + j22 * y2)),
    );
  }
  end[0] += u + h * shrunk - at.creep[i + 1];
  end[1] += tension - at.tension[i + 1];
  end[2] += 1.0;
  end[5] += 1.0;
  end[6] += face.rests ? h * shrunk : h;
  end[7] -= grown * (B0 * f0 + B1 * f1 + B2 * f2);
  if (face.rests) {
    end[8] += h;
  }
  return [stages, end];
}

/** Creep u = x + c mu(x, p) p at a magnitude of slip, > 0 [m]. */
export function traction__creep_of_slip(law, shear, pressure, slip) {
  return slip + shear * traction__stress_of_slip(law, pressure, slip)[0];
}

/** Condition at the exit made linear: by_creep du + by_tension dT = missing. */
export function collocation__exit_row(face, arc, ends, at) {
  let u = at.creep.at(-1);
  let tension = at.tension.at(-1);
  if (ends.kind === TENSION) {
    return [0.0, 1.0, ends.goal - tension];
  }
  if (ends.kind === CREEP) {
    return [1.0, 0.0, ends.goal - u];
  }
  let area = arc.width * arc.radius;
  let size = Math.abs(ends.goal);
  let sign = ends.goal > 0.0 ? 1.0 : -1.0;
  let by_pressure = traction__stress_of_slip(face.law, tension / area, size)[1];
  let creep = sign * traction__creep_of_slip(face.law, face.shear, tension / area, size);
  return [1.0, (-sign * face.shear * by_pressure) / area, creep - u];
}

/** Entry tension of a rest arc, much longer than l, by that at its end [N]. */
export function collocation__entry_of_rest(face, arc, tension) {
  let by_tension, change, overrun;
  if (arc.shear === 0.0) {
    return tension;
  }
  let end = collocation__start_at(face, arc, tension)[0];
  let taken = collocation__held_stiffness(arc);
  let entry = tension;
  for (let each1 = 0, end1 = 4; each1 < end1; each1++) {
    const found2 = collocation__overrun_at(arc, entry);
    overrun = found2[0];
    by_tension = found2[1];
    change = (entry - tension - taken * (overrun + end)) / (1.0 - taken * by_tension);
    entry = max(entry - change, LEAST_LEFT * entry);
  }
  return entry;
}

/** Apply a Newton step, from the exit to the entry; `end` ties du at the exit to dT and dZ. */
export function collocation___moved(face, at, elements, back, end, dt, free) {
  let b, change, d, dk, du, dz, i, j, k, kt, n, over, r, rk, rt, y, zt;
  [n, [dz, dk]] = [elements.length, free];
  let creep = at.creep.slice(0);
  let tension = at.tension.slice(0);
  let stage = at.stage.slice(0);
  let largest = Math.abs(dt);
  let top = max(at.tension[0], at.tension[n]);
  let scale = max(Math.abs(at.tension[0] - at.tension[n]), LEAST_PULL * top);
  creep[n] += end[0] + end[1] * dz - end[2] * dt;
  tension[n] = max(tension[n] + dt, LEAST_LEFT * tension[n]);
  for (let each1 = n - 1, end1 = -1; each1 > end1; each1 += -1) {
    i = each1;
    [r, d, b, rt, zt, over, rk, kt] = back[i];
    dt = over * dt - rt - zt * dz - kt * dk;
    du = r + d * dz + rk * dk - b * dt;
    y = elements[i];
    for (let each2 = 0, end2 = 3; each2 < end2; each2++) {
      j = each2;
      change = y[j] + y[3 + j] * du + y[6 + j] * dt + y[9 + j] * dz;
      if (face.rests) {
        change += y[12 + j] * dk;
      }
      k = stage[3 * i + j];
      stage[3 * i + j] = max(k + change, LEAST_LEFT * k);
      largest = max(largest, Math.abs(change));
    }
    creep[i] += du;
    tension[i] = max(tension[i] + dt, LEAST_LEFT * tension[i]);
    largest = max(largest, Math.abs(dt));
  }
  return [
    new Course(at.place, creep, tension, stage, at.ratio + (face.rests ? dk : dz)),
    largest / scale,
  ];
}

/** One Newton step; the course after it, and the largest change of a tension of the largest. */
export function collocation__improved(face, arc, ends, at) {
  let by_k,
    end,
    first_k,
    i,
    kt,
    lack,
    last_k,
    over,
    part,
    pt,
    rt,
    s0,
    s1,
    s2,
    s3,
    stages,
    steep,
    stretch,
    turn,
    wanted,
    z0,
    z1,
    z2,
    z3,
    zt;
  let n = at.place.length - 1;
  let c = collocation__compliance_of(arc);
  const found1 = collocation__start_at(face, arc, at.tension[0]);
  let start = found1[0];
  let by_tension = found1[1];
  let b = -by_tension;
  let r = start - at.creep[0];
  let d = 0.0;
  let dk = 0.0;
  let elements = [];
  let back = [];
  for (let each2 = 0, end2 = n; each2 < end2; each2++) {
    i = each2;
    const found3 = collocation__condensed(face, arc, at.place[i + 1] - at.place[i], c, at, i);
    stages = found3[0];
    end = found3[1];
    [s0, z0, s1, z1, s2, z2, s3, z3] = end.slice(0, 8);
    pt = z2 - z1 * b;
    rt = (z0 + z1 * r) / pt;
    zt = (z3 + z1 * d) / pt;
    kt = face.rests ? (end[9] + z1 * dk) / pt : 0.0;
    elements.push(stages);
    back.push([r, d, b, rt, zt, 1.0 / pt, dk, kt]);
    turn = s2 - s1 * b;
    if (face.rests) {
      dk = end[8] + s1 * dk - turn * kt;
    }
    [b, r, d] = [-turn / pt, s0 + s1 * r - turn * rt, s3 + s1 * d - turn * zt];
  }
  const found4 = collocation__exit_row(face, arc, ends, at);
  let by_creep = found4[0];
  let by_exit = found4[1];
  let missing = found4[2];
  let free = by_exit - by_creep * b;
  if (free === 0.0) {
    return [at, Infinity, NO_SLOPES];
  }
  let last = (missing - by_creep * r) / free;
  let last_z = (-by_creep * d) / free;
  let last_goal = 1.0 / free;
  let first = last;
  let first_z = last_z;
  let first_goal = last_goal;
  last_k = first_k = (-by_creep * dk) / free;
  for (let each5 = n - 1, end5 = -1; each5 > end5; each5 += -1) {
    i = each5;
    [, , , rt, zt, over, , kt] = back[i];
    [first, first_z, first_goal] = [over * first - rt, over * first_z - zt, over * first_goal];
    first_k = over * first_k - kt;
  }
  let exit_z = last_z;
  let drop = face.rests
    ? collocation__entry_of_rest(face, arc, at.tension[0]) - at.tension[0]
    : 0.0;
  let short = ends.tension - ends.at_entry * (at.tension[0] + drop) - ends.at_exit * at.tension[n];
  short -= ends.at_entry * first + ends.at_exit * last;
  let slope = ends.at_entry * first_z + ends.at_exit * last_z;
  let k = 0.0;
  let det = slope;
  let dz = short;
  if (face.rests) {
    const found6 = collocation__ratio_behind_rest(face, arc, at.tension[0]);
    wanted = found6[0];
    steep = found6[1];
    part = 1.0 - steep * first_k;
    lack = wanted - at.ratio + steep * first;
    by_k = ends.at_entry * first_k + ends.at_exit * last_k;
    det = part * slope + steep * first_z * by_k;
    dz = part * short - by_k * lack;
    k = lack * slope + steep * first_z * short;
    part = steep / (Math.abs(part) > FREELY ? part : FREELY);
    [last_z, last_goal] = [
      last_z + last_k * part * first_z,
      last_goal + last_k * part * first_goal,
    ];
    [first_z, first_goal] = [first_z * (1.0 + first_k * part), first_goal * (1.0 + first_k * part)];
  }
  if (det === 0.0) {
    return [at, Infinity, NO_SLOPES];
  }
  [dz, k] = [dz / det, k / det];
  let moved = last + exit_z * dz + last_k * k;
  let end_row = [r + dk * k, d, b];
  const found7 = collocation___moved(face, at, elements, back, end_row, moved, [dz, k]);
  let new_ = found7[0];
  let change = found7[1];
  if (face.rests) {
    stretch = 1.0 + max(min(dz, MOST_STRETCH), -MOST_STRETCH);
    new_ = Object.assign(Object.create(Object.getPrototypeOf(new_)), new_, {
      place: [...at.place].map((place) => stretch * place),
    });
    change = max(change, Math.abs(dz));
  }
  return [new_, change, new Slopes(first_z, last_z, first_goal, last_goal)];
}

/** Newton's method on one mesh, until a step changes no tension by `near` of the pull. */
export function collocation__converged(face, arc, ends, at, most, near) {
  let change;
  let slopes = NO_SLOPES;
  let before = Infinity;
  for (let each1 = 0, end1 = most; each1 < end1; each1++) {
    if (collocation__spent(arc, at)) {
      return new Solved(false, at, slopes);
    }
    const found2 = collocation__improved(face, arc, ends, at);
    at = found2[0];
    change = found2[1];
    slopes = found2[2];
    if (!(change < FARTHEST)) {
      return new Solved(false, at, slopes);
    }
    if (change < near || (change < 1e-5 && change > 0.5 * before)) {
      return new Solved(true, at, slopes);
    }
    before = change;
  }
  return new Solved(false, at, slopes);
}

/** How far the traction at the ends of each element is from that of its polynomial [-]. */
export function collocation__misfits(face, arc, at, kind) {
  let d0, d1, d2, first, h, i, last, of, one, t;
  let n = at.place.length - 1;
  let area = arc.width * arc.radius;
  let k = at.stage;
  let tension = at.tension;
  let size = 1e-7 * tension[0];
  for (const each1 of tension) {
    one = each1;
    size = max(size, Math.abs(one - tension[0]));
  }
  let fall = max(Math.abs(Math.log(tension[0] / tension[n])), LEAST_PULL);
  let taken = [...$range(n + 1)].map(
    (i) => arc.width * collocation__traction_at(face, tension[i] / area, at.creep[i]).stress,
  );
  let found = [];
  for (let each2 = 0, end2 = n; each2 < end2; each2++) {
    i = each2;
    h = at.place[i + 1] - at.place[i];
    t = tension[i];
    d0 = k[3 * i] - t;
    d1 = k[3 * i + 1] - t;
    d2 = k[3 * i + 2] - t;
    first = Math.abs(d0 * F0 + d1 * F1 + d2 * F2 + h * taken[i]);
    last = Math.abs(d0 * L0 + d1 * L1 + d2 * L2 + h * taken[i + 1]);
    of = kind === TENSION ? size : fall * min(t, tension[i + 1]);
    found.push(max(first, last) / of);
  }
  return found;
}

/** Branch of a law at a magnitude of creep, > 0 [m]; -1 where the belt is held. */
export function traction__branch_at(law, segment, shear, pressure, creep) {
  let mu_pk, residual, slip_pk, slope;
  if (law.kind === LIMIT || law.kind === TABLE) {
    return traction__piece_at(law, segment, shear, pressure, creep).branch;
  }
  const found1 = compact__peak(law, segment, pressure);
  slip_pk = found1[0];
  mu_pk = found1[1];
  let hold = traction___hold(law, segment, pressure);
  let ease = shear * pressure;
  let beyond = creep - slip_pk - ease * hold * mu_pk;
  if (beyond <= 0.0) {
    return RISE;
  }
  const found2 = compact__tail(law, segment, pressure);
  slope = found2[0];
  residual = found2[1];
  let line = beyond / (1.0 + ease * hold * slope);
  return mu_pk + slope * line >= min(residual, mu_pk) ? LINE : RESIDUAL;
}

/** The piece of a law that holds at a place: sign of the creep, segment, branch. */
export function collocation__piece_code(face, arc, state, least) {
  let [u, tension] = state;
  let p = tension / (arc.width * arc.radius);
  let segment = compact__segment_of(face.law, p);
  let branch = traction__branch_at(face.law, segment, face.shear, p, max(Math.abs(u), LEAST_CREEP));
  return [Math.abs(u) < least ? 0 : u > 0.0 ? 1 : -1, segment, branch];
}

/** Whether two places lie in different pieces of the law, or creep turns between them. */
export function collocation___differ(one, other) {
  return one[0] * other[0] < 0 || one[1] !== other[1] || one[2] !== other[2];
}

/** Integrals from 0 to c of the parabolas that are 1 at one stage of an element each. */
export function collocation__weights_at(c) {
  let x = 2.0 * c - 1.0;
  let linear = 0.25 * (x * x - 1.0);
  let square = 0.25 * (x * x * x - x);
  return [
    B0 * (c - _S * linear + 2.0 * square),
    B1 * (c - 2.5 * square),
    B2 * (c + _S * linear + 2.0 * square),
  ];
}

/** Creep [m] and tension [N] at a fraction c of element i, by its polynomials. */
export function collocation__state_at(arc, at, i, c) {
  let h = at.place[i + 1] - at.place[i];
  let k = at.stage;
  let t = at.tension[i];
  let compliance = collocation__compliance_of(arc);
  const found1 = collocation__weights_at(c);
  let w0 = found1[0];
  let w1 = found1[1];
  let w2 = found1[2];
  let d0 = k[3 * i] - t;
  let d1 = k[3 * i + 1] - t;
  let d2 = k[3 * i + 2] - t;
  let change = w0 * d0 + w1 * d1 + w2 * d2;
  let u = at.creep[i] + h * (c * (at.ratio - compliance * t) - compliance * change);
  let c0 = c - C0;
  let c1 = c - C1;
  let c2 = c - C2;
  return [u, t + c * ((d0 * c1 * c2) / D0 + (d1 * c0 * c2) / D1 + (d2 * c0 * c1) / D2)];
}

/** Fraction of an element at which a piece of the law ends, and whether creep turns there. */
export function collocation___change(face, arc, at, i, within, code) {
  let middle, now;
  let [low, high] = within;
  let turns = false;
  while (high - low > 0.1 * KINK) {
    middle = 0.5 * (low + high);
    now = collocation__piece_code(face, arc, collocation__state_at(arc, at, i, middle), 0.0);
    if (collocation___differ(now, code)) {
      high = middle;
      turns = now[0] !== code[0];
    } else {
      low = middle;
    }
  }
  return [high, turns];
}

/** Places where the course passes into another piece of the law [m], and whether creep turns. */
export function collocation__kinks(face, arc, at) {
  let h, high, i, low, now, share, states, t, turns, u, u0, u1, u2;
  let found = [];
  let largest = $maxOf(at.creep);
  let lowest = $minOf(at.creep);
  let least = SMALL * max(largest, -lowest);
  let c = collocation__compliance_of(arc);
  let n = at.place.length - 1;
  let k = at.stage;
  let code = [0, 0, 0];
  for (let each1 = 0, end1 = n; each1 < end1; each1++) {
    i = each1;
    h = at.place[i + 1] - at.place[i];
    [u0, u1, u2] = collocation__stage_creeps(
      h,
      at.ratio,
      c,
      at.creep[i],
      k.slice(3 * i, 3 * i + 3),
    );
    states = [
      [C0, u0, k[3 * i]],
      [C1, u1, k[3 * i + 1]],
      [C2, u2, k[3 * i + 2]],
    ];
    if (i + 1 < n) {
      states.push([1.0, at.creep[i + 1], at.tension[i + 1]]);
    }
    low = 0.0;
    for (const each2 of states) {
      [high, u, t] = each2;
      now = collocation__piece_code(face, arc, [u, t], least);
      if (i === 0 && high === C0) {
        code = now;
      } else if (collocation___differ(now, code)) {
        const found3 = collocation___change(face, arc, at, i, [low, high], code);
        share = found3[0];
        turns = found3[1];
        found.push([at.place[i] + share * h, turns]);
      }
      code = now[0] !== 0 ? now : [code[0], now[1], now[2]];
      low = high;
    }
  }
  return found.slice(0, MOST_KINKS);
}

/** Whether no element ends at a kink. */
export function collocation___misses(places, where) {
  let i = 0;
  while (places[i + 1] < where) {
    i += 1;
  }
  let h = places[i + 1] - places[i];
  return min(where - places[i], places[i + 1] - where) > KINK * h;
}

/** Ends of elements of which each has the same share of the parts that were asked for. */
export function collocation___spread(places, parts) {
  let goal, j;
  let total = $sum(parts);
  let n = min(max(Math.ceil(total), FIRST_ELEMENTS), MOST_ELEMENTS);
  let new_ = [0.0];
  let i = 0;
  let done = 0.0;
  for (let each1 = 1, end1 = n; each1 < end1; each1++) {
    j = each1;
    goal = (total * j) / n;
    while (done + parts[i] < goal) {
      done += parts[i];
      i += 1;
    }
    new_.push(places[i] + ((places[i + 1] - places[i]) * (goal - done)) / parts[i]);
  }
  new_.push(places.at(-1));
  return new_;
}

/** Let an element end at a kink: by a node that is moved, or by a new one. */
export function collocation___end_at(places, where, turns) {
  let i = 0;
  while (places[i + 1] < where) {
    i += 1;
  }
  let h = places[i + 1] - places[i];
  let near = where - places[i] < 0.5 * h ? i : i + 1;
  if (0 < near && near < places.length - 1 && Math.abs(where - places[near]) < 0.3 * h) {
    places[near] = where;
    i = near;
  } else {
    i += 1;
    places.splice(i, 0, where);
  }
  for (let each1 = 0, end1 = turns && h > TURN * places.at(-1) ? 4 : 0; each1 < end1; each1++) {
    places.splice(i, 0, where - (where - places[i - 1]) * 0.25);
    i += 1;
    places.splice(i + 1, 0, where + (places[i + 1] - where) * 0.25);
  }
}

/** A course on another mesh of the same length. */
export function collocation___carried_over(arc, at, places) {
  let c, h, j, s, share, t, u;
  let creep = [at.creep[0]];
  let tension = [at.tension[0]];
  let stage = [];
  let i = 0;
  for (let each1 = 0, end1 = places.length - 1; each1 < end1; each1++) {
    j = each1;
    h = places[j + 1] - places[j];
    for (const each2 of [C0, C1, C2, 1.0]) {
      c = each2;
      s = places[j] + c * h;
      while (i + 2 < at.place.length && at.place[i + 1] < s) {
        i += 1;
      }
      share = (s - at.place[i]) / (at.place[i + 1] - at.place[i]);
      const found3 = collocation__state_at(arc, at, i, min(share, 1.0));
      u = found3[0];
      t = found3[1];
      t = max(t, LEAST_LEFT * min(at.tension[i], at.tension[i + 1]));
      if (c < 1.0) {
        stage.push(t);
      }
    }
    creep.push(u);
    tension.push(t);
  }
  let last = places.length - 1;
  [creep[last], tension[last]] = [at.creep.at(-1), at.tension.at(-1)];
  return new Course(places, creep, tension, stage, at.ratio);
}

/** The course on a mesh that spreads the misfit evenly and ends elements at kinks. */
export function collocation__meshed(face, arc, at, kind, tol) {
  let turns, where;
  let places = at.place;
  let misses = collocation__misfits(face, arc, at, kind);
  collocation__spent(arc, at);
  let needed = [...misses].map((miss) => (miss / tol) ** 0.25);
  needed[0] = needed[0] ** 2;
  let ends = collocation__kinks(face, arc, at);
  let far = false;
  for (const each1 of ends) {
    [where] = each1;
    far = far || collocation___misses(places, where);
  }
  let over = $maxOf(needed) > 1.0;
  if (!far && !over) {
    return [false, false, at];
  }
  let new_ = collocation___spread(
    places,
    [...needed].map((part) => min(max(part, LEAST_PART), MOST_PART)),
  );
  for (const each2 of ends) {
    [where, turns] = each2;
    collocation___end_at(new_, where, turns);
  }
  return [true, over, collocation___carried_over(arc, at, new_)];
}

/** The course on meshes that adapt until no element misses by more. */
export function collocation___refined(face, arc, ends, start, tol) {
  let finer, new_, over;
  let found = collocation__converged(face, arc, ends, start, FIRST_STEPS, COARSELY);
  let kept = 0;
  for (let each1 = 0, end1 = MOST_ROUNDS; each1 < end1; each1++) {
    if (face.rests && found.course.place.at(-1) > LONGEST * arc.radius * arc.wrap_angle) {
      return new Solved(false, found.course, found.slopes);
    }
    if (!found.done) {
      return found;
    }
    const found2 = collocation__meshed(face, arc, found.course, ends.kind, tol);
    finer = found2[0];
    over = found2[1];
    new_ = found2[2];
    kept = over ? 0 : kept + 1;
    if (!finer || kept > KINK_ROUNDS) {
      break;
    }
    found = collocation__converged(face, arc, ends, new_, LATER_STEPS, COARSELY);
  }
  return collocation__converged(face, arc, ends, found.course, LATER_STEPS, 1e-9);
}

/** How many times the relative error of tension that of creep is, tensions given, from 1 [-]. */
export function collocation__amplification(found) {
  let at = found.course;
  let slopes = found.slopes;
  let pull = Math.abs(at.tension[0] - at.tension.at(-1));
  let moves = at.place.at(-1) * max(Math.abs(slopes.first_goal), 1.0) * pull;
  let size = Math.abs(slopes.first) * $maxOf([...at.creep].map((creep) => Math.abs(creep)));
  return moves > size ? min(moves / size, MOST_AMPLIFIED) : 1.0;
}

/** Meet the end conditions from a first guess, on meshes that adapt until nothing misses. */
export function collocation__solved(face, arc, ends, start, tol = 1e-6) {
  let found = collocation___refined(face, arc, ends, start, tol);
  if (!found.done || ends.kind !== TENSION || face.rests) {
    return found;
  }
  let answers = collocation__amplification(found);
  if (answers <= AMPLIFIED) {
    return found;
  }
  let finer = collocation___refined(face, arc, ends, found.course, tol / answers);
  return finer.done ? finer : found;
}

/** An arc with its slide behind a rest arc; not done where that is not much longer than l. */
export function meet__with_rest(face, arc, found) {
  let course = found.course;
  let rest = arc.radius * arc.wrap_angle - course.place.at(-1);
  let long = rest >= 20.0 * collocation__lag_length(arc);
  let entry = collocation__entry_of_rest(face, arc, course.tension[0]);
  return new Met(long, course, found.slopes, max(rest, 0.0), entry, face);
}

/** `meet` with a rest arc at the entry; not done where it is not much longer than l. */
export function meet___behind_rest(face, arc, ends, guess, tol) {
  let area, first, found, pull, short, slide;
  let length = arc.radius * arc.wrap_angle;
  let slides = [...FIRST_SLIDES].map((share) => share * length);
  if (arc.shear === 0.0 && ends.kind === TENSION) {
    area = arc.width * arc.radius;
    pull = Math.abs(guess.entry - guess.leaving);
    short = pull / (arc.width * traction__held_stress(face.law, guess.leaving / area));
    if (short < slides.at(-1)) {
      slides = [short];
    }
  }
  for (const each1 of slides) {
    slide = each1;
    first = collocation__first_course(arc, slide, guess.entry, guess.leaving, guess.creep);
    first = Object.assign(Object.create(Object.getPrototypeOf(first)), first, {
      ratio: collocation__ratio_behind_rest(face, arc, guess.entry)[0],
    });
    found = collocation__solved(face, arc, ends, first, tol);
    if (found.done) {
      return meet__with_rest(face, arc, found);
    }
  }
  return meet__unmet(face, first);
}

/** An arc without a rest arc of its own. */
export function meet__all_sliding(face, found) {
  return new Met(found.done, found.course, found.slopes, 0.0, found.course.tension[0], face);
}

/** Continuation in what shears: from a lagging so soft that the arc is a few l long. */
export function collocation__softened(face, arc, ends, at, tol) {
  let now, shear, step;
  let length = at.place.at(-1);
  let entry = at.tension[0];
  let leaving = at.tension.at(-1);
  let mean = Math.sqrt(entry * leaving) / (arc.width * arc.radius);
  let creep =
    collocation__mean_creep(face, arc, entry, leaving) + collocation__overrun_at(arc, entry)[0];
  let gives = (SOFTER * Math.abs(creep)) / traction__plateau_stress(face.law, mean);
  let least = max((length / SOFTEST) ** 2 * collocation__compliance_of(arc) * arc.width, gives);
  let soft = Object.assign(Object.create(Object.getPrototypeOf(face)), face, {
    shear: max(face.shear, least),
    slides: 0.0,
  });
  creep = at.creep.at(-1);
  if (ends.kind === TENSION) {
    creep = 2.0 * collocation__mean_creep(soft, arc, entry, leaving);
  }
  let first = collocation__first_course(arc, length, entry, leaving, creep);
  let found = collocation__converged(soft, arc, ends, first, FIRST_STEPS, COARSELY);
  if (!found.done) {
    return found;
  }
  least = max(face.shear, LEAST_SHEAR * soft.shear);
  step = FIRST_SOFTER;
  at = collocation__meshed(soft, arc, found.course, ends.kind, ROUGH)[2];
  for (let each1 = 0, end1 = MOST_SOFTENED; each1 < end1; each1++) {
    if (step > LEAST_SOFTER) {
      break;
    }
    shear = max(step * soft.shear, least);
    now =
      shear > least
        ? Object.assign(Object.create(Object.getPrototypeOf(soft)), soft, { shear: shear })
        : face;
    found = collocation__converged(now, arc, ends, at, FIRST_STEPS, COARSELY);
    if (!found.done) {
      step = Math.sqrt(step);
      continue;
    }
    [soft, step] = [now, step * Math.sqrt(step)];
    at = collocation__meshed(soft, arc, found.course, ends.kind, max(ROUGH, tol))[2];
    if (shear === least) {
      return collocation__converged(face, arc, ends, at, LATER_STEPS, COARSELY);
    }
  }
  return new Solved(false, at, NO_SLOPES);
}

/** `solved`, by continuation in what shears where Newton's method alone does not get there. */
export function collocation__solved_or_softened(face, arc, ends, start, tol = 1e-6) {
  let found = collocation__solved(face, arc, ends, start, tol);
  if (found.done) {
    return found;
  }
  found = collocation__softened(face, arc, ends, start, tol);
  return found.done ? collocation__solved(face, arc, ends, found.course, tol) : found;
}

/** Meet end conditions. */
export function meet__meet(law, arc, ends, guess, near, tol) {
  let again, behind, found, held;
  let face = meet__interface(law, arc);
  let length = arc.radius * arc.wrap_angle;
  if (meet__may_rest(law, arc)) {
    behind = Object.assign(Object.create(Object.getPrototypeOf(face)), face, {
      slides: arc.side,
      rests: true,
    });
    held = arc.shear > 0.0 ? meet___at_rest(behind, arc, ends, guess) : null;
    found = held === null ? meet___behind_rest(behind, arc, ends, guess, tol) : held;
    if (found.done) {
      return found;
    }
  }
  if (near !== null) {
    again = collocation__solved(face, arc, ends, near, tol);
    if (again.done) {
      return meet__all_sliding(face, again);
    }
    if (tol >= ROUGH) {
      return meet__unmet(face, near);
    }
  }
  let first = collocation__first_course(arc, length, guess.entry, guess.leaving, guess.creep);
  return meet__all_sliding(face, collocation__solved_or_softened(face, arc, ends, first, tol));
}

/** Whether more is carried as creep grows: friction is not exhausted. */
export function answer___rises(met) {
  let first = met.slopes.first;
  let through = met.slopes.first_goal;
  return met.rest > 0.0 || first > 0.0 || first * through > 0.0;
}

/** ln(tight/slack) at gross slip with what friction is left with at slips without bound. */
export function gross_slip__residual_capacity(law, tight_pressure, wrap_angle) {
  return gross_slip___capacity(law, tight_pressure, wrap_angle, true);
}

/** Friction beyond the residual over all slips at a pressure, int (mu - mu_residual) dx [m]. */
export function compact__excess_at(law, segment, pressure) {
  let cell, hold, mu, place, slip, slip_pk, slope, total, width;
  let kind = law.kind;
  let slips = law.slips;
  if (kind === LIMIT) {
    return 0.0;
  }
  let left = compact__residual_at(law, segment, pressure);
  if (kind === TABLE) {
    total = 0.0;
    for (let each1 = 0, end1 = slips.length - 1; each1 < end1; each1++) {
      cell = each1;
      width = slips[cell + 1] - slips[cell];
      for (const each2 of [0.2113248654051871, 0.7886751345948129]) {
        place = each2;
        slip = slips[cell] + place * width;
        const found3 = compact__friction_at(law, segment, cell, slip, pressure);
        mu = found3[0];
        total += 0.5 * width * (mu - left);
      }
    }
    return total;
  }
  const found4 = compact__peak(law, segment, pressure);
  slip_pk = found4[0];
  const found5 = compact__tail(law, segment, pressure);
  slope = found5[0];
  let top = compact__plateau_at(law, segment, pressure);
  let fall = top - left;
  total = slip_pk * (0.75 * top - left);
  if (fall > 0.0) {
    hold = top / compact__peak(law, segment, pressure)[1];
    total -= (0.5 * fall * fall) / (slope * hold);
  }
  return total;
}

/** Whether some creep may carry more than the residual friction everywhere. */
export function gross_slip__outweighs(law, geometry, tight, residual) {
  let i, p, segment, start;
  let area = geometry.width * geometry.radius;
  for (let each1 = 0, end1 = PRESSURES; each1 < end1; each1++) {
    i = each1;
    p = (tight / area) * Math.exp((-residual * i) / (PRESSURES - 1));
    segment = compact__segment_of(law, p);
    start = Math.abs(geometry.overrun_constant + geometry.overrun_coefficient * p * Math.sqrt(p));
    if (compact__excess_at(law, segment, p) + start * compact__residual_at(law, segment, p) > 0.0) {
      return true;
    }
  }
  return false;
}

/** A limit at the exit, and at_tight T_tight + at_slack T_slack = tension [-, -, N]. */
export function capacity__ends_at(arc, at_tight, at_slack, tension, limit) {
  let goal = arc.side * limit.most;
  if (arc.side > 0.0) {
    return new Ends(at_tight, at_slack, tension, limit.kind, goal);
  }
  return new Ends(at_slack, at_tight, tension, limit.kind, goal);
}

/** Magnitude of the traction at a pressure [Pa] and a creep [m], for a first guess [Pa]. */
export function capacity__stress_about(face, pressure, creep) {
  return min(
    Math.abs(collocation__traction_at(face, pressure, creep).stress),
    MOST_USED * traction__plateau_stress(face.law, pressure),
  );
}

/** A first guess by the tensions of the tight and the slack side [N], and creep [m]. */
export function capacity___guess(arc, tight, slack, creep) {
  return arc.side > 0.0 ? new Guess(tight, slack, creep) : new Guess(slack, tight, creep);
}

/** Where an arc meets a limit of creep or slip, about. */
export function capacity___guess_at(law, arc, tight, limit) {
  let face = meet__interface(law, arc);
  let area = arc.width * arc.radius;
  let p = tight / area;
  let used = capacity__stress_about(face, p, 0.6 * limit.most);
  let fall = min((used / p) * arc.wrap_angle, LARGEST_FALL);
  let slack = tight * Math.exp(-0.9 * fall);
  let end = arc.side * (limit.most + (limit.kind === SLIP ? arc.shear * used : 0.0));
  return capacity___guess(arc, tight, slack, end);
}

/** Meet a goal of creep or slip at the exit by continuation in it, from a small part of it. */
export function meet__by_growth(law, arc, ends, guess, tol) {
  let begin, part;
  let share = FIRST_GOAL;
  let step = 2.0;
  let near = null;
  let last = 0.0;
  let met = meet__unmet(
    meet__interface(law, arc),
    collocation__first_course(arc, 1.0, guess.entry, guess.entry, 0.0),
  );
  let top = max(guess.entry, guess.leaving);
  for (let each1 = 0, end1 = STEPS; each1 < end1; each1++) {
    part = Object.assign(Object.create(Object.getPrototypeOf(ends)), ends, {
      goal: share * ends.goal,
    });
    begin = new Guess(top, top, share * guess.creep);
    met = meet__meet(law, arc, part, begin, near, share < 1.0 ? ROUGH : tol);
    if (met.done && share === 1.0) {
      break;
    }
    if (met.done) {
      near = met.rest === 0.0 ? met.course : null;
      [last, share] = [share, min(step * share, 1.0)];
    } else if (near === null || step < LEAST_GROWTH) {
      break;
    } else {
      step = Math.sqrt(step);
      share = step * last;
    }
  }
  return met;
}

/** Meet a limit of creep or slip at the exit with the tension of the tight side held [N]. */
export function capacity__carry(law, arc, tight, limit, near = null, tol = 1e-5) {
  let ends;
  [arc, ends] = [
    quantities__counted(arc, CAPACITY_STEPS),
    capacity__ends_at(arc, 1.0, 0.0, tight, limit),
  ];
  let guess = capacity___guess_at(law, arc, tight, limit);
  let met = meet__meet(law, arc, ends, guess, near, tol);
  return met.done ? met : meet__by_growth(law, arc, ends, guess, tol);
}

/** A course to begin another question with. */
export function capacity___near(met) {
  return met.rest === 0.0 ? met.course : null;
}

/** How what is carried grows with the creep at the exit, in sign: less tension is left. */
export function capacity__growth(arc, slopes) {
  if (arc.side > 0.0) {
    return -(slopes.last_goal - (slopes.last * slopes.first_goal) / slopes.first);
  }
  return slopes.first_goal - (slopes.first * slopes.last_goal) / slopes.last;
}

/** Tensions of the tight and of the slack side of an arc [N]. */
export function capacity__sides(arc, met) {
  let entry = met.entry;
  let leaving = met.course.tension.at(-1);
  return arc.side > 0.0 ? [entry, leaving] : [leaving, entry];
}

/** ln(tight/slack) of an arc [-]; negative where a large overrun pulls the other way. */
export function capacity__log_ratio(arc, met) {
  const found1 = capacity__sides(arc, met);
  let tight = found1[0];
  let slack = found1[1];
  return Math.log(tight / slack);
}

/** Where a slope ends that is `up` > 0 at one end and `down` < 0 at the other. */
export function capacity___between(low, up, high, down) {
  let place = up > 0.0 && 0.0 > down ? low + ((high - low) * up) / (up - down) : low;
  return low < place && place < high ? place : 0.5 * (low + high);
}

/** Largest ln(tight/slack) of a held tight side over creeps, and its creep [m]. */
export function capacity___largest_at_creep(law, arc, tight, residual) {
  let grows, last, look, met;
  arc = Object.assign(Object.create(Object.getPrototypeOf(arc)), arc, { left: [CAPACITY_STEPS] });
  let best = -Infinity;
  let low = 0.0;
  let high = 0.0;
  let up = 0.0;
  let down = 0.0;
  let peak = collocation__mean_creep(
    meet__interface(law, arc),
    arc,
    tight,
    tight * Math.exp(-10.0),
    ON_THE_RISE,
  );
  let slack = tight * Math.exp(-residual);
  let entry = arc.side > 0.0 ? tight : slack;
  let shrinks = collocation__compliance_of(arc) * arc.radius * arc.wrap_angle;
  shrinks *= arc.side * (entry - (tight - slack) / residual);
  let creep =
    FIRST_PART * max(Math.abs(peak), shrinks + arc.side * collocation__overrun_at(arc, entry)[0]);
  let at = null;
  let near = null;
  let before = 0.0;
  let risen = 0.0;
  let found = false;
  for (let each1 = 0, end1 = MOST_LOOKS; each1 < end1; each1++) {
    look = each1;
    if (look >= LOOKS && risen <= 0.0) {
      break;
    }
    met = capacity__carry(law, arc, tight, new Limit(CREEP, creep), near, ROUGH);
    if (met.done) {
      near = capacity___near(met);
      grows = capacity__growth(arc, met.slopes);
      if (capacity__log_ratio(arc, met) > best && (grows > 0.0 || before > 0.0)) {
        best = capacity__log_ratio(arc, met);
        at = capacity___near(met);
        found = true;
        [low, up, high] = grows > 0.0 ? [creep, grows, 0.0] : [before, risen, creep];
        down = grows;
      }
      if (grows <= 0.0 && high === 0.0) {
        high = creep;
        down = grows;
      }
      before = creep;
      risen = grows;
    }
    creep *= WIDER;
  }
  if (!found || high === 0.0) {
    return [-Infinity, Infinity];
  }
  creep = high;
  last = low;
  while (high - low > 1e-6 * high && Math.abs(creep - last) > 1e-6 * high) {
    last = creep;
    creep = capacity___between(low, up, high, down);
    met = capacity__carry(law, arc, tight, new Limit(CREEP, creep), at);
    if (!met.done) {
      return [NaN, NaN];
    }
    at = capacity___near(met);
    best = capacity__log_ratio(arc, met);
    grows = capacity__growth(arc, met.slopes);
    if (grows > 0.0) {
      [low, up, down] = [creep, grows, 0.5 * down];
    } else {
      [high, down, up] = [creep, grows, 0.5 * up];
    }
  }
  return [best, creep];
}

/** Gross-slip capacity of a held tight side: ln(tight/slack), and the exit creep there [m]. */
export function capacity__largest_ratio(law, arc, tight, softening) {
  let pressure = tight / (arc.width * arc.radius);
  let plateau = gross_slip__plateau_capacity(law, pressure, arc.wrap_angle);
  let residual = softening ? gross_slip__residual_capacity(law, pressure, arc.wrap_angle) : plateau;
  if (residual >= plateau) {
    return [plateau, Infinity];
  }
  if (!gross_slip__outweighs(law, arc, tight, residual)) {
    return [residual, Infinity];
  }
  const found1 = capacity___largest_at_creep(law, arc, tight, residual);
  let most = found1[0];
  let creep = found1[1];
  return most <= residual ? [residual, Infinity] : [most, creep];
}

/** Operating point by continuation in the creep at the exit, the tight side held. */
export function answer___by_creep(law, arc, goal) {
  let between, ends, guess, i, rise, share, there;
  let tight = max(goal.entry, goal.leaving);
  let slack = min(goal.entry, goal.leaving);
  let asked = Math.log(tight / slack);
  let close = CLOSE;
  let first = max(Math.abs(goal.creep), LEAST_GUESS);
  let low = new _Tried(0.0, 0.0, null);
  let high = new _Tried(Infinity, Infinity, null);
  let creep = first;
  let at = low;
  let met = meet__unmet(
    meet__interface(law, arc),
    collocation__first_course(arc, 1.0, goal.entry, goal.leaving, goal.creep),
  );
  for (let each1 = 0, end1 = STEPS; each1 < end1; each1++) {
    i = each1;
    ends = capacity__ends_at(arc, 1.0, 0.0, tight, new Limit(CREEP, creep));
    guess = Object.assign(Object.create(Object.getPrototypeOf(goal)), goal, {
      creep: arc.side * creep,
    });
    met = meet__meet(law, arc, ends, guess, at.course, ROUGH);
    if (met.done) {
      at = new _Tried(creep, capacity__log_ratio(arc, met), met.rest === 0.0 ? met.course : null);
      if (Math.abs(at.carried - asked) < close * asked) {
        between = collocation__between_tensions(goal.entry, goal.leaving);
        there = meet__meet(law, arc, between, goal, at.course, MESH);
        if (there.done && answer___rises(there)) {
          return there;
        }
        close *= NEARER;
      }
      if (at.carried < asked && (met.rest > 0.0 || capacity__growth(arc, met.slopes) > 0.0)) {
        low = at;
      } else {
        high = at;
      }
      if (high.creep === Infinity) {
        creep = 3.0 * low.creep;
      } else if (low.creep === 0.0) {
        creep = 0.3 * high.creep;
      } else {
        rise = high.carried - low.carried;
        share = high.carried > asked ? (asked - low.carried) / rise : 0.5;
        share = min(max(share, 0.1), 0.9);
        creep = low.creep * (high.creep / low.creep) ** share;
        at = share < 0.5 ? low : high;
      }
    } else if (at.creep === 0.0) {
      creep =
        first * AWAY ** (modulo(i, 2) === 0 ? Math.floor((i + 2) / 2) : -Math.floor((i + 1) / 2));
    } else if (LEAST_GROWTH * min(creep, at.creep) > max(creep, at.creep)) {
      break;
    } else {
      creep = Math.sqrt(creep * at.creep);
    }
  }
  return meet__unmet(meet__interface(law, arc), met.course);
}

/** Entry creep ratio g of a course [-]. */
export function meet__ratio_of(at, arc) {
  return at.ratio - collocation__compliance_of(arc) * at.tension[0];
}

/** Operating point of an arc between two tensions [N]. */
export function answer__operating_point(law, arc, entry, leaving) {
  let first;
  arc = quantities__counted(arc, POINT_STEPS);
  let goal = arc.side * Math.log(entry / leaving);
  let area = arc.width * arc.radius;
  let face = meet__interface(law, arc);
  if (Math.abs(goal) < NO_PULL && arc.overrun_constant === 0.0 && arc.overrun_coefficient === 0.0) {
    return new Answer(SOLVED, answer___still(face, arc, entry));
  }
  let top = max(entry, leaving) / area;
  let creep = 2.0 * collocation__mean_creep(face, arc, entry, leaving);
  let guess = new Guess(entry, leaving, creep);
  if (goal >= gross_slip__plateau_capacity(law, top, arc.wrap_angle)) {
    first = collocation__first_course(
      arc,
      arc.radius * arc.wrap_angle,
      guess.entry,
      guess.leaving,
      guess.creep,
    );
    return new Answer(BREAKAWAY, meet__unmet(face, first));
  }
  let met = meet__meet(law, arc, collocation__between_tensions(entry, leaving), guess, null, MESH);
  if (!(met.done && answer___rises(met))) {
    if (goal >= capacity__largest_ratio(law, arc, max(entry, leaving), true)[0]) {
      return new Answer(BREAKAWAY, met);
    }
    met = answer___by_creep(law, arc, guess);
  }
  if (!met.done) {
    return new Answer(UNSOLVED, met);
  }
  if (met.rest === 0.0 && meet__ratio_of(met.course, arc) >= RATIO_END) {
    return new Answer(BREAKAWAY, met);
  }
  return new Answer(answer___rises(met) ? SOLVED : UNSOLVED, met);
}

/** Where the course passes into another piece of the law [m]. */
export function profile__kink_places(arc, met) {
  if (met.course.place.at(-1) === 0.0) {
    return [];
  }
  return [...collocation__kinks(met.face, arc, met.course)]
    .filter(([where, turns]) => !turns)
    .map(([where, turns]) => met.rest + where);
}

/** Point of a rest arc: held by the shear of the lagging alone, or by nothing that gives way. */
export function profile__point_at_rest(arc, met, s) {
  let at = met.course;
  if (arc.shear === 0.0) {
    return new Point(s, met.entry, 0.0, 0.0, 0.0);
  }
  let lag = collocation__lag_length(arc);
  let overrun = collocation__overrun_at(arc, met.entry)[0];
  let early = Math.exp(-s / lag);
  let late = Math.exp((s - met.rest) / lag);
  let creep = overrun * early + at.creep[0] * late;
  let taken = collocation__held_stiffness(arc) * (overrun * (1.0 - early) + at.creep[0] * late);
  return new Point(s, met.entry - taken, creep, 0.0, creep / arc.shear);
}

/** Traction at a tension [N] and a creep [m] of a course. */
export function profile__traction_of(arc, met, tension, creep) {
  return collocation__traction_at(met.face, tension / (arc.width * arc.radius), creep);
}

/** Point at a fraction c of element i of the course. */
export function profile__point_of(arc, met, i, c) {
  let at = met.course;
  const found1 = collocation__state_at(arc, at, i, c);
  let u = found1[0];
  let tension = found1[1];
  if (i === 0 && c === 0.0) {
    u = at.creep[0];
    tension = at.tension[0];
  }
  let felt = profile__traction_of(arc, met, tension, u);
  let place = met.rest + at.place[i] + c * (at.place[i + 1] - at.place[i]);
  return new Point(place, tension, u, felt.slip, felt.stress);
}

/** Point at a place [m]. */
export function profile__point_at(arc, met, s) {
  let middle;
  if (s < met.rest || met.course.place.at(-1) === 0.0) {
    return profile__point_at_rest(arc, met, s);
  }
  let places = met.course.place;
  let low = 0;
  let high = met.course.place.length - 2;
  while (low < high) {
    middle = Math.floor((low + high + 1) / 2);
    if (places[middle] <= s - met.rest) {
      low = middle;
    } else {
      high = middle - 1;
    }
  }
  let c = (s - met.rest - places[low]) / (places[low + 1] - places[low]);
  return profile__point_of(arc, met, low, min(max(c, 0.0), 1.0));
}

export function profile___record(met, out, count, at) {
  let o = RECORD * count;
  [out[o], out[o + 1], out[o + 2]] = [at.place, Math.log(at.tension / met.entry), at.slip];
  [out[o + 3], out[o + 4]] = [at.creep, at.stress];
  return count + 1;
}

/** Profile at equal parts of the wrap and at kinks of the law; records, and their number. */
export function profile__records(arc, met, points) {
  let j, s;
  let length = arc.radius * arc.wrap_angle;
  let places = profile__kink_places(arc, met);
  let out = zeros(RECORD * (points + 2 * places.length + 3));
  let count = 0;
  let k = 0;
  let slides = met.rest > 0.0 && met.course.place.at(-1) > 0.0;
  for (let each1 = 0, end1 = points + 1; each1 < end1; each1++) {
    j = each1;
    s = (length * j) / points;
    while (k < places.length && places[k] < s - ALIKE * length) {
      count = profile___record(met, out, count, profile__point_at(arc, met, places[k]));
      k += 1;
    }
    while (k < places.length && places[k] < s + ALIKE * length) {
      k += 1;
    }
    if (slides && s > met.rest && out[RECORD * (count - 1)] < met.rest) {
      count = profile___record(met, out, count, profile__point_at_rest(arc, met, met.rest));
      if (arc.shear === 0.0) {
        count = profile___record(met, out, count, profile__point_of(arc, met, 0, 0.0));
      }
    }
    count = profile___record(met, out, count, profile__point_at(arc, met, s));
  }
  return [out, count];
}

/** Solution of an arc with its profile and the number of records; none where it has none. */
export function summary__solved_arc(law, geometry, load, points) {
  let found = answer__operating_point(law, geometry, load.entry_tension, load.exit_tension);
  if (found.outcome !== SOLVED) {
    return [found, zeros(0), 0];
  }
  const found1 = profile__records(geometry, found.met, points);
  let out = found1[0];
  let count = found1[1];
  return [found, out, count];
}

/** Cell of a table that a slip [m] lies in; the last one has no end. */
export function compact__cell_of(slips, slip) {
  let cell = 0;
  while (cell < slips.length - 1 && slip >= slips[cell + 1]) {
    cell += 1;
  }
  return cell;
}

/** Branch that holds at a magnitude of slip [m] and a pressure [Pa]. */
export function compact__branch_of(law, segment, slip, pressure) {
  let limit, mu_pk, residual, slip_pk, slope;
  let kind = law.kind;
  let c = law.coefficients;
  let slips = law.slips;
  if (kind === LIMIT) {
    limit = compact__plateau_at(law, segment, pressure) * pressure;
    return c[3] > 0.0 && slip < c[3] * limit ? ELASTIC : PLASTIC;
  }
  if (kind === TABLE) {
    return compact__cell_of(slips, slip);
  }
  const found1 = compact__peak(law, segment, pressure);
  slip_pk = found1[0];
  mu_pk = found1[1];
  if (slip <= slip_pk) {
    return RISE;
  }
  const found2 = compact__tail(law, segment, pressure);
  slope = found2[0];
  residual = found2[1];
  if (mu_pk + slope * (slip - slip_pk) < min(residual, mu_pk)) {
    return RESIDUAL;
  }
  return LINE;
}

/** Friction of a law with the sign of the slip [-]. */
export function summary__available(law, slip, pressure) {
  let mu;
  if (slip === 0.0) {
    return 0.0;
  }
  let segment = compact__segment_of(law, pressure);
  let size = Math.abs(slip);
  const found1 = compact__friction_at(
    law,
    segment,
    compact__branch_of(law, segment, size, pressure),
    size,
    pressure,
  );
  mu = found1[0];
  return copysign(mu, slip);
}

/** Profile of an arc with a rest arc [m], record by record. */
export function summary__columns_of(law, arc, rest, out, count) {
  let felt, i, o, pressure, s, slides, slip, tau, tension;
  let columns = new Columns(
    zeros(count),
    zeros(count),
    zeros(count),
    zeros(count),
    zeros(count),
    zeros(count),
    zeros(count),
    zeros(count),
    zeros(count),
    zeros(count),
  );
  let side = arc.entry_tension >= arc.exit_tension ? 1.0 : -1.0;
  for (let each1 = 0, end1 = count; each1 < end1; each1++) {
    i = each1;
    o = RECORD * i;
    s = out[o];
    slip = out[o + 2];
    tau = out[o + 4];
    tension = (arc.entry_tension - arc.centrifugal) * Math.exp(out[o + 1]) + arc.centrifugal;
    pressure = summary__pressure_of(arc, tension);
    slides = (s > rest || rest === 0.0) && (slip !== 0.0 || tau === 0.0);
    felt = slides ? slip : copysign(NEXT_SLIP, tau === 0.0 ? side : tau);
    columns.position[i] = s / (0.5 * arc.diameter);
    columns.tension[i] = tension;
    columns.wrap_pressure[i] = pressure;
    columns.friction[i] = summary__available(law, felt, pressure);
    columns.friction_used[i] = tau / pressure;
    columns.slip[i] = slip;
    columns.creep[i] = out[o + 3];
    columns.shear_stress[i] = tau;
    columns.shear_angle[i] = Math.atan(tau / arc.shear_modulus);
    columns.sliding[i] = slides ? 1.0 : 0.0;
  }
  return columns;
}

/** Where pressure or slip lie outside the tested range: pairs of places [rad], their number. */
export function summary__stretches_outside(tested, columns, count) {
  let beyond, i;
  let found = zeros(2 * count + 2);
  let pairs = 0;
  let start = -1;
  if (tested === null) {
    return [found, pairs];
  }
  let position = columns.position;
  let pressure = columns.wrap_pressure;
  let slip = columns.slip;
  for (let each1 = 0, end1 = count + 1; each1 < end1; each1++) {
    i = each1;
    beyond =
      i < count &&
      (pressure[i] < tested.pressure_min ||
        pressure[i] > tested.pressure_max ||
        Math.abs(slip[i]) > tested.slip_max);
    if (beyond && start < 0) {
      start = i;
    }
    if (start >= 0 && !beyond) {
      found[2 * pairs] = position[max(start - 1, 0)];
      found[2 * pairs + 1] = position[min(i, count - 1)];
      pairs += 1;
      start = -1;
    }
  }
  return [found, pairs];
}

export function summary___asked_alone(arc) {
  let entry = arc.entry_tension;
  let leaving = arc.exit_tension;
  return new Summary(
    entry,
    leaving,
    entry - leaving,
    entry / leaving,
    NaN,
    NaN,
    NaN,
    NaN,
    NaN,
    NaN,
    NaN,
    NaN,
    NaN,
    NaN,
    NaN,
    NaN,
    NaN,
    NaN,
    NaN,
    NaN,
    NaN,
    NaN,
    NaN,
    NaN,
    NaN,
    NaN,
    NaN,
  );
}

/** A tested range as numbers, nan without one. */
export function summary__range_of(tested) {
  if (tested === null) {
    return new Range(NaN, NaN, NaN);
  }
  return new Range(tested.pressure_min, tested.pressure_max, tested.slip_max);
}

/** Points at the ends and the stages of all elements, and at the entry of a rest arc. */
export function profile__samples(arc, met) {
  let i;
  let found = met.rest === 0.0 ? [] : [profile__point_at_rest(arc, met, 0.0)];
  let at = met.course;
  let length = arc.radius * arc.wrap_angle;
  if (at.place.at(-1) === 0.0) {
    found.push(profile__point_at_rest(arc, met, length));
    return found;
  }
  for (let each1 = 0, end1 = at.place.length - 1; each1 < end1; each1++) {
    i = each1;
    found.push(...[...[0.0, C0, C1, C2]].map((c) => profile__point_of(arc, met, i, c)));
  }
  found.push(profile__point_of(arc, met, at.place.length - 2, 1.0));
  return found;
}

/** Entry creep ratio g [-]. */
export function profile__entry_ratio(arc, met) {
  if (met.rest === 0.0) {
    return meet__ratio_of(met.course, arc);
  }
  if (arc.shear === 0.0) {
    return 0.0;
  }
  let lag = collocation__lag_length(arc);
  let overrun = collocation__overrun_at(arc, met.entry)[0];
  return (met.course.creep[0] * Math.exp(-met.rest / lag) - overrun) / lag;
}

/** Slope of the magnitude of shear stress along the arc [Pa/m]. */
export function profile___slope_at(arc, met, s) {
  let at = profile__point_at(arc, met, s);
  let felt = profile__traction_of(arc, met, at.tension, at.creep);
  let growth = met.course.ratio - collocation__compliance_of(arc) * at.tension;
  let loss = (felt.by_pressure * felt.stress) / arc.radius;
  return (felt.stress >= 0.0 ? 1.0 : -1.0) * (felt.by_creep * growth - loss);
}

/** Largest magnitude of shear stress [Pa] and where it is, s [m]. */
export function profile__peak_stress(arc, met, along) {
  let at, edge, f, f_high, f_low, high, i, low, s, share;
  let best = 0;
  for (let each1 = 1, end1 = along.length; each1 < end1; each1++) {
    i = each1;
    if (Math.abs(along[i].stress) > Math.abs(along[best].stress)) {
      best = i;
    }
  }
  let most = Math.abs(along[best].stress);
  let where = along[best].place;
  for (const each2 of [best - 1, best]) {
    i = each2;
    if (i < 0 || i + 1 >= along.length || along[i].place < met.rest) {
      continue;
    }
    low = along[i].place;
    high = along[i + 1].place;
    edge = 1e-9 * (high - low);
    f_low = profile___slope_at(arc, met, low + edge);
    f_high = profile___slope_at(arc, met, high - edge);
    if (!(f_low > 0.0 && 0.0 > f_high)) {
      continue;
    }
    for (let each3 = 0, end3 = HALVINGS; each3 < end3; each3++) {
      share = min(max(f_low / (f_low - f_high), 0.05), 0.95);
      s = low + (high - low) * share;
      f = profile___slope_at(arc, met, s);
      if (f > 0.0) {
        [low, f_low, f_high] = [s, f, 0.5 * f_high];
      } else {
        [high, f_high, f_low] = [s, f, 0.5 * f_low];
      }
      if (high - low < edge) {
        break;
      }
    }
    at = profile__point_at(arc, met, 0.5 * (low + high));
    if (Math.abs(at.stress) > most) {
      most = Math.abs(at.stress);
      where = at.place;
    }
  }
  return [most, where];
}

/** How far a point lies beyond one of the limits of a tested range, > 0 outside. */
export function profile___beyond(arc, at, tested, kind) {
  let pressure = at.tension / (arc.width * arc.radius);
  if (kind === 0) {
    return tested.pressure_min - pressure;
  }
  if (kind === 1) {
    return pressure - tested.pressure_max;
  }
  return Math.abs(at.slip) - tested.slip_max;
}

/** Where between two places what holds at the first ends to hold: from below and above [m]. */
export function profile___border(before, low, high) {
  let middle;
  for (let each1 = 0, end1 = HALVINGS; each1 < end1; each1++) {
    middle = 0.5 * (low + high);
    if (before(middle)) {
      low = middle;
    } else {
      high = middle;
    }
  }
  return [low, high];
}

/** Where between two points a limit is crossed [m]. */
export function profile___crossing(arc, met, a, b, tested, kind) {
  let outside = profile___beyond(arc, a, tested, kind) > 0.0;
  const same = (s) => {
    return profile___beyond(arc, profile__point_at(arc, met, s), tested, kind) > 0.0 === outside;
  };
  const found1 = profile___border(same, a.place, b.place);
  let low = found1[0];
  let high = found1[1];
  return 0.5 * (low + high);
}

/** Fraction of the arc where pressure or slip lies outside the tested range. */
export function profile__share_outside(arc, met, along, tested) {
  let a, b, f_a, f_b, high, i, kind, low;
  let outside = 0.0;
  for (let each1 = 0, end1 = along.length - 1; each1 < end1; each1++) {
    i = each1;
    a = along[i];
    b = along[i + 1];
    low = a.place;
    high = b.place;
    for (let each2 = 0, end2 = 3; each2 < end2; each2++) {
      kind = each2;
      f_a = profile___beyond(arc, a, tested, kind);
      f_b = profile___beyond(arc, b, tested, kind);
      if (f_a > 0.0 && f_b > 0.0) {
        high = low - 1.0;
      } else if (f_a > 0.0) {
        low = max(low, profile___crossing(arc, met, a, b, tested, kind));
      } else if (f_b > 0.0) {
        high = min(high, profile___crossing(arc, met, a, b, tested, kind));
      }
    }
    outside += b.place - a.place - max(high - low, 0.0);
  }
  return outside / (along.at(-1).place - along[0].place);
}

/** Int tau du along the arc by Lobatto's rule: of the course, at places of its own [J/m2]. */
export function profile__loss_along(arc, met, along) {
  let end, ends, h, i, inner, p, pair, weight;
  let at = met.course;
  let c = collocation__compliance_of(arc);
  let total = 0.0;
  for (let each1 = 0, end1 = at.place.length - 1; each1 < end1; each1++) {
    i = each1;
    h = at.place[i + 1] - at.place[i];
    if (h === 0.0) {
      continue;
    }
    ends = [profile__point_of(arc, met, i, 0.0), profile__point_of(arc, met, i, 1.0)];
    inner = [
      profile__point_of(arc, met, i, LOBATTO),
      profile__point_of(arc, met, i, 1.0 - LOBATTO),
    ];
    for (const each2 of [
      [AT_ENDS, ends],
      [INSIDE, inner],
    ]) {
      [weight, pair] = each2;
      for (const each3 of pair) {
        p = each3;
        total += weight * h * p.stress * (at.ratio - c * p.tension);
      }
    }
  }
  if (met.rest > 0.0 && arc.shear > 0.0) {
    end = at.creep[0];
    total += (0.5 / arc.shear) * (end * end - along[0].creep * along[0].creep);
  }
  return total;
}

/** Length of the entry part of the arc over which the belt does not slip [m]. */
export function profile__stuck_length(arc, met, along) {
  if (met.rest > 0.0 || !quantities__jumps(met.face.law) || along[0].slip !== 0.0) {
    return met.rest;
  }
  let i = 0;
  while (i + 1 < along.length && along[i + 1].slip === 0.0) {
    i += 1;
  }
  if (i + 1 === along.length) {
    return along[i].place;
  }
  const held = (s) => {
    return profile__point_at(arc, met, s).slip === 0.0;
  };
  return profile___border(held, along[i].place, along[i + 1].place)[0];
}

/** Length of the exit part of the arc that takes 99 % of the tension change [m]. */
export function profile__active_length(arc, met, along) {
  let end = along.at(-1);
  let change = met.entry - end.tension;
  if (Math.abs(change) <= ROUNDING * met.entry) {
    return 0.0;
  }
  let i = along.length - 1;
  while (i > 0 && (met.entry - along[i].tension) / change > ACTIVE_SHARE) {
    i -= 1;
  }
  if (i === along.length - 1) {
    return 0.0;
  }
  const idle = (s) => {
    return (met.entry - profile__point_at(arc, met, s).tension) / change <= ACTIVE_SHARE;
  };
  return end.place - profile___border(idle, along[i].place, along[i + 1].place)[0];
}

/** Read an arc that is solved; `tested` is of nan without a tested range. */
export function profile__read(arc, met, tested) {
  let along = profile__samples(arc, met);
  let end = along.at(-1);
  let g = profile__entry_ratio(arc, met);
  let c = collocation__compliance_of(arc);
  let pull = met.entry - end.tension;
  let loss = (pull * (g + 0.5 * pull * c)) / arc.width;
  const found1 = profile__peak_stress(arc, met, along);
  let peak = found1[0];
  let where = found1[1];
  let outside = NaN;
  if (tested.slip_max === tested.slip_max) {
    outside = profile__share_outside(arc, met, along, tested);
  }
  return new Read(
    met.course.creep.at(-1),
    end.slip,
    end.stress,
    along[0].stress,
    g,
    loss,
    Math.abs(profile__loss_along(arc, met, along) - loss),
    profile__stuck_length(arc, met, along),
    profile__active_length(arc, met, along),
    peak,
    where,
    outside,
  );
}

/** Spring rate of the belt over its active arc, EA/l [N/m]; nan of an idle pulley. */
export function summary__spring_rate(axial_stiffness, length, creep) {
  return length > IDLE && Math.abs(creep) > IDLE ? axial_stiffness / length : NaN;
}

/** Reported numbers of an arc that is solved; nan where there is none. */
export function summary__summary_of(geometry, arc, tested, found) {
  if (found.outcome !== SOLVED) {
    return summary___asked_alone(arc);
  }
  let entry = arc.entry_tension;
  let exit_tension = arc.exit_tension;
  let radius = 0.5 * arc.diameter;
  let told = profile__read(geometry, found.met, summary__range_of(tested));
  let pull = entry - exit_tension;
  let g = told.creep_ratio;
  let length = radius * arc.wrap_angle;
  let kappa = summary__recovery_compliance(arc);
  let compliance = 1.0 / arc.axial_stiffness + kappa;
  let recovery = compliance > 0.0 ? kappa / compliance : 0.0;
  let overrun = collocation__overrun_at(geometry, entry - arc.centrifugal)[0];
  let distributed = told.creep - overrun - g * length;
  let kept =
    0.5 *
    arc.shear_compliance *
    (told.stress * told.stress - told.entry_stress * told.entry_stress);
  let work = told.loss - kept;
  if (Math.abs(work) < 1e-12 * (Math.abs(told.loss) + Math.abs(kept))) {
    work = 0.0;
  }
  let speed = g < 1.0 ? arc.belt_speed / (1.0 - g) : NaN;
  let part = Math.abs(pull) > 1e-6 * entry ? (geometry.width * told.loss) / Math.abs(pull) : NaN;
  let efficiency = pull > 0.0 ? 1.0 - part : 1.0 / (1.0 + part);
  return new Summary(
    entry,
    exit_tension,
    pull,
    entry / exit_tension,
    told.creep,
    (1.0 - recovery) * distributed,
    recovery * distributed + overrun,
    g * length,
    told.slip,
    g,
    g + pull * compliance,
    told.peak,
    Math.atan(told.peak / arc.shear_modulus),
    told.peak_at / radius,
    Math.abs(Math.log(entry / exit_tension)) / arc.wrap_angle,
    told.active / radius,
    summary__spring_rate(arc.axial_stiffness, radius * (told.active / radius), told.creep),
    told.outside,
    told.stuck / radius,
    speed * pull,
    speed * geometry.width * work,
    speed * geometry.width * kept,
    speed * geometry.width * told.loss,
    efficiency,
    work,
    1000000.0 * arc.wear_coefficient * work,
    (geometry.width * told.miss) /
      max(max(Math.abs(geometry.width * told.loss), 1e-6 * entry * Math.abs(g)), 1e-300),
  );
}

/** Answer for one arc; None where it is for the server to say what is wrong. */
export function in_page__quick(law, given, tested, points) {
  let arc = in_page__description_of(given);
  if (in_page__refused(law, arc, given.steepest_fall)) {
    return null;
  }
  let geometry = summary__geometry_of(arc);
  let load = in_page__load_of(given, arc, null);
  const found1 = summary__solved_arc(law, geometry, load, points);
  let found = found1[0];
  let out = found1[1];
  let count = found1[2];
  if (!(found.outcome === SOLVED || found.outcome === BREAKAWAY)) {
    return null;
  }
  let profile = summary__columns_of(law, arc, found.met.rest, out, count);
  const found2 = summary__stretches_outside(tested, profile, count);
  let outside = found2[0];
  let stretches = found2[1];
  let summary = summary__summary_of(geometry, arc, tested, found);
  return new Quick(found.outcome === SOLVED, summary, profile, outside, stretches);
}

/** Whether an arc hands nothing over: its pulley is not driven. */
export function pull__idles(entry, leaving) {
  return Math.abs(entry - leaving) <= 1e-6 * entry;
}

/** Largest tight-side tension that is looked at [N]: that of the largest tested pressure. */
export function capacity__highest_tight(pressure_max, area, tight) {
  return pressure_max === pressure_max ? pressure_max * area : HIGHEST * tight;
}

/** d(pull)/d(tight-side tension) along a limit at the exit [-]. */
export function capacity___pull_slope(arc, slopes) {
  let first = slopes.first;
  let last = slopes.last;
  if (arc.side > 0.0) {
    return 1.0 - last / first;
  }
  return 1.0 - first / last;
}

/** Pull of an arc with a tension of the tight side [N]. */
export function capacity___pull(arc, met, tight) {
  return tight * -Math.expm1(-capacity__log_ratio(arc, met));
}

/** Ln tight-side tension of the largest pull at a limit, that pull [N], and its course. */
export function capacity___largest_pull(law, arc, limit, within, near, enough) {
  let last, met, pull, slope;
  let [low, high] = within;
  let best = high;
  let most = -Infinity;
  let at = near;
  let up = 0.0;
  let down = 0.0;
  let t = low;
  for (let each1 = 0, end1 = ROUNDS; each1 < end1; each1++) {
    [last, t] = [t, capacity___between(low, up, high, down)];
    met = capacity__carry(law, arc, Math.exp(t), limit, at);
    if (!met.done) {
      break;
    }
    pull = capacity___pull(arc, met, Math.exp(t));
    if (pull > most) {
      best = t;
      most = pull;
      at = capacity___near(met);
    }
    if (most >= enough || high - low < NEAR_TOP || Math.abs(t - last) < NEAR_TOP) {
      break;
    }
    slope = capacity___pull_slope(arc, met.slopes);
    if (slope > 0.0) {
      [low, up, down] = [t, slope, 0.5 * down];
    } else {
      [high, down, up] = [t, slope, 0.5 * up];
    }
  }
  return [best, most, at];
}

/** `least_slack` along the tension: the pull at the limit grows with it, up to a largest one. */
export function capacity___least_sought(law, arc, pull, limit, at_tight, top) {
  let by_log, carried, miss, near, new_, slope;
  let high = Math.log(top);
  let low = min(Math.log(pull) + LEAST_OVER, high - DEEPEST);
  let met = at_tight;
  let t = high;
  let over = false;
  if (met.done) {
    t = Math.log(capacity__sides(arc, met)[0]);
  }
  if (!(met.done && t < high && capacity___pull_slope(arc, met.slopes) > 0.0)) {
    t = high;
    met = capacity__carry(law, arc, top, limit);
  }
  for (let each1 = 0, end1 = ROUNDS; each1 < end1; each1++) {
    if (!met.done) {
      break;
    }
    carried = capacity___pull(arc, met, Math.exp(t));
    slope = capacity___pull_slope(arc, met.slopes);
    miss = carried > 0.0 ? Math.log(carried / pull) : -Infinity;
    if (Math.abs(miss) < 1e-9 && slope > 0.0) {
      return new Least(Math.exp(t) - pull, NaN);
    }
    if (miss < 0.0 && slope > 0.0 && t >= high) {
      return new Least(NaN, carried);
    }
    if (miss < 0.0 && slope <= 0.0) {
      const found2 = capacity___largest_pull(law, arc, limit, [low, t], capacity___near(met), pull);
      t = found2[0];
      carried = found2[1];
      near = found2[2];
      if (!(carried >= pull)) {
        return new Least(NaN, carried);
      }
      high = t;
      over = true;
      met = capacity__carry(law, arc, Math.exp(t), limit, near);
      continue;
    }
    [low, high] = miss > 0.0 ? [low, t] : [t, high];
    over = over || miss > 0.0;
    by_log = (slope * Math.exp(t)) / carried;
    new_ = by_log > 0.0 ? t - miss / by_log : low;
    new_ = new_ >= high && !over ? high : new_;
    t = (low < new_ && new_ < high) || (new_ === high && !over) ? new_ : 0.5 * (low + high);
    met = capacity__carry(law, arc, Math.exp(t), limit, capacity___near(met));
  }
  return new Least(NaN, NaN);
}

/** Least slack-side tension that carries a pull within a limit at the exit. */
export function capacity__least_slack(law, arc, pull, limit, at_tight, top) {
  let carried, ends, first, found, guess, met;
  arc = quantities__counted(arc, CAPACITY_STEPS);
  if (at_tight.done) {
    carried = -Math.expm1(-capacity__log_ratio(arc, at_tight));
    first = max(carried > 0.0 ? min(pull / carried, top) : 0.0, 1.02 * pull);
    guess = capacity___guess(arc, first, first - pull, at_tight.course.creep.at(-1));
    ends = capacity__ends_at(arc, 1.0, -1.0, pull, limit);
    met = meet__meet(law, arc, ends, guess, capacity___near(at_tight), MISFIT);
    if (met.done && capacity___pull_slope(arc, met.slopes) > 0.0) {
      found = capacity__sides(arc, met)[0];
      if (found <= top) {
        return new Least(found - pull, NaN);
      }
    }
  }
  return capacity___least_sought(law, arc, pull, limit, at_tight, top);
}

/** Capacities that are asked for by `parts`. */
export function capacity__find_capacities(law, arc, load, parts) {
  let by_creep, by_slip, gross, gross_creep, least, met, most, top;
  arc = quantities__counted(arc, CAPACITY_STEPS);
  let tight = max(load.entry_tension, load.exit_tension);
  let pull = Math.abs(load.entry_tension - load.exit_tension);
  by_creep = by_slip = gross = gross_creep = least = most = NaN;
  let limit = new Limit(CREEP, load.creep_limit);
  let near = null;
  if (parts & (CREEP_LIMIT + LEAST)) {
    met = capacity__carry(law, arc, tight, limit);
    if (met.done) {
      by_creep = capacity__log_ratio(arc, met);
      near = capacity___near(met);
    }
    if (parts & LEAST && pull > 1e-6 * tight) {
      top = capacity__highest_tight(load.pressure_max, arc.width * arc.radius, tight);
      const found1 = capacity__least_slack(law, arc, pull, limit, met, top);
      least = found1.slack;
      most = found1.most;
    }
  }
  if (parts & TESTED_SLIP && load.slip_max === load.slip_max) {
    met = capacity__carry(law, arc, tight, new Limit(SLIP, load.slip_max), near);
    if (met.done) {
      by_slip = capacity__log_ratio(arc, met);
    }
  }
  if (parts & GROSS_SLIP) {
    const found2 = capacity__largest_ratio(law, arc, tight, load.steepest_fall < 0.0);
    gross = found2[0];
    gross_creep = found2[1];
    if (gross_creep <= load.creep_limit) {
      by_creep = gross;
    }
    if (gross_creep <= load.slip_max) {
      by_slip = gross;
    }
  }
  return new Carried(by_creep, by_slip, gross, gross_creep, least, most);
}

/** Whether the tested slip ends well before the creep of sliding. */
export function sliding___tests_end_first(of, tight) {
  let pressure = tight / (of.geometry.width * of.geometry.radius);
  let friction = compact__plateau_at(of.law, compact__segment_of(of.law, pressure), pressure);
  return of.load.slip_max + of.geometry.shear * friction * pressure < EARLY * SLIDES;
}

/** What ends the grip of an arc, whichever comes first; nothing of a law that falls. */
export function sliding__at_limits(of) {
  let limit;
  let tight = max(of.load.entry_tension, of.load.exit_tension);
  let found = [];
  if (of.peaks) {
    return [];
  }
  if (of.load.slip_max === of.load.slip_max) {
    limit = new Limit(SLIP_KIND, of.load.slip_max);
    found.push(new AtLimit(limit, TESTED, capacity__carry(of.law, of.geometry, tight, limit)));
  }
  if (!sliding___tests_end_first(of, tight)) {
    limit = new Limit(CREEP_KIND, SLIDES);
    found.push(new AtLimit(limit, 0, capacity__carry(of.law, of.geometry, tight, limit)));
  }
  return found;
}

/** Tensions of a line at which a limit is met, about: of the tight and of the slack side [N]. */
export function capacity___first_along(law, arc, line, limit, at_tight) {
  let asked, k, middle, used;
  let [tight, slack, tight_rise, slack_rise] = line;
  let ratio = Math.exp(capacity__log_ratio(arc, at_tight));
  if (tight_rise > ratio * slack_rise) {
    k = 1.0 + (ratio * slack - tight) / (tight_rise - ratio * slack_rise);
    return [tight + (k - 1.0) * tight_rise, slack + (k - 1.0) * slack_rise];
  }
  if (!(tight_rise > 0.0)) {
    return [NaN, NaN];
  }
  let face = meet__interface(law, arc);
  let area = arc.width * arc.radius;
  let low = tight;
  let high = FAR * tight;
  let first = capacity__stress_about(face, tight / area, 0.6 * limit.most) / tight;
  for (let each1 = 0, end1 = 12; each1 < end1; each1++) {
    middle = Math.sqrt(low * high);
    used = capacity__stress_about(face, middle / area, 0.6 * limit.most) / middle;
    asked = Math.log(middle / (slack + ((middle - tight) / tight_rise) * slack_rise));
    if (asked < (used / first) * capacity__log_ratio(arc, at_tight)) {
      low = middle;
    } else {
      high = middle;
    }
  }
  return [middle, slack + ((middle - tight) / tight_rise) * slack_rise];
}

/** Meet a limit of creep or slip at the exit with tensions on a line, T = T(1) + (k - 1) rise. */
export function capacity__carry_along(law, arc, line, limit, at_tight) {
  arc = quantities__counted(arc, CAPACITY_STEPS);
  let [tight, slack, tight_rise, slack_rise] = line;
  if (!at_tight.done) {
    return new Along(NaN, at_tight);
  }
  if (tight_rise === 0.0 && slack_rise < 0.0) {
    return new Along(1.0 + (capacity__sides(arc, at_tight)[1] - slack) / slack_rise, at_tight);
  }
  const found1 = capacity___first_along(law, arc, line, limit, at_tight);
  let top = found1[0];
  let low = found1[1];
  if (!(top > 0.0 && low > 0.0)) {
    return new Along(NaN, at_tight);
  }
  let size = max(Math.abs(tight_rise), Math.abs(slack_rise));
  let at_top = slack_rise / size;
  let at_low = -tight_rise / size;
  let goal = at_top * (tight - tight_rise) + at_low * (slack - slack_rise);
  let guess = capacity___guess(arc, top, low, at_tight.course.creep.at(-1));
  let met = meet__meet(
    law,
    arc,
    capacity__ends_at(arc, at_top, at_low, goal, limit),
    guess,
    capacity___near(at_tight),
    MISFIT,
  );
  if (!met.done) {
    return new Along(NaN, met);
  }
  const found2 = capacity__sides(arc, met);
  let found = found2[0];
  let other = found2[1];
  if (!(tight_rise * other > slack_rise * found)) {
    return new Along(NaN, met);
  }
  let by_tight = Math.abs(tight_rise) >= Math.abs(slack_rise);
  let step = by_tight ? (found - tight) / tight_rise : (other - slack) / slack_rise;
  return new Along(1.0 + step, met);
}

/** ln(tight/slack) with the largest friction everywhere, for a tension of the tight side [N]. */
export function sliding___most_at(of, tight) {
  let pressure = tight / (of.geometry.width * of.geometry.radius);
  return gross_slip__plateau_capacity(of.law, pressure, of.geometry.wrap_angle);
}

/** Largest ln(tight/slack) before the belt slides with a tight side held [N], and the cause. */
export function sliding__carried_at(of, tight) {
  let driving = of.geometry.side > 0.0;
  let load = Object.assign(Object.create(Object.getPrototypeOf(of.load)), of.load, {
    entry_tension: driving ? tight : 0.5 * tight,
    exit_tension: driving ? 0.5 * tight : tight,
    creep_limit: SLIDES,
  });
  let most = sliding___most_at(of, tight);
  let parts = BY_CREEP + BY_SLIP + (of.peaks ? BY_LAW : 0);
  if (!of.peaks && sliding___tests_end_first(of, tight)) {
    parts = BY_SLIP;
  }
  let found = capacity__find_capacities(of.law, of.geometry, load, parts);
  let q = found.creep_limit;
  let cause = 0;
  if (Number.isNaN(q) || found.tested_slip < q * (1.0 - 1e-6)) {
    q = found.tested_slip;
    cause = TESTED;
  }
  if (q >= most * (1.0 - 1e-6) || (of.peaks && q >= found.gross_slip * (1.0 - 1e-6))) {
    cause = MOST;
  }
  return [q, cause];
}

/** What friction has to spare at a place of a line, over what, and about its slope. */
export function sliding___spare(of, line, k, q, even) {
  let kept;
  let tight = line.tight + (k - 1.0) * line.tight_rise;
  let slack = line.slack + (k - 1.0) * line.slack_rise;
  if (even) {
    kept = Math.exp(-q);
    return [k, slack - tight * kept, line.slack_rise - line.tight_rise * kept];
  }
  let asked = Math.log(tight / slack);
  let area = of.geometry.width * of.geometry.radius;
  let wrap = of.geometry.wrap_angle;
  let here = gross_slip__plateau_capacity(of.law, tight / area, wrap);
  let there = gross_slip__plateau_capacity(of.law, (tight * (1.0 + DIFFERENCE)) / area, wrap);
  let fall = (((there - here) / (here * DIFFERENCE)) * k * line.tight_rise) / tight;
  let grows = (k * (line.tight_rise / tight - line.slack_rise / slack)) / asked;
  return [Math.log(k), Math.log(max(q, LEAST_CARRIED) / asked), fall - grows];
}

/** A step to `new`, kept between the ends. */
export function sliding___within(ends, new_, k) {
  new_ = min(new_, 200.0);
  if (ends.low < new_ && new_ < ends.high) {
    return new_;
  }
  return ends.high < Infinity ? 0.5 * (ends.low + ends.high) : min(4.0 * k + 1.0, 200.0);
}

/** Place k of a line at which the belt begins to slide (way 1) or ends to (way -1). */
export function sliding__slide_place(of, line, way, low, start) {
  let at, end, new_, q, slope, spare;
  let falls = line.slack_rise < 0.0;
  let even = falls || way < 0.0;
  let ends = new Bracket(low, Infinity);
  if (line.slack_rise !== 0.0) {
    end = 1.0 - line.slack / line.slack_rise;
    ends = falls ? new Bracket(low, end) : new Bracket(max(low, end), Infinity);
  }
  let k = start >= ends.high ? 0.5 * (ends.low + ends.high) : start;
  let last = NaN;
  let spare_last = NaN;
  let cause = 0;
  for (let each1 = 0, end1 = ROUNDS; each1 < end1; each1++) {
    const found2 = sliding__carried_at(of, line.tight + (k - 1.0) * line.tight_rise);
    q = found2[0];
    cause = found2[1];
    if (Number.isNaN(q)) {
      return new Sliding(NaN, cause);
    }
    const found3 = sliding___spare(of, line, k, q, even);
    at = found3[0];
    spare = found3[1];
    slope = found3[2];
    if (last === last && at !== last) {
      slope = (spare - spare_last) / (at - last);
    }
    if (spare < 0.0 === way > 0.0) {
      ends = new Bracket(ends.low, k);
    } else if (k >= 200.0) {
      return new Sliding(Infinity, cause);
    } else {
      ends = new Bracket(k, ends.high);
    }
    last = at;
    spare_last = spare;
    new_ = way * slope < 0.0 ? at - spare / slope : Infinity;
    if (!even) {
      new_ = Math.exp(min(new_, 30.0));
    }
    if (Math.abs(new_ - k) <= _NEAR * k) {
      return new Sliding(new_, cause);
    }
    new_ = sliding___within(ends, new_, k);
    if (Math.abs(new_ - k) <= 1e-14 * k) {
      return new Sliding(new_, cause);
    }
    k = new_;
  }
  return new Sliding(k, cause);
}

/** Pull at which the belt slides over the pull, tensions growing along a line. */
export function sliding__pull_at_sliding(of, line, begin) {
  let cause, exhausted, first_met, limit, met, place, tight;
  if (line.tight === line.slack) {
    return new Sliding(Infinity, 0);
  }
  let first = new Sliding(Infinity, 0);
  for (const each1 of begin) {
    [limit, cause, first_met] = each1;
    const found2 = capacity__carry_along(of.law, of.geometry, line, limit, first_met);
    place = found2.place;
    met = found2.met;
    if (!(place > 0.0)) {
      return sliding__slide_place(of, line, 1.0, 0.0, 1.0);
    }
    tight = capacity__sides(of.geometry, met)[0];
    exhausted =
      capacity__log_ratio(of.geometry, met) >= sliding___most_at(of, tight) * (1.0 - 1e-6);
    if (place < first.place * (1.0 - 1e-6)) {
      first = new Sliding(place, exhausted ? MOST : cause);
    }
  }
  return first.place === Infinity ? sliding__slide_place(of, line, 1.0, 0.0, 1.0) : first;
}

export function least_numbers___least_within(law, geometry, of, limit) {
  let met = capacity__carry(law, geometry, of.tight, limit);
  let least = capacity__least_slack(law, geometry, of.pull, limit, met, of.top).slack;
  return least === least ? least : Infinity;
}

/** Least slack-side tension with which the creep at the exit keeps a limit [N]; inf if none. */
export function least_numbers__least_for_creep(law, geometry, of, limit) {
  return least_numbers___least_within(law, geometry, of, new Limit(CREEP, limit));
}

/** Return the geometry whose answers are those of an arc with a factor on its friction. */
export function sliding__with_friction(geometry, factor) {
  return Object.assign(Object.create(Object.getPrototypeOf(geometry)), geometry, {
    wrap_angle: factor * geometry.wrap_angle,
    compliance: geometry.compliance / factor,
    shear: factor * geometry.shear,
  });
}

/** Least slack-side tension with which the slip at the exit keeps a limit [N]; inf if none. */
export function least_numbers__least_for_slip(law, geometry, of, limit) {
  return least_numbers___least_within(law, geometry, of, new Limit(SLIP, limit));
}

/** Tight over slack side by ln(tight/slack) of the tensions above m v^2, tight side held [-]. */
export function summary__tension_ratio_of(arc, carried) {
  if (arc.centrifugal === 0.0) {
    return Math.exp(carried);
  }
  let tight = max(arc.entry_tension, arc.exit_tension);
  return tight / ((tight - arc.centrifugal) * Math.exp(-carried) + arc.centrifugal);
}

/** Capacities and margins of an arc. */
export function summary__capacity_numbers(arc, carried) {
  let entry = arc.entry_tension;
  let leaving = arc.exit_tension;
  let wrap_angle = arc.wrap_angle;
  let actual = max(entry, leaving) / min(entry, leaving);
  let creep = summary__tension_ratio_of(arc, carried.creep_limit);
  let slip = summary__tension_ratio_of(arc, carried.tested_slip);
  let gross = summary__tension_ratio_of(arc, carried.gross_slip);
  return new CapacityNumbers(
    creep,
    creep / actual,
    max(Math.log(creep), 0.0) / wrap_angle,
    carried.least_slack + arc.centrifugal,
    max(carried.most_pull, 0.0),
    slip,
    slip / actual,
    gross,
    gross / actual,
    carried.gross_creep,
  );
}

/** Least tension of the tight side with which a pull does not slide the belt [N]; inf if none. */
export function sliding__tight_at_sliding(of, pull, begin) {
  let limit, met, slack;
  if (pull <= 0.0) {
    return 0.0;
  }
  let tight = max(of.load.entry_tension, of.load.exit_tension);
  let needed = 0.0;
  for (const each1 of begin) {
    [limit, , met] = each1;
    slack = capacity__least_slack(of.law, of.geometry, pull, limit, met, 200.0 * pull).slack;
    needed = slack === slack && needed === needed ? max(needed, slack + pull) : NaN;
  }
  if (needed > 0.0) {
    return needed;
  }
  let line = new Line(pull, 0.0, pull, pull);
  return pull * sliding__slide_place(of, line, -1.0, 1.0, max(tight / pull, 1.0 + 1e-6)).place;
}

/** How much all tensions must rise for a safety factor against sliding [N]. */
export function sliding__lift_for_safety(of, factor, tight_rise, begin) {
  let tight = max(of.load.entry_tension, of.load.exit_tension);
  let pull = Math.abs(of.load.entry_tension - of.load.exit_tension);
  return sliding__tight_at_sliding(of, factor * pull, begin) - tight - (factor - 1.0) * tight_rise;
}

/** Largest magnitude in a column. */
export function numbers__largest(column, count) {
  let i;
  let found = 0.0;
  for (let each1 = 0, end1 = count; each1 < end1; each1++) {
    i = each1;
    found = max(found, Math.abs(column[i]));
  }
  return found;
}

/** Magnitude of x' at a fraction of an element [-]; 0 where the belt does not slip. */
export function profile___slip_growth(arc, met, i, c) {
  const found1 = collocation__state_at(arc, met.course, i, c);
  let u = found1[0];
  let tension = found1[1];
  let felt = profile__traction_of(arc, met, tension, u);
  if (felt.slip === 0.0) {
    return 0.0;
  }
  let growth = met.course.ratio - collocation__compliance_of(arc) * tension;
  let loss = (felt.by_pressure * felt.stress) / arc.radius;
  return Math.abs(growth - arc.shear * (felt.by_creep * growth - loss));
}

/** Top of x' in an element beside a place: of parabolas through three that are ever closer. */
export function profile___top_growth(arc, met, i, c) {
  let before, behind, bend, here;
  let most = 0.0;
  let wide = PLACES[2] - PLACES[1];
  for (let each1 = 0, end1 = NARROWER; each1 < end1; each1++) {
    before = profile___slip_growth(arc, met, i, c - wide);
    here = profile___slip_growth(arc, met, i, c);
    behind = profile___slip_growth(arc, met, i, c + wide);
    most = max(max(max(most, before), here), behind);
    bend = before - 2.0 * here + behind;
    if (!(bend < 0.0)) {
      break;
    }
    c += wide * min(max((0.5 * (before - behind)) / bend, -0.5), 0.5);
    wide *= 0.25;
    c = min(max(c, PLACES[0] + wide), PLACES.at(-1) - wide);
  }
  return max(most, profile___slip_growth(arc, met, i, c));
}

/** Larger x' of both sides of the kink beside the end of an element. */
export function profile___growth_at_kink(arc, met, i, before, behind) {
  let c, j, middle, rate;
  let places = met.course.place;
  let wide = places[i + 1] - places[i];
  let next_wide = places[i + 2] - places[i + 1];
  let low = -BESIDE * wide;
  let high = BESIDE * next_wide;
  for (let each1 = 0, end1 = SIDES; each1 < end1; each1++) {
    middle = 0.5 * (low + high);
    [j, c] = middle < 0.0 ? [i, 1.0 + middle / wide] : [i + 1, middle / next_wide];
    rate = profile___slip_growth(arc, met, j, c);
    if (Math.abs(rate - before) < Math.abs(rate - behind)) {
      low = middle;
      before = rate;
    } else {
      high = middle;
      behind = rate;
    }
  }
  return max(before, behind);
}

/** Largest growth of slip per length along the arc [-]. */
export function profile__steepest_slip(arc, met) {
  let before, behind, i, k, part;
  let n = met.course.place.length - 1;
  if (met.course.place.at(-1) === 0.0) {
    return 0.0;
  }
  let rates = [...$range(n)].map((i) =>
    [...PLACES].map((c) => profile___slip_growth(arc, met, i, c)),
  );
  let most = max(
    profile___slip_growth(arc, met, 0, 1e-9),
    profile___slip_growth(arc, met, n - 1, 1.0),
  );
  for (const each1 of rates) {
    part = each1;
    most = max(most, $maxOf(part));
  }
  for (let each2 = 0, end2 = n; each2 < end2; each2++) {
    i = each2;
    part = rates[i];
    for (let each3 = 1, end3 = PLACES.length - 1; each3 < end3; each3++) {
      k = each3;
      if (part[k] >= ABOUT * most && part[k] >= max(part[k - 1], part[k + 1])) {
        most = max(most, profile___top_growth(arc, met, i, PLACES[k]));
      }
    }
    if (i + 1 < n) {
      before = part.at(-1);
      behind = rates[i + 1][0];
      if (max(before, behind) >= (1.0 - BESIDE) * most && before !== behind) {
        most = max(most, profile___growth_at_kink(arc, met, i, before, behind));
      }
    }
  }
  return most;
}

/** Creep at the exit with a cover in series, see `ArcResult.covered_creep` [m]. */
export function in_page__covered_creep(law, given, cover) {
  if (cover === 0.0) {
    return NaN;
  }
  let arc = in_page__description_of(
    Object.assign(Object.create(Object.getPrototypeOf(given)), given, {
      cover_compliance: given.cover_compliance + cover,
    }),
  );
  let load = in_page__load_of(given, arc, null);
  let geometry = summary__geometry_of(arc);
  let found = answer__operating_point(law, geometry, load.entry_tension, load.exit_tension);
  return found.outcome === SOLVED
    ? found.met.course.creep.at(-1)
    : copysign(Infinity, geometry.side);
}

/** Creep at the exit with a factor on the friction [m]; inf in gross slip, nan without a factor. */
export function sliding__wet_creep(of, factor) {
  if (Number.isNaN(factor)) {
    return NaN;
  }
  let wet = sliding__with_friction(of.geometry, factor);
  let found = answer__operating_point(of.law, wet, of.load.entry_tension, of.load.exit_tension);
  return found.outcome === SOLVED ? Math.abs(found.met.course.creep.at(-1)) : Infinity;
}

/** Return the resultant of the belt tensions at a pulley, and its bounds with its own weight. */
export function load_case__resultant(entry, leaving, wrap_angle, strength, mass = NaN) {
  let along = entry - leaving * Math.cos(wrap_angle);
  let across = leaving * Math.sin(wrap_angle);
  let force = Math.sqrt(along * along + across * across);
  let angle = Math.atan2(across, along);
  let weight = mass * GRAVITY;
  let safety = strength / max(entry, leaving);
  return new Resultant(force, angle, safety, force + weight, Math.abs(force - weight));
}

/** Numbers of the checks of one arc; None where they are for the server to find. */
export function in_page__judged(law, given, tested, criteria, points) {
  let by_slip, covered, series, wetted, when_wet;
  let arc = in_page__description_of(given);
  let entry = arc.entry_tension;
  let leaving = arc.exit_tension;
  if (in_page__refused(law, arc, given.steepest_fall) || pull__idles(entry, leaving)) {
    return null;
  }
  let geometry = summary__geometry_of(arc);
  let load = in_page__load_of(given, arc, tested);
  const found1 = summary__solved_arc(law, geometry, load, points);
  let found = found1[0];
  let out = found1[1];
  let count = found1[2];
  if (!(found.outcome === SOLVED || found.outcome === BREAKAWAY)) {
    return null;
  }
  let profile = summary__columns_of(law, arc, found.met.rest, out, count);
  let carried = capacity__find_capacities(law, geometry, load, CAPACITIES);
  let loaded = new Loaded(
    law,
    geometry,
    load,
    given.steepest_fall < 0.0 && carried.gross_creep !== Infinity,
  );
  let tight = max(entry, leaving) - arc.centrifugal;
  let slack = min(entry, leaving) - arc.centrifugal;
  let line = new Line(tight, slack, criteria.tight_rise, criteria.slack_rise);
  let begin = sliding__at_limits(loaded);
  let sliding = sliding__pull_at_sliding(loaded, line, begin);
  if (sliding.place !== sliding.place) {
    return null;
  }
  by_slip = covered = when_wet = NaN;
  let top = capacity__highest_tight(load.pressure_max, arc.width * (0.5 * arc.diameter), tight);
  let pull = new Pull(Math.abs(entry - leaving), tight, top);
  let limit = given.creep_limit;
  if (criteria.cover !== 0.0) {
    series = Object.assign(Object.create(Object.getPrototypeOf(geometry)), geometry, {
      shear: geometry.shear + criteria.cover,
    });
    covered = least_numbers__least_for_creep(law, series, pull, limit) + arc.centrifugal;
  }
  if (criteria.wet > 0.0) {
    wetted = sliding__with_friction(geometry, criteria.wet);
    when_wet = least_numbers__least_for_creep(law, wetted, pull, limit) + arc.centrifugal;
  }
  if (load.slip_max < limit) {
    by_slip = least_numbers__least_for_slip(law, geometry, pull, load.slip_max) + arc.centrifugal;
  }
  let runs = (arc.belt_speed * 0.5 * arc.diameter) / (0.5 * arc.diameter + arc.pitch_offset);
  return new Found(
    found.outcome === SOLVED,
    summary__summary_of(geometry, arc, tested, found),
    summary__capacity_numbers(arc, carried),
    sliding.place,
    sliding.cause,
    sliding__lift_for_safety(loaded, criteria.safety, criteria.tight_rise, begin),
    by_slip,
    covered,
    when_wet,
    numbers__largest(profile.slip, count),
    count > 0 ? runs * profile__steepest_slip(geometry, found.met) : NaN,
    in_page__covered_creep(law, given, criteria.cover),
    criteria.wet !== 0.0 ? sliding__wet_creep(loaded, criteria.wet) : NaN,
    load_case__resultant(entry, leaving, arc.wrap_angle, criteria.strength, criteria.pulley_mass),
  );
}

/** The keys given that fix the effective tension. */
export function tension_rules__effective_keys(of) {
  return [...EFFECTIVE].filter((key) => of[key] !== null);
}

/** One key for each independent quantity given. */
export function tension_rules__families(of) {
  let keys = [...ENDS].filter((key) => of[key] !== null);
  let pulls = tension_rules__effective_keys(of);
  if (pulls.length > 0) {
    keys.push(pulls[0]);
  }
  return keys;
}

/** Effective tension that is given [N]; None where it is not, or does not follow. */
export function tension_rules__pull_given(of, at) {
  if (of.effective_tension !== null) {
    return of.effective_tension;
  }
  if (of.torque !== null) {
    return at.diameter === null ? null : load_case__pull_of_torque(of.torque, at.diameter);
  }
  if (of.power === null || at.speed === null) {
    return null;
  }
  return load_case__pull_of_power(of.power, at.speed);
}

/** What is given with the pull between the outer tensions: that of the pulleys less the runs. */
export function tension_rules__less_runs(of, runs, at) {
  let pull = tension_rules__pull_given(of, at);
  if (runs === 0.0 || pull === null) {
    return of;
  }
  return new LoadGiven(of.entry_tension, of.exit_tension, pull - runs, null, null);
}

/** Both tensions by one of them and the pull [N]. */
export function tension_rules__filled(entry, leaving, pull) {
  if (pull !== null && leaving === null && entry !== null) {
    return new NipTensions(entry, entry - pull);
  }
  if (pull !== null && entry === null && leaving !== null) {
    return new NipTensions(leaving + pull, leaving);
  }
  return new NipTensions(entry, leaving);
}

/** Tensions at the nips, as far as they follow [N]. */
export function tension_rules__ends_of(of, at) {
  return tension_rules__filled(
    of.entry_tension,
    of.exit_tension,
    tension_rules__pull_given(of, at),
  );
}

/** What is given of a pulley with what a load case gives put over it. */
export function tension_rules__overridden(of, over, fixed, at, runs) {
  let between, ends, half;
  if (tension_rules__families(over).length >= 2) {
    return over;
  }
  let pull = tension_rules__pull_given(over, at);
  if (fixed && pull !== null && tension_rules__effective_keys(over).length === 1) {
    ends = tension_rules__ends_of(tension_rules__less_runs(of, runs.base, at), at);
    if (ends.entry === null || ends.exit === null) {
      return over;
    }
    half = 0.5 * (ends.entry + ends.exit);
    between = 0.5 * (pull - runs.case);
    return new LoadGiven(half + between, half - between, null, null, null);
  }
  let by = tension_rules__effective_keys(over).length > 0 ? over : of;
  return new LoadGiven(
    over.entry_tension === null ? of.entry_tension : over.entry_tension,
    over.exit_tension === null ? of.exit_tension : over.exit_tension,
    by.effective_tension,
    by.torque,
    by.power,
  );
}

/** Whether more is given than fixes the tensions. */
export function tension_rules__overdetermined(of) {
  return tension_rules__effective_keys(of).length > 1 || tension_rules__families(of).length > 2;
}

/** Keys in words. */
export function tension_rules__listed(keys) {
  return "" + $text(keys.slice(0, -1).join(", ")) + " and " + $text(keys.at(-1));
}

/** What is wrong with what is given of one pulley, by itself. */
export function tension_rules__fault_of(of, inherited, at, force) {
  let between;
  let pulls = tension_rules__effective_keys(of);
  let given = tension_rules__families(of);
  if (!tension_rules__overdetermined(of)) {
    return null;
  }
  if (pulls.length > 1) {
    return new LoadFault(
      "" + $text(tension_rules__listed(pulls)) + " each fix the effective tension",
      ONE_TOO_MANY,
      "",
    );
  }
  let message = "" + $text(tension_rules__listed(given)) + " are one too many";
  let pull = tension_rules__pull_given(of, at);
  let ends = tension_rules__ends_of(of, at);
  if (pull !== null && ends.entry !== null && ends.exit !== null) {
    between = ends.entry - ends.exit;
    if (Math.abs(pull - between) > _ALIKE * Math.abs(between)) {
      message =
        "" +
        $text(pulls[0]) +
        " makes " +
        $text(force(pull)) +
        ", the tensions " +
        $text(force(between));
    }
  }
  let remedy = "" + "Give two of " + $text(given.join(", ")) + " in the load case.";
  return new LoadFault(message, inherited ? remedy : ONE_TOO_MANY, "");
}

/** Whether a power is given, and no belt speed to make a pull of it. */
export function tension_rules__speed_missing(of, at) {
  if (at.speed !== null || of.power === null) {
    return null;
  }
  let remedy = 'Write speed = "3 m/s" in [belt], or give effective_tension.';
  return new LoadFault("power needs the belt speed", remedy, "power");
}

/** What is said where the tensions do not follow. */
export function tension_rules__too_few(of) {
  let given = tension_rules__families(of);
  if (given.length === 0) {
    return new LoadFault("tensions missing", FEW, "tensions");
  }
  let message = "" + $text(given[0]) + " alone does not fix the tensions";
  return new LoadFault(message, FEW, "tensions");
}

/** Tensions of a load case that gives its pull alone, by a take-up between drives [N]. */
export function tension_rules__behind_take_up(now, first, after, before) {
  if (now.entry === null || now.exit === null || first.entry === null || first.exit === null) {
    return null;
  }
  let pull = now.entry - now.exit;
  let pull_0 = first.entry - first.exit;
  let lost = after.share * (pull + after.runs) - after.behind;
  lost -= before.share * (pull_0 + before.runs) - before.behind;
  return new NipTensions(first.exit - lost + pull, first.exit - lost);
}

/** S, loaded area over the area free to bulge [-]: a/(4 h) square, w/(2 h) strip. */
export function compression__shape_factor(square, width, height) {
  return width / ((square ? 4.0 : 2.0) * height);
}

/** Effective compression modulus by plain numbers, see `compression_modulus` [Pa]. */
export function compression__block_modulus(elastic_modulus, square, width, height, k, contact) {
  let s2 = compression__shape_factor(square, width, height) ** 2;
  if (square) {
    return contact * elastic_modulus * (1.0 + 2.0 * k * s2);
  }
  return contact * (4.0 / 3.0) * elastic_modulus * (1.0 + k * s2);
}
