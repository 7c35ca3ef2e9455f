// The pages by name.
import { DrivePage } from "../pages/drive.js";

/** @import { Children } from "../types.d.ts" */
/**
 * A page, and the tab that it is under; all but the first are fetched when they are looked at.
 * @typedef {{Page: () => Children, update?: () => void, picks?: () => Children}} View
 * @typedef {{title: string, tab: string, as: string, view?: View,
 *   load?: () => Promise<View>}} Page as: how it is called beside the others of its tab
 */

/** @type {Record<string, Page>} */
export const PAGES = {
  drive: { title: "Drive", tab: "drive", as: "One pulley", view: { Page: DrivePage } },
  train: page("Train", "drive", "Tandem", () => import("../pages/train.js")),
  across: page("Across the width", "drive", "", () => import("../pages/across.js")),
  events: page("Events", "drive", "In time", () => import("../pages/events.js")),
  compare: page("Compare", "choose", "", () => import("../pages/compare.js")),
  study: page("Study", "choose", "", () => import("../pages/study.js")),
  tests: page("Tests", "measure", "Shear tests", () => import("../pages/tests.js")),
  logs: page("A plant's logs", "measure", "", () => import("../pages/logs.js")),
  report: page("Report", "report", "", () => import("../pages/report.js")),
  saved: page("Saved", "", "", () => import("../pages/saved.js")),
};
/** @param {string} title @param {string} tab @param {string} as @param {() => Promise<View>} load
 * @returns {Page} */
function page(title, tab, as, load) {
  return { title, tab, as: as || title, load };
}
