// @ts-nocheck
// What Python has built in, for the modules that are translated whole (tools/javascript/whole.py).
// Lists and tuples are arrays, dicts are Maps, sets are Sets, None is null. A whole float of a
// document is a `Number` object: only that tells it from an integer.

export class $Object {
  constructor(...given) {
    this.$init(...given);
  }
  /** Puts the fields, if a class has any. */
  $init(...given) {
    const { $names = [], $usual } = this.constructor;
    $names.forEach((name, i) => {
      this[name] = given[i] === undefined ? $usual[name]?.() : given[i];
    });
    this.__post_init__?.();
  }
}
/** What has its fields in an order. */
export class $Tuple extends $Object {
  *[Symbol.iterator]() {
    for (const name of this.constructor.$names) yield this[name];
  }
}
export class $Dict extends Map {
  constructor(...given) {
    super();
    this.$init(...given);
  }
  $init(from) {
    for (const [key, value] of from ?? []) this.set(key, value);
  }
}
export class $Error extends Error {
  constructor(...given) {
    super();
    this.$init(...given);
  }
  $init(...args) {
    this.args = args;
  }
  __str__() {
    return String(this.args[0] ?? "");
  }
}
export class $KeyError extends $Error {}
export class $ValueError extends $Error {}
export class $StopIteration extends $Error {}
export class $TypeError extends $Error {}
export class $OverflowError extends $Error {}

// Decimal numbers of 28 digits, as the context of Python's `decimal` has them.
const DIGITS = 28;
export class $Decimal {
  constructor(whole, power) {
    this.whole = whole; // times 10 ** power
    this.power = power;
  }
  static of(text) {
    const [, sign, whole, part = "", power = "0"] =
      /^([+-]?)(\d*)\.?(\d*)(?:[eE]([+-]?\d+))?$/.exec(text);
    return new $Decimal(BigInt(`${sign}${whole}${part}`), Number(power) - part.length);
  }
  rounded() {
    const size = String(this.whole < 0n ? -this.whole : this.whole).length;
    if (size <= DIGITS) return this;
    return new $Decimal(
      halved(this.whole, 10n ** BigInt(size - DIGITS)),
      this.power + size - DIGITS,
    ).rounded();
  }
  plus(other, sign = 1n) {
    const power = Math.min(this.power, other.power);
    const at = (d) => d.whole * 10n ** BigInt(d.power - power);
    return new $Decimal(at(this) + sign * at(other), power).rounded();
  }
  times(other) {
    return new $Decimal(this.whole * other.whole, this.power + other.power).rounded();
  }
  to(power) {
    const n = BigInt(Math.abs(power));
    const found = new $Decimal(this.whole ** n, this.power * Math.abs(power));
    if (power >= 0) return found.rounded();
    const more = DIGITS + String(found.whole).length + 4;
    return new $Decimal(10n ** BigInt(more) / found.whole, -more - found.power).rounded();
  }
  normalize() {
    const [, kept, zeros] = /^(-?\d+?)(0*)$/.exec(this.whole);
    return new $Decimal(BigInt(kept), this.power + zeros.length);
  }
  /** All its digits. */
  plain() {
    const sign = this.whole < 0n ? "-" : "";
    const digits = String(this.whole).replace("-", "") + "0".repeat(Math.max(this.power, 0));
    const text = digits.padStart(1 - this.power, "0");
    return (
      sign + (this.power < 0 ? `${text.slice(0, this.power)}.${text.slice(this.power)}` : text)
    );
  }
  valueOf() {
    return Number(`${this.whole}e${this.power}`);
  }
}
/** A quotient rounded half to even. */
function halved(whole, by) {
  const [sign, n] = whole < 0n ? [-1n, -whole] : [1n, whole];
  const [low, rest] = [n / by, n % by];
  const up = 2n * rest > by || (2n * rest === by && low % 2n === 1n);
  return sign * (up ? low + 1n : low);
}

