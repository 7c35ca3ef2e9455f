// @ts-nocheck
// Made from the Python source by `make kernel`: change that, not this.
import {
  cellOf,
  decimal,
  exponentOf,
  grouped,
  scientific,
  trimmed,
  unitRow,
} from "./base/digits.js";
const max = (a, b) => (b > a ? b : a);
const min = (a, b) => (b < a ? b : a);
const copysign = (a, b) => (b < 0 || Object.is(b, -0) ? -Math.abs(a) : Math.abs(a));
const modulo = (a, b) => (a % b !== 0 && a % b < 0 !== b < 0 ? (a % b) + b : a % b);
const EMPTY = /* @__PURE__ */ new Float64Array(0);
const zeros = (size) => (size > 0 ? new Float64Array(size) : EMPTY);

const NOTHING = 1e-9;
const SMALL = "wear_coefficient";
const GIVEN_DIGITS = 4;
const _EXACT = 1e-9;
const RESULT_DIGITS = 3;
const _EVERY = 16;
const MOST_DIGITS = 9;
const NONE = "-";
const _UNBOUNDED = "infinite";
const _SLOW = 0.1;
const _TYPED = 6;

export function digits___equal(a, b) {
  return Math.abs(a - b) <= _EXACT * max(Math.abs(a), Math.abs(b));
}

/** Return the number with so many significant digits, in plain notation where it fits. */
export function digits__rounded(number, digits) {
  if (Number.isNaN(number)) {
    return "nan";
  }
  if (Math.abs(number) === Infinity) {
    return number > 0.0 ? "inf" : "-inf";
  }
  if (number === 0.0) {
    return "0";
  }
  let given = scientific(number, GIVEN_DIGITS - 1);
  let power = exponentOf(given);
  if (
    digits <= GIVEN_DIGITS &&
    digits___equal(Number(given), number) &&
    -4 <= power &&
    power < 12
  ) {
    return trimmed(decimal(Number(given), max(0, GIVEN_DIGITS - 1 - power)));
  }
  let text = scientific(number, digits - 1);
  power = exponentOf(text);
  return -4 <= power && power < 12 ? decimal(Number(text), max(0, digits - 1 - power)) : text;
}

/** Return the number and the unit that `display` shows. */
export function display__parts(value, dimension, system, digits) {
  let bound, factor, other, zero;
  let row = unitRow(dimension, system);
  let unit = row.unit;
  let number = value / row.factor;
  if (Math.abs(number) < NOTHING && dimension !== SMALL) {
    number = 0.0;
  }
  let size = Math.abs(Number(digits__rounded(number, digits)));
  for (const each1 of row.larger) {
    [bound, other, factor, zero] = each1;
    if (bound <= size && size < Infinity) {
      unit = other;
      number = (value - zero) / factor;
    }
  }
  return [digits__rounded(number, digits), unit];
}

/** Return a number with its unit; of a plain number alone. */
export function display__joined(of) {
  let [number, unit] = of;
  return number + (unit !== "" ? " " + unit : "");
}

/** Return an SI value as text with a unit of fitting size, ``"126 kN"``. */
export function display__display(value, dimension, system = "si", digits = 4) {
  return display__joined(display__parts(value, dimension, system, digits));
}

/** Return a number rounded up or down to so many digits; itself where they hold it. */
export function digits___stepped(number, digits, up) {
  let step;
  let shown = Number(digits__rounded(number, digits));
  if (digits___equal(shown, number)) {
    return number;
  }
  if (shown < number === up) {
    step = 10.0 ** (exponentOf(scientific(shown, 3)) - digits + 1);
    shown += up ? step : -step;
  }
  return shown;
}

/** Return the same of a value that shows in units of a size. */
export function digits__safe(value, size, up) {
  let number = value / size;
  if (!Number.isFinite(number) || Math.abs(number) < NOTHING) {
    return value;
  }
  let shown = digits___stepped(number, RESULT_DIGITS, up);
  return shown === number ? value : shown * size;
}

/** Return a number with so many digits behind the point; its sign always, unless it is 0. */
export function digits__decimals(number, digits, signed) {
  let power;
  if (!Number.isFinite(number)) {
    return digits__rounded(number, digits);
  }
  let text = decimal(0.0, digits);
  if (number !== 0.0) {
    power = exponentOf(scientific(number, _EVERY));
    if (power + digits >= _EVERY - 2) {
      text = digits__rounded(number, _EVERY - 1);
    } else if (power + digits >= 0) {
      text = decimal(Number(scientific(number, power + digits)), digits);
    } else if (Math.abs(number) > 0.5 * 10.0 ** -digits) {
      text = decimal(number > 0.0 ? 10.0 ** -digits : -(10.0 ** -digits), digits);
    }
  }
  if (Number(text) === 0.0) {
    return signed ? "0" : decimal(0.0, digits);
  }
  return signed && number > 0.0 ? "+" + text : text;
}

