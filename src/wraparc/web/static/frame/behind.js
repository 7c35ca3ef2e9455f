// What comes behind the first answer, and needs no solver.
export { raise, raiseAlone } from "../pages/drive/advice.js";
export { fileMenu } from "./file_menu.js";
