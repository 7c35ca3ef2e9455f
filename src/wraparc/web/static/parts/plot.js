// Pictures drawn by hand, as components.

import { Chart } from "../plots/chart.js";
import { Component, createRef, h } from "../vendor/preact.js";

/** @import { ChartData, ChartLook } from "../types.d.ts" */

/**
 * A chart that is drawn anew when its data are other ones.
 * @typedef {ChartLook & {data: ChartData, class?: string, hold?: (chart: Chart) => void}} PlotProps
 * @extends {Component<PlotProps>}
 */
export class Plot extends Component {
  box = createRef();
  componentDidMount() {
    this.chart = new Chart(this.box.current, this.props);
    this.chart.draw(this.props.data);
    this.props.hold?.(this.chart);
  }
  /** @param {PlotProps} next */
  shouldComponentUpdate(next) {
    if (next.data !== this.props.data && this.chart) this.chart.draw(next.data);
    return false;
  }
  componentWillUnmount() {
    this.chart?.sized.disconnect();
  }
  render() {
    return h("figure", { ref: this.box, class: this.props.class });
  }
}