/** Return a share in hundredths. */
export function cell___share(value, digits, form) {
  if (form === "percent") {
    return display__display(100.0 * value, "number", "si", digits);
  }
  return digits__decimals(100.0 * value, digits, form === "percent signed");
}

/** Return a number with so many significant digits, zeros at its end too. */
export function digits__every_digit(number, digits) {
  if (number === 0.0 || !Number.isFinite(number)) {
    return digits__rounded(number, digits);
  }
  let text = scientific(number, digits - 1);
  let power = exponentOf(text);
  return -4 <= power && power < 12 ? decimal(Number(text), max(0, digits - 1 - power)) : text;
}

/** Return ``number ± error``: the number to three digits, the error to the same place. */
export function digits__with_error(number, error) {
  if (!(Number.isFinite(number) && Number.isFinite(error) && error > 0.0)) {
    return digits__rounded(number, RESULT_DIGITS);
  }
  if (error >= Math.abs(number)) {
    return digits__every_digit(number, 2) + " ± " + digits__every_digit(error, 2);
  }
  let first = exponentOf(scientific(number, _EVERY));
  let places = max(0, min(1 - exponentOf(scientific(error, _EVERY)), RESULT_DIGITS - 1 - first));
  if (error < 0.5 * 10.0 ** -places) {
    places = max(0, GIVEN_DIGITS - 1 - first);
  }
  let least = 10.0 ** -places;
  let shown =
    error >= 0.5 * least
      ? digits__decimals(error, places, false)
      : "< " + digits__decimals(least, places, false);
  return digits__decimals(number, places, false) + " ± " + shown;
}

/** Return a number with so many significant digits, rounded up or down. */
export function digits__rounded_limit(number, digits, up) {
  if (!Number.isFinite(number) || Math.abs(number) < NOTHING) {
    return digits__rounded(number, digits);
  }
  let shown = digits___stepped(number, digits, up);
  return shown === number ? digits__rounded(number, digits) : digits__every_digit(shown, digits);
}

/** Return a number without a unit. */
export function cell___bare(number, digits, form, other) {
  if (form === "bare error") {
    return digits__with_error(number, other);
  }
  if (form === "bare up") {
    return digits__rounded_limit(number, digits, true);
  }
  if (form === "fixed" || form === "signed") {
    return digits__decimals(number, digits, form === "signed");
  }
  if (form === "grouped" && Number.isFinite(number)) {
    return grouped(digits__decimals(number, 0, false));
  }
  return display__display(number, "number", "si", digits);
}

export function cell___slow_unit(system) {
  return system === "si" ? ["mm/s", 0.001] : ["in/s", 0.0254];
}

/** Return number and unit; a slow speed, where it may be one of slip, in mm/s. */
export function cell___told(number, dimension, system, digits, slow) {
  let size, unit;
  if (!Number.isFinite(number)) {
    return [Number.isNaN(number) ? NONE : _UNBOUNDED, ""];
  }
  if (slow && dimension === "speed" && Math.abs(number) < _SLOW) {
    const found1 = cell___slow_unit(system);
    unit = found1[0];
    size = found1[1];
    return [display__display(number / size, "number", system, digits), unit];
  }
  return display__parts(number, dimension, system, digits);
}

/** Return a value in as many digits as tell it from another. */
export function cell___apart(value, dimension, digits, other, system, slow) {
  let more, text;
  for (let each1 = digits, end1 = MOST_DIGITS + 1; each1 < end1; each1++) {
    more = each1;
    text = display__joined(cell___told(value, dimension, system, more, slow));
    if (text !== display__joined(cell___told(other, dimension, system, more, slow))) {
      return text;
    }
  }
  return display__joined(cell___told(value, dimension, system, digits, slow));
}

/** Return a number in the unit that `_told` shows it with. */
export function cell___in_unit(number, dimension, system, unit) {
  let factor, other, zero;
  let row = unitRow(dimension, system);
  const found1 = cell___slow_unit(system);
  let slow = found1[0];
  let size = found1[1];
  if (dimension === "speed" && unit === slow) {
    return number / size;
  }
  for (const each2 of row.larger) {
    [, other, factor, zero] = each2;
    if (unit === other) {
      return (number - zero) / factor;
    }
  }
  return number / row.factor;
}

/** Return number and unit of a limit, rounded up or down. */
export function cell___limit(number, dimension, system, digits, up) {
  const found1 = cell___told(number, dimension, system, digits, true);
  let text = found1[0];
  let unit = found1[1];
  if (!Number.isFinite(number) || Math.abs(number) < NOTHING) {
    return [text, unit];
  }
  return [digits__rounded_limit(cell___in_unit(number, dimension, system, unit), digits, up), unit];
}

/** Return a number rounded up or down to so many significant digits, zeros at its end too. */
export function digits__every_limit_digit(number, digits, up) {
  return digits__every_digit(digits___stepped(number, digits, up), digits);
}

