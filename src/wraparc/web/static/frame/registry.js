// The pages by name.
import { DrivePage } from "../pages/drive.js";

/** @import { Children } from "../types.d.ts" */
/**
 * A page; all but the first are fetched when they are looked at.
 * @typedef {{Page: () => Children, update?: () => void}} View
 * @typedef {{title: string, view?: View, load?: () => Promise<View>}} Page
 */

/** @type {Record<string, Page>} */
export const PAGES = {
  drive: { title: "Drive", view: { Page: DrivePage } },
  compare: { title: "Compare", load: () => import("../pages/compare.js") },
  across: { title: "Across the width", load: () => import("../pages/across.js") },
  tests: { title: "Tests", load: () => import("../pages/tests.js") },
  train: { title: "Train", load: () => import("../pages/train.js") },
  events: { title: "Events", load: () => import("../pages/events.js") },
  study: { title: "Study", load: () => import("../pages/study.js") },
  saved: { title: "Saved", load: () => import("../pages/saved.js") },
};