class Counts extends Map {}
/** Arguments that go by name. */
class Named {
  constructor(given) {
    Object.assign(this, given);
  }
}
export const $k = (given) => new Named(given);
export const $named = (args) => (args.at(-1) instanceof Named ? args.pop() : {});

/** What is said of a function; no names of one that takes any number of arguments. */
export const $sig = (of, names, more = false, usual = {}) =>
  Object.assign(of, { $names: names, $more: more, $usual: usual });
const placed = (of, args, by) => {
  if (of.$names === null) return [...args, $k(Object.fromEntries(by))];
  const rest = new Map(by);
  const given = of.$names.map((name, i) => {
    if (i < args.length) return args[i];
    const found = rest.get(name);
    rest.delete(name);
    return found;
  });
  if (rest.size && !of.$more) throw new TypeError(`no argument ${[...rest.keys()]}`);
  return of.$more ? [...given, rest] : given;
};
/** What an object has under a name; of a method the one that keeps its object. */
export const $bound = (of, name) => {
  const found = of[name];
  return typeof found === "function" && !found.prototype ? found.bind(of) : found;
};
export const $fields = (of) => (of.$names ?? of.constructor.$names).map((name) => ({ name }));
/** A function, a class or a method called with arguments by name. */
export const $call = (of, args, by) =>
  of.prototype instanceof $Object || of.prototype instanceof $Error
    ? new of(...placed(of, args, by))
    : of(...placed(of, args, by));
export const $method = (of, name, args, by) => of[name](...placed(of[name], args, by));

/** A function that remembers what it returned. */
export const $once =
  (of, kept) =>
  (...args) => {
    const key = args.map((x) => `${typeof x}${x}`).join("\0");
    if (!kept.has(key)) kept.set(key, of(...args));
    return kept.get(key);
  };
export const $iter = (of) => (of instanceof Map ? of.keys() : of.__iter__ ? of.__iter__() : of);
export const $map = (entries) => new Map(entries);
export const $truth = (x) =>
  !(
    x === null ||
    x === undefined ||
    x === false ||
    x === "" ||
    x === 0 ||
    (Array.isArray(x) && x.length === 0) ||
    ((x instanceof Map || x instanceof Set) && x.size === 0) ||
    (x instanceof Number && +x === 0) ||
    (x instanceof $Decimal && x.whole === 0n)
  );
export const $or = (a, b) => ($truth(a) ? a : b());
export const $and = (a, b) => ($truth(a) ? b() : a);
const isNumber = (x) => typeof x === "number" || x instanceof Number || x instanceof $Decimal;
export function $eq(a, b) {
  if (a === b || (a == null && b == null)) return true;
  if (isNumber(a) && isNumber(b)) return +a === +b;
  if (typeof a !== "object" || typeof b !== "object" || !a || !b) return false;
  if (Array.isArray(a))
    return Array.isArray(b) && a.length === b.length && a.every((x, i) => $eq(x, b[i]));
  if (a instanceof Map)
    return (
      b instanceof Map &&
      a.size === b.size &&
      [...a].every(([k, v]) => b.has(k) && $eq(v, b.get(k)))
    );
  if (a instanceof Set)
    return b instanceof Set && a.size === b.size && [...a].every((x) => b.has(x));
  const fields = a.constructor.$compared;
  return a.constructor === b.constructor && Boolean(fields) && fields.every((f) => $eq(a[f], b[f]));
}
const isMap = (of) => of instanceof Map || of instanceof WeakMap;
/** A key as a dict has it: a tuple is an array here, which JavaScript knows by identity alone.
 * @param {any} of @param {any} key */
const keyIn = (of, key) =>
  Array.isArray(key) && of.keys
    ? ([...of.keys()].find((known) => Array.isArray(known) && $eq(known, key)) ?? key)
    : key;
