// What is under the fold follows a slider one frame behind: the first screen does not wait for it.
import { app, gripped } from "../../base/design.js";
import { Component, h } from "../../vendor/preact.js";

/** @import { Children } from "../../types.d.ts" */

const slides = () => gripped() || document.activeElement?.matches("[type=range], [role=slider]");

/** @extends {Component<{draw: () => Children}>} */
class After extends Component {
  of = app.doc;
  waits = false;

  shouldComponentUpdate() {
    if (this.of === app.doc || !slides()) return true;
    if (!this.waits) requestAnimationFrame(() => setTimeout(() => this.forceUpdate()));
    this.waits = true;
    return false;
  }
  render() {
    this.of = app.doc;
    this.waits = false;
    return this.props.draw();
  }
}
/** @param {() => Children} draw */
export const after = (draw) => h(After, { draw });
