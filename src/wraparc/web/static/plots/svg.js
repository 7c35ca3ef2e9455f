// Making SVG by hand: pictures change in place, so that a slider step only rewrites paths.
const SVG = "http://www.w3.org/2000/svg";

/**
 * @param {string} tag @param {Record<string, any>} [attributes]
 * @param {...any} children @returns {SVGElement}
 */
export function s(tag, attributes = {}, ...children) {
  const e = document.createElementNS(SVG, tag);
  e.append(...flat(children));
  return attr(/** @type {SVGElement} */ (e), attributes);
}
/** @param {any[]} children @returns {any[]} */
const flat = (children) => children.flat(9).filter((k) => k != null && k !== false);
/** @param {Element} e @param {...any} children */
export const put = (e, ...children) => e.replaceChildren(...flat(children));
/** Set attributes that are others than before: a browser styles and paints anew what is written.
 * @template {Element} E @param {E} e @param {Record<string, any>} attributes @returns {E} */
export function attr(e, attributes) {
  for (const key in attributes) {
    const value = String(attributes[key]);
    if (e.getAttribute(key) !== value) e.setAttribute(key, value);
  }
  return e;
}
/** @param {Node} e @param {string} text */
export function say(e, text) {
  if (e.textContent !== text) e.textContent = text;
}
/** One child of a kind for each row of attributes, those that are there changed in place.
 * @param {Element} e @param {string} tag @param {Record<string, any>[]} rows */
export function each(e, tag, rows) {
  while (e.childElementCount > rows.length) e.lastChild?.remove();
  for (const [i, row] of rows.entries()) attr(e.children[i] ?? e.appendChild(s(tag)), row);
}
/** @param {number} v */
export const fixed = (v) => Math.round(v * 10) / 10;
let ids = 0;
/** A name for patterns that no other picture has. @param {string} of */
export const fresh = (of) => `${of}${++ids}`;

/** Hatches, so that nothing is told by colour alone. @param {string} id */
export const hatches = (id) => {
  const turned = { width: 6, height: 6, patternUnits: "userSpaceOnUse" };
  const even = { ...turned, patternTransform: "rotate(45)" };
  return s(
    "defs",
    {},
    s("pattern", { id: `${id}out`, ...even }, s("path", { d: "M0 0V6", class: "hatch-red" })),
    s(
      "pattern",
      { id: `${id}rest`, ...turned, width: 5, height: 5 },
      s("circle", { cx: 2.5, cy: 2.5, r: 0.9, class: "dot" }),
    ),
    s(
      "pattern",
      { id: `${id}x`, ...turned },
      s("rect", { width: 6, height: 6, class: "f-green" }),
      s("path", { d: "M0 0L6 6M6 0L0 6", class: "hatch-white" }),
    ),
    s(
      "pattern",
      { id: `${id}d`, ...even },
      s("rect", { width: 6, height: 6, class: "f-orange" }),
      s("path", { d: "M0 0V6", class: "hatch-white" }),
    ),
  );
};

/**
 * A round step that divides a span into at most so many parts.
 * @param {number} span @param {number} most
 */
export function roundStep(span, most) {
  const raw = span / most;
  const p = 10 ** Math.floor(Math.log10(raw || 1));
  return [1, 2, 2.5, 5, 10].map((m) => m * p).find((v) => v >= raw * 0.9999) ?? 10 * p;
}
/** @param {number} lo @param {number} hi @param {number} step */
export function ticks(lo, hi, step) {
  const found = [];
  for (let i = Math.ceil(lo / step - 1e-9); i * step <= hi + 1e-5 * step; i++)
    found.push(+(i * step).toPrecision(12));
  return found;
}
