// Unpacks style and scripts of the file: packed they are a third as large.
import { unpacked } from "./unpacked.js";

for (const id of ["style", "solver", "program"]) {
  const part = document.createElement(id === "style" ? id : "script");
  part.textContent = await unpacked(`${id}-packed`);
  part.id = id;
  document.body.append(part);
}
