// What comes behind the first answer, and needs no solver.
export { offered, raise, raiseAlone } from "../pages/drive/advice.js";
export { fileMenu } from "./file_menu.js";
