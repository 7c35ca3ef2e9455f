// One field of the drive file: label, box, unit, slider, help and what is wrong with it.

import { app, edit, get, grasp, gripped, touched, wrong } from "../base/design.js";
import { factor, sign, split, trim, unit, viewed } from "../base/units.js";
import { Component, createRef, h } from "../vendor/preact.js";
import { valueIn } from "./choose.js";

/** @import { Children, Limits, Path, Spec } from "../types.d.ts" */
/**
 * A choice is its value and its text; those of a group stand under one heading.
 * @typedef {[string, string]} Choice
 * @typedef {{group?: string, choices: Choice[]}} Choices
 * @typedef {{least: number, most: number, stops?: number[], mark?: number | null,
 *   good?: [number, number] | null}} Scale
 *   where a slider goes [SI], its stops, where a limit is, and between what that is kept
 * @typedef {{spec: Spec, path: Path, label?: string, choices?: Choices[], slider?: boolean,
 *   scale?: Scale | null, inUnit?: string, assumed?: boolean, placeholder?: string,
 *   page?: string, read?: () => any,
 *   put?: (value: any) => void,
 *   check?: (text: string) => string}} FieldProps
 *   inUnit: the unit of a number that is not there yet; read and put: other than the place of the
 *   document; a field with a check is taken when the typing is done and nothing speaks against it
 * @typedef {{draft: string | null, from: any, help: boolean, refused: string}} FieldState
 */

/** @param {string} sectionKey */
export const section = (sectionKey) =>
  app.form.sections.find((x) => x.key === sectionKey)?.fields || [];
/** @param {string} sectionKey @param {string} key @returns {Spec} */
export const spec = (sectionKey, key) =>
  section(sectionKey).find((f) => f.key === key) || { key, title: key, kind: "text" };

/** Some fields in an order of one's own, and the others.
 * @param {Spec[]} fields @param {string[]} keys @returns {[Spec[], Spec[]]} */
export const parted = (fields, keys) => [
  keys.flatMap((k) => fields.filter((f) => f.key === k)),
  fields.filter((f) => !keys.includes(f.key)),
];

/** What is said of a field that is empty, and is no mistake. */
export const NEEDED = "Missing.";
/** Names of the fields on the pages by the place they show: which problems have a field. */
export const shownFields = /** @type {Map<string, string[]>} */ (new Map());
/** @param {Path} path */
const keyOf = (path) => path.join();
/** The box of a field. @param {Path} path @param {string} [page] */
export const idOf = (path, page = "f") => `${page}-${path.join("-").replace(/[^\w-]/g, "_")}`;

/**
 * A slider of some 400 places between two values, even or in equal ratios; numbers come out round.
 * @param {Limits} range @param {number} f @param {number} now
 */
function places(range, f, now) {
  const lo = Math.min(range.least / f, now);
  const hi = Math.max(range.most / f, now);
  if (range.log && lo > 0) {
    const whole = Math.log(hi / lo);
    /** @param {number} v */
    const at = (v) => (400 * Math.log(v / lo)) / whole;
    return {
      at,
      value: (/** @type {number} */ k) => trim(lo * (hi / lo) ** (k / 400), 3),
      min: 0,
      max: 400,
    };
  }
  const p = 10 ** Math.floor(Math.log10((hi - lo) / 400));
  const step = [1, 2, 5, 10].map((m) => m * p).find((v) => v >= ((hi - lo) / 400) * 0.999) || p;
  /** @param {number} v */
  const at = (v) => v / step;
  return {
    at,
    value: (/** @type {number} */ k) => trim(k * step, 6),
    min: Math.floor(lo / step),
    max: Math.ceil(hi / step),
  };
}
/** A slider that goes from one stop to the next. @param {number[]} stops @param {number} f
 * @param {number} now */
function placesAt(stops, f, now) {
  const all = [...new Set([...stops.map((v) => +trim(v / f, 6)), now])].sort((a, b) => a - b);
  const at = (/** @type {number} */ v) => {
    const i = Math.max(
      1,
      all.findIndex((x) => x >= v) < 0 ? all.length - 1 : all.findIndex((x) => x >= v),
    );
    return i - 1 + (v - all[i - 1]) / (all[i] - all[i - 1] || 1);
  };
  const value = (/** @type {number} */ k) => String(all[Math.round(k)]);
  return { at, value, min: 0, max: all.length - 1 };
}
/** @param {Spec} s */
function allowed({ dimension, allowed: text, least, most }) {
  if (!dimension || !text) return "";
  const [u, f] = unit(dimension);
  const end = (/** @type {number} */ v) => `${trim(v / f, 4)} ${u}`.trim();
  const from = least != null && least > 0 && `from ${end(least)}`;
  const both = [from, most != null && `to ${end(most)}`].filter(Boolean).join(" ");
  return both && app.units === "us" ? `Allowed: ${both}.` : `Allowed: ${text}.`;
}

