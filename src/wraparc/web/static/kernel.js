// @ts-nocheck
// Made from the Python source by `make kernel`: change that, not this.
const max = (a, b) => (b > a ? b : a);
const min = (a, b) => (b < a ? b : a);
const copysign = (a, b) => (b < 0 || Object.is(b, -0) ? -Math.abs(a) : Math.abs(a));
const modulo = (a, b) => (a % b !== 0 && a % b < 0 !== b < 0 ? (a % b) + b : a % b);
const NOTHING = new Float64Array(0);
const zeros = (size) => (size > 0 ? new Float64Array(size) : NOTHING);

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
  }
}

export class Geometry {
  constructor(side, radius, wrap_angle, width, compliance, shear, kick, kick_coefficient, onset) {
    this.side = side;
    this.radius = radius;
    this.wrap_angle = wrap_angle;
    this.width = width;
    this.compliance = compliance;
    this.shear = shear;
    this.kick = kick;
    this.kick_coefficient = kick_coefficient;
    this.onset = onset;
  }
  *[Symbol.iterator]() {
    yield this.side;
    yield this.radius;
    yield this.wrap_angle;
    yield this.width;
    yield this.compliance;
    yield this.shear;
    yield this.kick;
    yield this.kick_coefficient;
    yield this.onset;
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

export class Aim {
  constructor(of, value) {
    this.of = of;
    this.value = value;
  }
  *[Symbol.iterator]() {
    yield this.of;
    yield this.value;
  }
}

export class Layers {
  constructor(
    solved,
    z,
    entry_tension,
    rest_tension,
    creep,
    ratio,
    entry_length,
    length,
    exit_creep,
    exit_ratio,
  ) {
    this.solved = solved;
    this.z = z;
    this.entry_tension = entry_tension;
    this.rest_tension = rest_tension;
    this.creep = creep;
    this.ratio = ratio;
    this.entry_length = entry_length;
    this.length = length;
    this.exit_creep = exit_creep;
    this.exit_ratio = exit_ratio;
  }
  *[Symbol.iterator]() {
    yield this.solved;
    yield this.z;
    yield this.entry_tension;
    yield this.rest_tension;
    yield this.creep;
    yield this.ratio;
    yield this.entry_length;
    yield this.length;
    yield this.exit_creep;
    yield this.exit_ratio;
  }
}

export class Case {
  constructor(aim, exit_tension, crossing, floors, close, tolerance) {
    this.aim = aim;
    this.exit_tension = exit_tension;
    this.crossing = crossing;
    this.floors = floors;
    this.close = close;
    this.tolerance = tolerance;
  }
  *[Symbol.iterator]() {
    yield this.aim;
    yield this.exit_tension;
    yield this.crossing;
    yield this.floors;
    yield this.close;
    yield this.tolerance;
  }
}

export class Arrival {
  constructor(arrived, length, creep, ratio) {
    this.arrived = arrived;
    this.length = length;
    this.creep = creep;
    this.ratio = ratio;
  }
  *[Symbol.iterator]() {
    yield this.arrived;
    yield this.length;
    yield this.creep;
    yield this.ratio;
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

export class Found {
  constructor(outcome, z, shot, layers, steps) {
    this.outcome = outcome;
    this.z = z;
    this.shot = shot;
    this.layers = layers;
    this.steps = steps;
  }
  *[Symbol.iterator]() {
    yield this.outcome;
    yield this.z;
    yield this.shot;
    yield this.layers;
    yield this.steps;
  }
}

export class State {
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

export class Answer {
  constructor(outcome, par, z, shot, layers, steps) {
    this.outcome = outcome;
    this.par = par;
    this.z = z;
    this.shot = shot;
    this.layers = layers;
    this.steps = steps;
  }
  *[Symbol.iterator]() {
    yield this.outcome;
    yield this.par;
    yield this.z;
    yield this.shot;
    yield this.layers;
    yield this.steps;
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

export class Among {
  constructor(end, held, slack_end, sagging, tight_rise, slack_rise) {
    this.end = end;
    this.held = held;
    this.slack_end = slack_end;
    this.sagging = sagging;
    this.tight_rise = tight_rise;
    this.slack_rise = slack_rise;
  }
  *[Symbol.iterator]() {
    yield this.end;
    yield this.held;
    yield this.slack_end;
    yield this.sagging;
    yield this.tight_rise;
    yield this.slack_rise;
  }
}

export class Beginning {
  constructor(creep_limit, tested_slip, least, entry) {
    this.creep_limit = creep_limit;
    this.tested_slip = tested_slip;
    this.least = least;
    this.entry = entry;
  }
  *[Symbol.iterator]() {
    yield this.creep_limit;
    yield this.tested_slip;
    yield this.least;
    yield this.entry;
  }
}

export class Guess {
  constructor(z, layers) {
    this.z = z;
    this.layers = layers;
  }
  *[Symbol.iterator]() {
    yield this.z;
    yield this.layers;
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

export class Compared {
  constructor(
    gross_slip,
    design_standard,
    creep,
    belt_tension,
    momentary_tension,
    face_pressure,
    bond_stress,
    fatigue_stress,
    tested_pressure_max,
    tested_pressure_min,
    tested_slip,
    tested_slip_speed,
    balance,
    sag,
    pulley_diameter,
    share = NaN,
    passes = NaN,
  ) {
    this.gross_slip = gross_slip;
    this.design_standard = design_standard;
    this.creep = creep;
    this.belt_tension = belt_tension;
    this.momentary_tension = momentary_tension;
    this.face_pressure = face_pressure;
    this.bond_stress = bond_stress;
    this.fatigue_stress = fatigue_stress;
    this.tested_pressure_max = tested_pressure_max;
    this.tested_pressure_min = tested_pressure_min;
    this.tested_slip = tested_slip;
    this.tested_slip_speed = tested_slip_speed;
    this.balance = balance;
    this.sag = sag;
    this.pulley_diameter = pulley_diameter;
    this.share = share;
    this.passes = passes;
  }
  *[Symbol.iterator]() {
    yield this.gross_slip;
    yield this.design_standard;
    yield this.creep;
    yield this.belt_tension;
    yield this.momentary_tension;
    yield this.face_pressure;
    yield this.bond_stress;
    yield this.fatigue_stress;
    yield this.tested_pressure_max;
    yield this.tested_pressure_min;
    yield this.tested_slip;
    yield this.tested_slip_speed;
    yield this.balance;
    yield this.sag;
    yield this.pulley_diameter;
    yield this.share;
    yield this.passes;
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

export class Ends {
  constructor(low, high) {
    this.low = low;
    this.high = high;
  }
  *[Symbol.iterator]() {
    yield this.low;
    yield this.high;
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
    gross_slip_margin,
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
    this.gross_slip_margin = gross_slip_margin;
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
    yield this.gross_slip_margin;
    yield this.gross_slip_creep;
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

export class Asked {
  constructor(
    creep,
    tested_slip,
    design_standard,
    gross_slip,
    tested_pressure_min,
    tested_pressure_max,
    face_pressure,
    belt_tension,
    sag,
    given,
  ) {
    this.creep = creep;
    this.tested_slip = tested_slip;
    this.design_standard = design_standard;
    this.gross_slip = gross_slip;
    this.tested_pressure_min = tested_pressure_min;
    this.tested_pressure_max = tested_pressure_max;
    this.face_pressure = face_pressure;
    this.belt_tension = belt_tension;
    this.sag = sag;
    this.given = given;
  }
  *[Symbol.iterator]() {
    yield this.creep;
    yield this.tested_slip;
    yield this.design_standard;
    yield this.gross_slip;
    yield this.tested_pressure_min;
    yield this.tested_pressure_max;
    yield this.face_pressure;
    yield this.belt_tension;
    yield this.sag;
    yield this.given;
  }
}

export class Judged {
  constructor(solved, summary, capacities, values, limits, held, asked, cause, wet) {
    this.solved = solved;
    this.summary = summary;
    this.capacities = capacities;
    this.values = values;
    this.limits = limits;
    this.held = held;
    this.asked = asked;
    this.cause = cause;
    this.wet = wet;
  }
  *[Symbol.iterator]() {
    yield this.solved;
    yield this.summary;
    yield this.capacities;
    yield this.values;
    yield this.limits;
    yield this.held;
    yield this.asked;
    yield this.cause;
    yield this.wet;
  }
}

export class Pulls {
  constructor(entry_tension, exit_tension, effective_tension, torque, power) {
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
const LINE = 1;
const ELASTIC = 0;
const STEPS = 24;
const LEAST_COMPLIANCE = 1e-16;
const TENSION = 0;
const STEP_TOLERANCE = 1e-9;
const NO_LAYERS = new Layers(false, NaN, NaN, NaN, NaN, NaN, NaN, NaN, NaN, NaN);
const _MOST_TRIALS = 200;
const RESIDUAL = 2;
const FLOOR = 1e-9;
const NEARBY = 8;
const TO_CREEP = 1;
const TO_RATIO = 0;
const KINK_TOLERANCE = 0.01;
const MOST_STEPS = 800;
const NOISE = 100.0;
const FILLED = 3.0;
const SOLVED = 0;
const LARGEST_RATIO = 1.0;
const BREAKAWAY = 1;
const HALVINGS = 4;
const MARGIN = 4.0;
const UNSOLVED = 2;
const RECORD = 6;
const LARGEST_LOG = 50.0;
const FEWEST_CUT_STEPS = 16;
const MESH_POWER = 4;
const FARTHEST_SLIP = 1000.0;
const LARGEST_LOG_STEP = 0.12;
const NEAREST = 1e-7;
const STEEP = 0.5;
const CELL_PARTS = 3.0;
const FEW_STEPS = 0.05;
const PART_OF_LAG = 0.3;
const WILD_LOG_STEP = 1.0;
const WILD_SLIP = 10000.0;
const MOST_CUTS = 200;
const PREVIOUS_BRANCH = 3;
const LOWER_EDGE = 0;
const UPPER_EDGE = 1;
const NO_SLIP = 2;
const NEXT_BRANCH = 4;
const SMOOTH_CUT_TOLERANCE = 0.0003;
const CUT_TOLERANCE = 1e-6;
const SLIP_CUT_TOLERANCE = 1e-9;
const LANDINGS = 40;
const STUCK = 4;
const NO_PULL = 1e-11;
const FAR = 13.0;
const _PIECE = 0.25;
const CREEP = 1;
const SMALL_RATIO = 1e-7;
const NO_SHOT = new Shot(NaN, NaN, NaN, NaN, NaN, NaN, NaN);
const FINEST = 32;
const NEARLY_IDLE = 0.0001;
const MOST_LAGS = 100.0;
const LAGS_PER_MESH = 2.0;
const FIRST = 64;
const STEP = 57;
const TOLERANCE = 1e-10;
const CREEP_SCALE = 0.00635;
const GRADED_END = 0.1;
const NODE = 11;
const GRADED_POWER = 10;
const LOST = 5;
const PART = 9;
const LANDING = 1e-12;
const SLIP = 2;
const COARSE_STEPS = 8;
const COARSE_TOLERANCE = 0.0001;
const LOSS_MISS = 1e-6;
const FINER = 8;
const TURNS = 60;
const LEAST_TURN = 1e-9;
const BALANCE = 1e-8;
const NODES = 400;
const KINKS = 200;
const NEXT_SLIP = 1e-300;
const PEAK_TOLERANCE = 1e-6;
const GOLDEN = 0.6180339887498949;
const IDLE = 1e-6;
const CREEP_LIMIT = 0.00635;
const WIDTHS = [0.2, 4.0];
const MODULI = [100000.0, 1000000000.0];
const SPEEDS = [0.05, 15.0];
const DIAMETERS = [0.15, 3.0];
const USUAL_TENSION = [500.0, 10000000.0];
const CAPACITIES = 30;
const NO_BEGINNING = new Beginning(NaN, NaN, NaN, NaN);
const LEAST = 8;
const MEET_STEPS = 12;
const MOST_ROUNDS = 30;
const ALIKE = 1e-9;
const SLOW_ROUNDS = 8;
const HIGHEST = 1000.0;
const NEAR_TOP = 0.08;
const PULL_TOLERANCE = 2e-9;
const TESTED_SLIP = 4;
const GROSS_SLIP = 16;
const PRESSURES = 5;
const PEAK_STEPS = 12;
const EDGE = 0.0005;
const _ROUNDS = 60;
const SLIDES = 0.0635;
const BY_CREEP = 2;
const BY_SLIP = 4;
const BY_LAW = 16;
const _FIRST = 0.8;
const _STEPS = 24;
const _ALIKE = 1e-6;
const TESTED = 1;
const MOST = 2;
const _DIFFERENCE = 0.001;
const _FARTHEST = 200.0;
const _NEAR = 1e-8;
const NOT_CARRIED = 0.999;
const SEVERAL_PULLS = 1;
const ALL_THREE = 2;
const TOO_FEW = 3;
const NO_SPEED = 4;
const UNUSUAL = 3;
const HELD = 0.1;
const BEHIND = 1000000000.0;
const NUMBERLESS = -2000000000.0;
const AHEAD = 4000000000.0;

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
    return load_case__pull_of_torque(given.torque, given.diameter);
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
    given.speed,
    given.wear_coefficient,
  );
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

/** Numbers of the arc for the march; `onset` is that of its law [m/Pa]. */
export function summary__geometry_of(arc, onset) {
  let radius = 0.5 * arc.diameter;
  let given = arc.overrun === arc.overrun;
  let by_formula = summary__overrun_coefficient(arc.thickness / arc.compression_modulus, radius);
  return new Geometry(
    arc.entry_tension >= arc.exit_tension ? 1.0 : -1.0,
    radius,
    arc.wrap_angle,
    arc.width,
    1.0 / arc.axial_stiffness + summary__recovery_compliance(arc),
    arc.thickness / arc.shear_modulus,
    given ? arc.overrun : 0.0,
    given ? 0.0 : by_formula,
    onset,
  );
}

/** Whether friction falls so steeply that slip and shear of the lagging are not unique. */
export function summary__too_steep(arc, fall) {
  let top = (2.0 * max(arc.entry_tension, arc.exit_tension)) / (arc.width * arc.diameter);
  return (arc.thickness / arc.shear_modulus) * top * fall <= -1.0;
}

/** Whether a law holds the belt without slip. */
export function effort__jumps(law) {
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
  let number = Math.exp(b / a - 1.0);
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

/** Shear stress a law holds without slip [Pa] and its derivative by pressure [-]. */
export function stick__onset_stress(law, pressure) {
  let segment = compact__segment_of(law, pressure);
  let branch = law.kind === LIMIT ? PLASTIC : 0;
  const found1 = compact__friction_at(law, segment, branch, 0.0, pressure);
  let mu = found1[0];
  let mu_p = found1[2];
  return [mu * pressure, mu + pressure * mu_p];
}

/** Creep up to which a law that jumps holds the belt without slip at a pressure [m]. */
export function summary__held_creep(law, shear, pressure) {
  return (shear + law.onset_compliance) * stick__onset_stress(law, pressure)[0];
}

/** Whether the overrun is more than a law that jumps holds: no creep at rest is unique then. */
export function summary__kicked_loose(law, geometry, pressure) {
  if (!effort__jumps(law)) {
    return false;
  }
  let kick = Math.abs(geometry.kick + geometry.kick_coefficient * pressure * Math.sqrt(pressure));
  return kick > 0.0 && kick > summary__held_creep(law, geometry.shear, pressure);
}

/** Whether it is for the server to say what is wrong with an arc. */
export function in_page__refused(law, arc, fall) {
  let entry = arc.entry_tension;
  let leaving = arc.exit_tension;
  if (!(min(entry, leaving) >= LEAST_TENSION && max(entry, leaving) <= MOST_TENSION)) {
    return true;
  }
  let geometry = summary__geometry_of(arc, law.onset_compliance);
  let pressure = (2.0 * entry) / (arc.width * arc.diameter);
  return summary__too_steep(arc, fall) || summary__kicked_loose(law, geometry, pressure);
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
  return new Load(arc.entry_tension, arc.exit_tension, limit, low, high, slip, fall);
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

/** Length l = sqrt(c_e EA' / B), over which a stuck belt hands over its tension [m]. */
export function stick__shear_lag_length(par) {
  return Math.sqrt((par.shear + par.onset) / (par.width * par.compliance));
}

/** Whether the belt sticks over the whole wrap, and its creep at the exit if it does [m]. */
export function stick__held_exit(law, par, exit_tension) {
  let compliance = par.shear + par.onset;
  if (compliance === 0.0) {
    return [exit_tension === par.entry_tension, 0.0];
  }
  let lag = stick__shear_lag_length(par);
  let length = par.length;
  let e = Math.exp(-length / lag);
  let pull = (par.entry_tension - exit_tension) * lag * par.compliance;
  let u =
    par.kick * e + (pull + par.kick * Math.expm1(-length / lag)) / Math.tanh((0.5 * length) / lag);
  let limit = compliance * stick__onset_stress(law, exit_tension / (par.width * par.radius))[0];
  return [Math.abs(u) <= limit, u];
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

/** Whether friction holds the belt all along a stuck zone, and not at its end alone. */
export function stick__holds(law, par, length, end_creep) {
  let creep, held, i, tension;
  let compliance = par.shear + par.onset;
  let parts = 64;
  for (let each1 = 1, end1 = parts; each1 < end1; each1++) {
    i = each1;
    const found2 = stick__zone_point(par, (length * i) / parts, length, end_creep);
    tension = found2[0];
    creep = found2[1];
    const found3 = stick__onset_stress(law, tension / (par.width * par.radius));
    held = found3[0];
    if (Math.abs(creep) > compliance * held * (1.0 + 1e-9)) {
      return false;
    }
  }
  return true;
}

/** Cell of a table that a slip [m] lies in; the last one has no end. */
export function compact__cell_of(slips, slip) {
  let cell = 0;
  while (cell < slips.length - 1 && slip >= slips[cell + 1]) {
    cell += 1;
  }
  return cell;
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

/** The same before the peak of an integral-log law: r (1 + k (1 - ln r)) = w. */
export function layer_march___on_the_rise(slip_pk, mu_pk, ease, creep, share) {
  let change, lr;
  let k = (ease * mu_pk) / slip_pk;
  let w = creep / slip_pk;
  let r = share * w;
  if (share === 1.0) {
    r = w / (1.0 + k * (1.0 - Math.log(max(min(w, 1.0), SMALLEST))));
  }
  r = max(min(r, 1.0), 1e-300);
  for (let each1 = 0, end1 = 30; each1 < end1; each1++) {
    lr = Math.log(r);
    change = (r * (1.0 + k * (1.0 - lr)) - w) / (1.0 - k * lr);
    r = min(max(r - change, 0.1 * r), 1.0);
    if (Math.abs(change) <= 1e-14 * r) {
      break;
    }
  }
  return [mu_pk * r * (1.0 - Math.log(r)), r * slip_pk];
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

/** The same past a peak, and under a law with a limit; `x` is a first guess of the slip [m]. */
export function layer_march___past_the_rise(law, segment, ease, pressure, creep, x) {
  let branch, miss, mu_x, slope;
  let low = 0.0;
  let high = creep;
  let mu = 0.0;
  for (let each1 = 0, end1 = 60; each1 < end1; each1++) {
    branch = compact__branch_of(law, segment, x, pressure);
    const found2 = compact__friction_at(law, segment, branch, x, pressure);
    mu = found2[0];
    mu_x = found2[1];
    miss = x + ease * mu - creep;
    if (Math.abs(miss) <= 1e-13 * creep || high - low <= 1e-14 * creep) {
      break;
    }
    if (miss > 0.0) {
      high = x;
    } else {
      low = x;
    }
    slope = 1.0 + ease * mu_x;
    x = slope > 0.0 ? x - miss / slope : low;
    if (!(low < x && x < high)) {
      x = 0.5 * (low + high);
    }
  }
  return [mu, x];
}

/** Friction [-] and slip x [m] with x + ease mu(x) = creep (Newton, inside a bracket). */
export function layer_march___slip_and_friction(law, ease, pressure, creep, share) {
  let held, mu_pk, slip_pk;
  let segment = compact__segment_of(law, pressure);
  if (law.kind === TABLE) {
    return table_slip__slip_under_table(law, segment, ease, pressure, creep, share);
  }
  if (law.kind === KNOTS || law.kind === PIECES) {
    const found1 = compact__peak(law, segment, pressure);
    slip_pk = found1[0];
    mu_pk = found1[1];
    if (segment >= law.edges.length - 1 && law.edges.length - 1 >= 0) {
      mu_pk *= law.edges[law.edges.length - 1] / pressure;
    }
    if (creep <= slip_pk + ease * mu_pk) {
      return layer_march___on_the_rise(slip_pk, mu_pk, ease, creep, share);
    }
  }
  if (law.kind === LIMIT && ease > 0.0 && law.coefficients[3] === 0.0) {
    const found2 = compact__friction_at(law, segment, PLASTIC, 0.0, pressure);
    held = found2[0];
    if (creep <= ease * held) {
      return [creep / ease, 0.0];
    }
  }
  return layer_march___past_the_rise(law, segment, ease, pressure, creep, share * creep);
}

/** Shear stress [Pa] and slip [m] at a creep and a tension. */
export function layer_march__friction_of_creep(law, par, tension, u) {
  if (u === 0.0) {
    return [0.0, 0.0];
  }
  let p = par.entry_pressure * max(tension / par.entry_tension, 1e-9);
  const found1 = layer_march___slip_and_friction(law, par.shear * p, p, Math.abs(u), 1.0);
  let mu = found1[0];
  let x = found1[1];
  return u > 0.0 ? [mu * p, x] : [-mu * p, -x];
}

/** Shear-lag length sqrt(u / (tau B C)) of a creep [m]; the whole arc where nothing holds. */
export function layer_march__lag_at(law, par, tension, creep) {
  const found1 = layer_march__friction_of_creep(law, par, tension, creep);
  let tau = found1[0];
  let stiffness = tau * par.width * par.compliance;
  if (stiffness <= 0.0) {
    return par.length;
  }
  return min(Math.sqrt(creep / stiffness), par.length);
}

/** What is to be met, with its floors. */
export function layers___case(law, par, aim, exit_tension, tolerance) {
  let lag, pull;
  let close = 1e-12 * par.entry_tension;
  if (exit_tension === exit_tension) {
    close = 0.1 * tolerance * exit_tension;
  }
  let creep = max(Math.abs(par.kick), aim.value);
  if (aim.of === TENSION) {
    pull = par.entry_tension * Math.abs(1.0 - Math.exp(-par.side * aim.value));
    close = max(min(close, 1e-8 * pull), 1e-15 * par.entry_tension);
    creep = max(Math.abs(par.kick), 1e-6);
    for (let each1 = 0, end1 = 8; each1 < end1; each1++) {
      lag = layer_march__lag_at(law, par, par.entry_tension, creep);
      creep = max(max(Math.abs(par.kick), par.compliance * pull * lag), 1e-200);
    }
  }
  let floor = FLOOR * creep;
  let floors = [floor, floor / layer_march__lag_at(law, par, par.entry_tension, floor)];
  return new Case(aim, exit_tension, false, floors, close, tolerance);
}

/** The same with or without creep that passes through zero. */
export function layers___crossed(case_, crossing) {
  return new Case(
    case_.aim,
    case_.exit_tension,
    crossing,
    case_.floors,
    case_.close,
    case_.tolerance,
  );
}

/** Creep and creep ratio where the layers part, and whether there is none at the entry. */
export function layers___parting(par, case_, z) {
  let kick = par.kick;
  let floors = case_.floors;
  let way = kick > 0.0 ? 1.0 : -1.0;
  if (kick === 0.0) {
    return [0.0, par.side * floors[1] * Math.exp(z), true];
  }
  if (case_.crossing) {
    return [0.0, -way * floors[1] * Math.exp(z), false];
  }
  let creep = way * floors[0] * Math.exp(z);
  if (Math.abs(creep) < Math.abs(kick)) {
    return [creep, 0.0, false];
  }
  let spare = Math.exp(z) - Math.abs(kick) / floors[0];
  return [kick, way * floors[1] * spare, true];
}

/** Of a state, what a goal is compared with. */
export function layer_march__value_at(law, par, rest, to, u, w) {
  if (to === TO_RATIO) {
    return w;
  }
  if (to === TO_CREEP) {
    return u;
  }
  return layer_march__friction_of_creep(law, par, rest - w / par.compliance, u)[1];
}

/** Write one step of a path that has room. */
export function layer_march___note(path, s, u, w) {
  let n;
  if (path.length > 0) {
    n = Math.trunc(path[0]);
    [path[0], path[3 * n + 1], path[3 * n + 2], path[3 * n + 3]] = [n + 1.0, s, u, w];
  }
}

/** dw/ds = C B tau [1/m], and slip over creep; `share` is a first guess of that. */
export function layer_march___growth(law, par, rest, u, w, share) {
  if (u === 0.0) {
    return [0.0, share];
  }
  let tension = rest - w / par.compliance;
  let p = par.entry_pressure * max(tension / par.entry_tension, 1e-9);
  const found1 = layer_march___slip_and_friction(law, par.shear * p, p, Math.abs(u), share);
  let mu = found1[0];
  let x = found1[1];
  let growth = par.compliance * par.width * mu * p;
  return [u > 0.0 ? growth : -growth, x / Math.abs(u)];
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

/** One step of length h, which may be negative: creep and creep ratio at its end. */
export function layer_march__layer_step(law, par, rest, u, w, h) {
  let g2, g3, g4, g5, g6, g7;
  const found1 = layer_march___growth(law, par, rest, u, w, 1.0);
  let g1 = found1[0];
  let x = found1[1];
  let a1 = h * w;
  let b1 = h * g1;
  let v = w + butcher__to_second(b1);
  const found2 = layer_march___growth(law, par, rest, u + butcher__to_second(a1), v, x);
  g2 = found2[0];
  x = found2[1];
  let a2 = h * v;
  let b2 = h * g2;
  v = w + butcher__to_third(b2);
  const found3 = layer_march___growth(law, par, rest, u + butcher__to_third(a2), v, x);
  g3 = found3[0];
  x = found3[1];
  let a3 = h * v;
  let b3 = h * g3;
  v = w + butcher__to_fourth(b1, b2, b3);
  const found4 = layer_march___growth(law, par, rest, u + butcher__to_fourth(a1, a2, a3), v, x);
  g4 = found4[0];
  x = found4[1];
  let a4 = h * v;
  let b4 = h * g4;
  v = w + butcher__to_fifth(b1, b2, b3, b4);
  const found5 = layer_march___growth(law, par, rest, u + butcher__to_fifth(a1, a2, a3, a4), v, x);
  g5 = found5[0];
  x = found5[1];
  let a5 = h * v;
  let b5 = h * g5;
  v = w + butcher__to_sixth(b2, b3, b4, b5);
  const found6 = layer_march___growth(law, par, rest, u + butcher__to_sixth(a2, a3, a4, a5), v, x);
  g6 = found6[0];
  x = found6[1];
  let a6 = h * v;
  let b6 = h * g6;
  v = w + butcher__to_last(b1, b2, b3, b4, b6);
  const found7 = layer_march___growth(
    law,
    par,
    rest,
    u + butcher__to_last(a1, a2, a3, a4, a6),
    v,
    x,
  );
  g7 = found7[0];
  x = found7[1];
  let a7 = h * v;
  let b7 = h * g7;
  return [u + butcher__to_end(a1, a3, a4, a5, a6, a7), w + butcher__to_end(b1, b3, b4, b5, b6, b7)];
}

/** The part of a step after which the goal is met, and creep and creep ratio there. */
export function layer_march___landing(law, par, rest, start, h, to, goal) {
  let f;
  let low = 0.0;
  let high = 1.0;
  let f_low = layer_march__value_at(law, par, rest, to, start[0], start[1]) - goal;
  const found1 = layer_march__layer_step(law, par, rest, start[0], start[1], h);
  let u = found1[0];
  let w = found1[1];
  let f_high = layer_march__value_at(law, par, rest, to, u, w) - goal;
  let size = max(Math.abs(goal), 1e-300);
  let part = 1.0;
  for (let each2 = 0, end2 = 60; each2 < end2; each2++) {
    if (f_high === f_low) {
      break;
    }
    part = (low * f_high - high * f_low) / (f_high - f_low);
    const found3 = layer_march__layer_step(law, par, rest, start[0], start[1], part * h);
    u = found3[0];
    w = found3[1];
    f = layer_march__value_at(law, par, rest, to, u, w) - goal;
    if (Math.abs(f) <= 1e-14 * size || high - low < 1e-15) {
      break;
    }
    if (f * f_high > 0.0) {
      [high, f_high, f_low] = [part, f, 0.5 * f_low];
    } else {
      [low, f_low, f_high] = [part, f, 0.5 * f_high];
    }
  }
  return [part, u, w];
}

/** March from the point of least creep until a goal is reached. */
export function layer_march__march_layer(
  law,
  par,
  rest,
  start,
  towards,
  to,
  goal,
  tolerance,
  path,
) {
  let error, factor, left, part, size_u, size_w, u1, u2, um, w1, w2, wm;
  let [u, w] = start;
  let s = 0.0;
  let h =
    0.02 *
    layer_march__lag_at(
      law,
      par,
      rest,
      max(Math.abs(u), to !== TO_RATIO ? Math.abs(goal) : Math.abs(u)),
    );
  let ahead = goal - layer_march__value_at(law, par, rest, to, u, w);
  if (law.kind === LIMIT) {
    tolerance *= KINK_TOLERANCE;
  }
  layer_march___note(path, s, u, w);
  for (let each1 = 0, end1 = MOST_STEPS; each1 < end1; each1++) {
    const found2 = layer_march__layer_step(law, par, rest, u, w, towards * h);
    u1 = found2[0];
    w1 = found2[1];
    const found3 = layer_march__layer_step(law, par, rest, u, w, 0.5 * towards * h);
    um = found3[0];
    wm = found3[1];
    const found4 = layer_march__layer_step(law, par, rest, um, wm, 0.5 * towards * h);
    u2 = found4[0];
    w2 = found4[1];
    size_u = Math.abs(u2) + Math.abs(w2) * h;
    size_w = Math.abs(w2) + Math.abs(w2 - w);
    error = max(Math.abs(u2 - u1) / max(size_u, 1e-300), Math.abs(w2 - w1) / max(size_w, 1e-300));
    if (!(error <= 1.0)) {
      error = 1.0;
    }
    factor = 0.9 * (tolerance / max(error, 1e-16)) ** (1.0 / 7.0);
    if (error > tolerance && h > 1e-12 * par.length) {
      h *= max(min(factor, 0.7), 0.1);
      continue;
    }
    left = goal - layer_march__value_at(law, par, rest, to, u2, w2);
    if (left * ahead <= 0.0) {
      const found5 = layer_march___landing(law, par, rest, [u, w], towards * h, to, goal);
      part = found5[0];
      u2 = found5[1];
      w2 = found5[2];
      s += part * h;
      layer_march___note(path, s, u2, w2);
      return new Arrival(true, s, u2, w2);
    }
    [s, u, w] = [s + h, u2, w2];
    layer_march___note(path, s, u, w);
    if (s > 4.0 * par.length) {
      break;
    }
    h *= min(max(factor, 0.3), 4.0);
  }
  return new Arrival(false, s, u, w);
}

/** A layer from where the layers part to its nip, and the T_r at which a held tension is met. */
export function layers___layer(law, par, case_, rest, part, towards) {
  let ahead, goal, i, new_, noise, to;
  let c = par.compliance;
  let aim = case_.aim;
  let held = towards < 0.0 ? par.entry_tension : case_.exit_tension;
  let free = towards > 0.0 && held !== held;
  let miss = 0.0;
  let rest_last = 0.0;
  let miss_last = 0.0;
  let least = part[1] / c + 1e-6 * par.entry_tension;
  let tried = Infinity;
  let there = new Arrival(false, 0.0, part[0], part[1]);
  for (let each1 = 0, end1 = 40; each1 < end1; each1++) {
    i = each1;
    to = TO_CREEP;
    goal = par.kick;
    if (towards > 0.0) {
      to = aim.of;
      goal = par.side * aim.value;
      if (to === TENSION) {
        goal = c * (rest - par.entry_tension * Math.exp(-goal));
      }
      ahead = goal - layer_march__value_at(law, par, rest, to, part[0], part[1]);
      if (ahead * (part[0] > 0.0 || part[1] > 0.0 ? 1.0 : -1.0) <= 0.0) {
        return [false, false, rest, there];
      }
    }
    there = layer_march__march_layer(
      law,
      par,
      rest,
      part,
      towards,
      to,
      goal,
      case_.tolerance,
      zeros(0),
    );
    if (free || !there.arrived) {
      return [true, there.arrived, rest, there];
    }
    miss = rest - there.ratio / c - held;
    noise = i > 2 && Math.abs(miss) <= NOISE * case_.close;
    if (Math.abs(miss) <= case_.close || (noise && Math.abs(miss) > 0.1 * Math.abs(miss_last))) {
      break;
    }
    new_ = rest - miss;
    if (i > 0 && miss !== miss_last) {
      new_ = rest - (miss * (rest - rest_last)) / (miss - miss_last);
    }
    if (new_ <= least) {
      if (rest <= least) {
        return [true, false, rest, there];
      }
      new_ = tried === Infinity ? least : 0.5 * (rest + tried);
      tried = least;
    }
    [rest_last, miss_last, rest] = [rest, miss, new_];
  }
  return [true, Math.abs(miss) <= NOISE * case_.close, rest, there];
}

/** Both layers at one lambda, `z`; `rest` is a first guess of T_r. */
export function layers___layers_of(law, par, case_, z, rest) {
  let begun, both, met, near, out, there, way;
  const found1 = layers___parting(par, case_, z);
  let creep = found1[0];
  let ratio = found1[1];
  let free = found1[2];
  let held_exit = case_.exit_tension === case_.exit_tension;
  let length = 0.0;
  let entry = par.entry_tension;
  if (!held_exit) {
    if (free) {
      rest = entry + ratio / par.compliance;
    } else {
      if (case_.crossing) {
        way = par.kick > 0.0 ? 1.0 : -1.0;
        rest += way * min(way * (ratio / par.compliance - (rest - entry)), 0.0);
      }
      const found2 = layers___layer(law, par, case_, rest, [creep, ratio], -1.0);
      met = found2[1];
      rest = found2[2];
      there = found2[3];
      if (!met) {
        return new Layers(false, z, entry, rest, creep, ratio, there.length, Infinity, 0.0, 0.0);
      }
      length = there.length;
    }
  }
  const found3 = layers___layer(law, par, case_, rest, [creep, ratio], 1.0);
  begun = found3[0];
  met = found3[1];
  rest = found3[2];
  out = found3[3];
  if (!begun) {
    near = z === 0.0;
    both = near ? length : 0.0;
    return new Layers(near, z, entry, rest, creep, ratio, both, both, creep, ratio);
  }
  met = met && out.ratio < par.compliance * rest;
  if (held_exit) {
    entry = rest - ratio / par.compliance;
    if (met && !free) {
      there = layer_march__march_layer(
        law,
        par,
        rest,
        [creep, ratio],
        -1.0,
        TO_CREEP,
        par.kick,
        case_.tolerance,
        zeros(0),
      );
      met = there.arrived;
      length = there.length;
      entry = rest - there.ratio / par.compliance;
    }
    met = met && entry > 0.0;
  }
  both = met ? length + out.length : Infinity;
  return new Layers(met, z, entry, rest, creep, ratio, length, both, out.creep, out.ratio);
}

/** Layers that just fill the arc, by secants from those of nearly the same arc. */
export function layers___nearby(law, par, case_, before) {
  let best, f, i;
  case_ = layers___crossed(case_, par.kick !== 0.0 && before.creep === 0.0);
  let z = before.z;
  let rest = before.rest_tension;
  let z_last = 0.0;
  let f_last = 0.0;
  let slope = -case_.floors[0] / (case_.floors[1] * par.length);
  for (let each1 = 0, end1 = NEARBY; each1 < end1; each1++) {
    i = each1;
    best = layers___layers_of(law, par, case_, z, rest);
    f = best.length / par.length - 1.0;
    if (!best.solved || Math.abs(f) < FILLED * case_.tolerance) {
      return best;
    }
    if (i > 0 && z !== z_last) {
      slope = (f - f_last) / (z - z_last);
    }
    if (slope >= 0.0) {
      break;
    }
    z_last = z;
    f_last = f;
    rest = best.rest_tension;
    z -= f / slope;
    if (z <= 0.0) {
      break;
    }
  }
  return NO_LAYERS;
}

/** The layers at the floor, and the case, in which creep may pass through zero. */
export function layers___at_rest(law, par, case_) {
  let last;
  let aim = case_.aim;
  let first = layers___layers_of(law, par, case_, 0.0, par.entry_tension);
  let crossing = par.kick * par.side < 0.0;
  if (aim.of === TENSION) {
    last = par.entry_tension * Math.exp(-par.side * aim.value);
    crossing = par.kick * (last - first.rest_tension) > 0.0;
  }
  if (crossing) {
    case_ = layers___crossed(case_, true);
    first = layers___layers_of(law, par, case_, 0.0, first.rest_tension);
  }
  return [case_, first];
}

/** Layers that just fill the arc, from those at the floor that are longer. */
export function layers___less_rest(law, par, case_, first) {
  let f, fall, i, z;
  let rest = first.rest_tension;
  let tolerance = case_.tolerance;
  let low = 0.0;
  let high = 0.0;
  let f_low = first.length / par.length - 1.0;
  let f_high = Infinity;
  let best = first;
  let top = Math.log(LARGEST_RATIO / case_.floors[1]);
  let reach = 2.0;
  for (let each1 = 0, end1 = 60; each1 < end1; each1++) {
    if (high >= top) {
      return [BREAKAWAY, best];
    }
    high = min(high + reach, top);
    best = layers___layers_of(law, par, case_, high, rest);
    f_high = best.length / par.length - 1.0;
    if (f_high <= 0.0) {
      break;
    }
    fall = (f_low - f_high) / (high - low);
    reach = 0.0 < fall && fall < Infinity ? min(max((1.1 * f_high) / fall, 0.5), 12.0) : 2.0;
    low = high;
    f_low = f_high;
    rest = best.rest_tension;
  }
  let side = 0;
  let rise = Infinity;
  for (let each2 = 0, end2 = 100; each2 < end2; each2++) {
    i = each2;
    if (f_low === Infinity && i >= HALVINGS && f_high + MARGIN * rise * (high - low) < 0.0) {
      break;
    }
    z = 0.5 * (low + high);
    if (f_low < Infinity && f_low !== f_high && modulo(i, 8) < 7) {
      z = (low * f_high - high * f_low) / (f_high - f_low);
    }
    if (!(low < z && z < high)) {
      z = 0.5 * (low + high);
    }
    best = layers___layers_of(law, par, case_, z, best.rest_tension);
    f = best.length / par.length - 1.0;
    if (Math.abs(f) < FILLED * tolerance || high - low < 1e-13 * high) {
      break;
    }
    if (f > 0.0) {
      f_high *= side > 0 ? 0.5 : 1.0;
      low = z;
      f_low = f;
      side = 1;
    } else {
      f_low *= side < 0 ? 0.5 : 1.0;
      rise = max(f - f_high, 0.0) / (high - z);
      high = z;
      f_high = f;
      side = -1;
    }
  }
  let good = best.solved && Math.abs(best.length / par.length - 1.0) < 10.0 * tolerance;
  return [good ? SOLVED : UNSOLVED, best];
}

/** Layers that meet a held tension and an aim at the exit, whatever holds the belt at rest. */
export function layers__solve_layers(law, par, aim, exit_tension, tolerance, before) {
  let first, layers, near, other;
  let case_ = layers___case(law, par, aim, exit_tension, tolerance);
  if (before.solved && before.z > 0.0) {
    near = layers___nearby(law, par, case_, before);
    if (near.solved) {
      return [SOLVED, near];
    }
  }
  const found1 = layers___at_rest(law, par, case_);
  case_ = found1[0];
  first = found1[1];
  if (first.solved && first.length <= par.length) {
    return [SOLVED, first];
  }
  const found2 = layers___less_rest(law, par, case_, first);
  let outcome = found2[0];
  let found = found2[1];
  if (outcome !== SOLVED && !first.solved && par.kick !== 0.0) {
    case_ = layers___crossed(case_, !case_.crossing);
    first = layers___layers_of(law, par, case_, 0.0, par.entry_tension);
    const found3 = layers___less_rest(law, par, case_, first);
    other = found3[0];
    layers = found3[1];
    if (other === SOLVED) {
      return [other, layers];
    }
  }
  return [outcome, found];
}

/** Exit quantities of solved layers; friction's work is what the exact loss leaves to it. */
export function layers__shot_of_layers(law, par, found) {
  let c = par.compliance;
  let tension = found.rest_tension - found.exit_ratio / c;
  const found1 = layer_march__friction_of_creep(law, par, tension, found.exit_creep);
  let tau = found1[0];
  let x = found1[1];
  const found2 = layer_march__friction_of_creep(law, par, par.entry_tension, par.kick);
  let entry_tau = found2[0];
  let g = c * (found.rest_tension - par.entry_tension);
  let work = (0.5 * (found.exit_ratio ** 2 - g * g)) / (c * par.width);
  work -= 0.5 * par.shear * (tau * tau - entry_tau * entry_tau);
  return new Shot(Math.log(tension / par.entry_tension), x, found.exit_creep, tau, work, g, 0.0);
}

/** `solve_tension` by layers, where no effort at the entry tells what happens at the exit. */
export function answer__by_layers(law, par, goal) {
  const found1 = layers__solve_layers(
    law,
    par,
    new Aim(TENSION, goal),
    NaN,
    STEP_TOLERANCE,
    NO_LAYERS,
  );
  let outcome = found1[0];
  let layers = found1[1];
  return new Found(outcome, NaN, layers__shot_of_layers(law, par, layers), layers, 0);
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

export function stick___record_stuck(par, out, count, s, zone, end_creep) {
  const found1 = stick__zone_point(par, s, zone, end_creep);
  let tension = found1[0];
  let creep = found1[1];
  let compliance = par.shear + par.onset;
  let tau = compliance > 0.0 ? creep / compliance : 0.0;
  let entry_tau = compliance > 0.0 ? par.kick / compliance : 0.0;
  let i = RECORD * count;
  [out[i], out[i + 1], out[i + 2]] = [s, Math.log(tension / par.entry_tension), par.onset * tau];
  [out[i + 3], out[i + 4]] = [creep, tau];
  out[i + 5] = 0.5 * par.onset * (tau * tau - entry_tau * entry_tau);
}

/** Wrap pressure [Pa] at ln(T/T1); a trial far off the solution may ask for any. */
export function step__pressure_at(par, q) {
  return par.entry_pressure * Math.exp(min(max(q, -LARGEST_LOG), LARGEST_LOG));
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

/** Write one point of a profile: s, q, slip, creep, shear stress, friction work. */
export function march__record(law, par, out, count, s, state) {
  const found1 = march__stress_and_creep(law, par, state);
  let tau = found1[0];
  let creep = found1[1];
  let i = RECORD * count;
  [out[i], out[i + 1], out[i + 2]] = [s, state.log_tension, state.slip];
  [out[i + 3], out[i + 4], out[i + 5]] = [creep, tau, state.work];
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

/** Carry a sliding state from xi to xi_end on the mesh s = origin + span xi^4. */
export function march__advance(law, par, g, state, origin, span, xi, xi_end, cut, out, count) {
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
    there,
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
      if (out.length > 0 && xi < xi_end && f > 0.0) {
        there = new State(q, x, work, segment, branch, sign);
        march__record(law, par, out, count, origin + span * xi ** MESH_POWER, there);
        count += 1;
      }
      continue;
    }
    [q, x, work] = [q1, x1, work + w1];
    xi = h === xi_end - xi ? xi_end : xi + h;
  }
  return [new State(q, x, work, segment, branch, sign), count];
}

/** Carry a state from mesh node `first` to the exit, recording `points` parts of the arc. */
export function march__carry_to_exit(law, par, g, state, origin, first, steps, points, out, count) {
  let between, i, j, t, xi, xi_end;
  let length = par.length;
  let span = length - origin;
  let h = 1.0 / steps;
  let cut = steps >= FEWEST_CUT_STEPS || law.kind === LIMIT || law.kind === TABLE;
  if (out.length > 0 && first > 0) {
    march__record(law, par, out, count, origin + span * (first * h) ** MESH_POWER, state);
    count += 1;
  }
  for (let each1 = first, end1 = steps; each1 < end1; each1++) {
    i = each1;
    xi = i * h;
    xi_end = (i + 1) * h;
    if (points > 0) {
      j = Math.trunc(((origin + span * xi ** MESH_POWER) / length) * points * (1.0 + 1e-12)) + 1;
      while (j < points) {
        t = (max((j * length) / points - origin, 0.0) / span) ** (1.0 / MESH_POWER);
        if (t >= xi_end * (1.0 - 1e-12)) {
          break;
        }
        if (t > xi) {
          const found2 = march__advance(law, par, g, state, origin, span, xi, t, cut, zeros(0), 0);
          between = found2[0];
          march__record(law, par, out, count, (j * length) / points, between);
          count += 1;
        }
        j += 1;
      }
    }
    const found3 = march__advance(law, par, g, state, origin, span, xi, xi_end, cut, out, count);
    state = found3[0];
    count = found3[1];
  }
  if (out.length > 0) {
    march__record(law, par, out, count, length, state);
    count += 1;
  }
  return [state, count];
}

/** A stuck zone of length `zone`, then sliding to the exit with entry creep ratio g. */
export function stick__stick_slip(law, par, zone, end_creep, g, steps, points, out) {
  let j, s;
  let length = par.length;
  let compliance = par.shear + par.onset;
  let count = 0;
  if (out.length > 0) {
    for (let each1 = 0, end1 = points + 1; each1 < end1; each1++) {
      j = each1;
      s = (j * length) / points;
      if (s > zone * (1.0 - 1e-12) && s > 0.0) {
        break;
      }
      stick___record_stuck(par, out, count, s, zone, end_creep);
      count += 1;
    }
    if (zone > 0.0) {
      stick___record_stuck(par, out, count, zone, zone, end_creep);
      count += 1;
    }
  }
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
  let state = new State(q, x, work, segment, branch, par.side);
  if (zone >= length) {
    return [state, count];
  }
  if (out.length > 0 && compliance === 0.0) {
    march__record(law, par, out, count, zone, state);
    count += 1;
  }
  return march__carry_to_exit(law, par, g, state, zone, 0, steps, points, out, count);
}

/** Exit quantities and profile of an arc that sticks throughout, with its creep at the exit. */
export function answer__stuck_shot(law, par, exit_tension, creep, points, out) {
  let length = par.length;
  let compliance = par.shear + par.onset;
  let g = stick__zone_creep_ratio(par, length, creep);
  const found1 = stick__stick_slip(law, par, length, creep, g, 0, points, out);
  let state = found1[0];
  let count = found1[1];
  let tau = compliance > 0.0 ? creep / compliance : 0.0;
  let q = Math.log(exit_tension / par.entry_tension);
  return [new Shot(q, state.slip, creep, tau, state.work, g, length), count];
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

/** Whether no march from the entry tells what happens at the exit, and layers do. */
export function effort__is_far(law, par) {
  return !effort__jumps(law) && effort__lags(law, par) > FAR;
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

/** Slip at which a law without a jump gives about this friction, its peak if it cannot [m]. */
export function effort___slip_for(law, pressure, friction) {
  let i, m, mu, mu_pk, r, slip_pk;
  let segment = compact__segment_of(law, pressure);
  if (law.kind === KNOTS || law.kind === PIECES) {
    const found1 = compact__peak(law, segment, pressure);
    slip_pk = found1[0];
    mu_pk = found1[1];
    m = friction / mu_pk;
    if (m >= 0.95) {
      return slip_pk;
    }
    if (m < 1e-6) {
      return 0.05 * m * slip_pk;
    }
    r = 0.3 * m;
    for (let each2 = 0, end2 = 4; each2 < end2; each2++) {
      r = min(max(r + (m - r * (1.0 - Math.log(r))) / -Math.log(r), 0.3 * r), 0.9);
    }
    return r * slip_pk;
  }
  if (law.kind === LIMIT) {
    return (
      law.coefficients[3] * pressure * min(friction, compact__plateau_at(law, segment, pressure))
    );
  }
  for (let each3 = 1, end3 = law.slips.length; each3 < end3; each3++) {
    i = each3;
    const found4 = compact__friction_at(law, segment, i, law.slips[i], pressure);
    mu = found4[0];
    if (mu >= friction) {
      return law.slips[i];
    }
  }
  return law.slips[law.slips.length - 1];
}

/** Effort of an entry creep ratio, laws without a jump; the inverse of :func:`ratio_of`. */
export function effort__effort_of(par, g) {
  let r = (par.side * g) / SMALL_RATIO;
  if (par.kick !== 0.0) {
    return Math.asinh(r);
  }
  return r > 0.0 ? Math.log(r) : -60.0;
}

/** Effort from the creep that a rigid belt of uniform pressure would need. */
export function effort__first_guess(law, par, aim) {
  let creep, mean, pressure, pull, share, slip, spare, tau, way;
  if (effort__jumps(law)) {
    const found1 = stick__onset_stress(law, par.entry_pressure);
    tau = found1[0];
    share = min((aim.value * par.radius * par.entry_pressure) / (tau * par.length), 0.98);
    if (aim.of !== TENSION) {
      spare = max(aim.value - (aim.of === CREEP ? par.shear * tau : 0.0), 0.05 * aim.value);
      way = Math.sqrt((2.0 * spare) / (par.compliance * par.width * tau));
      share = min(way / par.length, 0.9);
    }
    return par.shear + par.onset === 0.0 ? share : share / (1.0 - share);
  }
  let length = par.length;
  if (aim.of === TENSION) {
    pressure = par.entry_pressure * Math.exp(-0.5 * par.side * aim.value);
    mean = (aim.value * par.radius) / length;
    slip = effort___slip_for(law, pressure, 1.6 * mean);
    creep = slip + par.shear * 1.4 * mean * pressure;
    pull = par.entry_tension * Math.abs(1.0 - Math.exp(-par.side * aim.value));
  } else {
    creep = aim.value;
    pull = 0.5 * par.entry_tension;
  }
  let shrinkage = 0.35 * par.compliance * pull * length;
  spare = creep - shrinkage - par.side * par.kick;
  spare = max(spare, par.kick === 0.0 ? 0.05 * creep : -0.25 * Math.abs(par.kick));
  return effort__effort_of(par, (par.side * spare) / length);
}

/** Whether the march may be tried: integral-log law, no kick against the direction of slip. */
export function tension_table__applies(law, par) {
  return (law.kind === KNOTS || law.kind === PIECES) && par.kick * par.side >= 0.0;
}

/** Mesh steps for an arc: more where the belt hands over its tension in a short exit part. */
export function effort__mesh_steps(law, par, steps) {
  return Math.trunc(steps * max(1.0, min(effort__lags(law, par), MOST_LAGS) / LAGS_PER_MESH));
}

/** Numbers that a table needs, see `open_table`; with room for 60 pieces of the law. */
export function tension_table__table_size(end, steps) {
  return FIRST + STEP * (Math.trunc(0.75 * steps + (end * steps) / 1.44) + 64);
}

/** Prepare a table; one that is of the same drive, end and fineness is kept. */
export function tension_table__open_table(law, par, end, steps, table) {
  if (table[3] === end && table[4] === 0.75 * steps && table[6] === par.entry_pressure) {
    return;
  }
  let segment = compact__segment_of(law, par.entry_pressure);
  if (par.side > 0.0 && segment >= 0 && par.entry_pressure <= law.edges[segment] * (1.0 + 1e-14)) {
    segment -= 1;
  }
  [table[0], table[1], table[2], table[3]] = [0.0, 0.0, segment, end];
  [table[4], table[5], table[6]] = [0.75 * steps, 1.44 / steps, par.entry_pressure];
}

/** Effort at which the entry creep ratio is 1. */
export function effort__largest_effort(law, par) {
  if (!effort__jumps(law)) {
    return effort__effort_of(par, par.side * LARGEST_RATIO);
  }
  let compliance = par.shear + par.onset;
  if (compliance === 0.0) {
    return 1.0 + (LARGEST_RATIO * par.length) / CREEP_SCALE;
  }
  let u = compliance * stick__onset_stress(law, par.entry_pressure)[0];
  return max(par.length / u, 10.0);
}

/** Effort below which nothing is sought: creep well beyond the kick towards the tight side. */
export function effort__lowest_effort(law, par) {
  if (effort__jumps(law)) {
    return -3.0;
  }
  if (par.kick !== 0.0) {
    return effort__effort_of(par, (-par.side * 1000.0 * Math.abs(par.kick)) / par.length);
  }
  return -60.0;
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
export function march__to_zero_slip(law, par, g, steps, out, count) {
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
        return [0, 0.0, 0.0, 0.0, count];
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
      return [2, 0.0, 0.0, 0.0, count];
    }
    [q, x, s, work] = [q + sum_q, x + sum_x, s + sum_s, work + sum_w];
    if (x <= 0.0) {
      return [0, 0.0, 0.0, 0.0, count];
    }
    if (out.length > 0) {
      march__record(law, par, out, count, s, new State(q, sign * x, work, segment, branch, sign));
      count += 1;
    }
  }
  rate = sign * (g + par.entry_tension * -Math.expm1(q) * par.compliance);
  if (rate >= 0.0) {
    return [0, 0.0, 0.0, 0.0, count];
  }
  let ds = (kick * h ** 4) / -rate;
  if (s + ds >= length) {
    return [2, 0.0, 0.0, 0.0, count];
  }
  let dq = step__rates(law, par, g, segment, branch, sign, q, sign * x)[0];
  return [1, s + ds, q + 0.5 * ds * dq, work, count];
}

/** State a short way s past a point of no slip, where creep grows at `rate` (no kick). */
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
  return new State(q - sign * dq, sign * x, 0.5 * mu * p * x, segment, branch, sign);
}

/** March the whole arc with a law that starts without a jump. */
export function march__sweep(law, par, g, steps, points, out) {
  let cell, gone, i, j, n, p, q, rate, s, segment, sign, state, status, work, x;
  let kick = par.kick;
  let length = par.length;
  let count = 0;
  if (kick !== 0.0) {
    sign = kick > 0.0 ? 1.0 : -1.0;
    x = creep_step__slip_at_entry(law, par, Math.abs(kick), 0.0);
    p = par.entry_pressure;
    segment = compact__segment_of(law, p);
    state = new State(0.0, sign * x, 0.0, segment, compact__branch_of(law, segment, x, p), sign);
    if (out.length > 0) {
      march__record(law, par, out, 0, 0.0, state);
      count = 1;
    }
    if (sign * g < 0.0 && (law.kind === KNOTS || law.kind === PIECES)) {
      const found1 = march__to_zero_slip(law, par, g, steps, out, count);
      status = found1[0];
      s = found1[1];
      q = found1[2];
      work = found1[3];
      n = found1[4];
      if (status === 1) {
        rate = g + par.entry_tension * -Math.expm1(q) * par.compliance;
        cell = (length - s) / steps ** MESH_POWER;
        gone = march___leave(law, par, rate, q, cell);
        state = new State(
          gone.log_tension,
          gone.slip,
          gone.work + work,
          gone.segment,
          gone.branch,
          gone.sign,
        );
        return march__carry_to_exit(law, par, g, state, s, 1, steps, points, out, n);
      }
    }
    return march__carry_to_exit(law, par, g, state, 0.0, 0, steps, points, out, count);
  }
  if (out.length > 0) {
    for (let each2 = 0, end2 = RECORD; each2 < end2; each2++) {
      i = each2;
      out[i] = 0.0;
    }
    count = 1;
  }
  if (g === 0.0) {
    p = par.entry_pressure;
    state = new State(0.0, 0.0, 0.0, compact__segment_of(law, p), 0, 1.0);
    if (out.length > 0) {
      for (let each3 = 1, end3 = points + 1; each3 < end3; each3++) {
        j = each3;
        out[RECORD * count] = (j * length) / points;
        for (let each4 = 1, end4 = RECORD; each4 < end4; each4++) {
          i = each4;
          out[RECORD * count + i] = 0.0;
        }
        count += 1;
      }
    }
    return [state, count];
  }
  if (law.kind === LIMIT || law.kind === TABLE) {
    sign = g > 0.0 ? 1.0 : -1.0;
    state = new State(0.0, 0.0, 0.0, compact__segment_of(law, par.entry_pressure), 0, sign);
    return march__carry_to_exit(law, par, g, state, 0.0, 0, steps, points, out, count);
  }
  state = march___leave(law, par, g, 0.0, length / steps ** MESH_POWER);
  return march__carry_to_exit(law, par, g, state, 0.0, 1, steps, points, out, count);
}

/** Exit quantities of a state at the exit. */
export function effort__shot_of(law, par, state, g, zone) {
  const found1 = march__stress_and_creep(law, par, state);
  let tau = found1[0];
  let creep = found1[1];
  return new Shot(state.log_tension, state.slip, creep, tau, state.work, g, zone);
}

/** March one arc at effort z; `points` and `out` as :func:`wraparc.arc.kernel.march.sweep`. */
export function effort__shoot_from(law, par, z, steps, points, out) {
  let compliance, count, creep, end, g, length, state, tau;
  let zone = 0.0;
  steps = effort__mesh_steps(law, par, steps);
  if (effort__jumps(law)) {
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
    const found1 = stick__stick_slip(law, par, zone, end, g, steps, points, out);
    state = found1[0];
    count = found1[1];
    if (zone >= length) {
      creep = stick__zone_point(par, length, length, end)[1];
      tau = compliance > 0.0 ? creep / compliance : 0.0;
      return [new Shot(state.log_tension, state.slip, creep, tau, state.work, g, zone), count];
    }
  } else {
    g = effort__ratio_of(par, z);
    const found2 = march__sweep(law, par, g, steps, points, out);
    state = found2[0];
    count = found2[1];
  }
  return [effort__shot_of(law, par, state, g, zone), count];
}

/** Value of a shot that a target is compared with; it grows with effort. */
export function effort__value_of(par, shot, of) {
  if (of === TENSION) {
    return -par.side * shot.log_tension;
  }
  if (of === CREEP) {
    return par.side * shot.creep;
  }
  return par.side * shot.slip;
}

/** Weight dQ of a step h at e: h, times dQ/d eta in the graded part. */
export function tension_table___weight(graded, top, e, h) {
  if (!graded) {
    return h;
  }
  let e3 = e * e * e;
  return GRADED_POWER * top * e3 * e3 * e3 * h;
}

/** Numbers of the law at Q in one of its segments, with dQ (times a Jacobian) as weight. */
export function tension_table___node(law, par, segment, q, weight, table, o) {
  let c, k, m1, m2, m3, mu_pk, mu_pk_p, slip_pk, slip_pk_p, softens, t, x1, x2, x3;
  let shear = par.shear;
  let sigma = par.side;
  let fall = Math.exp(-sigma * q);
  let p = par.entry_pressure * fall;
  let last = law.edges.length - 1;
  if (law.kind === KNOTS && 0 <= segment && segment < last) {
    c = law.coefficients;
    k = segment * KNOT_STRIDE;
    t = p - law.edges[segment];
    x1 = c[k + 1];
    x2 = c[k + 2];
    x3 = c[k + 3];
    m1 = c[k + 5];
    m2 = c[k + 6];
    m3 = c[k + 7];
    slip_pk = c[k] + t * (x1 + t * (x2 + t * x3));
    mu_pk = c[k + 4] + t * (m1 + t * (m2 + t * m3));
    slip_pk_p = x1 + t * (2.0 * x2 + 3.0 * t * x3);
    mu_pk_p = m1 + t * (2.0 * m2 + 3.0 * t * m3);
    softens = c[k + 8] !== 0.0 || c[k + 9] !== 0.0 || c[k + 10] !== 0.0 || c[k + 11] !== 0.0;
  } else {
    const found1 = compact__peak(law, segment, p);
    slip_pk = found1[0];
    mu_pk = found1[1];
    slip_pk_p = found1[2];
    mu_pk_p = found1[3];
    softens = true;
  }
  let held = 1.0;
  if (segment >= last && last >= 0) {
    held = law.edges[last] / p;
    [mu_pk, mu_pk_p, slip_pk_p] = [mu_pk * held, (-mu_pk * held) / p, 0.0];
  }
  let bend = weight * sigma * shear * p;
  let r_mu = (weight * par.radius) / mu_pk;
  table[o] = 1.0 / slip_pk;
  table[o + 1] = r_mu;
  table[o + 2] = r_mu * par.entry_tension * Math.abs(1.0 - fall) * par.compliance;
  table[o + 3] = bend * (mu_pk + p * mu_pk_p);
  table[o + 4] = (bend * p * mu_pk * slip_pk_p) / slip_pk;
  table[o + 5] = (shear * p * mu_pk) / slip_pk;
  table[o + 6] = mu_pk * p;
  table[o + 7] = table[o + 8] = table[o + 10] = 0.0;
  table[o + 9] = 1.0;
  if (!softens) {
    return;
  }
  const found2 = compact__tail(law, segment, p);
  let slope = found2[0];
  let residual = found2[1];
  let slope_p = found2[2];
  let residual_p = found2[3];
  let mu_0 = mu_pk / held;
  let mu_0_p = mu_pk_p;
  if (held !== 1.0) {
    mu_0_p = slope_p = residual_p = 0.0;
  }
  if (slope < 0.0 && residual < mu_0) {
    table[o + 7] = (slope * slip_pk) / mu_0;
    table[o + 8] = (bend * p * mu_pk * slip_pk * (slope_p - (slope * mu_0_p) / mu_0)) / mu_0;
    table[o + 9] = residual / mu_0;
    table[o + 10] = (bend * p * mu_pk * (residual_p - (residual * mu_0_p) / mu_0)) / mu_0;
  }
}

/** Nodes of one step, from eta (graded) or Q = start over h. */
export function tension_table__fill(law, par, segment, graded, top, start, h, table, o, known) {
  let e, i, k, part, q, scale, scaled;
  let first = 0;
  if (known >= 0) {
    scale = tension_table___weight(graded, top, start, h) / table[8];
    for (let each1 = 0, end1 = NODE; each1 < end1; each1++) {
      k = each1;
      scaled = k === 1 || k === 2 || k === 3 || k === 4 || k === 8 || k === 10;
      table[o + k] = scaled ? table[known + k] * scale : table[known + k];
    }
    first = 1;
  }
  for (let each2 = first, end2 = 5; each2 < end2; each2++) {
    i = each2;
    part = i === 0 ? 0.0 : i === 4 ? 1.0 : (1.0 + i) / 6.0;
    e = start + h * part;
    q = graded ? top * e ** GRADED_POWER : e;
    tension_table___node(
      law,
      par,
      segment,
      q,
      tension_table___weight(graded, top, e, h),
      table,
      o + NODE * i,
    );
  }
}

/** Add one step to a table; False at its end. */
export function tension_table__extend(law, par, table) {
  let eta, h, most, part, power, to;
  let n = Math.trunc(table[0]);
  let q = table[1];
  let segment = Math.trunc(table[2]);
  let end = table[3];
  let o = FIRST + n * STEP;
  if (q >= end * (1.0 - 1e-14) || o + STEP > table.length) {
    return false;
  }
  let sigma = par.side;
  let top = min(GRADED_END, end);
  let wall = end;
  if (sigma > 0.0 && segment >= 0) {
    wall = min(end, Math.log(par.entry_pressure / law.edges[segment]));
  } else if (sigma < 0.0 && segment < law.edges.length - 1) {
    wall = min(end, Math.log(law.edges[segment + 1] / par.entry_pressure));
  }
  table[o + 1] = table[2];
  let known = n > 0 && table[o - STEP + 1] === table[2] ? o - NODE : -1;
  if (q < top * (1.0 - 1e-12)) {
    power = 1.0 / GRADED_POWER;
    eta = (q / top) ** power;
    part = 1.0 / table[4];
    most = (min(wall, top) / top) ** power;
    to = most - eta < 1.3 * part ? most : eta + part;
    tension_table__fill(law, par, segment, true, top, eta, to - eta, table, o + 2, known);
    table[8] = tension_table___weight(true, top, to, to - eta);
    q = to === most ? min(wall, top) : top * to ** GRADED_POWER;
  } else {
    h = wall - q > 1.3 * table[5] ? table[5] : wall - q;
    tension_table__fill(law, par, segment, false, top, q, h, table, o + 2, known);
    table[8] = h;
    q = q + h >= wall * (1.0 - 1e-13) ? wall : q + h;
  }
  if (q >= wall * (1.0 - 1e-13) && wall < end) {
    table[2] += sigma > 0.0 ? -1.0 : 1.0;
  }
  table[o] = table[1] = q;
  table[0] = n + 1;
  return true;
}

/** State at the first node: status, steps done, s [m], slip [m], friction work [J/m2]. */
export function tension_march__start_of(law, par, gamma, table) {
  let change, f, mu_pk, r, slip_pk, work;
  let kick = par.side * par.kick;
  if (gamma * par.length < -0.1 * kick) {
    return [LOST, 0, 0.0, 0.0, 0.0];
  }
  if (kick > 0.0) {
    return [SOLVED, 0, 0.0, creep_step__slip_at_entry(law, par, kick, 0.0), 0.0];
  }
  if (gamma <= 1e-12) {
    return [LOST, 0, 0.0, 0.0, 0.0];
  }
  let p = par.entry_pressure;
  const found1 = compact__peak(law, compact__segment_of(law, p), p);
  slip_pk = found1[0];
  mu_pk = found1[1];
  let last = law.edges.length - 1;
  if (last >= 0 && p > law.edges[last]) {
    mu_pk *= law.edges[last] / p;
  }
  let goal = Math.log(table[FIRST] * gamma * par.radius);
  let shear = par.shear * p * mu_pk * mu_pk;
  let y = -14.0;
  for (let each2 = 0, end2 = 60; each2 < end2; each2++) {
    r = Math.exp(y);
    f = r * (1.0 - y);
    work = mu_pk * slip_pk * r * r * (0.75 - 0.5 * y) + 0.5 * shear * f * f;
    change = (Math.log(work) - goal) * work;
    change /= mu_pk * slip_pk * r * r * (1.0 - y) - shear * f * r * y;
    y -= change;
    if (y > -1.0) {
      return [LOST, 0, 0.0, 0.0, 0.0];
    }
    if (Math.abs(change) < 1e-13) {
      break;
    }
  }
  r = Math.exp(y);
  let mu = mu_pk * r * (1.0 - y);
  let s = (r * slip_pk + par.shear * p * mu) / gamma;
  return [SOLVED, 1, s, r * slip_pk, mu_pk * p * slip_pk * r * r * (0.75 - 0.5 * y)];
}

/** Shear stress [Pa] and creep [m] towards the slack side of a state at Q with slip a. */
export function tension_march__exit_state(law, par, q, a) {
  let mu;
  let p = par.entry_pressure * Math.exp(-par.side * q);
  let segment = compact__segment_of(law, p);
  let branch = compact__branch_of(law, segment, a, p);
  const found1 = compact__friction_at(law, segment, branch, a, p);
  mu = found1[0];
  return [mu * p, a + par.shear * mu * p];
}

/** Write one point of a profile, see wraparc.arc.kernel.march.record. */
export function tension_march__record_point(law, par, q, s, a, work, out, count) {
  let side = par.side;
  const found1 = tension_march__exit_state(law, par, q, a);
  let tau = found1[0];
  let creep = found1[1];
  let i = RECORD * count;
  [out[i], out[i + 1], out[i + 2]] = [s, -side * q, side * a];
  [out[i + 3], out[i + 4], out[i + 5]] = [side * creep, side * tau, work];
}

/** Weight dQ times ds/dQ [m], da/dQ [m] and d(friction work)/dQ [J/m2] at a node. */
export function tension_march___rates(t, o, branch, gamma, a) {
  let da, f, lr, rl, w;
  let r = a * t[o];
  if (branch === RISE && (r < 1.0 || t[o + 7] < 0.0)) {
    if (r < SMALLEST) {
      r = SMALLEST;
    }
    lr = Math.log(r);
    rl = r * lr;
    f = r - rl;
    if (f === 0.0) {
      f = SMALLEST;
    }
    w = 1.0 / f;
    da = (gamma * t[o + 1] + t[o + 2]) * w + t[o + 3] * f + t[o + 4] * rl;
    da /= 1.0 - t[o + 5] * lr;
    return [t[o + 1] * w, da, t[o + 6] * f * da];
  }
  if (branch === RESIDUAL) {
    f = t[o + 9];
    da = (gamma * t[o + 1] + t[o + 2]) / f + t[o + 3] * f + t[o + 10];
    return [t[o + 1] / f, da, t[o + 6] * f * da];
  }
  let z = t[o + 7];
  f = 1.0 + z * (r - 1.0);
  da = (gamma * t[o + 1] + t[o + 2]) / f + t[o + 3] * f + t[o + 8] * (r - 1.0) - t[o + 4] * z;
  da /= 1.0 + t[o + 5] * z;
  return [t[o + 1] / f, da, t[o + 6] * f * da];
}

/** One sixth-order step (Butcher, as in arc.kernel.step) over five nodes: s, a, work. */
export function tension_march___step(t, o, branch, gamma, s, a, work) {
  let b2;
  let n1 = o + NODE;
  let n2 = o + 2 * NODE;
  let n3 = o + 3 * NODE;
  let n4 = o + 4 * NODE;
  const found1 = tension_march___rates(t, o, branch, gamma, a);
  let s1 = found1[0];
  let b1 = found1[1];
  let w1 = found1[2];
  const found2 = tension_march___rates(t, n1, branch, gamma, a + butcher__to_second(b1));
  b2 = found2[1];
  const found3 = tension_march___rates(t, n3, branch, gamma, a + b2 * (2.0 / 3.0));
  let s3 = found3[0];
  let b3 = found3[1];
  let w3 = found3[2];
  const found4 = tension_march___rates(t, n1, branch, gamma, a + butcher__to_fourth(b1, b2, b3));
  let s4 = found4[0];
  let b4 = found4[1];
  let w4 = found4[2];
  const found5 = tension_march___rates(t, n2, branch, gamma, a + butcher__to_fifth(b1, b2, b3, b4));
  let s5 = found5[0];
  let b5 = found5[1];
  let w5 = found5[2];
  const found6 = tension_march___rates(t, n2, branch, gamma, a + butcher__to_sixth(b2, b3, b4, b5));
  let s6 = found6[0];
  let b6 = found6[1];
  let w6 = found6[2];
  const found7 = tension_march___rates(
    t,
    n4,
    branch,
    gamma,
    a + butcher__to_last(b1, b2, b3, b4, b6),
  );
  let s7 = found7[0];
  let b7 = found7[1];
  let w7 = found7[2];
  return [
    s + butcher__to_end(s1, s3, s4, s5, s6, s7),
    a + butcher__to_end(b1, b3, b4, b5, b6, b7),
    work + butcher__to_end(w1, w3, w4, w5, w6, w7),
  ];
}

/** Branch of a state at a node, among the neighbours of the branch it comes from. */
export function tension_march___next_branch(t, o, branch, a) {
  let z = t[o + 7];
  let r = a * t[o];
  if (branch === RISE) {
    return r > 1.0 ? LINE : RISE;
  }
  if (z === 0.0) {
    return r >= 1.0 ? branch : RISE;
  }
  let over = 1.0 + z * (r - 1.0) >= t[o + 9];
  if (branch === RESIDUAL) {
    return over && t[o + 9] < 1.0 ? LINE : RESIDUAL;
  }
  if (r < 1.0) {
    return RISE;
  }
  return over ? LINE : RESIDUAL;
}

/** How far a state at a node is beyond the boundary to another branch; negative before. */
export function tension_march___gap(t, o, branch, to, a) {
  let r = a * t[o];
  if (branch === RISE) {
    return r - 1.0;
  }
  if (to === RISE) {
    return 1.0 - r;
  }
  let below = t[o + 9] - 1.0 - t[o + 7] * (r - 1.0);
  return to === RESIDUAL ? below : -below;
}

/** The part of a step after which a gap closes, and s, a, work there. */
export function tension_march___cut(
  law,
  par,
  gamma,
  branch,
  to,
  segment,
  q,
  q_end,
  s,
  a,
  work,
  gap_0,
  gap_1,
  table,
) {
  let ds, gap;
  let low = 0.0;
  let high = 1.0;
  let f_low = gap_0;
  let f_high = gap_1;
  let part = 0.0;
  let s1 = s;
  let a1 = a;
  let work1 = work;
  if (gap_0 >= 0.0) {
    return [part, s1, a1, work1];
  }
  part = gap_0 / (gap_0 - gap_1);
  for (let each1 = 0, end1 = 60; each1 < end1; each1++) {
    if (!(low < part && part < high)) {
      part = 0.5 * (low + high);
    }
    tension_table__fill(law, par, segment, false, 1.0, q, part * (q_end - q), table, PART, -1);
    const found2 = tension_march___step(table, PART, branch, gamma, s, a, work);
    s1 = found2[0];
    a1 = found2[1];
    work1 = found2[2];
    const found3 = tension_march___rates(table, PART + 4 * NODE, branch, gamma, a1);
    ds = found3[0];
    gap =
      to < 0 ? s1 / par.length - 1.0 : tension_march___gap(table, PART + 4 * NODE, branch, to, a1);
    if (Math.abs(gap) < LANDING || high - low < 1e-15) {
      break;
    }
    if (gap > 0.0) {
      high = part;
      f_high = gap;
    } else {
      low = part;
      f_low = gap;
    }
    if (to >= 0) {
      part = low - (f_low * (high - low)) / (f_high - f_low);
      if (gap > 0.0) {
        f_low *= 0.5;
      } else {
        f_high *= 0.5;
      }
    } else {
      part -= ds > 0.0 ? (gap * part * par.length) / ds : part;
    }
  }
  return [part, s1, a1, work1];
}

/** Whether a point of the equal division of the arc lies inside a step. */
export function tension_march___divided(par, points, s, s_end) {
  let part = par.length / max(points, 1);
  let j = Math.trunc((s / part) * (1.0 + 1e-12)) + 1;
  return j < points && j * part < s_end * (1.0 - 1e-12);
}

/** Slopes dQ/ds, da/ds and d(friction work)/ds in a piece, past a flat peak too. */
export function tension_march___slopes(law, par, gamma, segment, branch, q, a) {
  let p;
  let side = par.side;
  if (branch === RISE) {
    p = par.entry_pressure * Math.exp(-side * q);
    if (compact__branch_of(law, segment, a, p) !== RISE) {
      branch = LINE;
    }
  }
  let r = step__rates(law, par, side * gamma, segment, branch, side, -side * q, side * a);
  return [-side * r[0], side * r[1], r[2]];
}

/** Record the points of the equal division inside a step (Q, s, a, work): cubics in s. */
export function tension_march___between(
  law,
  par,
  gamma,
  segment,
  branch,
  start,
  end,
  points,
  out,
  count,
) {
  let a, at, f, q;
  let length = par.length;
  let s = start[1];
  let ds = end[1] - start[1];
  if (!tension_march___divided(par, points, s, end[1])) {
    return count;
  }
  let j = Math.trunc((s / length) * points * (1.0 + 1e-12)) + 1;
  let d0 = tension_march___slopes(law, par, gamma, segment, branch, start[0], start[2]);
  let d1 = tension_march___slopes(law, par, gamma, segment, branch, end[0], end[2]);
  while (j < points && (j * length) / points < end[1] * (1.0 - 1e-12)) {
    at = (j * length) / points;
    f = (at - s) / ds;
    q = step__hermite(f, ds, start[0], d0[0], end[0], d1[0]);
    a = step__hermite(f, ds, start[2], d0[1], end[2], d1[1]);
    tension_march__record_point(
      law,
      par,
      q,
      at,
      a,
      step__hermite(f, ds, start[3], d0[2], end[3], d1[2]),
      out,
      count,
    );
    count += 1;
    j += 1;
  }
  return count;
}

/** Record the points of the equal division inside a step (Q, s, a, work), and its end. */
export function tension_march__record_step(
  law,
  par,
  gamma,
  segment,
  branch,
  start,
  end,
  points,
  table,
  out,
  count,
) {
  let am, half, middle, sm, work_m;
  if (tension_march___divided(par, points, start[1], end[1])) {
    half = 0.5 * (end[0] - start[0]);
    tension_table__fill(law, par, segment, false, 1.0, start[0], half, table, PART, -1);
    const found1 = tension_march___step(table, PART, branch, gamma, start[1], start[2], start[3]);
    sm = found1[0];
    am = found1[1];
    work_m = found1[2];
    middle = [start[0] + half, sm, am, work_m];
    count = tension_march___between(
      law,
      par,
      gamma,
      segment,
      branch,
      start,
      middle,
      points,
      out,
      count,
    );
    start = middle;
  }
  count = tension_march___between(law, par, gamma, segment, branch, start, end, points, out, count);
  tension_march__record_point(law, par, end[0], end[1], end[2], end[3], out, count);
  return count + 1;
}

/** March from the entry to the last Q of a table, or to the exit nip. */
export function tension_march__march(law, par, gamma, to_exit, table, points, out) {
  let a1, done, end, gap_0, gap_1, j, kink, o, part, q1, q_end, s1, start, there, to, work1;
  let length = par.length;
  if (table[0] === 0.0) {
    tension_table__extend(law, par, table);
  }
  const found1 = tension_march__start_of(law, par, gamma, table);
  let status = found1[0];
  let i = found1[1];
  let s = found1[2];
  let a = found1[3];
  let work = found1[4];
  let count = 0;
  if (status === LOST) {
    return [LOST, 0.0, 0.0, 0.0, 0.0, count];
  }
  let q = i === 1 ? table[FIRST] : 0.0;
  if (out.length > 0) {
    for (let each2 = 0, end2 = RECORD; each2 < end2; each2++) {
      j = each2;
      out[j] = 0.0;
    }
    if (i === 0) {
      tension_march__record_point(law, par, 0.0, 0.0, a, 0.0, out, 0);
    }
    count = 1;
  }
  let segment = compact__segment_of(law, par.entry_pressure);
  let branch = compact__branch_of(law, segment, a, par.entry_pressure);
  let least = i === 0 ? 0.5 * a : 0.0;
  let inside = false;
  for (let each3 = 0, end3 = 4000; each3 < end3; each3++) {
    if (i >= Math.trunc(table[0]) && !tension_table__extend(law, par, table)) {
      there = !to_exit && q >= table[3] * (1.0 - 1e-13);
      return [there ? SOLVED : LOST, q, s, a, work, count];
    }
    o = FIRST + i * STEP;
    q_end = table[o];
    segment = Math.trunc(table[o + 1]);
    o += 2;
    if (inside) {
      tension_table__fill(law, par, segment, false, 1.0, q, q_end - q, table, PART, -1);
      o = PART;
    }
    if (branch === RISE && table[o + 4 * NODE + 7] < 0.0 && a * table[o] > 1.0 + 1e-9) {
      branch = LINE;
    }
    const found4 = tension_march___step(table, o, branch, gamma, s, a, work);
    s1 = found4[0];
    a1 = found4[1];
    work1 = found4[2];
    if (!(a1 > least && s1 > s && a1 < 1000.0 && s1 < 1000000.0)) {
      return [LOST, q, s, a, work, count];
    }
    to = tension_march___next_branch(table, o + 4 * NODE, branch, a1);
    q1 = q_end;
    kink = false;
    if (to !== branch) {
      kink = true;
      gap_0 = tension_march___gap(table, o, branch, to, a);
      gap_1 = tension_march___gap(table, o + 4 * NODE, branch, to, a1);
      const found5 = tension_march___cut(
        law,
        par,
        gamma,
        branch,
        to,
        segment,
        q,
        q_end,
        s,
        a,
        work,
        gap_0,
        gap_1,
        table,
      );
      part = found5[0];
      s1 = found5[1];
      a1 = found5[2];
      work1 = found5[3];
      q1 = q + part * (q_end - q);
    }
    done = to_exit && s1 >= length;
    if (done) {
      const found6 = tension_march___cut(
        law,
        par,
        gamma,
        branch,
        -1,
        segment,
        q,
        q1,
        s,
        a,
        work,
        s / length - 1.0,
        s1 / length - 1.0,
        table,
      );
      part = found6[0];
      s1 = found6[1];
      a1 = found6[2];
      work1 = found6[3];
      [q1, kink] = [q + part * (q1 - q), false];
    }
    if (out.length > 0) {
      start = [q, s, a, work];
      end = [q1, s1, a1, work1];
      count = tension_march__record_step(
        law,
        par,
        gamma,
        segment,
        branch,
        start,
        end,
        points,
        table,
        out,
        count,
      );
    }
    q = q1;
    s = s1;
    a = a1;
    work = work1;
    if (done) {
      return [SOLVED, q, s, a, work, count];
    }
    inside = kink && q < q_end * (1.0 - 1e-13);
    if (kink) {
      branch = to;
    }
    if (!inside) {
      i += 1;
    }
  }
  return [LOST, q, s, a, work, count];
}

/** Exit quantities of a march in tension. */
export function search__tension_shot(law, par, gamma, q, a, work) {
  let side = par.side;
  const found1 = tension_march__exit_state(law, par, q, a);
  let tau = found1[0];
  let creep = found1[1];
  return new Shot(-side * q, side * a, side * creep, side * tau, work, side * gamma, 0.0);
}

/** March at effort z, in tension where there is a table: whether it went, the miss, the shot. */
export function search__attempt(law, par, aim, z, steps, table) {
  let shot;
  if (table.length === 0) {
    const found1 = effort__shoot_from(law, par, z, steps, 0, zeros(0));
    shot = found1[0];
    return [true, effort__value_of(par, shot, aim.of) - aim.value, shot];
  }
  let gamma = par.side * effort__ratio_of(par, z);
  let to_exit = aim.of !== TENSION;
  const found2 = tension_march__march(law, par, gamma, to_exit, table, 0, zeros(0));
  let status = found2[0];
  let q = found2[1];
  let s = found2[2];
  let a = found2[3];
  let work = found2[4];
  shot = search__tension_shot(law, par, gamma, q, a, work);
  if (status !== SOLVED) {
    return [false, 0.0, shot];
  }
  if (aim.of === TENSION) {
    return [true, aim.value * Math.log(par.length / s), shot];
  }
  return [true, effort__value_of(par, shot, aim.of) - aim.value, shot];
}

/** ln(tight/slack) carried with effort z, and the shot. */
export function search__carried_ratio(law, par, z, steps, table) {
  let shot, went;
  if (table.length > 0) {
    const found1 = search__attempt(law, par, new Aim(SLIP, 0.0), z, steps, table);
    went = found1[0];
    shot = found1[2];
    if (went) {
      return [effort__value_of(par, shot, TENSION), shot];
    }
  }
  const found2 = effort__shoot_from(law, par, z, steps, 0, zeros(0));
  shot = found2[0];
  return [effort__value_of(par, shot, TENSION), shot];
}

/** Effort in [a, b] of the largest tension ratio, to within `width`. */
export function search__climb(law, par, a, b, width, steps, table) {
  let before, f_u, f_v, f_w, middle, move, p, parabolic, q, r, shot_u, u, v, w;
  let golden = 0.3819660112501051;
  let x = a + golden * (b - a);
  const found1 = search__carried_ratio(law, par, x, steps, table);
  let f_x = found1[0];
  let shot = found1[1];
  w = v = x;
  f_w = f_v = f_x;
  move = before = 0.0;
  for (let each2 = 0, end2 = 80; each2 < end2; each2++) {
    middle = 0.5 * (a + b);
    if (Math.abs(x - middle) + 0.5 * (b - a) <= 2.0 * width) {
      break;
    }
    parabolic = false;
    if (Math.abs(before) > width) {
      r = (x - w) * (f_v - f_x);
      q = (x - v) * (f_w - f_x);
      p = (x - v) * q - (x - w) * r;
      q = 2.0 * (q - r);
      p = q > 0.0 ? -p : p;
      q = Math.abs(q);
      if (Math.abs(p) < Math.abs(0.5 * q * before) && q * (a - x) < p && p < q * (b - x)) {
        [before, move] = [move, p / q];
        parabolic = true;
        if (x + move - a < 2.0 * width || b - x - move < 2.0 * width) {
          move = middle >= x ? width : -width;
        }
      }
    }
    if (!parabolic) {
      before = x < middle ? b - x : a - x;
      move = golden * before;
    }
    u = x + (Math.abs(move) >= width ? move : move > 0.0 ? width : -width);
    const found3 = search__carried_ratio(law, par, u, steps, table);
    f_u = found3[0];
    shot_u = found3[1];
    if (f_u >= f_x) {
      if (u >= x) {
        a = x;
      } else {
        b = x;
      }
      [v, f_v, w, f_w, x, f_x, shot] = [w, f_w, x, f_x, u, f_u, shot_u];
    } else {
      if (u < x) {
        a = u;
      } else {
        b = u;
      }
      if (f_u >= f_w || w === x) {
        [v, f_v, w, f_w] = [w, f_w, u, f_u];
      } else if (f_u >= f_v || v === x || v === w) {
        v = u;
        f_v = f_u;
      }
    }
  }
  return [x, shot];
}

/** Least effort at which the value of a target meets its goal. */
export function search__search(law, par, aim, z, slope, steps, tolerance, table) {
  let i, new_, peak_high, peak_low, reach;
  let top = effort__largest_effort(law, par);
  let jump = effort__jumps(law);
  let bottom = effort__lowest_effort(law, par);
  let low = bottom;
  let high = Infinity;
  z = min(z, top);
  const found1 = search__attempt(law, par, aim, z, steps, table);
  let went = found1[0];
  let f = found1[1];
  let shot = found1[2];
  let z_last = z;
  let f_last = 0.0;
  if (slope <= 0.0) {
    slope = 0.8 * max(f + aim.value, 0.2 * aim.value);
  }
  let width = Infinity;
  let climbed = false;
  let astray = 0;
  for (let each2 = 0, end2 = 120; each2 < end2; each2++) {
    i = each2;
    if (!went) {
      astray += 1;
      low = max(low, z);
      new_ = high < Infinity ? 0.5 * (low + high) : z + 3.0;
      if (astray > 8 || new_ > top) {
        return [LOST, z, slope, shot];
      }
      z_last = z = new_;
      const found3 = search__attempt(law, par, aim, z, steps, table);
      went = found3[0];
      f = found3[1];
      shot = found3[2];
      f_last = f;
      continue;
    }
    if (Math.abs(f) <= tolerance) {
      return [SOLVED, z, slope, shot];
    }
    if (f < 0.0) {
      low = max(low, z);
    } else {
      high = min(high, z);
    }
    if (i > 0 && z !== z_last && f !== f_last) {
      slope = (f - f_last) / (z - z_last);
    }
    if (f < 0.0 && high === Infinity && (slope < 1e-12 || z >= top)) {
      if (climbed || aim.of !== TENSION || table.length > 0) {
        return [BREAKAWAY, z, slope, shot];
      }
      climbed = true;
      peak_low = min(z, z_last) - 6.0;
      peak_high = min(max(z, z_last) + 1.0, top);
      if (jump) {
        peak_low = 0.0;
        peak_high = top;
      }
      const found4 = search__climb(law, par, peak_low, peak_high, 1e-6, steps, zeros(0));
      z = found4[0];
      shot = found4[1];
      f = effort__value_of(par, shot, aim.of) - aim.value;
      if (f < -tolerance) {
        return [BREAKAWAY, z, slope, shot];
      }
      low = bottom;
      z_last = z;
      f_last = f;
      slope = 0.5 * aim.value;
      if (f < 0.0) {
        return [SOLVED, z, slope, shot];
      }
      high = z;
    }
    new_ = slope > 0.0 ? z - f / slope : z - 1.0;
    if (high === Infinity || (low === bottom && f > 0.0 && z - low > 5.0)) {
      reach = !jump ? 2.5 : max(1.0, 2.0 * z);
      new_ = min(min(max(new_, z - reach), z + reach), top);
    } else if (modulo(i, 2) === 0) {
      if (high - low > 0.5 * width) {
        new_ = 0.5 * (low + high);
      }
      width = high - low;
    }
    if (!(low < new_ && new_ < high)) {
      new_ = high < Infinity ? 0.5 * (low + high) : top;
    }
    if (new_ === z) {
      return [UNSOLVED, z, slope, shot];
    }
    z_last = z;
    f_last = f;
    z = new_;
    const found5 = search__attempt(law, par, aim, z, steps, table);
    went = found5[0];
    f = found5[1];
    shot = found5[2];
  }
  return [UNSOLVED, z, slope, shot];
}

/** Meet an aim: by marches in tension where they apply, else in position, coarse then fine. */
export function search__refine(law, par, aim, z, steps) {
  let end, fine, outcome, shot, slope, table, z_met;
  let size = aim.of === TENSION ? max(Math.abs(aim.value), NEARLY_IDLE) : Math.abs(aim.value);
  if (tension_table__applies(law, par) && aim.value > NO_PULL) {
    fine = effort__mesh_steps(law, par, steps);
    end = aim.of === TENSION ? aim.value : 8.0;
    table = zeros(tension_table__table_size(end, fine));
    tension_table__open_table(law, par, end, fine, table);
    const found1 = search__search(law, par, aim, z, 0.0, steps, TOLERANCE * size, table);
    outcome = found1[0];
    z_met = found1[1];
    shot = found1[3];
    if (outcome === SOLVED) {
      return [outcome, z_met, shot];
    }
  }
  let no_table = zeros(0);
  const found2 = search__search(
    law,
    par,
    aim,
    z,
    0.0,
    COARSE_STEPS,
    COARSE_TOLERANCE * size,
    no_table,
  );
  outcome = found2[0];
  z = found2[1];
  slope = found2[2];
  shot = found2[3];
  if (outcome !== SOLVED) {
    slope = 0.0;
  }
  const found3 = search__search(law, par, aim, z, slope, steps, TOLERANCE * size, no_table);
  outcome = found3[0];
  z = found3[1];
  shot = found3[3];
  if (
    outcome === UNSOLVED &&
    Math.abs(effort__value_of(par, shot, aim.of) - aim.value) < 1e-8 * size
  ) {
    outcome = SOLVED;
  }
  return [outcome, z, shot];
}

/** Miss of loss = (T1 - T2) (g + (T1 - T2)/(2 EA')), relative to the energies in it. */
export function answer__loss_miss(law, par, shot) {
  let pull = par.entry_tension * -Math.expm1(shot.log_tension);
  let exact = pull * (shot.creep_ratio + 0.5 * pull * par.compliance);
  const found1 = layer_march__friction_of_creep(law, par, par.entry_tension, par.kick);
  let entry_stress = found1[0];
  let leaving = 0.5 * par.shear * shot.stress ** 2;
  let entering = 0.5 * par.shear * entry_stress ** 2;
  let loss = par.width * (shot.work + leaving - entering);
  let size = max(Math.abs(exact), par.width * (Math.abs(shot.work) + leaving + entering));
  return size > 0.0 ? Math.abs(loss - exact) / size : 0.0;
}

/** Meet ln(tight/slack) by marches from the entry, on a finer mesh while it is not resolved. */
export function answer___by_marches(law, par, goal, steps) {
  let held, miss, outcome, shot, z;
  let aim = new Aim(TENSION, goal);
  let guess = effort__first_guess(law, par, aim);
  let found = new Found(BREAKAWAY, NaN, NO_SHOT, NO_LAYERS, steps);
  let finer = 1;
  while (finer <= FINEST) {
    const found1 = search__refine(law, par, aim, guess, finer * steps);
    outcome = found1[0];
    z = found1[1];
    shot = found1[2];
    if (outcome === BREAKAWAY) {
      break;
    }
    found = new Found(outcome, z, shot, NO_LAYERS, finer * steps);
    miss = outcome === SOLVED ? answer__loss_miss(law, par, shot) : 0.0;
    held = effort__jumps(law) && par.shear === 0.0;
    if (miss < LOSS_MISS && (outcome === SOLVED || held || finer > 2)) {
      break;
    }
    finer *= Math.trunc(min(max(Math.ceil(Math.sqrt(miss / LOSS_MISS)), 2), FINER));
  }
  return found;
}

/** Numbers that the records of a march need. */
export function answer___march_size(law, par, steps, points) {
  return RECORD * (points + 4 * effort__mesh_steps(law, par, steps) + 600);
}

/** Whether slip passes through zero in a march: a law that jumps would hold the belt there. */
export function answer___turns(law, par, found) {
  let high, i, low;
  let out = zeros(answer___march_size(law, par, found.steps, TURNS));
  const found1 = effort__shoot_from(law, par, found.z, found.steps, TURNS, out);
  let count = found1[1];
  low = high = 0.0;
  for (let each2 = 0, end2 = count; each2 < end2; each2++) {
    i = each2;
    [low, high] = [min(low, out[RECORD * i + 2]), max(high, out[RECORD * i + 2])];
  }
  return min(-low, high) > LEAST_TURN;
}

/** Whether friction holds the belt all along the stuck zone of a march. */
export function answer___held_throughout(law, par, found) {
  if (!effort__jumps(law) || par.shear === 0.0 || found.outcome !== SOLVED) {
    return true;
  }
  let zone = found.shot.stuck_length;
  if (!stick__holds(law, par, zone, stick__zone_end(law, par, zone)[1])) {
    return false;
  }
  return par.kick === 0.0 || !answer___turns(law, par, found);
}

/** Whether a march has met its aim on a mesh fine enough for the law. */
export function answer___resolved(law, par, found) {
  if (found.outcome !== SOLVED) {
    return effort__jumps(law) && par.shear === 0.0;
  }
  return answer__loss_miss(law, par, found.shot) < LOSS_MISS;
}

/** Effort at which the exit tension is met. */
export function answer__solve_tension(law, par, exit_tension, steps) {
  let creep, end, far, found, held, holds_on, other, outcome, shot, still, z;
  let goal = par.side * Math.log(par.entry_tension / exit_tension);
  if (effort__jumps(law)) {
    const found1 = stick__held_exit(law, par, exit_tension);
    held = found1[0];
    creep = found1[1];
    if (held && !stick__holds(law, par, par.length, creep)) {
      return answer__by_layers(law, par, goal);
    }
    if (held) {
      end = stick__zone_end(law, par, par.length)[1];
      z = end !== 0.0 ? creep / end - 1.0 : 0.0;
      const found2 = answer__stuck_shot(law, par, exit_tension, creep, 0, zeros(0));
      shot = found2[0];
      return new Found(STUCK, z, shot, NO_LAYERS, steps);
    }
  }
  if (Math.abs(goal) < NO_PULL && par.kick === 0.0) {
    still = new Shot(0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0);
    return new Found(SOLVED, -Infinity, still, NO_LAYERS, steps);
  }
  if (effort__is_far(law, par)) {
    far = answer__by_layers(law, par, goal);
    if (far.outcome !== UNSOLVED) {
      return far;
    }
  }
  let tight = max(par.entry_tension, exit_tension) / (par.width * par.radius);
  if (goal < gross_slip__plateau_capacity(law, tight, par.length / par.radius)) {
    found = answer___by_marches(law, par, goal, steps);
    if (found.outcome !== BREAKAWAY) {
      holds_on = answer___held_throughout(law, par, found);
      if (holds_on && answer___resolved(law, par, found)) {
        return found;
      }
      other = answer__by_layers(law, par, goal);
      if (other.outcome === SOLVED) {
        return other;
      }
      outcome = holds_on ? found.outcome : UNSOLVED;
      return new Found(outcome, found.z, found.shot, found.layers, found.steps);
    }
  }
  return new Found(BREAKAWAY, -Infinity, NO_SHOT, NO_LAYERS, steps);
}

/** Operating point of an arc, judged by the balance T(phi) = T2. */
export function answer__answer(law, geometry, load, steps) {
  let good, miss;
  let par = quantities__parameters_at(load.entry_tension, geometry);
  const found1 = answer__solve_tension(law, par, load.exit_tension, steps);
  let outcome = found1.outcome;
  let z = found1.z;
  let shot = found1.shot;
  let layers = found1.layers;
  let marched = found1.steps;
  if (outcome !== BREAKAWAY) {
    miss = (load.entry_tension * Math.exp(shot.log_tension)) / load.exit_tension - 1.0;
    good = (outcome === SOLVED || outcome === STUCK) && Math.abs(miss) <= BALANCE;
    outcome = good ? SOLVED : UNSOLVED;
  }
  return new Answer(outcome, par, z, shot, layers, marched);
}

/** Numbers that the records of `trace` need: points, nodes and kinks. */
export function answer__profile_size(law, found, points) {
  if (found.z !== found.z) {
    return RECORD * (points + 2 * (NODES + KINKS) + 10);
  }
  return answer___march_size(law, found.par, found.steps, points);
}

/** Write one point of a profile, see wraparc.arc.kernel.march.record. */
export function layer_profile___record(law, par, rest, g, s, u, w, out, count) {
  let tension = rest - w / par.compliance;
  const found1 = layer_march__friction_of_creep(law, par, tension, u);
  let tau = found1[0];
  let x = found1[1];
  const found2 = layer_march__friction_of_creep(law, par, par.entry_tension, par.kick);
  let entry_tau = found2[0];
  let work = (0.5 * (w * w - g * g)) / (par.compliance * par.width);
  work -= 0.5 * par.shear * (tau * tau - entry_tau * entry_tau);
  let i = RECORD * count;
  [out[i], out[i + 1], out[i + 2]] = [s, Math.log(tension / par.entry_tension), x];
  [out[i + 3], out[i + 4], out[i + 5]] = [u, tau, work];
}

/** Record a layer in order of position, with the points of the equal division inside it. */
export function layer_profile___record_path(
  law,
  par,
  rest,
  g,
  path,
  origin,
  towards,
  points,
  out,
  count,
) {
  let at, before, from_s, h, here, i, j, k, m, s, start, u, v, w, y;
  let n = Math.trunc(path[0]);
  let skip = 1 + Math.floor(n / NODES);
  for (let each1 = 0, end1 = n; each1 < end1; each1++) {
    k = each1;
    i = towards > 0.0 ? k : n - 1 - k;
    s = path[3 * i + 1];
    u = path[3 * i + 2];
    w = path[3 * i + 3];
    here = origin + towards * s;
    if (k > 0) {
      m = towards > 0.0 ? i - 1 : i;
      from_s = path[3 * m + 1];
      start = [path[3 * m + 2], path[3 * m + 3]];
      before = origin + towards * path[3 * (towards > 0.0 ? i - 1 : i + 1) + 1];
      j = Math.trunc((before / par.length) * points * (1.0 + 1e-12)) + 1;
      while (j < points && (j * par.length) / points < here * (1.0 - 1e-12)) {
        at = (j * par.length) / points;
        h = towards * (towards * (at - origin) - from_s);
        const found2 = layer_march__layer_step(law, par, rest, start[0], start[1], h);
        v = found2[0];
        y = found2[1];
        layer_profile___record(law, par, rest, g, at, v, y, out, count);
        count += 1;
        j += 1;
      }
    }
    if (k === 0 || k === n - 1 || modulo(k, skip) === 0) {
      layer_profile___record(law, par, rest, g, max(here, 0.0), u, w, out, count);
      count += 1;
    }
  }
  return count;
}

/** Segment and branch of the law at a creep and a creep ratio; -1 where the belt is held. */
export function layer_profile___piece(law, par, rest, u, w) {
  let tension = rest - w / par.compliance;
  const found1 = layer_march__friction_of_creep(law, par, tension, u);
  let x = found1[1];
  let pressure = par.entry_pressure * max(tension / par.entry_tension, 1e-9);
  let segment = compact__segment_of(law, pressure);
  return [segment, x !== 0.0 ? compact__branch_of(law, segment, Math.abs(x), pressure) : -1];
}

/** Record where the law changes its piece between two steps of a layer. */
export function layer_profile___record_kinks(law, par, rest, g, path, origin, towards, out, count) {
  let h, high, i, low, part, piece, s, u, v, w, y;
  let most = count + KINKS;
  for (let each1 = 0, end1 = Math.trunc(path[0]) - 1; each1 < end1; each1++) {
    i = each1;
    s = path[3 * i + 1];
    u = path[3 * i + 2];
    w = path[3 * i + 3];
    piece = layer_profile___piece(law, par, rest, u, w);
    h = towards * (path[3 * i + 4] - s);
    if (
      count === most ||
      piece === layer_profile___piece(law, par, rest, path[3 * i + 5], path[3 * i + 6])
    ) {
      continue;
    }
    low = 0.0;
    high = 1.0;
    for (let each2 = 0, end2 = 50; each2 < end2; each2++) {
      part = 0.5 * (low + high);
      const found3 = layer_march__layer_step(law, par, rest, u, w, part * h);
      v = found3[0];
      y = found3[1];
      if (layer_profile___piece(law, par, rest, v, y) === piece) {
        low = part;
      } else {
        high = part;
      }
    }
    const found4 = layer_march__layer_step(law, par, rest, u, w, high * h);
    v = found4[0];
    y = found4[1];
    layer_profile___record(
      law,
      par,
      rest,
      g,
      max(origin + towards * s + high * h, 0.0),
      v,
      y,
      out,
      count,
    );
    count += 1;
  }
  return count;
}

/** Put records in order of s (insertion sort: they are nearly in order). */
export function profile__sort(out, count) {
  let a, b, i, j, k;
  for (let each1 = 1, end1 = count; each1 < end1; each1++) {
    i = each1;
    j = i;
    while (j > 0 && out[RECORD * j] < out[RECORD * (j - 1)]) {
      a = RECORD * j;
      b = RECORD * (j - 1);
      for (let each2 = 0, end2 = RECORD; each2 < end2; each2++) {
        k = each2;
        [out[a + k], out[b + k]] = [out[b + k], out[a + k]];
      }
      j -= 1;
    }
  }
}

/** Profile of solved layers: exit quantities and the number of records. */
export function layer_profile__trace_layers(law, par, found, points, out) {
  let path = zeros(3 * MOST_STEPS + 10);
  let count = 0;
  let part = [found.creep, found.ratio];
  let g = par.compliance * (found.rest_tension - par.entry_tension);
  let begin = min(found.entry_length, par.length);
  let out_length = max(found.length - found.entry_length, 0.0);
  if (begin > 0.0) {
    layer_march__march_layer(
      law,
      par,
      found.rest_tension,
      part,
      -1.0,
      TO_CREEP,
      par.kick,
      STEP_TOLERANCE,
      path,
    );
    count = layer_profile___record_path(
      law,
      par,
      found.rest_tension,
      g,
      path,
      begin,
      -1.0,
      points,
      out,
      0,
    );
    count = layer_profile___record_kinks(
      law,
      par,
      found.rest_tension,
      g,
      path,
      begin,
      -1.0,
      out,
      count,
    );
  } else if (par.kick === 0.0) {
    layer_profile___record(law, par, found.rest_tension, g, 0.0, 0.0, found.ratio, out, 0);
    count = 1;
  }
  let end = max(par.length - out_length, begin);
  let j = Math.trunc((begin / par.length) * points * (1.0 + 1e-12)) + 1;
  while (j < points && (j * par.length) / points < end) {
    layer_profile___record(
      law,
      par,
      found.rest_tension,
      g,
      (j * par.length) / points,
      0.0,
      0.0,
      out,
      count,
    );
    count += 1;
    j += 1;
  }
  path[0] = 0.0;
  if (out_length > 0.0) {
    layer_march__march_layer(
      law,
      par,
      found.rest_tension,
      part,
      1.0,
      TO_RATIO,
      found.exit_ratio,
      STEP_TOLERANCE,
      path,
    );
  } else {
    [path[0], path[1], path[2], path[3]] = [1.0, 0.0, found.exit_creep, found.exit_ratio];
  }
  count = layer_profile___record_path(
    law,
    par,
    found.rest_tension,
    g,
    path,
    end,
    1.0,
    points,
    out,
    count,
  );
  out[RECORD * (count - 1)] = par.length;
  count = layer_profile___record_kinks(law, par, found.rest_tension, g, path, end, 1.0, out, count);
  profile__sort(out, count);
  return [layers__shot_of_layers(law, par, found), count];
}

/** Profile of an arc solved by `solve_tension`: exit quantities and the number of records. */
export function answer__trace(law, found, exit_tension, points, out) {
  let a, count, creep, fine, gamma, held, q, s, shot, status, table, work;
  let par = found.par;
  let z = found.z;
  let steps = found.steps;
  let goal = par.side * Math.log(par.entry_tension / exit_tension);
  if (z !== z) {
    return layer_profile__trace_layers(law, par, found.layers, points, out);
  }
  if (effort__jumps(law)) {
    const found1 = stick__held_exit(law, par, exit_tension);
    held = found1[0];
    creep = found1[1];
    if (held) {
      return answer__stuck_shot(law, par, exit_tension, creep, points, out);
    }
  }
  if (tension_table__applies(law, par) && goal > NO_PULL) {
    fine = effort__mesh_steps(law, par, steps);
    table = zeros(tension_table__table_size(goal, fine));
    tension_table__open_table(law, par, goal, fine, table);
    gamma = par.side * effort__ratio_of(par, z);
    const found2 = tension_march__march(law, par, gamma, false, table, 0, zeros(0));
    status = found2[0];
    q = found2[1];
    s = found2[2];
    a = found2[3];
    work = found2[4];
    if (status === SOLVED && Math.abs(s / par.length - 1.0) < TOLERANCE * 100.0) {
      count = tension_march__march(law, par, gamma, false, table, points, out)[5];
      profile__sort(out, count);
      return [search__tension_shot(law, par, gamma, q, a, work), count];
    }
  }
  const found3 = effort__shoot_from(law, par, z, steps, points, out);
  shot = found3[0];
  count = found3[1];
  profile__sort(out, count);
  return [shot, count];
}

/** Exit quantities of an answer and the number of records of its profile, in `out`. */
export function answer__profile_of(law, found, exit_tension, points, out) {
  let i;
  if (found.z !== -Infinity) {
    return answer__trace(law, found, exit_tension, points, out);
  }
  for (let each1 = 0, end1 = points + 1; each1 < end1; each1++) {
    i = each1;
    out[RECORD * i] = (found.par.length * i) / points;
  }
  return [found.shot, points + 1];
}

/** Solution of an arc with its profile and the number of records; none where it has none. */
export function summary__operating_point(law, geometry, load, steps, points) {
  let found = answer__answer(law, geometry, load, steps);
  if (found.outcome !== SOLVED) {
    return [found, zeros(0), 0];
  }
  let out = zeros(answer__profile_size(law, found, points));
  const found1 = answer__profile_of(law, found, load.exit_tension, points, out);
  let shot = found1[0];
  let count = found1[1];
  return [
    Object.assign(Object.create(Object.getPrototypeOf(found)), found, { shot: shot }),
    out,
    count,
  ];
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

/** Profile of an arc that is solved and traced, record by record. */
export function summary__columns_of(law, arc, found, out, count) {
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
  let zone = found.shot.stuck_length;
  let side = found.par.side;
  for (let each1 = 0, end1 = count; each1 < end1; each1++) {
    i = each1;
    o = RECORD * i;
    s = out[o];
    slip = out[o + 2];
    tau = out[o + 4];
    tension = found.par.entry_tension * Math.exp(out[o + 1]);
    pressure = (2.0 * tension) / (arc.width * arc.diameter);
    slides = (s > zone || zone === 0.0) && (slip !== 0.0 || tau === 0.0);
    felt = slides ? slip : copysign(NEXT_SLIP, tau === 0.0 ? side : tau);
    columns.position[i] = s / found.par.radius;
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

/** D tau/ds [Pa/m] at one end of the way between two records, in the piece of law between. */
export function profile___stress_slope(law, par, g, out, a, b, at) {
  let q = out[at + 1];
  let tau = out[at + 4];
  let slip = 0.5 * (out[a + 2] + out[b + 2]);
  let w = g + par.entry_tension * -Math.expm1(q) * par.compliance;
  if (slip === 0.0) {
    return par.shear > 0.0 ? w / par.shear : 0.0;
  }
  let sign = slip > 0.0 ? 1.0 : -1.0;
  let between = par.entry_pressure * Math.exp(0.5 * (out[a + 1] + out[b + 1]));
  let segment = compact__segment_of(law, between);
  let branch = compact__branch_of(law, segment, sign * slip, between);
  let p = par.entry_pressure * Math.exp(q);
  const found1 = compact__friction_at(law, segment, branch, sign * out[at + 2], p);
  let mu = found1[0];
  let mu_x = found1[1];
  let mu_p = found1[2];
  let turn = (-sign * (mu + p * mu_p) * tau) / par.radius;
  return (p * mu_x * w + turn) / (1.0 + par.shear * p * mu_x);
}

/** Magnitude of shear stress at a fraction of the way between two records [Pa]. */
export function profile___stress_between(law, par, g, out, a, b, f) {
  let at, part, tension;
  let e = 1.0 - f;
  let h = out[b] - out[a];
  let near = e * e * (1.0 + 2.0 * f);
  let far = f * f * (3.0 - 2.0 * f);
  let to_a = e * e * f * h;
  let to_b = -f * f * e * h;
  let q = near * out[a + 1] + far * out[b + 1];
  let u = near * out[a + 3] + far * out[b + 3];
  for (const each1 of [
    [a, to_a],
    [b, to_b],
  ]) {
    [at, part] = each1;
    tension = par.entry_tension * Math.exp(out[at + 1]);
    q -= (part * out[at + 4] * par.width) / tension;
    u += part * (g + (par.entry_tension - tension) * par.compliance);
  }
  const found2 = layer_march__friction_of_creep(law, par, par.entry_tension * Math.exp(q), u);
  let tau = found2[0];
  return Math.abs(tau);
}

/** Fraction of the way between two records at which stress is largest, and the stress [Pa]. */
export function profile___peak_between(law, par, g, out, a, b) {
  let h = out[b] - out[a];
  let sign = out[a + 4] + out[b + 4] > 0.0 ? 1.0 : -1.0;
  if (h <= 0.0 || sign * out[a + 4] <= 0.0 || sign * out[b + 4] <= 0.0) {
    return [0.0, 0.0];
  }
  let start = h * sign * profile___stress_slope(law, par, g, out, a, b, a);
  let end = h * sign * profile___stress_slope(law, par, g, out, a, b, b);
  if (!(start > 0.0) || !(end < 0.0)) {
    return [0.0, 0.0];
  }
  let rise = sign * (out[b + 4] - out[a + 4]);
  let m = 6.0 * rise - 4.0 * start - 2.0 * end;
  let k = 3.0 * (start + end) - 6.0 * rise;
  let f = (2.0 * start) / (-m + Math.sqrt(max(m * m - 4.0 * k * start, 0.0)));
  let vertex = sign * out[a + 4] + f * (start + f * (0.5 * m + (f * k) / 3.0));
  let there = profile___stress_between(law, par, g, out, a, b, f);
  if (Math.abs(there - vertex) <= PEAK_TOLERANCE * vertex) {
    return [f, there];
  }
  let low = 0.0;
  let high = 1.0;
  let c = 1.0 - GOLDEN;
  let d = GOLDEN;
  let at_c = profile___stress_between(law, par, g, out, a, b, c);
  let at_d = profile___stress_between(law, par, g, out, a, b, d);
  for (let each1 = 0, end1 = 40; each1 < end1; each1++) {
    if (at_c >= at_d) {
      [high, d, at_d] = [d, c, at_c];
      c = high - GOLDEN * (high - low);
      at_c = profile___stress_between(law, par, g, out, a, b, c);
    } else {
      [low, c, at_c] = [c, d, at_d];
      d = low + GOLDEN * (high - low);
      at_d = profile___stress_between(law, par, g, out, a, b, d);
    }
  }
  return at_c >= at_d ? [c, at_c] : [d, at_d];
}

/** Largest magnitude of shear stress [Pa] and where it is, s [m]. */
export function profile__peak_stress(law, par, g, out, count) {
  let a, b, f, i, there;
  let best = 0;
  for (let each1 = 1, end1 = count; each1 < end1; each1++) {
    i = each1;
    if (Math.abs(out[RECORD * i + 4]) > Math.abs(out[RECORD * best + 4])) {
      best = i;
    }
  }
  let most = Math.abs(out[RECORD * best + 4]);
  let where = out[RECORD * best];
  for (const each2 of [best - 1, best]) {
    i = each2;
    if (i < 0 || i + 1 >= count) {
      continue;
    }
    a = RECORD * i;
    b = RECORD * (i + 1);
    const found3 = profile___peak_between(law, par, g, out, a, b);
    f = found3[0];
    there = found3[1];
    if (there > most) {
      most = there;
      where = out[a] + f * (out[b] - out[a]);
    }
  }
  return [most, where];
}

/** Length of the exit part of the arc that takes 99 % of the tension change [m]. */
export function profile__active_length(out, count) {
  let end = RECORD * (count - 1);
  let change = -Math.expm1(out[end + 1]);
  if (change === 0.0) {
    return 0.0;
  }
  let i = count - 1;
  while (i > 0 && -Math.expm1(out[RECORD * i + 1]) / change > 0.01) {
    i -= 1;
  }
  if (i === count - 1) {
    return 0.0;
  }
  let a = -Math.expm1(out[RECORD * i + 1]) / change;
  let b = -Math.expm1(out[RECORD * (i + 1) + 1]) / change;
  let w = b !== a ? (0.01 - a) / (b - a) : 1.0;
  let s = out[RECORD * i] + w * (out[RECORD * (i + 1)] - out[RECORD * i]);
  return out[end] - s;
}

/** Fraction of the arc where pressure or slip lies outside the tested range. */
export function profile__share_outside(par, out, count, pressure_min, pressure_max, slip_max) {
  let a, b, f0, f1, high, i, low, p0, p1, x0, x1;
  let outside = 0.0;
  for (let each1 = 0, end1 = count - 1; each1 < end1; each1++) {
    i = each1;
    a = RECORD * i;
    b = RECORD * (i + 1);
    low = 0.0;
    high = 1.0;
    p0 = par.entry_pressure * Math.exp(out[a + 1]);
    p1 = par.entry_pressure * Math.exp(out[b + 1]);
    x0 = Math.abs(out[a + 2]);
    x1 = Math.abs(out[b + 2]);
    for (const each2 of [
      [pressure_min - p0, pressure_min - p1],
      [p0 - pressure_max, p1 - pressure_max],
      [x0 - slip_max, x1 - slip_max],
    ]) {
      [f0, f1] = each2;
      if (f0 > 0.0 && f1 > 0.0) {
        high = -1.0;
      } else if (f0 > 0.0) {
        low = max(low, f0 / (f0 - f1));
      } else if (f1 > 0.0) {
        high = min(high, f0 / (f0 - f1));
      }
    }
    outside += (out[b] - out[a]) * (1.0 - max(high - low, 0.0));
  }
  return outside / (out[RECORD * (count - 1)] - out[0]);
}

/** Spring rate of the belt over its active arc, EA/l [N/m]; nan without one. */
export function summary__spring_rate(axial_stiffness, length) {
  return length > 0.0 ? axial_stiffness / length : NaN;
}

/** Reported numbers of an arc that is solved and traced; nan where there is none. */
export function summary__summary_of(law, arc, tested, found, out, count) {
  if (found.outcome !== SOLVED) {
    return summary___asked_alone(arc);
  }
  let par = found.par;
  let shot = found.shot;
  let radius = par.radius;
  let entry = par.entry_tension;
  let exit_tension = arc.exit_tension;
  let q = shot.log_tension;
  let g = shot.creep_ratio;
  let work = shot.work;
  let pull = entry - entry * Math.exp(q);
  const found1 = profile__peak_stress(law, par, g, out, count);
  let peak = found1[0];
  let where = found1[1];
  let active = profile__active_length(out, count);
  let outside = NaN;
  if (tested !== null) {
    outside = profile__share_outside(
      par,
      out,
      count,
      tested.pressure_min,
      tested.pressure_max,
      tested.slip_max,
    );
  }
  let kappa = summary__recovery_compliance(arc);
  let compliance = 1.0 / arc.axial_stiffness + kappa;
  let recovery = compliance > 0.0 ? kappa / compliance : 0.0;
  let distributed = shot.creep - par.kick - g * (radius * arc.wrap_angle);
  let shear = arc.thickness / arc.shear_modulus;
  let kept = 0.5 * shear * (shot.stress * shot.stress - out[4] * out[4]);
  let exact = pull * (g + 0.5 * pull * compliance);
  let lost = work + kept;
  let speed = g < 1.0 ? arc.belt_speed / (1.0 - g) : NaN;
  let part = Math.abs(pull) > 1e-6 * arc.entry_tension ? (arc.width * lost) / Math.abs(pull) : NaN;
  let efficiency = pull > 0.0 ? 1.0 - part : 1.0 / (1.0 + part);
  return new Summary(
    entry,
    exit_tension,
    entry - exit_tension,
    entry / exit_tension,
    shot.creep,
    (1.0 - recovery) * distributed,
    recovery * distributed + par.kick,
    g * (radius * arc.wrap_angle),
    shot.slip,
    g,
    g + pull * compliance,
    peak,
    Math.atan(peak / arc.shear_modulus),
    where / radius,
    Math.abs(q) / arc.wrap_angle,
    active / radius,
    summary__spring_rate(arc.axial_stiffness, radius * (active / radius)),
    outside,
    shot.stuck_length / radius,
    speed * pull,
    speed * arc.width * work,
    speed * arc.width * kept,
    speed * arc.width * lost,
    efficiency,
    work,
    1000000.0 * arc.wear_coefficient * work,
    Math.abs(arc.width * lost - exact) /
      max(max(Math.abs(exact), 1e-6 * arc.entry_tension * Math.abs(g)), 1e-300),
  );
}

/** Answer for one arc; None where it is for the server to say what is wrong. */
export function in_page__quick(law, given, tested, points) {
  let arc = in_page__description_of(given);
  if (in_page__refused(law, arc, given.steepest_fall)) {
    return null;
  }
  let geometry = summary__geometry_of(arc, law.onset_compliance);
  let load = in_page__load_of(given, arc, null);
  const found1 = summary__operating_point(law, geometry, load, STEPS, points);
  let found = found1[0];
  let out = found1[1];
  let count = found1[2];
  if (!(found.outcome === SOLVED || found.outcome === BREAKAWAY)) {
    return null;
  }
  let profile = summary__columns_of(law, arc, found, out, count);
  const found2 = summary__stretches_outside(tested, profile, count);
  let outside = found2[0];
  let stretches = found2[1];
  let summary = summary__summary_of(law, arc, tested, found, out, count);
  return new Quick(found.outcome === SOLVED, summary, profile, outside, stretches);
}

/** Growth of the tight and of the slack side of a single pulley with its pull [N]. */
export function numbers__rise_alone(pull, fixed, behind) {
  let size = Math.abs(pull);
  let lost = fixed ? 0.5 * size : behind && pull < 0.0 ? size : 0.0;
  return [size - lost, -lost];
}

/** The same of a pulley that is alone on its belt. */
export function in_page__alone(arc, criteria) {
  let entry = arc.entry_tension;
  let leaving = arc.exit_tension;
  let slack = entry >= leaving ? leaving : entry;
  let end = criteria.behind ? leaving : slack;
  let held = criteria.fixed ? entry + leaving : end;
  const found1 = numbers__rise_alone(entry - leaving, criteria.fixed, criteria.behind);
  let tight_rise = found1[0];
  let slack_rise = found1[1];
  return new Among(end, held, slack, slack, tight_rise, slack_rise);
}

/** Whether an arc hands nothing over: its pulley is not driven. */
export function numbers__idles(entry, leaving) {
  return Math.abs(entry - leaving) <= IDLE * entry;
}

/** Whether a size is one that conveyor drives have; one that is not given is. */
export function numbers__usual(value, least, most) {
  return !(value < least || value > most);
}

/** Whether belt and pulley have sizes that those of a conveyor have. */
export function numbers__usual_sizes(width, modulus, speed, diameter) {
  let belt =
    numbers__usual(width, WIDTHS[0], WIDTHS[1]) && numbers__usual(modulus, MODULI[0], MODULI[1]);
  let found =
    numbers__usual(speed, SPEEDS[0], SPEEDS[1]) &&
    numbers__usual(diameter, DIAMETERS[0], DIAMETERS[1]);
  return belt && found;
}

/** Whether a tension is one that the belt of a conveyor has. */
export function numbers__usual_tension(tension, width) {
  return numbers__usual(tension, USUAL_TENSION[0] * width, USUAL_TENSION[1] * width);
}

/** Relative error of a step of layers, for the fineness of a mesh. */
export function capacity___tolerance(steps) {
  return steps === MEET_STEPS ? 1e-6 : STEP_TOLERANCE;
}

/** Meet a target of creep or slip with the entry tension held [N]. */
export function capacity__carry_from(law, geometry, entry, aim, guess, steps) {
  let layers, outcome, shot;
  let par = quantities__parameters_at(entry, geometry);
  if (effort__is_far(law, par)) {
    const found1 = layers__solve_layers(
      law,
      par,
      aim,
      NaN,
      capacity___tolerance(steps),
      guess.layers,
    );
    outcome = found1[0];
    layers = found1[1];
    shot = outcome === SOLVED ? layers__shot_of_layers(law, par, layers) : NO_SHOT;
    return [outcome, new Guess(NaN, layers), shot];
  }
  let z = guess.z === guess.z ? guess.z : effort__first_guess(law, par, aim);
  const found2 = search__refine(law, par, aim, z, steps);
  outcome = found2[0];
  z = found2[1];
  shot = found2[2];
  return [outcome, new Guess(z, guess.layers), shot];
}

/** `carry` of a long braking pulley: T1 is what its layers hand on, and sets only the kick. */
export function capacity___carry_far(law, geometry, tight, aim, steps) {
  let fixed, miss, new_, outcome, par;
  let t = 0.6 * tight;
  let mesh = MEET_STEPS;
  let t_last = 0.0;
  let miss_last = 0.0;
  let layers = NO_LAYERS;
  for (let each1 = 0, end1 = MOST_ROUNDS; each1 < end1; each1++) {
    par = quantities__parameters_at(t, geometry);
    const found2 = layers__solve_layers(law, par, aim, tight, capacity___tolerance(mesh), layers);
    outcome = found2[0];
    layers = found2[1];
    if (outcome !== SOLVED) {
      break;
    }
    miss = layers.entry_tension - t;
    fixed = geometry.kick_coefficient === 0.0;
    if (mesh === steps && (fixed || Math.abs(miss) < max(ALIKE, capacity___tolerance(mesh)) * t)) {
      t = layers.entry_tension;
      return [
        SOLVED,
        t,
        layers__shot_of_layers(law, quantities__parameters_at(t, geometry), layers),
      ];
    }
    if (mesh !== steps && (fixed || Math.abs(miss) < 0.0001 * t)) {
      mesh = steps;
      t = layers.entry_tension;
      t_last = 0.0;
      continue;
    }
    new_ = t + miss;
    if (t_last > 0.0 && miss !== miss_last) {
      new_ = t - (miss * (t - t_last)) / (miss - miss_last);
    }
    t_last = t;
    miss_last = miss;
    t = 0.0 < new_ && new_ <= tight ? new_ : t + miss;
  }
  return [UNSOLVED, t, NO_SHOT];
}

/** `carry` of a braking pulley where Newton's method fails: secants in ln T1, in a bracket. */
export function capacity___carry_bracketed(law, geometry, tight, aim, steps) {
  let f, outcome, shot;
  let radius = geometry.radius;
  let wrap = geometry.wrap_angle;
  let width = geometry.width;
  let goal = Math.log(tight);
  let t = goal;
  let t_last = goal;
  let f_last = 0.0;
  let slope = 1.0;
  let mesh = MEET_STEPS;
  let guess = new Guess(NaN, NO_LAYERS);
  let bottom = goal - gross_slip__plateau_capacity(law, tight / (width * radius), wrap) - 1.0;
  let low = bottom;
  let high = goal;
  for (let each1 = 0, end1 = 80; each1 < end1; each1++) {
    const found2 = capacity__carry_from(law, geometry, Math.exp(t), aim, guess, mesh);
    outcome = found2[0];
    guess = found2[1];
    shot = found2[2];
    if (outcome !== SOLVED) {
      return [outcome, guess.z, Math.exp(t), shot];
    }
    f = t + shot.log_tension - goal;
    if (mesh === steps && (Math.abs(f) < 1e-9 || high - low < 1e-13)) {
      return [Math.abs(f) < 1e-8 ? SOLVED : UNSOLVED, guess.z, Math.exp(t), shot];
    }
    if (t !== t_last) {
      slope = (f - f_last) / (t - t_last);
    }
    if (mesh !== steps && Math.abs(f) < 0.0001) {
      mesh = steps;
      low = bottom;
      high = goal;
      t_last = t;
      continue;
    }
    [low, high] = f > 0.0 ? [low, t] : [t, high];
    t_last = t;
    f_last = f;
    t = slope > 0.0 ? t - f / slope : NaN;
    if (!(low < t && t < high)) {
      t = 0.5 * (low + high);
    }
  }
  return [UNSOLVED, guess.z, Math.exp(t), shot];
}

/** Relative misses of the target and of the tension, for ln T1 = t and effort z. */
export function capacity___misses(law, geometry, case_, t, z, steps, table) {
  let miss, shot;
  let [aim, of_pull, tension] = case_;
  let par = quantities__parameters_at(Math.exp(t), geometry);
  let went = false;
  if (tension_table__applies(law, par)) {
    tension_table__open_table(law, par, 8.0, effort__mesh_steps(law, par, steps), table);
    const found1 = search__attempt(law, par, aim, z, steps, table);
    went = found1[0];
    miss = found1[1];
    shot = found1[2];
  }
  if (!went) {
    const found2 = search__attempt(law, par, aim, z, steps, zeros(0));
    miss = found2[1];
    shot = found2[2];
  }
  miss /= aim.value;
  if (!of_pull) {
    return [miss, t + shot.log_tension - Math.log(tension), shot];
  }
  let pull = par.entry_tension * Math.abs(1.0 - Math.exp(shot.log_tension));
  return [miss, Math.log(max(pull, 1e-9 * tension) / tension), shot];
}

/** Entry tension and effort that meet a target at the exit and a tension together. */
export function capacity__meet(law, geometry, aim, of_pull, tension, entry, z, most, steps) {
  let a1,
    a2,
    b1,
    b2,
    det,
    dt,
    dz,
    e1,
    e2,
    far,
    i,
    j11,
    j12,
    j21,
    j22,
    n1,
    n2,
    scale,
    shrunk,
    size,
    square;
  let t = Math.log(entry);
  j11 = j12 = j21 = j22 = 0.0;
  let fine = effort__mesh_steps(law, quantities__parameters_at(entry, geometry), steps);
  let table = zeros(tension_table__table_size(8.0, 2 * fine));
  let mesh = MEET_STEPS;
  let fresh = true;
  let case_ = [aim, of_pull, tension];
  const found1 = capacity___misses(law, geometry, case_, t, z, mesh, table);
  let r1 = found1[0];
  let r2 = found1[1];
  let shot = found1[2];
  for (let each2 = 0, end2 = MOST_ROUNDS; each2 < end2; each2++) {
    i = each2;
    size = max(Math.abs(r1), Math.abs(r2));
    if (i > SLOW_ROUNDS && size > 0.3) {
      break;
    }
    if (mesh === steps && size < TOLERANCE * 10.0) {
      det = j11 * j22 - j12 * j21;
      return [true, z, Math.exp(t), shot, det * (j11 > 0.0 ? 1.0 : -1.0)];
    }
    if (mesh < steps && size < 0.0003) {
      mesh = steps;
      const found3 = capacity___misses(law, geometry, case_, t, z, mesh, table);
      r1 = found3[0];
      r2 = found3[1];
      shot = found3[2];
      continue;
    }
    far = effort__jumps(law) ? max(1.0, Math.abs(z)) : 1.0;
    if (fresh) {
      dz = 0.0001 * far;
      dt = 0.0001;
      const found4 = capacity___misses(law, geometry, case_, t, z + dz, mesh, table);
      a1 = found4[0];
      a2 = found4[1];
      const found5 = capacity___misses(law, geometry, case_, t + dt, z, mesh, table);
      b1 = found5[0];
      b2 = found5[1];
      j11 = (a1 - r1) / dz;
      j21 = (a2 - r2) / dz;
      j12 = (b1 - r1) / dt;
      j22 = (b2 - r2) / dt;
    }
    det = j11 * j22 - j12 * j21;
    if (det === 0.0) {
      return [false, z, Math.exp(t), shot, 0.0];
    }
    dz = (r2 * j12 - r1 * j22) / det;
    dt = (r1 * j21 - r2 * j11) / det;
    scale = min(min(1.0, (1.5 * far) / max(Math.abs(dz), 1e-300)), 0.5 / max(Math.abs(dt), 1e-300));
    [dz, dt] = [scale * dz, scale * dt];
    [z, t] = [z + dz, t + dt];
    if (t > Math.log(most)) {
      return [false, z, Math.exp(t), shot, 0.0];
    }
    const found6 = capacity___misses(law, geometry, case_, t, z, mesh, table);
    n1 = found6[0];
    n2 = found6[1];
    shot = found6[2];
    shrunk = max(Math.abs(n1), Math.abs(n2)) < 0.3 * size;
    fresh = mesh < steps && !shrunk;
    square = dz * dz + dt * dt;
    if (square > 0.0) {
      e1 = (n1 - r1 - j11 * dz - j12 * dt) / square;
      e2 = (n2 - r2 - j21 * dz - j22 * dt) / square;
      [j11, j12] = [j11 + e1 * dz, j12 + e1 * dt];
      [j21, j22] = [j21 + e2 * dz, j22 + e2 * dt];
    }
    r1 = n1;
    r2 = n2;
  }
  return [false, z, Math.exp(t), shot, 0.0];
}

/** Largest tension ratio of a held tight side at which a target of creep or slip is met. */
export function capacity__carry(law, geometry, tight, aim, z, steps) {
  let entry, guess, met, outcome, shot, z_met;
  if (geometry.side > 0.0) {
    const found1 = capacity__carry_from(law, geometry, tight, aim, new Guess(z, NO_LAYERS), steps);
    outcome = found1[0];
    guess = found1[1];
    shot = found1[2];
    return [outcome, guess.z, tight, shot];
  }
  let par = quantities__parameters_at(0.6 * tight, geometry);
  if (effort__is_far(law, par)) {
    const found2 = capacity___carry_far(law, geometry, tight, aim, steps);
    outcome = found2[0];
    entry = found2[1];
    shot = found2[2];
    if (outcome === SOLVED) {
      return [outcome, NaN, entry, shot];
    }
    return capacity___carry_bracketed(law, geometry, tight, aim, steps);
  }
  let first = z === z ? z : effort__first_guess(law, par, aim);
  const found3 = capacity__meet(
    law,
    geometry,
    aim,
    false,
    tight,
    0.6 * tight,
    first,
    4.0 * tight,
    steps,
  );
  met = found3[0];
  z_met = found3[1];
  entry = found3[2];
  shot = found3[3];
  if (met && entry <= tight) {
    return [SOLVED, z_met, entry, shot];
  }
  return capacity___carry_bracketed(law, geometry, tight, aim, steps);
}

/** Largest tight-side tension that is looked at [N]: that of the largest tested pressure. */
export function least_slack__highest_tight(pressure_max, area, tight) {
  return pressure_max === pressure_max ? pressure_max * area : HIGHEST * tight;
}

/** Pull carried at a creep limit with a held entry tension [N], and what to go on from. */
export function least_slack___pull(law, geometry, entry, limit, guess, steps) {
  let shot;
  const found1 = capacity__carry_from(law, geometry, entry, new Aim(CREEP, limit), guess, steps);
  guess = found1[1];
  shot = found1[2];
  return [entry * Math.abs(1.0 - Math.exp(shot.log_tension)), guess];
}

/** ln(entry tension) up to `top` of the largest pull at a creep limit, the pull [N], a guess. */
export function least_slack___most(law, geometry, limit, enough, top, p_top, guess) {
  let p_c, p_d;
  const found1 = least_slack___pull(law, geometry, Math.exp(top - 0.02), limit, guess, MEET_STEPS);
  let p_in = found1[0];
  let guess_in = found1[1];
  if (p_in <= p_top) {
    return [top, p_top, guess];
  }
  let low = top - 3.0;
  let high = top;
  let p_low = -Infinity;
  let p_high = p_top;
  let d = low + GOLDEN * (high - low);
  const found2 = least_slack___pull(law, geometry, Math.exp(d), limit, guess_in, MEET_STEPS);
  p_d = found2[0];
  guess = found2[1];
  let c = high - GOLDEN * (high - low);
  const found3 = least_slack___pull(law, geometry, Math.exp(c), limit, guess, MEET_STEPS);
  p_c = found3[0];
  guess = found3[1];
  while (high - low > NEAR_TOP && max(p_c, p_d) < enough) {
    if (p_c >= p_d) {
      [high, p_high, d, p_d] = [d, p_d, c, p_c];
      c = high - GOLDEN * (high - low);
      const found4 = least_slack___pull(law, geometry, Math.exp(c), limit, guess, MEET_STEPS);
      p_c = found4[0];
      guess = found4[1];
    } else {
      [low, p_low, c, p_c] = [c, p_c, d, p_d];
      d = low + GOLDEN * (high - low);
      const found5 = least_slack___pull(law, geometry, Math.exp(d), limit, guess, MEET_STEPS);
      p_d = found5[0];
      guess = found5[1];
    }
  }
  let [t, p_t] = p_c >= p_d ? [c, p_c] : [d, p_d];
  if (p_t >= enough || p_low === -Infinity) {
    return [t, p_t, guess];
  }
  let [left, right] = t === c ? [low, d] : [c, high];
  let [p_left, p_right] = t === c ? [p_low, p_d] : [p_c, p_high];
  let rise = (p_t - p_left) / (t - left);
  let fall = (p_right - p_t) / (right - t);
  let v = 0.5 * (left + t) + (0.5 * (right - left) * rise) / (rise - fall);
  const found6 = least_slack___pull(law, geometry, Math.exp(v), limit, guess, MEET_STEPS);
  let p_v = found6[0];
  let guess_v = found6[1];
  return p_v > p_t ? [v, p_v, guess_v] : [t, p_t, guess];
}

/** Bracket of ln(entry tension) around a pull, from where more is carried downwards. */
export function least_slack___down(law, geometry, pull, limit, high, p_high, guess) {
  let floor = geometry.side > 0.0 ? Math.log(pull) : -Infinity;
  let low = high;
  let p_low = p_high;
  let step = Infinity;
  let slope = 1.0;
  while (p_low >= pull) {
    step = min((1.2 * Math.log(p_low / pull)) / slope + 0.02, 2.0 * step);
    [high, p_high, low] = [low, p_low, low - step];
    if (low <= floor) {
      return [floor, 0.5 * pull, high, p_high, guess];
    }
    const found1 = least_slack___pull(law, geometry, Math.exp(low), limit, guess, MEET_STEPS);
    p_low = found1[0];
    guess = found1[1];
    if (p_low >= pull) {
      slope = max(min(Math.log(p_high / p_low) / step, 1.0), 0.001);
    }
  }
  return [low, p_low, high, p_high, guess];
}

/** ln(entry tension) at which a pull is carried, by secants on the fine mesh; nan if not met. */
export function least_slack___pull_closed(law, geometry, pull, limit, near, guess, steps) {
  let f, f_last, i, p, t_last;
  let [t, slope] = near;
  t_last = f_last = 0.0;
  for (let each1 = 0, end1 = 12; each1 < end1; each1++) {
    i = each1;
    const found2 = least_slack___pull(law, geometry, Math.exp(t), limit, guess, steps);
    p = found2[0];
    guess = found2[1];
    f = Math.log(max(p, 1e-9 * pull) / pull);
    if (Math.abs(f) < PULL_TOLERANCE) {
      return t;
    }
    if (i > 0 && t !== t_last) {
      slope = (f - f_last) / (t - t_last);
    }
    if (slope <= 0.0 || Math.abs(f) > slope) {
      break;
    }
    [t_last, f_last, t] = [t, f, t - f / slope];
  }
  return NaN;
}

/** `least_slack` where Newton's method fails: the pull rises with tension to a largest one. */
export function least_slack___least_bracketed(law, geometry, pull, limit, tight_max, steps) {
  let f, low, p, p_low, t;
  let aim = new Aim(CREEP, limit);
  const found1 = capacity__carry(law, geometry, tight_max, aim, NaN, MEET_STEPS);
  let z = found1[1];
  let entry = found1[2];
  let shot = found1[3];
  let guess = new Guess(z, NO_LAYERS);
  let high = Math.log(entry);
  let p_high = entry * Math.abs(1.0 - Math.exp(shot.log_tension));
  if (p_high < pull) {
    const found2 = least_slack___most(law, geometry, limit, pull, high, p_high, guess);
    high = found2[0];
    p_high = found2[1];
    guess = found2[2];
  }
  if (p_high < pull) {
    if (high < Math.log(entry)) {
      return [NaN, least_slack___pull(law, geometry, Math.exp(high), limit, guess, steps)[0]];
    }
    shot = capacity__carry(law, geometry, tight_max, aim, guess.z, steps)[3];
    return [NaN, tight_max * (1.0 - Math.exp(-Math.abs(shot.log_tension)))];
  }
  const found3 = least_slack___down(law, geometry, pull, limit, high, p_high, guess);
  low = found3[0];
  p_low = found3[1];
  high = found3[2];
  p_high = found3[3];
  guess = found3[4];
  if (p_low !== p_low) {
    return [NaN, NaN];
  }
  let f_low = Math.log(max(p_low, 1e-9 * pull) / pull);
  let f_high = Math.log(p_high / pull);
  let side = 0;
  let slope = 1.0;
  let t_last = high;
  let f_last = f_high;
  for (let each4 = 0, end4 = 40; each4 < end4; each4++) {
    t = (low * f_high - high * f_low) / (f_high - f_low);
    const found5 = least_slack___pull(law, geometry, Math.exp(t), limit, guess, MEET_STEPS);
    p = found5[0];
    guess = found5[1];
    f = Math.log(max(p, 1e-9 * pull) / pull);
    if (t !== t_last) {
      slope = (f - f_last) / (t - t_last);
    }
    if (Math.abs(f) < 0.001) {
      break;
    }
    if (f > 0.0) {
      f_low *= side > 0 ? 0.5 : 1.0;
      high = t;
      f_high = f;
      side = 1;
    } else {
      f_high *= side < 0 ? 0.5 : 1.0;
      low = t;
      f_low = f;
      side = -1;
    }
    t_last = t;
    f_last = f;
  }
  t = least_slack___pull_closed(law, geometry, pull, limit, [t, slope], guess, steps);
  return [geometry.side > 0.0 ? Math.exp(t) - pull : Math.exp(t), NaN];
}

/** Least slack-side tension that carries a pull within a creep limit. */
export function least_slack__least_slack(
  law,
  geometry,
  pull,
  limit,
  tight,
  entry,
  z,
  tight_max,
  steps,
) {
  let found;
  if (z !== z) {
    return least_slack___least_bracketed(law, geometry, pull, limit, tight_max, steps);
  }
  const found1 = capacity__meet(
    law,
    geometry,
    new Aim(CREEP, limit),
    true,
    pull,
    entry,
    z,
    1.5 * tight_max,
    steps,
  );
  let met = found1[0];
  let entry_met = found1[2];
  let shot = found1[3];
  let growth = found1[4];
  if (met && growth > 0.0) {
    found = max(entry_met, entry_met * Math.exp(shot.log_tension));
    if (found <= tight_max) {
      return [found - pull, NaN];
    }
  }
  return least_slack___least_bracketed(law, geometry, pull, limit, tight_max, steps);
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
    start = Math.abs(geometry.kick + geometry.kick_coefficient * p * Math.sqrt(p));
    if (compact__excess_at(law, segment, p) + start * compact__residual_at(law, segment, p) > 0.0) {
      return true;
    }
  }
  return false;
}

/** `table` opened for marches in tension, or none where they do not apply. */
export function gross_slip___opened(law, par, steps, table) {
  if (!tension_table__applies(law, par)) {
    return zeros(0);
  }
  tension_table__open_table(law, par, 8.0, effort__mesh_steps(law, par, steps), table);
  return table;
}

/** Largest ln(tight/slack) over effort, the creep there [m] and the effort. */
export function gross_slip___peak_of(law, par, near, steps, table) {
  let at, best, buffer, coarse, end, i, left, near_end, parts, right, shot, span, value;
  let top = effort__largest_effort(law, par);
  let low = effort__jumps(law) ? 0.0 : effort__effort_of(par, par.side * 1e-5);
  let high = top;
  let z = near;
  let reach = 0.02;
  if (near === -Infinity) {
    coarse = min(PEAK_STEPS, steps);
    buffer = gross_slip___opened(law, par, coarse, table);
    parts = 8;
    best = -Infinity;
    at = 0;
    for (let each1 = 0, end1 = parts + 1; each1 < end1; each1++) {
      i = each1;
      z = low + ((high - low) * i) / parts;
      const found2 = search__carried_ratio(law, par, z, coarse, buffer);
      value = found2[0];
      if (value > best) {
        best = value;
        at = i;
      }
    }
    span = (high - low) / parts;
    [low, high] = [low + span * max(at - 1, 0), low + span * min(at + 1, parts)];
    const found3 = search__climb(law, par, low, high, 0.01, coarse, buffer);
    z = found3[0];
    shot = found3[1];
    const found4 = search__carried_ratio(law, par, high, coarse, buffer);
    value = found4[0];
    if (value > effort__value_of(par, shot, TENSION)) {
      z = high;
    }
    reach = 0.03;
  }
  buffer = gross_slip___opened(law, par, steps, table);
  const found5 = search__carried_ratio(law, par, high, steps, buffer);
  best = found5[0];
  shot = found5[1];
  if (z < high) {
    end = best;
    near_end = shot;
    left = right = z;
    while (!(left < z - EDGE || left === low) || !(z + EDGE < right || right === high)) {
      left = max(low, z - reach);
      right = min(high, z + reach);
      const found6 = search__climb(law, par, left, right, 0.0002, steps, buffer);
      z = found6[0];
      shot = found6[1];
      reach *= 4.0;
    }
    best = effort__value_of(par, shot, TENSION);
    if (end > best) {
      best = end;
      shot = near_end;
      z = high;
    }
  }
  return [best, par.side * shot.creep, z];
}

/** Entry tension of a braking pulley that carries `tight` at an effort, and ln(T2/T1). */
export function gross_slip___entry_at(law, geometry, tight, z, entry, ratio, steps, table) {
  let i, miss, new_, par, t, t_last;
  t = t_last = Math.log(entry);
  let miss_last = 0.0;
  for (let each1 = 0, end1 = 8; each1 < end1; each1++) {
    i = each1;
    miss = Math.log(tight) - ratio - t;
    if (Math.abs(miss) < 1e-9) {
      break;
    }
    new_ = t + miss;
    if (i > 0 && miss !== miss_last) {
      new_ = t - (miss * (t - t_last)) / (miss - miss_last);
    }
    [t_last, miss_last, t] = [t, miss, new_];
    par = quantities__parameters_at(Math.exp(t), geometry);
    const found2 = search__carried_ratio(
      law,
      par,
      z,
      steps,
      gross_slip___opened(law, par, steps, table),
    );
    ratio = found2[0];
  }
  return [Math.exp(t), ratio];
}

/** Largest ln(tight/slack) of a held tight side over entry creep ratios below 1, and the creep. */
export function gross_slip___largest_over_effort(law, geometry, tight, guess, steps) {
  let change, done, new_;
  let side = geometry.side;
  let fine = effort__mesh_steps(law, quantities__parameters_at(tight, geometry), steps);
  let table = zeros(tension_table__table_size(8.0, 2 * fine));
  let entry = side > 0.0 ? tight : tight * Math.exp(-guess);
  let coarse = min(PEAK_STEPS, steps);
  let mesh = side > 0.0 ? steps : coarse;
  let best = guess;
  let creep = 0.0;
  let z = -Infinity;
  let before = Infinity;
  for (let each1 = 0, end1 = 40; each1 < end1; each1++) {
    const found2 = gross_slip___peak_of(
      law,
      quantities__parameters_at(entry, geometry),
      z,
      mesh,
      table,
    );
    new_ = found2[0];
    creep = found2[1];
    z = found2[2];
    [change, best] = [Math.abs(new_ - best), new_];
    done = change < 1e-8 || (before < 1e-5 && change > 0.5 * before);
    if (side > 0.0 || (mesh === steps && done)) {
      break;
    }
    before = change;
    if (mesh !== steps && change < 0.01) {
      mesh = steps;
      before = Infinity;
    }
    const found3 = gross_slip___entry_at(law, geometry, tight, z, entry, best, mesh, table);
    entry = found3[0];
    best = found3[1];
  }
  return [best, creep];
}

/** Gross-slip capacity of a held tight side: ln(tight/slack), and the exit creep there [m]. */
export function gross_slip__largest_ratio(law, geometry, tight, softening, steps) {
  let radius = geometry.radius;
  let wrap = geometry.wrap_angle;
  let width = geometry.width;
  let pressure = tight / (width * radius);
  if (!softening) {
    return [gross_slip__plateau_capacity(law, pressure, wrap), Infinity];
  }
  let residual = gross_slip__residual_capacity(law, pressure, wrap);
  if (!gross_slip__outweighs(law, geometry, tight, residual)) {
    return [residual, Infinity];
  }
  let most = gross_slip__plateau_capacity(law, pressure, wrap);
  const found1 = gross_slip___largest_over_effort(law, geometry, tight, most, steps);
  let best = found1[0];
  let creep = found1[1];
  return best > residual ? [best, creep] : [residual, Infinity];
}

/** `find_capacities` where it is known about where they are. */
export function answer__find_capacities_near(law, geometry, load, parts, steps, begin) {
  let by_creep, by_slip, entry, gross, gross_creep, least, most, outcome, shot, softening, top, z;
  let tight = max(load.entry_tension, load.exit_tension);
  let pull = Math.abs(load.entry_tension - load.exit_tension);
  by_creep = by_slip = gross = gross_creep = least = most = NaN;
  if (parts & (2 + LEAST)) {
    const found1 = capacity__carry(
      law,
      geometry,
      tight,
      new Aim(CREEP, load.creep_limit),
      begin.creep_limit,
      steps,
    );
    outcome = found1[0];
    z = found1[1];
    entry = found1[2];
    shot = found1[3];
    if (outcome === SOLVED) {
      by_creep = Math.abs(shot.log_tension);
    }
    if (parts & LEAST && outcome === SOLVED && pull > 1e-6 * tight) {
      top = least_slack__highest_tight(load.pressure_max, geometry.width * geometry.radius, tight);
      if (z === z && begin.entry === begin.entry) {
        entry = begin.entry;
        z = begin.least;
      }
      const found2 = least_slack__least_slack(
        law,
        geometry,
        pull,
        load.creep_limit,
        tight,
        entry,
        z,
        top,
        steps,
      );
      least = found2[0];
      most = found2[1];
    }
  }
  if (parts & TESTED_SLIP && load.slip_max === load.slip_max) {
    const found3 = capacity__carry(
      law,
      geometry,
      tight,
      new Aim(SLIP, load.slip_max),
      begin.tested_slip,
      steps,
    );
    outcome = found3[0];
    shot = found3[3];
    if (outcome === SOLVED) {
      by_slip = Math.abs(shot.log_tension);
    }
  }
  if (parts & GROSS_SLIP) {
    softening = load.steepest_fall < 0.0;
    const found4 = gross_slip__largest_ratio(law, geometry, tight, softening, steps);
    gross = found4[0];
    gross_creep = found4[1];
    if (gross_creep <= load.creep_limit) {
      by_creep = gross;
    }
    if (gross_creep <= load.slip_max) {
      by_slip = gross;
    }
  }
  return new Carried(by_creep, by_slip, gross, gross_creep, least, most);
}

/** Capacities that are asked for by `parts`. */
export function answer__find_capacities(law, geometry, load, parts, steps) {
  return answer__find_capacities_near(law, geometry, load, parts, steps, NO_BEGINNING);
}

/** Slack-side tension over effective tension, Cw = 1/(exp(mu phi) - 1) (CEMA) [-]. */
export function constant_friction__wrap_factor(friction, wrap_angle) {
  return 1.0 / Math.expm1(friction * wrap_angle);
}

/** Slack-side tension by a wrap factor, Cw times the pull that is designed for [N]. */
export function numbers__asked_slack(factor, start, pull) {
  return factor * start * Math.abs(pull);
}

/** What the checks of an arc allow. */
export function in_page__limits_of(given, arc, tested, criteria) {
  let high, low, slip;
  low = high = slip = NaN;
  if (tested !== null) {
    low = tested.pressure_min;
    high = tested.pressure_max;
    slip = tested.slip_max;
  }
  let pull = arc.entry_tension - arc.exit_tension;
  let factor = criteria.factor;
  if (factor !== factor) {
    factor = constant_friction__wrap_factor(criteria.standard, arc.wrap_angle);
  }
  return new Compared(
    criteria.safety,
    numbers__asked_slack(factor, criteria.start, pull),
    given.creep_limit,
    criteria.belt_tension * arc.width,
    criteria.belt_tension * arc.width,
    criteria.face_pressure,
    criteria.bond_strength,
    criteria.fatigue_limit,
    high,
    low,
    slip,
    criteria.slip_speed,
    criteria.balance,
    criteria.sag,
    criteria.pulley_diameter,
  );
}

/** Largest ln(tight/slack) before the belt slides with a tight side held [N], and the cause. */
export function sliding__carried_at(of, tight) {
  let driving = of.geometry.side > 0.0;
  let load = Object.assign(Object.create(Object.getPrototypeOf(of.load)), of.load, {
    entry_tension: driving ? tight : 0.5 * tight,
    exit_tension: driving ? 0.5 * tight : tight,
    creep_limit: SLIDES,
  });
  let pressure = tight / (of.geometry.width * of.geometry.radius);
  let most = gross_slip__plateau_capacity(of.law, pressure, of.geometry.wrap_angle);
  let friction = compact__plateau_at(of.law, compact__segment_of(of.law, pressure), pressure);
  let at_end = load.slip_max + of.geometry.shear * friction * pressure;
  let parts = BY_CREEP + BY_SLIP + (of.peaks ? BY_LAW : 0);
  if (!of.peaks && at_end < _FIRST * SLIDES) {
    parts = BY_SLIP;
  }
  let found = answer__find_capacities(of.law, of.geometry, load, parts, _STEPS);
  let q = found.creep_limit;
  let cause = 0;
  if (Number.isNaN(q) || found.tested_slip < q * (1.0 - _ALIKE)) {
    q = found.tested_slip;
    cause = TESTED;
  }
  if (q >= most * (1.0 - _ALIKE) || (of.peaks && q >= found.gross_slip * (1.0 - _ALIKE))) {
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
  let there = gross_slip__plateau_capacity(of.law, (tight * (1.0 + _DIFFERENCE)) / area, wrap);
  let fall = (((there - here) / (here * _DIFFERENCE)) * k * line.tight_rise) / tight;
  let grows = (k * (line.tight_rise / tight - line.slack_rise / slack)) / asked;
  return [Math.log(k), Math.log(q / asked), fall - grows];
}

/** A step to `new`, kept between the ends. */
export function sliding___within(ends, new_, k) {
  new_ = min(new_, _FARTHEST);
  if (ends.low < new_ && new_ < ends.high) {
    return new_;
  }
  return ends.high < Infinity ? 0.5 * (ends.low + ends.high) : min(4.0 * k + 1.0, _FARTHEST);
}

/** Place k of a line at which the belt begins to slide (way 1) or ends to (way -1). */
export function sliding__slide_place(of, line, way, low, start) {
  let at, new_, q, slope, spare;
  let falls = line.slack_rise < 0.0;
  let even = falls || way < 0.0;
  let ends = new Ends(low, falls ? 1.0 - line.slack / line.slack_rise : Infinity);
  let k = start >= ends.high ? 0.5 * (ends.low + ends.high) : start;
  let last = NaN;
  let spare_last = NaN;
  let cause = 0;
  for (let each1 = 0, end1 = _ROUNDS; each1 < end1; each1++) {
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
      ends = new Ends(ends.low, k);
    } else if (k >= _FARTHEST) {
      return new Sliding(Infinity, cause);
    } else {
      ends = new Ends(k, ends.high);
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
export function sliding__pull_at_sliding(of, line) {
  if (line.tight === line.slack) {
    return new Sliding(Infinity, 0);
  }
  return sliding__slide_place(of, line, 1.0, 0.0, 1.0);
}

/** Pressure of the belt on the pulley, 2 T/(B D) [Pa]. */
export function numbers__wrap_pressure_of(tension, width, diameter) {
  return (2.0 * tension) / (width * diameter);
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

/** Largest change of the slip per length of arc [-]; nan without a stretch of arc. */
export function numbers__steepest(position, slip, count, radius, length) {
  let change, i, step;
  let found = NaN;
  let least = 1e-9 * length;
  for (let each1 = 1, end1 = count; each1 < end1; each1++) {
    i = each1;
    step = (position[i] - position[i - 1]) * radius;
    if (step > least) {
      change = Math.abs(slip[i] - slip[i - 1]) / step;
      if (!(change <= found)) {
        found = change;
      }
    }
  }
  return found;
}

/** Miss of the energy balance, of an idle pulley relative to the strain of the belt [-]. */
export function numbers__balance_miss(error, pull, g, entry, compliance) {
  let exact = Math.abs(pull * (g + 0.5 * pull * compliance));
  let told = max(max(exact, 1e-6 * entry * Math.abs(g)), 1e-300);
  let scale = max(exact, 1e-6 * entry * (Math.abs(g) + entry * compliance));
  return scale > 0.0 ? (Math.abs(error) * told) / scale : 0.0;
}

/** How often the pulley turns in an hour [-]. */
export function numbers__passes_an_hour(speed, diameter) {
  return (3600.0 * speed) / (3.141592653589793 * diameter);
}

/** Capacities and margins of an arc with its tensions [N] and its wrap angle [rad]. */
export function summary__capacity_numbers(entry, leaving, wrap_angle, carried) {
  let actual = max(entry, leaving) / min(entry, leaving);
  let creep = Math.exp(carried.creep_limit);
  let slip = Math.exp(carried.tested_slip);
  let gross = Math.exp(carried.gross_slip);
  return new CapacityNumbers(
    creep,
    creep / actual,
    Math.log(creep) / wrap_angle,
    carried.least_slack,
    carried.most_pull,
    slip,
    slip / actual,
    gross,
    gross / actual,
    carried.gross_creep,
  );
}

/** Slip at the exit with a tension of the tight side [m]; inf where it is not carried. */
export function least_numbers___slips(law, geometry, pull, tight) {
  let entry = geometry.side > 0.0 ? tight : tight - pull;
  let leaving = geometry.side > 0.0 ? tight - pull : tight;
  let found = answer__solve_tension(
    law,
    quantities__parameters_at(entry, geometry),
    leaving,
    _STEPS,
  );
  return found.outcome === SOLVED ? Math.abs(found.shot.slip) : Infinity;
}

export function least_numbers___by_halving(law, geometry, of, limit) {
  let middle;
  let low = of.pull * (1.0 + 1e-6);
  let high = of.top;
  if (low >= high || least_numbers___slips(law, geometry, of.pull, high) > limit) {
    return Infinity;
  }
  while (high - low > 1e-6 * high) {
    middle = 0.5 * (low + high);
    if (least_numbers___slips(law, geometry, of.pull, middle) > limit) {
      low = middle;
    } else {
      high = middle;
    }
  }
  return high - of.pull;
}

/** Least slack-side tension with which the slip at the exit keeps a limit [N]; inf if none. */
export function least_numbers__least_for_slip(law, geometry, of, limit) {
  let found, growth, met, shot;
  const found1 = capacity__carry(law, geometry, of.tight, new Aim(SLIP, limit), NaN, _STEPS);
  let outcome = found1[0];
  let z = found1[1];
  let entry = found1[2];
  if (outcome === SOLVED) {
    const found2 = capacity__meet(
      law,
      geometry,
      new Aim(SLIP, limit),
      true,
      of.pull,
      entry,
      z,
      1.5 * of.top,
      _STEPS,
    );
    met = found2[0];
    entry = found2[2];
    shot = found2[3];
    growth = found2[4];
    found = max(entry, entry * Math.exp(shot.log_tension));
    if (met && growth > 0.0 && found <= of.top) {
      return found - of.pull;
    }
  }
  return least_numbers___by_halving(law, geometry, of, limit);
}

/** Least tension of the tight side with which a pull does not slide the belt [N]; inf if none. */
export function sliding__tight_at_sliding(of, pull) {
  if (pull <= 0.0) {
    return 0.0;
  }
  let tight = max(of.load.entry_tension, of.load.exit_tension);
  let line = new Line(pull, 0.0, pull, pull);
  return pull * sliding__slide_place(of, line, -1.0, 1.0, max(tight / pull, 1.0 + 1e-6)).place;
}

/** How much all tensions must rise for a safety factor against sliding [N]. */
export function sliding__lift_for_safety(of, factor, tight_rise) {
  let tight = max(of.load.entry_tension, of.load.exit_tension);
  let pull = Math.abs(of.load.entry_tension - of.load.exit_tension);
  return sliding__tight_at_sliding(of, factor * pull) - tight - (factor - 1.0) * tight_rise;
}

/** What the checks of an arc ask of the take-up, its pull held. */
export function in_page__asked_of(loaded, arc, least, limits, given, factor, among) {
  let entry = arc.entry_tension;
  let leaving = arc.exit_tension;
  let end = among.end;
  let tight = max(entry, leaving);
  let slack = min(entry, leaving);
  let area = arc.width * (0.5 * arc.diameter);
  let top = least_slack__highest_tight(limits.tested_pressure_max, area, tight);
  let of = new Pull(Math.abs(entry - leaving), tight, top);
  let by_slip = NaN;
  if (limits.tested_slip < given.creep_limit) {
    by_slip = least_numbers__least_for_slip(loaded.law, loaded.geometry, of, limits.tested_slip);
  }
  let lift = sliding__lift_for_safety(loaded, factor, among.tight_rise);
  return new Asked(
    end - slack + (least === least ? least : Infinity),
    end - slack + by_slip,
    end - slack + limits.design_standard,
    end + (lift === lift ? lift : Infinity),
    end - slack + limits.tested_pressure_min * area,
    end - tight + limits.tested_pressure_max * area,
    end - tight + limits.face_pressure * area,
    end - tight + limits.belt_tension,
    limits.sag + end - among.slack_end,
    end,
  );
}

/** Creep at the exit with a factor on the friction [m]; inf in gross slip, nan without a factor. */
export function sliding__wet_creep(of, factor) {
  if (Number.isNaN(factor)) {
    return NaN;
  }
  let g = of.geometry;
  let wet = Object.assign(Object.create(Object.getPrototypeOf(g)), g, {
    wrap_angle: factor * g.wrap_angle,
    compliance: g.compliance / factor,
    shear: factor * g.shear,
  });
  let found = answer__answer(of.law, wet, of.load, _STEPS);
  return found.outcome === SOLVED ? Math.abs(found.shot.creep) : Infinity;
}

/** Numbers of the checks of one arc; None where they are for the server to find. */
export function in_page__judged(law, given, tested, criteria, points, among = null) {
  let arc = in_page__description_of(given);
  let others = among === null ? in_page__alone(arc, criteria) : among;
  let entry = arc.entry_tension;
  let leaving = arc.exit_tension;
  if (in_page__refused(law, arc, given.steepest_fall) || numbers__idles(entry, leaving)) {
    return null;
  }
  if (given.creep_limit === CREEP_LIMIT) {
    if (!criteria.customary) {
      return null;
    }
  } else if (criteria.customary) {
    return null;
  }
  if (criteria.wrap_angle === criteria.wrap_angle && arc.wrap_angle !== criteria.wrap_angle) {
    return null;
  }
  if (!numbers__usual_sizes(given.width, given.modulus, given.speed, given.diameter)) {
    return null;
  }
  if (!(numbers__usual_tension(entry, arc.width) && numbers__usual_tension(leaving, arc.width))) {
    return null;
  }
  let geometry = summary__geometry_of(arc, law.onset_compliance);
  let load = in_page__load_of(given, arc, tested);
  const found1 = summary__operating_point(law, geometry, load, STEPS, points);
  let found = found1[0];
  let out = found1[1];
  let count = found1[2];
  if (!(found.outcome === SOLVED || found.outcome === BREAKAWAY)) {
    return null;
  }
  let profile = summary__columns_of(law, arc, found, out, count);
  let summary = summary__summary_of(law, arc, tested, found, out, count);
  let carried = answer__find_capacities(law, geometry, load, CAPACITIES, STEPS);
  let solved = found.outcome === SOLVED;
  let limits = in_page__limits_of(given, arc, tested, criteria);
  let loaded = new Loaded(
    law,
    geometry,
    load,
    given.steepest_fall < 0.0 && carried.gross_creep !== Infinity,
  );
  let tight = max(entry, leaving);
  let slack = min(entry, leaving);
  let sliding = sliding__pull_at_sliding(
    loaded,
    new Line(tight, slack, others.tight_rise, others.slack_rise),
  );
  if (sliding.place !== sliding.place) {
    return null;
  }
  let values = new Compared(
    solved ? sliding.place : min(sliding.place, NOT_CARRIED),
    min(entry, leaving),
    Math.abs(summary.exit_creep),
    max(entry, leaving),
    max(entry, leaving),
    numbers__wrap_pressure_of(max(entry, leaving), arc.width, arc.diameter),
    summary.peak_shear_stress,
    summary.peak_shear_stress,
    numbers__wrap_pressure_of(max(entry, leaving), arc.width, arc.diameter),
    numbers__wrap_pressure_of(min(entry, leaving), arc.width, arc.diameter),
    numbers__largest(profile.slip, count),
    arc.belt_speed *
      numbers__steepest(
        profile.position,
        profile.slip,
        count,
        geometry.radius,
        geometry.radius * arc.wrap_angle,
      ),
    numbers__balance_miss(
      summary.identity_error,
      summary.effective_tension,
      summary.entry_creep_ratio,
      entry,
      geometry.compliance,
    ),
    others.sagging,
    arc.diameter,
    (100.0 * max(entry, leaving)) / (criteria.rating * arc.width),
    numbers__passes_an_hour(arc.belt_speed, arc.diameter),
  );
  return new Judged(
    solved,
    summary,
    summary__capacity_numbers(entry, leaving, arc.wrap_angle, carried),
    values,
    limits,
    others.held,
    in_page__asked_of(loaded, arc, carried.least_slack, limits, given, criteria.safety, others),
    sliding.cause,
    criteria.wet !== 0.0 ? sliding__wet_creep(loaded, criteria.wet) : -1.0,
  );
}

/** How many quantities are given that fix the effective tension. */
export function pulls__pulls(of) {
  let count = of.effective_tension === of.effective_tension ? 1 : 0;
  count += of.torque === of.torque ? 1 : 0;
  return count + (of.power === of.power ? 1 : 0);
}

/** How many independent quantities are given. */
export function pulls__families(of) {
  let count = of.entry_tension === of.entry_tension ? 1 : 0;
  count += of.exit_tension === of.exit_tension ? 1 : 0;
  return count + (pulls__pulls(of) > 0 ? 1 : 0);
}

/** Effective tension that is given, nan where it is not [N]. */
export function pulls__pull_given(of, diameter, speed) {
  if (of.effective_tension === of.effective_tension) {
    return of.effective_tension;
  }
  if (of.torque === of.torque) {
    return load_case__pull_of_torque(of.torque, diameter);
  }
  return load_case__pull_of_power(of.power, speed);
}

/** Sum of the tensions that are given, nan where they are not [N]. */
export function pulls__both_tensions(of, diameter, speed) {
  let pull = pulls__pull_given(of, diameter, speed);
  let entry = of.entry_tension;
  let leaving = of.exit_tension;
  let first = entry === entry ? entry : leaving + pull;
  return first + (leaving === leaving ? leaving : entry - pull);
}

/** Tensions of a pulley with those of a load case put over them. */
export function pulls__overridden(of, over, fixed, diameter, speed) {
  let both;
  if (pulls__families(over) >= 2) {
    return over;
  }
  let pull = pulls__pull_given(over, diameter, speed);
  if (fixed && pull === pull && pulls__pulls(over) === 1) {
    both = pulls__both_tensions(of, diameter, speed);
    if (both !== both) {
      return over;
    }
    return new Pulls(0.5 * both + 0.5 * pull, 0.5 * both - 0.5 * pull, NaN, NaN, NaN);
  }
  let entry = over.entry_tension;
  let leaving = over.exit_tension;
  let taken = pulls__pulls(over) > 0;
  return new Pulls(
    entry === entry ? entry : of.entry_tension,
    leaving === leaving ? leaving : of.exit_tension,
    taken ? over.effective_tension : of.effective_tension,
    taken ? over.torque : of.torque,
    taken ? over.power : of.power,
  );
}

/** What is wrong with the tensions that are given; 0 where nothing is. */
export function pulls__fault_of(of, speed) {
  if (pulls__pulls(of) > 1) {
    return SEVERAL_PULLS;
  }
  if (pulls__families(of) > 2) {
    return ALL_THREE;
  }
  if (pulls__families(of) < 2) {
    return TOO_FEW;
  }
  return of.power === of.power && speed !== speed ? NO_SPEED : 0;
}

/** Entry and exit tension of an arc by its numbers [N]. */
export function in_page__described(given) {
  let arc = in_page__description_of(given);
  return [arc.entry_tension, arc.exit_tension];
}

/** Why the page cannot judge an arc; 0 where it can. */
export function in_page__unjudged(law, given) {
  let arc = in_page__description_of(given);
  if (in_page__refused(law, arc, given.steepest_fall)) {
    return 1;
  }
  if (numbers__idles(arc.entry_tension, arc.exit_tension)) {
    return 2;
  }
  let sizes = numbers__usual_sizes(given.width, given.modulus, given.speed, given.diameter);
  let usual = numbers__usual_tension(arc.entry_tension, arc.width);
  return sizes && usual && numbers__usual_tension(arc.exit_tension, arc.width) ? 0 : UNUSUAL;
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

/** Whether a value that misses its limit fails: nan where it never does. */
export function numbers__beyond(value, fails, at_most) {
  return at_most ? value > fails : value < fails;
}

/** Whether one take-up can hold both tensions. */
export function numbers__held_alike(least, most) {
  return most - least <= HELD * most;
}

/** Whether two numbers are equal in the four digits they are compared in. */
export function numbers__same_shown(value, limit) {
  if (!(Number.isFinite(value) && Number.isFinite(limit))) {
    return value === limit;
  }
  return value.toExponential(3) === limit.toExponential(3);
}

/** Whether a value keeps its limit, compared in four digits; one that is not known does not. */
export function numbers__kept(value, limit, at_most) {
  if (Number.isNaN(value)) {
    return false;
  }
  let within = at_most ? value <= limit : value >= limit;
  return within || numbers__same_shown(value, limit);
}

/** How far a value is from its limit, over the limit: positive on the safe side, or nan [-]. */
export function numbers__margin_of(value, limit, at_most) {
  if (Number.isNaN(value) || Number.isNaN(limit) || limit === 0.0) {
    return NaN;
  }
  if (!Number.isFinite(value)) {
    return at_most ? NaN : Infinity;
  }
  return (at_most ? 1.0 : -1.0) * (1.0 - value / limit) + 0.0;
}

/** How many times its limit a value is, where it is far from it; nan where it is not [-]. */
export function numbers__times_of(value, limit) {
  if (Number.isNaN(value) || Number.isNaN(limit) || limit <= 0.0 || !Number.isFinite(value)) {
    return NaN;
  }
  return value / limit >= 10.0 ? value / limit : NaN;
}

/** Place of a check among those of its level: the least governs, equal ones the first. */
export function numbers__order_of(margin, missed, binding, advises, leads) {
  let found = Math.abs(margin) < BEHIND ? Math.floor(margin / ALIKE + 0.5) * ALIKE : margin;
  if (Number.isNaN(margin)) {
    found = missed && binding ? NUMBERLESS : Infinity;
  }
  if (leads) {
    return min(found, BEHIND) - AHEAD;
  }
  return missed && advises ? max(found, -BEHIND) + 2.0 * BEHIND : found;
}
