// A picture of the server, fetched as all that it answers: no address of a picture opens it.
import { askFile } from "../base/server.js";
import { Component, h } from "../vendor/preact.js";

/** @extends {Component<{path: string, alt: string}, {src?: string}>} */
export class Picture extends Component {
  async componentDidMount() {
    const [data] = await askFile(this.props.path).catch(() => [null]);
    if (data) this.setState({ src: URL.createObjectURL(data) });
  }
  componentWillUnmount() {
    URL.revokeObjectURL(this.state.src ?? "");
  }
  render() {
    return h("img", { src: this.state.src, alt: this.props.alt });
  }
}
