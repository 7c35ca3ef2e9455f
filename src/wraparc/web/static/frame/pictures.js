// The pictures of a page as one file: every figure where it stands, in the colours of paper.
import { app } from "../base/design.js";
import { s } from "../plots/svg.js";

/** @typedef {{text: string, width: number, height: number}} Picture */

const LOOKS = ["fill", "stroke", "stroke-width", "stroke-dasharray", "opacity", "fill-opacity"]
  .concat(["font-size", "font-weight", "font-style", "font-family", "text-anchor"])
  .concat(["dominant-baseline"]);
/** What a property is where nobody sets it. @type {Record<string, string[]>} */
const USUAL = {
  stroke: ["none"],
  "stroke-width": ["1px"],
  "stroke-dasharray": ["none"],
  opacity: ["1"],
  "fill-opacity": ["1"],
  "font-style": ["normal"],
  "font-weight": ["400"],
  "text-anchor": ["start"],
  "dominant-baseline": ["auto"],
};
const MARGIN = 12;
const FOOT = 22;
const BACK = "#fff";

/** Do something in the colours of the light page: those of paper. @template T @param {() => T} f */
function onPaper(f) {
  const rules = [...document.styleSheets].flatMap((sheet) => [...sheet.cssRules]);
  const root = /** @type {CSSStyleRule} */ (
    rules.find((r) => r instanceof CSSStyleRule && r.selectorText === ":root")
  );
  const names = [...root.style].filter((name) => name.startsWith("--"));
  const { style } = document.documentElement;
  for (const name of names) style.setProperty(name, root.style.getPropertyValue(name));
  try {
    return f();
  } finally {
    for (const name of names) style.removeProperty(name);
  }
}
/** What of the page is a picture, and seen. */
const figures = () =>
  [...document.querySelectorAll(`#${app.page} figure`)].filter((e) => e.checkVisibility());

/** The pictures of the page that is looked at; null where it has none. @returns {Picture | null} */
export function svg() {
  const all = figures().filter((e) => e.querySelector("svg"));
  if (!all.length) return null;
  const boxes = all.map((e) => e.getBoundingClientRect());
  const left = Math.min(...boxes.map((b) => b.left)) - MARGIN;
  const width = Math.ceil(Math.max(...boxes.map((b) => b.right)) - left + MARGIN);
  const { tops, tall } = packed(boxes);
  const height = tall + FOOT;
  const whole = s(
    "svg",
    { xmlns: "http://www.w3.org/2000/svg", width, height, viewBox: `0 0 ${width} ${height}` },
    s("rect", { width, height, fill: BACK }),
    onPaper(() => all.flatMap((e, i) => [...drawn(e, left, tops[i]), ...said(e, left, tops[i])])),
    foot(tall),
  );
  return { text: new XMLSerializer().serializeToString(whole), width, height };
}
/** Where every figure begins once what stands between them is taken out: what the page calls 0.
 * @param {DOMRect[]} boxes @returns {{tops: number[], tall: number}} */
function packed(boxes) {
  const tops = boxes.map(() => 0);
  const order = boxes.map((_, i) => i).sort((a, b) => boxes[a].top - boxes[b].top);
  let end = boxes[order[0]].top; // of what is placed, on the page
  let out = end - MARGIN;
  for (const i of order) {
    out += Math.max(0, boxes[i].top - end - MARGIN);
    end = Math.max(end, boxes[i].bottom);
    tops[i] = out;
  }
  return { tops, tall: Math.ceil(end - out + MARGIN) };
}
/** What the picture is of, below it. @param {number} y */
function foot(y) {
  const named = [app.doc.title || app.name, app.page === "drive" && app.case];
  const program = `wraparc ${app.about.version}, ${new Date().toISOString().slice(0, 10)}`;
  const text = [...named, program].filter(Boolean).join("; ");
  const look = { "font-size": "11px", "font-family": "sans-serif", fill: "#55606e" };
  return s("text", { x: MARGIN, y: y + 4, ...look }, text);
}
/** The drawings of a figure, each where it is seen. @param {Element} figure @param {number} left
 * @param {number} top */