export const $in = (x, of) => {
  if (isMap(of) || of instanceof Set) return of.has(keyIn(of, x));
  if (typeof of === "string") return of.includes(x);
  return [...of].some((y) => $eq(x, y));
};
export const $add = (a, b) => {
  if (Array.isArray(a)) return [...a, ...b];
  return a instanceof $Decimal ? a.plus(b) : a + b;
};
export const $sub = (a, b) => {
  if (a instanceof Set) return new Set([...a].filter((x) => !$in(x, b)));
  return a instanceof $Decimal ? a.plus(b, -1n) : a - b;
};
export const $mul = (a, b) => {
  if (a instanceof $Decimal) return a.times(b);
  return Array.isArray(a) ? Array.from({ length: b }, () => a).flat() : a * b;
};
export const $pow = (a, b) => (a instanceof $Decimal ? a.to(b) : a ** b);
export const $neg = (a) => (a instanceof $Decimal ? new $Decimal(-a.whole, a.power) : -a);
export const $merged = (a, b) =>
  a instanceof Map ? new Map([...a, ...b]) : a instanceof Set ? new Set([...a, ...b]) : a | b;
export const $common = (a, b) =>
  a instanceof Set ? new Set([...a].filter((x) => b.has(x))) : a & b;
/** The characters of a text, one a code point. */
const letters = (text) => (/[\ud800-\udfff]/.test(text) ? [...text] : text);
export function $at(of, key) {
  if (isMap(of)) {
    const own = keyIn(of, key);
    if (!of.has(own) && of instanceof Counts) return 0;
    if (!of.has(own)) throw new $KeyError(key);
    return of.get(own);
  }
  const found =
    typeof of === "string" ? letters(of) : (of.$found ?? (Array.isArray(of) ? of : [...of]));
  return typeof key === "number" ? (found.at(key) ?? null) : (found.groups?.[key] ?? null);
}
export const $put = (of, key, value) => {
  if (isMap(of)) of.set(keyIn(of, key), value);
  else of[key < 0 ? of.length + key : key] = value;
};
export const $slice = (of, from, to) => {
  const part = (typeof of === "string" ? letters(of) : [...of]).slice(from ?? 0, to ?? undefined);
  return typeof of === "string" && Array.isArray(part) ? part.join("") : part;
};
export const $replaced = (of, by) => {
  const kind = of.constructor;
  return new kind(...kind.$names.map((name) => (by.has(name) ? by.get(name) : of[name])));
};
/** What a lazy property is found to be, which it is from then on. */
export const $kept = (of, name, value) => {
  Object.defineProperty(of, name, { value });
  return value;
};
/** What a member of an enumeration has, or another object. */
export const $told = (of, member, name) =>
  typeof member === "string" ? of.get(member) : member[name];
/** An object of a class as it was when the module was made. */
export const $made = (kind, names, values) =>
  Object.assign(
    Object.create(kind.prototype),
    Object.fromEntries(names.map((n, i) => [n, values[i]])),
  );

// Numbers as text.