/** Return a limit, or a value that misses it, in as many digits as tell both apart. */
export function cell___missed(value, dimension, digits, form, other, system) {
  let first, more, second;
  let is_limit = form === "maximum" || form === "minimum";
  let up = form === "minimum" || form === "below";
  let [limit, compared] = is_limit ? [value, other] : [other, value];
  let plain = cell___limit(limit, dimension, system, digits, up);
  if (Number.isNaN(other) || !(Number.isFinite(value) && Number.isFinite(other))) {
    return display__joined(is_limit ? plain : cell___told(value, dimension, system, digits, true));
  }
  let told = cell___told(compared, dimension, system, digits, true);
  if (display__joined(plain) !== display__joined(told)) {
    return display__joined(is_limit ? plain : told);
  }
  for (let each1 = digits + 1, end1 = MOST_DIGITS + 1; each1 < end1; each1++) {
    more = each1;
    first = digits__every_limit_digit(cell___in_unit(limit, dimension, system, told[1]), more, up);
    second = digits__every_digit(cell___in_unit(compared, dimension, system, told[1]), more);
    if (first !== second) {
      return display__joined([is_limit ? first : second, told[1]]);
    }
  }
  return display__joined(is_limit ? plain : told);
}

/** Return a given number with the digits that it was typed with, six at most. */
export function digits__as_typed(number, text) {
  if (number === 0.0 || !Number.isFinite(number)) {
    return text;
  }
  let typed = scientific(number, _TYPED - 1);
  let power = exponentOf(typed);
  if (!digits___equal(Number(typed), number) || !(-4 <= power && power < 12)) {
    return text;
  }
  return trimmed(decimal(Number(typed), max(0, _TYPED - 1 - power)));
}

/** Return a given number as typed, and its unit; rounded where its unit is another. */
export function cell___typed(number, dimension, system, digits) {
  const found1 = cell___told(number, dimension, system, digits, false);
  let text = found1[0];
  let unit = found1[1];
  return [digits__as_typed(cell___in_unit(number, dimension, system, unit), text), unit];
}

/** Return two numbers, with one unit where both have the same. */
export function cell___range(value, dimension, digits, form, other, system) {
  let last;
  let first = cell___told(other, dimension, system, digits, false);
  if (form === "to up" || form === "to down") {
    first = cell___typed(other, dimension, system, digits);
  }
  if (form === "to" || form === "-") {
    last = cell___told(value, dimension, system, digits, false);
    if (display__joined(first) === display__joined(last)) {
      return display__joined(last);
    }
  } else {
    last = cell___limit(value, dimension, system, digits, form === "to up");
  }
  let begin = first[1] === last[1] ? first[0] : display__joined(first);
  let between = form === "of" ? " of " : " to ";
  return begin + (form === "-" ? "-" : between) + display__joined(last);
}

/** Return what a cell of such a value shows, see `Cell`. */
export function cell__cell_text(value, dimension, digits, form, other, system) {
  let row = unitRow(dimension, system);
  if (form === "unit") {
    return row.unit;
  }
  if (form === "percent" || form === "percent fixed" || form === "percent signed") {
    return cell___share(value, digits, form) + " %";
  }
  if (
    form === "bare" ||
    form === "bare up" ||
    form === "bare error" ||
    form === "fixed" ||
    form === "signed" ||
    form === "grouped"
  ) {
    return cell___bare(value / row.factor, digits, form, other / row.factor);
  }
  if (form === "apart" || form === "slip apart") {
    return cell___apart(value, dimension, digits, other, system, form === "slip apart");
  }
  if (form === "exceeds" || form === "below" || form === "maximum" || form === "minimum") {
    return cell___missed(value, dimension, digits, form, other, system);
  }
  if (form === "to" || form === "-" || form === "to up" || form === "to down" || form === "of") {
    return cell___range(value, dimension, digits, form, other, system);
  }
  if (form === "typed") {
    return display__joined(cell___typed(value, dimension, system, digits));
  }
  if (form === "up" || form === "down") {
    return display__joined(cell___limit(value, dimension, system, digits, form === "up"));
  }
  return display__joined(cell___told(value, dimension, system, digits, form === "slip"));
}

/** Return the cell of a value [SI]; `NONE` for nan and words for infinity. */
export function cell__quantity(value, dimension, digits = 3, name = "") {
  if (Number.isNaN(value)) {
    return NONE;
  }
  if (Math.abs(value) === Infinity) {
    return _UNBOUNDED;
  }
  return cellOf(value, dimension, digits, undefined, undefined, name);
}

/** Return a share as percent, `NONE` for nan. */
export function cell__percent(share, digits = 3) {
  return Number.isNaN(share) ? NONE : cellOf(share, "number", digits, "percent");
}

/** Return a value with so many digits behind the point, `NONE` for nan. */
export function cell__fixed(value, digits, form = "fixed", dimension = "number", name = "") {
  if (!Number.isFinite(value)) {
    return cell__quantity(value, dimension);
  }
  return cellOf(value, dimension, digits, form, undefined, name);
}