const drawn = (figure, left, top) =>
  [...figure.querySelectorAll("svg")]
    .filter((e) => e.checkVisibility() && !e.parentElement?.closest("svg"))
    .map((e) => {
      const { x, y, width, height } = e.getBoundingClientRect();
      const copy = /** @type {SVGElement} */ (plain(e));
      const size = { x: x - left, y: y - top, width, height };
      for (const [name, v] of Object.entries(size)) copy.setAttribute(name, v.toFixed(1));
      if (!copy.hasAttribute("viewBox")) copy.setAttribute("viewBox", `0 0 ${width} ${height}`);
      return copy;
    });
/** A colour as every program reads it, not as a browser tells one that it has mixed.
 * @param {string} value */
const plainColour = (value) =>
  value.replace(
    /^color\(srgb ([^)]*)\)$/,
    (_, parts) => `rgb(${parts.split(" ").map((/** @type {string} */ v) => Math.round(255 * +v))})`,
  );
/** An element with all that styles make of it as attributes of its own; null where it is not seen.
 * @param {Element} e @returns {Element | null} */
function plain(e) {
  const look = getComputedStyle(e);
  if (look.display === "none" && !e.closest("defs")) return null;
  const copy = /** @type {Element} */ (e.cloneNode(false));
  for (const name of ["class", "tabindex", "style"]) copy.removeAttribute(name);
  if (e.tagName !== "svg" && !["defs", "pattern", "marker"].includes(e.tagName))
    for (const name of LOOKS) {
      const value = plainColour(look.getPropertyValue(name));
      const font = /^(font|text|dominant)/.test(name) && !["text", "tspan"].includes(e.tagName);
      if (value && !font && !USUAL[name]?.includes(value)) copy.setAttribute(name, value);
    }
  for (const child of e.childNodes) {
    const kept = child instanceof Element ? plain(child) : child.cloneNode();
    if (kept) copy.append(kept);
  }
  return copy;
}
/** The words of a figure beside its drawings, line by line. @param {Element} figure
 * @param {number} left @param {number} top */
function said(figure, left, top) {
  const walk = document.createTreeWalker(figure, NodeFilter.SHOW_TEXT);
  const found = [];
  while (walk.nextNode()) {
    const e = walk.currentNode.parentElement;
    if (!e || e.closest("svg, label, select, button, .away") || !e.checkVisibility()) continue;
    const look = getComputedStyle(e);
    const size = Number.parseFloat(look.fontSize);
    for (const { text, box } of linesOf(/** @type {Text} */ (walk.currentNode)))
      found.push(
        s(
          "text",
          {
            x: (box.left - left).toFixed(1),
            y: (box.top - top + (box.height + 0.7 * size) / 2).toFixed(1),
            fill: look.color,
            "font-size": look.fontSize,
            "font-weight": look.fontWeight,
            "font-family": look.fontFamily,
          },
          text,
        ),
      );
  }
  return found;
}
/** The lines that a text is broken into, each where it begins. @param {Text} node */
function linesOf(node) {
  /** @type {{text: string, box: DOMRect}[]} */
  const found = [];
  for (const { 0: word, index } of node.data.matchAll(/\S+\s*/g)) {
    const range = document.createRange();
    range.setStart(node, index);
    range.setEnd(node, index + word.trimEnd().length);
    const box = range.getBoundingClientRect();
    const last = found[found.length - 1];
    if (last && Math.abs(last.box.top - box.top) < 1) last.text += word;
    else found.push({ text: word, box });
  }
  return found.map(({ text, box }) => ({ text: text.trimEnd(), box }));
}

/** Pixels of the picture for each of the page. */
const SHARP = 2;
/** @param {Picture} picture @returns {Promise<Blob>} */
export async function png({ text, width, height }) {
  const image = new Image();
  image.src = `data:image/svg+xml;charset=utf-8,${encodeURIComponent(text)}`;
  await image.decode();
  const canvas = document.createElement("canvas");
  [canvas.width, canvas.height] = [SHARP * width, SHARP * height];
  canvas.getContext("2d")?.drawImage(image, 0, 0, canvas.width, canvas.height);
  return new Promise((done, fail) =>
    canvas.toBlob((data) => (data ? done(data) : fail(new Error("No picture was made.")))),
  );
}
