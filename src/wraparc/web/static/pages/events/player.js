// The player: pulleys with belt and stress in motion, a slider of time, histories with a cursor.
import { app } from "../../base/design.js";
import { digits, percent, show, title, unit } from "../../base/units.js";
import { choose, oneOf } from "../../parts/choose.js";
import { Plot } from "../../parts/plot.js";
import { colourScale, MovingStage } from "../../plots/moving.js";
import { MovingTrain } from "../../plots/moving_train.js";
import { Component, createRef, h } from "../../vendor/preact.js";
import { angles, between, largest, value, wrap } from "./course.js";
import { histories } from "./histories.js";

/** @import { Chart } from "../../plots/chart.js" */
/** @import { Between, Drum, Played } from "./course.js" */

/** @typedef {"shear" | "creep"} What */
/** @type {Record<What, [string, string]>} */
const WHATS = { creep: ["Creep", "length"], shear: ["Shear stress", "pressure"] };
/** @type {[number, string][]} */
const RATES = [
  [0.1, "0.1 ×"],
  [0.25, "0.25 ×"],
  [1, "1 ×"],
  [4, "4 ×"],
];
/** Who asked for less motion sees steps of this length [s], and no belt that runs. */
const STEP = 0.5;
const STEADY = "Running steadily";
const NOT_RUN =
  "Tensions, shares, creep and speeds over time appear here, and play above, once the event " +
  "has run. It takes some seconds.";
const calm = () => matchMedia("(prefers-reduced-motion: reduce)").matches;

/**
 * @typedef {{playing: boolean, rate: number, what: What, curve: string}} PlayerState
 * @extends {Component<{run: Played, rating: number}, PlayerState>}
 */
export class Player extends Component {
  /** @type {PlayerState} */
  state = { playing: false, rate: 1, what: "creep", curve: "Tension" };
  now = 0;
  last = 0;
  request = 0;
  slider = createRef();
  reading = createRef();
  scale = createRef();
  box = createRef();
  /** @type {MovingStage | MovingTrain | null} */
  drawn = null;
  captions = createRef();
  chart = /** @type {Chart | null} */ (null);
  /** @type {number[][]} */
  turned = [];
  units = app.units;
  most = 1;
  full = 1;

