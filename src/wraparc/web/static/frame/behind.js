// What comes behind the first answer, and needs no solver.

export { caseLacks } from "../pages/drive/ask_back.js";
export { mend } from "../pages/drive/unknown_key.js";
export { offered } from "../pages/drive/way.js";
export { entry } from "./entry.js";
export { fileMenu } from "./file_menu.js";
export { offer } from "./offer.js";