const WIDE = 16;
export function $repr(x) {
  if (typeof x === "string") return `'${x}'`;
  if (!isNumber(x)) return $str(x);
  const n = +x;
  if (!Number.isFinite(n)) return Number.isNaN(n) ? "nan" : n > 0 ? "inf" : "-inf";
  const [digits, power] = n.toExponential().split("e");
  if (n !== 0 && (power < -4 || power >= WIDE)) return `${digits}e${signed(power)}`;
  const text = plainly(digits, +power);
  return text.includes(".") ? text : `${text}.0`;
}
const signed = (power) => `${power < 0 ? "-" : "+"}${String(Math.abs(power)).padStart(2, "0")}`;
/** Digits of a number with its power, without one. */
function plainly(digits, power) {
  const sign = digits.startsWith("-") ? "-" : "";
  const all = digits.replace(/[-.]/g, "");
  if (power < 0) return `${sign}0.${"0".repeat(-power - 1)}${all}`;
  const padded = all.padEnd(power + 1, "0");
  const part = padded.slice(power + 1);
  return `${sign}${padded.slice(0, power + 1)}${part && `.${part}`}`;
}
export function $str(x) {
  if (typeof x === "string") return x;
  if (x === null || x === undefined) return "None";
  if (typeof x === "boolean") return x ? "True" : "False";
  if (typeof x === "number") return Number.isInteger(x) ? String(x) : $repr(x);
  if (x instanceof Number) return $repr(x);
  if (Array.isArray(x)) return `[${x.map($repr).join(", ")}]`;
  return x.__str__ ? x.__str__() : String(x);
}
export function $format(x, spec) {
  const [, sign, grouped, places, kind] = /^(\+?)(,?)(?:\.(\d+))?([efgdx%]?)$/.exec(
    spec.replace(/^0\d(?=x)/, ""),
  );
  if (x instanceof $Decimal) return x.plain();
  const n = +x;
  if (kind === "x") return n.toString(16).padStart(Number(/^0(\d)/.exec(spec)?.[1] ?? 0), "0");
  if (!Number.isFinite(n)) return $repr(n);
  let text = String(n);
  const digits = Number(places ?? 6);
  if (kind === "f") text = fixed(n, digits);
  if (kind === "e") text = exponential(n, digits);
  if (kind === "g") text = general(n, digits || 1);
  if (grouped) text = text.replace(/\B(?=(\d{3})+(?!\d))/g, ",");
  return sign && n >= 0 ? `+${text}` : text;
}
/** The exact decimal number of a float, rounded half to even: JavaScript rounds half up. */
function exactly(n, power) {
  let [whole, down] = [Math.abs(n), 0];
  while (!Number.isInteger(whole)) [whole, down] = [whole * 2, down + 1];
  const top = BigInt(whole) * 10n ** BigInt(Math.max(-power, 0));
  return halved(top, 2n ** BigInt(down) * 10n ** BigInt(Math.max(power, 0)));
}
function fixed(n, digits) {
  const text = String(exactly(n, -digits)).padStart(digits + 1, "0");
  const whole = text.slice(0, text.length - digits);
  const minus = n < 0 || Object.is(n, -0) ? "-" : "";
  return `${minus}${whole}${digits ? `.${text.slice(-digits)}` : ""}`;
}
function parted(n, digits) {
  if (n === 0) return ["0".repeat(digits + 1), 0];
  let power = Number(n.toExponential().split("e")[1]);
  let text = String(exactly(n, power - digits));
  if (text.length > digits + 1) [text, power] = [String(exactly(n, power + 1 - digits)), power + 1];
  return [text, power];
}
function exponential(n, digits) {
  const [text, power] = parted(n, digits);
  const minus = n < 0 || Object.is(n, -0) ? "-" : "";
  return `${minus}${text[0]}${digits ? `.${text.slice(1)}` : ""}e${signed(power)}`;
}
function general(n, digits) {
  const [text, power] = parted(n, digits - 1);
  const minus = n < 0 || Object.is(n, -0) ? "-" : "";
  const bare = text.replace(/0+$/, "") || "0";
  if (power < -4 || power >= digits)
    return `${minus}${bare[0]}${bare.length > 1 ? `.${bare.slice(1)}` : ""}e${signed(power)}`;
  return `${minus}${plainly(bare, power)}`;
}
/** As `errors.shown`: source notation, short, printable. */
export function $shown(value) {
  let text = $json(value);
  const all = [...text];
  if (all.length > SHOWN)
    text = all.slice(0, SHOWN - 4).join("") + (text.startsWith('"') ? '..."' : "...");
  const hidden = (c) => c !== " " && UNPRINTABLE.test(c);
  return [...text]
    .map((c) => (hidden(c) ? `\\u${c.codePointAt(0).toString(16).padStart(4, "0")}` : c))
    .join("");
}
const SHOWN = 60;
/** As json.dumps(value, ensure_ascii=False, default=str). */
export function $json(x) {
  if (typeof x === "string")
    return JSON.stringify(x).replace(/\\u(d[89a-f]..)/g, (_, c) =>
      String.fromCharCode(Number.parseInt(c, 16)),
    );
  if (x === null || x === undefined) return "null";
  if (typeof x === "boolean") return String(x);
  if (isNumber(x) && !Number.isFinite(+x))
    return Number.isNaN(+x) ? "NaN" : +x > 0 ? "Infinity" : "-Infinity";
  if (isNumber(x)) return $str(x);
  if (typeof x === "bigint") return String(x);
  if (Array.isArray(x)) return `[${x.map($json).join(", ")}]`;
  if (x instanceof Map)
    return `{${[...x].map(([k, v]) => `${$json($str(k))}: ${$json(v)}`).join(", ")}}`;
  return $json($str(x));
}

