// Pictures of the page in node, on elements that only remember what is written into them.
class Element {
  constructor(tag) {
    Object.assign(this, { tag, attributes: {}, children: [], said: "", clientWidth: 0 });
  }
  setAttribute(key, value) {
    this.attributes[key] = String(value);
  }
  getAttribute(key) {
    return this.attributes[key] ?? null;
  }
  append(...children) {
    for (const child of children) this.children.push(child);
  }
  appendChild(child) {
    this.append(child);
    return child;
  }
  replaceChildren(...children) {
    this.children = children;
  }
  remove() {}
  addEventListener(kind, f) {
    this[`on${kind}`] = f;
  }
  getBoundingClientRect() {
    return { left: 0 };
  }
  get childElementCount() {
    return this.children.length;
  }
  get lastChild() {
    return { remove: () => this.children.pop() };
  }
  get textContent() {
    return this.said + this.children.map((c) => c.textContent ?? c).join("");
  }
  set textContent(text) {
    this.said = text;
  }
}
globalThis.Text = class extends Element {};
globalThis.ResizeObserver = class {
  observe() {}
};
globalThis.document = {
  createElementNS: (_, tag) => new Element(tag),
  createElement: (tag) => new Element(tag),
};
const { app } = await import("../../src/wraparc/web/static/base/design.js");
const { Budget } = await import("../../src/wraparc/web/static/plots/budget.js");
const { Chart } = await import("../../src/wraparc/web/static/plots/chart.js");
const { MovingStage } = await import("../../src/wraparc/web/static/plots/moving.js");
const { named } = await import("../../src/wraparc/web/static/plots/named.js");
const { roundStep, ticks } = await import("../../src/wraparc/web/static/plots/svg.js");
const { colour } = await import("../../src/wraparc/web/static/plots/ramp.js");
const { chain } = await import("../../src/wraparc/web/static/pages/train/chain.js");
const { Spreads } = await import("../../src/wraparc/web/static/pages/study/spread.js");

const si = (unit, factor) => ({ si: { unit, factor, larger: [] } });
const unit = { ...si("mm", 1e-3), us: { unit: "in", factor: 0.0254, larger: [] } };
app.form = {
  units: { length: unit, force: si("kN", 1e3), number: si("", 1) },
  glossary: { exit_creep: { title: "Creep at exit", dimension: "length" } },
};
const of = (e) => ({ tag: e.tag, ...e.attributes, text: e.textContent });
const all = (e) => [of(e), ...e.children.filter((c) => c.tag).flatMap(all)];

function box(width) {
  return Object.assign(new Element("div"), { clientWidth: width });
}
function chartOf({ width, look, data, picks = [], cursor, names }) {
  const picked = [];
  const chart = new Chart(box(width), { ...look, onpick: (part) => picked.push(part) });
  if (names) chart.named = named;
  chart.draw(data);
  chart.at(cursor ?? 0.5);
  for (const clientX of picks) chart.svg.onpointerdown({ clientX });
  return {
    picked,
    lines: chart.paths.map((p) => p.getAttribute("d")),
    limit: chart.bound.getAttribute("d"),
    zones: chart.zones.children.map(of),
    marks: chart.marks.children.map(of),
    cursor: chart.cursor.getAttribute("d"),
    names: chart.names.children.map(of),
    axis: chart.back.children.map(of),
  };
}
function stageOf({ turn, radius }) {
  const stage = new MovingStage(box(300), radius);
  stage.turn(...turn);
  return { marks: of(stage.dashes), spoke: of(stage.spoke) };
}
function budgetOf({ width, bars, limit }) {
  const budget = new Budget(box(0), box(width), "Creep");
  budget.draw(width, bars, limit, "mm", "", ["", "", ""]);
  return { parts: budget.rows.children.map(of), limit: of(budget.limit) };
}
function spreadOf({ width, spread }) {
  const spreads = new Spreads({ spreads: [spread] });
  spreads.box.current = box(width);
  spreads.wide = width;
  spreads.draw();
  return all(spreads.box.current);
}
/** Elements of a tree that Preact would draw. */
const flat = (v) =>
  v?.props
    ? [{ tag: v.type, ...v.props, children: undefined, text: texts(v) }, ...inner(v)]
    : Array.isArray(v)
      ? v.flatMap(flat)
      : [];
const inner = (v) => [v.props.children].flat(9).flatMap(flat);
const texts = (v) => [v.props.children].flat(9).filter((c) => typeof c === "string").join("");

const DRAWN = { chart: chartOf, stage: stageOf, budget: budgetOf, spread: spreadOf };
const { readFileSync } = await import("node:fs");
const cases = JSON.parse(readFileSync(0, "utf-8"));
const found = cases.map(({ kind, ...asked }) => {
  if (kind === "train") return flat(chain(asked.load_case, new Map()));
  if (kind === "steps") return asked.spans.map(([span, most]) => roundStep(span, most));
  if (kind === "ticks") return asked.of.map(([lo, hi, step]) => ticks(lo, hi, step));
  if (kind === "ramp") return asked.of.map(colour);
  return DRAWN[kind](asked);
});
process.stdout.write(JSON.stringify(found));
