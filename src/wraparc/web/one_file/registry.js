// The pages that the file has.
import * as compare from "../static/pages/compare.js";
import { DrivePage } from "../static/pages/drive.js";
import * as train from "../static/pages/train.js";

/** @type {typeof import("../static/frame/registry.js").PAGES} */
export const PAGES = {
  drive: { title: "Drive", view: { Page: DrivePage } },
  compare: { title: "Compare", view: compare },
  train: { title: "Train", view: train },
};