// Regular expressions.

export const $re = (source, flags) => ({
  search: new RegExp(source, `${flags}u`),
  match: new RegExp(source, `${flags}uy`),
  fullmatch: new RegExp(`^(?:${source})$`, `${flags}u`),
  all: new RegExp(source, `${flags}ug`),
});
const match = (found) => found && { $found: found };

// Methods of what is built in; those of objects go first.

const UNPRINTABLE = /[\p{C}\p{Z}]/u;
const SPACE = String.raw`[\s\x1c-\x1f\x85]`;
const sides = (text, of, left, right) => {
  const any = of == null ? SPACE : `[${of.replace(/[\\\]^-]/g, "\\$&")}]`;
  let found = text;
  if (left) found = found.replace(new RegExp(`^${any}+`, "u"), "");
  return right ? found.replace(new RegExp(`${any}+$`, "u"), "") : found;
};
const any = (x) => (Array.isArray(x) ? x : [x]);
const METHODS = {
  // texts
  strip: (x, of) => sides(x, of, true, true),
  lstrip: (x, of) => sides(x, of, true, false),
  rstrip: (x, of) => sides(x, of, false, true),
  lower: (x) => x.toLowerCase(),
  upper: (x) => x.toUpperCase(),
  capitalize: (x) => x.slice(0, 1).toUpperCase() + x.slice(1).toLowerCase(),
  casefold: (x) => x.toLowerCase().replaceAll("ß", "ss"),
  startswith: (x, of) => any(of).some((y) => x.startsWith(y)),
  endswith: (x, of) => any(of).some((y) => x.endsWith(y)),
  replace: (x, a, b) => x.replaceAll(a, () => b),
  removeprefix: (x, a) => (x.startsWith(a) ? x.slice(a.length) : x),
  removesuffix: (x, a) => (a && x.endsWith(a) ? x.slice(0, -a.length) : x),
  partition: (x, by) => {
    const at = x.indexOf(by);
    return at < 0 ? [x, "", ""] : [x.slice(0, at), by, x.slice(at + by.length)];
  },
  rpartition: (x, by) => {
    const at = x.lastIndexOf(by);
    return at < 0 ? ["", "", x] : [x.slice(0, at), by, x.slice(at + by.length)];
  },
  split: (x, by) =>
    by === undefined
      ? sides(x, null, true, true)
          .split(new RegExp(`${SPACE}+`, "u"))
          .filter(Boolean)
      : x.split(by),
  join: (by, of) => [...$iter(of)].join(by),
  isprintable: (x) => ![...x].some((c) => c !== " " && UNPRINTABLE.test(c)),
  isdecimal: (x) => /^\p{Nd}+$/u.test(x),
  // biome-ignore lint/suspicious/noControlCharactersInRegex: of ASCII
  isascii: (x) => /^[\x00-\x7f]*$/.test(x),
  translate: (x, by) =>
    [...x].map((c) => (by.has(c.codePointAt(0)) ? (by.get(c.codePointAt(0)) ?? "") : c)).join(""),
  format: (x, given, by) => {
    let at = 0;
    return x.replace(/\{\{|\}\}|\{(\w*)\}/g, (all, name) =>
      name === undefined ? all[0] : $str(name ? $at(by, name) : given[at++]),
    );
  },
  // dicts, sets and lists
  get: (x, key, other = null) => ($in(key, x) ? $at(x, key) : other),
  items: (x) => [...x],
  keys: (x) => new Set(x.keys()),
  values: (x) => [...x.values()],
  setdefault: (x, key, other) => {
    if (!$in(key, x)) $put(x, key, other);
    return $at(x, key);
  },
  pop: (x, key, other) => {
    if (Array.isArray(x)) return key === undefined ? x.pop() : x.splice(key, 1)[0];
    const found = $in(key, x) ? $at(x, key) : other;
    x.delete(keyIn(x, key));
    return found;
  },
  update: (x, more) => {
    for (const [key, value] of more instanceof Map ? more : $iter(more)) x.set(key, value);
  },
  append: (x, one) => {
    x.push(one);
  },
  count: (x, one) => [...x].filter((y) => $eq(y, one)).length,
  index: (x, one) => [...x].findIndex((y) => $eq(y, one)),
  isdisjoint: (x, of) => ![...$iter(of)].some((y) => x.has(y)),
  // regular expressions
  match: (x, text, from = 0) => {
    x.match.lastIndex = from;
    return match(x.match.exec(text));
  },
  fullmatch: (x, text) => match(x.fullmatch.exec(text)),
  search: (x, text) => match(x.search.exec(text)),
  findall: (x, text) =>
    [...text.matchAll(x.all)].map((m) =>
      m.length > 2 ? m.slice(1).map((g) => g ?? "") : (m[1] ?? m[0]),
    ),
  sub: (x, by, text) => text.replace(x.all, () => by),
  group: (x, key = 0) => $at(x, key),
  end: (x) => x.$found.index + x.$found[0].length,
  start: (x) => x.$found.index,
};
export const $m = Object.fromEntries(
  Object.entries(METHODS).map(([name, of]) => [
    name,
    (x, ...args) =>
      x instanceof $Object || (x instanceof $Error && x[name]) ? x[name](...args) : of(x, ...args),
  ]),
);

