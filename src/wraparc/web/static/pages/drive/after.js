// What is under the fold does not hold the first screen up: it follows a slider with the judgement.
import { app, gripped } from "../../base/design.js";
import { Component, h } from "../../vendor/preact.js";
import { answer } from "./solving.js";

/** @import { Children } from "../../types.d.ts" */

const SOON = 100; // [ms] where no judgement comes
const slides = () => gripped() || document.activeElement?.matches("[type=range], [role=slider]");

/** @extends {Component<{draw: () => Children}>} */
class After extends Component {
  of = app.doc;
  wait = 0;

  shouldComponentUpdate() {
    if (this.of === app.doc || answer.judgedDoc === app.doc || !slides()) return true;
    this.wait ||= setTimeout(() => this.forceUpdate(), SOON);
    return false;
  }
  render() {
    clearTimeout(this.wait);
    this.wait = 0;
    this.of = app.doc;
    return this.props.draw();
  }
}
/** @param {() => Children} draw */
export const after = (draw) => h(After, { draw });
