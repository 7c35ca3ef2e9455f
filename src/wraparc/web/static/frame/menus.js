// What is behind the menus.
export { exportMenu } from "./exporting.js";
export { fileMenu } from "./file_menu.js";