  componentDidMount() {
    const { run } = this.props;
    const { drums } = run;
    const at = this.box.current;
    this.drawn =
      drums.length > 1 ? new MovingTrain(at, drums) : new MovingStage(at, drums[0].diameter / 2);
    this.turned = run.drums.map((d) => angles(run, d));
    this.key();
    this.seek(0);
    if (!calm() && !run.steady) this.play();
  }
  componentDidUpdate() {
    this.key();
    this.seek(this.now);
  }
  componentWillUnmount() {
    cancelAnimationFrame(this.request);
  }
  /** @param {{run: Played, rating: number}} next @param {PlayerState} state */
  shouldComponentUpdate(next, state) {
    const other = state !== this.state || this.units !== app.units || next.run !== this.props.run;
    this.units = app.units;
    return other;
  }
  get end() {
    const { time } = this.props.run;
    return time[time.length - 1];
  }
  key() {
    const { what } = this.state;
    const [title, dimension] = WHATS[what];
    const { drums } = this.props.run;
    const limit = Math.max(...drums.map((d) => this.limit(d)));
    this.most = Math.max(largest(drums.map((d) => d[what])), 1.02 * limit);
    this.full = largest([drums.flatMap((d) => [d.entry_tension, d.exit_tension])]);
    const [u, f] = unit(dimension);
    colourScale(this.scale.current, `${title} [${u}]`, this.most / f, limit / f);
  }
  /** What the quantity that is shown must not exceed; 0 for none. @param {Drum} d */
  limit = (d) => (this.state.what === "creep" ? d.creep_limit : 0);
  play = () => {
    if (this.now >= this.end) this.now = 0;
    this.last = performance.now();
    this.setState({ playing: true });
    this.request = requestAnimationFrame(this.frame);
  };
  pause = () => {
    cancelAnimationFrame(this.request);
    this.setState({ playing: false });
  };
  /** @param {number} at */
  frame = (at) => {
    const shown = document.getElementById("events");
    const gone = Math.max(at - this.last, 0) * 1e-3 * this.state.rate;
    if (gone >= (calm() ? STEP : 0)) {
      this.last = at;
      // another page, or another window: it waits
      if (!shown?.hidden && gone < 2) this.seek(this.now + gone);
    }
    if (this.now >= this.end) this.pause();
    else this.request = requestAnimationFrame(this.frame);
  };
  /** Show an instant. @param {number} t */
  seek(t) {
    const { run } = this.props;
    this.now = Math.max(0, Math.min(t, this.end));
    const row = between(run.time, this.now);
    const frame = between(run.frame_time, this.now);
    this.show(row, frame);
    this.chart?.at(this.now / this.end);
    const told = `${this.now.toFixed(2)} s`;
    const input = this.slider.current;
    if (input) {
      input.value = String(this.now);
      input.setAttribute("aria-valuetext", told);
    }
    const speed = show(value(run.belt_speed, row), "speed", 3);
    if (this.reading.current) this.reading.current.textContent = `${told}: belt ${speed}`;
  }
  /** @param {Between} row @param {Between} frame */
  show(row, frame) {
    const { run, rating } = this.props;
    const all = run.drums.map((d) => this.instant(d, row, frame));
    if (this.drawn instanceof MovingStage) this.alone(this.drawn, all[0], run.drums[0]);
    else {
      const [{ creep_limit: limit }] = run.drums;
      const { full, most } = this;
      this.drawn?.draw(all, {
        ...{ full: Math.max(full, rating), most, rating, told: all.map((d) => d.told).join("; ") },
        limit: this.state.what === "creep" ? limit : 0,
        force: (t) => show(t, "force", 3),
      });
    }
    const lines = this.captions.current.children;
    all.forEach(({ said }, i) => {
      lines[i].lastChild.textContent = said;
    });
    if (!run.steady)
      lines[all.length].textContent =
        `Belt travelled ${show(value(run.travel, row), "length", 3)}.`;
    if (calm()) return;
    const turned = this.turned.map((of) => value(of, row));
    if (this.drawn instanceof MovingStage) this.drawn.turn(value(run.travel, row), turned[0]);
    else this.drawn?.turn(value(run.travel, row), turned);
  }
  /** What is shown of a pulley. @param {Drum} d @param {Between} row @param {Between} frame */
  instant(d, row, frame) {
    const { run } = this.props;
    const [t1, t2] = [value(d.entry_tension, row), value(d.exit_tension, row)];
    const values = wrap(d[this.state.what], frame);
    const share = value(d.share, row);
    const now = Math.abs(value(d.exit_creep, row));
    const creep = show(value(d.exit_creep, row), "length", 3);
    const pulls = `${t1 < t2 ? "brakes" : "pulls"} ${show(Math.abs(t1 - t2), "force", 3)}`;
    const sizes = d.exit_creep.map(Math.abs);
    const peak = Math.max(...sizes);
    const [u, f] = unit("length");
    const shared = Number.isNaN(share) ? "" : `, share ${percent(share, 2)}`;
    return {
      ...{ t1, t2, values, now: digits(now / f), unit: u },
      level: run.steady || now <= d.creep_limit ? "" : "warn",
      hub: [
        `${d.name}: creep${run.steady ? "" : " now"}`,
        run.steady ? "" : `maximum ${show(peak, "length", 3)}`,
        run.steady
          ? `limit ${show(d.creep_limit, "length", 3)}`
          : `at ${digits(run.time[sizes.indexOf(peak)], 3)} s`,
      ],
      said: `${pulls}${shared}, creep ${creep}`,
      told: `${d.name}: ${pulls}, ${title("exit_creep").toLowerCase()} ${creep}`,
    };
  }
  /** The one pulley of a drive, as on the first screen. @param {MovingStage} stage
   * @param {ReturnType<Player["instant"]>} now @param {Drum} d */
  alone(stage, { t1, t2, values, level, hub, now, unit: u, told }, d) {
    const part = (/** @type {number} */ k) => k / (values.length - 1);
    stage.draw({
      phi: d.wrap_angle,
      ...{ t1, t2, values, level, told, most: this.most, full: this.full, limit: this.limit(d) },
      position: values.map((_, k) => part(k) * d.wrap_angle),
      tension: values.map((_, k) => t1 + (t2 - t1) * part(k)),
      solved: true,
      hub: [hub[0], now, u, hub[1], hub[2]],
      ...{ figures: [], legend: "", handles: {}, marks: {} },
      texts: { t1: `T1 ${show(t1, "force", 3)}`, t2: `T2 ${show(t2, "force", 3)}`, wrap: "" },
    });
  }
  /** Go to an instant by hand. @param {number} t */
  go(t) {
    if (this.state.playing) this.pause();
    this.seek(t);
  }
  render() {
    const { run } = this.props;
    return [
      h(
        "div",
        {
          ...{ class: "stage-box player", key: "s", tabIndex: 0 },
          ...{ role: "group", "aria-label": run.steady ? STEADY : `Event ${run.event}` },
        },
        h("figure", { class: "stage-svg", ref: this.box }),
        h(
          "div",
          { class: "drums", ref: this.captions },
          run.drums.map((d) =>
            h("p", { key: d.name }, h("strong", {}, d.name), " ", h("span", {})),
          ),
          !run.steady && h("p", { key: " travel" }),
        ),
        h(
          "p",
          { class: "help" },
          run.steady && `${STEADY}, load case ${run.steady}. `,
          "Grey: the pulley brakes the belt.",
        ),
        h("div", { class: "scale", ref: this.scale }),
        !run.steady && this.hue(),
      ),
      run.steady
        ? h("div", { class: "curve", key: "n" }, h("p", { class: "help intro" }, NOT_RUN))
        : h("div", { class: "curve player", key: "c" }, this.history()),
    ];
  }
  /** One quantity over the time, which a hand moves along it. */
  history() {
    const { curve } = this.state;
    const drawn = histories(this.props.run, this.props.rating);
    const { title, data } = drawn.find((d) => d.title === curve) ?? drawn[0];
    const hold = (/** @type {Chart} */ chart) => {
      this.chart = chart;
      chart.at(this.now / this.end);
    };
    const onpick = (/** @type {number} */ part, /** @type {PointerEvent} */ e) =>
      e.buttons && this.go(part * this.end);
    const names = drawn.map((d) => /** @type {[string, string]} */ ([d.title, d.title]));
    const put = (/** @type {string} */ curve) => this.setState({ curve });
    const charted = { title, data, hold, onpick, height: 142, xlabel: "", key: title };
    return [
      this.controls(oneOf("history", "Quantity over time", title, names, put)),
      h(Plot, charted),
    ];
  }
  /** What the lagging is coloured by. */
  hue() {
    /** @type {[string, string][]} */
    const whats = Object.entries(WHATS).map(([k, [title]]) => [k, title]);
    return h(
      "label",
      { class: "hue" },
      h("span", { class: "away" }, "Colour"),
      choose(
        this.state.what,
        whats,
        (v) => this.setState({ what: /** @type {What} */ (v) }),
        "play-what",
      ),
    );
  }
  /** @param {import("../../types.d.ts").Children} quantity */
  controls(quantity) {
    const { playing, rate } = this.state;
    return h(
      "div",
      { class: "bar transport" },
      h(
        "button",
        { type: "button", class: "main", id: "play", onClick: playing ? this.pause : this.play },
        playing ? "❚❚ Pause" : "▶ Play",
      ),
      h("output", { class: "reading-time", for: "play-time", ref: this.reading }),
      quantity,
      h(
        "label",
        {},
        h("span", { class: "away" }, "Speed"),
        choose(rate, RATES, (v) => this.setState({ rate: +v }), "play-rate"),
      ),
      h("input", {
        type: "range",
        id: "play-time",
        "aria-label": "Time",
        ref: this.slider,
        min: 0,
        max: this.end,
        step: Math.max(+(this.end / 500).toPrecision(2), 0.001),
        onInput: (/** @type {any} */ e) => this.go(+e.currentTarget.value),
      }),
    );
  }
}