// Functions.

const TYPES = {
  str: (x) => typeof x === "string",
  bool: (x) => typeof x === "boolean",
  int: (x) =>
    typeof x === "boolean" ||
    typeof x === "bigint" ||
    (typeof x === "number" && Number.isInteger(x)),
  float: (x) => x instanceof Number || (typeof x === "number" && !Number.isInteger(x)),
  dict: (x) => x instanceof Map,
  Mapping: (x) => x instanceof Map,
  list: Array.isArray,
  tuple: Array.isArray,
  Sequence: (x) => Array.isArray(x) || typeof x === "string",
};
const many = (args) => (args.length === 1 ? [...$iter(args[0])] : args);
const less = (a, b) => {
  if (!Array.isArray(a)) return a < b;
  const at = a.findIndex((x, i) => !$eq(x, b[i]));
  return at >= 0 && less(a[at], b[at]);
};
const best =
  (better) =>
  (...args) => {
    const { key = (x) => x, ...more } = $named(args);
    const all = many(args);
    if (!all.length) {
      if ("default" in more) return more.default;
      throw new TypeError("nothing to choose from");
    }
    return all.reduce((a, b) => (better(key(b), key(a)) ? b : a));
  };
export const $b = {
  len: (x) => (typeof x === "string" ? letters(x).length : (x.size ?? x.length ?? [...x].length)),
  isinstance: (x, ...of) =>
    of.flat().some((t) => (typeof t === "string" ? TYPES[t](x) : x instanceof t)),
  str: $str,
  repr: $repr,
  int: (x) => Math.trunc(Number(x)),
  float: (x) => Number(x),
  bool: $truth,
  list: (x = []) => [...$iter(x)],
  tuple: (x = []) => [...$iter(x)],
  set: (x = []) => new Set($iter(x)),
  frozenset: (x = []) => new Set($iter(x)),
  dict: (x = []) => new Map(x),
  fromkeys: (x, value = null) => new Map([...$iter(x)].map((k) => [k, value])),
  any: (x) => [...$iter(x)].some($truth),
  all: (x) => [...$iter(x)].every($truth),
  sum: (x) => [...$iter(x)].reduce((a, b) => a + b, 0),
  abs: (x) => Math.abs(x),
  filter: (of, x) => [...$iter(x)].filter((y) => $truth(of === null ? y : of(y))),
  /** A whole number, half to even. */
  round: (x) => (Math.abs(x % 1) === 0.5 ? 2 * Math.round(x / 2) : Math.round(x)),
  min: best((a, b) => less(a, b)),
  max: best((a, b) => less(b, a)),
  sorted: (...args) => {
    const { key = (x) => x, reverse = false } = $named(args);
    const way = reverse ? -1 : 1;
    return many(args).sort(
      (a, b) => way * (less(key(a), key(b)) ? -1 : less(key(b), key(a)) ? 1 : 0),
    );
  },
  zip: (...args) => {
    $named(args);
    const all = args.map((x) => [...$iter(x)]);
    const length = Math.min(...all.map((x) => x.length));
    return Array.from({ length }, (_, i) => all.map((x) => x[i]));
  },
  enumerate: (...args) => {
    const { start = 0 } = $named(args);
    return [...$iter(args[0])].map((x, i) => [i + start, x]);
  },
  range: (a, b) =>
    Array.from({ length: Math.max(b === undefined ? a : b - a, 0) }, (_, i) =>
      b === undefined ? i : a + i,
    ),
  map: (of, ...x) =>
    x.length > 1 ? $b.zip(...x).map((y) => of(...y)) : [...$iter(x[0])].map((y) => of(y)),
  next: (of, ...other) => {
    const { done, value } = of[Symbol.iterator]().next();
    if (!done) return value;
    if (other.length) return other[0];
    throw new $StopIteration();
  },
  iter: (x) => [...$iter(x)][Symbol.iterator](),
  reversed: (x) => [...$iter(x)].reverse(),
  ord: (x) => x.codePointAt(0),
  type: (x) => x.constructor,
  getattr: (x, name, other) => x?.[name] ?? other ?? null,
  pairwise: (x) => $b.zip($iter(x), [...$iter(x)].slice(1)),
  Counter: (x) => {
    const found = new Counts();
    for (const one of $iter(x)) found.set(one, (found.get(one) ?? 0) + 1);
    return found;
  },
  Decimal: (x) => (typeof x === "string" ? $Decimal.of(x) : exact(Number(x))),
};
/** The decimal number that a float is, all its digits. */
function exact(n) {
  let [whole, down] = [n, 0];
  while (!Number.isInteger(whole)) [whole, down] = [whole * 2, down + 1];
  return new $Decimal(BigInt(whole) * 5n ** BigInt(down), -down);
}
export const $math = {
  inf: Number.POSITIVE_INFINITY,
  isfinite: (x) => Number.isFinite(+x),
  isnan: (x) => Number.isNaN(+x),
  isinf: (x) => Math.abs(x) === Number.POSITIVE_INFINITY,
  isclose: (a, b, { rel_tol }) =>
    a === b ||
    (Number.isFinite(a - b) && Math.abs(a - b) <= rel_tol * Math.max(Math.abs(a), Math.abs(b))),
  fsum: (x) => {
    const all = [...$iter(x)].map(Number);
    if (!all.every(Number.isFinite)) return all.reduce((a, b) => a + b, 0);
    return +all.map(exact).reduce(sumOf, new $Decimal(0n, 0));
  },
  comb: (n, k) =>
    Array.from({ length: k }, (_, i) => i).reduce((a, i) => (a * (n - i)) / (i + 1), 1),
  degrees: (x) => (x * 180) / Math.PI,
  copysign: (a, b) => (b < 0 || Object.is(b, -0) ? -Math.abs(a) : Math.abs(a)),
};
for (const name of [
  "log",
  "expm1",
  "exp",
  "sqrt",
  "sin",
  "cos",
  "tan",
  "atan2",
  "asin",
  "acos",
  "atan",
  "hypot",
  "floor",
  "ceil",
])
  $math[name] = Math[name];
function sumOf(a, b) {
  const power = Math.min(a.power, b.power);
  const at = (d) => d.whole * 10n ** BigInt(d.power - power);
  return new $Decimal(at(a) + at(b), power);
}
