// @ts-nocheck
// Made from the Python source by `make kernel`: change that, not this.
import { cellOf, decimal, exponentOf, scientific, trimmed, unitRow } from "./base/digits.js";
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
const NONE = "-";
const _UNBOUNDED = "without bound";
const _SLOW = 0.1;
const MOST_DIGITS = 9;

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

/** Return the same of a value that shows in units of a size. */
export function digits__safe(value, size, up) {
  let step;
  let number = value / size;
  if (!Number.isFinite(number) || Math.abs(number) < NOTHING) {
    return value;
  }
  let shown = Number(digits__rounded(number, RESULT_DIGITS));
  if (digits___equal(shown, number)) {
    return value;
  }
  if (shown < number === up) {
    step = 10.0 ** (exponentOf(scientific(shown, 3)) - RESULT_DIGITS + 1);
    shown += up ? step : -step;
  }
  return shown * size;
}

export function cell___with_unit(value, dimension, digits, form, other, system) {
  let begin, first, last, more;
  const told = (number, places) => {
    let size, unit;
    if (!Number.isFinite(number)) {
      return [Number.isNaN(number) ? NONE : _UNBOUNDED, ""];
    }
    if (
      (form === "slip" || form === "slip apart") &&
      dimension === "speed" &&
      Math.abs(number) < _SLOW
    ) {
      [unit, size] = system === "si" ? ["mm/s", 0.001] : ["in/s", 0.0254];
      return [display__display(number / size, "number", system, places), unit];
    }
    return display__parts(number, dimension, system, places);
  };
  if (form === "to" || form === "-") {
    first = told(other, digits);
    last = told(value, digits);
    if (display__joined(first) === display__joined(last)) {
      return display__joined(last);
    }
    begin = first[1] === last[1] ? first[0] : display__joined(first);
    return begin + (form === "to" ? " to " : "-") + display__joined(last);
  }
  if (form === "apart" || form === "slip apart") {
    for (let each1 = digits, end1 = MOST_DIGITS + 1; each1 < end1; each1++) {
      more = each1;
      if (display__joined(told(value, more)) !== display__joined(told(other, more))) {
        return display__joined(told(value, more));
      }
    }
  }
  return display__joined(told(value, digits));
}

/** Return what a cell of such a value shows, see `Cell`. */
export function cell__cell_text(value, dimension, digits, form, other, system) {
  let row = unitRow(dimension, system);
  if (form === "unit") {
    return row.unit;
  }
  if (form === "percent") {
    return display__display(100.0 * value, "number", system, digits) + " %";
  }
  if (form === "up" || form === "bare up" || form === "down") {
    value = digits__safe(value, row.factor, form !== "down");
  }
  if (form === "bare" || form === "bare up") {
    return display__display(value / row.factor, "number", system, digits);
  }
  return cell___with_unit(value, dimension, digits, form, other, system);
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