/** What finds the value of a field that gives a wanted result, where there is a server, and what
 * asks for the value that may be meant. */
export const seeking = {
  open: /** @type {((path: Path) => void) | null} */ (null),
  hint: /** @type {((of: Field) => Children) | null} */ (null),
};

/** @extends {Component<FieldProps, FieldState>} */
export class Field extends Component {
  /** @type {FieldState} */
  state = { draft: null, from: undefined, help: false, refused: "" };
  row = createRef();
  /** @type {ReturnType<typeof places> | null} the scale stays while the slider is held */
  held = null;
  pressed = false;
  seen = "";

  componentDidMount() {
    const key = keyOf(this.props.path);
    shownFields.set(key, [...(shownFields.get(key) || []), this.name]);
  }
  componentWillUnmount() {
    const key = keyOf(this.props.path);
    const left = (shownFields.get(key) || []).slice(1);
    if (left.length) shownFields.set(key, left);
    else shownFields.delete(key);
  }
  get name() {
    return this.props.label || this.props.spec.title;
  }
  /** @param {FieldProps} next @param {FieldState} state */
  shouldComponentUpdate(next, state) {
    return state !== this.state || this.look(next) !== this.seen;
  }
  /** Everything that decides how the field looks. @param {FieldProps} p */
  look(p) {
    const { path, label, choices, placeholder, scale, assumed, spec: s } = p;
    const problem = wrong.at.get(keyOf(path));
    return JSON.stringify([
      path,
      this.value(p),
      label,
      choices,
      placeholder,
      scale,
      assumed,
      s.key,
      s.title,
      problem,
      app.units,
      seeking.open !== null,
    ]);
  }
  componentDidUpdate() {
    const named = shownFields.get(keyOf(this.props.path));
    if (named) named[0] = this.name; // it may be called after what was renamed
    if (!this.problem) return;
    // what is wrong must be seen
    for (let e = this.row.current; e; e = e.parentElement)
      if (e.tagName === "DETAILS") e.open = true;
  }
  get id() {
    return idOf(this.props.path, this.props.page);
  }
  get problem() {
    return this.state.refused || wrong.at.get(keyOf(this.props.path));
  }
  value(p = this.props) {
    return p.read ? p.read() : get(app.doc, p.path);
  }
  /** @param {any} value */
  put(value) {
    touched.add(keyOf(this.props.path));
    if (this.props.put) this.props.put(value);
    else edit(this.props.path, value);
  }
  /** Take what is typed into the document, with the unit of the field where none is typed.
   * @param {string} text @param {string} shownUnit */
  take(text, shownUnit) {
    const { spec: s } = this.props;
    const t = text.trim();
    if (s.kind === "flag") return this.put(t === "" ? undefined : t === "true");
    if (t === "") return this.put(undefined);
    if (s.kind === "number") return this.put(split(t) && !split(t)?.unit ? +t : text);
    if (s.kind !== "quantity" || !s.dimension) return this.put(text);
    const bare = !/[a-z%°"'µ]/i.test(t.replace(/\de[-+]?\d+/i, "0"));
    // behind what could not be read there is no unit: that of the field, if it needs one
    const needs = !shownUnit && factor("", s.dimension) === undefined;
    return this.put(bare ? `${t} ${needs ? unit(s.dimension)[0] : shownUnit}`.trim() : t);
  }
  /** Text and unit that the box shows. @returns {[string, string]} */
  text() {
    const { spec: s } = this.props;
    const value = this.value();
    const { draft, from } = this.state;
    /** @type {[string, string]} */
    const own =
      value == null
        ? ["", this.props.inUnit ?? (s.dimension ? unit(s.dimension)[0] : "")]
        : s.dimension
          ? viewed(value, s.dimension)
          : [String(value), ""];
    return draft !== null && from === value ? [draft, this.typedUnit] : own;
  }
  typedUnit = "";
  /** @param {string} text @param {string} u */
  typed(text, u) {
    if (this.state.draft === null) this.typedUnit = u;
    if (!this.props.check) this.take(text, this.typedUnit);
    this.setState({ draft: text, from: this.value(), refused: "" });
  }
  done = () => {
    const { draft } = this.state;
    if (draft === null) return;
    const { check } = this.props;
    const changed = draft.trim() !== String(this.value() ?? "");
    const refused = check && changed ? check(draft.trim()) : "";
    if (refused) return this.setState({ refused });
    if (check && changed) this.take(draft, "");
    this.setState({ draft: null, refused: "" });
  };
  render() {
    const { spec: s, choices } = this.props;
    this.seen = this.look(this.props);
    const { name, problem } = this;
    const hint = !problem && seeking.hint?.(this);
    const tall = /description/.test(s.key);
    const shape = choices && !s.dimension ? " wide" : tall ? " tall" : "";
    const standing = hint || problem === NEEDED ? " needed" : problem ? " wrong" : "";
    const [text, u] = this.text();
    return h(
      "div",
      {
        class: `field${shape}${standing}${this.props.assumed ? " assumed" : ""}`,
        ref: this.row,
      },
      h(
        "label",
        { for: this.id },
        name,
        s.symbol && h("span", { class: "sym" }, " ", sign(s.symbol)),
      ),
      h(
        "span",
        { class: "box" },
        this.box(text, u, tall),
        h("span", { class: "unit", id: `${this.id}-u` }, u),
      ),
      this.question(name),
      this.slider(name),
      h(
        "p",
        { class: "help", id: `${this.id}-h`, hidden: !this.state.help },
        this.help(),
        " ",
        this.state.help && this.seek(),
      ),
      // a long one scrolls: the keys must get there
      h(
        "p",
        { class: "error", id: `${this.id}-e`, tabIndex: problem ? 0 : undefined },
        problem || hint,
      ),
    );
  }
  /** @param {string} name */
  question(name) {
    const { help } = this.state;
    return h(
      "button",
      {
        type: "button",
        class: "q",
        tabIndex: -1, // the keys have F1 in the field
        "aria-label": `Help: ${name}`,
        "aria-expanded": help,
        "aria-controls": `${this.id}-h`,
        onClick: () => this.setState({ help: !help }),
      },
      "?",
    );
  }
  /** F1 opens the help of a field, up and down go a step of its slider.
   * @param {KeyboardEvent} e */
  keys = (e) => {
    if (e.key !== "F1") return this.stepped(e);
    e.preventDefault();
    this.setState({ help: !this.state.help });
  };
  seek() {
    const { path, spec: s, page } = this.props;
    const { open } = seeking;
    if (
      !open ||
      page ||
      s.kind !== "quantity" ||
      !/^(belt|pulley|load_case)$/.test(String(path[0]))
    )
      return null;
    return h(
      "button",
      { type: "button", onClick: () => open(path) },
      "Which value gives a result?",
    );
  }
  help() {
    const { spec: s } = this.props;
    const word = s.word && `Or the word "${s.word}".`;
    const without = s.default && `${s.default} if left empty.`;
    return [s.help, allowed(s), word, without].filter(Boolean).join(" ");
  }
  /** @param {string} text @param {string} u @param {boolean} tall */
  box(text, u, tall) {
    const { spec: s, choices } = this.props;
    const common = {
      id: this.id,
      "aria-describedby": `${this.id}-h ${this.id}-e`,
      "aria-invalid": Boolean(this.problem) && this.problem !== NEEDED,
      "aria-keyshortcuts": "F1",
      onKeyDown: this.keys,
    };
    const options = choices || ownChoices(s);
    const taken = (/** @type {Event} */ e) => this.take(valueIn(e), u);
    if (options)
      return h("select", { ...common, value: text, onChange: taken }, options.map(optionsOf));
    const typing = {
      ...common,
      value: text,
      onInput: (/** @type {Event} */ e) => this.typed(valueIn(e), u),
      onChange: this.done,
      onBlur: this.done,
    };
    if (tall) return h("textarea", { ...typing, rows: 2 });
    return h("input", {
      ...typing,
      type: "text",
      autocomplete: "off",
      spellcheck: false,
      class: s.dimension ? "amount" : "",
      "aria-required": s.required ? true : undefined,
      placeholder: this.empty().replace(` ${u}`, ""),
    });
  }
  /** What holds while the field is empty. */
  empty() {
    const { placeholder, spec: s } = this.props;
    return String(placeholder ?? (s.word || s.default || ""));
  }
  /** Value and unit that a slider stands at, and its places. */
  places() {
    const { spec: s, slider, scale: own } = this.props;
    if (!(own || s.slider) || !s.dimension || slider === false) return null;
    const [text, u] = viewed(this.value() ?? this.empty(), s.dimension);
    const now = split(text)?.number;
    const f = factor(u, s.dimension);
    if (now === undefined || f === undefined) return { text, u, f: 1, now: 0, scale: null };
    const range = own ? { ...own, log: false } : /** @type {Limits} */ (s.slider);
    const made = () => (own?.stops ? placesAt(own.stops, f, now) : places(range, f, now));
    return { text, u, f, now, scale: this.held || made() };
  }
  /** @param {string} name */
  slider(name) {
    const found = this.places();
    if (!found) return null;
    const { text, u, f, now, scale } = found;
    const common = { type: "range", "aria-label": `${name}, slider`, tabIndex: -1 };
    if (!scale) return h("input", { ...common, disabled: true });
    const release = () => {
      this.held = null;
      this.pressed = false;
    };
    const press = () => {
      this.pressed = true;
      grasp();
    };
    const range = h("input", {
      ...common,
      min: scale.min,
      max: scale.max,
      step: 1,
      value: Math.round(scale.at(now)),
      "aria-valuetext": `${text} ${u}`.trim(),
      onPointerDown: press,
      onInput: (/** @type {Event} */ e) => {
        if (this.pressed && !gripped()) return this.forceUpdate(); // given back by Escape
        this.held = scale;
        this.put(`${scale.value(+valueIn(e))} ${u}`.trim());
      },
      onChange: release,
      onBlur: release,
    });
    const { scale: own } = this.props;
    if (!own) return range;
    /** @param {number} v */
    const part = (v) =>
      100 * Math.min(1, Math.max(0, (scale.at(v / f) - scale.min) / (scale.max - scale.min || 1)));
    const [a, b] = own.good ? own.good.map(part) : [0, 0];
    const good = b > a && h("u", { style: { left: `${a}%`, width: `${b - a}%` } });
    const mark = own.mark != null && h("b", { style: { left: `${part(own.mark)}%` } });
    return h("span", { class: "sl" }, h("span", { class: "t" }, good, mark), range);
  }
  /** @param {KeyboardEvent} e */
  stepped = (e) => {
    if (e.currentTarget instanceof HTMLSelectElement) return;
    const way = { ArrowUp: 1, ArrowDown: -1 }[e.key] ?? 0;
    const found = way ? this.places() : null;
    if (!found?.scale || e.altKey || e.ctrlKey) return;
    e.preventDefault();
    const { scale, now, u } = found;
    const k = Math.round(scale.at(now)) + way;
    if (k < scale.min || k > scale.max) return;
    this.setState({ draft: null });
    this.put(`${scale.value(k)} ${u}`.trim());
  };
}

/** @param {Spec} s @returns {Choices[] | null} */
function ownChoices(s) {
  if (s.kind === "flag")
    return [
      {
        choices: [
          ["", "as by default"],
          ["true", "yes"],
          ["false", "no"],
        ],
      },
    ];
  if (!s.options?.length) return null;
  return [{ choices: [["", "–"], ...s.options.map((o) => /** @type {Choice} */ ([o, o]))] }];
}
/** @param {Choices} c @returns {Children} */
function optionsOf({ group, choices }) {
  const options = choices.map(([value, text]) => h("option", { value, key: value }, text));
  return group ? h("optgroup", { label: group, key: group }, options) : options;
}
/** @param {FieldProps} props */
export const field = (props) => h(Field, { key: keyOf(props.path), ...props });
/** Fields that are folded away until they are asked for, or something stands in them.
 * @param {string} name @param {Children[]} rows @param {boolean} [open] @param {string} [key] */
export const more = (name, rows, open, key = name) => {
  /** Opened once: what the hand folds or unfolds after that stays. @param {any} box */
  const ref = (box) => {
    if (!box || !open || box.dataset.opened) return;
    box.dataset.opened = box.open = true;
  };
  return rows.length > 0 && h("details", { class: "more", ref, key }, h("summary", {}, name), rows);
};
