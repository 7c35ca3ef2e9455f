// A picture that is drawn anew in the size that its box gets.
import { Component, createRef } from "../vendor/preact.js";

/** @template P @extends {Component<P>} */
export class Sized extends Component {
  box = createRef();
  wide = 640;
  high = 400;
  /** @type {ResizeObserver | null} */
  sized = null;
  componentDidMount() {
    this.sized = new ResizeObserver(([e]) => {
      const [wide, high] = [e.contentRect.width, e.contentRect.height].map(Math.floor);
      if (!wide || (wide === this.wide && high === this.high)) return;
      Object.assign(this, { wide, high });
      this.forceUpdate();
    });
    this.sized.observe(this.box.current);
  }
  componentWillUnmount() {
    this.sized?.disconnect();
  }
  /** @returns {any} */
  render() {
    return null;
  }
}
