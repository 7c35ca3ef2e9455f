// The pages that the file has.
import * as compare from "../static/pages/compare.js";
import { DrivePage } from "../static/pages/drive.js";
import * as train from "../static/pages/train.js";

/** @type {typeof import("../static/frame/registry.js").PAGES} */
export const PAGES = {
  drive: { title: "Drive", tab: "drive", as: "One pulley", view: { Page: DrivePage } },
  train: { title: "Train", tab: "drive", as: "Tandem", view: train },
  compare: { title: "Compare", tab: "choose", as: "Compare", view: compare },
};
